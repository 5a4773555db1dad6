/* SPDX-License-Identifier: GPL-3.0-or-later */
/* skin.h - which particles of a body need a closer look in this step.
 *
 * Skin particles are put in an order in which neighbours in space are neighbours in the list (a
 * Hilbert curve over the starting positions) and cut into runs of 32. A run keeps a fat box and the
 * list of facets that overlap it; as long as the swept box of the run stays inside and no moving
 * wall left its own margin, the tree is not asked. The lists are a conservative superset: results
 * never depend on when they were made. */
#ifndef FW_SKIN_H
#define FW_SKIN_H

#include "contact/broadphase.h"
#include "core/solid.h"

typedef struct fw_skin fw_skin;

/* For the solid's present skin. FW_SYSTEM_FAILED without memory. */
fw_status fw_skin_create(fw_skin **skin, const fw_solid *solid, fw_error *error);
void fw_skin_destroy(fw_skin *skin);

int fw_skin_count(const fw_skin *skin);
/* The particles, in the order of the runs (not ascending). */
const int *fw_skin_particles(const fw_skin *skin);
/* Room for the predictions of these particles, same order; filled by the scene. */
fw_prediction *fw_skin_predictions(fw_skin *skin);

/* A particle and a run of candidate facets. */
typedef struct fw_candidates {
    int entry;         /* place in fw_skin_particles */
    const int *facets; /* ascending; shared by the run */
    int facet_count;
} fw_candidates;

/* Refreshes the runs for positions x, y and the predicted displacements: afterwards every facet
 * that the path of a skin particle can meet is in the list of its run. `generation` changes when a
 * moving wall left its margin. FW_SYSTEM_FAILED without memory for longer lists. */
fw_status fw_skin_refresh(fw_skin *skin, const fw_solid *solid, const fw_broadphase *broadphase,
                          int generation, fw_error *error);

/* Runs that have any facet near, and their particles. */
int fw_skin_run_count(const fw_skin *skin);
fw_candidates fw_skin_run(const fw_skin *skin, int run, int *first_entry, int *entry_count);

/* How often the tree was asked since creation, for benchmarks. */
long fw_skin_query_count(const fw_skin *skin);

#endif
