/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_points.c - bodies whose particles stand where a file says. The places take that of the
 * file in the document, so that the scenario as run needs no other file. Keeps no state. Start
 * reading at fw_scenario_take_files(). */
#include "scenario_parts.h"

#include "experiments/configuration/configuration.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"

#include <math.h>
#include <string.h>

/* As written. */
typedef struct wanted {
    const char *name, *type; /* type NULL: all */
    double scale;
} wanted;

static const fw_key file_keys[] = {
    {"name", AT_TEXT(wanted, name), REQUIRED,
     .meaning = "extended XYZ (.xyz, .extxyz: its last frame) or a data file of LAMMPS (.data, "
                ".lmp); seen from the folder of the scenario"},
    {"scale", AT_NUMBER(wanted, scale), ABOVE_ZERO, .default_value = "1",
     .meaning = "what a length of 1 in the file is here"},
    {"type", AT_TEXT(wanted, type), .default_meaning = "all particles",
     .meaning = "only the particles of this species or type: one file can be several bodies"},
    {.name = NULL}};

const fw_section fw_points_file_section = {"`bodies.NAME.shape.file`", "a file of places",
                                           "Places of particles from another program, all in one "
                                           "plane z. The scenario as run has the places "
                                           "themselves, as `points`.",
                                           .keys = file_keys};

/* "FOLDER-OF-THE-SCENARIO/NAME"; the name alone where it begins at the root or nobody wrote the
 * scenario. */
static const char *path_of(const fw_scenario *scenario, const char *name)
{
    const char *file = fw_document_file(scenario->document);
    const char *end = file && name[0] != '/' ? strrchr(file, '/') : NULL;
    if (!end) return name;
    const size_t folder = (size_t)(end - file) + 1, size = folder + strlen(name) + 1;
    char *path = fw_document_allocate(scenario->document, size, 1);
    if (path) snprintf(path, size, "%.*s%s", (int)folder, file, name);
    return path;
}

static fw_node *make_node(fw_document *document, fw_node_kind kind, fw_node *parent)
{
    fw_node *node = fw_document_allocate(document, 1, sizeof *node);
    if (!node) return NULL;
    node->kind = kind;
    node->place = node->key_place = parent->place;
    return node;
}

static bool add_number(fw_document *document, fw_node *pair, double value)
{
    char text[FW_NUMBER_TEXT];
    fw_node *number = make_node(document, FW_SCALAR, pair);
    fw_number_write(text, value);
    if (!number || !(number->text = fw_document_copy(document, text, strlen(text)))) return false;
    number->length = strlen(text);
    fw_node_append(pair, number);
    return true;
}

static bool add_point(fw_document *document, fw_node *points, fw_vec2 place)
{
    fw_node *pair = make_node(document, FW_LIST, points);
    if (!pair || !add_number(document, pair, place.x) || !add_number(document, pair, place.y))
        return false;
    fw_node_append(points, pair);
    return true;
}

static fw_status put_points(fw_scenario *scenario, fw_node *shape, fw_node *file,
                            const fw_configuration *from, const wanted *what, fw_error *error)
{
    fw_document *document = scenario->document;
    fw_node *points = make_node(document, FW_LIST, file);
    if (!points) return fw_document_fail_memory(document, error);
    points->key = "points";
    points->key_place = file->key_place;
    for (int n = 0; n < from->count; ++n) {
        if (what->type && strcmp(what->type, from->kind[n]) != 0) continue;
        const fw_vec2 place = {what->scale * from->place[n].x, what->scale * from->place[n].y};
        if (!add_point(document, points, place)) return fw_document_fail_memory(document, error);
    }
    if (points->count == 0)
        return fw_scenario_fail(scenario, file->place, error,
                                "%s has no particle of type '%s', but such as '%s'", what->name,
                                fw_text_quote(what->type, strlen(what->type)).text, from->kind[0]);
    fw_node_remove(shape, file);
    fw_node_append(shape, points);
    return FW_OK;
}

static fw_status take_file(fw_scenario *scenario, fw_node *shape, fw_node *file, fw_error *error)
{
    wanted what = {.name = file->text, .scale = 1};
    fw_configuration from;
    if (file->kind == FW_MAPPING)
        FW_TRY(fw_schema_fill(scenario->document, &fw_points_file_section, file, &what, error));
    const char *path = path_of(scenario, what.name);
    if (!path) return fw_document_fail_memory(scenario->document, error);
    fw_status status = fw_configuration_read(&from, path, error);
    FW_TRY(fw_scenario_fail_again(scenario, file->place, status, error));
    status = put_points(scenario, shape, file, &from, &what, error);
    fw_configuration_clear(&from);
    return status;
}

fw_status fw_scenario_take_files(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *bodies = fw_scenario_part(scenario, "bodies", &count);
    for (const fw_node *body = bodies->first; body; body = body->next) {
        fw_node *shape = fw_node_find(body, "shape"), *file = fw_node_find(shape, "file");
        if (file) FW_TRY(take_file(scenario, shape, file, error));
    }
    return FW_OK;
}

fw_status fw_scenario_read_points(const fw_scenario *scenario, const fw_node *list,
                                  fw_scenario_body *body, fw_error *error)
{
    fw_scenario_shape *shape = &body->shape;
    if (list->count > FW_CONFIGURATION_MOST)
        return fw_scenario_fail(scenario, list->place, error,
                                "bodies.%s.shape has %d points, expected at most %d", body->name,
                                list->count, FW_CONFIGURATION_MOST);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *shape->points,
                                &shape->points, error));
    shape->low = shape->high =
        (fw_vec2){fw_node_number(list->first->first), fw_node_number(list->first->last)};
    for (const fw_node *pair = list->first; pair; pair = pair->next) {
        const fw_vec2 at = {fw_node_number(pair->first), fw_node_number(pair->last)};
        shape->points[shape->count++] = at;
        shape->low = (fw_vec2){fmin(shape->low.x, at.x), fmin(shape->low.y, at.y)};
        shape->high = (fw_vec2){fmax(shape->high.x, at.x), fmax(shape->high.y, at.y)};
    }
    return FW_OK;
}
