/* SPDX-License-Identifier: GPL-3.0-or-later */
/* label.h - what stands beside an axis: a quantity and its unit, written in one way. */
#ifndef FW_LABEL_H
#define FW_LABEL_H

#include <stddef.h>

/* "mean square displacement (length^{2})": the quantity in words, '-' as a space, and its unit with
 * powers raised. No unit for a pure number (NULL, "" or "1"), nor where it is the quantity itself.
 */
void fw_label_print(char *text, size_t size, const char *quantity, const char *unit);

#endif
