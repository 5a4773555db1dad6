/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_start.c - displacements of both colours for a body that starts displaced by u and
 * moving at V. Keeps no state. Start reading at fw_automaton_start(). */
#include "core/automaton_body.h"

static fw_vec2 value_at(const fw_vec2 *field, int particle)
{
    return field ? field[particle] : (fw_vec2){0, 0};
}

/* The particle beyond a bond, or -1. */
static int beyond(const fw_automaton *body, int particle, int direction)
{
    double weight;
    const int colour = body->white[particle];
    const int partner =
        fw_automaton_cell_neighbour(body, colour, body->cell[particle], direction, &weight);
    return partner < 0 ? -1 : body->colour[!colour].particle[partner];
}

/* Difference per spacing along an axis: central inside, one-sided at a rim. */
static fw_vec2 slope(const fw_automaton *body, const fw_vec2 *field, int particle, int forward)
{
    const int ahead = beyond(body, particle, forward);
    const int behind = beyond(body, particle, fw_opposite(forward));
    const int sides = (ahead >= 0) + (behind >= 0);
    if (sides == 0) return (fw_vec2){0, 0};
    const fw_vec2 difference = fw_vec2_subtract(field[ahead >= 0 ? ahead : particle],
                                                field[behind >= 0 ? behind : particle]);
    return fw_vec2_scale(1.0 / sides, difference);
}

/* White is half a step ahead. It carries half of its own velocity's way and half of its black
 * neighbours', so that the momentum is sum m V / 4 over all cells:
 *     [V + m^-1 1/2 sum B V_black] / 4 = V/2 + m^-1 sum B (V_black - V) / 8. */
static fw_vec2 white_advance(const fw_automaton *body, const fw_vec2 *velocity, int particle)
{
    const fw_vec2 own = velocity[particle];
    fw_vec2 sum = {0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int black = beyond(body, particle, d);
        if (black < 0) continue;
        const fw_sym2 pull = fw_automaton_cell_matrix(body, FW_WHITE, body->cell[particle], d);
        sum = fw_vec2_add(sum, fw_sym2_apply(pull, fw_vec2_subtract(velocity[black], own)));
    }
    const fw_sym2 inverse = fw_automaton_cell_inverse_mass(body, FW_WHITE, body->cell[particle]);
    return fw_vec2_add(fw_vec2_scale(0.5, own), fw_vec2_scale(0.125, fw_sym2_apply(inverse, sum)));
}

/* In a uniform strain black and white rest at an offset of (P d/dx + Q d/dy) u / 2 (Eq 21). */
static fw_vec2 white_offset(const fw_automaton *body, const fw_vec2 *displacement, int particle)
{
    const fw_sym2 *b = body->matrices.bond;
    const fw_sym2 p = fw_sym2_add(b[FW_EAST], fw_sym2_scale(-1, b[FW_WEST]));
    const fw_sym2 q = fw_sym2_add(b[FW_NORTH], fw_sym2_scale(-1, b[FW_SOUTH]));
    const fw_vec2 east = slope(body, displacement, particle, FW_EAST);
    const fw_vec2 north = slope(body, displacement, particle, FW_NORTH);
    return fw_vec2_scale(-0.5, fw_vec2_add(fw_sym2_apply(p, east), fw_sym2_apply(q, north)));
}

/* Offsets of a displacement that is not uniform, or of a rim, do not add up to nothing. The body
 * as a whole is not to move because of that. */
static void take_out_spurious_momentum(fw_automaton *body)
{
    fw_automaton_colour *white = &body->colour[FW_WHITE];
    const fw_vec2 momentum = fw_automaton_momentum(&body->head);
    /* White has half of all mass, in units of which a shift by s is a velocity of 2 s. */
    const fw_sym2 inverse = fw_sym2_invert(fw_automaton_mass(&body->head));
    const fw_vec2 shift = fw_vec2_scale(-0.5, fw_sym2_apply(inverse, momentum));
    for (int n = 0; n < white->count; ++n) {
        white->x[n] += shift.x;
        white->y[n] += shift.y;
    }
}

void fw_automaton_start(fw_automaton *body, const fw_elastic_automaton_def *def)
{
    fw_solid *head = &body->head;
    for (int p = 0; p < head->count; ++p) {
        fw_automaton_colour *colour = &body->colour[body->white[p]];
        fw_vec2 u = value_at(def->displacement, p);
        if (def->displacement && !def->displaced_as_given && body->white[p])
            u = fw_vec2_add(u, white_offset(body, def->displacement, p));
        colour->x[body->cell[p]] = u.x;
        colour->y[body->cell[p]] = u.y;
    }
    if (def->displacement && !def->displaced_as_given) take_out_spurious_momentum(body);
    for (int p = 0; p < head->count; ++p) {
        fw_automaton_colour *colour = &body->colour[body->white[p]];
        const int cell = body->cell[p];
        if (def->velocity && body->white[p]) {
            const fw_vec2 ahead = white_advance(body, def->velocity, p);
            colour->x[cell] += ahead.x;
            colour->y[cell] += ahead.y;
        }
        head->x[p] += colour->x[cell];
        head->y[p] += colour->y[cell];
    }
}
