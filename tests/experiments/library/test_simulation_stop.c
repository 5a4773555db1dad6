/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_simulation_stop.c - simulations that stop before their end: where the
 * checkpoint cannot be written, and where the numbers diverge. */
#include "tests/support/laws.h"

#include "experiments/library/simulation.h"
#include "tests/support/program.h"

static const char flight[] = "title: a sheet flies\n"
                             "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
                             "bodies: {one: {material: rubber, shape: {rectangle: [3, 2]}}}\n"
                             "run: {steps: 50, record-every: 5}\n"
                             "measure: [energy]\n";

/* Its folder is gone, and with it where the checkpoint would be. */
static void a_stop_without_its_checkpoint_says_so(void **state)
{
    (void)state;
    char folder[64], out[96], sentence[FW_SENTENCE_SIZE];
    make_quick_folder(folder, sizeof folder);
    fw_simulation_def def = fw_simulation_def_default();
    fw_simulation *simulation;
    def.text = flight;
    snprintf(out, sizeof out, "%s/gone", folder);
    def.directory = out;
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    assert_fine(fw_simulation_advance(simulation, 21, &error));
    shell(folder, "rm -r gone");
    assert_refused(fw_simulation_stop(simulation, &error), FW_SYSTEM_FAILED, "checkpoint");
    strcpy(sentence, error.sentence);
    /* It stays stopped, for this reason. */
    assert_refused(fw_simulation_advance(simulation, 1, &error), FW_SYSTEM_FAILED, sentence);
    assert_fine(fw_simulation_stop(simulation, &error));
    fw_simulation_destroy(simulation);
    remove_folder(folder);
}

static bool count_calls(fw_simulation *simulation, void *context)
{
    (void)simulation;
    *(int *)context += 1;
    return true;
}

/* Pulled out of all bounds while somebody looks on. */
static void whoever_looks_is_told_that_it_diverges(void **state)
{
    (void)state;
    static const char *const settings[] = {"forces.pull={body: one, force: [1e6, 0]}"};
    fw_simulation_def def = fw_simulation_def_default();
    fw_simulation *simulation;
    int calls = 0;
    def.text = flight;
    def.settings = settings;
    def.setting_count = 1;
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    assert_refused(fw_simulation_run(simulation, 10, count_calls, &calls, &error), FW_DIVERGED,
                   "of body one");
    assert_int_equal(calls, 1);
    assert_true(fw_simulation_step(simulation) < 10);
    assert_false(fw_simulation_is_at_end(simulation));
    fw_simulation_destroy(simulation);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stop_without_its_checkpoint_says_so),
        cmocka_unit_test(whoever_looks_is_told_that_it_diverges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
