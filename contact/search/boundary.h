/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary.h - which particles of a body need a closer look in this step.
 *
 * Skin particles are put in an order in which neighbours in space are neighbours in the list (a
 * Hilbert curve over the positions at creation) and cut into runs of 32. A run keeps a fat box and
 * the list of facets that can be passed in it; as long as the paths of the run stay inside and no
 * wall left its own margin, the tree is not searched. The lists are a superset of what is needed:
 * what contact finds with them never depends on when they were made. */
#ifndef FW_BOUNDARY_H
#define FW_BOUNDARY_H

#include "contact/search/broadphase.h"
#include "core/solid.h"

typedef struct fw_boundary fw_boundary;

/* For the solid's present boundary and positions. FW_SYSTEM_FAILED without memory. A solid whose
 * boundary changes needs a new one; making it costs about a hundred refreshes. */
fw_status fw_boundary_create(fw_boundary **boundary, const fw_solid *solid, fw_error *error);
void fw_boundary_destroy(fw_boundary *boundary);

int fw_boundary_count(const fw_boundary *boundary);
/* The particles, in the order of the runs (not ascending). */
const int *fw_boundary_particles(const fw_boundary *boundary);
/* Room for the predictions of these particles, same order; filled by the scene. */
fw_prediction *fw_boundary_predictions(fw_boundary *boundary);

/* Brings the runs up to date with the solid's positions, the predicted displacements and the walls'
 * sweeps: afterwards every facet that a boundary particle can pass in this step is in the list of
 * its run, if it moves by no more than twice the longest predicted displacement of its run plus the
 * longest sweep of all walls. FW_SYSTEM_FAILED without memory for longer lists. */
fw_status fw_boundary_refresh(fw_boundary *boundary, const fw_solid *solid,
                              const fw_broadphase *broadphase, fw_error *error);

/* Entries first ... first + count - 1 of the particles, and the facets near them, ascending. The
 * list is valid until the next refresh or extension. */
typedef struct fw_boundary_run {
    int first, count;
    const int *facets;
    int facet_count;
} fw_boundary_run;

/* The run that has this entry. */
int fw_boundary_run_of(const fw_boundary *boundary, int entry);
int fw_boundary_run_count(const fw_boundary *boundary);
fw_boundary_run fw_boundary_observe_run(const fw_boundary *boundary, int run);

/* For a particle that is pushed further than refresh foresaw: extends the list of its run to what
 * can be passed on a path to `point`. Costs a comparison where it is covered already. */
fw_status fw_boundary_extend(fw_boundary *boundary, const fw_broadphase *broadphase, int run,
                             fw_vec2 point, fw_error *error);

/* No facet lies nearer to any boundary particle, as they lie now, than what is returned: the
 * largest length of `most`, most/2, ... most/256 of which that is true, or 0. Right after a refresh
 * and for walls that do not move. */
double fw_boundary_clearance(const fw_boundary *boundary, const fw_solid *solid,
                             const fw_broadphase *broadphase, double most);

/* How often the tree was searched since creation, for benchmarks. */
long fw_boundary_query_count(const fw_boundary *boundary);

#endif
