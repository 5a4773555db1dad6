/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warning.c - warnings of a run. State: what was said already, and the lines. Start reading at
 * fw_warning_look(). */
#include "experiments/measures/warning.h"

#include "experiments/setup/phase.h"
#include "experiments/setup/solids.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { WARNING_SIZE = 512 };

/* An oscillation that begins, or goes on, with a jump larger than this part of its amplitude was
 * hardly meant to. A phase need not end at a whole number of periods, but near it. */
#define JUMP_MAX 0.05

/* Says it, and keeps it as a line; without memory it is only said. */
static void warn(fw_warning *warning, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void warn(fw_warning *warning, const char *format, ...)
{
    char line[WARNING_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    warning->count += 1;
    fprintf(warning->out, "warning: %s\n", line);
    const size_t used = warning->text ? strlen(warning->text) : 0;
    char *longer = realloc(warning->text, used + strlen(line) + 2);
    if (!longer) return;
    warning->text = longer;
    sprintf(longer + used, "%s\n", line);
}

/* Each of these bodies has a solid to itself. */
static fw_status look_for_folds(fw_warning *warning, const fw_experiment *experiment,
                                fw_error *error)
{
    for (int b = 0; b < experiment->body_count; ++b) {
        bool found;
        fw_vec2 where;
        FW_TRY(fw_scene_find_fold(experiment->scene, experiment->bodies[b].solid,
                                  experiment->start[b], &found, &where, error));
        if (!found) continue;
        warn(warning,
             "step %lld: the edge of body %s crosses itself near (%g, %g): the body is folded, and "
             "contact of a body with itself is not looked for",
             (long long)fw_scene_steps(experiment->scene), experiment->bodies[b].name, where.x,
             where.y);
        warning->folded = true;
        return FW_OK;
    }
    return FW_OK;
}

static void look_for_haste(fw_warning *warning, const fw_experiment *experiment)
{
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        double spacing = experiment->scenario->bodies[b].lattice.spacing;
        const double fastest = fw_solid_kind_of(experiment->scenario, b)->fastest;
        if (!(fastest > 0)) continue;
        fw_vec2 velocity =
            fw_sym2_apply(fw_sym2_invert(solid->model->mass(solid)), fw_solid_momentum(solid));
        double speed = hypot(velocity.x, velocity.y) / spacing;
        if (speed <= fastest) continue;
        warn(warning,
             "body %s moves %g spacings in a step; above about %g an impact turns cells "
             "of an LB solid inside out",
             experiment->bodies[b].name, speed, fastest);
        warning->hurried = true;
        return;
    }
}

/* Walls that break a law which all others keep. */
static void look_for_walls(fw_warning *warning, const fw_experiment *experiment)
{
    for (int w = 0; w < fw_scene_wall_count(experiment->scene); ++w) {
        const fw_wall *wall = fw_scene_wall(experiment->scene, w);
        if (fw_wall_surface(wall).law != FW_COMPONENTWISE) continue;
        warn(warning,
             "the surface of wall %s is 'componentwise', which does not conserve energy: where c2 "
             "couples x and y it can grow without bound ('frictionless' and 'stick' conserve it)",
             fw_wall_name(wall));
    }
}

/* One component of an oscillating force, when a phase begins. */
typedef struct phase_edge {
    double before, after; /* as the phase before would go on, and as it is */
    double before_amplitude, amplitude;
    bool forced; /* by forces, not held to a path */
} phase_edge;

static void look_for_jump(fw_warning *warning, const char *kind, const char *name, phase_edge edge,
                          const fw_scenario_phase *phase, const fw_drive *drive, double time)
{
    const double jump = edge.after - edge.before, part = fabs(jump / edge.amplitude);
    if (!edge.forced || edge.amplitude == 0 || part <= JUMP_MAX) return;
    if (edge.before_amplitude != 0)
        warn(warning,
             "phase %s: the oscillating force on %s %s goes on with a jump of %.3g, %.2g of its "
             "amplitude; 'time-from', 'period' and 'phase' as in the phase before continue it, and "
             "an 'until' at which it is 0 lets the amplitude change",
             phase->name, kind, name, jump, part);
    else if (drive->origin != time) /* else its 'phase' was chosen for this beginning */
        warn(warning,
             "phase %s: the oscillating force on %s %s begins with a jump of %.3g, %.2g of its "
             "amplitude, since its time is not counted from here; 'time-from: %s'%s lets it begin "
             "at 0",
             phase->name, kind, name, jump, part, phase->name,
             drive->phase != 0 ? " without 'phase'" : "");
}

/* Of both components, when the phase begins at `time`. */
static void look_for_jumps(fw_warning *warning, const char *kind, const char *name,
                           const fw_drive *before, const fw_drive *drive,
                           const fw_scenario_phase *phase, double time)
{
    const fw_vec2 was = fw_drive_oscillation(before, time), is = fw_drive_oscillation(drive, time);
    phase_edge x = {was.x, is.x, before->amplitude.x, drive->amplitude.x, !drive->prescribed_x};
    phase_edge y = {was.y, is.y, before->amplitude.y, drive->amplitude.y, !drive->prescribed_y};
    if (before->prescribed_x) x.before = x.before_amplitude = 0;
    if (before->prescribed_y) y.before = y.before_amplitude = 0;
    look_for_jump(warning, kind, name, x, phase, drive, time);
    look_for_jump(warning, kind, name, y, phase, drive, time);
}

static void look_at_phases(fw_warning *warning, const fw_experiment *experiment)
{
    const fw_scenario *scenario = experiment->scenario;
    const fw_scene *scene = experiment->scene;
    for (int p = 1; p < scenario->phase_count; ++p) {
        const fw_scenario_phase *phase = &scenario->phases[p];
        const double time = fw_phase_time(scenario, scene, p);
        for (int g = 0; g < scenario->grip_count; ++g) {
            const fw_drive before = fw_phase_grip(scenario, scene, p - 1, g);
            const fw_drive drive = fw_phase_grip(scenario, scene, p, g);
            look_for_jumps(warning, "grip", scenario->grips[g].name, &before, &drive, phase, time);
        }
        for (int w = 0; w < scenario->wall_count; ++w) {
            if (!scenario->walls[w].is_piston) continue;
            const fw_drive before = fw_phase_piston_drive(scenario, scene, p - 1, w);
            const fw_drive drive = fw_phase_piston_drive(scenario, scene, p, w);
            look_for_jumps(warning, "piston", scenario->walls[w].def.name, &before, &drive, phase,
                           time);
        }
    }
}

void fw_warning_clear(fw_warning *warning)
{
    free(warning->text);
    *warning = (fw_warning){0};
}

fw_status fw_warning_look(fw_warning *warning, const fw_experiment *experiment, fw_error *error)
{
    if (!warning->out) return FW_OK;
    if (!warning->looked) {
        look_for_walls(warning, experiment);
        look_at_phases(warning, experiment);
    }
    warning->looked = true;
    if (!warning->hurried && fw_scene_wall_count(experiment->scene) > 0)
        look_for_haste(warning, experiment);
    return warning->folded ? FW_OK : look_for_folds(warning, experiment, error);
}
