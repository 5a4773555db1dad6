/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_bond_history.c - bonds that break, and particles that move away, whenever one looks. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"

#include "experiments/measures/bond_history.h"
#include "experiments/measures/layer.h"

static const fw_langevin_controls still = {.time_step = 0.005};

static fw_solid *pair(void)
{
    return solid_of(crowd_rectangle(2, 1, (fw_vec2){0, 0}, 1, 0, 1), fw_return_force_default(),
                    still, 1);
}

static fw_bond_history *history_of(const fw_solid *solid)
{
    fw_bond_history *history;
    assert_int_equal(fw_bond_history_create(&history, solid, 0, 100000, 1, NULL), FW_OK);
    assert_int_equal(history->lag, 200);
    assert_int_equal(history->look, 10);
    return history;
}

/* Puts the second particle that far from the first. */
static void place(fw_solid *solid, double distance)
{
    solid->x[1] = solid->x[0] + distance;
    solid->y[1] = solid->y[0];
    assert_int_equal(fw_langevin_refresh(solid, NULL), FW_OK);
}

/* Counts what breaks while the distance swings so often between two lengths, looked at so many
 * times in a swing. */
static double broken_in(double low, double high, int swings, int looks)
{
    fw_solid *solid = pair();
    fw_bond_history *h = history_of(solid);
    double broken = 0;
    for (int n = 0; n <= swings * looks; ++n) {
        place(solid, low + (high - low) * .5 * (1 - cos(2 * M_PI * n / looks)));
        if (fw_bond_history_look(h, solid, 10 * n)) broken += h->broken[0];
    }
    fw_bond_history_destroy(h);
    fw_solid_destroy(solid);
    return broken;
}

/* The radii are 1.25 and 1.5. */
static void a_bond_breaks_once_however_often_one_looks(void **state)
{
    (void)state;
    for (int looks = 4; looks <= 256; looks *= 4) {
        assert_close(broken_in(1, 1.6, 5, looks), 5, 0);
        assert_close(broken_in(1, 1.45, 5, looks), 0, 0);   /* never beyond the outer radius */
        assert_close(broken_in(1.3, 1.6, 5, looks), 0, 0);  /* never within the inner one */
        assert_close(broken_in(1.2, 1.55, 5, looks), 5, 0); /* both, and slowly between */
    }
}

static void only_what_is_due_is_looked_at(void **state)
{
    (void)state;
    fw_solid *solid = pair();
    fw_bond_history *h = history_of(solid);
    assert_false(fw_bond_history_look(h, solid, 0)); /* nothing is known of before */
    place(solid, 1.6);
    assert_false(fw_bond_history_look(h, solid, 5));
    assert_true(fw_bond_history_look(h, solid, 10));
    assert_close(h->broken[0], 1, 0);
    assert_close(h->broken[1], 1, 0);
    assert_true(fw_bond_history_look(h, solid, 20));
    assert_close(h->broken[0], 0, 0);
    assert_false(fw_bond_history_look(h, solid, 100010));
    fw_bond_history_destroy(h);
    fw_solid_destroy(solid);
}

static void motion_is_followed_over_one_lag_and_over_all(void **state)
{
    (void)state;
    fw_solid *solid = pair();
    fw_bond_history *h = history_of(solid);
    assert_int_equal(fw_bond_history_snapshot(h, 0, 1), -1);
    for (int n = 0; n <= 9; ++n) {
        place(solid, 1 + .01 * n * n);
        const int last = fw_bond_history_snapshot(h, 200 * n, 1);
        const int oldest = fw_bond_history_snapshot(h, 200 * n, FW_HISTORY_LAGS);
        assert_int_equal(last >= 0, n >= 1);
        assert_int_equal(oldest >= 0, n >= FW_HISTORY_LAGS);
        const bool bonded = n >= 1 && 1 + .01 * (n - 1) * (n - 1) < 1.25;
        if (last >= 0) {
            const fw_bond_change change = fw_bond_history_change(h, solid, last, 0);
            assert_close(change.bonds, bonded, 0);
            assert_close(change.square, bonded * pow(.01 * (2 * n - 1), 2), 1e-12);
            assert_close(change.along[0], change.square, 1e-12);
            assert_close(change.along[1], 0, 1e-12);
        }
        if (oldest >= 0 && n <= 8) {
            const fw_bond_change change = fw_bond_history_change(h, solid, oldest, 1);
            assert_close(change.square, pow(.01 * (n * n - (n - 4) * (n - 4)), 2), 1e-12);
        }
        fw_bond_history_remember(h, solid, 200 * n);
    }
    fw_bond_history_destroy(h);
    fw_solid_destroy(solid);
}

/* Six particles away from the origin, each moved its own way: of each, over those that were near
 * it, the change of what leads to them. */
static void each_bond_changes_by_the_motion_of_its_ends(void **state)
{
    (void)state;
    enum { COUNT = 6 };
    static const fw_vec2 moves[COUNT] = {{.1, .02},  {-.03, .2}, {.05, -.07},
                                         {.01, .11}, {.3, -.2},  {-.13, .04}};
    fw_solid *solid = solid_of(crowd_rectangle(3, 2, (fw_vec2){5, 7}, 1, .1, 4),
                               fw_return_force_default(), still, 1);
    fw_bond_history *h = history_of(solid);
    fw_vec2 before[COUNT];
    for (int i = 0; i < COUNT; ++i) before[i] = fw_solid_position(solid, i);
    fw_bond_history_remember(h, solid, 0);
    for (int i = 0; i < COUNT; ++i) {
        solid->x[i] += moves[i].x;
        solid->y[i] += moves[i].y;
    }
    assert_int_equal(fw_langevin_refresh(solid, NULL), FW_OK);
    const int snapshot = fw_bond_history_snapshot(h, 200, 1);
    for (int i = 0; i < COUNT; ++i) {
        const fw_bond_change change = fw_bond_history_change(h, solid, snapshot, i);
        double bonds = 0, along[2] = {0};
        for (int j = 0; j < COUNT; ++j) {
            const fw_vec2 apart = fw_vec2_subtract(before[j], before[i]);
            if (j == i || hypot(apart.x, apart.y) >= 1.25) continue;
            bonds += 1;
            along[0] += pow(moves[j].x - moves[i].x, 2);
            along[1] += pow(moves[j].y - moves[i].y, 2);
        }
        assert_true(bonds >= 2);
        assert_close(change.bonds, bonds, 0);
        assert_close(change.along[0], along[0], 1e-14);
        assert_close(change.along[1], along[1], 1e-14);
        assert_close(change.square, along[0] + along[1], 1e-14);
    }
    fw_bond_history_destroy(h);
    fw_solid_destroy(solid);
}

static void particles_that_there_are_not_are_noticed(void **state)
{
    (void)state;
    fw_solid *solid = pair();
    fw_bond_history *h = history_of(solid);
    fw_bond_history_look(h, solid, 0);
    assert_true(fw_bond_history_is_sound(h));
    h->bonds[0][0] = 2;
    assert_false(fw_bond_history_is_sound(h));
    h->bonds[0][0] = -2;
    assert_false(fw_bond_history_is_sound(h));
    h->bonds[0][0] = 1;
    h->past_bonds[7][3] = 7;
    assert_false(fw_bond_history_is_sound(h));
    fw_bond_history_destroy(h);
    fw_solid_destroy(solid);
}

/* --- the width of a layer --- */

static double width_by(double bin, double shift, double half, double sign)
{
    enum { BINS_MAX = 400 };
    double places[BINS_MAX], values[BINS_MAX];
    int count = 0;
    for (double x = -9; x <= 9; x += bin, ++count) {
        places[count] = x;
        values[count] = .5 + sign * .4 * exp(-(x - shift) * (x - shift) / (2 * half * half));
    }
    return fw_layer_width(places, values, count, .5 + sign * .2, sign, -6, 6);
}

/* A bump of Gauss's form is above half its height on 2 (2 ln 2)^(1/2) of its deviation. */
static void a_width_resolves_what_is_finer_than_a_bin(void **state)
{
    (void)state;
    double last = 0;
    for (double half = 1; half < 2; half += .05) {
        const double exact = 2 * sqrt(2 * log(2)) * half;
        for (double sign = -1; sign <= 1; sign += 2) {
            assert_close(width_by(.5, 0, half, sign), exact, .03 * exact);
            assert_close(width_by(.25, .1, half, sign), exact, .01 * exact);
        }
        assert_true(width_by(.5, 0, half, 1) > last + .05);
        last = width_by(.5, 0, half, 1);
    }
    const double places[] = {-2, -1, 0, 1, 2}, values[] = {1, NAN, 0, 1, 1};
    assert_close(fw_layer_width(places, values, 5, .5, -1, -6, 6), 1.5, 1e-15);
    assert_close(fw_layer_width(places, values, 5, .5, -1, -.5, .25), .75, 1e-15);
    assert_close(fw_layer_width(places, values, 5, -.5, -1, -6, 6), 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bond_breaks_once_however_often_one_looks),
        cmocka_unit_test(only_what_is_due_is_looked_at),
        cmocka_unit_test(motion_is_followed_over_one_lag_and_over_all),
        cmocka_unit_test(each_bond_changes_by_the_motion_of_its_ends),
        cmocka_unit_test(particles_that_there_are_not_are_noticed),
        cmocka_unit_test(a_width_resolves_what_is_finer_than_a_bin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
