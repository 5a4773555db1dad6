/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contour.h - the edge of a body as chains of segments, which other bodies must not pass.
 *
 * Links and particles are a plane graph. Where a face of it is a cell (of three or four links),
 * there is matter; every other face is free space: around the body, in a hole, or in a crack that
 * broken links have opened. A walk around such a face, with the face on the left, is a chain of
 * segments that bar the way from their left to their right. A link without a cell on either side,
 * as in a chain of single particles, is a segment in both directions. */
#ifndef FW_CONTOUR_H
#define FW_CONTOUR_H

#include "core/solid.h"

/* Points are numbered in the order in which chains come to them first. */
typedef struct fw_contour_segment {
    int from, to;   /* points; the same for a particle without links */
    bool two_sided; /* the contour has it in the other direction as well */
} fw_contour_segment;

typedef struct fw_contour {
    int point_count, segment_count;
    int *particles;                   /* per point */
    uint8_t *tips;                    /* per point: 1 where a chain of single particles ends */
    fw_contour_segment *segments;     /* chain after chain, along each */
    int *points;                      /* per particle of the solid: its point, or -1 */
    struct fw_contour_halves *halves; /* private: once it was renewed */
} fw_contour;

/* Of the solid's present links. `home` says, per particle, where links lead around it: places in
 * which the body is not turned inside out, such as those it was made with. FW_SYSTEM_FAILED without
 * memory, with an empty contour. */
fw_status fw_contour_create(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                            fw_error *error);
/* The same contour as one made anew, after links broke. From the second time on that goes with the
 * points, but for a comparison of all links, if links have only gone and their order stayed. On
 * failure the contour is empty or as it was. */
fw_status fw_contour_renew(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                           fw_error *error);
void fw_contour_clear(fw_contour *contour);

/* A segment of the solid's contour that crosses another one of it, or -1: then the body is folded.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_contour_find_fold(const fw_contour *contour, const fw_solid *solid, int *segment,
                               fw_error *error);

#endif
