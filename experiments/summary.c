/* SPDX-License-Identifier: GPL-3.0-or-later */
/* summary.c - verdicts over seeds as comma-separated values. Keeps no state. */
#include "experiments/summary.h"

#include "experiments/verdict.h"
#include "experiments/whole_file.h"

#include <stdlib.h>

/* Names and expected values hold commas: they go in quotes, and hold none themselves. */
static void write_row(FILE *out, const fw_scenario *scenario, const fw_measurement *measurement,
                      int number)
{
    const fw_verdict verdict = fw_verdict_of(scenario, measurement, number);
    fprintf(out, "\"%s\",\"%s\",%.17g,%.17g,%s", verdict.quantity, verdict.expected,
            verdict.measured, verdict.error, verdict.holds ? "holds" : "FAILS");
    for (int n = 0; n < measurement->seed_count; ++n)
        fprintf(out, ",%.17g", fw_verdict_of_seed(scenario, measurement, number, n));
    fputc('\n', out);
}

fw_status fw_summary_write(const char *path, const fw_scenario *scenario,
                           const fw_measurement *measurement, fw_error *error)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) return fw_fail_memory(error, "a summary");
    fputs("quantity,expected,mean,standard error,verdict", out);
    for (int n = 0; n < measurement->seed_count; ++n)
        fprintf(out, ",seed %lld", (long long)scenario->run.seed + n);
    fputc('\n', out);
    for (int n = 0; n < scenario->expectation_count; ++n)
        if (measurement->expected[n] >= 0) write_row(out, scenario, measurement, n);
    fw_status status = fclose(out) == 0 ? FW_OK : fw_fail_memory(error, "a summary");
    if (status == FW_OK) status = fw_whole_file_write(path, text, size, error);
    free(text);
    return status;
}
