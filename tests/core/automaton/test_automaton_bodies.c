/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_bodies.c - which bodies of the elastic automaton are accepted, how they break, and
 * that restarts change no bit. */
#include "tests/support/automata.h"
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/automaton/elastic_automaton.h"

#include <stdlib.h>
#include <string.h>

static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(*seed >> 11) / 4503599627370496.0 - 1;
}

static fw_solid *stirred(fw_elastic_automaton_def def, double amplitude)
{
    const size_t count = (size_t)def.sites->count;
    fw_vec2 *u = malloc(count * sizeof *u);
    uint64_t seed = 21;
    for (size_t p = 0; p < count; ++p)
        u[p] = (fw_vec2){amplitude * random_number(&seed), amplitude * random_number(&seed)};
    def.displacement = u;
    fw_solid *solid;
    fw_error error;
    if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    free(u);
    return solid;
}

static double energy(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

static void refused(const fw_elastic_automaton_def *def, const char *expected)
{
    fw_solid *solid;
    fw_error error = {0};
    assert_int_equal(fw_elastic_automaton_create(&solid, def, &error), FW_BAD_INPUT);
    assert_null(solid);
    if (!strstr(error.sentence, expected))
        fail_msg("\"%s\" does not say \"%s\"", error.sentence, expected);
}

static void bad_bodies_are_refused_with_the_reason(void **state)
{
    (void)state;
    fw_sites square = rectangle(6, 6), odd = rectangle(7, 6), chain = rectangle(5, 1);
    fw_sites loose = mask("#.#\n#..\n");
    fw_elastic_automaton_def def = def_of(&square, 1, 1.1);
    refused(&def, "c1^2 + c2^2 = 2.21 (c1 = 1, c2 = 1.1), expected at most 2");
    refused(&def, "grows by 1.891");
    def = def_of(&square, -1, 0);
    refused(&def, "c1 = -1");
    def = def_of(&odd, 1, 0.5);
    def.period_columns = 7;
    refused(&def, "a period of 7 columns, expected an even number");
    def.period_columns = 6;
    refused(&def, "takes 7 columns, expected at most its period of 6");
    def = def_of(&square, 0.4, 0.58);
    refused(&def, "boundary rule 'bond' with c1 = 0.4, c2 = 0.58 is unstable");
    refused(&def, "grows by 1.0845");
    def.boundary = FW_BOUNDARY_TRAPEZOID;
    refused(&def, "grows by 1.0643");
    def = def_of(&loose, 1, 0.5);
    refused(&def, "site [2, 1] has no neighbour");
    def = def_of(&chain, 1, 0.5);
    def.boundary = FW_BOUNDARY_MIRROR;
    refused(&def, "lacks two opposite neighbours");
    def = def_of(&square, 1, 0.5);
    def.reflection = 0;
    refused(&def, "reflection a = 0");
    def.reflection = 1.01;
    refused(&def, "reflection a = 1.01");
    def = def_of(&square, 1, 0.5);
    def.lattice.kind = FW_HEXAGONAL;
    refused(&def, "hexagonal");
    def = def_of(&square, 0.4, 0.5);
    def.break_at = 0.1;
    refused(&def, "breaking bonds with c1 = 0.4, c2 = 0.5");
    def = def_of(&square, 1, 0.5);
    def.break_at = NAN;
    refused(&def, "break-at nan");
    def.break_at = 0.1;
    def.boundary = FW_BOUNDARY_TRAPEZOID;
    refused(&def, "expected 'bond'");
    fw_vec2 u[36] = {{0, 0}};
    u[7].y = INFINITY;
    def = def_of(&square, 1, 0.5);
    def.displacement = u;
    refused(&def, "not finite");
    fw_sites_clear(&square);
    fw_sites_clear(&odd);
    fw_sites_clear(&chain);
    fw_sites_clear(&loose);
}

static void breaking_takes_energy_into_the_ledger(void **state)
{
    (void)state;
    fw_sites sites = rectangle(12, 8);
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
    def.break_at = 0.35;
    fw_solid *solid = stirred(def, 0.25);
    const double begin = energy(solid);
    const fw_vec2 p = fw_solid_momentum(solid);
    double before = begin;
    const int revision = solid->boundary_revision, links = solid->link_count;
    for (int tick = 0; tick < 4000; ++tick) {
        advance_free(solid);
        const double now = energy(solid);
        assert_true(now <= before * (1 + 1e-13));
        before = now;
    }
    const int broken = fw_elastic_automaton_broken(solid);
    assert_true(broken > 5 && broken < links);
    assert_int_equal(solid->link_count, links - broken);
    assert_true(solid->boundary_revision > revision);
    assert_true(solid->ledger.fracture > 0);
    assert_close(begin - before, solid->ledger.fracture, 1e-12 * begin);
    assert_true(solid->ledger.dissipated == solid->ledger.fracture);
    /* Fragments fly apart: by now their displacements are some hundred, known to 5e-14. */
    const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), p);
    assert_close(gained.x, solid->ledger.drag.x, 1e-11);
    assert_close(gained.y, solid->ledger.drag.y, 1e-11);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static bool is_exposed(const fw_solid *solid, int particle)
{
    bool found = false;
    for (int n = 0; n < solid->boundary_count; ++n) {
        assert_true(n == 0 || solid->boundary[n - 1] < solid->boundary[n]);
        found = found || solid->boundary[n] == particle;
    }
    return found;
}

/* From inside a body, whichever colour it is broken from. */
static void both_ends_of_a_broken_bond_are_exposed(void **state)
{
    (void)state;
    for (int from = 14; from <= 15; ++from) {
        fw_sites sites = rectangle(6, 6);
        fw_elastic_automaton_def def = def_of(&sites, 1, 0.5);
        def.break_at = 100;
        fw_solid *solid = stirred(def, 0.1);
        const int count = solid->boundary_count;
        assert_false(is_exposed(solid, from));
        assert_false(is_exposed(solid, from + 1));
        assert_true(fw_elastic_automaton_break(solid, from, FW_EAST));
        assert_true(is_exposed(solid, from));
        assert_true(is_exposed(solid, from + 1));
        assert_int_equal(solid->boundary_count, count + 2);
        fw_solid_destroy(solid);
        fw_sites_clear(&sites);
    }
}

static void rigid_motion_breaks_nothing(void **state)
{
    (void)state;
    fw_sites sites = rectangle(6, 5);
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
    def.break_at = 1e-9;
    fw_vec2 v[30];
    for (int p = 0; p < 30; ++p) v[p] = (fw_vec2){0.3, -0.2};
    def.velocity = v;
    fw_solid *solid;
    assert_int_equal(fw_elastic_automaton_create(&solid, &def, NULL), FW_OK);
    for (int tick = 0; tick < 400; ++tick) advance_free(solid);
    assert_int_equal(fw_elastic_automaton_broken(solid), 0);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static void cell_without_bonds_freezes(void **state)
{
    (void)state;
    fw_sites sites = rectangle(5, 5);
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.5);
    def.break_at = 100;
    fw_solid *solid = stirred(def, 0.1);
    for (int tick = 0; tick < 7; ++tick) advance_free(solid);
    const int corner = 24;
    assert_int_equal(fw_elastic_automaton_frozen(solid), 0);
    assert_true(fw_elastic_automaton_break(solid, corner, FW_WEST));
    assert_true(fw_elastic_automaton_break(solid, corner, FW_SOUTH));
    assert_false(fw_elastic_automaton_break(solid, corner, FW_SOUTH));
    assert_int_equal(fw_elastic_automaton_frozen(solid), 1);
    assert_int_equal(fw_elastic_automaton_broken(solid), 2);
    const fw_vec2 at = fw_solid_position(solid, corner);
    solid->loaded = true;
    solid->external_x[corner] = 1;
    for (int tick = 0; tick < 50; ++tick) advance_free(solid);
    assert_true(solid->x[corner] == at.x && solid->y[corner] == at.y);
    assert_true(solid->ledger.work == 0);
    fw_prediction prediction;
    fw_solid_predict(solid, &corner, 1, &prediction);
    assert_true(prediction.mobility.xx == 0);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static uint64_t hash_after(fw_solid *solid, int ticks)
{
    const fw_constraint constraints[] = {{3, {0, 0.01}, {0, 0}}, {17, {0, 0}, {0, 0}}};
    for (int tick = 0; tick < ticks; ++tick) advance_held(solid, constraints, 2);
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    return fw_state_list_hash(&list);
}

static void saved_state_goes_on_exactly(void **state)
{
    (void)state;
    /* Saved at an odd tick, in the middle of breaking; put back into the body that has broken
     * further, and into a fresh one. */
    fw_sites sites = rectangle(10, 9);
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
    def.break_at = 0.35;
    fw_solid *solid = stirred(def, 0.25), *fresh = stirred(def, 0);
    hash_after(solid, 5);
    fw_state_list list = {0}, other = {0};
    solid->model->state(solid, &list);
    void *saved[FW_STATE_CAPACITY];
    for (int n = 0; n < list.count; ++n) {
        const size_t bytes = list.array[n].count * fw_element_size(list.array[n].element);
        saved[n] = malloc(bytes);
        memcpy(saved[n], list.array[n].data, bytes);
    }
    const int broken = fw_elastic_automaton_broken(solid);
    const uint64_t expected = hash_after(solid, 400);
    assert_true(fw_elastic_automaton_broken(solid) > broken && broken > 0);
    fresh->model->state(fresh, &other);
    for (int n = 0; n < list.count; ++n) {
        const size_t bytes = list.array[n].count * fw_element_size(list.array[n].element);
        memcpy(list.array[n].data, saved[n], bytes);
        memcpy(other.array[n].data, saved[n], bytes);
        free(saved[n]);
    }
    restore(solid);
    restore(fresh);
    assert_int_equal(fw_elastic_automaton_broken(solid), broken);
    assert_true(hash_after(solid, 400) == expected);
    assert_true(hash_after(fresh, 400) == expected);
    fw_solid_destroy(solid);
    fw_solid_destroy(fresh);
    fw_sites_clear(&sites);
}

static void periodic_strip_has_no_seam(void **state)
{
    (void)state;
    /* Periodic along x, free along y: shifting the pattern by two columns shifts the motion. */
    enum { COLUMNS = 12, ROWS = 5 };
    fw_sites sites = rectangle(COLUMNS, ROWS);
    fw_solid *solid[2];
    fw_vec2 u[2][COLUMNS * ROWS];
    uint64_t seed = 8;
    for (int p = 0; p < COLUMNS * ROWS; ++p) {
        u[0][p] = (fw_vec2){random_number(&seed), random_number(&seed)};
        u[1][p / COLUMNS * COLUMNS + (p % COLUMNS + 2) % COLUMNS] = u[0][p];
    }
    for (int s = 0; s < 2; ++s) {
        fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
        def.period_columns = COLUMNS;
        def.displacement = u[s];
        assert_int_equal(fw_elastic_automaton_create(&solid[s], &def, NULL), FW_OK);
        for (int tick = 0; tick < 301; ++tick) advance_free(solid[s]);
    }
    for (int p = 0; p < COLUMNS * ROWS; ++p) {
        const int shifted = p / COLUMNS * COLUMNS + (p % COLUMNS + 2) % COLUMNS;
        const fw_vec2 a = fw_elastic_automaton_displacement(solid[0], p);
        const fw_vec2 b = fw_elastic_automaton_displacement(solid[1], shifted);
        assert_close(a.x, b.x, 1e-11);
        assert_close(a.y, b.y, 1e-11);
    }
    /* Bonds across the seam are no lines in pictures; only rows 0 and 4 can touch something. */
    assert_int_equal(solid[0]->link_count, (COLUMNS - 1) * ROWS + COLUMNS * (ROWS - 1));
    assert_int_equal(solid[0]->boundary_count, 2 * COLUMNS);
    fw_solid_destroy(solid[0]);
    fw_solid_destroy(solid[1]);
    fw_sites_clear(&sites);
}

/* Links that broke are taken out of the list: it is the one that a restart makes. */
static void list_of_links_is_that_of_a_restart(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 12, 9, NULL), FW_OK);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.break_at = 0.25;
    fw_solid *solid = stirred(def, 0.2);
    int most = 0;
    for (int tick = 0; tick < 200; ++tick) {
        const int before = solid->link_count;
        advance_free(solid);
        if (tick % 7 == 0) (void)fw_elastic_automaton_break(solid, tick / 2, tick % 4);
        const int count = solid->link_count, edge = solid->boundary_count;
        if (count == before) continue;
        if (before - count > most) most = before - count;
        int(*links)[2] = malloc((size_t)count * sizeof *links);
        int *boundary = malloc((size_t)edge * sizeof *boundary);
        memcpy(links, solid->links, (size_t)count * sizeof *links);
        memcpy(boundary, solid->boundary, (size_t)edge * sizeof *boundary);
        restore(solid);
        assert_int_equal(solid->link_count, count);
        assert_memory_equal(solid->links, links, (size_t)count * sizeof *links);
        assert_int_equal(solid->boundary_count, edge);
        assert_memory_equal(solid->boundary, boundary, (size_t)edge * sizeof *boundary);
        free(links);
        free(boundary);
    }
    assert_true(most > 1);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_bodies_are_refused_with_the_reason),
        cmocka_unit_test(breaking_takes_energy_into_the_ledger),
        cmocka_unit_test(both_ends_of_a_broken_bond_are_exposed),
        cmocka_unit_test(rigid_motion_breaks_nothing),
        cmocka_unit_test(cell_without_bonds_freezes),
        cmocka_unit_test(list_of_links_is_that_of_a_restart),
        cmocka_unit_test(saved_state_goes_on_exactly),
        cmocka_unit_test(periodic_strip_has_no_seam),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
