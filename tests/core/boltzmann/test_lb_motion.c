/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_motion.c - what is told of an LB solid without placing it is what it has once placed, to
 * the bit: positions, velocities, the middle; and whether anything is far away. */
#include "tests/support/lb_bodies.h"

#include "core/boltzmann/lb_state.h"
#include "core/instruction_set.h"

#include <omp.h>
#include <string.h>

enum { SITES = 1501, SPARE = 3 };

/* After 37 free ticks, not placed. */
static fw_solid *unplaced(fw_lb_form form, const fw_sites *sites, int kind)
{
    fw_error error;
    fw_solid *solid = solid_in_form(form, sites, kind, 0.97, INFINITY);
    assert_moved(fw_solid_move_free(solid, 37, &error), &error);
    return solid;
}

/* V = M^-1 sum f (Eq 3), link by link. */
static fw_vec2 velocity_of(const fw_solid *solid, int l)
{
    const lb_solid *lb = (const lb_solid *)solid;
    return fw_sym2_apply(lb_inverse_of(lb, l), lb_psi(lb, l));
}

/* What lies around the numbers that were asked for is not touched. */
static void assert_told(const fw_solid *unplaced_one, const fw_solid *placed, int first, int count)
{
    double told[4][SITES + 2 * SPARE];
    for (int n = 0; n < 4; ++n)
        for (int k = 0; k < SITES + 2 * SPARE; ++k) told[n][k] = 77;
    const fw_motions motions = {told[0] + SPARE, told[1] + SPARE, told[2] + SPARE, told[3] + SPARE};
    unplaced_one->model->motions(unplaced_one, first, count, &motions);
    for (int k = 0; k < count; ++k) {
        const fw_vec2 v = velocity_of(placed, first + k);
        assert_true(motions.x[k] == placed->x[first + k]);
        assert_true(motions.y[k] == placed->y[first + k]);
        assert_true(motions.velocity_x[k] == v.x && motions.velocity_y[k] == v.y);
    }
    for (int n = 0; n < 4; ++n)
        for (int k = 0; k < SPARE; ++k)
            assert_true(told[n][k] == 77 && told[n][SPARE + count + k] == 77);
}

static void motions_are_told_as_they_are_placed(void **state)
{
    (void)state;
    fw_sites sites = blob(SITES, 6);
    const int best = fw_instruction_set();
    for (int form = 0; form < 2; ++form)
        for (int kind = 0; kind < REST_KINDS; ++kind)
            for (int set = 0; set <= best; ++set) {
                const fw_lb_form kept = form ? FW_LB_DISPLACEMENTS : FW_LB_POPULATIONS;
                fw_solid *one = unplaced(kept, &sites, kind), *other = unplaced(kept, &sites, kind);
                fw_solid_place(other);
                assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
                assert_told(one, other, 0, SITES);
                for (int first = 0; first < 40; ++first) assert_told(one, other, first, 1);
                for (int first = 5; first < SITES; first += 211)
                    assert_told(one, other, first, SITES - first < 97 ? SITES - first : 97);
                assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(best), NULL),
                                 FW_OK);
                fw_solid_destroy(one);
                fw_solid_destroy(other);
            }
    fw_sites_clear(&sites);
}

static void velocities_are_the_same_for_any_number_of_threads(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_disc(&sites, FW_SQUARE, 80.3, NULL), FW_OK);
    fw_solid *solid = unplaced(FW_LB_DISPLACEMENTS, &sites, REST_NONE);
    const size_t count = (size_t)solid->count;
    double *x = malloc(2 * count * sizeof *x), *y = malloc(2 * count * sizeof *y);
    for (int threads = 1; threads <= 2; ++threads) {
        omp_set_num_threads(threads);
        const size_t from = (size_t)(threads - 1) * count;
        solid->model->velocities(solid, x + from, y + from);
    }
    omp_set_num_threads(1);
    assert_memory_equal(x, x + count, count * sizeof *x);
    assert_memory_equal(y, y + count, count * sizeof *y);
    for (int l = 0; l < solid->count; l += 97) {
        const fw_vec2 v = velocity_of(solid, l);
        assert_true(x[l] == v.x && y[l] == v.y);
    }
    free(x);
    free(y);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* sum M (r - r_0), particle by particle. */
static fw_vec2 middle_of(const fw_solid *solid)
{
    fw_vec2 base = fw_solid_position(solid, 0), sum = {0, 0};
    for (int l = 0; l < solid->count; ++l) {
        const fw_vec2 from = fw_vec2_subtract(fw_solid_position(solid, l), base);
        sum = fw_vec2_add(sum, fw_sym2_apply(fw_lb_solid_mass(solid, l), from));
    }
    return fw_vec2_add(base, fw_sym2_apply(fw_sym2_invert(solid->model->mass(solid)), sum));
}

static void the_middle_needs_no_placing(void **state)
{
    (void)state;
    fw_sites sites = blob(SITES, 3);
    const int best = fw_instruction_set();
    for (int form = 0; form < 2; ++form)
        for (int kind = 0; kind < REST_KINDS; ++kind) {
            const fw_lb_form kept = form ? FW_LB_DISPLACEMENTS : FW_LB_POPULATIONS;
            fw_solid *solid = unplaced(kept, &sites, kind);
            fw_vec2 told[FW_INSTRUCTION_SETS];
            for (int set = 0; set <= best; ++set) {
                assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
                told[set] = solid->model->centre_of_mass(solid);
            }
            fw_solid_place(solid);
            const fw_vec2 expected = middle_of(solid);
            for (int set = 0; set <= best; ++set)
                assert_true(told[set].x == expected.x && told[set].y == expected.y);
            fw_solid_destroy(solid);
        }
    fw_sites_clear(&sites);
}

/* --- far away --- */

static bool keeps_within(const fw_solid *solid, double limit)
{
    return solid->model->stays_within(solid, (fw_vec2){50, 50}, limit);
}

static void displace(fw_solid *solid, int half, int l, double x, double y)
{
    displacement_form *form = &((lb_solid *)solid)->form;
    form->x[half][form->grid.place[l]] = x;
    form->y[half][form->grid.place[l]] = y;
}

static void what_is_lost_does_not_stay_within(void **state)
{
    (void)state;
    static const double far_away[] = {1e6, -1e6, INFINITY, -INFINITY, NAN};
    fw_sites sites = blob(SITES, 9);
    fw_solid *populations = unplaced(FW_LB_POPULATIONS, &sites, REST_NONE);
    assert_false(keeps_within(populations, 1e9));
    fw_solid_destroy(populations);
    const int best = fw_instruction_set();
    for (int set = 0; set <= best; ++set) {
        assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
        fw_solid *solid = unplaced(FW_LB_DISPLACEMENTS, &sites, REST_NONE);
        assert_true(keeps_within(solid, 1000));
        assert_true(keeps_within(solid, INFINITY));
        assert_false(keeps_within(solid, 10)); /* the blob is larger */
        for (int l = 0; l < SITES; l += 131)
            for (size_t n = 0; n < sizeof far_away / sizeof *far_away; ++n)
                for (int half = 0; half < 4; ++half) {
                    const double x = half < 2 ? far_away[n] : 0, y = half < 2 ? 0 : far_away[n];
                    displace(solid, half % 2, l, x, y);
                    assert_false(keeps_within(solid, 1000));
                    displace(solid, half % 2, l, 0, 0);
                }
        assert_true(keeps_within(solid, 1000));
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

/* True is only said where the look at each position says so too. */
static void what_stays_within_is_not_lost(void **state)
{
    (void)state;
    fw_sites sites = blob(SITES, 9);
    fw_solid *solid = unplaced(FW_LB_DISPLACEMENTS, &sites, REST_NONE);
    fw_solid_place(solid);
    int sure = 0;
    for (double limit = 5; limit < 100; limit *= 1.01) {
        if (!keeps_within(solid, limit)) continue;
        assert_int_equal(fw_solid_find_lost(solid, (fw_vec2){50, 50}, limit), -1);
        ++sure;
    }
    assert_true(sure > 10);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motions_are_told_as_they_are_placed),
        cmocka_unit_test(velocities_are_the_same_for_any_number_of_threads),
        cmocka_unit_test(the_middle_needs_no_placing),
        cmocka_unit_test(what_is_lost_does_not_stay_within),
        cmocka_unit_test(what_stays_within_is_not_lost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
