/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_bodies.c - bodies against bodies: what collisions must keep, and what they must not do. */
#include "tests/support/pistons.h"

#include "core/particles/linear_lattice.h"

#include <omp.h>

typedef struct sums {
    double energy;
    fw_vec2 momentum;
} sums;

static sums sums_of(const fw_scene *scene)
{
    return (sums){energy_of(scene), fw_scene_momentum(scene)};
}

static double apart(sums before, sums after)
{
    const fw_vec2 change = fw_vec2_subtract(after.momentum, before.momentum);
    return fmax(fabs(after.energy / before.energy - 1), fmax(fabs(change.x), fabs(change.y)));
}

/* A chain along x. */
static void add_chain(fw_scene *scene, int count, double x, double velocity)
{
    add_body(scene, (body_options){
                        .columns = count, .rows = 1, .origin = {x, 0}, .velocity = {velocity, 0}});
}

static void equal_chains_swap_velocities(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_chain(scene, 10, 0, 0.1);
    add_chain(scene, 10, 9.55, 0);
    begin(scene);
    const sums before = sums_of(scene);
    run(scene, 400);
    assert_true(apart(before, sums_of(scene)) < 1e-12);
    assert_true(fabs(velocity_of(scene, 0).x) < 1e-12);
    assert_true(fabs(velocity_of(scene, 1).x - 0.1) < 1e-12);
    fw_scene_destroy(scene);
}

/* The wave in the short one comes back when its end stands still: 2 * 4 / 38 of the long one. */
static void short_chain_stops_at_long_one(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_chain(scene, 5, 0, 0.1);
    add_chain(scene, 20, 4.33, 0);
    begin(scene);
    run(scene, 400);
    assert_true(fabs(velocity_of(scene, 0).x) < 1e-12);
    assert_true(fabs(velocity_of(scene, 1).x - 0.4 / 19) < 1e-12);
    fw_scene_destroy(scene);
}

/* Where the gap at which they land is small beside the way of a step. */
static double restitution(double offset)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 10, .rows = 10, .velocity = {0.1, 0}});
    add_body(scene, (body_options){.columns = 10, .rows = 10, .origin = {9.501, offset}});
    begin(scene);
    const sums before = sums_of(scene);
    run(scene, 60);
    assert_true(apart(before, sums_of(scene)) < 1e-12);
    assert_true(fw_scene_contact_ledger(scene)->ticks > 5);
    assert_true(fw_scene_contact_ledger(scene)->unconverged == 0);
    assert_true(fw_scene_body_penetration(scene) == 0);
    const double left = velocity_of(scene, 1).x - velocity_of(scene, 0).x;
    fw_scene_destroy(scene);
    return left / 0.1;
}

static void sheets_bounce_as_the_reference_does(void **state)
{
    (void)state;
    assert_true(fabs(restitution(0) - 0.940142) < 1e-3);
    assert_true(fabs(restitution(0.37) - 0.938822) < 1e-3);
}

static void add_room(fw_scene *scene, fw_vec2 low, fw_vec2 high, fw_surface surface)
{
    const fw_vec2 corners[] = {low, high};
    fw_wall_def def = fw_wall_def_default();
    def.name = "room";
    def.points = corners;
    def.surface = surface;
    must(fw_scene_add_wall(scene, &def, &error));
}

/* Three blocks of any shape in a room: walls and other bodies on the same particles. */
static fw_scene *crowded_room(fw_surface surface)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene,
             (body_options){.columns = 6, .rows = 6, .origin = {1, 1}, .velocity = {0.03, 0.11}});
    add_body(scene, (body_options){.columns = 5,
                                   .rows = 7,
                                   .origin = {9.2, 2.3},
                                   .velocity = {-0.09, 0.02},
                                   .rest_mass = 1});
    add_body(
        scene,
        (body_options){
            .columns = 8, .rows = 3, .origin = {6, 11.5}, .velocity = {0.04, -0.13}, .angle = 0.3});
    add_room(scene, (fw_vec2){0, 0}, (fw_vec2){15, 16}, surface);
    begin(scene);
    return scene;
}

static void bodies_in_a_room_stay_in_it_and_out_of_each_other(void **state)
{
    (void)state;
    const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                   {.law = FW_STICK},
                                   {.law = FW_COULOMB, .friction = 0.4},
                                   {.law = FW_PENALTY, .stiffness = 0.3}};
    for (int n = 0; n < 4; ++n) {
        fw_scene *scene = crowded_room(surfaces[n]);
        for (int t = 0; t < 2000; ++t) {
            run(scene, 1);
            assert_true(fw_scene_body_penetration(scene) == 0);
            if (n < 3) assert_true(fw_scene_penetration(scene, -1) < 1e-13);
        }
        assert_true(fw_scene_contact_ledger(scene)->ticks > 100);
        assert_true(fw_scene_contact_ledger(scene)->unconverged <= 2);
        assert_ledger_closes(scene, 1e-11);
        assert_action_is_reaction(scene, 3, 1e-11);
        fw_scene_destroy(scene);
    }
}

static fw_scene *frictionless_room(void)
{
    return crowded_room((fw_surface){.law = FW_FRICTIONLESS});
}

/* Whatever the fat boxes and lists of candidates were. */
static void run_that_goes_on_elsewhere_has_the_same_bytes(void **state)
{
    (void)state;
    assert_goes_on_elsewhere(frictionless_room, 700, 60, 91);
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    uint64_t hash[3];
    const int before = omp_get_max_threads();
    for (int n = 0; n < 3; ++n) {
        fw_scene *scene = empty_scene(1e4);
        omp_set_num_threads(n + 1);
        add_body(scene, (body_options){.columns = 160, .rows = 120, .velocity = {0.1, 0}});
        add_body(scene, (body_options){.columns = 150, .rows = 130, .origin = {159.37, -20.3}});
        begin(scene);
        run(scene, 60);
        assert_true(fw_scene_contact_ledger(scene)->ticks > 20);
        hash[n] = hash_of_scene(scene);
        fw_scene_destroy(scene);
    }
    omp_set_num_threads(before);
    assert_true(hash[0] == hash[1] && hash[0] == hash[2]);
}

/* A ball in a frame: what holds it is the inner edge. */
static void body_in_the_hole_of_another_stays_there(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    fw_sites sites;
    must(fw_sites_mask(&sites,
                       "##########\n##########\n##......##\n##......##\n##......##\n"
                       "##......##\n##......##\n##......##\n##########\n##########\n",
                       &error));
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    fw_solid *frame;
    int body;
    must(fw_lb_solid_create(&frame, &def, &error));
    must(fw_scene_adopt_body(scene, "frame", frame, &body, &error));
    fw_sites_clear(&sites);
    add_body(
        scene,
        (body_options){
            .columns = 4, .rows = 4, .origin = {2.6, 3.1}, .velocity = {0.21, 0.17}, .angle = 0.2});
    begin(scene);
    const sums before = sums_of(scene);
    run(scene, 3000);
    assert_true(apart(before, sums_of(scene)) < 1e-11);
    assert_true(fw_scene_body_penetration(scene) == 0);
    const fw_vec2 ball =
        fw_scene_observe_body(scene, 1)->model->centre_of_mass(fw_scene_observe_body(scene, 1));
    const fw_vec2 hole = frame->model->centre_of_mass(frame);
    assert_true(fabs(ball.x - hole.x) < 2.5 && fabs(ball.y - hole.y) < 2.5);
    fw_scene_destroy(scene);
}

/* A block with a notch that broken links have opened, and a chain that flies into it. */
static void links_that_break_open_the_way(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    fw_sites sites;
    must(fw_sites_rectangle(&sites, 8, 8, &error));
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_vec2 velocity[64];
    for (int l = 0; l < 64; ++l) velocity[l] = (fw_vec2){l % 8 < 4 ? -0.2 : 0.2, 0};
    def.sites = &sites;
    def.velocity = velocity;
    def.break_at = 0.3;
    fw_solid *block;
    int body;
    must(fw_lb_solid_create(&block, &def, &error));
    must(fw_scene_adopt_body(scene, "block", block, &body, &error));
    fw_sites_clear(&sites);
    add_body(scene,
             (body_options){.columns = 2, .rows = 3, .origin = {3.2, 9.5}, .velocity = {0, -0.25}});
    begin(scene);
    run(scene, 60);
    assert_true(fw_lb_solid_broken(block) > 0);
    const fw_solid *small = fw_scene_observe_body(scene, 1);
    assert_true(small->y[0] < 5); /* it is in the gap between the halves */
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_ledger_closes(scene, 1e-11);
    fw_scene_destroy(scene);
}

/* Held by a grip below, and hit from above on what the grip holds. */
static void grips_bear_what_hits_them(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 6, .rows = 2});
    add_body(scene,
             (body_options){.columns = 4, .rows = 4, .origin = {0.7, 3}, .velocity = {0.02, -0.1}});
    int held[6];
    for (int n = 0; n < 6; ++n) held[n] = 6 + n;
    const fw_grip_def def = {.name = "clamp",
                             .particles = held,
                             .particle_count = 6,
                             .drive = {.prescribed_x = true, .prescribed_y = true}};
    must(fw_scene_add_grip(scene, 0, &def, &error));
    begin(scene);
    run(scene, 300);
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_true(velocity_of(scene, 1).y > 0.05);
    assert_ledger_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

static void linear_lattices_meet(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    fw_sites sites;
    must(fw_sites_rectangle(&sites, 7, 7, &error));
    for (int n = 0; n < 2; ++n) {
        fw_vec2 velocity[49];
        for (int l = 0; l < 49; ++l) velocity[l] = (fw_vec2){n == 0 ? 1 : -1, 0};
        fw_linear_lattice_def def = fw_linear_lattice_def_default();
        def.sites = &sites;
        def.velocities = velocity;
        def.lattice =
            (fw_lattice){.kind = FW_HEXAGONAL, .spacing = 1, .origin = {8.3 * n, 0.4 * n}};
        fw_solid *solid;
        int body;
        must(fw_linear_lattice_create(&solid, &def, &error));
        must(fw_scene_adopt_body(scene, n == 0 ? "left" : "right", solid, &body, &error));
    }
    fw_sites_clear(&sites);
    begin(scene);
    const sums before = sums_of(scene);
    run(scene, 800);
    const sums after = sums_of(scene);
    assert_true(fw_scene_contact_ledger(scene)->ticks > 10);
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_true(velocity_of(scene, 0).x < -0.3);
    assert_true(fabs(after.energy / before.energy - 1) < 1e-3); /* Verlet's own */
    assert_close(after.momentum.x, before.momentum.x, 1e-11);
    assert_close(after.momentum.y, before.momentum.y, 1e-11);
    fw_scene_destroy(scene);
}

/* Floor, block, block, piston: each passes on what the piston's force is. */
static void piston_presses_bodies_on_each_other(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 10, .rows = 5, .origin = {0, 0.1}, .mu = 0.95});
    add_body(scene, (body_options){.columns = 6, .rows = 4, .origin = {1.3, 4.3}, .mu = 0.95});
    add_room(scene, (fw_vec2){-5, 0}, (fw_vec2){15, 30}, smooth);
    const fw_piston_def piston = {.mass = 20, .drive = {.prescribed_x = true, .force = {0, -0.2}}};
    add_block(scene, "press", (fw_vec2){-1, 7.5}, (fw_vec2){11, 9}, smooth, &piston);
    begin(scene);
    for (int t = 0; t < 4000; ++t) {
        run(scene, 1);
        assert_true(fw_scene_body_penetration(scene) == 0);
        assert_true(fw_scene_penetration(scene, -1) < 1e-13);
    }
    assert_ledger_balances(scene, 1e-11);
    assert_close(fw_scene_body_ledger(scene, 0, 0)->reaction.y, -0.2, 1e-6);
    assert_close(fw_scene_body_ledger(scene, 1, 0)->reaction.y, 0.2, 1e-6);
    assert_close(fw_scene_wall_ledger(scene, 0)->reaction.y, 0.2, 1e-6);
    assert_true(motion_fits(scene, 1));
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_chains_swap_velocities),
        cmocka_unit_test(short_chain_stops_at_long_one),
        cmocka_unit_test(sheets_bounce_as_the_reference_does),
        cmocka_unit_test(bodies_in_a_room_stay_in_it_and_out_of_each_other),
        cmocka_unit_test(run_that_goes_on_elsewhere_has_the_same_bytes),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(body_in_the_hole_of_another_stays_there),
        cmocka_unit_test(links_that_break_open_the_way),
        cmocka_unit_test(grips_bear_what_hits_them),
        cmocka_unit_test(linear_lattices_meet),
        cmocka_unit_test(piston_presses_bodies_on_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
