/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_core_short_memory.c - every allocation of core fails once: whoever asked says so or comes to
 * the same bytes without, and nothing is left behind. Start reading at the tests, at the end. */
#include "tests/support/short_memory.h"

#include "core/automaton/automaton_dispersion.h"
#include "core/averages.h"
#include "core/boltzmann/lb_dispersion.h"
#include "core/particles/neighbours.h"
#include "core/particles/particle_observables.h"
#include "core/particles/structure.h"
#include "core/particles/surroundings.h"
#include "core/placement.h"
#include "tests/support/solids.h"

#include <gsl/gsl_errno.h>
#include <omp.h>

static uint64_t hash_of(const char *name, fw_element element, size_t count, const void *data)
{
    fw_state_list list = {0};
    fw_state_list_add(&list, name, element, count, (void *)(uintptr_t)data);
    return fw_state_list_hash(&list);
}

/* --- sets of points, series, waves --- */

static fw_status make_sites(const void *input, uint64_t *result, fw_error *error)
{
    static const fw_site list[] = {{3, 1}, {0, 0}, {1, 0}};
    const int shape = *(const int *)input;
    fw_sites sites;
    if (shape == 0) FW_TRY(fw_sites_rectangle(&sites, 5, 4, error));
    if (shape == 1) FW_TRY(fw_sites_disc(&sites, FW_HEXAGONAL, 2.5, error));
    if (shape == 2) FW_TRY(fw_sites_list(&sites, list, 3, error));
    if (shape == 3) FW_TRY(fw_sites_mask(&sites, "##.\n.##\n", error));
    *result = hash_of("sites", FW_I32, 2 * (size_t)sites.count, sites.site);
    fw_sites_clear(&sites);
    return FW_OK;
}

static fw_status place_points(const void *input, uint64_t *result, fw_error *error)
{
    (void)input;
    fw_vec2 points[20];
    FW_TRY(fw_placement_random(points, 20, (fw_vec2){0, 0}, (fw_vec2){9, 8}, 0.7, 1, error));
    *result = hash_of("points", FW_F64, 40, points);
    return FW_OK;
}

static fw_status average(const void *input, uint64_t *result, fw_error *error)
{
    double number[3];
    fw_average of;
    FW_TRY(fw_average_of_series(&of, input, 100, error));
    FW_TRY(fw_average_drift(&number[2], input, 100, error));
    number[0] = of.mean;
    number[1] = of.error;
    *result = hash_of("averages", FW_F64, 3, number);
    return FW_OK;
}

static fw_status find_waves(const void *input, uint64_t *result, fw_error *error)
{
    (void)input;
    fw_lb_spectrum spectrum;
    FW_TRY(fw_lb_spectrum_over_grid(fw_sym2_scalar(0.8), 3, &spectrum, error));
    fw_automaton_matrices matrices;
    FW_TRY(fw_automaton_matrices_make(&matrices, (fw_automaton_speeds){0.9, 0.5}, 0, error));
    fw_automaton_mode mode[FW_MODES];
    FW_TRY(fw_automaton_modes(&matrices, (fw_vec2){0.4, 0.3}, mode, error));
    const double number[4] = {spectrum.frequency_error, spectrum.radius_error, mode[0].frequency,
                              mode[1].frequency};
    *result = hash_of("waves", FW_F64, 4, number);
    return FW_OK;
}

/* What surrounds the points of a ragged set. */
static fw_status look_around(const void *input, uint64_t *result, fw_error *error)
{
    enum { COUNT = 60, MAP = 5 };
    const double *x = input, *y = x + COUNT;
    const int folds[] = {4, 6};
    double values[4 * COUNT + MAP * MAP] = {0};
    uint8_t members[COUNT];
    int found;
    fw_neighbours *neighbours;
    FW_TRY(fw_surroundings_order(x, y, COUNT, 1.5, folds, 2, values, error));
    FW_TRY(fw_surroundings_density(x, y, COUNT, 1, values + 2 * COUNT, error));
    FW_TRY(fw_surroundings_cluster(x, y, COUNT, 0.8, members, &found, error));
    FW_TRY(fw_structure_map(x, y, COUNT, 1, 0.5, MAP, values + 4 * COUNT, error));
    FW_TRY(fw_neighbours_create(&neighbours, x, y, COUNT, 1.2, error));
    for (int p = 0; p < COUNT; ++p)
        values[3 * COUNT + p] = members[p] + found + (double)neighbours->begin[p + 1];
    fw_neighbours_destroy(neighbours);
    *result = hash_of("around", FW_F64, 4 * COUNT + MAP * MAP, values);
    return FW_OK;
}

/* --- solids --- */

/* Some ticks of every kind, and what comes of them. */
static fw_status live(fw_solid *solid, uint64_t *result, fw_error *error)
{
    const fw_constraint held[] = {{.particle = solid->boundary[0]},
                                  {.particle = solid->boundary[solid->boundary_count - 1]}};
    bool changed;
    for (int tick = 0; tick < 4; ++tick) {
        FW_TRY(fw_solid_advance_free(solid, error));
        FW_TRY(fw_solid_advance(solid, held, 2, error));
    }
    if (solid->model->list_links) FW_TRY(solid->model->list_links(solid, &changed, error));
    FW_TRY(fw_solid_restored(solid, error));
    FW_TRY(fw_solid_move_free(solid, 4, error));
    fw_solid_place(solid);
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    *result = fw_state_list_hash(&list);
    return FW_OK;
}

static fw_status live_and_die(fw_solid *solid, uint64_t *result, fw_error *error)
{
    const fw_status status = live(solid, result, error);
    fw_solid_destroy(solid);
    return status;
}

static fw_status make_boltzmann_body(const void *input, uint64_t *result, fw_error *error)
{
    fw_solid *solid;
    FW_TRY(fw_lb_solid_create(&solid, input, error));
    return live_and_die(solid, result, error);
}

static fw_status make_automaton_body(const void *input, uint64_t *result, fw_error *error)
{
    fw_solid *solid;
    FW_TRY(fw_elastic_automaton_create(&solid, input, error));
    return live_and_die(solid, result, error);
}

static fw_status find_spectral_radius(const void *input, uint64_t *result, fw_error *error)
{
    double radius = 0;
    FW_TRY(fw_elastic_automaton_spectral_radius(input, &radius, error));
    *result = hash_of("radius", FW_F64, 1, &radius);
    return FW_OK;
}

/* An unstable body is refused all the same. */
static fw_status judge_stability(const void *input, uint64_t *result, fw_error *error)
{
    fw_solid *solid = NULL;
    const fw_status status = fw_elastic_automaton_create(&solid, input, error);
    fw_solid_destroy(solid);
    *result = (uint64_t)status;
    return status == FW_BAD_INPUT ? FW_OK : status;
}

static fw_status make_linear_body(const void *input, uint64_t *result, fw_error *error)
{
    fw_solid *solid;
    FW_TRY(fw_linear_lattice_create(&solid, input, error));
    return live_and_die(solid, result, error);
}

/* Lists are made anew when particles are where others were, and grow when they come closer. */
static fw_status crowd(fw_solid *solid, uint64_t *result, fw_error *error)
{
    double number[4] = {0};
    for (int p = 0; p < solid->count; ++p) {
        solid->x[p] *= 0.8;
        solid->y[p] *= 0.8;
    }
    FW_TRY(fw_solid_restored(solid, error));
    FW_TRY(fw_particle_pair_correlation(solid, 0, 1, 0.5, 4, number, error));
    FW_TRY(live(solid, result, error));
    *result += hash_of("correlation", FW_F64, 4, number);
    return FW_OK;
}

static fw_status make_particle_body(const void *input, uint64_t *result, fw_error *error)
{
    fw_solid *solid;
    FW_TRY(fw_particles_create(&solid, input, error));
    const fw_status status = crowd(solid, result, error);
    fw_solid_destroy(solid);
    return status;
}

/* --- the tests --- */

static void sites_say_that_memory_is_missing(void **state)
{
    (void)state;
    for (int shape = 0; shape < 4; ++shape)
        assert_true(fail_each_allocation("sites", make_sites, &shape) > 0);
}

static void points_and_series_say_that_memory_is_missing(void **state)
{
    (void)state;
    double numbers[120];
    for (uint32_t n = 0; n < 120; ++n) numbers[n] = 4 * fw_noise_uniform(1, n, 0, 1).x;
    assert_true(fail_each_allocation("a placement", place_points, NULL) == 2);
    assert_true(fail_each_allocation("averages", average, numbers) > 1);
    assert_true(fail_each_allocation("waves", find_waves, NULL) == 5);
    assert_true(fail_each_allocation("surroundings", look_around, numbers) > 12);
}

static void boltzmann_solid_says_that_memory_is_missing(void **state)
{
    (void)state;
    start s = rectangle(&kinds[0], 9, 8);
    shake(&s, 0.02, 0.02);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &s.sites;
    def.rest_mass = fw_sym2_scalar(0.8);
    def.displacement = s.displacement;
    def.velocity = s.velocity;
    assert_true(fail_each_allocation("populations", make_boltzmann_body, &def) >= 3);
    def.form = FW_LB_DISPLACEMENTS;
    assert_true(fail_each_allocation("displacements", make_boltzmann_body, &def) >= 5);
    def.form = FW_LB_POPULATIONS;
    def.break_at = 0.03;
    assert_true(fail_each_allocation("breaking links", make_boltzmann_body, &def) >= 3);
    release_start(&s);
}

static void automaton_says_that_memory_is_missing(void **state)
{
    (void)state;
    start s = rectangle(&kinds[2], 9, 8);
    shake(&s, 0.02, 0.02);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &s.sites;
    def.speeds = (fw_automaton_speeds){0.6, 0.3};
    def.displacement = s.displacement;
    def.velocity = s.velocity;
    assert_true(fail_each_allocation("automaton", make_automaton_body, &def) >= 8);
    def.break_at = 0.02;
    assert_true(fail_each_allocation("breaking bonds", make_automaton_body, &def) >= 8);
    def.break_at = INFINITY;
    def.boundary = FW_BOUNDARY_TRAPEZOID;
    def.speeds = (fw_automaton_speeds){0.9, 0.5};
    assert_true(fail_each_allocation("trapezoid", make_automaton_body, &def) >= 8);
    assert_true(fail_each_allocation("spectral radius", find_spectral_radius, &def) >= 8);
    for (int side = -1; side <= 1;
         side += 2) { /* of what is stable: see test_automaton_stability */
        def.speeds = (fw_automaton_speeds){0.6, sqrt(2) * 0.6 * (1 + 0.02 * side)};
        assert_true(fail_each_allocation("stability", judge_stability, &def) >= 12);
    }
    def.boundary = FW_BOUNDARY_MIRROR;
    assert_true(fail_each_allocation("mirror", find_spectral_radius, &def) >= 8);
    release_start(&s);
}

static void linear_lattice_says_that_memory_is_missing(void **state)
{
    (void)state;
    start s = rectangle(&kinds[5], 9, 8);
    shake(&s, 0.02, 0.02);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.lattice = s.lattice;
    def.sites = &s.sites;
    def.displacements = s.displacement;
    def.velocities = s.velocity;
    assert_true(fail_each_allocation("linear lattice", make_linear_body, &def) >= 4);
    release_start(&s);
}

static void particles_say_that_memory_is_missing(void **state)
{
    (void)state;
    start s = rectangle(&kinds[6], 9, 8);
    fw_vec2 *positions = calloc((size_t)s.sites.count, sizeof *positions);
    for (int p = 0; p < s.sites.count; ++p)
        positions[p] = fw_lattice_position(&s.lattice, s.sites.site[p]);
    fw_particle_group_def groups[2] = {fw_particle_group_def_default(),
                                       fw_particle_group_def_default()};
    for (int g = 0; g < 2; ++g) {
        groups[g].name = g == 0 ? "left" : "right";
        groups[g].count = g == 0 ? 40 : s.sites.count - 40;
        groups[g].positions = g == 0 ? positions : positions + 40;
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    assert_true(fail_each_allocation("movable particles", make_particle_body, &def) >= 10);
    free(positions);
    release_start(&s);
}

static void called(const char *reason, const char *file, int line, int number)
{
    (void)number;
    fail_msg("%s:%d: %s", file, line, reason);
}

/* The handler of a program around is as before, whatever failed. */
static void handler_of_gsl_is_put_back(void **state)
{
    gsl_error_handler_t *standard = gsl_set_error_handler(called);
    boltzmann_solid_says_that_memory_is_missing(state);
    automaton_says_that_memory_is_missing(state);
    assert_ptr_equal(gsl_set_error_handler(standard), called);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sites_say_that_memory_is_missing),
        cmocka_unit_test(points_and_series_say_that_memory_is_missing),
        cmocka_unit_test(boltzmann_solid_says_that_memory_is_missing),
        cmocka_unit_test(automaton_says_that_memory_is_missing),
        cmocka_unit_test(linear_lattice_says_that_memory_is_missing),
        cmocka_unit_test(particles_say_that_memory_is_missing),
        cmocka_unit_test(handler_of_gsl_is_put_back),
    };
    omp_set_num_threads(1); /* allocations come in one order */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
