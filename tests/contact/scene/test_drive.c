/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_drive.c - drives by hand, in either component, and what grips and pistons report of them:
 * each measure against the drive's own force, alone. Balances of energy do not see these, since
 * what is wrong in one place is absorbed in another. */
#include "tests/support/pistons.h"

#include "contact/scene/drive.h"

/* D = force + amplitude sin(2 pi (t - origin)/period + phase) - k (u + w/2). */
static const fw_drive swung = {.force = {3, -2},
                               .amplitude = {0.5, 4},
                               .period = 8,
                               .phase = 0.25,
                               .origin = 5,
                               .tether = {0.7, 1.3}};
static const fw_vec2 away = {0.4, -0.6}, step_of_it = {0.1, 0.2};

static void the_force_of_a_drive_is_that_by_hand(void **state)
{
    (void)state;
    const double swing = sin(2 * M_PI * 2 / 8 + 0.25);
    const fw_vec2 oscillation = fw_drive_oscillation(&swung, 7);
    assert_close(oscillation.x, 0.5 * swing, 1e-15);
    assert_close(oscillation.y, 4 * swing, 1e-15);
    const fw_vec2 force = fw_drive_force(&swung, away, step_of_it, 7);
    assert_close(force.x, 3 + 0.5 * swing - 0.7 * 0.45, 1e-15);
    assert_close(force.y, -2 + 4 * swing - 1.3 * -0.5, 1e-15);
    fw_drive held = swung;
    held.prescribed_x = true;
    assert_close(fw_drive_force(&held, away, step_of_it, 7).x, 0, 0);
    assert_close(fw_drive_force(&held, away, step_of_it, 7).y, force.y, 0);
}

/* inertia w = push + D(w), in both components, with an inertia that couples them; and as
 * prescribed where it is. */
static void the_motion_of_a_drive_solves_its_equation(void **state)
{
    (void)state;
    const fw_sym2 inertia = {5, 0.6, 4};
    const fw_vec2 push = {0.3, -0.8};
    for (int held = 0; held < 4; ++held) {
        fw_drive drive = swung;
        drive.prescribed_x = held & 1;
        drive.prescribed_y = held & 2;
        drive.path = (fw_path){.velocity = {0.25, -0.5}, .until = INFINITY};
        const fw_vec2 w = fw_drive_solve(&drive, inertia, push, away, 7, 0.1);
        const fw_vec2 force = fw_drive_force(&drive, away, w, 7);
        if (held & 1)
            assert_close(w.x, 0.025, 1e-15);
        else
            assert_close(5 * w.x + 0.6 * w.y, 0.3 + force.x, 1e-14);
        if (held & 2)
            assert_close(w.y, -0.05, 1e-15);
        else
            assert_close(0.6 * w.x + 4 * w.y, -0.8 + force.y, 1e-14);
    }
}

/* What a path prescribes in a tick is its way from the tick's beginning to its end. */
static void a_path_is_followed_tick_by_tick(void **state)
{
    (void)state;
    const fw_drive drive = {.prescribed_x = true,
                            .prescribed_y = true,
                            .origin = 2,
                            .path = {.amplitude = {1, -2}, .period = 10, .until = INFINITY}};
    const fw_sym2 inertia = fw_sym2_scalar(1);
    fw_vec2 sum = {0, 0};
    for (int tick = 0; tick < 25; ++tick) {
        const double time = 2 + 0.1 * tick;
        sum = fw_vec2_add(sum, fw_drive_solve(&drive, inertia, (fw_vec2){0, 0}, sum, time, 0.1));
    }
    const fw_vec2 quarter = fw_path_displacement(&drive.path, 2.5);
    assert_close(fabs(quarter.x), 1, 1e-14);
    assert_close(sum.x, quarter.x, 1e-14);
    assert_close(sum.y, -2 * quarter.x, 1e-14);
}

/* --- what a grip reports --- */

typedef struct grip_step {
    fw_vec2 total, step;
    double torque;
} grip_step;

/* One step, and what its forces are together, as the body has felt them. */
static grip_step advance_grip(fw_scene *scene, const int *held, int count)
{
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    const fw_grip_ledger *ledger = fw_grip_observe_ledger(fw_scene_observe_grip(scene, 0));
    const fw_vec2 before = ledger->displacement;
    double x[64] = {0}, y[64] = {0};
    fw_vec2 centre = {0, 0}, place[8];
    for (int n = 0; n < count; ++n) {
        place[n] = fw_solid_position(solid, held[n]);
        centre = fw_vec2_add(centre, fw_vec2_scale(1. / count, place[n]));
    }
    run(scene, 1);
    fw_scene_add_contact_forces(scene, 0, x, y);
    grip_step found = {.step = fw_vec2_subtract(ledger->displacement, before)};
    for (int n = 0; n < count; ++n) {
        const int l = held[n];
        found.total = fw_vec2_add(found.total, (fw_vec2){x[l], y[l]});
        found.torque += (place[n].x - centre.x) * y[l] - (place[n].y - centre.y) * x[l];
    }
    return found;
}

/* Two columns of a sheet that flies and turns, pulled by all that a drive has: every number of the
 * ledger against the forces on the particles, and these against the drive. */
static void the_ledger_of_a_grip_is_that_of_its_forces(void **state)
{
    (void)state;
    static const int held[] = {0, 1, 7, 8, 9};
    fw_scene *scene = empty_scene(1e6);
    fw_drive drive = swung;
    drive.force = (fw_vec2){0.03, -0.02};
    drive.amplitude = (fw_vec2){0.02, 0.5};
    drive.tether = (fw_vec2){0.02, 0.05};
    const fw_grip_def def = {
        .name = "hand", .particles = held, .particle_count = 5, .drive = drive};
    add_sheet(scene, 6, 5, (fw_vec2){0.01, -0.02}, 0, 1);
    must(fw_scene_add_grip(scene, 0, &def, &error));
    begin(scene);
    const fw_grip_ledger *ledger = fw_grip_observe_ledger(fw_scene_observe_grip(scene, 0));
    fw_vec2 last = {0, 0}, impulse = {0, 0}, way = {0, 0};
    double work = 0;
    for (int t = 0; t < 60; ++t) {
        const fw_vec2 u = ledger->displacement;
        const grip_step now = advance_grip(scene, held, 5);
        const fw_vec2 wanted = fw_drive_force(&drive, u, now.step, t);
        assert_close(now.total.x, wanted.x, 1e-13);
        assert_close(now.total.y, wanted.y, 1e-13);
        impulse = fw_vec2_add(impulse, now.total);
        work += fw_vec2_dot(now.total, now.step);
        way = fw_vec2_add(way, (fw_vec2){fabs(now.step.x), fabs(now.step.y)});
        assert_close(ledger->force.x, now.total.x, 1e-15);
        assert_close(ledger->force.y, now.total.y, 1e-15);
        assert_close(ledger->reaction.x, .5 * (now.total.x + last.x), 1e-15);
        assert_close(ledger->reaction.y, .5 * (now.total.y + last.y), 1e-15);
        assert_close(ledger->torque, now.torque, 1e-14);
        assert_close(ledger->impulse.x, impulse.x, 1e-14);
        assert_close(ledger->impulse.y, impulse.y, 1e-14);
        assert_close(ledger->work, work, 1e-14);
        assert_close(ledger->path_length.x, way.x, 1e-13);
        assert_close(ledger->path_length.y, way.y, 1e-13);
        last = now.total;
    }
    assert_true(fabs(ledger->torque) > 1e-6);
    assert_true(way.y > 1.1 * fabs(ledger->displacement.y));
    fw_scene_destroy(scene);
}

/* --- what a piston reports --- */

/* Alone, nothing pushes it: its force is the drive's, and nothing is unmatched. */
static void the_ledger_of_a_piston_is_that_of_its_drive(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 3, .velocity = {0.1, 0.3}, .drive = swung};
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "block", (fw_vec2){500, 500}, (fw_vec2){501, 501}, smooth, &def);
    begin(scene);
    fw_vec2 last = {0, 0}, way = {0, 0};
    double work = 0;
    for (int t = 0; t < 60; ++t) {
        const fw_piston_ledger before = *ledger_of(scene, 0);
        run(scene, 1);
        const fw_piston_ledger *a = ledger_of(scene, 0);
        const fw_vec2 w = fw_vec2_subtract(a->displacement, before.displacement);
        const fw_vec2 force = fw_drive_force(&swung, before.displacement, w, t);
        way = fw_vec2_add(way, (fw_vec2){fabs(w.x), fabs(w.y)});
        work += fw_vec2_dot(force, w);
        assert_close(a->force.x, force.x, 1e-12);
        assert_close(a->force.y, force.y, 1e-12);
        assert_close(a->reaction.x, .5 * (force.x + last.x), 1e-12);
        assert_close(a->reaction.y, .5 * (force.y + last.y), 1e-12);
        assert_close(3 * (a->velocity.y - before.velocity.y), force.y, 1e-12);
        assert_close(a->work, work, 1e-10);
        assert_close(a->path_length.x, way.x, 1e-11);
        assert_close(a->path_length.y, way.y, 1e-11);
        assert_close(fabs(a->unmatched.x) + fabs(a->unmatched.y), 0, 1e-11);
        assert_close(a->unmatched_work, 0, 1e-11);
        last = force;
    }
    assert_true(way.y > 1.1 * fabs(ledger_of(scene, 0)->displacement.y));
    fw_scene_destroy(scene);
}

/* A push that does not fit the motion is booked as unmatched, by as much as it does not: at rest
 * and at a motion of 0, the drive alone would have been balanced by -force. */
static void a_push_that_does_not_fit_is_unmatched(void **state)
{
    (void)state;
    fw_piston *piston;
    const fw_piston_def def = {.mass = 2, .drive = {.force = {0.5, -3}}};
    must(fw_piston_create(&piston, "press", &def, &error));
    fw_piston_advance(piston, (fw_vec2){0, 0}, (fw_vec2){-0.5, 3.25}, (fw_vec2){0, 0}, 0, 0, 0,
                      0.1);
    const fw_piston_ledger *a = fw_piston_observe_ledger(piston);
    assert_close(a->unmatched.x, 0, 1e-15);
    assert_close(a->unmatched.y, 0.1 * 0.25, 1e-15);
    assert_close(a->pushed.y, 0.1 * 3.25, 1e-15);
    assert_close(a->velocity.y, 0, 1e-15);
    fw_piston_destroy(piston);
}

/* By its momentum alone a block goes on with the velocity of its sheet; what is held goes as it is
 * told, in each component by itself. */
static void a_grip_coasts_where_it_is_not_held(void **state)
{
    (void)state;
    static const int particles[] = {1, 2, 6};
    const fw_vec2 told = {.1, -.2};
    for (int held = 0; held < 4; ++held) {
        fw_scene *scene = empty_scene(100);
        add_body(scene, (body_options){.columns = 4, .rows = 3, .velocity = {.03, .04}, .mu = 1});
        const fw_grip_def def = {.name = "hand",
                                 .particles = particles,
                                 .particle_count = 3,
                                 .drive = {.prescribed_x = held & 1, .prescribed_y = held & 2}};
        fw_grip *grip;
        must(fw_grip_create(&grip, &def, &error));
        (void)fw_grip_displacement(grip, fw_scene_body(scene, 0), 0);
        const fw_vec2 inertial = fw_grip_inertial(grip, told);
        assert_close(inertial.x, held & 1 ? told.x : .03, 1e-14);
        assert_close(inertial.y, held & 2 ? told.y : .04, 1e-14);
        fw_grip_destroy(grip);
        fw_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_force_of_a_drive_is_that_by_hand),
        cmocka_unit_test(the_motion_of_a_drive_solves_its_equation),
        cmocka_unit_test(a_path_is_followed_tick_by_tick),
        cmocka_unit_test(the_ledger_of_a_grip_is_that_of_its_forces),
        cmocka_unit_test(the_ledger_of_a_piston_is_that_of_its_drive),
        cmocka_unit_test(a_push_that_does_not_fit_is_unmatched),
        cmocka_unit_test(a_grip_coasts_where_it_is_not_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
