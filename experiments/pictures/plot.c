/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot.c - draws one picture of a result, or all that its scenario names.
 * Keeps no state. Start reading at draw_picture(). */
#include "experiments/pictures/plot.h"

#include "experiments/storage/manifest.h"
#include "experiments/study/sweep.h"
#include "plot_choice.h"
#include "plot_sweep.h"

#include <stdlib.h>

/* What draws each kind: a row of picture_kind.h without its function does not compile. */
typedef fw_status (*draw_function)(const fw_plot_result *result, const fw_plot_picture *picture,
                                   fw_error *error);
#define DRAW_FUNCTION(id, draw, name, meaning, keys, needs, frames, field) fw_plot_draw_##draw,
static const draw_function draws[FW_PICTURE_KINDS] = {FW_PICTURE_ROWS(DRAW_FUNCTION)};

static fw_status draw_picture(const fw_plot_result *result, const fw_plot_wish *wish, FILE *out,
                              fw_error *error)
{
    fw_plot_choice *choice = calloc(1, sizeof *choice);
    if (!choice) return fw_fail_memory(error, "a picture");
    fw_status status = fw_plot_choose(choice, result, wish, error);
    if (status == FW_OK)
        status = draws[choice->picture.asked.kind](result, &choice->picture, error);
    if (status == FW_OK && !wish->file) {
        char name[FW_NAME_BYTES + 8];
        snprintf(name, sizeof name, "%s.png", choice->name);
        status = fw_manifest_enter(result->directory, name, error);
    }
    if (status == FW_OK) fprintf(out, "picture: %s\n", choice->picture.page.file);
    if (status == FW_OK && choice->notes[0]) fprintf(out, "  %s\n", choice->notes);
    fw_plot_choice_clear(choice);
    free(choice);
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
        if (!fw_plot_is_of_case(&result.scenario->pictures[n])) continue;
        const fw_status done = draw_picture(&result, &wish, out, &own);
        drawn = true;
        if (status == FW_OK && done != FW_OK) *error = own;
        if (status == FW_OK) status = done;
    }
    if (!drawn) status = draw_picture(&result, &(fw_plot_wish){0}, out, error);
    fw_plot_result_close(&result);
    return status;
}
