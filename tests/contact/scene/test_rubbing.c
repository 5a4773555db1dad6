/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_rubbing.c - friction between bodies: what sticks does not creep, what slides obeys the cone,
 * and what that takes is heat. */
#include "tests/support/scenes.h"

#include "core/noise.h"

/* Two beams of at most 20 columns, the lower held at its bottom, the upper pressed and moved by
 * `path` at its top. */
static fw_scene *two_surfaces(int columns, fw_friction friction, fw_path path)
{
    fw_scene *scene = empty_scene(1e4);
    int held[2][20];
    for (int n = 0; n < columns; ++n) {
        held[0][n] = n;
        held[1][n] = 4 * columns + n;
    }
    add_body(scene, (body_options){.columns = columns, .rows = 5, .mu = 0.9});
    add_body(scene,
             (body_options){.columns = columns, .rows = 5, .origin = {0.5, 4.001}, .mu = 0.9});
    const fw_grip_def below = {.name = "held",
                               .particles = held[0],
                               .particle_count = columns,
                               .drive = {.prescribed_x = true, .prescribed_y = true}};
    const fw_grip_def above = {.name = "driven",
                               .particles = held[1],
                               .particle_count = columns,
                               .drive = {.prescribed_x = true, .path = path, .force = {0, -0.2}}};
    must(fw_scene_add_grip(scene, 0, &below, &error));
    must(fw_scene_add_grip(scene, 1, &above, &error));
    /* Each of its own surface; the pairs of like ones would give other numbers. */
    const fw_friction pairs[4] = {{3, 4}, friction, friction, {5, 6}};
    must(fw_scene_set_surfaces(scene, 2, pairs, (int[]){0, 1}, &error));
    begin(scene);
    return scene;
}

static fw_scene *two_beams(double friction, fw_path path)
{
    return two_surfaces(20, fw_friction_of(friction, friction), path);
}

static void assert_energy_closes(const fw_scene *scene, double tolerance)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    assert_close(energy_of(scene), fw_ledger_energy(&ledger),
                 tolerance * fw_scene_energy_scale(scene));
}

/* Sheared by .01, well inside the cone, and left alone: not one bit. */
static void what_sticks_does_not_creep(void **state)
{
    (void)state;
    fw_scene *scene = two_beams(0.3, (fw_path){.velocity = {1e-5, 0}, .from = 1000, .until = 2000});
    run(scene, 6000);
    const double heat = fw_scene_contact_ledger(scene)->heat;
    const fw_vec2 force = fw_scene_body_ledger(scene, 1, 0)->reaction;
    assert_close(force.x, -0.01 * 20 / 8, 1e-4); /* 20 columns, 8 links in a row */
    run(scene, 4000);
    assert_close(fw_scene_body_ledger(scene, 1, 0)->reaction.x, force.x, 1e-14);
    assert_close(fw_scene_contact_ledger(scene)->heat, heat, 1e-15);
    assert_close(fw_scene_contact_ledger(scene)->unconverged, 0, 2);
    assert_energy_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

static void what_slides_obeys_the_cone(void **state)
{
    (void)state;
    for (int n = 0; n < 2; ++n) {
        const double friction = n == 0 ? 0.3 : 0.1;
        fw_scene *scene =
            two_beams(friction, (fw_path){.velocity = {1e-4, 0}, .from = 1000, .until = 4000});
        /* The less friction the sooner all of them slide. */
        run(scene, n == 0 ? 3600 : 2000);
        const double before = fw_scene_contact_ledger(scene)->heat;
        run(scene, 400);
        const fw_vec2 force = fw_scene_body_ledger(scene, 1, 0)->reaction;
        assert_close(force.x / force.y, -friction, 0.015 * friction);
        const double heat = fw_scene_contact_ledger(scene)->heat - before;
        assert_close(heat, friction * 0.2 * 0.04, 0.01 * heat);
        assert_true(fw_scene_contact_ledger(scene)->overstep < 0.04);
        assert_true(fw_scene_body_penetration(scene) == 0);
        assert_energy_closes(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* Pulled ever further, it bears more than the kinetic coefficient times the load before it lets go
 * (though less than the static one: it breaks loose from the edge at which it bears least, one
 * particle after the other), and the kinetic one once it slides. */
static void what_sticks_bears_more_than_what_slides(void **state)
{
    (void)state;
    fw_scene *scene = two_surfaces(20, (fw_friction){0.2, 0.4},
                                   (fw_path){.velocity = {1e-4, 0}, .from = 1000, .until = 6000});
    double most = 0;
    for (int t = 0; t < 3600; ++t) {
        run(scene, 1);
        most = fmax(most, -fw_scene_body_ledger(scene, 1, 0)->reaction.x);
    }
    assert_true(most > 1.3 * 0.2 * 0.2 && most < 0.4 * 0.2);
    /* Particles stick and slip, and what is stored in the beams comes and goes: over 400 steps the
     * heat is off by a tenth. */
    const double before = fw_scene_contact_ledger(scene)->heat;
    run(scene, 1200);
    /* Normals and tangents lean on each other: in turn 100 of these steps would not settle, and
     * friction exceed its cone by .46. */
    assert_true(fw_scene_contact_ledger(scene)->overstep < 0.04);
    assert_true(fw_scene_contact_ledger(scene)->unconverged <= 5);
    assert_close(fw_scene_contact_ledger(scene)->heat - before, 0.2 * 0.2 * 0.12, 1.9e-4);
    assert_energy_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

/* Pulled inside the cone, for 10^4 steps: it does not creep by one bit, on whichever of
 * the walls that its corner touches comes first, and the ledger closes. */
static void what_lies_on_a_floor_does_not_creep(void **state)
{
    (void)state;
    double place[2];
    for (int order = 0; order < 2; ++order) {
        fw_scene *scene = empty_scene(INFINITY);
        const fw_vec2 floors[2][2] = {{{-100, 0}, {3.5, 0}}, {{3.5, 0}, {100, 0}}};
        int all[24];
        for (int i = 0; i < 24; ++i) all[i] = i;
        add_body(scene, (body_options){.columns = 8, .rows = 3, .mu = 0.97});
        for (int w = 0; w < 2; ++w) {
            fw_wall_def def = fw_wall_def_default();
            def.name = w == order ? "left" : "right";
            def.shape = FW_CHAIN;
            def.points = floors[w == order ? 0 : 1];
            def.point_count = 2;
            def.surface = (fw_surface){.law = FW_COULOMB, .friction = 0.3};
            must(fw_scene_add_wall(scene, &def, &error));
        }
        const fw_load_def weight = {.kind = FW_LOAD_ACCELERATION,
                                    .particles = all,
                                    .particle_count = 24,
                                    .vector = {0, -2e-4},
                                    .until = INT64_MAX};
        fw_load_def pull = weight;
        pull.vector = (fw_vec2){5e-5, 0};
        pull.from = 100;
        must(fw_scene_add_load(scene, 0, &weight, &error));
        must(fw_scene_add_load(scene, 0, &pull, &error));
        begin(scene);
        run(scene, 8000);
        const fw_solid *solid = fw_scene_observe_body(scene, 0);
        fw_vec2 settled[8];
        for (int i = 0; i < 8; ++i) settled[i] = fw_solid_position(solid, i);
        run(scene, 10000);
        for (int i = 0; i < 8; ++i) {
            assert_close(fw_solid_position(solid, i).x, settled[i].x, 0);
            assert_close(fw_solid_position(solid, i).y, settled[i].y, 0);
        }
        assert_energy_closes(scene, 1e-10);
        place[order] = settled[7].x;
        fw_scene_destroy(scene);
    }
    assert_close(place[0], place[1], 0);
}

static fw_scene *shaken_beams(void)
{
    return two_surfaces(12, fw_friction_of(0.3, 0.3),
                        (fw_path){.amplitude = {0.1, 0}, .period = 400});
}

static void friction_that_goes_on_elsewhere_has_the_same_bytes(void **state)
{
    (void)state;
    assert_goes_on_elsewhere(shaken_beams, 600, 173, 197);
}

/* Bodies that strike each other at any angle: energy only falls, and is heat. */
static void assert_only_takes(fw_friction friction, double part, double most)
{
    const fw_friction pairs[4] = {{0, 0}, friction, friction, {0, 0}};
    double unconverged = 0, ticks = 0, overstep = 0;
    for (uint32_t n = 0; n < 60; ++n) {
        const fw_vec2 a = fw_noise_uniform(7, n, 0, 0), b = fw_noise_uniform(7, n, 1, 0);
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6,
                                       .rows = 5,
                                       .angle = 3 * b.x,
                                       .velocity = {0.15 + 0.1 * b.y, 0.1 * a.x}});
        add_body(scene, (body_options){
                            .columns = 7, .rows = 7, .origin = {12, -4 + 3 * a.y}, .angle = a.x});
        must(fw_scene_set_surfaces(scene, 2, pairs, (int[]){0, 1}, &error));
        begin(scene);
        const fw_vec2 momentum = fw_scene_momentum(scene);
        double before = energy_of(scene);
        const double start = before;
        for (int t = 0; t < 160; ++t) {
            run(scene, 1);
            assert_true(energy_of(scene) <= before + 1e-13 * start);
            before = energy_of(scene);
        }
        const fw_vec2 after = fw_scene_momentum(scene);
        assert_close(after.x, momentum.x, 1e-12);
        assert_close(after.y, momentum.y, 1e-12);
        assert_close(before + fw_scene_contact_ledger(scene)->heat, start, 1e-12 * start);
        assert_true(fw_scene_body_penetration(scene) < 1e-9);
        unconverged += fw_scene_contact_ledger(scene)->unconverged;
        ticks += fw_scene_contact_ledger(scene)->ticks;
        overstep = fmax(overstep, fw_scene_contact_ledger(scene)->overstep);
        fw_scene_destroy(scene);
    }
    print_message("%g, %g: %g of %g ticks not converged, overstep %g\n", friction.at_rest,
                  friction.kinetic, unconverged, ticks, overstep);
    assert_true(ticks > 200);
    assert_true(unconverged < part * ticks);
    assert_true(overstep < most);
}

static void friction_never_feeds(void **state)
{
    (void)state;
    assert_only_takes((fw_friction){0.3, 0.3}, 0.01, 0.02);
    assert_only_takes((fw_friction){1, 1}, 0.01, 0.02);
    assert_only_takes((fw_friction){0.3, 0.6}, 0.01, 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_sticks_does_not_creep),
        cmocka_unit_test(what_slides_obeys_the_cone),
        cmocka_unit_test(what_lies_on_a_floor_does_not_creep),
        cmocka_unit_test(what_sticks_bears_more_than_what_slides),
        cmocka_unit_test(friction_that_goes_on_elsewhere_has_the_same_bytes),
        cmocka_unit_test(friction_never_feeds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
