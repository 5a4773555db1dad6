/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spelling.h - which word somebody meant. */
#ifndef FW_SPELLING_H
#define FW_SPELLING_H

#include "experiments/text/document.h"

/* The best of the candidates that were offered so far. */
typedef struct fw_suggestion {
    const char *word; /* as written */
    const char *best; /* NULL: none is close */
    int distance;
} fw_suggestion;

static inline fw_suggestion fw_suggestion_begin(const char *word)
{
    return (fw_suggestion){word, NULL, 0};
}

/* Takes the candidate if it is closer than all before; observes it. Close means: letters wrong,
 * missing, too many or swapped with their neighbour, at most one in three; upper and lower case
 * and '_' for '-' do not count. */
void fw_suggestion_offer(fw_suggestion *suggestion, const char *candidate);

/* How many such mistakes lie between two words; FW_NAME_BYTES where one is too long to compare. */
int fw_spelling_distance(const char *a, const char *b);

#endif
