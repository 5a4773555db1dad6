/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_run_refused_calls.c - a run whose warnings cannot be kept ends with a sentence: none of them
 * is lost without a word. */
#include "tests/support/laws.h"

#include "experiments/study/run.h"
#include "tests/support/refused_calls.h"
#include "tests/support/scenarios.h"

#include <errno.h>

/* A body as fast as this beside a wall is warned of at once. */
static const char fast[] =
    "title: too fast\n"
    "materials: {m: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies: {b: {material: m, shape: {rectangle: [4, 4]}, velocity: [0.9, 0]}}\n"
    "walls: {floor: {chain: [[-9, -9], [9, -9]]}}\n"
    "run: {steps: 2}\n";

static void warnings_are_not_lost(void **state)
{
    (void)state;
    fw_scenario *scenario = read_right(fast);
    int refused = 0;
    for (int which = 1;; ++which) {
        char *said = NULL;
        size_t size = 0;
        fw_run *run;
        fw_run_options options = {.warnings = open_memstream(&said, &size)};
        assert_non_null(options.warnings);
        refuse_call(REFUSED_FCLOSE, which, ENOMEM);
        const fw_status status = fw_run_begin(&run, scenario, &options, &error);
        const bool was = call_was_refused();
        if (status == FW_OK) fw_run_destroy(run);
        fclose(options.warnings);
        if (status != FW_OK) assert_string_equal(error.sentence, "not enough memory for warnings");
        if (status == FW_OK) assert_non_null(strstr(said, "warning: "));
        free(said);
        refused += status != FW_OK;
        if (!was) break;
    }
    assert_int_equal(refused, 1);
    fw_scenario_destroy(scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(warnings_are_not_lost)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
