/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacements.c - the displacement form of the LB solid: exactly its populations, as long as
 * no hidden mode is excited, in a quarter of the memory traffic.
 *
 * Let every field be f_{i+2}(l) = (x_m(t) - x_l(t-1))/2 and f_0 = M0 (x_l(t) - x_l(t-1))/2, as they
 * are at the start with x(0) = u + V/2, x(-1) = u - V/2. The step sends f -> w - f to the other end
 * of the link; there it is w_l - (x_m(t) - x_l(t-1))/2, and that is (x_l(t+1) - x_m(t))/2 with
 *     x_l(t+1) = x_l(t-1) + 2 w_l                                                       (1)
 * for whatever w, be it free or held. So the fields keep their form, and Psi = M0 f_0 + sum f is
 * M (x(t) - x(t-1)) + L x(t)/2, where L x = sum_links (x_m - x_l). With w = mu M^-1 (Psi + F/2)
 *     x(t+1) = x(t) + (2 mu - 1)(x(t) - x(t-1)) + mu M^-1 (L x(t) + F(t)),              (2)
 * which is the leapfrog scheme. The stretch of a link is u_m - u_l, u(t) = (x(t) + x(t-1))/2.
 *
 * State: x(t) and x(t-1), and what is common to all of them. Start reading at
 * lb_displacements_advance(). */
#include "lb_displacements.h"

#include "core/row_front.h"
#include "lb_reach.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* A body of so many particles is not worth a second thread. */
enum { ALONE = 16384 };

/* Displacements are kept below FAR, at every tick that is a multiple of COMMON_EVERY. */
enum { FAR = 2, COMMON_EVERY = LB_DEPTH };

/* Bytes of the nearest large cache that the rows of a sweep may take. */
enum { CACHE = 1 << 20 };

/* --- making --- */

static bool same(fw_sym2 a, fw_sym2 b)
{
    return a.xx == b.xx && a.xy == b.xy && a.yy == b.yy;
}

/* The mass of the first particle with four links is the one of plain runs. */
static void mark_plain(lb_solid *lb, uint8_t *plain)
{
    displacement_form *form = &lb->form;
    int first = -1;
    for (int l = 0; l < lb->head.count; ++l) {
        if (lb->present[l] != LB_ALL_LINKS) continue;
        if (first < 0) first = l;
        plain[l] = lb->counted || same(lb_inverse_of(lb, l), lb_inverse_of(lb, first));
    }
    if (first < 0) return;
    form->plain_inverse = lb_inverse_of(lb, first);
    form->plain_mobility = fw_sym2_scale(lb->mu, form->plain_inverse);
    form->plain_mass = lb_mass_of(lb, first);
}

static fw_status allocate(lb_solid *lb, fw_error *error)
{
    displacement_form *form = &lb->form;
    lb_grid *grid = &form->grid;
    fw_arena *arena = &form->arena;
    const size_t places = (size_t)grid->place_count, count = (size_t)lb->head.count;
    const size_t rows = (size_t)grid->row_count;
    for (int half = 0; half < 2; ++half) {
        FW_ARENA_ADD(arena, form->x[half], places);
        FW_ARENA_ADD(arena, form->y[half], places);
    }
    FW_ARENA_ADD(arena, form->force_x, places);
    FW_ARENA_ADD(arena, form->force_y, places);
    if (!lb->counted) lb_add_matrices(arena, &form->mobility, places, lb->matrix);
    if (!lb->counted && lb->mu < 1) lb_add_matrices(arena, &form->mass, places, lb->matrix);
    FW_ARENA_ADD(arena, form->site_x, count);
    FW_ARENA_ADD(arena, form->site_y, count);
    FW_ARENA_ADD(arena, form->passed, rows * LB_DEPTH);
    FW_ARENA_ADD(arena, grid->rows, rows + 1);
    FW_ARENA_ADD(arena, grid->runs, (size_t)grid->run_count);
    FW_ARENA_ADD(arena, grid->stretches, (size_t)grid->stretch_count);
    FW_ARENA_ADD(arena, grid->place, count);
    FW_ARENA_ADD(arena, grid->links, places / LB_BLOCK);
    lb_reach_allocate(lb);
    return fw_arena_allocate(arena, "the displacements of an LB solid", error);
}

fw_status lb_displacements_make(lb_solid *lb, const fw_sites *sites, fw_error *error)
{
    displacement_form *form = &lb->form;
    uint8_t *plain = calloc((size_t)sites->count, sizeof *plain);
    if (!plain) return fw_fail_memory(error, "the grid of an LB solid");
    mark_plain(lb, plain);
    const lb_grid_def def = {.sites = sites, .present = lb->present, .plain = plain};
    lb_grid_measure(&form->grid, &def);
    const fw_status status = allocate(lb, error);
    if (status == FW_OK) lb_grid_fill(&form->grid, &def);
    free(plain);
    FW_TRY(status);
    for (int l = 0; l < sites->count && !lb->counted; ++l) {
        const int place = form->grid.place[l];
        lb_put(&form->mobility, place, fw_sym2_scale(lb->mu, lb_inverse_of(lb, l)));
        if (lb->mu < 1) lb_put(&form->mass, place, lb_mass_of(lb, l));
    }
    lb_reach_begin(lb);
    return FW_OK;
}

void lb_displacements_release(lb_solid *lb)
{
    fw_arena_release(&lb->form.arena);
    free(lb->form.kept);
}

void lb_displacements_start(lb_solid *lb, int first, int count, const fw_vec2 *sites,
                            const fw_lb_solid_def *def)
{
    const displacement_form *form = &lb->form;
    double *ahead_x = form->x[lb->parity], *ahead_y = form->y[lb->parity];
    double *behind_x = form->x[!lb->parity], *behind_y = form->y[!lb->parity];
    const int *place = form->grid.place + first;
    for (int k = 0; k < count; ++k) {
        form->site_x[first + k] = sites[k].x;
        form->site_y[first + k] = sites[k].y;
    }
    for (int k = 0; k < count; ++k) {
        const fw_vec2 u = lb_start_displacement(def, first + k);
        const fw_vec2 velocity = lb_start_velocity(def, first + k);
        ahead_x[place[k]] = u.x + 0.5 * velocity.x;
        ahead_y[place[k]] = u.y + 0.5 * velocity.y;
        behind_x[place[k]] = u.x - 0.5 * velocity.x;
        behind_y[place[k]] = u.y - 0.5 * velocity.y;
    }
}

void lb_displacements_state(lb_solid *lb, fw_state_list *list)
{
    displacement_form *form = &lb->form;
    const size_t places = (size_t)form->grid.place_count;
    fw_state_list_add(list, "displacement-common", FW_F64, 2, &form->common);
    fw_state_list_add(list, "displacement-0-x", FW_F64, places, form->x[0]);
    fw_state_list_add(list, "displacement-0-y", FW_F64, places, form->y[0]);
    fw_state_list_add(list, "displacement-1-x", FW_F64, places, form->x[1]);
    fw_state_list_add(list, "displacement-1-y", FW_F64, places, form->y[1]);
}

/* --- a row in a step --- */

static lb_grid_arrays arrays_of(const lb_solid *lb, int parity, bool loaded)
{
    const displacement_form *form = &lb->form;
    return (lb_grid_arrays){
        .ahead_x = form->x[parity],
        .ahead_y = form->y[parity],
        .behind_x = form->x[!parity],
        .behind_y = form->y[!parity],
        .force_x = loaded ? form->force_x : NULL,
        .force_y = loaded ? form->force_y : NULL,
        .mobility_xx = form->mobility.xx,
        .mobility_xy = form->mobility.xy,
        .mobility_yy = form->mobility.yy,
        .mass_xx = form->mass.xx,
        .mass_xy = form->mass.xy,
        .mass_yy = form->mass.yy,
        .links = (const uint8_t(*)[FW_DIRECTIONS])form->grid.links,
        .plain_mobility = form->plain_mobility,
        .plain_mass = form->plain_mass,
        .rest_square = lb->rest_square,
        .mu = lb->mu,
    };
}

static void load_row(lb_solid *lb, int row)
{
    displacement_form *form = &lb->form;
    const lb_row *rows = form->grid.rows;
    for (int n = rows[row].stretch; n < rows[row + 1].stretch; ++n) {
        const lb_stretch s = form->grid.stretches[n];
        const size_t bytes = (size_t)s.count * sizeof(double);
        memcpy(form->force_x + s.place, lb->head.external_x + s.particle, bytes);
        memcpy(form->force_y + s.place, lb->head.external_y + s.particle, bytes);
    }
}

static void advance_row(const lb_solid *lb, const lb_grid_arrays *arrays, int row,
                        fw_solid_ledger *passed)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_row *here = &grid->rows[row];
    FW_KERNELS_CHOSEN(lb_displacements)
        ->advance(arrays, grid->runs + here->run, here[1].run - here->run, here->north, here->south,
                  passed);
}

lb_grid_arrays lb_displacements_arrays(const lb_solid *lb)
{
    return arrays_of(lb, lb->parity, false);
}

void lb_displacements_add_squares(const lb_solid *lb, int row, int place, int count,
                                  fw_vec2 velocity, double weight, double *sums)
{
    const lb_grid_arrays arrays = arrays_of(lb, lb->parity, false);
    const lb_row *here = &lb->form.grid.rows[row];
    FW_KERNELS_CHOSEN(lb_displacements)
        ->add_squares(&arrays, place, count, here->north, here->south, velocity, weight, sums);
}

/* Row by row, whoever advanced it, and step by step. */
static void add_passed(lb_solid *lb, int steps)
{
    const int rows = lb->form.grid.row_count;
    if (!lb->head.loaded && lb->mu == 1) return;
    for (int n = 0; n < steps * rows; ++n)
        fw_solid_ledger_add(&lb->head.ledger, &lb->form.passed[n]);
}

static void load_rows(lb_solid *lb)
{
    if (!lb->head.loaded) return;
    for (int row = 0; row < lb->form.grid.row_count; ++row) load_row(lb, row);
}

/* --- positions --- */

lb_particle_arrays lb_displacements_particles(const lb_solid *lb)
{
    const displacement_form *form = &lb->form;
    return (lb_particle_arrays){.site_x = form->site_x,
                                .site_y = form->site_y,
                                .mass = lb->mass.xx,
                                .inverse = lb->inverse.xx,
                                .plain = lb->counted || !lb->resting, /* same rest masses */
                                .plain_mass = form->plain_mass.xx,
                                .plain_inverse = form->plain_inverse.xx,
                                .common = form->common};
}

void lb_displacements_place(lb_solid *lb)
{
    const displacement_form *form = &lb->form;
    const lb_grid_arrays arrays = lb_displacements_arrays(lb);
    const lb_particle_arrays particles = lb_displacements_particles(lb);
#pragma omp parallel for schedule(static) if (lb->head.count > ALONE)
    for (int n = 0; n < form->grid.stretch_count; ++n) {
        const lb_stretch s = form->grid.stretches[n];
        FW_KERNELS_CHOSEN(lb_looks)->positions(&arrays, &particles, s, lb->head.x + s.particle,
                                               lb->head.y + s.particle);
    }
}

fw_vec2 lb_displacements_position(const lb_solid *lb, int l)
{
    const displacement_form *form = &lb->form;
    const int at = form->grid.place[l];
    return (fw_vec2){form->site_x[l] + (form->common.x + 0.5 * (form->x[0][at] + form->x[1][at])),
                     form->site_y[l] + (form->common.y + 0.5 * (form->y[0][at] + form->y[1][at]))};
}

void lb_displacements_place_boundary(lb_solid *lb)
{
    for (int n = 0; n < lb->head.boundary_count; ++n) {
        const int l = lb->head.boundary[n];
        const fw_vec2 at = lb_displacements_position(lb, l);
        lb->head.x[l] = at.x;
        lb->head.y[l] = at.y;
    }
}

/* Takes whole units of length out of all displacements, so that those of a body that has moved
 * far are rounded no more than its deformation needs. Always at the same ticks: it must not matter
 * how many are taken at once. */
static void take_out_common(lb_solid *lb)
{
    displacement_form *form = &lb->form;
    if (lb->head.ticks % COMMON_EVERY != 0) return;
    const int first = form->grid.place[0];
    const fw_vec2 now = {form->x[lb->parity][first], form->y[lb->parity][first]};
    if (!(fabs(now.x) > FAR || fabs(now.y) > FAR)) return;
    const fw_vec2 common = {rint(now.x), rint(now.y)};
    form->common = fw_vec2_add(form->common, common);
    for (int n = 0; n < form->grid.stretch_count; ++n) {
        const lb_stretch s = form->grid.stretches[n];
        for (int half = 0; half < 2; ++half)
            for (int at = s.place; at < s.place + s.count; ++at) {
                form->x[half][at] -= common.x;
                form->y[half][at] -= common.y;
            }
    }
}

/* --- what a tick would bring --- */

static fw_vec2 half_at(const displacement_form *form, int half, int place)
{
    return (fw_vec2){form->x[half][place], form->y[half][place]};
}

/* w = mu [V + M^-1 (L x + F)/2]; the particle's own momentum is M0^2 V/2 + sum (V_l + V_m)/4. */
fw_prediction lb_displacements_predict(const lb_solid *lb, int l)
{
    const displacement_form *form = &lb->form;
    const int here = form->grid.place[l], ahead = lb->parity, behind = !lb->parity;
    const fw_vec2 x = half_at(form, ahead, here);
    const fw_vec2 v = fw_vec2_subtract(x, half_at(form, behind, here));
    const fw_sym2 mobility = fw_sym2_scale(lb->mu, lb_inverse_of(lb, l));
    fw_vec2 pull = {0, 0}, momentum = {0, 0};
    if (lb->head.loaded) pull = (fw_vec2){lb->head.external_x[l], lb->head.external_y[l]};
    if (lb->resting) {
        const fw_sym2 m = lb_get(&lb->rest_mass, l);
        momentum = fw_sym2_apply(m, fw_sym2_apply(m, fw_vec2_scale(0.5, v)));
    }
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        const int there = form->grid.place[lb_neighbour(lb, l, d)];
        const fw_vec2 beside = half_at(form, ahead, there);
        const fw_vec2 its = fw_vec2_subtract(beside, half_at(form, behind, there));
        pull = fw_vec2_add(pull, fw_vec2_subtract(beside, x));
        momentum = fw_vec2_add(momentum, fw_vec2_scale(0.25, fw_vec2_add(v, its)));
    }
    const fw_vec2 change = fw_vec2_scale(0.5, fw_sym2_apply(mobility, pull));
    return (fw_prediction){.displacement = fw_vec2_add(fw_vec2_scale(lb->mu, v), change),
                           .mobility = fw_sym2_scale(0.5, mobility),
                           .inertial = fw_sym2_apply(mobility, momentum)};
}

/* --- one tick, in which particles may be held --- */

static fw_status keep(lb_solid *lb, const fw_constraint *constraints, int count, fw_error *error)
{
    displacement_form *form = &lb->form;
    if (count > form->kept_capacity) {
        fw_vec2 *more = realloc(form->kept, (size_t)count * sizeof *more);
        if (!more) return fw_fail_memory(error, "the constraints of an LB solid");
        form->kept = more;
        form->kept_capacity = count;
    }
    for (int n = 0; n < count; ++n) {
        const int place = form->grid.place[constraints[n].particle];
        form->kept[n] = (fw_vec2){form->x[!lb->parity][place], form->y[!lb->parity][place]};
    }
    return FW_OK;
}

/* What a displacement w brings into the ledger beyond another one. */
static void add_difference(lb_solid *lb, int l, fw_vec2 w, fw_vec2 other)
{
    fw_solid_ledger *ledger = &lb->head.ledger;
    if (lb->head.loaded) {
        const fw_vec2 force = {lb->head.external_x[l], lb->head.external_y[l]};
        ledger->work += fw_vec2_dot(force, fw_vec2_subtract(w, other));
    }
    if (lb->mu < 1) {
        const fw_sym2 drag = fw_sym2_scale(2 * (1 / lb->mu - 1), lb_mass_of(lb, l));
        ledger->dissipated += fw_sym2_form(w, drag, w) - fw_sym2_form(other, drag, other);
        ledger->drag =
            fw_vec2_subtract(ledger->drag, fw_sym2_apply(drag, fw_vec2_subtract(w, other)));
    }
}

/* (1): exactly the old u where w is zero. The kernel has moved the particle freely. */
static void hold(lb_solid *lb, const fw_constraint *constraint, fw_vec2 kept)
{
    displacement_form *form = &lb->form;
    const int l = constraint->particle, place = form->grid.place[l];
    double *x = &form->x[!lb->parity][place], *y = &form->y[!lb->parity][place];
    const fw_vec2 w = constraint->displacement;
    add_difference(lb, l, w, (fw_vec2){0.5 * (*x - kept.x), 0.5 * (*y - kept.y)});
    *x = kept.x + 2 * w.x;
    *y = kept.y + 2 * w.y;
}

fw_status lb_displacements_advance(lb_solid *lb, const fw_constraint *constraints, int count,
                                   fw_error *error)
{
    displacement_form *form = &lb->form;
    const lb_grid_arrays arrays = arrays_of(lb, lb->parity, lb->head.loaded);
    take_out_common(lb);
    FW_TRY(keep(lb, constraints, count, error));
#pragma omp parallel for schedule(static) if (lb->head.count > ALONE)
    for (int row = 0; row < form->grid.row_count; ++row) {
        if (lb->head.loaded) load_row(lb, row);
        advance_row(lb, &arrays, row, &form->passed[row]);
    }
    add_passed(lb, 1);
    for (int n = 0; n < count; ++n) hold(lb, &constraints[n], form->kept[n]);
    lb->parity = !lb->parity;
    lb->head.ticks += 1;
    lb_displacements_place_boundary(lb);
    return FW_OK;
}

/* --- many ticks --- */

/* In even steps, in odd ones. */
typedef struct front {
    lb_solid *lb;
    lb_grid_arrays arrays[2];
} front;

/* x(t-1) of the row is overwritten. */
static void sweep_row(void *context, int step, int row)
{
    const front *f = context;
    const displacement_form *form = &f->lb->form;
    advance_row(f->lb, &f->arrays[step % 2], row,
                &form->passed[(size_t)step * (size_t)form->grid.row_count + (size_t)row]);
}

static void sweep(lb_solid *lb, int steps)
{
    const int rows = lb->form.grid.row_count;
    const int threads = lb->head.count > ALONE ? omp_get_max_threads() : 1;
    front f = {.lb = lb,
               .arrays = {arrays_of(lb, lb->parity, lb->head.loaded),
                          arrays_of(lb, !lb->parity, lb->head.loaded)}};
    fw_row_front_run(rows, steps, fw_row_front_strips(rows, steps, threads), sweep_row, &f);
    add_passed(lb, steps);
    lb->parity = (lb->parity + steps) % 2;
    lb->head.ticks += steps;
}

void lb_displacements_advance_free(lb_solid *lb, int ticks)
{
    const int row_bytes = 4 * (int)sizeof(double) * lb->form.grid.longest;
    const int fitting = CACHE / row_bytes;
    const int depth = fitting < 1 ? 1 : fitting > LB_DEPTH ? LB_DEPTH : fitting;
    load_rows(lb);
    for (int left = ticks, steps; left > 0; left -= steps) {
        const int aligned = COMMON_EVERY - (int)(lb->head.ticks % COMMON_EVERY);
        steps = left < depth ? left : depth;
        if (steps > aligned) steps = aligned;
        take_out_common(lb);
        sweep(lb, steps);
    }
}
