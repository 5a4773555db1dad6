/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_damaged_tables.c - tables that are read again, with lines and cells missing or too many: the
 * reader says which file is wrong, and takes no number of it. The manifest, which would tell
 * before, has each of them as it is. */
#include "tests/support/laws.h"

#include "experiments/storage/manifest.h"
#include "experiments/study/study.h"
#include "experiments/study/summary.h"
#include "experiments/study/sweep_table.h"
#include "experiments/study/threshold_table.h"
#include "tests/support/program.h"
#include "tests/support/scenarios.h"

static char folder[64], made[2048];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static void put(const char *name, const char *text)
{
    assert_fine(fw_manifest_write(folder, name, text, strlen(text), &error));
}

/* --- what is done to a table --- */

/* The line of that number, from 0; its length without the line end. */
static const char *find_line(const char *text, int number, size_t *length)
{
    for (; number > 0 && *text; --number) text += strcspn(text, "\n") + 1;
    *length = strcspn(text, "\n");
    return text;
}

static int count_lines(const char *text)
{
    int count = 0;
    for (; *text; ++text) count += *text == '\n';
    return count;
}

/* Without its last `count` cells; false where it has no more than these. */
static bool cut_cells(const char *text, int number, int count)
{
    size_t length;
    const char *line = find_line(text, number, &length);
    const char *rest = line + length;
    while (count > 0 && length > 0)
        if (line[--length] == ',') --count;
    if (count > 0) return false;
    snprintf(made, sizeof made, "%.*s%s", (int)(line - text + (int)length), text, rest);
    return true;
}

static void add_cell(const char *text, int number)
{
    size_t length;
    const char *line = find_line(text, number, &length);
    snprintf(made, sizeof made, "%.*s,7%s", (int)(line - text + (int)length), text, line + length);
}

static void keep_lines(const char *text, int count)
{
    size_t length;
    const char *line = find_line(text, count, &length);
    snprintf(made, sizeof made, "%.*s", (int)(line - text), text);
}

/* Looks at what lies there as `made` says. */
typedef void look_function(void);

/* Of each line from `first` on every number of cells less than all, and with `more` one more. */
static int damage_lines(const char *text, int first, bool more, look_function *refused)
{
    int count = 0;
    for (int line = first; line < count_lines(text); ++line) {
        for (int cells = 1; cut_cells(text, line, cells); ++cells, ++count) refused();
        if (!more) continue;
        add_cell(text, line);
        refused();
        ++count;
    }
    return count;
}

/* --- the table of a sweep --- */

static const char swept[] = "# a sweep\n"
                            "# units: length/time,1,energy,energy,energy,energy,,\n"
                            "v,n,energy,energy error,energy expected,energy within,seeds,failure\n"
                            "0.1,1,2.5,0.25,2,1,3,\n"
                            "0.2,2,,,2,1,3,\"too fast; it says\"\n";

static void sweep_is_refused(void)
{
    char sentence[128];
    fw_sweep_table table;
    put(FW_SWEEP_FILE, made);
    snprintf(sentence, sizeof sentence, "%s/sweep.csv is not the table of a sweep", folder);
    error = (fw_error){0};
    if (fw_sweep_table_read(&table, folder, 2, &error) != FW_BAD_INPUT)
        fail_msg("taken for the table of a sweep: %s", made);
    assert_string_equal(error.sentence, sentence);
    assert_true(!table.values && !table.columns && !table.failures);
}

static void damaged_table_of_a_sweep_is_refused(void **state)
{
    (void)state;
    fw_sweep_table table;
    put(FW_SWEEP_FILE, swept);
    assert_fine(fw_sweep_table_read(&table, folder, 2, &error));
    assert_int_equal(table.row_count, 2);
    assert_int_equal(table.column_count, 1);
    assert_int_equal(table.seed_count, 3);
    assert_string_equal(table.axes[0].unit, "length/time");
    assert_string_equal(table.columns[0].name, "energy");
    assert_true(table.values[2] == .2 && table.values[3] == 2);
    assert_true(table.columns[0].mean[0] == 2.5 && table.columns[0].error[0] == .25);
    assert_true(isnan(table.columns[0].mean[1]) && table.columns[0].within[1] == 1);
    assert_null(table.failures[0]);
    assert_string_equal(table.failures[1], "too fast; it says");
    fw_sweep_table_clear(&table);
    assert_int_equal(damage_lines(swept, 1, true, sweep_is_refused), 4 * 8);
    for (int lines = 0; lines < 4; ++lines) {
        keep_lines(swept, lines);
        sweep_is_refused();
    }
    snprintf(made, sizeof made, "# a sweep\n%s", strchr(swept, 'v'));
    sweep_is_refused();
    /* Another number of parameters leaves too few cells, or none for the seeds. */
    snprintf(made, sizeof made, "# a sweep\n# units: ,\nv,seeds\n1,2\n");
    sweep_is_refused();
}

/* --- thresholds --- */

static const char thresholds[] =
    "quantity,level,n,v,standard error,seeds,no number since\n"
    "centre-of-mass.sheet x,9,1,0.1,0.01,3,\n"
    "centre-of-mass.sheet x,9,2,,,3,it is below the level at both ends\n";

static void thresholds_are_refused(void)
{
    char sentence[128];
    fw_threshold_row *rows;
    int count;
    put("thresholds.csv", made);
    snprintf(sentence, sizeof sentence, "%s/thresholds.csv does not hold the thresholds of a sweep",
             folder);
    error = (fw_error){0};
    if (fw_threshold_table_read(&rows, &count, folder, 2, &error) != FW_BAD_INPUT)
        fail_msg("taken for thresholds: %s", made);
    assert_string_equal(error.sentence, sentence);
    assert_null(rows);
    assert_int_equal(count, 0);
}

static void damaged_thresholds_are_refused(void **state)
{
    (void)state;
    fw_threshold_row *rows;
    int count;
    put("thresholds.csv", thresholds);
    assert_fine(fw_threshold_table_read(&rows, &count, folder, 2, &error));
    assert_int_equal(count, 2);
    assert_string_equal(rows[0].quantity, "centre-of-mass.sheet x");
    assert_true(rows[0].level == 9 && rows[0].values[0] == 1 && rows[0].values[1] == .1);
    assert_true(rows[0].error == .01 && rows[0].seeds == 3);
    assert_true(rows[1].values[0] == 2 && isnan(rows[1].values[1]) && isnan(rows[1].error));
    free(rows);
    assert_int_equal(damage_lines(thresholds, 1, true, thresholds_are_refused), 2 * 7);
    made[0] = '\0';
    thresholds_are_refused();
}

/* --- the summary of a study --- */

static const char summed[] = "title: summed\n"
                             "materials: {m: {movable-particles: {}}}\n"
                             "bodies: {b: {material: m, shape: {rectangle: [3, 3]}}}\n"
                             "dynamics: {damping: 1, temperature: .1}\n"
                             "run: {steps: 2}\n"
                             "study: {seeds: 2}\n"
                             "expect:\n"
                             "  - {quantity: energy, value: 4, within: 1}\n"
                             "  - {quantity: momentum, component: x, above: 2}\n";
static const char summary[] =
    "quantity,expected,mean,standard error,verdict,error is lower bound,no number since,seed 1,"
    "seed 2\n"
    "energy,4 +- 1,4.5,0.5,ok,1,,4,5\n"
    "\"momentum x\",> 2,1,,FAILS,0,it is short,1,1\n";

static fw_scenario *scenario;

static void summary_is_refused(void)
{
    char sentence[128];
    double seeds[4];
    fw_verdicts verdicts;
    size_t length;
    put(FW_SUMMARY_FILE, made);
    snprintf(sentence, sizeof sentence,
             "%s/summary.csv does not hold the 2 rows of what was expected", folder);
    assert_refused(fw_summary_read_seeds(folder, scenario, seeds, &error), FW_BAD_INPUT, sentence);
    /* Verdicts need no cells of seeds. */
    int cells = 1;
    const char *last = find_line(made, 2, &length);
    for (const char *c = last; *c && *c != '\n'; ++c) cells += *c == ',';
    if (*last && cells >= 7) return;
    assert_refused(fw_summary_read(folder, scenario, &verdicts, &error), FW_BAD_INPUT, sentence);
    assert_null(verdicts.item);
}

static void damaged_summaries_are_refused(void **state)
{
    (void)state;
    double seeds[4];
    fw_verdicts verdicts;
    scenario = read_right(summed);
    put(FW_SUMMARY_FILE, summary);
    assert_fine(fw_summary_read_seeds(folder, scenario, seeds, &error));
    assert_true(seeds[0] == 4 && seeds[1] == 5 && seeds[2] == 1 && seeds[3] == 1);
    assert_fine(fw_summary_read(folder, scenario, &verdicts, &error));
    assert_int_equal(verdicts.count, 2);
    assert_true(verdicts.item[0].measured == 4.5 && verdicts.item[0].error == .5);
    assert_true(verdicts.item[0].at_least && verdicts.item[0].holds);
    assert_true(verdicts.item[1].measured == 1 && isnan(verdicts.item[1].error));
    assert_false(verdicts.item[1].holds);
    assert_string_equal(verdicts.item[1].why, "it is short");
    fw_verdicts_clear(&verdicts);
    assert_int_equal(damage_lines(summary, 2, false, summary_is_refused), 8);
    for (int lines = 0; lines < 3; ++lines) {
        keep_lines(summary, lines);
        summary_is_refused();
    }
    fw_scenario_destroy(scenario);
}

/* --- layers of seeds --- */

static const char rubbing[] =
    "title: two crystals rub\n"
    "parameters: {T: 0}\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {damping: 0.4, temperature: T}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [-4, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [.5, 0]}\n"
    "run: {steps: 10, seed: 7}\n"
    "profile: {every: 5, far: [1, 3], contact: 1.5}\n"
    "study: {seeds: 2, sweep: {parameters: {T: {values: [0.001]}}}}\n";

static void layer_is_refused(void)
{
    char inner[128];
    snprintf(inner, sizeof inner, "%s/it/T=0.001", folder);
    assert_fine(fw_manifest_write(inner, FW_LAYER_FILE, made, strlen(made), &error));
    const outcome seen = run_program(folder, "collect it --no-plot");
    expect_end(&seen, 2, "fretwork: it/T=0.001/layer.csv does not hold the layers of 2 seeds\n");
}

static void damaged_layers_are_refused(void **state)
{
    (void)state;
    char inner[128], *text;
    size_t size;
    write_scenario(folder, "file.yaml", rubbing);
    outcome seen = run_program(folder, "run file.yaml -q --no-plot -o it -j 1");
    expect_end(&seen, 0, "");
    shell(folder, "cp it/sweep-seeds.csv before");
    snprintf(inner, sizeof inner, "%s/it/T=0.001", folder);
    assert_fine(fw_manifest_read(&text, &size, inner, FW_LAYER_FILE, &error));
    /* Names, then two rows of seeds. */
    for (int lines = 0; lines < 3; ++lines) {
        keep_lines(text, lines);
        layer_is_refused();
    }
    for (int line = 0; line < 3; line += 2)
        for (int cells = 1; cells < 12; cells += 5) {
            assert_true(cut_cells(text, line, cells));
            layer_is_refused();
        }
    assert_fine(fw_manifest_write(inner, FW_LAYER_FILE, text, size, &error));
    seen = run_program(folder, "collect it --no-plot");
    expect_end(&seen, 0, "");
    shell(folder, "cmp it/sweep-seeds.csv before");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(damaged_table_of_a_sweep_is_refused, begin, end),
        cmocka_unit_test_setup_teardown(damaged_thresholds_are_refused, begin, end),
        cmocka_unit_test_setup_teardown(damaged_summaries_are_refused, begin, end),
        cmocka_unit_test_setup_teardown(damaged_layers_are_refused, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
