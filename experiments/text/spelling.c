/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spelling.c - the distance of Damerau and Levenshtein (optimal string alignment) between short
 * words. Keeps no state. */
#include "experiments/text/spelling.h"

#include <string.h>

static char fold(char c)
{
    if (c >= 'A' && c <= 'Z') return (char)(c - 'A' + 'a');
    return c == '_' || c == ' ' ? '-' : c;
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

int fw_spelling_distance(const char *a, const char *b)
{
    size_t rows = strlen(a), columns = strlen(b);
    if (rows >= FW_NAME_BYTES || columns >= FW_NAME_BYTES) return FW_NAME_BYTES;
    int table[3][FW_NAME_BYTES + 1];
    int *before = table[0], *above = table[1], *row = table[2];
    for (size_t j = 0; j <= columns; ++j) above[j] = (int)j;
    for (size_t i = 1; i <= rows; ++i) {
        row[0] = (int)i;
        for (size_t j = 1; j <= columns; ++j) {
            char x = fold(a[i - 1]), y = fold(b[j - 1]);
            int best = least(above[j] + 1, row[j - 1] + 1);
            best = least(best, above[j - 1] + (x != y));
            if (i > 1 && j > 1 && x == fold(b[j - 2]) && fold(a[i - 2]) == y)
                best = least(best, before[j - 2] + 1);
            row[j] = best;
        }
        int *spare = before;
        before = above;
        above = row;
        row = spare;
    }
    return above[columns];
}

void fw_suggestion_offer(fw_suggestion *suggestion, const char *candidate)
{
    int distance = fw_spelling_distance(suggestion->word, candidate);
    size_t length = strlen(candidate);
    int allowed = (int)(length + 2) / 3;
    if ((size_t)distance >= length || distance > allowed) return;
    if (suggestion->best && suggestion->distance <= distance) return;
    suggestion->best = candidate;
    suggestion->distance = distance;
}
