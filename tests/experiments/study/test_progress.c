/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_progress.c - the progress line fits its terminal and speaks of the whole; elsewhere there is
 * a line now and then. */
#include "tests/support/laws.h"

#include "experiments/study/study.h"
#include "tests/support/program.h"

/* What is shown after so much of 1000 was done, after two pieces. */
static void show(char *text, size_t size, int width, double found, double done)
{
    FILE *out = tmpfile();
    assert_non_null(out);
    fw_progress p = fw_progress_begin(out, "friction-sweep 2/7 A=2.5");
    p.total = 1000;
    p.terminal = width > 0;
    p.width = width;
    p.every = 0;
    fw_progress_find(&p, found);
    fw_progress_add(&p, done / 2);
    usleep(20000);
    fw_progress_add(&p, done / 2);
    take_stream(out, text, size);
}

/* Columns of the last line, without what wipes the rest. */
static int last_width(const char *text)
{
    const char *line = strrchr(text, '\r') + 1;
    return (int)strcspn(line, "\033");
}

static void line_fits_any_terminal(void **state)
{
    char text[1024];
    (void)state;
    for (int width = 20; width <= 300; ++width) {
        show(text, sizeof text, width, 0, 500);
        assert_true(last_width(text) < width);
        assert_non_null(strstr(text, "50 %"));
        assert_non_null(strstr(text, " left"));
    }
    show(text, sizeof text, 80, 0, 500);
    assert_non_null(strstr(text, "\rfriction-sweep 2/7 A=2.5 ["));
    assert_non_null(strstr(text, "#."));
    show(text, sizeof text, 200, 0, 500);
    assert_non_null(strstr(text, "million particle steps/s"));
}

/* A run that goes on begins where it was, and its rate is that of now. */
static void what_was_found_counts_as_done(void **state)
{
    char text[1024];
    (void)state;
    show(text, sizeof text, 80, 900, 2);
    assert_non_null(strstr(text, "90 %"));
    /* 1 in 20 ms, so 98 take about 2 s and not 2 ms. */
    const double left = strtod(strstr(text, "90 %, ") + 6, NULL);
    assert_true(left > 1.5 && left < 60);
}

static void elsewhere_there_are_lines(void **state)
{
    char text[1024];
    (void)state;
    show(text, sizeof text, 0, 0, 500);
    assert_null(strpbrk(text, "\r\033["));
    assert_non_null(strstr(text, "friction-sweep 2/7 A=2.5: 50 %, "));
    assert_int_equal(text[strlen(text) - 1], '\n');
    fw_progress quiet = fw_progress_begin(NULL, "run");
    fw_progress_add(&quiet, 1);
    fw_progress_add(NULL, 1);
    fw_progress_end(&quiet);
    FILE *out = tmpfile();
    fw_progress fresh = fw_progress_begin(out, "run");
    assert_true(fresh.every == 30);
    fw_progress_add(&fresh, 1);
    fw_progress_add(&fresh, 1);
    take_stream(out, text, sizeof text);
    assert_string_equal(text, "");
}

static const char study[] = "title: a gas\n"
                            "materials: {gas: {movable-particles: {strength: 0}}}\n"
                            "bodies: {cloud: {material: gas, shape: {rectangle: [4, 3]}}}\n"
                            "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
                            "run: {steps: 20}\n"
                            "study: {seeds: 3}\n";

/* All runs of a study are counted, not the first alone. */
static void all_runs_of_a_study_count(void **state)
{
    fw_scenario *scenario;
    fw_study *made;
    (void)state;
    assert_fine(fw_scenario_read(&scenario, "gas", study, strlen(study), NULL, 0, &error));
    FILE *out = tmpfile();
    fw_progress progress = fw_progress_begin(out, "gas");
    const fw_run_options options = {.threads = 1, .at_once = 2, .progress = &progress};
    assert_fine(fw_study_begin(&made, scenario, &options, &error));
    assert_true(progress.total == 3 * 20 * 12);
    assert_fine(fw_study_to_end(made, &error));
    assert_true(progress.done == progress.total);
    fw_study_destroy(made);
    fw_scenario_destroy(scenario);
    fclose(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(line_fits_any_terminal),
        cmocka_unit_test(what_was_found_counts_as_done),
        cmocka_unit_test(elsewhere_there_are_lines),
        cmocka_unit_test(all_runs_of_a_study_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
