/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_show.c - show: a scenario as it is written, with the values of its formulas as comments
 * behind their lines; or, changed by --set, as it would be run. Keeps no state. Start reading at
 * fw_command_show(). */
#include "experiments/commands/command.h"
#include "experiments/scenario/catalogue.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The values of formulas that are written in that line, in order. */
static bool print_values(const fw_node *node, int line, bool begun)
{
    for (const fw_node *child = node->first; child; child = child->next)
        begun = print_values(child, line, begun);
    if (!node->formula || node->place.line != line) return begun;
    printf("%s%s", begun ? ", " : "  # = ", node->text);
    return true;
}

static void print_text(const fw_scenario *scenario, const char *text, size_t length)
{
    const char *end = text + length;
    for (int line = 1; text < end; ++line) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        const size_t size = (size_t)((stop ? stop : end) - text);
        fwrite(text, 1, size, stdout);
        print_values(fw_document_root(scenario->document), line, false);
        putchar('\n');
        text += size + 1;
    }
}

static fw_status print_file(const fw_scenario *scenario, const char *path, fw_error *error)
{
    char *text = NULL;
    size_t room = 0;
    FILE *file = fopen(path, "r");
    const ssize_t length = file ? getdelim(&text, &room, '\0', file) : -1;
    const int reason = errno;
    if (length > 0) print_text(scenario, text, (size_t)length);
    free(text);
    if (file) fclose(file);
    if (length > 0) return FW_OK;
    /* It was there a moment ago. */
    return fw_fail(error, FW_SYSTEM_FAILED, "%s: cannot be read: %s", path, strerror(reason));
}

static fw_status print_as_run(const fw_scenario *scenario, fw_error *error)
{
    char *text;
    FW_TRY(fw_scenario_print(scenario, &text, error));
    fputs(text, stdout);
    free(text);
    return FW_OK;
}

fw_status fw_command_show(const fw_arguments *arguments, fw_error *error)
{
    char name[FW_NAME_BYTES + 1];
    const char *word = arguments->words[0];
    const fw_catalogue_entry *entry;
    fw_scenario *scenario;
    fw_error ignored;
    FW_TRY(fw_command_load(&scenario, word, arguments, name, error));
    fw_status status = FW_OK;
    if (arguments->settings.count > 0)
        status = print_as_run(scenario, error);
    else if (!strpbrk(word, "./") && fw_catalogue_find(&entry, word, &ignored) == FW_OK)
        print_text(scenario, entry->text, entry->length);
    else
        status = print_file(scenario, word, error);
    fw_scenario_destroy(scenario);
    return status;
}
