/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of many particles as one problem: what the solution must satisfy, whatever the rows. */
#include "tests/support/joint_problems.h"

static void solve(problem *p)
{
    solve_with(p, NULL);
}

/* Energy that the rows add, over that which the ends have: |sum F . w| / sum w_p A^-1 w_p. */
static double energy_error(const problem *p)
{
    double work = 0, energy = 0;
    for (int e = 0; e < p->end_count; ++e) {
        const fw_joint_end *end = &p->ends[e];
        if (end->mobility.xx == 0) continue;
        work += fw_vec2_dot(end->force, end->displacement);
        energy += fw_sym2_form(end->free, fw_sym2_invert(end->mobility), end->free);
    }
    return fabs(work) / energy;
}

static double momentum_error(const problem *p)
{
    fw_vec2 sum = {0, 0};
    double size = 0;
    for (int e = 0; e < p->end_count; ++e) {
        sum = fw_vec2_add(sum, p->ends[e].force);
        size += fabs(p->ends[e].force.x) + fabs(p->ends[e].force.y);
    }
    return size > 0 ? (fabs(sum.x) + fabs(sum.y)) / size : 0;
}

/* How far the worst row is passed. */
static double passed(const problem *p)
{
    double most = 0;
    for (int n = 0; n < p->row_count; ++n)
        most = fmax(most, p->rows[n].bound - fw_joint_motion(&p->rows[n], p->ends));
    return most;
}

static void assert_solved(const problem *p, double energy, double gap)
{
    for (int n = 0; n < p->row_count; ++n) assert_true(p->rows[n].lambda >= 0);
    for (int e = 0; e < p->end_count; ++e) {
        const fw_joint_end *end = &p->ends[e];
        const fw_vec2 w = fw_vec2_add(end->free, fw_sym2_apply(end->mobility, end->force));
        assert_true(fabs(w.x - end->displacement.x) < 1e-12);
        assert_true(fabs(w.y - end->displacement.y) < 1e-12);
    }
    if (!(energy_error(p) <= energy) || !(passed(p) <= gap) || p->outcome.unconverged > 0)
        fail_msg("energy %g, passed by %g, %d islands of %d not converged, change %g",
                 energy_error(p), passed(p), p->outcome.unconverged, p->outcome.islands,
                 p->outcome.change);
}

typedef enum approach { UNIFORM, NOISE, PARABOLA, ROCKING } approach;

/* The face of a body above, that comes down, on that of a body below; `both`: rows of both sides.
 */
static problem two_faces(int count, double offset, double gap, approach how, bool both,
                         uint64_t seed)
{
    problem p = with_room(2 * count, 8 * count);
    for (int n = 0; n < count; ++n)
        add_end(&p, (fw_vec2){n, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(0.25));
    for (int n = 0; n < count; ++n) {
        const double x = (double)n / count - 0.5;
        const double noise = random_of(seed, n);
        const double down = how == UNIFORM    ? 0.1
                            : how == NOISE    ? 0.1 * noise
                            : how == PARABOLA ? 0.1 - 0.5 * x * x
                                              : 0.2 * x;
        const double bump = how == NOISE ? 1e-3 * random_of(seed, count + n) : 0;
        add_end(&p, (fw_vec2){n + offset, gap + bump}, (fw_vec2){0.01 * noise, -down},
                fw_sym2_scalar(n == 0 || n == count - 1 ? 0.5 : 0.25));
    }
    for (int n = 0; n < count; ++n) { /* the upper body's point against the lower one's segment */
        const double x = p.ends[count + n].position.x;
        const int left = (int)floor(x);
        if (left >= 0 && left + 1 < count) add_segment(&p, count + n, left, left + 1);
    }
    for (int n = 0; both && n < count; ++n) { /* segments of the upper body run leftward */
        const double x = n - offset;
        const int left = (int)floor(x);
        if (left >= 0 && left + 1 < count) add_segment(&p, n, count + left + 1, count + left);
    }
    return p;
}

static void flat_faces_meet_at_any_offset(void **state)
{
    (void)state;
    double slowest = 0, worst = 0;
    for (int how = UNIFORM; how <= ROCKING; ++how)
        for (int n = 0; n < 8; ++n) {
            const double offsets[] = {0, 1e-9, 0.01, 0.25, 0.37, 0.5, 0.999, 300.123};
            problem p = two_faces(1000, offsets[n], 1e-3, (approach)how, true, (uint64_t)n);
            solve(&p);
            assert_solved(&p, 1e-13, 1e-12);
            assert_true(momentum_error(&p) < 1e-13);
            slowest = fmax(slowest, p.seconds);
            worst = fmax(worst, energy_error(&p));
            release(&p);
        }
    assert_true(slowest < 1); /* .02 s where nobody else works */
    print_message("two faces of 1000: dE <= %.1e, at most %.1f ms\n", worst, 1e3 * slowest);
}

static void small_faces_meet_at_any_offset(void **state)
{
    (void)state;
    double slowest = 0;
    for (int how = UNIFORM; how <= ROCKING; ++how)
        for (int n = 0; n < 200; ++n) {
            const double offset = n == 0 ? 0 : 10 * random_of(3, n);
            problem p = two_faces(2 + n % 48, offset, 0.01, (approach)how, true, (uint64_t)n);
            if (p.row_count > 0) {
                solve(&p);
                assert_solved(&p, 1e-13, 1e-12);
                slowest = fmax(slowest, p.seconds);
            }
            release(&p);
        }
    print_message("two faces of up to 49: at most %.2f ms\n", 1e3 * slowest);
}

static void rows_that_stand_twice_change_nothing(void **state)
{
    (void)state;
    for (int count = 3; count <= 243; count *= 3) {
        problem once = two_faces(count, 0.3, 1e-3, PARABOLA, true, 5);
        problem more = two_faces(count, 0.3, 1e-3, PARABOLA, true, 5);
        for (int n = 0; n < once.row_count; ++n) more.rows[more.row_count++] = once.rows[n];
        solve(&once);
        solve(&more);
        assert_solved(&more, 1e-13, 1e-12);
        for (int e = 0; e < once.end_count; ++e) {
            const fw_vec2 apart =
                fw_vec2_subtract(once.ends[e].displacement, more.ends[e].displacement);
            assert_true(fabs(apart.x) + fabs(apart.y) < 1e-7);
        }
        release(&once);
        release(&more);
    }
}

static double area_of(const problem *p, const fw_joint_row *row, bool after)
{
    fw_vec2 at[3];
    for (int k = 0; k < 3; ++k) {
        const fw_joint_end *end = &p->ends[row->end[k]];
        at[k] = after ? fw_vec2_add(end->position, end->displacement) : end->position;
    }
    return fw_vec2_cross(fw_vec2_subtract(at[2], at[1]), fw_vec2_subtract(at[0], at[1]));
}

/* Points that fly at a chain of segments from all sides, with any mobility. */
static void no_point_comes_nearer_to_the_segment_that_holds_it(void **state)
{
    (void)state;
    int unconverged = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int count = 2 + trial % 7;
        const uint64_t seed = (uint64_t)trial;
        problem p = with_room(2 * count, count);
        for (int n = 0; n < 2 * count; ++n) {
            const fw_vec2 at = {n < count ? 1.7 * n : 1.7 * (n - count) + random_of(seed, 3 * n),
                                0.5 * random_of(seed, 3 * n + 1) + (n < count ? 0 : 0.5)};
            add_end(&p, at, (fw_vec2){0.3 * random_of(seed, 99 + n), n < count ? 0.2 : -0.3},
                    fw_sym2_scalar(1));
            const double a = 0.6 + random_of(seed, 200 + n), c = 0.6 + random_of(seed, 300 + n);
            p.ends[n].mobility = (fw_sym2){a, 0.9 * sqrt(a * c) * random_of(seed, 400 + n), c};
            if (trial % 3 == 0 && n == 0) p.ends[n].mobility = (fw_sym2){0, 0, 0};
        }
        for (int n = 0; n + 1 < count; ++n) add_segment(&p, count + n, n, n + 1);
        solve(&p);
        if (p.outcome.unconverged == 0)
            for (int n = 0; n < p.row_count; ++n) {
                assert_true(area_of(&p, &p.rows[n], true) >=
                            area_of(&p, &p.rows[n], false) - 1e-11);
                assert_true(p.rows[n].lambda >= 0);
            }
        if (trial % 3 != 0) assert_true(energy_error(&p) < 1e-13);
        assert_true(momentum_error(&p) < 1e-13);
        unconverged += p.outcome.unconverged;
        release(&p);
    }
    print_message("%d of 2000 not converged\n", unconverged);
    assert_true(unconverged <= 20);
}

/* A particle between a moving plane and a body's edge, and one that is alone with a circle. */
static void walls_push_what_they_meet(void **state)
{
    (void)state;
    problem p = with_room(4, 3);
    const int i = add_end(&p, (fw_vec2){0.5, 0.1}, (fw_vec2){0, 0}, fw_sym2_scalar(1));
    const int j = add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(0.5));
    const int k = add_end(&p, (fw_vec2){1, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(0.5));
    const int l = add_end(&p, (fw_vec2){7, 5}, (fw_vec2){-0.2, 0.7}, fw_sym2_scalar(0.5));
    add_segment(&p, i, j, k);
    p.rows[p.row_count++] = (fw_joint_row){
        .kind = FW_JOINT_PLANE, .end = {i}, .normal = {0, -1}, .motion = {3, -0.25}, .fresh = true};
    p.rows[p.row_count++] = (fw_joint_row){
        .kind = FW_JOINT_ROUND, .end = {l}, .centre = {7, 2}, .inside = true, .fresh = true};
    solve(&p);
    assert_int_equal(p.outcome.unconverged, 0);
    assert_int_equal(p.outcome.islands, 2);
    assert_true(fabs(p.ends[i].displacement.y + 0.25) < 1e-13);
    assert_true(fabs(area_of(&p, &p.rows[0], true) - area_of(&p, &p.rows[0], false)) < 1e-8);
    assert_true(p.ends[j].force.y < 0 && p.ends[k].force.y < 0);
    const fw_vec2 from =
        fw_vec2_subtract(fw_vec2_add(p.ends[l].position, p.ends[l].displacement), (fw_vec2){7, 2});
    assert_true(fabs(hypot(from.x, from.y) - 3) < 1e-12);
    assert_true(fabs(fw_vec2_dot(p.ends[l].force, p.ends[l].displacement)) < 1e-14);
    release(&p);
}

/* Two chains that meet end to end exchange what their ends have. */
static void equal_points_swap(void **state)
{
    (void)state;
    problem p = with_room(2, 1);
    add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0.1, 0}, fw_sym2_scalar(1));
    add_end(&p, (fw_vec2){0.04, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(1));
    p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_POINT, .end = {1, 0}, .fresh = true};
    solve(&p);
    assert_true(fabs(p.ends[0].displacement.x - 0.05) < 1e-15);
    assert_true(fabs(p.ends[1].displacement.x - 0.05) < 1e-15);
    assert_true(energy_error(&p) < 1e-16);
    release(&p);
}

/* Two planes that close on a particle leave it no way: that is counted. */
static void what_has_no_way_is_counted(void **state)
{
    (void)state;
    problem p = with_room(1, 2);
    add_end(&p, (fw_vec2){0, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(1));
    for (int n = 0; n < 2; ++n)
        p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_PLANE,
                                               .end = {0},
                                               .normal = {0, n == 0 ? 1 : -1},
                                               .motion = {0, n == 0 ? 0.1 : -0.1},
                                               .fresh = true};
    solve(&p);
    assert_int_equal(p.outcome.unconverged, 1);
    release(&p);
}

/* Each of 1000 particles slides on a plane of its own direction: it bears its limit to the last bit
 * and is not taken for one that sticks. */
static void what_slides_bears_its_limit_to_the_last_bit(void **state)
{
    (void)state;
    problem p = with_room(1000, 1000);
    for (int n = 0; n < 1000; ++n) {
        const double angle = 3.2 * random_of(6, 3 * n);
        const fw_vec2 normal = {-sin(angle), cos(angle)}, along = {cos(angle), sin(angle)};
        const fw_vec2 free =
            fw_vec2_add(fw_vec2_scale(-0.1 - fabs(random_of(6, 3 * n + 1)), normal), along);
        add_end(&p, (fw_vec2){0, 0}, free, fw_sym2_scalar(1.0 / 3));
        p.ends[n].inertial = free;
        p.rows[p.row_count++] = (fw_joint_row){
            .kind = FW_JOINT_PLANE,
            .end = {n},
            .normal = normal,
            .rub = {.coefficient = 0.1 + fabs(random_of(6, 3 * n + 2)) / 10, .before = 0.1},
            .fresh = true};
    }
    solve(&p);
    for (int n = 0; n < 1000; ++n) {
        assert_true(fabs(p.rows[n].rub.slip) > 0.1);
        assert_true(fabs(p.rows[n].rub.traction) == p.rows[n].rub.limit);
        assert_false(p.rows[n].rub.stuck);
    }
    release(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_faces_meet_at_any_offset),
        cmocka_unit_test(small_faces_meet_at_any_offset),
        cmocka_unit_test(rows_that_stand_twice_change_nothing),
        cmocka_unit_test(no_point_comes_nearer_to_the_segment_that_holds_it),
        cmocka_unit_test(walls_push_what_they_meet),
        cmocka_unit_test(equal_points_swap),
        cmocka_unit_test(what_has_no_way_is_counted),
        cmocka_unit_test(what_slides_bears_its_limit_to_the_last_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
