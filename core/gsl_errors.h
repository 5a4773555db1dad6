/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gsl_errors.h - what fails in GSL is told to who called it. GSL itself calls a handler that ends
 * the process, unless the program around has set another. Every call of GSL stands between these
 * two; pairs may overlap in several threads. When the last one ends, the handler is as before. */
#ifndef FW_GSL_ERRORS_H
#define FW_GSL_ERRORS_H

void fw_gsl_errors_catch(void);
void fw_gsl_errors_release(void);

#endif
