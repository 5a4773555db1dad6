/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_sums.c - energies, momentum and mass of an LB solid, by particles in a fixed order. State:
 * what was summed for the present fields. Start reading at sums_of(). */
#include "lb_sums.h"

#include "lb_displacements.h"

#include <math.h>

/* Row-sized partial sums keep the rounding of large bodies small. */
enum { BLOCK = LB_TERMS_MAX - 2 * LB_BLOCK };

/* --- from populations --- */

/* Of a particle's links to the east and north, and of its rest field. */
static void add_energies(const lb_solid *lb, int l, fw_energies *sum)
{
    for (int d = FW_EAST; d <= FW_NORTH; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        const fw_vec2 here = lb_field(lb, l, d);
        const fw_vec2 there = lb_field(lb, lb_neighbour(lb, l, d), fw_opposite(d));
        const fw_vec2 stretch = fw_vec2_subtract(here, there), both = fw_vec2_add(here, there);
        const fw_sym2 kappa = lb_stiffness(lb, l, d);
        sum->elastic += 0.5 * fw_sym2_form(stretch, kappa, stretch);
        sum->kinetic += 0.5 * fw_sym2_form(both, kappa, both);
    }
    const fw_vec2 rest = lb_rest(lb, l);
    sum->kinetic += fw_vec2_dot(rest, rest);
}

static void sum_populations(const lb_solid *lb, lb_sums *sums)
{
    for (int begin = 0; begin < lb->head.count; begin += BLOCK) {
        const int end = begin + BLOCK < lb->head.count ? begin + BLOCK : lb->head.count;
        fw_energies block = {0, 0};
        for (int l = begin; l < end; ++l) {
            add_energies(lb, l, &block);
            sums->momentum = fw_vec2_add(sums->momentum, lb_psi(lb, l));
        }
        sums->energies.elastic += block.elastic;
        sums->energies.kinetic += block.kinetic;
    }
}

/* --- from displacements: the same terms in the same order --- */

/* Of particles at consecutive places, from that place on; `from` is that of the first term. */
static void add_terms(const lb_solid *lb, const lb_field_terms *terms, int from, int particle,
                      int count, fw_energies *block, fw_vec2 *momentum)
{
    fw_energies sum = *block;
    fw_vec2 psi = *momentum;
    for (int k = 0; k < count; ++k) {
        const int t = from + k;
        fw_vec2 here = {terms->psi_x[t], terms->psi_y[t]};
        sum.elastic += terms->elastic[FW_EAST][t];
        sum.elastic += terms->elastic[FW_NORTH][t];
        sum.kinetic += terms->kinetic[FW_EAST][t];
        sum.kinetic += terms->kinetic[FW_NORTH][t];
        if (lb->resting) {
            const fw_vec2 rest = lb_rest(lb, particle + k);
            sum.kinetic += fw_vec2_dot(rest, rest);
            here = fw_vec2_add(here, fw_sym2_apply(lb_get(&lb->rest_mass, particle + k), rest));
        }
        psi = fw_vec2_add(psi, here);
    }
    *block = sum;
    *momentum = psi;
}

static void sum_displacements(const lb_solid *lb, lb_sums *sums)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_grid_arrays arrays = lb_displacements_arrays(lb);
    fw_energies block = {0, 0};
    lb_field_terms terms;
    for (int row = 0; row < grid->row_count; ++row)
        for (int n = grid->rows[row].stretch; n < grid->rows[row + 1].stretch; ++n) {
            const lb_stretch s = grid->stretches[n];
            for (int k = 0, count; k < s.count; k += count) {
                const int particle = s.particle + k, room = BLOCK - particle % BLOCK;
                const int place = s.place + k, from = place % LB_BLOCK;
                count = s.count - k < room ? s.count - k : room;
                FW_KERNELS_CHOSEN(lb_looks)->terms(&arrays, place - from, from + count,
                                                   grid->rows[row].north, grid->rows[row].south,
                                                   &terms);
                add_terms(lb, &terms, from, particle, count, &block, &sums->momentum);
                if (count < room && particle + count < lb->head.count) continue;
                sums->energies.elastic += block.elastic;
                sums->energies.kinetic += block.kinetic;
                block = (fw_energies){0, 0};
            }
        }
}

static const lb_sums *sums_of(const lb_solid *lb)
{
    lb_sums *sums = lb->sums;
    if (sums->known && sums->ticks == lb->head.ticks) return sums;
    sums->known = true;
    sums->ticks = lb->head.ticks;
    sums->energies = (fw_energies){0, 0};
    sums->momentum = (fw_vec2){0, 0};
    if (lb->displaced)
        sum_displacements(lb, sums);
    else
        sum_populations(lb, sums);
    return sums;
}

fw_energies lb_energies(const fw_solid *solid)
{
    return sums_of((const lb_solid *)solid)->energies;
}

fw_vec2 lb_momentum(const fw_solid *solid)
{
    return sums_of((const lb_solid *)solid)->momentum;
}

static fw_sym2 summed_mass(const lb_solid *lb)
{
    fw_sym2 sum = {0, 0, 0};
    for (int l = 0; l < lb->head.count; ++l) sum = fw_sym2_add(sum, lb_mass_of(lb, l));
    return sum;
}

/* Only breaking changes it. */
fw_sym2 lb_mass(const fw_solid *solid)
{
    const lb_solid *lb = (const lb_solid *)solid;
    if (isfinite(lb->break_at)) return summed_mass(lb);
    if (!lb->sums->mass_known) lb->sums->mass = summed_mass(lb);
    lb->sums->mass_known = true;
    return lb->sums->mass;
}
