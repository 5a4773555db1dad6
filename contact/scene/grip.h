/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grip.h - a rigid block of particles of one solid, held together by constraint forces and driven.
 *
 * All its particles move by the same displacement w in a step. A driven component obeys the drive
 * force D: with the particles' free displacements w_i and mobilities A_i,
 *
 *     sum_i A_i^-1 (w - w_i) = D,      F_i = A_i^-1 (w - w_i),
 *
 * which for the LB solid is F_i = 2 (M_i w/mu - Psi_i), w = mu (sum Psi + D/2)/sum M. A component
 * on a prescribed path follows it, and D is the force that this takes. The forces F_i inside the
 * block do no work but D.w, and add up to D: energy and momentum are exact. A grip does not turn;
 * the torque that this takes is reported.
 *
 * Forces that are found so turn the momentum of a held particle over in each tick, p -> 2 M V - p.
 * On a path every particle gets the velocity of the path after the tick instead (fw_grip_carry):
 * released, it keeps that velocity. What this takes is a part of D and of its work.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_GRIP_H
#define FW_GRIP_H

#include "contact/scene/drive.h"
#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

typedef struct fw_grip_def {
    const char *name;     /* copied */
    const int *particles; /* of the solid, ascending, each once; copied */
    int particle_count;   /* >= 1 */
    fw_drive drive;
} fw_grip_def;

/* What the grip did and what was done to it. All of it is state. */
typedef struct fw_grip_ledger {
    fw_vec2 displacement; /* since the beginning */
    fw_vec2 force;        /* D of the last tick */
    fw_vec2 reaction;     /* mean of D over the last two ticks, free of the held mode */
    double torque;        /* of the constraint forces about the grip's centre, last tick */
    fw_vec2 impulse;      /* sum D dt */
    double work;          /* sum D . w */
    fw_vec2 path_length;  /* per component, to and fro */
} fw_grip_ledger;

typedef struct fw_grip fw_grip;

/* FW_BAD_INPUT: no particles, numbers that are not finite, period or tether < 0. */
fw_status fw_grip_create(fw_grip **grip, const fw_grip_def *def, fw_error *error);
void fw_grip_destroy(fw_grip *grip);

const char *fw_grip_name(const fw_grip *grip);
int fw_grip_particle_count(const fw_grip *grip);
const int *fw_grip_particles(const fw_grip *grip);
/* Part of the state: the caller puts it into its list and may write saved values back. */
fw_grip_ledger *fw_grip_ledger_of(fw_grip *grip);
const fw_grip_ledger *fw_grip_observe_ledger(const fw_grip *grip);

/* Another drive from now on, as in the next phase of an experiment; the displacement, to which
 * tethers refer, is kept. Paths are counted from their own time 0. FW_BAD_INPUT as for create. */
fw_status fw_grip_set_drive(fw_grip *grip, const fw_drive *drive, fw_error *error);

/* By how much its particles will move in the tick that begins at `time` if they touch nothing, from
 * the solid's predictions. The other functions of the tick come after it. */
fw_vec2 fw_grip_displacement(fw_grip *grip, const fw_solid *solid, double time);
/* dw/dF of a force on any of its particles: zero in components that the drive prescribes. */
fw_sym2 fw_grip_mobility(const fw_grip *grip);
/* What momentum alone, or the drive's path, would move it by. */
fw_vec2 fw_grip_inertial(const fw_grip *grip, fw_vec2 displacement);
/* Its particles move by w: fills `constraints` (particle_count of them, ascending), and enters the
 * tick in the ledger. */
void fw_grip_constrain(fw_grip *grip, const fw_solid *solid, fw_vec2 w, fw_constraint *constraints);

/* Others push its particles with that force in this tick, which is no part of its own: that is so
 * much less than what the particles need. After fw_grip_constrain. */
void fw_grip_book_contact(fw_grip *grip, fw_vec2 force, fw_vec2 displacement, double tick);

/* After the tick: adds the particles' velocities to the list, where the drive prescribes any,
 * marked with `owner`; returns how many it added. Afterwards enter in the ledger what
 * they took, as the solid has reported it. */
int fw_grip_carry(const fw_grip *grip, int owner, double time, double tick, fw_carry *carries);
void fw_grip_book_carry(fw_grip *grip, const fw_carry *carry, double tick);

FW_PUBLIC_END

#endif
