/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz_scenario.c - whatever bytes a scenario file holds, reading it ends at once, with a scenario
 * or with one sentence. What follows a zero byte is taken as a --set option, up to the next one.
 * Built with -DFRETWORK_FUZZ=ON, see CMakeLists.txt. */
#include "experiments/scenario/scenario.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void demand(int holds)
{
    if (!holds) abort();
}

static void check_sentence(fw_status status, const fw_error *error)
{
    demand(status == FW_BAD_INPUT || status == FW_SYSTEM_FAILED);
    demand(error->status == status);
    demand(!strpbrk(error->sentence, "\n\r\t"));
    demand(status != FW_BAD_INPUT || !strncmp(error->sentence, "fuzz.yaml:", 10) ||
           !strncmp(error->sentence, "--set ", 6));
}

/* What was read must also be printed, and read again as the same. */
static void check_scenario(const fw_scenario *scenario)
{
    char *text, *text_again;
    fw_error error;
    demand(fw_scenario_print(scenario, &text, &error) == FW_OK);
    fw_scenario *again;
    demand(fw_scenario_read(&again, "again", text, strlen(text), NULL, 0, &error) == FW_OK);
    demand(fw_scenario_print(again, &text_again, &error) == FW_OK);
    demand(!strcmp(text, text_again));
    for (int n = 0; n < scenario->body_count; ++n)
        demand(scenario->bodies[n].shape.count == again->bodies[n].shape.count);
    fw_scenario_destroy(again);
    free(text);
    free(text_again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { SETTINGS_MAX = 4 };
    char *copy = malloc(size + 1);
    demand(copy != NULL);
    if (size) memcpy(copy, data, size);
    copy[size] = '\0';
    size_t length = strlen(copy);
    const char *settings[SETTINGS_MAX];
    int count = 0;
    for (size_t at = length + 1; at < size && count < SETTINGS_MAX; at += strlen(copy + at) + 1)
        settings[count++] = copy + at;
    fw_scenario *scenario;
    fw_error error;
    fw_status status =
        fw_scenario_read(&scenario, "fuzz.yaml", copy, length, settings, count, &error);
    if (status == FW_OK)
        check_scenario(scenario);
    else
        check_sentence(status, &error);
    fw_scenario_destroy(scenario);
    free(copy);
    return 0;
}
