/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_limits.c - how long a time step movable particles allow: that of the start as it
 * is, and of the bath that acts. */
#include "tests/support/laws.h"

#include "core/particles/particles.h"
#include "tests/support/crowd.h"

#include <string.h>

typedef struct pair_start {
    double distance, time_step, damping, temperature;
} pair_start;

static fw_status make_pair(fw_solid **solid, pair_start from, fw_pair_potential potential,
                           fw_error *error)
{
    const fw_vec2 positions[] = {{0.3, 0.2},
                                 {0.3 + 0.8 * from.distance, 0.2 + 0.6 * from.distance}};
    fw_particle_group_def group = fw_particle_group_def_default();
    group.name = "pair";
    group.count = 2;
    group.positions = positions;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.potential = potential;
    def.controls = (fw_langevin_controls){from.time_step, from.damping, from.temperature};
    def.overlap_energy = INFINITY;
    return fw_particles_create(solid, &def, error);
}

static fw_pair_potential morse(double steepness)
{
    fw_pair_potential potential = fw_pair_potential_default();
    potential.kind = FW_MORSE;
    potential.steepness = steepness;
    return potential;
}

/* U'' is the slope of the force, also where the potential is cut. */
static void curvature_is_the_slope_of_the_force(void **state)
{
    (void)state;
    const fw_pair_potential kinds[] = {fw_pair_potential_default(), morse(6)};
    for (int k = 0; k < 2; ++k) {
        assert_close(fw_pair_potential_curvature(&kinds[k], 1), 72, 1e-11);
        assert_true(fw_pair_potential_curvature(&kinds[k], 1.7) == 0);
        for (double r = 0.6; r < 1.69; r += 0.05) {
            const double h = 1e-6, out = r + h, in = r - h;
            const double slope = (in * fw_pair_at(&kinds[k], in * in).push -
                                  out * fw_pair_at(&kinds[k], out * out).push) /
                                 (2 * h);
            assert_close(fw_pair_potential_curvature(&kinds[k], r), slope,
                         1e-4 * fmax(1, fabs(slope)));
        }
    }
}

/* Of pairs further apart than that none has a larger U'' or U'/r. */
static void no_pair_is_stiffer_than_the_stiffest(void **state)
{
    (void)state;
    const fw_pair_potential jones = fw_pair_potential_default();
    fw_pair_potential kinds[] = {jones, morse(6), morse(1), jones, morse(1), jones, morse(4)};
    kinds[3].cut = fw_smooth_cut_over(1, 1.05);
    kinds[4].cut = fw_smooth_cut_over(1, 1.5);
    kinds[5].cut = kinds[6].cut = fw_smooth_cut_over(5, 5);
    for (int k = 0; k < 7; ++k)
        for (double closest = 0.5; closest < 1.8; closest += 0.1) {
            const double stiffest = fw_pair_potential_stiffest(&kinds[k], closest);
            for (double r = closest; r < 1.8; r += 0.003) {
                assert_true(fw_pair_potential_curvature(&kinds[k], r) <= stiffest);
                assert_true(-fw_pair_at(&kinds[k], r * r).push <= stiffest);
            }
        }
}

/* A free pair is one oscillator, omega^2 = 2 U''/m: Verlet's step must be below 2/omega. */
static void an_overlap_shortens_the_time_step(void **state)
{
    (void)state;
    const double distances[] = {1, 0.9, 0.8, 0.7};
    const fw_pair_potential potential = fw_pair_potential_default();
    for (int n = 0; n < 4; ++n) {
        fw_solid *solid;
        fw_error error;
        const double limit = sqrt(2 / fw_pair_potential_curvature(&potential, distances[n]));
        pair_start from = {.distance = distances[n], .time_step = 0.99 * fmin(limit, 0.0962)};
        assert_int_equal(make_pair(&solid, from, potential, &error), FW_OK);
        assert_close(fw_particles_start_limit(solid, NULL), limit, 1e-12);
        fw_solid_destroy(solid);
        from.time_step = 0.05;
        const fw_status status = make_pair(&solid, from, potential, &error);
        assert_int_equal(status, limit > 0.05 ? FW_OK : FW_BAD_INPUT);
        if (status == FW_OK)
            fw_solid_destroy(solid);
        else
            assert_non_null(strstr(error.sentence, "particle 0 of body 'pair' starts so near"));
    }
}

static fw_status make_crystal(fw_solid **solid, double spacing, double time_step, fw_error *error)
{
    fw_crowd crowd = crowd_rectangle(9, 9, (fw_vec2){0, 0}, spacing, 0, 1);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls.time_step = time_step;
    def.overlap_energy = INFINITY;
    const fw_status status = fw_particles_create(solid, &def, error);
    free(crowd.at);
    return status;
}

/* Inside, all of a particle's neighbours add up. */
static void a_pressed_crystal_shortens_the_time_step(void **state)
{
    (void)state;
    const double spacings[] = {0.95, 0.8, 0.6};
    for (int n = 0; n < 3; ++n) {
        fw_solid *solid;
        fw_error error;
        assert_int_equal(make_crystal(&solid, spacings[n], 1e-6, &error), FW_OK);
        const double limit = fw_particles_start_limit(solid, NULL);
        fw_solid_destroy(solid);
        assert_int_equal(make_crystal(&solid, spacings[n], 0.99 * limit, &error), FW_OK);
        fw_solid_destroy(solid);
        assert_int_equal(make_crystal(&solid, spacings[n], 1.01 * limit, &error), FW_BAD_INPUT);
        assert_non_null(strstr(error.sentence, "starts so near to its neighbours"));
    }
}

/* Rows that shake along themselves, each against the next, are the fastest wave of a crystal that
 * only return forces keep: m omega^2 = 6 n f0/r0. */
static void return_forces_limit_the_time_step(void **state)
{
    (void)state;
    enum { SIDE = 9, MIDDLE = SIDE * (SIDE / 2) + SIDE / 2 };
    const double amplitude = 2, shake = 1e-6, fastest = 6 * (6 * amplitude);
    fw_crowd crowd = crowd_rectangle(SIDE, SIDE, (fw_vec2){0, 0}, 1, 0, 1);
    for (int i = 0; i < crowd.count; ++i) crowd.at[i].x += i / SIDE % 2 ? -shake : shake;
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    group.strength = 0;
    group.return_force = return_force_of(6, amplitude, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_solid *solid;
    fw_error error;
    assert_int_equal(fw_particles_create(&solid, &def, &error), FW_OK);
    assert_close(((const fw_langevin *)solid)->force_x[MIDDLE] / (-fastest * shake), 1, 1e-5);
    assert_close(fw_particles_time_step_limit(&def), 2 / sqrt(fastest), 1e-14);
    fw_solid_destroy(solid);
    free(crowd.at);
}

/* At 10 T above the well U'' is 2 m/dt^2: for Lennard-Jones and dt = .005 that is 18.86. */
static void a_bath_too_hot_is_refused(void **state)
{
    (void)state;
    const fw_pair_potential potential = fw_pair_potential_default();
    pair_start from = {.distance = 1, .time_step = 0.005, .damping = 1, .temperature = 18.8};
    fw_solid *solid;
    fw_error error;
    assert_close(fw_pair_potential_hottest(&potential, 1, 1, 0.005), 18.86, 0.01);
    assert_int_equal(make_pair(&solid, from, potential, &error), FW_OK);
    assert_int_equal(fw_langevin_set_bath(solid, 1, 1e9, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "the temperature is 1e+09, expected at most 18.86"));
    assert_int_equal(fw_particles_set_temperature(solid, 19, &error), FW_BAD_INPUT);
    assert_int_equal(fw_langevin_set_bath(solid, 0, 1e9, &error), FW_OK);
    fw_solid_destroy(solid);
    from.temperature = 18.9;
    assert_int_equal(make_pair(&solid, from, potential, &error), FW_BAD_INPUT);
    from.damping = 0;
    assert_int_equal(make_pair(&solid, from, potential, &error), FW_OK);
    fw_solid_destroy(solid);
    /* The core of a Morse bond is finite: this one is never too stiff. */
    from.damping = 1;
    from.temperature = 1e9;
    assert_int_equal(make_pair(&solid, from, morse(3), &error), FW_OK);
    fw_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curvature_is_the_slope_of_the_force),
        cmocka_unit_test(no_pair_is_stiffer_than_the_stiffest),
        cmocka_unit_test(an_overlap_shortens_the_time_step),
        cmocka_unit_test(a_pressed_crystal_shortens_the_time_step),
        cmocka_unit_test(return_forces_limit_the_time_step),
        cmocka_unit_test(a_bath_too_hot_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
