/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_grips_random.c - grips with any drives between walls, pistons and bodies: energy is exact,
 * nothing passes, and what cannot go on says so. */
#include "tests/support/grips.h"
#include "tests/support/pistons.h"

/* Numbers in [low, high), the same in every run. */
static double random_between(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static fw_drive random_drive(uint64_t *seed)
{
    fw_drive drive = {
        .prescribed_x = random_between(seed, 0, 1) < .5,
        .prescribed_y = random_between(seed, 0, 1) < .3,
        .path = {.amplitude = {random_between(seed, -2, 2), random_between(seed, -1, 1)},
                 .period = random_between(seed, 60, 400)},
        .tether = {random_between(seed, -.02, .02), random_between(seed, -.02, .02)}};
    drive.force = (fw_vec2){random_between(seed, -.1, .1), random_between(seed, -.3, .1)};
    drive.tether.x = fmax(drive.tether.x, 0);
    drive.tether.y = fmax(drive.tether.y, 0);
    return drive;
}

/* Three bodies between a floor and a ceiling, or a piston, two of them in grips. */
static fw_scene *random_scene(uint64_t seed)
{
    fw_scene *scene = empty_scene(1e4);
    const double friction = random_between(&seed, -.5, .5), rough = random_between(&seed, -.5, .5);
    for (int b = 0; b < 3; ++b)
        add_body(scene, (body_options){.columns = 5 + b,
                                       .rows = 3,
                                       .origin = {random_between(&seed, -1, 1), .05 + 2.3 * b},
                                       .velocity = {random_between(&seed, -.05, .05), 0},
                                       .mu = random_between(&seed, .9, 1)});
    grip_rows(scene, 0, "first", 5, 0, 1 + (random_between(&seed, 0, 1) < .5), random_drive(&seed));
    grip_rows(scene, 2, "second", 7, 1, 1 + (random_between(&seed, 0, 1) < .5),
              random_drive(&seed));
    const fw_surface surface = {.law = rough > 0 ? FW_COULOMB : FW_FRICTIONLESS,
                                .friction = fmax(rough, 0)};
    const fw_piston_def piston = {
        .mass = 8, .damping = .01, .drive = {.prescribed_x = true, .force = {0, -.1}}};
    const bool moves = random_between(&seed, 0, 1) < .5;
    add_block(scene, "floor", (fw_vec2){-50, -4}, (fw_vec2){50, 0}, surface, NULL);
    add_block(scene, "ceiling", (fw_vec2){-50, 7.3}, (fw_vec2){50, 9}, surface,
              moves ? &piston : NULL);
    fw_scene_set_friction(scene, fmax(friction, 0));
    return scene;
}

static void whatever_grips_do_the_books_close(void **state)
{
    (void)state;
    int ended = 0, loose = 0;
    double touches = 0, on_walls = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        fw_scene *scene = random_scene(seed);
        begin(scene);
        fw_status status = FW_OK;
        for (int t = 0; t < 400 && status == FW_OK; ++t) status = fw_scene_step(scene, &error);
        if (status != FW_OK) {
            assert_int_equal(status, FW_DIVERGED);
            if (!strstr(error.sentence, "carr") && !strstr(error.sentence, "room"))
                fail_msg("seed %d: %s", (int)seed, error.sentence);
        } else {
            ended += 1;
        }
        touches += (double)fw_scene_contact_ledger(scene)->ticks;
        on_walls += (double)fw_scene_wall_ledger(scene, 0)->held;
        const fw_ledger ledger = fw_scene_ledger(scene);
        const double lost = energy_of(scene) - fw_ledger_energy(&ledger);
        if (fabs(lost) > 1e-11 * fw_scene_energy_scale(scene))
            fail_msg("seed %d: energy of %g is lost", (int)seed, lost);
        if (fw_scene_contact_ledger(scene)->unconverged > 0 || fw_scene_unresolved(scene) > 0) {
            loose += 1;
        } else {
            if (fw_scene_body_penetration(scene) > 1e-9 || fw_scene_penetration(scene, -1) > 1e-9)
                fail_msg("seed %d: something passed by %g, %g", (int)seed,
                         fw_scene_body_penetration(scene), fw_scene_penetration(scene, -1));
        }
        fw_scene_destroy(scene);
    }
    assert_true(ended >= 30 && loose <= 3 && touches > 5000 && on_walls > 5000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(whatever_grips_do_the_books_close)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
