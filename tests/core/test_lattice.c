/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lattice.c - shapes and places. */
#include "tests/support/laws.h"

#include "core/lattice.h"

#include <string.h>

static void rectangle_is_in_row_order(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 3, 2, NULL), FW_OK);
    assert_int_equal(sites.count, 6);
    assert_int_equal(fw_sites_find(&sites, (fw_site){0, 1}), 3);
    assert_int_equal(fw_sites_find(&sites, (fw_site){3, 0}), -1);
    fw_sites_clear(&sites);
}

static void discs_have_gauss_counts(void **state)
{
    (void)state;
    /* Gauss' circle problem, N(r) for r = 0..6, and the hexagonal counterpart 1, 7, 19, 37. */
    const int square[] = {1, 5, 13, 29, 49, 81, 113};
    const int hexagonal[] = {1, 7, 19, 37};
    for (int r = 0; r < 7; ++r) {
        fw_sites sites;
        assert_int_equal(fw_sites_disc(&sites, FW_SQUARE, r, NULL), FW_OK);
        assert_int_equal(sites.count, square[r]);
        fw_sites_clear(&sites);
    }
    for (int r = 0; r < 4; ++r) {
        fw_sites sites;
        assert_int_equal(fw_sites_disc(&sites, FW_HEXAGONAL, r, NULL), FW_OK);
        assert_int_equal(sites.count, hexagonal[r]);
        fw_sites_clear(&sites);
    }
}

static void mask_reads_as_it_looks(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_mask(&sites, "#.#\n###\n", NULL), FW_OK);
    assert_int_equal(sites.count, 5);
    assert_int_equal(fw_sites_find(&sites, (fw_site){0, 1}), 3);
    assert_int_equal(fw_sites_find(&sites, (fw_site){1, 1}), -1);
    fw_sites_clear(&sites);
    fw_error error;
    assert_int_equal(fw_sites_mask(&sites, "#x\n", &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "'x'"));
}

static void listed_twice_is_refused(void **state)
{
    (void)state;
    const fw_site list[] = {{4, 1}, {0, 0}, {4, 1}};
    fw_sites sites;
    fw_error error;
    assert_int_equal(fw_sites_list(&sites, list, 3, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "[4, 1]"));
    assert_int_equal(sites.count, 0);
}

static void hexagonal_neighbours_are_one_spacing_apart(void **state)
{
    (void)state;
    const fw_lattice lattice = {FW_HEXAGONAL, 1.5, 0.3, {100, -7}};
    const fw_vec2 a = fw_lattice_position(&lattice, (fw_site){2, 3});
    const fw_site around[] = {{3, 3}, {1, 3}, {2, 4}, {3, 4}, {2, 2}, {3, 2}};
    for (int n = 0; n < 6; ++n) {
        fw_vec2 d = fw_vec2_subtract(fw_lattice_position(&lattice, around[n]), a);
        assert_close(sqrt(fw_vec2_dot(d, d)), 1.5, 1e-13);
    }
}

static void walking_finds_what_searching_finds(void **state)
{
    (void)state;
    fw_sites sites;
    fw_error error;
    assert_int_equal(fw_sites_mask(&sites, "#.##\n\n.#\n####\n", &error), FW_OK);
    const fw_site asked[] = {{-1, 0}, {0, 0}, {3, 0}, {4, 0}, {0, 1}, {1, 1}, {2, 1},  {3, 2},
                             {0, 3},  {1, 3}, {3, 3}, {9, 9}, {3, 0}, {0, 0}, {0, -1}, {2, 3}};
    int at = 0;
    for (size_t n = 0; n < sizeof asked / sizeof asked[0]; ++n)
        assert_int_equal(fw_sites_find_next(&sites, asked[n], &at),
                         fw_sites_find(&sites, asked[n]));
    fw_sites_clear(&sites);
}

static void lattices_turn_against_the_clock(void **state)
{
    (void)state;
    const fw_lattice square = {
        .kind = FW_SQUARE, .spacing = 2, .angle = FW_PI / 2, .origin = {3, 4}};
    const fw_vec2 right = fw_lattice_position(&square, (fw_site){1, 0});
    const fw_vec2 above = fw_lattice_position(&square, (fw_site){0, 1});
    assert_close(right.x, 3, 1e-15);
    assert_close(right.y, 6, 1e-15);
    assert_close(above.x, 1, 1e-15);
    assert_close(above.y, 4, 1e-15);
    const fw_vec2 step = fw_lattice_step(&square, FW_EAST);
    assert_close(step.x, 0, 1e-15);
    assert_close(step.y, 2, 1e-15);
}

/* To the last bit: in results a site's place is the same whoever made it. */
static void many_sites_lie_where_each_does(void **state)
{
    (void)state;
    const fw_site sites[] = {{0, 0}, {3, -2}, {-7, 5}, {1000, 1}};
    for (int n = 0; n < 4; ++n) {
        const fw_lattice lattice = {n % 2 ? FW_HEXAGONAL : FW_SQUARE, 1.1, n / 2 * 0.3, {0.1, -7}};
        fw_vec2 places[4];
        fw_lattice_place(&lattice, sites, 4, places);
        for (int s = 0; s < 4; ++s) {
            const fw_vec2 at = fw_lattice_position(&lattice, sites[s]);
            assert_true(places[s].x == at.x && places[s].y == at.y);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangle_is_in_row_order),
        cmocka_unit_test(lattices_turn_against_the_clock),
        cmocka_unit_test(many_sites_lie_where_each_does),
        cmocka_unit_test(discs_have_gauss_counts),
        cmocka_unit_test(mask_reads_as_it_looks),
        cmocka_unit_test(listed_twice_is_refused),
        cmocka_unit_test(walking_finds_what_searching_finds),
        cmocka_unit_test(hexagonal_neighbours_are_one_spacing_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
