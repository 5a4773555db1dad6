/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_room.c - the memory of the joint solver: it grows as problems do and is kept. */
#include "joint_parts.h"

#include <stdlib.h>

fw_joint *fw_joint_create(void)
{
    return calloc(1, sizeof(fw_joint));
}

void fw_joint_destroy(fw_joint *joint)
{
    if (!joint) return;
    joint_islands_release(&joint->islands);
    free(joint->local);
    free(joint->global);
    free(joint->first);
    free(joint->w);
    free(joint->change);
    free(joint->z);
    free(joint->line_of);
    free(joint->lines);
    free(joint->lambda);
    free(joint->limit);
    free(joint->traction);
    free(joint->target);
    free(joint->slip);
    free(joint->tangents);
    free(joint->tangent_of);
    free(joint->room);
    free(joint);
}

static void *enlarge(void *list, size_t count, size_t size, bool *failed)
{
    void *larger = realloc(list, (count + 1) * size);
    *failed |= !larger;
    return larger ? larger : list;
}

fw_status joint_reserve(fw_joint *joint, int end_count, int row_count, fw_error *error)
{
    bool failed = false;
    if (end_count + row_count > joint->end_capacity) { /* a spring needs an end of its own */
        const size_t size = 2 * ((size_t)end_count + (size_t)row_count) + 64;
        joint->local = enlarge(joint->local, size, sizeof *joint->local, &failed);
        joint->global = enlarge(joint->global, size, sizeof *joint->global, &failed);
        joint->first = enlarge(joint->first, size, sizeof *joint->first, &failed);
        joint->w = enlarge(joint->w, size, sizeof *joint->w, &failed);
        joint->change = enlarge(joint->change, size, sizeof *joint->change, &failed);
        joint->z = enlarge(joint->z, size, sizeof *joint->z, &failed);
        if (!failed) joint->end_capacity = (int)size;
    }
    if (row_count > joint->row_capacity) {
        const size_t size = 2 * (size_t)row_count + 64;
        joint->line_of = enlarge(joint->line_of, size, sizeof *joint->line_of, &failed);
        joint->lines = enlarge(joint->lines, size, sizeof *joint->lines, &failed);
        joint->limit = enlarge(joint->limit, size, sizeof *joint->limit, &failed);
        joint->target = enlarge(joint->target, size, sizeof *joint->target, &failed);
        joint->slip = enlarge(joint->slip, size, sizeof *joint->slip, &failed);
        joint->traction = enlarge(joint->traction, size, sizeof *joint->traction, &failed);
        joint->tangents = enlarge(joint->tangents, size, sizeof *joint->tangents, &failed);
        joint->tangent_of = enlarge(joint->tangent_of, size, sizeof *joint->tangent_of, &failed);
        joint->lambda = enlarge(joint->lambda, size, sizeof *joint->lambda, &failed);
        if (!failed) joint->row_capacity = (int)size;
    }
    return failed ? fw_fail_memory(error, "the contact of bodies") : FW_OK;
}

fw_status joint_reserve_room(fw_joint *joint, size_t size, fw_error *error)
{
    if (size <= joint->room_size) return FW_OK;
    bool failed = false;
    joint->room = enlarge(joint->room, 2 * size, sizeof *joint->room, &failed);
    if (failed) return fw_fail_memory(error, "the contact of bodies");
    joint->room_size = 2 * size;
    return FW_OK;
}
