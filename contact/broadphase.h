/* SPDX-License-Identifier: GPL-3.0-or-later */
/* broadphase.h - the C door to Box2D 2.4.1: which facets are near a box.
 *
 * Every wall is a Box2D body, every facet one of its fixtures, and Box2D's tree finds candidates.
 * It never decides a contact: its floats and skins (0.005, 0.01, 0.1) are far too coarse. Boxes are
 * rounded outward, lengths are scaled to a few Box2D units and measured from the scene's middle, so
 * that no candidate is lost however far the scene lies from the origin. Not to be used from several
 * threads at once. */
#ifndef FW_BROADPHASE_H
#define FW_BROADPHASE_H

#include "contact/wall.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fw_box {
    fw_vec2 low, high;
} fw_box;

typedef struct fw_broadphase fw_broadphase;

/* `extent`: what the walls span together, for the choice of origin and scale. NULL: no memory. */
fw_broadphase *fw_broadphase_create(fw_box extent);
void fw_broadphase_destroy(fw_broadphase *broadphase);

/* Adds all facets of a wall; facets are numbered through, in the order of adding. Returns the
 * number of the wall's first facet, or -1 without memory. */
int fw_broadphase_add_wall(fw_broadphase *broadphase, const fw_wall *wall);

/* Puts a moving wall at a displacement from its definition; `sweep` more is to be covered, since
 * it may go on from there (the box of each facet is taken over both ends). */
void fw_broadphase_move_wall(fw_broadphase *broadphase, int wall, fw_vec2 displacement,
                             fw_vec2 sweep);

/* Numbers of all facets whose box overlaps `box` (some more may be in the list, none is missing),
 * ascending, so that the result does not depend on the tree's history. Writes at most `capacity`
 * and returns how many there are. */
int fw_broadphase_query(const fw_broadphase *broadphase, fw_box box, int *facets, int capacity);

#ifdef __cplusplus
}
#endif
#endif
