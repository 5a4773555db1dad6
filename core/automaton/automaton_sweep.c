/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_sweep.c - one half-step: the cells of one colour are reflected about the means
 * of their neighbours of the resting colour. Start reading at fw_automaton_advance().
 *
 * Cells gather and write only their own entry, so rows can be shared among threads and the result
 * does not depend on how many there are; what rows add to the ledger is added up in their order.
 *
 * Displacements are kept small: a body that has drifted far has its common part moved from x, y
 * into the integers `drift`. Otherwise the last bit of a displacement of 400 spacings would be all
 * that is left of the precision of the differences, on which the energy stands. */
#include "automaton_sweep.h"

#include "automaton_rim.h"

#include <math.h>

fw_half_step fw_half_step_of(const fw_automaton *body, int colour)
{
    const double a = body->reflection;
    const fw_automaton_colour *own = &body->colour[colour], *other = &body->colour[!colour];
    fw_half_step step = {.body = body,
                         .colour = colour,
                         .share_of_pull = (1 + a) / 2,
                         .loss = (1 - a) / (1 + a),
                         .kernels = FW_KERNELS_CHOSEN(fw_automaton_kernels)};
    step.move = (fw_automaton_move){.x = own->x,
                                    .y = own->y,
                                    .other_x = other->x,
                                    .other_y = other->y,
                                    .share_of_pull = step.share_of_pull,
                                    .loss = step.loss,
                                    .force_x = body->head.loaded ? body->head.external_x : NULL,
                                    .force_y = body->head.loaded ? body->head.external_y : NULL,
                                    .break_at = body->break_at,
                                    .torn = body->torn,
                                    .mirror = body->boundary == FW_BOUNDARY_MIRROR,
                                    .fetches = true};
    for (int d = 0; d < FW_DIRECTIONS; ++d) step.move.matrix[d] = *own->matrix[d];
    return step;
}

/* (1 + a)/2 m^-1, how far a unit of force moves a cell. */
static fw_sym2 mobility(const fw_half_step *step, fw_sym2 inverse_mass)
{
    return fw_sym2_scale(step->share_of_pull, inverse_mass);
}

/* Of a rim cell that is pulled by s. */
static fw_vec2 rim_displacement(const fw_half_step *step, const fw_automaton_rim *rim, fw_vec2 s)
{
    return fw_automaton_rim_displacement(rim, s, step->share_of_pull, step->move.mirror);
}

fw_prediction fw_half_step_predict(const fw_half_step *step, int particle, fw_vec2 pull)
{
    const fw_automaton *body = step->body;
    const fw_solid *head = &body->head;
    const fw_automaton_colour *colour = &body->colour[step->colour];
    const int cell = body->cell[particle];
    fw_prediction out = {.displacement = {0, 0}};
    out.mobility = mobility(step, fw_automaton_cell_inverse_mass(body, step->colour, cell));
    /* The reflection is all momentum: no part of it is an elastic force. */
    out.inertial = colour->place[cell] >= 0
                       ? rim_displacement(step, &colour->rim[colour->place[cell]], pull)
                       : fw_vec2_scale(step->share_of_pull, pull);
    out.displacement = out.inertial;
    if (!head->loaded) return out;
    const fw_vec2 force = {head->external_x[particle], head->external_y[particle]};
    out.displacement = fw_vec2_add(out.displacement, fw_sym2_apply(out.mobility, force));
    return out;
}

void fw_automaton_predict(const fw_solid *solid, const int *particles, int count,
                          fw_prediction *out)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const fw_half_step step = fw_half_step_of(body, fw_automaton_moving(body));
    for (int n = 0; n < count; ++n) {
        out[n] = (fw_prediction){.displacement = {0, 0}};
        if (body->white[particles[n]] != step.colour) continue;
        const int cell = body->cell[particles[n]];
        out[n] = fw_half_step_predict(&step, particles[n],
                                      fw_automaton_cell_pull(body, step.colour, cell));
    }
}

/* As in the kernels: notes the bonds of a cell that are too long, from the middle of its
 * displacement. */
static bool tear(const fw_half_step *step, int cell, fw_vec2 middle)
{
    const fw_automaton *body = step->body;
    bool any = false;
    for (int direction = 0; direction < FW_DIRECTIONS; ++direction) {
        double weight;
        const int partner =
            fw_automaton_cell_neighbour(body, step->colour, cell, direction, &weight);
        if (partner < 0) continue;
        const fw_vec2 stretch =
            fw_vec2_subtract(fw_automaton_at(&body->colour[!step->colour], partner), middle);
        if (!(hypot(stretch.x, stretch.y) > body->break_at)) continue;
        step->move.torn[cell] |= (uint8_t)(1 << direction);
        any = true;
    }
    return any;
}

/* Moves one cell by d, or by what its constraint says, and adds what went through its bounds to the
 * share. */
static void move(const fw_half_step *step, int cell, int particle, fw_sym2 mass,
                 fw_sym2 inverse_mass, fw_vec2 d, fw_automaton_share *share)
{
    const fw_solid *head = &step->body->head;
    const fw_automaton_colour *colour = &step->body->colour[step->colour];
    fw_vec2 force = {0, 0};
    if (head->loaded) {
        force = (fw_vec2){head->external_x[particle], head->external_y[particle]};
        d = fw_vec2_add(d, fw_sym2_apply(mobility(step, inverse_mass), force));
    }
    if (step->constraints && colour->held[cell] > 0)
        d = step->constraints[colour->held[cell] - 1].displacement;
    const fw_vec2 middle = fw_vec2_add(fw_automaton_at(colour, cell), fw_vec2_scale(0.5, d));
    colour->x[cell] += d.x;
    colour->y[cell] += d.y;
    if (step->move.torn) share->torn |= tear(step, cell, middle);
    /* dE = F.d - k d.m d, dp = F - k m d: see the header. A cell without mass takes nothing up. */
    if (head->loaded && inverse_mass.xx > 0) {
        share->work += fw_vec2_dot(force, d);
        share->impulse = fw_vec2_add(share->impulse, force);
    }
    if (step->loss > 0) {
        const fw_vec2 drag = fw_vec2_scale(-step->loss, fw_sym2_apply(mass, d));
        share->dissipated -= fw_vec2_dot(drag, d);
        share->drag = fw_vec2_add(share->drag, drag);
    }
}

/* Cell by cell, since constraints decide for some. */
static void move_held_span(const fw_half_step *step, const fw_automaton_span *span,
                           fw_automaton_share *share)
{
    for (int k = 0; k < span->count; ++k) {
        const fw_vec2 pull = fw_automaton_cell_pull(step->body, step->colour, span->begin + k);
        move(step, span->begin + k, span->particle + 2 * k, fw_sym2_scalar(1), fw_sym2_scalar(1),
             fw_vec2_scale(step->share_of_pull, pull), share);
    }
}

/* Cell by cell, where a constraint may decide, or something passes. */
static void move_busy_rim(const fw_half_step *step, const fw_automaton_rim *rim,
                          fw_automaton_share *share)
{
    const fw_automaton_colour *colour = &step->body->colour[step->colour];
    const fw_vec2 pull = fw_automaton_rim_pull(rim, fw_automaton_at(colour, rim->cell),
                                               step->move.other_x, step->move.other_y);
    const int particle = colour->particle[rim->cell];
    move(step, rim->cell, particle, rim->mass, rim->inverse_mass, rim_displacement(step, rim, pull),
         share);
}

static void move_rim(const fw_half_step *step, const fw_automaton_rim *rim, int count,
                     fw_automaton_share *share)
{
    if (!step->constraints && !fw_half_step_passes(step))
        step->kernels->move_rim(&step->move, rim, count, share);
    else
        for (int n = 0; n < count; ++n) move_busy_rim(step, &rim[n], share);
}

static void move_span(const fw_half_step *step, const fw_automaton_span *span,
                      fw_automaton_share *share)
{
    if (span->held)
        move_held_span(step, span, share);
    else
        step->kernels->move(&step->move, span, share);
}

/* What is left of a span between the gaps from *gap on. */
static void move_pieces(const fw_half_step *step, const fw_automaton_span *span,
                        const fw_automaton_gaps *gaps, int *gap, fw_automaton_share *share)
{
    const fw_automaton_rim *rim = step->body->colour[step->colour].rim;
    const int end = span->begin + span->count;
    for (int begin = span->begin; begin < end;) {
        const bool cut = *gap < gaps->count && rim[gaps->rim[*gap]].cell < end;
        const int until = cut ? rim[gaps->rim[(*gap)++]].cell : end;
        fw_automaton_span piece = *span;
        piece.begin = begin;
        piece.count = until - begin;
        piece.particle += 2 * (begin - span->begin);
        if (piece.count > 0) move_span(step, &piece, share);
        begin = until + 1;
    }
}

void fw_half_step_move_row(const fw_half_step *step, int number, fw_automaton_share *share)
{
    const fw_automaton_colour *colour = &step->body->colour[step->colour];
    const fw_automaton_row *row = &colour->row[number];
    const fw_automaton_gaps none = {0}, *gaps = colour->gaps ? &colour->gaps[number] : &none;
    *share = (fw_automaton_share){0};
    int gap = 0;
    for (int n = row[0].span; n < row[1].span; ++n) {
        if (gap < gaps->count)
            move_pieces(step, &colour->span[n], gaps, &gap, share);
        else
            move_span(step, &colour->span[n], share);
    }
    if (row[1].rim > row[0].rim)
        move_rim(step, &colour->rim[row[0].rim], row[1].rim - row[0].rim, share);
    for (int n = 0; n < gaps->count; ++n) move_rim(step, &colour->rim[gaps->rim[n]], 1, share);
}

void fw_automaton_book(fw_automaton *body, const fw_automaton_share *shares)
{
    for (int row = 0; row < body->row_count; ++row) {
        const fw_solid_ledger part = {.work = shares[row].work,
                                      .dissipated = shares[row].dissipated,
                                      .impulse = shares[row].impulse,
                                      .drag = shares[row].drag};
        fw_solid_ledger_add(&body->head.ledger, &part);
    }
}

/* Moves whole quanta of displacement into the drift, for all cells alike, once the first cell has
 * gone that far. Differences of displacements change at most in their last bit. Looked for now and
 * then only, by the ticks alone, so that it does not matter how many ticks are taken at once. */
static void recentre(fw_automaton *body)
{
    if (body->head.ticks % FW_RECENTRE_EVERY != 0) return;
    const fw_automaton_colour *black = &body->colour[FW_BLACK];
    const double first[2] = {black->x[0], black->y[0]};
    for (int axis = 0; axis < 2; ++axis) {
        const double quanta = trunc(first[axis] / body->quantum);
        if (quanta == 0 || !isfinite(quanta) || fabs(quanta) > 1e15) continue;
        body->drift[axis] += (int64_t)quanta;
        for (int c = 0; c < FW_COLOURS; ++c) {
            double *values = axis == 0 ? body->colour[c].x : body->colour[c].y;
            for (int n = 0; n < body->colour[c].count; ++n) values[n] -= quanta * body->quantum;
        }
    }
}

void fw_automaton_tick(fw_automaton *body, int ticks)
{
    body->head.ticks += ticks;
    recentre(body);
}

/* Notes which cells of the moving colour constraints decide for, or forgets it. */
static void note_constraints(fw_half_step *step, const fw_constraint *constraints, int count,
                             bool held)
{
    const fw_automaton *body = step->body;
    const fw_automaton_colour *colour = &body->colour[step->colour];
    for (int h = 0; h < count; ++h) {
        if (body->white[constraints[h].particle] != step->colour) continue;
        const int cell = body->cell[constraints[h].particle], place = colour->place[cell];
        colour->held[cell] = held ? h + 1 : 0;
        if (place < 0) colour->span[~place].held = held;
        step->constraints = constraints;
    }
}

fw_status fw_automaton_advance(fw_solid *solid, const fw_constraint *constraints,
                               int constraint_count, fw_error *error)
{
    fw_automaton *body = fw_automaton_of(solid);
    fw_half_step step = fw_half_step_of(body, fw_automaton_moving(body));
    note_constraints(&step, constraints, constraint_count, true);
#pragma omp parallel for schedule(static) if (solid->count >= FW_THREADS_FROM)
    for (int row = 0; row < body->row_count; ++row)
        fw_half_step_move_row(&step, row, &body->share[row]);
    if (fw_half_step_passes(&step)) fw_automaton_book(body, body->share);
    note_constraints(&step, constraints, constraint_count, false);
    for (int row = 0; body->breaks && row < body->row_count; ++row)
        if (body->share[row].torn) FW_TRY(fw_automaton_tear_row(body, step.colour, row, 0, error));
    fw_automaton_sort_tears(body);
    fw_automaton_book_tears(body, 0);
    fw_automaton_tick(body, 1);
    fw_automaton_place_boundary(body);
    return FW_OK;
}
