/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_core_refusals.c - what solids, shapes and placements do not take: one wrong number at a time
 * among right ones, and what is said of it. Start reading at refuse_each(). */
#include "tests/support/laws.h"

#include "core/arena.h"
#include "core/boltzmann/lb_state.h"
#include "core/placement.h"
#include "tests/support/solids.h"

/* After solids.h, whose functions have errors of their own. */
#include "tests/support/scratch.h"

typedef struct wrong {
    double *number;
    double value;
    const char *words;
} wrong;

typedef fw_status maker(fw_solid **solid, const void *def, fw_error *error);

/* Each of the numbers in turn is wrong; without, the solid is made. */
static void refuse_each(maker *make, const void *def, const wrong *list, size_t count)
{
    fw_solid *solid;
    for (size_t n = 0; n < count; ++n) {
        const double right = *list[n].number;
        *list[n].number = list[n].value;
        error = (fw_error){0};
        if (make(&solid, def, &error) != FW_BAD_INPUT || error.status != FW_BAD_INPUT ||
            !strstr(error.sentence, list[n].words))
            fail_msg("number %zu, %g: '%s' does not speak of '%s'", n, list[n].value,
                     error.sentence, list[n].words);
        assert_int_equal(make(&solid, def, NULL), FW_BAD_INPUT);
        *list[n].number = right;
    }
    assert_fine(make(&solid, def, &error));
    fw_solid_destroy(solid);
}
#define REFUSE_EACH(make, def, list) refuse_each(make, def, list, sizeof(list) / sizeof(list)[0])

static fw_status make_lb(fw_solid **solid, const void *def, fw_error *failed)
{
    return fw_lb_solid_create(solid, def, failed);
}

static void lb_solid_takes_no_wrong_number(void **state)
{
    (void)state;
    start s = rectangle(&kinds[0], 3, 3);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &s.sites;
    def.rest_mass = (fw_sym2){1, 0.1, 1};
    def.stiffness = (fw_sym2){1, 0.1, 1};
    const wrong list[] = {{&def.lattice.spacing, 0, "spacing 0"},
                          {&def.lattice.spacing, INFINITY, "spacing inf"},
                          {&def.lattice.spacing, NAN, "spacing nan"},
                          {&def.mu, 0.5, "mu 0.5"},
                          {&def.mu, 1.01, "mu 1.01"},
                          {&def.break_at, 0, "break-at 0"},
                          {&def.break_at, NAN, "break-at nan"},
                          {&def.rest_mass.xx, INFINITY, "rest mass of site [0, 0]"},
                          {&def.rest_mass.xy, NAN, "rest mass of site [0, 0]"},
                          {&def.rest_mass.yy, NAN, "rest mass of site [0, 0]"},
                          {&def.stiffness.xx, -1, "link stiffness -1 at site [0, 0]"},
                          {&def.stiffness.yy, 0, "link stiffness 1 at site [0, 0]"},
                          {&def.stiffness.xy, 1.1, "positive definite"},
                          {&def.stiffness.xy, NAN, "positive definite"},
                          {&def.stiffness.yy, INFINITY, "positive definite"}};
    REFUSE_EACH(make_lb, &def, list);
    def.lattice.kind = FW_HEXAGONAL;
    fw_solid *solid;
    assert_refused(fw_lb_solid_create(&solid, &def, &error), FW_BAD_INPUT, "hexagonal");
    release_start(&s);
}

static fw_status make_ca(fw_solid **solid, const void *def, fw_error *failed)
{
    return fw_elastic_automaton_create(solid, def, failed);
}

static void automaton_takes_no_wrong_number(void **state)
{
    (void)state;
    start s = rectangle(&kinds[2], 4, 4);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &s.sites;
    def.speeds = (fw_automaton_speeds){0.9, 0.5};
    def.displacement = s.displacement;
    def.velocity = s.velocity;
    const wrong list[] = {{&def.lattice.spacing, 0, "spacing 0"},
                          {&def.lattice.spacing, INFINITY, "spacing inf"},
                          {&def.speeds.transverse, -1, "c1 = -1"},
                          {&def.speeds.coupling, -1, "c2 = -1"},
                          {&def.speeds.transverse, INFINITY, "c1 = inf"},
                          {&def.speeds.coupling, INFINITY, "c2 = inf"},
                          {&def.reflection, 0, "reflection a = 0"},
                          {&def.reflection, 1.5, "reflection a = 1.5"},
                          {&def.break_at, -1, "break-at -1"},
                          {&s.displacement[3].x, NAN, "not finite"},
                          {&s.displacement[3].y, NAN, "not finite"},
                          {&s.velocity[15].x, INFINITY, "not finite"},
                          {&s.velocity[15].y, INFINITY, "not finite"}};
    REFUSE_EACH(make_ca, &def, list);
    const int periods[][2] = {{1, 0}, {5, 0}, {0, 1}, {0, 5}};
    for (int n = 0; n < 4; ++n) {
        fw_solid *solid;
        def.period_columns = periods[n][0];
        def.period_rows = periods[n][1];
        assert_refused(fw_elastic_automaton_create(&solid, &def, &error), FW_BAD_INPUT, "even");
    }
    release_start(&s);
    fw_automaton_speeds speeds;
    const double moduli[][2] = {{0, 0.3}, {INFINITY, 0.3}, {1, -1.1}, {1, 1}};
    for (int n = 0; n < 4; ++n)
        assert_refused(fw_automaton_speeds_from_moduli(&speeds, moduli[n][0], moduli[n][1], &error),
                       FW_BAD_INPUT, "expected");
}

static fw_status make_lattice(fw_solid **solid, const void *def, fw_error *failed)
{
    return fw_linear_lattice_create(solid, def, failed);
}

static void linear_lattice_takes_no_wrong_number(void **state)
{
    (void)state;
    start s = rectangle(&kinds[5], 3, 3);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.lattice = s.lattice;
    def.sites = &s.sites;
    const wrong list[] = {{&def.lattice.spacing, -1, "-1"},
                          {&def.lattice.spacing, INFINITY, "inf"},
                          {&def.mass, 0, "mass 0"},
                          {&def.mass, INFINITY, "mass inf"},
                          {&def.k1, NAN, "nan"},
                          {&def.k2, INFINITY, "inf"},
                          {&def.k2, -41, "-41"},
                          {&def.k1, -20, "-20"},
                          {&def.controls.time_step, 0, "0"},
                          {&def.controls.time_step, INFINITY, "inf"},
                          {&def.controls.damping, -1, "-1"},
                          {&def.controls.damping, INFINITY, "inf"},
                          {&def.controls.temperature, -1, "-1"},
                          {&def.controls.temperature, INFINITY, "inf"}};
    REFUSE_EACH(make_lattice, &def, list);
    release_start(&s);
}

static fw_status make_points(fw_solid **solid, const void *def, fw_error *failed)
{
    return fw_particles_create(solid, def, failed);
}

static void movable_particles_take_no_wrong_number(void **state)
{
    (void)state;
    fw_vec2 positions[] = {{0, 0}, {1, 0}, {0.5, 0.9}}, velocities[3] = {{0, 0}};
    fw_particle_group_def group = fw_particle_group_def_default();
    group.name = "body";
    group.count = 3;
    group.positions = positions;
    group.velocities = velocities;
    fw_return_force *turn = &group.return_force;
    *turn = fw_return_force_default();
    turn->amplitude = 1;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_pair_potential *pair = &def.potential;
    const wrong list[] = {{&group.mass, 0, "mass 0"},
                          {&group.mass, INFINITY, "mass inf"},
                          {&group.strength, -1, "strength -1 in it"},
                          {&group.strength, INFINITY, "strength inf in it"},
                          {&positions[1].x, NAN, "particle 1 lies at [nan, 0]"},
                          {&positions[1].y, INFINITY, "particle 1 lies at [1, inf]"},
                          {&velocities[2].x, NAN, "particle 2 has velocity [nan, 0]"},
                          {&velocities[2].y, NAN, "particle 2 has velocity [0, nan]"},
                          {&turn->amplitude, -1, "amplitude of -1"},
                          {&turn->amplitude, INFINITY, "amplitude of inf"},
                          {&turn->distance, 0, "bond length of 0"},
                          {&turn->distance, INFINITY, "bond length of inf"},
                          {&turn->cut.inner, -1, "cut from -1"},
                          {&turn->cut.inner, 1.45, "cut from 1.45"},
                          {&turn->cut.outer, INFINITY, "to inf"},
                          {&turn->cut.outer, 1.42, "radius of 1.42"},
                          {&turn->angle, NAN, "angle nan"},
                          {&pair->depth, -1, "-1"},
                          {&pair->depth, INFINITY, "inf"},
                          {&pair->distance, 0, "0"},
                          {&pair->distance, INFINITY, "inf"},
                          {&pair->cut.inner, 1.8, "1.8"},
                          {&pair->cut.inner, -INFINITY, "-inf"},
                          {&pair->cut.outer, INFINITY, "inf"},
                          {&pair->cut.inner, 0.9, "0.9"},
                          {&def.strength_across, -1, "strength -1 between bodies"},
                          {&def.strength_across, INFINITY, "strength inf between bodies"},
                          {&def.bond_radius, 0, "bonds reach up to 0"},
                          {&def.bond_radius, INFINITY, "bonds reach up to inf"},
                          {&def.margin, -1, "-1 further"},
                          {&def.margin, INFINITY, "inf further"},
                          {&def.overlap_energy, -1, "overlap energy is -1"},
                          {&def.controls.time_step, 1, "1"},
                          {&def.controls.damping, NAN, "nan"}};
    REFUSE_EACH(make_points, &def, list);
    fw_solid *solid;
    const int folds[] = {5, 0, 26};
    for (int n = 0; n < 3; ++n) {
        turn->fold = folds[n];
        assert_refused(fw_particles_create(&solid, &def, &error), FW_BAD_INPUT, "fold");
    }
    group.count = 0;
    assert_refused(fw_particles_create(&solid, &def, &error), FW_BAD_INPUT,
                   "body 'body': it has 0 particles");
    def.group_count = 0;
    assert_refused(fw_particles_create(&solid, &def, &error), FW_BAD_INPUT, "no bodies");
}

static void morse_needs_a_steepness(void **state)
{
    (void)state;
    fw_pair_potential morse = fw_pair_potential_default();
    morse.kind = FW_MORSE;
    const double wrongs[] = {0, INFINITY, NAN};
    for (int n = 0; n < 3; ++n) {
        morse.steepness = wrongs[n];
        assert_refused(fw_pair_potential_check(&morse, &error), FW_BAD_INPUT, "steepness");
    }
    morse.steepness = 6;
    assert_fine(fw_pair_potential_check(&morse, &error));
}

/* --- what may change between steps --- */

static void changes_are_refused_and_alter_nothing(void **state)
{
    (void)state;
    fw_solid *solid = shaken(&kinds[6], 4, 4, 0);
    const fw_langevin_controls before = *fw_particles_controls(solid);
    fw_langevin_controls controls = before;
    controls.time_step = 3;
    assert_refused(fw_particles_set_controls(solid, &controls, &error), FW_BAD_INPUT, "3");
    controls.time_step = -1;
    assert_refused(fw_particles_set_controls(solid, &controls, &error), FW_BAD_INPUT, "-1");
    assert_refused(fw_particles_set_damping(solid, -2, &error), FW_BAD_INPUT, "-2");
    assert_refused(fw_particles_set_temperature(solid, -2, &error), FW_BAD_INPUT, "-2");
    assert_refused(fw_particles_set_amplitude(solid, 0, -2, &error), FW_BAD_INPUT, "-2");
    assert_refused(fw_particles_set_amplitude(solid, 0, 1e9, &error), FW_BAD_INPUT, "time step");
    assert_refused(fw_langevin_set_bath(solid, NAN, 0, &error), FW_BAD_INPUT, "nan");
    assert_memory_equal(fw_particles_controls(solid), &before, sizeof before);
    assert_close(fw_particles_group(solid, 0)->return_force.amplitude, 0, 0);
    fw_solid_destroy(solid);
}

/* --- states --- */

static void every_solid_refuses_a_state_that_is_none(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 4, 4, 0);
        double *const places[] = {&solid->x[5], &solid->y[5]};
        for (int n = 0; n < 2; ++n) {
            const double right = *places[n];
            *places[n] = NAN;
            assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT, "particle 5");
            *places[n] = right;
        }
        solid->ticks = -1;
        assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT, "-1");
        solid->ticks = 0;
        assert_fine(fw_solid_restored(solid, &error));
        if (fw_solid_is_langevin(solid)) {
            const fw_vec2 bad[] = {{NAN, 0}, {0, INFINITY}};
            for (int n = 0; n < 2; ++n) {
                fw_langevin_set_velocity(solid, 3, bad[n]);
                assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT, "particle 3");
            }
            fw_langevin_set_velocity(solid, 3, (fw_vec2){0, 0});
            ((fw_langevin *)solid)->controls.time_step = NAN;
            assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT, "nan");
        }
        fw_solid_destroy(solid);
    }
}

static void links_that_lead_nowhere_are_refused(void **state)
{
    (void)state;
    start s = rectangle(&kinds[0], 3, 3);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &s.sites;
    def.break_at = 1;
    fw_solid *solid;
    for (int n = 0; n < 3; ++n) {
        assert_fine(fw_lb_solid_create(&solid, &def, &error));
        lb_solid *lb = (lb_solid *)solid;
        if (n == 0) lb->parity = 2;
        if (n == 1) lb->present[0] |= 1u << FW_WEST;
        if (n == 2) lb->present[4] &= (uint8_t) ~(1u << FW_EAST); /* its neighbour still has it */
        assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT, n == 0 ? "2" : "link");
        fw_solid_destroy(solid);
    }
    fw_elastic_automaton_def cells = fw_elastic_automaton_def_default();
    cells.sites = &s.sites;
    cells.break_at = 1;
    for (int d = 0; d < 2; ++d) {
        assert_fine(fw_elastic_automaton_create(&solid, &cells, &error));
        fw_state_list list = {0};
        solid->model->state(solid, &list);
        uint8_t *bonds = list.array[list.count - 1].data;
        assert_string_equal(list.array[list.count - 1].name, "bonds");
        bonds[0] |= (uint8_t)(d == 0 ? 1 << FW_WEST : 1 << 6);
        assert_refused(fw_solid_restored(solid, &error), FW_BAD_INPUT,
                       d == 0 ? "black cell 0 has a bond in direction 2"
                              : "black cell 0 has a bond in direction 6");
        fw_solid_destroy(solid);
    }
    release_start(&s);
}

/* --- shapes, places, memory --- */

static void shapes_have_sites_and_not_too_many(void **state)
{
    (void)state;
    fw_sites sites;
    assert_refused(fw_sites_rectangle(&sites, 0, 3, &error), FW_BAD_INPUT, "0 x 3");
    assert_refused(fw_sites_rectangle(&sites, 3, -1, &error), FW_BAD_INPUT, "3 x -1");
    assert_refused(fw_sites_rectangle(&sites, 1 << 15, 1 << 14, &error), FW_BAD_INPUT,
                   "the shape has 536870912 sites, expected at most 268435456");
    assert_refused(fw_sites_disc(&sites, FW_SQUARE, -1, &error), FW_BAD_INPUT, "radius -1");
    assert_refused(fw_sites_disc(&sites, FW_SQUARE, 20000, &error), FW_BAD_INPUT, "20000");
    assert_refused(fw_sites_disc(&sites, FW_SQUARE, NAN, &error), FW_BAD_INPUT, "radius nan");
    assert_refused(fw_sites_mask(&sites, "...\n", &error), FW_BAD_INPUT, "no sites");
    assert_int_equal(sites.count, 0);
    assert_null(sites.site);
}

static void places_that_cannot_be_are_refused(void **state)
{
    (void)state;
    static fw_vec2 points[4000];
    const struct {
        fw_vec2 high;
        int count;
        double distance;
        const char *words;
    } bad[] = {{{0, 9}, 3, 0.5, "expected a rectangle with an area"},
               {{9, -1}, 3, 0.5, "expected a rectangle with an area"},
               {{INFINITY, 9}, 3, 0.5, "expected a rectangle with an area"},
               {{9, INFINITY}, 3, 0.5, "expected a rectangle with an area"},
               {{9, 9}, 3, -1, "-1 apart"},
               {{9, 9}, 3, INFINITY, "inf apart"},
               {{9, 9}, 0, 1, "0 particles"},
               {{9, 9}, 120, 1, "do not fit however they lie"},
               {{60, 60}, 2800, 1, "where random placement jams"},
               {{9, 9}, 80, 1, "found"}};
    for (size_t n = 0; n < sizeof bad / sizeof bad[0]; ++n)
        assert_refused(fw_placement_random(points, bad[n].count, (fw_vec2){0, 0}, bad[n].high,
                                           bad[n].distance, 1, &error),
                       FW_BAD_INPUT, bad[n].words);
}

static void more_memory_than_there_can_be_is_refused(void **state)
{
    (void)state;
    double *numbers = (double *)1;
    char *more = (char *)1;
    for (int n = 0; n < 3; ++n) {
        fw_arena arena = {0};
        const size_t counts[][2] = {
            {SIZE_MAX / 8, 8}, {SIZE_MAX / 40, SIZE_MAX / 5}, {8, SIZE_MAX}};
        FW_ARENA_ADD(&arena, numbers, counts[n][0]);
        FW_ARENA_ADD(&arena, more, counts[n][1]);
        assert_refused(fw_arena_allocate(&arena, "a giant", &error), FW_SYSTEM_FAILED,
                       "not enough memory for a giant");
        assert_null(numbers);
        assert_null(more);
        fw_arena_release(&arena);
    }
    assert_null(fw_array_allocate(SIZE_MAX / 4, 8));
    assert_null(fw_array_allocate(SIZE_MAX / 2 + 1, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lb_solid_takes_no_wrong_number),
        cmocka_unit_test(automaton_takes_no_wrong_number),
        cmocka_unit_test(linear_lattice_takes_no_wrong_number),
        cmocka_unit_test(movable_particles_take_no_wrong_number),
        cmocka_unit_test(morse_needs_a_steepness),
        cmocka_unit_test(changes_are_refused_and_alter_nothing),
        cmocka_unit_test(every_solid_refuses_a_state_that_is_none),
        cmocka_unit_test(links_that_lead_nowhere_are_refused),
        cmocka_unit_test(shapes_have_sites_and_not_too_many),
        cmocka_unit_test(places_that_cannot_be_are_refused),
        cmocka_unit_test(more_memory_than_there_can_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
