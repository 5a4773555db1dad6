/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_constrain.c - what must hold for one particle between any walls: the displacement follows
 * from the force, work and heat are reported, friction never feeds, and nothing passes a wall
 * unnoticed. Random facets, mobilities, memories and motions. */
#include "tests/support/laws.h"

#include "contact/constraint/constrain.h"
#include "contact/constraint/friction_law.h"

#include <stdbool.h>

enum { FACETS = 3 };

/* Numbers in [low, high), the same in every run. */
static double random_between(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

typedef struct kind {
    const char *name;
    fw_surface_law law;
    bool round, moving, matrix;
    double unresolved_max; /* part of the held steps that may be held fast and counted */
} kind;

typedef struct tally {
    int held, unresolved;
} tally;

/* A facet whose surface passes within .3 of the particle at the origin, which is on its free side.
 */
static fw_facet random_facet(uint64_t *seed, int number, bool round)
{
    double angle = random_between(seed, 0, FW_TWO_PI), gap = random_between(seed, 0, 0.3);
    fw_vec2 normal = {cos(angle), sin(angle)}, foot = fw_vec2_scale(-gap, normal);
    if (round && random_between(seed, 0, 1) < 0.6) {
        bool inside = random_between(seed, 0, 1) < 0.5;
        double radius = random_between(seed, 1, 5);
        fw_vec2 centre = fw_vec2_add(foot, fw_vec2_scale(inside ? radius : -radius, normal));
        return fw_facet_round(number, centre, radius, inside ? FW_INSIDE : FW_OUTSIDE, 0);
    }
    fw_vec2 along = fw_vec2_scale(-3, fw_vec2_turn(normal));
    return fw_facet_straight(number, fw_vec2_subtract(foot, along), fw_vec2_add(foot, along), 0);
}

static fw_sym2 random_mobility(uint64_t *seed, bool matrix)
{
    double a = random_between(seed, 0.2, 1), c = random_between(seed, 0.2, 1);
    if (!matrix) return fw_sym2_scalar(a);
    return (fw_sym2){a, random_between(seed, -0.9, 0.9) * sqrt(a * c), c};
}

static fw_vec2 random_vector(uint64_t *seed, double size)
{
    double x = random_between(seed, -size, size);
    return (fw_vec2){x, random_between(seed, -size, size)};
}

/* Two walls that are nearly parallel, or a nearly singular mobility, make forces and displacements
 * large: 1e-11 of their size is rounding. */
static void assert_lawful(const kind *k, const fw_prediction *free, const fw_candidate *candidates,
                          int count, const fw_contact_solution *c)
{
    fw_vec2 moved = fw_vec2_add(free->displacement, fw_sym2_apply(free->mobility, c->force));
    double size = 1 + hypot(c->force.x, c->force.y) + hypot(c->displacement.x, c->displacement.y);
    if (hypot(moved.x - c->displacement.x, moved.y - c->displacement.y) > 1e-11 * size)
        fail_msg("%s: the displacement does not follow from the force", k->name);
    double work = fw_vec2_dot(c->force, c->displacement);
    for (int n = 0; n < c->wall_contact_count; ++n) {
        work -= c->wall_contact[n].work - c->wall_contact[n].dissipated;
        if (k->law != FW_COMPONENTWISE && c->wall_contact[n].dissipated < -1e-11)
            fail_msg("%s: friction feeds %g", k->name, -c->wall_contact[n].dissipated);
    }
    if (fabs(work) > 1e-11 * size * size) fail_msg("%s: work of %g is not reported", k->name, work);
    for (int n = 0; n < count && !c->unresolved; ++n) {
        fw_vec2 w = fw_vec2_subtract(c->displacement, candidates[n].motion);
        if (fw_facet_gap(candidates[n].facet, w) < -1e-11 * size &&
            fw_facet_is_passed(candidates[n].facet, (fw_vec2){0, 0}, w, 0))
            fail_msg("%s: a wall is passed by %g and nothing says so", k->name,
                     -fw_facet_gap(candidates[n].facet, w));
    }
}

static void try_once(const kind *k, uint64_t *seed, tally *sum)
{
    fw_facet facets[FACETS];
    fw_candidate candidates[FACETS];
    int count = 1 + (int)random_between(seed, 0, FACETS);
    for (int n = 0; n < count; ++n) {
        fw_surface surface = {.law = k->law, .friction = random_between(seed, 0, 1)};
        facets[n] = random_facet(seed, n, k->round);
        candidates[n] = (fw_candidate){.facet = &facets[n], .number = n, .surface = surface};
        if (k->moving) candidates[n].motion = random_vector(seed, 0.2);
    }
    const fw_prediction free = {.displacement = random_vector(seed, 0.5),
                                .inertial = random_vector(seed, 0.5),
                                .mobility = random_mobility(seed, k->matrix)};
    fw_contact_memory memory = {0};
    if (random_between(seed, 0, 1) < 0.5)
        memory = (fw_contact_memory){.reaction = random_between(seed, 0, 1),
                                     .inertial = random_between(seed, -0.3, 0.3),
                                     .facet = 1 + (int)random_between(seed, 0, count),
                                     .stuck = random_between(seed, 0, 1) < 0.5};
    fw_contact_solution c = fw_constrain((fw_vec2){0, 0}, &free, candidates, count, candidates,
                                         k->law == FW_COULOMB ? &memory : NULL);
    if (!c.held) return;
    sum->held += 1;
    sum->unresolved += c.unresolved;
    assert_lawful(k, &free, candidates, count, &c);
}

static void one_particle_obeys_the_laws_between_any_walls(void **state)
{
    (void)state;
    static const kind kinds[] = {
        {"frictionless", FW_FRICTIONLESS, false, false, false, 0},
        {"frictionless, matrix", FW_FRICTIONLESS, false, false, true, 0},
        {"frictionless, moving", FW_FRICTIONLESS, false, true, true, 0.05},
        {"frictionless, round", FW_FRICTIONLESS, true, false, false, 0.01},
        {"frictionless, round, moving, matrix", FW_FRICTIONLESS, true, true, true, 0.1},
        {"coulomb", FW_COULOMB, false, false, false, 0.01},
        {"coulomb, matrix", FW_COULOMB, false, false, true, 0.05},
        {"coulomb, round, moving, matrix", FW_COULOMB, true, true, true, 0.2},
        {"stick", FW_STICK, false, false, true, 0},
        {"stick, moving", FW_STICK, false, true, false, 0.1},
        {"componentwise", FW_COMPONENTWISE, false, false, true, 0.2},
    };
    for (size_t n = 0; n < sizeof kinds / sizeof kinds[0]; ++n) {
        uint64_t seed = 17 + n;
        tally sum = {0, 0};
        for (int round = 0; round < 50000; ++round) try_once(&kinds[n], &seed, &sum);
        double part = (double)sum.unresolved / sum.held;
        print_message("%-36s held %d, held fast %.4f\n", kinds[n].name, sum.held, part);
        assert_true(sum.held > 10000);
        assert_true(part <= kinds[n].unresolved_max);
    }
}

/* What sticking lets through is all that the particle would slip, so that it needs no traction:
 * it sticks, from whichever direction it comes. The sign of what rounding leaves says nothing. */
static void what_needs_no_traction_sticks(void **state)
{
    (void)state;
    for (int n = 0; n < 360; ++n) {
        const double angle = FW_TWO_PI * n / 360;
        const fw_vec2 normal = {cos(angle), sin(angle)}, along = fw_vec2_turn(normal);
        const fw_facet facet = fw_facet_round(0, fw_vec2_scale(-1.01, normal), 1, FW_OUTSIDE, 0);
        const fw_candidate wall = {.facet = &facet,
                                   .surface = {.law = FW_COULOMB, .friction = 0.3}};
        const fw_vec2 path = fw_vec2_add(fw_vec2_scale(-0.1, normal), fw_vec2_scale(0.01, along));
        const fw_prediction free = {
            .displacement = path, .inertial = path, .mobility = fw_sym2_scalar(0.5)};
        fw_contact_memory memory = {.reaction = 0.1, .inertial = -1, .facet = 1, .stuck = true};
        const fw_contact_solution c =
            fw_constrain((fw_vec2){0, 0}, &free, &wall, 1, &wall, &memory);
        assert_true(c.held && memory.stuck);
    }
}

/* On a circle that is large beside the way of a step, what is left of the slip of a particle that
 * sticks is rounding of where it lies about the centre: it sticks on, and is not let go. */
static void what_sticks_to_a_large_circle_sticks_on(void **state)
{
    (void)state;
    for (int n = 0; n < 360; ++n) {
        const fw_vec2 normal = {cos(FW_TWO_PI * n / 360), sin(FW_TWO_PI * n / 360)};
        const fw_vec2 along = fw_vec2_turn(normal);
        const fw_facet facet = fw_facet_round(0, fw_vec2_scale(-500, normal), 500, FW_OUTSIDE, 0);
        const fw_candidate wall = {.facet = &facet,
                                   .surface = {.law = FW_COULOMB, .friction = 0.3}};
        const fw_vec2 path = fw_vec2_add(fw_vec2_scale(-1e-3, normal), fw_vec2_scale(1e-5, along));
        const fw_prediction free = {
            .displacement = path, .inertial = path, .mobility = fw_sym2_scalar(0.5)};
        fw_contact_memory memory = {.reaction = 2e-3,
                                    .inertial = fw_vec2_dot(path, along) + 1e-9,
                                    .facet = 1,
                                    .stuck = true};
        const fw_contact_solution c =
            fw_constrain((fw_vec2){0, 0}, &free, &wall, 1, &wall, &memory);
        assert_true(c.held && memory.stuck);
        assert_close(fw_vec2_dot(c.force, along), -2e-5, 1e-9);
    }
}

/* Floors 0 and 1 are facets of one wall, and floor 2 is another wall. A particle at the origin
 * rests on floor 0; it would sink by .2, so that with a mobility of .5 the reaction is .4. */
static fw_contact_solution rub_on_floor(double slip, double inertial, fw_contact_memory *memory)
{
    const fw_facet facets[] = {fw_facet_straight(0, (fw_vec2){-3, 0}, (fw_vec2){3, 0}, 0),
                               fw_facet_straight(0, (fw_vec2){-9, 0}, (fw_vec2){-3, 0}, 0),
                               fw_facet_straight(1, (fw_vec2){3, 0}, (fw_vec2){9, 0}, 0)};
    fw_candidate floors[3];
    for (int n = 0; n < 3; ++n)
        floors[n] = (fw_candidate){
            .facet = &facets[n], .number = n, .surface = {.law = FW_COULOMB, .friction = 0.25}};
    const fw_prediction free = {
        .displacement = {slip, -0.2}, .inertial = {inertial, 0}, .mobility = fw_sym2_scalar(0.5)};
    const fw_contact_solution c = fw_constrain((fw_vec2){0, 0}, &free, floors, 1, floors, memory);
    assert_int_equal(c.wall_contact_count, 1);
    assert_close(c.force.y, 0.4, 1e-15);
    assert_close(memory->reaction, 0.4, 1e-15);
    return c;
}

/* Friction is bound by its coefficient times the mean of the reactions of two steps, of the wall
 * that it rubs on and no other. It slips to the left; a force of .6 would
 * stop it. */
static void the_cone_is_of_the_same_wall_and_of_two_steps(void **state)
{
    (void)state;
    static const struct {
        int floor; /* on which it was, with a reaction of .8 */
        double cone;
    } cases[] = {{0, 0.25 * (0.4 + 0.8) / 2}, {1, 0.25 * (0.4 + 0.8) / 2}, {2, 0.25 * 0.4 / 2}};
    for (int n = 0; n < 3; ++n) {
        fw_contact_memory memory = {.reaction = 0.8, .facet = 1 + cases[n].floor};
        const fw_contact_solution c = rub_on_floor(-0.3, 0, &memory);
        assert_close(c.force.x, cases[n].cone, 1e-15);
        assert_close(c.displacement.x, -0.3 + 0.5 * cases[n].cone, 1e-15);
        assert_close(c.wall_contact[0].cone, cases[n].cone, 1e-15);
        assert_close(c.wall_contact[0].beyond, 0, 0);
        assert_close(c.wall_contact[0].dissipated, -c.force.x * c.displacement.x, 1e-15);
        assert_false(memory.stuck);
        assert_close(memory.crept, 0, 0);
    }
}

/* In the step after it left, its wall rubs it with half of the reaction that it had. */
static void what_leaves_is_rubbed_once_more(void **state)
{
    (void)state;
    const fw_facet facet = fw_facet_straight(0, (fw_vec2){-3, 0}, (fw_vec2){3, 0}, 0);
    const fw_candidate floor = {.facet = &facet, .surface = {.law = FW_COULOMB, .friction = 0.25}};
    const fw_prediction free = {.displacement = {-0.3, 0.2}, .mobility = fw_sym2_scalar(0.5)};
    fw_contact_memory memory = {.reaction = 0.8, .facet = 1};
    fw_contact_solution c = fw_constrain((fw_vec2){0, 0}, &free, &floor, 1, &floor, &memory);
    assert_true(c.held);
    assert_close(c.force.x, 0.25 * 0.8 / 2, 1e-15);
    assert_close(c.force.y, 0, 0);
    assert_close(c.wall_contact[0].beyond, 0, 0);
    assert_close(memory.reaction, 0, 0);
    c = fw_constrain((fw_vec2){0, 0}, &free, &floor, 1, &floor, &memory);
    assert_false(c.held);
    assert_int_equal(memory.facet, 0);
}

/* Of a particle that stays stuck: what it is let through along the tangent, (-1, 0), added up. */
static void creep_is_summed_while_it_sticks(void **state)
{
    (void)state;
    fw_contact_memory memory = {.reaction = 0.8, .inertial = -0.01, .facet = 1, .stuck = true};
    const double step = FW_STICK_FILTER / 4 * 0.02;
    for (int n = 1; n <= 3; ++n) {
        const fw_contact_solution c = rub_on_floor(0.03, 0.01 + 0.02 * n, &memory);
        assert_true(memory.stuck);
        assert_close(c.displacement.x, step, 1e-15);
        assert_close(memory.crept, -n * step, 1e-15);
    }
    memory.stuck = false;
    rub_on_floor(0.03, 0.02, &memory);
    assert_true(memory.stuck);
    assert_close(memory.crept, 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_particle_obeys_the_laws_between_any_walls),
        cmocka_unit_test(what_needs_no_traction_sticks),
        cmocka_unit_test(what_sticks_to_a_large_circle_sticks_on),
        cmocka_unit_test(the_cone_is_of_the_same_wall_and_of_two_steps),
        cmocka_unit_test(what_leaves_is_rubbed_once_more),
        cmocka_unit_test(creep_is_summed_while_it_sticks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
