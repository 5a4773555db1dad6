/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_order.c - order, neighbours and peaks of two shaken crystals of different symmetry
 * that overlap, counted again pair by pair and wave by wave. */
#include "tests/support/laws.h"

#include "core/particles/particles.h"
#include "experiments/measures/measurement.h"
#include "tests/support/scratch.h"

static fw_scenario *scenario;
static fw_observer *observer;
static const fw_solid *solid;

/* The first body is hexagonal, its axes 17 degrees from x; the second one is square, 30 degrees. */
static const char crystals[] =
    "title: two crystals\n"
    "materials:\n"
    "  six: {movable-particles: {strength: 0, mass: 2,\n"
    "    return-force: {symmetry: 6, amplitude: 1, axes: lab, angle: 17}}}\n"
    "  four: {movable-particles: {strength: 0, mass: 3,\n"
    "    return-force: {symmetry: 4, amplitude: 1, axes: lab}}}\n"
    "bodies:\n"
    "  a: {material: six, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [.1, .3],\n"
    "    angle: 20, displacement: [{random: .09}]}\n"
    "  b: {material: four, lattice: square, shape: {rectangle: [6, 3]}, origin: [3.9, 1.2],\n"
    "    angle: 30, displacement: [{random: .16}]}\n"
    "dynamics: {strength-across: 0}\n"
    "run: {steps: 1, seed: 11}\n";
static const int first_of[] = {0, 12, 30};

static int set_up(void **state)
{
    (void)state;
    assert_fine(fw_scenario_read(&scenario, "o.yaml", crystals, strlen(crystals), NULL, 0, &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
    solid = fw_experiment_particles(observer->experiment);
    assert_int_equal(solid->count, first_of[2]);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
    return 0;
}

static double number(const char *name)
{
    double out[FW_COMPONENTS_MAX];
    int count;
    assert_fine(fw_measurement_look(observer, name, out, &count, &error));
    assert_int_equal(count, 1);
    return out[0];
}

/* --- pair by pair --- */

/* Sums over the bonds of a particle: all that are shorter than 1.25, to whatever body. */
typedef struct bonds {
    int count, across;
    double cosine, sine; /* of n (phi - axes) */
} bonds;

static bonds bonds_of(int i, int fold, double axes)
{
    bonds b = {0};
    for (int j = 0; j < solid->count; ++j) {
        const double dx = solid->x[j] - solid->x[i], dy = solid->y[j] - solid->y[i];
        if (j == i || hypot(dx, dy) >= 1.25) continue;
        b.count += 1;
        b.across += (i < first_of[1]) != (j < first_of[1]);
        b.cosine += cos(fold * (atan2(dy, dx) - axes));
        b.sine += sin(fold * (atan2(dy, dx) - axes));
    }
    return b;
}

static int fold_of(int i)
{
    return i < first_of[1] ? 6 : 4;
}

static double axes_of(int i)
{
    return (i < first_of[1] ? 17 : 30) * FW_PI / 180;
}

static double size_of(bonds b)
{
    return b.count > 0 ? hypot(b.cosine, b.sine) / b.count : 0;
}

static void expect_field(const char *name, double (*expected)(int particle))
{
    double values[64], low = INFINITY, high = -INFINITY;
    const fw_field *field = fw_solid_find_field(solid, name);
    assert_non_null(field);
    field->fill(solid, values);
    for (int i = 0; i < solid->count; ++i) {
        const double wanted = expected(i);
        if (!(fabs(values[i] - wanted) < 1e-12))
            fail_msg("%s of %d is %.17g, expected %.17g", name, i, values[i], wanted);
        low = fmin(low, wanted), high = fmax(high, wanted);
    }
    assert_true(high > low + .2);
}

static double order_of_four(int i)
{
    return size_of(bonds_of(i, 4, 0));
}

static double order_of_six(int i)
{
    return size_of(bonds_of(i, 6, 0));
}

static double own_order(int i)
{
    return size_of(bonds_of(i, fold_of(i), 0));
}

static double order_about_axes(int i)
{
    const bonds b = bonds_of(i, fold_of(i), axes_of(i));
    return b.count > 0 ? b.cosine / b.count : 0;
}

static double bond_count(int i)
{
    return bonds_of(i, 1, 0).count;
}

static double density_about(int i)
{
    double sum = 0;
    for (int j = 0; j < solid->count; ++j)
        sum += exp(-pow(solid->x[j] - solid->x[i], 2) - pow(solid->y[j] - solid->y[i], 2));
    return sum;
}

static double body_of(int i)
{
    return i >= first_of[1];
}

static void fields_show_each_particles_own_surroundings(void **state)
{
    (void)state;
    int across = 0;
    for (int i = 0; i < solid->count; ++i) across += bonds_of(i, 1, 0).across;
    assert_true(across > 4);
    expect_field("order-4", order_of_four);
    expect_field("order-6", order_of_six);
    expect_field("local-order", own_order);
    expect_field("lab-order", order_about_axes);
    expect_field("coordination", bond_count);
    expect_field("gaussian-density", density_about);
    expect_field("group", body_of);
}

/* lab-order is a mean over bonds, local-order one over particles that have any, coordination one
 * over all of them. */
static void order_is_that_of_one_body_or_of_all(void **state)
{
    (void)state;
    static const struct {
        const char *lab, *local, *coordination;
        int first, end;
    } rows[] = {{"lab-order.a", "local-order.a", "coordination.a", 0, 12},
                {"lab-order.b", "local-order.b", "coordination.b", 12, 30},
                {"lab-order", "local-order", "coordination", 0, 30}};
    double seen[3];
    for (int n = 0; n < 3; ++n) {
        double lab = 0, local = 0;
        int count = 0, bonded = 0;
        for (int i = rows[n].first; i < rows[n].end; ++i) {
            const bonds b = bonds_of(i, fold_of(i), axes_of(i));
            lab += b.cosine;
            local += size_of(b);
            count += b.count;
            bonded += b.count > 0;
        }
        assert_close(number(rows[n].lab), lab / count, 1e-12);
        assert_close(number(rows[n].local), local / bonded, 1e-12);
        assert_close(number(rows[n].coordination), count / (double)(rows[n].end - rows[n].first),
                     1e-12);
        seen[n] = lab / count;
    }
    assert_true(fabs(seen[0] - seen[1]) > .1 && fabs(seen[0] - seen[2]) > .05);
}

/* --- wave by wave --- */

static double peak_at(int first, int end, double qx, double qy)
{
    double cosine = 0, sine = 0;
    for (int i = first; i < end; ++i) {
        cosine += cos(qx * solid->x[i] + qy * solid->y[i]);
        sine += sin(qx * solid->x[i] + qy * solid->y[i]);
    }
    return (cosine * cosine + sine * sine) / ((end - first) * (end - first));
}

/* The highest in a square of a tenth of the wave number to all sides, turned with the wave. */
static double highest_about(int first, int end, double length, double angle)
{
    enum { REACH = 60 };
    double highest = 0;
    for (int a = -REACH; a <= REACH; ++a)
        for (int b = -REACH; b <= REACH; ++b) {
            const double along = length * (1 + .1 * a / REACH), across = length * .1 * b / REACH;
            highest = fmax(highest, peak_at(first, end, along * cos(angle) - across * sin(angle),
                                            along * sin(angle) + across * cos(angle)));
        }
    return highest;
}

/* Shortest reciprocal vectors: of the hexagonal lattice 4 pi/3^(1/2), upright on the axes that its
 * material has, three of them; of the square one 2 pi, two. Each is found better than a grid does
 * of steps of .01 or .012. */
static void peaks_are_the_highest_about_the_axes_of_the_body(void **state)
{
    (void)state;
    double six = 0, four = 0;
    for (int d = 0; d < 3; ++d)
        six += highest_about(0, 12, 4 * FW_PI / sqrt(3), (17 + 90 + 60 * d) * FW_PI / 180) / 3;
    for (int d = 0; d < 2; ++d)
        four += highest_about(12, 30, 2 * FW_PI, (30 + 90 * d) * FW_PI / 180) / 2;
    assert_true(six < .95 && four < .95 && fabs(six - four) > .01);
    const double first = number("bragg-peak.a"), second = number("bragg-peak.b");
    assert_true(first >= six - 1e-12 && first < six + 5e-4);
    assert_true(second >= four - 1e-12 && second < four + 5e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields_show_each_particles_own_surroundings),
        cmocka_unit_test(order_is_that_of_one_body_or_of_all),
        cmocka_unit_test(peaks_are_the_highest_about_the_axes_of_the_body),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
