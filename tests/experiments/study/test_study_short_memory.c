/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_study_short_memory.c - what asks for memory while a scenario is read, run, gone on with and
 * read back fails once at each place: it says so or comes to the same results without, and leaves
 * no memory behind. Start reading at the scenarios. */
#define _GNU_SOURCE /* nftw */
#include "tests/support/short_memory.h"

#include "experiments/results/playback.h"
#include "experiments/storage/checksum.h"
#include "experiments/study/study.h"
#include "experiments/study/summary.h"
#include "experiments/study/sweep.h"
#include "tests/support/program.h"
#include "tests/support/small_scenarios.h"

#include <ftw.h>
#include <omp.h>

/* All that is computed without running, of an automaton and of its lattice Boltzmann reference. */
static const char analysed[] =
    "title: an automaton and what is computed of it\n"
    "materials: {sheet: {elastic-automaton: {chopard: true}}}\n"
    "bodies: {block: {material: sheet, shape: {rectangle: [6, 4]}, velocity: [.01, 0]}}\n"
    "run: {steps: 4}\n"
    "analysis:\n"
    "  map: {stability-map: {c1: [.5, 1.5], c2: [.2, 1.4], points: [3, 2], waves: 4}}\n"
    "  waves: {dispersion: {material: sheet, size: 4, steps: 8}}\n"
    "  mode: {plane-mode: {material: sheet, wave-vector: [.5, 0]}}\n"
    "  body: {body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [2, 2]}}\n"
    "  twin: {boltzmann-reference: {body: block, half-steps: 8}}\n"
    "expect: [{quantity: reference-error, analysis: twin, below: 1e-9}]\n";

static const char sheets[] =
    "title: an automaton at two speeds\n"
    "materials: {sheet: {elastic-automaton: {c1: .4, c2: .2, break-at: .02}}}\n"
    "parameters: {w: 2*v, v: .1}\n"
    "bodies: {sheet: {material: sheet, shape: {rectangle: [6, 5]}, velocity: [v, 0*w]}}\n"
    "walls: {stop: {chain: [[7, -3], [7, 9]], surface: frictionless}}\n"
    "run: {steps: 20, record-every: 10, measure-every: 10}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, above: 0}]\n"
    "study: {seeds: 2, sweep: {parameters: {v: {values: [.05, .1]}}, set: [run.seed=1 + 0*v]}}\n";

/* Results are made in one folder, from what lies in the other one. */
static char folder[64], before[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    make_quick_folder(before, sizeof before);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    remove_folder(before);
    return 0;
}

static fw_run_options options_in(const char *path)
{
    return (fw_run_options){.directory = path, .threads = 1, .at_once = 1, .name = "it"};
}

static void add_numbers(uint64_t *hash, const double *values, size_t count)
{
    *hash = fw_checksum_add(*hash, values, count * sizeof *values);
}

/* Everything in a results file that is the same in each run. */
static fw_status hash_results(const char *path, uint64_t *hash, fw_error *failed)
{
    enum { MOST = 4096 };
    static double x[MOST], y[MOST];
    fw_playback *playback;
    FW_TRY(fw_playback_open(&playback, path, failed));
    fw_status status = FW_OK;
    for (int64_t frame = 0; status == FW_OK && frame < playback->frame_count; ++frame) {
        const size_t count = (size_t)playback->particle_count;
        status = fw_playback_read_positions(playback, frame, x, y, failed);
        add_numbers(hash, x, count);
        add_numbers(hash, y, count);
        for (int f = 0; status == FW_OK && f < playback->field_count; ++f) {
            status = fw_playback_read_field(playback, frame, playback->fields[f].name, x, failed);
            add_numbers(hash, x, count);
        }
    }
    for (int o = 0; status == FW_OK && o < playback->observable_count; ++o) {
        const size_t rows = (size_t)playback->sample_count;
        status = fw_playback_read_observable(playback, o, x, failed);
        add_numbers(hash, x, rows * (size_t)playback->observables[o].components);
    }
    *hash = fw_checksum_add(*hash, playback->scenario, strlen(playback->scenario));
    *hash = fw_checksum_add(*hash, playback->exit_reason, strlen(playback->exit_reason));
    fw_playback_close(playback);
    return status;
}

/* What a study keeps beside it. */
static fw_status hash_tables(const fw_scenario *scenario, const char *path, uint64_t *hash,
                             fw_error *failed)
{
    static double seeds[64];
    fw_verdicts verdicts = {0};
    const int count = scenario->expectation_count;
    if (scenario->profile.every != 0) {
        fw_playback *playback;
        fw_profile_table *table = NULL;
        FW_TRY(fw_playback_open(&playback, path, failed));
        const fw_status status =
            fw_profile_table_read(&table, playback, scenario->profile.axis ? 'y' : 'x', failed);
        if (status == FW_OK) add_numbers(hash, table->edges, (size_t)table->bin_count + 1);
        fw_profile_table_destroy(table);
        fw_playback_close(playback);
        FW_TRY(status);
    }
    if (count == 0) return FW_OK;
    FW_TRY(fw_summary_read(path, scenario, &verdicts, failed));
    for (int n = 0; n < verdicts.count; ++n) add_numbers(hash, &verdicts.item[n].measured, 1);
    fw_verdicts_clear(&verdicts);
    FW_TRY(fw_summary_read_seeds(path, scenario, seeds, failed));
    add_numbers(hash, seeds, (size_t)(count * scenario->study.seeds));
    return FW_OK;
}

static fw_status finish_study(fw_study *study, const fw_scenario *scenario, uint64_t *hash,
                              fw_error *failed)
{
    fw_status status = fw_study_to_end(study, failed);
    fw_study_destroy(study);
    *hash = FW_CHECKSUM_OF_NOTHING;
    if (status == FW_OK) status = hash_results(folder, hash, failed);
    return status == FW_OK ? hash_tables(scenario, folder, hash, failed) : status;
}

static int remove_one(const char *path, const struct stat *facts, int kind, struct FTW *where)
{
    (void)facts, (void)kind;
    return where->level > 0 ? remove(path) : 0;
}

/* The folder is as `before` is. Done often: without a shell where that is empty. */
static void begin_folder(void)
{
    char line[256];
    assert_int_equal(nftw(folder, remove_one, 8, FTW_DEPTH | FTW_PHYS), 0);
    if (!exists(before, "trajectory.h5")) return;
    snprintf(line, sizeof line, "cp -r . '%s'", folder);
    shell(before, line);
}

static fw_status read_scenario(fw_scenario **scenario, const char *text, fw_error *failed)
{
    return fw_scenario_read(scenario, "it.yaml", text, strlen(text), NULL, 0, failed);
}

static fw_status run_study(const void *text, uint64_t *hash, fw_error *failed)
{
    fw_scenario *scenario;
    fw_study *study;
    const fw_run_options options = options_in(folder);
    begin_folder();
    FW_TRY(read_scenario(&scenario, text, failed));
    fw_status status = fw_study_begin(&study, scenario, &options, failed);
    if (status == FW_OK) status = finish_study(study, scenario, hash, failed);
    fw_scenario_destroy(scenario);
    return status;
}

static fw_status go_on_with_study(const void *text, uint64_t *hash, fw_error *failed)
{
    fw_scenario *scenario;
    fw_study *study;
    char note[FW_SENTENCE_SIZE];
    const fw_run_options options = options_in(folder);
    begin_folder();
    FW_TRY(read_scenario(&scenario, text, failed));
    fw_status status = fw_study_resume(&study, scenario, &options, note, failed);
    if (status == FW_OK) status = finish_study(study, scenario, hash, failed);
    fw_scenario_destroy(scenario);
    return status;
}

static fw_status hash_sweep(const fw_scenario *scenario, const fw_sweep *sweep, uint64_t *hash,
                            fw_error *failed)
{
    char path[512], name[FW_CASE_NAME];
    fw_sweep_table table;
    *hash = FW_CHECKSUM_OF_NOTHING;
    for (int n = 0; n < fw_sweep_case_count(sweep); ++n) {
        fw_scenario_case_name(scenario, n, name);
        snprintf(path, sizeof path, "%s/%s", folder, name);
        FW_TRY(hash_results(path, hash, failed));
        FW_TRY(hash_tables(fw_sweep_scenario(sweep, n), path, hash, failed));
    }
    FW_TRY(fw_sweep_table_read(&table, folder, 1, failed));
    add_numbers(hash, table.values, (size_t)(table.row_count * table.axis_count));
    fw_sweep_table_clear(&table);
    return FW_OK;
}

static fw_status run_sweep(const void *text, uint64_t *hash, fw_error *failed)
{
    fw_scenario *scenario;
    fw_sweep *sweep;
    const fw_run_options options = options_in(folder);
    begin_folder();
    FW_TRY(read_scenario(&scenario, text, failed));
    fw_status status = fw_sweep_begin(&sweep, scenario, &options, failed);
    if (status == FW_OK) status = fw_sweep_to_end(sweep, failed);
    if (status == FW_OK) status = hash_sweep(scenario, sweep, hash, failed);
    fw_sweep_destroy(sweep);
    fw_scenario_destroy(scenario);
    return status;
}

/* --- tests --- */

/* Killed after some steps. */
static void leave_run(const char *text, int64_t steps)
{
    fw_scenario *scenario;
    fw_study *study;
    const fw_run_options options = options_in(before);
    assert_fine(read_scenario(&scenario, text, &error));
    assert_fine(fw_study_begin(&study, scenario, &options, &error));
    assert_fine(fw_run_advance(fw_study_run(study), steps, &error));
    fw_study_destroy(study);
    fw_scenario_destroy(scenario);
}

static void blocks_that_touch(void **state)
{
    (void)state;
    assert_true(fail_each_place("blocks", run_study, two_blocks) > 100);
    leave_run(two_blocks, 45);
    assert_true(fail_each_place("blocks gone on with", go_on_with_study, two_blocks) > 50);
}

static void crystal_over_seeds(void **state)
{
    (void)state;
    assert_true(fail_each_place("crystal", run_study, held_crystal) > 50);
}

static void automaton_and_its_analyses(void **state)
{
    (void)state;
    assert_true(fail_each_place("analyses", run_study, analysed) > 30);
}

static void sweep_over_seeds(void **state)
{
    (void)state;
    assert_true(fail_each_place("sweep", run_sweep, sheets) > 40);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(blocks_that_touch, begin, end),
        cmocka_unit_test_setup_teardown(crystal_over_seeds, begin, end),
        cmocka_unit_test_setup_teardown(automaton_and_its_analyses, begin, end),
        cmocka_unit_test_setup_teardown(sweep_over_seeds, begin, end),
    };
    omp_set_num_threads(1);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
