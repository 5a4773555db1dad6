/* SPDX-License-Identifier: GPL-3.0-or-later */
/* axis.h - one axis of a panel: what it spans, its ticks, and the room that it takes.
 *
 * Order of use: describe it, compute its ticks (fw_axis_prepare) and its room (fw_axis_depth),
 * place the panel, draw (panel.h). */
#ifndef FW_AXIS_H
#define FW_AXIS_H

#include "experiments/drawing/label.h"
#include "experiments/drawing/ticks.h"

typedef struct fw_axis_name {
    double at;
    const char *name;
} fw_axis_name;

typedef struct fw_axis {
    fw_range range; /* low < high; logarithmic: low > 0 */
    bool logarithmic;
    fw_label label;            /* its factor is of the numbers at the ticks alone */
    const fw_axis_name *names; /* ticks with names in place of numbers */
    int name_count;
    bool bare;      /* ticks only: the panel below carries numbers and label */
    bool hidden;    /* not even ticks */
    fw_ticks ticks; /* from fw_axis_prepare */
} fw_axis;

/* Chooses the ticks for an axis of this length in mm; `across`: the x axis. */
void fw_axis_prepare(fw_axis *axis, double length, bool across);
/* Room in mm that numbers and label take: below the box (across) or to its left. */
double fw_axis_depth(const fw_axis *axis, bool across);
/* Room in mm above the box that a note to the y axis (powers of ten, offset) takes. */
double fw_axis_note_height(const fw_axis *axis);
/* How far the last number of an x axis of this length sticks out to the right of the box. */
double fw_axis_overhang(const fw_axis *axis, double length);
/* Width in mm of the widest number. */
double fw_axis_widest_number(const fw_axis *axis);
/* Along the axis, as a part of its length: 0 at the low end, 1 at the high one. */
double fw_axis_part(const fw_axis *axis, double value);

/* Lengths in mm that panels draw and depths count with. */
#define FW_AXIS_TICK       1.3
#define FW_AXIS_MINOR_TICK .7
#define FW_AXIS_NUMBER_GAP .9
#define FW_AXIS_LABEL_GAP  1.0

#endif
