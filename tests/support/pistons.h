/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pistons.h - what tests of pistons share beside scenes.h: sheets, blocks with pistons, and that
 * the ledgers of bodies, walls and pistons agree. */
#ifndef FW_TEST_PISTONS_H
#define FW_TEST_PISTONS_H

#include "tests/support/scenes.h"

static inline void add_sheet(fw_scene *scene, int columns, int rows, fw_vec2 velocity,
                             double rest_mass, double mu)
{
    add_body(scene, (body_options){.columns = columns,
                                   .rows = rows,
                                   .velocity = velocity,
                                   .rest_mass = rest_mass,
                                   .mu = mu});
}

static const fw_surface smooth = {.law = FW_FRICTIONLESS};

/* A box that is free outside, with the piston that moves it, or at rest. */
static inline void add_block(fw_scene *scene, const char *name, fw_vec2 low, fw_vec2 high,
                             fw_surface surface, const fw_piston_def *piston)
{
    const fw_vec2 corners[] = {low, high};
    fw_wall_def def = fw_wall_def_default();
    def.name = name;
    def.points = corners;
    def.side = FW_OUTSIDE;
    def.surface = surface;
    const fw_status status = piston ? fw_scene_add_piston(scene, &def, piston, &error)
                                    : fw_scene_add_wall(scene, &def, &error);
    if (status != FW_OK) fail_msg("%s", error.sentence);
}

static inline const fw_piston_ledger *ledger_of(const fw_scene *scene, int wall)
{
    return fw_piston_observe_ledger(fw_scene_observe_piston(scene, wall));
}

/* The motion of the piston fits what pushed it, in all steps. */
static inline bool motion_fits(const fw_scene *scene, int wall)
{
    const fw_piston_ledger *a = ledger_of(scene, wall);
    const double flow = fabs(a->work) + fabs(a->pushed_by);
    const double impulses = 1 + fabs(a->pushed.x) + fabs(a->pushed.y);
    return fabs(a->unmatched_work) <= 1e-11 * (1 + flow) &&
           fabs(a->unmatched.x) + fabs(a->unmatched.y) <= 1e-11 * impulses;
}

/* Ledgers of the bodies, of each piston, and that what one gives the other takes. */
static inline void assert_ledger_balances(const fw_scene *scene, double tolerance)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    const fw_energies e = fw_scene_energies(scene);
    const double size = fabs(ledger.energy_at_start) + fabs(ledger.wall_work) + ledger.dissipated;
    assert_close(e.kinetic + e.elastic, fw_ledger_energy(&ledger), tolerance * (1e-3 + size));
    const fw_vec2 p = fw_scene_momentum(scene), wanted = fw_ledger_momentum(&ledger);
    double impulses = 1;
    for (int w = 0; w < fw_scene_wall_count(scene); ++w) {
        const fw_vec2 impulse = fw_scene_wall_ledger(scene, w)->impulse;
        impulses += fabs(impulse.x) + fabs(impulse.y);
    }
    assert_close(p.x, wanted.x, tolerance * impulses);
    assert_close(p.y, wanted.y, tolerance * impulses);
    for (int w = 0; w < fw_scene_wall_count(scene); ++w) {
        const fw_piston *piston = fw_scene_observe_piston(scene, w);
        if (!piston) continue;
        const fw_piston_ledger *a = fw_piston_observe_ledger(piston);
        const fw_wall_ledger *wall = fw_scene_wall_ledger(scene, w);
        const double flow = fabs(a->work) + fabs(a->pushed_by) + fabs(a->met_work) + a->heat;
        assert_close(fw_piston_energy_error(piston), 0, tolerance * (1e-3 + flow));
        assert_close(a->pushed_by, -wall->work, tolerance * (1e-3 + flow));
        const fw_vec2 lost = fw_piston_momentum_error(piston);
        assert_close(lost.x, 0, tolerance * (1 + fabs(a->impulse.x) + fabs(a->pushed.x)));
        assert_close(lost.y, 0, tolerance * (1 + fabs(a->impulse.y) + fabs(a->pushed.y)));
        assert_close(a->pushed.x, -wall->impulse.x, tolerance * (1 + fabs(wall->impulse.x)));
        assert_close(a->pushed.y, -wall->impulse.y, tolerance * (1 + fabs(wall->impulse.y)));
    }
}

#endif
