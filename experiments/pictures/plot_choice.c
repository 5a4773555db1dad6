/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_choice.c - from what is wished for to a picture with every choice made.
 * Keeps no state. Invariant: no step is drawn under another one's name; where a step was not
 * recorded, picture and output say which one stands for it. Start reading at fw_plot_choose(). */
#include "plot_choice.h"

#include "experiments/setup/solids.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include "contact/scene/scene.h"
#include "core/array.h"

#include <stdlib.h>
#include <string.h>

/* A choice on its way. */
typedef struct draft {
    const fw_plot_result *result;
    const fw_plot_wish *wish;
    const fw_scenario_picture *own; /* the scenario's picture, or NULL */
    fw_plot_choice *choice;
    fw_plot_picture *picture; /* of the choice */
    /* Wanted steps that could not be drawn as such. */
    char replaced[256], missing[256];
} draft;

/* --- words --- */

static fw_status refuse_name(const char *directory, const char *what, const char *name,
                             fw_suggestion suggestion, const char *known, fw_error *error)
{
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "%s has no %s %s; did you mean %s?", directory, what,
                       name, suggestion.best);
    if (known[0] == '\0')
        return fw_fail(error, FW_BAD_INPUT, "%s has no %s %s, and no other one", directory, what,
                       name);
    return fw_fail(error, FW_BAD_INPUT, "%s has no %s %s, expected one of %s", directory, what,
                   name, known);
}

/* --- pictures, kinds and fields by name --- */

static unsigned needs(fw_picture_kind kind)
{
    return fw_picture_rows[kind].needs;
}

/* A sweep is drawn from all of its cases, in its own folder. */
bool fw_plot_is_of_case(const fw_scenario_picture *picture)
{
    return !(needs(picture->kind) & FW_PICTURE_NEEDS_SWEEP);
}

static fw_status find_picture(draft *d, const char *name, fw_error *error)
{
    const fw_scenario *scenario = d->result->scenario;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[512] = "";
    for (int n = 0; n < scenario->picture_count; ++n) {
        d->own = &scenario->pictures[n];
        if (!fw_plot_is_of_case(d->own)) continue;
        if (strcmp(d->own->name, name) == 0) return FW_OK;
        fw_suggestion_offer(&suggestion, d->own->name);
        fw_text_append(known, sizeof known, "%s%s", known[0] ? ", " : "", d->own->name);
    }
    return refuse_name(d->result->directory, "picture", name, suggestion, known, error);
}

static fw_status find_kind(const char *name, fw_picture_kind *kind, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[512] = "", of_sweeps[64] = "";
    for (int k = 0; k < FW_PICTURE_KINDS; ++k) {
        const char *word = fw_picture_rows[k].name;
        const bool of_case = !(needs((fw_picture_kind)k) & FW_PICTURE_NEEDS_SWEEP);
        if (of_case && strcmp(word, name) == 0) {
            *kind = (fw_picture_kind)k;
            return FW_OK;
        }
        if (of_case) fw_suggestion_offer(&suggestion, word);
        fw_text_append(of_case ? known : of_sweeps, of_case ? sizeof known : sizeof of_sweeps,
                       "%s%s", (of_case ? known : of_sweeps)[0] ? ", " : "", word);
    }
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "no pictures of kind %s; did you mean %s?", name,
                       suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "no pictures of kind %s, expected one of %s, or %s in the folder of a sweep",
                   name, known, of_sweeps);
}

/* The name of the bodies' solids that is nearest; NULL: none is near. */
static const char *nearest_field(const fw_scenario *scenario, const char *name)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_field *field = fw_solid_kind_of(scenario, b)->model->fields;
        for (; field->name; ++field) fw_suggestion_offer(&suggestion, field->name);
    }
    return suggestion.best;
}

static fw_status find_field(draft *d, const char *name, fw_error *error)
{
    const fw_playback *playback = d->result->playback;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[512] = "";
    for (int n = 0; n < playback->field_count; ++n) {
        if (strcmp(playback->fields[n].name, name) == 0) {
            d->picture->asked.field.text = playback->fields[n].name;
            return FW_OK;
        }
        fw_suggestion_offer(&suggestion, playback->fields[n].name);
        fw_text_append(known, sizeof known, "%s%s", n > 0 ? ", " : "", playback->fields[n].name);
    }
    if (suggestion.best)
        return refuse_name(d->result->directory, "field", name, suggestion, known, error);
    const char *nearest = nearest_field(d->result->scenario, name);
    if (nearest && strcmp(nearest, name) != 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: there is no field %s; did you mean %s? It was not recorded, name it "
                       "under record.fields and run again",
                       d->result->directory, name, nearest);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: the field %s was not recorded (%s%s); to have it, name it under "
                   "record.fields and run again",
                   d->result->directory, name, known[0] ? "there is " : "no field was", known);
}

/* --- steps --- */

/* Evenly over the frames, first and last among them; a single one is the last. */
static void choose_frames(draft *d, int wanted)
{
    int64_t last = d->result->playback->frame_count - 1;
    for (int k = 0; k < wanted; ++k) {
        int64_t frame = wanted > 1 ? (2 * k * last + wanted - 1) / (2 * (wanted - 1)) : last;
        if (d->picture->frame_count == 0 ||
            d->picture->frames[d->picture->frame_count - 1] != frame)
            d->picture->frames[d->picture->frame_count++] = frame;
    }
}

static int by_number(const void *one, const void *other)
{
    int64_t a = *(const int64_t *)one, b = *(const int64_t *)other;
    return (a > b) - (a < b);
}

/* A step before the first one or after the last one that is there. */
static fw_status refuse_step(const draft *d, int64_t step, fw_error *error)
{
    const fw_plot_result *result = d->result;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: step %lld, but the results hold the steps %lld to %lld", result->directory,
                   (long long)step, (long long)result->steps[0],
                   (long long)result->steps[result->playback->frame_count - 1]);
}

static bool holds_step(const draft *d, int64_t step)
{
    const fw_plot_result *result = d->result;
    return step >= result->steps[0] && step <= result->steps[result->playback->frame_count - 1];
}

static fw_status take_step(draft *d, int64_t step, fw_error *error)
{
    const fw_plot_result *result = d->result;
    if (!holds_step(d, step)) {
        if (d->wish->step_count > 0) return refuse_step(d, step, error);
        fw_text_append(d->missing, sizeof d->missing, "%s%lld", d->missing[0] ? ", " : "",
                       (long long)step);
        return FW_OK;
    }
    int64_t frame = fw_plot_nearest_frame(result, step);
    if (result->steps[frame] != step)
        fw_text_append(d->replaced, sizeof d->replaced, "%s%lld for %lld",
                       d->replaced[0] ? ", " : "", (long long)result->steps[frame],
                       (long long)step);
    d->picture->frames[d->picture->frame_count++] = frame;
    return FW_OK;
}

static void note_steps(draft *d)
{
    const fw_plot_result *result = d->result;
    if (d->replaced[0])
        fw_text_append(d->choice->notes, sizeof d->choice->notes, "Nearest recorded steps: %s.",
                       d->replaced);
    if (d->missing[0])
        fw_text_append(d->choice->notes, sizeof d->choice->notes,
                       "%sMissing, as the results end at step %lld: %s.",
                       d->choice->notes[0] ? " " : "",
                       (long long)result->steps[result->playback->frame_count - 1], d->missing);
}

static fw_status take_frames(draft *d, fw_error *error)
{
    fw_plot_picture *picture = d->picture;
    const fw_scenario_picture *asked = &picture->asked;
    const int chosen = fw_picture_rows[asked->kind].frames;
    size_t room = (size_t)(asked->instant_count > chosen ? asked->instant_count : chosen);
    picture->frames = fw_array_allocate(room, sizeof *picture->frames);
    if (!picture->frames) return fw_fail_memory(error, "the frames of a picture");
    for (int k = 0; k < asked->instant_count; ++k) FW_TRY(take_step(d, asked->instants[k], error));
    if (picture->frame_count == 0) choose_frames(d, chosen);
    qsort(picture->frames, (size_t)picture->frame_count, sizeof *picture->frames, by_number);
    int kept = 0;
    for (int k = 0; k < picture->frame_count; ++k)
        if (kept == 0 || picture->frames[kept - 1] != picture->frames[k])
            picture->frames[kept++] = picture->frames[k];
    picture->frame_count = kept;
    note_steps(d);
    return FW_OK;
}

/* The steps between which something is drawn over time. */
static fw_status take_span(draft *d, fw_error *error)
{
    const fw_plot_wish *wish = d->wish;
    fw_scenario_picture *asked = &d->picture->asked;
    const bool listed = wish->step_count > 0;
    if (listed && (wish->step_count != 2 || wish->from > 0 || wish->until > 0))
        return fw_fail(error, FW_BAD_INPUT,
                       "a series is drawn from one step to a later one, expected --at FROM,UNTIL, "
                       "or --from and --until");
    if (!listed && wish->from == 0 && wish->until == 0) return FW_OK;
    if (listed || wish->from > 0) asked->from = listed ? wish->steps[0] : wish->from;
    if (listed || wish->until > 0) asked->until = listed ? wish->steps[1] : wish->until;
    if (asked->from >= asked->until)
        return fw_fail(error, FW_BAD_INPUT,
                       "from step %lld until step %lld, expected a later one: --at FROM,UNTIL, or "
                       "--from and --until",
                       (long long)asked->from, (long long)asked->until);
    return holds_step(d, asked->from) ? FW_OK : refuse_step(d, asked->from, error);
}

/* --- from wish to picture --- */

static fw_status choose_kind(draft *d, fw_error *error)
{
    const fw_plot_wish *wish = d->wish;
    fw_scenario_picture *asked = &d->picture->asked;
    fw_picture_kind kind = FW_PICTURE_MOTION;
    bool named = true;
    if (wish->picture && wish->kind)
        return fw_fail(error, FW_BAD_INPUT,
                       "both the picture %s and the kind %s, expected one of the two",
                       wish->picture, wish->kind);
    if (wish->picture) FW_TRY(find_picture(d, wish->picture, error));
    if (wish->kind)
        FW_TRY(find_kind(wish->kind, &kind, error));
    else if (!wish->picture && wish->observable_count > 0)
        kind = FW_PICTURE_SERIES;
    else if (!wish->picture && wish->field)
        kind = FW_PICTURE_FIELD;
    else
        named = false;
    const fw_scenario *scenario = d->result->scenario;
    for (int n = 0; n < scenario->picture_count && !named && !d->own; ++n)
        if (fw_plot_is_of_case(&scenario->pictures[n])) d->own = &scenario->pictures[n];
    *asked = d->own ? *d->own : (fw_scenario_picture){.kind = kind, .until = INT64_MAX};
    d->choice->name = d->own ? d->own->name : fw_picture_rows[kind].name;
    d->picture->fixed_axes = wish->step_count > 0 || asked->instant_count == 0;
    if (wish->step_count > 0) {
        asked->instant_count = wish->step_count;
        asked->instants = (int64_t *)wish->steps;
    }
    if (asked->kind == FW_PICTURE_FIELD && asked->instant_count > 1) asked->kind = FW_PICTURE_STRIP;
    if (wish->range[0] < wish->range[1]) memcpy(asked->range, wish->range, sizeof asked->range);
    asked->logarithmic |= wish->logarithmic;
    if (wish->body) asked->body.text = wish->body;
    return fw_plot_check_wish(d->wish, d->picture->asked.kind, error);
}

/* Recorded for pictures of friction: shown as a field only where it is named. */
static bool is_of_contact(const char *name)
{
    for (const fw_contact_field *field = fw_contact_fields; field->name; ++field)
        if (strcmp(field->name, name) == 0) return true;
    return false;
}

const char *fw_plot_usual_field(const fw_plot_result *result)
{
    const fw_playback *playback = result->playback;
    for (int n = 0; n < playback->field_count; ++n)
        if (!is_of_contact(playback->fields[n].name)) return playback->fields[n].name;
    return NULL;
}

static fw_status choose_field(draft *d, fw_error *error)
{
    fw_scenario_picture *asked = &d->picture->asked;
    const char *name = d->wish->field ? d->wish->field : asked->field.text;
    if (name) return find_field(d, name, error);
    asked->field.text = fw_plot_usual_field(d->result);
    if (!asked->field.text && asked->kind != FW_PICTURE_STRIP)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: no field was recorded; to have one, name it under record.fields and "
                       "run again",
                       d->result->directory);
    return FW_OK;
}

/* The wish's, or the picture's own, or the energies. */
static fw_status choose_observables(draft *d, fw_error *error)
{
    static const char *const energies[] = {"energy", "kinetic-energy", "elastic-energy"};
    const fw_plot_wish *wish = d->wish;
    fw_plot_picture *picture = d->picture;
    const fw_schema_names *own = &picture->asked.observables;
    const int count = wish->observable_count > 0 ? wish->observable_count : own->count;
    picture->observables = calloc((size_t)count + 3, sizeof *picture->observables);
    if (!picture->observables) return fw_fail_memory(error, "the names of observables");
    for (int n = 0; n < count; ++n)
        picture->observables[n] =
            wish->observable_count > 0 ? wish->observables[n] : own->item[n].text;
    picture->observable_count = count;
    for (int n = 0; n < 3 && count == 0; ++n)
        if (fw_playback_find_observable(d->result->playback, energies[n]) >= 0)
            picture->observables[picture->observable_count++] = energies[n];
    if (picture->observable_count > 0) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: no energy was measured, expected the names of observables to draw",
                   d->result->directory);
}

/* The picture's own, or the first. */
static fw_status choose_analysis(draft *d, fw_error *error)
{
    const fw_scenario *scenario = d->result->scenario;
    const char *name = d->picture->asked.analysis.text;
    for (int n = 0; n < scenario->analysis_count && !d->picture->analysis; ++n)
        if (!name || strcmp(scenario->analyses[n].name, name) == 0)
            d->picture->analysis = &scenario->analyses[n];
    if (d->picture->analysis) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s: the scenario has no analysis to draw",
                   d->result->directory);
}

fw_page fw_plot_page(const fw_plot_wish *wish)
{
    fw_page page = fw_page_default();
    if (wish->width > 0) page.width = wish->width;
    if (wish->resolution > 0) page.resolution = wish->resolution;
    if (wish->font_size > 0) page.enlarged = wish->font_size / FW_TEXT_SIZE;
    page.width /= page.enlarged;
    page.chart_height = wish->height / page.enlarged;
    page.x_range = (fw_range){wish->x_range[0], wish->x_range[1]};
    page.y_range = (fw_range){wish->y_range[0], wish->y_range[1]};
    page.bare = wish->bare;
    page.letter = wish->letter;
    return page;
}

static fw_status choose_page(draft *d, fw_error *error)
{
    fw_plot_choice *choice = d->choice;
    fw_page *page = &d->picture->page;
    const fw_scenario *scenario = d->result->scenario;
    const fw_picture_kind kind = d->picture->asked.kind;
    const bool of_paper = kind == FW_PICTURE_MOTION || kind == FW_PICTURE_FORCES ||
                          needs(kind) & FW_PICTURE_NEEDS_PROFILE;
    *page = fw_plot_page(d->wish);
    fw_plot_name_places(&choice->names, page, &scenario->units);
    page->title = d->own && d->own->title ? d->own->title : scenario->title;
    if (d->own && of_paper && scenario->figure && scenario->source)
        fw_text_append(choice->caption, sizeof choice->caption, "Compare %s.%s", scenario->source,
                       choice->notes[0] ? " " : "");
    fw_text_append(choice->caption, sizeof choice->caption, "%s%s%s", choice->notes,
                   choice->caption[0] || choice->notes[0] ? " " : "", d->result->units);
    page->caption = choice->caption;
    page->file = d->wish->file ? d->wish->file : choice->file;
    if (d->wish->file) return FW_OK;
    char name[FW_NAME_BYTES + 8];
    snprintf(name, sizeof name, "%s.png", choice->name);
    snprintf(choice->data, sizeof choice->data, "%s-data.csv", choice->name);
    d->picture->data = choice->data;
    return fw_path_join(choice->file, d->result->directory, name, error);
}

void fw_plot_name_field(fw_plot_picture *picture, const fw_plot_result *result)
{
    const fw_playback *playback = result->playback;
    const char *name = picture->asked.field.text ? picture->asked.field.text : "", *unit = NULL;
    for (int n = 0; n < playback->field_count; ++n)
        if (strcmp(playback->fields[n].name, name) == 0) unit = playback->fields[n].unit;
    fw_label_print(picture->field_label, sizeof picture->field_label, name, NULL);
    picture->field = fw_plot_label(picture->field_axis, sizeof picture->field_axis, name, unit,
                                   &result->scenario->units);
}

fw_status fw_plot_choose(fw_plot_choice *choice, const fw_plot_result *result,
                         const fw_plot_wish *wish, fw_error *error)
{
    *choice = (fw_plot_choice){.name = ""};
    draft *d =
        &(draft){.result = result, .wish = wish, .choice = choice, .picture = &choice->picture};
    FW_TRY(choose_kind(d, error));
    const fw_picture_kind kind = d->picture->asked.kind;
    if (fw_picture_reads(kind, "field")) FW_TRY(choose_field(d, error));
    fw_plot_name_field(d->picture, result);
    if (fw_picture_rows[kind].frames > 0) FW_TRY(take_frames(d, error));
    if (fw_picture_reads(kind, "observables")) FW_TRY(choose_observables(d, error));
    if (fw_picture_reads(kind, "from")) FW_TRY(take_span(d, error));
    d->picture->map = wish->palette ? fw_palette_find(wish->palette) : FW_PALETTE_AUTO;
    d->picture->in_steps = wish->in_steps;
    d->picture->along = wish->along;
    d->picture->with = wish->with;
    d->picture->with_count = wish->with_count;
    if (needs(kind) & FW_PICTURE_NEEDS_ANALYSIS) FW_TRY(choose_analysis(d, error));
    return choose_page(d, error);
}

void fw_plot_choice_clear(fw_plot_choice *choice)
{
    free(choice->picture.frames);
    free(choice->picture.observables);
    choice->picture.frames = NULL;
    choice->picture.observables = NULL;
}
