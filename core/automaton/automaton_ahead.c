/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_ahead.c - a whole step of cells before its first half: where those of the resting
 * colour will go, and how that hangs on the cells that move now. Keeps no state. Start reading at
 * fw_automaton_predict_step().
 *
 * With d_b the displacements of the neighbours in this half-step, a resting cell moves by
 *     d_w = (1 + a)/2 m^-1 [sum B (b + d_b - w) + F]
 * in the next one (Dong Eq 3), so that d_w grows by (1 + a)/2 m^-1 B times what d_b does. */
#include "automaton_sweep.h"

static fw_prediction predict_now(const fw_half_step *now, int cell)
{
    const fw_automaton *body = now->body;
    return fw_half_step_predict(now, body->colour[now->colour].particle[cell],
                                fw_automaton_cell_pull(body, now->colour, cell));
}

static fw_prediction predict_later(const fw_half_step *now, const fw_half_step *later, int cell)
{
    const fw_automaton *body = now->body;
    fw_vec2 pull = fw_automaton_cell_pull(body, later->colour, cell);
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        double weight;
        const int neighbour = fw_automaton_cell_neighbour(body, later->colour, cell, d, &weight);
        if (neighbour < 0) continue;
        const fw_sym2 b = fw_automaton_cell_matrix(body, later->colour, cell, d);
        pull = fw_vec2_add(pull, fw_sym2_apply(b, predict_now(now, neighbour).displacement));
    }
    fw_prediction out =
        fw_half_step_predict(later, body->colour[later->colour].particle[cell], pull);
    out.later = true;
    return out;
}

void fw_automaton_predict_step(const fw_solid *solid, const int *particles, int count,
                               fw_prediction *out)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const int moving = fw_automaton_moving(body);
    const fw_half_step now = fw_half_step_of(body, moving), later = fw_half_step_of(body, !moving);
    for (int n = 0; n < count; ++n) {
        const int cell = body->cell[particles[n]];
        out[n] = body->white[particles[n]] == moving ? predict_now(&now, cell)
                                                     : predict_later(&now, &later, cell);
    }
}

int fw_automaton_partners(const fw_solid *solid, int particle, fw_partner partners[FW_PARTNERS])
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const int colour = body->white[particle], cell = body->cell[particle];
    const fw_sym2 inverse = fw_automaton_cell_inverse_mass(body, colour, cell);
    const double share = (1 + body->reflection) / 2;
    int count = 0;
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        double weight;
        const int neighbour = fw_automaton_cell_neighbour(body, colour, cell, d, &weight);
        if (neighbour < 0) continue;
        const fw_sym2 b = fw_automaton_cell_matrix(body, colour, cell, d);
        partners[count++] = (fw_partner){
            .particle = body->colour[!colour].particle[neighbour],
            .x = fw_vec2_scale(share, fw_sym2_apply(b, (fw_vec2){inverse.xx, inverse.xy})),
            .y = fw_vec2_scale(share, fw_sym2_apply(b, (fw_vec2){inverse.xy, inverse.yy}))};
    }
    return count;
}
