/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_profile.c - the layer between two rubbing bodies: the bodies above their profile (Popov &
 * Filippov Fig 6), the control beside it; and the fretting loop. Keeps no state. Start reading at
 * fw_plot_draw_profile(). */
#include "experiments/measures/profile_table.h"
#include "experiments/storage/folder.h"
#include "experiments/study/study.h"
#include "plot_extent.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHARTS = 2, REGIONS = 4 };

/* What is drawn below the bodies; the second one where bonds break, the last one elsewhere. */
typedef struct drawn_column {
    fw_profile_column column;
    const char *name, *unit;
} drawn_column;
static const drawn_column drawn[] = {{FW_PROFILE_RETURN_FORCE, "return force", "force"},
                                     {FW_PROFILE_BOND_BREAKING, "bond-breaking rate", "1/time"},
                                     {FW_PROFILE_DRIFT, "drift velocity", "length/time"}};

/* One column of the figure: the experiment, or its control. */
typedef struct side {
    fw_plot_view view;
    char name[128];
    double *x, *values[CHARTS], *errors[CHARTS];
    fw_curve curves[CHARTS];
    fw_chart charts[CHARTS];
    char labels[CHARTS][64], places[2][32];
    fw_figure_region regions[REGIONS];
} side;

static void mark_regions(side *s, const fw_scenario_profile *plan)
{
    const double middle = plan->middle, contact = plan->contact, far = plan->far[0];
    s->regions[0] = (fw_figure_region){middle - contact, middle + contact, "contact", 1};
    s->regions[1] = (fw_figure_region){middle - far, middle - contact, "intermediate", .35};
    s->regions[2] = (fw_figure_region){middle + contact, middle + far, "intermediate", .35};
}

static double top_of(double mean, double error)
{
    return isfinite(mean) ? mean + (isfinite(error) ? error : 0) : 0;
}

/* From 0 to a little above the largest value of experiment and control, errors included. */
static fw_range range_of(const fw_outcome *column, int count)
{
    double most = 0;
    for (int b = 0; b < count; ++b) {
        most = fmax(most, top_of(column[b].mean, column[b].error));
        most = fmax(most, top_of(column[b].control, column[b].control_error));
    }
    return most > 0 ? (fw_range){-.03 * most, 1.1 * most} : (fw_range){-.03, 1};
}

void fw_plot_profile_values(const fw_profile_table *table, fw_profile_column column, bool control,
                            double *x, double *values, double *errors)
{
    const fw_outcome *outcome = fw_profile_table_column(table, column);
    for (int b = 0; b < table->bin_count; ++b) {
        const double error = control ? outcome[b].control_error : outcome[b].error;
        x[b] = .5 * (table->edges[b] + table->edges[b + 1]);
        values[b] = control ? outcome[b].control : outcome[b].mean;
        errors[b] = isfinite(error) ? error : 0;
    }
}

static bool has_values(const fw_profile_table *table, fw_profile_column column)
{
    for (int b = 0; b < table->bin_count; ++b)
        if (isfinite(fw_profile_table_column(table, column)[b].mean)) return true;
    return false;
}

static const drawn_column *drawn_in(const fw_profile_table *table, int chart)
{
    return &drawn[chart > 0 && !has_values(table, drawn[chart].column) ? CHARTS : chart];
}

static fw_status fill_curves(side *s, const fw_profile_table *table, bool control,
                             const fw_units *units, fw_error *error)
{
    const size_t bins = (size_t)table->bin_count;
    s->x = fw_array_of_doubles(bins);
    if (!s->x) return fw_fail_memory(error, "a profile");
    for (int n = 0; n < CHARTS; ++n) {
        const drawn_column *what = drawn_in(table, n);
        const fw_outcome *column = fw_profile_table_column(table, what->column);
        s->values[n] = fw_array_of_doubles(bins);
        s->errors[n] = fw_array_of_doubles(bins);
        if (!s->values[n] || !s->errors[n]) return fw_fail_memory(error, "a profile");
        fw_plot_profile_values(table, what->column, control, s->x, s->values[n], s->errors[n]);
        s->curves[n] = (fw_curve){.count = table->bin_count,
                                  .x = s->x,
                                  .y = s->values[n],
                                  .error = s->errors[n],
                                  .look = FW_CURVE_LINE_AND_MARKERS,
                                  .colour = n + 1};
        s->charts[n] = (fw_chart){.label = fw_plot_label(s->labels[n], sizeof s->labels[n],
                                                         what->name, what->unit, units),
                                  .curves = &s->curves[n],
                                  .curve_count = 1,
                                  .range = range_of(column, table->bin_count)};
    }
    return FW_OK;
}

static fw_figure_stack_plan plan_of(side *s, const fw_profile_table *table, fw_colouring colouring,
                                    const char *name, const fw_units *units)
{
    const char *across = table->axis == 'x' ? "x" : "y", *along = table->axis == 'x' ? "y" : "x";
    const fw_view *view = &s->view.view;
    snprintf(s->name, sizeof s->name, "%s%s%s", name ? name : "", name ? ", " : "", view->name);
    s->view.view.name = s->name;
    return (fw_figure_stack_plan){
        .views = &s->view.view,
        .view_count = 1,
        .look = FW_VIEW_DISCS,
        .colouring = colouring,
        .charts = s->charts,
        .chart_count = CHARTS,
        .label = fw_plot_label(s->places[0], sizeof s->places[0], across, "length", units),
        .y_label = fw_plot_label(s->places[1], sizeof s->places[1], along, "length", units),
        .regions = s->regions,
        .region_count = 3};
}

static void clear_side(side *s)
{
    fw_plot_view_clear(&s->view);
    free(s->x);
    for (int n = 0; n < CHARTS; ++n) {
        free(s->values[n]);
        free(s->errors[n]);
    }
}

/* The control's own results, where it left some. */
static fw_status open_control(fw_plot_result *control, const fw_plot_result *result,
                              char folder[FW_PATH_SIZE], bool *found, fw_error *error)
{
    *found = result->scenario->study.control_count > 0;
    if (!*found) return FW_OK;
    FW_TRY(fw_path_join(folder, result->directory, FW_CONTROL_FOLDER, error));
    return fw_plot_result_open(control, folder, error);
}

/* The axis of the profile runs from left to right, whichever it is. */
static void lay_across(fw_plot_view *view, char axis)
{
    if (axis == 'x') return;
    for (int b = 0; b < view->view.body_count; ++b) {
        const double *x = view->bodies[b].x;
        view->bodies[b].x = view->bodies[b].y;
        view->bodies[b].y = x;
    }
    view->view.wall_count = 0; /* their shapes lie as they lie */
}

/* Widens `across` by the particles above the bins; returns how many lie elsewhere. */
static int include_above(fw_range *across, const fw_view *view, fw_range bins)
{
    int elsewhere = 0;
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        for (int n = 0; n < body->count; ++n) {
            const double y = body->y[n];
            if (body->x[n] >= bins.low && body->x[n] <= bins.high)
                fw_range_include(across, (double[]){y - body->spacing, y + body->spacing}, 2,
                                 false);
            else
                elsewhere += 1;
        }
    }
    return elsewhere;
}

/* The bins, and one more at either end. */
static fw_range bins_of(const fw_profile_table *table)
{
    const double bin = table->edges[1] - table->edges[0];
    return (fw_range){table->edges[0] - bin, table->edges[table->bin_count] + bin};
}

/* The last frame in which three quarters of the particles are above the bins: where they have been
 * squeezed out, later ones show nothing. The first where there is none. */
static fw_status find_frame(const fw_plot_result *result, const fw_profile_table *table,
                            int64_t *frame, fw_error *error)
{
    const int count = result->playback->particle_count, least = count - count / 4;
    for (; *frame > 0; *frame -= 1) {
        fw_plot_view view;
        fw_range across = fw_range_empty();
        int elsewhere = 0;
        const fw_status status = fw_plot_view_load(&view, result, *frame, NULL, error);
        if (status == FW_OK) {
            lay_across(&view, table->axis);
            elsewhere = include_above(&across, &view.view, bins_of(table));
        }
        fw_plot_view_clear(&view);
        if (status != FW_OK || count - elsewhere >= least) return status;
    }
    return FW_OK;
}

/* Experiment and control stand above the bins of the profile: bodies that have left them would
 * stretch one axis and not the other. Returns whether all particles are there. */
static bool share_axes(fw_figure_stack_plan plans[2], const side sides[2], int columns,
                       const fw_profile_table *table)
{
    const fw_range bins = bins_of(table);
    fw_range across = fw_range_empty();
    int elsewhere = 0;
    for (int k = 0; k < columns; ++k)
        elsewhere += include_above(&across, &sides[k].view.view, bins);
    for (int k = 0; k < columns && !fw_range_is_empty(across); ++k) {
        plans[k].range = bins;
        plans[k].y_range = across;
    }
    return elsewhere == 0;
}

static fw_status fill_sides(side sides[2], const fw_plot_result *result,
                            const fw_plot_result *control, const fw_profile_table *table,
                            const fw_plot_picture *picture, fw_error *error)
{
    const fw_units *units = &result->scenario->units;
    int64_t frame = picture->frames[0];
    if (picture->asked.instant_count == 0) FW_TRY(find_frame(result, table, &frame, error));
    FW_TRY(fw_plot_view_load(&sides[0].view, result, frame, picture->asked.field.text, error));
    lay_across(&sides[0].view, table->axis);
    FW_TRY(fill_curves(&sides[0], table, false, units, error));
    mark_regions(&sides[0], &result->scenario->profile);
    if (!control) return FW_OK;
    const int64_t nearest = fw_plot_nearest_frame(control, result->steps[frame]);
    FW_TRY(fw_plot_view_load(&sides[1].view, control, nearest, picture->asked.field.text, error));
    lay_across(&sides[1].view, table->axis);
    FW_TRY(fill_curves(&sides[1], table, true, units, error));
    mark_regions(&sides[1], &result->scenario->profile);
    return FW_OK;
}

static fw_status draw_sides(const fw_plot_result *result, const fw_plot_picture *picture,
                            const fw_profile_table *table, const fw_plot_result *control,
                            fw_error *error)
{
    side *sides = calloc(2, sizeof *sides);
    if (!sides) return fw_fail_memory(error, "a picture");
    fw_status status = fill_sides(sides, result, control, table, picture, error);
    fw_colouring colours;
    if (status == FW_OK) status = fw_plot_colours_find(&colours, result, picture, error);
    if (status == FW_OK) {
        fw_figure_stack_plan plans[2] = {
            plan_of(&sides[0], table, colours, control ? "experiment" : NULL,
                    &result->scenario->units),
            plan_of(&sides[1], table, colours, "control", &result->scenario->units)};
        const bool all = share_axes(plans, sides, control ? 2 : 1, table);
        fw_page page = picture->page;
        char seeds[64] = "", caption[2048];
        if (result->scenario->study.seeds > 1)
            snprintf(seeds, sizeof seeds, " and %lld seeds with standard errors as bars",
                     (long long)result->scenario->study.seeds);
        snprintf(caption, sizeof caption,
                 "Above: the particles, coloured by their %s. Below: profiles "
                 "across %c, means over the samples%s. %s%s",
                 picture->field_label, table->axis, seeds,
                 all ? "" : "Particles that have left the profile are not shown. ",
                 page.caption ? page.caption : "");
        page.caption = caption;
        if (control) page.width = 240;
        status = control ? fw_figure_columns(&page, plans, 2, error)
                         : fw_figure_stack(&page, plans, error);
    }
    clear_side(&sides[0]);
    clear_side(&sides[1]);
    free(sides);
    return status;
}

fw_status fw_plot_draw_profile(const fw_plot_result *result, const fw_plot_picture *picture,
                               fw_error *error)
{
    fw_plot_result control = {0};
    char folder[FW_PATH_SIZE];
    bool has_control;
    fw_profile_table *table;
    FW_TRY(fw_profile_table_read(&table, result->playback,
                                 result->scenario->profile.axis ? 'y' : 'x', error));
    fw_status status = open_control(&control, result, folder, &has_control, error);
    if (status == FW_OK)
        status = draw_sides(result, picture, table, has_control ? &control : NULL, error);
    fw_plot_result_close(&control);
    fw_profile_table_destroy(table);
    return status;
}

/* --- the fretting loop --- */

/* Component `along` of an observable in the steps of the profile; returns how many values. */
static fw_status read_component(const fw_plot_result *result, const char *name, int component,
                                double **values, int *count, fw_error *error)
{
    fw_playback *playback = result->playback;
    const int number = fw_playback_find_observable(playback, name);
    const size_t rows = (size_t)playback->sample_count;
    *values = NULL;
    if (number < 0 || playback->observables[number].components != 2)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: %s was not measured, expected the results of a scenario with a profile",
                       result->directory, name);
    double *both = fw_array_of_doubles(2 * rows);
    int64_t *steps = calloc(rows + 1, sizeof *steps);
    *values = fw_array_of_doubles(rows);
    fw_status status =
        both && steps && *values ? FW_OK : fw_fail_memory(error, "the fretting loop");
    if (status == FW_OK) status = fw_playback_read_observable(playback, number, both, error);
    if (status == FW_OK) status = fw_playback_read_sample_times(playback, steps, NULL, error);
    *count = 0;
    for (size_t row = 0; row < rows && status == FW_OK; ++row)
        if (steps[row] >= result->scenario->profile.from &&
            steps[row] <= result->scenario->profile.until)
            (*values)[(*count)++] = both[2 * row + (size_t)component];
    free(both);
    free(steps);
    return status;
}

fw_status fw_plot_draw_loop(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error)
{
    const int along = result->scenario->profile.axis == 0 ? 1 : 0;
    const fw_units *units = &result->scenario->units;
    char labels[2][64];
    double *slip = NULL, *force = NULL;
    int count = 0;
    fw_status status = read_component(result, "slip", along, &slip, &count, error);
    if (status == FW_OK)
        status = read_component(result, "interface-force", along, &force, &count, error);
    if (status == FW_OK) {
        /* What the first body does to the second, which slip drags along. */
        for (int n = 0; n < count; ++n) force[n] = -force[n];
        const fw_curve curve = {.count = count, .x = slip, .y = force, .look = FW_CURVE_LINE};
        const fw_chart chart = {
            .label = fw_plot_label(labels[0], sizeof labels[0], "tangential force", "force", units),
            .curves = &curve,
            .curve_count = 1,
            .height = 90};
        fw_page page = picture->page;
        char caption[2048];
        snprintf(caption, sizeof caption,
                 "Force of the first body on the second along the interface, against the "
                 "displacement of the first grip less that of the second. %s",
                 page.caption ? page.caption : "");
        page.caption = caption;
        status = fw_figure_curves(
            &page, &chart,
            fw_plot_label(labels[1], sizeof labels[1], "slip of the grips", "length", units), NULL,
            0, error);
    }
    free(slip);
    free(force);
    return status;
}
