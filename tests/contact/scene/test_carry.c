/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_carry.c - what is held on a path has the velocity of the path, and goes on with that. */
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"
#include "tests/support/scenes.h"

typedef enum solid_kind { LATTICE_BOLTZMANN, LINEAR_LATTICE, MOVABLE, SOLIDS } solid_kind;

enum { SIDE = 4, COUNT = SIDE * SIDE };

/* 4 x 4 particles at rest. */
static void add_block(fw_scene *scene, solid_kind kind, double damping, double temperature)
{
    if (kind == LATTICE_BOLTZMANN) {
        add_body(scene, (body_options){.columns = SIDE,
                                       .rows = SIDE,
                                       .mu = 1 - 0.1 * damping,
                                       .rest_matrix = {1, 0.2, 0.7}});
        return;
    }
    fw_sites sites;
    fw_solid *solid;
    int body;
    must(fw_sites_rectangle(&sites, SIDE, SIDE, &error));
    const fw_langevin_controls controls = {0.005, damping, temperature};
    if (kind == LINEAR_LATTICE) {
        fw_linear_lattice_def def = fw_linear_lattice_def_default();
        def.sites = &sites;
        def.mass = 1.5;
        def.controls = controls;
        must(fw_linear_lattice_create(&solid, &def, &error));
    } else {
        const fw_lattice lattice = {.kind = FW_HEXAGONAL, .spacing = 1};
        fw_vec2 places[COUNT];
        for (int i = 0; i < COUNT; ++i) places[i] = fw_lattice_position(&lattice, sites.site[i]);
        fw_particle_group_def group = fw_particle_group_def_default();
        group.name = "sheet";
        group.count = COUNT;
        group.positions = places;
        group.mass = 1.5;
        fw_particles_def def = fw_particles_def_default();
        def.groups = &group;
        def.group_count = 1;
        def.controls = controls;
        must(fw_particles_create(&solid, &def, &error));
    }
    must(fw_scene_adopt_body(scene, "sheet", solid, &body, &error));
    fw_sites_clear(&sites);
}

static void add_grip(fw_scene *scene, int first, int count, fw_drive drive)
{
    int particles[COUNT];
    for (int n = 0; n < count; ++n) particles[n] = first + n;
    const fw_grip_def def = {
        .name = "grip", .particles = particles, .particle_count = count, .drive = drive};
    must(fw_scene_add_grip(scene, 0, &def, &error));
}

static void assert_velocities(const fw_scene *scene, int first, int count, fw_vec2 velocity,
                              double tolerance)
{
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    double x[COUNT], y[COUNT];
    solid->model->velocities(solid, x, y);
    for (int i = first; i < first + count; ++i) {
        assert_close(x[i], velocity.x, tolerance);
        assert_close(y[i], velocity.y, tolerance);
    }
}

/* Energy and momentum against the ledger, as parts of what has passed. The energy of deformed point
 * masses is only as exact as Verlet's step. */
static void assert_ledgers_close(const fw_scene *scene, double tolerance, double energy_tolerance)
{
    const fw_ledger l = fw_scene_ledger(scene);
    const double size = fabs(l.external_work) + fabs(l.wall_work) + fabs(l.grip_work) +
                        l.dissipated + fabs(l.thermostat_heat);
    assert_close(energy_of(scene), fw_ledger_energy(&l), energy_tolerance * (1 + size));
    const fw_vec2 p = fw_scene_momentum(scene), booked = fw_ledger_momentum(&l);
    assert_close(p.x, booked.x, 100 * tolerance);
    assert_close(p.y, booked.y, 100 * tolerance);
}

/* All of the block at V: kinetic energy M V^2/2 in every step, and V when it is let go, after any
 * number of steps. */
static void block_goes_on_as_it_was_carried(void **state)
{
    (void)state;
    const fw_vec2 v = {0.1, -0.03};
    for (int kind = 0; kind < SOLIDS; ++kind)
        for (int steps = 200; steps <= 201; ++steps) {
            fw_scene *scene = empty_scene(1e6);
            add_block(scene, (solid_kind)kind, 0, 0);
            add_grip(scene, 0, COUNT,
                     (fw_drive){.prescribed_x = true,
                                .prescribed_y = true,
                                .path = {.velocity = v, .until = INFINITY}});
            begin(scene);
            const fw_solid *solid = fw_scene_observe_body(scene, 0);
            const fw_sym2 mass = solid->model->mass(solid);
            const double kinetic = 0.5 * fw_sym2_form(v, mass, v);
            const double rest = fw_scene_energies(scene).kinetic;
            for (int t = 1; t <= steps; ++t) {
                run(scene, 1);
                assert_velocities(scene, 0, COUNT, v, 1e-12);
                assert_close(fw_scene_energies(scene).kinetic - rest, kinetic, 1e-12);
                assert_ledgers_close(scene, 1e-13, 1e-13);
            }
            const fw_drive none = {.path = {.until = INFINITY}};
            must(fw_grip_set_drive(fw_scene_grip(scene, 0), &none, &error));
            const fw_vec2 from = fw_solid_position(solid, 5);
            run(scene, 300);
            const fw_vec2 to = fw_solid_position(solid, 5);
            assert_close((to.x - from.x) / (300 * solid->tick), v.x, 1e-11);
            assert_close((to.y - from.y) / (300 * solid->tick), v.y, 1e-11);
            assert_ledgers_close(scene, 1e-13, 1e-13);
            fw_scene_destroy(scene);
        }
}

/* Two rows shaken in x, with damping and noise, the others free. Point masses have the velocity of
 * the path in each step; what is held only in x is free in y. */
static void held_component_follows_an_oscillation(void **state)
{
    (void)state;
    for (int kind = 0; kind < SOLIDS; ++kind)
        for (int both = 0; both < 2; ++both) {
            fw_scene *scene = empty_scene(1e6);
            add_block(scene, (solid_kind)kind, 0.5, 0.3);
            const fw_path path = {.velocity = {0.05, 0.01},
                                  .until = INFINITY,
                                  .amplitude = {0.02, 0.03},
                                  .period = kind == LATTICE_BOLTZMANN ? 100 : 1};
            const fw_drive drive = {.prescribed_x = true, .prescribed_y = both, .path = path};
            add_grip(scene, 0, 2 * SIDE, drive);
            begin(scene);
            double held_y = 0;
            for (int t = 1; t <= 1000; ++t) {
                run(scene, 1);
                const fw_solid *solid = fw_scene_observe_body(scene, 0);
                double x[COUNT], y[COUNT];
                solid->model->velocities(solid, x, y);
                const fw_vec2 v = fw_path_velocity(&path, fw_scene_time(scene), solid->tick);
                for (int i = 0; i < 2 * SIDE && kind != LATTICE_BOLTZMANN; ++i) {
                    assert_close(x[i], v.x, 1e-12);
                    if (both) assert_close(y[i], v.y, 1e-12);
                    held_y = fmax(held_y, fabs(y[i] - v.y));
                }
            }
            if (kind != LATTICE_BOLTZMANN) assert_int_equal(held_y > 1e-3, !both);
            assert_ledgers_close(scene, 1e-11, kind == LATTICE_BOLTZMANN ? 1e-11 : 1e-3);
            fw_scene_destroy(scene);
        }
}

/* The derivative of the path, and the share of a tick in which its window begins or ends. */
static void velocity_of_a_path_is_its_derivative(void **state)
{
    (void)state;
    const fw_path path = {.velocity = {0.3, -0.2},
                          .from = 2,
                          .until = 10.25,
                          .amplitude = {0.5, 0.1},
                          .period = 7,
                          .phase = 0.4};
    const double h = 1e-5;
    for (double time = 2.7; time < 10; time += 0.37) {
        const fw_vec2 change = fw_vec2_subtract(fw_path_displacement(&path, time + h),
                                                fw_path_displacement(&path, time - h));
        const fw_vec2 v = fw_path_velocity(&path, time, 0.5);
        assert_close(v.x, change.x / (2 * h), 1e-9);
        assert_close(v.y, change.y / (2 * h), 1e-9);
    }
    const fw_path ramp = {.velocity = {0.3, -0.2}, .from = 2, .until = 10.25};
    assert_close(fw_path_velocity(&ramp, 2, 0.5).x, 0, 0);
    assert_close(fw_path_velocity(&ramp, 2.5, 0.5).x, 0.3, 0);
    assert_close(fw_path_velocity(&ramp, 10.5, 0.5).x, 0.15, 1e-15);
    assert_close(fw_path_velocity(&ramp, 11, 0.5).x, 0, 0);
}

/* A block pressed on a floor that sticks, moves, and stops; the load ends before or after that. */
static void sticking_floor_carries_and_stops(void **state)
{
    (void)state;
    const double v = 0.02;
    for (int kind = 0; kind < SOLIDS; ++kind)
        for (int piston = 0; piston < 2; ++piston) {
            fw_scene *scene = empty_scene(1e6);
            add_block(scene, (solid_kind)kind, 0, 0);
            const fw_vec2 corners[] = {{-20, -5}, {30, 0}};
            const double tick = fw_scene_observe_body(scene, 0)->tick, until = 300 * tick;
            const fw_path path = {.velocity = {v, 0}, .until = until};
            fw_wall_def def = fw_wall_def_default();
            def.name = "floor";
            def.points = corners;
            def.side = FW_OUTSIDE;
            def.surface.law = FW_STICK;
            if (piston) {
                const fw_piston_def moved = {
                    .mass = 3, .drive = {.prescribed_x = true, .prescribed_y = true, .path = path}};
                must(fw_scene_add_piston(scene, &def, &moved, &error));
            } else {
                def.path = path;
                must(fw_scene_add_wall(scene, &def, &error));
            }
            int bottom[SIDE] = {0, 1, 2, 3};
            const fw_load_def load = {.kind = FW_LOAD_EACH,
                                      .particles = bottom,
                                      .particle_count = SIDE,
                                      .vector = {0, -2},
                                      .until = 500};
            must(fw_scene_add_load(scene, 0, &load, &error));
            begin(scene);
            for (int t = 1; t <= 500; ++t) {
                run(scene, 1);
                assert_true(fw_scene_wall_ledger(scene, 0)->contacts == SIDE);
                if (kind != LATTICE_BOLTZMANN)
                    assert_velocities(scene, 0, SIDE, (fw_vec2){t <= 300 ? v : 0, 0}, 1e-12);
                assert_ledgers_close(scene, 1e-12, kind == LATTICE_BOLTZMANN ? 1e-12 : 1e-5);
                assert_true(fw_scene_wall_ledger(scene, 0)->dissipated >= 0);
            }
            if (piston) {
                const fw_piston *moved = fw_scene_observe_piston(scene, 0);
                assert_close(fw_piston_energy_error(moved), 0, 1e-12);
                assert_close(fw_piston_momentum_error(moved).x, 0, 1e-10);
                assert_close(fw_piston_observe_ledger(moved)->pushed_by,
                             -fw_scene_wall_ledger(scene, 0)->work, 1e-12);
            }
            fw_scene_destroy(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(block_goes_on_as_it_was_carried),
        cmocka_unit_test(held_component_follows_an_oscillation),
        cmocka_unit_test(velocity_of_a_path_is_its_derivative),
        cmocka_unit_test(sticking_floor_carries_and_stops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
