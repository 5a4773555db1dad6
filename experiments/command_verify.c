/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_verify.c - runs experiments without writing results, and judges them. */
#include "experiments/catalogue.h"
#include "experiments/command.h"
#include "experiments/progress.h"
#include "experiments/run.h"
#include "experiments/verdict.h"

typedef struct tally {
    int experiments, expectations, failures;
} tally;

static fw_status verify_one(const char *word, const fw_arguments *arguments, tally *sum,
                            fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    FW_TRY(fw_command_load(&scenario, word, arguments, name, error));
    const fw_run_options options = {.threads = fw_command_threads(arguments),
                                    .name = name,
                                    .progress = arguments->quiet ? NULL : stderr};
    fw_run *run;
    double started = fw_progress_clock();
    fw_status status = fw_run_begin(&run, scenario, &options, error);
    if (status == FW_OK) {
        status = fw_run_to_end(run, error);
        if (status == FW_OK) {
            printf("%s: %s (%.1f s)\n", name, scenario->title, fw_progress_clock() - started);
            sum->failures += fw_verdict_print(stdout, scenario, fw_run_measurement(run));
            sum->expectations += scenario->expectation_count;
            sum->experiments += 1;
            printf("\n");
            fflush(stdout);
        }
        fw_run_destroy(run);
    }
    fw_scenario_destroy(scenario);
    return status;
}

fw_status fw_command_verify(const fw_arguments *arguments, fw_error *error)
{
    tally sum = {0};
    for (int n = 0; n < arguments->word_count; ++n)
        FW_TRY(verify_one(arguments->words[n], arguments, &sum, error));
    for (const fw_catalogue_entry *entry = fw_catalogue; arguments->word_count == 0 && entry->name;
         ++entry)
        FW_TRY(verify_one(entry->name, arguments, &sum, error));
    printf("%d experiments, %d expectations, %d failed\n", sum.experiments, sum.expectations,
           sum.failures);
    return sum.failures > 0 ? FW_EXPECTATION_FAILED : FW_OK;
}
