/* SPDX-License-Identifier: GPL-3.0-or-later */
/* terminal.h - what lies behind a stream that somebody may be looking at. */
#ifndef FW_TERMINAL_H
#define FW_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

bool fw_terminal_is(FILE *out);
/* Columns of the terminal; 80 where it does not say. */
int fw_terminal_width(FILE *out);
/* May colours be used? Only on a terminal that has them, and never where NO_COLOR is set and not
 * empty (no-color.org). */
bool fw_terminal_colours(FILE *out);

#endif
