/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ticks.h - round numbers along an axis, and numbers in print. */
#ifndef FW_TICKS_H
#define FW_TICKS_H

#include "experiments/text/range.h"

/* Round numbers inside a range. */
enum { FW_TICKS_MAX = 32, FW_TICKS_MINOR_MAX = 200, FW_TICK_LABEL_SIZE = 40 };
typedef struct fw_ticks {
    int count;
    double at[FW_TICKS_MAX];
    char label[FW_TICKS_MAX][FW_TICK_LABEL_SIZE]; /* text for fw_canvas_text */
    int minor_count;
    double minor[FW_TICKS_MINOR_MAX];
    /* What the numbers are to be multiplied by and added to, "x10^{-14} + 1"; "" for nothing. */
    char note[64];
} fw_ticks;

/* At most about `wanted` labelled ticks (at least two where the range allows). */
void fw_ticks_find(fw_ticks *ticks, fw_range range, bool logarithmic, int wanted);

/* A number as one would print it, with `digits` significant digits: true minus sign, thin spaces
 * between thousands, powers of ten raised (as markup of fw_canvas_text). */
void fw_ticks_print_number(char *text, int size, double value, int digits);

#endif
