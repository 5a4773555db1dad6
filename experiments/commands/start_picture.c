/* SPDX-License-Identifier: GPL-3.0-or-later */
/* start_picture.c - the scene as it stands before the first step, as a picture of its motion with
 * a single instant. Keeps no state. Start reading at fw_start_picture_draw(). */
#include "start_picture.h"

#include "experiments/drawing/figure.h"
#include "experiments/pictures/wall_outline.h"

#include <stdlib.h>

typedef struct first_frame {
    fw_view_body *bodies;
    fw_outline *walls;
    fw_vec2 (*corners)[FW_WALL_CORNERS_MAX]; /* per wall */
    int **links;                             /* per body */
} first_frame;

static void release_frame(first_frame *frame, int bodies)
{
    for (int b = 0; frame->links && b < bodies; ++b) free(frame->links[b]);
    free(frame->links);
    free(frame->bodies);
    free(frame->walls);
    free(frame->corners);
}

/* The links of a body, numbered within it; NULL without memory. */
static int *links_of(const fw_body_range *range, const fw_solid *solid, int *count)
{
    int *links = calloc(2 * (size_t)solid->link_count + 1, sizeof *links);
    *count = 0;
    for (int n = 0; links && n < solid->link_count; ++n) {
        int one = solid->links[n][0] - range->first, other = solid->links[n][1] - range->first;
        if (one < 0 || one >= range->count || other < 0 || other >= range->count) continue;
        links[2 * *count] = one;
        links[2 * *count + 1] = other;
        *count += 1;
    }
    return links;
}

static fw_status fill_frame(const fw_experiment *experiment, first_frame *frame, fw_error *error)
{
    const fw_scene *scene = experiment->scene;
    int bodies = experiment->body_count, walls = fw_scene_wall_count(scene);
    frame->bodies = calloc((size_t)bodies + 1, sizeof *frame->bodies);
    frame->links = calloc((size_t)bodies + 1, sizeof *frame->links);
    frame->walls = calloc((size_t)walls + 1, sizeof *frame->walls);
    frame->corners = calloc((size_t)walls + 1, sizeof *frame->corners);
    if (!frame->bodies || !frame->links || !frame->walls || !frame->corners)
        return fw_fail_memory(error, "a picture of the start");
    for (int b = 0; b < bodies; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        int count;
        frame->links[b] = links_of(range, solid, &count);
        if (!frame->links[b]) return fw_fail_memory(error, "a picture of the start");
        frame->bodies[b] =
            (fw_view_body){.name = range->name,
                           .count = range->count,
                           .x = solid->x + range->first,
                           .y = solid->y + range->first,
                           .links = frame->links[b],
                           .link_count = count,
                           .kind = b % FW_PALETTE_KINDS,
                           .spacing = experiment->scenario->bodies[b].lattice.spacing};
    }
    for (int w = 0; w < walls; ++w) {
        frame->walls[w] =
            fw_wall_outline(fw_wall_definition(fw_scene_wall(scene, w)), frame->corners[w]);
        frame->walls[w].displacement = fw_scene_wall_displacement(scene, w);
    }
    return FW_OK;
}

fw_status fw_start_picture_draw(const fw_experiment *experiment, const char *file, fw_error *error)
{
    first_frame frame = {0};
    fw_status status = fill_frame(experiment, &frame, error);
    if (status == FW_OK) {
        const fw_view view = {.bodies = frame.bodies,
                              .body_count = experiment->body_count,
                              .walls = frame.walls,
                              .wall_count = fw_scene_wall_count(experiment->scene)};
        const fw_figure_motion_plan plan = {.views = &view, .view_count = 1};
        fw_page page = fw_page_default();
        page.file = file;
        page.title = experiment->scenario->title;
        status = fw_figure_motion(&page, &plan, error);
    }
    release_frame(&frame, experiment->body_count);
    return status;
}
