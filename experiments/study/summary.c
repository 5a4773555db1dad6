/* SPDX-License-Identifier: GPL-3.0-or-later */
/* summary.c - verdicts over seeds as comma-separated values. Keeps no state. Start reading at
 * fw_summary_write(). */
#include "experiments/study/summary.h"

#include "experiments/storage/csv.h"
#include "experiments/storage/manifest.h"
#include "experiments/text/text.h"

#include <stdlib.h>
#include <string.h>

typedef struct summary {
    const fw_scenario *scenario;
    const fw_measurement *measurement;
} summary;

static void write_row(FILE *out, const summary *s, int number)
{
    const fw_verdict verdict = fw_verdict_of(s->scenario, s->measurement, number);
    fw_csv_write_text(out, verdict.quantity);
    fputc(',', out);
    fw_csv_write_text(out, verdict.expected);
    fputc(',', out);
    fw_csv_write_number(out, verdict.measured);
    fputc(',', out);
    fw_csv_write_number(out, verdict.error);
    fprintf(out, ",%s,%d,", !verdict.asked ? "not asked" : fw_verdict_word(&verdict),
            verdict.at_least);
    fw_csv_write_text(out, verdict.why);
    for (int n = 0; n < s->scenario->study.seeds; ++n) {
        fputc(',', out);
        fw_csv_write_number(out, fw_verdict_of_seed(s->scenario, s->measurement, number, n));
    }
    fputc('\n', out);
}

static void write(FILE *out, const void *object)
{
    const summary *s = object;
    fputs("quantity,expected,mean,standard error,verdict,error is lower bound,no number since",
          out);
    for (int n = 0; n < s->scenario->study.seeds; ++n)
        fprintf(out, ",seed %lld", (long long)(s->scenario->run.seed + n));
    fputc('\n', out);
    for (int n = 0; n < s->scenario->expectation_count; ++n) write_row(out, s, n);
}

fw_status fw_summary_write(const char *directory, const fw_scenario *scenario,
                           const fw_measurement *measurement, fw_error *error)
{
    return fw_csv_keep(directory, FW_SUMMARY_FILE, write, &(summary){scenario, measurement}, error);
}

/* --- read again --- */

/* Cells of a row before those of the seeds. */
enum { QUANTITY, EXPECTED, MEAN, ERROR, VERDICT, AT_LEAST, WHY, CELLS };

static bool read_row(char *line, fw_verdict *verdict)
{
    char *cell[CELLS];
    for (int n = 0; n < CELLS; ++n) {
        if (!line) return false;
        line = fw_csv_cut(line, &cell[n]);
    }
    snprintf(verdict->quantity, sizeof verdict->quantity, "%s", cell[QUANTITY]);
    verdict->measured = fw_csv_read_number(cell[MEAN]);
    verdict->error = fw_csv_read_number(cell[ERROR]);
    verdict->at_least = strcmp(cell[AT_LEAST], "1") == 0;
    snprintf(verdict->why, sizeof verdict->why, "%s", cell[WHY]);
    return true;
}

static bool read_rows(char *text, const fw_scenario *scenario, fw_verdicts *verdicts)
{
    bool whole = fw_text_line(&text) != NULL;
    for (int n = 0; n < scenario->expectation_count && whole; ++n) {
        const fw_expectation *e = &scenario->expectations[n];
        fw_verdict *verdict = &verdicts->item[verdicts->count++];
        *verdict = (fw_verdict){.expectation = e,
                                .seeds = (int)scenario->study.seeds,
                                .asked = fw_verdict_is_asked(scenario, e)};
        whole = read_row(fw_text_line(&text), verdict);
        if (whole) fw_verdict_judge(verdict);
    }
    return whole;
}

static fw_status refuse(const char *directory, const fw_scenario *scenario, fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT,
                   "%s/" FW_SUMMARY_FILE " does not hold the %d rows of what was expected",
                   directory, scenario->expectation_count);
}

static bool read_seeds(char *line, int count, double *values)
{
    char *cell;
    for (int n = 0; n < CELLS + count; ++n) {
        if (!line) return false;
        line = fw_csv_cut(line, &cell);
        if (n >= CELLS) values[n - CELLS] = fw_csv_read_number(cell);
    }
    return true;
}

fw_status fw_summary_read_seeds(const char *directory, const fw_scenario *scenario, double *values,
                                fw_error *error)
{
    const int seeds = (int)scenario->study.seeds;
    char *text, *rest;
    size_t size;
    FW_TRY(fw_manifest_read(&text, &size, directory, FW_SUMMARY_FILE, error));
    rest = text;
    bool whole = fw_text_line(&rest) != NULL;
    for (int n = 0; n < scenario->expectation_count && whole; ++n)
        whole = read_seeds(fw_text_line(&rest), seeds, values + n * seeds);
    free(text);
    return whole ? FW_OK : refuse(directory, scenario, error);
}

fw_status fw_summary_read(const char *directory, const fw_scenario *scenario, fw_verdicts *verdicts,
                          fw_error *error)
{
    char *text;
    size_t size;
    *verdicts = (fw_verdicts){0};
    FW_TRY(fw_manifest_read(&text, &size, directory, FW_SUMMARY_FILE, error));
    verdicts->item = calloc((size_t)scenario->expectation_count + 1, sizeof *verdicts->item);
    fw_status status = FW_OK;
    if (!verdicts->item)
        status = fw_fail_memory(error, "a summary");
    else if (!read_rows(text, scenario, verdicts))
        status = refuse(directory, scenario, error);
    free(text);
    if (status != FW_OK) fw_verdicts_clear(verdicts);
    return status;
}
