/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rubbing.c - sums over the steps in which two bodies rub.
 * State: the sums, and slip and force of the last step. Start reading at fw_rubbing_follow(). */
#include "experiments/measures/rubbing.h"

#include "core/particles/particles.h"

#include <math.h>

static double component_of(fw_vec2 v, int component)
{
    return component == 0 ? v.x : v.y;
}

fw_vec2 fw_rubbing_slip(const fw_experiment *experiment)
{
    const fw_scene *scene = experiment->scene;
    if (fw_scene_grip_count(scene) < 2) return (fw_vec2){NAN, NAN};
    return fw_vec2_subtract(fw_grip_observe_ledger(fw_scene_observe_grip(scene, 0))->displacement,
                            fw_grip_observe_ledger(fw_scene_observe_grip(scene, 1))->displacement);
}

fw_vec2 fw_rubbing_force(const fw_experiment *experiment)
{
    const fw_solid *particles = fw_experiment_particles(experiment);
    if (!particles && fw_scene_body_count(experiment->scene) == 2)
        return fw_scene_body_ledger(experiment->scene, 0, 0)->reaction;
    if (!particles || fw_particles_group_count(particles) < 2) return (fw_vec2){NAN, NAN};
    return fw_particles_force_on(particles, 0, 1);
}

fw_rubbing fw_rubbing_begin(const fw_scenario *scenario)
{
    const fw_scenario_profile *plan = &scenario->profile;
    fw_rubbing rubbing = {
        .along = 1 - plan->axis, .across = plan->axis, .from = plan->from, .until = plan->until};
    for (int p = 0; p < scenario->phase_count; ++p)
        if (scenario->phases[p].until == plan->from) rubbing.before = scenario->phases[p].from;
    return rubbing;
}

/* The loop by trapezoids between one step and the next. */
static void add_sample(fw_rubbing *r, fw_vec2 force, double slip, int64_t step)
{
    const double along = component_of(force, r->along);
    fw_rubbing_sums *s = &r->sums;
    if (step > r->from) {
        s->path += fabs(slip - s->last_slip);
        s->work -= 0.5 * (along + s->last_force) * (slip - s->last_slip);
    }
    s->last_force = along;
    s->steps += 1;
    s->slip += slip;
    s->force += fabs(along);
    s->pressing += fabs(component_of(force, r->across));
}

void fw_rubbing_follow(fw_rubbing *r, const fw_experiment *experiment, int64_t step)
{
    if (step < r->before || step > r->until) return;
    const double slip = component_of(fw_rubbing_slip(experiment), r->along);
    if (step > r->before && step <= r->from) r->sums.path_before += fabs(slip - r->sums.last_slip);
    if (step >= r->from) add_sample(r, fw_rubbing_force(experiment), slip, step);
    r->sums.last_slip = slip;
}

void fw_rubbing_state(fw_rubbing *r, fw_state_list *list)
{
    fw_state_list_add(list, "rubbing", FW_F64, sizeof r->sums / sizeof(double), &r->sums.last_slip);
}
