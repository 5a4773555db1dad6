/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_surroundings.c - order, density and clusters of points where they are known. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"

#include "core/particles/surroundings.h"

enum { FOLDS = 6 };
static const int folds[FOLDS] = {2, 3, 4, 5, 6, 12};

typedef struct points {
    int count;
    double *x, *y;
} points;

static points of_crowd(fw_crowd crowd)
{
    const size_t bytes = (size_t)crowd.count * sizeof(double);
    points p = {crowd.count, malloc(bytes), malloc(bytes)};
    for (int i = 0; i < p.count; ++i) p.x[i] = crowd.at[i].x, p.y[i] = crowd.at[i].y;
    free(crowd.at);
    return p;
}

static points square(int side, double angle)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, side, side, NULL), FW_OK);
    return of_crowd(crowd_of(sites, (fw_lattice){FW_SQUARE, 1, angle, {2, -7}}, 0, 1));
}

static void release(points p)
{
    free(p.x);
    free(p.y);
}

static int nearest(points p, double x, double y)
{
    int best = 0;
    for (int i = 0; i < p.count; ++i)
        if (hypot(p.x[i] - x, p.y[i] - y) < hypot(p.x[best] - x, p.y[best] - y)) best = i;
    return best;
}

/* Inside a square crystal psi_n is 1 where 4 divides n, and 0 otherwise; inside a hexagonal one
 * where 6 does; however they are turned. */
static void crystals_have_the_order_of_their_axes(void **state)
{
    (void)state;
    for (int turned = 0; turned < 2; ++turned) {
        const points both[] = {square(9, .3 * turned),
                               of_crowd(crowd_disc(5, (fw_vec2){3, 1}, .7 * turned, 0, 1))};
        for (int kind = 0; kind < 2; ++kind) {
            const points p = both[kind];
            double *values = malloc(FOLDS * (size_t)p.count * sizeof *values);
            assert_int_equal(
                fw_surroundings_order(p.x, p.y, p.count, 1.25, folds, FOLDS, values, NULL), FW_OK);
            const int middle = kind == 0 ? 40 : nearest(p, 3, 1);
            for (int f = 0; f < FOLDS; ++f)
                assert_close(values[f * p.count + middle], folds[f] % (kind == 0 ? 4 : 6) == 0,
                             1e-13);
            free(values);
            release(p);
        }
    }
}

/* Two bonds at an angle a: |1 + e^{i n a}|/2 = |cos(n a/2)|; one bond: 1; none: NaN. */
static void a_few_bonds_have_their_closed_form(void **state)
{
    (void)state;
    const double a = 1.1;
    const double x[] = {0, 1, cos(a), 9}, y[] = {0, 0, sin(a), 9};
    double values[FOLDS * 4];
    assert_int_equal(fw_surroundings_order(x, y, 4, 1.04, folds, FOLDS, values, NULL), FW_OK);
    for (int f = 0; f < FOLDS; ++f) {
        assert_close(values[4 * f], fabs(cos(folds[f] * a / 2)), 1e-14);
        assert_close(values[4 * f + 1], 1, 1e-14);
        assert_true(isnan(values[4 * f + 3]));
    }
}

/* pi lambda/a with the ripple's first term, whose reciprocal vectors are G: on the particles
 * 1 + m e^{-lambda G^2/4} of it, m = 6, G^2 = 16 pi^2/3 and m = 4, G^2 = 4 pi^2. */
static void density_of_crystals_is_that_of_their_cells(void **state)
{
    (void)state;
    const points hexagonal = of_crowd(crowd_disc(9, (fw_vec2){3, 1}, .2, 0, 1)),
                 four = square(17, 1);
    const double pi = acos(-1);
    for (int kind = 0; kind < 2; ++kind) {
        const points p = kind ? four : hexagonal;
        const int middle = kind ? 8 * 17 + 8 : nearest(p, 3, 1);
        for (double lambda = .5; lambda < 1.1; lambda += .25) {
            double *values = malloc((size_t)p.count * sizeof *values);
            assert_int_equal(fw_surroundings_density(p.x, p.y, p.count, lambda, values, NULL),
                             FW_OK);
            const double flat = pi * lambda / (kind ? 1 : sqrt(3) / 2);
            const double ripple =
                kind ? 4 * exp(-pi * pi * lambda) : 6 * exp(-4 * pi * pi * lambda / 3);
            const double second =
                kind ? 4 * exp(-2 * pi * pi * lambda) : 6 * exp(-4 * pi * pi * lambda);
            assert_close(values[middle], flat * (1 + ripple + second), 1e-6);
            free(values);
        }
    }
    release(hexagonal);
    release(four);
}

static void density_of_two_points_is_their_gauss(void **state)
{
    (void)state;
    const double x[] = {0, .6, 40}, y[] = {0, .8, 0};
    double values[3];
    assert_int_equal(fw_surroundings_density(x, y, 3, 2, values, NULL), FW_OK);
    assert_close(values[0], 1 + exp(-.5), 1e-15);
    assert_close(values[1], 1 + exp(-.5), 1e-15);
    assert_close(values[2], 1, 0);
}

static void the_largest_cluster_is_linked_through_others(void **state)
{
    (void)state;
    const double x[] = {0, 1, 5, 6, 7, 8.8}, y[6] = {0};
    uint8_t members[6];
    int found;
    const struct {
        double link;
        int found, first;
    } cases[] = {{.9, 1, 0}, {1.1, 3, 2}, {1.9, 4, 2}, {4.1, 6, 0}};
    for (int n = 0; n < 4; ++n) {
        assert_int_equal(fw_surroundings_cluster(x, y, 6, cases[n].link, members, &found, NULL),
                         FW_OK);
        assert_int_equal(found, cases[n].found);
        for (int i = 0; i < 6; ++i)
            assert_int_equal(members[i],
                             i >= cases[n].first && i < cases[n].first + cases[n].found);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crystals_have_the_order_of_their_axes),
        cmocka_unit_test(a_few_bonds_have_their_closed_form),
        cmocka_unit_test(density_of_crystals_is_that_of_their_cells),
        cmocka_unit_test(density_of_two_points_is_their_gauss),
        cmocka_unit_test(the_largest_cluster_is_linked_through_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
