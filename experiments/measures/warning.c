/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warning.c - warnings of a run. State: what was said already, and the lines. */
#include "experiments/measures/warning.h"

#include "experiments/setup/overlap.h"
#include "experiments/setup/solids.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { WARNING_SIZE = 512 };

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

static fw_status look_for_meetings(fw_warning *warning, const fw_experiment *experiment,
                                   fw_error *error)
{
    for (int a = 0; a < experiment->body_count; ++a)
        for (int b = a + 1; b < experiment->body_count; ++b) {
            bool found;
            fw_vec2 where;
            if (experiment->bodies[a].solid == experiment->bodies[b].solid) continue;
            FW_TRY(fw_overlap_find(experiment->scene, &experiment->bodies[a],
                                   &experiment->bodies[b], &found, &where, error));
            if (!found) continue;
            warn(warning,
                 "step %lld: bodies %s and %s pass through each other near (%g, %g): "
                 "solids of these models meet walls only",
                 (long long)fw_scene_steps(experiment->scene), experiment->bodies[a].name,
                 experiment->bodies[b].name, where.x, where.y);
            warning->met = true;
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

void fw_warning_clear(fw_warning *warning)
{
    free(warning->text);
    *warning = (fw_warning){0};
}

fw_status fw_warning_look(fw_warning *warning, const fw_experiment *experiment, fw_error *error)
{
    if (!warning->out) return FW_OK;
    if (!warning->looked) look_for_walls(warning, experiment);
    warning->looked = true;
    if (!warning->hurried && fw_scene_wall_count(experiment->scene) > 0)
        look_for_haste(warning, experiment);
    return warning->met ? FW_OK : look_for_meetings(warning, experiment, error);
}
