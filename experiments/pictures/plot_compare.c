/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_compare.c - several results in one frame. Keeps no state. Start reading at
 * fw_plot_compared_find(). */
#include "plot_compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- names --- */

enum { RESULTS_MAX = 1 + FW_PLOT_WITH_MAX };

/* Paths of all results, the own one first, and how much of each name is needed to tell them apart.
 */
typedef struct result_names {
    char *path[RESULTS_MAX]; /* whole, or as it was given */
    int count, parts;
} result_names;

/* The last so many parts of a path: "soft", "results/soft". */
static const char *end_of(const char *path, int parts)
{
    const char *begin = path + strlen(path);
    while (begin > path && (begin[-1] != '/' || --parts > 0)) --begin;
    return begin;
}

static bool are_told_apart(const result_names *names)
{
    for (int n = 1; n < names->count; ++n)
        for (int m = 0; m < n; ++m)
            if (strcmp(end_of(names->path[n], names->parts),
                       end_of(names->path[m], names->parts)) == 0)
                return false;
    return true;
}

static void clear_names(result_names *names)
{
    for (int n = 0; n < names->count; ++n) free(names->path[n]);
}

static fw_status find_names(result_names *names, const fw_plot_result *own,
                            const fw_plot_picture *picture, fw_error *error)
{
    enum { PARTS_MAX = 8 };
    for (int n = 0; n <= picture->with_count; ++n) {
        const char *given = n == 0 ? own->directory : picture->with[n - 1];
        char *path = realpath(given, NULL);
        if (!path) path = strdup(given);
        if (!path) return fw_fail_memory(error, "a picture of several results");
        names->path[names->count++] = path;
    }
    for (names->parts = 1; names->parts < PARTS_MAX && !are_told_apart(names);) ++names->parts;
    if (!are_told_apart(names)) names->parts = 1;
    return FW_OK;
}

/* --- other results --- */

static fw_status open_others(fw_plot_compared *c, const fw_plot_series *own,
                             const fw_plot_picture *picture, fw_error *error)
{
    fw_plot_picture wanted = *picture;
    wanted.with_count = 0;
    for (int n = 0; n < picture->with_count; ++n) {
        c->count = n + 1;
        FW_TRY(fw_plot_result_open(&c->result[n], picture->with[n], error));
        FW_TRY(fw_plot_series_find(&c->series[n], &c->result[n], &wanted, error));
        bool alike = c->series[n].panel_count == own->panel_count;
        for (int p = 0; alike && p < own->panel_count; ++p)
            alike = strcmp(c->series[n].charts[p].label.text, own->charts[p].label.text) == 0 &&
                    c->series[n].charts[p].label.factor == own->charts[p].label.factor;
        if (!alike)
            return fw_fail(error, FW_BAD_INPUT,
                           "%s and %s do not go into one frame: what is drawn of them is called "
                           "differently or has other units; name one observable of both",
                           own->result->directory, picture->with[n]);
    }
    return FW_OK;
}

static const fw_plot_series *series_of(const fw_plot_compared *c, const fw_plot_series *own, int n)
{
    return n == 0 ? own : &c->series[n - 1];
}

static fw_status allocate(fw_plot_compared *c, const fw_plot_series *own, fw_error *error)
{
    size_t curves = 0;
    for (int n = 0; n <= c->count; ++n)
        for (int p = 0; p < own->panel_count; ++p)
            curves += (size_t)series_of(c, own, n)->charts[p].curve_count;
    c->charts = calloc((size_t)own->panel_count, sizeof *c->charts);
    c->curves = calloc(curves + 1, sizeof *c->curves);
    c->labels = calloc(curves + 1, sizeof *c->labels);
    return c->charts && c->curves && c->labels
               ? FW_OK
               : fw_fail_memory(error, "a picture of several results");
}

/* What a heat bath is set to is left out: it may be another in each result. */
static bool is_of_bath(const fw_curve *curve)
{
    return curve->look == FW_CURVE_DASHES && curve->colour == FW_PLOT_BATH_COLOUR;
}

/* The curves of all results in one panel after the other. */
static void fill_charts(fw_plot_compared *c, const fw_plot_series *own, const result_names *names)
{
    int used = 0;
    for (int p = 0; p < own->panel_count; ++p) {
        c->charts[p] = own->charts[p];
        c->charts[p].curves = c->curves + used;
        c->charts[p].curve_count = 0;
        for (int n = 0; n <= c->count; ++n) {
            const fw_chart *chart = &series_of(c, own, n)->charts[p];
            for (int k = 0; k < chart->curve_count; ++k) {
                const fw_curve *curve = &chart->curves[k];
                if (is_of_bath(curve)) continue;
                const bool alone = !curve->label || strcmp(curve->label, "measured") == 0;
                snprintf(c->labels[used], sizeof c->labels[used], "%s%s%s",
                         end_of(names->path[n], names->parts), alone ? "" : ": ",
                         alone ? "" : curve->label);
                c->curves[used] = *curve;
                c->curves[used].label = c->labels[used];
                used += 1;
                c->charts[p].curve_count += 1;
            }
        }
    }
}

fw_status fw_plot_compared_find(fw_plot_compared *c, const fw_plot_series *own,
                                const fw_plot_picture *picture, fw_error *error)
{
    result_names names = {.count = 0};
    *c = (fw_plot_compared){.count = 0};
    FW_TRY(open_others(c, own, picture, error));
    FW_TRY(allocate(c, own, error));
    const fw_status status = find_names(&names, own->result, picture, error);
    if (status == FW_OK) fill_charts(c, own, &names);
    clear_names(&names);
    return status;
}

void fw_plot_compared_clear(fw_plot_compared *c)
{
    for (int n = 0; n < c->count; ++n) {
        fw_plot_series_clear(&c->series[n]);
        fw_plot_result_close(&c->result[n]);
    }
    free(c->charts);
    free(c->curves);
    free(c->labels);
    *c = (fw_plot_compared){.count = 0};
}
