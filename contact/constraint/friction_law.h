/* SPDX-License-Identifier: GPL-3.0-or-later */
/* friction_law.h - what sticking lets through of a particle's motion along the tangent: the
 * filtered hold, as a pure function. */
#ifndef FW_FRICTION_LAW_H
#define FW_FRICTION_LAW_H

#include <math.h>
#include <stdbool.h>

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
 * without friction, relative as well; `slope` is how the result changes with the motion of what it
 * sticks to. */
static inline double fw_friction_target(bool again, double inertial, double change, double slip,
                                        double *slope)
{
    const double target = fw_friction_filter(again, inertial, change);
    const double low = fmin(slip, 0), high = fmax(slip, 0);
    *slope = again ? -FW_STICK_FILTER / 4 : -0.5;
    if (target > low && target < high) return target;
    const double end = target <= low ? low : high;
    *slope = end == 0 ? 0 : -1;
    return end;
}

#endif
