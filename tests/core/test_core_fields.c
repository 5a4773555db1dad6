/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_core_fields.c - quantities per particle against what the solid says as a whole and what
 * follows from how it was made. Start reading at the tests. */
#include "tests/support/solids.h"
#include "tests/support/steps.h"

#include <string.h>

/* NULL where the solid has no such field. */
static double *field_of(const fw_solid *solid, const char *name)
{
    const fw_field *field = fw_solid_find_field(solid, name);
    if (!field) return NULL;
    double *values = fw_array_of_doubles((size_t)solid->count);
    field->fill(solid, values);
    return values;
}

static double sum_of(const fw_solid *solid, const char *name)
{
    double *values = field_of(solid, name);
    const double sum = values ? fw_array_sum(values, (size_t)solid->count) : 0;
    free(values);
    return sum;
}

static void parts_of_the_energy_add_up_to_it(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 7, 6, 0);
        for (int tick = 0; tick < 5; ++tick) advance_free(solid);
        const fw_energies all = fw_solid_energies(solid);
        const bool points = fw_solid_is_langevin(solid);
        const double elastic = sum_of(solid, points ? "potential-energy" : "energy");
        const double expected = points ? all.elastic : all.kinetic + all.elastic;
        if (!(fabs(elastic - expected) < 1e-12 * fabs(expected)))
            fail_msg("%s: %.17g, expected %.17g", kinds[k].name, elastic, expected);
        if (fw_solid_find_field(solid, "kinetic-energy"))
            assert_close(sum_of(solid, "kinetic-energy"), all.kinetic, 1e-12 * all.kinetic);
        assert_null(fw_solid_find_field(solid, "no such field"));
        fw_solid_destroy(solid);
    }
}

/* A body that moves as one has one speed everywhere. */
static void speeds_are_those_of_the_body(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 5, 4);
        for (int p = 0; p < s.sites.count; ++p) s.velocity[p] = (fw_vec2){0.03, -0.04};
        fw_solid *solid = made(&kinds[k], &s);
        double *speeds = field_of(solid, "speed");
        for (int p = 0; p < solid->count; ++p)
            if (!(fabs(speeds[p] - 0.05 * kinds[k].transverse) < 1e-13))
                fail_msg("%s: particle %d has speed %.17g", kinds[k].name, p, speeds[p]);
        free(speeds);
        fw_solid_destroy(solid);
    }
}

static void displacements_are_those_it_was_made_with(void **state)
{
    (void)state;
    int asked = 0;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 5, 4);
        fw_vec2 given[20];
        for (int p = 0; p < 20; ++p) s.displacement[p] = given[p] = (fw_vec2){0.3, -0.2};
        fw_solid *solid = made(&kinds[k], &s);
        double *x = field_of(solid, "displacement-x"), *y = field_of(solid, "displacement-y");
        for (int p = 0; x && p < 20; ++p) {
            assert_close(x[p], given[p].x, 1e-14);
            assert_close(y[p], given[p].y, 1e-14);
        }
        asked += x != NULL;
        free(x);
        free(y);
        fw_solid_destroy(solid);
    }
    assert_int_equal(asked, 4);
}

/* A body that is stretched by G has that strain at every particle but those at its open ends, and
 * as many links as it has neighbours. */
static void stretched_sheet_shows_its_strain(void **state)
{
    (void)state;
    for (int k = 0; k < 2; ++k) {
        start s = rectangle(&kinds[k], 5, 4);
        for (int p = 0; p < 20; ++p) {
            const fw_site site = s.sites.site[p];
            s.displacement[p] =
                (fw_vec2){0.03 * site.i + 0.01 * site.j, 0.005 * site.i - 0.02 * site.j};
        }
        fw_solid *solid = made(&kinds[k], &s);
        const char *const names[] = {"strain-xx", "strain-yy", "strain-xy", "links"};
        const double expected[] = {0.03, -0.02, 0.0075, 4};
        for (int n = 0; n < 4; ++n) {
            double *values = field_of(solid, names[n]);
            assert_close(values[6], expected[n], 1e-14);
            assert_close(values[13], expected[n], 1e-14);
            if (n == 3) assert_close(values[0], 2, 0);
            free(values);
        }
        fw_solid_destroy(solid);
    }
}

static void colours_are_those_that_move_in_turn(void **state)
{
    (void)state;
    start s = rectangle(&kinds[2], 5, 4);
    fw_solid *solid = made(&kinds[2], &s);
    double *colour = field_of(solid, "colour");
    for (int p = 0; p < solid->count; ++p) {
        assert_true(colour[p] == !fw_elastic_automaton_is_black(solid, p));
        assert_true(colour[p] == (p % 5 + p / 5) % 2);
    }
    free(colour);
    fw_solid_destroy(solid);
}

/* Inside a hexagonal crystal every particle has six bonds, in perfect order of six and in none of
 * four; a single particle has none. */
static void crystal_shows_its_order(void **state)
{
    (void)state;
    fw_vec2 positions[31], velocity[31];
    const fw_lattice lattice = {.kind = FW_HEXAGONAL, .spacing = 1};
    for (int p = 0; p < 30; ++p)
        positions[p] = fw_lattice_position(&lattice, (fw_site){p % 6, p / 6});
    positions[30] = (fw_vec2){20, 20};
    for (int p = 0; p < 31; ++p) velocity[p] = (fw_vec2){0, 0};
    fw_particle_group_def groups[2] = {fw_particle_group_def_default(),
                                       fw_particle_group_def_default()};
    groups[0].name = "crystal";
    groups[0].count = 30;
    groups[0].positions = positions;
    groups[0].velocities = velocity;
    groups[1].name = "single";
    groups[1].count = 1;
    groups[1].positions = positions + 30;
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    fw_error error;
    fw_solid *solid;
    if (fw_particles_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    assert_int_equal(fw_particles_find_group(solid, "single"), 1);
    assert_int_equal(fw_particles_find_group(solid, "none"), -1);
    double density = 0;
    for (int p = 0; p < 30; ++p) {
        const fw_vec2 apart = fw_vec2_subtract(positions[p], positions[14]);
        density += exp(-fw_vec2_dot(apart, apart));
    }
    const struct {
        const char *name;
        double inside, alone;
    } known[] = {{"coordination", 6, 0}, {"order-6", 1, 0},   {"order-4", 0, 0},
                 {"local-order", 1, 0},  {"lab-order", 1, 0}, {"bond-force", 0, 0},
                 {"return-force", 0, 0}, {"group", 0, 1},     {"gaussian-density", density, 1}};
    for (size_t n = 0; n < sizeof known / sizeof known[0]; ++n) {
        double *values = field_of(solid, known[n].name);
        if (!values) fail_msg("no field %s", known[n].name);
        if (!(fabs(values[14] - known[n].inside) < 1e-12 &&
              fabs(values[30] - known[n].alone) < 1e-12))
            fail_msg("%s: %.17g and %.17g", known[n].name, values[14], values[30]);
        free(values);
    }
    fw_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_the_energy_add_up_to_it),
        cmocka_unit_test(speeds_are_those_of_the_body),
        cmocka_unit_test(displacements_are_those_it_was_made_with),
        cmocka_unit_test(stretched_sheet_shows_its_strain),
        cmocka_unit_test(colours_are_those_that_move_in_turn),
        cmocka_unit_test(crystal_shows_its_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
