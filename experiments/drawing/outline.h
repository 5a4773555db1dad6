/* SPDX-License-Identifier: GPL-3.0-or-later */
/* outline.h - the outline of something rigid: where particles may not be is grey. */
#ifndef FW_OUTLINE_H
#define FW_OUTLINE_H

#include "experiments/drawing/panel.h"

/* Which side of an outline is forbidden. All of an inside is filled, and has to be convex; of the
 * other sides a band is. */
typedef enum fw_forbidden {
    FW_FORBIDDEN_OUTSIDE,
    FW_FORBIDDEN_INSIDE,
    FW_FORBIDDEN_RIGHT /* walking along the points; not of circles */
} fw_forbidden;

typedef struct fw_outline {
    const fw_vec2 *points; /* [count] in order; of a circle its centre */
    int count;
    double radius; /* > 0: a circle */
    bool closed;   /* from the last point to the first; a circle is */
    fw_forbidden forbidden;
    fw_vec2 displacement; /* from `points` */
} fw_outline;

/* Widen the ranges by the outline. */
void fw_outline_include(const fw_outline *outline, fw_range *x, fw_range *y);

/* The forbidden part, of this opacity; a band is `width` mm wide. */
void fw_outline_draw_forbidden(const fw_outline *outline, const fw_panel *panel, double opacity,
                               double width);
void fw_outline_draw(const fw_outline *outline, const fw_panel *panel, fw_stroke line);

#endif
