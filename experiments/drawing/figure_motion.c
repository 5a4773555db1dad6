/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_motion.c - a body that moves: several instants in one panel.
 * Keeps no state. Start reading at fw_figure_motion(). */
#include "colour_bar.h"
#include "experiments/drawing/figure.h"
#include "experiments/drawing/legend.h"

#include <math.h>
#include <stdio.h>

/* Up to so many instants each is named in the legend, beyond that a colour bar shows the step. */
enum { NAMED_INSTANTS = 10 };

typedef struct motion_layout {
    fw_panel panel;
    fw_colour_bar bar;
    bool has_bar;
    int entry_count;
    fw_legend_entry entries[NAMED_INSTANTS + 1];
    char labels[NAMED_INSTANTS][64];
    double legend_top, legend_width;
} motion_layout;

/* The map without its darkest end, which is hardly told from the path, nor its palest, which is
 * faint on white. */
static const double FIRST_COLOUR = .16;

static fw_colour colour_of_instant(const fw_figure_motion_plan *plan, int number)
{
    int count = plan->view_count;
    double part = count > 1 ? number / (count - 1.) : 0;
    if (count > NAMED_INSTANTS) {
        double first = (double)plan->views[0].step, last = (double)plan->views[count - 1].step;
        part = last > first ? ((double)plan->views[number].step - first) / (last - first) : 0;
    }
    const double last = count > NAMED_INSTANTS ? 1 : .93;
    return fw_palette_at(FW_PALETTE_SEQUENTIAL, FIRST_COLOUR + (last - FIRST_COLOUR) * part);
}

/* Mixed with so much white, and so opaque. */
static fw_colour with_white(fw_colour colour, double white, double alpha)
{
    return (fw_colour){colour.red + white * (1 - colour.red),
                       colour.green + white * (1 - colour.green),
                       colour.blue + white * (1 - colour.blue), alpha};
}

static void describe_instants(const fw_figure_motion_plan *plan, motion_layout *layout)
{
    layout->has_bar = plan->view_count > NAMED_INSTANTS;
    for (int k = 0; k < plan->view_count && !layout->has_bar; ++k) {
        fw_view_print_name(&plan->views[k], layout->labels[k], sizeof layout->labels[k]);
        layout->entries[layout->entry_count++] =
            (fw_legend_entry){layout->labels[k], colour_of_instant(plan, k), FW_LEGEND_DISC, 0};
    }
    if (plan->path_count > 0) {
        layout->entries[layout->entry_count++] =
            (fw_legend_entry){"centre of mass", fw_colour_grey(.1), FW_LEGEND_LINE, 0};
    }
}

static fw_view_bounds bounds_of_motion(const fw_figure_motion_plan *plan)
{
    fw_view_bounds bounds = fw_view_bounds_or_empty(plan->bounds);
    for (int k = 0; k < plan->view_count; ++k) {
        fw_view_bounds_include_bodies(&bounds, &plan->views[k]);
    }
    for (int k = 0; k < plan->path_count; ++k) {
        fw_range_include(&bounds.x, plan->paths[k].x, plan->paths[k].count, false);
        fw_range_include(&bounds.y, plan->paths[k].y, plan->paths[k].count, false);
    }
    if (fw_view_bounds_are_unset(plan->bounds))
        fw_view_bounds_include_walls(&bounds, plan->views, plan->view_count);
    return bounds;
}

static fw_colour_bar step_bar(const fw_figure_motion_plan *plan, double height)
{
    fw_colour_scale scale = {
        .label = {"step", 0},
        .map = FW_PALETTE_SEQUENTIAL,
        .range = {(double)plan->views[0].step, (double)plan->views[plan->view_count - 1].step}};
    scale.range = fw_range_roomy(scale.range, 0, false);
    return fw_colour_bar_for(scale, height);
}

static void lay_out(const fw_page *page, const fw_figure_motion_plan *plan, motion_layout *layout)
{
    fw_panel *panel = &layout->panel;
    fw_view_bounds bounds = bounds_of_motion(plan);
    panel->x = fw_page_axis(page->x_range, fw_range_roomy(bounds.x, .035, false), page->x_label);
    panel->y = fw_page_axis(page->y_range, fw_range_roomy(bounds.y, .035, false), page->y_label);
    describe_instants(plan, layout);
    double right = 3;
    for (int round = 0; round < 2; ++round) {
        fw_page_fit_equal(page, panel, right, 18, 1.05 * page->width);
        right = fw_axis_overhang(&panel->x, panel->box.width);
        if (!layout->has_bar) continue;
        layout->bar = step_bar(plan, panel->box.height);
        right = fmax(right, fw_colour_bar_width(&layout->bar));
    }
    layout->legend_top = fw_page_top(page);
    layout->legend_width = page->width - 2 * FW_PAGE_MARGIN;
    panel->box.top = layout->legend_top +
                     fw_legend_height(layout->entries, layout->entry_count, layout->legend_width) +
                     fw_axis_note_height(&panel->y);
}

static long particle_count(const fw_figure_motion_plan *plan)
{
    long particles = 0;
    for (int k = 0; k < plan->view_count; ++k) particles += fw_view_count(&plan->views[k]);
    return particles;
}

/* A path goes over the bodies; but it would hide a lone particle. */
static bool is_lone(const fw_view_body *body)
{
    return body->count == 1;
}

/* Of the lone bodies, or of the others. */
static fw_status draw_instants(const fw_figure_motion_plan *plan, const fw_panel *panel, bool lone,
                               fw_error *error)
{
    fw_status status = FW_OK;
    bool raster = particle_count(plan) > 6000 && !lone;
    if (raster) fw_canvas_raster_begin(panel->canvas, panel->box);
    for (int k = 0; k < plan->view_count && status == FW_OK; ++k) {
        fw_colour colour = colour_of_instant(plan, k);
        for (int b = 0; b < plan->views[k].body_count && status == FW_OK; ++b) {
            const fw_view_body *body = &plan->views[k].bodies[b];
            if (is_lone(body) != lone) continue;
            double spacing = fw_view_spacing(body) * fw_panel_scale(panel);
            /* Without links a body that lies on another one could not be distinguished from it. */
            if (body->link_count == 0 && !lone && plan->view_count > 1)
                status = fw_view_draw_silhouette(body, panel, with_white(colour, .78, .7), error);
            fw_view_draw_links(
                body, panel,
                (fw_stroke){fw_colour_fade(colour, .55), fmin(.18, .12 * spacing), FW_DASH_NONE});
            fw_view_draw_discs(body, panel, lone ? 1.15 : fmin(fmax(.27 * spacing, .2), 1), colour);
        }
    }
    if (raster) fw_canvas_raster_end(panel->canvas);
    return status;
}

/* Length of a path on the paper. With `apart` > 0: draws an arrow head about every so many mm, the
 * first after half of that, each where the path has gone straight for the length of the head. */
static double walk_path(const fw_figure_path *path, const fw_panel *panel, double apart)
{
    const fw_stroke line = {fw_colour_grey(.1), .5, FW_DASH_NONE};
    const double head = 3.4;
    double walked = 0, next = apart / 2, straight = 0;
    fw_vec2 heading = {0, 0};
    fw_vec2 from = fw_panel_place(panel, path->x[0], path->y[0]);
    for (int k = 1; k < path->count; ++k) {
        fw_vec2 to = fw_panel_place(panel, path->x[k], path->y[k]);
        double step = hypot(to.x - from.x, to.y - from.y);
        /* Steps that are too small to see have no direction either. */
        if (!isfinite(step) || step < .3) continue;
        fw_vec2 along = fw_vec2_scale(1 / step, fw_vec2_subtract(to, from));
        if (fw_vec2_dot(along, heading) < .985) {
            heading = along;
            straight = 0;
        }
        while (apart > 0 && next <= walked + step) {
            if (straight + next - walked < head) {
                next += .5;
                continue;
            }
            fw_vec2 tip = fw_vec2_add(from, fw_vec2_scale(next - walked, along));
            fw_canvas_arrow(panel->canvas, fw_vec2_subtract(tip, fw_vec2_scale(head, along)), tip,
                            line, 3.3);
            next += apart;
        }
        walked += step;
        straight += step;
        from = to;
    }
    return walked;
}

/* Arrow heads about 40 mm apart, at least one. */
static void draw_directions(const fw_figure_path *path, const fw_panel *panel)
{
    double length = walk_path(path, panel, 0);
    if (length > 5) walk_path(path, panel, length / fmax(1, nearbyint(length / 40)));
}

/* Cased in white, to be seen on the bodies. */
static void draw_path(const fw_figure_path *path, const fw_panel *panel)
{
    const fw_colour white = fw_colour_grey(1);
    const fw_stroke line = {fw_colour_grey(.1), .45, FW_DASH_NONE};
    if (path->count < 1) return;
    fw_vec2 start = fw_panel_place(panel, path->x[0], path->y[0]);
    fw_panel_line(panel, path->x, path->y, path->count, (fw_stroke){white, 1.1, FW_DASH_NONE});
    fw_canvas_circle(panel->canvas, start, 1.15, (fw_stroke){white, 1.1, FW_DASH_NONE});
    fw_panel_line(panel, path->x, path->y, path->count, line);
    fw_canvas_circle(panel->canvas, start, 1.15, line);
    draw_directions(path, panel);
}

static fw_status draw(const fw_figure_motion_plan *plan, const motion_layout *layout,
                      fw_error *error)
{
    const fw_panel *panel = &layout->panel;
    fw_canvas_clip(panel->canvas, panel->box);
    if (plan->view_count > 0)
        fw_view_draw_walls(&plan->views[plan->view_count - 1], panel, false, 1);
    for (int k = 0; k < plan->view_count - 1; ++k)
        fw_view_draw_moved(&plan->views[k], &plan->views[plan->view_count - 1], panel,
                           (fw_stroke){colour_of_instant(plan, k), .35, FW_DASH_NONE});
    fw_status status = draw_instants(plan, panel, false, error);
    for (int k = 0; k < plan->path_count; ++k) draw_path(&plan->paths[k], panel);
    if (status == FW_OK) status = draw_instants(plan, panel, true, error);
    if (plan->view_count > 0) fw_view_draw_surfaces(&plan->views[plan->view_count - 1], panel);
    fw_canvas_unclip(panel->canvas);
    if (plan->view_count == 0) fw_panel_say(panel, "no particles");
    fw_panel_draw_axes(panel, 0);
    fw_legend_draw(layout->entries, layout->entry_count, panel->canvas,
                   (fw_vec2){FW_PAGE_MARGIN, layout->legend_top}, layout->legend_width);
    if (layout->has_bar) {
        fw_colour_bar_draw(&layout->bar, panel->canvas, panel->box.left + panel->box.width,
                           panel->box.top, panel->box.height);
    }
    return status;
}

fw_status fw_figure_motion(const fw_page *page, const fw_figure_motion_plan *plan, fw_error *error)
{
    motion_layout layout = {.entry_count = 0};
    lay_out(page, plan, &layout);
    fw_panel *panel = &layout.panel;
    double bottom = panel->box.top + panel->box.height + fw_axis_depth(&panel->x, true);
    FW_TRY(fw_page_open(page, bottom, &panel->canvas, error));
    const fw_status status = draw(plan, &layout, error);
    return fw_page_close(panel->canvas, status, error);
}
