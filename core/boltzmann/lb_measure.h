/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_measure.h - fields, for the table of operations; all else that is measured
 * is declared in lb_solid.h. */
#ifndef FW_LB_MEASURE_H
#define FW_LB_MEASURE_H

#include "lb_state.h"

extern const fw_field lb_fields[];

#endif
