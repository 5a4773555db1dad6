/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_map.c - one number of a sweep as colour over its two parameters. Cells are of one
 * size, whatever lies between the values: ticks name them. Keeps no state. Start reading at
 * fw_plot_sweep_map(). */
#include "plot_sweep_parts.h"

#include "experiments/drawing/figure.h"
#include "experiments/drawing/label.h"
#include "experiments/text/text.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TICKS_MAX = 12 };

/* The values of one parameter, ascending, and ticks that name some of them. */
typedef struct side {
    int count, name_count;
    double *values;
    char text[TICKS_MAX][FW_TICK_LABEL_SIZE];
    fw_axis_name names[TICKS_MAX];
    char label[FW_NAME_BYTES + 80];
} side;

static fw_status make_side(side *s, const fw_sweep_table *table, int axis, fw_error *error)
{
    s->values = fw_array_of_doubles((size_t)table->row_count);
    if (!s->values) return fw_fail_memory(error, "a map of a sweep");
    for (int r = 0; r < table->row_count; ++r) {
        const double value = table->values[r * table->axis_count + axis];
        int at = 0;
        while (at < s->count && s->values[at] < value) ++at;
        if (at < s->count && s->values[at] == value) continue;
        memmove(s->values + at + 1, s->values + at, (size_t)(s->count - at) * sizeof *s->values);
        s->values[at] = value;
        s->count += 1;
    }
    const int every = (s->count + TICKS_MAX - 1) / TICKS_MAX;
    for (int n = 0; n < s->count; n += every) {
        char *text = s->text[s->name_count];
        snprintf(text, FW_TICK_LABEL_SIZE, "%.4g", s->values[n]);
        s->names[s->name_count++] = (fw_axis_name){n, text};
    }
    fw_label_print(s->label, sizeof s->label, table->axes[axis].name, table->axes[axis].unit);
    return FW_OK;
}

static int place_of(const side *s, double value)
{
    int at = 0;
    while (s->values[at] < value) ++at;
    return at;
}

static fw_status draw(const fw_plot_sweep *sweep, const fw_sweep_column *column, const side *p,
                      const side *q, int along, const fw_colouring *colouring, fw_page *page,
                      fw_error *error)
{
    const fw_sweep_table *table = &sweep->table;
    const size_t cells = (size_t)p->count * (size_t)q->count;
    double *values = fw_array_of_doubles(cells);
    char caption[2048] = "";
    bool hole = false;
    if (!values) return fw_fail_memory(error, "a map of a sweep");
    for (size_t n = 0; n < cells; ++n) values[n] = NAN;
    for (int r = 0; r < table->row_count; ++r) {
        const double *point = &table->values[r * table->axis_count];
        values[place_of(q, point[1 - along]) * p->count + place_of(p, point[along])] =
            column->mean[r];
    }
    for (size_t n = 0; n < cells; ++n) hole |= !isfinite(values[n]);
    fw_plot_sweep_explain(column, caption, sizeof caption);
    fw_text_append(caption, sizeof caption, "Drawn: %s. ", column->name);
    if (sweep->scenario->study.seeds > 1)
        fw_text_append(caption, sizeof caption, "Means over %lld seeds. ",
                       (long long)sweep->scenario->study.seeds);
    if (hole) fw_text_append(caption, sizeof caption, "Grey: no number. ");
    fw_text_append(caption, sizeof caption, "Reduced units.");
    page->caption = caption;
    const fw_figure_map_plan plan = {.columns = p->count,
                                     .rows = q->count,
                                     .values = values,
                                     .p_step = 1,
                                     .q_step = 1,
                                     .p_label = p->label,
                                     .q_label = q->label,
                                     .p_names = p->names,
                                     .p_name_count = p->name_count,
                                     .q_names = q->names,
                                     .q_name_count = q->name_count,
                                     .colouring = *colouring};
    const fw_status status = fw_figure_map(page, &plan, error);
    free(values);
    return status;
}

fw_status fw_plot_sweep_map(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                            const fw_scenario_picture *own, fw_page *page, fw_error *error)
{
    const fw_sweep_table *table = &sweep->table;
    fw_sweep_choice choice;
    char label[FW_SWEEP_NAME + 80];
    if (table->axis_count != 2)
        return fw_fail(error, FW_BAD_INPUT, "%s: a map needs two parameters, but the sweep has %d",
                       sweep->directory, table->axis_count);
    if (wish->observable_count > 1)
        return fw_fail(error, FW_BAD_INPUT, "a map shows one observable, but %d are wished for",
                       wish->observable_count);
    FW_TRY(fw_plot_sweep_choose(&choice, sweep, wish, own, error));
    if (choice.count == 0)
        return fw_fail(error, FW_BAD_INPUT, "%s: the sweep has no number to draw",
                       sweep->directory);
    const fw_sweep_column *column = &table->columns[choice.columns[0]];
    fw_plot_sweep_label(column, true, label, sizeof label);
    fw_colouring colouring = {.label = label,
                              .logarithmic = wish->logarithmic || (own && own->logarithmic)};
    const double *range = wish->range[0] < wish->range[1] ? wish->range : own ? own->range : NULL;
    if (range && range[0] < range[1]) colouring.range = (fw_range){range[0], range[1]};
    side sides[2] = {{0}};
    fw_status status = make_side(&sides[0], table, 0, error);
    if (status == FW_OK) status = make_side(&sides[1], table, 1, error);
    int along = own ? own->along : -1;
    if (along < 0) along = sides[1].count > sides[0].count;
    if (status == FW_OK)
        status =
            draw(sweep, column, &sides[along], &sides[1 - along], along, &colouring, page, error);
    free(sides[0].values);
    free(sides[1].values);
    return status;
}
