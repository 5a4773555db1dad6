/* SPDX-License-Identifier: GPL-3.0-or-later */
/* period.c - refuses oscillations that a step cannot follow. A sine that is evaluated once or twice
 * in a period is zero each time, or an oscillation with another period. Keeps no state.
 * Start reading at fw_period_check(). */
#include "period.h"

/* Duration of a step, in the time of paths and drives. */
static double step_of(const fw_scene *scene)
{
    double step = 0;
    for (int b = 0; b < fw_scene_body_count(scene); ++b) {
        const fw_solid *solid = fw_scene_observe_body(scene, b);
        step = fmax(step, solid->tick * solid->model->ticks_per_step);
    }
    return step;
}

static fw_status check(const fw_scenario *scenario, fw_place place, const char *kind,
                       const char *name, double period, double step, fw_error *error)
{
    /* What is meant to be exactly the shortest may be less by a rounding. */
    if (period == 0 || period > FW_SHORTEST_PERIOD * step * (1 - 1e-9)) return FW_OK;
    return fw_scenario_fail(scenario, place, error,
                            "%s %s oscillates with a period of %g (steps: %.3g), expected at "
                            "least %g (steps: %d): it is evaluated once per step",
                            kind, name, period, period / step, FW_SHORTEST_PERIOD * step,
                            FW_SHORTEST_PERIOD);
}

static fw_status check_drive(const fw_scenario *scenario, fw_place place, const char *kind,
                             const char *name, const fw_drive *drive, double step, fw_error *error)
{
    FW_TRY(check(scenario, place, kind, name, drive->period, step, error));
    return check(scenario, place, kind, name, drive->path.period, step, error);
}

fw_status fw_period_check(const fw_scenario *scenario, const fw_scene *scene, fw_error *error)
{
    const double step = step_of(scene);
    for (int n = 0; n < scenario->wall_count; ++n) {
        const fw_scenario_wall *wall = &scenario->walls[n];
        if (wall->is_piston)
            FW_TRY(check_drive(scenario, wall->place, "piston", wall->def.name,
                               &wall->piston.motion.drive, step, error));
        else
            FW_TRY(check(scenario, wall->place, "wall", wall->def.name, wall->def.path.period, step,
                         error));
    }
    for (int n = 0; n < scenario->force_count; ++n) {
        const fw_scenario_force *force = &scenario->forces[n]; /* its period counts steps */
        FW_TRY(check(scenario, force->place, "force", force->name, force->period, 1, error));
    }
    for (int n = 0; n < scenario->grip_count; ++n)
        FW_TRY(check_drive(scenario, scenario->grips[n].place, "grip", scenario->grips[n].name,
                           &scenario->grips[n].motion.drive, step, error));
    for (int p = 0; p < scenario->phase_count; ++p) {
        const fw_scenario_phase *phase = &scenario->phases[p];
        for (int n = 0; n < phase->drive_count; ++n)
            FW_TRY(check_drive(scenario, phase->drives[n].place, "grip",
                               scenario->grips[phase->drives[n].grip].name,
                               &phase->drives[n].motion.drive, step, error));
        for (int n = 0; n < phase->piston_count; ++n)
            FW_TRY(check_drive(scenario, phase->pistons[n].place, "piston",
                               scenario->walls[phase->pistons[n].wall].def.name,
                               &phase->pistons[n].motion.drive, step, error));
    }
    return FW_OK;
}
