/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_hash.h - a scene as one number. */
#ifndef FW_SCENE_HASH_H
#define FW_SCENE_HASH_H

#include "contact/scene/scene.h"

/* Of the whole state. */
static inline uint64_t hash_of_scene(fw_scene *scene)
{
    uint64_t hash = 0;
    for (int n = 0; n < fw_scene_section_count(scene); ++n) {
        fw_state_list list = {0};
        fw_scene_section(scene, n, &list);
        hash = hash * 31 + fw_state_list_hash(&list);
    }
    return hash;
}

#endif
