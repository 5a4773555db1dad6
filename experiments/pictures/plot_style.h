/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_style.h - how pictures look, from a file: one for all figures of a paper. */
#ifndef FW_PLOT_STYLE_H
#define FW_PLOT_STYLE_H

#include "experiments/pictures/plot.h"
#include "experiments/schema/schema.h"

/* The keys of such a file. */
extern const fw_section fw_plot_style_section;

/* What the wish leaves open is as the file says. FW_BAD_INPUT with file, line and column. */
fw_status fw_plot_style_read(fw_plot_wish *wish, const char *path, fw_error *error);

#endif
