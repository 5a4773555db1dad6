/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_contact.c - the bodies with the forces on their particles as arrows, at several instants
 * side by side. Keeps no state. Start reading at fw_plot_draw_contact(). */
#include "plot_parts.h"

#include "core/array.h"

#include <stdlib.h>

typedef struct instants {
    int count;
    fw_plot_view *loaded;
    fw_view *views;
    double *x, *y; /* forces of all particles, one instant after the other */
} instants;

static fw_status load(instants *shown, const fw_plot_result *result, int64_t frame, fw_error *error)
{
    const fw_playback *playback = result->playback;
    const size_t at = (size_t)shown->count * (size_t)playback->particle_count;
    fw_plot_view *view = &shown->loaded[shown->count++];
    FW_TRY(fw_plot_view_load(view, result, frame, NULL, error));
    FW_TRY(fw_playback_read_forces(result->playback, frame, shown->x + at, shown->y + at, error));
    for (int b = 0; b < playback->body_count; ++b) {
        view->bodies[b].force_x = shown->x + at + playback->bodies[b].first;
        view->bodies[b].force_y = shown->y + at + playback->bodies[b].first;
    }
    shown->views[shown->count - 1] = view->view;
    return FW_OK;
}

static fw_status load_all(instants *shown, const fw_plot_result *result,
                          const fw_plot_picture *picture, fw_error *error)
{
    const size_t frames = (size_t)picture->frame_count;
    const size_t numbers = frames * (size_t)result->playback->particle_count;
    *shown = (instants){.loaded = calloc(frames, sizeof *shown->loaded),
                        .views = calloc(frames, sizeof *shown->views),
                        .x = fw_array_of_doubles(numbers),
                        .y = fw_array_of_doubles(numbers)};
    if (!shown->loaded || !shown->views || !shown->x || !shown->y)
        return fw_fail_memory(error, "the frames of a picture");
    for (int k = 0; k < picture->frame_count; ++k)
        FW_TRY(load(shown, result, picture->frames[k], error));
    return FW_OK;
}

static void clear(instants *shown)
{
    for (int k = 0; k < shown->count; ++k) fw_plot_view_clear(&shown->loaded[k]);
    free(shown->loaded);
    free(shown->views);
    free(shown->x);
    free(shown->y);
}

fw_status fw_plot_draw_contact(const fw_plot_result *result, const fw_plot_picture *picture,
                               fw_error *error)
{
    instants shown;
    char caption[2048];
    fw_page page = picture->page;
    if (!result->playback->force)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: forces were not recorded; a picture of kind 'contact' in the scenario "
                       "lets them be, or record.force: true",
                       result->directory);
    snprintf(caption, sizeof caption,
             "Arrows: external forces, and reactions of walls, grips and other bodies, [F(t) + "
             "F(t-1)]/2, on the particles where they begin. %s",
             page.caption);
    page.caption = caption;
    fw_status status = load_all(&shown, result, picture, error);
    if (status == FW_OK) {
        const fw_figure_strip_plan plan = {
            .views = shown.views, .view_count = shown.count, .look = FW_VIEW_DISCS};
        status = fw_figure_strip(&page, &plan, error);
    }
    clear(&shown);
    return status;
}
