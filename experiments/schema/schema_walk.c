/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_walk.c - the keys of a section, the sections below one, and every key by its whole path.
 * Keeps no state. Start reading at fw_section_first(). */
#include "experiments/schema/schema.h"

#include <assert.h>
#include <string.h>

/* --- sections and their keys --- */

static bool is_row(const fw_section *section, const fw_key *key)
{
    const char *first = (const char *)section->rows, *at = (const char *)key;
    return first && at >= first && at < first + section->row_count * section->row_size;
}

static const fw_key *first_plain(const fw_section *section)
{
    return section->keys && section->keys->name ? section->keys : NULL;
}

const fw_key *fw_section_first(const fw_section *section)
{
    return section->rows ? section->rows : first_plain(section);
}

const fw_key *fw_section_next(const fw_section *section, const fw_key *key)
{
    if (!is_row(section, key)) return key[1].name ? key + 1 : NULL;
    const fw_key *next = (const fw_key *)(const void *)((const char *)key + section->row_size);
    return is_row(section, next) ? next : first_plain(section);
}

const fw_key *fw_section_find(const fw_section *section, const char *name)
{
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key))
        if (!strcmp(key->name, name)) return key;
    return NULL;
}

static int collect(const fw_section *section, const fw_section **sections, int count)
{
    for (int n = 0; n < count; ++n)
        if (sections[n] == section) return count;
    assert(count < FW_SECTIONS_MAX);
    sections[count++] = section;
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key))
        if (key->subsection) count = collect(key->subsection, sections, count);
    return count;
}

int fw_schema_sections(const fw_section *root, const fw_section *sections[FW_SECTIONS_MAX])
{
    return collect(root, sections, 0);
}

/* --- all keys --- */

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
