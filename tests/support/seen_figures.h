/* SPDX-License-Identifier: GPL-3.0-or-later */
/* seen_figures.h - what a picture hands to its figure, looked at on its way there: the figures of
 * a test are replaced (see tests/CMakeLists.txt). */
#ifndef FW_SEEN_FIGURES_H
#define FW_SEEN_FIGURES_H

#include "experiments/drawing/figure.h"
#include "experiments/pictures/plot.h"
#include "tests/support/laws.h"
#include "tests/support/scratch.h"

#include <stdio.h>

#define NEVER_DRAWN "/tmp/fretwork-never-drawn.png"

static int looks;                      /* figures that were asked for */
static void (*look)(const void *plan); /* at the next one; NULL: it is drawn */
static char seen_caption[4096];        /* of the last one */

static inline void see_figure(const fw_page *page, const void *plan)
{
    ++looks;
    snprintf(seen_caption, sizeof seen_caption, "%s", page->caption ? page->caption : "");
    if (look) look(plan);
}

static inline void expect_caption(const char *words)
{
    if (!strstr(seen_caption, words)) fail_msg("'%s' does not say '%s'", seen_caption, words);
}

/* A figure that gets all it shows in a plan. */
#define SEEN_FIGURE(name, plan_type)                                                               \
    fw_status __real_##name(const fw_page *page, const plan_type *plan, fw_error *e);              \
    fw_status __wrap_##name(const fw_page *page, const plan_type *plan, fw_error *e);              \
    fw_status __wrap_##name(const fw_page *page, const plan_type *plan, fw_error *e)               \
    {                                                                                              \
        see_figure(page, plan);                                                                    \
        return look ? FW_OK : __real_##name(page, plan, e);                                        \
    }

static inline fw_status look_at(const char *directory, const fw_plot_wish *wish,
                                void (*asked)(const void *))
{
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    look = asked;
    looks = 0;
    const fw_status status = fw_plot_one(directory, wish, nowhere, &error);
    fclose(nowhere);
    return status;
}

static inline void draw_from(const char *directory, const fw_plot_wish *wish,
                             void (*asked)(const void *))
{
    assert_fine(look_at(directory, wish, asked));
    assert_int_equal(looks, 1);
}

#endif
