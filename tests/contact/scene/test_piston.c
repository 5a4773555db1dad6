/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_piston.c - walls with a mass: what moves alone follows closed forms, what meets bodies keeps
 * energy and momentum with them, whatever the surface and shape. */
#include "tests/support/pistons.h"

/* --- alone --- */

static void constant_force_gives_constant_acceleration(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 4, .drive = {.force = {0.02, -0.01}}};
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "block", (fw_vec2){5, 5}, (fw_vec2){6, 6}, smooth, &def);
    begin(scene);
    run(scene, 1000);
    const fw_piston_ledger *a = ledger_of(scene, 0);
    assert_close(a->displacement.x, 0.5 * 0.02 / 4 * 1e6, 1e-8);
    assert_close(a->displacement.y, -0.5 * 0.01 / 4 * 1e6, 1e-8);
    assert_close(a->velocity.x, 0.02 / 4 * 1000, 1e-11);
    assert_ledger_balances(scene, 1e-12);
    assert_int_equal(fw_scene_unresolved(scene), 0);
    fw_scene_destroy(scene);
}

/* To F/(M damping), up to the order of the time step squared. */
static void damped_piston_reaches_its_terminal_velocity(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 4, .damping = 0.02, .drive = {.force = {0.02, 0}}};
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "block", (fw_vec2){5, 5}, (fw_vec2){6, 6}, smooth, &def);
    begin(scene);
    run(scene, 3000);
    assert_close(ledger_of(scene, 0)->velocity.x, 0.25, 0.25 * 0.02 * 0.02);
    assert_ledger_balances(scene, 1e-12);
    fw_scene_destroy(scene);
}

/* omega of the implicit spring is below (k/M)^(1/2) by (omega dt)^2/24 (its step is a rotation by 2
 * atan(omega dt/2)); its energy k u^2/2 + M v^2/2 does not change at all. */
static void tethered_piston_swings_for_ever(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    fw_piston_def def = {.mass = 2, .drive = {.force = {0.3, 0}}};
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "block", (fw_vec2){5, 5}, (fw_vec2){6, 6}, smooth, &def);
    begin(scene);
    run(scene, 1);
    fw_piston *piston = fw_scene_piston(scene, 0);
    const fw_drive spring = {.tether = {0.02, 0}};
    assert_int_equal(fw_piston_set_drive(piston, &spring, 0, &error), FW_OK);
    double first = 0;
    int turns = 0;
    for (int t = 0; t < 20000; ++t) {
        const double before = ledger_of(scene, 0)->velocity.x;
        run(scene, 1);
        const fw_piston_ledger *a = ledger_of(scene, 0);
        const double energy =
            fw_piston_kinetic_energy(piston) + 0.5 * 0.02 * a->displacement.x * a->displacement.x;
        if (t == 0) first = energy;
        assert_close(energy, first, 1e-11 * first);
        turns += before > 0 && a->velocity.x <= 0;
    }
    const double angle = 2 * atan(0.5 * sqrt(0.02 / 2));
    assert_close(turns, 20000 * angle / FW_TWO_PI, 1);
    fw_scene_destroy(scene);
}

/* --- with bodies --- */

/* Two masses on a line swap what the textbook says, to the last digits. */
static void piston_and_particle_collide_elastically(void **state)
{
    (void)state;
    const double masses[] = {0.1, 1, 16, 1e4};
    for (size_t n = 0; n < sizeof masses / sizeof masses[0]; ++n) {
        fw_scene *scene = empty_scene(1e6);
        const double m = 0.5 * 1.3 * 1.3, big = masses[n], v = 0.0371;
        const fw_piston_def def = {.mass = big};
        add_sheet(scene, 1, 1, (fw_vec2){v, 0.01}, 1.3, 1);
        add_block(scene, "block", (fw_vec2){1, -50}, (fw_vec2){2, 50}, smooth, &def);
        begin(scene);
        run(scene, 100);
        const fw_solid *solid = fw_scene_observe_body(scene, 0);
        const fw_vec2 p = fw_solid_momentum(solid);
        assert_close(p.x / m, v * (m - big) / (m + big), 1e-14);
        assert_close(p.y / m, 0.01, 1e-15);
        assert_close(ledger_of(scene, 0)->velocity.x, 2 * m * v / (m + big), 1e-14);
        assert_ledger_balances(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* A sheet between a wall and a piston that strikes it, again and again. */
static void impacts_keep_energy_and_momentum_on_every_surface(void **state)
{
    (void)state;
    static const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                          {.law = FW_STICK},
                                          {.law = FW_COULOMB, .friction = 0.3},
                                          {.law = FW_PENALTY, .stiffness = 0.3}};
    static const double masses[] = {0.3, 3, 40, 1000};
    for (size_t s = 0; s < 4; ++s)
        for (size_t n = 0; n < 4; ++n) {
            fw_scene *scene = empty_scene(1e6);
            const fw_piston_def def = {.mass = masses[n], .drive = {.tether = {0.002, 0.001}}};
            add_sheet(scene, 12, 7, (fw_vec2){0.031, 0.017}, 0.2, 1);
            add_block(scene, "stop", (fw_vec2){-40, -400}, (fw_vec2){-1.3, 400}, smooth, NULL);
            add_block(scene, "piston", (fw_vec2){13.7, -200}, (fw_vec2){20, 200}, surfaces[s],
                      &def);
            begin(scene);
            double deepest = 0;
            for (int t = 0; t < 3000; ++t) {
                run(scene, 1);
                deepest = fmax(deepest, fw_scene_penetration(scene, 0));
            }
            assert_ledger_balances(scene, 2e-12);
            assert_true(fw_scene_wall_ledger(scene, 1)->held > 0 || s == 3);
            assert_true(fabs(ledger_of(scene, 1)->pushed_by) > 1e-4);
            if (s != 3) assert_below(deepest, 1e-11);
            assert_int_equal(fw_scene_unresolved(scene), 0);
            assert_true(motion_fits(scene, 1));
            fw_scene_destroy(scene);
        }
}

/* A heavy disc, free to go anywhere, is struck by a sheet. */
static void round_piston_keeps_energy_and_momentum(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 50};
    const fw_vec2 centre = {17.3, 4.4};
    fw_wall_def disc = fw_wall_def_default();
    disc.name = "disc";
    disc.shape = FW_CIRCLE;
    disc.points = &centre;
    disc.point_count = 1;
    disc.radius = 3;
    disc.side = FW_OUTSIDE;
    add_sheet(scene, 12, 7, (fw_vec2){0.031, 0}, 0.2, 1);
    assert_int_equal(fw_scene_add_piston(scene, &disc, &def, &error), FW_OK);
    begin(scene);
    run(scene, 600);
    const fw_piston_ledger *a = ledger_of(scene, 0);
    assert_true(a->velocity.x > 0.01);
    assert_ledger_balances(scene, 1e-11);
    assert_true(motion_fits(scene, 0));
    const fw_vec2 p = fw_scene_momentum(scene);
    assert_close(p.x + 50 * a->velocity.x, fw_scene_ledger(scene).momentum_at_start.x, 1e-12);
    assert_below(fw_scene_penetration(scene, 0), 1e-11);
    fw_scene_destroy(scene);
}

/* A prescribed component follows its path and pays with the drive's work what the bodies take. */
static void held_piston_follows_its_path(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {
        .mass = 5,
        .drive = {.prescribed_x = true,
                  .prescribed_y = true,
                  .path = {.amplitude = {0.5, 0}, .period = 400, .until = INFINITY}}};
    add_sheet(scene, 8, 5, (fw_vec2){0, 0}, 0.2, 0.99);
    add_block(scene, "stop", (fw_vec2){-40, -400}, (fw_vec2){-0.5, 400}, smooth, NULL);
    add_block(scene, "piston", (fw_vec2){7.2, -200}, (fw_vec2){20, 200}, smooth, &def);
    begin(scene);
    run(scene, 1100);
    const fw_piston_ledger *a = ledger_of(scene, 1);
    assert_close(a->displacement.x, 0.5 * sin(FW_TWO_PI * 1100 / 400), 1e-12);
    assert_close(a->work, fw_scene_wall_ledger(scene, 1)->work, 1e-12);
    assert_true(a->work > 1e-3);
    assert_true(fw_piston_kinetic_energy(fw_scene_observe_piston(scene, 1)) == 0);
    /* Let go, it begins with the velocity that it had. */
    const fw_drive none = {.force = {0, 0}};
    const double speed = a->velocity.x;
    assert_int_equal(fw_piston_set_drive(fw_scene_piston(scene, 1), &none, 0, &error), FW_OK);
    assert_close(fw_piston_kinetic_energy(fw_scene_observe_piston(scene, 1)), 2.5 * speed * speed,
                 1e-15);
    run(scene, 300);
    assert_ledger_balances(scene, 1e-12);
    fw_scene_destroy(scene);
}

/* Nothing stands in its way. */
static void piston_that_escapes_stops_the_run(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    const fw_piston_def def = {.mass = 1, .drive = {.force = {1e4, 0}}};
    add_sheet(scene, 2, 2, (fw_vec2){0, 0}, 0, 1);
    add_block(scene, "block", (fw_vec2){5, 5}, (fw_vec2){6, 6}, smooth, &def);
    begin(scene);
    fw_status status = FW_OK;
    for (int t = 0; t < 20 && status == FW_OK; ++t) status = fw_scene_step(scene, &error);
    assert_int_equal(status, FW_DIVERGED);
    assert_non_null(strstr(error.sentence, "step 15: piston block is displaced by"));
    fw_scene_destroy(scene);
}

static void bad_pistons_are_refused(void **state)
{
    (void)state;
    const struct {
        fw_piston_def def;
        const char *words;
    } bad[] = {{{.mass = 0}, "mass 0"},
               {{.mass = -1}, "mass -1"},
               {{.mass = NAN}, "mass"},
               {{.mass = INFINITY}, "mass inf"},
               {{.mass = 1, .damping = INFINITY}, "damping inf"},
               {{.mass = 1, .damping = -0.1}, "damping -0.1"},
               {{.mass = 1, .drive = {.tether = {-1, 0}}}, "tether"},
               {{.mass = 1, .drive = {.force = {INFINITY, 0}}}, "not finite"},
               {{.mass = 1, .velocity = {NAN, 0}}, "velocity"},
               {{.mass = 1, .velocity = {1, 0}, .drive = {.prescribed_x = true}}, "held"}};
    for (size_t n = 0; n < sizeof bad / sizeof bad[0]; ++n) {
        fw_piston *piston;
        assert_int_equal(fw_piston_create(&piston, "press", &bad[n].def, &error), FW_BAD_INPUT);
        assert_null(piston);
        if (!strstr(error.sentence, bad[n].words) || !strstr(error.sentence, "piston press"))
            fail_msg("'%s' does not speak of '%s'", error.sentence, bad[n].words);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_force_gives_constant_acceleration),
        cmocka_unit_test(damped_piston_reaches_its_terminal_velocity),
        cmocka_unit_test(tethered_piston_swings_for_ever),
        cmocka_unit_test(piston_and_particle_collide_elastically),
        cmocka_unit_test(impacts_keep_energy_and_momentum_on_every_surface),
        cmocka_unit_test(round_piston_keeps_energy_and_momentum),
        cmocka_unit_test(held_piston_follows_its_path),
        cmocka_unit_test(piston_that_escapes_stops_the_run),
        cmocka_unit_test(bad_pistons_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
