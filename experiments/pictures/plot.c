/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot.c - which pictures of a result are drawn, and of which frames.
 * Keeps no state. Invariant: no step is drawn under another one's name; where a step was not
 * recorded, picture and output say which one stands for it. Start reading at draw_picture(). */
#include "experiments/pictures/plot.h"

#include "experiments/storage/folder.h"
#include "experiments/study/sweep.h"
#include "experiments/text/spelling.h"
#include "plot_parts.h"
#include "plot_sweep.h"

#include "core/array.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

typedef struct kind_row {
    const char *name; /* NULL ends the table */
    int chosen;       /* how many frames where none are named; 0: it shows none */
    fw_status (*draw)(const fw_plot_result *result, const fw_plot_picture *picture,
                      fw_error *error);
} kind_row;

static const kind_row kinds[] = {
    [FW_PLOT_MOTION] = {"motion", 5, fw_plot_draw_motion},
    [FW_PLOT_FORCES] = {"forces", 1, fw_plot_draw_forces},
    [FW_PLOT_FIELD] = {"field", 1, fw_plot_draw_field},
    [FW_PLOT_STRIP] = {"strip", 6, fw_plot_draw_strip},
    [FW_PLOT_SERIES] = {"series", 0, fw_plot_draw_series},
    [FW_PLOT_PROFILE] = {"profile", 1, fw_plot_draw_profile},
    [FW_PLOT_LOOP] = {"loop", 0, fw_plot_draw_loop},
    [FW_PLOT_ANALYSIS] = {"analysis", 0, fw_plot_draw_analysis},
    {NULL, 0, NULL},
};

/* A picture on its way from what is wished for to what is drawn. */
typedef struct draft {
    const fw_plot_result *result;
    const char *name;               /* of the file, without folder and ending */
    const fw_scenario_picture *own; /* the scenario's picture, or NULL */
    int step_count;
    const int64_t *steps;
    bool steps_wished; /* by the user: a step that does not exist is refused */
    fw_plot_picture picture;
    char file[FW_PATH_SIZE];
    char caption[1024];
    /* Steps that were asked for and could not be drawn as such. */
    char replaced[256], missing[256];
    char notes[640]; /* what the output has to say of them */
} draft;

/* --- words --- */

static void append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void append(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

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

/* --- the scenario's pictures, kinds and fields by name --- */

/* A sweep is drawn from all of its cases, in its own folder. */
static bool is_drawn(const fw_scenario_picture *picture)
{
    return picture->kind != FW_PICTURE_SWEEP;
}

static fw_status find_picture(const fw_plot_result *result, const char *name,
                              const fw_scenario_picture **picture, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[512] = "";
    for (int n = 0; n < scenario->picture_count; ++n) {
        *picture = &scenario->pictures[n];
        if (!is_drawn(*picture)) continue;
        if (strcmp((*picture)->name, name) == 0) return FW_OK;
        fw_suggestion_offer(&suggestion, (*picture)->name);
        append(known, sizeof known, "%s%s", known[0] ? ", " : "", (*picture)->name);
    }
    return refuse_name(result->directory, "picture", name, suggestion, known, error);
}

static fw_status find_kind(const char *name, fw_plot_kind *kind, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int k = 0; kinds[k].name; ++k) {
        if (strcmp(kinds[k].name, name) == 0) {
            *kind = (fw_plot_kind)k;
            return FW_OK;
        }
        fw_suggestion_offer(&suggestion, kinds[k].name);
    }
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "no pictures of kind %s; did you mean %s?", name,
                       suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "no pictures of kind %s, expected motion, forces, field, strip, series, "
                   "profile, loop or analysis, or sweep in the folder of one",
                   name);
}

static fw_status find_field(draft *d, const char *name, fw_error *error)
{
    const fw_playback *playback = d->result->playback;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[512] = "";
    for (int n = 0; n < playback->field_count; ++n) {
        if (strcmp(playback->fields[n].name, name) == 0) {
            d->picture.field = playback->fields[n].name;
            return FW_OK;
        }
        fw_suggestion_offer(&suggestion, playback->fields[n].name);
        append(known, sizeof known, "%s%s", n > 0 ? ", " : "", playback->fields[n].name);
    }
    if (suggestion.best)
        return refuse_name(d->result->directory, "field", name, suggestion, known, error);
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
        if (d->picture.frame_count == 0 || d->picture.frames[d->picture.frame_count - 1] != frame)
            d->picture.frames[d->picture.frame_count++] = frame;
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
        if (d->steps_wished) return refuse_step(d, step, error);
        append(d->missing, sizeof d->missing, "%s%lld", d->missing[0] ? ", " : "", (long long)step);
        return FW_OK;
    }
    int64_t frame = fw_plot_nearest_frame(result, step);
    if (result->steps[frame] != step)
        append(d->replaced, sizeof d->replaced, "%s%lld for %lld", d->replaced[0] ? ", " : "",
               (long long)result->steps[frame], (long long)step);
    d->picture.frames[d->picture.frame_count++] = frame;
    return FW_OK;
}

static void note_steps(draft *d)
{
    const fw_plot_result *result = d->result;
    if (d->replaced[0])
        append(d->notes, sizeof d->notes, "Nearest recorded steps: %s.", d->replaced);
    if (d->missing[0])
        append(d->notes, sizeof d->notes, "%sMissing, as the results end at step %lld: %s.",
               d->notes[0] ? " " : "", (long long)result->steps[result->playback->frame_count - 1],
               d->missing);
}

static fw_status take_frames(draft *d, fw_error *error)
{
    fw_plot_picture *picture = &d->picture;
    int chosen = kinds[picture->kind].chosen;
    size_t room = (size_t)(d->step_count > chosen ? d->step_count : chosen);
    picture->frames = fw_array_allocate(room, sizeof *picture->frames);
    if (!picture->frames) return fw_fail_memory(error, "the frames of a picture");
    for (int k = 0; k < d->step_count; ++k) FW_TRY(take_step(d, d->steps[k], error));
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

/* The steps between which a series is drawn. */
static fw_status take_span(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    fw_plot_picture *picture = &d->picture;
    picture->from = d->own ? d->own->from : 0;
    picture->until = d->own ? d->own->until : INT64_MAX;
    picture->logarithmic = wish->logarithmic || (d->own && d->own->logarithmic);
    if (wish->step_count == 0) return FW_OK;
    if (wish->step_count != 2 || wish->steps[0] >= wish->steps[1])
        return fw_fail(error, FW_BAD_INPUT,
                       "a series is drawn from one step to a later one, expected --at FROM,UNTIL");
    if (!holds_step(d, wish->steps[0])) return refuse_step(d, wish->steps[0], error);
    picture->from = wish->steps[0];
    picture->until = wish->steps[1];
    return FW_OK;
}

/* --- from wish to picture --- */

static fw_plot_kind kind_of(const fw_scenario_picture *own)
{
    switch (own->kind) {
    case FW_PICTURE_MOTION:
        return FW_PLOT_MOTION;
    case FW_PICTURE_FORCES:
        return FW_PLOT_FORCES;
    case FW_PICTURE_FIELD:
        return own->instant_count > 1 ? FW_PLOT_STRIP : FW_PLOT_FIELD;
    case FW_PICTURE_PROFILE:
        return FW_PLOT_PROFILE;
    case FW_PICTURE_LOOP:
        return FW_PLOT_LOOP;
    case FW_PICTURE_ANALYSIS:
        return FW_PLOT_ANALYSIS;
    case FW_PICTURE_SERIES:
    case FW_PICTURE_SWEEP: /* not drawn here, see is_drawn() */
        break;
    }
    return FW_PLOT_SERIES;
}

/* The wish's own words come first, then those of the scenario's picture. */
static fw_status decide_kind(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    fw_plot_kind *kind = &d->picture.kind;
    if (wish->picture && wish->kind)
        return fw_fail(error, FW_BAD_INPUT,
                       "both the picture %s and the kind %s, expected one of the two",
                       wish->picture, wish->kind);
    if (wish->picture) FW_TRY(find_picture(d->result, wish->picture, &d->own, error));
    if (wish->kind) {
        FW_TRY(find_kind(wish->kind, kind, error));
    } else if (!wish->picture && wish->observable_count > 0) {
        *kind = FW_PLOT_SERIES;
    } else if (!wish->picture && wish->field) {
        *kind = FW_PLOT_FIELD;
    } else {
        const fw_scenario *scenario = d->result->scenario;
        for (int n = 0; n < scenario->picture_count && !d->own; ++n)
            if (is_drawn(&scenario->pictures[n])) d->own = &scenario->pictures[n];
        *kind = d->own ? kind_of(d->own) : FW_PLOT_MOTION;
    }
    d->name = d->own ? d->own->name : kinds[*kind].name;
    if (*kind == FW_PLOT_FIELD && wish->step_count > 1) *kind = FW_PLOT_STRIP;
    const char *stray = NULL;
    bool coloured = *kind == FW_PLOT_FIELD || *kind == FW_PLOT_STRIP || *kind == FW_PLOT_PROFILE;
    if (wish->field && !coloured) stray = "a field";
    if (wish->observable_count > 0 && *kind != FW_PLOT_SERIES) stray = "observables";
    if (wish->step_count > 0 && *kind == FW_PLOT_ANALYSIS) stray = "steps";
    if (wish->logarithmic && *kind != FW_PLOT_SERIES) stray = "anything on logarithmic axes";
    if (!stray) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "a picture of kind %s does not draw %s", kinds[*kind].name,
                   stray);
}

static fw_status decide_field(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    const fw_playback *playback = d->result->playback;
    const char *name = wish->field ? wish->field : d->own ? d->own->field.text : NULL;
    if (name) return find_field(d, name, error);
    if (playback->field_count > 0)
        d->picture.field = playback->fields[0].name;
    else if (d->picture.kind == FW_PLOT_FIELD || d->picture.kind == FW_PLOT_PROFILE)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: no field was recorded; to have one, name it under record.fields and "
                       "run again",
                       d->result->directory);
    return FW_OK;
}

static fw_status decide_observables(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    static const char *const standard[] = {"energy", "kinetic-energy", "elastic-energy"};
    const fw_scenario_names *own = d->own ? &d->own->observables : NULL;
    int count = wish->observable_count > 0 ? wish->observable_count : own ? own->count : 0;
    const char **names = calloc((size_t)count + 3, sizeof *names);
    d->picture.observables = names;
    if (!names) return fw_fail_memory(error, "the names of observables");
    for (int n = 0; n < count; ++n)
        names[n] = wish->observable_count > 0 ? wish->observables[n] : own->item[n].text;
    for (int n = 0; n < 3 && count == 0; ++n)
        if (fw_playback_find_observable(d->result->playback, standard[n]) >= 0)
            names[d->picture.observable_count++] = standard[n];
    d->picture.observable_count += count;
    if (d->picture.observable_count > 0) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: no energy was measured, expected the names of observables to draw",
                   d->result->directory);
}

/* The picture's own, or the first. */
static fw_status decide_analysis(draft *d, fw_error *error)
{
    const fw_scenario *scenario = d->result->scenario;
    const char *name = d->own ? d->own->analysis.text : NULL;
    for (int n = 0; n < scenario->analysis_count && !d->picture.analysis; ++n)
        if (!name || strcmp(scenario->analyses[n].name, name) == 0)
            d->picture.analysis = &scenario->analyses[n];
    if (d->picture.analysis) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s: the scenario has no analysis to draw",
                   d->result->directory);
}

static fw_status decide_page(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    fw_page *page = &d->picture.page;
    const fw_scenario *scenario = d->result->scenario;
    *page = fw_page_default();
    page->title = d->own && d->own->title ? d->own->title : scenario->title;
    bool of_paper = d->picture.kind == FW_PLOT_MOTION || d->picture.kind == FW_PLOT_FORCES ||
                    d->picture.kind == FW_PLOT_PROFILE;
    if (d->own && of_paper && scenario->figure && scenario->source)
        append(d->caption, sizeof d->caption, "Compare %s.%s", scenario->source,
               d->notes[0] ? " " : "");
    append(d->caption, sizeof d->caption, "%s", d->notes);
    page->caption = d->caption;
    int length =
        wish->file ? snprintf(d->file, sizeof d->file, "%s", wish->file)
                   : snprintf(d->file, sizeof d->file, "%s/%s.png", d->result->directory, d->name);
    if (length >= (int)sizeof d->file)
        return fw_fail(error, FW_BAD_INPUT, "the name of the picture %s is too long", d->name);
    page->file = d->file;
    return FW_OK;
}

static fw_status decide(draft *d, const fw_plot_wish *wish, fw_error *error)
{
    FW_TRY(decide_kind(d, wish, error));
    d->steps_wished = wish->step_count > 0;
    d->step_count = d->steps_wished ? wish->step_count : d->own ? d->own->instant_count : 0;
    d->steps = d->steps_wished ? wish->steps : d->own ? d->own->instants : NULL;
    switch (d->picture.kind) {
    case FW_PLOT_FIELD:
    case FW_PLOT_STRIP:
    case FW_PLOT_PROFILE:
        FW_TRY(decide_field(d, wish, error));
        FW_TRY(take_frames(d, error));
        break;
    case FW_PLOT_MOTION:
    case FW_PLOT_FORCES:
        FW_TRY(take_frames(d, error));
        break;
    case FW_PLOT_SERIES:
        FW_TRY(decide_observables(d, wish, error));
        FW_TRY(take_span(d, wish, error));
        break;
    case FW_PLOT_LOOP:
        break;
    case FW_PLOT_ANALYSIS:
        FW_TRY(decide_analysis(d, error));
        break;
    }
    return decide_page(d, wish, error);
}

static fw_status draw_picture(const fw_plot_result *result, const fw_plot_wish *wish, FILE *out,
                              fw_error *error)
{
    draft *d = calloc(1, sizeof *d);
    if (!d) return fw_fail_memory(error, "a picture");
    d->result = result;
    fw_status status = decide(d, wish, error);
    if (status == FW_OK) status = kinds[d->picture.kind].draw(result, &d->picture, error);
    if (status == FW_OK) fprintf(out, "picture: %s\n", d->file);
    if (status == FW_OK && d->notes[0]) fprintf(out, "  %s\n", d->notes);
    free(d->picture.frames);
    free(d->picture.observables);
    free(d);
    return status;
}

fw_status fw_plot_one(const char *directory, const fw_plot_wish *wish, FILE *out, fw_error *error)
{
    fw_plot_result result;
    if (fw_sweep_is_in(directory)) return fw_plot_sweep_one(directory, wish, out, error);
    fw_status status = fw_plot_result_open(&result, directory, error);
    if (status == FW_OK) status = draw_picture(&result, wish, out, error);
    fw_plot_result_close(&result);
    return status;
}

fw_status fw_plot_all(const char *directory, FILE *out, fw_error *error)
{
    fw_plot_result result;
    if (fw_sweep_is_in(directory)) return fw_plot_sweep_all(directory, out, error);
    fw_status status = fw_plot_result_open(&result, directory, error);
    const int count = status == FW_OK ? result.scenario->picture_count : 0;
    bool drawn = status != FW_OK;
    for (int n = 0; n < count; ++n) {
        fw_error own = {0};
        const fw_plot_wish wish = {.picture = result.scenario->pictures[n].name};
        if (!is_drawn(&result.scenario->pictures[n])) continue;
        const fw_status done = draw_picture(&result, &wish, out, &own);
        drawn = true;
        if (status == FW_OK && done != FW_OK) *error = own;
        if (status == FW_OK) status = done;
    }
    if (!drawn) status = draw_picture(&result, &(fw_plot_wish){0}, out, error);
    fw_plot_result_close(&result);
    return status;
}
