/* SPDX-License-Identifier: GPL-3.0-or-later */
/* unit_name.c - prefixes and units of the SI, and the few others that are used for lattices.
 * Keeps no state. Sizes: SI Brochure (2019), and CODATA 2018 for eV and u. */
#include "unit_name.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct prefix {
    const char *text, *shown;
    double size;
} prefix;

/* From the largest down. */
static const prefix prefixes[] = {{"T", "T", 1e12},  {"G", "G", 1e9},   {"M", "M", 1e6},
                                  {"k", "k", 1e3},   {"", "", 1},       {"m", "m", 1e-3},
                                  {"µ", "µ", 1e-6},  {"u", "µ", 1e-6},  {"n", "n", 1e-9},
                                  {"p", "p", 1e-12}, {"f", "f", 1e-15}, {"a", "a", 1e-18}};
enum { PREFIXES = sizeof prefixes / sizeof *prefixes };

typedef struct known_unit {
    fw_unit_kind kind;
    const char *text, *shown;
    double size;
    bool prefixed;
} known_unit;

static const known_unit known[] = {{FW_UNIT_LENGTH, "m", "m", 1, true},
                                   {FW_UNIT_LENGTH, "cm", "cm", 1e-2, false},
                                   {FW_UNIT_LENGTH, "A", "Å", 1e-10, false},
                                   {FW_UNIT_LENGTH, "Å", "Å", 1e-10, false},
                                   {FW_UNIT_TIME, "s", "s", 1, true},
                                   {FW_UNIT_MASS, "g", "g", 1e-3, true},
                                   {FW_UNIT_MASS, "u", "u", 1.66053906660e-27, false},
                                   {FW_UNIT_MASS, "Da", "Da", 1.66053906660e-27, true},
                                   {FW_UNIT_ENERGY, "J", "J", 1, true},
                                   {FW_UNIT_ENERGY, "eV", "eV", ELECTRON_VOLT, true}};
enum { KNOWN = sizeof known / sizeof *known };

const char *fw_unit_kind_choice(fw_unit_kind kind)
{
    static const char *const choices[] = {
        [FW_UNIT_LENGTH] = "a unit of length: m with any prefix, cm, or A (0.1 nm)",
        [FW_UNIT_TIME] = "a unit of time: s with any prefix",
        [FW_UNIT_MASS] = "a unit of mass: g or Da with any prefix, or u",
        [FW_UNIT_ENERGY] = "a unit of energy: J or eV with any prefix"};
    return choices[kind];
}

bool fw_dimension_equal(fw_dimension one, fw_dimension other)
{
    return one.length == other.length && one.time == other.time && one.mass == other.mass &&
           one.temperature == other.temperature;
}

static bool is(const char *text, size_t length, const prefix *before, const char *symbol)
{
    const size_t first = strlen(before->text), second = strlen(symbol);
    return length == first + second && memcmp(text, before->text, first) == 0 &&
           memcmp(text + first, symbol, second) == 0;
}

bool fw_unit_name_read(fw_unit_kind kind, const char *text, size_t length, fw_unit_name *name)
{
    for (int n = 0; n < KNOWN; ++n)
        for (int p = 0; p < PREFIXES; ++p) {
            const bool plain = prefixes[p].text[0] == '\0';
            if (known[n].kind != kind || (!plain && !known[n].prefixed) ||
                !is(text, length, &prefixes[p], known[n].text))
                continue;
            name->size = prefixes[p].size * known[n].size;
            snprintf(name->text, sizeof name->text, "%s%s", prefixes[p].shown, known[n].shown);
            return true;
        }
    return false;
}

fw_unit_name fw_unit_name_prefixed(const char *symbol, double si, double value)
{
    fw_unit_name name = {.size = si};
    const char *shown = "";
    double size = 1;
    for (int p = 0; p < PREFIXES && value > 0; ++p) {
        shown = prefixes[p].shown;
        size = prefixes[p].size;
        if (value / si >= .1 * size) break;
    }
    name.size *= size;
    snprintf(name.text, sizeof name.text, "%s%s", shown, symbol);
    return name;
}
