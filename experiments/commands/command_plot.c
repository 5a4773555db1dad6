/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_plot.c - pictures of a result: words of the command line into a wish. Keeps no state.
 * Start reading at fw_command_plot(). */
#include "experiments/commands/command.h"
#include "experiments/measures/column.h"
#include "experiments/pictures/plot_style.h"
#include "experiments/text/number.h"

#include <stdlib.h>
#include <string.h>

enum { ITEMS_MAX = 1024 };

/* A wish and the memory of its lists. */
typedef struct plot_lists {
    char *text; /* that the names lie in */
    const char **names;
    int64_t steps[ITEMS_MAX];
} plot_lists;

static fw_status read_steps(const char *text, plot_lists *lists, int *count, fw_error *error)
{
    *count = 0;
    for (const char *item = text; item;) {
        size_t length = strcspn(item, ",");
        int64_t step;
        if (*count == ITEMS_MAX || fw_integer_read(item, length, &step) != FW_NUMBER_FINE ||
            step < 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "--at %s, expected up to %d whole numbers with commas between them",
                           text, ITEMS_MAX);
        lists->steps[(*count)++] = step;
        item = item[length] ? item + length + 1 : NULL;
    }
    return FW_OK;
}

fw_status fw_command_read_range(const char *option, const char *text, double range[2],
                                fw_error *error)
{
    if (!text) return FW_OK;
    const size_t length = strcspn(text, ",");
    const char *high = text[length] ? text + length + 1 : "";
    if (fw_number_read(text, length, &range[0]) != FW_NUMBER_FINE ||
        fw_number_read(high, strlen(high), &range[1]) != FW_NUMBER_FINE || range[0] >= range[1])
        return fw_fail(error, FW_BAD_INPUT,
                       "%s %s, expected two numbers with a comma between them, the lower first",
                       option, text);
    return FW_OK;
}

static fw_status read_level(const char *text, double *level, fw_plot_wish *wish, fw_error *error)
{
    if (!text) return FW_OK;
    if (fw_number_read(text, strlen(text), level) != FW_NUMBER_FINE)
        return fw_fail(error, FW_BAD_INPUT, "--level %s, expected a number", text);
    wish->level = level;
    return FW_OK;
}

/* "a" or "ii", also as "(a)" or "a)"; longer texts belong into a title. */
static bool is_panel_letter(const char *text)
{
    const bool opens = *text == '(';
    const char *letter = text + opens;
    const size_t count = strspn(letter, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    const char *end = letter + count;
    return (count == 1 || count == 2) && (strcmp(end, ")") == 0 || (*end == '\0' && !opens));
}

/* Axes, letters, and what a file says of looks. */
static fw_status read_look(const fw_arguments *a, fw_plot_wish *wish, fw_error *error)
{
    FW_TRY(fw_command_read_range("--x-range", a->x_range, wish->x_range, error));
    FW_TRY(fw_command_read_range("--y-range", a->y_range, wish->y_range, error));
    if (a->font_size &&
        (fw_number_read(a->font_size, strlen(a->font_size), &wish->font_size) != FW_NUMBER_FINE ||
         wish->font_size < 4 || wish->font_size > 40))
        return fw_fail(error, FW_BAD_INPUT, "--font-size %s, expected a number from 4 to 40 points",
                       a->font_size);
    if (a->letter && !is_panel_letter(a->letter))
        return fw_fail(error, FW_BAD_INPUT,
                       "--letter %s, expected a letter or two, as a, B, ii or (a)", a->letter);
    if (a->with.count > FW_PLOT_WITH_MAX)
        return fw_fail(error, FW_BAD_INPUT, "--with is given %d times, expected at most %d",
                       a->with.count, FW_PLOT_WITH_MAX);
    wish->height = (double)a->height;
    wish->palette = a->palette;
    wish->in_steps = a->in_steps;
    wish->with = a->with.item;
    wish->with_count = a->with.count;
    return a->style ? fw_plot_style_read(wish, a->style, error) : FW_OK;
}

fw_status fw_command_plot(const fw_arguments *arguments, fw_error *error)
{
    const fw_arguments *a = arguments;
    const char *directory = a->words[0];
    if (!a->output && !a->picture && !a->kind && !a->field && !a->observable && !a->at &&
        !a->range && !a->along && !a->level && !a->logarithmic && !a->width && !a->dots &&
        !a->bare && !a->letter && !a->body && !a->from && !a->until && !a->font_size &&
        !a->x_range && !a->y_range && !a->style && !a->height && !a->palette && !a->in_steps &&
        a->with.count == 0)
        return fw_plot_all(directory, stdout, error);
    plot_lists *lists = calloc(1, sizeof *lists);
    if (!lists) return fw_fail_memory(error, "what to draw");
    double level;
    fw_plot_wish wish = {.file = a->output,
                         .picture = a->picture,
                         .kind = a->kind,
                         .field = a->field,
                         .logarithmic = a->logarithmic,
                         .along = a->along,
                         .width = (double)a->width,
                         .resolution = (double)a->dots,
                         .bare = a->bare,
                         .letter = a->letter,
                         .body = a->body,
                         .from = a->from,
                         .until = a->until,
                         .steps = lists->steps};
    fw_status status = fw_column_names_read(a->observable, &lists->text, &lists->names,
                                            &wish.observable_count, error);
    wish.observables = lists->names;
    if (status == FW_OK) status = read_steps(a->at, lists, &wish.step_count, error);
    if (status == FW_OK) status = fw_command_read_range("--range", a->range, wish.range, error);
    if (status == FW_OK) status = read_look(a, &wish, error);
    if (status == FW_OK) status = read_level(a->level, &level, &wish, error);
    if (status == FW_OK) status = fw_plot_one(directory, &wish, stdout, error);
    free(lists->names);
    free(lists->text);
    free(lists);
    return status;
}
