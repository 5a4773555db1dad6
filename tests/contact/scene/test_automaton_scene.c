/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_scene.c - the elastic automaton against walls, in half-steps: the paper's bounce,
 * exact ledgers for conserving walls, and what `componentwise` does to the energy. */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/automaton/elastic_automaton.h"

#include <stdlib.h>

static fw_scene *empty_scene(void)
{
    fw_scene *scene;
    assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
    return scene;
}

static void adopt(fw_scene *scene, const fw_elastic_automaton_def *def)
{
    fw_error error;
    fw_solid *solid;
    int body;
    if (fw_elastic_automaton_create(&solid, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    assert_int_equal(fw_scene_adopt_body(scene, "body", solid, &body, &error), FW_OK);
}

/* The paper's Figs 3 and 4: 6 x 6, spacing 1.5, black = i + j odd, site (2, 1) displaced by -.3. */
static fw_scene *paper_scene(double c1, double c2, fw_boundary_rule rule, fw_surface surface)
{
    fw_scene *scene = empty_scene();
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 6, 6, NULL), FW_OK);
    fw_vec2 u[36] = {{0, 0}};
    u[fw_sites_find(&sites, (fw_site){2, 1})].x = -0.3;
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = (fw_automaton_speeds){c1, c2};
    def.boundary = rule;
    def.black_is_odd = true;
    def.lattice.spacing = 1.5;
    def.lattice.origin = (fw_vec2){6.25, 6.25};
    def.displacement = u;
    def.displaced_as_given = true;
    adopt(scene, &def);
    fw_sites_clear(&sites);
    fw_wall_def wall = fw_wall_def_default();
    const fw_vec2 corners[] = {{0, 0}, {20, 20}};
    wall.name = "box";
    wall.points = corners;
    wall.point_count = 2;
    wall.surface = surface;
    assert_int_equal(fw_scene_add_wall(scene, &wall, NULL), FW_OK);
    assert_int_equal(fw_scene_begin(scene, NULL), FW_OK);
    return scene;
}

static double energy_of(const fw_scene *scene)
{
    const fw_energies e = fw_scene_energies(scene);
    return e.kinetic + e.elastic;
}

static fw_vec2 drift_of(const fw_scene *scene)
{
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    return fw_sym2_apply(fw_sym2_invert(solid->model->mass(solid)), fw_solid_momentum(solid));
}

static void assert_ledger_balances(const fw_scene *scene, double tolerance)
{
    const fw_ledger l = fw_scene_ledger(scene);
    const double expected = l.energy_at_start + l.external_work + l.wall_work - l.dissipated -
                            l.friction_heat + l.thermostat_heat;
    assert_close(energy_of(scene), expected, tolerance);
    const fw_vec2 p = fw_scene_momentum(scene);
    assert_close(p.x, l.momentum_at_start.x + l.external_impulse.x + l.wall_impulse.x + l.drag.x,
                 tolerance);
    assert_close(p.y, l.momentum_at_start.y + l.external_impulse.y + l.wall_impulse.y + l.drag.y,
                 tolerance);
}

/* The numbers are those of tests/whole/plain_solids.py. */
static void paper_body_bounces_as_computed_independently(void **state)
{
    (void)state;
    const struct {
        double c1, c2;
        fw_surface_law law;
        int first, after;
        fw_vec2 drift;
    } cases[] = {{1.41421356237309515, 0, FW_FRICTIONLESS, 154, 157, {-0.0317024553, 0}},
                 {1.41421356237309515, 0, FW_STICK, 154, 157, {-0.0317024553, 0}},
                 {0.4, 0.5, FW_STICK, 151, 169, {-0.0362765743, 0.0185786962}},
                 {0.4, 0.5, FW_FRICTIONLESS, 151, 170, {-0.0395776410, 0}}};
    for (int c = 0; c < 4; ++c) {
        fw_scene *scene = paper_scene(cases[c].c1, cases[c].c2, FW_BOUNDARY_BOND,
                                      (fw_surface){.law = cases[c].law});
        int first = 0, last = 0;
        double held = 0;
        for (int step = 1; step <= 250; ++step) {
            assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
            const double now = fw_scene_wall_ledger(scene, 0)->held;
            if (now > held) last = step;
            if (now > held && first == 0) first = step;
            held = now;
            assert_close(energy_of(scene), 0.09, 1e-14);
            assert_true(fw_scene_penetration(scene, -1) == 0);
        }
        assert_int_equal(first, cases[c].first);
        assert_int_equal(last, cases[c].after);
        assert_close(drift_of(scene).x, cases[c].drift.x, 1e-10);
        assert_close(drift_of(scene).y, cases[c].drift.y, 1e-10);
        assert_ledger_balances(scene, 1e-13);
        fw_scene_destroy(scene);
    }
}

static void conserving_walls_keep_energy_for_ten_thousand_steps(void **state)
{
    (void)state;
    const fw_surface_law laws[] = {FW_STICK, FW_FRICTIONLESS};
    for (int n = 0; n < 2; ++n) {
        fw_scene *scene = paper_scene(0.4, 0.5, FW_BOUNDARY_BOND, (fw_surface){.law = laws[n]});
        for (int step = 0; step < 10000; ++step)
            assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
        assert_true(fw_scene_wall_ledger(scene, 0)->held > 100);
        assert_close(energy_of(scene) / 0.09, 1, 1e-12);
        assert_ledger_balances(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

static void componentwise_walls_pump_energy(void **state)
{
    (void)state;
    /* Exact for Chopard's diagonal matrices, without bound for coupled ones. */
    const double c2[] = {0, 0.5};
    double end[2];
    for (int n = 0; n < 2; ++n) {
        fw_scene *scene = paper_scene(n == 0 ? 1.41421356237309515 : 0.4, c2[n], FW_BOUNDARY_BOND,
                                      (fw_surface){.law = FW_COMPONENTWISE});
        for (int step = 0; step < 1500; ++step) assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
        end[n] = energy_of(scene);
        fw_scene_destroy(scene);
    }
    assert_close(end[0], 0.09, 1e-13);
    assert_true(end[1] > 100 * 0.09);
}

static void bounce_as_printed_goes_down(void **state)
{
    (void)state;
    /* Fig 4 with the paper's c1, c2: needs `mirror` and walls that do not conserve. */
    fw_scene *scene =
        paper_scene(0.4, 0.58, FW_BOUNDARY_MIRROR, (fw_surface){.law = FW_COMPONENTWISE});
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    const fw_vec2 begin = solid->model->centre_of_mass(solid);
    for (int step = 0; step < 250; ++step) assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
    assert_close(solid->model->centre_of_mass(solid).y - begin.y, -1.6, 0.05);
    assert_true(energy_of(scene) > 2 * 0.09);
    fw_scene_destroy(scene);
}

static void moving_wall_does_what_the_ledger_says(void **state)
{
    (void)state;
    /* A slanted wall swings against the body from below while it is shaken by loads and damped. */
    fw_scene *scene = empty_scene();
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 9, 7, NULL), FW_OK);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = (fw_automaton_speeds){0.4, 0.5};
    def.reflection = 0.95;
    def.lattice.origin = (fw_vec2){0, 3};
    adopt(scene, &def);
    fw_wall_def wall = fw_wall_def_default();
    const fw_vec2 points[] = {{-200, -20.5}, {200, 20.5}};
    wall.name = "floor";
    wall.shape = FW_CHAIN;
    wall.points = points;
    wall.point_count = 2;
    wall.path.amplitude = (fw_vec2){0.2, 1.5};
    wall.path.period = 90;
    fw_error error;
    if (fw_scene_add_wall(scene, &wall, &error) != FW_OK) fail_msg("%s", error.sentence);
    int all[63];
    for (int p = 0; p < 63; ++p) all[p] = p;
    const fw_load_def weight = {.kind = FW_LOAD_EACH,
                                .particles = all,
                                .particle_count = 63,
                                .vector = {0, -2e-3},
                                .until = INT64_MAX};
    assert_int_equal(fw_scene_add_load(scene, 0, &weight, &error), FW_OK);
    if (fw_scene_begin(scene, &error) != FW_OK) fail_msg("%s", error.sentence);
    double deepest = 0;
    for (int step = 0; step < 900; ++step) {
        assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
        deepest = fmax(deepest, fw_scene_penetration(scene, -1));
    }
    assert_true(fw_scene_wall_ledger(scene, 0)->held > 50);
    assert_true(fabs(fw_scene_wall_ledger(scene, 0)->work) > 1e-3);
    assert_ledger_balances(scene, 1e-11); /* impulses of some hundred */
    /* The colour that rests is where the wall was half a step ago: 1.5 2 pi/90 /2 = .052. */
    assert_below(deepest, 0.053);
    fw_scene_destroy(scene);
    fw_sites_clear(&sites);
}

/* A block of 8 x 4 on a floor, under a weight that is shared equally. */
static fw_scene *block_on_floor(fw_vec2 velocity, double reflection, fw_surface surface,
                                double weight)
{
    fw_scene *scene = empty_scene();
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 8, 4, NULL), FW_OK);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    fw_vec2 v[32];
    int all[32];
    for (int p = 0; p < 32; ++p) {
        all[p] = p;
        v[p] = velocity;
    }
    def.sites = &sites;
    def.speeds = (fw_automaton_speeds){0.8, 0.5};
    def.reflection = reflection;
    def.velocity = v;
    adopt(scene, &def);
    fw_sites_clear(&sites);
    fw_wall_def wall = fw_wall_def_default();
    const fw_vec2 points[] = {{-100, 0}, {100, 0}};
    wall.name = "floor";
    wall.shape = FW_CHAIN;
    wall.points = points;
    wall.point_count = 2;
    wall.surface = surface;
    assert_int_equal(fw_scene_add_wall(scene, &wall, NULL), FW_OK);
    const fw_load_def load = {.kind = FW_LOAD_TOTAL,
                              .particles = all,
                              .particle_count = 32,
                              .vector = {0, -weight},
                              .until = INT64_MAX};
    assert_int_equal(fw_scene_add_load(scene, 0, &load, NULL), FW_OK);
    assert_int_equal(fw_scene_begin(scene, NULL), FW_OK);
    return scene;
}

static void resting_body_weighs_what_it_weighs(void **state)
{
    (void)state;
    fw_scene *scene =
        block_on_floor((fw_vec2){0, 0}, 0.8, (fw_surface){.law = FW_FRICTIONLESS}, 0.02);
    for (int step = 0; step < 3000; ++step) assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
    /* At rest the floor's force, as momentum per time, is the weight. */
    assert_close(fw_scene_wall_ledger(scene, 0)->reaction.y, 0.02, 1e-10);
    fw_scene_destroy(scene);
}

static void sliding_body_is_braked_by_friction(void **state)
{
    (void)state;
    const double friction = 0.2, weight = 0.02;
    fw_scene *scene = block_on_floor((fw_vec2){0.3, 0}, 1,
                                     (fw_surface){.law = FW_COULOMB, .friction = friction}, weight);
    const double before = fw_scene_momentum(scene).x;
    double total = energy_of(scene);
    for (int step = 0; step < 300; ++step) {
        assert_int_equal(fw_scene_step(scene, NULL), FW_OK);
        const double now = energy_of(scene) - fw_scene_ledger(scene).external_work;
        assert_true(now < total + 1e-14);
        total = now;
    }
    assert_ledger_balances(scene, 1e-12);
    assert_close((before - fw_scene_momentum(scene).x) / (friction * weight * 300), 1, 0.02);
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paper_body_bounces_as_computed_independently),
        cmocka_unit_test(conserving_walls_keep_energy_for_ten_thousand_steps),
        cmocka_unit_test(componentwise_walls_pump_energy),
        cmocka_unit_test(bounce_as_printed_goes_down),
        cmocka_unit_test(moving_wall_does_what_the_ledger_says),
        cmocka_unit_test(resting_body_weighs_what_it_weighs),
        cmocka_unit_test(sliding_body_is_braked_by_friction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
