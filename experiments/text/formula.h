/* SPDX-License-Identifier: GPL-3.0-or-later */
/* formula.h - formulas of named numbers, as 24*A or sqrt(k/m): operators + - * / ^, comparisons and
 * c ? a : b, and functions such as sqrt, exp, ln, log10, sin, atan2, abs, min, max, rint; pi. */
#ifndef FW_FORMULA_H
#define FW_FORMULA_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct fw_variable {
    const char *name; /* a letter, then letters, digits and '_' */
    double value;
} fw_variable;

/* Can it be the name of a variable? FW_BAD_INPUT: it is none, or that of a function or constant. */
fw_status fw_formula_check_name(const char *name, fw_error *error);

/* Which variable the first name in `text` is that is one, behind `from`: its number, or -1.
 * *end goes behind the name. Letters of numbers, as in 1e3, are no names. */
int fw_formula_find(const char *text, size_t length, size_t from, const fw_variable *variables,
                    int count, size_t *end);

/* Value of the formula. FW_BAD_INPUT with what is wrong with it, also where the value is not
 * finite. */
fw_status fw_formula_evaluate(const char *text, size_t length, const fw_variable *variables,
                              int count, double *value, fw_error *error);

#endif
