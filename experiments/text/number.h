/* SPDX-License-Identifier: GPL-3.0-or-later */
/* number.h - numbers as people write them, read exactly or refused.
 * The same whatever the locale; no hexadecimal, no nan, no infinity, nothing left over behind. */
#ifndef FW_NUMBER_H
#define FW_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum fw_number_fault {
    FW_NUMBER_FINE,
    FW_NUMBER_MALFORMED,  /* "2.5e", "1.0x", "0x10", "" */
    FW_NUMBER_NOT_FINITE, /* "nan", ".inf", "-infinity" */
    FW_NUMBER_TOO_LARGE,  /* beyond the range of double or int64_t */
    FW_NUMBER_TOO_SMALL,  /* digits other than 0, yet 0 as a double */
    FW_NUMBER_NOT_WHOLE   /* a number, but not written as a whole one: "1e6", "2.0", "007" */
} fw_number_fault;

/* 12, -0.5, .5, 2.5e-3: the nearest double. *value is unaltered on a fault. */
fw_number_fault fw_number_read(const char *text, size_t length, double *value);
/* 0, 12, -7: whole numbers, without point, exponent or leading zeros. */
fw_number_fault fw_integer_read(const char *text, size_t length, int64_t *value);

/* The number at the beginning of a text that the program has written itself, with nan and inf; 0
 * where there is none. *end, unless `end` is NULL, is what follows it. */
double fw_number_scan(const char *text, const char **end);

/* The shortest text that reads back to the same number; whole numbers without an exponent, so that
 * they read as whole ones. */
enum { FW_NUMBER_TEXT = 32 };
void fw_number_write(char text[FW_NUMBER_TEXT], double value);

#endif
