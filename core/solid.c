/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solid.c - the head that all solids share. State: what every fw_solid has before what is its
 * own. */
#include "core/solid.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fw_solid_ledger_add(fw_solid_ledger *ledger, const fw_solid_ledger *part)
{
    ledger->work += part->work;
    ledger->dissipated += part->dissipated;
    ledger->heat += part->heat;
    ledger->fracture += part->fracture;
    ledger->impulse = fw_vec2_add(ledger->impulse, part->impulse);
    ledger->drag = fw_vec2_add(ledger->drag, part->drag);
}

void fw_solid_head_begin(fw_solid *solid, const fw_solid_model *model, int count)
{
    const size_t size = (size_t)count;
    solid->model = model;
    solid->count = count;
    solid->tick = 1;
    solid->conserves = true;
    FW_ARENA_ADD(&solid->arena, solid->x, size);
    FW_ARENA_ADD(&solid->arena, solid->y, size);
    FW_ARENA_ADD(&solid->arena, solid->external_x, size);
    FW_ARENA_ADD(&solid->arena, solid->external_y, size);
    FW_ARENA_ADD(&solid->arena, solid->boundary, size);
}

fw_status fw_solid_allocate(fw_solid *solid, fw_error *error)
{
    char what[48];
    snprintf(what, sizeof what, "%d particles", solid->count);
    return fw_arena_allocate(&solid->arena, what, error);
}

void fw_solid_head_release(fw_solid *solid)
{
    fw_arena_release(&solid->arena);
    free(solid->links);
    solid->links = NULL;
}

void fw_solid_head_state(fw_solid *solid, fw_state_list *list)
{
    size_t count = (size_t)solid->count;
    fw_state_list_add(list, "position-x", FW_F64, count, solid->x);
    fw_state_list_add(list, "position-y", FW_F64, count, solid->y);
    fw_state_list_add(list, "ledger", FW_F64, sizeof solid->ledger / sizeof(double),
                      &solid->ledger);
    fw_state_list_add(list, "ticks", FW_I64, 1, &solid->ticks);
}

fw_status fw_solid_head_restored(const fw_solid *solid, fw_error *error)
{
    for (int i = 0; i < solid->count; ++i)
        if (!isfinite(solid->x[i]) || !isfinite(solid->y[i]))
            return fw_fail(error, FW_BAD_INPUT, "particle %d lies at (%g, %g), expected numbers", i,
                           solid->x[i], solid->y[i]);
    if (solid->ticks >= 0) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "the solid has taken %lld ticks, expected 0 or more",
                   (long long)solid->ticks);
}

fw_status fw_solid_move_free(fw_solid *solid, int ticks, fw_error *error)
{
    if (solid->model->advance_free) return solid->model->advance_free(solid, ticks, error);
    for (int tick = 0; tick < ticks; ++tick) FW_TRY(fw_solid_move(solid, NULL, 0, error));
    return FW_OK;
}

fw_status fw_solid_advance(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                           fw_error *error)
{
    FW_TRY(fw_solid_move(solid, constraints, constraint_count, error));
    fw_solid_place(solid);
    return FW_OK;
}

fw_status fw_solid_advance_free(fw_solid *solid, fw_error *error)
{
    return fw_solid_advance(solid, NULL, 0, error);
}

void fw_solid_reverse(fw_solid *solid)
{
    fw_vec2 before = fw_solid_momentum(solid);
    solid->model->reverse(solid);
    fw_vec2 change = fw_vec2_subtract(fw_solid_momentum(solid), before);
    solid->ledger.impulse = fw_vec2_add(solid->ledger.impulse, change);
}

const fw_field *fw_solid_find_field(const fw_solid *solid, const char *name)
{
    for (const fw_field *field = solid->model->fields; field && field->name; ++field)
        if (strcmp(field->name, name) == 0) return field;
    return NULL;
}

int fw_solid_find_lost_boundary(const fw_solid *solid, fw_vec2 centre, double limit)
{
    limit = fmin(limit, DBL_MAX);
    for (int n = 0; n < solid->boundary_count; ++n) {
        const int i = solid->boundary[n];
        if (!(fabs(solid->x[i] - centre.x) <= limit && fabs(solid->y[i] - centre.y) <= limit))
            return i;
    }
    return -1;
}

int fw_solid_find_lost(const fw_solid *solid, fw_vec2 centre, double limit)
{
    /* Block by block without a branch inside, so that the search costs no more than the stream. */
    enum { BLOCK = 512 };
    limit = fmin(limit, DBL_MAX); /* an infinite position is lost whatever the limit */
    for (int begin = 0; begin < solid->count; begin += BLOCK) {
        int end = begin + BLOCK < solid->count ? begin + BLOCK : solid->count;
        int kept = 0;
        for (int i = begin; i < end; ++i)
            kept +=
                (fabs(solid->x[i] - centre.x) <= limit) & (fabs(solid->y[i] - centre.y) <= limit);
        if (kept == end - begin) continue;
        for (int i = begin; i < end; ++i)
            if (!(fabs(solid->x[i] - centre.x) <= limit && fabs(solid->y[i] - centre.y) <= limit))
                return i;
    }
    return -1;
}
