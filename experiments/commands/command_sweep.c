/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_sweep.c - sweep and collect: the cases of a sweep for whatever engine runs them, and what
 * they say together. All that is known of a case lies in its folder. Keeps no state. Start reading
 * at fw_command_sweep(). */
#include "experiments/commands/command.h"
#include "experiments/storage/manifest.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/leftovers.h"
#include "experiments/study/sweep.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

/* As a shell reads it. */
static void print_word(const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "-_./=,+:@%";
    if (word[0] && strspn(word, plain) == strlen(word)) {
        fputs(word, stdout);
        return;
    }
    putchar('\'');
    for (const char *c = word; *c; ++c)
        if (*c == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*c);
    putchar('\'');
}

static void print_cases(const fw_scenario *scenario, const char *directory)
{
    for (int n = 0; n < scenario->study.sweep.case_count; ++n) {
        char name[FW_CASE_NAME];
        fw_scenario_case_name(scenario, n, name);
        fputs("fretwork sweep ", stdout);
        print_word(directory);
        printf(" --case %s\n", name);
    }
}

/* Is it the sweep that lies there already? */
static fw_status is_same(const fw_scenario *scenario, const char *directory, bool *same,
                         fw_error *error)
{
    char *found, *text;
    size_t size;
    *same = false;
    if (!fw_sweep_is_in(directory)) return FW_OK;
    FW_TRY(fw_manifest_read(&found, &size, directory, FW_SWEEP_SCENARIO, error));
    const fw_status status = fw_scenario_print(scenario, &text, error);
    if (status == FW_OK) {
        *same = strcmp(found, text) == 0;
        free(text);
    }
    free(found);
    return status;
}

/* The folder with the scenario of the sweep, from which the cases are run. */
static fw_status prepare(const fw_scenario *scenario, const char *directory, const char *name,
                         bool overwrite, fw_error *error)
{
    const fw_run_options options = {
        .directory = directory, .overwrite = overwrite, .threads = 1, .name = name};
    fw_leftovers *leftovers;
    fw_sweep *sweep;
    bool same = false;
    if (!overwrite) FW_TRY(is_same(scenario, directory, &same, error));
    if (same) return FW_OK;
    FW_TRY(fw_leftovers_find(&leftovers, directory, scenario, overwrite, error));
    fw_status status = fw_sweep_begin(&sweep, scenario, &options, error);
    if (status == FW_OK) {
        status = fw_leftovers_remove(leftovers, error);
        fw_sweep_destroy(sweep);
    }
    fw_leftovers_destroy(leftovers);
    return status;
}

/* Of a folder that was prepared, or run, before. */
static fw_status list_folder(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    const char *directory = arguments->words[0];
    if (arguments->settings.count > 0 || arguments->overwrite || arguments->seed >= 0)
        return fw_fail(
            error, FW_BAD_INPUT,
            "%s holds a sweep, whose cases are listed as they are: expected --list alone",
            directory);
    FW_TRY(fw_sweep_load(&scenario, directory, error));
    print_cases(scenario, directory);
    fw_scenario_destroy(scenario);
    return FW_OK;
}

static fw_status list_cases(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1], standard[FW_NAME_BYTES + 16];
    if (!arguments->output && fw_sweep_is_in(arguments->words[0]))
        return list_folder(arguments, error);
    FW_TRY(fw_command_load(&scenario, arguments->words[0], arguments, name, error));
    snprintf(standard, sizeof standard, "results/%s", name);
    const char *directory = arguments->output ? arguments->output : standard;
    fw_status status = FW_OK;
    if (!fw_scenario_is_sweep(scenario))
        status =
            fw_fail(error, FW_BAD_INPUT, "%s has no study.sweep whose cases could be listed", name);
    if (status == FW_OK) status = prepare(scenario, directory, name, arguments->overwrite, error);
    if (status == FW_OK) print_cases(scenario, directory);
    fw_scenario_destroy(scenario);
    return status;
}

/* A worker has one processor, unless it is told of more: there are others beside it. */
static fw_status run_case(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0], *name = arguments->one_case;
    char label[128];
    fw_scenario *scenario;
    bool taken;
    if (!fw_sweep_is_in(directory))
        return fw_fail(error, FW_BAD_INPUT,
                       "%s holds no sweep, expected a folder that `fretwork sweep NAME -o DIR "
                       "--list` has made",
                       directory);
    FW_TRY(fw_sweep_load(&scenario, directory, error));
    snprintf(label, sizeof label, "%.120s", name);
    fw_progress progress = fw_progress_begin(arguments->quiet ? NULL : stderr, label);
    const fw_run_options options = {.directory = directory,
                                    .threads = fw_command_threads(arguments),
                                    .at_once = fw_command_threads(arguments),
                                    .name = name,
                                    .progress = &progress,
                                    .warnings = stderr};
    fw_interrupt_watch();
    const fw_status status = fw_sweep_run_case(scenario, name, &options, &taken, error);
    if (status == FW_OK) printf("%s: %s\n", name, taken ? "another worker has it" : "finished");
    if (status == FW_DIVERGED) fw_fail_within(error, "case %s", name);
    fw_scenario_destroy(scenario);
    return status;
}

fw_status fw_command_sweep(const fw_arguments *arguments, fw_error *error)
{
    if (arguments->list && arguments->one_case)
        return fw_fail(error, FW_BAD_INPUT, "both --list and --case, expected one of them");
    if (arguments->list) return list_cases(arguments, error);
    if (!arguments->one_case)
        return fw_fail(error, FW_BAD_INPUT,
                       "expected --list or --case; `fretwork run` runs all cases here");
    const char *const misplaced = arguments->output               ? "-o"
                                  : arguments->overwrite          ? "--overwrite"
                                  : arguments->settings.count > 0 ? "--set"
                                  : arguments->seed >= 0          ? "--seed"
                                                                  : NULL;
    if (misplaced)
        return fw_fail(error, FW_BAD_INPUT,
                       "--case runs what lies in the folder: %s belongs to --list", misplaced);
    return run_case(arguments, error);
}

fw_status fw_command_collect(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    const fw_run_options options = {
        .directory = directory, .threads = 1, .name = directory, .warnings = stderr};
    fw_scenario *scenario;
    fw_sweep *sweep;
    if (!fw_sweep_is_in(directory))
        return fw_fail(error, FW_BAD_INPUT, "%s holds no sweep, whose cases could be collected",
                       directory);
    FW_TRY(fw_sweep_load(&scenario, directory, error));
    fw_status status = fw_leftovers_check(directory, scenario, error);
    if (status == FW_OK) status = fw_sweep_open(&sweep, scenario, &options, error);
    if (status == FW_OK) {
        status = fw_report_collected(sweep, scenario, directory, arguments->no_plot, error);
        fw_sweep_destroy(sweep);
    }
    fw_scenario_destroy(scenario);
    return status;
}
