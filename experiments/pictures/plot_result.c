/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_result.c - a results folder, opened for drawing, and its frames as views.
 * Invariant: bodies of the file and bodies of the scenario in it are the same, in the same order.
 * State: fw_plot_result, whose frame is the one loaded last. Start reading at
 * fw_plot_result_open(). */
#include "plot_parts.h"

#include "core/array.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the result --- */

static fw_status check_bodies(const fw_plot_result *result, fw_error *error)
{
    const fw_playback *playback = result->playback;
    const fw_scenario *scenario = result->scenario;
    bool same = playback->body_count == scenario->body_count;
    for (int b = 0; same && b < playback->body_count; ++b)
        same = strcmp(playback->bodies[b].name, scenario->bodies[b].name) == 0 &&
               playback->bodies[b].count == scenario->bodies[b].shape.count;
    if (same) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: the bodies in the results are not those of their own "
                   "scenario",
                   result->directory);
}

static fw_status read_frame_times(fw_plot_result *result, fw_error *error)
{
    size_t count = (size_t)result->playback->frame_count;
    if (count == 0)
        return fw_fail(error, FW_BAD_INPUT, "%s: the results hold no frame yet", result->directory);
    result->steps = fw_array_allocate(count, sizeof *result->steps);
    result->times = fw_array_of_doubles(count);
    if (!result->steps || !result->times) return fw_fail_memory(error, "the steps of all frames");
    return fw_playback_read_frame_times(result->playback, result->steps, result->times, error);
}

/* Bodies without a lattice begin where they were placed. */
static fw_status place_where_placed(fw_plot_result *result, fw_error *error)
{
    fw_playback *playback = result->playback;
    size_t count = (size_t)playback->particle_count;
    double *x = fw_array_of_doubles(count), *y = fw_array_of_doubles(count);
    fw_status status = x && y ? fw_playback_read_positions(playback, 0, x, y, error)
                              : fw_fail_memory(error, "the places at rest");
    for (int b = 0; b < playback->body_count && status == FW_OK; ++b) {
        const fw_playback_body *body = &playback->bodies[b];
        size_t bytes = (size_t)body->count * sizeof *x;
        if (!fw_shape_is_free(result->scenario->bodies[b].shape.kind)) continue;
        memcpy(result->rest_x + body->first, x + body->first, bytes);
        memcpy(result->rest_y + body->first, y + body->first, bytes);
    }
    free(x);
    free(y);
    return status;
}

static fw_status find_rest(fw_plot_result *result, fw_error *error)
{
    size_t count = (size_t)result->playback->particle_count;
    result->rest_x = fw_array_of_doubles(count);
    result->rest_y = fw_array_of_doubles(count);
    if (!result->rest_x || !result->rest_y) return fw_fail_memory(error, "the places at rest");
    int particle = 0;
    for (int b = 0; b < result->scenario->body_count; ++b) {
        const fw_scenario_body *body = &result->scenario->bodies[b];
        fw_sites sites;
        FW_TRY(fw_scenario_sites(body, &sites, error));
        for (int n = 0; n < sites.count; ++n, ++particle) {
            fw_vec2 place = fw_lattice_position(&body->lattice, sites.site[n]);
            result->rest_x[particle] = place.x;
            result->rest_y[particle] = place.y;
        }
        fw_sites_clear(&sites);
    }
    return place_where_placed(result, error);
}

/* Number of the body that a particle belongs to. */
static int body_of(const fw_playback *playback, int particle)
{
    int low = 0, high = playback->body_count - 1;
    while (low < high) {
        int middle = (low + high + 1) / 2;
        if (playback->bodies[middle].first <= particle)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

static fw_status sort_links(fw_plot_result *result, fw_error *error)
{
    const fw_playback *playback = result->playback;
    size_t bodies = (size_t)playback->body_count;
    result->links = fw_array_allocate(2 * (size_t)playback->link_count + 1, sizeof *result->links);
    result->link_first = calloc(bodies + 2, sizeof *result->link_first);
    if (!result->links || !result->link_first) return fw_fail_memory(error, "the links");
    /* Counted two places ahead, so that each body's count has become its beginning when the links
     * are laid down, and its end afterwards. */
    for (int round = 0; round < 2; ++round) {
        for (int n = 0; n < playback->link_count; ++n) {
            int one = playback->links[n][0], other = playback->links[n][1];
            int body = body_of(playback, one), first = playback->bodies[body].first;
            if (body_of(playback, other) != body) continue;
            if (round == 0) {
                result->link_first[body + 2] += 1;
                continue;
            }
            int at = result->link_first[body + 1]++;
            result->links[2 * at] = one - first;
            result->links[2 * at + 1] = other - first;
        }
        for (size_t b = 2; round == 0 && b < bodies + 2; ++b)
            result->link_first[b] += result->link_first[b - 1];
    }
    return FW_OK;
}

static fw_status make_walls(fw_plot_result *result, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    result->walls = calloc((size_t)scenario->wall_count + 1, sizeof *result->walls);
    result->corners = calloc((size_t)scenario->wall_count + 1, sizeof *result->corners);
    if (!result->walls || !result->corners) return fw_fail_memory(error, "the walls of a picture");
    for (int w = 0; w < scenario->wall_count; ++w)
        FW_TRY(fw_wall_create(&result->walls[w], w, &scenario->walls[w].def, error));
    return FW_OK;
}

/* Where pistons were: they are always measured. */
static fw_status read_piston(fw_plot_result *result, int wall, fw_error *error)
{
    fw_playback *playback = result->playback;
    const char *wall_name = result->scenario->walls[wall].def.name;
    char name[2 * FW_NAME_SIZE];
    snprintf(name, sizeof name, "piston-displacement.%s", wall_name);
    const int observable = fw_playback_find_observable(playback, name);
    if (observable < 0 || playback->observables[observable].components != 2)
        return fw_fail(error, FW_BAD_INPUT, "%s: the results do not say where the piston %s was",
                       result->directory, wall_name);
    result->piston_paths[wall] = fw_array_of_doubles(2 * (size_t)playback->sample_count);
    if (!result->piston_paths[wall]) return fw_fail_memory(error, "the path of a piston");
    return fw_playback_read_observable(playback, observable, result->piston_paths[wall], error);
}

static fw_status read_pistons(fw_plot_result *result, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    const size_t samples = (size_t)result->playback->sample_count;
    result->piston_paths = calloc((size_t)scenario->wall_count + 1, sizeof *result->piston_paths);
    result->sample_steps = fw_array_allocate(samples + 1, sizeof *result->sample_steps);
    if (!result->piston_paths || !result->sample_steps)
        return fw_fail_memory(error, "the paths of pistons");
    FW_TRY(fw_playback_read_sample_times(result->playback, result->sample_steps, NULL, error));
    for (int w = 0; w < scenario->wall_count; ++w)
        if (scenario->walls[w].is_piston) FW_TRY(read_piston(result, w, error));
    return FW_OK;
}

/* Between two samples a piston is drawn on the straight line. */
static fw_vec2 displacement_of(const fw_plot_result *result, int wall, int64_t frame)
{
    const double *path = result->piston_paths[wall];
    const int64_t step = result->steps[frame], count = result->playback->sample_count;
    if (path && count == 0) return (fw_vec2){0, 0};
    if (!path) return fw_wall_displacement(result->walls[wall], result->times[frame]);
    int64_t after = 0;
    while (after < count - 1 && result->sample_steps[after] < step) ++after;
    const int64_t before = after > 0 ? after - 1 : 0;
    const double span = (double)(result->sample_steps[after] - result->sample_steps[before]);
    double part = span > 0 ? (double)(step - result->sample_steps[before]) / span : 0;
    part = fmin(part, 1);
    const fw_vec2 from = {path[2 * before], path[2 * before + 1]};
    const fw_vec2 to = {path[2 * after], path[2 * after + 1]};
    return fw_vec2_add(from, fw_vec2_scale(part, fw_vec2_subtract(to, from)));
}

void fw_plot_walls_at(fw_outline *walls, const fw_plot_result *result, int64_t frame)
{
    for (int w = 0; w < result->scenario->wall_count; ++w) {
        walls[w] = fw_wall_outline(fw_wall_definition(result->walls[w]), result->corners[w]);
        walls[w].displacement = displacement_of(result, w, frame);
    }
}

/* Where every lattice has spacing 1, that is the unit of length. */
static const char *sentence_of_units(const fw_scenario *scenario)
{
    if (fw_units_given(&scenario->units)) return "";
    for (int b = 0; b < scenario->body_count; ++b)
        if (scenario->bodies[b].lattice.spacing != 1 ||
            fw_shape_is_free(scenario->bodies[b].shape.kind))
            return "Reduced units.";
    return scenario->body_count > 0 ? "Reduced units: a length of 1 is a lattice spacing."
                                    : "Reduced units.";
}

fw_status fw_plot_result_open(fw_plot_result *result, const char *directory, fw_error *error)
{
    *result = (fw_plot_result){.directory = directory};
    FW_TRY(fw_playback_open(&result->playback, directory, error));
    const char *text = result->playback->scenario;
    FW_TRY(fw_scenario_read(&result->scenario, directory, text, strlen(text), NULL, 0, error));
    FW_TRY(check_bodies(result, error));
    FW_TRY(read_frame_times(result, error));
    FW_TRY(find_rest(result, error));
    FW_TRY(sort_links(result, error));
    result->units = sentence_of_units(result->scenario);
    FW_TRY(make_walls(result, error));
    return read_pistons(result, error);
}

void fw_plot_result_close(fw_plot_result *result)
{
    for (int w = 0; result->walls && w < result->scenario->wall_count; ++w)
        fw_wall_destroy(result->walls[w]);
    for (int w = 0; result->piston_paths && w < result->scenario->wall_count; ++w)
        free(result->piston_paths[w]);
    free(result->piston_paths);
    free(result->sample_steps);
    free(result->walls);
    free(result->corners);
    free(result->link_first);
    free(result->links);
    free(result->rest_x);
    free(result->rest_y);
    free(result->steps);
    free(result->times);
    fw_scenario_destroy(result->scenario);
    fw_playback_close(result->playback);
    *result = (fw_plot_result){0};
}

int64_t fw_plot_nearest_frame(const fw_plot_result *result, int64_t step)
{
    int64_t low = 0, high = result->playback->frame_count - 1;
    while (high - low > 1) {
        int64_t middle = low + (high - low) / 2;
        if (result->steps[middle] <= step)
            low = middle;
        else
            high = middle;
    }
    return step - result->steps[low] <= result->steps[high] - step ? low : high;
}

/* --- a frame --- */

static bool allocate_view(fw_plot_view *view, const fw_plot_result *result, const char *field)
{
    const fw_playback *playback = result->playback;
    size_t count = (size_t)playback->particle_count;
    view->x = fw_array_of_doubles(count);
    view->y = fw_array_of_doubles(count);
    view->field = field ? fw_array_of_doubles(count) : NULL;
    view->links = fw_array_allocate(2 * (size_t)playback->link_count + 1, sizeof *view->links);
    view->bodies = calloc((size_t)playback->body_count, sizeof *view->bodies);
    view->walls = calloc((size_t)result->scenario->wall_count + 1, sizeof *view->walls);
    return view->x && view->y && (view->field || !field) && view->links && view->bodies &&
           view->walls;
}

/* How far the ends of a link, numbers among all particles, are from where they lie to each other at
 * rest (Chopard & Marconi Eq 31). */
static double stretch_of(const fw_plot_view *view, const fw_plot_result *result, int one, int other)
{
    double x = view->x[other] - view->x[one] - (result->rest_x[other] - result->rest_x[one]);
    double y = view->y[other] - view->y[one] - (result->rest_y[other] - result->rest_y[one]);
    return hypot(x, y);
}

/* The whole links of a body into `links`; returns how many. */
static int take_links(const fw_plot_view *view, const fw_plot_result *result, int body, int *links)
{
    const fw_scenario *scenario = result->scenario;
    const double break_at =
        fw_material_break_at(&scenario->materials[scenario->bodies[body].material]);
    int first = result->playback->bodies[body].first, count = 0;
    for (int n = result->link_first[body]; n < result->link_first[body + 1]; ++n) {
        int one = result->links[2 * n], other = result->links[2 * n + 1];
        if (break_at > 0 && stretch_of(view, result, first + one, first + other) > break_at)
            continue;
        links[2 * count] = one;
        links[2 * count + 1] = other;
        count += 1;
    }
    return count;
}

/* The time too, where it is not the number of the step. */
static void name_view(fw_plot_view *view, const fw_plot_result *result, int64_t frame)
{
    char step[32], time[32];
    fw_ticks_print_number(step, sizeof step, (double)result->steps[frame], 15);
    const bool same = result->times[frame] == (double)result->steps[frame];
    const fw_physical unit = fw_units_physical(&result->scenario->units, "time");
    fw_ticks_print_number(time, sizeof time, fw_physical_value(&unit, result->times[frame]), 6);
    snprintf(view->name, sizeof view->name,
             same && unit.factor == 0 ? "step %s" : "step %s, time %s%s%s", step, time,
             unit.factor > 0 ? " " : "", unit.text);
}

static void describe_view(fw_plot_view *view, const fw_plot_result *result, int64_t frame)
{
    const fw_playback *playback = result->playback;
    const fw_scenario *scenario = result->scenario;
    for (int b = 0; b < playback->body_count; ++b) {
        int first = playback->bodies[b].first;
        int *links = view->links + 2 * result->link_first[b];
        view->bodies[b] = (fw_view_body){
            .name = scenario->bodies[b].name,
            .count = playback->bodies[b].count,
            .x = view->x + first,
            .y = view->y + first,
            .links = links,
            .link_count = take_links(view, result, b, links),
            .field = view->field ? view->field + first : NULL,
            .kind = b % FW_PALETTE_KINDS,
            .spacing = scenario->bodies[b].lattice.spacing,
        };
    }
    fw_plot_walls_at(view->walls, result, frame);
    view->view = (fw_view){.name = view->name,
                           .step = result->steps[frame],
                           .bodies = view->bodies,
                           .body_count = playback->body_count,
                           .walls = view->walls,
                           .wall_count = scenario->wall_count};
}

fw_status fw_plot_view_load(fw_plot_view *view, const fw_plot_result *result, int64_t frame,
                            const char *field, fw_error *error)
{
    *view = (fw_plot_view){0};
    if (!allocate_view(view, result, field)) return fw_fail_memory(error, "a frame to draw");
    FW_TRY(fw_playback_read_positions(result->playback, frame, view->x, view->y, error));
    if (field) FW_TRY(fw_playback_read_field(result->playback, frame, field, view->field, error));
    name_view(view, result, frame);
    describe_view(view, result, frame);
    return FW_OK;
}

void fw_plot_view_clear(fw_plot_view *view)
{
    free(view->x);
    free(view->y);
    free(view->field);
    free(view->links);
    free(view->bodies);
    free(view->walls);
    *view = (fw_plot_view){0};
}
