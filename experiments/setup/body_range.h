/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_range.h - where a body of the scenario lives in the scene, and its energy, momentum, mass
 * and centre, whether it has a solid to itself or shares one, as movable particles do. */
#ifndef FW_BODY_RANGE_H
#define FW_BODY_RANGE_H

#include "contact/scene/scene.h"
#include "core/lattice.h"

/* Particles first .. first + count - 1 of one solid. */
typedef struct fw_body_range {
    const char *name;
    int solid; /* number of the scene's body */
    int first, count;
    double spacing; /* of its lattice */
    fw_sites sites; /* in the order of the particles; owned by the experiment */
} fw_body_range;

const fw_solid *fw_body_range_solid(const fw_scene *scene, const fw_body_range *range);
fw_energies fw_body_range_energies(const fw_scene *scene, const fw_body_range *range);
fw_vec2 fw_body_range_momentum(const fw_scene *scene, const fw_body_range *range);
fw_sym2 fw_body_range_mass(const fw_scene *scene, const fw_body_range *range);
fw_vec2 fw_body_range_centre_of_mass(const fw_scene *scene, const fw_body_range *range);
/* Its group among the movable particles of its solid; -1: it is of another model. */
int fw_body_range_group(const fw_scene *scene, const fw_body_range *range);
/* The links within the body as pairs of its own numbers: malloc'ed, NULL without memory. */
int (*fw_body_range_links(const fw_scene *scene, const fw_body_range *range, int *count))[2];

#endif
