/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_exact.h - the exact solution beside what was simulated, where there is one: modes of
 * periodic elastic automata that nothing disturbs go on as running waves (Dong et al. Eq 40). */
#ifndef FW_PLOT_EXACT_H
#define FW_PLOT_EXACT_H

#include "plot_parts.h"

/* Are the bodies of the result such, and is the field a component of their displacement? */
bool fw_plot_exact_exists(const fw_plot_result *result, const char *field);

/* A frame as fw_plot_view_load makes it, with places and field of the exact solution. */
fw_status fw_plot_exact_load(fw_plot_view *view, const fw_plot_result *result, int64_t frame,
                             const char *field, fw_error *error);

#endif
