/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scenario_contact.c - surfaces, their pairs, and one or two coefficients mean what they say,
 * and what cannot be meant is refused. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"

#include <string.h>

static const char text[] =
    "title: Surfaces\n"
    "materials: {rubber: {lattice-boltzmann: {}}}\n"
    "bodies:\n"
    "  plain: {material: rubber, shape: {rectangle: [3, 3]}}\n"
    "  block: {material: rubber, shape: {rectangle: [3, 3]}, origin: [9, 0], surface: steel}\n"
    "  other: {material: rubber, shape: {rectangle: [3, 3]}, origin: [19, 0], surface: steel}\n"
    "walls:\n"
    "  floor: {chain: [[-9, 0], [30, 0]], surface: {named: ice}}\n"
    "  side: {chain: [[0, 9], [0, -9]], surface: {coulomb: {static: 0.7, kinetic: 0.6}}}\n"
    "contact:\n"
    "  friction: {static: 0.4, kinetic: 0.2}\n"
    "  pairs:\n"
    "    - {between: [ice, steel], friction: 0.1}\n"
    "    - {between: [steel, steel], friction: {static: 0.9, kinetic: 0.8}}\n"
    "run: {steps: 1}\n";

static fw_status read(fw_scenario **scenario, const char *setting, fw_error *error)
{
    return fw_scenario_read(scenario, "s.yaml", text, strlen(text), &setting, setting ? 1 : 0,
                            error);
}

static void assert_pair(const fw_scenario_contact *contact, int a, int b, double at_rest,
                        double kinetic)
{
    const fw_friction ab = contact->pairs[a * contact->surface_count + b];
    const fw_friction ba = contact->pairs[b * contact->surface_count + a];
    assert_close(ab.at_rest, at_rest, 0);
    assert_close(ab.kinetic, kinetic, 0);
    assert_close(ba.at_rest, at_rest, 0);
    assert_close(ba.kinetic, kinetic, 0);
}

static void pairs_of_surfaces_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s;
    fw_error error;
    if (read(&s, NULL, &error) != FW_OK) fail_msg("%s", error.sentence);
    const int steel = s->bodies[1].surface, ice = s->walls[0].def.surface.number - 1;
    assert_int_equal(s->contact.surface_count, 3);
    assert_int_equal(s->bodies[0].surface, 0);
    assert_int_equal(s->bodies[2].surface, steel);
    assert_true(steel > 0 && ice > 0 && steel != ice);
    assert_int_equal(s->walls[0].def.surface.law, FW_COULOMB);
    assert_pair(&s->contact, 0, 0, 0.4, 0.2);
    assert_pair(&s->contact, 0, steel, 0.4, 0.2);
    assert_pair(&s->contact, 0, ice, 0.4, 0.2);
    assert_pair(&s->contact, ice, steel, 0.1, 0.1);
    assert_pair(&s->contact, steel, steel, 0.9, 0.8);
    assert_int_equal(s->walls[1].def.surface.number, 0);
    assert_close(s->walls[1].def.surface.friction, 0.6, 0);
    assert_close(s->walls[1].def.surface.static_friction, 0.7, 0);
    fw_scenario_destroy(s);
    if (read(&s, "contact.friction=0.5", &error) != FW_OK) fail_msg("%s", error.sentence);
    assert_pair(&s->contact, 0, 0, 0.5, 0.5);
    fw_scenario_destroy(s);
}

static void assert_refused(const char *setting, const char *sentence)
{
    fw_scenario *s;
    fw_error error;
    assert_int_equal(read(&s, setting, &error), FW_BAD_INPUT);
    if (!strstr(error.sentence, sentence)) fail_msg("%s\nexpected %s", error.sentence, sentence);
}

static void what_cannot_be_meant_is_refused(void **state)
{
    (void)state;
    assert_refused("contact.pairs=[{between: [ice, stel], friction: 1}]",
                   "no body or wall has the surface 'stel'; did you mean 'steel'?");
    assert_refused("contact.pairs=[{between: [ice, wax], friction: 1}]",
                   "no body or wall has the surface 'wax', expected one that a 'surface' names");
    assert_refused("contact.pairs=[{between: [ice, steel], friction: 1}, "
                   "{between: [steel, ice], friction: 2}]",
                   "the pair of surfaces 'steel' and 'ice' stands there twice");
    assert_refused("contact.friction={static: 0.2, kinetic: 0.3}",
                   "the kinetic coefficient of friction is 0.3, expected at most the static one, "
                   "0.2");
    assert_refused("walls.side.surface.coulomb.kinetic=0.8",
                   "the kinetic coefficient of friction is 0.8, expected at most the static one");
    assert_refused("contact.friction={static: 0.2}", "has no 'kinetic'");
    assert_refused("contact.friction=-1", "contact.friction is '-1', expected a number from 0 to 1000");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_of_surfaces_are_what_was_written),
        cmocka_unit_test(what_cannot_be_meant_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
