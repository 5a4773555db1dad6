/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_warning.c - a body that folds is told of, whatever it is made of: contact of a body with
 * itself is not looked for. */
#include "tests/support/laws.h"

#include "experiments/measures/warning.h"
#include "tests/support/scratch.h"

#include <string.h>

/* The ends of a slab are pulled past each other. */
#define PULLED(material, lattice, dynamics, force)                                                 \
    "title: folds\n"                                                                               \
    "materials: {m: " material "}\n"                                                               \
    "bodies: {slab: {material: m, lattice: " lattice ", shape: {rectangle: [10, 3]}}}\n" dynamics  \
    "forces:\n"                                                                                    \
    "  left: {body: slab, sites: {columns: [0, 1]}, total: [" force ", 1]}\n"                      \
    "  right: {body: slab, sites: {columns: [8, 9]}, total: [-" force ", -1]}\n"                   \
    "run: {steps: 100}\n"

static const char *const solids[] = {
    PULLED("{lattice-boltzmann: {rest-mass: 0}}", "square", "", "6"),
    PULLED("{elastic-automaton: {c1: 1, c2: 0}}", "square", "", "6"),
    PULLED("{linear-lattice: {}}", "hexagonal", "dynamics: {time-step: 0.01}\n", "600")};

static void a_body_that_folds_is_told_of(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof solids / sizeof *solids; ++n) {
        fw_scenario *scenario;
        fw_experiment *experiment;
        char *said = NULL;
        size_t length = 0;
        assert_fine(fw_scenario_read(&scenario, "folds.yaml", solids[n], strlen(solids[n]), NULL, 0,
                                     &error));
        assert_fine(fw_experiment_create(&experiment, scenario, &error));
        fw_warning warning = {.out = open_memstream(&said, &length), .hurried = true};
        assert_fine(fw_warning_look(&warning, experiment, &error));
        fflush(warning.out);
        assert_int_equal(length, 0);
        for (int step = 0; step < 100; ++step) {
            assert_fine(fw_experiment_step(experiment, &error));
            assert_fine(fw_warning_look(&warning, experiment, &error));
        }
        fclose(warning.out);
        const char *first = strstr(said, "the edge of body slab crosses itself near");
        assert_non_null(first);
        assert_null(strstr(first + 1, "the edge of body")); /* it is said once */
        fw_warning_clear(&warning);
        free(said);
        fw_experiment_destroy(experiment);
        fw_scenario_destroy(scenario);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_body_that_folds_is_told_of)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
