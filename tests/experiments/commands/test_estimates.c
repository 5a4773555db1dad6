/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_estimates.c - what check says of the time: of all runs, in the unit that it names. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char gas[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [3, 3]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 100}\n"
    "profile: {every: 50, bin: 1, middle: 1, far: [0.5, 3]}\n";
static const char seeds[] = "study: {seeds: 3}\n";
static const char seeds_with_control[] =
    "study: {seeds: 3, control: ['bodies.cloud.temperature=0']}\n";

static double json_number(const char *text, const char *name)
{
    char key[64];
    snprintf(key, sizeof key, "\"%s\": ", name);
    const char *at = strstr(text, key);
    if (!at) fail_msg("no %s in: %s", name, text);
    return strtod(at + strlen(key), NULL);
}

/* A folder with both studies. */
static void write_studies(char *folder, size_t size)
{
    char text[1024];
    make_quick_folder(folder, size);
    snprintf(text, sizeof text, "%s%s", gas, seeds);
    write_scenario(folder, "seeds.yaml", text);
    snprintf(text, sizeof text, "%s%s", gas, seeds_with_control);
    write_scenario(folder, "controlled.yaml", text);
}

/* Each of three seeds, and each of their controls. */
static void the_time_is_that_of_all_runs(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        int runs;
    } cases[] = {{"controlled.yaml", 6},
                 {"controlled.yaml --set study.seeds=1", 2},
                 {"seeds.yaml", 3},
                 {"seeds.yaml --set study.seeds=1", 1}};
    char folder[64], line[128];
    write_studies(folder, sizeof folder);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        snprintf(line, sizeof line, "check %s --json", cases[n].words);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 0, "");
        assert_int_equal(json_number(seen.out, "runs"), cases[n].runs);
        const double step = json_number(seen.out, "seconds_per_step");
        const double begin = json_number(seen.out, "seconds_to_begin");
        const double write = json_number(seen.out, "seconds_to_write");
        const double wanted = (step * 100 + begin + write) * cases[n].runs;
        assert_true(step > 0 && begin > 0 && write > 0);
        assert_close(json_number(seen.out, "seconds"), wanted, 1e-9 * wanted);
    }
    const outcome seen = run_program(folder, "check controlled.yaml");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "3 seeds, each with its control; what follows is of one run"));
    assert_non_null(strstr(seen.out, ", for the 6 runs, "));
    remove_folder(folder);
}

/* The duration behind a word, in seconds, with what its last digit is worth. */
static double duration_of(const char *text, const char *word, double *digit)
{
    static const struct {
        const char *name;
        double seconds, digit;
    } units[] = {{" s,", 1, 0}, {" min,", 60, 60}, {" h,", 3600, 360}, {" days,", 86400, 0}};
    char start[64], *end;
    snprintf(start, sizeof start, "\n  %s ", word);
    const char *at = strstr(text, start);
    if (!at) fail_msg("nothing is said of %s in: %s", word, text);
    const double number = strtod(at + strlen(start), &end);
    for (size_t n = 0; n < sizeof units / sizeof *units; ++n)
        if (strncmp(end, units[n].name, strlen(units[n].name)) == 0) {
            const double seconds = number * units[n].seconds;
            *digit = fmax(units[n].digit, .06 * seconds);
            return seconds;
        }
    fail_msg("no unit of time: %s", end);
    return 0;
}

/* Whatever the unit, it is what a step takes, times the steps, and what comes beside them. */
static void a_duration_is_in_its_unit(void **state)
{
    (void)state;
    static const char *const units[] = {" s, about", " min, about", " h, about", " days, about"};
    char folder[64], line[128];
    bool seen_unit[4] = {false};
    write_studies(folder, sizeof folder);
    for (double steps = 1e4; steps < 2e12; steps *= 10) {
        double digit;
        snprintf(line, sizeof line,
                 "check seeds.yaml --set run.steps=%.0f --set run.measure-every=%.0f "
                 "--set profile.every=%.0f",
                 steps, steps / 100, steps / 10);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 0, "");
        const char *threads = strstr(seen.out, " thread"), *each = strstr(seen.out, " ms a step)");
        assert_true(threads && each);
        const double step = 1e-3 * strtod(strchr(threads, '(') + 1, NULL);
        const double beside = strtod(strchr(each, ',') + 1, NULL);
        const double wanted = step * steps + beside;
        const double found = duration_of(seen.out, "time", &digit);
        assert_close(found, wanted, digit + .05 * beside + .01 * wanted);
        const double all = duration_of(seen.out, "in all", &digit);
        assert_close(all, 3 * wanted, digit + .15 * beside + .03 * wanted);
        for (int n = 0; n < 4; ++n) seen_unit[n] = seen_unit[n] || strstr(seen.out, units[n]);
    }
    for (int n = 0; n < 4; ++n) assert_true(seen_unit[n]);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_time_is_that_of_all_runs),
        cmocka_unit_test(a_duration_is_in_its_unit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
