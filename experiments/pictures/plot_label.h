/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_label.h - what stands beside an axis of a picture, in the units of nature where the scenario
 * has them. */
#ifndef FW_PLOT_LABEL_H
#define FW_PLOT_LABEL_H

#include "experiments/drawing/page.h"
#include "experiments/units/units.h"

#include <stdbool.h>

/* "speed (km/s)" into `text`, which the label points to; `unit` is one of the program. */
fw_label fw_plot_label(char *text, size_t size, const char *quantity, const char *unit,
                       const fw_units *units);
/* "time (ps)", or "time (steps)" where a step takes a time of 1, or "time". */
fw_label fw_plot_time_label(char *text, size_t size, bool steps_are_times, const fw_units *units);

/* What the labels of a page point to. */
typedef struct fw_plot_names {
    char x[32], y[32], force[FW_UNIT_TEXT];
} fw_plot_names;

/* Labels of the places and forces on a page, where there are units. */
void fw_plot_name_places(fw_plot_names *names, fw_page *page, const fw_units *units);

#endif
