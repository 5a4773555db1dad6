/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warning.c - warnings of a run. State: what was said already. */
#include "experiments/measures/warning.h"

#include "core/boltzmann/lb_solid.h"
#include "experiments/setup/overlap.h"

#include <math.h>

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
            fprintf(warning->out,
                    "warning: step %lld: bodies %s and %s pass through each other near (%g, %g): "
                    "solids of these models meet walls only\n",
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
        if (solid->model != &fw_lb_solid_model) continue;
        fw_vec2 velocity =
            fw_sym2_apply(fw_sym2_invert(solid->model->mass(solid)), fw_solid_momentum(solid));
        double speed = hypot(velocity.x, velocity.y) / spacing;
        if (speed <= FW_LB_FASTEST) continue;
        fprintf(
            warning->out,
            "warning: body %s moves %g spacings in a step; above about %g an impact turns cells "
            "of an LB solid inside out\n",
            experiment->bodies[b].name, speed, FW_LB_FASTEST);
        warning->hurried = true;
        return;
    }
}

int fw_warning_walls(FILE *out, const fw_experiment *experiment)
{
    int count = 0;
    for (int w = 0; w < fw_scene_wall_count(experiment->scene); ++w) {
        const fw_wall *wall = fw_scene_wall(experiment->scene, w);
        if (fw_wall_surface(wall).law != FW_COMPONENTWISE) continue;
        fprintf(out,
                "warning: the surface of wall %s is 'componentwise', which does not conserve "
                "energy: where c2 couples x and y it can grow without bound ('frictionless' and "
                "'stick' conserve it)\n",
                fw_wall_name(wall));
        count += 1;
    }
    return count;
}

fw_status fw_warning_look(fw_warning *warning, const fw_experiment *experiment, fw_error *error)
{
    if (!warning->out) return FW_OK;
    if (!warning->looked) fw_warning_walls(warning->out, experiment);
    warning->looked = true;
    if (!warning->hurried && fw_scene_wall_count(experiment->scene) > 0)
        look_for_haste(warning, experiment);
    return warning->met ? FW_OK : look_for_meetings(warning, experiment, error);
}
