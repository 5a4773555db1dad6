/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction of many particles as one problem with what pushes them: Coulomb's law row by row, with
 * nothing of what finds the solution. */
#include "contact/constraint/joint.h"

#include "core/noise.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 24 };

typedef struct problem {
    int end_count, row_count;
    fw_joint_end ends[MOST];
    fw_joint_row rows[MOST];
    fw_joint_outcome outcome;
} problem;

/* Between -1 and 1. */
static double random_of(uint64_t seed, int n)
{
    return fw_noise_uniform(seed, (uint32_t)n, 0, FW_NOISE_PLACEMENT).x;
}

static void add_end(problem *p, fw_vec2 position, fw_vec2 free, uint64_t seed)
{
    const int n = p->end_count++;
    const double a = 0.6 + 0.5 * random_of(seed, 200 + n), c = 0.6 + 0.5 * random_of(seed, 300 + n);
    p->ends[n] =
        (fw_joint_end){.position = position,
                       .free = free,
                       .unled = free,
                       .displacement = free,
                       .inertial = {free.x + 0.03 * random_of(seed, 500 + n), free.y},
                       .mobility = (fw_sym2){a, 0.5 * sqrt(a * c) * random_of(seed, 400 + n), c}};
}

/* What `leader` does beside its free way, in part, is added to that of `follower`. */
static void lead(problem *p, int leader, int follower, uint64_t seed)
{
    fw_joint_end *leads = &p->ends[leader], *led = &p->ends[follower];
    led->lead[led->lead_count++] = (fw_joint_lead){
        .end = leader,
        .x = {0.4 * random_of(seed, 600 + leader), 0.2 * random_of(seed, 620 + leader)},
        .y = {0.2 * random_of(seed, 640 + leader), 0.4 * random_of(seed, 660 + leader)},
        .expected = leads->free};
    leads->follower[leads->follower_count++] = follower;
}

/* Points come down on a chain of segments, and slide along it; where `leads`, each end of the chain
 * leads the point above it. */
static problem rubbing_points(uint64_t seed, double coefficient, double at_rest, bool leads)
{
    problem p = {0};
    const int count = 2 + (int)(seed % 6);
    for (int n = 0; n < 2 * count; ++n) {
        const bool below = n < count;
        const fw_vec2 at = {below ? 1.7 * n : 1.7 * (n - count) + 0.85 + 0.6 * random_of(seed, n),
                            0.1 * random_of(seed, 40 + n) + (below ? 0 : 0.25)};
        add_end(&p, at,
                (fw_vec2){0.15 * random_of(seed, 80 + n),
                          (below ? 0.1 : -0.2) * (1 + 0.5 * random_of(seed, 120 + n))},
                seed);
    }
    for (int n = 0; leads && n + 1 < count; ++n) lead(&p, n, count + n, seed);
    for (int n = 0; n + 1 < count; ++n)
        p.rows[p.row_count++] =
            (fw_joint_row){.kind = FW_JOINT_SEGMENT,
                           .end = {count + n, n, n + 1},
                           .fresh = true,
                           .rub = {.coefficient = coefficient,
                                   .at_rest = at_rest,
                                   .before = fmax(0, 0.2 * random_of(seed, 700 + n)),
                                   .stuck_before = random_of(seed, 730 + n) > 0,
                                   .slides = random_of(seed, 790 + n) > 0.5,
                                   .inertial_before = 0.1 * random_of(seed, 760 + n)}};
    return p;
}

static void solve(problem *p)
{
    fw_error error;
    fw_joint *joint = fw_joint_create();
    assert_int_equal(fw_joint_solve(joint, p->ends, p->end_count, p->rows, p->row_count, NULL,
                                    &p->outcome, &error),
                     FW_OK);
    fw_joint_destroy(joint);
}

/* w = free + A F, where `free` follows what leads. */
static void assert_moves_by_its_forces(const problem *p)
{
    for (int e = 0; e < p->end_count; ++e) {
        const fw_joint_end *end = &p->ends[e];
        fw_vec2 w = fw_vec2_add(end->lead_count > 0 ? end->unled : end->free,
                                fw_sym2_apply(end->mobility, end->force));
        for (int m = 0; m < end->lead_count; ++m) {
            const fw_joint_lead *by = &end->lead[m];
            const fw_vec2 more = fw_vec2_subtract(p->ends[by->end].displacement, by->expected);
            w = fw_vec2_add(w, (fw_vec2){fw_vec2_dot(by->x, more), fw_vec2_dot(by->y, more)});
        }
        assert_true(fabs(w.x - end->displacement.x) < 1e-14);
        assert_true(fabs(w.y - end->displacement.y) < 1e-14);
    }
}

static void assert_pushes_and_never_pulls(const problem *p)
{
    for (int n = 0; n < p->row_count; ++n) {
        const double gap = fw_joint_motion(&p->rows[n], p->ends) - p->rows[n].bound;
        assert_true(p->rows[n].lambda >= 0);
        assert_true(gap >= -1e-12);
        assert_true(p->rows[n].lambda * gap < 1e-13);
    }
}

/* Within the cone, at it where it slides, and against the slip; energy is never given, by all
 * together or by one that slides. */
static void assert_obeys_coulombs_law(const problem *p)
{
    double power = 0;
    for (int n = 0; n < p->row_count; ++n) {
        const fw_joint_rub *rub = &p->rows[n].rub;
        const double cone = fw_joint_cone(&p->rows[n]);
        double slip = 0;
        for (int k = 0; k < 3; ++k)
            slip += fw_vec2_dot(rub->weight[k], p->ends[p->rows[n].end[k]].displacement);
        assert_true(fabs(slip - rub->slip) < 1e-14);
        assert_false(rub->barred);
        assert_true(fabs(rub->traction) <= cone * (1 + 1e-9));
        if (!rub->stuck) {
            assert_true(fabs(rub->traction) >= cone * (1 - 1e-8));
            assert_true(rub->traction * slip <= 1e-13);
        }
        power += rub->traction * slip;
    }
    assert_true(power <= 1e-14);
}

/* Forces do no work but that of friction, whatever follows what. */
static void assert_books_close(const problem *p)
{
    double work = 0;
    fw_vec2 sum = {0, 0};
    for (int e = 0; e < p->end_count; ++e) {
        work += fw_vec2_dot(p->ends[e].force, p->ends[e].displacement);
        sum = fw_vec2_add(sum, p->ends[e].force);
    }
    for (int n = 0; n < p->row_count; ++n) work -= p->rows[n].rub.traction * p->rows[n].rub.slip;
    assert_true(fabs(work) < 1e-13);
    assert_true(fabs(sum.x) + fabs(sum.y) < 1e-14);
}

static void assert_all_is_well(const problem *p)
{
    assert_moves_by_its_forces(p);
    assert_books_close(p);
    assert_pushes_and_never_pulls(p);
    assert_obeys_coulombs_law(p);
}

/* Books close whatever happens; the law holds in all islands but few. */
static void small_islands_obey_the_law(bool leads)
{
    static const double laws[][2] = {{0.3, 0.3}, {1, 1}, {0.3, 0.6}, {2, 2}};
    for (int law = 0; law < 4; ++law) {
        int unconverged = 0;
        for (uint64_t seed = 0; seed < 500; ++seed) {
            problem p = rubbing_points(seed, laws[law][0], laws[law][1], leads);
            solve(&p);
            unconverged += p.outcome.unconverged;
            if (p.outcome.unconverged == 0)
                assert_all_is_well(&p);
            else
                assert_books_close(&p);
        }
        print_message("%g, %g: %d of 500 not converged\n", laws[law][1], laws[law][0], unconverged);
        assert_true(unconverged <= 5);
    }
}

static void small_islands_obey_coulombs_law(void **state)
{
    (void)state;
    small_islands_obey_the_law(false);
}

static void islands_that_follow_obey_coulombs_law(void **state)
{
    (void)state;
    small_islands_obey_the_law(true);
}

/* With a coefficient that holds everything, and nothing to let through, all stick. No power is left
 * but rounding, and that takes nothing away. */
static void friction_that_only_holds_is_kept(void **state)
{
    (void)state;
    int held = 0;
    for (uint64_t seed = 0; seed < 500; ++seed) {
        problem p = rubbing_points(seed, 1, 1, false);
        for (int n = 0; n < p.row_count; ++n) p.rows[n].rub.before = 1e3;
        for (int e = 0; e < p.end_count; ++e) p.ends[e].inertial = (fw_vec2){0, 0};
        for (int n = 0; n < p.row_count; ++n) p.rows[n].rub.inertial_before = 0;
        solve(&p);
        assert_int_equal(p.outcome.unconverged, 0);
        for (int n = 0; n < p.row_count; ++n) {
            assert_true(p.rows[n].rub.stuck && p.rows[n].rub.traction != 0);
            assert_true(fabs(p.rows[n].rub.slip) < 1e-9);
            held += 1;
        }
    }
    assert_true(held > 1000);
}

/* Two points on one piston, each of which is carried along it its own way, whatever the force: they
 * cannot both stick, and bear their cones. */
static void what_cannot_all_stick_slides(void **state)
{
    (void)state;
    problem p = {0};
    for (int n = 0; n < 2; ++n) add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0, -0.2}, 3);
    p.ends[0].mobility = (fw_sym2){0, 0, 1}; /* held along the plane */
    p.ends[1].mobility = (fw_sym2){0, 0, 1};
    p.ends[0].free = p.ends[0].displacement = (fw_vec2){0.1, -0.2};
    p.ends[1].free = p.ends[1].displacement = (fw_vec2){-0.1, -0.2};
    p.ends[2] = (fw_joint_end){.mobility = fw_sym2_scalar(1), .wide = true};
    p.end_count = 3;
    for (int n = 0; n < 2; ++n)
        p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_PLANE,
                                               .end = {n, 2},
                                               .normal = {0, 1},
                                               .borne = true,
                                               .rub = {.coefficient = 0.3, .before = 0.4},
                                               .fresh = true};
    solve(&p);
    assert_int_equal(p.outcome.unconverged, 0);
    for (int n = 0; n < 2; ++n) {
        const fw_joint_rub *rub = &p.rows[n].rub;
        assert_true(fabs(fabs(rub->traction) - fw_joint_cone(&p.rows[n])) < 1e-12);
        assert_true(rub->traction * rub->slip < 0);
    }
    assert_true(fabs(p.ends[2].displacement.x) < 1e-14);
}

static void add_rough_plane(problem *p, int particle, int piston, fw_vec2 normal, double before)
{
    p->rows[p->row_count++] =
        (fw_joint_row){.kind = FW_JOINT_PLANE,
                       .end = {particle, piston},
                       .normal = normal,
                       .borne = true,
                       .open = before > 0,
                       .rub = {.coefficient = 2, .before = before, .stuck_before = before > 0},
                       .fresh = true};
}

/* A particle in the notch of a rough piston: what sticking would let through along one face is not
 * what the other allows. A wall that it has just left rubs it and another particle. However both
 * faces share the load, they press no more than motions ask for. */
static void contradictions_of_what_sticks_press_nothing(void **state)
{
    (void)state;
    for (int trial = 0; trial < 2000; ++trial) {
        const uint64_t seed = 100 + (uint64_t)trial;
        problem p = {0};
        for (int n = 0; n < 4; ++n) {
            const fw_vec2 free = {0.1 * random_of(seed, 10 + n), 0.05 * random_of(seed, 20 + n)};
            add_end(&p, (fw_vec2){0, 0}, free, seed);
            p.ends[n].mobility = fw_sym2_scalar(0.1 + 0.1 * n);
        }
        p.ends[1].wide = p.ends[2].wide = true;
        p.ends[2].mobility = (fw_sym2){1, 0, 0};
        for (int n = 0; n < 2; ++n) {
            const double angle = (n > 0 ? 3.6 : -0.4) + 0.1 * random_of(seed, 30 + n);
            add_rough_plane(&p, 0, 1, (fw_vec2){cos(angle), sin(angle)}, 0);
        }
        add_rough_plane(&p, 0, 2, (fw_vec2){-1, 0}, 0.06);
        add_rough_plane(&p, 3, 2, (fw_vec2){-1, 0}, trial % 2 > 0 ? 0.06 : 0);
        solve(&p);
        assert_int_equal(p.outcome.unconverged, 0);
        assert_true(p.outcome.residual < 1e-14);
        for (int n = 0; n < 2; ++n) assert_true(p.rows[n].lambda < 10);
    }
}

/* A particle that something else holds along a piston's face: whatever it bears, it has not broken
 * loose. */
static void what_is_held_along_a_face_has_not_broken_loose(void **state)
{
    (void)state;
    for (int trial = 0; trial < 200; ++trial) {
        const uint64_t seed = 5000 + (uint64_t)trial;
        problem p = {0};
        for (int n = 0; n < 2; ++n)
            add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0.1 * random_of(seed, n), n > 0 ? -0.2 : 0.1},
                    seed);
        p.ends[1].wide = true;
        p.ends[1].free.x = p.ends[1].displacement.x = 0;
        p.ends[1].mobility = (fw_sym2){0, 0, 0.1};
        for (int n = 0; n < 2; ++n)
            p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_PLANE,
                                                   .end = {0, -1},
                                                   .normal = {n > 0, n == 0},
                                                   .both = true,
                                                   .fresh = true};
        add_rough_plane(&p, 0, 1, (fw_vec2){0, -1}, 0);
        p.rows[2].rub.coefficient = 0.3;
        solve(&p);
        const fw_joint_rub *rub = &p.rows[2].rub;
        assert_true(fabs(rub->slip) < 1e-15);
        assert_true(fabs(rub->traction) <= fw_joint_cone(&p.rows[2]) * (1 + 1e-12));
        assert_true(rub->stuck);
    }
}

/* A point over the first quarter of a segment rubs the end that is near by more: by 1 - p and p,
 * with p where it is on the way in the middle of the step. */
static void a_nearer_end_is_rubbed_by_more(void **state)
{
    (void)state;
    problem p = {0};
    const fw_vec2 at[] = {{1, 0.05}, {0, 0}, {4, 0}}, free[] = {{0.3, -0.2}, {0, 0}, {0, 0}};
    fw_vec2 middle[3];
    for (int n = 0; n < 3; ++n) {
        add_end(&p, at[n], free[n], 1);
        p.ends[n].mobility = fw_sym2_scalar(0.5);
    }
    p.rows[p.row_count++] = (fw_joint_row){
        .kind = FW_JOINT_SEGMENT, .end = {0, 1, 2}, .rub = {.coefficient = 0.3}, .fresh = true};
    solve(&p);
    assert_int_equal(p.outcome.unconverged, 0);
    for (int n = 0; n < 3; ++n)
        middle[n] = fw_vec2_add(at[n], fw_vec2_scale(0.5, p.ends[n].displacement));
    const fw_vec2 edge = fw_vec2_subtract(middle[2], middle[1]);
    const double length = hypot(edge.x, edge.y);
    const double part =
        fw_vec2_dot(edge, fw_vec2_subtract(middle[0], middle[1])) / (length * length);
    const double expected[] = {1, part - 1, -part};
    assert_true(part > 0.2 && part < 0.35 && p.rows[0].rub.traction < 0);
    for (int n = 0; n < 3; ++n) {
        assert_true(fabs(p.rows[0].rub.weight[n].x - expected[n] * edge.x / length) < 1e-9);
        assert_true(fabs(p.rows[0].rub.weight[n].y - expected[n] * edge.y / length) < 1e-9);
    }
}

/* A particle that falls by .1 on a wall which moves along itself by .05: it is taken along by half
 * of .3 times its reaction .1, on one of these sides as on the other; by a wall at rest it is not.
 * That at rest it would bear .6 is no matter: half of that is less than .05, and it breaks loose.
 */
static void assert_is_taken_along(double at_rest)
{
    for (int way = -1; way <= 1; ++way) {
        problem p = {0};
        add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0, -0.1}, 1);
        p.ends[0].inertial = (fw_vec2){0, -0.1};
        p.ends[0].mobility = fw_sym2_scalar(1);
        p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_PLANE,
                                               .end = {0, -1},
                                               .normal = {0, 1},
                                               .motion = {0.05 * way, 0},
                                               .rub = {.coefficient = 0.3, .at_rest = at_rest},
                                               .fresh = true};
        solve(&p);
        assert_true(p.rows[0].rub.slides == (way != 0 && at_rest > 0.3));
        assert_true(fabs(p.rows[0].lambda - 0.1) < 1e-14);
        assert_true(fabs(p.ends[0].displacement.x - 0.015 * way) < 1e-14);
        assert_true(fabs(p.ends[0].displacement.y) < 1e-14);
        assert_true(fabs(fabs(p.rows[0].rub.slip) - 0.035 * abs(way)) < 1e-14);
    }
}

static void a_wall_takes_along_what_lies_on_it(void **state)
{
    (void)state;
    assert_is_taken_along(0.3);
    assert_is_taken_along(0.4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_islands_obey_coulombs_law),
        cmocka_unit_test(islands_that_follow_obey_coulombs_law),
        cmocka_unit_test(friction_that_only_holds_is_kept),
        cmocka_unit_test(what_cannot_all_stick_slides),
        cmocka_unit_test(what_is_held_along_a_face_has_not_broken_loose),
        cmocka_unit_test(a_nearer_end_is_rubbed_by_more),
        cmocka_unit_test(a_wall_takes_along_what_lies_on_it),
        cmocka_unit_test(contradictions_of_what_sticks_press_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
