/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_walls.c - walls of a scenario. Keeps no state. Start reading at
 * fw_scenario_read_walls(). */
#include "contact/geometry/wall.h"
#include "scenario_parts.h"

static const fw_key surface_keys[] = {
    {"coulomb", FW_FORM_NUMBER | FW_FORM_MAPPING, ALTERNATIVE, FROM_TO(0, 1000),
     .subsection = &fw_friction_section, NOT_STORED,
     .meaning = "friction coefficient: the tangential force is at most this times the reaction"},
    {"named", FW_FORM_NAME, ALTERNATIVE, NOT_STORED,
     .meaning = "a name of your own for what it is like where bodies rub on it: as `contact` says "
                "of its pair with the body's"},
    {"penalty", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED, .unit = "force/length",
     .meaning =
         "soft: a particle behind the surface by d is pushed back with this times d; not for "
         "chains"},
    {.name = NULL}};

static const fw_section fw_surface_section = {
    "`walls.NAME.surface`", "a surface",
    "`frictionless`, `stick` (a particle that touches is held; a wall at rest reflects it, one "
    "with a path takes it "
    "along, and what it had besides the path's velocity becomes heat), `componentwise` (of an "
    "elastic "
    "automaton: what would pass is frozen, the rest of the motion left alone, which does not "
    "conserve energy), or a mapping:",
    .keys = surface_keys};

static const fw_key path_keys[] = {
    {"velocity", AT_VEC2(fw_path, velocity), .layout = "[x, y]", .default_value = "[0, 0]",
     .unit = "length/time", .meaning = "constant during the window"},
    {"from", AT_NUMBER(fw_path, from), .needs = "velocity", .default_value = "0", .unit = "time",
     .meaning = "when the velocity begins"},
    {"until", AT_NUMBER(fw_path, until), .needs = "velocity", .default_value = "1e15",
     .default_meaning = "never", .unit = "time", .meaning = "when it ends"},
    {"amplitude", AT_VEC2(fw_path, amplitude), .layout = "[x, y]", .needs = "period",
     .default_value = "[0, 0]", .unit = "length", .meaning = "of an oscillation on top"},
    {"period", AT_NUMBER(fw_path, period), .needs = "amplitude", ABOVE_ZERO,
     .default_meaning = "no oscillation", .unit = "time", .meaning = "of the oscillation"},
    {"phase", AT_ANGLE(fw_path, phase), .needs = "period", FROM_TO(-360, 360), .default_value = "0",
     .unit = "degrees", .meaning = "of the oscillation at time 0"},
    {.name = NULL}};

const fw_section fw_path_section = {
    "`walls.NAME.path`", "a path",
    "The wall is displaced by velocity (t - from) while from <= t <= until, plus amplitude "
    "sin(360 t / period + phase).",
    .keys = path_keys};

static const fw_key piston_keys[] = {
    {"mass", AT_NUMBER(fw_scenario_piston, mass), REQUIRED, ABOVE_ZERO, .unit = "mass",
     .meaning = "of the whole wall"},
    {"damping", AT_NUMBER(fw_scenario_piston, damping), AT_LEAST(0), .default_value = "0",
     .unit = "1/time", .meaning = "rate at which its velocity decays"},
    {"velocity", AT_VEC2(fw_scenario_piston, velocity), .layout = "[x, y]",
     .default_value = "[0, 0]", .unit = "length/time", .meaning = "at the start"},
    {"meets", FW_FORM_LIST, .items = FW_FORM_NAME, .least = 1, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none",
     .meaning = "walls and pistons that it does not pass through, by name: they meet as rigid "
                "bodies without friction, and hits are elastic"},
    DRIVE_KEYS(fw_scenario_piston, "period", ITSELF),
    {.name = NULL}};

static const fw_section fw_piston_section = {
    "`walls.NAME.piston`", "a piston",
    "The wall has a mass and is moved by a drive and by what touches it; it does not turn, and "
    "passes through other walls but those that it `meets`. Energy and momentum of bodies and "
    "pistons together are exact.",
    .keys = piston_keys};

static const fw_word surface_words[] = {{"frictionless", FW_FRICTIONLESS},
                                        {"stick", FW_STICK},
                                        {"componentwise", FW_COMPONENTWISE},
                                        {NULL, 0}};

/* As large as the most numbers that a shape is given with, and one more. */
#define SHAPE_NUMBERS(id, word, low, high, expected, numbers, ...) double word[(numbers) + 1];
union shape_numbers {
    FW_WALL_SHAPE_ROWS(SHAPE_NUMBERS)
};

/* A key for each shape: so many numbers, or a list of points. */
#define SHAPE_KEY(id, word, low, high, expected, numbers, written, what, sided, corners)           \
    {{.name = #word,                                                                               \
      .forms = (numbers) ? FW_FORM_NUMBERS : FW_FORM_LIST,                                         \
      .items = (numbers) ? 0 : FW_FORM_NUMBERS,                                                    \
      .layout = written,                                                                           \
      .least = (numbers) ? 0 : (low),                                                              \
      .most = (numbers) ? 0 : POINTS_MAX,                                                          \
      ALTERNATIVE,                                                                                 \
      NOT_STORED,                                                                                  \
      .unit = "length",                                                                            \
      .meaning = what}},
enum { POINTS_MAX = 65536 };
static const struct {
    fw_key key;
} shape_keys[] = {FW_WALL_SHAPE_ROWS(SHAPE_KEY)};

static const fw_key wall_keys[] = {
    {"closed", AT_FLAG(fw_scenario_wall, def.closed), .needs = "chain", .default_value = "false",
     .meaning = "the chain returns to its first point"},
    {"side", AT_WORD(fw_scenario_wall, def.side),
     WORDS({"inside", FW_INSIDE}, {"outside", FW_OUTSIDE}), .default_value = "inside",
     .meaning = "where particles are free: of boxes, polygons and circles"},
    {"surface", FW_FORM_WORD | FW_FORM_MAPPING, .words = surface_words,
     .subsection = &fw_surface_section, NOT_STORED, .default_value = "frictionless",
     .meaning = "what it does along its tangent"},
    {"path", AT_OBJECT(fw_scenario_wall, def.path), .subsection = &fw_path_section,
     .default_meaning = "at rest",
     .meaning =
         "how it moves. It holds a particle up to one step's displacement in front of it: an "
         "indentation at 1e-3 a step was off by 1.3e-4"},
    {"piston", AT_OBJECT(fw_scenario_wall, piston), .subsection = &fw_piston_section,
     .default_meaning = "moved by nothing but its path",
     .meaning = "its mass, and the forces on it"},
    {.name = NULL}};

const fw_section fw_wall_section = {
    "`walls.NAME`", "a wall",
    "A rigid wall, at rest, on a prescribed path, or with a mass that forces move.",
    .keys = wall_keys, FW_ROWS(shape_keys)};

/* The shape that the wall has, and where that is written. */
static const fw_node *find_geometry(const fw_node *wall, fw_wall_shape_kind *shape)
{
    const fw_node *found = NULL;
    for (int n = 0; n < FW_WALL_SHAPES && !found; ++n) {
        found = fw_node_find(wall, fw_wall_shapes[n].word);
        *shape = (fw_wall_shape_kind)n;
    }
    return found;
}

static fw_status read_points(const fw_scenario *scenario, const fw_node *list, fw_wall_def *def,
                             fw_error *error)
{
    fw_vec2 *points;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *points, &points, error));
    def->points = points;
    for (const fw_node *pair = list->first; pair; pair = pair->next)
        points[def->point_count++] =
            (fw_vec2){fw_node_number(pair->first), fw_node_number(pair->last)};
    return FW_OK;
}

static fw_status read_geometry(const fw_scenario *scenario, const fw_node *node, fw_wall_def *def,
                               fw_error *error)
{
    const fw_node *given = find_geometry(node, &def->shape);
    const fw_wall_shape *shape = fw_wall_shape_of(def);
    double values[sizeof(union shape_numbers) / sizeof(double)];
    fw_vec2 *points;
    if (shape->numbers == 0) return read_points(scenario, given, def, error);
    fw_node_numbers(given, values);
    def->point_count = shape->numbers / 2;
    FW_TRY(
        fw_scenario_allocate(scenario, (size_t)def->point_count, sizeof *points, &points, error));
    def->points = points;
    for (int n = 0; n < def->point_count; ++n)
        points[n] = (fw_vec2){values[2 * n], values[2 * n + 1]};
    if (shape->numbers % 2 == 1) def->radius = values[shape->numbers - 1];
    return FW_OK;
}

/* Of a surface with a name, fw_scenario_read_contact() says how it rubs. */
static fw_status read_surface(const fw_scenario *scenario, const fw_node *node, fw_surface *surface,
                              fw_error *error)
{
    fw_friction friction;
    *surface = (fw_surface){.law = FW_FRICTIONLESS};
    if (!node) return FW_OK;
    if (node->kind == FW_SCALAR) {
        surface->law = (fw_surface_law)fw_node_word(node, surface_words);
        return FW_OK;
    }
    const fw_node *penalty = fw_node_find(node, "penalty");
    if (penalty) {
        *surface = (fw_surface){.law = FW_PENALTY, .stiffness = fw_node_number(penalty)};
        return FW_OK;
    }
    FW_TRY(fw_scenario_read_friction(scenario, fw_node_find(node, "coulomb"), &friction, error));
    *surface = (fw_surface){
        .law = FW_COULOMB, .friction = friction.kinetic, .static_friction = friction.at_rest};
    return FW_OK;
}

static fw_status read_piston(const fw_scenario *scenario, const fw_node *node,
                             fw_scenario_wall *wall, fw_error *error)
{
    const fw_node *piston = fw_node_find(node, "piston"), *path = fw_node_find(node, "path");
    if (!piston) return FW_OK;
    wall->is_piston = true;
    if (path)
        return fw_scenario_fail(
            scenario, path->key_place, error,
            "walls.%s has both 'piston' and 'path'; a piston is moved by forces, "
            "or by a path within 'piston'",
            node->key);
    FW_TRY(fw_scenario_read_drive(scenario, piston, piston, "piston", node->key,
                                  &wall->piston.motion, error));
    const fw_node *velocity = fw_node_find(piston, "velocity");
    const fw_drive *drive = &wall->piston.motion.drive;
    if (velocity && ((drive->prescribed_x && wall->piston.velocity.x != 0) ||
                     (drive->prescribed_y && wall->piston.velocity.y != 0)))
        return fw_scenario_fail(
            scenario, velocity->place, error,
            "piston '%s' has the velocity [%g, %g], expected 0 in the component "
            "that 'hold' names",
            node->key, wall->piston.velocity.x, wall->piston.velocity.y);
    return FW_OK;
}

static fw_status read_wall(fw_scenario *scenario, const fw_node *node, fw_scenario_wall *wall,
                           fw_error *error)
{
    fw_wall_def *def = &wall->def;
    wall->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_wall_section, node, wall, error));
    def->name = node->key;
    FW_TRY(read_geometry(scenario, node, def, error));
    FW_TRY(read_surface(scenario, fw_node_find(node, "surface"), &def->surface, error));
    const fw_node *side = fw_node_find(node, "side");
    if (side && !fw_wall_shape_of(def)->sided)
        return fw_scenario_fail(scenario, side->key_place, error,
                                "walls.%s has both '%s' and 'side'; a %s is free to the left of "
                                "the way along it, so turn its points round instead",
                                node->key, fw_wall_shape_of(def)->word,
                                fw_wall_shape_of(def)->word);
    fw_wall_shape_kind shape;
    FW_TRY(fw_scenario_fail_again(scenario, find_geometry(node, &shape)->place,
                                  fw_wall_def_check(def, error), error));
    return read_piston(scenario, node, wall, error);
}

/* Once all walls have their numbers. */
static fw_status read_meets(fw_scenario *scenario, const fw_node *walls, const fw_node *node,
                            fw_error *error)
{
    const fw_node *piston = fw_node_find(node, "piston");
    const fw_node *meets = piston ? fw_node_find(piston, "meets") : NULL;
    int own;
    if (!meets) return FW_OK;
    fw_node name = *node;
    name.text = node->key;
    FW_TRY(fw_scenario_find(scenario, walls, "wall", &name, &own, error));
    fw_scenario_piston *of = &scenario->walls[own].piston;
    FW_TRY(
        fw_scenario_allocate(scenario, (size_t)meets->count, sizeof *of->meets, &of->meets, error));
    for (const fw_node *item = meets->first; item; item = item->next) {
        int *other = &of->meets[of->meets_count++];
        FW_TRY(fw_scenario_find(scenario, walls, "wall", item, other, error));
        if (*other == own)
            return fw_scenario_fail(scenario, item->place, error,
                                    "piston '%s' meets itself, expected other walls", node->key);
        for (int n = 0; n < of->meets_count - 1; ++n)
            if (of->meets[n] == *other)
                return fw_scenario_fail(scenario, item->place, error,
                                        "piston '%s' meets '%s' a second time, expected each once",
                                        node->key, item->text);
    }
    return FW_OK;
}

fw_status fw_scenario_read_walls(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "walls", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->walls, &scenario->walls,
                                error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_wall(scenario, node, &scenario->walls[scenario->wall_count++], error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_meets(scenario, part, node, error));
    return FW_OK;
}
