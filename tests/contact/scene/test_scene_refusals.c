/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scene_refusals.c - what a scene does not take, when it is made and when a state is put back,
 * and what it says of it. */
#include "contact/scene/scene_parts.h"
#include "core/automaton/elastic_automaton.h"
#include "tests/support/pistons.h"
#include "tests/support/scratch.h"

/* --- drives --- */

static void every_number_of_a_drive_is_finite(void **state)
{
    (void)state;
    fw_drive drive = {.period = 1, .path = {.period = 1, .until = INFINITY}};
    double *const numbers[] = {&drive.force.x,          &drive.force.y,          &drive.amplitude.x,
                               &drive.amplitude.y,      &drive.period,           &drive.phase,
                               &drive.origin,           &drive.tether.x,         &drive.tether.y,
                               &drive.path.velocity.x,  &drive.path.velocity.y,  &drive.path.phase,
                               &drive.path.amplitude.x, &drive.path.amplitude.y, &drive.path.period,
                               &drive.path.from,        &drive.path.until};
    assert_fine(fw_drive_check(&drive, "grip", "hand", &error));
    for (size_t n = 0; n < sizeof numbers / sizeof numbers[0]; ++n) {
        const double right = *numbers[n];
        *numbers[n] = NAN;
        assert_refused(fw_drive_check(&drive, "grip", "hand", &error), FW_BAD_INPUT,
                       "grip hand: the drive has a number that is not finite");
        *numbers[n] = right;
    }
}

static void periods_and_tethers_are_not_negative(void **state)
{
    (void)state;
    const struct {
        fw_drive drive;
        const char *words;
    } bad[] = {{{.period = -1}, "period"},
               {{.path = {.period = -2}}, "period"},
               {{.tether = {-3, 0}}, "tether [-3, 0]"},
               {{.tether = {0, -4}}, "tether [0, -4]"}};
    for (size_t n = 0; n < sizeof bad / sizeof bad[0]; ++n)
        assert_refused(fw_drive_check(&bad[n].drive, "grip", "hand", &error), FW_BAD_INPUT,
                       bad[n].words);
}

/* At the start and where a phase changes it: what was there stays. */
static void what_drives_is_checked_each_time(void **state)
{
    (void)state;
    const fw_drive bad = {.period = -1}, fine = {.force = {1, 2}};
    const char *const words = ": period -1, expected 0 or more";
    const int held = 4;
    fw_scene *scene = empty_scene(100);
    add_sheet(scene, 3, 3, (fw_vec2){0, 0}, 1, 1);
    fw_grip_def hand = {.name = "hand", .particles = &held, .particle_count = 1, .drive = bad};
    assert_refused(fw_scene_add_grip(scene, 0, &hand, &error), FW_BAD_INPUT, words);
    assert_int_equal(fw_scene_grip_count(scene), 0);
    hand.drive = fine;
    assert_fine(fw_scene_add_grip(scene, 0, &hand, &error));
    assert_refused(fw_grip_set_drive(fw_scene_grip(scene, 0), &bad, &error), FW_BAD_INPUT, words);
    begin(scene);
    run(scene, 1);
    assert_close(fw_grip_observe_ledger(fw_scene_grip(scene, 0))->impulse.y, 2, 1e-15);
    fw_scene_destroy(scene);

    fw_piston *piston;
    const fw_piston_def def = {.mass = 1, .damping = 0.5, .drive = fine};
    assert_fine(fw_piston_create(&piston, "press", &def, &error));
    assert_refused(fw_piston_set_drive(piston, &bad, 0, &error), FW_BAD_INPUT, words);
    assert_refused(fw_piston_set_drive(piston, &fine, -2, &error), FW_BAD_INPUT,
                   "piston press: damping -2, expected 0 or more");
    fw_piston_destroy(piston);
}

static void a_piston_has_no_velocity_where_it_is_held(void **state)
{
    (void)state;
    fw_piston *piston;
    fw_piston_def def = {.mass = 1, .velocity = {0, 2}, .drive = {.prescribed_y = true}};
    assert_refused(fw_piston_create(&piston, "press", &def, &error), FW_BAD_INPUT,
                   "piston press: velocity [0, 2], expected 0 in a component that is held");
    def.velocity = (fw_vec2){0, INFINITY};
    assert_refused(fw_piston_create(&piston, "press", &def, &error), FW_BAD_INPUT, "finite");
    def.velocity = (fw_vec2){3, 0};
    assert_fine(fw_piston_create(&piston, "press", &def, &error));
    fw_piston_destroy(piston);
}

/* --- parts --- */

static fw_solid *automaton(void)
{
    fw_sites sites;
    assert_fine(fw_sites_rectangle(&sites, 3, 3, &error));
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.lattice.origin = (fw_vec2){50, 50};
    fw_solid *solid;
    assert_fine(fw_elastic_automaton_create(&solid, &def, &error));
    fw_sites_clear(&sites);
    return solid;
}

/* A sheet whose ticks take as long as is said. */
static fw_solid *sheet_of_tick(double tick)
{
    fw_sites sites;
    assert_fine(fw_sites_rectangle(&sites, 3, 3, &error));
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    fw_solid *solid;
    assert_fine(fw_lb_solid_create(&solid, &def, &error));
    fw_sites_clear(&sites);
    solid->tick = tick;
    return solid;
}

static void bodies_move_in_the_same_ticks(void **state)
{
    (void)state;
    int body;
    fw_scene *scene = empty_scene(100);
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 1, 1);
    assert_refused(fw_scene_adopt_body(scene, "slow", sheet_of_tick(2), &body, &error),
                   FW_BAD_INPUT, "body slow takes time steps of 2, expected 1");
    fw_solid *halves = automaton();
    halves->tick = 1;
    assert_refused(fw_scene_adopt_body(scene, "halves", halves, &body, &error), FW_BAD_INPUT,
                   "body halves moves in half-steps, one colour after the other, expected");
    assert_int_equal(fw_scene_body_count(scene), 1);
    fw_scene_destroy(scene);

    scene = empty_scene(100);
    assert_fine(fw_scene_adopt_body(scene, "halves", automaton(), &body, &error));
    assert_refused(fw_scene_adopt_body(scene, "whole", sheet_of_tick(0.5), &body, &error),
                   FW_BAD_INPUT, "body whole moves all at once, those before it in half-steps");
    fw_scene_destroy(scene);
}

static void each_particle_has_one_grip_and_each_grip_a_name(void **state)
{
    (void)state;
    static const int first[] = {70}, both[] = {5, 70}, second[] = {1, 2}, back[] = {4, 3},
                     twice[] = {3, 3};
    fw_scene *scene = empty_scene(100);
    add_sheet(scene, 9, 9, (fw_vec2){0, 0}, 1, 1);
    int body;
    fw_grip_def def = {.name = "hand", .particles = first, .particle_count = 1};
    assert_fine(fw_scene_add_grip(scene, 0, &def, &error));
    def.name = "other";
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip other holds particle 70 of body sheet, which another grip holds already");
    def.particles = both;
    def.particle_count = 2;
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip other holds particle 70 of body sheet, which another grip holds already");
    def.particles = second;
    def.particle_count = 0;
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip other holds no particles");
    def.particle_count = 2;
    def.particles = back;
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip other: particle 3 after 4");
    def.particles = twice;
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip other: particle 3 after 3");
    def.particles = second;
    def.name = "hand";
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "two grips are called hand");
    assert_int_equal(fw_scene_grip_count(scene), 1);
    for (int n = 1; n < FW_STATE_CAPACITY; ++n) {
        char name[24];
        snprintf(name, sizeof name, "grip %d", n);
        const fw_grip_def next = {.name = name, .particles = &n, .particle_count = 1};
        assert_fine(fw_scene_add_grip(scene, 0, &next, &error));
    }
    def = (fw_grip_def){.name = "last", .particles = (int[]){80}, .particle_count = 1};
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip last is one too many, expected at most 64");
    fw_scene_destroy(scene);

    scene = empty_scene(100);
    assert_fine(fw_scene_adopt_body(scene, "halves", automaton(), &body, &error));
    assert_refused(fw_scene_add_grip(scene, 0, &def, &error), FW_BAD_INPUT,
                   "grip last holds a body that moves in half-steps");
    fw_scene_destroy(scene);
}

static void pistons_are_walls_and_not_too_many(void **state)
{
    (void)state;
    static const fw_vec2 corners[] = {{0, 0}, {1, 1}}, flat[] = {{0, 0}, {1, 0}};
    fw_scene *scene = empty_scene(100);
    const fw_piston_def piston = {.mass = 1};
    fw_wall_def def = fw_wall_def_default();
    def.name = "ram";
    def.points = flat;
    assert_refused(fw_scene_add_piston(scene, &def, &piston, &error), FW_BAD_INPUT, "ram");
    assert_int_equal(fw_scene_wall_count(scene), 0);
    def.points = corners;
    for (int n = 0; n < FW_STATE_CAPACITY; ++n)
        assert_fine(fw_scene_add_piston(scene, &def, &piston, &error));
    assert_refused(fw_scene_add_piston(scene, &def, &piston, &error), FW_BAD_INPUT,
                   "piston ram is one too many, expected at most 64");
    assert_int_equal(fw_scene_wall_count(scene), FW_STATE_CAPACITY);
    fw_scene_destroy(scene);
}

/* --- states --- */

/* One body rubs on a floor, and another one on it. */
static fw_scene *rubbing(void)
{
    static const fw_vec2 ground[] = {{-20, -0.1}, {20, -0.1}};
    fw_scene *scene = empty_scene(100);
    for (int n = 0; n < 2; ++n)
        add_body(scene, (body_options){.columns = 5,
                                       .rows = 3,
                                       .origin = {0.3 * n, 2.4 * n},
                                       .velocity = {0.05 * n, -0.06},
                                       .mu = 0.98});
    fw_wall_def def = fw_wall_def_default();
    def.name = "floor";
    def.shape = FW_CHAIN;
    def.points = ground;
    def.point_count = 2;
    def.surface = (fw_surface){.law = FW_COULOMB, .friction = 0.3};
    must(fw_scene_add_wall(scene, &def, &error));
    fw_scene_set_friction(scene, 0.3);
    begin(scene);
    return scene;
}

static void *array_of(fw_scene *scene, int section, const char *name, size_t *count)
{
    fw_state_list list = {0};
    fw_scene_section(scene, section, &list);
    for (int n = 0; n < list.count; ++n)
        if (strcmp(list.array[n].name, name) == 0) {
            *count = list.array[n].count;
            return list.array[n].data;
        }
    fail_msg("no array %s", name);
    return NULL;
}

static void a_clock_that_does_not_agree_is_refused(void **state)
{
    (void)state;
    static const int64_t clocks[][3] = {
        {-1, -1, 0}, {3, 3, -1}, {3, 4, 0}, {INT64_MAX, INT64_MAX, 0}};
    for (int k = 0; k < 4; ++k) {
        int body;
        size_t count;
        fw_scene *scene = empty_scene(100);
        /* Two ticks a step: so many steps have no count of ticks. */
        must(fw_scene_adopt_body(scene, "halves", automaton(), &body, &error));
        begin(scene);
        int64_t *clock = array_of(scene, 0, "clock", &count);
        assert_int_equal(count, 3);
        memcpy(clock, clocks[k], sizeof clocks[k]);
        if (k == 1) clock[1] = 6;
        assert_refused(fw_scene_restored(scene, &error), FW_BAD_INPUT, "which do not agree");
        fw_scene_destroy(scene);
    }
}

/* A particle that rubs on another body, once there is one, with what it remembers. */
static scene_rub *find_rub(fw_scene *scene, int *body, int *particle)
{
    for (int steps = 0; steps < 200; ++steps) {
        run(scene, 1);
        for (*body = 0; *body < 2; ++*body) {
            size_t bytes;
            scene_rub *rubs = array_of(scene, 1 + *body, "body-friction", &bytes);
            for (*particle = 0; *particle < (int)(bytes / sizeof *rubs); ++*particle)
                if (rubs[*particle].other != 0) return &rubs[*particle];
        }
    }
    fail_msg("nothing rubs");
    return NULL;
}

static void what_rubs_on_nothing_is_refused(void **state)
{
    (void)state;
    for (int k = 0; k < 7; ++k) {
        fw_scene *scene = rubbing();
        int body, particle;
        scene_rub *rub = find_rub(scene, &body, &particle);
        must(fw_scene_restored(scene, &error));
        if (k == 0) rub->other = -1;
        if (k == 1) rub->other = 3;
        if (k == 2) rub->segment = -1;
        if (k == 3) rub->lambda = -1;
        if (k == 4) rub->lambda = INFINITY;
        if (k == 5) rub->inertial = NAN;
        if (k == 6) rub->other = 1 + body; /* on itself */
        char words[64];
        snprintf(words, sizeof words, "particle %d of body sheet rubs on segment %d", particle,
                 rub->segment);
        assert_refused(fw_scene_restored(scene, &error), FW_BAD_INPUT, words);
        fw_scene_destroy(scene);
    }
}

static void what_touches_no_facet_is_refused(void **state)
{
    (void)state;
    for (int k = 0; k < 3; ++k) {
        fw_scene *scene = rubbing();
        size_t bytes;
        fw_contact_memory *memory = array_of(scene, 1, "contact-memory", &bytes);
        run(scene, 10);
        must(fw_scene_restored(scene, &error));
        memory[2] = (fw_contact_memory){0};
        if (k == 0) memory[2].facet = -1;
        if (k == 1) memory[2].facet = 2;
        if (k == 2) memory[2].reaction = 1;
        assert_refused(fw_scene_restored(scene, &error), FW_BAD_INPUT,
                       "particle 2 of body sheet touches facet");
        fw_scene_destroy(scene);
    }
}

/* What a solid refuses is told with its name. */
static void a_body_that_is_nowhere_is_refused(void **state)
{
    (void)state;
    fw_scene *scene = rubbing();
    fw_scene_body(scene, 1)->x[3] = NAN;
    assert_refused(fw_scene_restored(scene, &error), FW_BAD_INPUT, "body sheet: ");
    fw_scene_body(scene, 1)->x[3] = NAN;
    assert_int_equal(fw_scene_restored(scene, NULL), FW_BAD_INPUT);
    fw_scene_destroy(scene);
}

static fw_status explode(fw_solid *solid, const fw_constraint *constraints, int count,
                         fw_error *failed)
{
    (void)solid, (void)constraints, (void)count;
    return fw_fail(failed, FW_DIVERGED, "it explodes");
}

/* With step and body; and where nobody wants the sentence, as it is. */
static void a_solid_that_fails_in_a_step_ends_it(void **state)
{
    (void)state;
    fw_scene *scene = rubbing();
    fw_solid *solid = fw_scene_body(scene, 1);
    fw_solid_model failing = *solid->model;
    failing.advance = explode;
    solid->model = &failing;
    assert_refused(fw_scene_step(scene, &error), FW_DIVERGED, ": body sheet: it explodes");
    assert_int_equal(fw_scene_step(scene, NULL), FW_DIVERGED);
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_of_a_drive_is_finite),
        cmocka_unit_test(periods_and_tethers_are_not_negative),
        cmocka_unit_test(what_drives_is_checked_each_time),
        cmocka_unit_test(a_piston_has_no_velocity_where_it_is_held),
        cmocka_unit_test(bodies_move_in_the_same_ticks),
        cmocka_unit_test(each_particle_has_one_grip_and_each_grip_a_name),
        cmocka_unit_test(pistons_are_walls_and_not_too_many),
        cmocka_unit_test(a_clock_that_does_not_agree_is_refused),
        cmocka_unit_test(what_rubs_on_nothing_is_refused),
        cmocka_unit_test(what_touches_no_facet_is_refused),
        cmocka_unit_test(a_body_that_is_nowhere_is_refused),
        cmocka_unit_test(a_solid_that_fails_in_a_step_ends_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
