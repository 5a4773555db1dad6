/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_shapes.c - which sites a body occupies: the table of shapes. Keeps no state.
 * Invariant: reading a scenario never makes the sites of a rectangle or disc, so that it takes no
 * longer than its text deserves, however large the body. Start reading at
 * fw_scenario_read_shape(). */
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

/* The sentence of the maker of sites, at the place where the shape was written. */
static fw_status fail_shape(const fw_scenario *scenario, const fw_node *node, const char *body,
                            fw_status status, fw_error *error)
{
    return fw_scenario_fail_within(scenario, node->place, status, error, "bodies.%s.shape.%s", body,
                                   node->key);
}

static fw_status read_list(const fw_scenario *scenario, const fw_node *list, fw_scenario_body *body,
                           fw_error *error)
{
    fw_site *sites = malloc((size_t)list->count * sizeof *sites);
    if (!sites) return fw_document_fail_memory(scenario->document, error);
    int count = 0;
    for (const fw_node *pair = list->first; pair; pair = pair->next)
        sites[count++] = fw_scenario_read_site(pair);
    const fw_status status = fw_sites_list(&body->shape.sites, sites, count, error);
    free(sites);
    FW_TRY(fail_shape(scenario, list, body->name, status, error));
    measure_sites(&body->shape);
    return FW_OK;
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
    const fw_status status = fw_sites_mask(&body->shape.sites, mask->text, error);
    FW_TRY(fail_shape(scenario, mask, body->name, status, error));
    measure_sites(&body->shape);
    return FW_OK;
}

static fw_status read_rectangle(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_body *body, fw_error *error)
{
    fw_scenario_shape *shape = &body->shape;
    (void)scenario;
    (void)error;
    shape->columns = (int)fw_node_integer(node->first);
    shape->rows = (int)fw_node_integer(node->last);
    shape->count = (int64_t)shape->columns * shape->rows;
    shape->last_row = shape->rows - 1;
    shape->last_column = shape->columns - 1;
    return FW_OK;
}

static fw_status read_disc(const fw_scenario *scenario, const fw_node *node, fw_scenario_body *body,
                           fw_error *error)
{
    (void)scenario;
    (void)error;
    body->shape.radius = fw_node_number(node);
    measure_disc(body);
    return FW_OK;
}

static const fw_key placed_keys[] = {
    {"count", FW_FORM_INTEGER, REQUIRED, FROM_TO(1, FW_COORDINATE_MAX), NOT_STORED,
     .meaning = "how many particles"},
    {"box", FW_FORM_NUMBERS, .layout = "[x0, y0, x1, y1]", REQUIRED, NOT_STORED, .unit = "length",
     .meaning = "lower left and upper right corner, seen from the body's origin"},
    {"min-distance", AT_NUMBER(fw_scenario_shape, apart), AT_LEAST(0), .default_value = "0.75",
     .unit = "length", .meaning = "no two are closer"},
    {.name = NULL}};

static const fw_section fw_placed_section = {
    "`bodies.NAME.shape.placed`", "a random placement",
    "Particles are dropped one after the other, uniformly in a rectangle; one that falls too near "
    "an earlier one is dropped again. The places follow from the run's seed; particle n is called "
    "site [n, 0].",
    .keys = placed_keys};

static fw_status refuse_lattices(const fw_scenario *scenario, const fw_node *node,
                                 const fw_scenario_body *body, const char *how, fw_error *error)
{
    if (fw_material_model_of(scenario->materials[body->material].kind)->flows) return FW_OK;
    return fw_scenario_fail(scenario, node->key_place, error,
                            "bodies.%s is %s, which only movable particles can be: the others live "
                            "on a lattice",
                            body->name, how);
}

/* All in one row: particle n is site [n, 0]. */
static void line_up(fw_scenario_shape *shape)
{
    shape->columns = (int)shape->count;
    shape->rows = 1;
    shape->last_column = shape->columns - 1;
}

static fw_status read_points(const fw_scenario *scenario, const fw_node *list,
                             fw_scenario_body *body, fw_error *error)
{
    FW_TRY(refuse_lattices(scenario, list, body, "a list of places", error));
    FW_TRY(fw_scenario_read_points(scenario, list, body, error));
    line_up(&body->shape);
    return FW_OK;
}

static fw_status read_placed(const fw_scenario *scenario, const fw_node *node,
                             fw_scenario_body *body, fw_error *error)
{
    fw_scenario_shape *shape = &body->shape;
    double box[4];
    FW_TRY(refuse_lattices(scenario, node, body, "placed at random", error));
    FW_TRY(fw_schema_fill(scenario->document, &fw_placed_section, node, shape, error));
    const fw_node *corners = fw_node_find(node, "box");
    fw_node_numbers(corners, box);
    shape->low = (fw_vec2){box[0], box[1]};
    shape->high = (fw_vec2){box[2], box[3]};
    shape->count = fw_node_integer(fw_node_find(node, "count"));
    line_up(shape);
    if (shape->low.x < shape->high.x && shape->low.y < shape->high.y) return FW_OK;
    return fw_scenario_fail(scenario, corners->place, error,
                            "bodies.%s.shape.placed.box goes from [%g, %g] to [%g, %g], expected "
                            "the lower left corner first and the upper right one next",
                            body->name, box[0], box[1], box[2], box[3]);
}

/* --- what else is checked of shapes --- */

static fw_status make_frame(const fw_scenario_body *body, fw_sites *sites, fw_error *error)
{
    return fw_sites_rectangle(sites, body->shape.columns, body->shape.rows, error);
}

static fw_status make_disc(const fw_scenario_body *body, fw_sites *sites, fw_error *error)
{
    return fw_sites_disc(sites, body->lattice.kind, body->shape.radius, error);
}

static fw_status copy_sites(const fw_scenario_body *body, fw_sites *sites, fw_error *error)
{
    return fw_sites_list(sites, body->shape.sites.site, body->shape.sites.count, error);
}

static bool fills_row(const fw_scenario_body *body, int row, int first, int last)
{
    (void)body, (void)row, (void)first, (void)last;
    return true;
}

static bool disc_meets_row(const fw_scenario_body *body, int row, int first, int last)
{
    int own_first, own_last;
    return find_disc_row(body, row, &own_first, &own_last) && own_first <= last &&
           own_last >= first;
}

static bool list_meets_row(const fw_scenario_body *body, int row, int first, int last)
{
    const fw_sites *sites = &body->shape.sites;
    int low = 0, high = sites->count; /* the first site at (first, row) or later */
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const fw_site site = sites->site[middle];
        if (site.j < row || (site.j == row && site.i < first))
            low = middle + 1;
        else
            high = middle;
    }
    return low < sites->count && sites->site[low].j == row && sites->site[low].i <= last;
}

/* --- the table --- */

typedef struct shape_row {
    fw_key key; /* of a shape */
    fw_status (*read)(const fw_scenario *scenario, const fw_node *node, fw_scenario_body *body,
                      fw_error *error);
    fw_status (*make)(const fw_scenario_body *body, fw_sites *sites, fw_error *error);
    /* Has it a site in that row from column `first` to `last`, all within its frame? */
    bool (*meets_row)(const fw_scenario_body *body, int row, int first, int last);
} shape_row;

static const shape_row shapes[] = {
    [FW_SHAPE_RECTANGLE] = {{"rectangle", FW_FORM_INTEGERS, .layout = "[columns, rows]",
                             ALTERNATIVE, AT_LEAST(1), NOT_STORED, .unit = "sites",
                             .meaning = "lower left corner at site [0, 0]"},
                            read_rectangle,
                            make_frame,
                            fills_row},
    [FW_SHAPE_DISC] = {{"disc", FW_FORM_NUMBER, ALTERNATIVE, FROM_TO(0, 8192), NOT_STORED,
                        .unit = "spacings",
                        .meaning = "all sites within this distance of site [0, 0]"},
                       read_disc,
                       make_disc,
                       disc_meets_row},
    [FW_SHAPE_SITES] = {{"sites", FW_FORM_LIST, .items = FW_FORM_INTEGERS, .layout = "[i, j]",
                         ALTERNATIVE, .least = 1, NOT_STORED,
                         .meaning = "every site, in any order"},
                        read_list,
                        copy_sites,
                        list_meets_row},
    [FW_SHAPE_MASK] =
        {{"mask", FW_FORM_TEXT, ALTERNATIVE, NOT_STORED,
          .meaning =
              "lines of text (after a `|`): `#` is a particle, `.` none; the last line is row 0, "
              "its first character column 0"},
         read_mask,
         copy_sites,
         list_meets_row},
    [FW_SHAPE_PLACED] = {{"placed", FW_FORM_MAPPING, .subsection = &fw_placed_section, ALTERNATIVE,
                          NOT_STORED, .meaning = "random sequential placement (movable particles)"},
                         read_placed,
                         make_frame,
                         fills_row},
    [FW_SHAPE_POINTS] = {{"points", FW_FORM_LIST, .items = FW_FORM_NUMBERS, .layout = "[x, y]",
                          ALTERNATIVE, .least = 1, NOT_STORED, .unit = "length",
                          .meaning = "where each particle is, seen from the body's origin (movable "
                                     "particles); particle n is called site [n, 0]"},
                         read_points,
                         make_frame,
                         fills_row},
    {{"file", FW_FORM_TEXT | FW_FORM_MAPPING, .subsection = &fw_points_file_section, ALTERNATIVE,
      NOT_STORED,
      .meaning = "where each particle is, from a file: its name, or keys of what follows (movable "
                 "particles)"},
     NULL,
     NULL,
     NULL}};

const fw_section fw_shape_section = {
    "`bodies.NAME.shape`", "a shape",
    "Which sites [i, j] = [column, row] of the lattice the body occupies; rows count upwards.",
    FW_ROWS(shapes)};

fw_status fw_scenario_read_shape(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_body *body, fw_error *error)
{
    int kind = 0;
    while (strcmp(shapes[kind].key.name, node->first->key) != 0) ++kind;
    body->shape.kind = (fw_shape_kind)kind;
    return shapes[kind].read(scenario, node->first, body, error);
}

fw_status fw_scenario_sites(const fw_scenario_body *body, fw_sites *sites, fw_error *error)
{
    return shapes[body->shape.kind].make(body, sites, error);
}

bool fw_scenario_meets_row(const fw_scenario_body *body, int row, int first, int last)
{
    const fw_scenario_shape *shape = &body->shape;
    if (first < shape->first_column) first = shape->first_column;
    if (last > shape->last_column) last = shape->last_column;
    return row >= shape->first_row && row <= shape->last_row && first <= last &&
           shapes[shape->kind].meets_row(body, row, first, last);
}

bool fw_scenario_has_site(const fw_scenario_body *body, fw_site site)
{
    return fw_scenario_meets_row(body, site.j, site.i, site.i);
}
