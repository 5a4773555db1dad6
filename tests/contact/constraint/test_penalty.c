/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_penalty.c - soft walls: whatever touches them, energy is kept exactly, and the ledger says
 * what the wall holds of it. */
#include "tests/support/laws.h"

#include "contact/constraint/penalty.h"
#include "contact/scene/scene.h"
#include "core/boltzmann/lb_solid.h"
#include "core/noise.h"
#include "tests/support/crowd.h"

#include <string.h>

static fw_scene *empty_scene(void)
{
    fw_scene *scene;
    assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
    return scene;
}

static void add_sheet(fw_scene *scene, int columns, int rows, fw_vec2 origin, fw_vec2 velocity,
                      fw_sym2 rest_mass)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    fw_vec2 *velocities = malloc((size_t)sites.count * sizeof *velocities);
    for (int l = 0; l < sites.count; ++l) velocities[l] = velocity;
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    def.lattice.origin = origin;
    def.velocity = velocities;
    def.rest_mass = rest_mass;
    fw_solid *solid;
    int body;
    assert_int_equal(fw_lb_solid_create(&solid, &def, NULL), FW_OK);
    assert_int_equal(fw_scene_adopt_body(scene, "sheet", solid, &body, NULL), FW_OK);
    free(velocities);
    fw_sites_clear(&sites);
}

static fw_wall_def soft_wall(fw_wall_shape_kind shape, const fw_vec2 *points, int count,
                             double radius, fw_side side, double stiffness)
{
    fw_wall_def def = fw_wall_def_default();
    def.name = "soft";
    def.shape = shape;
    def.points = points;
    def.point_count = count;
    def.radius = radius;
    def.side = side;
    def.surface = (fw_surface){.law = FW_PENALTY, .stiffness = stiffness};
    return def;
}

static void add_wall(fw_scene *scene, const fw_wall_def *def)
{
    fw_error error;
    if (fw_scene_add_wall(scene, def, &error) != FW_OK) fail_msg("%s", error.sentence);
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

/* --- springs alone --- */

/* F . w = V(before) - V(after) for any path, along the normals alone. Both ends of a path are drawn
 * near the surface, so that every way of crossing it occurs. */
static void force_does_the_work_that_the_spring_gives(void **state)
{
    (void)state;
    const fw_vec2 corners[] = {{0, 0}, {1, 1}}, centre[] = {{0.5, 0.5}};
    const fw_vec2 triangle[] = {{0, 0}, {1, 0.1}, {0.3, 1}};
    const fw_wall_def defs[] = {soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, 3),
                                soft_wall(FW_POLYGON, triangle, 3, 0, FW_INSIDE, 3),
                                soft_wall(FW_CIRCLE, centre, 1, 0.4, FW_INSIDE, 3),
                                soft_wall(FW_CIRCLE, centre, 1, 0.4, FW_OUTSIDE, 3)};
    for (int d = 0; d < 4; ++d) {
        fw_wall *wall;
        assert_int_equal(fw_wall_create(&wall, 0, &defs[d], NULL), FW_OK);
        int pushed = 0;
        for (int n = 0; n < 20000; ++n) {
            const fw_vec2 a = fw_noise_uniform(5, (uint32_t)n, (uint64_t)d, 1);
            const fw_vec2 b = fw_noise_uniform(5, (uint32_t)n, (uint64_t)d, 2);
            const fw_vec2 from = {0.5 + 0.8 * a.x, 0.5 + 0.8 * a.y};
            const fw_vec2 to = {from.x + 0.2 * b.x, from.y + 0.2 * b.y};
            const fw_vec2 force = fw_penalty_force(wall, from, to);
            const double given = fw_penalty_energy(wall, from) - fw_penalty_energy(wall, to);
            assert_close(fw_vec2_dot(force, fw_vec2_subtract(to, from)), given, 1e-14);
            pushed += force.x != 0 || force.y != 0;
            if (fw_wall_facet(wall, 0)->kind != FW_ROUND) continue;
            /* No torque about the centre at the middle of the path. */
            const fw_vec2 middle = fw_vec2_scale(0.5, fw_vec2_add(from, to));
            assert_close(fw_vec2_cross(fw_vec2_subtract(middle, centre[0]), force), 0, 1e-15);
        }
        assert_true(pushed > 3000);
        fw_wall_destroy(wall);
    }
}

/* Of an obstacle the nearest side's spring acts; where that side stays the same, it is exact. */
static void obstacle_pushes_to_its_nearest_side(void **state)
{
    (void)state;
    const fw_vec2 corners[] = {{0, 0}, {4, 2}};
    const fw_wall_def def = soft_wall(FW_BOX, corners, 2, 0, FW_OUTSIDE, 10);
    fw_wall *wall;
    assert_int_equal(fw_wall_create(&wall, 0, &def, NULL), FW_OK);
    const fw_vec2 force = fw_penalty_force(wall, (fw_vec2){2, -0.1}, (fw_vec2){2.05, 0.3});
    assert_close(fw_penalty_energy(wall, (fw_vec2){2, 0.3}), 0.5 * 10 * 0.09, 1e-15);
    assert_close(force.x, 0, 0);
    assert_close(force.y * 0.4, -0.5 * 10 * 0.09, 1e-15);
    assert_close(fw_penalty_energy(wall, (fw_vec2){0.2, 0.3}), 0.5 * 10 * 0.04, 1e-15);
    assert_close(fw_penalty_energy(wall, (fw_vec2){2, 2.1}), 0, 0);
    fw_wall_destroy(wall);
}

/* --- bodies against them --- */

/* LB sheets, with scalar and matrix rest mass, in a soft box with a soft ball in it: total energy
 * to rounding while it goes to and fro between the body and the walls. */
static void sheet_between_soft_walls_keeps_its_energy(void **state)
{
    (void)state;
    const fw_sym2 rest[] = {{0, 0, 0}, {1, 0.6, 0.3}};
    for (int n = 0; n < 2; ++n) {
        fw_scene *scene = empty_scene();
        const fw_vec2 corners[] = {{0, 0}, {40, 40}}, centre[] = {{28, 28}};
        const fw_wall_def box = soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, 0.5);
        const fw_wall_def ball = soft_wall(FW_CIRCLE, centre, 1, 4, FW_OUTSIDE, 0.3);
        add_sheet(scene, 8, 8, (fw_vec2){7.3, 11.7}, (fw_vec2){0.06, 0.037}, rest[n]);
        add_wall(scene, &box);
        add_wall(scene, &ball);
        begin(scene);
        const double start = energy_of(scene);
        double stored = 0, deepest = 0;
        for (int t = 0; t < 3000; ++t) {
            step(scene);
            const fw_ledger ledger = fw_scene_ledger(scene);
            assert_close((energy_of(scene) + ledger.wall_stored) / start, 1, 1e-12);
            assert_close(energy_of(scene) / start, fw_ledger_energy(&ledger) / start, 1e-12);
            assert_close(ledger.wall_work / start, 0, 1e-12);
            const fw_vec2 expected = fw_ledger_momentum(&ledger), p = fw_scene_momentum(scene);
            assert_close(p.x, expected.x, 1e-11);
            assert_close(p.y, expected.y, 1e-11);
            stored = fmax(stored, ledger.wall_stored);
            deepest = fmax(deepest, fw_scene_penetration(scene, -1));
        }
        assert_true(stored > 0.02 * start);
        assert_true(fw_scene_wall_ledger(scene, 0)->held > 100);
        assert_true(fw_scene_wall_ledger(scene, 1)->held > 100);
        /* As deep as the energy of both walls allows one particle: K d^2/2. */
        assert_true(deepest > 0.05);
        assert_below(deepest, sqrt(2 * stored / 0.3) * (1 + 1e-9));
        fw_scene_destroy(scene);
    }
}

/* A soft wall on its way does work on what it pushes: F times its motion, to the last bit of the
 * ledger. */
static void moving_soft_wall_does_work(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene();
    const fw_vec2 corners[] = {{0, 0}, {30, 20}};
    fw_wall_def box = soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, 0.5);
    box.path = (fw_path){.amplitude = {3, 0.5}, .period = 90, .until = INFINITY};
    add_sheet(scene, 6, 6, (fw_vec2){2.5, 7}, (fw_vec2){0, 0}, fw_sym2_scalar(0.4));
    add_wall(scene, &box);
    begin(scene);
    for (int t = 0; t < 2000; ++t) step(scene);
    const fw_ledger ledger = fw_scene_ledger(scene);
    assert_true(energy_of(scene) > 1e-3);
    assert_close(energy_of(scene), fw_ledger_energy(&ledger), 1e-12 * energy_of(scene));
    assert_close(ledger.wall_work, energy_of(scene) + ledger.wall_stored, 1e-12 * energy_of(scene));
    fw_scene_destroy(scene);
}

/* A single particle in a soft circle keeps its angular momentum about the centre. */
static void soft_circle_exerts_no_torque(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene();
    const fw_vec2 centre[] = {{0, 0}};
    const fw_wall_def ring = soft_wall(FW_CIRCLE, centre, 1, 10, FW_INSIDE, 0.2);
    add_sheet(scene, 1, 1, (fw_vec2){3.1, 1.7}, (fw_vec2){0.11, 0.31}, fw_sym2_scalar(1.2));
    add_wall(scene, &ring);
    begin(scene);
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    const double before = fw_vec2_cross(fw_solid_position(solid, 0), fw_scene_momentum(scene));
    for (int t = 0; t < 5000; ++t) step(scene);
    const double after = fw_vec2_cross(fw_solid_position(solid, 0), fw_scene_momentum(scene));
    assert_close(after / before, 1, 1e-12);
    assert_true(fw_scene_wall_ledger(scene, 0)->held > 100);
    fw_scene_destroy(scene);
}

/* Where a hard floor and a soft side meet, both hold: nothing behind the floor, energy exact. */
static void hard_and_soft_walls_act_together(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene();
    const fw_vec2 corners[] = {{0, -50}, {20, 50}}, floor[] = {{-100, 0}, {100, 0}};
    const fw_wall_def soft = soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, 0.4);
    fw_wall_def hard = fw_wall_def_default();
    hard.name = "floor";
    hard.shape = FW_CHAIN;
    hard.points = floor;
    hard.point_count = 2;
    add_sheet(scene, 6, 6, (fw_vec2){8, 3}, (fw_vec2){-0.06, -0.05}, fw_sym2_scalar(0));
    add_wall(scene, &soft);
    add_wall(scene, &hard);
    begin(scene);
    const double start = energy_of(scene);
    for (int t = 0; t < 1500; ++t) {
        step(scene);
        const fw_ledger ledger = fw_scene_ledger(scene);
        assert_close((energy_of(scene) + ledger.wall_stored) / start, 1, 1e-12);
        for (int i = 0; i < fw_scene_observe_body(scene, 0)->count; ++i)
            assert_true(fw_scene_observe_body(scene, 0)->y[i] >= 0);
    }
    assert_true(fw_scene_wall_ledger(scene, 1)->held > 5);
    fw_scene_destroy(scene);
}

/* --- movable particles --- */

/* A hot crystal shut in by soft walls: with the wall's energy, the total stays as near as Verlet
 * keeps any, and half the step brings a quarter of the error. */
static void particles_between_soft_walls_keep_verlets_energy(void **state)
{
    (void)state;
    double worst[2];
    for (int fine = 0; fine < 2; ++fine) {
        const double dt = fine ? 0.0025 : 0.005;
        fw_scene *scene = empty_scene();
        const fw_vec2 corners[] = {{-5.01, -4.5}, {5.01, 4.5}};
        const fw_wall_def box = soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, 100);
        fw_solid *solid = solid_of(crowd_disc(5, (fw_vec2){0, 0}, 0, 0, 3),
                                   return_force_of(6, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                                   (fw_langevin_controls){.time_step = dt}, 1);
        fw_particles_draw_velocities(solid, -1, 0.3);
        int body;
        assert_int_equal(fw_scene_adopt_body(scene, "disc", solid, &body, NULL), FW_OK);
        add_wall(scene, &box);
        begin(scene);
        worst[fine] = 0;
        for (int t = 0; t < (fine ? 4000 : 2000); ++t) {
            step(scene);
            const fw_ledger ledger = fw_scene_ledger(scene);
            worst[fine] = fmax(worst[fine], fabs(energy_of(scene) - fw_ledger_energy(&ledger)));
            assert_close(ledger.wall_work, 0, 1e-10);
        }
        assert_true(fw_scene_wall_ledger(scene, 0)->held > 1000);
        fw_scene_destroy(scene);
    }
    assert_below(worst[0], 0.05); /* of a kinetic energy of 27 */
    assert_close(worst[1] / worst[0], 0.25, 0.04);
}

/* --- refusals --- */

static void stiff_and_open_walls_are_refused(void **state)
{
    (void)state;
    fw_error error;
    const fw_vec2 corners[] = {{0, 0}, {40, 40}}, points[] = {{0, 0}, {5, 0}};
    const fw_wall_def chain = soft_wall(FW_CHAIN, points, 2, 0, FW_INSIDE, 1);
    fw_scene *scene = empty_scene();
    assert_int_equal(fw_scene_add_wall(scene, &chain, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "a chain and has a penalty"));
    fw_scene_destroy(scene);
    /* dt < 2/(K/m)^(1/2): K below 4 m/dt^2 = 160,000. */
    for (int stiff = 0; stiff < 2; ++stiff) {
        scene = empty_scene();
        const fw_wall_def box =
            soft_wall(FW_BOX, corners, 2, 0, FW_INSIDE, stiff ? 160001 : 159999);
        fw_solid *solid = solid_of(crowd_disc(2, (fw_vec2){20, 20}, 0, 0, 3),
                                   return_force_of(6, 0, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                                   (fw_langevin_controls){.time_step = 0.005}, 1);
        int body;
        assert_int_equal(fw_scene_adopt_body(scene, "disc", solid, &body, NULL), FW_OK);
        add_wall(scene, &box);
        assert_int_equal(fw_scene_begin(scene, &error), stiff ? FW_BAD_INPUT : FW_OK);
        if (stiff) assert_non_null(strstr(error.sentence, "expected less than 1.6e+05"));
        fw_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_does_the_work_that_the_spring_gives),
        cmocka_unit_test(obstacle_pushes_to_its_nearest_side),
        cmocka_unit_test(sheet_between_soft_walls_keeps_its_energy),
        cmocka_unit_test(moving_soft_wall_does_work),
        cmocka_unit_test(soft_circle_exerts_no_torque),
        cmocka_unit_test(hard_and_soft_walls_act_together),
        cmocka_unit_test(particles_between_soft_walls_keep_verlets_energy),
        cmocka_unit_test(stiff_and_open_walls_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
