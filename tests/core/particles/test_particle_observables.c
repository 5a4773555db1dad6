/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_observables.c - measures of movable particles on bodies where they are known. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include "core/particles/particle_observables.h"
#include "core/particles/structure.h"
#include "core/particles/surroundings.h"
#include "core/placement.h"

#include <string.h>

static const fw_langevin_controls still = {.time_step = 0.005};

/* Energy of the body after x' = x + e x or x + e y (or the same for y), every particle. */
static double energy_strained(fw_solid *solid, int which, double e)
{
    const size_t bytes = (size_t)solid->count * sizeof(double);
    double *x = malloc(bytes), *y = malloc(bytes);
    memcpy(x, solid->x, bytes);
    memcpy(y, solid->y, bytes);
    for (int i = 0; i < solid->count; ++i) {
        if (which < 2) solid->x[i] += e * (which == 0 ? x[i] : y[i]);
        if (which >= 2) solid->y[i] += e * (which == 2 ? x[i] : y[i]);
    }
    restore(solid);
    const double energy = fw_solid_energies(solid).elastic;
    memcpy(solid->x, x, bytes);
    memcpy(solid->y, y, bytes);
    restore(solid);
    free(x);
    free(y);
    return energy;
}

/* A strain e does the work -virial . e: all four components, potential and return forces. */
static void virial_is_the_work_of_a_strain(void **state)
{
    (void)state;
    for (int axes = FW_AXES_LAB; axes <= FW_AXES_COROTATING; ++axes) {
        fw_solid *solid =
            solid_of(crowd_disc(4, (fw_vec2){1, 2}, 0.1, 0.1, 3),
                     return_force_of(6, 2, (fw_return_axes)axes, FW_RETURN_CONSERVATIVE), still, 1);
        const fw_tensor virial = fw_particles_virial(solid, -1);
        /* r (x) F: the strain x += e y does work F_x y. */
        const double of_strain[] = {virial.xx, virial.yx, virial.xy, virial.yy};
        for (int which = 0; which < 4; ++which) {
            const double h = 1e-5;
            const double slope =
                (8 * (energy_strained(solid, which, h) - energy_strained(solid, which, -h)) -
                 (energy_strained(solid, which, 2 * h) - energy_strained(solid, which, -2 * h))) /
                (12 * h);
            assert_close(of_strain[which], -slope, 1e-6 * (1 + fabs(slope)));
        }
        if (axes == FW_AXES_COROTATING) assert_close(virial.xy, virial.yx, 1e-10);
        fw_solid_destroy(solid);
    }
}

/* Particles that do not feel each other: p A = N T, to rounding, and no drift. */
static void ideal_gas_has_its_pressure(void **state)
{
    (void)state;
    enum { COUNT = 500 };
    fw_crowd crowd = {COUNT, malloc(COUNT * sizeof *crowd.at)};
    assert_int_equal(
        fw_placement_random(crowd.at, COUNT, (fw_vec2){0, 0}, (fw_vec2){40, 40}, 0.9, 7, NULL),
        FW_OK);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = COUNT;
    group.positions = crowd.at;
    group.strength = 0;
    group.mass = 3;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    fw_particles_draw_velocities(solid, -1, 0.7);
    const fw_vec2 drift = fw_particle_drift_velocity(solid, -1);
    assert_close(drift.x, 0, 1e-15);
    const double temperature = fw_particle_temperature(solid, -1, drift);
    assert_close(temperature, 0.7, 4 * 0.7 / sqrt(COUNT));
    const fw_tensor pressure = fw_particle_pressure(solid, 0, 1600);
    assert_close(0.5 * (pressure.xx + pressure.yy) * 1600, COUNT * temperature, 1e-10);
    fw_solid_destroy(solid);
    free(crowd.at);
}

/* Two pairs of unlike masses, whose velocities are prescribed: everything by hand. */
static void motion_is_measured_beside_its_drift(void **state)
{
    (void)state;
    static const fw_vec2 places[2][2] = {{{0, 0}, {0.95, 0.1}}, {{5, 5}, {5.2, 6.1}}};
    static const fw_vec2 velocities[4] = {{1, 2}, {-2, 0.5}, {3, -1}, {0.25, 4}};
    static const double masses[4] = {2, 2, 5, 5};
    fw_particle_group_def groups[2];
    for (int g = 0; g < 2; ++g) {
        groups[g] = fw_particle_group_def_default();
        groups[g].count = 2;
        groups[g].positions = places[g];
        groups[g].mass = masses[2 * g];
    }
    groups[0].name = "light";
    groups[1].name = "heavy";
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    for (int i = 0; i < 4; ++i) fw_langevin_set_velocity(solid, i, velocities[i]);
    const fw_vec2 drift = fw_particle_drift_velocity(solid, -1);
    assert_close(drift.x, (2 * 1 - 2 * 2 + 5 * 3 + 5 * 0.25) / 14, 1e-15);
    assert_close(drift.y, (2 * 2 + 2 * 0.5 - 5 * 1 + 5 * 4) / 14, 1e-15);
    double energy = 0;
    fw_tensor flux = {0}; /* of the heavy pair */
    for (int i = 0; i < 4; ++i) {
        const double x = velocities[i].x - drift.x, y = velocities[i].y - drift.y;
        energy += masses[i] * (x * x + y * y);
        if (i < 2) continue;
        const double own_x = velocities[i].x - (3 + 0.25) / 2, own_y = velocities[i].y - 1.5;
        flux.xx += 5 * own_x * own_x;
        flux.xy += 5 * own_x * own_y;
        flux.yy += 5 * own_y * own_y;
    }
    assert_close(fw_particle_temperature(solid, -1, drift), energy / 8, 1e-14);
    const fw_tensor virial = fw_particles_virial(solid, 1);
    const fw_tensor pressure = fw_particle_pressure(solid, 1, 7);
    assert_true(fabs(virial.xx) > 1e-3 && fabs(virial.xy) > 1e-3 && fabs(virial.yy) > 1e-3);
    assert_close(pressure.xx, (flux.xx + virial.xx) / 7, 1e-14);
    assert_close(pressure.xy, (flux.xy + virial.xy) / 7, 1e-14);
    assert_close(pressure.yx, (flux.xy + virial.yx) / 7, 1e-14);
    assert_close(pressure.yy, (flux.yy + virial.yy) / 7, 1e-14);
    fw_solid_destroy(solid);
}

/* Who has no bond has no order, and does not count in its mean; it does in that of bonds. */
static void order_is_of_those_that_are_bonded(void **state)
{
    (void)state;
    static const fw_vec2 places[3] = {{0, 0}, {1, 0}, {10, 10}};
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = 3;
    group.positions = places;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    const fw_particle_order order = fw_particle_order_of(solid, 0);
    assert_close(order.local, 1, 1e-15);
    assert_close(order.coordination, 2. / 3, 1e-15);
    fw_solid_destroy(solid);
}

static void order_tells_axes(void **state)
{
    (void)state;
    const double degree = FW_PI / 180, angles[] = {0, 30, 15, 60}, axes[] = {0, 7};
    const double lab[] = {1, -1, 0, 1};
    for (int a = 0; a < 8; ++a) {
        const double angle = (axes[a / 4] + angles[a % 4]) * degree;
        fw_return_force force = return_force_of(6, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
        force.angle = axes[a / 4] * degree;
        fw_solid *solid = solid_of(crowd_disc(4, (fw_vec2){3, 1}, angle, 0, 1), force, still, 1);
        const fw_particle_order order = fw_particle_order_of(solid, -1);
        assert_close(order.lab, lab[a % 4], 1e-12);
        assert_close(order.local, 1, 1e-12);
        double values[61];
        assert_int_equal(solid->count, 61);
        fw_solid_find_field(solid, "lab-order")->fill(solid, values);
        assert_close(values[30], lab[a % 4], 1e-12); /* in the middle all six bonds are there */
        assert_close(fw_particle_bragg_peak(solid, -1, 6, angle, 1, 0.1), 1, 1e-12);
        assert_below(fw_particle_bragg_peak(solid, -1, 6, angle + 30 * degree, 1, 0.1), 0.2);
        fw_solid_destroy(solid);
    }
}

/* A hexagon of 12 bonds across its axes, and 4 x 3 squares of 17 bonds turned by 15 degrees from
 * theirs. */
static void each_body_has_its_own_symmetry_and_axes(void **state)
{
    (void)state;
    const double degree = FW_PI / 180, angles[] = {7 * degree, -20 * degree};
    const int folds[] = {6, 4};
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 4, 3, NULL), FW_OK);
    const fw_lattice square = {FW_SQUARE, 1, angles[1] + 15 * degree, {20, 0}};
    const fw_crowd crowds[] = {crowd_disc(1, (fw_vec2){0, 0}, angles[0] + 30 * degree, 0, 1),
                               crowd_of(sites, square, 0, 1)};
    fw_particle_group_def groups[2];
    for (int g = 0; g < 2; ++g) {
        groups[g] = fw_particle_group_def_default();
        groups[g].name = g == 0 ? "hexagon" : "squares";
        groups[g].count = crowds[g].count;
        groups[g].positions = crowds[g].at;
        groups[g].return_force = return_force_of(folds[g], 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
        groups[g].return_force.angle = angles[g];
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    const double lab[] = {-1, 0.5, (24 * -1 + 34 * 0.5) / 58};
    const double coordination[] = {24. / 7, 34. / 12, 58. / 19};
    for (int n = 0; n < 3; ++n) {
        const fw_particle_order order = fw_particle_order_of(solid, n < 2 ? n : -1);
        assert_close(order.lab, lab[n], 1e-12);
        assert_close(order.local, 1, 1e-12);
        assert_close(order.coordination, coordination[n], 1e-12);
    }
    double values[2][19];
    fw_solid_find_field(solid, "lab-order")->fill(solid, values[0]);
    fw_solid_find_field(solid, "local-order")->fill(solid, values[1]);
    for (int i = 0; i < 19; ++i) {
        assert_close(values[0][i], lab[i >= 7], 1e-12);
        assert_close(values[1][i], 1, 1e-12);
    }
    for (int g = 0; g < 2; ++g) free(crowds[g].at);
    fw_solid_destroy(solid);
}

static void crystals_have_bragg_peaks(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 12, 12, NULL), FW_OK);
    fw_crowd crowd = crowd_of(sites, (fw_lattice){FW_SQUARE, 1.02, 0.3, {5, 5}}, 0, 1);
    fw_solid *solid =
        solid_of(crowd, return_force_of(4, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE), still, 1);
    assert_close(fw_particle_bragg_peak(solid, 0, 4, 0.3, 1.02, 0.05), 1, 1e-12);
    assert_close(fw_particle_structure_factor(solid, 0, (fw_vec2){0, 0}), 1, 1e-12);
    enum { POINTS = 17 };
    double map[POINTS * POINTS];
    assert_int_equal(fw_structure_map(solid->x, solid->y, solid->count, -8, 1, POINTS, map, NULL),
                     FW_OK);
    for (int b = 0; b < POINTS; ++b)
        for (int a = 0; a < POINTS; ++a)
            assert_close(map[b * POINTS + a],
                         fw_particle_structure_factor(solid, 0, (fw_vec2){a - 8, b - 8}), 1e-12);
    fw_solid_destroy(solid);
}

/* The window reaches a tenth of the wave number: .1 radians, or a tenth of the spacing. */
static void a_crystal_that_is_turned_or_stretched_a_little_is_found(void **state)
{
    (void)state;
    static const double angles[] = {0.3, 0.35, 0.22}, spacings[] = {1, 1.03, 0.95};
    for (int n = 0; n < 3; ++n) {
        fw_sites sites;
        assert_int_equal(fw_sites_rectangle(&sites, 12, 12, NULL), FW_OK);
        fw_crowd crowd =
            crowd_of(sites, (fw_lattice){FW_SQUARE, spacings[n], angles[n], {5, 5}}, 0, 1);
        fw_solid *solid =
            solid_of(crowd, return_force_of(4, 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE), still, 1);
        assert_close(fw_particle_bragg_peak(solid, 0, 4, 0.3, 1, 0.1), 1, 1e-9);
        if (n > 0) assert_below(fw_particle_bragg_peak(solid, 0, 4, 0.3, 1, 0.01), 0.5);
        assert_below(fw_particle_bragg_peak(solid, 0, 4, 0.3 + acos(-1) / 4, 1, 0.1), 0.1);
        fw_solid_destroy(solid);
    }
}

/* A crystal's shells, and a gas without any. */
static void pair_correlation_counts_neighbours(void **state)
{
    (void)state;
    fw_solid *solid =
        solid_of(crowd_disc(30, (fw_vec2){0, 0}, 0.2, 0, 1), fw_return_force_default(), still, 1);
    enum { BINS = 25 };
    double g[BINS];
    const double density = 2 / sqrt(3), step = 0.1;
    assert_int_equal(fw_particle_pair_correlation(solid, 0, density, step, BINS, g, NULL), FW_OK);
    double shells[3] = {0};
    for (int k = 0; k < BINS; ++k) {
        const double neighbours = g[k] * density * FW_PI * step * step * (2 * k + 1);
        if (k < 9) assert_close(neighbours, 0, 1e-12);
        shells[k < 12 ? 0 : k < 19 ? 1 : 2] += neighbours;
    }
    /* 6 at 1, 6 at sqrt 3, 6 at 2, less what the rim of a disc of radius 30 lacks. */
    for (int s = 0; s < 3; ++s) {
        assert_below(shells[s], 6);
        assert_below(5.7 - 0.12 * s, shells[s]);
    }
    fw_solid_destroy(solid);
}

static void largest_cluster_is_found(void **state)
{
    (void)state;
    fw_crowd big = crowd_disc(3, (fw_vec2){0, 0}, 0, 0, 1);
    fw_crowd small = crowd_disc(2, (fw_vec2){20, 3}, 0, 0, 1);
    fw_crowd both = {big.count + small.count, NULL};
    both.at = malloc((size_t)both.count * sizeof *both.at);
    memcpy(both.at, small.at, (size_t)small.count * sizeof *both.at);
    memcpy(both.at + small.count, big.at, (size_t)big.count * sizeof *both.at);
    const int first = small.count, count = both.count;
    fw_solid *solid = solid_of(both, fw_return_force_default(), still, 1);
    uint8_t *members = malloc((size_t)count);
    int found;
    assert_int_equal(
        fw_surroundings_cluster(solid->x, solid->y, solid->count, 1.7, members, &found, NULL),
        FW_OK);
    assert_int_equal(found, big.count);
    for (int i = 0; i < count; ++i) assert_int_equal(members[i], i >= first);
    assert_int_equal(
        fw_surroundings_cluster(solid->x, solid->y, solid->count, 0.9, members, &found, NULL),
        FW_OK);
    assert_int_equal(found, 1);
    assert_int_equal(members[0], 1);
    fw_solid_destroy(solid);
    free(members);
    free(big.at);
    free(small.at);
}

static void fields_agree_with_sums(void **state)
{
    (void)state;
    fw_solid *solid =
        solid_of(crowd_disc(4, (fw_vec2){3, 1}, 0.1, 0.1, 2),
                 return_force_of(6, 1, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE), still, 1);
    const size_t count = (size_t)solid->count;
    double *values = malloc(count * sizeof *values);
    fw_particles_draw_velocities(solid, -1, 0.3);
    fw_solid_find_field(solid, "potential-energy")->fill(solid, values);
    assert_close(fw_array_sum(values, count), fw_solid_energies(solid).elastic, 1e-11);
    fw_solid_find_field(solid, "kinetic-energy")->fill(solid, values);
    assert_close(fw_array_sum(values, count), fw_solid_energies(solid).kinetic, 1e-11);
    fw_solid_find_field(solid, "local-order")->fill(solid, values);
    assert_close(fw_array_sum(values, count) / solid->count, fw_particle_order_of(solid, 0).local,
                 1e-12);
    fw_solid_find_field(solid, "coordination")->fill(solid, values);
    assert_close(fw_array_sum(values, count) / solid->count,
                 fw_particle_order_of(solid, 0).coordination, 1e-12);
    /* With the potential switched off by hand only return forces are left. */
    fw_solid_find_field(solid, "return-force")->fill(solid, values);
    double x[61], y[61];
    assert_int_equal(solid->count, 61);
    fw_particles_return_forces(solid, x, y);
    for (int i = 0; i < 61; ++i) assert_close(values[i], hypot(x[i], y[i]), 1e-15);
    const fw_langevin *langevin = (const fw_langevin *)solid;
    double with[61];
    memcpy(with, langevin->force_x, sizeof with);
    assert_int_equal(fw_particles_set_amplitude(solid, 0, 0, NULL), FW_OK);
    for (int i = 0; i < 61; ++i) assert_close(with[i] - langevin->force_x[i], x[i], 1e-12);
    free(values);
    fw_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(virial_is_the_work_of_a_strain),
        cmocka_unit_test(ideal_gas_has_its_pressure),
        cmocka_unit_test(motion_is_measured_beside_its_drift),
        cmocka_unit_test(order_is_of_those_that_are_bonded),
        cmocka_unit_test(order_tells_axes),
        cmocka_unit_test(each_body_has_its_own_symmetry_and_axes),
        cmocka_unit_test(crystals_have_bragg_peaks),
        cmocka_unit_test(a_crystal_that_is_turned_or_stretched_a_little_is_found),
        cmocka_unit_test(pair_correlation_counts_neighbours),
        cmocka_unit_test(largest_cluster_is_found),
        cmocka_unit_test(fields_agree_with_sums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
