/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_load.c - what acts in time: in the steps before, at and after each edge the external forces
 * have exactly the values by hand. */
#include "tests/support/scenes.h"

#include "contact/scene/load.h"

/* A row of four particles: the ends have one link, the others two, and so half of the mass. */
static fw_solid *make_row(void)
{
    fw_sites sites;
    fw_solid *solid;
    must(fw_sites_rectangle(&sites, 4, 1, &error));
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    must(fw_lb_solid_create(&solid, &def, &error));
    fw_sites_clear(&sites);
    return solid;
}

/* Of one load in one step, on fresh external forces. */
static void apply(const fw_load_def *def, int64_t step, fw_solid *solid)
{
    fw_load *load;
    for (int l = 0; l < solid->count; ++l) solid->external_x[l] = solid->external_y[l] = 0;
    must(fw_load_create(&load, def, solid, &error));
    fw_load_apply(load, step, solid);
    fw_load_destroy(load);
}

static const int pair[] = {1, 3};

static fw_load_def steady(fw_load_kind kind)
{
    return (fw_load_def){.kind = kind,
                         .particles = pair,
                         .particle_count = 2,
                         .vector = {3, -0.5},
                         .from = 10,
                         .until = 20};
}

static void assert_forces(const fw_solid *solid, double first, double second, double factor)
{
    assert_close(solid->external_x[0], 0, 0);
    assert_close(solid->external_x[2], 0, 0);
    assert_close(solid->external_x[1], 3 * first * factor, 1e-14);
    assert_close(solid->external_x[3], 3 * second * factor, 1e-14);
    assert_close(solid->external_y[1], -0.5 * first * factor, 1e-14);
    assert_close(solid->external_y[3], -0.5 * second * factor, 1e-14);
}

static void a_window_takes_its_first_step_and_not_its_last(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    const fw_load_def def = steady(FW_LOAD_EACH);
    static const struct {
        int64_t step;
        double factor;
    } edges[] = {{8, 0}, {9, 0}, {10, 1}, {11, 1}, {18, 1}, {19, 1}, {20, 0}, {21, 0}};
    for (size_t n = 0; n < sizeof edges / sizeof *edges; ++n) {
        apply(&def, edges[n].step, solid);
        assert_forces(solid, 1, 1, edges[n].factor);
    }
    fw_solid_destroy(solid);
}

/* In the first of four steps a quarter acts, in the fourth all. */
static void a_ramp_is_whole_in_its_last_step(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    fw_load_def def = steady(FW_LOAD_EACH);
    def.ramp = 4;
    static const double factors[] = {0, .25, .5, .75, 1, 1};
    for (int n = 0; n < 6; ++n) {
        apply(&def, 9 + n, solid);
        assert_forces(solid, 1, 1, factors[n]);
    }
    apply(&def, 20, solid);
    assert_forces(solid, 1, 1, 0);
    fw_solid_destroy(solid);
}

/* The oscillation counts steps from the beginning of the run, whenever the force begins. */
static void an_oscillation_counts_the_steps_of_the_run(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    fw_load_def def = steady(FW_LOAD_EACH);
    def.period = 8;
    def.phase = FW_TWO_PI / 4;
    static const double factors[] = {0, -1, 0, 1, 0, -1}; /* cos(2 pi step/8) */
    for (int n = 0; n < 6; ++n) {
        apply(&def, 10 + 2 * n, solid);
        assert_forces(solid, 1, 1, n < 5 ? factors[n] : 0);
    }
    def.ramp = 4;
    apply(&def, 12, solid);
    assert_forces(solid, 1, 1, -.75);
    fw_solid_destroy(solid);
}

static void each_particle_bears_its_part(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    double mass[4];
    solid->model->masses(solid, mass);
    assert_true(fabs(mass[1] - mass[3]) > .1 * mass[1]);
    fw_load_def def = steady(FW_LOAD_TOTAL);
    apply(&def, 15, solid);
    assert_forces(solid, .5, .5, 1);
    def = steady(FW_LOAD_ACCELERATION);
    apply(&def, 15, solid);
    assert_forces(solid, mass[1], mass[3], 1);
    fw_solid_destroy(solid);
}

/* Forces of two loads add up. */
static void a_load_adds_to_what_is_there(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    fw_load *load;
    const fw_load_def def = steady(FW_LOAD_EACH);
    must(fw_load_create(&load, &def, solid, &error));
    fw_load_apply(load, 12, solid);
    fw_load_apply(load, 12, solid);
    assert_true(solid->loaded);
    assert_forces(solid, 1, 1, 2);
    fw_load_destroy(load);
    fw_solid_destroy(solid);
}

static void balanced_random_forces_move_nothing_as_a_whole(void **state)
{
    (void)state;
    fw_solid *solid = make_row();
    fw_load_def def = steady(FW_LOAD_RANDOM);
    def.random = 2;
    def.seed = 7;
    double x[2], y[2];
    for (int balanced = 0; balanced < 2; ++balanced) {
        def.balanced = balanced;
        apply(&def, 12, solid);
        x[balanced] = solid->external_x[1] + solid->external_x[3];
        y[balanced] = solid->external_y[1] + solid->external_y[3];
        for (int n = 0; n < 2; ++n) assert_true(fabs(solid->external_x[pair[n]]) <= 2);
    }
    assert_true(fabs(x[0]) > 1e-3 && fabs(y[0]) > 1e-3);
    assert_close(x[1], 0, 1e-15);
    assert_close(y[1], 0, 1e-15);
    const double before = solid->external_x[1];
    apply(&def, 13, solid);
    assert_true(solid->external_x[1] != before);
    fw_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_takes_its_first_step_and_not_its_last),
        cmocka_unit_test(a_ramp_is_whole_in_its_last_step),
        cmocka_unit_test(an_oscillation_counts_the_steps_of_the_run),
        cmocka_unit_test(each_particle_bears_its_part),
        cmocka_unit_test(a_load_adds_to_what_is_there),
        cmocka_unit_test(balanced_random_forces_move_nothing_as_a_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
