/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view_key.c - one scale for all values, or one name for each kind.
 * Keeps no state. Start reading at fw_view_key_for(). */
#include "view_key.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void name_kind(fw_view_key *key, int kind, const char *name)
{
    kind %= FW_PALETTE_KINDS;
    if (key->named[kind]) return;
    key->named[kind] = true;
    char *label = key->labels[key->entry_count];
    if (name) {
        snprintf(label, sizeof key->labels[0], "%s", name);
    } else {
        snprintf(label, sizeof key->labels[0], "kind %d", kind);
    }
    key->entries[key->entry_count++] =
        (fw_legend_entry){label, fw_palette_kind(kind), FW_LEGEND_DISC, 0};
}

static void name_kinds(fw_view_key *key, const fw_view *view)
{
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        bool seen[FW_PALETTE_KINDS] = {false};
        if (!body->species) name_kind(key, body->kind, body->name);
        for (int k = 0; body->species && k < body->count; ++k) {
            seen[body->species[k] % FW_PALETTE_KINDS] = true;
        }
        for (int kind = 0; kind < FW_PALETTE_KINDS; ++kind) {
            if (seen[kind])
                name_kind(key, kind, kind < view->kind_count ? view->kinds[kind] : NULL);
        }
    }
}

/* All values of all views one after the other; returns how many. */
static long gather(const fw_view *views, int view_count, double *values)
{
    long count = 0;
    for (int v = 0; v < view_count; ++v) {
        for (int b = 0; b < views[v].body_count; ++b) {
            const fw_view_body *body = &views[v].bodies[b];
            if (!body->field) continue;
            memcpy(values + count, body->field, (size_t)body->count * sizeof *values);
            count += body->count;
        }
    }
    return count;
}

static bool has_field(const fw_view *views, int view_count)
{
    for (int v = 0; v < view_count; ++v) {
        for (int b = 0; b < views[v].body_count; ++b) {
            if (views[v].bodies[b].field) return true;
        }
    }
    return false;
}

fw_status fw_view_key_for(fw_view_key *key, const fw_view *views, int view_count, fw_colouring wish,
                          fw_error *error)
{
    memset(key, 0, sizeof *key);
    key->by_field = has_field(views, view_count);
    if (!key->by_field) {
        for (int v = 0; v < view_count; ++v) name_kinds(key, &views[v]);
        if (key->entry_count == 1) key->entry_count = 0;
        return FW_OK;
    }
    long total = 0;
    for (int v = 0; v < view_count; ++v) total += fw_view_count(&views[v]);
    double *values = malloc(((size_t)total + 1) * sizeof *values);
    if (!values) return fw_fail_memory(error, "the values of a picture");
    key->scale = fw_colour_scale_for(wish, values, gather(views, view_count, values));
    free(values);
    return FW_OK;
}

const fw_colour_scale *fw_view_key_scale(const fw_view_key *key)
{
    return key->by_field ? &key->scale : NULL;
}
