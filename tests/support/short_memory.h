/* SPDX-License-Identifier: GPL-3.0-or-later */
/* short_memory.h - lets one allocation fail, then the next one, until all is given: tests named
 * *_short_memory are linked so that what they and the program's libraries ask for comes through
 * short_memory.c. */
#ifndef FW_SHORT_MEMORY_H
#define FW_SHORT_MEMORY_H

#include "core/status.h"
#include "tests/support/laws.h"

#include <stdbool.h>
#include <string.h>

/* From now on the allocation number `which` fails, counted from 1; 0: none does. */
void short_memory_fail(long which);
/* Has it? */
bool short_memory_failed(void);
/* For what else a test lets fail, in the order of the allocations: does it fail here? */
bool short_memory_fails_here(void);
/* Pieces of memory that are there. */
long short_memory_pieces(void);

/* Makes something of `input`, releases it, and says in *result, as a number that everything in it
 * took part in, what it was. */
typedef fw_status attempt_function(const void *input, uint64_t *result, fw_error *error);

/* Lets every allocation of the attempt fail once. It then says that memory is missing, or comes to
 * the same result, and leaves nothing behind. Returns how many of them were refused. */
static inline int fail_each_allocation(const char *name, attempt_function *attempt,
                                       const void *input)
{
    static fw_error error;
    uint64_t expected, result = 0;
    error = (fw_error){0};
    if (attempt(input, &expected, &error) != FW_OK) fail_msg("%s: %s", name, error.sentence);
    int refused = 0, given = 0;
    for (long which = 1;; ++which) {
        const long before = short_memory_pieces();
        error = (fw_error){0};
        short_memory_fail(which);
        const fw_status status = attempt(input, &result, &error);
        const bool failed = short_memory_failed();
        short_memory_fail(0);
        if (short_memory_pieces() != before)
            fail_msg("%s, allocation %ld: %ld pieces of memory are left behind", name, which,
                     short_memory_pieces() - before);
        if (status != FW_OK && (!failed || status != FW_SYSTEM_FAILED || error.status != status ||
                                !strstr(error.sentence, "not enough memory ")))
            fail_msg("%s, allocation %ld: status %d: %s", name, which, (int)status, error.sentence);
        if (status == FW_OK && result != expected)
            fail_msg("%s, allocation %ld: goes on to another result", name, which);
        if (!failed) break;
        refused += status != FW_OK;
        given += status == FW_OK;
    }
    print_message("%s: %d allocations refused, %d done without\n", name, refused, given);
    return refused;
}

#endif
