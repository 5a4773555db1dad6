/* SPDX-License-Identifier: GPL-3.0-or-later */
/* friction_law.h - friction as pure functions: what sticking lets through of a particle's motion
 * along the tangent (the filtered hold), and Coulomb's law with a static and a kinetic
 * coefficient.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_FRICTION_LAW_H
#define FW_FRICTION_LAW_H

#include "core/public.h"

#include <math.h>
#include <stdbool.h>

FW_PUBLIC_BEGIN

/* e of the sticking force: how much of the change of the particle's own momentum P is let through.
 * Stuck and without damping, F = -2 Psi + e (P - P_before)/2 makes
 *     P+ = P + F = -P + e (P - P_before)/2      (elastic forces aside),
 * whose modes P ~ q^t obey q^2 + (1 - e/2) q + e/2 = 0. Both decay the fastest where they coincide,
 * (1 - e/2)^2 = 2 e: e = 6 - 4 sqrt 2 = .3431, q = 1 - sqrt 2 = -.414. (e = 0 is the hold rule, q =
 * -1, which keeps for ever what a particle brought.) */
#define FW_STICK_FILTER 0.343

/* How far sticking lets a particle move: F = -2 Psi + P at first, then
 * F = -2 Psi + e (P - P_before)/2. `inertial` is its displacement by momentum alone and `change`
 * how that differs from the step before, in which it stuck if `again`; both relative to what it
 * sticks to. */
static inline double fw_friction_filter(bool again, double inertial, double change)
{
    return again ? FW_STICK_FILTER / 4 * change : 0.5 * inertial;
}

/* The same, never against the free motion nor beyond it. `slip` is how far the particle would go
 * without friction, relative as well. */
static inline double fw_friction_target(bool again, double inertial, double change, double slip)
{
    const double target = fw_friction_filter(again, inertial, change);
    return fmin(fmax(target, fmin(slip, 0)), fmax(slip, 0));
}

/* Coefficients of Coulomb friction, >= 0: of what slides, and of what sticks, which is never less
 * than the other. */
typedef struct fw_friction {
    double kinetic, at_rest;
} fw_friction;

static inline fw_friction fw_friction_of(double kinetic, double at_rest)
{
    return (fw_friction){kinetic, fmax(kinetic, at_rest)};
}

/* The traction of a particle that would stick with `wanted`. What sticks, or has just come, is let
 * go where that takes more than the static coefficient times the reaction; what slides is rubbed by
 * the kinetic one, and sticks where that is enough. `slides`, in: it slid in the step before; out:
 * it slides, or did. */
static inline double fw_friction_traction(fw_friction law, double reaction, double wanted,
                                          bool *slides)
{
    if (fabs(wanted) <= (*slides ? law.kinetic : law.at_rest) * reaction) return wanted;
    *slides = true;
    return copysign(law.kinetic * reaction, wanted);
}

FW_PUBLIC_END

#endif
