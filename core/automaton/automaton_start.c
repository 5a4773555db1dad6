/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_start.c - displacements of both colours for a body that starts displaced by u and
 * moving at V. Keeps no state. Start reading at fw_automaton_start(). */
#include "automaton_body.h"

/* The particle beyond a bond, or -1. */
static int beyond(const fw_automaton *body, int particle, int direction)
{
    double weight;
    const int colour = body->white[particle];
    const int partner =
        fw_automaton_cell_neighbour(body, colour, body->cell[particle], direction, &weight);
    return partner < 0 ? -1 : body->colour[!colour].particle[partner];
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

/* A body rests if it would run back the way it came: white, which moved last, has then not moved.
 * It lies at the weighted mean of its black neighbours, w = m^-1 1/2 sum B b, and the body has
 * neither kinetic energy nor momentum, whatever its shape and its displacement. In a uniform strain
 * that is the offset -(P d/dx + Q d/dy) b / 2 of Eq 21. */
static fw_vec2 mean_place(const fw_automaton *body, int cell)
{
    const fw_vec2 pull = fw_automaton_cell_pull(body, FW_WHITE, cell);
    const fw_sym2 inverse = fw_automaton_cell_inverse_mass(body, FW_WHITE, cell);
    return fw_vec2_add(fw_automaton_at(&body->colour[FW_WHITE], cell),
                       fw_vec2_scale(0.5, fw_sym2_apply(inverse, pull)));
}

void fw_automaton_start(fw_automaton *body, const fw_elastic_automaton_def *def)
{
    fw_solid *head = &body->head; /* displacements are zero as yet */
    fw_automaton_colour *white = &body->colour[FW_WHITE];
    for (int p = 0; def->displacement && p < head->count; ++p) {
        const fw_vec2 u = def->displacement[p];
        body->colour[body->white[p]].x[body->cell[p]] = u.x;
        body->colour[body->white[p]].y[body->cell[p]] = u.y;
    }
    for (int n = 0; n < white->count; ++n) {
        fw_vec2 u = fw_automaton_at(white, n);
        if (def->displacement && !def->displaced_as_given) u = mean_place(body, n);
        u = fw_vec2_add(u, def->velocity ? white_advance(body, def->velocity, white->particle[n])
                                         : fw_vec2_scale(0.5, def->drift));
        white->x[n] = u.x;
        white->y[n] = u.y;
    }
    fw_automaton_place(head);
}
