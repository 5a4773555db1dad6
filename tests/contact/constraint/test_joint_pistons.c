/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows that many particles share with walls that yield: momentum and energy, few rows or many. */
#include "tests/support/joint_problems.h"

/* A piston: an end that many rows share. */
static int add_wide(problem *p, fw_vec2 position, fw_vec2 free, fw_sym2 mobility)
{
    const int end = add_end(p, position, free, mobility);
    p->ends[end].wide = true;
    return end;
}

static fw_joint_row *add_plane(problem *p, int particle, int piston, fw_vec2 normal)
{
    fw_joint_row *row = &p->rows[p->row_count++];
    *row = (fw_joint_row){.kind = FW_JOINT_PLANE,
                          .end = {particle, piston},
                          .normal = normal,
                          .borne = piston >= 0,
                          .fresh = true};
    return row;
}

static void solve(problem *p, const fw_joint_springs *springs)
{
    solve_with(p, springs);
    assert_int_equal(p->outcome.unconverged, 0);
}

/* Forces add up to zero, do no work, and no row is passed nor pulls. */
static void assert_solved(const problem *p)
{
    fw_vec2 sum = {0, 0};
    double work = 0, size = 0, force = 0;
    for (int e = 0; e < p->end_count; ++e) {
        const fw_joint_end *end = &p->ends[e];
        const fw_vec2 w = fw_vec2_add(end->free, fw_sym2_apply(end->mobility, end->force));
        assert_true(fabs(w.x - end->displacement.x) + fabs(w.y - end->displacement.y) < 1e-13);
        sum = fw_vec2_add(sum, end->force);
        work += fw_vec2_dot(end->force, end->displacement);
        size += fabs(end->force.x * end->free.x) + fabs(end->force.y * end->free.y);
        force += fabs(end->force.x) + fabs(end->force.y);
    }
    for (int n = 0; n < p->row_count; ++n) {
        const fw_joint_row *row = &p->rows[n];
        const double gap = fw_joint_motion(row, p->ends) - row->bound;
        assert_true(row->lambda >= 0 || row->both);
        assert_true(gap >= -1e-13 && (!row->both || gap <= 1e-13));
    }
    assert_true(fabs(sum.x) + fabs(sum.y) <= 1e-13 * force);
    assert_true(fabs(work) <= 1e-13 * size);
}

/* A piston takes n particles along: all have the velocity of their common momentum. */
static void a_piston_and_what_it_hits_move_as_one(void **state)
{
    (void)state;
    const int counts[] = {1, 2, 29, 31, 400, 3000};
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; ++c) {
        const int count = counts[c];
        const double light = 0.25, heavy = 0.003;
        problem p = with_room(count + 1, count);
        const int piston =
            add_wide(&p, (fw_vec2){0, 0}, (fw_vec2){0.2, -0.1}, (fw_sym2){0, 0, heavy});
        for (int n = 0; n < count; ++n) {
            const int end = add_end(&p, (fw_vec2){n, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(light));
            add_plane(&p, end, piston, (fw_vec2){0, -1});
        }
        solve(&p, NULL);
        assert_solved(&p);
        const double expected = -0.1 / heavy / (1 / heavy + count / light);
        assert_true(fabs(p.ends[piston].displacement.y - expected) < 1e-14);
        assert_true(p.ends[piston].displacement.x == 0.2);
        release(&p);
    }
}

/* Bodies' edges between two pistons, with particles of any mobility, some of which are held both
 * ways; each particle on one of the pistons, on both, or on its neighbours. */
static void particles_between_pistons_keep_energy_and_momentum(void **state)
{
    (void)state;
    for (int trial = 0; trial < 400; ++trial) {
        const uint64_t seed = (uint64_t)trial;
        const int count = 2 + (trial % 4 == 3 ? 5 * trial % 331 : trial % 40);
        problem p = with_room(2 * count + 2, 5 * count);
        const int above = add_wide(&p, (fw_vec2){0, 2}, (fw_vec2){0.1 * random_of(seed, 1), -0.1},
                                   fw_sym2_scalar(exp(4 * random_of(seed, 2) - 3)));
        const int below = add_wide(&p, (fw_vec2){0, -1}, (fw_vec2){0, 0.05},
                                   fw_sym2_scalar(exp(4 * random_of(seed, 3) - 3)));
        for (int n = 0; n < 2 * count; ++n) {
            const double a = 0.6 + random_of(seed, 200 + n), c = 0.6 + random_of(seed, 3000 + n);
            const fw_sym2 mobility = {a, 0.5 * sqrt(a * c) * random_of(seed, 6000 + n), c};
            add_end(&p, (fw_vec2){n % count + 0.3 * (n / count), n / count},
                    (fw_vec2){0.1 * random_of(seed, 9000 + n), 0.2 * random_of(seed, 12000 + n)},
                    mobility);
        }
        for (int n = 0; n < count; ++n) {
            const double tilt = 0.2 * random_of(seed, 15000 + n);
            const fw_vec2 down = {sin(tilt), -cos(tilt)};
            add_plane(&p, 2 + count + n, above, down);
            add_plane(&p, 2 + n, below, fw_vec2_scale(-1, down));
            if (trial % 3 == 1) add_plane(&p, 2 + n, below, fw_vec2_turn(down))->both = true;
            if (n > 0 && trial % 2 == 1)
                p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_SEGMENT,
                                                       .end = {2 + count + n - 1, 1 + n, 2 + n},
                                                       .fresh = true};
            if (trial % 5 == 0) add_plane(&p, 2 + n, above, down);
        }
        solve(&p, NULL);
        assert_solved(&p);
        release(&p);
    }
}

/* A foil has no way out between a piston and a floor, and stops the piston. */
static void a_foil_on_a_floor_stops_the_piston(void **state)
{
    (void)state;
    for (int count = 1; count < 200; count += 33) {
        problem p = with_room(count + 1, 2 * count);
        const int piston = add_wide(&p, (fw_vec2){0, 0}, (fw_vec2){0, -0.3}, fw_sym2_scalar(0.1));
        for (int n = 0; n < count; ++n) {
            const int end = add_end(&p, (fw_vec2){n, 0}, (fw_vec2){0, 0.001}, fw_sym2_scalar(0.5));
            add_plane(&p, end, piston, (fw_vec2){0, -1});
            add_plane(&p, end, -1, (fw_vec2){0, 1});
        }
        solve(&p, NULL);
        assert_true(fabs(p.ends[piston].displacement.y) < 1e-14);
        assert_true(fabs(p.ends[piston].force.y - 3) < 1e-13);
        release(&p);
    }
}

/* A spring between the piston, as deep as it is pressed, and a particle before it. */
static fw_vec2 push_up(void *context, int row, fw_vec2 relative, double *slope)
{
    (void)context;
    (void)row;
    const double depth = -relative.y;
    *slope = 0.5;
    return (fw_vec2){0, depth > 0 ? 0.5 * depth : 0};
}

static fw_vec2 freely(void *context, int end, fw_vec2 displacement)
{
    (void)displacement;
    return ((const problem *)context)->ends[end].free;
}

static double not_at_all(void *context, int end)
{
    (void)context;
    (void)end;
    return 0;
}

/* Of n springs in parallel the piston feels n times the stiffness, softened by what they push. */
static void springs_give_way_together(void **state)
{
    (void)state;
    for (int count = 1; count < 100; count += 20) {
        const double mass = 0.1, light = 0.7;
        problem p = with_room(count + 1, count);
        const fw_joint_springs springs = {freely, not_at_all, push_up, &p};
        const int piston = add_wide(&p, (fw_vec2){0, 0}, (fw_vec2){0, 0.2}, fw_sym2_scalar(mass));
        for (int n = 0; n < count; ++n) {
            const int end = add_end(&p, (fw_vec2){n, 0}, (fw_vec2){0, 0}, fw_sym2_scalar(light));
            p.rows[p.row_count++] =
                (fw_joint_row){.kind = FW_JOINT_SPRING, .end = {end, piston}, .fresh = true};
        }
        solve(&p, &springs);
        /* F = (W - w)/2, w = light F, W = .2 - mass n F */
        const double force = 0.2 / (2 + light + mass * count);
        assert_true(fabs(p.ends[1].force.y - force) < 1e-14);
        assert_true(fabs(p.ends[piston].force.y + count * force) < 1e-13);
        release(&p);
    }
}

/* Two pistons touch at so many points, none of which gives way by itself: what pushes one along the
 * other stays within the cones of all together, and slips by rounding. */
static void pistons_that_rub_hold_to_rounding(void **state)
{
    (void)state;
    for (int trial = 0; trial < 200; ++trial) {
        const uint64_t seed = 9000 + (uint64_t)trial;
        const int points = 4 + trial % 16;
        const double push = 0.2 + 0.1 * random_of(seed, 0), load = 0.6 + 0.4 * random_of(seed, 1);
        const fw_vec2 none = {0, 0};
        problem p = with_room(2, points);
        const int upper =
            add_wide(&p, none, (fw_vec2){0.02 * push * load, -0.02 * load}, fw_sym2_scalar(0.02));
        const int lower = add_wide(&p, none, none, fw_sym2_scalar(0.05 * (trial % 2)));
        for (int n = 0; n < points; ++n)
            add_plane(&p, upper, lower, (fw_vec2){0, 1})->rub =
                (fw_joint_rub){.coefficient = 0.3,
                               .before = 2 * load * (1 + random_of(seed, 2 + n)) / points,
                               .stuck_before = true};
        solve(&p, NULL);
        for (int n = 0; n < points; ++n) {
            const fw_joint_rub *rub = &p.rows[n].rub;
            assert_true(fabs(rub->slip) <= 1e-15 * load);
            assert_true(fabs(rub->traction) <= rub->limit * (1 + 1e-12));
        }
        release(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_piston_and_what_it_hits_move_as_one),
        cmocka_unit_test(particles_between_pistons_keep_energy_and_momentum),
        cmocka_unit_test(a_foil_on_a_floor_stops_the_piston),
        cmocka_unit_test(springs_give_way_together),
        cmocka_unit_test(pistons_that_rub_hold_to_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
