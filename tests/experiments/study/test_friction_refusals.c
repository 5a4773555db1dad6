/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_friction_refusals.c - what is refused of grips, phases, profile and study. */
#include "tests/support/laws.h"

#include "experiments/study/study.h"
#include "tests/support/beams.h"
#include "tests/support/scratch.h"

static void mistakes_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *setting, *sentence;
    } rows[] = {
        {"grips.more={body: left, sites: left}", "which grip 'left' holds already"},
        {"grips.more={body: right, sites: {rows: [5, 5], columns: [4, 4]}}",
         "grip 'more' holds site [4, 5] of body 'right', which grip 'right' holds already"},
        {"grips.left.sites={rows: [90, 91]}", "rows are [90, 91]"},
        {"phases.drive.until=400", "phases out of order: 'drive' ends at step 400"},
        {"phases.sample.until=2400", "phases out of order: 'sample' ends at step 2400"},
        {"phases.sample.until=2600", "phases out of order: 'sample' ends at step 2600"},
        {"phases.drive.grips.middle={force: [1, 0]}", "there is no grip 'middle'"},
        {"grips.left.path={velocity: [1, 0]}", "a path that no component follows"},
        {"grips.left.period=3", "has 'period' but no 'amplitude'"},
        {"grips.left.hold=x", "moves that component whatever force acts"},
        {"profile.window=[90, 99]", "the profile has no particles: none lies at 90 <= y <= 99"},
        {"profile.middle=90", "the profile has no particles at the contact"},
        /* x from -.5 - 5 (3/4)^(1/2) to 5: bins -483013 to 500000. */
        {"profile.bin=1e-5",
         "profile.bin is 1e-05, which makes 983014 bins, expected at most 100000"},
        {"profile.far=[80, 90]", "the profile has no particles far from the contact"},
        {"profile.phase=smaple", "did you mean 'sample'?"},
        {"profile.every=5000", "expected at most the 1000 steps"},
        {"expect.0={quantity: layer-contcat, above: 1}", "did you mean layer-contact?"},
        {"expect.0={quantity: slip, component: y, phase: drove, above: 1}", "did you mean 'drive'"},
        {"expect.0={quantity: layer-mobility, above: 1}",
         "it is now called layer-relative-displacement"},
        {"measure=[layer-contact]", "comes out of all runs together"},
        {"study.control=['phases.drive.grips.lfet.amplitude=[0, 0]']", "control: "},
    };
    int faults = 0;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        fw_scenario *scenario;
        fw_study *study = NULL;
        const fw_run_options options = {.threads = 1};
        fw_status status = fw_scenario_read(&scenario, "beams.yaml", small_beams,
                                            strlen(small_beams), &rows[n].setting, 1, &error);
        if (status == FW_OK) status = fw_study_begin(&study, scenario, &options, &error);
        if (status == FW_BAD_INPUT && strstr(error.sentence, rows[n].sentence)) {
            fw_scenario_destroy(scenario);
            continue;
        }
        faults += 1;
        print_error("%s\n  found    %s\n  expected %s\n", rows[n].setting,
                    status == FW_OK ? "no complaint" : error.sentence, rows[n].sentence);
        fw_study_destroy(study);
        fw_scenario_destroy(scenario);
    }
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_are_refused),
    };
    return cmocka_run_group_tests_name("friction refusals", tests, NULL, NULL);
}
