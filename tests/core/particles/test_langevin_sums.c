/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_langevin_sums.c - energies, momentum and mass of point masses are kept once they were asked
 * for: whatever changes positions or velocities, they are those of the solid as it is. */
#include "core/particles/linear_lattice.h"
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "tests/support/crowd.h"

static const fw_langevin_controls bath = {.time_step = 0.01, .damping = 0.5, .temperature = 0.2};

static fw_solid *linear(void)
{
    fw_sites sites;
    fw_solid *solid;
    fw_error error;
    assert_int_equal(fw_sites_disc(&sites, FW_HEXAGONAL, 4.2, NULL), FW_OK);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.controls = bath;
    def.mass = 1.7;
    if (fw_linear_lattice_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    fw_sites_clear(&sites);
    return solid;
}

static fw_solid *movable(void)
{
    return solid_of(crowd_disc(4.2, (fw_vec2){0, 0}, 0, 0.02, 3), fw_return_force_default(), bath,
                    7);
}

/* By the velocities as they are, and by a solid that was never asked. */
static void assert_sums_are_right(fw_solid *solid, fw_solid *(*make)(void))
{
    const fw_langevin *motion = (const fw_langevin *)solid;
    double kinetic = 0, mass = 0;
    fw_vec2 momentum = {0, 0};
    for (int i = 0; i < solid->count; ++i) {
        const fw_vec2 v = fw_langevin_velocity(solid, i);
        kinetic += 0.5 * motion->mass[i] * fw_vec2_dot(v, v);
        momentum = fw_vec2_add(momentum, fw_vec2_scale(motion->mass[i], v));
        mass += motion->mass[i];
    }
    fw_solid *fresh = make();
    for (int i = 0; i < solid->count; ++i) {
        fresh->x[i] = solid->x[i];
        fresh->y[i] = solid->y[i];
    }
    restore(fresh);
    for (int times = 0; times < 2; ++times) {
        assert_close(fw_solid_energies(solid).kinetic, kinetic, 1e-12);
        assert_true(fw_solid_energies(solid).elastic == fw_solid_energies(fresh).elastic);
        assert_close(fw_solid_momentum(solid).x, momentum.x, 1e-12);
        assert_close(fw_solid_momentum(solid).y, momentum.y, 1e-12);
        assert_close(solid->model->mass(solid).xx, mass, 1e-11);
    }
    fw_solid_destroy(fresh);
}

static void check_changes(fw_solid *(*make)(void))
{
    fw_solid *solid = make();
    assert_sums_are_right(solid, make);
    for (int step = 0; step < 3; ++step) {
        advance_free(solid);
        assert_sums_are_right(solid, make);
    }
    fw_langevin_set_velocity(solid, 5, (fw_vec2){1.5, -2});
    assert_sums_are_right(solid, make);
    fw_langevin_draw_velocities(solid, 0, 11, 3);
    assert_sums_are_right(solid, make);
    fw_langevin_reverse(solid);
    assert_sums_are_right(solid, make);
    fw_carry carry = {.particle = 3, .x = true, .velocity = {4, 0}};
    solid->model->carry(solid, &carry, 1);
    assert_sums_are_right(solid, make);
    solid->x[2] += 0.1;
    restore(solid);
    assert_sums_are_right(solid, make);
    fw_solid_destroy(solid);
}

static void sums_are_those_of_the_present(void **state)
{
    (void)state;
    check_changes(linear);
    check_changes(movable);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sums_are_those_of_the_present)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
