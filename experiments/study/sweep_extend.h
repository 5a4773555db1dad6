/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_extend.h - a sweep with further values, of which the cases that there are stay the same. */
#ifndef FW_SWEEP_EXTEND_H
#define FW_SWEEP_EXTEND_H

#include "experiments/scenario/scenario.h"

/* `additions`: "A=3.5", a further value of a parameter, which meets all values of the others; or of
 * a sweep with points "A=3.5,p=2", a further point. `settings` as --set has them, 500 at most.
 * FW_BAD_INPUT: a value that is there already, a parameter that is not, or settings that would make
 * an old case another one: these are named. */
fw_status fw_sweep_extend(fw_scenario **made, const fw_scenario *sweep, const char *directory,
                          const char *const *additions, int addition_count,
                          const char *const *settings, int setting_count, fw_error *error);

/* The sweep with further points[count][parameters], which differ from all it has. */
fw_status fw_sweep_add_points(fw_scenario **made, const fw_scenario *sweep, const double *points,
                              int count, fw_error *error);

#endif
