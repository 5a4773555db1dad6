/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_automaton.c - what is asked of elastic automata and of their analyses by name: from
 * closed forms, from cells one by one, and from a second iteration of a body's own update. */
#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"
#include "tests/experiments/measures/asked.h"

#include <complex.h>

static fw_solid *second_body(void)
{
    return fw_scene_body(observer->experiment->scene, observer->experiment->bodies[1].solid);
}

/* --- cells --- */

#define PAIR(material, start)                                                                      \
    "title: two bodies\n"                                                                          \
    "materials: {m: {elastic-automaton: {" material "}}}\n"                                        \
    "bodies:\n"                                                                                    \
    "  a: {material: m, shape: {rectangle: [4, 2]}, origin: [30, 7], velocity: [.2, .3]}\n"        \
    "  b: {material: m, shape: {rectangle: [5, 3]}, origin: [3, 9], " start "}\n"                  \
    "run: {steps: 9}\n"

/* Displaced as given by two waves, one along x and one along y. */
static void the_largest_displacement_is_that_of_any_cell(void **state)
{
    (void)state;
    observe(PAIR("c1: .4, c2: .2", "displaced-as-given: true, displacement:\n"
                                   "  [{wave: {amplitude: [-.1, 0], wave-vector: [.5, .2]}},\n"
                                   "   {wave: {amplitude: [0, .03], wave-vector: [-.4, .9]}}]"));
    double x = 0, y = 0, of_signs = 0;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 3; ++j) {
            x = fmax(x, fabs(.1 * cos(.5 * i + .2 * j)));
            y = fmax(y, fabs(.03 * cos(-.4 * i + .9 * j)));
            of_signs = fmax(of_signs, -.1 * cos(.5 * i + .2 * j));
        }
    assert_true(x > of_signs + .01);
    assert_close(number("largest-displacement.b.x"), x, 1e-15);
    assert_close(number("largest-displacement.b.y"), y, 1e-15);
    end();
}

/* After n steps black has gone n V, and white, half a step ahead, n + 1/2. */
static void a_moving_body_is_displaced_by_its_way(void **state)
{
    (void)state;
    observe(PAIR("c1: .4, c2: .2", "velocity: [-.03, .02]"));
    for (int step = 0; step <= 3; ++step) {
        if (step > 0) assert_fine(fw_observer_advance(observer, 1, &error));
        assert_close(number("largest-displacement.b.x"), .03 * (step + .5), 1e-15);
        assert_close(number("largest-displacement.b.y"), .02 * (step + .5), 1e-15);
        assert_close(number("largest-displacement.a.x"), .2 * (step + .5), 1e-14);
    }
    end();
}

/* A corner has two bonds, a cell at an edge three, one inside four: the last of those is the last
 * one of its neighbour, too. */
static void a_cell_freezes_with_its_last_bond(void **state)
{
    (void)state;
    static const struct {
        int particle, bonds, before, after; /* frozen cells, before the last bond and after it */
    } cells[] = {{0, 2, 0, 1}, {2, 3, 1, 2}, {14, 2, 2, 3}, {6, 4, 3, 5}};
    observe(PAIR("c1: 1, c2: .2, break-at: .5", "velocity: [0, 0]"));
    int broken = 0;
    for (size_t n = 0; n < sizeof cells / sizeof *cells; ++n) {
        int left = cells[n].bonds;
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            if (!fw_elastic_automaton_break(second_body(), cells[n].particle, d)) continue;
            left -= 1;
            broken += 1;
            assert_close(number("broken-bonds.b"), broken, 0);
            assert_close(number("frozen-cells.b"), left > 0 ? cells[n].before : cells[n].after, 0);
        }
        assert_int_equal(left, 0);
    }
    assert_close(number("frozen-cells.a"), 0, 0);
    assert_close(number("broken-bonds.a"), 0, 0);
    end();
}

/* --- analyses --- */

#define FOAM                                                                                       \
    "title: waves\n"                                                                               \
    "materials:\n"                                                                                 \
    "  stiff: {elastic-automaton: {c1: .5, c2: 1, boundary: periodic}}\n"                          \
    "  foam: {elastic-automaton: {c1: .4, c2: .58, boundary: periodic}}\n"                         \
    "  chopard: {elastic-automaton: {chopard: true}}\n"                                            \
    "bodies:\n"                                                                                    \
    "  a: {material: stiff, shape: {rectangle: [2, 2]}}\n"                                         \
    "  b: {material: chopard, shape: {rectangle: [3, 2]}, origin: [20, 3]}\n"                      \
    "run: {steps: 1}\nanalysis:\n"

/* 4 sin^2(omega/2) of both modes, Eq 33 with its signs corrected, for complex roots too:
 * slow first. */
static void squares(double c1, double c2, double kx, double ky, double complex out[2])
{
    const double shear = c1 * c1, coupling = c2 * c2, m = shear + coupling / 2;
    const double complex p0 = csqrt(1 - shear / 2), p1 = csqrt(1 - shear / 2 - coupling / 2);
    const double x = sin(kx), y = sin(ky), v = cos(kx) - cos(ky), s = x * x + y * y;
    const double complex w = v * (p1 * x - p0 * y), split = coupling / 2 * csqrt(s * s + w * w);
    const double mean = m * (s + (4 - m) * v * v / 4);
    out[0] = mean - split;
    out[1] = mean + split;
}

/* The larger |lambda| of lambda + 1/lambda = 2 - square. */
static double growth_of(double complex square)
{
    const double complex half = 1 - square / 2, root = csqrt(half * half - 1);
    return fmax(cabs(half + root), cabs(half - root));
}

static double growth_on_grid(double c1, double c2, int waves)
{
    double most = 1;
    for (int n = 0; n < waves * waves; ++n) {
        double complex both[2];
        squares(c1, c2, FW_TWO_PI * (n % waves) / waves, FW_TWO_PI * (n / waves) / waves, both);
        most = fmax(most, fmax(growth_of(both[0]), growth_of(both[1])));
    }
    return most;
}

/* Of six pairs three lie outside the disc, with c1^2 + c2^2 = 2.25, 2.5 and 3.69. Four times as
 * many waves have the worst one, (pi/2, pi/2), ten in a circle do not. */
static void a_map_tells_how_waves_grow_within_and_outside_the_disc(void **state)
{
    (void)state;
    static const double c1[] = {.5, 1.2}, c2[] = {.3, .9, 1.5};
    observe(FOAM
            "  first: {stability-map: {c1: [.1, .2], c2: [0, .3], points: [2, 2], waves: 4}}\n"
            "  coarse: {stability-map: {c1: [.5, 1.2], c2: [.3, 1.5], points: [2, 3], waves: 10}}\n"
            "  map: {stability-map: {c1: [.5, 1.2], c2: [.3, 1.5], points: [2, 3], waves: 8}}\n");
    double least = INFINITY, greatest = 0, error_of_coarse = 0, coarse_least = INFINITY,
           coarse_greatest = 0;
    int outside = 0;
    for (int n = 0; n < 6; ++n) {
        const double sum = c1[n % 2] * c1[n % 2] + c2[n / 2] * c2[n / 2];
        if (sum <= 2) continue;
        const double h = sqrt(2 * sum), growth = pow((h + sqrt(h * h - 4)) / 2, 2);
        const double coarse = growth_on_grid(c1[n % 2], c2[n / 2], 10);
        outside += 1;
        least = fmin(least, growth);
        greatest = fmax(greatest, growth);
        coarse_least = fmin(coarse_least, coarse);
        coarse_greatest = fmax(coarse_greatest, coarse);
        error_of_coarse = fmax(error_of_coarse, fabs(coarse - growth));
    }
    assert_int_equal(outside, 3);
    assert_close(number("growth-inside.map"), 0, 1e-12);
    assert_close(number("growth-outside.map"), least, 1e-9);
    assert_close(number("largest-growth.map"), greatest, 1e-9);
    assert_close(number("growth-error.map"), 0, 1e-9);
    assert_true(error_of_coarse > .01 && coarse_greatest > coarse_least + .1);
    assert_close(number("growth-inside.coarse"), 0, 1e-12);
    assert_close(number("growth-outside.coarse"), coarse_least, 1e-9);
    assert_close(number("largest-growth.coarse"), coarse_greatest, 1e-9);
    assert_close(number("growth-error.coarse"), error_of_coarse, 1e-9);
    assert_close(number("largest-growth.first"), 1, 0);
    end();
}

/* White cells move on ellipses whose long axis lies along (sin kx, sin ky) in the fast mode, and
 * across it in the slow one; its x is positive. */
static void a_plane_mode_has_both_speeds_and_directions(void **state)
{
    (void)state;
    observe(FOAM "  one: {plane-mode: {material: stiff, wave-vector: [.3, .1]}}\n"
                 "  two: {plane-mode: {material: foam, wave-vector: [1.2, -.5]}}\n");
    double complex both[2];
    squares(.4, .58, 1.2, -.5, both);
    const double length = hypot(1.2, .5), sine = hypot(sin(1.2), sin(.5));
    assert_close(number("phase-speed.two.slow"), 2 * asin(sqrt(creal(both[0])) / 2) / length,
                 1e-12);
    assert_close(number("phase-speed.two.fast"), 2 * asin(sqrt(creal(both[1])) / 2) / length,
                 1e-12);
    assert_close(number("fast-polarisation.two.x"), sin(1.2) / sine, 1e-12);
    assert_close(number("fast-polarisation.two.y"), -sin(.5) / sine, 1e-12);
    assert_close(number("slow-polarisation.two.x"), sin(.5) / sine, 1e-12);
    assert_close(number("slow-polarisation.two.y"), sin(1.2) / sine, 1e-12);
    end();
}

/* From Gamma over X and M back, in units of 2 pi/6: each point's frequencies, twice; what they are
 * apart is rounding, and the largest of it is told. */
static void a_dispersion_tells_how_far_simulated_waves_are_off(void **state)
{
    (void)state;
    static const int way[][2] = {{1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 2}, {1, 1}};
    static const char *const names[] = {"closed-slow", "closed-fast", "simulated-slow",
                                        "simulated-fast"};
    observe(FOAM "  first: {dispersion: {material: stiff, size: 4, steps: 3}}\n"
                 "  bands: {dispersion: {material: foam, size: 6, steps: 5}}\n");
    const fw_analysis *bands = observer->analyses[1];
    double most = 0, length = 0;
    for (int n = 0; n < 8; ++n) {
        double complex both[2];
        const int *before = n > 0 ? way[n - 1] : (const int[]){0, 0};
        squares(.4, .58, FW_TWO_PI / 6 * way[n][0], FW_TWO_PI / 6 * way[n][1], both);
        length += FW_TWO_PI / 6 * hypot(way[n][0] - before[0], way[n][1] - before[1]);
        assert_close(fw_analysis_find(bands, "way")->values[n], length, 1e-12);
        double value[4];
        for (int c = 0; c < 4; ++c) value[c] = fw_analysis_find(bands, names[c])->values[n];
        for (int c = 0; c < 4; ++c)
            assert_close(value[c], 2 * asin(sqrt(fmax(0, creal(both[c % 2]))) / 2), 1e-7);
        for (int m = 0; m < 2; ++m) most = fmax(most, fabs(value[2 + m] - value[m]));
    }
    assert_close(number("frequency-error.bands"), most, 0);
    assert_true(most > 0 && most < 1e-11);
    end();
}

/* --- a body's own update, once more --- */

enum { COLUMNS = 7, ROWS = 4 };

typedef struct update {
    fw_sym2 bond[FW_DIRECTIONS]; /* of black cells */
    bool half_edges;
} update;

/* Bond from (i, j) in direction d, 0 where there is none; along an edge it may count half. */
static double weight_of(const update *u, int i, int j, int d)
{
    const int to_i = i + (d == FW_EAST) - (d == FW_WEST);
    const int to_j = j + (d == FW_NORTH) - (d == FW_SOUTH);
    if (to_i < 0 || to_i >= COLUMNS || to_j < 0 || to_j >= ROWS) return 0;
    const bool along_edge = d % 2 == 0 ? j == 0 || j == ROWS - 1 : i == 0 || i == COLUMNS - 1;
    return u->half_edges && along_edge ? .5 : 1;
}

/* Places that the cells of a colour are reflected about: the mean of their neighbours, weighted. */
static void average(const update *u, int colour, fw_vec2 cells[COLUMNS][ROWS])
{
    for (int i = 0; i < COLUMNS; ++i)
        for (int j = 0; j < ROWS; ++j) {
            fw_sym2 mass = {0, 0, 0};
            fw_vec2 sum = {0, 0};
            if ((i + j) % 2 != colour) continue;
            for (int d = 0; d < FW_DIRECTIONS; ++d) {
                const double weight = weight_of(u, i, j, d);
                if (weight == 0) continue;
                const fw_sym2 b =
                    fw_sym2_scale(weight, u->bond[colour == 0 ? d : (d + 2) % FW_DIRECTIONS]);
                const fw_vec2 there = cells[i + (d == FW_EAST) - (d == FW_WEST)]
                                           [j + (d == FW_NORTH) - (d == FW_SOUTH)];
                mass = fw_sym2_add(mass, b);
                sum = fw_vec2_add(sum, fw_sym2_apply(b, there));
            }
            cells[i][j] = fw_sym2_apply(fw_sym2_invert(mass), sum);
        }
}

static double size_of(fw_vec2 cells[COLUMNS][ROWS])
{
    double sum = 0;
    for (int n = 0; n < COLUMNS * ROWS; ++n)
        if ((n / ROWS + n % ROWS) % 2 == 1)
            sum += fw_vec2_dot(cells[n / ROWS][n % ROWS], cells[n / ROWS][n % ROWS]);
    return sqrt(sum);
}

/* A step with both reflections has (lambda + 1)^2 = 4 z lambda, z the largest factor by which both
 * averages can stretch the white cells: by iteration. */
static double radius_of(double c1, double c2, bool half_edges)
{
    fw_automaton_matrices matrices;
    fw_vec2 cells[COLUMNS][ROWS];
    update u = {.half_edges = half_edges};
    assert_fine(fw_automaton_matrices_make(&matrices, (fw_automaton_speeds){c1, c2}, 0, &error));
    memcpy(u.bond, matrices.bond, sizeof u.bond);
    for (int n = 0; n < COLUMNS * ROWS; ++n)
        cells[n / ROWS][n % ROWS] = (fw_vec2){sin(3 * n + 1), cos(n * n)};
    double z = 0;
    for (int step = 0; step < 4000; ++step) {
        const double before = size_of(cells);
        average(&u, 0, cells);
        average(&u, 1, cells);
        z = size_of(cells) / before;
        for (int n = 0; n < COLUMNS * ROWS; ++n)
            cells[n / ROWS][n % ROWS] = fw_vec2_scale(1 / z / before, cells[n / ROWS][n % ROWS]);
    }
    return growth_of(4 - 4 * z);
}

static void a_body_grows_by_its_own_update(void **state)
{
    (void)state;
    observe(FOAM
            "  calm: {body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [4, 3]}}\n"
            "  bond: {body-stability: {c1: .6, c2: .9, boundary: bond, rectangle: [7, 4]}}\n"
            "  half: {body-stability: {c1: .6, c2: .9, boundary: trapezoid, rectangle: [7, 4]}}\n"
            "  mirror: {body-stability: {c1: .4, c2: .58, boundary: mirror, rectangle: [6, 6]}}\n");
    const double bond = radius_of(.6, .9, false), half = radius_of(.6, .9, true);
    assert_true(bond > 1.01 && half > 1.01 && fabs(bond - half) > .01);
    assert_close(number("spectral-radius.bond"), bond, 1e-6);
    assert_close(number("spectral-radius.half"), half, 1e-6);
    assert_close(number("spectral-radius.calm"), 1, 1e-6);
    assert_close(number("spectral-radius.mirror"), 1, 1e-5);
    end();
}

/* Chopard's automaton is its reference, to rounding, and what is told is the worst of it: of bodies
 * that move along x or along y alone, and are damped. */
static void a_reference_is_as_far_away_as_its_worst_step(void **state)
{
    (void)state;
    static const char *const starts[] = {
        "displacement: [{by: [.1, 0], sites: [[1, 1]]}], velocity: [.03, 0]",
        "displacement: [{by: [0, .1], sites: [[1, 1]]}], velocity: [0, .03]"};
    for (int axis = 0; axis < 2; ++axis) {
        char text[1024];
        snprintf(text, sizeof text,
                 "title: twins\nmaterials:\n"
                 "  m: {elastic-automaton: {chopard: true, damping: .07}}\n"
                 "bodies:\n"
                 "  a: {material: m, shape: {rectangle: [2, 2]}}\n"
                 "  b: {material: m, shape: {rectangle: [3, 2]}, origin: [20, 3], %s}\n"
                 "run: {steps: 1}\n"
                 "analysis: {still: {boltzmann-reference: {body: a, half-steps: 6}},\n"
                 "  twin: {boltzmann-reference: {body: b, half-steps: 40}}}\n",
                 starts[axis]);
        observe(text);
        const fw_table *apart = fw_analysis_find(observer->analyses[1], "difference");
        const fw_table *when = fw_analysis_find(observer->analyses[1], "half-step");
        double most = 0;
        assert_int_equal(apart->extent[0], 20);
        for (int n = 0; n < 20; ++n) {
            most = fmax(most, apart->values[n]);
            assert_close(when->values[n], 2 * (n + 1), 0);
        }
        assert_close(number("reference-error.twin"), most, 0);
        assert_true(most > 0 && most < 1e-13);
        assert_close(number("reference-error.still"), 0, 0);
        end();
    }
}

/* --- names --- */

/* Numbers that are written by hand, all different, of the second analysis. */
static void each_number_of_an_analysis_has_its_own_name(void **state)
{
    (void)state;
    static const struct {
        const char *kind, *name;
        double value;
    } rows[] = {
        {"stability-map: {c1: [1, 1], c2: [1, 1], points: [1, 1], waves: 4}", "growth-inside.b", 1},
        {"stability-map: {c1: [1, 1], c2: [1, 1], points: [1, 1], waves: 4}", "growth-outside.b",
         2},
        {"stability-map: {c1: [1, 1], c2: [1, 1], points: [1, 1], waves: 4}", "largest-growth.b",
         3},
        {"stability-map: {c1: [1, 1], c2: [1, 1], points: [1, 1], waves: 4}", "growth-error.b", 4},
        {"dispersion: {material: foam, size: 4, steps: 1}", "frequency-error.b", 5},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "phase-speed.b.slow", 6},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "phase-speed.b.fast", 7},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "slow-polarisation.b.x", 8},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "slow-polarisation.b.y", 9},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "fast-polarisation.b.x", 10},
        {"plane-mode: {material: foam, wave-vector: [1, 2]}", "fast-polarisation.b.y", 11},
        {"body-stability: {c1: 1, c2: 0, boundary: bond, rectangle: [2, 2]}", "spectral-radius.b",
         12},
        {"boltzmann-reference: {body: b, half-steps: 2}", "reference-error.b", 13},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char text[2048];
        snprintf(text, sizeof text, FOAM "  a: {%s}\n  b: {%s}\n", rows[n].kind, rows[n].kind);
        observe(text);
        fw_analysis *b = observer->analyses[1];
        b->map.excess = 1, b->map.least = 2, b->map.greatest = 3, b->map.error = 4;
        b->frequency_error = 5;
        b->mode.speed[0] = 6, b->mode.speed[1] = 7;
        b->mode.polarisation[0] = (fw_vec2){8, 9}, b->mode.polarisation[1] = (fw_vec2){10, 11};
        b->spectral_radius = 12, b->reference_error = 13;
        assert_close(number(rows[n].name), rows[n].value, 0);
        end();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_largest_displacement_is_that_of_any_cell),
        cmocka_unit_test(a_moving_body_is_displaced_by_its_way),
        cmocka_unit_test(a_cell_freezes_with_its_last_bond),
        cmocka_unit_test(a_map_tells_how_waves_grow_within_and_outside_the_disc),
        cmocka_unit_test(a_plane_mode_has_both_speeds_and_directions),
        cmocka_unit_test(a_dispersion_tells_how_far_simulated_waves_are_off),
        cmocka_unit_test(a_body_grows_by_its_own_update),
        cmocka_unit_test(a_reference_is_as_far_away_as_its_worst_step),
        cmocka_unit_test(each_number_of_an_analysis_has_its_own_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
