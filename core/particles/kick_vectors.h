/* SPDX-License-Identifier: GPL-3.0-or-later */
/* kick_vectors.h - the half kick of langevin.h, a particle in each lane of a vector; for kernels.
 */
#ifndef FW_KICK_VECTORS_H
#define FW_KICK_VECTORS_H

#include "langevin_kernels.h"

#include "core/vectors.h"

/* v + dt/2m (F + external and constraint forces), of particles `at` and on. */
FW_INLINE fw_vector_pair fw_kicked(const fw_move_task *task, bool loaded, int at,
                                   fw_vector_pair force)
{
    if (loaded) {
        force.x += fw_load(task->external_x + at);
        force.y += fw_load(task->external_y + at);
    }
    if (task->constraint_x) {
        force.x += fw_load(task->constraint_x + at);
        force.y += fw_load(task->constraint_y + at);
    }
    const fw_vector push = task->baoab.half * fw_load(task->inverse_mass + at);
    return (fw_vector_pair){fw_load(task->velocity_x + at) + push * force.x,
                            fw_load(task->velocity_y + at) + push * force.y};
}

/* Particles outside the mask keep their velocities. */
FW_INLINE void fw_kick(const fw_move_task *task, bool loaded, int at, fw_mask held,
                       fw_vector_pair force)
{
    const fw_vector_pair kicked = fw_kicked(task, loaded, at, force);
    fw_store_some(task->velocity_x + at, held, kicked.x);
    fw_store_some(task->velocity_y + at, held, kicked.y);
}

#endif
