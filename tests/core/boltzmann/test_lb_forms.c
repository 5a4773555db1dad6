/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_forms.c - the displacement form of the LB solid is its populations, which know nothing of
 * it; and its bytes depend on nothing but the state. */
#include "tests/support/lb_bodies.h"

#include "core/boltzmann/lb_state.h"
#include "core/instruction_set.h"

#include <omp.h>
#include <string.h>

static double apart(fw_vec2 a, fw_vec2 b)
{
    return fmax(fabs(a.x - b.x), fabs(a.y - b.y));
}

static uint64_t hash_of(fw_solid *solid)
{
    fw_solid_place(solid);
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    return fw_state_list_hash(&list);
}

static void move_free(fw_solid *solid, int ticks)
{
    fw_error error;
    assert_moved(fw_solid_move_free(solid, ticks, &error), &error);
}

/* Largest difference of any field of two solids. */
static double field_difference(const fw_solid *a, const fw_solid *b)
{
    const lb_solid *one = (const lb_solid *)a, *two = (const lb_solid *)b;
    double worst = 0;
    for (int l = 0; l < a->count; ++l) {
        worst = fmax(worst, apart(lb_rest(one, l), lb_rest(two, l)));
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            if (one->present[l] & (1u << d))
                worst = fmax(worst, apart(lb_field(one, l, d), lb_field(two, l, d)));
    }
    return worst;
}

enum { SITES = 401 };
typedef struct forms {
    fw_sites sites;
    fw_solid *populations, *displacements;
    fw_vec2 start[SITES];
} forms;

static forms both_forms(int kind, double mu, uint64_t seed)
{
    forms both = {.sites = blob(SITES, seed)};
    both.populations = solid_of(&both.sites, kind, mu, INFINITY);
    both.displacements = solid_in_form(FW_LB_DISPLACEMENTS, &both.sites, kind, mu, INFINITY);
    assert_int_equal(fw_lb_solid_form(both.populations), FW_LB_POPULATIONS);
    assert_int_equal(fw_lb_solid_form(both.displacements), FW_LB_DISPLACEMENTS);
    for (int l = 0; l < SITES; ++l) both.start[l] = fw_solid_position(both.populations, l);
    return both;
}

static void destroy_forms(forms *both)
{
    fw_solid_destroy(both->populations);
    fw_solid_destroy(both->displacements);
    fw_sites_clear(&both->sites);
}

/* Displacements are rounded as they are large; positions, near 50, by 7e-15 each time. */
static void assert_same_solid(const forms *both)
{
    const fw_solid *a = both->populations, *b = both->displacements;
    double displaced = 1;
    for (int l = 0; l < SITES; ++l) {
        assert_below(apart(fw_solid_position(a, l), fw_solid_position(b, l)), 1e-12);
        displaced = fmax(displaced, apart(fw_solid_position(a, l), both->start[l]));
    }
    assert_below(field_difference(a, b), 1e-14 * displaced);
    const fw_energies e = fw_solid_energies(a), f = fw_solid_energies(b);
    assert_close(f.kinetic, e.kinetic, 1e-12 * e.kinetic);
    assert_close(f.elastic, e.elastic, 1e-12 * e.elastic);
    assert_below(apart(fw_solid_momentum(a), fw_solid_momentum(b)), 1e-12);
    assert_close(b->ledger.work, a->ledger.work, 1e-12);
    assert_close(b->ledger.dissipated, a->ledger.dissipated, 1e-12);
    assert_below(apart(a->ledger.impulse, b->ledger.impulse), 1e-12);
    assert_below(apart(a->ledger.drag, b->ledger.drag), 1e-12);
}

static void displacements_are_the_populations(void **state)
{
    (void)state;
    const double mu[] = {1, 0.9, 0.6};
    for (int kind = 0; kind < REST_KINDS; ++kind)
        for (int n = 0; n < 3; ++n) {
            forms both = both_forms(kind, mu[n], 3);
            for (int step = 0; step < 200; ++step) {
                uint64_t seed = (uint64_t)step, again = seed;
                if (step % 3) {
                    push_at_random(both.populations, &seed);
                    push_at_random(both.displacements, &again);
                } else {
                    both.populations->loaded = both.displacements->loaded = false;
                }
                const fw_constraint held[] = {
                    {17, {0, 0}, {0, 0}},
                    {100 + step % 50, {0.01 * random_number(&seed), 0.01}, {0, 0}}};
                const int count = step < 100 ? 2 : 0;
                advance_held(both.populations, held, count);
                advance_held(both.displacements, held, count);
            }
            assert_same_solid(&both);
            destroy_forms(&both);
        }
}

/* What contact asks before it decides. */
static void both_forms_predict_the_same(void **state)
{
    (void)state;
    forms both = both_forms(REST_PER_SITE, 0.9, 5);
    uint64_t seed = 8, again = 8;
    for (int step = 0; step < 20; ++step) {
        push_at_random(both.populations, &seed);
        push_at_random(both.displacements, &again);
        fw_prediction a[SITES], b[SITES];
        int all[SITES];
        for (int l = 0; l < SITES; ++l) all[l] = l;
        fw_solid_predict(both.populations, all, SITES, a);
        fw_solid_predict(both.displacements, all, SITES, b);
        fw_vec2 before[SITES];
        for (int l = 0; l < SITES; ++l) before[l] = fw_solid_position(both.displacements, l);
        advance_free(both.populations);
        advance_free(both.displacements);
        for (int l = 0; l < SITES; ++l) {
            const fw_vec2 moved =
                fw_vec2_subtract(fw_solid_position(both.displacements, l), before[l]);
            assert_below(apart(a[l].displacement, b[l].displacement), 1e-13);
            assert_below(apart(a[l].inertial, b[l].inertial), 1e-13);
            assert_below(apart(moved, b[l].displacement), 1e-13);
        }
    }
    destroy_forms(&both);
}

static void held_particle_stays_to_the_bit(void **state)
{
    (void)state;
    forms both = both_forms(REST_SCALAR, 1, 2);
    fw_solid *solid = both.displacements;
    const double x = solid->x[33], y = solid->y[33];
    const fw_energies e0 = fw_solid_energies(solid);
    const fw_constraint resting = {33, {0, 0}, {0, 0}};
    advance_held(solid, &resting, 1);
    const double first_x = solid->x[33], first_y = solid->y[33];
    for (int step = 0; step < 500; ++step) advance_held(solid, &resting, 1);
    const fw_energies e = fw_solid_energies(solid);
    assert_true(solid->x[33] == first_x && solid->y[33] == first_y);
    assert_close(first_x, x, 1e-14);
    assert_close(first_y, y, 1e-14);
    assert_close((e.kinetic + e.elastic) / (e0.kinetic + e0.elastic), 1, 1e-12);
    destroy_forms(&both);
}

static void runs_back_the_way_it_came(void **state)
{
    (void)state;
    forms both = both_forms(REST_MATRIX, 1, 4);
    for (int back = 0; back < 2; ++back) {
        for (int step = 0; step < 150; ++step) {
            advance_free(both.populations);
            advance_free(both.displacements);
        }
        assert_same_solid(&both);
        fw_solid_reverse(both.populations);
        fw_solid_reverse(both.displacements);
        assert_same_solid(&both);
    }
    destroy_forms(&both);
}

static void only_what_has_no_hidden_modes_has_displacements(void **state)
{
    (void)state;
    fw_sites sheet, scattered;
    const fw_site far_apart[] = {{0, 0}, {100000, 0}, {0, 1}, {100000, 1}};
    assert_int_equal(fw_sites_rectangle(&sheet, 5, 4, NULL), FW_OK);
    assert_int_equal(fw_sites_list(&scattered, far_apart, 4, NULL), FW_OK);
    for (int n = 0; n < 4; ++n) {
        fw_solid *solid;
        fw_lb_solid_def def = fw_lb_solid_def_default();
        def.form = FW_LB_DISPLACEMENTS;
        def.sites = n == 3 ? &scattered : &sheet;
        if (n == 1) def.stiffness = fw_sym2_scalar(1.5);
        if (n == 2) def.break_at = 0.1;
        assert_int_equal(fw_lb_solid_create(&solid, &def, NULL), FW_OK);
        assert_int_equal(fw_lb_solid_form(solid), n == 0 ? FW_LB_DISPLACEMENTS : FW_LB_POPULATIONS);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sheet);
    fw_sites_clear(&scattered);
}

/* A sheet that moves and rings. */
static fw_solid *moving_sheet(fw_vec2 velocity)
{
    fw_sites sites;
    fw_solid *solid;
    fw_vec2 velocities[70], displacements[70];
    assert_int_equal(fw_sites_rectangle(&sites, 10, 7, NULL), FW_OK);
    uint64_t seed = 2;
    for (int l = 0; l < 70; ++l) {
        velocities[l] = velocity;
        displacements[l] = (fw_vec2){1e-3 * random_number(&seed), 1e-3 * random_number(&seed)};
    }
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.form = FW_LB_DISPLACEMENTS;
    def.sites = &sites;
    def.rest_mass = fw_sym2_scalar(0.8);
    def.velocity = velocities;
    def.displacement = displacements;
    assert_int_equal(fw_lb_solid_create(&solid, &def, NULL), FW_OK);
    fw_sites_clear(&sites);
    return solid;
}

/* 100 spacings of .01 and more would leave the energy of the ringing, some 1e-4, at 1e-10. */
static void what_moves_far_rings_as_what_rests(void **state)
{
    (void)state;
    fw_solid *resting = moving_sheet((fw_vec2){0, 0}),
             *moving = moving_sheet((fw_vec2){0.25, -0.125});
    const fw_vec2 begin = moving->model->centre_of_mass(moving);
    move_free(resting, 4000);
    move_free(moving, 4000);
    fw_solid_place(moving);
    const fw_vec2 end = moving->model->centre_of_mass(moving);
    assert_close(end.x, begin.x + 1000, 1e-11);
    assert_close(end.y, begin.y - 500, 1e-11);
    const double elastic = fw_solid_energies(resting).elastic;
    assert_close(fw_solid_energies(moving).elastic, elastic, 1e-11 * elastic);
    fw_solid_destroy(resting);
    fw_solid_destroy(moving);
}

static void where_displacements_are_cut_is_no_matter_of_grouping(void **state)
{
    (void)state;
    fw_solid *one = moving_sheet((fw_vec2){0.25, -0.125}),
             *many = moving_sheet((fw_vec2){0.25, -0.125});
    for (int n = 0; n < 105; ++n) advance_free(one);
    for (int n = 0; n < 105; n += 21) move_free(many, 21);
    assert_true(hash_of(one) == hash_of(many));
    fw_solid_destroy(one);
    fw_solid_destroy(many);
}

/* --- bytes --- */

enum { SHEET, DISC, CHAIN, HOLED, SHAPES };

static fw_sites shape_of(int shape)
{
    fw_sites sites;
    if (shape == SHEET) assert_int_equal(fw_sites_rectangle(&sites, 203, 147, NULL), FW_OK);
    if (shape == DISC) assert_int_equal(fw_sites_disc(&sites, FW_SQUARE, 80.3, NULL), FW_OK);
    if (shape == CHAIN) assert_int_equal(fw_sites_rectangle(&sites, 3, 9000, NULL), FW_OK);
    if (shape == HOLED) sites = blob(3001, 6);
    return sites;
}

/* After 95 ticks, `group` at a time. */
static uint64_t hash_after(int shape, int kind, double mu, int group)
{
    fw_sites sites = shape_of(shape);
    fw_solid *solid = solid_in_form(FW_LB_DISPLACEMENTS, &sites, kind, mu, INFINITY);
    assert_int_equal(fw_lb_solid_form(solid), FW_LB_DISPLACEMENTS);
    uint64_t seed = 12;
    if (kind == REST_SCALAR) push_at_random(solid, &seed);
    for (int ticks = 95; ticks > 0; ticks -= group) {
        if (group == 1)
            advance_free(solid);
        else
            move_free(solid, ticks < group ? ticks : group);
    }
    const uint64_t hash = hash_of(solid);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
    return hash;
}

static void bytes_depend_on_the_state_alone(void **state)
{
    (void)state;
    const int groups[] = {1, 2, 7, 16, 40, 95};
    const int best = fw_instruction_set();
    for (int shape = 0; shape < SHAPES; ++shape)
        for (int kind = 0; kind < REST_KINDS; ++kind) {
            const double mu = (kind + shape) % 2 ? 0.97 : 1;
            const uint64_t expected = hash_after(shape, kind, mu, 1);
            for (int threads = 1; threads <= 3; ++threads) {
                omp_set_num_threads(threads);
                for (int n = 0; n < 6; ++n)
                    assert_true(hash_after(shape, kind, mu, groups[n]) == expected);
            }
            omp_set_num_threads(1);
            for (int set = 0; set < best; ++set) {
                assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
                assert_true(hash_after(shape, kind, mu, 40) == expected);
            }
            assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(best), NULL), FW_OK);
        }
}

static void bytes_under_loads_and_holds_depend_on_the_state_alone(void **state)
{
    (void)state;
    const int best = fw_instruction_set();
    const fw_constraint held[] = {{0, {0, 0.001}, {0, 0}}, {7007, {0, 0}, {0, 0}}};
    for (int kind = 0; kind < REST_KINDS; ++kind) {
        uint64_t expected = 0;
        for (int run = 0; run < 2 + best; ++run) {
            omp_set_num_threads(run == 1 ? 2 : 1);
            const char *instructions = fw_instruction_set_name(run < 2 ? best : run - 2);
            assert_int_equal(fw_instruction_set_use(instructions, NULL), FW_OK);
            fw_sites sites = shape_of(DISC);
            fw_solid *solid = solid_in_form(FW_LB_DISPLACEMENTS, &sites, kind, 0.9, INFINITY);
            uint64_t seed = 3;
            for (int step = 0; step < 12; ++step) {
                push_at_random(solid, &seed);
                advance_held(solid, held, 2);
            }
            if (run == 0) expected = hash_of(solid);
            assert_true(hash_of(solid) == expected);
            fw_solid_destroy(solid);
            fw_sites_clear(&sites);
        }
        assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(best), NULL), FW_OK);
        omp_set_num_threads(1);
    }
}

static void restored_state_goes_on_to_the_bit(void **state)
{
    (void)state;
    fw_sites sites = blob(157, 21);
    fw_solid *one = solid_in_form(FW_LB_DISPLACEMENTS, &sites, REST_MATRIX, 0.98, INFINITY);
    fw_solid *two = solid_in_form(FW_LB_DISPLACEMENTS, &sites, REST_MATRIX, 0.98, INFINITY);
    move_free(one, 101);
    fw_state_list from = {0}, to = {0};
    one->model->state(one, &from);
    two->model->state(two, &to);
    assert_int_equal(from.count, to.count);
    for (int n = 0; n < from.count; ++n)
        memcpy(to.array[n].data, from.array[n].data,
               from.array[n].count * fw_element_size(from.array[n].element));
    restore(two);
    move_free(one, 100);
    for (int step = 0; step < 100; ++step) advance_free(two);
    assert_true(hash_of(one) == hash_of(two));
    fw_solid_destroy(one);
    fw_solid_destroy(two);
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(displacements_are_the_populations),
        cmocka_unit_test(both_forms_predict_the_same),
        cmocka_unit_test(held_particle_stays_to_the_bit),
        cmocka_unit_test(runs_back_the_way_it_came),
        cmocka_unit_test(only_what_has_no_hidden_modes_has_displacements),
        cmocka_unit_test(what_moves_far_rings_as_what_rests),
        cmocka_unit_test(where_displacements_are_cut_is_no_matter_of_grouping),
        cmocka_unit_test(bytes_depend_on_the_state_alone),
        cmocka_unit_test(bytes_under_loads_and_holds_depend_on_the_state_alone),
        cmocka_unit_test(restored_state_goes_on_to_the_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
