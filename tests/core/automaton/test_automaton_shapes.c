/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_shapes.c - elastic automata of any shape, with holes and seams: their colours,
 * bonds and boundary are those that a search among all sites finds. */
#include "tests/support/automata.h"
#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"

#include <string.h>

enum { COLUMNS = 14, ROWS = 12 };

/* A shape as a table: particle + 1 of each site, 0: none; periods as of the definition. */
typedef struct shape {
    int particle[ROWS][COLUMNS];
    int period_columns, period_rows;
} shape;

static uint32_t drawn(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 8;
}

/* The particle at a site, across seams; -1: none. */
static int at(const shape *s, int i, int j)
{
    if (s->period_columns > 0) i = (i + s->period_columns) % s->period_columns;
    if (s->period_rows > 0) j = (j + s->period_rows) % s->period_rows;
    return i < 0 || j < 0 || i >= COLUMNS || j >= ROWS ? -1 : s->particle[j][i] - 1;
}

static bool is_alone(const shape *s, int i, int j)
{
    return at(s, i + 1, j) < 0 && at(s, i, j + 1) < 0 && at(s, i - 1, j) < 0 && at(s, i, j - 1) < 0;
}

/* So many of a hundred sites are there, but nobody alone. */
static fw_sites draw_shape(shape *s, int percent, uint32_t *seed)
{
    fw_site list[ROWS * COLUMNS];
    int count = 0;
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i) s->particle[j][i] = (int)(drawn(seed) % 100) < percent;
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i)
            if (s->particle[j][i] && is_alone(s, i, j)) s->particle[j][i] = 0;
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i) {
            if (!s->particle[j][i]) continue;
            list[count++] = (fw_site){i, j};
            s->particle[j][i] = count;
        }
    fw_sites sites;
    fw_error error;
    assert_int_equal(fw_sites_list(&sites, list, count, &error), FW_OK);
    return sites;
}

/* Links east and north of each particle in turn, but for those across seams; boundary: who lacks
 * one of eight around. */
static void expect_bonds(const shape *s, const fw_sites *sites, const fw_solid *solid)
{
    int links = 0, exposed = 0;
    for (int p = 0; p < sites->count; ++p) {
        const int i = sites->site[p].i, j = sites->site[p].j;
        const int partner[] = {i + 1 < COLUMNS ? at(s, i + 1, j) : -1,
                               j + 1 < ROWS ? at(s, i, j + 1) : -1};
        for (int d = 0; d < 2; ++d) {
            if (partner[d] < 0) continue;
            assert_true(links < solid->link_count);
            assert_int_equal(solid->links[links][0], p);
            assert_int_equal(solid->links[links++][1], partner[d]);
        }
        bool full = true;
        for (int n = 0; n < 9; ++n) full &= at(s, i + n % 3 - 1, j + n / 3 - 1) >= 0;
        if (!full) {
            assert_true(exposed < solid->boundary_count);
            assert_int_equal(solid->boundary[exposed++], p);
        }
        assert_int_equal(fw_elastic_automaton_is_black(solid, p), (i + j) % 2 == 0);
    }
    assert_int_equal(links, solid->link_count);
    assert_int_equal(exposed, solid->boundary_count);
}

/* Where one particle alone is displaced, those move that are bonded to it, across seams too. */
static void expect_neighbours(const shape *s, const fw_elastic_automaton_def *made)
{
    const fw_sites *sites = made->sites;
    fw_elastic_automaton_def def = *made;
    def.displaced_as_given = true;
    for (int p = 0; p < sites->count; ++p) {
        const int i = sites->site[p].i, j = sites->site[p].j;
        if ((i + j) % 2 == 0) continue; /* black ones move first */
        fw_vec2 u[ROWS * COLUMNS] = {{0, 0}};
        u[p] = (fw_vec2){0.1, 0.2};
        def.displacement = u;
        fw_solid *solid;
        fw_error error;
        if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK)
            fail_msg("%s", error.sentence);
        if (fw_solid_move_free(solid, 1, &error) != FW_OK) fail_msg("%s", error.sentence);
        for (int n = 0; n < sites->count; ++n) {
            const fw_vec2 moved = fw_elastic_automaton_displacement(solid, n);
            const bool near = n == at(s, i + 1, j) || n == at(s, i, j + 1) ||
                              n == at(s, i - 1, j) || n == at(s, i, j - 1);
            assert_int_equal(moved.x != 0, n == p || near);
        }
        fw_solid_destroy(solid);
    }
}

static void make_and_compare(int period_columns, int period_rows)
{
    uint32_t seed = 5;
    for (int percent = 40; percent <= 100; percent += 5) {
        shape s = {.period_columns = period_columns, .period_rows = period_rows};
        fw_sites sites = draw_shape(&s, percent, &seed);
        fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
        def.sites = &sites;
        def.period_columns = period_columns;
        def.period_rows = period_rows;
        fw_solid *solid;
        fw_error error;
        if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK)
            fail_msg("%s", error.sentence);
        expect_bonds(&s, &sites, solid);
        fw_solid_destroy(solid);
        if (percent % 20 == 0) expect_neighbours(&s, &def);
        fw_sites_clear(&sites);
    }
}

static void shapes_with_holes_have_the_bonds_of_their_sites(void **state)
{
    (void)state;
    make_and_compare(0, 0);
}

static void seams_join_the_ends_of_ragged_shapes(void **state)
{
    (void)state;
    make_and_compare(COLUMNS, 0);
    make_and_compare(0, ROWS);
    make_and_compare(COLUMNS, ROWS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_with_holes_have_the_bonds_of_their_sites),
        cmocka_unit_test(seams_join_the_ends_of_ragged_shapes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
