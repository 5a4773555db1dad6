/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot.h - pictures of a result: from a results folder to the figures of figure.h. */
#ifndef FW_PLOT_H
#define FW_PLOT_H

#include "core/status.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* What is to be drawn. All zero: the first picture that the scenario names, or the motion. */
/* How many results a series is compared with, at most. */
enum { FW_PLOT_WITH_MAX = 8 };

typedef struct fw_plot_wish {
    const char *file;    /* ends in .png, .svg or .pdf; NULL: NAME.png in the results folder */
    const char *picture; /* one of the scenario's, or NULL */
    const char *kind;    /* a name of picture_kind.h, or NULL */
    const char *field;   /* whose values are colours; NULL: the picture's own, or the first */
    const char *const *observables; /* of a series: "energy", "elongation.chain", "momentum.x" */
    int observable_count;           /* 0: the picture's own, or the energies */
    const int64_t *steps;           /* that are drawn; of a series, its first and its last */
    int step_count;                 /* 0: the picture's own, or chosen */
    int64_t from, until;            /* of what is drawn over time; 0: the picture's own */
    const char *body;               /* whose particles a map shows, or NULL */
    bool logarithmic;               /* axes of a series' values */
    double range[2];                /* ends of the colours; equal: those of the whole result */
    double width, resolution;       /* mm, dots per inch; 0: 160 and 200 */
    const char *palette;            /* one of FW_PALETTE_NAMES; NULL: auto */
    double height;                  /* of charts, in mm; 0: chosen */
    bool in_steps;                  /* a series over steps, not times */
    double font_size;               /* of labels, in points; 0: 8.5 */
    double x_range[2], y_range[2];  /* of the axes, as they are shown; equal: chosen */
    bool bare;                      /* without title and caption, for a paper's own */
    const char *letter; /* in the place of the title: "a" of a figure's panel; or NULL */
    const char *along;  /* of a sweep: parameter or number along x; of a series: an observable */
    const char *const *with; /* folders of results that a series is compared with */
    int with_count;
    const double *level; /* of a map: where a line is drawn, or NULL */
} fw_plot_wish;

/* Draws one picture and says on `out` where it lies. FW_BAD_INPUT: there are no results, or they do
 * not hold what is wished for; FW_SYSTEM_FAILED: memory, disk. */
fw_status fw_plot_one(const char *directory, const fw_plot_wish *wish, FILE *out, fw_error *error);

/* Draws every picture that the result's scenario names (the motion where it names none) into the
 * results folder, and says on `out` where each lies. One that fails does not keep the others from
 * being drawn: its failure is returned in the end. */
fw_status fw_plot_all(const char *directory, FILE *out, fw_error *error);

#endif
