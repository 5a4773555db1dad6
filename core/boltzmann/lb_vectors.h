/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_vectors.h - masses and forces of as many particles as a register holds, and what passes
 * through their bounds; for the kernels of both forms. */
#ifndef FW_LB_VECTORS_H
#define FW_LB_VECTORS_H

#include "core/lattice.h"
#include "core/solid.h"
#include "core/vectors.h"

/* A symmetric matrix, of which only xx counts where it is a multiple of one. */
typedef struct symmetric {
    fw_vector xx, xy, yy;
} symmetric;

FW_INLINE symmetric load_symmetric(const double *xx, const double *xy, const double *yy, int l,
                                   bool matrix)
{
    symmetric m = {.xx = fw_load(xx + l)};
    if (matrix) m.xy = fw_load(xy + l), m.yy = fw_load(yy + l);
    return m;
}

/* (M0^2 + number of links)/2 of the places of a block: of each direction a bit for each place. */
FW_INLINE fw_vector counted_mass(double rest_square, const uint8_t *links, int part)
{
    fw_vector sum = fw_splat(rest_square);
    for (int d = 0; d < FW_DIRECTIONS; ++d) sum += fw_keep(fw_mask_of(links[d], part), fw_splat(1));
    return 0.5 * sum;
}

FW_INLINE fw_vector_pair times(symmetric m, fw_vector_pair v, bool matrix)
{
    if (!matrix) return (fw_vector_pair){m.xx * v.x, m.xx * v.y};
    return (fw_vector_pair){m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y};
}

/* What passed, lane by lane. */
typedef struct passed {
    fw_vector work[FW_PARTS], impulse_x[FW_PARTS], impulse_y[FW_PARTS];
    fw_vector dissipated[FW_PARTS], drag_x[FW_PARTS], drag_y[FW_PARTS];
} passed;

/* dE = F.w,  dPsi = F */
FW_INLINE void pass_force(passed *sum, int part, fw_vector_pair force, fw_vector_pair w)
{
    sum->work[part] += force.x * w.x + force.y * w.y;
    sum->impulse_x[part] += force.x;
    sum->impulse_y[part] += force.y;
}

/* dE = -2(1/mu - 1) w.Mw,  dPsi = -2(1/mu - 1) Mw, with momentum = Mw */
FW_INLINE void pass_drag(passed *sum, int part, double mu, fw_vector_pair momentum,
                         fw_vector_pair w)
{
    const double loss = 2 * (1 / mu - 1);
    sum->dissipated[part] += loss * (w.x * momentum.x + w.y * momentum.y);
    sum->drag_x[part] -= loss * momentum.x;
    sum->drag_y[part] -= loss * momentum.y;
}

FW_INLINE void add_passed(fw_solid_ledger *ledger, const passed *sum, bool loaded, bool damped)
{
    if (loaded) {
        ledger->work += fw_sum_block(sum->work);
        ledger->impulse.x += fw_sum_block(sum->impulse_x);
        ledger->impulse.y += fw_sum_block(sum->impulse_y);
    }
    if (damped) {
        ledger->dissipated += fw_sum_block(sum->dissipated);
        ledger->drag.x += fw_sum_block(sum->drag_x);
        ledger->drag.y += fw_sum_block(sum->drag_y);
    }
}

#endif
