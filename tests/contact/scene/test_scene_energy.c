/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scene_energy.c - a scene whose energy leaves its ledger is stopped; no other is. */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/automaton/elastic_automaton.h"
#include "core/particles/particles.h"

#include <string.h>

static fw_scene *scene_with(fw_solid *solid)
{
    fw_scene *scene;
    int body;
    assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
    assert_int_equal(fw_scene_adopt_body(scene, "body", solid, &body, NULL), FW_OK);
    assert_int_equal(fw_scene_begin(scene, NULL), FW_OK);
    return scene;
}

/* Two particles thrown at each other. The step follows their collision as long as the bond is soft
 * enough where they turn back, U = m v^2. */
static fw_scene *collision(double speed)
{
    const fw_vec2 positions[] = {{0, 0}, {3.01, 0}}, velocities[] = {{speed, 0}, {-speed, 0}};
    fw_particle_group_def group = fw_particle_group_def_default();
    group.name = "pair";
    group.count = 2;
    group.positions = positions;
    group.velocities = velocities;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    return scene_with(solid);
}

static fw_status run(fw_scene *scene, int steps, fw_error *error)
{
    fw_status status = FW_OK;
    for (int step = 0; step < steps && status == FW_OK; ++step) {
        status = fw_scene_step(scene, error);
        if (status == FW_OK) status = fw_scene_check_energy(scene, error);
    }
    return status;
}

static void a_collision_that_the_step_follows_runs(void **state)
{
    (void)state;
    const double speeds[] = {0, 1, 5, 10};
    for (int n = 0; n < 4; ++n) {
        fw_error error = {0};
        fw_scene *scene = collision(speeds[n]);
        if (run(scene, 2000, &error) != FW_OK) fail_msg("%s", error.sentence);
        /* In the well, of depth 1, the kinetic energy is larger by 1 and the elastic one -1. */
        const double energy = speeds[n] * speeds[n];
        assert_true(fw_scene_energy_scale(scene) >= energy * (1 - 1e-12));
        assert_below(fw_scene_energy_scale(scene), 1.2 * energy + 2.1);
        fw_scene_destroy(scene);
    }
}

static void a_collision_that_explodes_is_stopped(void **state)
{
    (void)state;
    fw_error error = {0};
    fw_scene *scene = collision(150);
    assert_int_equal(run(scene, 2000, &error), FW_DIVERGED);
    assert_non_null(strstr(error.sentence, "the ledger of work and heat has 22500"));
    fw_scene_destroy(scene);
}

/* The boundary rule `mirror` keeps no energy, and is not expected to. */
static void what_conserves_nothing_may_run(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 4, 4, NULL), FW_OK);
    for (int mirror = 0; mirror < 2; ++mirror) {
        fw_vec2 velocity[16];
        for (int p = 0; p < 16; ++p) velocity[p] = (fw_vec2){p == 5 ? 0.1 : 0, 0};
        fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
        def.sites = &sites;
        def.boundary = mirror ? FW_BOUNDARY_MIRROR : FW_BOUNDARY_BOND;
        def.velocity = velocity;
        fw_solid *solid;
        fw_error error = {0};
        assert_int_equal(fw_elastic_automaton_create(&solid, &def, &error), FW_OK);
        assert_true(solid->conserves == !mirror);
        fw_scene *scene = scene_with(solid);
        if (run(scene, 500, &error) != FW_OK) fail_msg("%s", error.sentence);
        fw_scene_destroy(scene);
    }
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_collision_that_the_step_follows_runs),
        cmocka_unit_test(a_collision_that_explodes_is_stopped),
        cmocka_unit_test(what_conserves_nothing_may_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
