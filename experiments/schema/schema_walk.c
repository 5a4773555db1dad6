/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_walk.c - every key by its whole path. Keeps no state. Start reading at fw_schema_walk().
 */
#include "experiments/schema/schema.h"

#include <string.h>

typedef struct walker {
    fw_schema_visit visit;
    void *object;
    char path[FW_SCHEMA_PATH];
} walker;

static void append(walker *w, const char *name)
{
    const size_t used = strlen(w->path);
    snprintf(w->path + used, sizeof w->path - used, "%s%s", used ? "." : "", name);
}

/* Sections never contain each other in a circle, so this ends. */
static void walk(walker *w, const fw_section *section)
{
    const size_t before = strlen(w->path);
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        append(w, key->name);
        w->visit(w->object, w->path, key);
        const size_t named = strlen(w->path);
        if (key->forms & FW_FORM_NAMED) append(w, "NAME");
        if ((key->forms & FW_FORM_LIST) && key->subsection) append(w, "N");
        if (key->subsection) walk(w, key->subsection);
        w->path[named] = '\0';
        w->path[before] = '\0';
    }
}

void fw_schema_walk(const fw_section *root, fw_schema_visit visit, void *object)
{
    walker w = {.visit = visit, .object = object};
    walk(&w, root);
}
