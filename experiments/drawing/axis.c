/* SPDX-License-Identifier: GPL-3.0-or-later */
/* axis.c - ticks that fit, and the room that they take.
 * Keeps no state. Invariant: what panel.c draws of an axis stays inside the room that fw_axis_depth
 * promises. Start reading at fw_axis_prepare(). */
#include "experiments/drawing/axis.h"

#include "experiments/drawing/canvas.h"

#include <math.h>
#include <string.h>

static int wanted_ticks(double length, double apart)
{
    return (int)fmin(fmax(floor(length / apart), 3), 8);
}

/* Do the numbers along an x axis keep a distance from each other? */
static bool labels_fit(const fw_axis *axis, double length)
{
    const fw_ticks *ticks = &axis->ticks;
    double extent = axis->logarithmic ? log(axis->range.high / axis->range.low)
                                      : axis->range.high - axis->range.low;
    for (int k = 1; k < ticks->count; ++k) {
        double apart = axis->logarithmic ? log(ticks->at[k] / ticks->at[k - 1])
                                         : ticks->at[k] - ticks->at[k - 1];
        double taken = (fw_canvas_text_width(ticks->label[k - 1], FW_SMALL_SIZE, false) +
                        fw_canvas_text_width(ticks->label[k], FW_SMALL_SIZE, false)) /
                       2;
        if (apart / extent * length < taken + 3) return false;
    }
    return true;
}

static void take_names(fw_axis *axis)
{
    fw_ticks *ticks = &axis->ticks;
    memset(ticks, 0, sizeof *ticks);
    for (int k = 0; k < axis->name_count && ticks->count < FW_TICKS_MAX; ++k) {
        double at = axis->names[k].at;
        if (!(at >= axis->range.low && at <= axis->range.high)) continue;
        ticks->at[ticks->count] = at;
        strncat(ticks->label[ticks->count++], axis->names[k].name, FW_TICK_LABEL_SIZE - 1);
    }
}

/* Round are the numbers that are shown; the ticks are at the values. */
static void find_ticks(fw_axis *axis, int wanted)
{
    fw_ticks *ticks = &axis->ticks;
    const fw_range shown = {fw_label_shown(axis->label, axis->range.low),
                            fw_label_shown(axis->label, axis->range.high)};
    fw_ticks_find(ticks, shown, axis->logarithmic, wanted);
    if (!(axis->label.factor > 0)) return;
    for (int k = 0; k < ticks->count; ++k) ticks->at[k] /= axis->label.factor;
    for (int k = 0; k < ticks->minor_count; ++k) ticks->minor[k] /= axis->label.factor;
}

void fw_axis_prepare(fw_axis *axis, double length, bool across)
{
    if (axis->name_count > 0) {
        take_names(axis);
        return;
    }
    int wanted = wanted_ticks(length, across ? 14 : 10.5);
    do {
        find_ticks(axis, wanted);
    } while (across && --wanted > 0 && !labels_fit(axis, length));
    /* One number alone does not make a scale. */
    for (wanted = 4; wanted < 8 && axis->ticks.count < 2; ++wanted) {
        find_ticks(axis, wanted);
    }
}

double fw_axis_widest_number(const fw_axis *axis)
{
    const fw_ticks *ticks = &axis->ticks;
    double widest = 0;
    for (int k = 0; k < ticks->count; ++k) {
        widest = fmax(widest, fw_canvas_text_width(ticks->label[k], FW_SMALL_SIZE, false));
    }
    return widest;
}

double fw_axis_depth(const fw_axis *axis, bool across)
{
    double depth = FW_AXIS_TICK;
    if (axis->hidden) return 0;
    if (axis->bare) return depth;
    bool row = axis->label.text || (across && axis->ticks.note[0]);
    depth += FW_AXIS_NUMBER_GAP +
             (across ? fw_canvas_line_height(FW_SMALL_SIZE) : fw_axis_widest_number(axis));
    return row ? depth + FW_AXIS_LABEL_GAP + fw_canvas_line_height(FW_TEXT_SIZE) : depth;
}

double fw_axis_note_height(const fw_axis *axis)
{
    return axis->ticks.note[0] ? .8 + fw_canvas_line_height(FW_SMALL_SIZE) : 0;
}

double fw_axis_overhang(const fw_axis *axis, double length)
{
    const fw_ticks *ticks = &axis->ticks;
    if (axis->bare || ticks->count == 0) return 0;
    double width = fw_canvas_text_width(ticks->label[ticks->count - 1], FW_SMALL_SIZE, false);
    return fmax(0, fw_axis_part(axis, ticks->at[ticks->count - 1]) * length + width / 2 - length);
}

double fw_axis_part(const fw_axis *axis, double value)
{
    double low = axis->range.low, high = axis->range.high;
    if (!axis->logarithmic) return (value - low) / (high - low);
    return value > 0 ? log(value / low) / log(high / low) : NAN;
}
