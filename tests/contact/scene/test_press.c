/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_press.c - pistons that press bodies against walls and against each other. */
#include "tests/support/pistons.h"

static const fw_surface rough = {.law = FW_COULOMB, .friction = 0.3};

static void add_piston(fw_scene *scene, fw_wall_shape_kind shape, const fw_vec2 *points, int count,
                       double radius, fw_surface surface, const fw_piston_def *def)
{
    fw_wall_def wall = fw_wall_def_default();
    wall.name = "piston";
    wall.shape = shape;
    wall.points = points;
    wall.point_count = count;
    wall.radius = radius;
    wall.side = FW_OUTSIDE;
    wall.surface = surface;
    if (fw_scene_add_piston(scene, &wall, def, &error) != FW_OK) fail_msg("%s", error.sentence);
}

static double uniform(uint64_t *seed, double from, double to)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * (double)(*seed >> 11) * 0x1p-53;
}

/* A sheet lies on a floor, and a piston of any shape, mass, surface and drive comes down on it. */
static void press_anyhow(uint64_t seed, int *unresolved)
{
    static const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                          {.law = FW_STICK},
                                          {.law = FW_COULOMB, .friction = 0.4},
                                          {.law = FW_PENALTY, .stiffness = 0.5}};
    fw_scene *scene = empty_scene(1e6);
    const int kind = (int)uniform(&seed, 0, 4);
    const fw_surface surface = surfaces[(int)uniform(&seed, 0, 4)];
    const double x = uniform(&seed, 1, 7), tilt = uniform(&seed, -0.3, 0.3);
    const double top = uniform(&seed, 5.01, 5.5);
    const fw_vec2 box[] = {{x - 20, top}, {x + 20, top + 5}};
    const fw_vec2 wedge[] = {{x - 9, top + 4}, {x, top}, {x + 9, top + 4 + 9 * tilt}};
    const fw_vec2 centre = {x, top + 6.02};
    const fw_vec2 blade[] = {{x + 20, top + 20 * tilt + 6}, {x - 20, top - 20 * tilt + 6}};
    const double mass = exp(uniform(&seed, -1, 5));
    fw_piston_def def = {
        .mass = mass,
        .damping = uniform(&seed, 0, 1) < 0.5 ? 0 : 0.05,
        .velocity = {0, uniform(&seed, -0.1, 0)},
        .drive = {.force = {uniform(&seed, -0.02, 0.02), -0.1}, .tether = {0.01, 0}}};
    def.drive.prescribed_x = uniform(&seed, 0, 1) < 0.4;
    if (def.drive.prescribed_x) def.drive.force.x = def.drive.tether.x = 0;
    const fw_surface floors[] = {smooth, rough, {.law = FW_STICK}};
    const fw_surface floor = floors[(int)uniform(&seed, 0, 3)];
    const bool soft = surface.law == FW_PENALTY, soft_corner = soft && kind != 0 && kind != 2;
    const bool floor_first = uniform(&seed, 0, 1) < 0.5, hostile = uniform(&seed, 0, 1) < 0.5;
    const int wall = floor_first ? 1 : 0;
    if (hostile) { /* thrown sideways against a wall by a piston that is driven hard */
        def.drive.force.y = -1;
        def.velocity.y = -0.3;
    }
    add_sheet(scene, 9, 6, (fw_vec2){hostile ? -0.1 : 0, 0}, uniform(&seed, 0, 1), 0.98);
    if (floor_first) add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, floor, NULL);
    if (kind == 0) add_piston(scene, FW_BOX, box, 2, 0, surface, &def);
    if (kind == 1) add_piston(scene, FW_POLYGON, wedge, 3, 0, surface, &def);
    if (kind == 2) add_piston(scene, FW_CIRCLE, &centre, 1, 6, surface, &def);
    if (kind == 3) add_piston(scene, FW_CHAIN, blade, 2, 0, soft ? smooth : surface, &def);
    if (!floor_first) add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, floor, NULL);
    if (hostile) add_block(scene, "side", (fw_vec2){8.2, 0.5}, (fw_vec2){12, 50}, floor, NULL);
    begin(scene);
    double deepest = 0;
    for (int t = 0; t < 300; ++t) {
        run(scene, 1);
        deepest = fmax(deepest, fw_scene_penetration(scene, 0));
    }
    assert_ledger_balances(scene, 1e-11);
    const bool resolved = fw_scene_unresolved(scene) == 0 && motion_fits(scene, wall);
    if (resolved && !soft) assert_below(deepest, 1e-10);
    const fw_piston_ledger *a = ledger_of(scene, wall);
    const double flow = fabs(a->work) + fabs(a->pushed_by);
    if (resolved && !soft_corner) assert_below(fabs(a->unmatched_work), 1e-9 * (1 + flow));
    /* A soft corner pushes to one side or the other, and nothing between may fit; nor where a
     * piston sticks to what would leave it, or leads a particle into a corner. */
    if (!hostile && !soft_corner && surface.law != FW_STICK) assert_true(resolved);
    *unresolved += !resolved;
    fw_scene_destroy(scene);
}

static void any_press_keeps_its_ledger(void **state)
{
    (void)state;
    int unresolved = 0;
    for (uint64_t seed = 1; seed <= 100; ++seed)
        press_anyhow(seed * 0x9E3779B97F4A7C15u, &unresolved);
    print_message("%d of 100 presses have steps that do not fit\n", unresolved);
    assert_true(unresolved < 5);
}

/* A light piston, driven hard, is stopped by a block; a ball that it never comes to flies on. */
static void a_piston_strikes_only_what_it_reaches(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 0.5, .drive = {.prescribed_x = true, .force = {0, -1}}};
    add_sheet(scene, 6, 10, (fw_vec2){0, 0}, 0, 1);
    fw_lb_solid_def ball = fw_lb_solid_def_default();
    fw_sites site;
    fw_solid *solid;
    int body;
    const fw_vec2 velocity = {0, 0.05};
    assert_int_equal(fw_sites_rectangle(&site, 1, 1, NULL), FW_OK);
    ball.sites = &site;
    ball.lattice.origin = (fw_vec2){10, 8.1};
    ball.velocity = &velocity;
    ball.rest_mass = fw_sym2_scalar(1);
    assert_int_equal(fw_lb_solid_create(&solid, &ball, &error), FW_OK);
    assert_int_equal(fw_scene_adopt_body(scene, "ball", solid, &body, &error), FW_OK);
    fw_sites_clear(&site);
    add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){6, 0}, smooth, NULL);
    add_block(scene, "press", (fw_vec2){-50, 9}, (fw_vec2){50, 12}, smooth, &def);
    begin(scene);
    run(scene, 1);
    assert_true(ledger_of(scene, 1)->displacement.y > -0.1);
    assert_close(fw_solid_momentum(fw_scene_observe_body(scene, 1)).y, 0.025, 1e-15);
    fw_scene_destroy(scene);
}

/* What lies in one row between a piston and a floor has no way out: it stops the piston, and the
 * floor carries the load. */
static void one_row_carries_the_load(void **state)
{
    (void)state;
    for (int thrown = 0; thrown < 2; ++thrown) {
        fw_scene *scene = empty_scene(1e6);
        const fw_piston_def def = {
            .mass = 5,
            .velocity = {0, thrown ? -0.05 : 0},
            .drive = {.prescribed_x = true, .force = {0, thrown ? 0 : -0.2}}};
        add_sheet(scene, 10, 1, (fw_vec2){0, 0}, 0, 0.95);
        add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, smooth, NULL);
        add_block(scene, "press", (fw_vec2){-50, 0.33 * thrown}, (fw_vec2){50, 4}, smooth, &def);
        begin(scene);
        run(scene, 200);
        const fw_piston_ledger *a = ledger_of(scene, 1);
        if (thrown) {
            assert_close(a->velocity.y, 0.05, 1e-15);
        } else {
            assert_close(a->displacement.y, 0, 1e-14);
            assert_close(fw_scene_wall_ledger(scene, 0)->reaction.y, 0.2, 1e-14);
        }
        assert_true(fw_scene_penetration(scene, 0) == 0);
        assert_true(motion_fits(scene, 1));
        assert_ledger_balances(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* Each on columns of its own. */
static void two_platens_press_one_block(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {
        .mass = 5, .damping = 0.05, .drive = {.prescribed_x = true, .force = {0, -0.1}}};
    add_sheet(scene, 11, 6, (fw_vec2){0, 0}, 0, 0.95);
    add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, smooth, NULL);
    add_block(scene, "left", (fw_vec2){-1, 5}, (fw_vec2){4.5, 8}, smooth, &def);
    add_block(scene, "right", (fw_vec2){4.6, 5}, (fw_vec2){11, 8}, smooth, &def);
    begin(scene);
    run(scene, 3000);
    assert_close(fw_scene_wall_ledger(scene, 0)->reaction.y, 0.2, 1e-9);
    assert_true(motion_fits(scene, 1) && motion_fits(scene, 2));
    assert_ledger_balances(scene, 1e-11);
    fw_scene_destroy(scene);
}

/* n columns of a damped block yield to N like (rows - 1)/n links; the wall below carries N. */
static void pressed_block_yields_by_its_compliance(void **state)
{
    (void)state;
    const double load = 0.2;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 5, .drive = {.force = {0, -load}}, .damping = 0.05};
    add_sheet(scene, 20, 10, (fw_vec2){0, 0}, 0, 0.95);
    add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, smooth, NULL);
    add_block(scene, "press", (fw_vec2){-50, 9}, (fw_vec2){50, 12}, smooth, &def);
    begin(scene);
    run(scene, 6000);
    double sum = 0, deviation = 0;
    for (int t = 0; t < 200; ++t) {
        run(scene, 1);
        const double reaction = fw_scene_wall_ledger(scene, 0)->reaction.y;
        sum += reaction;
        deviation = fmax(deviation, fabs(reaction - load));
    }
    assert_close(sum / 200, load, 1e-9 * load);
    assert_below(deviation, 1e-9);
    assert_close(ledger_of(scene, 1)->displacement.y, -load * 9 / 20, 1e-9);
    assert_ledger_balances(scene, 1e-11);
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_press_keeps_its_ledger),
        cmocka_unit_test(a_piston_strikes_only_what_it_reaches),
        cmocka_unit_test(one_row_carries_the_load),
        cmocka_unit_test(two_platens_press_one_block),
        cmocka_unit_test(pressed_block_yields_by_its_compliance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
