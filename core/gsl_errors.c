/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gsl_errors.c - the handler of GSL's errors, one for the whole process, while this program calls
 * GSL. State, of the process as the handler is: how many calls there are now, and the handler that
 * was there before the first. */
#include "core/gsl_errors.h"

#include <gsl/gsl_errno.h>

static int callers;
static gsl_error_handler_t *before;

void fw_gsl_errors_catch(void)
{
#pragma omp critical(gsl_errors)
    if (callers++ == 0) before = gsl_set_error_handler_off();
}

void fw_gsl_errors_release(void)
{
#pragma omp critical(gsl_errors)
    if (--callers == 0) gsl_set_error_handler(before);
}
