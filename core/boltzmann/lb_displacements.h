/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacements.h - the displacement form of an LB solid: its state and its steps. */
#ifndef FW_LB_DISPLACEMENTS_H
#define FW_LB_DISPLACEMENTS_H

#include "lb_state.h"

/* Makes the grid and its arrays, once links and masses are known, of a shape that lb_grid_pays().
 * FW_SYSTEM_FAILED without memory. */
fw_status lb_displacements_make(lb_solid *lb, const fw_sites *sites, fw_error *error);
void lb_displacements_release(lb_solid *lb);
/* Where a particle is at the start: its site, u and V. */
void lb_displacements_start(lb_solid *lb, int l, fw_vec2 site, fw_vec2 u, fw_vec2 velocity);
void lb_displacements_state(lb_solid *lb, fw_state_list *list);

fw_prediction lb_displacements_predict(const lb_solid *lb, int l);
/* One tick, after which the positions of boundary particles are right. FW_SYSTEM_FAILED without
 * memory. */
fw_status lb_displacements_advance(lb_solid *lb, const fw_constraint *constraints, int count,
                                   fw_error *error);
/* Ticks without constraints, under the loads as they stand: the same bytes as one by one. */
void lb_displacements_advance_free(lb_solid *lb, int ticks);
/* What the links of `count` places of a row, from a multiple of LB_BLOCK on, add to energies and
 * momentum; 0 where there are none. */
void lb_displacements_terms(const lb_solid *lb, int row, int place, int count,
                            lb_field_terms *terms);
/* Velocities of all particles. False, and nothing done, where they have rest fields or masses that
 * are no multiples of one. */
bool lb_displacements_velocities(const lb_solid *lb, double *x, double *y);
/* The same of `add_squares` (lb_displacement_kernels.h). */
void lb_displacements_add_squares(const lb_solid *lb, int row, int place, int count,
                                  fw_vec2 velocity, double weight, double *sums);
/* Makes all positions, and those of boundary particles. */
void lb_displacements_place(lb_solid *lb);
void lb_displacements_place_boundary(lb_solid *lb);

#endif
