/* SPDX-License-Identifier: GPL-3.0-or-later */
/* label.c - a quantity and its unit. Keeps no state. */
#include "experiments/drawing/label.h"

#include <stdio.h>
#include <string.h>

/* "length^2/time" as "length^{2}/time". */
static void print_unit(char *text, size_t size, const char *unit)
{
    size_t used = 0;
    for (const char *c = unit; *c && used + 4 < size;) {
        const size_t power = *c == '^' ? strspn(c + 1, "-0123456789") : 0;
        if (power == 0) {
            text[used++] = *c++;
            continue;
        }
        const int length = snprintf(text + used, size - used, "^{%.*s}", (int)power, c + 1);
        used = (size_t)length < size - used ? used + (size_t)length : size - 1;
        c += 1 + power;
    }
    text[used] = '\0';
}

void fw_label_print(char *text, size_t size, const char *quantity, const char *unit)
{
    char raised[128];
    snprintf(text, size, "%s", quantity);
    for (char *c = text; *c; ++c)
        if (*c == '-') *c = ' ';
    if (!unit || unit[0] == '\0' || strcmp(unit, "1") == 0 || strcmp(unit, text) == 0) return;
    print_unit(raised, sizeof raised, unit);
    const size_t length = strlen(text);
    snprintf(text + length, size - length, " (%s)", raised);
}
