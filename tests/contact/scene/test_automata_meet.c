/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automata_meet.c - elastic automata against each other: what holds is said of whole steps, of
 * two half-steps each. */
#include "tests/support/scenes.h"

#include "core/automaton/elastic_automaton.h"
#include "core/noise.h"

#include <omp.h>

typedef struct cells {
    int columns, rows;
    fw_vec2 origin, velocity;
    double angle, break_at, reflection;
    fw_automaton_speeds speeds; /* Chopard's where 0 */
} cells;

static fw_solid *add_cells(fw_scene *scene, cells o)
{
    fw_sites sites;
    must(fw_sites_rectangle(&sites, o.columns, o.rows, &error));
    fw_vec2 *velocity = malloc((size_t)sites.count * sizeof *velocity);
    for (int l = 0; l < sites.count; ++l) velocity[l] = o.velocity;
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.velocity = velocity;
    def.lattice.origin = o.origin;
    def.lattice.angle = o.angle;
    if (o.speeds.transverse > 0) def.speeds = o.speeds;
    if (o.break_at > 0) def.break_at = o.break_at;
    if (o.reflection > 0) def.reflection = o.reflection;
    fw_solid *solid;
    int body;
    must(fw_elastic_automaton_create(&solid, &def, &error));
    must(fw_scene_adopt_body(scene, "cells", solid, &body, &error));
    free(velocity);
    fw_sites_clear(&sites);
    return solid;
}

/* A wave in a line: the left one stops, whichever colours meet. */
static void equal_chains_swap_velocities(void **state)
{
    (void)state;
    for (int count = 9; count < 11; ++count) {
        fw_scene *scene = empty_scene(1e4);
        add_cells(scene,
                  (cells){.columns = count, .rows = 1, .origin = {0, 0}, .velocity = {0.1, 0}});
        add_cells(
            scene,
            (cells){.columns = count, .rows = 1, .origin = {count - 0.45, 0}, .velocity = {0, 0}});
        begin(scene);
        run(scene, 300);
        assert_close(velocity_of(scene, 0).x, 0, 1e-12);
        assert_close(velocity_of(scene, 1).x, 0.1, 1e-12);
        assert_ledger_closes(scene, 1e-12);
        assert_close(fw_scene_body_ledger(scene, 1, 0)->impulse.x,
                     fw_solid_momentum(fw_scene_observe_body(scene, 1)).x, 1e-13);
        fw_scene_destroy(scene);
    }
}

/* The edge of a body that moves is ragged by half of its way in a step, for white cells are ahead
 * of black ones; bodies that move as one, that far apart, do not feel it. */
static void what_moves_together_does_not_touch(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_cells(scene, (cells){.columns = 6, .rows = 6, .origin = {0, 0}, .velocity = {0.3, 0.1}});
    add_cells(scene,
              (cells){.columns = 6, .rows = 6, .origin = {5.301, 0.37}, .velocity = {0.3, 0.1}});
    begin(scene);
    run(scene, 200);
    assert_true(fw_scene_contact_ledger(scene)->ticks == 0);
    fw_scene_destroy(scene);
}

static void add_room(fw_scene *scene, fw_vec2 low, fw_vec2 high, fw_surface surface, fw_path path)
{
    const fw_vec2 corners[] = {low, high};
    fw_wall_def def = fw_wall_def_default();
    def.name = "room";
    def.points = corners;
    def.surface = surface;
    def.path = path;
    must(fw_scene_add_wall(scene, &def, &error));
}

static fw_scene *crowded_room(fw_surface surface, fw_path path)
{
    fw_scene *scene = empty_scene(1e4);
    add_cells(scene, (cells){.columns = 6, .rows = 6, .origin = {1, 1}, .velocity = {0.03, 0.11}});
    add_cells(scene, (cells){.columns = 5,
                             .rows = 7,
                             .origin = {9.2, 2.3},
                             .velocity = {-0.09, 0.02},
                             .speeds = {1.0, 0.6}});
    add_cells(
        scene,
        (cells){
            .columns = 8, .rows = 3, .origin = {6, 11.5}, .velocity = {0.04, -0.13}, .angle = 0.3});
    add_room(scene, (fw_vec2){0, 0}, (fw_vec2){15, 16}, surface, path);
    begin(scene);
    return scene;
}

static void bodies_in_a_room_stay_in_it_and_out_of_each_other(void **state)
{
    (void)state;
    const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                   {.law = FW_STICK},
                                   {.law = FW_COULOMB, .friction = 0.4},
                                   {.law = FW_PENALTY, .stiffness = 0.2}};
    for (int n = 0; n < 4; ++n) {
        fw_scene *scene = crowded_room(surfaces[n], fw_wall_def_default().path);
        for (int t = 0; t < 1500; ++t) {
            run(scene, 1);
            assert_true(fw_scene_body_penetration(scene) == 0);
            if (n < 3) assert_true(fw_scene_penetration(scene, -1) < 1e-13);
        }
        assert_true(fw_scene_contact_ledger(scene)->ticks > 50);
        assert_true(fw_scene_contact_ledger(scene)->unconverged <= 2);
        assert_ledger_closes(scene, 1e-11);
        assert_action_is_reaction(scene, 3, 1e-11);
        fw_scene_destroy(scene);
    }
}

/* A cell that rests lets a moving wall pass by half of its way; ledgers close all the same. */
static void bodies_in_a_room_that_shakes_keep_the_ledger(void **state)
{
    (void)state;
    fw_path path = fw_wall_def_default().path;
    path.amplitude = (fw_vec2){0.6, 0.3};
    path.period = 90;
    fw_scene *scene = crowded_room((fw_surface){.law = FW_FRICTIONLESS}, path);
    for (int t = 0; t < 1500; ++t) {
        run(scene, 1);
        assert_true(fw_scene_body_penetration(scene) == 0);
        assert_true(fw_scene_penetration(scene, -1) < 0.05);
    }
    assert_true(fw_scene_contact_ledger(scene)->ticks > 50);
    assert_ledger_closes(scene, 1e-11);
    fw_scene_destroy(scene);
}

/* A bond that breaks between the half-steps of a contact takes what work the force does then. */
static void bodies_that_break_each_other_keep_the_ledger(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    fw_solid *left = add_cells(
        scene,
        (cells){
            .columns = 8, .rows = 8, .origin = {0, 0}, .velocity = {0.3, 0.02}, .break_at = 0.09});
    fw_solid *right = add_cells(scene, (cells){.columns = 8,
                                               .rows = 8,
                                               .origin = {8.6, 3.3},
                                               .velocity = {0, 0},
                                               .break_at = 0.06,
                                               .angle = 0.2});
    begin(scene);
    for (int t = 0; t < 200; ++t) {
        run(scene, 1);
        assert_ledger_closes(scene, 1e-12);
    }
    assert_true(fw_elastic_automaton_broken(left) + fw_elastic_automaton_broken(right) > 10);
    fw_scene_destroy(scene);
}

static void damped_bodies_keep_the_ledger(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_cells(scene, (cells){.columns = 8,
                             .rows = 8,
                             .origin = {0, 0},
                             .velocity = {0.2, 0.02},
                             .reflection = 0.98});
    add_cells(scene, (cells){.columns = 8,
                             .rows = 8,
                             .origin = {8.6, 1.3},
                             .velocity = {0, 0},
                             .reflection = 0.9,
                             .angle = 0.2});
    begin(scene);
    run(scene, 300);
    assert_true(fw_scene_contact_ledger(scene)->ticks > 5);
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_ledger_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

static void friction_only_takes_energy(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_cells(scene, (cells){.columns = 9, .rows = 8, .origin = {0, 0}, .velocity = {0.2, 0.15}});
    add_cells(scene, (cells){.columns = 8, .rows = 8, .origin = {8.6, 1.3}, .velocity = {0, 0}});
    fw_scene_set_friction(scene, 0.3);
    begin(scene);
    double before = energy_of(scene);
    for (int t = 0; t < 300; ++t) {
        run(scene, 1);
        const double now = energy_of(scene);
        assert_true(now <= before + 1e-13 * fw_scene_energy_scale(scene));
        before = now;
    }
    assert_true(fw_scene_contact_ledger(scene)->heat > 1e-3 * fw_scene_energy_scale(scene));
    assert_true(fw_scene_body_penetration(scene) == 0);
    assert_ledger_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

/* At any angle, and with any coefficient: energy never rises, and the law holds. */
static void friction_of_random_collisions_settles(void **state)
{
    (void)state;
    const fw_friction laws[] = {{0.3, 0.3}, {1, 1}, {0.3, 0.6}};
    double ticks = 0, unconverged = 0;
    for (uint32_t n = 0; n < 60; ++n) {
        const fw_vec2 a = fw_noise_uniform(7, n, 0, 0), b = fw_noise_uniform(7, n, 1, 0);
        const fw_friction pairs[4] = {{0, 0}, laws[n % 3], laws[n % 3], {0, 0}};
        const bool turned = n % 2;
        fw_scene *scene = empty_scene(1e4);
        add_cells(scene, (cells){.columns = 6 + (int)n % 4,
                                 .rows = 5,
                                 .origin = {0, 0},
                                 .velocity = {0.2 + 0.1 * b.y, 0.1 * a.x},
                                 .angle = turned ? 0.2 * b.x : 0});
        add_cells(scene, (cells){.columns = 7,
                                 .rows = 7,
                                 .origin = {13, -4 + 3 * a.y},
                                 .velocity = {0, 0},
                                 .angle = turned ? a.x : 0});
        must(fw_scene_set_surfaces(scene, 2, pairs, (int[]){0, 1}, &error));
        begin(scene);
        double before = energy_of(scene);
        for (int t = 0; t < 120; ++t) {
            run(scene, 1);
            assert_true(energy_of(scene) <= before + 1e-13 * fw_scene_energy_scale(scene));
            before = energy_of(scene);
        }
        assert_ledger_closes(scene, 1e-12);
        assert_true(fw_scene_body_penetration(scene) == 0);
        assert_true(fw_scene_contact_ledger(scene)->overstep < 0.04);
        ticks += (double)fw_scene_contact_ledger(scene)->ticks;
        unconverged += (double)fw_scene_contact_ledger(scene)->unconverged;
        fw_scene_destroy(scene);
    }
    print_message("%g of %g steps not converged\n", unconverged, ticks);
    assert_true(ticks > 200);
    assert_true(unconverged < 0.01 * ticks);
}

static fw_scene *room_at_rest(void)
{
    return crowded_room((fw_surface){.law = FW_FRICTIONLESS}, fw_wall_def_default().path);
}

static void run_that_goes_on_elsewhere_has_the_same_bytes(void **state)
{
    (void)state;
    assert_goes_on_elsewhere(room_at_rest, 500, 60, 91);
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    uint64_t hash[3];
    const int before = omp_get_max_threads();
    for (int n = 0; n < 3; ++n) {
        fw_scene *scene = empty_scene(1e4);
        omp_set_num_threads(n + 1);
        add_cells(scene,
                  (cells){.columns = 200, .rows = 190, .origin = {0, 0}, .velocity = {0.1, 0}});
        add_cells(
            scene,
            (cells){.columns = 190, .rows = 200, .origin = {199.37, -20.3}, .velocity = {0, 0}});
        begin(scene);
        run(scene, 30);
        assert_true(fw_scene_contact_ledger(scene)->ticks > 10);
        hash[n] = hash_of_scene(scene);
        fw_scene_destroy(scene);
    }
    omp_set_num_threads(before);
    assert_true(hash[0] == hash[1] && hash[0] == hash[2]);
}

static void bodies_that_start_in_each_other_are_refused(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_cells(scene, (cells){.columns = 6, .rows = 6, .origin = {0, 0}, .velocity = {0, 0}});
    add_cells(scene, (cells){.columns = 6, .rows = 6, .origin = {4.3, 2.5}, .velocity = {0, 0}});
    assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "starts in body"));
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_chains_swap_velocities),
        cmocka_unit_test(what_moves_together_does_not_touch),
        cmocka_unit_test(bodies_in_a_room_stay_in_it_and_out_of_each_other),
        cmocka_unit_test(bodies_in_a_room_that_shakes_keep_the_ledger),
        cmocka_unit_test(bodies_that_break_each_other_keep_the_ledger),
        cmocka_unit_test(damped_bodies_keep_the_ledger),
        cmocka_unit_test(friction_only_takes_energy),
        cmocka_unit_test(friction_of_random_collisions_settles),
        cmocka_unit_test(run_that_goes_on_elsewhere_has_the_same_bytes),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(bodies_that_start_in_each_other_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
