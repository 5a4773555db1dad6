/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solid.c - the head that all solids share. */
#include "core/solid.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

fw_status fw_solid_head_create(fw_solid *solid, const fw_solid_model *model, int count,
                               fw_error *error)
{
    size_t size = (size_t)count;
    solid->model = model;
    solid->count = count;
    solid->tick = 1;
    solid->conserves = true;
    solid->x = fw_array_of_doubles(size);
    solid->y = fw_array_of_doubles(size);
    solid->external_x = fw_array_of_doubles(size);
    solid->external_y = fw_array_of_doubles(size);
    solid->boundary = fw_array_allocate(size, sizeof *solid->boundary);
    if (!solid->x || !solid->y || !solid->external_x || !solid->external_y || !solid->boundary) {
        fw_solid_head_release(solid);
        return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for %d particles", count);
    }
    return FW_OK;
}

void fw_solid_head_release(fw_solid *solid)
{
    free(solid->x);
    free(solid->y);
    free(solid->external_x);
    free(solid->external_y);
    free(solid->boundary);
    free(solid->links);
    solid->x = solid->y = solid->external_x = solid->external_y = NULL;
    solid->boundary = NULL;
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

int fw_solid_find_lost(const fw_solid *solid, fw_vec2 centre, double limit)
{
    /* Block by block without a branch inside, so that the search costs no more than the stream. */
    enum { BLOCK = 512 };
    if (limit > DBL_MAX) limit = DBL_MAX; /* an infinite position is lost whatever the limit */
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
