/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_motion.c - frames of a result in few bytes, for a player.
 * Keeps no state. Start reading at fw_report_motion(). */
#include "core/array.h"
#include "plot_extent.h"
#include "report_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GRID = 65535, SHADES = 255, FRAMES_LEAST = 100, ABSENT = SHADES };

/* What is shown: frames 0, every, ... and particles 0, stride, ... of each body. */
typedef struct thinning {
    int64_t every, frames;
    int stride, particles;
} thinning;

typedef struct player {
    fw_json *json;
    const fw_plot_result *result;
    thinning thin;
    fw_view_bounds box;
    int *shown;     /* particles, in the order of the player */
    double *values; /* one number per particle */
    double *x, *y;
} player;

static int shown_of(const fw_playback_body *body, int stride)
{
    return (body->count + stride - 1) / stride;
}

static int count_shown(const fw_playback *playback, int stride)
{
    int count = 0;
    for (int b = 0; b < playback->body_count; ++b) count += shown_of(&playback->bodies[b], stride);
    return count;
}

static thinning thin_out(const fw_playback *playback, size_t budget)
{
    const double each = 4. + playback->field_count + (playback->force ? 8 : 0);
    const double frames = (double)playback->frame_count;
    const double least = fmin(frames, FRAMES_LEAST) * each * playback->particle_count;
    thinning thin = {.stride = (int)fmax(1, ceil(least / (double)budget))};
    thin.particles = count_shown(playback, thin.stride);
    thin.every = (int64_t)fmax(1, ceil(frames * each * thin.particles / (double)budget));
    thin.frames = (playback->frame_count + thin.every - 1) / thin.every;
    return thin;
}

/* Numbers of the particles that are shown, body after body; to be freed, NULL without memory. */
static int *list_shown(const fw_playback *playback, const thinning *thin)
{
    int *shown = fw_array_allocate((size_t)thin->particles, sizeof *shown), n = 0;
    for (int b = 0; shown && b < playback->body_count; ++b)
        for (int i = 0; i < playback->bodies[b].count; i += thin->stride)
            shown[n++] = playback->bodies[b].first + i;
    return shown;
}

/* --- places --- */

static uint16_t on_grid(double value, fw_range range)
{
    const double part = (value - range.low) / (range.high - range.low);
    return (uint16_t)(isfinite(part) ? lround(GRID * fmin(fmax(part, 0), 1)) : 0);
}

static fw_status write_places(player *p, fw_error *error)
{
    const size_t count = (size_t)p->thin.frames * (size_t)p->thin.particles;
    uint16_t *places = fw_array_allocate(2 * count, sizeof *places);
    if (!places) return fw_fail_memory(error, "the places of a report");
    fw_status status = FW_OK;
    size_t n = 0;
    for (int64_t f = 0; f < p->thin.frames && status == FW_OK; ++f) {
        status =
            fw_playback_read_positions(p->result->playback, f * p->thin.every, p->x, p->y, error);
        for (int k = 0; k < p->thin.particles && status == FW_OK; ++k) {
            places[n++] = on_grid(p->x[p->shown[k]], p->box.x);
            places[n++] = on_grid(p->y[p->shown[k]], p->box.y);
        }
    }
    if (status == FW_OK)
        status = fw_report_bytes(p->json, "places", places, 2 * count * sizeof *places, error);
    free(places);
    return status;
}

/* --- colours --- */

static unsigned char shade_of(double value, fw_range range)
{
    const double part = (value - range.low) / (range.high - range.low);
    return isnan(part) ? ABSENT : (unsigned char)lround((SHADES - 1) * fmin(fmax(part, 0), 1));
}

static void write_map(fw_json *json, fw_palette_map map)
{
    fw_json_begin(json, "map", '[');
    for (int n = 0; n < SHADES; ++n) {
        const fw_colour c = fw_palette_at(map, n / (SHADES - 1.));
        char text[8];
        snprintf(text, sizeof text, "#%02x%02x%02x", (unsigned)lround(255 * c.red),
                 (unsigned)lround(255 * c.green), (unsigned)lround(255 * c.blue));
        fw_json_text(json, NULL, text);
    }
    fw_json_end(json, ']');
}

static fw_status write_field(player *p, const fw_playback_field *field, fw_error *error)
{
    fw_plot_picture picture = {.asked.field.text = (char *)field->name};
    fw_colouring colouring;
    fw_plot_name_field(&picture, p->result);
    FW_TRY(fw_plot_colours_find(&colouring, p->result, &picture, error));
    fw_range range = colouring.range;
    if (!(range.low < range.high)) range = (fw_range){0, 1};
    const size_t count = (size_t)p->thin.frames * (size_t)p->thin.particles;
    unsigned char *shades = fw_array_allocate(count, 1);
    if (!shades) return fw_fail_memory(error, "the colours of a report");
    fw_status status = FW_OK;
    size_t n = 0;
    for (int64_t f = 0; f < p->thin.frames && status == FW_OK; ++f) {
        status = fw_playback_read_field(p->result->playback, f * p->thin.every, field->name,
                                        p->values, error);
        for (int k = 0; k < p->thin.particles && status == FW_OK; ++k)
            shades[n++] = shade_of(p->values[p->shown[k]], range);
    }
    if (status == FW_OK) {
        fw_json_begin(p->json, NULL, '{');
        fw_json_text(p->json, "name", picture.field_label);
        fw_json_text(p->json, "label", picture.field_axis);
        fw_json_text(p->json, "meaning", field->meaning);
        fw_json_number(p->json, "low", fw_label_shown(picture.field, range.low));
        fw_json_number(p->json, "high", fw_label_shown(picture.field, range.high));
        write_map(p->json, colouring.map);
        status = fw_report_bytes(p->json, "shades", shades, count, error);
        fw_json_end(p->json, '}');
    }
    free(shades);
    return status;
}

/* --- forces --- */

static fw_status write_forces(player *p, fw_error *error)
{
    if (!p->result->playback->force) return FW_OK;
    const size_t count = (size_t)p->thin.frames * (size_t)p->thin.particles;
    float *forces = fw_array_allocate(2 * count, sizeof *forces);
    if (!forces) return fw_fail_memory(error, "the forces of a report");
    fw_status status = FW_OK;
    size_t n = 0;
    for (int64_t f = 0; f < p->thin.frames && status == FW_OK; ++f) {
        status = fw_playback_read_forces(p->result->playback, f * p->thin.every, p->x, p->y, error);
        for (int k = 0; k < p->thin.particles && status == FW_OK; ++k) {
            forces[n++] = (float)p->x[p->shown[k]];
            forces[n++] = (float)p->y[p->shown[k]];
        }
    }
    if (status == FW_OK)
        status = fw_report_bytes(p->json, "forces", forces, 2 * count * sizeof *forces, error);
    free(forces);
    return status;
}

/* --- links --- */

/* Pairs of particles, and the first frame that is shown in which each is broken. Where particles
 * are left out there are none. */
static fw_status write_links(player *p, fw_error *error)
{
    const fw_playback *playback = p->result->playback;
    enum { LINKS_MAX = 200000 };
    const int count = playback->link_count;
    if (p->thin.stride > 1 || count == 0 || count > LINKS_MAX) return FW_OK;
    int32_t *pairs = fw_array_allocate(3 * (size_t)count, sizeof *pairs);
    if (!pairs) return fw_fail_memory(error, "the links of a report");
    fw_status status = FW_OK;
    for (int64_t f = 0; f < p->thin.frames && status == FW_OK; ++f) {
        fw_plot_view view;
        status = fw_plot_view_load(&view, p->result, f * p->thin.every, NULL, error);
        int n = 0;
        for (int b = 0; b < playback->body_count && status == FW_OK; ++b) {
            const fw_view_body *body = &view.bodies[b];
            const int first = playback->bodies[b].first;
            int kept = 0;
            for (int k = p->result->link_first[b]; k < p->result->link_first[b + 1]; ++k, ++n) {
                const int *link = &p->result->links[2 * k];
                const bool whole = kept < body->link_count && body->links[2 * kept] == link[0] &&
                                   body->links[2 * kept + 1] == link[1];
                kept += whole;
                if (f == 0) {
                    pairs[3 * n] = first + link[0];
                    pairs[3 * n + 1] = first + link[1];
                    pairs[3 * n + 2] = INT32_MAX;
                }
                if (!whole && pairs[3 * n + 2] == INT32_MAX) pairs[3 * n + 2] = (int32_t)f;
            }
        }
        fw_plot_view_clear(&view);
        if (f == 0 && status == FW_OK && n < count)
            memset(pairs + 3 * n, 0, 3 * (size_t)(count - n) * sizeof *pairs);
    }
    if (status == FW_OK)
        status = fw_report_bytes(p->json, "links", pairs, 3 * (size_t)count * sizeof *pairs, error);
    free(pairs);
    return status;
}

/* --- what stands around --- */

static void write_wall(fw_json *json, const fw_outline *wall)
{
    fw_json_begin(json, NULL, '{');
    fw_json_flag(json, "closed", wall->closed);
    fw_json_number(json, "radius", wall->radius);
    fw_json_begin(json, "points", '[');
    for (int n = 0; n < wall->count; ++n) {
        fw_json_number(json, NULL, wall->points[n].x);
        fw_json_number(json, NULL, wall->points[n].y);
    }
    fw_json_end(json, ']');
    fw_json_end(json, '}');
}

/* Outlines as they are at the start, then how far each has gone in every frame. */
static fw_status write_walls(player *p, fw_error *error)
{
    const int walls = p->result->scenario->wall_count;
    if (walls == 0) return FW_OK;
    float *gone = fw_array_allocate((size_t)p->thin.frames * (size_t)walls * 2, sizeof *gone);
    if (!gone) return fw_fail_memory(error, "the walls of a report");
    fw_status status = FW_OK;
    size_t n = 0;
    for (int64_t f = 0; f < p->thin.frames && status == FW_OK; ++f) {
        fw_plot_view view;
        status = fw_plot_view_load(&view, p->result, f * p->thin.every, NULL, error);
        if (status == FW_OK && f == 0) {
            fw_json_begin(p->json, "walls", '[');
            for (int w = 0; w < walls; ++w) write_wall(p->json, &view.walls[w]);
            fw_json_end(p->json, ']');
        }
        for (int w = 0; w < walls && status == FW_OK; ++w) {
            gone[n++] = (float)view.walls[w].displacement.x;
            gone[n++] = (float)view.walls[w].displacement.y;
        }
        fw_plot_view_clear(&view);
    }
    if (status == FW_OK) status = fw_report_bytes(p->json, "gone", gone, n * sizeof *gone, error);
    free(gone);
    return status;
}

static void write_bodies(const player *p)
{
    const fw_playback *playback = p->result->playback;
    fw_json_begin(p->json, "bodies", '[');
    for (int b = 0; b < playback->body_count; ++b) {
        fw_json_begin(p->json, NULL, '{');
        fw_json_text(p->json, "name", playback->bodies[b].name);
        fw_json_integer(p->json, "count", shown_of(&playback->bodies[b], p->thin.stride));
        fw_json_number(p->json, "spacing", p->result->scenario->bodies[b].lattice.spacing);
        fw_json_flag(p->json, "flows", fw_scenario_model(p->result->scenario, b)->flows);
        fw_json_end(p->json, '}');
    }
    fw_json_end(p->json, ']');
}

static void write_times(const player *p)
{
    fw_json_begin(p->json, "steps", '[');
    for (int64_t f = 0; f < p->thin.frames; ++f)
        fw_json_integer(p->json, NULL, p->result->steps[f * p->thin.every]);
    fw_json_end(p->json, ']');
    const fw_physical time = fw_units_physical(&p->result->scenario->units, "time");
    fw_json_begin(p->json, "times", '[');
    for (int64_t f = 0; f < p->thin.frames; ++f)
        fw_json_number(p->json, NULL,
                       fw_physical_value(&time, p->result->times[f * p->thin.every]));
    fw_json_end(p->json, ']');
    fw_json_text(p->json, "timeUnit", time.text);
    const fw_physical length = fw_units_physical(&p->result->scenario->units, "length");
    fw_json_text(p->json, "lengthUnit", length.factor > 0 ? length.text : "length");
    fw_json_number(p->json, "lengthFactor", fw_physical_value(&length, 1));
    fw_json_begin(p->json, "box", '[');
    fw_json_number(p->json, NULL, p->box.x.low);
    fw_json_number(p->json, NULL, p->box.x.high);
    fw_json_number(p->json, NULL, p->box.y.low);
    fw_json_number(p->json, NULL, p->box.y.high);
    fw_json_end(p->json, ']');
    fw_json_integer(p->json, "every", p->thin.every);
    fw_json_integer(p->json, "stride", p->thin.stride);
}

/* All bodies, and of the walls as much as pictures show, where they begin and where they end. */
static fw_status find_box(player *p, fw_error *error)
{
    fw_plot_view *ends = calloc(2, sizeof *ends);
    if (!ends) return fw_fail_memory(error, "a frame");
    fw_status status = fw_plot_bounds_find(&p->box, p->result, error);
    if (status == FW_OK) status = fw_plot_view_load(&ends[0], p->result, 0, NULL, error);
    if (status == FW_OK)
        status = fw_plot_view_load(&ends[1], p->result, p->result->playback->frame_count - 1, NULL,
                                   error);
    if (status == FW_OK)
        fw_view_bounds_include_walls(&p->box, (fw_view[]){ends[0].view, ends[1].view}, 2);
    for (int n = 0; n < 2; ++n) fw_plot_view_clear(&ends[n]);
    free(ends);
    return status;
}

static fw_status write_all(player *p, fw_error *error)
{
    const fw_playback *playback = p->result->playback;
    FW_TRY(find_box(p, error));
    write_times(p);
    write_bodies(p);
    FW_TRY(write_places(p, error));
    FW_TRY(write_links(p, error));
    FW_TRY(write_walls(p, error));
    FW_TRY(write_forces(p, error));
    fw_json_begin(p->json, "fields", '[');
    for (int f = 0; f < playback->field_count; ++f)
        FW_TRY(write_field(p, &playback->fields[f], error));
    fw_json_end(p->json, ']');
    return FW_OK;
}

fw_status fw_report_motion(fw_json *json, const fw_plot_result *result, size_t budget, double *kept,
                           fw_error *error)
{
    const fw_playback *playback = result->playback;
    const size_t count = (size_t)playback->particle_count;
    player p = {.json = json,
                .result = result,
                .thin = thin_out(playback, budget),
                .values = fw_array_of_doubles(count),
                .x = fw_array_of_doubles(count),
                .y = fw_array_of_doubles(count)};
    p.shown = list_shown(playback, &p.thin);
    fw_status status = p.shown && p.values && p.x && p.y ? FW_OK : fw_fail_memory(error, "a frame");
    fw_json_begin(json, "motion", '{');
    if (status == FW_OK) status = write_all(&p, error);
    fw_json_end(json, '}');
    *kept = (double)p.thin.frames * p.thin.particles /
            ((double)playback->frame_count * playback->particle_count);
    free(p.shown);
    free(p.values);
    free(p.x);
    free(p.y);
    return status;
}
