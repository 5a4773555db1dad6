/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_contact.c - movable particles against hard walls: the hold rule for velocity Verlet
 * and for BAOAB with noise (Popov & Filippov's particles). */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/noise.h"
#include "tests/support/crowd.h"

#include <omp.h>
#include <string.h>

static fw_scene *scene_of(fw_solid *solid)
{
    fw_scene *scene;
    int body;
    assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
    assert_int_equal(fw_scene_adopt_body(scene, "body", solid, &body, NULL), FW_OK);
    return scene;
}

static void add_wall(fw_scene *scene, fw_wall_shape_kind shape, const fw_vec2 *points, int count,
                     double radius, fw_path path)
{
    fw_wall_def def = fw_wall_def_default();
    fw_error error;
    def.name = "wall";
    def.shape = shape;
    def.points = points;
    def.point_count = count;
    def.radius = radius;
    def.path = path;
    if (fw_scene_add_wall(scene, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
}

static void begin(fw_scene *scene)
{
    fw_error error;
    if (fw_scene_begin(scene, &error) != FW_OK) fail_msg("%s", error.sentence);
}

static void step(fw_scene *scene)
{
    fw_error error;
    if (fw_scene_step(scene, &error) != FW_OK) fail_msg("%s", error.sentence);
}

static double energy_of(const fw_scene *scene)
{
    const fw_energies e = fw_scene_energies(scene);
    return e.kinetic + e.elastic;
}

static void assert_momentum_is_booked(const fw_scene *scene, double tolerance)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    const fw_vec2 expected = fw_ledger_momentum(&ledger), p = fw_scene_momentum(scene);
    assert_close(p.x, expected.x, tolerance);
    assert_close(p.y, expected.y, tolerance);
}

static fw_solid *moving_disc(double radius, fw_vec2 origin, fw_vec2 velocity, double dt)
{
    fw_solid *solid = solid_of(crowd_disc(radius, origin, 0.17, 0, 3),
                               return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){.time_step = dt}, 1);
    fw_langevin *motion = (fw_langevin *)solid;
    for (int i = 0; i < solid->count; ++i) {
        motion->velocity_x[i] = velocity.x;
        motion->velocity_y[i] = velocity.y;
    }
    return solid;
}

/* --- one particle, one step --- */

/* A walker above a floor at 0 with velocity -v, so near that it would pass. With noise or without:
 * it stays to the last bit, its normal velocity is reversed exactly as it was before the step, and
 * the wall's force is -(2m/dt)[v1 + s xi/(1+c)]_n with v1 after the first kick. */
static void held_walker_turns_round(void **state)
{
    (void)state;
    const double dt = 0.02, mass = 1.7, v = 1.3, height = 1e-4;
    const double dampings[] = {0, 1, 25}, temperatures[] = {0, 0.6, 0.2};
    for (int n = 0; n < 3; ++n) {
        const fw_vec2 at = {0.3, height}, velocity = {0.4, -v};
        fw_particle_group_def group = fw_particle_group_def_default();
        group.count = 1;
        group.positions = &at;
        group.velocities = &velocity;
        group.mass = mass;
        fw_particles_def def = fw_particles_def_default();
        def.groups = &group;
        def.group_count = 1;
        def.controls = (fw_langevin_controls){dt, dampings[n], temperatures[n]};
        def.seed = 9;
        fw_solid *solid;
        assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
        fw_scene *scene = scene_of(solid);
        const fw_vec2 floor[] = {{-10, 0}, {10, 0}};
        add_wall(scene, FW_CHAIN, floor, 2, 0, (fw_path){0});
        begin(scene);
        step(scene);
        const fw_langevin *motion = (const fw_langevin *)solid;
        assert_true(solid->y[0] == height);
        assert_close(motion->velocity_y[0], v, 4e-15);
        const double c = exp(-dampings[n] * dt), s = sqrt((1 - c * c) * temperatures[n] / mass);
        const fw_vec2 xi =
            s > 0 ? fw_noise_gaussian(9, 0, 0, FW_NOISE_THERMOSTAT) : (fw_vec2){0, 0};
        const fw_vec2 force = fw_scene_wall_ledger(scene, 0)->force;
        assert_close(force.y, -2 * mass / dt * (-v + s * xi.y / (1 + c)), 1e-11);
        assert_close(force.x, 0, 0);
        /* Along the wall it goes on as if there were none. */
        assert_close(motion->velocity_x[0], c * 0.4 + s * xi.x, 1e-15);
        assert_momentum_is_booked(scene, 1e-14);
        fw_scene_destroy(scene);
    }
}

/* --- whole bodies --- */

/* In a box, in an oblique polygon and in a circle: nothing gets behind a wall, the ledger
 * has all momentum, and the energy error is Verlet's: a quarter for half the step. */
static void disc_bounces_with_verlets_energy(void **state)
{
    (void)state;
    const fw_vec2 box[] = {{0, 0}, {24, 24}};
    const fw_vec2 kite[] = {{-9, -4}, {31, -7}, {27, 25}, {-4, 31}};
    const fw_vec2 centre[] = {{12, 12}};
    const struct {
        fw_wall_shape_kind shape;
        const fw_vec2 *points;
        int count;
        double radius, depth;
    } walls[] = {{FW_BOX, box, 2, 0, 0},
                 {FW_POLYGON, kite, 4, 0, 3e-14}, /* 4 ulp of the coordinates */
                 {FW_CIRCLE, centre, 1, 12, 2e-14}};
    for (int w = 0; w < 3; ++w) {
        double worst[2];
        for (int fine = 0; fine < 2; ++fine) {
            const double dt = fine ? 0.0025 : 0.005;
            fw_scene *scene = scene_of(moving_disc(3, (fw_vec2){9, 13}, (fw_vec2){0.4, 0.27}, dt));
            add_wall(scene, walls[w].shape, walls[w].points, walls[w].count, walls[w].radius,
                     (fw_path){0});
            begin(scene);
            const double start = energy_of(scene);
            worst[fine] = 0;
            for (int t = 0; t < (fine ? 20000 : 10000); ++t) {
                step(scene);
                assert_true(fw_scene_penetration(scene, -1) <= walls[w].depth);
                if (t % 10 == 0) worst[fine] = fmax(worst[fine], fabs(energy_of(scene) - start));
            }
            assert_momentum_is_booked(scene, 1e-11);
            assert_true(fw_scene_wall_ledger(scene, 0)->held > 10);
            assert_int_equal(fw_scene_unresolved(scene), 0);
            fw_scene_destroy(scene);
        }
        print_message("wall %d: energy error %.2g at dt, %.2g at dt/2\n", w, worst[0], worst[1]);
        assert_below(worst[0], 4e-3); /* a thousandth of the kinetic energy at the start */
        assert_close(worst[1] / worst[0], 0.25, 0.04);
    }
}

/* A floor that rises under a resting disc throws it up: the work of the wall is the energy it has
 * gained, to Verlet's error; momentum is in the ledger exactly. */
static void rising_floor_does_work(void **state)
{
    (void)state;
    fw_scene *scene = scene_of(moving_disc(3, (fw_vec2){0, 6}, (fw_vec2){0, 0}, 0.005));
    const fw_vec2 floor[] = {{-50, 0}, {50, 0}};
    add_wall(scene, FW_CHAIN, floor, 2, 0, (fw_path){.velocity = {0, 0.4}, .from = 0, .until = 20});
    begin(scene);
    const double start = energy_of(scene);
    for (int t = 0; t < 5000; ++t) step(scene);
    const fw_ledger ledger = fw_scene_ledger(scene);
    assert_true(ledger.wall_work > 1);
    assert_close(energy_of(scene) - start, ledger.wall_work, 1e-3 * ledger.wall_work);
    assert_momentum_is_booked(scene, 1e-11);
    fw_scene_destroy(scene);
}

/* Under a load that lasts, R = [F(t) + F(t-1)]/2 is the weight in the mean, however F chatters. */
static void reaction_carries_the_weight(void **state)
{
    (void)state;
    fw_solid *solid = solid_of(crowd_rectangle(8, 4, (fw_vec2){0, 0}, 1, 0, 1),
                               return_force_of(6, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){.time_step = 0.005, .damping = 1}, 1);
    const int count = solid->count;
    fw_scene *scene = scene_of(solid);
    const fw_vec2 floor[] = {{-50, -1e-9}, {50, -1e-9}};
    int all[64];
    for (int i = 0; i < count; ++i) all[i] = i;
    const fw_load_def weight = {.kind = FW_LOAD_ACCELERATION,
                                .particles = all,
                                .particle_count = count,
                                .vector = {0, -0.1},
                                .until = INT64_MAX};
    add_wall(scene, FW_CHAIN, floor, 2, 0, (fw_path){0});
    assert_int_equal(fw_scene_add_load(scene, 0, &weight, NULL), FW_OK);
    begin(scene);
    for (int t = 0; t < 8000; ++t) step(scene);
    const double before = fw_scene_wall_ledger(scene, 0)->impulse.y;
    double spread = 0;
    for (int t = 0; t < 2000; ++t) {
        step(scene);
        spread = fmax(spread, fabs(fw_scene_wall_ledger(scene, 0)->reaction.y / (0.1 * count) - 1));
    }
    const double mean = (fw_scene_wall_ledger(scene, 0)->impulse.y - before) / (2000 * 0.005);
    assert_close(mean / (0.1 * count), 1, 1e-6);
    assert_below(spread, 1e-6);
    fw_scene_destroy(scene);
}

/* A liquid in a box: in time every particle comes to a wall, also those that began inside; nobody
 * gets out. The boundary of a body that flows is all its particles. */
static void nobody_leaves_a_boiling_box(void **state)
{
    (void)state;
    fw_solid *solid = solid_of(crowd_rectangle(10, 10, (fw_vec2){1, 1}, 1.1, 0, 1),
                               return_force_of(6, 0, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){0.005, 1, 1.5}, 1);
    fw_particles_draw_velocities(solid, -1, 1.5);
    fw_scene *scene = scene_of(solid);
    const fw_vec2 corners[] = {{0, 0}, {12.5, 11.5}};
    add_wall(scene, FW_BOX, corners, 2, 0, (fw_path){0});
    begin(scene);
    bool touched[100] = {false};
    int met = 0;
    double x[100], y[100];
    for (int t = 0; t < 20000; ++t) {
        step(scene);
        assert_true(fw_scene_penetration(scene, -1) == 0);
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        fw_scene_add_contact_forces(scene, 0, x, y);
        for (int i = 0; i < 100; ++i)
            if (!touched[i] && (x[i] != 0 || y[i] != 0)) {
                touched[i] = true;
                met += 1;
            }
    }
    print_message("%d of 100 particles met a wall\n", met);
    assert_true(met > 80);
    assert_momentum_is_booked(scene, 1e-9);
    fw_scene_destroy(scene);
}

/* With noise, walls and more particles than one thread takes at a time: the same bytes. */
static uint64_t hash_after(int threads)
{
    omp_set_num_threads(threads);
    fw_solid *solid = solid_of(crowd_rectangle(80, 64, (fw_vec2){0.1, 0.1}, 1, 0, 1),
                               return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){0.005, 1, 0.4}, 1);
    fw_particles_draw_velocities(solid, -1, 0.4);
    fw_scene *scene = scene_of(solid);
    const fw_vec2 corners[] = {{0, 0}, {80.5, 56}};
    add_wall(scene, FW_BOX, corners, 2, 0, (fw_path){0});
    begin(scene);
    for (int t = 0; t < 60; ++t) step(scene);
    assert_true(fw_scene_wall_ledger(scene, 0)->held > 20);
    uint64_t hash = fingerprint(solid);
    fw_state_list list = {0};
    fw_scene_section(scene, 0, &list);
    hash = hash * 31 + fw_state_list_hash(&list);
    fw_scene_destroy(scene);
    return hash;
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    const uint64_t one = hash_after(1);
    assert_true(one == hash_after(2));
    assert_true(one == hash_after(3));
    omp_set_num_threads(1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(held_walker_turns_round),
        cmocka_unit_test(disc_bounces_with_verlets_energy),
        cmocka_unit_test(rising_floor_does_work),
        cmocka_unit_test(reaction_carries_the_weight),
        cmocka_unit_test(nobody_leaves_a_boiling_box),
        cmocka_unit_test(threads_do_not_change_a_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
