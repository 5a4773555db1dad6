/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_soft_walls.c - soft walls in a scene: what is passed over without a look at the wall is what
 * the wall does nothing to. */
#include "contact/constraint/penalty.h"
#include "contact/scene/scene_parts.h"
#include "tests/support/random_walls.h"
#include "tests/support/scenes.h"

enum { WALLS = 3000, PATHS = 40 };

/* At rest, or displaced and moving as a piston may be. */
static void set_in_motion(scene_wall *wall, dice *d, double size)
{
    if (dice_below(d, 2)) return;
    wall->place = dice_point(d, (fw_vec2){0, 0}, size);
    wall->motion = dice_point(d, (fw_vec2){0, 0}, 0.1 * size);
}

/* Random walls of all shapes, and paths about them: the force is that of the wall itself on the
 * path relative to it, and a scene that says that a path is clear exerts none. */
static void what_is_clear_of_a_soft_wall_feels_nothing(void **state)
{
    (void)state;
    dice d = {20};
    int pushed[FW_WALL_SHAPES][2] = {{0}}, clear = 0;
    for (int n = 0; n < WALLS; ++n) {
        wall_recipe recipe;
        const double size = dice_scale(&d, -1, 2);
        const fw_vec2 centre = dice_point(&d, (fw_vec2){0, 0}, 100);
        random_wall(&recipe, &d, centre, size, 0);
        recipe.def.name = "soft";
        recipe.def.surface = (fw_surface){.law = FW_PENALTY, .stiffness = 3};
        fw_scene *scene = empty_scene(INFINITY);
        if (fw_scene_add_wall(scene, &recipe.def, &error) != FW_OK) { /* a chain has no sides */
            fw_scene_destroy(scene);
            continue;
        }
        scene_wall *wall = &scene->walls[0];
        set_in_motion(wall, &d, size);
        for (int k = 0; k < PATHS; ++k) {
            const fw_vec2 from = dice_point(&d, centre, 1.2 * size);
            const fw_vec2 to = fw_vec2_add(from, dice_point(&d, (fw_vec2){0, 0}, 0.2 * size));
            const fw_vec2 at = fw_vec2_add(from, wall->place);
            const fw_vec2 w = fw_vec2_add(fw_vec2_subtract(to, from), wall->motion);
            const fw_vec2 start = fw_vec2_subtract(at, wall->place);
            const fw_vec2 wanted = fw_penalty_force(
                wall->wall, start, fw_vec2_add(start, fw_vec2_subtract(w, wall->motion)));
            const fw_vec2 force = scene_soft_force(scene, at, w);
            assert_true(force.x == wanted.x && force.y == wanted.y);
            if (wanted.x != 0 || wanted.y != 0) ++pushed[recipe.def.shape][recipe.def.side];
            if (!scene_is_clear_of_soft(scene, at, w)) continue;
            assert_true(wanted.x == 0 && wanted.y == 0);
            ++clear;
        }
        fw_scene_destroy(scene);
    }
    assert_true(clear > 1000);
    for (int shape = 0; shape < FW_WALL_SHAPES; ++shape)
        for (int side = 0; side < 2; ++side)
            if (shape != FW_CHAIN) assert_true(pushed[shape][side] > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_clear_of_a_soft_wall_feels_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
