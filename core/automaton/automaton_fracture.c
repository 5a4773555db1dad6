/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_fracture.c - bonds that break ("via breaking the neighbouring relations of particles",
 * Dong, closing section). What remains of a cell is renormalised as at a free boundary of kind
 * `bond`: its mass is that of the bonds it still has. The energy and the momentum that the bond
 * carried go with it, into the ledger.
 * State: one bit per bond, kept at its black end. Start reading at fw_automaton_break_stretched().
 */
#include "automaton_body.h"

#include <assert.h>
#include <math.h>

/* Writes into both rim entries whether a bond of the black cell is whole. */
static void set_bond(fw_automaton *body, int black_cell, int direction, bool whole)
{
    const int partner = body->built[black_cell][direction];
    const int end[FW_COLOURS] = {black_cell, partner};
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_rim *rim = &body->colour[c].rim[end[c]];
        const int d = c == FW_BLACK ? direction : fw_opposite(direction);
        rim->neighbour[d] = whole ? end[!c] : -1;
        rim->weight[d] = whole ? 1 : 0;
        /* Cannot fail: only matrices that are positive definite may break. */
        (void)fw_automaton_rim_weigh(body, c, rim);
    }
}

static void break_bond(fw_automaton *body, int cell, int direction, int moved)
{
    const fw_automaton_rim *rim = &body->colour[FW_BLACK].rim[cell];
    const fw_vec2 difference =
        fw_vec2_subtract(fw_automaton_at(&body->colour[FW_WHITE], rim->neighbour[direction]),
                         fw_automaton_at(&body->colour[FW_BLACK], cell));
    const fw_vec2 pull = fw_sym2_apply(rim->pull[direction], difference);
    const double energy = fw_vec2_dot(difference, pull) / 2;
    fw_solid_ledger *ledger = &body->head.ledger;
    ledger->fracture += energy;
    ledger->dissipated += energy;
    /* p = 1/2 sum B (w - b) once white has moved, the negative once black has. */
    ledger->drag = fw_vec2_add(ledger->drag, fw_vec2_scale(moved == FW_WHITE ? -0.5 : 0.5, pull));
    body->bonds[cell] &= (uint8_t) ~(1 << direction);
    set_bond(body, cell, direction, false);
}

/* Measured against the place of the moving colour halfway through its move: in a rigid motion the
 * two ends of a bond are then exactly at their lattice distance. */
void fw_automaton_break_stretched(fw_automaton *body)
{
    bool broken = false;
    const int moved = fw_automaton_moving(body);
    const fw_automaton_colour *black = &body->colour[FW_BLACK], *white = &body->colour[FW_WHITE];
    for (int n = 0; n < black->count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            const int partner = black->rim[n].neighbour[d];
            if (partner < 0) continue;
            fw_vec2 stretch =
                fw_vec2_subtract(fw_automaton_at(white, partner), fw_automaton_at(black, n));
            const fw_vec2 back = body->moved[moved == FW_BLACK ? n : partner];
            stretch = fw_vec2_add(stretch, fw_vec2_scale(moved == FW_BLACK ? 0.5 : -0.5, back));
            if (!(hypot(stretch.x, stretch.y) > body->break_at)) continue;
            break_bond(body, n, d, moved);
            broken = true;
        }
    if (broken) fw_automaton_list_bonds(body);
}

void fw_automaton_rebuild_bonds(fw_automaton *body)
{
    if (!body->bonds) return;
    for (int n = 0; n < body->colour[FW_BLACK].count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            if (body->built[n][d] >= 0) set_bond(body, n, d, body->bonds[n] >> d & 1);
    fw_automaton_list_bonds(body);
}

bool fw_elastic_automaton_break(fw_solid *solid, int particle, int direction)
{
    fw_automaton *body = fw_automaton_of(solid);
    assert(body->bonds);
    const int colour = body->white[particle], cell = body->cell[particle];
    const int partner = body->colour[colour].rim[cell].neighbour[direction];
    if (partner < 0) return false;
    /* Between ticks the colour that moved last is the one that does not move next. */
    const int moved = !fw_automaton_moving(body);
    if (colour == FW_BLACK)
        break_bond(body, cell, direction, moved);
    else
        break_bond(body, partner, fw_opposite(direction), moved);
    fw_automaton_list_bonds(body);
    return true;
}

int fw_elastic_automaton_frozen(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    int frozen = 0;
    for (int c = 0; c < FW_COLOURS; ++c)
        for (int n = 0; n < body->colour[c].rim_count; ++n)
            frozen += !(body->colour[c].rim[n].inverse_mass.xx > 0);
    return frozen;
}

int fw_elastic_automaton_broken(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    if (!body->bonds) return 0;
    int broken = 0;
    for (int n = 0; n < body->colour[FW_BLACK].count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            broken += body->built[n][d] >= 0 && !(body->bonds[n] >> d & 1);
    return broken;
}
