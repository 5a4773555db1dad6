/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_sums.c - energies and momentum of an elastic automaton, by cells in a fixed order.
 * State: what was summed for the present displacements. Start reading at sums_of(). */
#include "automaton_sweep.h"

enum { BLOCK = FW_AUTOMATON_TERMS_MAX };

/* Terms of a cell at a rim. */
static void rim_terms(const fw_automaton *body, int colour, int cell, int at,
                      fw_automaton_terms *terms)
{
    const fw_vec2 momentum = fw_automaton_bond_momentum(body, colour, cell);
    const fw_vec2 pull = fw_automaton_cell_pull(body, colour, cell);
    terms->energy[at] = fw_automaton_bond_energy(body, colour, cell);
    terms->momentum_x[at] = momentum.x;
    terms->momentum_y[at] = momentum.y;
    terms->kinetic[at] =
        fw_sym2_form(pull, fw_automaton_cell_inverse_mass(body, colour, cell), pull) / 4;
}

/* Of cells begin .. end - 1. */
static void fill_terms(const fw_automaton *body, int c, const fw_automaton_move *move, int begin,
                       int end, fw_automaton_terms *terms)
{
    const fw_automaton_colour *colour = &body->colour[c];
    for (int n = begin, count; n < end; n += count) {
        const int place = colour->place[n];
        count = 1;
        if (place >= 0) {
            rim_terms(body, c, n, n - begin, terms);
            continue;
        }
        while (n + count < end && colour->place[n + count] == place) ++count;
        const fw_automaton_span *span = &colour->span[~place];
        FW_KERNELS_CHOSEN(fw_automaton_kernels)
            ->terms(move, span->offset, n, count, n - begin, terms);
    }
}

/* What all cells of a colour add up to. */
typedef struct totals {
    double energy, kinetic;
    fw_vec2 momentum;
} totals;

static totals totals_of(const fw_automaton *body, int c)
{
    const fw_automaton_colour *colour = &body->colour[c];
    const fw_automaton_move move = fw_half_step_of(body, c).move;
    fw_automaton_terms terms;
    totals total = {0};
    for (int begin = 0; begin < colour->count; begin += BLOCK) {
        const int end = begin + BLOCK < colour->count ? begin + BLOCK : colour->count;
        totals block = {0};
        fill_terms(body, c, &move, begin, end, &terms);
        for (int k = 0; k < end - begin; ++k) {
            block.energy += terms.energy[k];
            block.kinetic += terms.kinetic[k];
            block.momentum.x += terms.momentum_x[k];
            block.momentum.y += terms.momentum_y[k];
        }
        total.energy += block.energy;
        total.kinetic += block.kinetic;
        total.momentum = fw_vec2_add(total.momentum, block.momentum);
    }
    return total;
}

/* Kinetic part: of the two colours the one that moved last is displaced from where its neighbours
 * would have it at rest, by -m^-1 s/2 with s = sum B (w - b): (m^-1 s/2).m (m^-1 s/2). What remains
 * of E is the energy of the other colour alone, the first one relaxed: elastic. */
static const fw_automaton_sums *sums_of(const fw_automaton *body)
{
    fw_automaton_sums *sums = body->sums;
    if (sums->known && sums->ticks == body->head.ticks) return sums;
    const bool white_moved = fw_automaton_moving(body) == FW_BLACK;
    const totals black = totals_of(body, FW_BLACK);
    const double kinetic = white_moved ? totals_of(body, FW_WHITE).kinetic : black.kinetic;
    const double sign = white_moved ? 1 : -1;
    sums->known = true;
    sums->ticks = body->head.ticks;
    sums->energies = (fw_energies){.kinetic = kinetic, .elastic = black.energy - kinetic};
    sums->momentum = fw_vec2_scale(sign, black.momentum);
    return sums;
}

fw_energies fw_automaton_energies(const fw_solid *solid)
{
    return sums_of(fw_automaton_of_const(solid))->energies;
}

fw_vec2 fw_automaton_momentum(const fw_solid *solid)
{
    return sums_of(fw_automaton_of_const(solid))->momentum;
}
