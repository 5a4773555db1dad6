/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_verify.c - runs experiments without writing results, and judges them: as tables, and as
 * JSON where that is wanted. Keeps no state. Start reading at fw_command_verify(). */
#include "experiments/commands/command.h"
#include "experiments/results/provenance.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/storage/whole_file.h"
#include "experiments/study/progress.h"
#include "experiments/study/study.h"
#include "experiments/study/sweep.h"
#include "experiments/text/json.h"
#include "experiments/text/text.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct tally {
    int experiments, expectations, failures;
    FILE *table; /* NULL: none */
    fw_json json;
} tally;

static void write_verdict(fw_json *json, const fw_verdict *verdict)
{
    const fw_expectation *e = verdict->expectation;
    const bool bounds = e->kind == FW_VERDICT_BOUNDS, trend = fw_expectation_is_trend(e);
    double tolerance = e->kind == FW_VERDICT_RELATIVE ? e->within * fabs(e->value) : e->within;
    fw_json_begin(json, NULL, '{');
    if (verdict->in) fw_json_text(json, "case", verdict->in);
    fw_json_text(json, "quantity", verdict->quantity);
    fw_json_text(json, "expected", verdict->expected);
    fw_json_number(json, "value", bounds || trend ? NAN : e->value);
    fw_json_number(json, "tolerance", bounds || trend ? NAN : tolerance);
    fw_json_number(json, "above", bounds && e->has_above ? e->above : NAN);
    fw_json_number(json, "below", bounds && e->has_below ? e->below : NAN);
    fw_json_number(json, "measured", verdict->measured);
    if (isfinite(verdict->error)) {
        fw_json_number(json, "error", verdict->error);
        fw_json_flag(json, "error-is-lower-bound", verdict->at_least);
    }
    if (verdict->why[0]) fw_json_text(json, "no-number-since", verdict->why);
    if (verdict->seeds > 1) fw_json_integer(json, "seeds", verdict->seeds);
    fw_json_flag(json, "holds", verdict->holds);
    fw_json_text(json, "source", e->source);
    fw_json_text(json, "note", e->note);
    fw_json_end(json, '}');
}

/* `certificate` is NULL for a sweep, each case of which has its own. */
static void judge(tally *sum, const char *name, const fw_scenario *scenario,
                  const fw_verdicts *verdicts, const fw_certificate *certificate, double seconds)
{
    if (sum->table) {
        fprintf(sum->table, "%s: ", name);
        fw_text_print_line(sum->table, scenario->title);
        fprintf(sum->table, " (%.1f s)\n", seconds);
        fw_verdicts_print(sum->table, verdicts);
        if (certificate) fw_report_certificate(sum->table, certificate);
        fprintf(sum->table, "\n");
        fflush(sum->table);
    }
    fw_json *json = &sum->json;
    fw_json_begin(json, NULL, '{');
    fw_json_text(json, "experiment", name);
    fw_json_text(json, "title", scenario->title);
    fw_json_text(json, "source", scenario->source);
    fw_json_number(json, "seconds", seconds);
    if (certificate) fw_report_certificate_as_json(json, certificate);
    fw_json_begin(json, "expectations", '[');
    for (int n = 0; n < verdicts->count; ++n)
        if (verdicts->item[n].asked) write_verdict(json, &verdicts->item[n]);
    fw_json_end(json, ']');
    fw_json_end(json, '}');
    sum->failures += fw_verdicts_failed(verdicts);
    sum->expectations += fw_verdicts_asked(verdicts);
    sum->experiments += 1;
}

static fw_status verify_study(const fw_scenario *scenario, const fw_run_options *options,
                              tally *sum, fw_error *error)
{
    const double started = fw_progress_clock();
    fw_study *study;
    fw_verdicts verdicts = {0};
    FW_TRY(fw_study_begin(&study, scenario, options, error));
    fw_status status = fw_study_to_end(study, error);
    if (status == FW_OK)
        status = fw_verdicts_create(&verdicts, scenario, fw_study_measurement(study), error);
    if (status == FW_OK)
        judge(sum, options->name, scenario, &verdicts, fw_study_certificate(study),
              fw_progress_clock() - started);
    fw_verdicts_clear(&verdicts);
    fw_study_destroy(study);
    return status;
}

static fw_status verify_sweep(const fw_scenario *scenario, const fw_run_options *options,
                              tally *sum, fw_error *error)
{
    const double started = fw_progress_clock();
    fw_sweep *sweep;
    FW_TRY(fw_sweep_begin(&sweep, scenario, options, error));
    const fw_status status = fw_sweep_to_end(sweep, error);
    if (status == FW_OK)
        judge(sum, options->name, scenario, fw_sweep_verdicts(sweep), NULL,
              fw_progress_clock() - started);
    fw_sweep_destroy(sweep);
    return status;
}

static fw_status verify_one(const char *word, const fw_arguments *arguments, tally *sum,
                            fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    FW_TRY(fw_command_load(&scenario, word, arguments, name, error));
    if (arguments->word_count == 0 && scenario->small.text && !arguments->full) {
        if (sum->table)
            fprintf(sum->table, "%s: left to --full, %s stands for it\n\n", name,
                    scenario->small.text);
        fw_scenario_destroy(scenario);
        return FW_OK;
    }
    fw_progress progress = fw_progress_begin(arguments->quiet ? NULL : stderr, name);
    const fw_run_options options = {.threads = fw_command_threads(arguments),
                                    .at_once = (int)arguments->threads,
                                    .name = name,
                                    .progress = &progress};
    const fw_status status = fw_scenario_is_sweep(scenario)
                                 ? verify_sweep(scenario, &options, sum, error)
                                 : verify_study(scenario, &options, sum, error);
    if (status == FW_DIVERGED) fw_fail_within(error, "%s", name);
    fw_scenario_destroy(scenario);
    return status;
}

static fw_status verify_all(const fw_arguments *arguments, tally *sum, fw_error *error)
{
    fw_provenance now = fw_provenance_now();
    fw_json *json = &sum->json;
    fw_json_begin(json, NULL, '{');
    fw_json_text(json, "program", now.program);
    fw_json_text(json, "version", now.version);
    fw_json_text(json, "revision", now.revision);
    fw_json_begin(json, "experiments", '[');
    for (int n = 0; n < arguments->word_count; ++n)
        FW_TRY(verify_one(arguments->words[n], arguments, sum, error));
    for (const fw_catalogue_entry *entry = fw_catalogue; arguments->word_count == 0 && entry->name;
         ++entry)
        FW_TRY(verify_one(entry->name, arguments, sum, error));
    fw_json_end(json, ']');
    fw_json_integer(json, "expectations", sum->expectations);
    fw_json_integer(json, "failed", sum->failures);
    fw_json_end(json, '}');
    if (sum->table)
        fprintf(sum->table, "%d experiments, %d expectations, %d failed\n", sum->experiments,
                sum->expectations, sum->failures);
    return FW_OK;
}

fw_status fw_command_verify(const fw_arguments *arguments, fw_error *error)
{
    const bool to_stdout = arguments->json_file && strcmp(arguments->json_file, "-") == 0;
    char *text = NULL;
    size_t size = 0;
    /* Gathered in memory: a file appears whole, once everything was judged. */
    tally sum = {.table = to_stdout ? NULL : stdout, .json.out = open_memstream(&text, &size)};
    if (!sum.json.out) return fw_fail_memory(error, "the verdicts");
    fw_status status = verify_all(arguments, &sum, error);
    if (fclose(sum.json.out) != 0 && status == FW_OK)
        status = fw_fail_memory(error, "the verdicts");
    if (status == FW_OK && to_stdout)
        fwrite(text, 1, size, stdout);
    else if (status == FW_OK && arguments->json_file)
        status = fw_whole_file_write(arguments->json_file, text, size, error);
    free(text);
    if (status == FW_OK && sum.failures > 0) return FW_EXPECTATION_FAILED;
    return status;
}
