/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_forces.c - forces as arrows (Chopard & Marconi Figs 4 and 5): those of the links, which
 * follow from where the particles are, and those that the file holds as external.
 * Keeps no state. Invariant: each link pulls its two ends with opposite forces. Start reading at
 * fw_plot_draw_forces(). */
#include "experiments/drawing/ticks.h"
#include "plot_parts.h"

#include "core/array.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { PANELS_MAX = 64 };

/* Stiffness of the links of one body, by their numbers in the result. */
static fw_status apply_replacement(const fw_plot_result *result, int body,
                                   const fw_replacement *change, const fw_sites *sites,
                                   fw_sym2 *stiffness, fw_error *error)
{
    int *particles, count;
    bool *selected = calloc((size_t)sites->count, sizeof *selected);
    if (!selected) return fw_fail_memory(error, "the stiffness of links");
    fw_status status = fw_selection_particles(&change->sites, sites, &particles, &count, error);
    if (status == FW_OK) {
        for (int n = 0; n < count; ++n) selected[particles[n]] = true;
        free(particles);
        int first = result->link_first[body], end = result->link_first[body + 1];
        for (int n = first; n < end; ++n) {
            bool here = selected[result->links[2 * n]], there = selected[result->links[2 * n + 1]];
            bool chosen = change->links == FW_LINKS_INSIDE   ? here && there
                          : change->links == FW_LINKS_ACROSS ? here != there
                                                             : here || there;
            if (chosen) stiffness[n] = change->value;
        }
    }
    free(selected);
    return status;
}

static fw_status find_stiffness(const fw_plot_result *result, int body, fw_sym2 *stiffness,
                                fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    const fw_scenario_body *of = &scenario->bodies[body];
    const fw_sym2 *own = fw_material_link_stiffness(&scenario->materials[of->material]);
    for (int n = result->link_first[body]; n < result->link_first[body + 1]; ++n)
        stiffness[n] = *own;
    if (of->link_stiffness.count == 0) return FW_OK;
    fw_sites sites;
    FW_TRY(fw_scenario_sites(of, &sites, error));
    fw_status status = FW_OK;
    for (int n = 0; n < of->link_stiffness.count && status == FW_OK; ++n)
        status =
            apply_replacement(result, body, &of->link_stiffness.item[n], &sites, stiffness, error);
    fw_sites_clear(&sites);
    return status;
}

/* --- panels --- */

typedef fw_plot_forces forces;

static bool has_links(const fw_plot_result *result, int body)
{
    const fw_scenario *scenario = result->scenario;
    const fw_scenario_body *of = &scenario->bodies[body];
    return fw_material_link_stiffness(&scenario->materials[of->material]) != NULL;
}

/* kappa times the deformation of the link (Eq 31), on both ends. */
static void add_link_forces(forces *f, const fw_plot_view *view, int body)
{
    const fw_plot_result *result = f->result;
    const fw_view_body *shown = &view->bodies[body];
    int first = result->playback->bodies[body].first, at = 0;
    /* The view has the unbroken ones of the result's links, in the same order. */
    for (int n = result->link_first[body]; n < result->link_first[body + 1]; ++n) {
        int a = result->links[2 * n], b = result->links[2 * n + 1];
        if (at == shown->link_count) break;
        if (shown->links[2 * at] != a || shown->links[2 * at + 1] != b) continue;
        at += 1;
        fw_vec2 deformation = {
            shown->x[b] - shown->x[a] - (result->rest_x[first + b] - result->rest_x[first + a]),
            shown->y[b] - shown->y[a] - (result->rest_y[first + b] - result->rest_y[first + a])};
        /* What rounding alone stretches has no force worth an arrow. */
        const double places = fabs(shown->x[a]) + fabs(shown->y[a]) + shown->spacing;
        if (hypot(deformation.x, deformation.y) <= 32 * DBL_EPSILON * places) continue;
        fw_vec2 force = fw_sym2_apply(f->stiffness[n], deformation);
        f->arrows[f->arrow_count++] = (fw_figure_force){a, force, false};
        f->arrows[f->arrow_count++] = (fw_figure_force){b, fw_vec2_scale(-1, force), false};
    }
}

static void add_external_forces(forces *f, int body)
{
    const fw_playback_body *of = &f->result->playback->bodies[body];
    for (int n = 0; n < of->count; ++n) {
        fw_vec2 force = {f->force_x[of->first + n], f->force_y[of->first + n]};
        if (force.x != 0 || force.y != 0)
            f->arrows[f->arrow_count++] = (fw_figure_force){n, force, true};
    }
}

/* Places at rest; of a body that has travelled by more than a spacing, moved along with it, or the
 * picture would show the shift and not the deformation. Returns whether they were. */
static bool place_originals(forces *f, const fw_plot_view *view, int body, double *x, double *y)
{
    const fw_plot_result *result = f->result;
    const fw_view_body *shown = &view->bodies[body];
    int first = result->playback->bodies[body].first;
    fw_vec2 shift = {0, 0};
    for (int n = 0; n < shown->count; ++n) {
        shift.x += (shown->x[n] - result->rest_x[first + n]) / shown->count;
        shift.y += (shown->y[n] - result->rest_y[first + n]) / shown->count;
    }
    bool travelled = hypot(shift.x, shift.y) > shown->spacing;
    if (!travelled) shift = (fw_vec2){0, 0};
    for (int n = 0; n < shown->count; ++n) {
        x[n] = result->rest_x[first + n] + shift.x;
        y[n] = result->rest_y[first + n] + shift.y;
    }
    return travelled;
}

/* "nine, step 2 000: 8 long at rest, 8.8 now"; the lengths of chains only. */
static void name_panel(const forces *f, const fw_plot_view *view, int body, bool travelled,
                       char name[256])
{
    const fw_plot_result *result = f->result;
    const fw_scenario_body *of = &result->scenario->bodies[body];
    const fw_view_body *shown = &view->bodies[body];
    const double *rest_x = result->rest_x + result->playback->bodies[body].first;
    const double *rest_y = result->rest_y + result->playback->bodies[body].first;
    int last = shown->count - 1;
    char rest[32], now[32];
    int length = snprintf(name, sizeof f->names[0], "%s, %s%s", of->name, view->name,
                          travelled ? ", original moved along" : "");
    bool chain = of->shape.first_row == of->shape.last_row ||
                 of->shape.first_column == of->shape.last_column;
    if (!chain || last < 1) return;
    fw_ticks_print_number(rest, sizeof rest,
                          hypot(rest_x[last] - rest_x[0], rest_y[last] - rest_y[0]), 6);
    fw_ticks_print_number(now, sizeof now,
                          hypot(shown->x[last] - shown->x[0], shown->y[last] - shown->y[0]), 6);
    snprintf(name + length, sizeof f->names[0] - (size_t)length, ": %s long at rest, %s now", rest,
             now);
}

static void add_panel(forces *f, const fw_plot_view *view, int body)
{
    const fw_plot_result *result = f->result;
    const fw_view_body *shown = &view->bodies[body];
    int first = result->playback->bodies[body].first;
    fw_figure_force *arrows = f->arrows + f->arrow_count;
    int before = f->arrow_count;
    if (has_links(result, body)) add_link_forces(f, view, body);
    if (result->playback->force) add_external_forces(f, body);
    size_t frame = (size_t)(view - f->views);
    size_t at = frame * (size_t)result->playback->particle_count + (size_t)first;
    bool travelled = place_originals(f, view, body, f->original_x + at, f->original_y + at);
    name_panel(f, view, body, travelled, f->names[f->panel_count]);
    f->panels[f->panel_count] = (fw_figure_forces_panel){
        .name = f->names[f->panel_count],
        .count = shown->count,
        .original_x = f->original_x + at,
        .original_y = f->original_y + at,
        .x = shown->x,
        .y = shown->y,
        .links = shown->links,
        .link_count = shown->link_count,
        .forces = arrows,
        .force_count = f->arrow_count - before,
    };
    f->panel_count += 1;
}

static bool allocate(forces *f, const fw_plot_picture *picture)
{
    const fw_playback *playback = f->result->playback;
    size_t frames = (size_t)picture->frame_count, particles = (size_t)playback->particle_count;
    size_t panels = frames * (size_t)playback->body_count, links = (size_t)playback->link_count;
    f->stiffness = calloc(links + 1, sizeof *f->stiffness);
    f->views = calloc(frames, sizeof *f->views);
    f->force_x = fw_array_of_doubles(particles);
    f->force_y = fw_array_of_doubles(particles);
    f->original_x = fw_array_of_doubles(frames * particles);
    f->original_y = fw_array_of_doubles(frames * particles);
    f->arrows = calloc(frames * (2 * links + particles), sizeof *f->arrows);
    f->panels = calloc(panels, sizeof *f->panels);
    f->names = calloc(panels, sizeof *f->names);
    return f->stiffness && f->views && f->force_x && f->force_y && f->original_x && f->original_y &&
           f->arrows && f->panels && f->names;
}

fw_status fw_plot_forces_find(fw_plot_forces *f, const fw_plot_result *result,
                              const fw_plot_picture *picture, fw_error *error)
{
    *f = (fw_plot_forces){.result = result};
    fw_playback *playback = f->result->playback;
    int panels = picture->frame_count * playback->body_count;
    if (panels > PANELS_MAX)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: %d panels of forces (bodies times steps), expected at most %d",
                       f->result->directory, panels, PANELS_MAX);
    if (!allocate(f, picture)) return fw_fail_memory(error, "a picture of forces");
    for (int b = 0; b < playback->body_count; ++b)
        if (has_links(f->result, b)) FW_TRY(find_stiffness(f->result, b, f->stiffness, error));
    for (int k = 0; k < picture->frame_count; ++k) {
        f->view_count += 1;
        FW_TRY(fw_plot_view_load(&f->views[k], f->result, picture->frames[k], NULL, error));
        if (playback->force)
            FW_TRY(fw_playback_read_forces(playback, picture->frames[k], f->force_x, f->force_y,
                                           error));
        for (int b = 0; b < playback->body_count; ++b) add_panel(f, &f->views[k], b);
    }
    return FW_OK;
}

void fw_plot_forces_clear(fw_plot_forces *f)
{
    for (int k = 0; k < f->view_count; ++k) fw_plot_view_clear(&f->views[k]);
    free(f->stiffness);
    free(f->views);
    free(f->force_x);
    free(f->force_y);
    free(f->original_x);
    free(f->original_y);
    free(f->arrows);
    free(f->panels);
    free(f->names);
    *f = (fw_plot_forces){0};
}

fw_status fw_plot_draw_forces(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error)
{
    forces f;
    fw_page page = picture->page;
    char caption[2048];
    const char *missing = result->playback->force
                              ? ""
                              : "External forces were not recorded (record.force): only those of "
                                "the links are shown.";
    snprintf(caption, sizeof caption, "%s%s%s", page.caption,
             page.caption[0] && missing[0] ? " " : "", missing);
    page.caption = caption;
    fw_status status = fw_plot_forces_find(&f, result, picture, error);
    if (status == FW_OK) {
        const fw_figure_forces_plan plan = {f.panels, f.panel_count};
        status = fw_figure_forces(&page, &plan, error);
    }
    fw_plot_forces_clear(&f);
    return status;
}
