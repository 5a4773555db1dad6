/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_level.c - the line on a map where its number has a level: between the cases of a grid
 * by straight lines, of a bisection where that found it. Keeps no state. Start reading at
 * fw_plot_sweep_level_of_grid(). */
#include "plot_sweep_parts.h"

#include "experiments/study/threshold_table.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fw_plot_sweep_level_clear(fw_sweep_level *line)
{
    free(line->x);
    *line = (fw_sweep_level){.level = NAN};
}

/* All parts share one piece of memory. */
static fw_status make_room(fw_sweep_level *line, size_t points, size_t marks, fw_error *error)
{
    line->x = fw_array_of_doubles(2 * points + 4 * marks);
    if (!line->x) return fw_fail_memory(error, "the line of a level");
    line->y = line->x + points;
    line->mark_x = line->y + points;
    line->mark_y = line->mark_x + marks;
    line->mark_error = line->mark_y + marks;
    line->mark_spread = line->mark_error + marks;
    return FW_OK;
}

static void add_point(fw_sweep_level *line, double x, double y)
{
    line->x[line->count] = x;
    line->y[line->count++] = y;
}

static void add_mark(fw_sweep_level *line, double x, double y, double spread, double error)
{
    line->mark_x[line->mark_count] = x;
    line->mark_y[line->mark_count] = y;
    line->mark_spread[line->mark_count] = spread;
    line->mark_error[line->mark_count++] = error;
}

/* --- a grid --- */

typedef struct grid {
    int columns, rows;
    const double *values, *errors;
    double level;
} grid;

static double value_at(const grid *g, int column, int row)
{
    return g->values[row * g->columns + column];
}

static double error_at(const grid *g, int column, int row)
{
    return g->errors[row * g->columns + column];
}

/* Does the number pass the level from one place to the next? */
static bool passes(const grid *g, double from, double to)
{
    return isfinite(from) && isfinite(to) && (from < g->level) != (to < g->level);
}

/* The part of the way at which a straight line passes the level, (L - a)/(b - a). */
static double part_of(const grid *g, double from, double to)
{
    return (g->level - from) / (to - from);
}

/* Its standard error: ((1 - t)^2 da^2 + t^2 db^2)^(1/2)/|b - a|. */
static double error_of_part(const grid *g, double from, double to, double from_error,
                            double to_error)
{
    const double t = part_of(g, from, to);
    return hypot((1 - t) * from_error, t * to_error) / fabs(to - from);
}

static void mark_passages(const grid *g, fw_sweep_level *line)
{
    for (int r = 0; r < g->rows; ++r)
        for (int c = 0; c < g->columns; ++c) {
            const double here = value_at(g, c, r);
            const double above = r + 1 < g->rows ? value_at(g, c, r + 1) : NAN;
            const double right = c + 1 < g->columns ? value_at(g, c + 1, r) : NAN;
            if (passes(g, here, above))
                add_mark(line, c, r + part_of(g, here, above), NAN,
                         error_of_part(g, here, above, error_at(g, c, r), error_at(g, c, r + 1)));
            if (passes(g, here, right))
                add_mark(line, c + part_of(g, here, right), r,
                         error_of_part(g, here, right, error_at(g, c, r), error_at(g, c + 1, r)),
                         NAN);
        }
}

/* Where the line enters and leaves the square whose lower left corner is a case. Through a saddle
 * there are two pieces, which part the corners that differ from the middle. */
static void join_passages(const grid *g, int c, int r, fw_sweep_level *line)
{
    const double corner[4] = {value_at(g, c, r), value_at(g, c + 1, r), value_at(g, c + 1, r + 1),
                              value_at(g, c, r + 1)};
    static const double left[4] = {0, 1, 1, 0}, low[4] = {0, 0, 1, 1};
    double x[4], y[4];
    bool crossed[4];
    int count = 0;
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        crossed[k] = passes(g, corner[k], corner[next]);
        if (!crossed[k]) continue;
        const double t = part_of(g, corner[k], corner[next]);
        x[k] = c + left[k] + t * (left[next] - left[k]);
        y[k] = r + low[k] + t * (low[next] - low[k]);
        count += 1;
    }
    if (count < 2 || !isfinite(corner[0] + corner[1] + corner[2] + corner[3])) return;
    const double middle = (corner[0] + corner[1] + corner[2] + corner[3]) / 4;
    /* Side k ends at corner k + 1: with it alone on its side of the level, sides k and k + 1 join.
     */
    const int first = count == 4 && (corner[1] < g->level) == (middle < g->level) ? 1 : 0;
    for (int k = first, done = 0; done < 4; ++done, k = (k + 1) % 4) {
        if (!crossed[k]) continue;
        int next = (k + 1) % 4;
        while (!crossed[next]) next = (next + 1) % 4;
        add_point(line, x[k], y[k]);
        add_point(line, x[next], y[next]);
        add_point(line, NAN, NAN);
        crossed[k] = crossed[next] = false;
        count -= 2;
        if (count < 2) return;
    }
}

fw_status fw_plot_sweep_level_of_grid(fw_sweep_level *line, double level, int columns, int rows,
                                      const double *values, const double *errors, fw_error *error)
{
    const grid g = {columns, rows, values, errors, level};
    const size_t cells = (size_t)columns * (size_t)rows;
    *line = (fw_sweep_level){.level = level};
    FW_TRY(make_room(line, 6 * cells, 2 * cells, error));
    mark_passages(&g, line);
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c) join_passages(&g, c, r, line);
    return FW_OK;
}

/* --- a bisection --- */

/* "broken-links.chain, at the end" is the number of the column "... in PHASE". */
static bool is_of_column(const fw_threshold_row *row, const fw_sweep_column *column)
{
    const size_t length = strlen(row->quantity);
    return strncmp(column->name, row->quantity, length) == 0 &&
           (column->name[length] == '\0' || column->name[length] == ' ');
}

fw_status fw_plot_sweep_level_of_bisection(fw_sweep_level *line, double level,
                                           const fw_plot_sweep *sweep,
                                           const fw_sweep_column *column, const double *others,
                                           int other_count, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->scenario->study.sweep;
    const int other = 1 - plan->bisected;
    fw_threshold_row *rows;
    int count;
    *line = (fw_sweep_level){.level = level};
    FW_TRY(fw_threshold_table_read(&rows, &count, sweep->directory, 2, error));
    fw_status status = make_room(line, (size_t)other_count, (size_t)other_count, error);
    for (int c = 0; status == FW_OK && c < other_count; ++c)
        for (int n = 0; n < count; ++n) {
            const double at = rows[n].values[plan->bisected], own = rows[n].error;
            if (rows[n].level != level || rows[n].values[other] != others[c] ||
                line->count == other_count || !is_of_column(&rows[n], column))
                continue;
            const double place = plan->logarithmic ? log10(at) : at;
            add_point(line, c, place);
            if (isfinite(at))
                add_mark(line, c, place, NAN, plan->logarithmic ? own / at / log(10) : own);
        }
    free(rows);
    return status;
}
