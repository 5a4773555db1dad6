/* SPDX-License-Identifier: GPL-3.0-or-later */
/* chart.h - curves with errors in a panel, and their legend. */
#ifndef FW_CHART_H
#define FW_CHART_H

#include "experiments/drawing/legend.h"
#include "experiments/drawing/panel.h"

typedef enum fw_curve_look {
    FW_CURVE_LINE,
    FW_CURVE_DASHES,
    FW_CURVE_MARKERS,
    FW_CURVE_LINE_AND_MARKERS
} fw_curve_look;

/* Colours of a curve: the next one of the palette, a certain one (1, 2, ...), grey for controls. */
enum { FW_CURVE_NEXT_COLOUR = 0, FW_CURVE_GREY = -1 };

typedef struct fw_curve {
    const char *label; /* NULL: not in the legend */
    int count;
    const double *x, *y;
    const double *error; /* standard error of y: a band, or bars on markers; may be NULL */
    const double *open;  /* not 0: that error is a lower bound, its bar dotted; NULL: none is */
    fw_curve_look look;
    int colour;
    const double *spread; /* standard error of x: bars on markers; may be NULL */
} fw_curve;

/* A panel of curves. */
typedef struct fw_chart {
    fw_label label; /* what y is */
    const fw_curve *curves;
    int curve_count;
    bool logarithmic;
    fw_range range; /* of y; where high <= low it comes from the curves */
    double height;  /* mm; 0: chosen */
} fw_chart;

/* Widen the ranges by the curves, errors included; by positive numbers only, if wanted. */
void fw_chart_include_x(fw_range *range, const fw_chart *chart, bool positive_only);
void fw_chart_include_y(fw_range *range, const fw_chart *chart);

/* What the y axis spans: the chart's own range, or that of its curves with room around them. */
fw_range fw_chart_range_of_y(const fw_chart *chart);

/* Entries for the labelled curves; returns how many. */
enum { FW_CHART_LEGEND_MAX = 24 };
int fw_chart_legend(const fw_chart *chart, fw_legend_entry entries[FW_CHART_LEGEND_MAX]);

/* Bands, then lines, then markers; what is grey lies below the rest. */
void fw_chart_draw(const fw_chart *chart, const fw_panel *panel);

#endif
