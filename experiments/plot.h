/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot.h - pictures of a result: from a results folder to the figures of figure.h. */
#ifndef FW_PLOT_H
#define FW_PLOT_H

#include "core/status.h"

#include <stdio.h>

/* Draws every picture that the result's scenario names (the motion where it names none) into the
 * results folder, and says on `out` where each lies. */
fw_status fw_plot_all(const char *directory, FILE *out, fw_error *error);

#endif
