/* SPDX-License-Identifier: GPL-3.0-or-later */
/* number.c - grammar first, value second: strtod only ever gets what the grammar accepts.
 * Keeps no state. */
#include "experiments/text/number.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* No number anybody means is longer; strtod takes time for longer ones. */
enum { LONGEST = 128 };

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static size_t count_digits(const char *text, size_t length)
{
    size_t count = 0;
    while (count < length && is_digit(text[count])) ++count;
    return count;
}

static bool is_not_finite(const char *text, size_t length)
{
    static const char *const words[] = {"nan", "inf", "infinity", ".nan", ".inf", NULL};
    size_t sign = length && (text[0] == '+' || text[0] == '-');
    for (const char *const *word = words; *word; ++word)
        if (strlen(*word) == length - sign && !strncasecmp(text + sign, *word, length - sign))
            return true;
    return false;
}

/* sign? (digits+ (. digits*)? | . digits+) (e sign? digits+)? */
static bool is_decimal(const char *text, size_t length)
{
    size_t at = length && (text[0] == '+' || text[0] == '-');
    size_t whole = count_digits(text + at, length - at);
    at += whole;
    size_t fraction = 0;
    if (at < length && text[at] == '.') {
        fraction = count_digits(text + at + 1, length - at - 1);
        at += 1 + fraction;
    }
    if (whole + fraction == 0) return false;
    if (at < length && (text[at] == 'e' || text[at] == 'E')) {
        at += 1;
        if (at < length && (text[at] == '+' || text[at] == '-')) at += 1;
        size_t exponent = count_digits(text + at, length - at);
        if (exponent == 0) return false;
        at += exponent;
    }
    return at == length;
}

static bool has_nonzero_digit(const char *text)
{
    for (; *text && *text != 'e' && *text != 'E'; ++text)
        if (*text >= '1' && *text <= '9') return true;
    return false;
}

double fw_number_scan(const char *text, const char **end)
{
    /* strtod follows the thread's locale, in which 0.5 may read as 0. */
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    locale_t before = plain ? uselocale(plain) : (locale_t)0;
    char *behind;
    const double value = strtod(text, &behind);
    if (plain) {
        uselocale(before);
        freelocale(plain);
    }
    if (end) *end = behind;
    return value;
}

fw_number_fault fw_number_read(const char *text, size_t length, double *value)
{
    if (is_not_finite(text, length)) return FW_NUMBER_NOT_FINITE;
    if (length >= LONGEST || !is_decimal(text, length)) return FW_NUMBER_MALFORMED;
    char copy[LONGEST];
    memcpy(copy, text, length);
    copy[length] = '\0';
    const double read = fw_number_scan(copy, NULL);
    if (!isfinite(read)) return FW_NUMBER_TOO_LARGE;
    if (read == 0 && has_nonzero_digit(copy)) return FW_NUMBER_TOO_SMALL;
    *value = read;
    return FW_NUMBER_FINE;
}

fw_number_fault fw_integer_read(const char *text, size_t length, int64_t *value)
{
    size_t sign = length && (text[0] == '+' || text[0] == '-');
    size_t digits = count_digits(text + sign, length - sign);
    if (digits == 0 || sign + digits != length) {
        double number;
        fw_number_fault fault = fw_number_read(text, length, &number);
        return fault == FW_NUMBER_FINE ? FW_NUMBER_NOT_WHOLE : fault;
    }
    if (digits > 1 && text[sign] == '0') return FW_NUMBER_NOT_WHOLE;
    bool negative = text[0] == '-';
    int64_t read = 0; /* kept negative: its range is the wider one */
    for (size_t n = sign; n < length; ++n)
        if (__builtin_mul_overflow(read, 10, &read) ||
            __builtin_sub_overflow(read, text[n] - '0', &read))
            return FW_NUMBER_TOO_LARGE;
    if (!negative && __builtin_sub_overflow((int64_t)0, read, &read)) return FW_NUMBER_TOO_LARGE;
    *value = read;
    return FW_NUMBER_FINE;
}

void fw_number_write(char text[FW_NUMBER_TEXT], double value)
{
    if (value == trunc(value) && fabs(value) < 1e15) {
        snprintf(text, FW_NUMBER_TEXT, "%.0f", value == 0 ? 0 : value);
        return;
    }
    for (int digits = 1; digits <= 17; ++digits) {
        snprintf(text, FW_NUMBER_TEXT, "%.*g", digits, value);
        if (fw_number_scan(text, NULL) == value) return;
    }
}
