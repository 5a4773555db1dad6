/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grips.h - what tests of grips share beside scenes.h. */
#ifndef FW_TEST_GRIPS_H
#define FW_TEST_GRIPS_H

#include "tests/support/scenes.h"

/* Of the rows [first, first + rows) of a body of `columns`. */
static inline void grip_rows(fw_scene *scene, int body, const char *name, int columns, int first,
                             int rows, fw_drive drive)
{
    int particles[128];
    for (int i = 0; i < columns * rows; ++i) particles[i] = first * columns + i;
    const fw_grip_def def = {
        .name = name, .particles = particles, .particle_count = columns * rows, .drive = drive};
    must(fw_scene_add_grip(scene, body, &def, &error));
}

static inline const fw_grip_ledger *grip_ledger(const fw_scene *scene, int grip)
{
    return fw_grip_observe_ledger(fw_scene_observe_grip(scene, grip));
}

#endif
