/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_cite.c - exactly what a scenario rests on is cited. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

/* The keys of the entries, with a blank behind each. */
static void keys_of(const char *text, char *keys)
{
    *keys = '\0';
    for (const char *at = text; (at = strchr(at, '@')); ++at) {
        const char *key = strchr(at, '{') + 1;
        strncat(keys, key, strcspn(key, ","));
        strcat(keys, " ");
    }
}

typedef struct expected {
    const char *line, *keys;
} expected;

static const expected expectations[] = {
    /* one of each solid, with walls and without */
    {"cite wall-bounce", "fretwork chopard2002 catto2020 debuyl2014 "},
    {"cite chain", "fretwork chopard2002 debuyl2014 "},
    {"cite bounce", "fretwork dong2012 catto2020 debuyl2014 "},
    {"cite wave", "fretwork dong2012 debuyl2014 "},
    {"cite isotropy", "fretwork popov2007 swope1982 debuyl2014 "},
    {"cite mlp-wall-bounce", "fretwork popov2007 swope1982 catto2020 debuyl2014 "},
    /* two solids by their comparison */
    {"cite lb-equals-ca", "fretwork chopard2002 dong2012 salmon2011 catto2020 debuyl2014 "},
    /* random forces on the LB solid, a heat bath */
    {"cite conservation", "fretwork chopard2002 salmon2011 debuyl2014 "},
    {"cite thermostat", "fretwork popov2007 leimkuhler2013 salmon2011 debuyl2014 "},
    {"cite mlp-gravity", "fretwork popov2007 leimkuhler2013 salmon2011 catto2020 debuyl2014 "},
    {"cite friction", "fretwork popov2007 leimkuhler2013 salmon2011 debuyl2014 "},
    {"cite friction-sweep", "fretwork popov2007 leimkuhler2013 salmon2011 debuyl2014 "},
    /* a bath without damping brings no noise, and phases may have either integrator */
    {"cite bath.yaml", "fretwork popov2007 swope1982 debuyl2014 "},
    {"cite phases.yaml", "fretwork popov2007 swope1982 leimkuhler2013 salmon2011 debuyl2014 "},
};

#define GAS                                                                                        \
    "title: a gas\n"                                                                               \
    "materials: {gas: {movable-particles: {strength: 0}}}\n"                                       \
    "bodies: {cloud: {material: gas, shape: {rectangle: [2, 2]}}}\n"                               \
    "run: {steps: 20}\n"

static void exactly_what_it_rests_on_is_cited(void **state)
{
    char folder[64], keys[512];
    int wrong = 0;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "bath.yaml", GAS "dynamics: {time-step: 0.01, temperature: 1}\n");
    write_scenario(folder, "phases.yaml",
                   GAS "dynamics: {time-step: 0.01, temperature: 1}\n"
                       "phases: {warm: {until: 10, damping: 1}, free: {until: 20}}\n");
    for (size_t n = 0; n < sizeof expectations / sizeof *expectations; ++n) {
        outcome seen = run_program(folder, expectations[n].line);
        expect_end(&seen, 0, "");
        keys_of(seen.out, keys);
        if (strcmp(keys, expectations[n].keys) != 0) {
            print_error("%s: %s\n  expected %s\n", expectations[n].line, keys,
                        expectations[n].keys);
            ++wrong;
        }
    }
    assert_int_equal(wrong, 0);
    remove_folder(folder);
}

/* A result says what was run, whatever its folder is called. */
static void a_result_is_cited_as_its_scenario(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "run bounce "
                                       "-q --no-plot -o it");
    expect_end(&seen, 0, "");
    outcome result = run_program(folder, "cite it"), scenario = run_program(folder, "cite bounce");
    expect_end(&result, 0, "");
    assert_string_equal(result.out, scenario.out);
    /* Also where the catalogue has an experiment of that name. */
    seen = run_program(folder, "run bounce -q --no-plot -o press");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "cite press");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, scenario.out);
    /* Braces close. */
    int depth = 0;
    for (const char *c = result.out; *c; ++c) depth += (*c == '{') - (*c == '}');
    assert_int_equal(depth, 0);
    seen = run_program(folder, "cite nothing");
    expect_end(&seen, 2, "there is no experiment 'nothing'");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exactly_what_it_rests_on_is_cited),
        cmocka_unit_test(a_result_is_cited_as_its_scenario),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
