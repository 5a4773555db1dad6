/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_analysis.c - pictures of analyses, from the arrays in the results file. Keeps no state.
 * Start reading at fw_plot_draw_analysis(). */
#include "plot_parts.h"

#include "core/automaton/automaton_dispersion.h"

#include <math.h>
#include <stdlib.h>

enum { TABLES = 5, DISC_POINTS = 181 };

static void clear(fw_table tables[TABLES])
{
    for (int n = 0; n < TABLES; ++n) free(tables[n].values);
}

/* Tables of these names, all of rank 1 and one length; FW_BAD_INPUT for another file.
 */
static fw_status read_columns(const fw_plot_result *result, const char *analysis,
                              const char *const *names, int count, fw_table *tables,
                              fw_error *error)
{
    for (int n = 0; n < count; ++n) {
        FW_TRY(fw_playback_read_table(result->playback, analysis, names[n], &tables[n], error));
        if (tables[n].rank != 1 || tables[n].extent[0] != tables[0].extent[0])
            return fw_fail(error, FW_BAD_INPUT, "%s: the arrays of %s are of different lengths",
                           result->directory, analysis);
    }
    return FW_OK;
}

/* --- the stability map --- */

static double step_of(const fw_table *axis)
{
    const int count = axis->extent[0];
    return count > 1 ? (axis->values[count - 1] - axis->values[0]) / (count - 1) : 1;
}

static fw_status draw_map(const fw_plot_result *result, const fw_plot_picture *picture,
                          fw_error *error)
{
    fw_table tables[TABLES] = {{.rank = 0}};
    const char *name = picture->analysis->name;
    fw_status status = fw_playback_read_table(result->playback, name, "c1", &tables[0], error);
    if (status == FW_OK)
        status = fw_playback_read_table(result->playback, name, "c2", &tables[1], error);
    if (status == FW_OK)
        status = fw_playback_read_table(result->playback, name, "growth", &tables[2], error);
    if (status == FW_OK &&
        (tables[0].rank != 1 || tables[1].rank != 1 || tables[2].rank != 2 ||
         tables[2].extent[0] != tables[1].extent[0] || tables[2].extent[1] != tables[0].extent[0]))
        status = fw_fail(error, FW_BAD_INPUT, "%s: the map %s does not fit its axes",
                         result->directory, name);
    if (status == FW_OK) {
        double x[DISC_POINTS], y[DISC_POINTS];
        for (int n = 0; n < DISC_POINTS; ++n) {
            x[n] = sqrt(2) * cos(M_PI / 2 * n / (DISC_POINTS - 1));
            y[n] = sqrt(2) * sin(M_PI / 2 * n / (DISC_POINTS - 1));
        }
        const fw_curve disc = {.label = "c_{1}^{2} + c_{2}^{2} = 2",
                               .count = DISC_POINTS,
                               .x = x,
                               .y = y,
                               .look = FW_CURVE_LINE,
                               .colour = 7};
        const fw_figure_map_plan plan = {
            .columns = tables[0].extent[0],
            .rows = tables[1].extent[0],
            .values = tables[2].values,
            .p_first = tables[0].values[0],
            .p_step = step_of(&tables[0]),
            .q_first = tables[1].values[0],
            .q_step = step_of(&tables[1]),
            .p_label = {"c_{1} (spacings/step)", 0},
            .q_label = {"c_{2} (spacings/step)", 0},
            .equal_aspect = true,
            .colouring = {.label = {"growth (1/step)", 0}, .map = FW_PALETTE_SEQUENTIAL},
            .curves = &disc,
            .curve_count = 1};
        status = fw_figure_map(&picture->page, &plan, error);
    }
    clear(tables);
    return status;
}

/* --- curves --- */

enum { CLOSED_POINTS = 241 };

/* The closed form along the whole path, much denser than the waves that were simulated. */
typedef struct closed_form {
    double path[CLOSED_POINTS], frequency[FW_MODES][CLOSED_POINTS], highest;
} closed_form;

static void find_closed_form(closed_form *c, const fw_scenario_automaton *material)
{
    const fw_vec2 corners[] = {{0, 0}, {M_PI, 0}, {M_PI, M_PI}, {0, 0}};
    enum { LEGS = 3, PER_LEG = (CLOSED_POINTS - 1) / LEGS };
    double begin = 0;
    c->highest = 0;
    for (int n = 0; n < CLOSED_POINTS; ++n) {
        const int leg = n / PER_LEG < LEGS ? n / PER_LEG : LEGS - 1;
        const fw_vec2 from = corners[leg], along = fw_vec2_subtract(corners[leg + 1], from);
        const double part = (double)(n - leg * PER_LEG) / PER_LEG;
        double squared[FW_MODES];
        c->path[n] = begin + part * hypot(along.x, along.y);
        fw_automaton_closed_form(material->speeds, fw_vec2_add(from, fw_vec2_scale(part, along)),
                                 squared);
        for (int m = 0; m < FW_MODES; ++m) {
            c->frequency[m][n] = 2 * asin(fmin(1, sqrt(fmax(0, squared[m])) / 2));
            c->highest = fmax(c->highest, c->frequency[m][n]);
        }
        if (n % PER_LEG == PER_LEG - 1 && leg < LEGS - 1) begin += hypot(along.x, along.y);
    }
}

static fw_status draw_dispersion(const fw_plot_result *result, const fw_plot_picture *picture,
                                 fw_error *error)
{
    static const char *const names[] = {"way", "simulated-slow", "simulated-fast"};
    fw_table t[TABLES] = {{.rank = 0}};
    closed_form closed;
    const fw_scenario_material *material =
        &result->scenario->materials[picture->analysis->material];
    fw_status status = read_columns(result, picture->analysis->name, names, 3, t, error);
    if (status == FW_OK) {
        find_closed_form(&closed, &material->automaton);
        const int count = t[0].extent[0];
        const double turn = M_PI, back = 2 * M_PI, end = closed.path[CLOSED_POINTS - 1];
        const fw_axis_name places[] = {{0, "Γ"}, {turn, "X"}, {back, "M"}, {end, "Γ"}};
        const fw_curve curves[] = {{"fast, closed form", CLOSED_POINTS, closed.path,
                                    closed.frequency[FW_FAST], NULL, NULL, FW_CURVE_LINE, 1, NULL},
                                   {"slow, closed form", CLOSED_POINTS, closed.path,
                                    closed.frequency[FW_SLOW], NULL, NULL, FW_CURVE_DASHES, 2,
                                    NULL},
                                   {"fast, simulated", count, t[0].values, t[2].values, NULL, NULL,
                                    FW_CURVE_MARKERS, 1, NULL},
                                   {"slow, simulated", count, t[0].values, t[1].values, NULL, NULL,
                                    FW_CURVE_MARKERS, 2, NULL}};
        const fw_chart chart = {.label = {"frequency (radians/step)", 0},
                                .curves = curves,
                                .curve_count = 4,
                                .range = {0, 1.05 * closed.highest}};
        status = fw_figure_curves(&picture->page, &chart,
                                  (fw_label){"wave vector along Γ–X–M–Γ", 0}, places, 4, error);
    }
    clear(t);
    return status;
}

static fw_status draw_reference(const fw_plot_result *result, const fw_plot_picture *picture,
                                fw_error *error)
{
    static const char *const names[] = {"half-step", "difference"};
    fw_table t[TABLES] = {{.rank = 0}};
    fw_status status = read_columns(result, picture->analysis->name, names, 2, t, error);
    if (status == FW_OK) {
        const fw_curve curve = {NULL, t[0].extent[0], t[0].values, t[1].values, NULL,
                                NULL, FW_CURVE_LINE,  1,           NULL};
        const fw_chart chart = {.label = {"largest difference (length)", 0},
                                .curves = &curve,
                                .curve_count = 1,
                                .logarithmic = true};
        status = fw_figure_curves(&picture->page, &chart, (fw_label){"time (half-steps)", 0}, NULL,
                                  0, error);
    }
    clear(t);
    return status;
}

fw_status fw_plot_draw_analysis(const fw_plot_result *result, const fw_plot_picture *picture,
                                fw_error *error)
{
    switch (picture->analysis->kind) {
    case FW_ANALYSIS_STABILITY_MAP:
        return draw_map(result, picture, error);
    case FW_ANALYSIS_DISPERSION:
        return draw_dispersion(result, picture, error);
    case FW_ANALYSIS_BOLTZMANN_REFERENCE:
        return draw_reference(result, picture, error);
    case FW_ANALYSIS_PLANE_MODE:
    case FW_ANALYSIS_BODY_STABILITY:
        break;
    }
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: the analysis %s is a few numbers, expected one with a map or curves",
                   result->directory, picture->analysis->name);
}
