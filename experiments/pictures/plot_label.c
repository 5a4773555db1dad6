/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_label.c - labels with units. Keeps no state. */
#include "plot_label.h"

#include <stdio.h>

fw_label fw_plot_label(char *text, size_t size, const char *quantity, const char *unit,
                       const fw_units *units)
{
    const fw_physical physical = fw_units_physical(units, unit ? unit : "1");
    fw_label_print(text, size, quantity, physical.factor > 0 ? physical.text : unit);
    return (fw_label){text, physical.factor};
}

fw_label fw_plot_time_label(char *text, size_t size, bool steps_are_times, const fw_units *units)
{
    if (fw_units_given(units)) return fw_plot_label(text, size, "time", "time", units);
    snprintf(text, size, "%s", steps_are_times ? "time (steps)" : "time");
    return (fw_label){text, 0};
}

void fw_plot_name_places(fw_plot_names *names, fw_page *page, const fw_units *units)
{
    if (!fw_units_given(units)) return;
    const fw_physical force = fw_units_physical(units, "force");
    snprintf(names->force, sizeof names->force, "%s", force.text);
    page->force = (fw_label){names->force, force.factor};
    page->x_label = fw_plot_label(names->x, sizeof names->x, "x", "length", units);
    page->y_label = fw_plot_label(names->y, sizeof names->y, "y", "length", units);
}
