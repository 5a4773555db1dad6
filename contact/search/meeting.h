/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meeting.h - which stretches of bodies' contours may touch in this step.
 *
 * Contours are cut into runs of 16 segments. A run keeps a fat box, and pairs of runs of different
 * bodies whose fat boxes meet are near. A run that is near none is idle: nobody has to predict
 * where its points go, and only where they are is looked at, as long as it stays well within its
 * fat box, and then only in every fourth step where all are. That is so while idle points go no
 * further from one look to the next than half the margin of their box, a spacing at least; whether
 * they did is looked at then.
 *
 * What is returned are pairs whose paths may meet in this very step, so that it does not depend on
 * when fat boxes were made. */
#ifndef FW_MEETING_H
#define FW_MEETING_H

#include "contact/geometry/facet.h"
#include "contact/search/contour.h"

/* A body that takes part; read in each step. */
typedef struct fw_meeting_body {
    const fw_solid *solid;
    const fw_contour *contour;
    int first, count; /* its segments: those of one of the bodies that share the solid */
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

/* Brings boxes up to date with where points are at the beginning of a step, and empties the list of
 * pairs. `expected` is how far points are to go in a first step, of which no way is known yet.
 * FW_DIVERGED: idle points went so far since the last look that they may have passed another body
 * (`jumped` is their run then, else -1); FW_SYSTEM_FAILED without memory. */
fw_status fw_meeting_begin(fw_meeting *meeting, const fw_meeting_body *bodies, double expected,
                           int *jumped, fw_error *error);

/* Runs that are near another one, without order. More may be appended by fw_meeting_find. */
const int *fw_meeting_busy(const fw_meeting *meeting, int *count);

/* Finds the pairs whose points may touch in this step, if points of busy runs go no further than
 * `reach`. Runs may become busy by that: their points, too. FW_SYSTEM_FAILED without memory. */
fw_status fw_meeting_find(fw_meeting *meeting, double reach, fw_error *error);

fw_meeting_run fw_meeting_observe_run(const fw_meeting *meeting, int run);
const fw_meeting_pair *fw_meeting_pairs(const fw_meeting *meeting, int *count);
/* How often the tree was searched since creation, for benchmarks. */
long fw_meeting_query_count(const fw_meeting *meeting);

#endif
