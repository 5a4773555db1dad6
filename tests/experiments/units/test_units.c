/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_units.c - what the reduced units are in nature: sizes by hand from the SI and CODATA 2018.
 */
#include "experiments/units/units.h"
#include "tests/support/laws.h"

#include <string.h>

static fw_error error;

/* Argon, of which everybody knows the Lennard-Jones units: 119.8 K, .3405 nm, 39.948 u, 2.156 ps.
 */
static fw_units argon(void)
{
    fw_units units = {
        .length_text = "0.3405 nm", .energy_text = "10.3236 meV", .mass_text = "39.948 u"};
    const char *key;
    assert_int_equal(fw_units_complete(&units, &key, &error), FW_OK);
    return units;
}

static void assert_physical(const fw_units *units, const char *unit, double factor,
                            const char *name)
{
    const fw_physical physical = fw_units_physical(units, unit);
    assert_string_equal(physical.text, name);
    assert_close(physical.factor, factor, 2e-4 * factor);
}

static void argon_has_the_units_that_everybody_knows(void **state)
{
    (void)state;
    const fw_units units = argon();
    assert_physical(&units, "length", .3405, "nm");
    assert_physical(&units, "energy", 10.3236, "meV");
    assert_physical(&units, "energy/k_B", 119.8, "K");
    assert_physical(&units, "time", 2.1564, "ps");
    assert_physical(&units, "mass", 39.948, "u");
    /* 157.9 m/s, 4.857 pN. */
    assert_physical(&units, "length/time", .1579, "km/s");
    assert_physical(&units, "spacings/step", .1579, "km/s");
    assert_physical(&units, "force", 4.8576, "pN");
    assert_physical(&units, "force/length", 14.266, "mN/m");
}

static void what_has_no_name_is_composed(void **state)
{
    (void)state;
    const fw_units units = argon();
    assert_physical(&units, "length^2", .3405 * .3405, "nm^2");
    assert_physical(&units, "1/time", 1 / 2.1564, "1/ps");
    assert_physical(&units, "length^2/time", .3405 * .3405 / 2.1564, "nm^2/ps");
    assert_physical(&units, "momentum", 39.948 * .3405 / 2.1564, "u nm/ps");
    assert_physical(&units, "angular momentum", 10.3236 * 2.1564, "meV ps");
    assert_physical(&units, "torque", 10.3236, "meV");
    assert_physical(&units, "energy/time", 10.3236 / 2.1564, "meV/ps");
    assert_physical(&units, "mass^(1/2)", sqrt(39.948), "u^(1/2)");
    assert_physical(&units, "(spacings/step)^2", pow(.3405 / 2.1564, 2), "nm^2/ps^2");
    assert_physical(&units, "length^(2)", .3405 * .3405, "nm^2");
    assert_physical(&units, "time^-1", 1 / 2.1564, "1/ps");
}

static void pure_numbers_angles_and_counts_stay(void **state)
{
    (void)state;
    const fw_units units = argon(), none = {.length = 0};
    const char *const plain[] = {"1",
                                 "",
                                 "degrees",
                                 "radians",
                                 "steps",
                                 "sites",
                                 "seconds",
                                 "lengths",
                                 "length/",
                                 "(length",
                                 "(length/",
                                 "length^(2",
                                 "length^ time",
                                 "length^(1/0)",
                                 "length^(x)",
                                 "energy/k_B/time"};
    for (size_t n = 0; n < sizeof plain / sizeof *plain; ++n)
        assert_true(fw_units_physical(&units, plain[n]).factor == 0);
    assert_true(fw_units_physical(&none, "length").factor == 0);
    assert_true(fw_units_physical(NULL, "length").factor == 0);
    char said[FW_UNITS_SAID];
    fw_units_say(said, &none, "length");
    assert_string_equal(said, "length");
    fw_units_say(said, &units, "length");
    assert_string_equal(said, "length = 0.3405 nm");
}

static void a_time_in_place_of_an_energy_gives_the_energy(void **state)
{
    (void)state;
    fw_units units = {.length_text = "1 mm", .time_text = "1us", .mass_text = "2 g"};
    const char *key;
    assert_int_equal(fw_units_complete(&units, &key, &error), FW_OK);
    /* .002 kg (1e3 m/s)^2. */
    assert_physical(&units, "energy", 2, "kJ");
    assert_physical(&units, "time", 1, "µs");
    assert_physical(&units, "force", 2, "MN");
}

/* A plane has forces per length; over its depth they are pressures. */
static void a_depth_makes_pressures(void **state)
{
    (void)state;
    fw_units units = {
        .length_text = "2 A", .energy_text = "1eV", .mass_text = "1 u", .depth_text = "0.2 nm"};
    const char *key;
    assert_int_equal(fw_units_complete(&units, &key, &error), FW_OK);
    /* 1.602e-19 J/(2e-10 m)^3. */
    assert_physical(&units, "force/length", 20.027, "GPa");
    assert_physical(&units, "length", 2, "Å");
}

static void what_is_no_size_is_refused(void **state)
{
    (void)state;
    static const struct {
        fw_units units;
        const char *key, *sentence;
    } wrong[] = {
        {{.length_text = "nm", .mass_text = "1 u", .time_text = "1 ps"},
         "length",
         "units.length is 'nm', expected a number above 0 and a unit of length: m with any prefix, "
         "cm, or A (0.1 nm)"},
        {{.length_text = "1 parsec", .mass_text = "1 u", .time_text = "1 ps"},
         "length",
         "units.length is in 'parsec', expected a unit of length: m with any prefix, cm, or A (0.1 "
         "nm)"},
        {{.length_text = "1 nm", .mass_text = "-1 u", .time_text = "1 ps"},
         "mass",
         "units.mass is '-1 u', expected a number above 0 and a unit of mass: g or Da with any "
         "prefix, or u"},
        {{.length_text = "1 nm", .mass_text = "1 u", .time_text = "1 nm"},
         "time",
         "units.time is in 'nm', expected a unit of time: s with any prefix"},
        {{.length_text = "1 nm", .mass_text = "1 u", .energy_text = "1 K"},
         "energy",
         "units.energy is in 'K', expected a unit of energy: J or eV with any prefix"},
        {{.length_text = "1 nm", .mass_text = "1 u", .time_text = "1 s", .depth_text = "1"},
         "depth",
         "units.depth is in '', expected a unit of length: m with any prefix, cm, or A (0.1 nm)"},
        {{.length_text = "1e100 m", .mass_text = "1 u", .time_text = "1 s"},
         "length",
         "units.length is '1e100 m', expected between 1e-60 and 1e60 SI units"},
        {{.length_text = "1.e-100 m", .mass_text = "1 u", .time_text = "1 s"},
         "length",
         "units.length is '1.e-100 m', expected between 1e-60 and 1e60 SI units"},
        {{.length_text = "1 m", .mass_text = "1. eV", .time_text = "1 s"},
         "mass",
         "units.mass is in 'eV', expected a unit of mass: g or Da with any prefix, or u"}};
    for (size_t n = 0; n < sizeof wrong / sizeof *wrong; ++n) {
        fw_units units = wrong[n].units;
        const char *key = NULL;
        assert_int_equal(fw_units_complete(&units, &key, &error), FW_BAD_INPUT);
        assert_string_equal(key, wrong[n].key);
        assert_string_equal(error.sentence, wrong[n].sentence);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(argon_has_the_units_that_everybody_knows),
        cmocka_unit_test(what_has_no_name_is_composed),
        cmocka_unit_test(pure_numbers_angles_and_counts_stay),
        cmocka_unit_test(a_time_in_place_of_an_energy_gives_the_energy),
        cmocka_unit_test(a_depth_makes_pressures),
        cmocka_unit_test(what_is_no_size_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
