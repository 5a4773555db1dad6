/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_sites.c - shapes of bodies and selections of their sites. Keeps no state.
 * Invariant: reading a scenario never makes the sites of a rectangle or disc, so that it takes no
 * longer than its text deserves, however large the body. */
#include "experiments/text/text.h"
#include "scenario_parts.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- rows of a disc, as fw_sites_disc makes them --- */

static bool in_disc(fw_lattice_kind kind, double radius, int column, int row)
{
    const fw_lattice lattice = {.kind = kind, .spacing = 1};
    fw_vec2 position = fw_lattice_vector(&lattice, (fw_site){column, row});
    return fw_vec2_dot(position, position) <= radius * radius * (1 + 1e-12);
}

/* First and last column of a row; false for an empty row. */
static bool find_disc_row(const fw_scenario_body *body, int row, int *first, int *last)
{
    const fw_lattice lattice = {.kind = body->lattice.kind, .spacing = 1};
    const double radius = body->shape.radius;
    fw_vec2 start = fw_lattice_vector(&lattice, (fw_site){0, row});
    double half = sqrt(fmax(0, radius * radius - start.y * start.y));
    *first = (int)floor(-half - start.x) - 1;
    *last = (int)ceil(half - start.x) + 1;
    while (*first <= *last && !in_disc(lattice.kind, radius, *first, row)) *first += 1;
    while (*first <= *last && !in_disc(lattice.kind, radius, *last, row)) *last -= 1;
    return *first <= *last;
}

static void measure_disc(fw_scenario_body *body)
{
    fw_scenario_shape *shape = &body->shape;
    const int reach = (int)ceil(shape->radius * 1.16) + 1; /* rows are 3^(1/2)/2 apart or more */
    shape->first_row = shape->first_column = INT_MAX;
    shape->last_row = shape->last_column = INT_MIN;
    for (int row = -reach; row <= reach; ++row) {
        int first, last;
        if (!find_disc_row(body, row, &first, &last)) continue;
        shape->count += last - first + 1;
        if (shape->first_row == INT_MAX) shape->first_row = row;
        shape->last_row = row;
        if (first < shape->first_column) shape->first_column = first;
        if (last > shape->last_column) shape->last_column = last;
    }
}

static void measure_sites(fw_scenario_shape *shape)
{
    const fw_sites *sites = &shape->sites;
    shape->count = sites->count;
    shape->first_row = sites->site[0].j;
    shape->last_row = sites->site[sites->count - 1].j;
    shape->first_column = INT_MAX;
    shape->last_column = INT_MIN;
    for (int n = 0; n < sites->count; ++n) {
        int column = sites->site[n].i;
        if (column < shape->first_column) shape->first_column = column;
        if (column > shape->last_column) shape->last_column = column;
    }
}

/* --- reading shapes --- */

static fw_site read_site(const fw_node *pair)
{
    return (fw_site){(int)fw_node_integer(pair->first), (int)fw_node_integer(pair->last)};
}

/* The sentence of the maker of sites, at the place where the shape was written. */
static fw_status pass_on(const fw_scenario *scenario, const fw_node *node, const char *body,
                         const fw_error *inner, fw_error *error)
{
    if (inner->status != FW_BAD_INPUT) return fw_fail(error, inner->status, "%s", inner->sentence);
    return fw_scenario_fail(scenario, node->place, error, "bodies.%s.shape.%s: %s", body, node->key,
                            inner->sentence);
}

static fw_status read_list(const fw_scenario *scenario, const fw_node *list, fw_scenario_body *body,
                           fw_error *error)
{
    fw_site *sites = malloc((size_t)list->count * sizeof *sites);
    if (!sites) return fw_document_fail_memory(scenario->document, error);
    int count = 0;
    for (const fw_node *pair = list->first; pair; pair = pair->next)
        sites[count++] = read_site(pair);
    fw_error inner;
    fw_status status = fw_sites_list(&body->shape.sites, sites, count, &inner);
    free(sites);
    return status == FW_OK ? FW_OK : pass_on(scenario, list, body->name, &inner, error);
}

static fw_status read_mask(const fw_scenario *scenario, const fw_node *mask, fw_scenario_body *body,
                           fw_error *error)
{
    int row = 1;
    for (const char *c = mask->text; *c; ++c) {
        row += *c == '\n';
        if (strchr("#. \n", *c)) continue;
        size_t size = 1; /* the whole of a character of several bytes */
        while ((c[size] & 0xC0) == 0x80) ++size;
        return fw_scenario_fail(scenario, mask->place, error,
                                "bodies.%s.shape.mask has '%s' in its row %d from the top, "
                                "expected '#' for a particle and '.' for none",
                                body->name, fw_text_quote(c, size).text, row);
    }
    fw_error inner;
    if (fw_sites_mask(&body->shape.sites, mask->text, &inner) == FW_OK) return FW_OK;
    return pass_on(scenario, mask, body->name, &inner, error);
}

static void read_rectangle(const fw_node *node, fw_scenario_shape *shape)
{
    shape->columns = (int)fw_node_integer(node->first);
    shape->rows = (int)fw_node_integer(node->last);
    shape->count = (int64_t)shape->columns * shape->rows;
    shape->last_row = shape->rows - 1;
    shape->last_column = shape->columns - 1;
}

fw_status fw_scenario_read_shape(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_body *body, fw_error *error)
{
    fw_scenario_shape *shape = &body->shape;
    const fw_node *given;
    if ((given = fw_node_find(node, "rectangle"))) {
        shape->kind = FW_SHAPE_RECTANGLE;
        read_rectangle(given, shape);
        return FW_OK;
    }
    if ((given = fw_node_find(node, "disc"))) {
        shape->kind = FW_SHAPE_DISC;
        shape->radius = fw_node_number(given);
        measure_disc(body);
        return FW_OK;
    }
    if ((given = fw_node_find(node, "placed")))
        return fw_scenario_read_placed(scenario, given, body, error);
    if ((given = fw_node_find(node, "sites"))) {
        shape->kind = FW_SHAPE_SITES;
        FW_TRY(read_list(scenario, given, body, error));
    } else {
        shape->kind = FW_SHAPE_MASK;
        FW_TRY(read_mask(scenario, fw_node_find(node, "mask"), body, error));
    }
    measure_sites(shape);
    return FW_OK;
}

fw_status fw_scenario_sites(const fw_scenario_body *body, fw_sites *sites, fw_error *error)
{
    const fw_scenario_shape *shape = &body->shape;
    if (shape->kind == FW_SHAPE_RECTANGLE || shape->kind == FW_SHAPE_PLACED)
        return fw_sites_rectangle(sites, shape->columns, shape->rows, error);
    if (shape->kind == FW_SHAPE_DISC)
        return fw_sites_disc(sites, body->lattice.kind, shape->radius, error);
    return fw_sites_list(sites, shape->sites.site, shape->sites.count, error);
}

bool fw_scenario_has_site(const fw_scenario_body *body, fw_site site)
{
    const fw_scenario_shape *shape = &body->shape;
    bool in_frame = site.i >= shape->first_column && site.i <= shape->last_column &&
                    site.j >= shape->first_row && site.j <= shape->last_row;
    if (!in_frame || shape->kind == FW_SHAPE_RECTANGLE || shape->kind == FW_SHAPE_PLACED)
        return in_frame;
    if (shape->kind == FW_SHAPE_DISC)
        return in_disc(body->lattice.kind, shape->radius, site.i, site.j);
    return fw_sites_find(&shape->sites, site) >= 0;
}

/* --- reading selections --- */

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
        fw_site site = read_site(pair);
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
    const fw_scenario_shape *shape = &body->shape;
    if (s->first_row > s->last_row || s->first_column > s->last_column) return false;
    if (shape->kind == FW_SHAPE_RECTANGLE || shape->kind == FW_SHAPE_PLACED) return true;
    if (shape->kind == FW_SHAPE_DISC) {
        for (int row = s->first_row; row <= s->last_row; ++row) {
            int first, last;
            if (find_disc_row(body, row, &first, &last) && first <= s->last_column &&
                last >= s->first_column)
                return true;
        }
        return false;
    }
    for (int n = 0; n < shape->sites.count; ++n) {
        fw_site site = shape->sites.site[n];
        if (site.j >= s->first_row && site.j <= s->last_row && site.i >= s->first_column &&
            site.i <= s->last_column)
            return true;
    }
    return false;
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
