/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_carry.c - particles whose velocity is prescribed. Keeps no state.
 *
 * The momentum of an LB particle lies in its rest field and in the sums of the two fields of each
 * of its links. A prescribed displacement w turns them over, f_0 -> M0 w - f_0 and
 * s -> (w_l + w_m)/2 - s with s half the sum: what starts at rest would have 0, 2V, 0, 2V, ...
 * Here they become what they are in a body that moves evenly, M0 V/2 and (V_l + V_m)/4. A link that
 * leads to a particle whose velocity is free stays as it is: half of its momentum is that one's.
 * Start reading at lb_carry(). */
#include "lb_step.h"

#include <assert.h>

/* Entry of a particle, or NULL. */
static fw_carry *find(fw_carry *carries, int count, int particle)
{
    int low = 0, high = count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (carries[middle].particle < particle)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && carries[low].particle == particle ? &carries[low] : NULL;
}

/* The change of a velocity of which only some components are prescribed, with the mass K: the
 * momentum of the others stays as it is. */
static fw_vec2 prescribed_change(const fw_carry *carry, fw_vec2 change, fw_sym2 mass)
{
    if (carry->x && carry->y) return change;
    if (mass.xy == 0) return (fw_vec2){carry->x ? change.x : 0, carry->y ? change.y : 0};
    if (carry->x) return (fw_vec2){change.x, -mass.xy / mass.yy * change.x};
    return (fw_vec2){-mass.xy / mass.xx * change.y, change.y};
}

/* Adds `change` to a field that weighs kappa in momentum and energy. */
static void change_field(slot_place slot, fw_vec2 change, fw_sym2 kappa, fw_carry *carry)
{
    const fw_vec2 before = {*slot.x, *slot.y}, after = fw_vec2_add(before, change);
    *slot.x = after.x;
    *slot.y = after.y;
    carry->impulse = fw_vec2_add(carry->impulse, fw_sym2_apply(kappa, change));
    carry->work += fw_sym2_form(after, kappa, after) - fw_sym2_form(before, kappa, before);
}

/* Both fields of a link by the same amount, which leaves its stretch as it is. */
static void carry_link(lb_solid *lb, int l, int direction, fw_carry *here, fw_carry *there)
{
    const int opposite = fw_opposite(direction);
    const slot_place near = lb_slot(lb, l, direction), far = lb_slot(lb, there->particle, opposite);
    const fw_sym2 kappa = lb_stiffness(lb, l, direction);
    const fw_carry common = {.x = here->x && there->x, .y = here->y && there->y};
    if (!common.x && !common.y) return;
    const fw_vec2 wanted = fw_vec2_scale(0.25, fw_vec2_add(here->velocity, there->velocity));
    const fw_vec2 now = {0.5 * (*near.x + *far.x), 0.5 * (*near.y + *far.y)};
    const fw_vec2 change = prescribed_change(&common, fw_vec2_subtract(wanted, now), kappa);
    change_field(near, change, kappa, here);
    change_field(far, change, kappa, there);
}

/* f_0 -> M0 V/2. */
static void carry_rest(lb_solid *lb, fw_carry *carry)
{
    const int l = carry->particle;
    const fw_sym2 m = lb_get(&lb->rest_mass, l);
    const fw_vec2 before = lb_rest(lb, l), half = fw_vec2_scale(0.5, carry->velocity);
    fw_vec2 after = fw_sym2_apply(m, half);
    if (m.xy == 0) {
        after = (fw_vec2){carry->x ? after.x : before.x, carry->y ? after.y : before.y};
    } else if (!(carry->x && carry->y)) {
        /* Which part of f_0 belongs to which component? */
        if (m.xx * m.yy - m.xy * m.xy == 0) return;
        const fw_sym2 square = {m.xx * m.xx + m.xy * m.xy, m.xy * (m.xx + m.yy),
                                m.yy * m.yy + m.xy * m.xy};
        const fw_vec2 now = fw_sym2_apply(fw_sym2_invert(m), before);
        const fw_vec2 change = prescribed_change(carry, fw_vec2_subtract(half, now), square);
        after = fw_vec2_add(before, fw_sym2_apply(m, change));
    }
    const fw_vec2 change = fw_vec2_subtract(after, before);
    lb->rest_x[l] = after.x;
    lb->rest_y[l] = after.y;
    carry->impulse = fw_vec2_add(carry->impulse, fw_sym2_apply(m, change));
    carry->work += fw_vec2_dot(after, after) - fw_vec2_dot(before, before);
}

void lb_carry(fw_solid *solid, fw_carry *carries, int count)
{
    lb_solid *lb = (lb_solid *)solid;
    lb->sums->known = false;
    assert(!lb->displaced); /* a carried link has hidden modes: see lb_solid.h */
    for (int n = 0; n < count; ++n) {
        const int l = carries[n].particle;
        if (lb->resting) carry_rest(lb, &carries[n]);
        for (int d = FW_EAST; d <= FW_NORTH; ++d) {
            if (!(lb->present[l] & (1u << d))) continue;
            fw_carry *there = find(carries, count, lb_neighbour(lb, l, d));
            if (there) carry_link(lb, l, d, &carries[n], there);
        }
    }
}
