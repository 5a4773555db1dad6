/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_selection.h - which sites of a body are meant, as plain data. */
#ifndef FW_SCENARIO_SELECTION_H
#define FW_SCENARIO_SELECTION_H

#include "core/lattice.h"
#include "experiments/schema/schema.h"

/* Sides of a body. */
typedef enum fw_outer_side {
    FW_SIDE_LEFT,
    FW_SIDE_RIGHT,
    FW_SIDE_BOTTOM,
    FW_SIDE_TOP
} fw_outer_side;

/* Which sites of a body: those of the list, or those within the rows and columns, which say
 * already which `side` and how many `layers` are wanted. At least one is the body's. */
typedef struct fw_selection {
    fw_place place;
    int first_row, last_row, first_column, last_column; /* inclusive */
    const fw_site *site; /* an explicit list, in the order of particles, or NULL */
    int site_count;
} fw_selection;

/* The selected ones as indices into `sites`, ascending: *particles is malloc'ed. Never empty for a
 * selection of this body that was read without error. */
fw_status fw_selection_particles(const fw_selection *selection, const fw_sites *sites,
                                 int **particles, int *count, fw_error *error);

#endif
