/* SPDX-License-Identifier: GPL-3.0-or-later */
/* chart.c - curves.
 * Keeps no state. Start reading at fw_chart_draw(). */
#include "experiments/drawing/chart.h"

#include <math.h>

void fw_chart_include_x(fw_range *range, const fw_chart *chart, bool positive_only)
{
    for (int k = 0; k < chart->curve_count; ++k) {
        const fw_curve *curve = &chart->curves[k];
        fw_range_include(range, curve->x, curve->count, positive_only);
        for (int i = 0; curve->spread && i < curve->count; ++i) {
            double ends[2] = {curve->x[i] - curve->spread[i], curve->x[i] + curve->spread[i]};
            fw_range_include(range, ends, 2, positive_only);
        }
    }
}

void fw_chart_include_y(fw_range *range, const fw_chart *chart)
{
    for (int k = 0; k < chart->curve_count; ++k) {
        const fw_curve *curve = &chart->curves[k];
        fw_range_include(range, curve->y, curve->count, chart->logarithmic);
        for (int i = 0; curve->error && i < curve->count; ++i) {
            double ends[2] = {curve->y[i] - curve->error[i], curve->y[i] + curve->error[i]};
            fw_range_include(range, ends, 2, chart->logarithmic);
        }
    }
}

fw_range fw_chart_range_of_y(const fw_chart *chart)
{
    if (chart->range.high > chart->range.low)
        return fw_range_roomy(chart->range, 0, chart->logarithmic);
    fw_range y = fw_range_empty();
    fw_chart_include_y(&y, chart);
    if (chart->logarithmic) return fw_range_roomy(y, .05, true);
    y = fw_range_up_from_zero(fw_range_without_rounding(y));
    /* What is positive and not far from zero is seen best against zero. */
    if (y.low >= 0 && y.low < .25 * y.high) y.low = 0;
    return fw_range_roomy(y, .05, false);
}

static fw_colour colour_of(const fw_chart *chart, int number)
{
    int next = 0;
    for (int k = 0; k < number; ++k) next += chart->curves[k].colour == FW_CURVE_NEXT_COLOUR;
    int wish = chart->curves[number].colour;
    if (wish == FW_CURVE_GREY) return fw_colour_grey(.6);
    return fw_palette_kind(wish == FW_CURVE_NEXT_COLOUR ? next : wish - 1);
}

int fw_chart_legend(const fw_chart *chart, fw_legend_entry entries[FW_CHART_LEGEND_MAX])
{
    static const fw_legend_look looks[] = {[FW_CURVE_LINE] = FW_LEGEND_LINE,
                                           [FW_CURVE_DASHES] = FW_LEGEND_DASHES,
                                           [FW_CURVE_MARKERS] = FW_LEGEND_DISC,
                                           [FW_CURVE_LINE_AND_MARKERS] = FW_LEGEND_LINE_AND_DISC};
    int count = 0;
    for (int k = 0; k < chart->curve_count && count < FW_CHART_LEGEND_MAX; ++k) {
        const fw_curve *curve = &chart->curves[k];
        if (!curve->label) continue;
        entries[count++] =
            (fw_legend_entry){curve->label, colour_of(chart, k), looks[curve->look], 0};
    }
    return count;
}

static bool has_markers(const fw_curve *curve)
{
    /* A line of one point would not be seen. */
    return curve->look == FW_CURVE_MARKERS || curve->look == FW_CURVE_LINE_AND_MARKERS ||
           curve->count == 1;
}

static void draw_line(const fw_curve *curve, const fw_panel *panel, fw_colour colour)
{
    fw_dash dash = curve->look == FW_CURVE_DASHES ? FW_DASH_LONG : FW_DASH_NONE;
    if (curve->error && !has_markers(curve)) {
        fw_panel_band(panel, curve->x, curve->y, curve->error, curve->count,
                      fw_colour_fade(colour, .22));
    }
    if (curve->look != FW_CURVE_MARKERS) {
        fw_panel_line(panel, curve->x, curve->y, curve->count, (fw_stroke){colour, .4, dash});
    }
}

static void draw_markers(const fw_curve *curve, const fw_panel *panel, fw_colour colour)
{
    double radius = curve->count > 100 ? .55 : .85;
    if (!has_markers(curve)) return;
    if (curve->error) {
        fw_panel_bars(panel, curve->x, curve->y, curve->error, curve->open, curve->count, colour);
    }
    if (curve->spread) {
        fw_panel_bars_across(panel, curve->x, curve->y, curve->spread, curve->count, colour);
    }
    fw_panel_markers(panel, curve->x, curve->y, curve->count, radius, colour);
}

void fw_chart_draw(const fw_chart *chart, const fw_panel *panel)
{
    for (int layer = 0; layer < 4; ++layer) {
        bool grey = layer % 2 == 0, markers = layer >= 2;
        if (!markers) fw_canvas_clip(panel->canvas, panel->box);
        for (int k = 0; k < chart->curve_count; ++k) {
            const fw_curve *curve = &chart->curves[k];
            if ((curve->colour == FW_CURVE_GREY) != grey) continue;
            if (markers) {
                draw_markers(curve, panel, colour_of(chart, k));
            } else {
                draw_line(curve, panel, colour_of(chart, k));
            }
        }
        if (!markers) fw_canvas_unclip(panel->canvas);
    }
}
