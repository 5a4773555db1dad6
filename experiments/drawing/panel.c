/* SPDX-License-Identifier: GPL-3.0-or-later */
/* panel.c - from numbers to places on the paper.
 * Keeps no state. Invariant: a number of the axes' ranges lies in the box. Start reading at
 * fw_panel_place() and fw_panel_draw_axes(). */
#include "experiments/drawing/panel.h"

#include <math.h>
#include <string.h>

/* By how much the label of an x axis may be wider than the box: panels side by side are further
 * apart. */
static const double overhang = 4.5; /* mm */

double fw_panel_x(const fw_panel *panel, double x)
{
    return panel->box.left + fw_axis_part(&panel->x, x) * panel->box.width;
}

double fw_panel_y(const fw_panel *panel, double y)
{
    return panel->box.top + (1 - fw_axis_part(&panel->y, y)) * panel->box.height;
}

fw_vec2 fw_panel_place(const fw_panel *panel, double x, double y)
{
    return (fw_vec2){fw_panel_x(panel, x), fw_panel_y(panel, y)};
}

double fw_panel_scale(const fw_panel *panel)
{
    return panel->box.width / (panel->x.range.high - panel->x.range.low);
}

void fw_panel_draw_grid(const fw_panel *panel)
{
    const fw_stroke hair = {fw_colour_grey(.9), .15, FW_DASH_NONE};
    const fw_rect *box = &panel->box;
    for (int k = 0; k < panel->x.ticks.count; ++k) {
        double x = fw_panel_x(panel, panel->x.ticks.at[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){x, box->top}, (fw_vec2){x, box->top + box->height},
                       hair);
    }
    for (int k = 0; k < panel->y.ticks.count; ++k) {
        double y = fw_panel_y(panel, panel->y.ticks.at[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){box->left, y}, (fw_vec2){box->left + box->width, y},
                       hair);
    }
}

static void draw_x_axis(const fw_panel *panel)
{
    const fw_stroke line = {fw_colour_ink(), .22, FW_DASH_NONE};
    const fw_axis *axis = &panel->x;
    double bottom = panel->box.top + panel->box.height;
    for (int k = 0; k < axis->ticks.minor_count; ++k) {
        double x = fw_panel_x(panel, axis->ticks.minor[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){x, bottom},
                       (fw_vec2){x, bottom + FW_AXIS_MINOR_TICK}, line);
    }
    double number = bottom + FW_AXIS_TICK + FW_AXIS_NUMBER_GAP;
    for (int k = 0; k < axis->ticks.count; ++k) {
        double x = fw_panel_x(panel, axis->ticks.at[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){x, bottom}, (fw_vec2){x, bottom + FW_AXIS_TICK},
                       line);
        if (axis->bare) continue;
        fw_canvas_text(
            panel->canvas, (fw_vec2){x, number}, axis->ticks.label[k],
            (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_CENTRE, FW_TEXT_TOP, 0, false});
    }
    if (axis->bare) return;
    double row = number + fw_canvas_line_height(FW_SMALL_SIZE) + FW_AXIS_LABEL_GAP;
    double right = panel->box.left + panel->box.width;
    double note = fw_canvas_text_width(axis->ticks.note, FW_SMALL_SIZE, false);
    fw_canvas_text(
        panel->canvas, (fw_vec2){right, row}, axis->ticks.note,
        (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_RIGHT, FW_TEXT_TOP, 0, false});
    if (!axis->label.text) return;
    /* In the middle, unless the note needs that room. */
    double room = panel->box.width + overhang;
    double size = fw_canvas_fitting_size(axis->label.text, FW_TEXT_SIZE, room);
    double width = fw_canvas_text_width(axis->label.text, size, false);
    double middle = panel->box.left + panel->box.width / 2;
    if (note > 0) middle = fmin(middle, right - note - 4 - width / 2);
    fw_canvas_text(panel->canvas, (fw_vec2){middle, row}, axis->label.text,
                   (fw_text_look){size, fw_colour_ink(), FW_TEXT_CENTRE, FW_TEXT_TOP, 0, false});
}

static void draw_y_axis(const fw_panel *panel, double label_place)
{
    const fw_stroke line = {fw_colour_ink(), .22, FW_DASH_NONE};
    const fw_axis *axis = &panel->y;
    double left = panel->box.left;
    for (int k = 0; k < axis->ticks.minor_count; ++k) {
        double y = fw_panel_y(panel, axis->ticks.minor[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){left, y}, (fw_vec2){left - FW_AXIS_MINOR_TICK, y},
                       line);
    }
    for (int k = 0; k < axis->ticks.count; ++k) {
        double y = fw_panel_y(panel, axis->ticks.at[k]);
        fw_canvas_line(panel->canvas, (fw_vec2){left, y}, (fw_vec2){left - FW_AXIS_TICK, y}, line);
        if (axis->bare) continue;
        fw_canvas_text(panel->canvas, (fw_vec2){left - FW_AXIS_TICK - FW_AXIS_NUMBER_GAP, y},
                       axis->ticks.label[k],
                       (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_RIGHT, FW_TEXT_MIDDLE,
                                      0, false});
    }
    if (axis->bare) return;
    fw_canvas_text(
        panel->canvas, (fw_vec2){left, panel->box.top - 1.1}, axis->ticks.note,
        (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_LEFT, FW_TEXT_BASELINE, 0, false});
    if (!axis->label.text) return;
    double depth = label_place > 0 ? label_place : fw_axis_depth(axis, false);
    double size = fw_canvas_fitting_size(axis->label.text, FW_TEXT_SIZE, panel->box.height);
    fw_canvas_text(panel->canvas, (fw_vec2){left - depth, panel->box.top + panel->box.height / 2},
                   axis->label.text,
                   (fw_text_look){size, fw_colour_ink(), FW_TEXT_CENTRE, FW_TEXT_TOP, 90, false});
}

void fw_panel_draw_axes(const fw_panel *panel, double label_place)
{
    fw_canvas_frame(panel->canvas, panel->box, (fw_stroke){fw_colour_ink(), .25, FW_DASH_NONE});
    if (!panel->x.hidden) draw_x_axis(panel);
    if (!panel->y.hidden) draw_y_axis(panel, label_place);
}

void fw_panel_say(const fw_panel *panel, const char *words)
{
    fw_canvas_text(
        panel->canvas,
        (fw_vec2){panel->box.left + panel->box.width / 2, panel->box.top + panel->box.height / 2},
        words,
        (fw_text_look){FW_TEXT_SIZE, fw_colour_grey(.5), FW_TEXT_CENTRE, FW_TEXT_MIDDLE, 0, false});
}

/* --- data --- */

/* A pen that hands points to the canvas in batches, so that a line of any length needs no memory.
 */
enum { PEN_POINTS = 1024 };
typedef struct line_pen {
    const fw_panel *panel;
    fw_stroke stroke;
    int count;
    fw_vec2 points[PEN_POINTS];
} line_pen;

static void lift_pen(line_pen *pen)
{
    if (pen->count > 1) {
        fw_canvas_polyline(pen->panel->canvas, pen->points, pen->count, false, pen->stroke);
    }
    pen->count = 0;
}

static void draw_to(line_pen *pen, fw_vec2 point)
{
    if (!isfinite(point.x) || !isfinite(point.y)) {
        lift_pen(pen);
        return;
    }
    if (pen->count == PEN_POINTS) {
        fw_vec2 last = pen->points[PEN_POINTS - 1];
        lift_pen(pen);
        pen->points[pen->count++] = last;
    }
    pen->points[pen->count++] = point;
}

static const double hair = .08; /* mm: nothing narrower is resolved on paper */

static bool is_crowded(const fw_panel *panel, const double *x, int count)
{
    if (count < 8 * panel->box.width / hair) return false;
    for (int k = 1; k < count; ++k) {
        if (!(x[k] >= x[k - 1])) return false;
    }
    return true;
}

/* First, least, greatest and last point of each hair's breadth. */
static void draw_crowded(line_pen *pen, const double *x, const double *y, int count)
{
    int k = 0;
    while (k < count) {
        fw_vec2 first = fw_panel_place(pen->panel, x[k], y[k]);
        fw_vec2 least = first, greatest = first, last = first;
        for (++k; k < count; ++k) {
            fw_vec2 next = fw_panel_place(pen->panel, x[k], y[k]);
            if (!(next.x - first.x < hair) || !isfinite(next.y) || !isfinite(first.y)) break;
            if (next.y < least.y) least = next;
            if (next.y > greatest.y) greatest = next;
            last = next;
        }
        draw_to(pen, first);
        draw_to(pen, least);
        draw_to(pen, greatest);
        draw_to(pen, last);
    }
}

void fw_panel_line(const fw_panel *panel, const double *x, const double *y, int count,
                   fw_stroke stroke)
{
    line_pen pen = {.panel = panel, .stroke = stroke};
    if (is_crowded(panel, x, count)) {
        draw_crowded(&pen, x, y, count);
    } else {
        for (int k = 0; k < count; ++k) draw_to(&pen, fw_panel_place(panel, x[k], y[k]));
    }
    lift_pen(&pen);
}

/* Where y - error and y + error lie; on a logarithmic axis what reaches zero ends at the bottom. */
static void place_error(const fw_panel *panel, double y, double error, double *lower, double *upper)
{
    double bottom = y - error;
    if (panel->y.logarithmic && !(bottom > 0)) bottom = panel->y.range.low;
    *lower = fw_panel_y(panel, bottom);
    *upper = fw_panel_y(panel, y + error);
}

void fw_panel_band(const fw_panel *panel, const double *x, const double *y, const double *error,
                   int count, fw_colour colour)
{
    enum { BATCH = 1024 };
    fw_vec2 rim[2 * BATCH];
    /* Finer than the paper needs nothing is lost in a band, which has no spikes. */
    int stride = 1 + (int)(count / (8 * panel->box.width / hair));
    int filled = 0;
    for (int k = 0; k < count + stride; k += stride) {
        double lower = NAN, upper = NAN, place = NAN;
        if (k < count) {
            place_error(panel, y[k], error[k], &lower, &upper);
            place = fw_panel_x(panel, x[k]);
        }
        bool good = isfinite(lower) && isfinite(upper) && isfinite(place);
        if (good) {
            /* The upper rim from the left of the array, the lower one from its right. */
            rim[filled] = (fw_vec2){place, upper};
            rim[2 * BATCH - 1 - filled] = (fw_vec2){place, lower};
            ++filled;
        }
        if (good && filled < BATCH) continue;
        if (filled > 1) {
            memmove(rim + filled, rim + 2 * BATCH - filled, (size_t)filled * sizeof *rim);
            fw_canvas_polygon(panel->canvas, rim, 2 * filled, colour, 0);
        }
        filled = 0;
        if (good) k -= stride; /* the next batch begins where this one ended */
    }
}

static bool is_inside(const fw_panel *panel, double x, double y)
{
    return x >= panel->x.range.low && x <= panel->x.range.high && y >= panel->y.range.low &&
           y <= panel->y.range.high;
}

void fw_panel_bars(const fw_panel *panel, const double *x, const double *y, const double *error,
                   const double *open, int count, fw_colour colour)
{
    const double half_cap = .7;
    for (int k = 0; k < count; ++k) {
        double lower, upper, place = fw_panel_x(panel, x[k]);
        place_error(panel, y[k], error[k], &lower, &upper);
        if (!isfinite(lower) || !isfinite(upper) || !is_inside(panel, x[k], y[k])) continue;
        lower = fmin(lower, panel->box.top + panel->box.height);
        upper = fmax(upper, panel->box.top);
        fw_vec2 strokes[6] = {{place, lower},
                              {place, upper},
                              {place - half_cap, lower},
                              {place + half_cap, lower},
                              {place - half_cap, upper},
                              {place + half_cap, upper}};
        const bool is_open = open && open[k] != 0;
        const fw_stroke line = {colour, .22, is_open ? FW_DASH_DOTS : FW_DASH_NONE};
        fw_canvas_segments(panel->canvas, strokes, is_open ? 1 : 3, line);
    }
}

void fw_panel_bars_across(const fw_panel *panel, const double *x, const double *y,
                          const double *error, int count, fw_colour colour)
{
    const double half_cap = .7;
    const fw_rect box = panel->box;
    for (int k = 0; k < count; ++k) {
        const double low = x[k] - error[k], place = fw_panel_y(panel, y[k]);
        const bool cut = panel->x.logarithmic && !(low > 0);
        double left = fw_panel_x(panel, cut ? panel->x.range.low : low);
        double right = fw_panel_x(panel, x[k] + error[k]);
        if (!isfinite(left) || !isfinite(right) || !is_inside(panel, x[k], y[k])) continue;
        left = fmax(left, box.left);
        right = fmin(right, box.left + box.width);
        fw_vec2 strokes[6] = {{left, place},
                              {right, place},
                              {left, place - half_cap},
                              {left, place + half_cap},
                              {right, place - half_cap},
                              {right, place + half_cap}};
        fw_canvas_segments(panel->canvas, strokes, 3, (fw_stroke){colour, .22, FW_DASH_NONE});
    }
}

void fw_panel_markers(const fw_panel *panel, const double *x, const double *y, int count,
                      double radius, fw_colour colour)
{
    for (int k = 0; k < count; ++k) {
        if (!is_inside(panel, x[k], y[k])) continue;
        fw_canvas_disc(panel->canvas, fw_panel_place(panel, x[k], y[k]), radius, colour);
    }
}
