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
/* From now on nothing fails; which allocations are the first of their place (place.h), that was not
 * listed before, is listed. */
void short_memory_list(void);
/* Their numbers, rising. Returns how many; from now on nothing is listed. */
long short_memory_listed(const long **numbers);
/* Pieces of memory that are there. */
long short_memory_pieces(void);

/* Makes something of `input`, releases it, and says in *result, as a number that everything in it
 * took part in, what it was. */
typedef fw_status attempt_function(const void *input, uint64_t *result, fw_error *error);

/* Lets the allocation number `which` of the attempt fail. It then says that memory is missing, or
 * comes to the same result, and leaves nothing behind. Returns whether it got so far. */
static inline bool fail_allocation(const char *name, attempt_function *attempt, const void *input,
                                   long which, uint64_t expected, int *refused, int *given)
{
    static fw_error error;
    uint64_t result = 0;
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
    *refused += status != FW_OK;
    *given += status == FW_OK && failed;
    return failed;
}

static inline uint64_t attempt_whole(const char *name, attempt_function *attempt, const void *input)
{
    static fw_error error;
    uint64_t result = 0;
    error = (fw_error){0};
    if (attempt(input, &result, &error) != FW_OK) fail_msg("%s: %s", name, error.sentence);
    return result;
}

/* Lets every allocation of the attempt fail once. Returns how many of them were refused. */
static inline int fail_each_allocation(const char *name, attempt_function *attempt,
                                       const void *input)
{
    int refused = 0, given = 0;
    const uint64_t expected = attempt_whole(name, attempt, input);
    for (long which = 1;; ++which)
        if (!fail_allocation(name, attempt, input, which, expected, &refused, &given)) break;
    print_message("%s: %d allocations refused, %d done without\n", name, refused, given);
    return refused;
}

/* The same with the first allocation at each place that no earlier attempt came to: of long
 * attempts that always do the same. */
static inline int fail_each_place(const char *name, attempt_function *attempt, const void *input)
{
    int refused = 0, given = 0;
    const long *numbers;
    const uint64_t expected = attempt_whole(name, attempt, input);
    short_memory_list();
    attempt_whole(name, attempt, input);
    const long count = short_memory_listed(&numbers);
    for (long n = 0; n < count; ++n)
        if (!fail_allocation(name, attempt, input, numbers[n], expected, &refused, &given))
            fail_msg("%s: allocation %ld is not asked for again", name, numbers[n]);
    print_message("%s: %d places refused, %d done without\n", name, refused, given);
    return refused;
}

#endif
