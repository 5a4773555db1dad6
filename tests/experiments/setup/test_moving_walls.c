/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_moving_walls.c - walls on paths that never end, as a scenario has them: they touch what they
 * meet and nothing else. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

/* A stamp comes down on a block and presses it in the end. Before, nothing knows of it. */
static const char stamp[] =
    "title: a block that a moving stamp presses\n"
    "materials: {rubber: {lattice-boltzmann: {}}}\n"
    "bodies: {block: {material: rubber, shape: {rectangle: [8, 5]}, origin: [1, 1],\n"
    "  velocity: [0.03, 0]}}\n"
    "walls:\n"
    "  floor: {box: [-50, 0, 50, 50]}\n"
    "  stamp: {box: [-2, 8, 12, 11], side: outside, path: {velocity: [0, -0.01]}}\n"
    "run: {steps: 250, record-every: 50}\n"
    "measure: [energy, momentum, reaction, unresolved, centre-of-mass]\n"
    "expect:\n"
    "  - {quantity: unresolved, value: 0, within: 0}\n"
    "  - {quantity: reaction, wall: stamp, component: y, at: 50, value: 0, within: 1e-12}\n"
    "  - {quantity: energy, at: 50, value: 0.03015, within: 1e-9}\n"
    "  - {quantity: momentum, component: x, at: 50, value: 2.01, within: 1e-9}\n";

/* A punch four particles wide presses these four, as hard as where its path ends behind the run. */
static const char punch[] =
    "title: a box on a path is pressed into a block\n"
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0, damping: 0.1}}}\n"
    "bodies:\n"
    "  block: {material: rubber, shape: {rectangle: [20, 8]}}\n"
    "walls:\n"
    "  floor: {box: [-5, -3, 24, 0], side: outside, surface: stick}\n"
    "  punch: {box: [7.5, 7.2, 11.5, 12], side: outside, path: {velocity: [0, -0.005]}}\n"
    "run: {steps: 200}\n"
    "expect:\n"
    "  - {quantity: contacts, wall: punch, statistic: largest, value: 4, within: 0}\n"
    "  - {quantity: reaction, wall: punch, component: y, at: 200, value: -1.225930567,\n"
    "     within: 1e-6}\n";

static void expect_it_holds(const char *text)
{
    static const char *const ends[] = {"", "1000", "1e12"};
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "moves.yaml", text);
    const char *wall = strstr(text, "  stamp:") ? "stamp" : "punch";
    for (size_t n = 0; n < sizeof ends / sizeof *ends; ++n) {
        char line[256];
        snprintf(line, sizeof line, "verify moves.yaml -q%s%s%s%s", n ? " --set walls." : "",
                 n ? wall : "", n ? ".path.until=" : "", ends[n]);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 0, "");
    }
    remove_folder(folder);
}

static void a_stamp_touches_a_block_when_it_gets_there(void **state)
{
    (void)state;
    expect_it_holds(stamp);
}

static void a_punch_presses_what_is_under_it(void **state)
{
    (void)state;
    expect_it_holds(punch);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stamp_touches_a_block_when_it_gets_there),
        cmocka_unit_test(a_punch_presses_what_is_under_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
