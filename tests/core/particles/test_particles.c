/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particles.c - the laws of movable lattice particles in motion. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include <omp.h>
#include <string.h>

static fw_langevin *motion(fw_solid *solid)
{
    return (fw_langevin *)solid;
}

static void run(fw_solid *solid, int steps)
{
    for (int step = 0; step < steps; ++step) advance_free(solid);
}

/* A pair 8 degrees off its axis comes to rest on the axis: the sign that Eq 18 should have. */
static void pair_turns_to_its_axis(void **state)
{
    (void)state;
    const double degree = FW_PI / 180;
    for (int fold = 4; fold <= 6; fold += 2) {
        fw_crowd pair = {2, malloc(2 * sizeof *pair.at)};
        pair.at[0] = (fw_vec2){0, 0};
        pair.at[1] = (fw_vec2){cos(8 * degree), sin(8 * degree)};
        fw_solid *solid =
            solid_of(pair, return_force_of(fold, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                     (fw_langevin_controls){.time_step = 0.005, .damping = 1}, 1);
        run(solid, 20000);
        const double angle = atan2(solid->y[1] - solid->y[0], solid->x[1] - solid->x[0]) / degree;
        assert_close(angle, 0, 1e-3);
        fw_solid_destroy(solid);
    }
}

/* Without damping and whatever the axes, a hot free body keeps its momentum: 2000 steps of at most
 * 127 roundings of forces of some 30 times dt. */
static void free_body_keeps_its_momentum(void **state)
{
    (void)state;
    const fw_return_axes axes[] = {FW_AXES_LAB, FW_AXES_COROTATING, FW_AXES_SURFACE};
    for (int a = 0; a < 3; ++a)
        for (int variant = 0; variant < 2; ++variant) {
            fw_solid *solid = solid_of(crowd_disc(6, (fw_vec2){0, 0}, 0, 0.05, 3),
                                       return_force_of(6, 1, axes[a], (fw_return_variant)variant),
                                       (fw_langevin_controls){.time_step = 0.005}, 1);
            fw_particles_draw_velocities(solid, -1, 0.1);
            const fw_vec2 centre = solid->model->centre_of_mass(solid);
            assert_close(fw_solid_momentum(solid).x, 0, 1e-13);
            run(solid, 2000);
            assert_close(fw_solid_momentum(solid).x, 0, 1e-12);
            assert_close(fw_solid_momentum(solid).y, 0, 1e-12);
            assert_close(solid->model->centre_of_mass(solid).x, centre.x, 1e-12);
            fw_solid_destroy(solid);
        }
}

/* A disc with axes of its own spins through more than half a turn: angular momentum to 1e-9 and
 * energy to 1e-9 per particle (issue of the laws). It starts from the shape that it has while it
 * spins, since ringing would show Verlet's own error of order dt^2 of the ringing's energy. */
static void disc_spins_freely(void **state)
{
    (void)state;
    const double rate = 0.05;
    fw_solid *solid = solid_of(crowd_disc(5, (fw_vec2){0, 0}, 0, 0, 3),
                               return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){.time_step = 0.005, .damping = 1}, 1);
    /* At rest in the turning frame: the centrifugal force as a load, and damping. */
    solid->loaded = true;
    for (int step = 0; step < 40000; ++step) {
        for (int i = 0; i < solid->count; ++i) {
            solid->external_x[i] = rate * rate * solid->x[i];
            solid->external_y[i] = rate * rate * solid->y[i];
        }
        advance_free(solid);
    }
    solid->loaded = false;
    assert_int_equal(fw_particles_set_damping(solid, 0, NULL), FW_OK);
    for (int i = 0; i < solid->count; ++i) {
        motion(solid)->velocity_x[i] = -rate * solid->y[i];
        motion(solid)->velocity_y[i] = rate * solid->x[i];
    }
    const double energy = total_energy(solid), spin = angular_momentum(solid);
    const double from = atan2(solid->y[solid->count - 1], solid->x[solid->count - 1]);
    const double duration = 1.2 * FW_PI / rate;
    double worst_energy = 0, worst_spin = 0;
    const int steps = (int)(duration / 0.005);
    for (int step = 0; step < steps; ++step) {
        advance_free(solid);
        if (step % 100) continue;
        worst_energy = fmax(worst_energy, fabs(total_energy(solid) - energy) / solid->count);
        worst_spin = fmax(worst_spin, fabs(angular_momentum(solid) / spin - 1));
    }
    const double turned = atan2(solid->y[solid->count - 1], solid->x[solid->count - 1]) - from;
    assert_close(cos(turned), cos(1.2 * FW_PI), 1e-3);
    assert_close(sin(turned), sin(1.2 * FW_PI), 2e-3);
    print_message("spin: energy per particle %.2g, angular momentum %.2g\n", worst_energy,
                  worst_spin);
    assert_below(worst_energy, 1e-9);
    assert_below(worst_spin, 1e-9);
    fw_solid_destroy(solid);
}

/* Verlet's energy error is bounded and falls as dt^2: half the step, a quarter of the error. */
static void energy_error_falls_as_the_square_of_the_step(void **state)
{
    (void)state;
    double worst[2];
    for (int fine = 0; fine < 2; ++fine) {
        const double dt = fine ? 0.0025 : 0.005;
        fw_solid *solid = solid_of(crowd_disc(4, (fw_vec2){0, 0}, 0, 0, 3),
                                   return_force_of(6, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                                   (fw_langevin_controls){.time_step = dt}, 1);
        fw_particles_draw_velocities(solid, -1, 0.02);
        const double energy = total_energy(solid);
        worst[fine] = 0;
        for (int step = 0; step < (fine ? 2000 : 1000); ++step) {
            advance_free(solid);
            worst[fine] = fmax(worst[fine], fabs(total_energy(solid) - energy));
        }
        fw_solid_destroy(solid);
    }
    assert_close(worst[0] / worst[1], 4, 0.3);
}

/* The ledger of a damped, shaken and loaded body: what it has gained is work - drag + noise, up to
 * Verlet's error, which is shown to be of order dt^2; its momentum likewise, to rounding. */
static void ledger_closes(void **state)
{
    (void)state;
    double open[2];
    for (int fine = 0; fine < 2; ++fine) {
        const double dt = fine ? 0.0025 : 0.005;
        fw_solid *solid = solid_of(
            crowd_disc(4, (fw_vec2){0, 0}, 0, 0, 3),
            return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE),
            (fw_langevin_controls){.time_step = dt, .damping = 0.3, .temperature = 0.05}, 9);
        solid->loaded = true;
        for (int i = 0; i < solid->count; ++i) {
            solid->external_x[i] = 0.1 * solid->x[i];
            solid->external_y[i] = -0.05;
        }
        const double energy = total_energy(solid);
        open[fine] = 0;
        for (int step = 0; step < (fine ? 4000 : 2000); ++step) {
            advance_free(solid);
            const fw_solid_ledger *ledger = &solid->ledger;
            const double gained = total_energy(solid) - energy;
            const double gap = gained - (ledger->work - ledger->dissipated + ledger->heat);
            open[fine] = fmax(open[fine], fabs(gap));
            const fw_vec2 momentum = fw_solid_momentum(solid);
            assert_close(momentum.x, ledger->impulse.x + ledger->drag.x, 1e-11);
            assert_close(momentum.y, ledger->impulse.y + ledger->drag.y, 1e-11);
        }
        assert_true(solid->ledger.heat > 1 && solid->ledger.dissipated > 1);
        print_message("ledger open by %.2g at dt %g\n", open[fine], dt);
        fw_solid_destroy(solid);
    }
    assert_below(open[0], 0.02);
    assert_below(open[1], 0.4 * open[0]);
}

/* Predict is what advance does, and a force of contact moves a particle by mobility F. */
static void prediction_is_what_happens(void **state)
{
    (void)state;
    fw_solid *solid =
        solid_of(crowd_disc(2, (fw_vec2){5, 5}, 0, 0.05, 3),
                 return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE),
                 (fw_langevin_controls){.time_step = 0.005, .damping = 0.7, .temperature = 0.2}, 4);
    enum { COUNT = 19 };
    assert_int_equal(solid->count, COUNT);
    int all[COUNT];
    fw_prediction predicted[COUNT];
    double x[COUNT], y[COUNT];
    solid->loaded = true;
    for (int i = 0; i < COUNT; ++i) all[i] = i, solid->external_x[i] = 0.3 * i;
    for (int step = 0; step < 50; ++step) {
        fw_solid_predict(solid, all, COUNT, predicted);
        memcpy(x, solid->x, sizeof x);
        memcpy(y, solid->y, sizeof y);
        /* Particle 3 is pushed, particle 7 is held, particle 8 held in y only. */
        const fw_vec2 push = {2, -3};
        fw_constraint constraints[3] = {
            {3, fw_vec2_add(predicted[3].displacement, fw_sym2_apply(predicted[3].mobility, push)),
             push},
            {7, {0, 0}, fw_vec2_scale(-1 / predicted[7].mobility.xx, predicted[7].displacement)},
            {8,
             {predicted[8].displacement.x, 0},
             {0, -predicted[8].displacement.y / predicted[8].mobility.yy}}};
        const double before = motion(solid)->velocity_y[8];
        const double force_before = motion(solid)->force_y[8];
        advance_held(solid, constraints, 3);
        for (int i = 0; i < COUNT; ++i) {
            fw_vec2 expected = predicted[i].displacement;
            for (int h = 0; h < 3; ++h)
                if (constraints[h].particle == i) expected = constraints[h].displacement;
            assert_close(solid->x[i] - x[i], expected.x, 1e-15 * 8);
            assert_close(solid->y[i] - y[i], expected.y, 1e-15 * 8);
        }
        assert_true(solid->x[7] == x[7] && solid->y[7] == y[7] && solid->y[8] == y[8]);
        /* What is held has its velocity reversed, up to the change of the other forces. */
        const double change = motion(solid)->force_y[8] - force_before;
        assert_close(motion(solid)->velocity_y[8], -before + 0.0025 * change, 1e-13);
    }
    fw_solid_destroy(solid);
}

/* Heat bath and free flight: kinetic temperature T and mean square displacement 2 T/(m damping) (t
 * - (1 - e^{-damping t})/damping) per component of free particles (Ornstein and Uhlenbeck), within
 * 4 standard errors of what 4000 of them can show. */
static void free_particles_diffuse(void **state)
{
    (void)state;
    enum { COUNT = 4000 };
    const double temperature = 0.5, damping = 2, dt = 0.01, duration = 5;
    fw_crowd crowd = crowd_rectangle(80, 50, (fw_vec2){0, 0}, 10, 0, 1);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    group.strength = 0;
    group.mass = 2;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls = (fw_langevin_controls){dt, damping, temperature};
    def.seed = 5;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    fw_particles_draw_velocities(solid, -1, temperature);
    run(solid, (int)(duration / dt + 0.5));
    double square = 0;
    for (int i = 0; i < COUNT; ++i) {
        const double dx = solid->x[i] - crowd.at[i].x, dy = solid->y[i] - crowd.at[i].y;
        square += dx * dx + dy * dy;
    }
    const double tau = 1 / damping;
    const double exact =
        4 * temperature / (group.mass * damping) * (duration - tau * (1 - exp(-duration / tau)));
    /* Sum of squares of 2 N Gaussians: relative standard error sqrt(2 / 2 N). */
    assert_close(square / COUNT / exact, 1, 4 / sqrt(COUNT));
    assert_close(fw_solid_energies(solid).kinetic / COUNT / temperature, 1, 4 / sqrt(COUNT));
    fw_solid_destroy(solid);
    free(crowd.at);
}

/* One restless scene of three bodies with all kinds of axes, for the tests of bytes. */
static fw_solid *three_bodies(double skin)
{
    fw_crowd crowd[3];
    fw_particle_group_def groups[3];
    const char *names[] = {"a", "b", "c"};
    for (int g = 0; g < 3; ++g) {
        crowd[g] =
            crowd_rectangle(60, 40, (fw_vec2){61. * g, 0.3 * g}, 1, 0.05, (uint64_t)(20 + g));
        groups[g] = fw_particle_group_def_default();
        groups[g].name = names[g];
        groups[g].count = crowd[g].count;
        groups[g].positions = crowd[g].at;
        groups[g].return_force = return_force_of(6, 1, (fw_return_axes)g, FW_RETURN_CONSERVATIVE);
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 3;
    def.margin = skin;
    def.controls = (fw_langevin_controls){0.005, 0.5, 0.4};
    def.seed = 123456789;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    for (int g = 0; g < 3; ++g) free(crowd[g].at);
    return solid;
}

static void bytes_do_not_depend_on_threads(void **state)
{
    (void)state;
    uint64_t hash[2];
    double energy[2];
    const int before = omp_get_max_threads();
    for (int threads = 1; threads <= 2; ++threads) {
        omp_set_num_threads(threads);
        fw_solid *solid = three_bodies(0.3);
        run(solid, 60);
        hash[threads - 1] = fingerprint(solid);
        energy[threads - 1] = total_energy(solid);
        fw_solid_destroy(solid);
    }
    omp_set_num_threads(before);
    assert_true(hash[0] == hash[1]);
    assert_true(energy[0] == energy[1]);
}

static void bytes_do_not_depend_on_when_lists_are_made(void **state)
{
    (void)state;
    uint64_t hash[3];
    const double skins[] = {0, 0.2, 0.7};
    for (int s = 0; s < 3; ++s) {
        fw_solid *solid = three_bodies(skins[s]);
        run(solid, 40);
        hash[s] = fingerprint(solid);
        fw_solid_destroy(solid);
    }
    assert_true(hash[0] == hash[1]);
    assert_true(hash[0] == hash[2]);
}

/* The state list is the whole state: written into a fresh solid, it goes on to the same bytes. */
static void resumed_is_uninterrupted(void **state)
{
    (void)state;
    fw_solid *whole = three_bodies(0.3), *first = three_bodies(0.3), *second = three_bodies(0.3);
    run(whole, 40);
    run(first, 25);
    fw_error error;
    assert_int_equal(fw_particles_set_damping(first, 0.1, &error), FW_OK);
    assert_int_equal(fw_particles_set_amplitude(first, 1, 0.6, &error), FW_OK);
    fw_state_list from = {0}, to = {0};
    first->model->state(first, &from);
    second->model->state(second, &to);
    assert_int_equal(from.count, to.count);
    for (int a = 0; a < from.count; ++a)
        memcpy(to.array[a].data, from.array[a].data,
               from.array[a].count * fw_element_size(from.array[a].element));
    restore(second);
    run(first, 15);
    run(second, 15);
    assert_true(fingerprint(first) == fingerprint(second));
    assert_true(fingerprint(first) != fingerprint(whole));
    fw_solid_destroy(whole);
    fw_solid_destroy(first);
    fw_solid_destroy(second);
}

/* Each of these gets its sentence. */
static void assert_refused(const fw_particles_def *def, const char *words)
{
    fw_solid *solid;
    fw_error error;
    assert_int_equal(fw_particles_create(&solid, def, &error), FW_BAD_INPUT);
    assert_null(solid);
    if (!strstr(error.sentence, words)) fail_msg("'%s' lacks '%s'", error.sentence, words);
}

static void impossible_solids_are_refused(void **state)
{
    (void)state;
    fw_vec2 positions[] = {{0, 0}, {1, 0}, {0.5, 0.9}};
    fw_particle_group_def groups[2] = {fw_particle_group_def_default(),
                                       fw_particle_group_def_default()};
    groups[0].count = 3;
    groups[0].positions = positions;
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 1;
    def.controls.time_step = 0.1;
    assert_refused(&def, "the time step is 0.1, expected less than 0.09623");
    def.controls.time_step = NAN;
    assert_refused(&def, "the time step is nan");
    def.controls.time_step = 0.005;
    def.controls.damping = -1;
    assert_refused(&def, "the damping is -1");
    def.controls.damping = 0;
    def.controls.temperature = -0.1;
    assert_refused(&def, "the temperature is -0.1");
    def.controls.temperature = 0;
    groups[0].return_force.fold = 3;
    assert_refused(&def, "body 'body': the return force has the odd fold 3");
    groups[0].return_force.fold = 6;
    groups[0].mass = 0;
    assert_refused(&def, "mass 0");
    groups[0].mass = 1;
    positions[2].x = INFINITY;
    assert_refused(&def, "particle 2 lies at [inf, 0.9]");
    positions[2] = (fw_vec2){0.5, 0.1};
    assert_refused(&def, "particle 0 of body 'body' and particle 2 of body 'body' overlap: at "
                         "distance 0.5099 their energy is");
    positions[2] = positions[0];
    assert_refused(&def, "overlap: at distance 0 their energy");
    positions[2] = (fw_vec2){0.5, 0.9};
    groups[1] = groups[0];
    def.group_count = 2;
    assert_refused(&def, "two bodies are called 'body'");
    def.group_count = 0;
    assert_refused(&def, "no bodies");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pair_turns_to_its_axis),
        cmocka_unit_test(free_body_keeps_its_momentum),
        cmocka_unit_test(disc_spins_freely),
        cmocka_unit_test(energy_error_falls_as_the_square_of_the_step),
        cmocka_unit_test(ledger_closes),
        cmocka_unit_test(prediction_is_what_happens),
        cmocka_unit_test(free_particles_diffuse),
        cmocka_unit_test(bytes_do_not_depend_on_threads),
        cmocka_unit_test(bytes_do_not_depend_on_when_lists_are_made),
        cmocka_unit_test(resumed_is_uninterrupted),
        cmocka_unit_test(impossible_solids_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
