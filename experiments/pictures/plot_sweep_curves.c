/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_curves.c - the table of a sweep as panels above the axis of one parameter, or of one
 * of its numbers: a line for every value of the other parameters. Keeps no state. Start reading at
 * fw_plot_sweep_curves(). */
#include "plot_sweep_parts.h"

#include "experiments/drawing/figure.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"
#include "plot_label.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* More lines than colours would not be told apart. */
enum { LINES_MAX = FW_PALETTE_KINDS - 1 };

/* Cases that differ in the parameter along x alone, by that. */
typedef struct sweep_line {
    char label[200]; /* "k=2, m=1" */
    int count;
    int *rows; /* of the table */
    double *x;
} sweep_line;

enum { PARTS = 7 };

/* Numbers of one panel: for each line its parts, in one piece of memory. */
typedef struct panel_data {
    char label[FW_SWEEP_NAME + 120];
    double *numbers;
    fw_curve curves[2 * LINES_MAX];
} panel_data;

typedef struct drawing {
    const fw_plot_sweep *sweep;
    int along;                     /* parameter that changes along each line */
    const fw_sweep_column *across; /* number on the x axis in its place, or NULL */
    int line_count, found;         /* lines that are drawn, and that there are */
    sweep_line lines[LINES_MAX];
    int *rows;
    double *x; /* memory of all lines */
    int count;
    panel_data panels[FW_SWEEP_PANELS_MAX];
    fw_chart charts[FW_SWEEP_PANELS_MAX];
    bool expected; /* any panel shows what was expected */
    bool open;     /* any error is a lower bound */
} drawing;

static double value_of(const drawing *d, int row, int axis)
{
    const fw_sweep_table *table = &d->sweep->table;
    return table->values[row * table->axis_count + axis];
}

/* --- lines --- */

static int count_values(const fw_sweep_table *table, int axis)
{
    int count = 0;
    for (int r = 0; r < table->row_count; ++r) {
        bool new = true;
        for (int q = 0; q < r && new; ++q)
            new = table->values[q * table->axis_count + axis] !=
                  table->values[r * table->axis_count + axis];
        count += new;
    }
    return count;
}

/* The first of those with the most values. */
static int choose_axis(const fw_sweep_table *table)
{
    int best = 0, most = 0;
    for (int a = 0; a < table->axis_count; ++a) {
        const int count = count_values(table, a);
        if (count > most) best = a;
        most = count > most ? count : most;
    }
    return best;
}

static bool same_line(const drawing *d, int row, int other)
{
    for (int a = 0; a < d->sweep->table.axis_count; ++a)
        if (a != d->along && value_of(d, row, a) != value_of(d, other, a)) return false;
    return true;
}

/* Is there a line with smaller values of the others? Lines come in their order. */
static int compare_lines(const drawing *d, int row, int other)
{
    for (int a = 0; a < d->sweep->table.axis_count; ++a) {
        if (a == d->along || value_of(d, row, a) == value_of(d, other, a)) continue;
        return value_of(d, row, a) < value_of(d, other, a) ? -1 : 1;
    }
    return 0;
}

/* First rows of all lines, in the order of the lines; returns how many. */
static int find_heads(const drawing *d, int *heads)
{
    int count = 0;
    for (int r = 0; r < d->sweep->table.row_count; ++r) {
        int at = 0;
        while (at < count && compare_lines(d, heads[at], r) < 0) ++at;
        if (at < count && same_line(d, heads[at], r)) continue;
        memmove(heads + at + 1, heads + at, (size_t)(count - at) * sizeof *heads);
        heads[at] = r;
        count += 1;
    }
    return count;
}

/* "0.5", or "0.0789 km/s" where there are units of nature. */
static void append_value(const drawing *d, int axis, double value, char *text, size_t size)
{
    const fw_physical physical =
        fw_units_physical(&d->sweep->scenario->units, d->sweep->table.axes[axis].unit);
    char number[FW_NUMBER_TEXT];
    fw_number_write(number, value);
    if (physical.factor > 0)
        fw_text_append(text, size, "%.4g %s", value * physical.factor, physical.text);
    else
        fw_text_append(text, size, "%s", number);
}

static void name_line(const drawing *d, int row, sweep_line *line)
{
    const fw_sweep_table *table = &d->sweep->table;
    for (int a = 0; a < table->axis_count; ++a) {
        if (a == d->along) continue;
        fw_text_append(line->label, sizeof line->label, "%s%s = ", line->label[0] ? ", " : "",
                       table->axes[a].name);
        append_value(d, a, value_of(d, row, a), line->label, sizeof line->label);
    }
}

static void fill_line(drawing *d, int head, sweep_line *line)
{
    for (int r = 0; r < d->sweep->table.row_count; ++r) {
        if (!same_line(d, head, r)) continue;
        const double x = value_of(d, r, d->along);
        int at = line->count++;
        for (; at > 0 && line->x[at - 1] > x; --at) {
            line->x[at] = line->x[at - 1];
            line->rows[at] = line->rows[at - 1];
        }
        line->x[at] = x;
        line->rows[at] = r;
    }
    name_line(d, head, line);
}

/* Of too many lines some are drawn, evenly chosen, the outermost among them. */
static fw_status make_lines(drawing *d, fw_error *error)
{
    const size_t rows = (size_t)d->sweep->table.row_count;
    int *heads = calloc(rows + 1, sizeof *heads);
    d->rows = calloc(rows, sizeof *d->rows);
    d->x = fw_array_of_doubles(rows);
    if (heads && d->rows && d->x) {
        int used = 0;
        d->found = find_heads(d, heads);
        d->line_count = d->found < LINES_MAX ? d->found : LINES_MAX;
        for (int n = 0; n < d->line_count; ++n) {
            const int chosen = d->line_count > 1 ? n * (d->found - 1) / (d->line_count - 1) : 0;
            d->lines[n].rows = d->rows + used;
            d->lines[n].x = d->x + used;
            fill_line(d, heads[chosen], &d->lines[n]);
            used += d->lines[n].count;
        }
    }
    free(heads);
    return d->rows && d->x && d->found > 0 ? FW_OK : fw_fail_memory(error, "a picture of a sweep");
}

/* Do the values grow by factors rather than by steps? */
static bool grows_by_factors(const sweep_line *line)
{
    if (line->count < 3 || !(line->x[0] > 0)) return false;
    const double first = line->x[1] / line->x[0], last = line->x[line->count - 1];
    for (int k = 1; k + 1 < line->count; ++k)
        if (fabs(line->x[k + 1] / line->x[k] / first - 1) > .05) return false;
    return last / line->x[0] > 3;
}

/* --- panels --- */

/* Numbers of a line in a panel; says whether anything of it is expected. */
static bool fill_curves(drawing *d, const fw_sweep_column *column, const sweep_line *line,
                        double *numbers, fw_curve *measured, fw_curve *expected)
{
    double *mean = numbers, *error = mean + line->count, *open = error + line->count;
    double *wanted = open + line->count, *within = wanted + line->count;
    double *x = within + line->count, *spread = x + line->count;
    bool any = false;
    for (int k = 0; k < line->count; ++k) {
        const int row = line->rows[k];
        x[k] = d->across ? d->across->mean[row] : line->x[k];
        spread[k] = d->across && isfinite(d->across->error[row]) ? d->across->error[row] : 0;
        mean[k] = column->mean[row];
        error[k] = isfinite(column->error[row]) ? column->error[row] : 0;
        open[k] = column->at_least[row];
        d->open = d->open || open[k] != 0;
        wanted[k] = column->expected[row];
        within[k] = isfinite(column->within[row]) ? column->within[row] : 0;
        any = any || isfinite(wanted[k]);
    }
    *measured = (fw_curve){.count = line->count,
                           .x = x,
                           .y = mean,
                           .error = error,
                           .spread = d->across ? spread : NULL,
                           .open = open,
                           .look = FW_CURVE_LINE_AND_MARKERS};
    *expected = (fw_curve){
        .count = line->count, .x = x, .y = wanted, .error = within, .look = FW_CURVE_MARKERS};
    d->expected = d->expected || any;
    return any;
}

/* One line alone is called by what of the quantity it shows; several by their values, and what they
 * show stands beside the axis. */
static void name_curves(drawing *d, panel_data *panel, const char *part, int number, bool expected)
{
    fw_curve *measured = panel->curves, *wanted = panel->curves + d->line_count;
    if (d->line_count == 1) {
        measured->label = part[0] ? part : expected ? "measured" : NULL;
        measured->colour = 1;
        wanted->label = "expected";
        wanted->colour = FW_CURVE_GREY;
        return;
    }
    for (int n = 0; n < d->line_count; ++n) {
        measured[n].label = number == 0 ? d->lines[n].label : NULL;
        measured[n].colour = wanted[n].colour = n + 1;
        wanted[n].look = FW_CURVE_DASHES;
        wanted[n].error = NULL;
    }
}

static fw_status fill_panel(drawing *d, int number, const fw_sweep_column *column, bool logarithmic,
                            fw_error *error)
{
    panel_data *panel = &d->panels[number];
    bool expected = false;
    size_t used = 0;
    panel->numbers = fw_array_of_doubles(PARTS * (size_t)d->sweep->table.row_count);
    if (!panel->numbers) return fw_fail_memory(error, "a picture of a sweep");
    for (int n = 0; n < d->line_count; ++n) {
        expected |= fill_curves(d, column, &d->lines[n], panel->numbers + used, &panel->curves[n],
                                &panel->curves[d->line_count + n]);
        used += PARTS * (size_t)d->lines[n].count;
    }
    fw_label label;
    const char *part =
        fw_plot_sweep_label(column, &d->sweep->table, &d->sweep->scenario->units, d->line_count > 1,
                            panel->label, sizeof panel->label, &label);
    name_curves(d, panel, part, number, expected);
    d->charts[number] = (fw_chart){.label = label,
                                   .curves = panel->curves,
                                   .curve_count = expected ? 2 * d->line_count : d->line_count,
                                   .logarithmic = logarithmic};
    return FW_OK;
}

static void clear_drawing(drawing *d)
{
    for (int p = 0; p < d->count; ++p) free(d->panels[p].numbers);
    free(d->rows);
    free(d->x);
    free(d);
}

/* --- the picture --- */

static void write_caption(const drawing *d, const fw_sweep_choice *choice, char *caption,
                          size_t size)
{
    const fw_sweep_table *table = &d->sweep->table;
    const int64_t seeds = d->sweep->scenario->study.seeds;
    for (int p = 0; p < d->count; ++p)
        fw_plot_sweep_explain(&table->columns[choice->columns[p]], caption, size);
    for (int p = 0; p < d->count && d->line_count > 1; ++p)
        fw_text_append(caption, size, "%s%s%s", p == 0 ? "Drawn: " : "; ",
                       table->columns[choice->columns[p]].name, p + 1 == d->count ? ". " : "");
    if (d->line_count < d->found)
        fw_text_append(caption, size, "%d of %d lines. ", d->line_count, d->found);
    if (d->across) {
        const sweep_line *first = &d->lines[0];
        fw_text_append(caption, size, "Along x: %s. Along each line %s grows from ",
                       d->across->name, table->axes[d->along].name);
        append_value(d, d->along, first->x[0], caption, size);
        fw_text_append(caption, size, " to ");
        append_value(d, d->along, first->x[first->count - 1], caption, size);
        fw_text_append(caption, size, ". ");
    }
    fw_plot_sweep_say_seeds(seeds, caption, size);
    if (d->open)
        fw_text_append(caption, size,
                       "Dotted bars: the series is too short for its correlation, the error is a "
                       "lower bound. ");
    if (d->expected && d->line_count == 1)
        fw_text_append(caption, size, "Grey: what is expected, with its tolerance as a bar. ");
    if (d->expected && d->line_count > 1)
        fw_text_append(caption, size, "Dashes: what is expected. ");
    if (!fw_units_given(&d->sweep->scenario->units))
        fw_text_append(caption, size, "Reduced units.");
}

static fw_status draw(drawing *d, const fw_sweep_choice *choice, fw_page *page, fw_error *error)
{
    const fw_sweep_axis *axis = &d->sweep->table.axes[d->along];
    char text[FW_SWEEP_NAME + 80], caption[3072] = "";
    const fw_units *units = &d->sweep->scenario->units;
    fw_label label = fw_plot_label(text, sizeof text, axis->name, axis->unit, units);
    if (d->across)
        fw_plot_sweep_label(d->across, &d->sweep->table, units, true, text, sizeof text, &label);
    write_caption(d, choice, caption, sizeof caption);
    page->caption = caption;
    const fw_figure_stack_plan plan = {.charts = d->charts,
                                       .chart_count = d->count,
                                       .label = label,
                                       .logarithmic = !d->across && grows_by_factors(&d->lines[0])};
    return fw_figure_stack(page, &plan, error);
}

fw_status fw_plot_sweep_curves(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                               const fw_scenario_picture *own, fw_page *page, fw_error *error)
{
    fw_sweep_choice choice;
    fw_sweep_along along;
    FW_TRY(fw_plot_sweep_choose(&choice, sweep, wish, own, error));
    FW_TRY(fw_plot_sweep_along(&along, sweep, wish, own, error));
    drawing *d = calloc(1, sizeof *d);
    if (!d) return fw_fail_memory(error, "a picture of a sweep");
    d->sweep = sweep;
    d->along = along.axis >= 0 ? along.axis : choose_axis(&sweep->table);
    d->across = along.column >= 0 ? &sweep->table.columns[along.column] : NULL;
    const bool logarithmic = wish->logarithmic || (own && own->logarithmic);
    fw_status status = make_lines(d, error);
    for (; status == FW_OK && d->count < choice.count; ++d->count)
        status = fill_panel(d, d->count, &sweep->table.columns[choice.columns[d->count]],
                            logarithmic, error);
    if (status == FW_OK) status = draw(d, &choice, page, error);
    clear_drawing(d);
    return status;
}
