/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_leftovers.c - a folder in which a result was replaced holds nothing of the earlier one, but
 * what is the user's own; and a replacement that cannot begin leaves it whole. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char study[] =
    "title: two small crystals rest\n"
    "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  left: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 4]}, origin: [-5, 0]}\n"
    "  right: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 4]},"
    " origin: [0.5, 0]}\n"
    "dynamics: {damping: 1, temperature: 0.001}\n"
    "run: {steps: 60, measure-every: 2}\n"
    "profile: {every: 10, far: [2, 4], contact: 1.5}\n"
    "study: {seeds: 2, control: ['dynamics.temperature=0']}\n"
    "pictures: {across: {kind: profile}, still: {kind: field}}\n";

static const char sweep[] = "title: a sheet flies\n"
                            "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
                            "bodies: {sheet: {material: rubber, shape: {rectangle: [3, 3]}}}\n"
                            "run: {steps: 20}\n"
                            "study: {sweep: {parameters: {v: {values: [0.1, 0.2, 0.3]}}, set: "
                            "['bodies.sheet.velocity=[v, 0]']}}\n"
                            "expect: [{quantity: energy-drift, below: 1e-12}]\n"
                            "pictures: {speeds: {kind: sweep}, way: {kind: motion}}\n";

static void run_into_it(const char *folder, const char *line)
{
    const outcome seen = run_program(folder, line);
    expect_end(&seen, 0, "");
}

static void assert_all(const char *folder, const char *const names[], bool there)
{
    for (int n = 0; names[n]; ++n)
        if (exists(folder, names[n]) != there)
            fail_msg("%s is %sthere", names[n], there ? "not " : "");
}

static void a_study_leaves_nothing_beside_a_run(void **state)
{
    static const char *const made[] = {"it/control/trajectory.h5",
                                       "it/control",
                                       "it/across.png",
                                       "it/still.png",
                                       "it/profile.csv",
                                       "it/layer.csv",
                                       NULL};
    static const char *const fresh[] = {"it/trajectory.h5", "it/notes.txt", NULL};
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "study.yaml", study);
    run_into_it(folder, "run study.yaml -q -o it");
    assert_all(folder, made, true);
    shell(folder, "echo mine > it/notes.txt");
    /* What cannot begin changes nothing. */
    const outcome seen =
        run_program(folder, "run free-particle -q --set run.steps=0 -o it --overwrite");
    expect_end(&seen, 2, "run.steps");
    assert_all(folder, made, true);
    run_into_it(folder, "run free-particle -q --no-plot -o it --overwrite");
    assert_all(folder, made, false);
    assert_all(folder, fresh, true);
    remove_folder(folder);
}

static void a_sweep_leaves_only_the_cases_of_the_next(void **state)
{
    static const char *const gone[] = {"it/v=0.1", "it/v=0.3", NULL};
    static const char *const kept[] = {"it/v=0.2/trajectory.h5", "it/v=0.4/trajectory.h5",
                                       "it/speeds.png", "it/sweep.csv", NULL};
    static const char *const after[] = {
        "it/v=0.2", "it/v=0.4", "it/speeds.png", "it/sweep.csv", "it/sweep-as-run.yaml", NULL};
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "sweep.yaml", sweep);
    run_into_it(folder, "run sweep.yaml -q -o it");
    assert_all(folder, gone, true);
    run_into_it(
        folder,
        "run sweep.yaml -q -o it --overwrite --set study.sweep.parameters.v.values=[0.2,0.4]");
    assert_all(folder, gone, false);
    assert_all(folder, kept, true);
    run_into_it(folder, "run free-particle -q --no-plot -o it --overwrite");
    assert_all(folder, after, false);
    remove_folder(folder);
}

/* A picture that names no field has one recorded. */
static void pictures_record_what_they_show(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "sweep.yaml", sweep);
    run_into_it(folder, "run sweep.yaml -q -o it --set study={} --set expect=[]"
                        " --set 'pictures={colour: {kind: field}}'");
    assert_true(exists(folder, "it/colour.png"));
    remove_folder(folder);
}

static void pictures_without_their_data_are_refused_before_the_run(void **state)
{
    static const struct {
        const char *pictures, *words;
    } wrong[] = {
        {"{a: {kind: profile}}", "pictures.a is of kind 'profile', but the scenario has no "
                                 "'profile'"},
        {"{a: {kind: loop}}", "pictures.a is of kind 'loop', but the scenario has no"},
        {"{a: {kind: series, observables: [slip]}}", "there is nothing to measure slip of"}};
    char folder[64], line[256];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "sweep.yaml", sweep);
    for (size_t n = 0; n < sizeof wrong / sizeof wrong[0]; ++n) {
        snprintf(line, sizeof line,
                 "run sweep.yaml -q -o it --set study={} --set expect=[] --set 'pictures=%s'",
                 wrong[n].pictures);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 2, wrong[n].words);
        assert_false(exists(folder, "it"));
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_study_leaves_nothing_beside_a_run),
        cmocka_unit_test(a_sweep_leaves_only_the_cases_of_the_next),
        cmocka_unit_test(pictures_record_what_they_show),
        cmocka_unit_test(pictures_without_their_data_are_refused_before_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
