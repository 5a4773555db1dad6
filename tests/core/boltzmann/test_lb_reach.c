/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_reach.c - no boundary particle of an LB solid goes further than the solid says that it
 * can, and what it says is of use. */
#include "tests/support/lb_bodies.h"

#include <string.h>

enum { TICKS_MAX = 100 };
static const int ticks[] = {1, 2, 15, 16, 17, 48, TICKS_MAX};

static fw_solid *moving_with(const fw_sites *sites, const fw_vec2 *displacement,
                             const fw_vec2 *velocity, double mu)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_solid *solid;
    fw_error error;
    def.sites = sites;
    def.displacement = displacement;
    def.velocity = velocity;
    def.mu = mu;
    def.form = FW_LB_DISPLACEMENTS;
    if (fw_lb_solid_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return solid;
}

/* The furthest that any boundary particle gets from where it is, tick by tick. */
static void follow(fw_solid *solid, double furthest[TICKS_MAX + 1])
{
    fw_vec2 *start = malloc((size_t)solid->boundary_count * sizeof *start);
    for (int n = 0; n < solid->boundary_count; ++n)
        start[n] = fw_solid_position(solid, solid->boundary[n]);
    furthest[0] = 0;
    for (int tick = 1; tick <= TICKS_MAX; ++tick) {
        advance_free(solid);
        furthest[tick] = furthest[tick - 1];
        for (int n = 0; n < solid->boundary_count; ++n) {
            const fw_vec2 way =
                fw_vec2_subtract(fw_solid_position(solid, solid->boundary[n]), start[n]);
            furthest[tick] = fmax(furthest[tick], sqrt(fw_vec2_dot(way, way)));
        }
    }
    free(start);
}

static void assert_keeps_within_reach(fw_solid *solid)
{
    enum { COUNT = sizeof ticks / sizeof *ticks };
    double reach[COUNT], furthest[TICKS_MAX + 1];
    for (int n = 0; n < COUNT; ++n) reach[n] = solid->model->reach(solid, ticks[n]);
    follow(solid, furthest);
    for (int n = 0; n < COUNT; ++n) {
        assert_true(isfinite(reach[n]));
        assert_below(furthest[ticks[n]], reach[n]);
    }
}

static void random_bodies_keep_within_reach(void **state)
{
    (void)state;
    for (int kind = 0; kind < REST_KINDS; ++kind)
        for (int damped = 0; damped < 2; ++damped) {
            fw_sites sites = blob(1201, 5 + (uint64_t)kind);
            fw_solid *solid =
                solid_in_form(FW_LB_DISPLACEMENTS, &sites, kind, damped ? 0.97 : 1, INFINITY);
            assert_keeps_within_reach(solid);
            assert_keeps_within_reach(solid); /* from where it is then */
            fw_solid_destroy(solid);
            fw_sites_clear(&sites);
        }
}

static double reach_of(const fw_solid *solid, int count)
{
    return solid->model->reach(solid, count);
}

static void uniform_motion_is_all_of_the_reach(void **state)
{
    (void)state;
    fw_sites sites = blob(401, 3);
    fw_vec2 velocity[401];
    for (int l = 0; l < 401; ++l) velocity[l] = (fw_vec2){0.3, -0.4};
    for (int damped = 0; damped < 2; ++damped) {
        fw_solid *solid = moving_with(&sites, NULL, velocity, damped ? 0.97 : 1);
        assert_close(reach_of(solid, 48), 24, 1e-5);
        assert_keeps_within_reach(solid);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

/* A chain of square root of 2 links a tick: a step of height 1 runs along it, each particle moves
 * by 1/2 twice, and the last by 1 twice. All its squares are 2/4. */
static void step_along_a_chain_is_near_its_reach(void **state)
{
    (void)state;
    enum { LENGTH = 12 };
    fw_sites sites;
    fw_vec2 displacement[LENGTH], velocity[LENGTH];
    assert_int_equal(fw_sites_rectangle(&sites, LENGTH, 1, NULL), FW_OK);
    for (int l = 0; l < LENGTH; ++l) { /* x(0) is the step at 9, x(-1) the one at 8 */
        const double now = l <= 9, before = l <= 8;
        displacement[l] = (fw_vec2){0, 0.5 * (now + before)};
        velocity[l] = (fw_vec2){0, now - before};
    }
    fw_solid *solid = moving_with(&sites, displacement, velocity, 1);
    double furthest[TICKS_MAX + 1];
    const double reach = reach_of(solid, 4);
    follow(solid, furthest);
    assert_below(furthest[4], reach);
    assert_close(furthest[4], 2, 1e-12);
    assert_below(reach, 3.2 * furthest[4]);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* The middle of a body is struck: 50 sites away, that is heard of after 50 ticks. */
static void boundary_hears_of_the_middle_in_time(void **state)
{
    (void)state;
    enum { SIDE = 101, MIDDLE = (SIDE * SIDE - 1) / 2 };
    fw_sites sites;
    fw_vec2 *velocity = calloc(SIDE * SIDE, sizeof *velocity);
    assert_int_equal(fw_sites_rectangle(&sites, SIDE, SIDE, NULL), FW_OK);
    velocity[MIDDLE] = (fw_vec2){1, 0};
    fw_solid *solid = moving_with(&sites, NULL, velocity, 1);
    double furthest[TICKS_MAX + 1];
    const double soon = reach_of(solid, 32), later = reach_of(solid, TICKS_MAX);
    follow(solid, furthest);
    assert_true(furthest[49] == 0);
    assert_below(soon, 1e-6);
    assert_below(1e-6, furthest[TICKS_MAX]);
    assert_below(furthest[TICKS_MAX], later);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
    free(velocity);
}

/* Waves that ran away from a corner come back to it. */
static void focused_waves_keep_within_reach(void **state)
{
    (void)state;
    fw_sites sites;
    fw_vec2 velocity[60 * 40] = {{5, 5}};
    assert_int_equal(fw_sites_rectangle(&sites, 60, 40, NULL), FW_OK);
    for (int away = 10; away <= 50; away += 10) {
        fw_solid *solid = moving_with(&sites, NULL, velocity, 1);
        for (int tick = 0; tick < away; ++tick) advance_free(solid);
        fw_solid_reverse(solid);
        fw_solid_place(solid);
        assert_keeps_within_reach(solid);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

static void reach_holds_through_a_reversal(void **state)
{
    (void)state;
    fw_sites sites = blob(401, 8);
    fw_solid *solid = solid_in_form(FW_LB_DISPLACEMENTS, &sites, REST_SCALAR, 1, INFINITY);
    for (int tick = 0; tick < 30; ++tick) advance_free(solid);
    const double reach = reach_of(solid, 48);
    const fw_vec2 start = fw_solid_position(solid, solid->boundary[0]);
    for (int tick = 0; tick < 48; ++tick) {
        if (tick == 7) fw_solid_reverse(solid);
        advance_free(solid);
        const fw_vec2 way = fw_vec2_subtract(fw_solid_position(solid, solid->boundary[0]), start);
        assert_below(sqrt(fw_vec2_dot(way, way)), reach);
    }
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static void nobody_knows_of_populations_loads_and_what_is_no_number(void **state)
{
    (void)state;
    fw_sites sites = blob(157, 1);
    fw_solid *solid = solid_of(&sites, REST_NONE, 1, INFINITY);
    assert_true(reach_of(solid, 16) == INFINITY);
    fw_solid_destroy(solid);
    solid = solid_in_form(FW_LB_DISPLACEMENTS, &sites, REST_NONE, 1, INFINITY);
    assert_true(isfinite(reach_of(solid, 16)));
    assert_true(reach_of(solid, 1 << 20) == INFINITY);
    solid->loaded = true;
    assert_true(reach_of(solid, 16) == INFINITY);
    solid->loaded = false;
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    for (int n = 0; n < list.count; ++n)
        if (strcmp(list.array[n].name, "displacement-0-x") == 0)
            for (size_t k = 0; k < list.array[n].count; ++k)
                ((double *)list.array[n].data)[k] += NAN;
    assert_true(reach_of(solid, 16) == INFINITY);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_bodies_keep_within_reach),
        cmocka_unit_test(uniform_motion_is_all_of_the_reach),
        cmocka_unit_test(step_along_a_chain_is_near_its_reach),
        cmocka_unit_test(boundary_hears_of_the_middle_in_time),
        cmocka_unit_test(focused_waves_keep_within_reach),
        cmocka_unit_test(reach_holds_through_a_reversal),
        cmocka_unit_test(nobody_knows_of_populations_loads_and_what_is_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
