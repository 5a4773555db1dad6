/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_bytes.c - the same bytes from all instruction sets, from any number of threads,
 * and from ticks that are taken one by one or many at once. */
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/automaton/elastic_automaton.h"
#include "core/instruction_set.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(*seed >> 11) / 4503599627370496.0 - 1;
}

/* A rectangle with holes, so that spans begin and end anywhere. */
static fw_sites ragged(int columns, int rows)
{
    fw_site *list = malloc((size_t)columns * (size_t)rows * sizeof *list);
    uint64_t seed = 5;
    int count = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            if (i == 0 || j == 0 || random_number(&seed) < 0.96) list[count++] = (fw_site){i, j};
    fw_sites sites;
    assert_int_equal(fw_sites_list(&sites, list, count, NULL), FW_OK);
    free(list);
    return sites;
}

typedef struct body_kind {
    double damping;
    bool loaded, periodic_columns, periodic_rows, whole;
    double break_at;
} body_kind;

static const body_kind kinds[] = {
    {0, false, false, false, false, INFINITY}, {0.01, false, false, false, false, INFINITY},
    {0, true, false, false, false, INFINITY},  {0.01, true, false, false, false, INFINITY},
    {0, false, true, false, false, INFINITY},  {0.01, false, true, true, true, INFINITY},
    {0, false, false, false, false, 0.45},     {0.01, true, true, false, false, 0.45},
    {0, false, false, true, false, 0.45},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* Moving fast enough for its displacements to be recentred. */
static fw_solid *body_of(const body_kind *kind, int columns, int rows)
{
    fw_sites sites = ragged(columns, rows);
    if (kind->whole) {
        fw_sites_clear(&sites);
        assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    }
    const size_t count = (size_t)sites.count;
    fw_vec2 *u = malloc(count * sizeof *u), *v = malloc(count * sizeof *v);
    uint64_t seed = 21;
    for (size_t p = 0; p < count; ++p) {
        u[p] = (fw_vec2){0.1 * random_number(&seed), 0.1 * random_number(&seed)};
        v[p] = (fw_vec2){0.11, -0.07};
    }
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = (fw_automaton_speeds){1, 0.9};
    def.reflection = 1 - kind->damping;
    def.break_at = kind->break_at;
    def.period_columns = kind->periodic_columns ? columns : 0;
    def.period_rows = kind->periodic_rows ? rows : 0;
    def.displacement = u;
    def.velocity = v;
    fw_solid *solid;
    fw_error error;
    if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    solid->loaded = kind->loaded;
    for (int p = 0; kind->loaded && p < solid->count; ++p) {
        solid->external_x[p] = 0.01 * random_number(&seed);
        solid->external_y[p] = 0.01 * random_number(&seed);
    }
    free(u);
    free(v);
    fw_sites_clear(&sites);
    return solid;
}

static uint64_t hash_of(fw_solid *solid)
{
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    return fw_state_list_hash(&list);
}

/* After `ticks` of one body: the first of them held, the others free. */
static uint64_t hash_after(const body_kind *kind, int columns, int rows, int ticks)
{
    const fw_constraint holds[] = {{0, {0, 0}, {0, 0}},
                                   {1, {0.01, 0}, {0, 0}},
                                   {columns + 7, {0, 0}, {0, 0}},
                                   {3 * columns, {0.02, 0.01}, {0, 0}}};
    fw_solid *solid = body_of(kind, columns, rows);
    for (int tick = 0; tick < 5; ++tick) advance_held(solid, holds, sizeof holds / sizeof holds[0]);
    for (int tick = 5; tick < ticks; ++tick) advance_free(solid);
    const uint64_t hash = hash_of(solid);
    fw_solid_destroy(solid);
    return hash;
}

static void bytes_do_not_depend_on_instructions(void **state)
{
    (void)state;
    const int best = fw_instruction_set();
    for (int k = 0; k < KINDS; ++k) {
        const uint64_t expected = hash_after(&kinds[k], 60, 38, 61);
        for (int set = 0; set < best; ++set) {
            assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
            assert_true(hash_after(&kinds[k], 60, 38, 61) == expected);
        }
        assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(best), NULL), FW_OK);
    }
}

/* From an odd tick on. */
static uint64_t hash_of_leaps(const body_kind *kind, int leap)
{
    fw_error error;
    fw_solid *solid = body_of(kind, 260, 150);
    advance_free(solid);
    for (int left = 42; left > 0; left -= leap)
        assert_int_equal(fw_solid_move_free(solid, leap < left ? leap : left, &error), FW_OK);
    fw_solid_place(solid);
    const uint64_t hash = hash_of(solid);
    fw_solid_destroy(solid);
    return hash;
}

static void bytes_do_not_depend_on_how_many_ticks_are_taken_at_once(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        const uint64_t expected = hash_of_leaps(&kinds[k], 1);
        for (int threads = 1; threads <= 3; ++threads) {
            omp_set_num_threads(threads);
            assert_true(hash_of_leaps(&kinds[k], 42) == expected);
            assert_true(hash_of_leaps(&kinds[k], 5) == expected);
        }
        omp_set_num_threads(1);
    }
}

static void bytes_do_not_depend_on_threads(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        uint64_t hash[4];
        for (int threads = 1; threads <= 3; ++threads) {
            omp_set_num_threads(threads);
            hash[threads] = hash_after(&kinds[k], 260, 150, 21);
        }
        omp_set_num_threads(1);
        assert_true(hash[2] == hash[1] && hash[3] == hash[1]);
    }
}

/* The field of speeds asks cell by cell. */
static void velocities_are_those_of_each_cell(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = body_of(&kinds[k], 70, 20);
        const size_t count = (size_t)solid->count;
        double *x = malloc(3 * count * sizeof *x), *y = x + count, *speed = y + count;
        for (int tick = 0; tick < 20; ++tick) {
            advance_free(solid);
            solid->model->velocities(solid, x, y);
            fw_solid_find_field(solid, "speed")->fill(solid, speed);
            for (size_t p = 0; p < count; ++p) assert_true(hypot(x[p], y[p]) == speed[p]);
        }
        free(x);
        fw_solid_destroy(solid);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_do_not_depend_on_instructions),
        cmocka_unit_test(bytes_do_not_depend_on_threads),
        cmocka_unit_test(bytes_do_not_depend_on_how_many_ticks_are_taken_at_once),
        cmocka_unit_test(velocities_are_those_of_each_cell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
