/* SPDX-License-Identifier: GPL-3.0-or-later */
/* broadphase.h - the C door to Box2D 2.4.1: which facets are near a box.
 *
 * Every wall is a Box2D body, every facet one of its fixtures, and Box2D's tree finds candidates.
 * It never decides: its floats and boundaries (0.005, 0.01, 0.1) are far too coarse. Its boxes are
 * rounded outward, with lengths scaled to some ten Box2D units and measured from the scene's
 * middle, so that no candidate is lost however far the scene lies from the origin; what it finds is
 * then sifted in double precision, so that the answer depends on nothing but the walls' places.
 * Not to be used from several threads at once. */
#ifndef FW_BROADPHASE_H
#define FW_BROADPHASE_H

#include "contact/geometry/wall.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fw_broadphase fw_broadphase;

/* `extent`: what the walls span together, for the choice of origin and scale. NULL: no memory. */
fw_broadphase *fw_broadphase_create(fw_box extent);
void fw_broadphase_destroy(fw_broadphase *broadphase);

/* Adds all facets of a wall, which must outlive the broadphase. Walls and facets are numbered
 * through, in the order of adding. Returns the number of the wall's first facet, or -1 without
 * memory, with the broadphase unaltered. */
int fw_broadphase_add_wall(fw_broadphase *broadphase, const fw_wall *wall);

int fw_broadphase_facet_count(const fw_broadphase *broadphase);
const fw_facet *fw_broadphase_facet(const fw_broadphase *broadphase, int number);

/* Says where a moving wall is at the beginning of a step and how far it may go in it (`sweep`, also
 * when it is zero). To be called for every moving wall in every step, before the boundaries are
 * refreshed. The wall's boxes are remade only where they do not cover that any more, and then for
 * some steps ahead. */
void fw_broadphase_move_wall(fw_broadphase *broadphase, int wall, fw_vec2 displacement,
                             fw_vec2 sweep);

/* A number that grows whenever boxes were remade: candidates from before are then out of date. */
long fw_broadphase_generation(const fw_broadphase *broadphase);

/* Length of the longest sweep of all walls in this step. */
double fw_broadphase_largest_sweep(const fw_broadphase *broadphase);

/* Numbers, ascending, of all facets that a path inside `box` can pass while the walls stay within
 * their boxes. Writes at most `capacity` and returns how many there are; where it is more, the
 * written ones are an arbitrary part. */
int fw_broadphase_query(const fw_broadphase *broadphase, fw_box box, int *facets, int capacity);

#ifdef __cplusplus
}
#endif
#endif
