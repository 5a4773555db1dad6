/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_compare.h - the same observables of several results in one frame. */
#ifndef FW_PLOT_COMPARE_H
#define FW_PLOT_COMPARE_H

#include "experiments/pictures/plot.h"
#include "plot_parts.h"

/* The series of a result and those of others, panel by panel, each curve called by the name of its
 * folder, with as many of those above it as tell the results apart. Cleared also after a failure.
 */
typedef struct fw_plot_compared {
    int count;
    fw_plot_result result[FW_PLOT_WITH_MAX]; /* of the others */
    fw_plot_series series[FW_PLOT_WITH_MAX];
    fw_chart *charts; /* those of all */
    fw_curve *curves;
    char (*labels)[4 * FW_NAME_SIZE];
} fw_plot_compared;

/* FW_BAD_INPUT: another result cannot be read, has not what is drawn, or its panels or units are
 * others. */
fw_status fw_plot_compared_find(fw_plot_compared *compared, const fw_plot_series *own,
                                const fw_plot_picture *picture, fw_error *error);
void fw_plot_compared_clear(fw_plot_compared *compared);

#endif
