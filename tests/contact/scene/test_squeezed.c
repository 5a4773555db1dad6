/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_squeezed.c - what lies between a piston and a wall, a body or another piston: loads go
 * through, friction knows how hard it is squeezed, and the order of walls decides nothing. */
#include "tests/support/pistons.h"

static void add_at(fw_scene *scene, int columns, int rows, fw_vec2 origin)
{
    add_body(scene, (body_options){.columns = columns, .rows = rows, .origin = origin, .mu = 0.95});
}

static const fw_piston_def press = {
    .mass = 5, .damping = 0.05, .drive = {.prescribed_x = true, .force = {0, -0.2}}};

/* A foil of one row on a block on a floor; each carries the piston's load. */
static void a_foil_passes_the_load_on_to_a_body(void **state)
{
    (void)state;
    const double offsets[] = {0, 0.37};
    for (int n = 0; n < 2; ++n) {
        fw_scene *scene = empty_scene(1e4);
        add_at(scene, 12, 4, (fw_vec2){0, 0});
        add_at(scene, 14, 1, (fw_vec2){offsets[n] - 1, 3.01});
        add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, smooth, NULL);
        add_block(scene, "press", (fw_vec2){-50, 3.05}, (fw_vec2){50, 8}, smooth, &press);
        begin(scene);
        for (int t = 0; t < 6000; ++t) {
            run(scene, 1);
            assert_below(fw_scene_penetration(scene, -1), 1e-12);
            assert_below(fw_scene_body_penetration(scene), 1e-12);
        }
        assert_close(fw_scene_wall_ledger(scene, 0)->reaction.y, 0.2, 1e-5);
        assert_close(fw_scene_wall_ledger(scene, 1)->reaction.y, -0.2, 1e-5);
        assert_ledger_balances(scene, 1e-11);
        assert_true(motion_fits(scene, 1));
        fw_scene_destroy(scene);
    }
}

/* Between two pistons, neither of which is held, a block takes what one gives the other. */
static void a_body_between_two_pistons_takes_along_what_it_gets(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    const fw_piston_def pushed = {.mass = 3, .drive = {.prescribed_x = true, .force = {0, 0.01}}};
    const fw_piston_def still = {.mass = 7, .drive = {.prescribed_x = true}};
    add_sheet(scene, 6, 4, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "below", (fw_vec2){-9, -5}, (fw_vec2){50, -0.3}, smooth, &pushed);
    add_block(scene, "above", (fw_vec2){-9, 3.4}, (fw_vec2){50, 8}, smooth, &still);
    begin(scene);
    run(scene, 500);
    const double body = fw_scene_momentum(scene).y;
    const double pistons =
        3 * ledger_of(scene, 0)->velocity.y + 7 * ledger_of(scene, 1)->velocity.y;
    assert_close(body + pistons, 0.01 * 500, 1e-12);
    assert_true(ledger_of(scene, 1)->velocity.y > 0.1);
    assert_ledger_balances(scene, 1e-11);
    fw_scene_destroy(scene);
}

/* How far a foil on a rough floor under a smooth piston is pulled aside in 9000 steps, and in the
 * last 1000 of them. */
static double pulled_aside(double pull, bool floor_first, double *last)
{
    const fw_surface rough = {.law = FW_COULOMB, .friction = 0.5};
    fw_scene *scene = empty_scene(1e4);
    add_at(scene, 8, 1, (fw_vec2){0, 0});
    if (floor_first) add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, rough, NULL);
    add_block(scene, "press", (fw_vec2){-50, 0}, (fw_vec2){50, 8}, smooth, &press);
    if (!floor_first) add_block(scene, "floor", (fw_vec2){-50, -5}, (fw_vec2){50, 0}, rough, NULL);
    int particles[8];
    for (int n = 0; n < 8; ++n) particles[n] = n;
    const fw_load_def load = {.kind = FW_LOAD_TOTAL,
                              .particles = particles,
                              .particle_count = 8,
                              .vector = {pull, 0},
                              .until = INT64_MAX};
    must(fw_scene_add_load(scene, 0, &load, &error));
    begin(scene);
    run(scene, 8000);
    const double before = fw_solid_position(fw_scene_observe_body(scene, 0), 0).x;
    run(scene, 1000);
    assert_ledger_balances(scene, 1e-11);
    assert_true(motion_fits(scene, floor_first ? 1 : 0));
    const double aside = fw_solid_position(fw_scene_observe_body(scene, 0), 0).x;
    *last = aside - before;
    fw_scene_destroy(scene);
    return aside;
}

/* .5 times the load of .2 is what friction bears. */
static void friction_knows_how_hard_a_piston_squeezes(void **state)
{
    (void)state;
    double last;
    assert_below(fabs(pulled_aside(0.09, true, &last)), 0.1);
    assert_true(last == 0);
    assert_true(pulled_aside(0.11, true, &last) > 1);
}

static void the_order_of_walls_decides_nothing(void **state)
{
    (void)state;
    double last;
    assert_close(pulled_aside(0.09, true, &last), pulled_aside(0.09, false, &last), 1e-12);
    assert_close(pulled_aside(0.11, true, &last), pulled_aside(0.11, false, &last), 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_foil_passes_the_load_on_to_a_body),
        cmocka_unit_test(a_body_between_two_pistons_takes_along_what_it_gets),
        cmocka_unit_test(friction_knows_how_hard_a_piston_squeezes),
        cmocka_unit_test(the_order_of_walls_decides_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
