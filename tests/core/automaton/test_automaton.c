/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton.c - bodies of the elastic automaton: what they keep, how they start, what holds
 * and loads do to them, and that Chopard's automaton is the LB solid. */
#include "tests/support/automata.h"
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(*seed >> 11) / 4503599627370496.0 - 1;
}

/* A ragged body without loose cells, one opening, thin and thick parts. */
static fw_sites ragged(void)
{
    fw_sites sites;
    assert_int_equal(fw_sites_mask(&sites,
                                   "......####..\n"
                                   "..#########.\n"
                                   "############\n"
                                   "####...#####\n"
                                   "####...####.\n"
                                   ".##########.\n"
                                   "..###.###...\n"
                                   "..#...##....\n",
                                   NULL),
                     FW_OK);
    return sites;
}

static fw_solid *made(const fw_elastic_automaton_def *def)
{
    fw_error error = {0};
    fw_solid *solid;
    if (fw_elastic_automaton_create(&solid, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return solid;
}

/* Random displacements of .1 on top of a velocity. */
static fw_solid *stirred(fw_elastic_automaton_def def, fw_vec2 velocity)
{
    const size_t count = (size_t)def.sites->count;
    fw_vec2 *u = malloc(count * sizeof *u), *v = malloc(count * sizeof *v);
    uint64_t seed = 11;
    for (size_t p = 0; p < count; ++p) {
        u[p] = (fw_vec2){0.1 * random_number(&seed), 0.1 * random_number(&seed)};
        v[p] = velocity;
    }
    def.displacement = u;
    def.velocity = v;
    def.displaced_as_given = true;
    fw_solid *solid = made(&def);
    free(u);
    free(v);
    return solid;
}

static double energy(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

static double length(fw_vec2 v)
{
    return hypot(v.x, v.y);
}

static void free_bodies_keep_energy_and_momentum(void **state)
{
    (void)state;
    const fw_sites shapes[] = {rectangle(6, 6), rectangle(9, 14), ragged()};
    const struct {
        int shape;
        double c1, c2;
    } cases[] = {
        {0, 0.4, 0.5}, {1, 0.4, 0.5}, {1, 1.41421356237309515, 0}, {2, 1, 0.9}, {2, 0.8, 0}};
    for (int c = 0; c < 5; ++c)
        for (int rule = FW_BOUNDARY_BOND; rule <= FW_BOUNDARY_TRAPEZOID; ++rule) {
            fw_elastic_automaton_def def =
                def_of(&shapes[cases[c].shape], cases[c].c1, cases[c].c2);
            def.boundary = (fw_boundary_rule)rule;
            def.lattice.spacing = 1.5;
            fw_solid *solid = stirred(def, (fw_vec2){0.05, -0.03});
            const double e = energy(solid);
            const fw_vec2 p = fw_solid_momentum(solid);
            for (int tick = 0; tick < 20000; ++tick) advance_free(solid);
            assert_close(energy(solid) / e, 1, 1e-12);
            assert_below(length(fw_vec2_subtract(fw_solid_momentum(solid), p)) / length(p), 1e-12);
            fw_solid_destroy(solid);
        }
    for (int s = 0; s < 3; ++s) fw_sites_clear((fw_sites *)&shapes[s]);
}

static void rigid_motion_does_not_ring(void **state)
{
    (void)state;
    fw_sites sites = ragged();
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
    fw_vec2 *v = malloc((size_t)sites.count * sizeof *v);
    for (int p = 0; p < sites.count; ++p) v[p] = (fw_vec2){0.05, -0.031};
    def.velocity = v;
    def.lattice.angle = 0.4;
    fw_solid *solid = made(&def);
    const fw_vec2 last = fw_solid_position(solid, solid->count - 1);
    const fw_vec2 centre = solid->model->centre_of_mass(solid);
    for (int tick = 0; tick < 2000; ++tick) advance_free(solid);
    assert_close(solid->x[solid->count - 1] - last.x, 50, 1e-11);
    assert_close(solid->y[solid->count - 1] - last.y, -31, 1e-11);
    /* The centre of mass with the weights m is straight; white was half a step ahead. */
    const fw_vec2 end = solid->model->centre_of_mass(solid);
    assert_close(end.x - centre.x, 50, 1e-11);
    assert_close(end.y - centre.y, -31, 1e-11);
    /* P = M V, E = P^2 / 2M = all kinetic. */
    const fw_sym2 mass = solid->model->mass(solid);
    const fw_vec2 p = fw_sym2_apply(mass, v[0]);
    assert_below(length(fw_vec2_subtract(fw_solid_momentum(solid), p)), 1e-12);
    const fw_energies e = fw_solid_energies(solid);
    assert_close(e.kinetic, fw_vec2_dot(p, v[0]) / 2, 1e-12);
    assert_close(e.elastic, 0, 1e-13);
    double *vx = malloc((size_t)sites.count * sizeof *vx),
           *vy = malloc((size_t)sites.count * sizeof *vy);
    solid->model->velocities(solid, vx, vy);
    for (int n = 0; n < sites.count; ++n) assert_close(vx[n], 0.05, 1e-13);
    free(vx);
    free(vy);
    free(v);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* The paper's Fig 3: 6 x 6, spacing 1.5, black = i + j odd, site (2, 1) displaced by -.3 in x. */
static fw_solid *paper_body(double c1, double c2, fw_boundary_rule rule)
{
    fw_sites sites = rectangle(6, 6);
    fw_elastic_automaton_def def = def_of(&sites, c1, c2);
    def.boundary = rule;
    def.black_is_odd = true;
    def.lattice.spacing = 1.5;
    def.lattice.origin = (fw_vec2){6.25, 6.25};
    fw_vec2 u[36] = {{0, 0}};
    u[fw_sites_find(&sites, (fw_site){2, 1})].x = -0.3;
    def.displacement = u;
    def.displaced_as_given = true;
    fw_solid *solid = made(&def);
    fw_sites_clear(&sites);
    return solid;
}

static void one_displaced_site_makes_the_body_drift(void **state)
{
    (void)state;
    const struct {
        double c1, c2;
        fw_boundary_rule rule;
        double drift, within;
        bool couples;
    } cases[] = {{1.41421356237309515, 0, FW_BOUNDARY_BOND, 0.04, 1e-13, false},
                 {0.4, 0.5, FW_BOUNDARY_BOND, 0.04, 1e-13, true},
                 {0.4, 0.58, FW_BOUNDARY_MIRROR, 0.0494, 1e-4, true}};
    for (int c = 0; c < 3; ++c) {
        fw_solid *solid = paper_body(cases[c].c1, cases[c].c2, cases[c].rule);
        assert_close(energy(solid), 0.09, 1e-15);
        const fw_vec2 begin = solid->model->centre_of_mass(solid);
        double highest = 0;
        const int steps = 10000;
        for (int tick = 0; tick < 2 * steps; ++tick) {
            advance_free(solid);
            for (int p = 0; p < solid->count; ++p)
                highest = fmax(highest, fabs(fw_elastic_automaton_displacement(solid, p).y));
        }
        const fw_vec2 end = solid->model->centre_of_mass(solid);
        assert_close((end.x - begin.x) / steps, cases[c].drift, cases[c].within);
        /* Only the coupled matrices make y of a disturbance in x. */
        if (cases[c].couples)
            assert_true(highest > 0.1);
        else
            assert_true(highest == 0);
        fw_solid_destroy(solid);
    }
}

static void frictionless_constraint_keeps_energy_and_tangential_momentum(void **state)
{
    (void)state;
    /* A wall of any direction: particles that move towards it beyond a line stay on their
     * tangent. F = -(n.d)/(n.A n) n, as the generic contact solve finds. */
    for (int turn = 0; turn < 5; ++turn) {
        const double angle = turn * 0.37;
        const fw_vec2 n = {cos(angle), sin(angle)}, t = fw_vec2_turn(n);
        fw_sites sites = rectangle(12, 7);
        fw_elastic_automaton_def def = def_of(&sites, 0.4, 0.5);
        def.black_is_odd = turn % 2;
        fw_solid *solid = stirred(def, fw_vec2_scale(-0.05, n));
        const double e = energy(solid), tangential = fw_vec2_dot(fw_solid_momentum(solid), t);
        double line = INFINITY;
        for (int p = 0; p < solid->count; ++p)
            line = fmin(line, fw_vec2_dot(fw_solid_position(solid, p), n) - 0.3);
        int particles[84], held = 0;
        fw_prediction prediction[84];
        for (int p = 0; p < 84; ++p) particles[p] = p;
        fw_vec2 impulse = {0, 0};
        const fw_vec2 before = fw_solid_momentum(solid);
        for (int tick = 0; tick < 3000; ++tick) {
            fw_constraint constraints[84];
            int count = 0;
            fw_solid_predict(solid, particles, 84, prediction);
            for (int p = 0; p < 84; ++p) {
                const fw_vec2 d = prediction[p].displacement;
                if (fw_vec2_dot(fw_vec2_add(fw_solid_position(solid, p), d), n) >= line) continue;
                if (prediction[p].mobility.xx == 0) continue;
                const fw_sym2 a = prediction[p].mobility;
                const double force = -fw_vec2_dot(d, n) / fw_sym2_form(n, a, n);
                constraints[count++] =
                    (fw_constraint){p, fw_vec2_add(d, fw_sym2_apply(a, fw_vec2_scale(force, n))),
                                    fw_vec2_scale(force, n)};
                impulse = fw_vec2_add(impulse, fw_vec2_scale(force, n));
            }
            held += count;
            advance_held(solid, constraints, count);
        }
        assert_true(held > 10);
        assert_close(energy(solid) / e, 1, 1e-13);
        assert_close(fw_vec2_dot(fw_solid_momentum(solid), t), tangential, 1e-13);
        /* A constraint force gives exactly itself as momentum: its particle's time is one unit. */
        const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), before);
        assert_below(length(fw_vec2_subtract(gained, impulse)), 1e-12);
        fw_solid_destroy(solid);
        fw_sites_clear(&sites);
    }
}

static void held_particle_stays_where_it_is_to_the_last_bit(void **state)
{
    (void)state;
    fw_sites sites = rectangle(8, 8);
    fw_elastic_automaton_def def = def_of(&sites, 0.4, 0.5);
    def.lattice.origin = (fw_vec2){1e4 + 0.1, -0.3};
    fw_solid *solid = stirred(def, (fw_vec2){0.3, 0.01});
    const fw_constraint constraints[] = {
        {27, {0, 0}, {0, 0}}, {28, {0, 0}, {0, 0}}, {63, {0, 0}, {0, 0}}};
    const double x = solid->x[27], y = solid->y[28], corner = solid->x[63];
    for (int tick = 0; tick < 500; ++tick) advance_held(solid, constraints, 3);
    assert_true(solid->x[27] == x && solid->y[28] == y && solid->x[63] == corner);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static void ledger_of_loads_and_damping_closes(void **state)
{
    (void)state;
    fw_sites sites = ragged();
    for (int damped = 0; damped < 2; ++damped) {
        fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
        def.reflection = damped ? 0.9 : 1;
        fw_solid *solid = stirred(def, (fw_vec2){0.02, 0});
        const double e = energy(solid);
        const fw_vec2 p = fw_solid_momentum(solid);
        uint64_t seed = 5;
        solid->loaded = true;
        for (int tick = 0; tick < 2000; ++tick) {
            for (int n = 0; n < solid->count; ++n) {
                solid->external_x[n] = 0.01 * random_number(&seed);
                solid->external_y[n] = 0.01 * random_number(&seed);
            }
            advance_free(solid);
        }
        const fw_solid_ledger *ledger = &solid->ledger;
        assert_true(ledger->work > 0.1);
        assert_true(damped ? ledger->dissipated > 0.1 : ledger->dissipated == 0);
        assert_close(energy(solid) - e, ledger->work - ledger->dissipated, 1e-11);
        const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), p);
        assert_close(gained.x, ledger->impulse.x + ledger->drag.x, 1e-11);
        assert_close(gained.y, ledger->impulse.y + ledger->drag.y, 1e-11);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

static void constant_force_obeys_newton(void **state)
{
    (void)state;
    /* dP/dt is the sum of all forces, although each acts in every second tick only. */
    fw_sites sites = rectangle(7, 6);
    fw_elastic_automaton_def def = def_of(&sites, 0.4, 0.5);
    fw_solid *solid = made(&def);
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p) solid->external_x[p] = 1e-3;
    const int steps = 500;
    for (int tick = 0; tick < 2 * steps; ++tick) advance_free(solid);
    assert_close(fw_solid_momentum(solid).x, 1e-3 * solid->count * steps, 1e-11);
    assert_close(fw_solid_momentum(solid).y, 0, 1e-11);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* Cells have a quarter each, those at an edge less, and altogether the body's mass. */
static void cells_share_the_mass(void **state)
{
    (void)state;
    fw_sites sites = ragged();
    fw_elastic_automaton_def def = def_of(&sites, 1, 0.9);
    fw_solid *solid = made(&def);
    double *mass = malloc((size_t)sites.count * sizeof *mass), sum = 0;
    solid->model->masses(solid, mass);
    for (int p = 0; p < sites.count; ++p) {
        assert_true(mass[p] > 0 && mass[p] <= 0.25 + 1e-15);
        sum += mass[p];
    }
    const fw_sym2 whole = solid->model->mass(solid);
    assert_close(sum, (whole.xx + whole.yy) / 2, 1e-13);
    assert_close(mass[fw_sites_find(&sites, (fw_site){2, 5})], 0.25, 1e-15);
    free(mass);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* Pulled at its four sides, a damped body comes to rest: no cell has a velocity then, although
 * forces act on it. */
static void loaded_body_that_rests_has_no_velocities(void **state)
{
    (void)state;
    enum { COLUMNS = 6, ROWS = 5 };
    double vx[COLUMNS * ROWS], vy[COLUMNS * ROWS];
    fw_sites sites = rectangle(COLUMNS, ROWS);
    fw_elastic_automaton_def def = def_of(&sites, 0.4, 0.5);
    def.reflection = 0.6;
    fw_solid *solid = made(&def);
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p) {
        const fw_site s = sites.site[p];
        solid->external_x[p] = s.i == 0 ? -0.01 : s.i == COLUMNS - 1 ? 0.01 : 0;
        solid->external_y[p] = s.j == 0 ? -0.02 : s.j == ROWS - 1 ? 0.02 : 0;
    }
    for (int tick = 0; tick < 8000; ++tick) advance_free(solid);
    solid->model->velocities(solid, vx, vy);
    for (int p = 0; p < solid->count; ++p) {
        const fw_site s = sites.site[p];
        assert_close(vx[p], 0, 1e-13);
        assert_close(vy[p], 0, 1e-13);
        if (s.j == 0) assert_true(fw_elastic_automaton_displacement(solid, p).y < -0.001);
        if (s.j == ROWS - 1) assert_true(fw_elastic_automaton_displacement(solid, p).y > 0.001);
    }
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

static void chopards_automaton_is_the_lb_solid(void **state)
{
    (void)state;
    /* f_(i+2)(black) = w - b on black, 0 on white: the LB start with u = (b, w), V = (-2b, 2w).
     * One LB step is one half-step. The third body runs into a wall at x = 0 as well. */
    for (int c = 0; c < 3; ++c) {
        fw_sites sites = c == 0 ? rectangle(10, 10) : ragged();
        const size_t count = (size_t)sites.count;
        fw_vec2 *u = malloc(count * sizeof *u), *v = malloc(count * sizeof *v);
        uint64_t seed = 3;
        for (int p = 0; p < sites.count; ++p) {
            const bool white = (sites.site[p].i + sites.site[p].j) & 1;
            u[p] = (fw_vec2){0.1 * random_number(&seed) - 0.02 * white, 0.1 * random_number(&seed)};
            v[p] = fw_vec2_scale(white ? 2 : -2, u[p]);
        }
        const fw_lattice lattice = {.kind = FW_SQUARE, .spacing = 1, .origin = {2, 0}};
        fw_elastic_automaton_def ca_def = fw_elastic_automaton_def_default();
        ca_def.sites = &sites;
        ca_def.lattice = lattice;
        ca_def.displacement = u;
        ca_def.displaced_as_given = true;
        fw_solid *ca = made(&ca_def), *lb;
        fw_lb_solid_def lb_def = fw_lb_solid_def_default();
        lb_def.sites = &sites;
        lb_def.lattice = lattice;
        lb_def.displacement = u;
        lb_def.velocity = v;
        assert_int_equal(fw_lb_solid_create(&lb, &lb_def, NULL), FW_OK);
        fw_solid *pair[2] = {ca, lb};
        int *all = malloc(count * sizeof *all), held = 0;
        fw_prediction *prediction = malloc(count * sizeof *prediction);
        fw_constraint *constraints = malloc(count * sizeof *constraints);
        for (int p = 0; p < sites.count; ++p) all[p] = p;
        double worst = 0;
        for (int tick = 0; tick < 1000; ++tick) {
            for (int which = 0; which < 2; ++which) {
                int constraint_count = 0;
                if (c == 2) {
                    fw_solid_predict(pair[which], all, sites.count, prediction);
                    for (int p = 0; p < sites.count; ++p)
                        if (pair[which]->x[p] + prediction[p].displacement.x < 0)
                            constraints[constraint_count++] =
                                (fw_constraint){p, {0, prediction[p].displacement.y}, {0, 0}};
                }
                held += constraint_count;
                advance_held(pair[which], constraints, constraint_count);
            }
            for (int p = 0; p < sites.count; ++p)
                worst = fmax(worst, fmax(fabs(ca->x[p] - lb->x[p]), fabs(ca->y[p] - lb->y[p])));
        }
        assert_below(worst, 1e-9);
        assert_true(c < 2 || held > 20);
        free(u);
        free(v);
        free(all);
        free(prediction);
        free(constraints);
        fw_solid_destroy(ca);
        fw_solid_destroy(lb);
        fw_sites_clear(&sites);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_bodies_keep_energy_and_momentum),
        cmocka_unit_test(rigid_motion_does_not_ring),
        cmocka_unit_test(one_displaced_site_makes_the_body_drift),
        cmocka_unit_test(frictionless_constraint_keeps_energy_and_tangential_momentum),
        cmocka_unit_test(held_particle_stays_where_it_is_to_the_last_bit),
        cmocka_unit_test(ledger_of_loads_and_damping_closes),
        cmocka_unit_test(constant_force_obeys_newton),
        cmocka_unit_test(cells_share_the_mass),
        cmocka_unit_test(loaded_body_that_rests_has_no_velocities),
        cmocka_unit_test(chopards_automaton_is_the_lb_solid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
