/* SPDX-License-Identifier: GPL-3.0-or-later */
/* summary.c - verdicts over seeds as comma-separated values. Keeps no state. */
#include "summary.h"

#include "experiments/storage/csv.h"

#include <errno.h>
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
    fprintf(out, ",%s", !verdict.asked ? "not asked" : verdict.holds ? "holds" : "FAILS");
    for (int n = 0; n < s->scenario->study.seeds; ++n) {
        fputc(',', out);
        fw_csv_write_number(out, fw_verdict_of_seed(s->scenario, s->measurement, number, n));
    }
    fputc('\n', out);
}

static void write(FILE *out, const void *object)
{
    const summary *s = object;
    fputs("quantity,expected,mean,standard error,verdict", out);
    for (int n = 0; n < s->scenario->study.seeds; ++n)
        fprintf(out, ",seed %lld", (long long)(s->scenario->run.seed + n));
    fputc('\n', out);
    for (int n = 0; n < s->scenario->expectation_count; ++n) write_row(out, s, n);
}

fw_status fw_summary_write(const char *path, const fw_scenario *scenario,
                           const fw_measurement *measurement, fw_error *error)
{
    return fw_csv_save(path, write, &(summary){scenario, measurement}, error);
}

/* --- read again --- */

static bool read_row(char *line, fw_verdict *verdict)
{
    char *cell[4];
    for (int n = 0; n < 4; ++n) {
        if (!line) return false;
        line = fw_csv_cut(line, &cell[n]);
    }
    snprintf(verdict->quantity, sizeof verdict->quantity, "%s", cell[0]);
    verdict->measured = strtod(cell[2], NULL);
    verdict->error = strtod(cell[3], NULL);
    return true;
}

static fw_status read_rows(FILE *in, const char *path, const fw_scenario *scenario,
                           fw_verdicts *verdicts, fw_error *error)
{
    char *line = NULL;
    size_t size = 0;
    bool whole = getline(&line, &size, in) > 0;
    for (int n = 0; n < scenario->expectation_count && whole; ++n) {
        const fw_expectation *e = &scenario->expectations[n];
        fw_verdict *verdict = &verdicts->item[verdicts->count++];
        *verdict = (fw_verdict){.expectation = e,
                                .seeds = (int)scenario->study.seeds,
                                .asked = fw_verdict_is_asked(scenario, e)};
        whole = getline(&line, &size, in) > 0 && read_row(line, verdict);
        if (whole) fw_verdict_judge(verdict);
    }
    free(line);
    if (whole) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s does not hold the %d rows of what was expected", path,
                   scenario->expectation_count);
}

fw_status fw_summary_read(const char *path, const fw_scenario *scenario, fw_verdicts *verdicts,
                          fw_error *error)
{
    *verdicts = (fw_verdicts){0};
    FILE *in = fopen(path, "r");
    if (!in) return fw_fail(error, FW_BAD_INPUT, "%s: cannot be opened: %s", path, strerror(errno));
    verdicts->item = calloc((size_t)scenario->expectation_count + 1, sizeof *verdicts->item);
    fw_status status = verdicts->item ? read_rows(in, path, scenario, verdicts, error)
                                      : fw_fail_memory(error, path);
    fclose(in);
    if (status != FW_OK) fw_verdicts_clear(verdicts);
    return status;
}
