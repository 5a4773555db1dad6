/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scene_record.c - what contact has done to each particle adds up to what the ledgers say, and
 * its forces are reactions, free of the mode that is held. */
#include "tests/support/scenes.h"

static const int COLUMNS = 8, ROWS = 4;

static fw_vec2 sum_of_forces(const fw_scene *scene, int body)
{
    const int count = fw_scene_observe_body(scene, body)->count;
    double x[64] = {0}, y[64] = {0};
    fw_vec2 sum = {0, 0};
    fw_scene_add_contact_forces(scene, body, x, y);
    for (int i = 0; i < count; ++i) sum = fw_vec2_add(sum, (fw_vec2){x[i], y[i]});
    return sum;
}

static double sum_of_field(const fw_scene *scene, int body, const char *name, bool lower_half)
{
    const int count = fw_scene_observe_body(scene, body)->count;
    const fw_contact_field *field = fw_scene_find_field(scene, body, name);
    double values[64], sum = 0;
    if (!field) fail_msg("body %d has no field %s", body, name);
    fw_scene_fill_field(scene, body, field, values);
    for (int i = 0; i < count; ++i)
        if (!lower_half || i < count / 2) sum += values[i];
    return sum;
}

static void push(fw_scene *scene, int body, fw_vec2 force)
{
    int all[64];
    const int count = fw_scene_observe_body(scene, body)->count;
    for (int i = 0; i < count; ++i) all[i] = i;
    const fw_load_def def = {.kind = FW_LOAD_TOTAL,
                             .particles = all,
                             .particle_count = count,
                             .vector = force,
                             .until = INT64_MAX};
    must(fw_scene_add_load(scene, body, &def, &error));
}

static void grip_row(fw_scene *scene, int body, int row, fw_drive drive)
{
    int particles[8];
    for (int i = 0; i < COLUMNS; ++i) particles[i] = row * COLUMNS + i;
    const fw_grip_def def = {.name = body == 0 ? "below" : "above",
                             .particles = particles,
                             .particle_count = COLUMNS,
                             .drive = drive};
    must(fw_scene_add_grip(scene, body, &def, &error));
}

static void add_floor(fw_scene *scene, double friction)
{
    const fw_vec2 corners[] = {{-50, 0}, {50, 0}};
    fw_wall_def floor = fw_wall_def_default();
    floor.name = "floor";
    floor.shape = FW_CHAIN;
    floor.points = corners;
    floor.point_count = 2;
    floor.surface = (fw_surface){.law = FW_COULOMB, .friction = friction};
    must(fw_scene_add_wall(scene, &floor, &error));
}

/* A block that rests on a floor, and another one on it. */
static fw_scene *stack(double floor_friction, double friction, fw_vec2 force)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = COLUMNS, .rows = ROWS, .mu = .9});
    add_body(scene,
             (body_options){.columns = COLUMNS, .rows = ROWS, .origin = {.3, ROWS - 1}, .mu = .9});
    add_floor(scene, floor_friction);
    push(scene, 1, force);
    fw_scene_set_friction(scene, friction);
    begin(scene);
    return scene;
}

/* A block falls on a floor and is pressed there until it rests: the forces of its lowest row add up
 * to the load, of two steps together in each of them, of one alone in none. */
static void reactions_do_not_alternate(void **state)
{
    (void)state;
    for (int keeps = 0; keeps < 2; ++keeps) {
        fw_scene *scene = empty_scene(1e4);
        add_floor(scene, 0);
        add_body(
            scene,
            (body_options){
                .columns = 12, .rows = 5, .origin = {0, .13}, .velocity = {0, -.1}, .mu = .95});
        push(scene, 0, (fw_vec2){0, -.2});
        if (keeps) fw_scene_keep_forces(scene);
        begin(scene);
        run(scene, 3000);
        double most = 0;
        for (int t = 0; t < 6; ++t) {
            run(scene, 1);
            most = fmax(most, fabs(sum_of_forces(scene, 0).y - .2));
        }
        if (keeps)
            assert_close(most, 0, 1e-9);
        else
            assert_true(most > .01);
        fw_scene_destroy(scene);
    }
}

/* A ball that bounces on a rough floor is touched in some steps: the mean of what it gained in the
 * last two, also where it has left the floor meanwhile. */
static void forces_are_the_mean_of_two_steps(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_floor(scene, .3);
    add_body(scene, (body_options){.columns = 1,
                                   .rows = 1,
                                   .origin = {0, .53},
                                   .velocity = {.3, -.1},
                                   .mu = 1,
                                   .rest_mass = 1});
    fw_scene_keep_forces(scene);
    begin(scene);
    fw_vec2 before = {0, 0}, momentum = fw_scene_momentum(scene);
    int left = 0;
    for (int t = 0; t < 30; ++t) {
        run(scene, 1);
        const fw_vec2 now = fw_vec2_subtract(fw_scene_momentum(scene), momentum);
        const fw_vec2 force = sum_of_forces(scene, 0);
        assert_close(force.x, .5 * (now.x + before.x), 1e-15);
        assert_close(force.y, .5 * (now.y + before.y), 1e-15);
        left += fabs(before.x) > 1e-3 && fabs(now.x) < 1e-12;
        before = now;
        momentum = fw_scene_momentum(scene);
    }
    assert_true(left > 0);
    fw_scene_destroy(scene);
}

static void heat_of_all_particles_is_that_of_the_ledger(void **state)
{
    (void)state;
    for (int slides_below = 0; slides_below < 2; ++slides_below) {
        fw_scene *scene = slides_below ? stack(0.1, 0.6, (fw_vec2){.05, -.2})
                                       : stack(0.9, 0.2, (fw_vec2){.06, -.2});
        run(scene, 600);
        const double heat = fw_scene_ledger(scene).friction_heat;
        const double below = sum_of_field(scene, 0, FW_FIELD_HEAT, false);
        const double above = sum_of_field(scene, 1, FW_FIELD_HEAT, false);
        assert_true(heat > 1e-3);
        assert_close(below + above, heat, 1e-12 * heat);
        /* Between bodies half of it comes to either. */
        assert_close(above, .5 * fw_scene_contact_ledger(scene)->heat, 1e-12 * heat);
        /* The wall's comes to the lower rows of the block on it. */
        const double bottom = sum_of_field(scene, 0, FW_FIELD_HEAT, true);
        assert_close(bottom, fw_scene_wall_ledger(scene, 0)->dissipated, 1e-12 * heat);
        if (slides_below)
            assert_true(bottom > .9 * heat);
        else
            assert_true(bottom < .1 * heat);
        fw_scene_destroy(scene);
    }
}

static void what_slides_is_told_from_what_sticks(void **state)
{
    (void)state;
    fw_scene *scene = stack(0.9, 0.2, (fw_vec2){.06, -.2});
    run(scene, 600);
    const double bottom = sum_of_field(scene, 0, FW_FIELD_RUBBING, true);
    const double slid_below = sum_of_field(scene, 0, FW_FIELD_SLIDING, true);
    const double top = sum_of_field(scene, 1, FW_FIELD_RUBBING, false);
    const double slid_above = sum_of_field(scene, 1, FW_FIELD_SLIDING, false);
    assert_true(bottom > 600 && top > 600);
    assert_true(slid_below < .3 * bottom);
    assert_true(slid_above > .7 * top);
    fw_scene_destroy(scene);
}

/* Where faces stick the points of one may be at their bound while those of the other hold the
 * place: it slides where all of its rows do. */
static void a_place_that_anything_holds_sticks(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = COLUMNS, .rows = ROWS, .mu = .9});
    add_body(scene,
             (body_options){
                 .columns = COLUMNS, .rows = ROWS, .origin = {.5, ROWS - 1 + .001}, .mu = .9});
    grip_row(scene, 0, 0, (fw_drive){.prescribed_x = true, .prescribed_y = true});
    /* To and fro: it slides, and sticks where it has turned. */
    grip_row(scene, 1, ROWS - 1,
             (fw_drive){.prescribed_x = true,
                        .path = {.amplitude = {.1, 0}, .period = 2000, .until = INFINITY},
                        .force = {0, -.2}});
    fw_scene_set_friction(scene, 0.3);
    begin(scene);
    run(scene, 1550);
    double rubbing = sum_of_field(scene, 1, FW_FIELD_RUBBING, false);
    double slid = sum_of_field(scene, 1, FW_FIELD_SLIDING, false);
    run(scene, 150);
    rubbing = sum_of_field(scene, 1, FW_FIELD_RUBBING, false) - rubbing;
    slid = sum_of_field(scene, 1, FW_FIELD_SLIDING, false) - slid;
    assert_true(rubbing > 1000);
    assert_close(slid, 0, 0);
    fw_scene_destroy(scene);
}

static void nothing_is_recorded_where_nothing_rubs(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 4, .rows = 3});
    begin(scene);
    assert_null(fw_scene_find_field(scene, 0, FW_FIELD_HEAT));
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reactions_do_not_alternate),
        cmocka_unit_test(forces_are_the_mean_of_two_steps),
        cmocka_unit_test(heat_of_all_particles_is_that_of_the_ledger),
        cmocka_unit_test(what_slides_is_told_from_what_sticks),
        cmocka_unit_test(a_place_that_anything_holds_sticks),
        cmocka_unit_test(nothing_is_recorded_where_nothing_rubs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
