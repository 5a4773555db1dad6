/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_export.c - what is exported are the numbers of the results file, in files that others read:
 * see exported.py. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

/* Two solids, one without links; forces, masses that differ, a field that one of them lacks. */
static const char scenario[] = "title: \"<b> & \\\"two\\\" solids\"\n"
                               "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
                               "bodies:\n"
                               "  falling: {material: soft, shape: {rectangle: [4, 3]}, origin: "
                               "[.3, 3.05], velocity: [.01, -.1]}\n"
                               "  lying: {material: soft, shape: {mask: \"#.#\\n###\"}}\n"
                               "run: {steps: 25, record-every: 5}\n"
                               "record: {force: true, fields: [strain-yy]}\n"
                               "measure: [energy]\n";

static const char gas[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 30, record-every: 10}\n"
    "record: {velocity: false}\n"
    "measure: [energy]\n";

/* As out-EVERY. */
static void export_everything(const char *folder, int every)
{
    static const char *const formats[][2] = {
        {"csv", "csv"}, {"extxyz", "extxyz"}, {"vtp", "pvd"}, {"xdmf", "xdmf"}, {"data", "data"}};
    for (int n = 0; n < 5; ++n) {
        char line[128], said[64], thinned[32];
        snprintf(thinned, sizeof thinned, " --every %d", every);
        if (every == 1) thinned[0] = '\0';
        snprintf(line, sizeof line, "export out --to %s -o out-%d.%s%s", formats[n][0], every,
                 formats[n][1], thinned);
        snprintf(said, sizeof said, "exported: out-%d.%s\n", every, formats[n][1]);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 0, "");
        assert_string_equal(seen.out, said);
    }
}

static void check_exported(const char *folder, const char *more)
{
    char arguments[128];
    snprintf(arguments, sizeof arguments, "%s out %s", folder, more);
    const int status = run_python("exported.py", arguments);
    if (status > 0) fail_msg("what was exported is not what the results say");
}

static void check_scenario(const char *text)
{
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", text);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    /* By four: of six frames the first and the fifth, of four only the first. */
    for (int every = 1; every <= 4; every *= 2) export_everything(folder, every);
    check_exported(folder, "1,2,4");
    remove_folder(folder);
    skip_unseen();
}

static void solids_with_links_are_exported_bit_by_bit(void **state)
{
    (void)state;
    check_scenario(scenario);
}

static void particles_without_velocities_are_exported_bit_by_bit(void **state)
{
    (void)state;
    check_scenario(gas);
}

/* Bit by bit, whether by ids in LAMMPS' order or by lines. */
static void a_run_starts_where_an_exported_one_ended(void **state)
{
    (void)state;
    static const char *const endings[] = {"data", "extxyz"};
    char folder[64], line[512];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", gas);
    outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    export_everything(folder, 1);
    for (int n = 0; n < 2; ++n) {
        snprintf(line, sizeof line,
                 "title: again\nmaterials: {gas: {movable-particles: {strength: 0}}}\n"
                 "bodies: {cloud: {material: gas, shape: {file: out-1.%s}}}\nrun: {steps: 1}\n",
                 endings[n]);
        write_scenario(folder, "again.yaml", line);
        snprintf(line, sizeof line, "run again.yaml -o %s --no-plot --quiet", endings[n]);
        seen = run_program(folder, line);
        expect_end(&seen, 0, "");
        snprintf(line, sizeof line, "rerun %s -o third --overwrite", endings[n]);
        seen = run_program(folder, line);
        expect_end(&seen, 0, "");
    }
    check_exported(folder, "1 data extxyz");
    remove_folder(folder);
    skip_unseen();
}

static void export_refuses_what_it_cannot_do(void **state)
{
    (void)state;
    static const char *const refused[][2] = {
        {"export out", "expected --to and one of xdmf, extxyz, vtp, csv, data"},
        {"export out --to mp4", "mp4"},
        {"export nothing --to csv", "nothing"},
        {"export out --to vtp -o out.vtp", "'out.vtp' as vtp, expected a name that ends in .pvd"},
        {"export out --to vtp -o .pvd", "'.pvd' as vtp, expected a name that ends in .pvd"},
        {"export out --to csv -o out.txt", "'out.txt' as csv, expected a name that ends in .csv"},
        {"export out --to xdmf -o out.csv", "expected a name that ends in .xdmf or .xmf"},
        {"export out --to extxyz -o xyz", "'xyz' as extxyz, expected a name that ends in .extxyz "
                                          "or .xyz"},
        {"export out --to data -o out.dat", "expected a name that ends in .data or .lmp"},
        {"export out --to csv --every 0", "--every"},
        {"export file.yaml --to csv", "file.yaml"},
    };
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", gas);
    outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n) {
        seen = run_program(folder, refused[n][0]);
        expect_end(&seen, 2, refused[n][1]);
    }
    seen = run_program(folder, "export out --to csv -o missing/out.csv");
    expect_end(&seen, 4, "missing/out.csv");
    static const char *const also[] = {"xdmf -o out.xmf", "extxyz -o out.xyz", "data -o out.lmp"};
    for (size_t n = 0; n < sizeof also / sizeof *also; ++n) {
        char line[64];
        snprintf(line, sizeof line, "export out --to %s", also[n]);
        seen = run_program(folder, line);
        expect_end(&seen, 0, "");
        assert_true(exists(folder, strstr(also[n], "out")));
    }
    remove_folder(folder);
}

/* However the folder is named, what is made stands beside it, under its name. */
static void exports_stand_beside_their_results(void **state)
{
    (void)state;
    static const struct {
        const char *inside, *line, *made;
    } rows[] = {
        {".", "export out/ --to csv", "out.csv"},
        {".", "export out/trajectory.h5 --to extxyz", "out.extxyz"},
        {".", "export ./out/. --to xdmf", "out.xdmf"},
        {"out", "export . --to data", "out.data"},
        {"out", "export trajectory.h5 --to vtp", "out.pvd"},
        {"out/inner", "export .. --to xdmf", "out.xdmf"},
        {"out", "rerun . -q --no-plot", "out-again/trajectory.h5"},
    };
    char folder[64], inside[128], line[128];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", gas);
    outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    shell(folder, "mkdir out/inner");
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        snprintf(inside, sizeof inside, "%s/%s", folder, rows[n].inside);
        seen = run_program(inside, rows[n].line);
        expect_end(&seen, 0, "");
        if (!exists(folder, rows[n].made)) fail_msg("%s: %s", rows[n].line, seen.out);
        snprintf(line, sizeof line, "rm -r %s", rows[n].made);
        shell(folder, line);
    }
    remove_folder(folder);
}

/* Neither half a file nor a temporary one. */
static void export_that_fails_leaves_nothing(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", gas);
    outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    shell(folder, "truncate -s -3000 out/trajectory.h5; mkdir lists; ls >lists/before");
    for (int n = 0; n < 2; ++n) {
        seen = run_program(folder, n ? "export out --to csv" : "export out --to extxyz");
        assert_int_not_equal(seen.code, 0);
    }
    shell(folder, "ls >lists/after; cmp lists/before lists/after");
    remove_folder(folder);
}

/* Frames that were there before stay. */
static void frames_that_nobody_lists_are_taken_back(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", gas);
    outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    shell(folder, "mkdir out.pvd");
    seen = run_program(folder, "export out --to vtp");
    expect_end(&seen, 4, "out.pvd");
    assert_false(exists(folder, "out.frames"));
    shell(folder, "mkdir -p out.frames/frame-000002.vtp");
    seen = run_program(folder, "export out --to vtp");
    expect_end(&seen, 4, "frame-000002.vtp");
    shell(folder, "test \"$(ls out.frames)\" = frame-000002.vtp");
    shell(folder, "rmdir out.frames/frame-000002.vtp; touch out.frames/frame-000000.vtp");
    seen = run_program(folder, "export out --to vtp");
    expect_end(&seen, 4, "out.pvd");
    shell(folder, "test \"$(ls out.frames)\" = frame-000000.vtp");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_with_links_are_exported_bit_by_bit),
        cmocka_unit_test(particles_without_velocities_are_exported_bit_by_bit),
        cmocka_unit_test(a_run_starts_where_an_exported_one_ended),
        cmocka_unit_test(export_refuses_what_it_cannot_do),
        cmocka_unit_test(exports_stand_beside_their_results),
        cmocka_unit_test(export_that_fails_leaves_nothing),
        cmocka_unit_test(frames_that_nobody_lists_are_taken_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
