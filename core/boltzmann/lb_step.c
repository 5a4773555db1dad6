/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_step.c - one step of the LB solid (Chopard & Marconi Eqs 18-20, corrected).
 * State: see lb_state.h. Work is cut into chunks of fixed size whose sums are added in order, so
 * that the result does not depend on the number of threads. Start reading at lb_advance(). */
#include "lb_step.h"

#include "lb_displacements.h"
#include "lb_fracture.h"
#include "lb_population_kernels.h"

#include <math.h>

/* An array from an element on; NULL where there is none. */
static double *from(double *array, int element)
{
    return array ? array + element : NULL;
}

/* `count` particles of a full span from `begin` on. */
static void relax_stretch(lb_solid *lb, const span *s, int begin, int count,
                          fw_solid_ledger *ledger)
{
    const bool loaded = lb->head.loaded;
    lb_population_arrays arrays = {
        .rest_x = from(lb->rest_x, begin),
        .rest_y = from(lb->rest_y, begin),
        .x = lb->head.x + begin,
        .y = lb->head.y + begin,
        .force_x = loaded ? lb->head.external_x + begin : NULL,
        .force_y = loaded ? lb->head.external_y + begin : NULL,
        .inverse_xx = lb->inverse.xx + begin,
        .inverse_xy = from(lb->inverse.xy, begin),
        .inverse_yy = from(lb->inverse.yy, begin),
        .rest_mass_xx = from(lb->rest_mass.xx, begin),
        .rest_mass_xy = from(lb->rest_mass.xy, begin),
        .rest_mass_yy = from(lb->rest_mass.yy, begin),
        .mass_xx = lb->mass.xx + begin,
        .mass_xy = from(lb->mass.xy, begin),
        .mass_yy = from(lb->mass.yy, begin),
    };
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int slot = lb->parity == 0 ? d : fw_opposite(d);
        const int first = begin + (lb->parity == 0 ? 0 : s->offset[d]);
        arrays.field_x[d] = lb->slot_x[slot] + first;
        arrays.field_y[d] = lb->slot_y[slot] + first;
    }
    FW_KERNELS_CHOSEN(lb_populations)->relax(&arrays, count, lb->mu, ledger);
}

static fw_vec2 external_force(const lb_solid *lb, int l)
{
    if (!lb->head.loaded) return (fw_vec2){0, 0};
    return (fw_vec2){lb->head.external_x[l], lb->head.external_y[l]};
}

/* One step of iterative refinement of w = M^-1 push, with M w taken through M0 as the update takes
 * it: where M is a matrix, the rounding of M and M^-1 is the same in every step and would let the
 * energy creep by some 1e-16 each. */
static fw_vec2 refine(const lb_solid *lb, int l, fw_vec2 push, fw_vec2 w)
{
    fw_vec2 rest = {0, 0}, links = {0, 0};
    if (lb->resting) {
        fw_sym2 rest_mass = lb_get(&lb->rest_mass, l);
        rest = fw_sym2_apply(rest_mass, fw_sym2_apply(rest_mass, w));
    }
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (lb->present[l] & (1u << d))
            links = fw_vec2_add(links, fw_sym2_apply(lb_stiffness(lb, l, d), w));
    fw_vec2 left = fw_vec2_subtract(push, fw_vec2_scale(0.5, fw_vec2_add(rest, links)));
    return fw_vec2_add(w, fw_sym2_apply(lb_get(&lb->inverse, l), left));
}

static fw_vec2 free_displacement(const lb_solid *lb, int l)
{
    fw_vec2 push = fw_vec2_add(lb_psi(lb, l), fw_vec2_scale(0.5, external_force(lb, l)));
    fw_vec2 w = fw_sym2_apply(lb_get(&lb->inverse, l), push);
    if (lb->matrix) w = refine(lb, l, push, w);
    return fw_vec2_scale(lb->mu, w);
}

/* Any particle: edges, weighted links, and those whose displacement w contact has decided. */
static void relax_one(lb_solid *lb, int l, fw_vec2 w, fw_solid_ledger *ledger)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        slot_place slot = lb_slot(lb, l, d);
        *slot.x = w.x - *slot.x;
        *slot.y = w.y - *slot.y;
    }
    if (lb->resting) {
        fw_vec2 rest = fw_sym2_apply(lb_get(&lb->rest_mass, l), w);
        lb->rest_x[l] = rest.x - lb->rest_x[l];
        lb->rest_y[l] = rest.y - lb->rest_y[l];
    }
    lb->head.x[l] += w.x;
    lb->head.y[l] += w.y;
    if (lb->head.loaded) {
        fw_vec2 force = external_force(lb, l);
        ledger->work += fw_vec2_dot(force, w);
        ledger->impulse = fw_vec2_add(ledger->impulse, force);
    }
    if (lb->mu < 1) {
        /* dE = F.w - 2(1/mu - 1) w.Mw, dPsi = F - 2(1/mu - 1) Mw */
        double loss = 2 * (1 / lb->mu - 1);
        fw_vec2 push = fw_vec2_scale(loss, fw_sym2_apply(lb_get(&lb->mass, l), w));
        ledger->dissipated += fw_vec2_dot(push, w);
        ledger->drag = fw_vec2_subtract(ledger->drag, push);
    }
}

static void relax_span(lb_solid *lb, const span *s, int begin, int end, fw_solid_ledger *ledger)
{
    if (s->full)
        relax_stretch(lb, s, begin, end - begin, ledger);
    else
        for (int l = begin; l < end; ++l) relax_one(lb, l, free_displacement(lb, l), ledger);
}

/* First constraint at or after a particle. */
static int find_constraint(const fw_constraint *constraints, int count, int particle)
{
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (constraints[middle].particle < particle)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void relax_chunk(lb_solid *lb, int chunk, const fw_constraint *constraints,
                        int constraint_count)
{
    fw_solid_ledger *ledger = &lb->chunk_ledger[chunk];
    *ledger = (fw_solid_ledger){0};
    int next = find_constraint(constraints, constraint_count, chunk * LB_CHUNK);
    for (int n = lb->chunk_span[chunk]; n < lb->chunk_span[chunk + 1]; ++n) {
        const span *s = &lb->spans[n];
        int begin = s->begin;
        for (; next < constraint_count && constraints[next].particle < s->end; ++next) {
            relax_span(lb, s, begin, constraints[next].particle, ledger);
            relax_one(lb, constraints[next].particle, constraints[next].displacement, ledger);
            begin = constraints[next].particle + 1;
        }
        relax_span(lb, s, begin, s->end, ledger);
    }
}

fw_status lb_advance(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                     fw_error *error)
{
    lb_solid *lb = (lb_solid *)solid;
    if (lb->displaced) return lb_displacements_advance(lb, constraints, constraint_count, error);
#pragma omp parallel for schedule(static) if (lb->chunk_count > 4)
    for (int chunk = 0; chunk < lb->chunk_count; ++chunk)
        relax_chunk(lb, chunk, constraints, constraint_count);
    for (int chunk = 0; chunk < lb->chunk_count; ++chunk)
        fw_solid_ledger_add(&solid->ledger, &lb->chunk_ledger[chunk]);
    lb->parity = !lb->parity;
    solid->ticks += 1;
    if (lb->break_at < HUGE_VAL) lb_break_links(lb);
    return FW_OK;
}

fw_status lb_advance_free(fw_solid *solid, int ticks, fw_error *error)
{
    lb_solid *lb = (lb_solid *)solid;
    if (lb->displaced)
        lb_displacements_advance_free(lb, ticks);
    else
        for (int n = 0; n < ticks; ++n) FW_TRY(lb_advance(solid, NULL, 0, error));
    return FW_OK;
}

static fw_prediction predict_one(const lb_solid *lb, int l)
{
    if (lb->displaced) return lb_displacements_predict(lb, l);
    fw_sym2 inverse = fw_sym2_scale(lb->mu, lb_get(&lb->inverse, l));
    /* The elastic part of Psi is half the pull of the links; what is left of it, kappa times the
     * mean of each link's two fields and the rest field, is the particle's own momentum. */
    fw_vec2 momentum = {0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        fw_vec2 mean =
            fw_vec2_scale(0.5, fw_vec2_add(lb_field(lb, l, d),
                                           lb_field(lb, lb_neighbour(lb, l, d), fw_opposite(d))));
        momentum = fw_vec2_add(momentum, fw_sym2_apply(lb_stiffness(lb, l, d), mean));
    }
    if (lb->resting)
        momentum = fw_vec2_add(momentum, fw_sym2_apply(lb_get(&lb->rest_mass, l), lb_rest(lb, l)));
    return (fw_prediction){.displacement = free_displacement(lb, l),
                           .mobility = fw_sym2_scale(0.5, inverse),
                           .inertial = fw_sym2_apply(inverse, momentum)};
}

void lb_predict(const fw_solid *solid, const int *particles, int count, fw_prediction *out)
{
    const lb_solid *lb = (const lb_solid *)solid;
    for (int n = 0; n < count; ++n) out[n] = predict_one(lb, particles[n]);
}
