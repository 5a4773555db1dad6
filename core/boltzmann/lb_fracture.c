/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_fracture.c - links that break. A broken link's mass and momentum go into the rest fields of
 * its two ends, so that M and Psi of each particle stay what they were; only energy is lost, at
 * least half kappa times the squared stretch: the fracture energy. State: that of lb_layout.h.
 * Start reading at lb_break_links(). */
#include "lb_fracture.h"

#include "lb_layout.h"

#include <math.h>

/* The positive square root of a symmetric, positive matrix: (m + sqrt(det m) 1)/sqrt(tr m + 2
 * sqrt(det m)), which follows from Cayley-Hamilton. */
static fw_sym2 root(fw_sym2 m)
{
    if (m.xy == 0) return (fw_sym2){sqrt(m.xx), 0, sqrt(m.yy)};
    double d = sqrt(fw_sym2_determinant(m));
    return fw_sym2_scale(1 / sqrt(m.xx + m.yy + 2 * d), fw_sym2_add(m, fw_sym2_scalar(d)));
}

/* M0 -> (M0^2 + kappa)^(1/2), f_0 -> M0'^-1 (M0 f_0 + kappa s), with s the mean of the link's two
 * fields. Returns the energy that the particle's rest field gained. */
static double absorb(lb_solid *lb, int l, int direction, fw_sym2 kappa, fw_vec2 mean)
{
    fw_sym2 before = lb_get(&lb->rest_mass, l);
    fw_sym2 after = root(fw_sym2_add(fw_sym2_square(before), kappa));
    fw_vec2 rest = lb_rest(lb, l);
    fw_vec2 carried = fw_vec2_add(fw_sym2_apply(before, rest), fw_sym2_apply(kappa, mean));
    fw_vec2 rest_after = fw_sym2_apply(fw_sym2_invert(after), carried);
    lb_put(&lb->rest_mass, l, after);
    lb->rest_x[l] = rest_after.x;
    lb->rest_y[l] = rest_after.y;
    lb->present[l] = (uint8_t)(lb->present[l] & ~(1u << direction));
    return fw_vec2_dot(rest_after, rest_after) - fw_vec2_dot(rest, rest);
}

static void break_link(lb_solid *lb, int l, int direction)
{
    int m = lb_neighbour(lb, l, direction), opposite = fw_opposite(direction);
    slot_place here = lb_slot(lb, l, direction), there = lb_slot(lb, m, opposite);
    fw_vec2 a = {*here.x, *here.y}, b = {*there.x, *there.y};
    fw_sym2 kappa = lb_stiffness(lb, l, direction);
    fw_vec2 mean = fw_vec2_scale(0.5, fw_vec2_add(a, b));
    double lost = fw_sym2_form(a, kappa, a) + fw_sym2_form(b, kappa, b);
    lost -= absorb(lb, l, direction, kappa, mean);
    lost -= absorb(lb, m, opposite, kappa, mean);
    *here.x = *here.y = *there.x = *there.y = 0;
    lb->head.ledger.dissipated += lost;
    lb->head.ledger.fracture += lost;
    lb->broken += 1;
}

void lb_break_links(lb_solid *lb)
{
    const double limit = lb->break_at * lb->break_at;
    int broken = lb->broken;
    for (int l = 0; l < lb->head.count; ++l)
        for (int d = FW_EAST; d <= FW_NORTH; ++d) {
            if (!(lb->present[l] & (1u << d))) continue;
            fw_vec2 stretch = fw_lb_solid_deformation(&lb->head, l, d);
            if (fw_vec2_dot(stretch, stretch) > limit) break_link(lb, l, d);
        }
    if (lb->broken != broken) lb_layout_rebuild(lb);
}
