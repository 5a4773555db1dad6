/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_starts.c - what bodies start with: each pattern by its formula, masses and links by which
 * sites are named. */
#include "tests/support/laws.h"

#include "core/boltzmann/lb_solid.h"
#include "core/noise.h"
#include "tests/support/scenarios.h"

static fw_scenario *scenario;
static fw_experiment *experiment;

static void begin(const char *text)
{
    scenario = read_right(text);
    experiment = build_right(scenario);
}

static void end(void)
{
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

/* --- patterns --- */

enum { COLUMNS = 4, ROWS = 3 };
#define SPACING 1.25

/* Site [i, j] lies at `place` from the body's origin. */
typedef fw_vec2 formula(fw_site site, fw_vec2 place);

static fw_vec2 uniform(fw_site site, fw_vec2 place)
{
    (void)site, (void)place;
    return (fw_vec2){.1, -.2};
}

static fw_vec2 left_alone(fw_site site, fw_vec2 place)
{
    (void)place;
    return site.i == 0 ? (fw_vec2){.1, -.2} : (fw_vec2){0, 0};
}

static fw_vec2 gaussian(fw_site site, fw_vec2 place)
{
    (void)place;
    const double di = site.i - 1.5, dj = site.j - .25;
    const double height = exp(-(di * di + dj * dj) / (2 * .8 * .8));
    return (fw_vec2){.1 * height, .3 * height};
}

static fw_vec2 wave(fw_site site, fw_vec2 place)
{
    (void)place;
    const double size = cos(.5 * site.i + .7 * site.j + FW_PI / 6);
    return (fw_vec2){.1 * size, .3 * size};
}

static fw_vec2 plane(fw_site site, fw_vec2 place)
{
    (void)site;
    const double size = cos(.5 * place.x + .7 * place.y - FW_PI / 3);
    return (fw_vec2){.1 * size, .3 * size};
}

static fw_vec2 gradient(fw_site site, fw_vec2 place)
{
    (void)site;
    return (fw_vec2){.01 * place.x + .02 * place.y, .03 * place.x - .04 * place.y};
}

static fw_vec2 both(fw_site site, fw_vec2 place)
{
    return fw_vec2_add(left_alone(site, place), gradient(site, place));
}

static const struct {
    const char *text;
    formula *value;
} patterns[] = {
    {"{by: [.1, -.2]}", uniform},
    {"{sites: left, by: [.1, -.2]}", left_alone},
    {"{gaussian: {amplitude: [.1, .3], centre: [1.5, .25], width: .8}}", gaussian},
    {"{wave: {amplitude: [.1, .3], wave-vector: [.5, .7], phase: 30}}", wave},
    {"{plane-wave: {amplitude: [.1, .3], wave-vector: [.5, .7], phase: -60}}", plane},
    {"{gradient: [.01, .02, .03, -.04]}", gradient},
    {"{sites: left, by: [.1, -.2]}, {gradient: [.01, .02, .03, -.04]}", both},
};

typedef struct kind {
    const char *material, *lattice;
} kind;

/* The first tells velocities of the step behind it: of displacements only. */
static const kind kinds[] = {
    {"lattice-boltzmann: {}", "square"},
    {"linear-lattice: {}", "hexagonal"},
    {"movable-particles: {strength: 0}", "hexagonal"},
};

static void begin_with(const kind *of, const char *key, const char *list)
{
    char text[640];
    snprintf(text, sizeof text,
             "title: a start\nmaterials: {m: {%s}}\n"
             "bodies: {a: {material: m, lattice: %s, shape: {rectangle: [%d, %d]}, spacing: %g,\n"
             "  angle: 20, origin: [7, -2], %s: [%s]}}\nrun: {steps: 1, seed: 5}\n",
             of->material, of->lattice, COLUMNS, ROWS, SPACING, key, list);
    begin(text);
}

static void displacements_follow_the_formula_of_their_pattern(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k)
        for (size_t n = 0; n < sizeof patterns / sizeof *patterns; ++n) {
            begin_with(&kinds[k], "displacement", patterns[n].text);
            const fw_lattice *lattice = &scenario->bodies[0].lattice;
            for (int l = 0; l < COLUMNS * ROWS; ++l) {
                const fw_site site = experiment->bodies[0].sites.site[l];
                const fw_vec2 place = fw_lattice_vector(lattice, site);
                const fw_vec2 u = patterns[n].value(site, place);
                const fw_vec2 at = fw_solid_position(fw_experiment_solid(experiment, 0), l);
                assert_close(at.x, 7 + place.x + u.x, 1e-14);
                assert_close(at.y, -2 + place.y + u.y, 1e-14);
            }
            end();
        }
}

static void velocities_follow_the_formula_of_their_pattern(void **state)
{
    (void)state;
    for (size_t k = 1; k < sizeof kinds / sizeof *kinds; ++k)
        for (size_t n = 0; n < sizeof patterns / sizeof *patterns; ++n) {
            double x[COLUMNS * ROWS], y[COLUMNS * ROWS];
            begin_with(&kinds[k], "velocity: [1, 2], velocities", patterns[n].text);
            const fw_solid *solid = fw_experiment_solid(experiment, 0);
            solid->model->velocities(solid, x, y);
            for (int l = 0; l < COLUMNS * ROWS; ++l) {
                const fw_site site = experiment->bodies[0].sites.site[l];
                const fw_vec2 v =
                    patterns[n].value(site, fw_lattice_vector(&scenario->bodies[0].lattice, site));
                assert_close(x[l], 1 + v.x, 1e-13);
                assert_close(y[l], 2 + v.y, 1e-13);
            }
            end();
        }
}

/* Within its bounds, as the seed says, another one in each pattern and body. */
static void random_patterns_are_bounded_and_differ(void **state)
{
    (void)state;
    double first[2][COLUMNS * ROWS];
    double largest = 0, sum = 0;
    for (int more = 0; more < 2; ++more) {
        begin_with(&kinds[2], "displacement", more ? "{by: [0, 0]}, {random: .1}" : "{random: .1}");
        for (int l = 0; l < COLUMNS * ROWS; ++l) {
            const fw_vec2 home = fw_lattice_position(&scenario->bodies[0].lattice,
                                                     experiment->bodies[0].sites.site[l]);
            const fw_vec2 at = fw_solid_position(fw_experiment_solid(experiment, 0), l);
            first[more][l] = at.x - home.x;
            largest = fmax(largest, fmax(fabs(at.x - home.x), fabs(at.y - home.y)));
            sum += fabs(at.x - home.x) + fabs(at.y - home.y);
        }
        end();
    }
    assert_true(largest <= .1 && largest > .08);
    assert_close(sum / (4 * COLUMNS * ROWS), .05, .02);
    for (int l = 0; l < COLUMNS * ROWS; ++l) assert_true(fabs(first[0][l] - first[1][l]) > 1e-6);
}

/* --- masses and links --- */

/* In a row of four the two in the middle are named: M = (M0^2 + sum kappa)/2 tells which of the
 * three links are stiffer, 3 in place of 1. */
static void links_are_chosen_by_their_ends(void **state)
{
    (void)state;
    static const struct {
        const char *links;
        double kappa[3];
    } choices[] = {{"inside", {1, 3, 1}}, {"across", {3, 1, 3}}, {"touching", {3, 3, 3}}};
    for (size_t n = 0; n < sizeof choices / sizeof *choices; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: a row\nmaterials: {m: {lattice-boltzmann: {rest-mass: 2}}}\n"
                 "bodies: {a: {material: m, shape: {rectangle: [4, 1]},\n"
                 "  link-stiffness: [{sites: [[1, 0], [2, 0]], links: %s, value: 3}]}}\n"
                 "run: {steps: 1}\n",
                 choices[n].links);
        begin(text);
        const double *k = choices[n].kappa;
        const double sums[] = {k[0], k[0] + k[1], k[1] + k[2], k[2]};
        for (int l = 0; l < 4; ++l) {
            const fw_sym2 mass = fw_lb_solid_mass(fw_experiment_solid(experiment, 0), l);
            assert_close(mass.xx, (4 + sums[l]) / 2, 1e-14);
            assert_close(mass.yy, (4 + sums[l]) / 2, 1e-14);
            assert_close(mass.xy, 0, 0);
        }
        end();
    }
}

static void the_last_mass_that_is_given_holds(void **state)
{
    (void)state;
    begin("title: a row\nmaterials: {m: {lattice-boltzmann: {rest-mass: 2}}}\n"
          "bodies: {a: {material: m, shape: {rectangle: [3, 1]}, rest-mass: [\n"
          "  {sites: {columns: [1, 2]}, value: 3}, {sites: right, value: [[1, 0], [0, 4]]}]}}\n"
          "run: {steps: 1}\n");
    const fw_solid *solid = fw_experiment_solid(experiment, 0);
    assert_close(fw_lb_solid_mass(solid, 0).xx, (4 + 1) / 2., 1e-14);
    assert_close(fw_lb_solid_mass(solid, 1).xx, (9 + 2) / 2., 1e-14);
    assert_close(fw_lb_solid_mass(solid, 2).xx, (1 + 1) / 2., 1e-14);
    assert_close(fw_lb_solid_mass(solid, 2).yy, (16 + 1) / 2., 1e-14);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(displacements_follow_the_formula_of_their_pattern),
        cmocka_unit_test(velocities_follow_the_formula_of_their_pattern),
        cmocka_unit_test(random_patterns_are_bounded_and_differ),
        cmocka_unit_test(links_are_chosen_by_their_ends),
        cmocka_unit_test(the_last_mass_that_is_given_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
