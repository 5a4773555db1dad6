/* SPDX-License-Identifier: GPL-3.0-or-later */
/* markup.h - raised and lowered letters in a line of text: "10^{-3}", "c_{1}". */
#ifndef FW_MARKUP_H
#define FW_MARKUP_H

/* Takes characters of equal height from the beginning of *text into `run`, which may stay empty;
 * *text then points behind them, at the terminating zero when all is done. *level, 0 at first, is
 * that of the run: 1 raised, -1 lowered. Bytes that are no UTF-8 become '?', control characters
 * blanks. */
enum { FW_MARKUP_RUN = 512 };
void fw_markup_take(const char **text, int *level, char run[FW_MARKUP_RUN]);

#endif
