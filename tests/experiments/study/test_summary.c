/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_summary.c - the summary of a study has each seed under its number, and their mean. */
#include "tests/support/laws.h"

#include "experiments/storage/csv.h"
#include "experiments/text/text.h"
#include "tests/support/program.h"

static const char gas[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [3, 3]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 20, seed: 41}\n"
    "study: {seeds: 3}\n"
    "expect: [{quantity: kinetic-energy, statistic: mean, above: 0}]\n";

static double number_in(char **line)
{
    char *cell;
    assert_non_null(*line);
    *line = fw_csv_cut(*line, &cell);
    return fw_csv_read_number(cell);
}

static void each_seed_stands_under_its_number(void **state)
{
    (void)state;
    char folder[64], path[128], text[2048], *rest = text, *cell;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    const outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    snprintf(path, sizeof path, "%s/it/summary.csv", folder);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(fw_text_line(&rest),
                        "quantity,expected,mean,standard error,verdict,error is lower bound,"
                        "no number since,seed 41,seed 42,seed 43");
    char *line = fw_text_line(&rest);
    for (int n = 0; n < 2; ++n) line = fw_csv_cut(line, &cell);
    const double mean = number_in(&line), error_of_mean = number_in(&line);
    for (int n = 0; n < 3; ++n) line = fw_csv_cut(line, &cell);
    double seeds[3], square = 0;
    for (int n = 0; n < 3; ++n) seeds[n] = number_in(&line);
    assert_true(seeds[0] != seeds[1] && seeds[1] != seeds[2]);
    assert_close(mean, (seeds[0] + seeds[1] + seeds[2]) / 3, 1e-12);
    for (int n = 0; n < 3; ++n) square += (seeds[n] - mean) * (seeds[n] - mean);
    assert_close(error_of_mean, sqrt(square / 6), 1e-12);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_seed_stands_under_its_number)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
