/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_forces.c - deformed bodies with the forces on their particles.
 * Keeps no state. Invariant: one length of arrow means one force in all panels. Start reading at
 * fw_figure_forces(). */
#include "colour_bar.h"
#include "experiments/drawing/figure.h"
#include "experiments/drawing/legend.h"
#include "view_arrows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A body to draw, and what is needed of it again and again. */
typedef struct forces_panel {
    fw_figure_forces_panel of;
    fw_view_bounds bounds; /* of its particles, original and present */
    bool is_chain;         /* straight and horizontal: everything would lie on one line */
    double shortest_link;  /* originally; without links as far as particles are apart */
} forces_panel;

typedef struct forces_plan {
    forces_panel *panels;
    int panel_count;
} forces_plan;

static const double chain_height = 22, name_height = 5.2, panel_gap = 2.5; /* mm */
static const double disc_radius = .95, ring_radius = 1.25; /* mm, where links are long enough */

static const fw_stroke thin_arrow = {{0, .447, .698, 1}, .38, FW_DASH_NONE};
static const fw_stroke fat_arrow = {{.835, .369, 0, 1}, 1.15, FW_DASH_NONE};
static const double thin_head = 1.9, fat_head = 3.4; /* mm */

static fw_view_bounds bounds_of(const fw_figure_forces_panel *of)
{
    fw_view_bounds bounds = fw_view_bounds_empty();
    fw_range_include(&bounds.x, of->original_x, of->count, false);
    fw_range_include(&bounds.x, of->x, of->count, false);
    fw_range_include(&bounds.y, of->original_y, of->count, false);
    fw_range_include(&bounds.y, of->y, of->count, false);
    return bounds;
}

static double shortest_link(const fw_figure_forces_panel *of, double width, double height)
{
    double shortest = INFINITY;
    for (int k = 0; k < of->link_count; ++k) {
        int a = of->links[2 * k], b = of->links[2 * k + 1];
        double length =
            hypot(of->original_x[a] - of->original_x[b], of->original_y[a] - of->original_y[b]);
        if (length > 0) shortest = fmin(shortest, length);
    }
    if (isfinite(shortest)) return shortest;
    /* On a square lattice that fills the same rectangle, or on a line as long. */
    const double line = fmax(width, height) / fmax(of->count - 1, 1);
    const double apart = fmax(sqrt(width * height / fmax(of->count, 1)), line);
    return apart > 0 ? apart : 1;
}

static forces_panel measure(const fw_figure_forces_panel *of)
{
    const fw_view_bounds bounds = bounds_of(of);
    const double width = bounds.x.high - bounds.x.low, height = bounds.y.high - bounds.y.low;
    return (forces_panel){.of = *of,
                          .bounds = bounds,
                          .is_chain = width > 0 && height <= 1e-6 * width,
                          .shortest_link = shortest_link(of, width, height)};
}

static fw_range with_room(fw_range range, double room)
{
    if (fw_range_is_empty(range)) range = (fw_range){0, 0};
    return (fw_range){range.low - room, range.high + room};
}

/* Chains share their x axis; other bodies have their own. */
static void choose_ranges(const forces_plan *plan, fw_panel *panels)
{
    fw_range chains = fw_range_empty();
    double room = 0;
    for (int k = 0; k < plan->panel_count; ++k) {
        if (!plan->panels[k].is_chain) continue;
        const fw_view_bounds bounds = plan->panels[k].bounds;
        fw_range_include(&chains, (double[]){bounds.x.low, bounds.x.high}, 2, false);
        room = fmax(room, .55 * plan->panels[k].shortest_link);
    }
    /* A chain of few long links needs no more than a tenth of its length. */
    room = fmin(room, .1 * (chains.high - chains.low));
    for (int k = 0; k < plan->panel_count; ++k) {
        const forces_panel *body = &plan->panels[k];
        const fw_view_bounds bounds = body->bounds;
        double own_room = .6 * body->shortest_link;
        panels[k].x.range =
            body->is_chain ? with_room(chains, room) : with_room(bounds.x, own_room);
        panels[k].y.range = body->is_chain ? (fw_range){-1, 1} : with_room(bounds.y, own_room);
    }
}

/* Chains one below the other over the whole width. */
static double place_chain(const fw_page *page, const forces_plan *plan, int number, fw_panel *panel,
                          double top)
{
    double width = page->width - 2 * FW_PAGE_MARGIN - 2;
    bool followed = number + 1 < plan->panel_count && plan->panels[number + 1].is_chain;
    panel->x.bare = followed;
    panel->box = (fw_rect){FW_PAGE_MARGIN + 1, 0, width, chain_height};
    panel->box.top = top + (plan->panels[number].of.name ? name_height : 0);
    fw_axis_prepare(&panel->x, width, true);
    return panel->box.top + chain_height + fw_axis_depth(&panel->x, true);
}

/* The panel of another body, as if its column were the page. */
static double place_body(const fw_page *page, const forces_panel *body, fw_panel *panel, int column,
                         int columns, double top)
{
    fw_page part = *page;
    part.width = page->width / columns;
    fw_page_fit_equal(&part, panel, 3, 20, .62 * page->width);
    panel->box.left += column * part.width;
    panel->box.top = top + (body->of.name ? name_height : 0) + fw_axis_note_height(&panel->y);
    return panel->box.top + panel->box.height + fw_axis_depth(&panel->x, true);
}

/* Returns where the lowest panel ends. Other bodies than chains stand two in a row. */
static double lay_out(const fw_page *page, const forces_plan *plan, fw_panel *panels, double top)
{
    double bottom = top;
    for (int k = 0; k < plan->panel_count;) {
        double row_top = bottom > top ? bottom + panel_gap : top;
        if (plan->panels[k].is_chain) {
            bottom = place_chain(page, plan, k, &panels[k], row_top);
            k += 1;
            continue;
        }
        bool pair = k + 1 < plan->panel_count && !plan->panels[k + 1].is_chain;
        /* The last of an odd number is as large as the others. */
        int columns = pair || (k > 0 && !plan->panels[k - 1].is_chain) ? 2 : 1;
        for (int column = 0; column <= (int)pair; ++column, ++k)
            bottom = fmax(bottom,
                          place_body(page, &plan->panels[k], &panels[k], column, columns, row_top));
    }
    return bottom;
}

static double largest_force(const forces_plan *plan, bool external)
{
    double largest = 0;
    for (int k = 0; k < plan->panel_count; ++k) {
        for (int f = 0; f < plan->panels[k].of.force_count; ++f) {
            const fw_figure_force *force = &plan->panels[k].of.forces[f];
            double size = hypot(force->force.x, force->force.y);
            if (force->external == external && isfinite(size)) largest = fmax(largest, size);
        }
    }
    return largest;
}

/* mm per force, such that no arrow is longer than 14 mm or shorter than can be helped: internal
 * ones take less than half of the shortest link, so that those of two neighbours do not meet,
 * external ones no more than the room round the body. */
static double choose_force_scale(const forces_plan *plan, const fw_panel *panels)
{
    double internal = largest_force(plan, false), external = largest_force(plan, true);
    double scale = INFINITY;
    for (int k = 0; k < plan->panel_count; ++k) {
        double link = plan->panels[k].shortest_link * fw_panel_scale(&panels[k]);
        if (internal > 0) scale = fmin(scale, fmin(14, fmax(.42 * link, 4)) / internal);
        if (external > 0) scale = fmin(scale, fmin(14, fmax(.55 * link, 4)) / external);
    }
    return isfinite(scale) ? scale : 0;
}

/* Where a particle lies on the paper. In the panel of a chain the original places form the upper
 * row, the present ones the lower. */
static fw_vec2 place_of(const forces_panel *body, const fw_panel *panel, int particle,
                        bool original)
{
    double x = original ? body->of.original_x[particle] : body->of.x[particle];
    double y = original ? body->of.original_y[particle] : body->of.y[particle];
    fw_vec2 place = fw_panel_place(panel, x, y);
    if (body->is_chain) place.y = panel->box.top + (original ? .26 : .66) * panel->box.height;
    return place;
}

static void draw_links(const forces_panel *body, const fw_panel *panel, bool original)
{
    const fw_stroke line = {fw_colour_grey(original ? .72 : .55), original ? .2 : .35,
                            original ? FW_DASH_LONG : FW_DASH_NONE};
    for (int k = 0; k < body->of.link_count; ++k) {
        fw_canvas_line(panel->canvas, place_of(body, panel, body->of.links[2 * k], original),
                       place_of(body, panel, body->of.links[2 * k + 1], original), line);
    }
}

/* Small where links are short, so that arrows come out from behind them and neighbours do not
 * touch. */
static double particle_size(const forces_panel *body, const fw_panel *panel)
{
    const double link = body->shortest_link * fw_panel_scale(panel);
    return fmin(fmin(1, fmax(.35, link / 14)), .3 * link / ring_radius);
}

static void draw_particles(const forces_panel *body, const fw_panel *panel)
{
    const fw_stroke rim = {fw_colour_grey(.35), .28, FW_DASH_NONE};
    const fw_stroke guide = {fw_colour_grey(.45), .18, FW_DASH_DOTS};
    double size = body->is_chain ? 1 : particle_size(body, panel);
    for (int k = 0; k < body->of.count; ++k) {
        fw_vec2 from = place_of(body, panel, k, true), to = place_of(body, panel, k, false);
        fw_canvas_line(panel->canvas, from, to, guide);
        fw_canvas_disc(panel->canvas, from, size * ring_radius, fw_colour_grey(1));
        fw_canvas_circle(panel->canvas, from, size * ring_radius, rim);
    }
    for (int k = 0; k < body->of.count; ++k) {
        fw_canvas_disc(panel->canvas, place_of(body, panel, k, false), size * disc_radius,
                       fw_colour_grey(.15));
    }
}

static void draw_arrows(const forces_panel *body, const fw_panel *panel, double scale,
                        bool external)
{
    for (int k = 0; k < body->of.force_count; ++k) {
        const fw_figure_force *force = &body->of.forces[k];
        fw_vec2 arrow = {scale * force->force.x, -scale * force->force.y};
        if (force->external != external || hypot(arrow.x, arrow.y) < .15) continue;
        fw_vec2 from = place_of(body, panel, force->particle, false);
        fw_canvas_arrow(panel->canvas, from, fw_vec2_add(from, arrow),
                        external ? fat_arrow : thin_arrow, external ? fat_head : thin_head);
    }
}

static void draw_panel(const forces_panel *body, const fw_panel *panel, double scale)
{
    fw_canvas_clip(panel->canvas, panel->box);
    draw_links(body, panel, true);
    draw_links(body, panel, false);
    draw_arrows(body, panel, scale, true);
    draw_particles(body, panel);
    draw_arrows(body, panel, scale, false);
    fw_canvas_unclip(panel->canvas);
    fw_panel_draw_axes(panel, 0);
    double note = body->is_chain ? 0 : fw_axis_note_height(&panel->y);
    if (!body->of.name) return;
    fw_canvas_text(
        panel->canvas, (fw_vec2){panel->box.left, panel->box.top - 1.3 - note}, body->of.name,
        (fw_text_look){FW_TEXT_SIZE, fw_colour_grey(.1), FW_TEXT_LEFT, FW_TEXT_BASELINE, 0, false});
}

typedef struct forces_legend {
    int count;
    fw_legend_entry entries[5];
    char scale_label[48];
} forces_legend;

static void add_entry(forces_legend *legend, fw_legend_entry entry)
{
    legend->entries[legend->count++] = entry;
}

/* What is drawn, and how long an arrow is. */
static void describe(forces_legend *legend, double internal, double external, double scale,
                     fw_label unit)
{
    const double largest = fmax(internal, external);
    legend->count = 0;
    add_entry(legend, (fw_legend_entry){"original", fw_colour_grey(.35), FW_LEGEND_RING, 0});
    add_entry(legend, (fw_legend_entry){"deformed", fw_colour_grey(.15), FW_LEGEND_DISC, 0});
    if (internal > 0)
        add_entry(legend,
                  (fw_legend_entry){"internal force", thin_arrow.colour, FW_LEGEND_ARROW, 0});
    if (external > 0)
        add_entry(legend,
                  (fw_legend_entry){"external force", fat_arrow.colour, FW_LEGEND_FAT_ARROW, 0});
    if (!(largest > 0)) return;
    const double shown =
        fw_view_arrows_print(legend->scale_label, sizeof legend->scale_label, largest, unit);
    add_entry(legend, (fw_legend_entry){legend->scale_label, fw_colour_grey(.1), FW_LEGEND_ARROW,
                                        scale * shown});
}

static fw_status draw_all(const fw_page *page, const forces_plan *plan, fw_panel *panels,
                          fw_error *error)
{
    double top = fw_page_top(page), width = page->width - 2 * FW_PAGE_MARGIN;
    const double internal = largest_force(plan, false), external = largest_force(plan, true);
    forces_legend legend;
    describe(&legend, internal, external, 1, page->force);
    lay_out(page, plan, panels, top + fw_legend_height(legend.entries, legend.count, width));
    double scale = choose_force_scale(plan, panels);
    describe(&legend, internal, external, scale, page->force);
    /* The scale arrow may have made the legend higher. */
    double bottom =
        lay_out(page, plan, panels, top + fw_legend_height(legend.entries, legend.count, width));
    fw_canvas *canvas;
    FW_TRY(fw_page_open(page, bottom, &canvas, error));
    fw_legend_draw(legend.entries, legend.count, canvas, (fw_vec2){FW_PAGE_MARGIN, top}, width);
    for (int k = 0; k < plan->panel_count; ++k) {
        panels[k].canvas = canvas;
        draw_panel(&plan->panels[k], &panels[k], scale);
    }
    return fw_page_close(canvas, FW_OK, error);
}

fw_status fw_figure_forces(const fw_page *page, const fw_figure_forces_plan *plan, fw_error *error)
{
    const int count = plan->panel_count;
    if (count < 1) {
        return fw_fail(error, FW_BAD_INPUT, "the picture '%s' has no body to show", page->file);
    }
    fw_panel *panels = calloc((size_t)count, sizeof *panels);
    const forces_plan measured = {calloc((size_t)count, sizeof *measured.panels), count};
    fw_status status =
        panels && measured.panels ? FW_OK : fw_fail_memory(error, "the panels of a picture");
    for (int k = 0; k < count && status == FW_OK; ++k) {
        measured.panels[k] = measure(&plan->panels[k]);
        panels[k].x.label = page->x_label;
        panels[k].y.label = page->y_label;
        panels[k].y.hidden = measured.panels[k].is_chain;
    }
    if (status == FW_OK) {
        choose_ranges(&measured, panels);
        status = draw_all(page, &measured, panels, error);
    }
    free(measured.panels);
    free(panels);
    return status;
}
