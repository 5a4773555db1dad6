/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_bodies.c - pictures of where bodies are: motion, field, strip.
 * Keeps no state. Start reading at fw_plot_draw_motion(). */
#include "experiments/plot_parts.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Beyond so many points a path looks the same, and reading takes long. */
enum { PATH_POINTS = 4000 };

/* --- several frames --- */

static fw_status load_views(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_plot_view **loaded, fw_view **views, fw_error *error)
{
    *loaded = calloc((size_t)picture->frame_count, sizeof **loaded);
    *views = calloc((size_t)picture->frame_count, sizeof **views);
    if (!*loaded || !*views) return fw_fail_memory(error, "the frames of a picture");
    for (int k = 0; k < picture->frame_count; ++k) {
        FW_TRY(fw_plot_view_load(&(*loaded)[k], result, picture->frames[k], picture->field, error));
        (*views)[k] = (*loaded)[k].view;
    }
    return FW_OK;
}

static void clear_views(const fw_plot_picture *picture, fw_plot_view *loaded, fw_view *views)
{
    for (int k = 0; loaded && k < picture->frame_count; ++k) fw_plot_view_clear(&loaded[k]);
    free(loaded);
    free(views);
}

/* --- the way of the centre of mass --- */

typedef struct paths {
    int count, point_count;
    fw_figure_path *path;
    double *x, *y; /* point_count of each body, body by body */
    double *mass, *particle_x, *particle_y;
} paths;

static bool allocate_paths(paths *p, const fw_plot_result *result, int point_count)
{
    size_t bodies = (size_t)result->playback->body_count, points = (size_t)point_count;
    size_t particles = (size_t)result->playback->particle_count;
    p->point_count = point_count;
    p->path = calloc(bodies, sizeof *p->path);
    p->x = fw_array_of_doubles(bodies * points);
    p->y = fw_array_of_doubles(bodies * points);
    p->mass = fw_array_of_doubles(particles);
    p->particle_x = fw_array_of_doubles(particles);
    p->particle_y = fw_array_of_doubles(particles);
    return p->path && p->x && p->y && p->mass && p->particle_x && p->particle_y;
}

static void free_paths(paths *p)
{
    free(p->path);
    free(p->x);
    free(p->y);
    free(p->mass);
    free(p->particle_x);
    free(p->particle_y);
}

static double centre(const double *place, const double *mass, int count)
{
    double sum = 0, weight = 0;
    for (int n = 0; n < count; ++n) {
        sum += mass[n] * place[n];
        weight += mass[n];
    }
    return sum / weight;
}

/* A centre that stays where it is has no way to be shown. */
static void keep_moving(paths *p, const fw_plot_result *result)
{
    int bodies = result->playback->body_count;
    for (int b = 0; b < bodies; ++b) {
        const double *x = p->x + (size_t)b * (size_t)p->point_count;
        const double *y = p->y + (size_t)b * (size_t)p->point_count;
        fw_range across = fw_range_empty(), along = fw_range_empty();
        fw_range_include(&across, x, p->point_count, false);
        fw_range_include(&along, y, p->point_count, false);
        double extent = fmax(across.high - across.low, along.high - along.low);
        if (extent > .02 * result->scenario->bodies[b].lattice.spacing)
            p->path[p->count++] = (fw_figure_path){x, y, p->point_count};
    }
}

/* From the first frame shown to the last one; up to the only one. */
static fw_status find_paths(paths *p, const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error)
{
    fw_playback *playback = result->playback;
    int64_t first = picture->frame_count > 1 ? picture->frames[0] : 0;
    int64_t last = picture->frames[picture->frame_count - 1];
    int64_t every = 1 + (last - first) / PATH_POINTS;
    int count = (int)((last - first) / every) + 1 + ((last - first) % every != 0);
    if (!allocate_paths(p, result, count)) return fw_fail_memory(error, "the path of a body");
    if (playback->mass)
        FW_TRY(fw_playback_read_masses(playback, p->mass, error));
    else
        for (int n = 0; n < playback->particle_count; ++n) p->mass[n] = 1;
    for (int k = 0; k < count; ++k) {
        int64_t frame = first + k * every < last ? first + k * every : last;
        FW_TRY(fw_playback_read_positions(playback, frame, p->particle_x, p->particle_y, error));
        for (int b = 0; b < playback->body_count; ++b) {
            const fw_playback_body *body = &playback->bodies[b];
            size_t at = (size_t)b * (size_t)count + (size_t)k;
            p->x[at] = centre(p->particle_x + body->first, p->mass + body->first, body->count);
            p->y[at] = centre(p->particle_y + body->first, p->mass + body->first, body->count);
        }
    }
    keep_moving(p, result);
    return FW_OK;
}

/* --- pictures --- */

fw_status fw_plot_draw_motion(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error)
{
    fw_plot_view *loaded = NULL;
    fw_view *views = NULL;
    paths p = {0};
    fw_status status = load_views(result, picture, &loaded, &views, error);
    if (status == FW_OK) status = find_paths(&p, result, picture, error);
    if (status == FW_OK) {
        const fw_figure_motion_plan plan = {.views = views,
                                            .view_count = picture->frame_count,
                                            .paths = p.path,
                                            .path_count = p.count,
                                            .length_unit = result->length_unit};
        status = fw_figure_motion(&picture->page, &plan, error);
    }
    free_paths(&p);
    clear_views(picture, loaded, views);
    return status;
}

/* What the colours mean goes into the caption: it is too long for the colour bar. */
static fw_page page_with_meaning(const fw_plot_result *result, const fw_plot_picture *picture,
                                 char *caption, size_t size)
{
    fw_page page = picture->page;
    const char *meaning = "";
    for (int n = 0; picture->field && n < result->playback->field_count; ++n)
        if (strcmp(result->playback->fields[n].name, picture->field) == 0)
            meaning = result->playback->fields[n].meaning;
    if (meaning[0]) {
        snprintf(caption, size, "%s: %s. %s", picture->field, meaning, page.caption);
        page.caption = caption;
    }
    return page;
}

fw_status fw_plot_draw_field(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    fw_plot_view loaded;
    char caption[2048];
    const fw_page page = page_with_meaning(result, picture, caption, sizeof caption);
    fw_status status =
        fw_plot_view_load(&loaded, result, picture->frames[0], picture->field, error);
    if (status == FW_OK) {
        const fw_figure_field_plan plan = {.view = &loaded.view,
                                           .colouring = {.label = picture->field},
                                           .length_unit = result->length_unit};
        status = fw_figure_field(&page, &plan, error);
    }
    fw_plot_view_clear(&loaded);
    return status;
}

fw_status fw_plot_draw_strip(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    fw_plot_view *loaded = NULL;
    fw_view *views = NULL;
    char caption[2048];
    const fw_page page = page_with_meaning(result, picture, caption, sizeof caption);
    fw_status status = load_views(result, picture, &loaded, &views, error);
    if (status == FW_OK) {
        const fw_figure_strip_plan plan = {.views = views,
                                           .view_count = picture->frame_count,
                                           .colouring = {.label = picture->field}};
        status = fw_figure_strip(&page, &plan, error);
    }
    clear_views(picture, loaded, views);
    return status;
}
