/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_bodies_meet.c - before bodies touch: how they may start, how the search follows them, and
 * what may not carry them. */
#include "tests/support/pistons.h"

static void bodies_that_start_in_each_other_are_refused(void **state)
{
    (void)state;
    /* A corner, all of it, a chain across; the same place, a part of it with the edges on edges and
     * nodes on nodes; chains that share a line with an edge. */
    const fw_vec2 origins[] = {{3.5, 2.2}, {1.5, 1.5}, {-3, 3.3}, {0, 0}, {2, 0}, {2, 5}, {0, 1.5}};
    const int columns[] = {6, 2, 14, 6, 3, 3, 1}, rows[] = {6, 2, 1, 6, 2, 1, 3};
    for (int n = 0; n < 7; ++n) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6, .rows = 6});
        add_body(scene,
                 (body_options){.columns = columns[n], .rows = rows[n], .origin = origins[n]});
        assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
        assert_non_null(strstr(error.sentence, "body sheet starts in body sheet: "));
        assert_true(fw_scene_refused_body(scene) >= 0);
        fw_scene_destroy(scene);
    }
    /* Side by side, they may touch. */
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 6, .rows = 6});
    add_body(scene, (body_options){.columns = 6, .rows = 6, .origin = {5, 2.5}});
    begin(scene);
    run(scene, 100);
    assert_true(energy_of(scene) == 0);
    fw_scene_destroy(scene);
}

/* Small bodies whose edges are few runs: the search must not take flight for a jump. */
static void small_bodies_meet_after_free_flight(void **state)
{
    (void)state;
    const double speeds[] = {0.05, 0.2, 0.6};
    for (int n = 0; n < 3; ++n) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 4, .rows = 4, .velocity = {speeds[n], 0}});
        add_body(scene, (body_options){.columns = 4, .rows = 4, .origin = {4.1, 0.3}});
        begin(scene);
        const double before = energy_of(scene);
        run(scene, 60);
        assert_true(fw_scene_contact_ledger(scene)->ticks > 0);
        assert_true(fabs(energy_of(scene) / before - 1) < 1e-12);
        const fw_solid *hit = fw_scene_observe_body(scene, 1);
        assert_true(fw_solid_momentum(hit).x > 0.5 * speeds[n] * hit->model->mass(hit).xx);
        fw_scene_destroy(scene);
    }
}

/* Two plates, one held, the other carried into it. */
static void grips_do_not_carry_bodies_into_each_other(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 6, .rows = 2});
    add_body(scene, (body_options){.columns = 4, .rows = 2, .origin = {0.7, 1.55}});
    const int lower[] = {6, 7, 8, 9, 10, 11}, upper[] = {0, 1, 2, 3};
    fw_grip_def def = {.name = "clamp",
                       .particles = lower,
                       .particle_count = 6,
                       .drive = {.prescribed_x = true, .prescribed_y = true}};
    must(fw_scene_add_grip(scene, 0, &def, &error));
    def.name = "hand";
    def.particles = upper;
    def.particle_count = 4;
    def.drive.path = (fw_path){.velocity = {0.03, -0.1}, .until = INFINITY};
    must(fw_scene_add_grip(scene, 1, &def, &error));
    begin(scene);
    run(scene, 5);
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_int_equal(fw_scene_step(scene, &error), FW_DIVERGED);
    assert_non_null(strstr(error.sentence, "grips carry particle"));
    fw_scene_destroy(scene);
}

/* Five spacings a step, from the first step on: nobody knows of a way before. */
static void fast_bodies_start_anywhere(void **state)
{
    (void)state;
    for (int n = 0; n < 20; ++n) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6, .rows = 6});
        add_body(scene,
                 (body_options){
                     .columns = 6, .rows = 6, .origin = {8 + 1.3 * n, 0.3}, .velocity = {-5, 0}});
        begin(scene);
        run(scene, 12);
        assert_true(fw_scene_contact_ledger(scene)->ticks > 0);
        fw_scene_destroy(scene);
    }
}

/* The step would end with both ends in one place, from which no one could tell them apart. */
static void chains_that_would_meet_in_one_place_do_not_pass(void **state)
{
    (void)state;
    for (int n = 0; n < 20; ++n) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 4, .rows = 1, .velocity = {0.1, 0}});
        add_body(scene, (body_options){.columns = 4, .rows = 1, .origin = {3.1 + 0.1 * n, 0}});
        begin(scene);
        run(scene, 100);
        const fw_solid *right = fw_scene_observe_body(scene, 1);
        assert_close(fw_solid_momentum(right).x, 0.3, 1e-12);
        fw_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_that_start_in_each_other_are_refused),
        cmocka_unit_test(small_bodies_meet_after_free_flight),
        cmocka_unit_test(chains_that_would_meet_in_one_place_do_not_pass),
        cmocka_unit_test(grips_do_not_carry_bodies_into_each_other),
        cmocka_unit_test(fast_bodies_start_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
