/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_step.h - the operations `predict`, `advance`, `advance_free` and (in lb_carry.c) `carry` of
 * fw_solid_model for the LB solid. */
#ifndef FW_LB_STEP_H
#define FW_LB_STEP_H

#include "lb_state.h"

void lb_predict(const fw_solid *solid, const int *particles, int count, fw_prediction *out);
fw_status lb_advance(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                     fw_error *error);
fw_status lb_advance_free(fw_solid *solid, int ticks, fw_error *error);
void lb_carry(fw_solid *solid, fw_carry *carries, int count);

#endif
