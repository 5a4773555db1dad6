/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacements.h - the displacement form of an LB solid: its state and its steps. */
#ifndef FW_LB_DISPLACEMENTS_H
#define FW_LB_DISPLACEMENTS_H

#include "lb_look_kernels.h"
#include "lb_state.h"

/* Makes the grid and its arrays, once links and masses are known, of a shape that lb_grid_pays().
 * FW_SYSTEM_FAILED without memory. */
fw_status lb_displacements_make(lb_solid *lb, const fw_sites *sites, fw_error *error);
void lb_displacements_release(lb_solid *lb);
/* Where `count` particles from `first` on are at the start, whose sites lie there. */
void lb_displacements_start(lb_solid *lb, int first, int count, const fw_vec2 *sites,
                            const fw_lb_solid_def *def);
void lb_displacements_state(lb_solid *lb, fw_state_list *list);

fw_prediction lb_displacements_predict(const lb_solid *lb, int l);
/* One tick, after which the positions of boundary particles are right. FW_SYSTEM_FAILED without
 * memory. */
fw_status lb_displacements_advance(lb_solid *lb, const fw_constraint *constraints, int count,
                                   fw_error *error);
/* Ticks without constraints, under the loads as they stand: the same bytes as one by one. */
void lb_displacements_advance_free(lb_solid *lb, int ticks);
/* As they are now, without loads. */
lb_grid_arrays lb_displacements_arrays(const lb_solid *lb);
lb_particle_arrays lb_displacements_particles(const lb_solid *lb);
/* `add_squares` (lb_displacement_kernels.h) of the present fields. */
void lb_displacements_add_squares(const lb_solid *lb, int row, int place, int count,
                                  fw_vec2 velocity, double weight, double *sums);
/* r = site + (common + u) of a particle, and as the head has it: of all, and of boundary particles.
 */
fw_vec2 lb_displacements_position(const lb_solid *lb, int l);
void lb_displacements_place(lb_solid *lb);
void lb_displacements_place_boundary(lb_solid *lb);

#endif
