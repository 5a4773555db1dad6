/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_wish.c - what pictures of a kind do not draw. Keeps no state. */
#include "plot_choice.h"

static fw_status refuse_stray(fw_picture_kind kind, const char *stray, fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT, "a picture of kind %s does not draw %s",
                   fw_picture_rows[kind].name, stray);
}

/* May the ends of its axes be chosen? Those of maps are those of what is known. */
static bool has_free_axes(fw_picture_kind kind)
{
    static const fw_picture_kind kinds[] = {
        FW_PICTURE_MOTION, FW_PICTURE_CONTACT, FW_PICTURE_FIELD, FW_PICTURE_STRIP,
        FW_PICTURE_SERIES, FW_PICTURE_PROFILE, FW_PICTURE_LOOP,  FW_PICTURE_SWEEP};
    for (size_t n = 0; n < sizeof kinds / sizeof *kinds; ++n)
        if (kinds[n] == kind) return true;
    return false;
}

static bool has_charts(fw_picture_kind kind)
{
    return kind == FW_PICTURE_SERIES || kind == FW_PICTURE_LOOP || kind == FW_PICTURE_PROFILE ||
           kind == FW_PICTURE_SWEEP;
}

fw_status fw_plot_check_wish(const fw_plot_wish *wish, fw_picture_kind kind, fw_error *error)
{
    if (wish->field && !fw_picture_reads(kind, "field"))
        return refuse_stray(kind, "a field", error);
    if (wish->range[0] < wish->range[1] && !fw_picture_reads(kind, "range"))
        return refuse_stray(kind, "a range of colours", error);
    if (wish->along && kind != FW_PICTURE_SERIES && !fw_picture_reads(kind, "along"))
        return refuse_stray(kind, "anything along another number", error);
    if ((wish->x_range[0] < wish->x_range[1] || wish->y_range[0] < wish->y_range[1]) &&
        !has_free_axes(kind))
        return refuse_stray(kind, "a chosen part of its axes", error);
    if (wish->height > 0 && !has_charts(kind))
        return refuse_stray(kind, "charts, whose height could be chosen", error);
    if (wish->in_steps && kind != FW_PICTURE_SERIES)
        return refuse_stray(kind, "anything over steps", error);
    if (wish->palette && fw_palette_find(wish->palette) == FW_PALETTE_MAPS)
        return fw_fail(error, FW_BAD_INPUT, "there is no palette '%s', expected one of %s",
                       wish->palette, FW_PALETTE_NAMES);
    if (wish->with_count > 0 && kind != FW_PICTURE_SERIES)
        return refuse_stray(kind, "several results", error);
    if (wish->level && !fw_picture_reads(kind, "level"))
        return refuse_stray(kind, "a level", error);
    if (wish->observable_count > 0 && !fw_picture_reads(kind, "observables"))
        return refuse_stray(kind, "observables", error);
    if (wish->logarithmic && !fw_picture_reads(kind, "logarithmic"))
        return refuse_stray(kind, "anything on logarithmic axes", error);
    if (wish->step_count > 0 && fw_picture_rows[kind].frames == 0 &&
        !fw_picture_reads(kind, "from"))
        return refuse_stray(kind, "steps", error);
    if ((wish->from > 0 || wish->until > 0) && !fw_picture_reads(kind, "from"))
        return refuse_stray(kind, "anything from one step until another", error);
    if (wish->body && !fw_picture_reads(kind, "body")) return refuse_stray(kind, "one body", error);
    if (wish->step_count > 1 && kind == FW_PICTURE_PROFILE)
        return refuse_stray(kind, "more than one step", error);
    return FW_OK;
}
