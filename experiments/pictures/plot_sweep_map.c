/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_map.c - one number of a sweep as colour over its two parameters. Cells are of one
 * size, whatever lies between the values: ticks name them, and each cell has its number with its
 * error. Of a bisection, whose values differ from line to line, each line is coloured by its
 * nearest case. Keeps no state. Start reading at fw_plot_sweep_map(). */
#include "plot_sweep_parts.h"

#include "experiments/drawing/figure.h"
#include "experiments/text/text.h"
#include "plot_label.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TICKS_MAX = 12, CELL_TEXT = 24, RASTER_ROWS = 240 };

/* The values of one parameter, ascending, and ticks that name some of them. */
typedef struct side {
    int axis;
    int count, name_count;
    double *values;
    char text[TICKS_MAX][FW_TICK_LABEL_SIZE];
    fw_axis_name names[TICKS_MAX];
    char name[FW_NAME_BYTES + 80];
    fw_label label; /* points to it */
} side;

/* A map on its way to its figure; its ticks point into it. */
typedef struct map {
    const fw_plot_sweep *sweep;
    const fw_sweep_column *column;
    side p, q; /* along x and y */
    int rows;
    double q_first, q_step;
    double *values, *errors; /* [rows][p.count], NaN where there is none */
    char (*cells)[CELL_TEXT];
    const char **texts; /* NULL: none are written */
    char name[FW_SWEEP_NAME + 80];
    fw_label label; /* of the numbers; points to it */
    fw_sweep_level level;
    bool has_level, bisected;
} map;

static void add_name(side *s, double place, double value)
{
    char *text = s->text[s->name_count];
    snprintf(text, FW_TICK_LABEL_SIZE, "%.4g", fw_label_shown(s->label, value));
    s->names[s->name_count++] = (fw_axis_name){place, text};
}

static fw_status make_side(side *s, const fw_sweep_table *table, int axis, fw_error *error)
{
    s->axis = axis;
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
    return FW_OK;
}

/* Once it is where it stays: its label points into it. */
static void name_side(side *s, const fw_plot_sweep *sweep)
{
    const fw_sweep_axis *axis = &sweep->table.axes[s->axis];
    s->label =
        fw_plot_label(s->name, sizeof s->name, axis->name, axis->unit, &sweep->scenario->units);
}

static void name_values(side *s)
{
    const int every = (s->count + TICKS_MAX - 1) / TICKS_MAX;
    for (int n = 0; n < s->count; n += every) add_name(s, n, s->values[n]);
}

static int place_of(const side *s, double value)
{
    int at = 0;
    while (s->values[at] < value) ++at;
    return at;
}

static double value_of(const map *m, int row, const side *s)
{
    return m->sweep->table.values[row * m->sweep->table.axis_count + s->axis];
}

/* --- cells --- */

/* 0.83(2), 1.4(2)e-05: the error, one digit or two, in units of the last digit. */
static void write_cell(char text[CELL_TEXT], double mean, double error)
{
    char power[12] = "";
    text[0] = '\0';
    if (!isfinite(mean)) return;
    if (!(error > 0) || !isfinite(error)) {
        snprintf(text, CELL_TEXT, "%.3g", mean);
        return;
    }
    const int size = (int)floor(log10(fmax(fabs(mean), error)));
    if (size < -3 || size > 4) {
        snprintf(power, sizeof power, "e%d", size);
        mean /= pow(10, size);
        error /= pow(10, size);
    }
    int digits = (int)-floor(log10(error));
    if (error * pow(10, digits) < 1.95) digits += 1;
    if (digits > 6)
        snprintf(text, CELL_TEXT, "%.6g%s", mean, power);
    else if (digits > 0)
        snprintf(text, CELL_TEXT, "%.*f(%.0f)%s", digits, mean, error * pow(10, digits), power);
    else
        snprintf(text, CELL_TEXT, "%.0f(%.0f)%s", mean, error, power);
}

static fw_status make_room(map *m, fw_error *error)
{
    const size_t cells = (size_t)m->p.count * (size_t)m->rows;
    m->values = fw_array_of_doubles(2 * cells);
    if (!m->values) return fw_fail_memory(error, "a map of a sweep");
    m->errors = m->values + cells;
    for (size_t n = 0; n < 2 * cells; ++n) m->values[n] = NAN;
    return FW_OK;
}

/* A cell for each pair of values. */
static fw_status fill_grid(map *m, fw_error *error)
{
    const size_t cells = (size_t)m->p.count * (size_t)m->q.count;
    m->rows = m->q.count;
    m->q_step = 1;
    name_values(&m->q);
    FW_TRY(make_room(m, error));
    m->cells = calloc(cells, sizeof *m->cells);
    m->texts = calloc(cells, sizeof *m->texts);
    if (!m->cells || !m->texts) return fw_fail_memory(error, "a map of a sweep");
    for (int r = 0; r < m->sweep->table.row_count; ++r) {
        const int n = place_of(&m->q, value_of(m, r, &m->q)) * m->p.count +
                      place_of(&m->p, value_of(m, r, &m->p));
        m->values[n] = m->column->mean[r];
        m->errors[n] = m->column->error[r];
        write_cell(m->cells[n], fw_label_shown(m->label, m->values[n]),
                   fw_label_shown(m->label, m->errors[n]));
        m->texts[n] = m->cells[n][0] ? m->cells[n] : NULL;
    }
    return FW_OK;
}

/* Along the bisected parameter places are its values, or their logarithms. */
static double place_along(const map *m, double value)
{
    return m->sweep->scenario->study.sweep.logarithmic ? log10(value) : value;
}

static fw_status fill_raster(map *m, fw_error *error)
{
    const double low = place_along(m, m->q.values[0]);
    const double high = place_along(m, m->q.values[m->q.count - 1]);
    m->rows = RASTER_ROWS;
    m->q_step = fabs(high - low) / RASTER_ROWS;
    m->q_first = fmin(low, high) + m->q_step / 2;
    for (int n = 0; n <= 4; ++n) {
        const double place = low + n * (high - low) / 4;
        add_name(&m->q, place,
                 m->sweep->scenario->study.sweep.logarithmic ? pow(10, place) : place);
    }
    FW_TRY(make_room(m, error));
    for (int row = 0; row < m->rows; ++row)
        for (int c = 0; c < m->p.count; ++c) {
            double nearest = INFINITY;
            for (int r = 0; r < m->sweep->table.row_count; ++r) {
                const double place = place_along(m, value_of(m, r, &m->q));
                const double distance = fabs(place - (m->q_first + row * m->q_step));
                if (value_of(m, r, &m->p) != m->p.values[c] || distance >= nearest) continue;
                nearest = distance;
                m->values[row * m->p.count + c] = m->column->mean[r];
            }
        }
    return FW_OK;
}

/* --- the line --- */

static bool is_of(const fw_sweep_column *column, const char *quantity)
{
    const size_t length = strlen(quantity);
    return strncmp(column->name, quantity, length) == 0 &&
           (!column->name[length] || strchr(" .,", column->name[length]));
}

/* The level of a picture is that of its own number, not of another that is wished for. */
static bool has_level(const map *m, const fw_plot_wish *wish, const fw_scenario_picture *own)
{
    if (!own || !own->has_level) return false;
    if (wish->observable_count == 0) return true;
    return own->observables.count > 0 && is_of(m->column, own->observables.item[0].text);
}

/* As wished for, or as the picture has it, or that which the number is expected to cross. */
static bool find_level(const map *m, const fw_plot_wish *wish, const fw_scenario_picture *own,
                       double *level)
{
    const fw_scenario *scenario = m->sweep->scenario;
    if (wish->level) *level = *wish->level;
    if (wish->level) return true;
    if (has_level(m, wish, own)) {
        *level = own->level;
        return true;
    }
    for (int n = 0; n < scenario->expectation_count; ++n) {
        const fw_expectation *e = &scenario->expectations[n];
        if (!e->has_level || !is_of(m->column, e->quantity.text)) continue;
        *level = e->level;
        return true;
    }
    return false;
}

static fw_status make_level(map *m, const fw_plot_wish *wish, const fw_scenario_picture *own,
                            fw_error *error)
{
    double level;
    m->has_level = find_level(m, wish, own, &level);
    if (!m->has_level) return FW_OK;
    if (!m->bisected)
        return fw_plot_sweep_level_of_grid(&m->level, level, m->p.count, m->rows, m->values,
                                           m->errors, error);
    FW_TRY(fw_plot_sweep_level_of_bisection(&m->level, level, m->sweep, m->column, m->p.values,
                                            m->p.count, error));
    if (m->level.count == 0 && (wish->level || has_level(m, wish, own)))
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: the sweep was not bisected for %s of %.6g, and has no line there",
                       m->sweep->directory, m->column->name, level);
    m->has_level = m->level.count > 0;
    return FW_OK;
}

static void write_caption(const map *m, char *caption, size_t size)
{
    bool hole = false;
    const double level = fw_label_shown(m->label, m->level.level);
    for (int n = 0; n < m->rows * m->p.count; ++n) hole |= !isfinite(m->values[n]);
    fw_plot_sweep_explain(m->column, caption, size);
    fw_text_append(caption, size, "Drawn: %s. ", m->column->name);
    if (m->bisected)
        fw_text_append(caption, size, "Each colour is that of the nearest of %d cases. ",
                       m->sweep->table.row_count);
    fw_plot_sweep_say_seeds(m->sweep->scenario->study.seeds, caption, size);
    if (m->has_level && m->level.mark_count == 0)
        fw_text_append(caption, size, "Nowhere does it pass %.6g. ", level);
    else if (m->has_level && m->bisected)
        fw_text_append(caption, size,
                       "Line: it crosses %.6g, found by bisection, with its uncertainty. ", level);
    else if (m->has_level)
        fw_text_append(caption, size,
                       "Line: it is %.6g, by straight lines between cases, with the standard error "
                       "of where it passes. ",
                       level);
    if (hole) fw_text_append(caption, size, "Grey: no number. ");
    if (!fw_units_given(&m->sweep->scenario->units))
        fw_text_append(caption, size, "Reduced units.");
}

/* --- the picture --- */

static fw_status draw(const map *m, const fw_colouring *colouring, fw_page *page, fw_error *error)
{
    char caption[2048] = "";
    const fw_sweep_level *line = &m->level;
    const fw_curve curves[] = {
        {.count = line->count, .x = line->x, .y = line->y, .look = FW_CURVE_LINE},
        {.count = line->mark_count,
         .x = line->mark_x,
         .y = line->mark_y,
         .error = line->mark_error,
         .spread = line->mark_spread,
         .look = FW_CURVE_MARKERS}};
    write_caption(m, caption, sizeof caption);
    page->caption = caption;
    const fw_figure_map_plan plan = {.columns = m->p.count,
                                     .rows = m->rows,
                                     .values = m->values,
                                     .p_step = 1,
                                     .q_first = m->q_first,
                                     .q_step = m->q_step,
                                     .p_label = m->p.label,
                                     .q_label = m->q.label,
                                     .p_names = m->p.names,
                                     .p_name_count = m->p.name_count,
                                     .q_names = m->q.names,
                                     .q_name_count = m->q.name_count,
                                     .colouring = *colouring,
                                     .texts = m->texts,
                                     .curves = curves,
                                     .curve_count = m->has_level ? 2 : 0};
    return fw_figure_map(page, &plan, error);
}

static fw_status make_map(map *m, const fw_plot_wish *wish, const fw_scenario_picture *own,
                          fw_error *error)
{
    const fw_plot_sweep *sweep = m->sweep;
    side sides[2] = {{0}};
    fw_sweep_along along;
    fw_status status = fw_plot_sweep_along(&along, sweep, wish, own, error);
    if (status == FW_OK && along.column >= 0)
        status = fw_fail(error, FW_BAD_INPUT,
                         "a map lies over two parameters, and %s is a number of the sweep",
                         wish->along ? wish->along : own->along_quantity);
    if (status == FW_OK) status = make_side(&sides[0], &sweep->table, 0, error);
    if (status == FW_OK) status = make_side(&sides[1], &sweep->table, 1, error);
    m->bisected = sweep->scenario->study.sweep.tolerance > 0;
    int x = along.axis >= 0 ? along.axis : sides[1].count > sides[0].count;
    if (m->bisected) x = 1 - sweep->scenario->study.sweep.bisected;
    m->p = sides[x];
    m->q = sides[1 - x];
    FW_TRY(status);
    name_side(&m->p, sweep);
    name_side(&m->q, sweep);
    name_values(&m->p);
    FW_TRY(m->bisected ? fill_raster(m, error) : fill_grid(m, error));
    return make_level(m, wish, own, error);
}

static void clear_map(map *m)
{
    fw_plot_sweep_level_clear(&m->level);
    free(m->p.values);
    free(m->q.values);
    free(m->values);
    free(m->cells);
    free(m->texts);
    free(m);
}

fw_status fw_plot_sweep_map(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                            const fw_scenario_picture *own, fw_page *page, fw_error *error)
{
    const fw_sweep_table *table = &sweep->table;
    fw_sweep_choice choice;
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
    map *m = calloc(1, sizeof *m);
    if (!m) return fw_fail_memory(error, "a map of a sweep");
    m->sweep = sweep;
    m->column = &table->columns[choice.columns[0]];
    fw_plot_sweep_label(m->column, table, &sweep->scenario->units, true, m->name, sizeof m->name,
                        &m->label);
    fw_colouring colouring = {.label = m->label,
                              .map =
                                  wish->palette ? fw_palette_find(wish->palette) : FW_PALETTE_AUTO,
                              .logarithmic = wish->logarithmic || (own && own->logarithmic)};
    const double *range = wish->range[0] < wish->range[1] ? wish->range : own ? own->range : NULL;
    if (range && range[0] < range[1]) colouring.range = (fw_range){range[0], range[1]};
    fw_status status = make_map(m, wish, own, error);
    if (status == FW_OK) status = draw(m, &colouring, page, error);
    clear_map(m);
    return status;
}
