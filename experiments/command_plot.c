/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_plot.c - pictures of a result: words of the command line into a wish. */
#include "experiments/command.h"
#include "experiments/number.h"
#include "experiments/plot.h"

#include <stdlib.h>
#include <string.h>

enum { ITEMS_MOST = 1024 };

/* A wish and the memory of its lists. */
typedef struct plot_lists {
    char *text; /* copy of the names, cut at commas */
    const char *names[ITEMS_MOST];
    int64_t steps[ITEMS_MOST];
} plot_lists;

/* Length of the item at the head of a list; a site as in "position.sheet[0,3]" is part of it. */
static size_t item_length(const char *text)
{
    size_t length = 0;
    for (bool site = false; text[length] && (text[length] != ',' || site); ++length) {
        if (text[length] == '[') site = true;
        if (text[length] == ']') site = false;
    }
    return length;
}

static fw_status read_names(const char *text, plot_lists *lists, int *count, fw_error *error)
{
    *count = 0;
    if (!text) return FW_OK;
    lists->text = strdup(text);
    if (!lists->text) return fw_fail_memory(error, "the names of observables");
    for (char *item = lists->text;;) {
        size_t length = item_length(item);
        bool last = item[length] == '\0';
        if (length == 0 || *count == ITEMS_MOST)
            return fw_fail(error, FW_BAD_INPUT,
                           "--observable %s, expected up to %d names with commas between them",
                           text, ITEMS_MOST);
        item[length] = '\0';
        lists->names[(*count)++] = item;
        if (last) return FW_OK;
        item += length + 1;
    }
}

static fw_status read_steps(const char *text, plot_lists *lists, int *count, fw_error *error)
{
    *count = 0;
    for (const char *item = text; item;) {
        size_t length = strcspn(item, ",");
        int64_t step;
        if (*count == ITEMS_MOST || fw_integer_read(item, length, &step) != FW_NUMBER_FINE ||
            step < 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "--at %s, expected up to %d whole numbers with commas between them",
                           text, ITEMS_MOST);
        lists->steps[(*count)++] = step;
        item = item[length] ? item + length + 1 : NULL;
    }
    return FW_OK;
}

fw_status fw_command_plot(const fw_arguments *arguments, fw_error *error)
{
    const fw_arguments *a = arguments;
    const char *directory = a->words[0];
    if (!a->output && !a->picture && !a->kind && !a->field && !a->observable && !a->at &&
        !a->logarithmic)
        return fw_plot_all(directory, stdout, error);
    plot_lists *lists = calloc(1, sizeof *lists);
    if (!lists) return fw_fail_memory(error, "what to draw");
    fw_plot_wish wish = {.file = a->output,
                         .picture = a->picture,
                         .kind = a->kind,
                         .field = a->field,
                         .logarithmic = a->logarithmic,
                         .observables = lists->names,
                         .steps = lists->steps};
    fw_status status = read_names(a->observable, lists, &wish.observable_count, error);
    if (status == FW_OK) status = read_steps(a->at, lists, &wish.step_count, error);
    if (status == FW_OK) status = fw_plot_one(directory, &wish, stdout, error);
    free(lists->text);
    free(lists);
    return status;
}
