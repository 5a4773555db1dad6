/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep.h - pictures of a sweep: what came out of its cases against the parameters. */
#ifndef FW_PLOT_SWEEP_H
#define FW_PLOT_SWEEP_H

#include "experiments/pictures/plot.h"
#include "plot_parts.h"

/* As fw_plot_one and fw_plot_all, for a folder that holds a sweep (sweep.h). FW_BAD_INPUT also
 * where the sweep is not finished. */
fw_status fw_plot_sweep_one(const char *directory, const fw_plot_wish *wish, FILE *out,
                            fw_error *error);
fw_status fw_plot_sweep_all(const char *directory, FILE *out, fw_error *error);

/* The kinds `sweep` and `map` of a single run: FW_BAD_INPUT, since one run has nothing to compare.
 */
fw_status fw_plot_draw_sweep(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error);
fw_status fw_plot_draw_map(const fw_plot_result *result, const fw_plot_picture *picture,
                           fw_error *error);

#endif
