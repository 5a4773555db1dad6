/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_layer.c - the numbers of a layer, each asked by its name: from sums that are
 * written by hand, all different, and from particles that are led along known ways. */
#include "tests/support/laws.h"

#include "core/particles/langevin.h"
#include "experiments/measures/layer.h"
#include "experiments/measures/profile_parts.h"
#include "tests/support/scratch.h"

static fw_scenario *scenario;
static fw_observer *observer;
static fw_measurement *measurement;
static double layer[FW_LAYER_MEASURES];

static void begin(const char *text)
{
    assert_fine(fw_scenario_read(&scenario, "l.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
    assert_fine(fw_measurement_create(&measurement, observer, &error));
}

static void end(void)
{
    fw_measurement_destroy(measurement);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

static void look(void)
{
    assert_fine(fw_layer_of(layer, observer, measurement, &error));
}

static double *number_in(double values[FW_LAYER_MEASURES], const char *name)
{
    for (int n = 0; n < FW_LAYER_MEASURES; ++n)
        if (strcmp(fw_layer_quantities[n].name, name) == 0) return &values[n];
    fail_msg("nothing is called %s", name);
    return NULL;
}

static void told(const char *name, double expected)
{
    const double value = *number_in(layer, name);
    if (!(fabs(value - expected) <= 1e-12 * fabs(expected)))
        fail_msg("%s is %.17g, expected %.17g", name, value, expected);
}

static void not_told(const char *name)
{
    if (!isnan(*number_in(layer, name))) fail_msg("%s is a number", name);
}

/* --- from sums by hand --- */

/* Bins of 1 about 2: eleven, from -5 to 5 beside the middle; 3 to 7 lie nearer than far. A unit of
 * time, sqrt 2, is 71 steps of .02, looked at every 3. Samples take 300 steps. */
#define BAR_DRIVEN(drive)                                                                          \
    "title: a bar\n"                                                                               \
    "materials: {m: {movable-particles: {mass: 2}}}\n"                                             \
    "bodies: {bar: {material: m, lattice: square, shape: {rectangle: [11, 3]}, origin: [-3, "      \
    "4]}}\n"                                                                                       \
    "dynamics: {time-step: 0.02}\ngrips:\n"                                                        \
    "  west: {body: bar, side: left, layer: 0.5, amplitude: [0, 1], period: 1.6}\n"                \
    "  east: {body: bar, side: right, layer: 0.5}\n"                                               \
    "phases:\n"                                                                                    \
    "  settle: {until: 500}\n"                                                                     \
    "  sample: {until: 800, grips: {west: {" drive "}}}\n"                                         \
    "run: {steps: 800, measure-every: 25}\n"                                                       \
    "measure: [energy, contact-return-force]\n"                                                    \
    "profile: {axis: x, phase: sample, every: 100, window: [3, 7], bin: 1, middle: 2,\n"           \
    "  contact: 1.3, far: [2.6, 4.7]}\n"
#define BAR   BAR_DRIVEN("amplitude: [0, 1], period: 2.5")
#define BINS  11
#define LAG   (71 * .02)
#define LOOK  (3 * .02)
#define WIDTH 4. /* of the window */

static double *sums_of(int bin)
{
    fw_profile *p = observer->profile;
    assert_int_equal(fw_profile_bin_count(p), BINS);
    return p->sums[bin == FW_PROFILE_CONTACT ? BINS : bin == FW_PROFILE_FAR ? BINS + 1 : bin];
}

static const double forces[BINS] = {3, 1.9, 1.7, .3, .45, 1.1, .8, .4, .2, 2, 4};
static const double orders[BINS] = {.1, .2, .95, .93, .85, .5, .6, .8, .98, .3, .4};
static const double drifts[BINS] = {.11, .12, .05, .031, .09, .13, .08, .047, .02, .14, .15};

/* What is seen in each bin, and in both regions beside them. */
static void write_sums(void)
{
    static const double contact[SUMS] = {
        [SUM_PARTICLES] = 40, [SUM_RETURN_FORCE] = 36, [SUM_BOND_FORCE] = 5,    [SUM_BONDED] = 20,
        [SUM_ORDER] = 13,     [SUM_HEAT] = 7,          [SUM_FREEDOM] = 50,      [SUM_DRIFT] = 17,
        [SUM_BROKEN] = 12,    [SUM_LOOKS] = 500,       [SUM_CHANGE] = 6,        [SUM_ACROSS] = 4,
        [SUM_CHANGED] = 80,   [SUM_ACROSS_LATE] = 9,   [SUM_CHANGED_LATE] = 60,
    };
    static const double far[SUMS] = {
        [SUM_PARTICLES] = 30, [SUM_RETURN_FORCE] = 7.5, [SUM_BOND_FORCE] = 9,
        [SUM_BONDED] = 25,    [SUM_ORDER] = 23,         [SUM_HEAT] = 2,
        [SUM_FREEDOM] = 35,   [SUM_DRIFT] = 3,          [SUM_BROKEN] = 3,
        [SUM_LOOKS] = 700,    [SUM_CHANGE] = 2,         [SUM_ACROSS] = 1.5,
        [SUM_CHANGED] = 100,  [SUM_ACROSS_LATE] = 5,    [SUM_CHANGED_LATE] = 125,
    };
    observer->profile->samples = 3;
    memcpy(sums_of(FW_PROFILE_CONTACT), contact, sizeof contact);
    memcpy(sums_of(FW_PROFILE_FAR), far, sizeof far);
    for (int bin = 0; bin < BINS; ++bin) {
        double *sums = sums_of(bin);
        const double count = bin + 2;
        sums[SUM_PARTICLES] = count;
        sums[SUM_RETURN_FORCE] = count * forces[bin];
        sums[SUM_ORDER] = count * orders[bin];
        sums[SUM_DRIFT] = count * drifts[bin] * drifts[bin];
    }
}

static void a_layer_tells_what_both_regions_saw(void **state)
{
    (void)state;
    begin(BAR);
    write_sums();
    look();
    told("layer-contact", .9);
    told("layer-far", .25);
    told("layer-contact-over-far", 3.6);
    told("layer-peak-over-far", 1.1 / .25); /* the bins beyond, up to 4, do not count */
    told("layer-temperature", .14);
    told("layer-bond-breaking", 12 / (500 * LOOK));
    told("layer-bond-breaking-far", 3 / (700 * LOOK));
    told("layer-bond-breaking-over-far", (12 / 500.) / (3 / 700.));
    told("layer-relative-displacement", 6 / 80.);
    told("layer-relative-displacement-far", 2 / 100.);
    told("layer-relative-displacement-over-far", 3.75);
    told("layer-diffusivity", (9 / 60. - 4 / 80.) / (4 * 3 * LAG));
    told("layer-diffusivity-far", (5 / 125. - 1.5 / 100) / (4 * 3 * LAG));
    told("layer-velocity-below", .031);
    told("layer-velocity-above", .047);
    end();
}

/* One bond that breaks in 700 looks is what no bond is taken for. */
static void no_bond_that_breaks_is_taken_for_one(void **state)
{
    (void)state;
    begin(BAR);
    write_sums();
    sums_of(FW_PROFILE_FAR)[SUM_BROKEN] = 0;
    look();
    told("layer-bond-breaking-far", 0);
    told("layer-bond-breaking-over-far", 12 / 500. * 700);
    sums_of(FW_PROFILE_FAR)[SUM_BROKEN] = .5;
    look();
    told("layer-bond-breaking-over-far", 12 / 500. * 700);
    sums_of(FW_PROFILE_FAR)[SUM_LOOKS] = 0;
    look();
    not_told("layer-bond-breaking-over-far");
    end();
}

/* Beside the contact region the next bin that has particles is asked. */
static void velocities_are_those_of_the_nearest_bins_with_particles(void **state)
{
    (void)state;
    begin(BAR);
    write_sums();
    memset(sums_of(3), 0, SUMS * sizeof(double));
    memset(sums_of(7), 0, SUMS * sizeof(double));
    memset(sums_of(8), 0, SUMS * sizeof(double));
    look();
    told("layer-velocity-below", .05);
    told("layer-velocity-above", .14);
    for (int bin = 0; bin < 3; ++bin) memset(sums_of(bin), 0, SUMS * sizeof(double));
    look();
    not_told("layer-velocity-below");
    told("layer-velocity-above", .14);
    end();
}

/* Where the line between (x, y) and (x + 1, z) has that level. */
static double crossing(double x, double y, double z, double level)
{
    return x + (level - y) / (z - y);
}

static void widths_are_of_straight_lines_nearer_than_far(void **state)
{
    (void)state;
    begin(BAR);
    write_sums();
    look();
    told("layer-width-order", crossing(2, .8, .98, .9) - crossing(-2, .93, .85, .9));
    /* From the edge of far, where the line is high, and about the contact. */
    const double half = (.9 + .25) / 2, twice = 2 * .25;
    told("layer-width-half", crossing(-3, 1.7, .3, half) + 2.6 + crossing(1, .8, .4, half) -
                                 crossing(-1, .45, 1.1, half));
    told("layer-width-double", crossing(-3, 1.7, .3, twice) + 2.6 + crossing(1, .8, .4, twice) -
                                   crossing(-1, .45, 1.1, twice));
    end();
}

/* Contact is 2.6 wide, far 4.2: 30 particles there are as dense as 18.57 at the contact. */
static void bodies_that_have_parted_have_no_layer(void **state)
{
    (void)state;
    static const char *const widths[] = {"layer-width-order", "layer-width-half",
                                         "layer-width-double"};
    begin(BAR);
    write_sums();
    const double even = 30 * 2.6 / (2 * (4.7 - 2.6));
    assert_close(fw_profile_value(observer->profile, FW_PROFILE_CONTACT, FW_PROFILE_DENSITY),
                 40 / (3 * 2.6 * WIDTH), 1e-14);
    for (int n = 0; n < 3; ++n) {
        sums_of(FW_PROFILE_CONTACT)[SUM_PARTICLES] = .501 * even;
        look();
        assert_true(*number_in(layer, widths[n]) >= 0);
        sums_of(FW_PROFILE_CONTACT)[SUM_PARTICLES] = .499 * even;
        look();
        not_told(widths[n]);
    }
    end();
}

/* Of 300 steps of .02 with the longest period that any drive has, 2.5: 2.4 cycles. */
static void expect_numbers_of_friction(const char *text)
{
    begin(text);
    observer->rubbing.sums = (fw_rubbing_sums){.last_slip = 31,
                                               .last_force = 37,
                                               .path_before = 3.7,
                                               .path = .8,
                                               .work = 9.6,
                                               .steps = 21,
                                               .slip = -5.25,
                                               .force = 63,
                                               .pressing = 126};
    look();
    told("layer-slip-path", 3.7);
    told("layer-offset", .25);
    told("layer-friction-force", 3);
    told("layer-normal-force", 6);
    told("layer-friction-coefficient", 2);
    told("layer-loop-energy", 4);
    end();
}

static void the_numbers_of_friction_are_those_of_its_sums(void **state)
{
    (void)state;
    expect_numbers_of_friction(BAR);
    expect_numbers_of_friction(BAR_DRIVEN("hold: y, path: {amplitude: [0, 1], period: 2.5}"));
}

/* --- over the control --- */

static void a_layer_is_compared_number_by_number(void **state)
{
    (void)state;
    double control[FW_LAYER_MEASURES];
    begin(BAR);
    write_sums();
    look();
    not_told("layer-contact-over-control");
    not_told("layer-bond-breaking-over-control");
    not_told("layer-relative-displacement-over-control");
    for (int n = 0; n < FW_LAYER_MEASURES; ++n) control[n] = 1000 + n;
    *number_in(control, "layer-contact") = .36;
    *number_in(control, "layer-bond-breaking") = .1;
    *number_in(control, "layer-relative-displacement") = .05;
    fw_layer_compare(layer, control, observer->profile);
    told("layer-contact-over-control", 2.5);
    told("layer-bond-breaking-over-control", 4);
    told("layer-relative-displacement-over-control", 1.5);
    /* A single one in the 500 looks is what none is taken for. */
    *number_in(control, "layer-bond-breaking") = 0;
    fw_layer_compare(layer, control, observer->profile);
    told("layer-bond-breaking-over-control", 12);
    end();
}

/* --- steadiness --- */

static const double before[] = {1.1, .8, 1.2, .9, 1.4, .6, 1.9, 2.3, 1.7, 2.2, 2.5, 1.4};

static double square_of_error(const double *values, int count)
{
    double mean = 0, squares = 0;
    for (int n = 0; n < count; ++n) mean += values[n] / count;
    for (int n = 0; n < count; ++n) squares += (values[n] - mean) * (values[n] - mean);
    return squares / (count - 1) / count;
}

/* Rows of steps 200 to 475 count, 300 steps before the samples at 500. Six values are too few for
 * blocks: each half has its plain error. */
static void a_layer_is_as_unsteady_as_its_halves_differ(void **state)
{
    (void)state;
    begin(BAR);
    for (int step = 0; step <= 800; step += 25) {
        const int n = (step - 200) / 25;
        const double row[8] = {step * .02, step >= 200 && step < 500 ? before[n] : 50 + step};
        fw_measurement_restore(measurement, step, step * .02, row);
    }
    look();
    told("layer-unsteadiness",
         1 / sqrt(square_of_error(before, 6) + square_of_error(before + 6, 6)));
    end();
}

static void too_few_rows_say_nothing_of_steadiness(void **state)
{
    (void)state;
    for (int rows = 7; rows <= 8; ++rows) {
        begin(BAR);
        for (int n = 0; n < rows; ++n) {
            const double row[8] = {0, before[n]};
            fw_measurement_restore(measurement, 499 - rows + n, 0, row);
        }
        look();
        assert_true(isnan(*number_in(layer, "layer-unsteadiness")) == (rows == 7));
        end();
    }
}

/* --- of particles that are led --- */

/* Pairs from (0, y) to (1, y) across y: the first lies beside the window, the second and third
 * between contact and far, the fourth at the contact, the fifth far from it. A unit of time is 71
 * steps of .014, looked at every 3; samples take steps 40 to 340. */
enum { BESIDE, BELOW, ABOVE, AT_CONTACT, AWAY, PAIRS };
#define PAIRED                                                                                     \
    "title: pairs\n"                                                                               \
    "materials: {m: {movable-particles: {mass: 2, strength: 0}}}\n"                                \
    "bodies: {b: {material: m, shape: {points: [[9, 1], [10, 1], [0, -1], [1, -1], [0, 3],\n"      \
    "  [1, 3], [0, 1], [1, 1], [0, 6], [1, 6]]}}}\n"                                               \
    "dynamics: {time-step: 0.014, strength-across: 0}\n"                                           \
    "phases: {settle: {until: 40}, sample: {until: 340}}\n"                                        \
    "run: {steps: 340}\n"                                                                          \
    "profile: {axis: y, phase: sample, every: 300, window: [-2, 5], bin: 1, middle: 1,\n"          \
    "  contact: 0.5, far: [3, 7]}\n"

/* What the second particle of a pair moves by in a step. */
static const fw_vec2 ways[PAIRS] = {
    {.003, 0}, {.002, 0}, {.0025, 0}, {.0004, .0011}, {.0007, -.0003}};
static const fw_vec2 speeds[PAIRS][2] = {{{7, 8}, {9, 8}},
                                         {{-.5, 2}, {-.9, 3}},
                                         {{.3, .9}, {.1, .8}},
                                         {{1, .5}, {1.6, -.3}},
                                         {{4, 6}, {5, 6}}};

/* So far apart are, beside their ways, the pair at the contact and that far from it: beyond 1.5
 * once, and twice. */
static double jump(int pair, int step)
{
    if (pair == AT_CONTACT) return step >= 335 ? .9 : 0;
    return pair == AWAY && ((step >= 326 && step < 329) || step >= 335) ? .8 : 0;
}

static void lead(fw_solid *solid, int step)
{
    for (int pair = 0; pair < PAIRS; ++pair) {
        const int second = 2 * pair + 1;
        solid->x[second] = solid->x[second - 1] + 1 + ways[pair].x * (step - 40) + jump(pair, step);
        solid->y[second] = solid->y[second - 1] + ways[pair].y * (step - 40);
        for (int n = 0; n < 2; ++n) fw_langevin_set_velocity(solid, 2 * pair + n, speeds[pair][n]);
    }
    assert_fine(fw_langevin_refresh(solid, &error));
    fw_profile_follow(observer->profile, observer->experiment, step);
}

static double square(double x)
{
    return x * x;
}

/* In 100 looks two particles lose one bond each at the contact, two each far from it. Of four times
 * 71 steps each is seen, and the whole; a pair drifts apart steadily, which is no diffusion, but
 * has its number. */
static void what_pairs_do_is_seen_where_they_are(void **state)
{
    (void)state;
    begin(PAIRED);
    fw_solid *solid = fw_scene_body(observer->experiment->scene, 0);
    for (int step = 40; step <= 340; ++step) lead(solid, step);
    look();
    const fw_vec2 near = ways[AT_CONTACT], far = ways[AWAY];
    const double unit = 71 * .014, looks = 2 * 100 * 3 * .014;
    told("layer-bond-breaking", 2 / looks);
    told("layer-bond-breaking-far", 4 / looks);
    told("layer-bond-breaking-over-far", .5);
    const double moved = square(71 * near.x) + square(71 * near.y);
    const double moved_far = square(71 * far.x) + square(71 * far.y);
    assert_close(*number_in(layer, "layer-relative-displacement"), moved, 1e-14);
    assert_close(*number_in(layer, "layer-relative-displacement-far"), moved_far, 1e-14);
    assert_close(*number_in(layer, "layer-relative-displacement-over-far"), moved / moved_far,
                 1e-10);
    assert_close(*number_in(layer, "layer-diffusivity"),
                 (square(4 * 71 * near.y) - square(71 * near.y)) / (4 * 3 * unit), 1e-14);
    assert_close(*number_in(layer, "layer-diffusivity-far"),
                 (square(4 * 71 * far.y) - square(71 * far.y)) / (4 * 3 * unit), 1e-14);
    /* Velocities along x; about their mean both at the contact have (.3, -.4), mass 2. */
    assert_close(*number_in(layer, "layer-velocity-below"), .7, 1e-14);
    assert_close(*number_in(layer, "layer-velocity-above"), .2, 1e-14);
    assert_close(*number_in(layer, "layer-temperature"), 2 * (.09 + .16) * 2 / 2, 1e-14);
    end();
}

/* Nobody rubs and nothing is gripped: friction is no number, nor is what is over nothing. */
static void what_is_not_there_is_not_told(void **state)
{
    (void)state;
    static const char *const names[] = {"layer-offset",
                                        "layer-friction-force",
                                        "layer-normal-force",
                                        "layer-friction-coefficient",
                                        "layer-loop-energy",
                                        "layer-unsteadiness",
                                        "layer-contact-over-far",
                                        "layer-peak-over-far",
                                        "layer-bond-breaking-over-far",
                                        "layer-relative-displacement-over-far",
                                        "layer-velocity-below",
                                        "layer-temperature"};
    begin(PAIRED);
    for (int step = 40; step < 42; ++step)
        fw_rubbing_follow(&observer->rubbing, observer->experiment, step);
    look();
    for (size_t n = 0; n < sizeof names / sizeof *names; ++n) not_told(names[n]);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_layer_tells_what_both_regions_saw),
        cmocka_unit_test(no_bond_that_breaks_is_taken_for_one),
        cmocka_unit_test(velocities_are_those_of_the_nearest_bins_with_particles),
        cmocka_unit_test(widths_are_of_straight_lines_nearer_than_far),
        cmocka_unit_test(bodies_that_have_parted_have_no_layer),
        cmocka_unit_test(the_numbers_of_friction_are_those_of_its_sums),
        cmocka_unit_test(a_layer_is_compared_number_by_number),
        cmocka_unit_test(a_layer_is_as_unsteady_as_its_halves_differ),
        cmocka_unit_test(too_few_rows_say_nothing_of_steadiness),
        cmocka_unit_test(what_pairs_do_is_seen_where_they_are),
        cmocka_unit_test(what_is_not_there_is_not_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
