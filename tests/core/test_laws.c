/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_laws.c - the same laws asked of every solid: momentum, energy, free translation, the ledger,
 * static equilibrium, wave speed, walls, restart, threads. What a solid keeps only up to the error
 * of its time step says so in its row. Start reading at the table of solids. */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/noise.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"
#include "tests/support/standing_wave.h"
#include "tests/support/steps.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* How a body starts; arrays per site, owned. */
typedef struct start {
    fw_sites sites;
    fw_lattice lattice;
    fw_vec2 *displacement, *velocity; /* displacement in spacings, velocity in units of sound */
    double loss;                      /* of momentum while sound runs one spacing */
} start;

typedef struct solid_kind {
    const char *name;
    fw_lattice_kind lattice;
    fw_solid *(*make)(const start *s);
    double transverse, longitudinal; /* speed of sound, in spacings per unit of time */
    double energy_error; /* part of the energy that rounding or the time step may take */
    double nonlinearity; /* part by which twice the force may not stretch twice as far */
} solid_kind;

static fw_solid *checked(fw_status status, fw_solid *solid, const fw_error *error)
{
    if (status != FW_OK) fail_msg("%s", error->sentence);
    return solid;
}

static fw_vec2 *scaled(const start *s, double speed)
{
    fw_vec2 *velocity = malloc((size_t)s->sites.count * sizeof *velocity);
    for (int p = 0; p < s->sites.count; ++p) velocity[p] = fw_vec2_scale(speed, s->velocity[p]);
    return velocity;
}

/* M0 = .8: M = (.64 + 4)/2. */
#define LB_SOUND 0.65653216429861311
static fw_solid *make_boltzmann(const start *s)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, LB_SOUND);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.rest_mass = fw_sym2_scalar(0.8);
    def.damping = 1 - s->loss * LB_SOUND / 2;
    def.displacement = s->displacement;
    def.velocity = velocity;
    const fw_status status = fw_lb_solid_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

static fw_solid *make_any_automaton(const start *s, fw_automaton_speeds speeds,
                                    fw_boundary_rule boundary)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, speeds.transverse);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.speeds = speeds;
    def.boundary = boundary;
    def.reflection = 1 - s->loss * speeds.transverse;
    def.displacement = s->displacement;
    def.velocity = velocity;
    const fw_status status = fw_elastic_automaton_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

static fw_solid *make_automaton(const start *s)
{
    return make_any_automaton(s, (fw_automaton_speeds){0.9, 0.5}, FW_BOUNDARY_BOND);
}

static fw_solid *make_trapezoid(const start *s)
{
    return make_any_automaton(s, (fw_automaton_speeds){0.9, 0.5}, FW_BOUNDARY_TRAPEZOID);
}

static fw_solid *make_chopard(const start *s)
{
    return make_any_automaton(s, fw_automaton_chopard(), FW_BOUNDARY_BOND);
}

/* k1 = 10, k2 = 50, mass 1: c_T^2 = 3/2 (10 + 50/4), c_L^2 = 3/2 (10 + 3 50/4). */
#define LINEAR_SOUND 5.8094750193111255
static fw_solid *make_linear(const start *s)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, LINEAR_SOUND);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.displacements = s->displacement;
    def.velocities = velocity;
    def.controls.time_step = 0.005;
    def.controls.damping = s->loss * LINEAR_SOUND;
    const fw_status status = fw_linear_lattice_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

/* Lennard-Jones: U'' = 72, c_T^2 = 9/8 72/3, c_L^2 = 9/8 72, with no return force. */
#define PARTICLE_SOUND 5.1961524227066320
static fw_solid *make_particles(const start *s)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, PARTICLE_SOUND);
    fw_vec2 *positions = malloc((size_t)s->sites.count * sizeof *positions);
    for (int p = 0; p < s->sites.count; ++p)
        positions[p] =
            fw_vec2_add(fw_lattice_position(&s->lattice, s->sites.site[p]), s->displacement[p]);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.name = "body";
    group.count = s->sites.count;
    group.positions = positions;
    group.velocities = velocity;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls.time_step = 0.005;
    def.controls.damping = s->loss * PARTICLE_SOUND;
    const fw_status status = fw_particles_create(&solid, &def, &error);
    free(velocity);
    free(positions);
    return checked(status, solid, &error);
}

/* Verlet's energy error is (omega dt)^2/8 of the ringing: .005 x 17 (20) of the stiffest bond. */
static const solid_kind kinds[] = {
    {"lattice Boltzmann", FW_SQUARE, make_boltzmann, LB_SOUND, LB_SOUND, 1e-12, 1e-9},
    {"elastic automaton", FW_SQUARE, make_automaton, 0.9, 1.0295630140987001, 1e-12, 1e-9},
    {"automaton, trapezoid", FW_SQUARE, make_trapezoid, 0.9, 1.0295630140987001, 1e-12, 1e-9},
    {"Chopard's automaton", FW_SQUARE, make_chopard, 1.4142135623730951, 1.4142135623730951, 1e-12,
     1e-9},
    {"linear lattice", FW_HEXAGONAL, make_linear, LINEAR_SOUND, 8.4409715080670666, 3e-3, 1e-9},
    {"movable particles", FW_HEXAGONAL, make_particles, PARTICLE_SOUND, 9, 5e-3, 0.1},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* --- starts --- */

static start rectangle(const solid_kind *kind, int columns, int rows)
{
    start s = {.lattice = {.kind = kind->lattice, .spacing = 1}};
    assert_int_equal(fw_sites_rectangle(&s.sites, columns, rows, NULL), FW_OK);
    s.displacement = calloc((size_t)s.sites.count, sizeof *s.displacement);
    s.velocity = calloc((size_t)s.sites.count, sizeof *s.velocity);
    return s;
}

static void shake(start *s, double displacement, double velocity)
{
    for (int p = 0; p < s->sites.count; ++p) {
        s->displacement[p] = fw_vec2_scale(displacement, fw_noise_uniform(1, (uint32_t)p, 0, 1));
        s->velocity[p] = fw_vec2_scale(velocity, fw_noise_uniform(1, (uint32_t)p, 0, 2));
    }
}

static fw_solid *made(const solid_kind *kind, start *s)
{
    fw_solid *solid = kind->make(s);
    fw_sites_clear(&s->sites);
    free(s->displacement);
    free(s->velocity);
    return solid;
}

static fw_solid *shaken(const solid_kind *kind, int columns, int rows, double loss)
{
    start s = rectangle(kind, columns, rows);
    shake(&s, 0.02, 0.02);
    s.loss = loss;
    return made(kind, &s);
}

/* Ticks in which transverse sound runs so many spacings. */
static int ticks_for(const solid_kind *kind, const fw_solid *solid, double spacings)
{
    const int ticks = (int)ceil(spacings / kind->transverse / solid->tick);
    return ticks + ticks % solid->model->ticks_per_step;
}

static double energy_of(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

/* Forces of the step, new at the start of each: an automaton keeps them for both of its ticks. */
static void push_at_random(fw_solid *solid, const solid_kind *kind, double size)
{
    const int64_t step = solid->ticks / solid->model->ticks_per_step;
    double *masses = fw_array_of_doubles((size_t)solid->count);
    solid->model->masses(solid, masses);
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p) {
        const fw_vec2 r = fw_noise_uniform(5, (uint32_t)p, (uint64_t)step, 3);
        const double weight = size * masses[p] * kind->transverse * kind->transverse;
        solid->external_x[p] = weight * r.x;
        solid->external_y[p] = weight * r.y;
    }
    free(masses);
}

/* --- the laws --- */

static void free_bodies_keep_momentum(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 9, 8, 0);
        const fw_vec2 before = fw_solid_momentum(solid);
        const double scale = solid->model->mass(solid).xx * kinds[k].transverse;
        const int ticks = ticks_for(&kinds[k], solid, 300);
        for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
        const fw_vec2 after = fw_solid_momentum(solid);
        if (!(hypot(after.x - before.x, after.y - before.y) < 1e-13 * scale))
            fail_msg("%s: momentum off by %g of %g", kinds[k].name,
                     hypot(after.x - before.x, after.y - before.y), scale);
        fw_solid_destroy(solid);
    }
}

static void free_bodies_keep_energy(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 9, 8, 0);
        const double before = energy_of(solid);
        const double rest = k == KINDS - 1 ? fw_solid_energies(solid).elastic : 0;
        /* Movable particles have a binding energy: the ringing is measured above it. */
        start at_rest = rectangle(&kinds[k], 9, 8);
        fw_solid *still = made(&kinds[k], &at_rest);
        const double ringing = before - (rest < 0 ? energy_of(still) : 0);
        double worst = 0;
        const int ticks = ticks_for(&kinds[k], solid, 300);
        for (int tick = 0; tick < ticks; ++tick) {
            advance_free(solid);
            if (tick % solid->model->ticks_per_step == solid->model->ticks_per_step - 1)
                worst = fmax(worst, fabs(energy_of(solid) - before) / ringing);
        }
        if (!(worst < kinds[k].energy_error))
            fail_msg("%s: energy off by %g, expected below %g", kinds[k].name, worst,
                     kinds[k].energy_error);
        fw_solid_destroy(solid);
        fw_solid_destroy(still);
    }
}

static void rigid_motion_does_not_ring(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 7, 6);
        s.lattice.origin = (fw_vec2){3, -2};
        for (int p = 0; p < s.sites.count; ++p) s.velocity[p] = (fw_vec2){0.03, -0.02};
        fw_solid *solid = made(&kinds[k], &s);
        const fw_vec2 begin = solid->model->centre_of_mass(solid);
        const double elastic = fw_solid_energies(solid).elastic;
        const double kinetic = fw_solid_energies(solid).kinetic;
        const int ticks = ticks_for(&kinds[k], solid, 200);
        for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
        const fw_vec2 end = solid->model->centre_of_mass(solid);
        const double way = kinds[k].make == make_trapezoid || kinds[k].make == make_automaton
                               ? 0.9 * ticks * solid->tick
                               : kinds[k].transverse * ticks * solid->tick;
        assert_close(end.x - begin.x, 0.03 * way, 1e-11);
        assert_close(end.y - begin.y, -0.02 * way, 1e-11);
        assert_below(fabs(fw_solid_energies(solid).elastic - elastic), 1e-11 * kinetic);
        fw_solid_destroy(solid);
    }
}

static void ledger_balances_under_loads_and_damping(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int damped = 0; damped < 2; ++damped) {
            fw_solid *solid = shaken(&kinds[k], 8, 7, damped ? 0.05 : 0);
            const double before = energy_of(solid);
            const fw_vec2 p0 = fw_solid_momentum(solid);
            const double scale = solid->model->mass(solid).xx * kinds[k].transverse;
            const int ticks = ticks_for(&kinds[k], solid, 150);
            double moved = 0;
            for (int tick = 0; tick < ticks; ++tick) {
                if (tick % solid->model->ticks_per_step == 0)
                    push_at_random(solid, &kinds[k], 0.02);
                advance_free(solid);
                moved = fmax(moved, fabs(solid->ledger.work) + solid->ledger.dissipated);
            }
            const fw_solid_ledger *a = &solid->ledger;
            const double expected = before + a->work - a->dissipated + a->heat;
            const double error = fabs(energy_of(solid) - expected) / moved;
            if (!(error < 10 * kinds[k].energy_error))
                fail_msg("%s: energy off by %g of what passed", kinds[k].name, error);
            const fw_vec2 p = fw_solid_momentum(solid);
            assert_close(p.x, p0.x + a->impulse.x + a->drag.x, 1e-12 * scale);
            assert_close(p.y, p0.y + a->impulse.y + a->drag.y, 1e-12 * scale);
            assert_true(moved > 0 && (a->dissipated > 0) == (damped == 1));
            fw_solid_destroy(solid);
        }
}

/* Opposite forces on the outermost columns; how much longer the body is once it rests. */
static double stretch(const solid_kind *kind, double force, double loss)
{
    enum { COLUMNS = 8, ROWS = 5 };
    start s = rectangle(kind, COLUMNS, ROWS);
    s.loss = loss;
    fw_solid *solid = made(kind, &s);
    const double size = force * kind->transverse * kind->transverse * solid->model->mass(solid).xx;
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p)
        solid->external_x[p] = p % COLUMNS == 0             ? -size / ROWS
                               : p % COLUMNS == COLUMNS - 1 ? size / ROWS
                                                            : 0;
    const double length = solid->x[COLUMNS - 1] - solid->x[0];
    const int ticks = ticks_for(kind, solid, 40 / loss * 20);
    for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
    const double here = solid->x[0];
    /* A load that has acted on black but not yet on white shows in the momentum between ticks. */
    fw_vec2 momentum = {0, 0};
    for (int tick = 0; tick < 10; ++tick) {
        momentum = fw_vec2_add(momentum, fw_solid_momentum(solid));
        advance_free(solid);
    }
    assert_below(hypot(momentum.x, momentum.y), 1e-11);
    assert_below(fabs(solid->x[0] - here), 1e-11);
    const double longer = solid->x[COLUMNS - 1] - solid->x[0] - length;
    fw_solid_destroy(solid);
    return longer;
}

static void pulled_bodies_rest_where_damping_has_no_say(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        const double slow = stretch(&kinds[k], 1e-3, 0.3), fast = stretch(&kinds[k], 1e-3, 0.5);
        const double twice = stretch(&kinds[k], 2e-3, 0.5);
        assert_true(slow > 0);
        if (!(fabs(slow / fast - 1) < 1e-8))
            fail_msg("%s: %.12g and %.12g longer", kinds[k].name, slow, fast);
        if (!(fabs(twice / fast / 2 - 1) < kinds[k].nonlinearity))
            fail_msg("%s: twice the force stretches %.10g as far", kinds[k].name, twice / fast);
    }
}

static double wave_speed(const solid_kind *kind, bool longitudinal)
{
    const standing_wave wave = {kind->lattice, longitudinal};
    start s = rectangle(kind, STANDING_COLUMNS, STANDING_ROWS);
    for (int p = 0; p < s.sites.count; ++p)
        s.displacement[p] = standing_wave_at(&wave, s.sites.site[p]);
    return standing_wave_speed(&wave, made(kind, &s));
}

static void long_waves_run_at_the_speed_of_sound(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int longitudinal = 0; longitudinal < 2; ++longitudinal) {
            const double expected = longitudinal ? kinds[k].longitudinal : kinds[k].transverse;
            const double found = wave_speed(&kinds[k], longitudinal == 1);
            print_message("%-22s %-12s %.5f of %.5f\n", kinds[k].name,
                          longitudinal ? "longitudinal" : "transverse", found, expected);
            assert_close(found / expected, 1, STANDING_ERROR);
        }
}

static void walls_hold_without_loss(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int slanted = 0; slanted < 2; ++slanted) {
            start s = rectangle(&kinds[k], 8, 7);
            s.lattice.origin = (fw_vec2){-3.3, 4};
            for (int p = 0; p < s.sites.count; ++p) s.velocity[p] = (fw_vec2){0.01, -0.04};
            fw_solid *solid = made(&kinds[k], &s);
            fw_scene *scene;
            fw_error error;
            int body;
            assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
            assert_int_equal(fw_scene_adopt_body(scene, "body", solid, &body, NULL), FW_OK);
            const fw_vec2 ends[] = {{-200, slanted ? -30 : 0}, {200, slanted ? 30 : 0}};
            fw_wall_def def = fw_wall_def_default();
            def.name = "floor";
            def.shape = FW_CHAIN;
            def.points = ends;
            def.point_count = 2;
            assert_int_equal(fw_scene_add_wall(scene, &def, NULL), FW_OK);
            if (fw_scene_begin(scene, &error) != FW_OK) fail_msg("%s", error.sentence);
            const double kinetic = fw_solid_energies(solid).kinetic, before = energy_of(solid);
            const fw_vec2 p0 = fw_solid_momentum(solid);
            const int steps = ticks_for(&kinds[k], solid, 250) / solid->model->ticks_per_step;
            double deepest = 0, worst = 0;
            for (int step = 0; step < steps; ++step) {
                assert_int_equal(fw_scene_step(scene, &error), FW_OK);
                deepest = fmax(deepest, fw_scene_penetration(scene, -1));
                worst = fmax(worst, fabs(energy_of(solid) - before) / kinetic);
            }
            const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), p0);
            const fw_vec2 normal = {slanted ? -0.14834045293024465 : 0,
                                    slanted ? 0.98893635286829761 : 1};
            assert_true(fw_scene_wall_ledger(scene, 0)->held > 0);
            assert_true(fw_vec2_dot(gained, normal) > 0);
            assert_close(fw_vec2_dot(gained, fw_vec2_turn(normal)), 0, 1e-12 * hypot(p0.x, p0.y));
            assert_true(deepest <= (slanted ? 4e-15 : 0));
            /* An impact rings with all frequencies, and Verlet's error is that of the fastest. */
            if (!(worst < fmax(1e-11, 10 * kinds[k].energy_error)))
                fail_msg("%s: energy off by %g", kinds[k].name, worst);
            fw_scene_destroy(scene);
        }
}

static void restored_bodies_go_on_to_the_bit(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *one = shaken(&kinds[k], 9, 8, 0.02), *other = shaken(&kinds[k], 9, 8, 0.02);
        fw_state_list from = {0}, to = {0};
        for (int tick = 0; tick < 101; ++tick) {
            push_at_random(one, &kinds[k], 0.02);
            advance_free(one);
        }
        one->model->state(one, &from);
        other->model->state(other, &to);
        assert_int_equal(from.count, to.count);
        for (int n = 0; n < from.count; ++n)
            memcpy(to.array[n].data, from.array[n].data,
                   from.array[n].count * fw_element_size(from.array[n].element));
        restore(other);
        for (int tick = 0; tick < 51; ++tick) {
            push_at_random(one, &kinds[k], 0.02);
            push_at_random(other, &kinds[k], 0.02);
            advance_free(one);
            advance_free(other);
        }
        if (fw_state_list_hash(&from) != fw_state_list_hash(&to))
            fail_msg("%s: goes on otherwise", kinds[k].name);
        fw_solid_destroy(one);
        fw_solid_destroy(other);
    }
}

static uint64_t hash_with(const solid_kind *kind, int threads)
{
    omp_set_num_threads(threads);
    /* More cells of a colour, and chunks of particles, than one thread takes at a time. */
    const bool half = kind->lattice == FW_SQUARE;
    fw_solid *solid = shaken(kind, half ? 186 : 90, half ? 180 : 80, 0.02);
    for (int tick = 0; tick < 12; ++tick) {
        push_at_random(solid, kind, 0.02);
        advance_free(solid);
    }
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    const uint64_t hash = fw_state_list_hash(&list);
    fw_solid_destroy(solid);
    omp_set_num_threads(1);
    return hash;
}

static void bytes_do_not_depend_on_threads(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        const uint64_t hash = hash_with(&kinds[k], 1);
        for (int threads = 2; threads <= 3; ++threads)
            if (hash_with(&kinds[k], threads) != hash)
                fail_msg("%s: other bytes with %d threads", kinds[k].name, threads);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_bodies_keep_momentum),
        cmocka_unit_test(free_bodies_keep_energy),
        cmocka_unit_test(rigid_motion_does_not_ring),
        cmocka_unit_test(ledger_balances_under_loads_and_damping),
        cmocka_unit_test(pulled_bodies_rest_where_damping_has_no_say),
        cmocka_unit_test(long_waves_run_at_the_speed_of_sound),
        cmocka_unit_test(walls_hold_without_loss),
        cmocka_unit_test(restored_bodies_go_on_to_the_bit),
        cmocka_unit_test(bytes_do_not_depend_on_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
