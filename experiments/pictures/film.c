/* SPDX-License-Identifier: GPL-3.0-or-later */
/* film.c - a picture of every frame, drawn like any other, into one film.
 * Keeps no state. Invariant: axes, colours, title and size are those of the first picture. Start
 * reading at fw_film_make(). */
#include "experiments/pictures/film.h"

#include "experiments/drawing/encoder.h"
#include "experiments/storage/scratch_folder.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/sweep.h"
#include "plot_choice.h"
#include "plot_extent.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* As many dots as a screen has room for. */
#define RESOLUTION 150

enum { FRAMES_DEFAULT = 500, RATE_DEFAULT = 25 };

typedef struct film {
    fw_plot_result result;
    fw_view_bounds bounds;
    fw_plot_wish wish; /* of the picture that is drawn next */
    fw_encoder *encoder;
    char folder[FW_PATH_SIZE]; /* where pictures lie until they are in the film */
    char picture[FW_PATH_SIZE + 16];
    int64_t every, count;
} film;

/* Of all frames alike; the first picture says which field. */
static fw_status fix_colours(film *f, const fw_plot_picture *picture, fw_error *error)
{
    fw_colouring colouring;
    if (f->wish.range[0] < f->wish.range[1]) return FW_OK;
    FW_TRY(fw_plot_colours_find(&colouring, &f->result, picture, error));
    f->wish.range[0] = colouring.range.low;
    f->wish.range[1] = colouring.range.high;
    return FW_OK;
}

static fw_status draw(film *f, int64_t frame, fw_plot_choice *choice, fw_error *error)
{
    f->wish.steps = &f->result.steps[frame];
    FW_TRY(fw_plot_choose(choice, &f->result, &f->wish, error));
    fw_plot_picture *picture = &choice->picture;
    picture->page.resolution = RESOLUTION;
    if (picture->asked.kind == FW_PICTURE_FIELD) {
        if (picture->asked.field.text) FW_TRY(fix_colours(f, picture, error));
        memcpy(picture->asked.range, f->wish.range, sizeof picture->asked.range);
        return fw_plot_draw_field(&f->result, picture, error);
    }
    if (picture->asked.kind == FW_PICTURE_MOTION)
        return fw_plot_draw_motion(&f->result, picture, error);
    return fw_fail(error, FW_BAD_INPUT,
                   "a picture of kind %s as a film, expected one of kind motion or field",
                   fw_picture_rows[picture->asked.kind].name);
}

static fw_status add_frame(film *f, int64_t frame, fw_error *error)
{
    fw_plot_choice *choice = calloc(1, sizeof *choice);
    if (!choice) return fw_fail_memory(error, "a picture");
    fw_status status = draw(f, frame, choice, error);
    fw_plot_choice_clear(choice);
    free(choice);
    return status == FW_OK ? fw_encoder_add(f->encoder, f->picture, error) : status;
}

static fw_status add_all(film *f, fw_error *error)
{
    for (int64_t n = 0; n < f->count; ++n) {
        const fw_status ended = fw_interrupt_seen();
        if (ended != FW_OK) return fw_fail(error, ended, "ended before the film was whole");
        FW_TRY(add_frame(f, n * f->every, error));
    }
    return FW_OK;
}

/* Where nothing is said: by a field, as far as one was recorded. */
static const char *default_kind(const fw_plot_result *result, const fw_film_wish *wish)
{
    if (wish->picture || wish->kind || wish->field) return wish->kind;
    return fw_plot_usual_field(result) ? "field" : "motion";
}

static fw_status prepare(film *f, const char *directory, const fw_film_wish *wish, fw_error *error)
{
    FW_TRY(fw_plot_result_open(&f->result, directory, error));
    FW_TRY(fw_plot_frame_find(&f->bounds, &f->result, true, error));
    f->result.bounds = &f->bounds;
    const int64_t frames = f->result.playback->frame_count;
    f->every = wish->every > 0 ? wish->every : 1 + (frames - 1) / FRAMES_DEFAULT;
    f->count = (frames + f->every - 1) / f->every;
    FW_TRY(fw_scratch_folder_make(f->folder, "film", error));
    snprintf(f->picture, sizeof f->picture, "%s/frame.png", f->folder);
    f->wish = (fw_plot_wish){.file = f->picture,
                             .picture = wish->picture,
                             .kind = default_kind(&f->result, wish),
                             .field = wish->field,
                             .step_count = 1,
                             .range = {wish->range[0], wish->range[1]}};
    const int rate = wish->rate > 0 ? (int)wish->rate : RATE_DEFAULT;
    return fw_encoder_begin(&f->encoder, wish->file, rate, error);
}

static void clear(film *f)
{
    fw_encoder_abandon(f->encoder);
    if (f->picture[0]) unlink(f->picture);
    if (f->folder[0]) rmdir(f->folder);
    fw_plot_result_close(&f->result);
}

fw_status fw_film_make(const char *directory, const fw_film_wish *wish, FILE *out, fw_error *error)
{
    film f = {0};
    FW_TRY(fw_sweep_refuse(directory, error));
    fw_interrupt_watch();
    fw_status status = prepare(&f, directory, wish, error);
    if (status == FW_OK) status = add_all(&f, error);
    if (status == FW_OK) {
        status = fw_encoder_commit(f.encoder, error);
        f.encoder = NULL;
    }
    if (status == FW_OK)
        fprintf(out, "film: %s, %lld frames, %.3g s\n", wish->file, (long long)f.count,
                (double)f.count / (double)(wish->rate > 0 ? wish->rate : RATE_DEFAULT));
    clear(&f);
    fw_interrupt_leave();
    return status;
}
