/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pair_potential.h - central forces between movable lattice particles (Popov & Filippov Eqs 13,
 * 14): any potential with its minimum at `distance`, led smoothly to zero over a range.
 *     Lennard-Jones  U = depth [(d/r)^12 - 2 (d/r)^6] S(r)
 *     Morse          U = depth [(1 - e^{-steepness (r - d)})^2 - 1] S(r)
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_PAIR_POTENTIAL_H
#define FW_PAIR_POTENTIAL_H

#include "core/particles/smooth_cut.h"
#include "core/public.h"
#include "core/status.h"

#include <math.h>
#include <stdbool.h>

FW_PUBLIC_BEGIN

typedef enum fw_pair_kind { FW_LENNARD_JONES, FW_MORSE } fw_pair_kind;

typedef struct fw_pair_potential {
    fw_pair_kind kind;
    double depth;     /* epsilon >= 0; 0: particles do not interact */
    double distance;  /* r0, where the minimum lies */
    double steepness; /* of Morse, 1/length; 6/r0 has Lennard-Jones' curvature */
    fw_smooth_cut cut;
} fw_pair_potential;

/* Lennard-Jones, depth 1, distance 1, cut from 1.4 to 1.7. */
fw_pair_potential fw_pair_potential_default(void);

/* FW_BAD_INPUT with a sentence for: non-finite numbers, depth < 0, distance or steepness <= 0, a
 * cut that ends before it begins, a minimum that does not lie inside the cut's full strength. */
fw_status fw_pair_potential_check(const fw_pair_potential *potential, fw_error *error);

/* U''(r0): 72 depth/r0^2 for Lennard-Jones, 2 depth steepness^2 for Morse. */
double fw_pair_potential_stiffness(const fw_pair_potential *potential);

/* U''(r) at any distance r > 0; 0 from the cut on. */
double fw_pair_potential_curvature(const fw_pair_potential *potential, double r);

/* U'' and U'/r of no pair that is at least so far apart, `closest` > 0, are larger. A bound that
 * costs nothing, not the least one. */
double fw_pair_potential_stiffest(const fw_pair_potential *potential, double closest);

/* The largest temperature at which steps of that length follow the collisions of such particles,
 * with the potential taken `strength` times: a collision takes as much as 10 T now and then, and
 * where U >= -depth + 10 T the bond must still be soft enough for Verlet's step,
 * dt < (2 m/U'')^(1/2). (Measured for 36 particles, Lennard-Jones, and time steps from .005 to .09:
 * up to that temperature the ledger closes to 1e-2, at two to ten times that the energy explodes.)
 * INFINITY where U'' never becomes so large. */
double fw_pair_potential_hottest(const fw_pair_potential *potential, double strength, double mass,
                                 double time_step);

typedef struct fw_pair {
    double energy; /* U */
    double push;   /* -U'/r: the force on i is push (r_i - r_j) */
} fw_pair;

/* U and -U'/r at squared distance r2 > 0; nothing from the cut on. */
static inline fw_pair fw_pair_at(const fw_pair_potential *potential, double r2)
{
    const double outer = potential->cut.outer;
    const double inverse = 1 / r2, r = sqrt(r2), inverse_r = inverse * r;
    fw_pair bare;
    if (potential->kind == FW_LENNARD_JONES) {
        const double square = potential->distance * potential->distance * inverse;
        const double sixth = square * square * square;
        bare.energy = potential->depth * sixth * (sixth - 2);
        bare.push = 12 * potential->depth * sixth * (sixth - 1) * inverse;
    } else {
        const double decay = exp(-potential->steepness * (r - potential->distance));
        bare.energy = potential->depth * decay * (decay - 2);
        bare.push = 2 * potential->depth * potential->steepness * decay * (decay - 1) * inverse_r;
    }
    const fw_weight weight = fw_smooth_cut_at(potential->cut, r);
    const double push = bare.push * weight.value - bare.energy * weight.slope * inverse_r;
    const bool inside = r2 < outer * outer;
    return (fw_pair){inside ? bare.energy * weight.value : 0, inside ? push : 0};
}

FW_PUBLIC_END

#endif
