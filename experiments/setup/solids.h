/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solids.h - what is built of each material: the table that goes with fw_material_model. Each row
 * stands in the file build_NAME.c of its material. */
#ifndef FW_SOLIDS_H
#define FW_SOLIDS_H

#include "experiments/scenario/scenario.h"
#include "experiments/setup/body_range.h"

#include <stdio.h>

/* A body as it starts, for what is said of its limits. */
typedef struct fw_start {
    const fw_scenario *scenario;
    int body;
    const fw_solid *solid;
    const fw_body_range *range;
    bool meets; /* walls or other bodies */
} fw_start;

typedef struct fw_solid_kind {
    const fw_solid_model *model;
    /* Memory of one particle with its links and neighbours, its part of a frame and of a
     * checkpoint: from the largest resident size of runs with 10^6 and 10^7 particles, in the
     * middle of what the options of the material make of it (within 20 % of each). */
    double bytes_per_particle;
    double fastest; /* spacings per step, above which an impact turns cells inside out; 0: none */
    /* A body that has a solid to itself ... */
    fw_status (*build)(const fw_scenario *scenario, int body, const fw_sites *sites,
                       fw_solid **solid, fw_error *error);
    /* ... or all bodies of this kind together, as one solid, in the order of the scenario. */
    fw_status (*build_together)(const fw_scenario *scenario, const fw_body_range *ranges,
                                fw_solid **solid, fw_error *error);
    /* Gives a solid the heat bath of a phase; NULL: it has none. */
    fw_status (*set_bath)(fw_solid *solid, double damping, double temperature, fw_error *error);
    /* Says how near a body is to what the solid can do. *warnings counts the warnings among it.
     * NULL: it has no limits. */
    fw_status (*print_limits)(FILE *out, const fw_start *start, int *warnings, fw_error *error);
} fw_solid_kind;

#define FW_SOLID_KIND(id, member, word, meaning) extern const fw_solid_kind fw_##member##_solid;
FW_MATERIAL_ROWS(FW_SOLID_KIND)

/* The row of a kind of material. */
const fw_solid_kind *fw_solid_kind_at(fw_material_kind kind);

/* The row of a body's material. */
const fw_solid_kind *fw_solid_kind_of(const fw_scenario *scenario, int body);

#endif
