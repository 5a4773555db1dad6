/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view_arrows.c - forces as arrows. Keeps no state. Start reading at fw_view_arrows_for(). */
#include "view_arrows.h"

#include "experiments/drawing/ticks.h"

#include <math.h>
#include <stdio.h>

/* Shorter arrows, in mm, would be dots. */
static const double SHORTEST = .7;

static const fw_stroke halo = {{1, 1, 1, 1}, 1.05, FW_DASH_NONE};
static const fw_stroke line = {{.07, .07, .07, 1}, .45, FW_DASH_NONE};
static const double head = 1.7;

/* The largest of 1, 2, 5 times a power of ten that is not above the value. */
static double rounded(double value)
{
    const double unit = pow(10, floor(log10(value)));
    return (value >= 5 * unit ? 5 : value >= 2 * unit ? 2 : 1) * unit;
}

double fw_view_arrows_print(char *text, size_t size, double value, fw_label unit)
{
    char number[32];
    const double shown = rounded(fw_label_shown(unit, value));
    fw_ticks_print_number(number, sizeof number, shown, 3);
    snprintf(text, size, "force of %s%s%s", number, unit.text ? " " : "",
             unit.text ? unit.text : "");
    return unit.factor > 0 ? shown / unit.factor : shown;
}

static double largest_in(const fw_view *view)
{
    double largest = 0;
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        for (int i = 0; body->force_x && i < body->count; ++i) {
            const double size = hypot(body->force_x[i], body->force_y[i]);
            if (isfinite(size)) largest = fmax(largest, size);
        }
    }
    return largest;
}

void fw_view_arrows_for(fw_view_arrows *arrows, const fw_view *views, int view_count, double length,
                        fw_label unit)
{
    *arrows = (fw_view_arrows){.largest = 0};
    for (int k = 0; k < view_count; ++k)
        arrows->largest = fmax(arrows->largest, largest_in(&views[k]));
    if (!(arrows->largest > 0)) return;
    arrows->scale = length / arrows->largest;
    const double shown =
        fw_view_arrows_print(arrows->label, sizeof arrows->label, arrows->largest, unit);
    arrows->entry =
        (fw_legend_entry){arrows->label, line.colour, FW_LEGEND_ARROW, arrows->scale * shown};
}

void fw_view_arrows_draw(const fw_view_arrows *arrows, const fw_view *view, const fw_panel *panel)
{
    for (int layer = 0; layer < 2; ++layer)
        for (int b = 0; b < view->body_count; ++b) {
            const fw_view_body *body = &view->bodies[b];
            for (int i = 0; body->force_x && i < body->count; ++i) {
                const fw_vec2 arrow = {arrows->scale * body->force_x[i],
                                       -arrows->scale * body->force_y[i]};
                if (!(hypot(arrow.x, arrow.y) >= SHORTEST)) continue;
                const fw_vec2 from = fw_panel_place(panel, body->x[i], body->y[i]);
                fw_canvas_arrow(panel->canvas, from, fw_vec2_add(from, arrow),
                                layer == 0 ? halo : line, head);
            }
        }
}
