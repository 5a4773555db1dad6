/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The law of friction alone: Coulomb's with two coefficients, and what sticking lets through. */
#include "contact/constraint/friction_law.h"

#include "tests/support/laws.h"

static double traction(double kinetic, double at_rest, double reaction, double wanted, bool slid,
                       bool *slides)
{
    *slides = slid;
    return fw_friction_traction(fw_friction_of(kinetic, at_rest), reaction, wanted, slides);
}

static void what_sticks_bears_up_to_the_static_limit(void **state)
{
    (void)state;
    bool slides;
    for (int sign = -1; sign <= 1; sign += 2) {
        assert_close(traction(0.2, 0.4, 2, sign * 0.8, false, &slides), sign * 0.8, 0);
        assert_false(slides);
        assert_close(traction(0.2, 0.4, 2, sign * 0.8001, false, &slides), sign * 0.4, 1e-15);
        assert_true(slides);
    }
}

static void what_slides_sticks_where_the_kinetic_limit_is_enough(void **state)
{
    (void)state;
    bool slides;
    assert_close(traction(0.2, 0.4, 2, 0.4, true, &slides), 0.4, 0);
    assert_close(traction(0.2, 0.4, 2, 0.5, true, &slides), 0.4, 1e-15);
    assert_close(traction(0.2, 0.4, 2, -3, true, &slides), -0.4, 1e-15);
    assert_true(slides);
}

static void one_coefficient_is_a_cone(void **state)
{
    (void)state;
    for (int n = -50; n <= 50; ++n) {
        const double wanted = 0.03 * n, reaction = 0.9, cone = 0.3 * reaction;
        bool a, b;
        const double fresh = traction(0.3, 0.3, reaction, wanted, false, &a);
        assert_close(fresh, fmin(fmax(wanted, -cone), cone), 0);
        assert_close(traction(0.3, 0.3, reaction, wanted, true, &b), fresh, 0);
        assert_true(b);
    }
    assert_close(fw_friction_of(0.3, 0).at_rest, 0.3, 0);
}

static void without_a_reaction_there_is_no_friction(void **state)
{
    (void)state;
    bool slides;
    assert_close(traction(0.2, 0.4, 0, 5, false, &slides), 0, 0);
    assert_close(traction(0, 0, 3, 5, false, &slides), 0, 0);
}

/* P+ = -P + 2 M w, w = filter: both modes of what a stuck particle brought are (1 - sqrt 2)^t. */
static void the_filter_lets_momentum_die_out_as_fast_as_can_be(void **state)
{
    (void)state;
    assert_close(FW_STICK_FILTER, 6 - 4 * sqrt(2), 2e-4);
    double before = 1, now = -1 + 2 * fw_friction_filter(false, 1, 0);
    assert_close(now, 0, 0); /* F = -2 Psi + P */
    for (int t = 0; t < 40; ++t) {
        const double next = -now + 2 * fw_friction_filter(true, now, now - before);
        before = now;
        now = next;
    }
    assert_true(fabs(now) < 1e-13);
}

/* Nothing changes: nothing moves. */
static void a_steady_force_moves_nothing(void **state)
{
    (void)state;
    assert_close(fw_friction_filter(true, 0.7, 0), 0, 0);
    for (int n = -3; n <= 3; ++n) assert_close(fw_friction_target(true, 0.7, 0, 0.1 * n), 0, 0);
}

static void sticking_never_leads_against_the_free_motion_nor_beyond_it(void **state)
{
    (void)state;
    for (int n = -20; n <= 20; ++n)
        for (int m = -20; m <= 20; ++m) {
            const double slip = 0.1 * m, way = fw_friction_target(true, 0, n, slip);
            assert_true(way * slip >= 0 && fabs(way) <= fabs(slip));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_sticks_bears_up_to_the_static_limit),
        cmocka_unit_test(what_slides_sticks_where_the_kinetic_limit_is_enough),
        cmocka_unit_test(one_coefficient_is_a_cone),
        cmocka_unit_test(without_a_reaction_there_is_no_friction),
        cmocka_unit_test(the_filter_lets_momentum_die_out_as_fast_as_can_be),
        cmocka_unit_test(a_steady_force_moves_nothing),
        cmocka_unit_test(sticking_never_leads_against_the_free_motion_nor_beyond_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
