/* SPDX-License-Identifier: GPL-3.0-or-later */
/* units.c - from three sizes to those of all units.
 * Keeps no state. Invariant: energy = mass length^2/time^2. Start reading at fw_units_physical():
 * the name of a unit becomes powers of length, time and mass, and these a name of nature. */
#include "units.h"

#include "experiments/text/number.h"
#include "experiments/text/text.h"
#include "unit_name.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const fw_key units_keys[] = {
    {"length", AT_TEXT(fw_units, length_text), REQUIRED, .hint = "such as 0.286 nm",
     .meaning = "what a length of 1 is: a number and m (with a prefix: nm, um, mm), cm or A"},
    {"time", AT_TEXT(fw_units, time_text), ALTERNATIVE, .hint = "such as 0.27 ps",
     .meaning = "what a time of 1 is: a number and s (fs, ps, ns, us, ms)"},
    {"energy", AT_TEXT(fw_units, energy_text), ALTERNATIVE, .hint = "such as 0.74 eV",
     .meaning = "what an energy of 1 is: a number and J or eV (meV)"},
    {"mass", AT_TEXT(fw_units, mass_text), REQUIRED, .hint = "such as 63.5 u",
     .meaning = "what a mass of 1 is: a number and u, Da or g (kg)"},
    {"depth", AT_TEXT(fw_units, depth_text), .default_meaning = "forces are per length",
     .hint = "such as 0.25 nm",
     .meaning = "how deep the layer is that the plane stands for: with it a force per length is "
                "shown as a pressure"},
    {.name = NULL}};

const fw_section fw_units_section = {
    "`units`", "units",
    "What the reduced units are in nature. The scenario and the results stay reduced; tables, "
    "axes, "
    "reports and the results file also say nm, ps, GPa, K. Time and energy follow from each other: "
    "energy = mass length^2/time^2.",
    .keys = units_keys};

/* --- reading --- */

static fw_status read_size(const char *key, const char *text, fw_unit_kind kind, double *size,
                           fw_unit_name *name, fw_error *error)
{
    size_t digits = strspn(text, "+-.0123456789eE");
    /* "1 eV" and "1eV": what a number takes of an E is given back. */
    while (digits > 0 && !isdigit((unsigned char)text[digits - 1]) && text[digits - 1] != '.')
        --digits;
    const char *unit = text + digits + strspn(text + digits, " ");
    double number = 0;
    if (fw_number_read(text, digits, &number) != FW_NUMBER_FINE || !(number > 0))
        return fw_fail(error, FW_BAD_INPUT, "units.%s is '%s', expected a number above 0 and %s",
                       key, fw_text_quote(text, strlen(text)).text, fw_unit_kind_choice(kind));
    if (!fw_unit_name_read(kind, unit, strlen(unit), name))
        return fw_fail(error, FW_BAD_INPUT, "units.%s is in '%s', expected %s", key,
                       fw_text_quote(unit, strlen(unit)).text, fw_unit_kind_choice(kind));
    *size = number * name->size;
    if (*size > 1e-60 && *size < 1e60) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "units.%s is '%s', expected between 1e-60 and 1e60 SI units", key,
                   fw_text_quote(text, strlen(text)).text);
}

fw_status fw_units_complete(fw_units *units, const char **key, fw_error *error)
{
    fw_unit_name depth;
    if (!units->length_text) return FW_OK;
    FW_TRY(read_size(*key = "length", units->length_text, FW_UNIT_LENGTH, &units->length,
                     &units->length_name, error));
    FW_TRY(read_size(*key = "mass", units->mass_text, FW_UNIT_MASS, &units->mass, &units->mass_name,
                     error));
    if (units->depth_text)
        FW_TRY(read_size(*key = "depth", units->depth_text, FW_UNIT_LENGTH, &units->depth, &depth,
                         error));
    if (units->time_text) {
        FW_TRY(read_size(*key = "time", units->time_text, FW_UNIT_TIME, &units->time,
                         &units->time_name, error));
        const double speed = units->length / units->time;
        units->energy = units->mass * speed * speed;
        /* Of lattices of atoms one speaks in eV, not in zJ. */
        const bool small = units->energy < 1e-15;
        units->energy_name =
            fw_unit_name_prefixed(small ? "eV" : "J", small ? ELECTRON_VOLT : 1, units->energy);
        return FW_OK;
    }
    FW_TRY(read_size(*key = "energy", units->energy_text, FW_UNIT_ENERGY, &units->energy,
                     &units->energy_name, error));
    units->time = units->length * sqrt(units->mass / units->energy);
    units->time_name = fw_unit_name_prefixed("s", 1, units->time);
    return FW_OK;
}

/* --- the units of the program, as powers --- */

typedef struct word {
    const char *name;
    fw_dimension is;
} word;

/* "angular momentum" is a length times a momentum. k_B turns a temperature into an energy. */
static const word words[] = {
    {"length", {1, 0, 0, 0}},  {"spacings", {1, 0, 0, 0}},  {"time", {0, 1, 0, 0}},
    {"step", {0, 1, 0, 0}},    {"mass", {0, 0, 1, 0}},      {"energy", {2, -2, 1, 0}},
    {"force", {1, -2, 1, 0}},  {"momentum", {1, -1, 1, 0}}, {"angular", {1, 0, 0, 0}},
    {"torque", {2, -2, 1, 0}}, {"radians", {0, 0, 0, 0}},   {"1", {0, 0, 0, 0}},
    {"k_B", {2, -2, 1, -1}}};
enum { WORDS = sizeof words / sizeof *words };

static fw_dimension times(fw_dimension one, fw_dimension other, double power)
{
    return (fw_dimension){one.length + power * other.length, one.time + power * other.time,
                          one.mass + power * other.mass,
                          one.temperature + power * other.temperature};
}

static bool read_product(const char **text, fw_dimension *is);

/* "^2", "^-1", "^(1/2)", or nothing. */
static bool read_power(const char **text, double *power)
{
    *power = 1;
    if (**text != '^') return true;
    const bool part = (*text)[1] == '(';
    const char *begin = *text + (part ? 2 : 1), *end;
    *power = fw_number_scan(begin, &end);
    if (part && *end == '/') *power /= fw_number_scan(end + 1, &end);
    if (end == begin || !isfinite(*power) || (part && *end != ')')) return false;
    *text = end + part;
    return true;
}

static bool read_factor(const char **text, fw_dimension *is)
{
    if (**text == '(') {
        ++*text;
        if (!read_product(text, is) || **text != ')') return false;
        ++*text;
        return true;
    }
    size_t length = 0;
    while (isalnum((unsigned char)(*text)[length]) || (*text)[length] == '_') ++length;
    for (int n = 0; n < WORDS; ++n) {
        if (strlen(words[n].name) != length || memcmp(words[n].name, *text, length) != 0) continue;
        *text += length;
        *is = words[n].is;
        return true;
    }
    return false;
}

/* Factors with a blank or a '/' between them, up to the end or a ')'. */
static bool read_product(const char **text, fw_dimension *is)
{
    double sign = 1;
    *is = (fw_dimension){0};
    for (;;) {
        fw_dimension factor;
        double power;
        if (!read_factor(text, &factor) || !read_power(text, &power)) return false;
        *is = times(*is, factor, sign * power);
        *text += strspn(*text, " ");
        if (**text == '\0' || **text == ')') return true;
        sign = **text == '/' ? -1 : 1;
        if (**text == '/') *text += 1 + strspn(*text + 1, " ");
    }
}

/* --- names of nature --- */

typedef struct named_dimension {
    fw_dimension is;
    const char *symbol;
    bool per_depth; /* only where there is one, over which it is spread */
} named_dimension;

static const named_dimension named[] = {{{1, -2, 1, 0}, "N", false},
                                        {{0, -2, 1, 0}, "Pa", true},
                                        {{0, -2, 1, 0}, "N/m", false},
                                        {{1, -1, 0, 0}, "m/s", false},
                                        {{0, 0, 0, 1}, "K", false}};
enum { NAMED = sizeof named / sizeof *named };

/* CODATA 2018, exact. */
static const double boltzmann = 1.380649e-23;

static double size_of(const fw_units *units, fw_dimension is)
{
    return pow(units->length, is.length) * pow(units->time, is.time) * pow(units->mass, is.mass) *
           pow(units->energy / boltzmann, is.temperature);
}

static void add_power(fw_physical *physical, const fw_unit_name *name, double power, bool below)
{
    if (below ? power >= 0 : power <= 0) return;
    const double size = fabs(power);
    const char *before = below ? (physical->text[0] ? "/" : "1/") : physical->text[0] ? " " : "";
    fw_text_append(physical->text, sizeof physical->text, "%s%s", before, name->text);
    if (size != 1 && size == floor(size))
        fw_text_append(physical->text, sizeof physical->text, "^%g", size);
    else if (size != 1)
        fw_text_append(physical->text, sizeof physical->text, "^(%g/2)", 2 * size);
    physical->factor /= pow(name->size, power);
}

/* Powers of mass, length and time, or of energy, length and time, whichever are lower. */
static fw_physical composed(const fw_units *units, fw_dimension is, double size)
{
    fw_physical physical = {.factor = size};
    const double plain = fabs(is.mass) + fabs(is.length) + fabs(is.time);
    const double length = is.length - 2 * is.mass, time = is.time + 2 * is.mass;
    const bool by_energy = fabs(is.mass) + fabs(length) + fabs(time) < plain;
    const fw_unit_name *first = by_energy ? &units->energy_name : &units->mass_name;
    for (int below = 0; below < 2; ++below) {
        add_power(&physical, first, is.mass, below);
        add_power(&physical, &units->length_name, by_energy ? length : is.length, below);
        add_power(&physical, &units->time_name, by_energy ? time : is.time, below);
    }
    return physical;
}

fw_physical fw_units_physical(const fw_units *units, const char *unit)
{
    const fw_physical nothing = {.factor = 0};
    fw_dimension is;
    if (!units || !fw_units_given(units) || !read_product(&unit, &is) || *unit != '\0' ||
        fw_dimension_equal(is, (fw_dimension){0}))
        return nothing;
    double size = size_of(units, is);
    for (int n = 0; n < NAMED; ++n) {
        if (!fw_dimension_equal(is, named[n].is) || (named[n].per_depth && units->depth == 0))
            continue;
        if (named[n].per_depth) size /= units->depth;
        fw_physical physical;
        const bool kelvin = is.temperature != 0;
        const fw_unit_name name = fw_unit_name_prefixed(named[n].symbol, 1, kelvin ? 0 : size);
        physical.factor = size / name.size;
        memcpy(physical.text, name.text, sizeof name.text);
        return physical;
    }
    return is.temperature == 0 ? composed(units, is, size) : nothing;
}

void fw_units_print(char text[FW_PHYSICAL_TEXT], const fw_units *units, const char *unit,
                    int digits)
{
    const fw_physical physical = fw_units_physical(units, unit);
    if (physical.factor == 0)
        text[0] = '\0';
    else
        snprintf(text, FW_PHYSICAL_TEXT, "%.*g %s", digits, physical.factor, physical.text);
}

void fw_units_say(char text[FW_UNITS_SAID], const fw_units *units, const char *unit)
{
    char physical[FW_PHYSICAL_TEXT];
    fw_units_print(physical, units, unit, 10);
    snprintf(text, FW_UNITS_SAID, "%.64s%s%s", unit, physical[0] ? " = " : "", physical);
}

void fw_units_list(FILE *out, const fw_units *units, bool warm)
{
    static const struct {
        const char *name, *unit;
    } listed[] = {{"length", "length"},
                  {"mass", "mass"},
                  {"time", "time"},
                  {"energy", "energy"},
                  {"temperature", "energy/k_B"},
                  {"velocity", "length/time"},
                  {"force", "force"},
                  {"force per length", "force/length"}};
    for (size_t n = 0; n < sizeof listed / sizeof *listed; ++n) {
        char physical[FW_PHYSICAL_TEXT];
        if (!warm && strcmp(listed[n].unit, "energy/k_B") == 0) continue;
        fw_units_print(physical, units, listed[n].unit, 4);
        fprintf(out, "%s%s %s", n > 0 ? ", " : "", listed[n].name, physical);
    }
}
