/* SPDX-License-Identifier: GPL-3.0-or-later */
/* piston.h - the motion of a rigid wall that has a mass and moves as forces make it.
 *
 * It does not turn. In a tick in which the drive D and the bodies' push R act on it, it moves by
 *
 *     u1 = v + dt (D + R)/(2 M),   w = dt (1 + c) u1 / 2,   v -> c u1 + dt (D + R)/(2 M),
 *
 * c = exp(-damping dt): the step of velocity Verlet (c = 1) and BAOAB, so that a piston is to
 * contact what a particle is, with the mobility dt^2 (1 + c)/(4 M). Kinetic energy changes by
 * exactly (D + R).w - M (1 - c^2) u1^2/2. A prescribed component follows its path and has neither
 * kinetic energy nor momentum here. How w and R come about together stands in scene_pistons.c.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_PISTON_H
#define FW_PISTON_H

#include "contact/scene/drive.h"
#include "core/public.h"

FW_PUBLIC_BEGIN

typedef struct fw_piston_def {
    double mass;      /* > 0 */
    fw_vec2 velocity; /* at the start; of prescribed components 0 */
    double damping;   /* rate at which its velocity decays, 1/time, >= 0 */
    fw_drive drive;
} fw_piston_def;

/* What the piston did and what was done to it. All of it is state. */
typedef struct fw_piston_ledger {
    fw_vec2 displacement;  /* since the beginning */
    fw_vec2 velocity;      /* of a prescribed component: of the last tick, 0 before the first */
    fw_vec2 held;          /* 1 in components that are prescribed now, else 0 */
    fw_vec2 force;         /* D of the last tick */
    fw_vec2 reaction;      /* mean of D over the last two ticks, free of the held mode */
    double torque;         /* of the bodies' push about the middle of the piston, last tick */
    fw_vec2 impulse;       /* sum D dt */
    double work;           /* sum D.w */
    fw_vec2 pushed;        /* sum R dt */
    double pushed_by;      /* the work of the bodies, sum R.w */
    fw_vec2 unmatched;     /* the part of `pushed` that does not fit the motion found, and ... */
    double unmatched_work; /* ... of `pushed_by`: rounding, unless a soft corner pushes */
    fw_vec2 drag;          /* momentum taken by damping, with its sign */
    double heat;           /* energy taken by damping, >= 0 */
    fw_vec2 path_length;   /* per component, to and fro */
    fw_vec2 met;           /* sum of the push of walls that it meets, times dt */
    double met_work;       /* of that */
} fw_piston_ledger;

typedef struct fw_piston fw_piston;

/* `name` begins the sentences of failures, and is copied. FW_BAD_INPUT: mass not above 0, damping <
 * 0, numbers that are not finite, a velocity of a prescribed component, or a drive that
 * fw_drive_check refuses. */
fw_status fw_piston_create(fw_piston **piston, const char *name, const fw_piston_def *def,
                           fw_error *error);
void fw_piston_destroy(fw_piston *piston);

/* Part of the state: the caller puts it into its list and may write saved values back. */
fw_piston_ledger *fw_piston_ledger_of(fw_piston *piston);
const fw_piston_ledger *fw_piston_observe_ledger(const fw_piston *piston);
/* Of the components that are not prescribed. */
double fw_piston_kinetic_energy(const fw_piston *piston);
fw_vec2 fw_piston_momentum(const fw_piston *piston);
/* Both minus what they were at the start and what the ledger says of work, heat and impulses, all
 * but what is unmatched: the piston's ledger closes to rounding. */
double fw_piston_energy_error(const fw_piston *piston);
fw_vec2 fw_piston_momentum_error(const fw_piston *piston);

/* Another drive and damping from now on. A component that is prescribed from now on gives up its
 * kinetic energy and momentum, one that no longer is begins with its last velocity; both count as
 * work and impulse of the drive. FW_BAD_INPUT as for create. */
fw_status fw_piston_set_drive(fw_piston *piston, const fw_drive *drive, double damping,
                              fw_error *error);

/* The displacement in the tick that begins at `time`, when the bodies push with `push`; and its
 * derivative to the push, a diagonal matrix with zeros where it is prescribed. */
fw_vec2 fw_piston_displacement(const fw_piston *piston, fw_vec2 push, double time, double tick);
fw_sym2 fw_piston_mobility(const fw_piston *piston, double tick);

/* The displacement in that tick by its velocity alone, and along the path where it is prescribed.
 */
fw_vec2 fw_piston_inertial(const fw_piston *piston, double time, double tick);

/* Whether forces move it, at least in one component. */
bool fw_piston_yields(const fw_piston *piston);

/* Ends the tick: it has moved by `motion` under the bodies' push and that of the walls that it
 * meets, and the bodies have done that work on it
 * (push . motion, but where soft corners push as no single force could). The velocity follows from
 * the motion; what that leaves over of push and work is booked as unmatched. */
void fw_piston_advance(fw_piston *piston, fw_vec2 motion, fw_vec2 push, fw_vec2 met, double work,
                       double torque, double time, double tick);

FW_PUBLIC_END

#endif
