/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_extent.h - what places and fields take over a whole result, so that all of its pictures have
 * the same axes and colours. */
#ifndef FW_PLOT_EXTENT_H
#define FW_PLOT_EXTENT_H

#include "plot_parts.h"

/* Bounds of all bodies in all frames; of very long results in frames spread evenly, first and last
 * among them. */
fw_status fw_plot_bounds_find(fw_view_bounds *bounds, const fw_plot_result *result,
                              fw_error *error);
/* The same with what is shown of walls, wherever they are in these frames. With `each` all frames
 * are looked at, however many there are. */
fw_status fw_plot_frame_find(fw_view_bounds *bounds, const fw_plot_result *result, bool each,
                             fw_error *error);

/* The colours of the picture's field: between the ends that it gives, else of all
 * values in the same frames but the 0.5 % at each end of each of them. */
fw_status fw_plot_colours_find(fw_colouring *colouring, const fw_plot_result *result,
                               const fw_plot_picture *picture, fw_error *error);

#endif
