/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_facts.c - what a run was asked for, what came out, and where it comes from. Keeps no
 * state. */
#include "core/array.h"
#include "experiments/measures/certificate.h"
#include "experiments/measures/column.h"
#include "experiments/study/summary.h"
#include "report_parts.h"

#include <stdlib.h>
#include <string.h>

/* More points of a curve than a screen has. */
enum { SAMPLES_MAX = 3000 };

static void write_texts(fw_json *json, const fw_plot_result *result)
{
    const fw_scenario *scenario = result->scenario;
    const fw_playback *playback = result->playback;
    fw_json_text(json, "title", scenario->title);
    if (scenario->about) fw_json_text(json, "about", scenario->about);
    if (scenario->source) fw_json_text(json, "source", scenario->source);
    fw_json_text(json, "scenario", playback->scenario);
    fw_json_text(json, "ended", playback->exit_reason);
    fw_json_text(json, "warnings", playback->warnings);
    fw_json_integer(json, "seed", (int64_t)playback->seed);
    fw_json_integer(json, "seeds", scenario->study.seeds);
}

static void write_provenance(fw_json *json, fw_playback *playback)
{
    static const char *const names[] = {"start", "end",          "version", "revision",  "compiler",
                                        "flags", "instructions", "forms",   "libraries", "host"};
    fw_json_begin(json, "provenance", '{');
    for (size_t n = 0; n < sizeof names / sizeof *names; ++n) {
        char *text = fw_playback_fact(playback, names[n]);
        if (text) fw_json_text(json, names[n], text);
        free(text);
    }
    fw_json_end(json, '}');
}

static fw_status write_verdicts(fw_json *json, const fw_plot_result *result, fw_error *error)
{
    fw_verdicts verdicts = {0};
    if (result->scenario->expectation_count == 0) return FW_OK;
    FW_TRY(fw_summary_read(result->directory, result->scenario, &verdicts, error));
    fw_json_begin(json, "verdicts", '[');
    for (int n = 0; n < verdicts.count; ++n) {
        const fw_verdict *verdict = &verdicts.item[n];
        if (!verdict->asked) continue;
        fw_json_begin(json, NULL, '{');
        fw_json_text(json, "quantity", verdict->quantity);
        fw_json_text(json, "expected", verdict->expected);
        fw_json_text(json, "measured", verdict->found);
        fw_json_text(json, "verdict", fw_verdict_word(verdict));
        if (verdict->expectation->source)
            fw_json_text(json, "source", verdict->expectation->source);
        fw_json_end(json, '}');
    }
    fw_json_end(json, ']');
    fw_verdicts_clear(&verdicts);
    return FW_OK;
}

static fw_status write_certificate(fw_json *json, fw_playback *playback, fw_error *error)
{
    fw_certificate certificate;
    char line[FW_CERTIFICATE_SIZE];
    FW_TRY(fw_certificate_read(&certificate, playback, error));
    fw_certificate_print(&certificate, line);
    fw_json_text(json, "certificate", line);
    return FW_OK;
}

/* --- what was measured --- */

static fw_status write_curve(fw_json *json, fw_playback *playback, const fw_column *column,
                             const fw_units *units, int64_t every, int64_t rows, float *shown,
                             double *values, fw_error *error)
{
    const fw_playback_observable *of = &playback->observables[column->observable];
    char name[FW_COLUMN_NAME];
    const fw_physical unit = fw_units_physical(units, of->unit);
    const double factor = unit.factor > 0 ? unit.factor : 1;
    FW_TRY(fw_playback_read_observable(playback, column->observable, values, error));
    for (int64_t n = 0; n < rows; ++n)
        shown[n] = (float)(factor * values[n * every * of->components + column->component]);
    fw_column_name(playback, column, name);
    fw_json_begin(json, NULL, '{');
    fw_json_text(json, "name", name);
    fw_json_text(json, "unit", unit.factor > 0 ? unit.text : of->unit);
    fw_json_text(json, "meaning", of->meaning);
    const fw_status status =
        fw_report_bytes(json, "values", shown, (size_t)rows * sizeof *shown, error);
    fw_json_end(json, '}');
    return status;
}

static fw_status write_curves(fw_json *json, const fw_plot_result *result, fw_error *error)
{
    fw_playback *playback = result->playback;
    const int64_t samples = playback->sample_count;
    const int64_t every = 1 + (samples - 1) / SAMPLES_MAX, rows = (samples + every - 1) / every;
    fw_column *columns = NULL;
    int count = 0, widest = 1;
    for (int o = 0; o < playback->observable_count; ++o)
        widest = playback->observables[o].components > widest ? playback->observables[o].components
                                                              : widest;
    FW_TRY(fw_columns_find(playback, result->directory, NULL, 0, &columns, &count, error));
    int64_t *steps = fw_array_allocate((size_t)samples + 1, sizeof *steps);
    float *shown = fw_array_allocate((size_t)rows + 1, sizeof *shown);
    double *values = fw_array_of_doubles((size_t)(samples * widest) + 1);
    fw_status status =
        steps && shown && values ? FW_OK : fw_fail_memory(error, "the curves of a report");
    if (status == FW_OK) status = fw_playback_read_sample_times(playback, steps, NULL, error);
    if (status == FW_OK) {
        fw_json_begin(json, "sampled", '[');
        for (int64_t n = 0; n < rows; ++n) fw_json_integer(json, NULL, steps[n * every]);
        fw_json_end(json, ']');
        fw_json_begin(json, "curves", '[');
        for (int c = 0; c < count && status == FW_OK; ++c)
            status = write_curve(json, playback, &columns[c], &result->scenario->units, every, rows,
                                 shown, values, error);
        fw_json_end(json, ']');
    }
    free(steps);
    free(shown);
    free(values);
    free(columns);
    return status;
}

static fw_status write_citation(fw_json *json, const fw_scenario *scenario,
                                void (*cite)(FILE *out, const fw_scenario *scenario),
                                fw_error *error)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    if (memory) cite(memory, scenario);
    if (!memory || fclose(memory) != 0) {
        free(text);
        return fw_fail_memory(error, "what to cite");
    }
    fw_json_text(json, "bibtex", text);
    free(text);
    return FW_OK;
}

fw_status fw_report_facts(fw_json *json, const fw_plot_result *result,
                          void (*cite)(FILE *out, const fw_scenario *scenario), fw_error *error)
{
    write_texts(json, result);
    write_provenance(json, result->playback);
    FW_TRY(write_verdicts(json, result, error));
    FW_TRY(write_certificate(json, result->playback, error));
    FW_TRY(write_citation(json, result->scenario, cite, error));
    return write_curves(json, result, error);
}
