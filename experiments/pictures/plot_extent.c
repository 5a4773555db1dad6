/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_extent.c - extent of a result in space and in its fields. Keeps no state. */
#include "plot_extent.h"

#include "core/array.h"

#include <stdlib.h>

/* More frames, and more values, say nothing new and take long to read. */
enum { FRAMES_MAX = 240, VALUES_MAX = 1 << 21 };

/* So many frames are looked at: evenly, the first and the last among them. */
static int looked_at(const fw_plot_result *result)
{
    const fw_playback *playback = result->playback;
    int64_t most = VALUES_MAX / (playback->particle_count > 0 ? playback->particle_count : 1);
    most = most < 2 ? 2 : most > FRAMES_MAX ? FRAMES_MAX : most;
    return (int)(playback->frame_count < most ? playback->frame_count : most);
}

static int64_t frame_of(const fw_plot_result *result, int number, int count)
{
    return count > 1 ? number * (result->playback->frame_count - 1) / (count - 1) : 0;
}

/* Of so many frames. */
static fw_status include_bodies(fw_view_bounds *bounds, const fw_plot_result *result, int count,
                                fw_error *error)
{
    const fw_playback *playback = result->playback;
    double *x = fw_array_of_doubles((size_t)playback->particle_count);
    double *y = fw_array_of_doubles((size_t)playback->particle_count);
    fw_status status = x && y ? FW_OK : fw_fail_memory(error, "the axes of a picture");
    for (int k = 0; k < count && status == FW_OK; ++k) {
        status =
            fw_playback_read_positions(result->playback, frame_of(result, k, count), x, y, error);
        for (int b = 0; b < playback->body_count && status == FW_OK; ++b) {
            const fw_playback_body *of = &playback->bodies[b];
            const fw_view_body body = {.count = of->count,
                                       .x = x + of->first,
                                       .y = y + of->first,
                                       .spacing = result->scenario->bodies[b].lattice.spacing};
            const fw_view view = {.bodies = &body, .body_count = 1};
            fw_view_bounds_include_bodies(bounds, &view);
        }
    }
    free(x);
    free(y);
    return status;
}

/* As much of them as a picture of all these bodies shows. */
static fw_status include_walls(fw_view_bounds *bounds, const fw_plot_result *result, int count,
                               fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    const fw_view_bounds bodies_only = *bounds;
    fw_outline *walls = calloc((size_t)scenario->wall_count + 1, sizeof *walls);
    fw_view_body *bodies = calloc((size_t)scenario->body_count + 1, sizeof *bodies);
    const fw_status status =
        walls && bodies ? FW_OK : fw_fail_memory(error, "the axes of a picture");
    for (int b = 0; b < scenario->body_count && status == FW_OK; ++b)
        bodies[b].spacing = scenario->bodies[b].lattice.spacing;
    for (int k = 0; k < count && status == FW_OK; ++k) {
        fw_view_bounds frame = bodies_only;
        fw_plot_walls_at(walls, result, frame_of(result, k, count));
        const fw_view view = {.bodies = bodies,
                              .body_count = scenario->body_count,
                              .walls = walls,
                              .wall_count = scenario->wall_count};
        fw_view_bounds_include_walls(&frame, &view, 1);
        fw_range_include(&bounds->x, (double[]){frame.x.low, frame.x.high}, 2, false);
        fw_range_include(&bounds->y, (double[]){frame.y.low, frame.y.high}, 2, false);
    }
    free(walls);
    free(bodies);
    return status;
}

fw_status fw_plot_bounds_find(fw_view_bounds *bounds, const fw_plot_result *result, fw_error *error)
{
    *bounds = fw_view_bounds_empty();
    return include_bodies(bounds, result, looked_at(result), error);
}

fw_status fw_plot_frame_find(fw_view_bounds *bounds, const fw_plot_result *result, bool each,
                             fw_error *error)
{
    const int count = each ? (int)result->playback->frame_count : looked_at(result);
    if (result->bounds) {
        *bounds = *result->bounds;
        return FW_OK;
    }
    *bounds = fw_view_bounds_empty();
    FW_TRY(include_bodies(bounds, result, count, error));
    return include_walls(bounds, result, count, error);
}

fw_status fw_plot_colours_find(fw_colouring *colouring, const fw_plot_result *result,
                               const fw_plot_picture *picture, fw_error *error)
{
    const char *field = picture->asked.field.text;
    const double *asked = picture->asked.range;
    *colouring = (fw_colouring){.label = picture->field, .map = picture->map};
    if (!field) return FW_OK;
    if (asked[0] < asked[1]) {
        colouring->range = (fw_range){asked[0], asked[1]};
        return FW_OK;
    }
    const int count = looked_at(result);
    const long particles = result->playback->particle_count;
    double *values = fw_array_of_doubles((size_t)particles);
    fw_range all = fw_range_empty();
    fw_status status = values ? FW_OK : fw_fail_memory(error, "the colours of a picture");
    for (int k = 0; k < count && status == FW_OK; ++k) {
        status = fw_playback_read_field(result->playback, frame_of(result, k, count), field, values,
                                        error);
        if (status != FW_OK) break;
        /* A few odd particles do not wash out the rest. */
        const fw_range most = fw_range_of_most(values, particles, .005, false);
        if (!fw_range_is_empty(most))
            fw_range_include(&all, (double[]){most.low, most.high}, 2, false);
    }
    if (status == FW_OK && !fw_range_is_empty(all)) {
        const fw_colour_scale scale =
            fw_colour_scale_for(*colouring, (double[]){all.low, all.high}, 2);
        colouring->range = scale.range;
        colouring->map = scale.map;
    }
    free(values);
    return status;
}
