/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scenario_short_memory.c - what a scenario is read into comes out of blocks of memory: each
 * piece of it is once the first of a block that is not there. The name of its file, which lies
 * before, shifts them all. */
#include "tests/support/short_memory.h"

#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/scenario.h"
#include "experiments/storage/checksum.h"

#include <stdlib.h>

/* A document's first block, by document.c. */
enum { BLOCK = 1 << 15, STEP = 112 };

typedef struct wanted_scenario {
    fw_catalogue_entry entry;
    size_t room; /* that the name of the file leaves in the first block */
} wanted_scenario;

/* What was read, and the first case of a sweep, as they are printed. */
static fw_status read_one(const void *input, uint64_t *result, fw_error *error)
{
    static char name[BLOCK];
    const wanted_scenario *wanted = input;
    const fw_catalogue_entry *entry = &wanted->entry;
    fw_scenario *scenario, *first = NULL;
    char *text;
    memset(name, 'f', sizeof name);
    name[sizeof name - 1 - wanted->room] = '\0';
    FW_TRY(fw_scenario_read(&scenario, name, entry->text, entry->length, NULL, 0, error));
    fw_status status = FW_OK;
    if (fw_scenario_is_sweep(scenario)) status = fw_scenario_read_case(&first, scenario, 0, error);
    if (status == FW_OK) status = fw_scenario_print(first ? first : scenario, &text, error);
    if (status == FW_OK) {
        *result = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, text, strlen(text));
        free(text);
    }
    fw_scenario_destroy(first);
    fw_scenario_destroy(scenario);
    return status;
}

static void every_piece_of_a_scenario_may_be_missing(void **state)
{
    (void)state;
    static const char *const names[] = {"friction-sweep", "saw-teeth",    "critical-pressure-map",
                                        "stick-slip",     "pistons-meet", "stability-map",
                                        "wave-diagonal",  "copper",       "fracture"};
    for (size_t n = 0; n < sizeof names / sizeof *names; ++n) {
        const fw_catalogue_entry *entry = fw_catalogue;
        int refused = 0;
        while (strcmp(entry->name, names[n]) != 0) ++entry;
        for (wanted_scenario wanted = {.entry = *entry}; wanted.room < BLOCK; wanted.room += STEP)
            refused += fail_each_place(names[n], read_one, &wanted);
        print_message("%s: %d\n", names[n], refused);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_piece_of_a_scenario_may_be_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
