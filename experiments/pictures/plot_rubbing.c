/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_rubbing.c - where a contact sticks, slides and heats, over time: maps of the particles of a
 * body that rub, a row for each, and the time between frames, a column each. Keeps no state. Start
 * reading at draw(). */
#include "plot_parts.h"

#include "contact/scene/scene.h"
#include "core/array.h"
#include "experiments/drawing/ticks.h"
#include "experiments/text/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TICKS_MAX = 9 };

typedef fw_plot_rubbing rubbing;

static fw_status read(const rubbing *r, int64_t frame, const char *field, double *values,
                      fw_error *error)
{
    return fw_playback_read_field(r->result->playback, frame, field, values, error);
}

static bool has_field(const fw_playback *playback, const char *name)
{
    for (int n = 0; n < playback->field_count; ++n)
        if (strcmp(playback->fields[n].name, name) == 0) return true;
    return false;
}

static fw_status check_fields(const fw_plot_result *result, const char *field, fw_error *error)
{
    if (has_field(result->playback, field) && has_field(result->playback, FW_FIELD_RUBBING))
        return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: friction was not recorded particle by particle; a picture of kind 'slip' "
                   "or 'heat' in the scenario lets it be, or record.fields: [%s, %s]",
                   result->directory, field, FW_FIELD_RUBBING);
}

/* The frames of the span; two of them, at least. */
static fw_status choose_span(rubbing *r, fw_error *error)
{
    const fw_scenario_picture *asked = &r->picture->asked;
    const int64_t count = r->result->playback->frame_count, last = r->result->steps[count - 1];
    r->from = 0;
    r->until = count - 1;
    while (r->from < r->until && r->result->steps[r->from] < asked->from) r->from += 1;
    while (r->until > r->from && r->result->steps[r->until] > asked->until) r->until -= 1;
    /* The last frame of a run may come early. */
    const int64_t every =
        r->result->steps[r->from + (r->until > r->from)] - r->result->steps[r->from];
    if (r->until > r->from + 1 &&
        r->result->steps[r->until] - r->result->steps[r->until - 1] != every)
        r->until -= 1;
    if (r->until > r->from) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: friction is drawn between frames, expected at least two of them from step "
                   "%lld to %lld",
                   r->result->directory, (long long)asked->from,
                   (long long)(asked->until < last ? asked->until : last));
}

static bool rubs_in_span(const rubbing *r, int particle)
{
    return r->now[particle] - r->before[particle] > 0;
}

/* The named body, or the first of which a particle rubs in the span. */
static fw_status choose_body(rubbing *r, fw_error *error)
{
    const fw_playback *playback = r->result->playback;
    const char *name = r->picture->asked.body.text;
    bool found = !name;
    FW_TRY(read(r, r->from, FW_FIELD_RUBBING, r->before, error));
    FW_TRY(read(r, r->until, FW_FIELD_RUBBING, r->now, error));
    for (int b = 0; b < playback->body_count; ++b) {
        if (name && strcmp(playback->bodies[b].name, name) != 0) continue;
        found = true;
        r->body = b;
        r->first = playback->bodies[b].first;
        r->count = playback->bodies[b].count;
        r->row_count = 0;
        for (int i = r->first; i < r->first + r->count; ++i) r->row_count += rubs_in_span(r, i);
        if (r->row_count > 0) return FW_OK;
    }
    if (!found)
        return fw_fail(error, FW_BAD_INPUT, "%s: there is no body %s", r->result->directory, name);
    return fw_fail(error, FW_BAD_INPUT, "%s: nothing rubs %s%s from step %lld to %lld",
                   r->result->directory, name ? "body " : "any body", name ? name : "",
                   (long long)r->result->steps[r->from], (long long)r->result->steps[r->until]);
}

static double place_of(const rubbing *r, int particle)
{
    return r->along_y ? r->result->rest_y[particle] : r->result->rest_x[particle];
}

/* Rows in the order of places at rest; few, and nearly in order. */
static fw_status make_rows(rubbing *r, fw_error *error)
{
    fw_range x = {INFINITY, -INFINITY}, y = x;
    r->particles = fw_array_allocate((size_t)r->row_count, sizeof *r->particles);
    r->places = fw_array_of_doubles((size_t)r->row_count);
    if (!r->particles || !r->places) return fw_fail_memory(error, "a map of friction");
    for (int i = r->first; i < r->first + r->count; ++i) {
        if (!rubs_in_span(r, i)) continue;
        x = (fw_range){fmin(x.low, r->result->rest_x[i]), fmax(x.high, r->result->rest_x[i])};
        y = (fw_range){fmin(y.low, r->result->rest_y[i]), fmax(y.high, r->result->rest_y[i])};
    }
    r->along_y = y.high - y.low > x.high - x.low;
    int rows = 0;
    for (int i = r->first; i < r->first + r->count; ++i) {
        if (!rubs_in_span(r, i)) continue;
        int at = rows++;
        for (; at > 0 && place_of(r, r->particles[at - 1]) > place_of(r, i); --at)
            r->particles[at] = r->particles[at - 1];
        r->particles[at] = i;
    }
    for (int row = 0; row < rows; ++row) r->places[row] = place_of(r, r->particles[row]);
    return FW_OK;
}

/* What a field grew by between two frames: over the steps of rubbing there, or over the time. Where
 * a particle did not rub there is no number. */
static fw_status fill(rubbing *r, const char *field, bool over_steps, fw_error *error)
{
    const int64_t columns = r->until - r->from;
    const size_t all = (size_t)r->result->playback->particle_count;
    FW_TRY(read(r, r->from, field, r->before, error));
    FW_TRY(read(r, r->from, FW_FIELD_RUBBING, r->steps_before, error));
    for (int64_t k = 0; k < columns; ++k) {
        const int64_t frame = r->from + k + 1;
        const double time = r->result->times[frame] - r->result->times[frame - 1];
        FW_TRY(read(r, frame, field, r->now, error));
        FW_TRY(read(r, frame, FW_FIELD_RUBBING, r->steps_now, error));
        for (int row = 0; row < r->row_count; ++row) {
            const int i = r->particles[row];
            const double steps = r->steps_now[i] - r->steps_before[i];
            const double grown = r->now[i] - r->before[i];
            const double part = over_steps ? fmin(grown / steps, 1) : grown / time;
            r->values[row * columns + k] = steps > 0 ? part : NAN;
        }
        memcpy(r->before, r->now, all * sizeof *r->now);
        memcpy(r->steps_before, r->steps_now, all * sizeof *r->steps_now);
    }
    return FW_OK;
}

static bool is_even(const rubbing *r)
{
    const double step = r->row_count > 1 ? r->places[1] - r->places[0] : 1;
    for (int n = 1; n < r->row_count; ++n)
        if (!(step > 0) || fabs(r->places[n] - r->places[n - 1] - step) > 1e-6 * step) return false;
    return true;
}

static fw_status draw_map(const rubbing *r, const fw_colouring *colouring, fw_page *page,
                          fw_error *error)
{
    char label[FW_NAME_SIZE + 32], texts[TICKS_MAX][FW_TICK_LABEL_SIZE];
    fw_axis_name names[TICKS_MAX];
    const fw_plot_result *result = r->result;
    const double time = result->times[r->from + 1] - result->times[r->from];
    const double steps = (double)(result->steps[r->from + 1] - result->steps[r->from]);
    const fw_units *units = &result->scenario->units;
    char where[FW_NAME_SIZE + 32], when[32];
    snprintf(where, sizeof where, "%s at rest, along %s", r->along_y ? "y" : "x",
             result->playback->bodies[r->body].name);
    fw_figure_map_plan plan = {
        .columns = (int)(r->until - r->from),
        .rows = r->row_count,
        .values = r->values,
        .p_first = result->times[r->from] + time / 2,
        .p_step = time,
        .q_first = r->places[0],
        .q_step = r->row_count > 1 ? r->places[1] - r->places[0] : 1,
        .p_label = fw_plot_time_label(when, sizeof when, time == steps, units),
        .q_label = fw_units_given(units)
                       ? fw_plot_label(label, sizeof label, where, "length", units)
                       : (fw_label){where, 0},
        .colouring = *colouring};
    if (!is_even(r)) {
        const int every = (r->row_count + TICKS_MAX - 1) / TICKS_MAX;
        plan.q_first = 0;
        plan.q_step = 1;
        plan.q_names = names;
        for (int n = 0; n < r->row_count; n += every) {
            char *text = texts[plan.q_name_count];
            fw_ticks_print_number(text, FW_TICK_LABEL_SIZE,
                                  fw_label_shown(plan.q_label, r->places[n]), 4);
            names[plan.q_name_count++] = (fw_axis_name){n, text};
        }
    }
    return fw_figure_map(page, &plan, error);
}

static bool allocate(rubbing *r)
{
    const size_t all = (size_t)r->result->playback->particle_count;
    r->before = fw_array_of_doubles(all);
    r->now = fw_array_of_doubles(all);
    r->steps_before = fw_array_of_doubles(all);
    r->steps_now = fw_array_of_doubles(all);
    return r->before && r->now && r->steps_before && r->steps_now;
}

fw_status fw_plot_rubbing_find(fw_plot_rubbing *r, const fw_plot_result *result,
                               const fw_plot_picture *picture, const char *field, bool over_steps,
                               fw_error *error)
{
    *r = (fw_plot_rubbing){.result = result, .picture = picture};
    FW_TRY(check_fields(r->result, field, error));
    if (!allocate(r)) return fw_fail_memory(error, "a map of friction");
    FW_TRY(choose_span(r, error));
    FW_TRY(choose_body(r, error));
    FW_TRY(make_rows(r, error));
    r->values = fw_array_of_doubles((size_t)r->row_count * (size_t)(r->until - r->from));
    if (!r->values) return fw_fail_memory(error, "a map of friction");
    return fill(r, field, over_steps, error);
}

void fw_plot_rubbing_clear(fw_plot_rubbing *r)
{
    free(r->particles);
    free(r->places);
    free(r->before);
    free(r->now);
    free(r->steps_before);
    free(r->steps_now);
    free(r->values);
}

static fw_status draw(const fw_plot_result *result, const fw_plot_picture *picture,
                      const char *field, bool over_steps, fw_colouring colouring,
                      const char *meaning, fw_error *error)
{
    rubbing r;
    fw_page page = picture->page;
    char caption[2048] = "";
    fw_text_append(caption, sizeof caption, "%s Grey: no contact. %s", meaning, page.caption);
    page.caption = caption;
    if (picture->asked.range[0] < picture->asked.range[1])
        colouring.range = (fw_range){picture->asked.range[0], picture->asked.range[1]};
    fw_status status = fw_plot_rubbing_find(&r, result, picture, field, over_steps, error);
    if (status == FW_OK) status = draw_map(&r, &colouring, &page, error);
    fw_plot_rubbing_clear(&r);
    return status;
}

fw_status fw_plot_draw_slip(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error)
{
    const fw_colouring colouring = {
        .label = {"part of the steps in which it slid", 0}, .map = picture->map, .range = {0, 1}};
    return draw(result, picture, FW_FIELD_SLIDING, true, colouring,
                "Between two frames: 0 sticks, 1 slides all the time. A place between two bodies "
                "sticks as long as anything there holds it.",
                error);
}

fw_status fw_plot_draw_heat(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error)
{
    /* What swings while it sticks takes a little back in places: that is no second kind of heat. */
    char label[64];
    const fw_colouring colouring = {.label = fw_plot_label(label, sizeof label, "heat of friction",
                                                           "energy/time", &result->scenario->units),
                                    .map = picture->map ? picture->map : FW_PALETTE_SEQUENTIAL};
    return draw(result, picture, FW_FIELD_HEAT, false, colouring,
                "Heat of friction at each particle, between two frames; between two bodies half of "
                "it comes to either.",
                error);
}
