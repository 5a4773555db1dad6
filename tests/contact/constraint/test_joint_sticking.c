/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What sticking lets through of many particles that rub: nothing of a swing that is small beside
 * the load, and nothing of all where rows would want different slips of one end. */
#include "tests/support/joint_problems.h"

/* A particle that a load would take along by .01, and that sticks: of a change c of its own
 * momentum e c/4 passes, e = .343, if that is more than 1e-4 of .01, and else nothing. */
static void what_swings_by_little_is_held(void **state)
{
    (void)state;
    for (int way = -1; way <= 1; way += 2)
        for (double change = 1e-6; change < 1e-3; change *= 3) {
            problem p = with_room(1, 1);
            const double passes = 0.343 / 4 * change;
            add_end(&p, (fw_vec2){0, 0}, (fw_vec2){way * (0.01 + change), -0.1}, fw_sym2_scalar(1));
            p.ends[0].inertial = (fw_vec2){way * change, -0.1};
            p.rows[p.row_count++] = (fw_joint_row){.kind = FW_JOINT_PLANE,
                                                   .end = {0, -1},
                                                   .normal = {0, 1},
                                                   .rub = {.coefficient = 1, .stuck_before = true},
                                                   .fresh = true};
            solve_with(&p, NULL);
            assert_true(p.rows[0].rub.stuck);
            const double expected = passes > 1e-6 ? way * passes : 0;
            assert_true(fabs(p.ends[0].displacement.x - expected) < 1e-16);
            release(&p);
        }
}

/* Points above a segment that rests, and of that on the segments between them, as where two faces
 * meet: more rows rub than ends can move. The last end is the ground. */
static problem two_faces(uint64_t seed)
{
    const int count = 3 + (int)(seed % 8);
    const double load = 0.01 * (1 + 2 * random_of(seed, 0));
    problem p = with_room(count + 1, 2 * count);
    for (int n = 0; n < count; ++n) {
        const fw_vec2 free = {load * (1 + random_of(seed, 50 + n)), -0.1};
        add_end(&p, (fw_vec2){n, 0}, free, fw_sym2_scalar(0.25));
        p.ends[n].inertial = (fw_vec2){0.008 * random_of(seed, 80 + n), -0.1};
    }
    p.end_count += 1;
    for (int n = 0; n < 2 * count - 1; ++n) {
        const int point = n / 2;
        const bool above = n % 2 == 0;
        p.rows[p.row_count++] = (fw_joint_row){
            .kind = FW_JOINT_SEGMENT,
            .end = {above ? point : count, above ? count : point + 1, above ? count : point},
            .offset = {{above ? 0 : point + 0.4, 0}, {above ? -20 : 0, 0}, {above ? 20 : 0, 0}},
            .rub = {.coefficient = 0.3,
                    .before = 0.4 * (1 + 2 * random_of(seed, 100 + point + 20 * !above)),
                    .stuck_before = random_of(seed, 120 + point) > -0.25,
                    .inertial_before = -0.008 * random_of(seed, 80 + point)},
            .fresh = true};
    }
    return p;
}

/* What is at its limit, and moves with what sticking lets through, holds; and so do the others, or
 * two of these would not settle. */
static void rows_that_share_ends_hold_together(void **state)
{
    (void)state;
    int firm = 0;
    for (uint64_t seed = 1400; seed < 1640; ++seed) {
        problem p = two_faces(seed);
        solve_with(&p, NULL);
        assert_int_equal(p.outcome.unconverged, 0);
        for (int n = 0; n < p.row_count; ++n) {
            assert_true(fabs(p.rows[n].rub.traction) <= fw_joint_cone(&p.rows[n]) * (1 + 1e-9));
            firm += p.rows[n].rub.firm;
        }
        release(&p);
    }
    assert_true(firm > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_swings_by_little_is_held),
        cmocka_unit_test(rows_that_share_ends_hold_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
