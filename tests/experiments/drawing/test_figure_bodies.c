/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_bodies.c - figures of bodies, drawn from small synthetic data in all formats. */
#include "tests/support/drawn_figure.h"

/* A square sheet of SIDE x SIDE particles that obey Newton with unit springs for x and y, in a box:
 * enough to look like the solids this is for. */
enum { SIDE = 20, SHEET = SIDE * SIDE, LINKS = 2 * SIDE * (SIDE - 1), STEPS = 1600 };

typedef struct sheet {
    double x[SHEET], y[SHEET], u[SHEET], v[SHEET];
    double speed[SHEET];
    int links[LINKS][2];
} sheet;

static void start_sheet(sheet *s)
{
    int link = 0;
    for (int k = 0; k < SHEET; ++k) {
        int i = k % SIDE, j = k / SIDE;
        s->x[k] = 7.313 + i;
        s->y[k] = 11.747 + j;
        s->u[k] = .07;
        s->v[k] = .045;
        s->speed[k] = hypot(.07, .045);
        if (i + 1 < SIDE) memcpy(s->links[link++], (int[2]){k, k + 1}, sizeof(int[2]));
        if (j + 1 < SIDE) memcpy(s->links[link++], (int[2]){k, k + SIDE}, sizeof(int[2]));
    }
    assert_int_equal(link, LINKS);
}

static void advance_sheet(sheet *s, double low, double high)
{
    const double dt = .5;
    for (int link = 0; link < LINKS; ++link) {
        int a = s->links[link][0], b = s->links[link][1];
        double fx = s->x[b] - s->x[a] - (b == a + 1 ? 1 : 0);
        double fy = s->y[b] - s->y[a] - (b == a + 1 ? 0 : 1);
        s->u[a] += dt * fx;
        s->u[b] -= dt * fx;
        s->v[a] += dt * fy;
        s->v[b] -= dt * fy;
    }
    for (int k = 0; k < SHEET; ++k) {
        double x = s->x[k] + dt * s->u[k], y = s->y[k] + dt * s->v[k];
        if (x < low || x > high) s->u[k] = -s->u[k];
        if (y < low || y > high) s->v[k] = -s->v[k];
        if (x >= low && x <= high) s->x[k] = x;
        if (y >= low && y <= high) s->y[k] = y;
        s->speed[k] = hypot(s->u[k], s->v[k]);
    }
}

static fw_view_body body_of(const sheet *s)
{
    return (fw_view_body){.name = "sheet",
                          .count = SHEET,
                          .x = s->x,
                          .y = s->y,
                          .links = *s->links,
                          .link_count = LINKS,
                          .spacing = 1};
}

static double mean(const double *values, int count)
{
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += values[k];
    return sum / count;
}

static fw_status draw_motion(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_motion(page, data, error);
}

static fw_status draw_field(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_field(page, data, error);
}

static fw_status draw_strip(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_strip(page, data, error);
}

enum { INSTANTS = 5 };

typedef struct journey {
    sheet at[INSTANTS];
    fw_view_body bodies[INSTANTS];
    fw_view views[INSTANTS];
    double path_x[STEPS + 1], path_y[STEPS + 1];
    fw_figure_path path;
    fw_outline wall;
} journey;

static const fw_vec2 box_corners[4] = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};

static journey *travel(void)
{
    journey *j = calloc(1, sizeof *j);
    assert_non_null(j);
    sheet now;
    start_sheet(&now);
    j->wall = (fw_outline){
        .points = box_corners, .count = 4, .closed = true, .forbidden = FW_FORBIDDEN_OUTSIDE};
    for (int step = 0; step <= STEPS; ++step) {
        int instant = step / (STEPS / (INSTANTS - 1));
        j->path_x[step] = mean(now.x, SHEET);
        j->path_y[step] = mean(now.y, SHEET);
        if (step % (STEPS / (INSTANTS - 1)) == 0) {
            j->at[instant] = now;
            j->bodies[instant] = body_of(&j->at[instant]);
            j->bodies[instant].field = j->at[instant].speed;
            j->views[instant] = (fw_view){.step = step,
                                          .bodies = &j->bodies[instant],
                                          .body_count = 1,
                                          .walls = &j->wall,
                                          .wall_count = 1};
        }
        advance_sheet(&now, 0, 60);
    }
    j->path = (fw_figure_path){j->path_x, j->path_y, STEPS + 1};
    return j;
}

/* Where a drawing first uses that colour. */
static const char *first_use(const char *svg, fw_colour colour)
{
    double red, green, blue;
    for (const char *at = strstr(svg, "rgb("); at; at = strstr(at + 1, "rgb("))
        if (sscanf(at, "rgb(%lf%%,%lf%%,%lf%%)", &red, &green, &blue) == 3 &&
            fabs(red - 100 * colour.red) + fabs(green - 100 * colour.green) +
                    fabs(blue - 100 * colour.blue) <
                1e-3)
            return at;
    fail_msg("a colour is not used");
    return NULL;
}

/* Bodies are drawn as time goes; their colours go along the map, from .16 to .93. */
static void assert_instants_have_their_colours(const char *name)
{
    file_bytes file = read_file(name);
    const char *svg = (const char *)file.bytes, *before = svg;
    for (int k = 0; k < INSTANTS; ++k) {
        const double part = .16 + (.93 - .16) * k / (INSTANTS - 1);
        const char *use = first_use(svg, fw_palette_at(FW_PALETTE_SEQUENTIAL, part));
        assert_true(use > before);
        before = use;
    }
    free(file.bytes);
}

static void a_sheet_on_its_way_is_drawn(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_motion_plan plan = {
        .views = j->views, .view_count = INSTANTS, .paths = &j->path, .path_count = 1};
    draw_everywhere(draw_motion, &plan,
                    page_with("A lattice Boltzmann sheet bounces in a rigid box",
                              "20 × 20 particles, box 60 × 60, frictionless walls. After Chopard & "
                              "Marconi 2002, Fig. 1."),
                    "motion");
    assert_instants_have_their_colours(picture_name("motion", ".svg"));
    free(j);
}

static void a_field_is_drawn_on_the_particles(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_field_plan plan = {.view = &j->views[1],
                                 .colouring = {.label = {"speed / lattice units per step", 0}}};
    draw_everywhere(draw_field, &plan, page_with("Speed of the particles", NULL), "field");
    plan.look = FW_VIEW_DISCS;
    plan.colouring = (fw_colouring){.label = {"velocity along x", 0}, .trim = .02};
    j->bodies[1].field = j->at[1].u;
    draw_everywhere(draw_field, &plan, page_with(NULL, NULL), "field-signs");
    free(j);
}

static void a_sequence_is_drawn_side_by_side(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_strip_plan plan = {
        .views = j->views, .view_count = INSTANTS, .colouring = {.label = {"speed", 0}}};
    draw_everywhere(draw_strip, &plan, page_with("The bounce in frames", NULL), "strip");
    static const char *const kinds[7] = {"white", NULL, NULL, NULL, NULL, NULL, "black"};
    unsigned char species[SHEET];
    for (int k = 0; k < SHEET; ++k) species[k] = (unsigned char)((k % SIDE + k / SIDE) % 2 ? 6 : 0);
    for (int k = 0; k < INSTANTS; ++k) {
        j->bodies[k].field = NULL;
        j->bodies[k].species = species;
        j->views[k].kinds = kinds;
        j->views[k].kind_count = 7;
    }
    plan.columns = 3;
    plan.look = FW_VIEW_DISCS;
    draw_everywhere(draw_strip, &plan, page_with(NULL, "Black and white cells."), "strip-species");
    free(j);
}

/* --- forces --- */

static fw_status draw_forces(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_forces(page, data, error);
}

/* A chain pulled at both ends: each link is stretched by 2 F (Chopard & Marconi Fig 4). */
typedef struct chain {
    double original[9], x[9], zero[9];
    int links[8][2];
    fw_figure_force forces[18];
    fw_figure_forces_panel panel;
} chain;

static void pull_chain(chain *c, int count, double stretch, const char *name)
{
    int forces = 0;
    memset(c, 0, sizeof *c);
    for (int k = 0; k < count; ++k) {
        c->original[k] = 8. * k / (count - 1);
        c->x[k] = c->original[k] + stretch * (k - (count - 1) / 2.);
        if (k > 0) c->forces[forces++] = (fw_figure_force){k, {-.1, 0}, false};
        if (k + 1 < count) c->forces[forces++] = (fw_figure_force){k, {.1, 0}, false};
        if (k > 0) memcpy(c->links[k - 1], (int[2]){k - 1, k}, sizeof(int[2]));
    }
    c->forces[forces++] = (fw_figure_force){0, {-.1, 0}, true};
    c->forces[forces++] = (fw_figure_force){count - 1, {.1, 0}, true};
    c->panel = (fw_figure_forces_panel){name,    count,     c->original, c->zero,   c->x,
                                        c->zero, *c->links, count - 1,   c->forces, forces};
}

static void forces_on_chains_are_drawn(void **state)
{
    (void)state;
    chain nine, three;
    pull_chain(&nine, 9, .2, "9 particles, F = 0.1: elongation 1.6");
    pull_chain(&three, 3, .2, "3 particles, F = 0.1: elongation 0.4");
    fw_figure_forces_panel panels[2] = {nine.panel, three.panel};
    fw_figure_forces_plan plan = {.panels = panels, .panel_count = 2};
    draw_everywhere(draw_forces, &plan,
                    page_with("A chain under tension", "After Chopard & Marconi 2002, Fig. 4."),
                    "forces-chains");
}

static void forces_on_a_sheet_are_drawn(void **state)
{
    (void)state;
    const double x0[4] = {0, 1, 0, 1}, y0[4] = {1, 1, 0, 0};
    const double x[4] = {-.08, 1.05, -.02, 1.12}, y[4] = {1.1, 1.04, -.06, -.05};
    const int links[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    const fw_figure_force forces[12] = {
        {0, {-.1, .08}, true},   {1, {.05, .06}, true},    {2, {-.05, -.08}, true},
        {3, {.1, -.06}, true},   {0, {.065, -.02}, false}, {1, {-.065, .02}, false},
        {2, {.07, .01}, false},  {3, {-.07, -.01}, false}, {0, {.03, -.06}, false},
        {2, {-.03, .06}, false}, {1, {.02, -.045}, false}, {3, {-.02, .045}, false}};
    fw_figure_forces_panel panel = {
        "four particles under balanced forces", 4, x0, y0, x, y, *links, 4, forces, 12};
    fw_figure_forces_plan plan = {.panels = &panel, .panel_count = 1};
    draw_everywhere(draw_forces, &plan, page_with("A sheet of four particles", NULL),
                    "forces-sheet");
}

/* In the SVG, by colour: the blue of internal forces and the orange of external ones. */
static bool shows(const char *name, const char *colour)
{
    char path[256];
    snprintf(path, sizeof path, PICTURES "%s.svg", name);
    file_bytes file = read_file(path);
    const bool found = strstr((const char *)file.bytes, colour) != NULL;
    free(file.bytes);
    return found;
}

static void the_legend_names_forces_that_are_drawn(void **state)
{
    (void)state;
    const char *const blue = "rgb(0%,44.7", *const orange = "rgb(83.5";
    chain nine;
    pull_chain(&nine, 9, .2, NULL);
    fw_figure_forces_plan plan = {.panels = &nine.panel, .panel_count = 1};
    draw_everywhere(draw_forces, &plan, page_with("A chain", NULL), "forces-both");
    assert_true(shows("forces-both", blue) && shows("forces-both", orange));
    nine.panel.force_count -= 2;
    draw_everywhere(draw_forces, &plan, page_with("A chain", NULL), "forces-internal");
    assert_true(shows("forces-internal", blue) && !shows("forces-internal", orange));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_on_its_way_is_drawn),
        cmocka_unit_test(a_field_is_drawn_on_the_particles),
        cmocka_unit_test(a_sequence_is_drawn_side_by_side),
        cmocka_unit_test(forces_on_chains_are_drawn),
        cmocka_unit_test(forces_on_a_sheet_are_drawn),
        cmocka_unit_test(the_legend_names_forces_that_are_drawn),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
