/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_selection.c - which sites of a body are meant. Keeps no state. Start reading at
 * fw_scenario_read_selection(). */
#include "scenario_parts.h"

#include <stdlib.h>
#include <string.h>

static const fw_key selection_keys[] = {
    {"side", FW_FORM_WORD,
     WORDS({"left", FW_SIDE_LEFT}, {"right", FW_SIDE_RIGHT}, {"bottom", FW_SIDE_BOTTOM},
           {"top", FW_SIDE_TOP}),
     NOT_STORED, .default_meaning = "any", .meaning = "the outermost columns or rows of the body"},
    {"layers", FW_FORM_INTEGER, .needs = "side", AT_LEAST(1), NOT_STORED, .default_value = "1",
     .meaning = "how many of them"},
    {"rows", FW_FORM_INTEGERS, .layout = "[first, last]", NOT_STORED, .default_meaning = "all",
     .meaning = "both included"},
    {"columns", FW_FORM_INTEGERS, .layout = "[first, last]", NOT_STORED, .default_meaning = "all",
     .meaning = "both included"},
    {.name = NULL}};

const fw_section fw_selection_section = {
    "Selections: `sites`", "a selection",
    "`all`; one of the sides `left`, `right`, `bottom`, `top`; a list of sites `[[i, j], ...]`; "
    "or a mapping with the keys below, which must all hold. Every site, row and column named must "
    "belong to the body.",
    .keys = selection_keys};

static int compare_sites(const void *left, const void *right)
{
    const fw_site *a = left, *b = right;
    if (a->j != b->j) return a->j < b->j ? -1 : 1;
    return (a->i > b->i) - (a->i < b->i);
}

static fw_status select_list(const fw_scenario *scenario, const fw_node *list,
                             const fw_scenario_body *body, fw_selection *selection, fw_error *error)
{
    fw_site *sites;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *sites, &sites, error));
    int count = 0;
    for (const fw_node *pair = list->first; pair; pair = pair->next) {
        fw_site site = fw_scenario_read_site(pair);
        if (!fw_scenario_has_site(body, site))
            return fw_scenario_fail(scenario, pair->place, error,
                                    "site [%d, %d] is not one of body '%s', whose sites lie in "
                                    "columns %d to %d and rows %d to %d",
                                    site.i, site.j, body->name, body->shape.first_column,
                                    body->shape.last_column, body->shape.first_row,
                                    body->shape.last_row);
        sites[count++] = site;
    }
    qsort(sites, (size_t)count, sizeof *sites, compare_sites);
    for (int n = 1; n < count; ++n)
        if (!compare_sites(&sites[n - 1], &sites[n]))
            return fw_scenario_fail(scenario, list->place, error, "site [%d, %d] is listed twice",
                                    sites[n].i, sites[n].j);
    selection->site = sites;
    selection->site_count = count;
    return FW_OK;
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static void select_side(fw_selection *selection, const char *side, int layers)
{
    /* Layers are at most FW_SITES_MAX, so none of these overflow. */
    if (!strcmp(side, "left"))
        selection->last_column =
            smaller(selection->last_column, selection->first_column + layers - 1);
    else if (!strcmp(side, "right"))
        selection->first_column =
            larger(selection->first_column, selection->last_column - layers + 1);
    else if (!strcmp(side, "bottom"))
        selection->last_row = smaller(selection->last_row, selection->first_row + layers - 1);
    else if (!strcmp(side, "top"))
        selection->first_row = larger(selection->first_row, selection->last_row - layers + 1);
}

/* Both ends of `rows` or `columns`; they must lie in the body, in order. */
static fw_status select_range(const fw_scenario *scenario, const fw_node *range,
                              const fw_scenario_body *body, int least, int most, int *first,
                              int *last, fw_error *error)
{
    int from = (int)fw_node_integer(range->first), to = (int)fw_node_integer(range->last);
    if (from > to)
        return fw_scenario_fail(scenario, range->place, error,
                                "%s are [%d, %d], expected the first before the last", range->key,
                                from, to);
    if (from < least || to > most)
        return fw_scenario_fail(scenario, range->place, error,
                                "%s are [%d, %d], but those of body '%s' are %d to %d", range->key,
                                from, to, body->name, least, most);
    *first = larger(*first, from);
    *last = smaller(*last, to);
    return FW_OK;
}

static bool selects_any(const fw_selection *s, const fw_scenario_body *body)
{
    for (int row = s->first_row; row <= s->last_row; ++row)
        if (fw_scenario_meets_row(body, row, s->first_column, s->last_column)) return true;
    return false;
}

/* As many columns or rows as the body has, at most. */
static fw_status check_layers(const fw_scenario *scenario, const char *side, const fw_node *layers,
                              const fw_scenario_body *body, fw_error *error)
{
    const fw_scenario_shape *shape = &body->shape;
    const bool across = strcmp(side, "left") == 0 || strcmp(side, "right") == 0;
    const int most = across ? shape->last_column - shape->first_column + 1
                            : shape->last_row - shape->first_row + 1;
    if (!layers || fw_node_integer(layers) <= most) return FW_OK;
    return fw_scenario_fail(
        scenario, layers->place, error, "layers is %lld, expected at most the %d %s of body '%s'",
        (long long)fw_node_integer(layers), most, across ? "columns" : "rows", body->name);
}

fw_status fw_scenario_read_selection(const fw_scenario *scenario, const fw_node *owner,
                                     const fw_scenario_body *body, fw_selection *selection,
                                     fw_error *error)
{
    const fw_scenario_shape *shape = &body->shape;
    const fw_node *node = fw_node_find(owner, "sites");
    *selection = (fw_selection){.place = node ? node->place : owner->place,
                                .first_row = shape->first_row,
                                .last_row = shape->last_row,
                                .first_column = shape->first_column,
                                .last_column = shape->last_column};
    if (!node) return FW_OK;
    if (node->kind == FW_LIST) return select_list(scenario, node, body, selection, error);
    if (node->kind == FW_SCALAR) {
        select_side(selection, node->text, 1);
    } else {
        const fw_node *side = fw_node_find(node, "side"), *layers = fw_node_find(node, "layers");
        if (side) FW_TRY(check_layers(scenario, side->text, layers, body, error));
        if (side) select_side(selection, side->text, layers ? (int)fw_node_integer(layers) : 1);
        const fw_node *rows = fw_node_find(node, "rows"), *columns = fw_node_find(node, "columns");
        if (rows)
            FW_TRY(select_range(scenario, rows, body, shape->first_row, shape->last_row,
                                &selection->first_row, &selection->last_row, error));
        if (columns)
            FW_TRY(select_range(scenario, columns, body, shape->first_column, shape->last_column,
                                &selection->first_column, &selection->last_column, error));
    }
    if (selects_any(selection, body)) return FW_OK;
    return fw_scenario_fail(scenario, node->place, error,
                            "the selection has none of the sites of body '%s', expected at least "
                            "one",
                            body->name);
}

fw_status fw_selection_particles(const fw_selection *selection, const fw_sites *sites,
                                 int **particles, int *count, fw_error *error)
{
    int most = selection->site ? selection->site_count : sites->count;
    *count = 0;
    *particles = malloc((size_t)larger(most, 1) * sizeof **particles);
    if (!*particles) return fw_fail_memory(error, "a selection of sites");
    if (selection->site) {
        for (int n = 0; n < most; ++n) {
            int particle = fw_sites_find(sites, selection->site[n]);
            if (particle >= 0) (*particles)[(*count)++] = particle;
        }
        return FW_OK;
    }
    for (int n = 0; n < sites->count; ++n) {
        fw_site site = sites->site[n];
        if (site.j >= selection->first_row && site.j <= selection->last_row &&
            site.i >= selection->first_column && site.i <= selection->last_column)
            (*particles)[(*count)++] = n;
    }
    return FW_OK;
}
