/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meeting.h - which stretches of bodies' contours may touch in this step.
 *
 * Contours are cut into runs of 16 segments. A run keeps a fat box, and the list of runs of other
 * bodies whose fat boxes it meets; as long as the paths of a run stay inside, no tree is searched.
 * What is returned are pairs whose boxes meet in this very step, so that it does not depend on when
 * fat boxes were made. */
#ifndef FW_MEETING_H
#define FW_MEETING_H

#include "contact/geometry/facet.h"
#include "contact/search/contour.h"

/* A body that takes part: arrays are read in each refresh. */
typedef struct fw_meeting_body {
    const fw_solid *solid;
    const fw_contour *contour;
} fw_meeting_body;

/* Segments first ... first + count - 1 of a body's contour, and the points they begin at. */
typedef struct fw_meeting_run {
    int body, first, count;
} fw_meeting_run;

typedef struct fw_meeting_pair {
    int a, b; /* runs; the body of a comes before that of b */
} fw_meeting_pair;

typedef struct fw_meeting fw_meeting;

/* The bodies' array is read during creation only. A body whose contour changes needs a new one.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_meeting_create(fw_meeting **meeting, const fw_meeting_body *bodies, int body_count,
                            fw_error *error);
void fw_meeting_destroy(fw_meeting *meeting);

/* Finds the pairs whose points may touch in this step, if no point goes further than `reach`.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_meeting_refresh(fw_meeting *meeting, const fw_meeting_body *bodies, double reach,
                             fw_error *error);

fw_meeting_run fw_meeting_observe_run(const fw_meeting *meeting, int run);
const fw_meeting_pair *fw_meeting_pairs(const fw_meeting *meeting, int *count);
/* How often the tree was searched since creation, for benchmarks. */
long fw_meeting_query_count(const fw_meeting *meeting);

#endif
