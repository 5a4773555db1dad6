/* SPDX-License-Identifier: GPL-3.0-or-later */
/* substitution.h - a change of a scenario with formulas in it, and numbers in their place. */
#ifndef FW_SUBSTITUTION_H
#define FW_SUBSTITUTION_H

#include "experiments/text/formula.h"

/* KEY=VALUE again, with a number for every formula in VALUE: a part that names one of the
 * variables. Parts end at commas, brackets, braces and quotes outside of parentheses; one with a
 * colon and a blank behind it is a key, and is left alone. used[n], which may be NULL, becomes true
 * where variable n is named. *out is malloc'ed, NULL on failure: FW_BAD_INPUT with what is wrong
 * with a formula. */
fw_status fw_substitution_write(const char *setting, const fw_variable *variables, int count,
                                char **out, bool *used, fw_error *error);

#endif
