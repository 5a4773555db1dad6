/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_texts.c - what pictures of results say, in words and in units of nature. */
#include "tests/support/laws.h"

#include "experiments/drawing/canvas.h"
#include "experiments/pictures/plot.h"
#include "tests/support/program.h"
#include "tests/support/seen_texts.h"

static void draw(const char *folder, const char *kind)
{
    char directory[128], file[128];
    snprintf(directory, sizeof directory, "%s/out", folder);
    snprintf(file, sizeof file, "%s/picture.png", folder);
    const fw_plot_wish wish = {.file = file, .kind = kind};
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    seen_text_count = 0;
    assert_fine(fw_plot_one(directory, &wish, nowhere, &error));
    fclose(nowhere);
}

/* A velocity of 1 is 1 nm over 1 ps. */
static const char sweep[] =
    "title: two sheets fly\n"
    "units: {length: 1 nm, time: 1 ps, mass: 1 u}\n"
    "parameters: {v: .1, L: 2}\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies: {sheet: {material: soft, shape: {rectangle: [L, 3]}, velocity: [v, 0]}}\n"
    "study:\n"
    "  sweep:\n"
    "    parameters:\n"
    "      L: {values: [2, 3, 4]}\n"
    "      v: {values: [.1, .25], unit: length/time}\n"
    "run: {steps: 4}\n"
    "expect: [{quantity: energy, above: 0}]\n";

static void lines_of_a_sweep_are_named_in_units_of_nature(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", sweep);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
    draw(folder, "sweep");
    assert_non_null(find_seen_text("v = 0.1 km/s", 0));
    assert_non_null(find_seen_text("v = 0.25 km/s", 0));
    assert_null(find_seen_text("v = 0.1", 1));
    remove_folder(folder);
}

/* Results in folders of one name are called by those above them. */
static void results_side_by_side_have_names_of_their_own(void **state)
{
    (void)state;
    char folder[64], soft[128], hard[128], file[128];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml",
                   "title: a sheet flies\n"
                   "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
                   "bodies: {sheet: {material: soft, shape: {rectangle: [2, 3]}}}\n"
                   "run: {steps: 4}\n"
                   "measure: [energy]\n");
    outcome seen = run_program(folder, "run file.yaml -o soft/out --no-plot --quiet");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run file.yaml -o hard/out --no-plot --quiet");
    expect_end(&seen, 0, "");
    snprintf(soft, sizeof soft, "%s/soft/out/", folder);
    snprintf(hard, sizeof hard, "%s/hard/out", folder);
    snprintf(file, sizeof file, "%s/picture.png", folder);
    const char *const energy[] = {"energy"}, *const with[] = {hard};
    const fw_plot_wish wish = {
        .file = file, .observables = energy, .observable_count = 1, .with = with, .with_count = 1};
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    seen_text_count = 0;
    assert_fine(fw_plot_one(soft, &wish, nowhere, &error));
    fclose(nowhere);
    assert_string_equal(find_seen_text("soft", 0)->text, "soft/out");
    assert_string_equal(find_seen_text("hard", 0)->text, "hard/out");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_of_a_sweep_are_named_in_units_of_nature),
        cmocka_unit_test(results_side_by_side_have_names_of_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
