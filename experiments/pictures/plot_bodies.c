/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_bodies.c - pictures of where bodies are: motion, field, strip.
 * Keeps no state. Start reading at fw_plot_draw_motion(). */
#include "plot_exact.h"
#include "plot_extent.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Beyond so many points a path looks the same, and reading takes long. */
enum { PATH_POINTS = 4000 };

/* --- several frames --- */

/* A row of views; below each row of a strip the exact solution, where there is one. */
enum { STRIP_COLUMNS = 3 };

typedef struct frames {
    int count; /* views: twice the frames with the exact solution */
    bool exact;
    fw_plot_view *loaded;
    fw_view *views;
} frames;

static fw_status load_view(frames *f, const fw_plot_result *result, int64_t frame,
                           const char *field, bool exact, fw_error *error)
{
    fw_plot_view *view = &f->loaded[f->count++];
    FW_TRY(exact ? fw_plot_exact_load(view, result, frame, field, error)
                 : fw_plot_view_load(view, result, frame, field, error));
    f->views[f->count - 1] = view->view;
    return FW_OK;
}

static fw_status load_frames(frames *f, const fw_plot_result *result,
                             const fw_plot_picture *picture, bool exact, fw_error *error)
{
    const int count = picture->frame_count;
    const char *field = picture->asked.field.text;
    *f = (frames){.exact = exact,
                  .loaded = calloc(2 * (size_t)count, sizeof *f->loaded),
                  .views = calloc(2 * (size_t)count, sizeof *f->views)};
    if (!f->loaded || !f->views) return fw_fail_memory(error, "the frames of a picture");
    for (int first = 0; first < count; first += STRIP_COLUMNS)
        for (int row = 0; row <= (int)exact; ++row)
            for (int k = first; k < count && k < first + STRIP_COLUMNS; ++k)
                FW_TRY(load_view(f, result, picture->frames[k], field, row == 1, error));
    return FW_OK;
}

static void clear_frames(frames *f)
{
    for (int k = 0; k < f->count; ++k) fw_plot_view_clear(&f->loaded[k]);
    free(f->loaded);
    free(f->views);
}

/* --- the path of the centre of mass --- */

static double centre(const double *place, const double *mass, int count)
{
    double sum = 0, weight = 0;
    for (int n = 0; n < count; ++n) {
        sum += mass[n] * place[n];
        weight += mass[n];
    }
    return sum / weight;
}

/* A centre that stays where it is has no path to be shown. */
static void keep_moving(fw_plot_paths *paths, const fw_plot_result *result, int points)
{
    for (int b = 0; b < result->playback->body_count; ++b) {
        const double *x = paths->x + (size_t)b * (size_t)points;
        const double *y = paths->y + (size_t)b * (size_t)points;
        fw_range across = fw_range_empty(), along = fw_range_empty();
        fw_range_include(&across, x, points, false);
        fw_range_include(&along, y, points, false);
        double extent = fmax(across.high - across.low, along.high - along.low);
        if (extent > .02 * result->scenario->bodies[b].lattice.spacing)
            paths->path[paths->count++] = (fw_figure_path){x, y, points};
    }
}

static fw_status read_masses(const fw_plot_result *result, double *mass, fw_error *error)
{
    if (result->playback->mass) return fw_playback_read_masses(result->playback, mass, error);
    for (int n = 0; n < result->playback->particle_count; ++n) mass[n] = 1;
    return FW_OK;
}

/* Centres of all bodies at `points` frames, `every` frames apart; the last one is always there. */
static fw_status read_centres(fw_plot_paths *paths, const fw_plot_result *result, int64_t first,
                              int64_t last, int64_t every, int points, fw_error *error)
{
    fw_playback *playback = result->playback;
    size_t particles = (size_t)playback->particle_count;
    double *mass = fw_array_of_doubles(particles);
    double *place[2] = {fw_array_of_doubles(particles), fw_array_of_doubles(particles)};
    fw_status status = mass && place[0] && place[1] ? read_masses(result, mass, error)
                                                    : fw_fail_memory(error, "the path of a body");
    for (int k = 0; k < points && status == FW_OK; ++k) {
        int64_t frame = first + k * every < last ? first + k * every : last;
        status = fw_playback_read_positions(playback, frame, place[0], place[1], error);
        for (int b = 0; b < playback->body_count && status == FW_OK; ++b) {
            const fw_playback_body *body = &playback->bodies[b];
            size_t at = (size_t)b * (size_t)points + (size_t)k;
            paths->x[at] = centre(place[0] + body->first, mass + body->first, body->count);
            paths->y[at] = centre(place[1] + body->first, mass + body->first, body->count);
        }
    }
    free(mass);
    free(place[0]);
    free(place[1]);
    return status;
}

fw_status fw_plot_paths_find(fw_plot_paths *paths, const fw_plot_result *result,
                             const fw_plot_picture *picture, fw_error *error)
{
    int64_t first = picture->frame_count > 1 ? picture->frames[0] : 0;
    int64_t last = picture->frames[picture->frame_count - 1];
    int64_t every = 1 + (last - first) / PATH_POINTS;
    int points = (int)((last - first) / every) + 1 + ((last - first) % every != 0);
    size_t bodies = (size_t)result->playback->body_count;
    *paths = (fw_plot_paths){.path = calloc(bodies, sizeof *paths->path),
                             .x = fw_array_of_doubles(bodies * (size_t)points),
                             .y = fw_array_of_doubles(bodies * (size_t)points)};
    if (!paths->path || !paths->x || !paths->y) return fw_fail_memory(error, "the path of a body");
    FW_TRY(read_centres(paths, result, first, last, every, points, error));
    keep_moving(paths, result, points);
    return FW_OK;
}

void fw_plot_paths_clear(fw_plot_paths *paths)
{
    free(paths->path);
    free(paths->x);
    free(paths->y);
    *paths = (fw_plot_paths){0};
}

/* --- pictures --- */

fw_status fw_plot_draw_motion(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error)
{
    frames shown;
    fw_plot_paths paths = {0};
    fw_view_bounds bounds = {{0, 0}, {0, 0}};
    fw_status status = load_frames(&shown, result, picture, false, error);
    if (status == FW_OK) status = fw_plot_paths_find(&paths, result, picture, error);
    /* Single instants of a result have the same axes. */
    if (status == FW_OK && picture->fixed_axes && picture->frame_count == 1)
        status = fw_plot_frame_find(&bounds, result, false, error);
    if (status == FW_OK) {
        const fw_figure_motion_plan plan = {.views = shown.views,
                                            .view_count = shown.count,
                                            .paths = paths.path,
                                            .path_count = paths.count,
                                            .bounds = bounds};
        status = fw_figure_motion(&picture->page, &plan, error);
    }
    fw_plot_paths_clear(&paths);
    clear_frames(&shown);
    return status;
}

/* What the colours mean goes into the caption: it is too long for the colour bar. */
static fw_page page_with_meaning(const fw_plot_result *result, const fw_plot_picture *picture,
                                 char *caption, size_t size)
{
    fw_page page = picture->page;
    const char *meaning = "";
    for (int n = 0; picture->asked.field.text && n < result->playback->field_count; ++n)
        if (strcmp(result->playback->fields[n].name, picture->asked.field.text) == 0)
            meaning = result->playback->fields[n].meaning;
    if (meaning[0]) {
        snprintf(caption, size, "%s: %s. %s", picture->field_label, meaning, page.caption);
        page.caption = caption;
    }
    return page;
}

/* Particles that flow leave their places and each other: cells would hide that. */
static fw_view_look look_of(const fw_plot_result *result)
{
    const fw_scenario *scenario = result->scenario;
    for (int b = 0; b < scenario->body_count; ++b)
        if (fw_scenario_model(scenario, b)->flows) return FW_VIEW_DISCS;
    return FW_VIEW_CELLS;
}

fw_status fw_plot_draw_field(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    fw_plot_view loaded;
    char caption[2048];
    const fw_page page = page_with_meaning(result, picture, caption, sizeof caption);
    fw_figure_field_plan plan = {.view = &loaded.view, .look = look_of(result)};
    fw_status status =
        fw_plot_view_load(&loaded, result, picture->frames[0], picture->asked.field.text, error);
    if (status == FW_OK && picture->fixed_axes)
        status = fw_plot_frame_find(&plan.bounds, result, false, error);
    if (status == FW_OK) status = fw_plot_colours_find(&plan.colouring, result, picture, error);
    if (status == FW_OK) status = fw_figure_field(&page, &plan, error);
    fw_plot_view_clear(&loaded);
    return status;
}

fw_status fw_plot_draw_strip(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    frames shown;
    char caption[2048];
    const fw_page page = page_with_meaning(result, picture, caption, sizeof caption);
    fw_figure_strip_plan plan = {.look = look_of(result)};
    const bool exact = fw_plot_exact_exists(result, picture->asked.field.text);
    fw_status status = load_frames(&shown, result, picture, exact, error);
    if (status == FW_OK) status = fw_plot_colours_find(&plan.colouring, result, picture, error);
    plan.views = shown.views;
    plan.view_count = shown.count;
    if (exact) plan.columns = STRIP_COLUMNS;
    if (status == FW_OK) status = fw_figure_strip(&page, &plan, error);
    clear_frames(&shown);
    return status;
}
