/* SPDX-License-Identifier: GPL-3.0-or-later */
/* elastic_automaton.c - a solid of black and white cells that move in turn: making it, and what can
 * be observed of it.
 * State: displacements of both colours, from which positions are made, which bonds are whole, the
 * tick, whose parity says which colour moves next. Invariant: E and p of the header change only by
 * what the ledger says. Start reading at fw_elastic_automaton_create(); the half-step is in
 * automaton_sweep.c. */
#include "automaton_body.h"
#include "automaton_stability.h"

#include <math.h>
#include <stdlib.h>

fw_elastic_automaton_def fw_elastic_automaton_def_default(void)
{
    return (fw_elastic_automaton_def){.lattice = {.kind = FW_SQUARE, .spacing = 1},
                                      .speeds = fw_automaton_chopard(),
                                      .boundary = FW_BOUNDARY_BOND,
                                      .reflection = 1,
                                      .break_at = INFINITY};
}

static bool all_finite(const fw_vec2 *field, int count)
{
    for (int p = 0; field && p < count; ++p)
        if (!isfinite(field[p].x) || !isfinite(field[p].y)) return false;
    return true;
}

static fw_status check_definition(const fw_elastic_automaton_def *def,
                                  const fw_automaton_matrices *matrices, fw_error *error)
{
    if (def->lattice.kind != FW_SQUARE)
        return fw_fail(error, FW_BAD_INPUT,
                       "a hexagonal lattice for an elastic automaton, expected a square one: its "
                       "cells are black and white in turn");
    if (!(def->lattice.spacing > 0 && isfinite(def->lattice.spacing)))
        return fw_fail(error, FW_BAD_INPUT, "spacing %g, expected a number above 0",
                       def->lattice.spacing);
    if (!all_finite(def->displacement, def->sites->count) ||
        !all_finite(def->velocity, def->sites->count) || !all_finite(&def->drift, 1))
        return fw_fail(error, FW_BAD_INPUT,
                       "a displacement or velocity of an elastic automaton that is not finite");
    if (!(def->reflection > 0 && def->reflection <= 1))
        return fw_fail(error, FW_BAD_INPUT,
                       "reflection a = %g, expected above 0 (overdamped) to 1 (elastic)",
                       def->reflection);
    if (!(def->break_at > 0))
        return fw_fail(error, FW_BAD_INPUT, "break-at %g, expected a positive stretch",
                       def->break_at);
    const bool breaks = isfinite(def->break_at);
    if (breaks && def->boundary != FW_BOUNDARY_BOND)
        return fw_fail(error, FW_BAD_INPUT,
                       "breaking bonds with another boundary rule than 'bond', expected 'bond': "
                       "what is left of a cell is renormalised by that rule");
    const double least = fw_automaton_matrices_least(matrices);
    if (breaks && !(least > 1e-9))
        return fw_fail(error, FW_BAD_INPUT,
                       "breaking bonds with c1 = %g, c2 = %g, where a bond's matrix has the "
                       "eigenvalue %.3g, expected all above 0: otherwise a broken body can be "
                       "unstable (a smaller c2 helps)",
                       def->speeds.transverse, def->speeds.coupling, least);
    return FW_OK;
}

static void destroy(fw_solid *solid)
{
    fw_automaton *body = fw_automaton_of(solid);
    fw_automaton_release(body);
    free(body);
}

/* The body on its lattice sites, whether it is stable or not. */
static fw_status build(fw_automaton **made, const fw_elastic_automaton_def *def, fw_error *error)
{
    *made = NULL;
    fw_automaton_matrices matrices;
    FW_TRY(fw_automaton_matrices_make(&matrices, def->speeds, def->lattice.angle, error));
    FW_TRY(check_definition(def, &matrices, error));
    fw_automaton *body = calloc(1, sizeof *body);
    if (!body) return fw_fail_memory(error, "an elastic automaton");
    body->matrices = matrices;
    body->boundary = def->boundary;
    body->reflection = def->reflection;
    body->break_at = def->break_at;
    body->lattice = def->lattice;
    const double angle = def->lattice.angle;
    body->turn = angle == 0 ? (fw_vec2){1, 0} : (fw_vec2){cos(angle), sin(angle)};
    body->breaks = isfinite(def->break_at);
    int exponent;
    (void)frexp(def->lattice.spacing, &exponent);
    body->quantum = ldexp(1, exponent);
    fw_solid_head_begin(&body->head, &fw_elastic_automaton_model, def->sites->count);
    fw_status status = fw_solid_allocate(&body->head, error);
    if (status == FW_OK) status = fw_automaton_lay_out(body, def, error);
    if (status != FW_OK) {
        destroy(&body->head);
        return status;
    }
    body->head.tick = 0.5;
    body->head.conserves = body->boundary != FW_BOUNDARY_MIRROR;
    *made = body;
    return FW_OK;
}

fw_status fw_elastic_automaton_create(fw_solid **solid, const fw_elastic_automaton_def *def,
                                      fw_error *error)
{
    *solid = NULL;
    fw_automaton *body;
    FW_TRY(build(&body, def, error));
    const fw_status status = fw_automaton_check_stability(body, error);
    if (status != FW_OK) {
        destroy(&body->head);
        return status;
    }
    fw_automaton_start(body, def);
    *solid = &body->head;
    return FW_OK;
}

fw_status fw_elastic_automaton_spectral_radius(const fw_elastic_automaton_def *def, double *radius,
                                               fw_error *error)
{
    fw_automaton *body;
    FW_TRY(build(&body, def, error));
    const fw_status status = fw_automaton_spectral_radius(body, radius, error);
    destroy(&body->head);
    return status;
}

fw_vec2 fw_elastic_automaton_displacement(const fw_solid *solid, int particle)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const fw_vec2 u = fw_automaton_at(&body->colour[body->white[particle]], body->cell[particle]);
    return (fw_vec2){u.x + (double)body->drift[0] * body->quantum,
                     u.y + (double)body->drift[1] * body->quantum};
}

bool fw_elastic_automaton_is_black(const fw_solid *solid, int particle)
{
    return fw_automaton_of_const(solid)->white[particle] == FW_BLACK;
}

static void state(fw_solid *solid, fw_state_list *list)
{
    fw_automaton *body = fw_automaton_of(solid);
    fw_solid_head_state(solid, list);
    fw_state_list_add(list, "black-x", FW_F64, (size_t)body->colour[FW_BLACK].count,
                      body->colour[FW_BLACK].x);
    fw_state_list_add(list, "black-y", FW_F64, (size_t)body->colour[FW_BLACK].count,
                      body->colour[FW_BLACK].y);
    fw_state_list_add(list, "white-x", FW_F64, (size_t)body->colour[FW_WHITE].count,
                      body->colour[FW_WHITE].x);
    fw_state_list_add(list, "white-y", FW_F64, (size_t)body->colour[FW_WHITE].count,
                      body->colour[FW_WHITE].y);
    fw_state_list_add(list, "drift", FW_I64, 2, body->drift);
    if (body->bonds)
        fw_state_list_add(list, "bonds", FW_U8, (size_t)body->colour[FW_BLACK].count, body->bonds);
}

static fw_status restored(fw_solid *solid, fw_error *error)
{
    fw_automaton *body = fw_automaton_of(solid);
    FW_TRY(fw_solid_head_restored(solid, error));
    for (int n = 0; body->bonds && n < body->colour[FW_BLACK].count; ++n)
        for (int d = 0; d < 8; ++d)
            if ((body->bonds[n] >> d & 1) && (d >= FW_DIRECTIONS || body->built[n][d] < 0))
                return fw_fail(error, FW_BAD_INPUT,
                               "black cell %d has a bond in direction %d, where no cell lies", n,
                               d);
    FW_TRY(fw_automaton_rebuild_bonds(body, error));
    body->sums->known = false;
    fw_automaton_place(solid);
    return FW_OK;
}

const fw_solid_model fw_elastic_automaton_model = {
    .name = "elastic-automaton",
    .ticks_per_step = 2,
    .destroy = destroy,
    .predict = fw_automaton_predict,
    .predict_step = fw_automaton_predict_step,
    .partners = fw_automaton_partners,
    .advance = fw_automaton_advance,
    .advance_free = fw_automaton_advance_free,
    .place = fw_automaton_place,
    .energies = fw_automaton_energies,
    .momentum = fw_automaton_momentum,
    .angular_momentum = fw_automaton_angular_momentum,
    .centre_of_mass = fw_automaton_centre_of_mass,
    .mass = fw_automaton_mass,
    .velocities = fw_automaton_velocities,
    .masses = fw_automaton_masses,
    .state = state,
    .restored = restored,
    .fields = fw_automaton_fields,
    .solid_between_links = true,
    .bare_is_nothing = true,
};
