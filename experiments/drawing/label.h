/* SPDX-License-Identifier: GPL-3.0-or-later */
/* label.h - what stands beside an axis: a quantity and its unit, written in one way. */
#ifndef FW_LABEL_H
#define FW_LABEL_H

#include <stddef.h>

/* What stands there, and by what the values are multiplied to be the numbers shown. */
typedef struct fw_label {
    const char *text; /* with unit, "time (ps)"; NULL: none */
    double factor;    /* > 0; 0: as 1 */
} fw_label;

/* The values as they are shown. */
static inline double fw_label_shown(fw_label label, double value)
{
    return label.factor > 0 ? label.factor * value : value;
}

/* "mean square displacement (length^{2})": the quantity in words, '-' as a space, and its unit with
 * powers raised. No unit for a pure number (NULL, "" or "1"), nor where it is the quantity itself.
 */
void fw_label_print(char *text, size_t size, const char *quantity, const char *unit);

#endif
