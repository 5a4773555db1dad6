/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contour_fold.c - does a body's edge cross itself? Segments in their order along a line, each
 * against those that begin before it ends. Keeps no state. */
#include "contact/geometry/crossing.h"
#include "contact/search/contour.h"

#include <stdlib.h>

typedef struct span {
    double low, high;
    int segment;
} span;

static int compare_spans(const void *left, const void *right)
{
    const span *a = left, *b = right;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    return (a->segment > b->segment) - (a->segment < b->segment);
}

static fw_vec2 place_of(const fw_contour *contour, const fw_solid *solid, int point)
{
    return fw_solid_position(solid, contour->particles[point]);
}

static bool cross_each_other(const fw_contour *contour, const fw_solid *solid, int first,
                             int second)
{
    const fw_contour_segment *s = &contour->segments[first], *t = &contour->segments[second];
    if (s->from == t->from || s->from == t->to || s->to == t->from || s->to == t->to) return false;
    return fw_crossing_of_still(place_of(contour, solid, s->from), place_of(contour, solid, s->to),
                                place_of(contour, solid, t->from), place_of(contour, solid, t->to));
}

static double along(fw_vec2 line, const fw_contour *contour, const fw_solid *solid, int point)
{
    return fw_vec2_dot(line, place_of(contour, solid, point));
}

/* The first segment along the line that crosses a later one, or -1. */
static int find_along(fw_vec2 line, const fw_contour *contour, const fw_solid *solid, span *spans)
{
    const int count = contour->segment_count;
    for (int n = 0; n < count; ++n) {
        const double from = along(line, contour, solid, contour->segments[n].from);
        const double to = along(line, contour, solid, contour->segments[n].to);
        spans[n] = (span){from < to ? from : to, from < to ? to : from, n};
    }
    qsort(spans, (size_t)count, sizeof *spans, compare_spans);
    for (int n = 0; n < count; ++n)
        for (int m = n + 1; m < count && spans[m].low <= spans[n].high; ++m)
            if (cross_each_other(contour, solid, spans[n].segment, spans[m].segment))
                return spans[n].segment;
    return -1;
}

fw_status fw_contour_find_fold(const fw_contour *contour, const fw_solid *solid, int *segment,
                               fw_error *error)
{
    /* Across a square's sides and diagonals: along one of them all of a side would lie at one
     * place. Only what is found is then looked for along x. */
    const fw_vec2 slanted = {1, 0.6180339887498949}, x = {1, 0};
    span *spans = malloc(((size_t)contour->segment_count + 1) * sizeof *spans);
    if (!spans) return fw_fail_memory(error, "a look at whether a body folds");
    *segment = find_along(slanted, contour, solid, spans);
    if (*segment >= 0) *segment = find_along(x, contour, solid, spans);
    free(spans);
    return FW_OK;
}
