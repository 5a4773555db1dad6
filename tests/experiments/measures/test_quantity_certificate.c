/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_certificate.c - the items of a certificate, each asked by its name, and where each
 * of them comes from: ledgers that are written by hand. */
#include "tests/support/laws.h"

#include "contact/scene/scene_parts.h"
#include "tests/experiments/measures/asked.h"

/* Two bodies; of three walls the first is smooth. Nothing touches. */
#define ROOM(contact)                                                                              \
    "title: a room\n"                                                                              \
    "materials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"                                        \
    "bodies:\n"                                                                                    \
    "  a: {material: m, shape: {rectangle: [3, 2]}, origin: [5, 9], velocity: [.3, -.2]}\n"        \
    "  b: {material: m, shape: {rectangle: [2, 4]}, origin: [15, 7], velocity: [-.1, .1]}\n"       \
    "walls:\n"                                                                                     \
    "  smooth: {chain: [[0, 40], [0, 0]]}\n"                                                       \
    "  floor: {chain: [[0, 0], [40, 0]], surface: {coulomb: 0.3}}\n"                               \
    "  side: {chain: [[40, 0], [40, 40]], surface: {coulomb: 0.2}}\n" contact "run: {steps: 9}\n"

#define RUBS "contact: {friction: 0.3}\n"

static const char *const names[] = {
    [FW_CERTIFICATE_PENETRATION] = "certificate-penetration",
    [FW_CERTIFICATE_ENERGY] = "certificate-energy",
    [FW_CERTIFICATE_MOMENTUM] = "certificate-momentum",
    [FW_CERTIFICATE_OVERSTEP] = "certificate-overstep",
    [FW_CERTIFICATE_CREEP] = "certificate-creep",
    [FW_CERTIFICATE_UNCONVERGED] = "certificate-unconverged",
    [FW_CERTIFICATE_UNRESOLVED] = "certificate-unresolved",
};
enum { NAMES = sizeof names / sizeof *names };

static void each_item_has_its_own_name(void **state)
{
    (void)state;
    observe(ROOM(RUBS));
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n) observer->certificate.worst[n] = 3 + n * .25;
    for (int n = 0; n < NAMES; ++n) assert_close(number(names[n]), 3 + n * .25, 0);
    end();
}

/* --- from the ledgers --- */

static fw_wall_ledger *wall(int w)
{
    return (fw_wall_ledger *)fw_scene_wall_ledger(observer->experiment->scene, w);
}

static fw_contact_ledger *contact(void)
{
    return (fw_contact_ledger *)fw_scene_contact_ledger(observer->experiment->scene);
}

/* The most of all that rubs; a smooth wall does not. */
static void friction_is_as_bad_as_where_it_is_worst(void **state)
{
    (void)state;
    observe(ROOM(RUBS));
    wall(0)->overstep = .9, wall(0)->creep = .8;
    wall(1)->overstep = .02, wall(1)->creep = .05;
    wall(2)->overstep = .03, wall(2)->creep = .04;
    contact()->overstep = .01, contact()->creep = .06;
    fw_observer_certify(observer);
    assert_close(number("certificate-overstep"), .03, 0);
    assert_close(number("certificate-creep"), .06, 0);
    contact()->overstep = .07;
    wall(1)->creep = .09;
    fw_observer_certify(observer);
    assert_close(number("certificate-overstep"), .07, 0);
    assert_close(number("certificate-creep"), .09, 0);
    /* What was worst before is not forgotten. */
    contact()->overstep = wall(1)->creep = 0;
    fw_observer_certify(observer);
    assert_close(number("certificate-overstep"), .07, 0);
    assert_close(number("certificate-creep"), .09, 0);
    end();
}

static void bodies_that_do_not_rub_have_no_friction(void **state)
{
    (void)state;
    observe(ROOM(""));
    contact()->overstep = .5, contact()->creep = .6, contact()->unconverged = 2;
    wall(1)->overstep = .02, wall(1)->creep = .05;
    fw_observer_certify(observer);
    assert_close(number("certificate-overstep"), .02, 0);
    assert_close(number("certificate-creep"), .05, 0);
    assert_close(number("certificate-unconverged"), 2, 0);
    end();
}

static void contacts_that_were_not_solved_are_counted(void **state)
{
    (void)state;
    observe(ROOM(RUBS));
    contact()->ticks = 17, contact()->unconverged = 5;
    observer->experiment->scene->clock.unresolved = 4;
    fw_observer_certify(observer);
    assert_close(number("certificate-unconverged"), 5, 0);
    assert_close(number("certificate-unresolved"), 4, 0);
    assert_close(observer->certificate.worst[FW_CERTIFICATE_STEPS], 17, 0);
    assert_close(number("certificate-penetration"), 0, 0);
    end();
}

static void what_cannot_be_is_not_a_number(void **state)
{
    (void)state;
    observe("title: one body\n"
            "materials: {m: {lattice-boltzmann: {}}}\n"
            "bodies: {b: {material: m, shape: {rectangle: [3, 2]}, velocity: [.3, .1]}}\n"
            "run: {steps: 1}\n");
    fw_observer_certify(observer);
    for (int n = 0; n < NAMES; ++n) {
        const bool books = n == FW_CERTIFICATE_ENERGY || n == FW_CERTIFICATE_MOMENTUM;
        assert_true(isnan(number(names[n])) == !books);
    }
    end();
}

/* --- from the state --- */

/* Behind the wall in the west the second particle of the second body lies deepest. */
static void penetration_is_the_deepest_of_all_looks(void **state)
{
    (void)state;
    observe(ROOM(RUBS));
    fw_solid *solid = fw_scene_body(observer->experiment->scene, 1);
    const double before = solid->x[2];
    solid->x[2] = -.375;
    fw_observer_certify(observer);
    assert_close(number("certificate-penetration"), .375, 1e-14);
    solid->x[2] = before;
    fw_observer_certify(observer);
    assert_close(number("certificate-penetration"), .375, 1e-14);
    end();
}

/* Energy and momentum that the books know nothing of, over the energy so far, and over what could
 * have moved all of the mass with it. Corners of a sheet without rest mass weigh 1, its edges 3/2:
 * 3 x 2 are 7, 2 x 4 are 10, and 1/2 each for rest mass 1. */
static void books_that_do_not_close_show_by_how_much(void **state)
{
    (void)state;
    observe(ROOM(RUBS));
    const double mass[] = {7 + 6 * .5, 10 + 8 * .5};
    const double energy = mass[0] / 2 * (.09 + .04) + mass[1] / 2 * (.01 + .01);
    fw_solid_ledger *books = &fw_scene_body(observer->experiment->scene, 1)->ledger;
    assert_close(fw_scene_energy_scale(observer->experiment->scene), energy, 1e-13);
    fw_observer_certify(observer);
    assert_below(number("certificate-energy"), 1e-14);
    assert_below(number("certificate-momentum"), 1e-14);
    books->work += .125;
    books->impulse.x += .05;
    books->impulse.y -= .1;
    fw_observer_certify(observer);
    assert_close(number("certificate-energy"), .125 / energy, 1e-13);
    assert_close(number("certificate-momentum"), .1 / sqrt(2 * (mass[0] + mass[1]) * energy),
                 1e-13);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_item_has_its_own_name),
        cmocka_unit_test(friction_is_as_bad_as_where_it_is_worst),
        cmocka_unit_test(bodies_that_do_not_rub_have_no_friction),
        cmocka_unit_test(contacts_that_were_not_solved_are_counted),
        cmocka_unit_test(what_cannot_be_is_not_a_number),
        cmocka_unit_test(penetration_is_the_deepest_of_all_looks),
        cmocka_unit_test(books_that_do_not_close_show_by_how_much),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
