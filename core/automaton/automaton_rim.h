/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_rim.h - what moves a cell at a rim. For the automaton's own files only, kernels among
 * them: small functions that are written once and compiled where they are called. */
#ifndef FW_AUTOMATON_RIM_H
#define FW_AUTOMATON_RIM_H

#include "automaton_body.h"

#include <math.h>

/* s = sum_d pull[d] (neighbour - self), over displacements of the other colour. */
static inline fw_vec2 fw_automaton_rim_pull(const fw_automaton_rim *rim, fw_vec2 self,
                                            const double *other_x, const double *other_y)
{
    fw_vec2 sum = {0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int neighbour = rim->neighbour[d];
        if (neighbour < 0) continue;
        const fw_vec2 there = {other_x[neighbour], other_y[neighbour]};
        sum = fw_vec2_add(sum, fw_sym2_apply(rim->pull[d], fw_vec2_subtract(there, self)));
    }
    return sum;
}

/* Free displacement (1 + a)/2 m^-1 s. The rounding of m^-1 is the same each time and would add up
 * to 1e-12 of the energy in 10^4 steps; a second pass over what m d misses leaves only rounding
 * that varies. (The images of `mirror` have no mass to keep.) */
static inline fw_vec2 fw_automaton_rim_displacement(const fw_automaton_rim *rim, fw_vec2 s,
                                                    double share_of_pull, bool mirror)
{
    const fw_sym2 m = rim->mass;
    fw_vec2 d = fw_sym2_apply(rim->inverse_mass, s);
    const fw_vec2 missed = {fma(-m.xy, d.y, fma(-m.xx, d.x, s.x)),
                            fma(-m.yy, d.y, fma(-m.xy, d.x, s.y))};
    if (!mirror) d = fw_vec2_add(d, fw_sym2_apply(rim->inverse_mass, missed));
    return fw_vec2_scale(share_of_pull, d);
}

#endif
