/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin.h - solids of point masses that obey Langevin's equation (Popov & Filippov Eqs 12-17):
 *     m dv/dt = F - m damping v + noise,   <noise noise> = 2 m damping T.
 * What they share, whatever their forces: velocities, and BAOAB steps, which are velocity Verlet's
 * where there is no damping. With c = e^{-damping dt}, s = sqrt((1 - c^2) T/m), xi Gaussian:
 *     v1 = v + dt/2m F(x);   v2 = c v1 + s xi;   x+ = x + dt/2 (v1 + v2);   v+ = v2 + dt/2m F(x+).
 * External and holding forces act in both kicks. A model embeds fw_langevin as its first member,
 * fills `find_forces`, and takes the operations below for its table.
 *
 * The ledger: work = F_ext . (x+ - x). Where damping acts, m/2 (v2^2 - v1^2) is split into what
 * drag takes, m/2 (1 - c^2) v1^2 >= 0, and what the noise brings, the rest. With them the energy
 * closes up to Verlet's own error, which is bounded and of order dt^2.
 *
 * Public: the controls and what is for everybody are meant to stay, the rest is not. */
#ifndef FW_LANGEVIN_H
#define FW_LANGEVIN_H

#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

typedef struct fw_langevin fw_langevin;
struct fw_move_task; /* a step in numbers, for kernels */

/* What may change between steps; part of the state. */
typedef struct fw_langevin_controls {
    double time_step;
    double damping;     /* rate, 1/time: eta/m */
    double temperature; /* kB T in units of energy */
} fw_langevin_controls;

/* Sums of what moves. */
typedef struct fw_motion_sums {
    double kinetic;
    fw_vec2 momentum;
} fw_motion_sums;

/* Sums over all particles as they are now, once somebody has asked for them. */
typedef struct fw_langevin_known {
    bool has_motion, has_elastic, has_mass;
    fw_motion_sums motion;
    double elastic, mass;
} fw_langevin_known;

struct fw_langevin {
    fw_solid head;
    fw_langevin_controls controls;
    uint64_t seed;
    double *velocity_x, *velocity_y;
    double *force_x, *force_y; /* the solid's own forces at its present positions */
    double *mass;              /* to be filled by the model before fw_langevin_start() */
    /* Makes force_x/y for the positions of the head; the only part in which models differ. No two
     * particles have come closer by more than `travel` since the last time. Then follows the second
     * kick of the step, by fw_langevin_kick() or where each force is made; NULL: none.
     * FW_SYSTEM_FAILED without memory. */
    fw_status (*find_forces)(fw_langevin *solid, double travel, const struct fw_move_task *kick,
                             fw_error *error);
    /* The largest temperature that steps of that length follow; NULL: any. */
    double (*hottest)(const fw_langevin *solid, double time_step);

    /* Private. */
    double *inverse_mass, *root_inverse_mass;
    double *constraint_x, *constraint_y; /* constraint forces; zero between steps */
    fw_vec2 *held_at;                    /* where held particles were; as many as particles */
    double *scratch;                     /* one number per particle, for whoever sums */
    fw_langevin_known *known;            /* nobody else's, so that sums can be observed */
    struct fw_move_sums *sums;           /* of each block of particles */
    fw_vec2 common;                      /* mean path of the last step; only `travel` hangs on it */
};

/* Allocates head and arrays; on failure everything is released. */
fw_status fw_langevin_create(fw_langevin *solid, const fw_solid_model *model, int count,
                             fw_error *error);
void fw_langevin_release(fw_langevin *solid);

/* FW_BAD_INPUT with a sentence for: a time step that is not positive, a negative damping or
 * temperature, numbers that are not finite. */
fw_status fw_langevin_check(const fw_langevin_controls *controls, fw_error *error);
/* To be called once positions, velocities, masses and controls stand: finds the first forces. */
fw_status fw_langevin_start(fw_langevin *solid, fw_error *error);
void fw_langevin_set_controls(fw_langevin *solid, const fw_langevin_controls *controls);

/* To be called where positions or velocities are about to change: what is known is of no use then.
 */
void fw_langevin_forget(fw_langevin *solid);
/* Sums over particles first to first + count - 1, in the order of fw_array_sum(): of their motion,
 * and of m x. */
fw_motion_sums fw_langevin_sum_motion(const fw_langevin *solid, int first, int count);
fw_vec2 fw_langevin_sum_places(const fw_langevin *solid, int first, int count);
/* The second kick of particles first to first + count - 1; for models. kick NULL: nothing. */
void fw_langevin_kick(const struct fw_move_task *kick, int first, int count);

/* Turns every velocity round: without damping the way back is the way it came. */
void fw_langevin_reverse(fw_solid *solid);

/* --- for everybody who has such a solid --- */

/* Does the solid consist of point masses that move by these steps? All below takes one that does.
 */
bool fw_solid_is_langevin(const fw_solid *solid);
fw_vec2 fw_langevin_velocity(const fw_solid *solid, int particle);
void fw_langevin_set_velocity(fw_solid *solid, int particle, fw_vec2 velocity);
/* Adds it to those of particles first to first + count - 1. */
void fw_langevin_add_velocity(fw_solid *solid, int first, int count, fw_vec2 velocity);
/* Velocities drawn from Maxwell's distribution at that temperature, for particles first to
 * first + count - 1, then shifted to leave their momentum zero. */
void fw_langevin_draw_velocities(fw_solid *solid, int first, int count, double temperature);
/* Adds sum m (v - drift)^2 of those particles, per component, to *heat. */
void fw_langevin_add_heat(const fw_solid *solid, int first, int count, fw_vec2 drift,
                          fw_vec2 *heat);
/* FW_BAD_INPUT where the temperature of those controls, of a bath or of a start, is higher than
 * their time step allows; without damping no temperature acts. */
fw_status fw_langevin_check_heat(const fw_solid *solid, const fw_langevin_controls *controls,
                                 fw_error *error);
/* Another bath from now on. FW_BAD_INPUT: a negative number, one that is not finite, or a bath too
 * hot for the time step. */
fw_status fw_langevin_set_bath(fw_solid *solid, double damping, double temperature,
                               fw_error *error);

/* The operations of fw_solid_model that all solids with an fw_langevin have alike. */
#define FW_LANGEVIN_OPERATIONS                                                                     \
    .ticks_per_step = 1, .predict = fw_langevin_predict, .advance = fw_langevin_advance,           \
    .carry = fw_langevin_carry, .momentum = fw_langevin_momentum,                                  \
    .angular_momentum = fw_langevin_angular_momentum,                                              \
    .centre_of_mass = fw_langevin_centre_of_mass, .mass = fw_langevin_mass,                        \
    .velocities = fw_langevin_velocities, .masses = fw_langevin_masses,                            \
    .reverse = fw_langevin_reverse

/* Operations of fw_solid_model, for solids that embed fw_langevin. */
void fw_langevin_predict(const fw_solid *solid, const int *particles, int count,
                         fw_prediction *out);
fw_status fw_langevin_advance(fw_solid *solid, const fw_constraint *constraints,
                              int constraint_count, fw_error *error);
void fw_langevin_carry(fw_solid *head, fw_carry *carries, int count);
double fw_langevin_kinetic_energy(const fw_langevin *solid);
fw_vec2 fw_langevin_momentum(const fw_solid *solid);
double fw_langevin_angular_momentum(const fw_solid *solid, int first, int count);
fw_vec2 fw_langevin_centre_of_mass(const fw_solid *solid);
fw_sym2 fw_langevin_mass(const fw_solid *solid);
void fw_langevin_velocities(const fw_solid *solid, double *x, double *y);
void fw_langevin_masses(const fw_solid *solid, double *mass);
void fw_langevin_state(fw_solid *solid, fw_state_list *list);
/* Finds the forces again, for positions or controls that were written from outside. */
fw_status fw_langevin_refresh(fw_solid *solid, fw_error *error);
fw_status fw_langevin_restored(fw_solid *solid, fw_error *error);

FW_PUBLIC_END

#endif
