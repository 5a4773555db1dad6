/* SPDX-License-Identifier: GPL-3.0-or-later */
/* observer.c - makes an experiment and what is followed beside it, and steps both together.
 * State: fw_observer; what a resumed run needs of it is in fw_observer_state(). Start reading at
 * fw_observer_create(). */
#include "experiments/measures/observer.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>

/* The ledger says in each step what energy there should be. */
static double largest_in_body(const fw_experiment *experiment, int body)
{
    const fw_solid_ledger *l = &fw_experiment_solid(experiment, body)->ledger;
    const double start = fw_experiment_energy_at_start(experiment, body);
    const double now = start + l->work - l->dissipated + l->heat;
    return fmax(fmax(fabs(start), fabs(now)),
                fmax(fabs(l->work), fmax(l->dissipated, fabs(l->heat))));
}

static void follow_energy(fw_observer *observer)
{
    const fw_experiment *experiment = observer->experiment;
    double *scale = observer->energy_scale;
    for (int b = 0; b < experiment->body_count; ++b)
        scale[b] = fmax(scale[b], largest_in_body(experiment, b));
}

void fw_observer_certify(fw_observer *observer)
{
    fw_certificate_look(&observer->certificate, observer->experiment);
}

static fw_status begin_following(fw_observer *observer, fw_error *error)
{
    observer->energy_scale = fw_array_of_doubles((size_t)observer->experiment->body_count);
    if (!observer->energy_scale) return fw_fail_memory(error, "an observer");
    follow_energy(observer);
    observer->certificate = fw_certificate_begin();
    fw_observer_certify(observer);
    return FW_OK;
}

void fw_observer_state(fw_observer *observer, fw_state_list *list)
{
    fw_state_list_add(list, "energy-scale", FW_F64, (size_t)observer->experiment->body_count,
                      observer->energy_scale);
    fw_certificate_state(&observer->certificate, list);
    if (!observer->profile) return;
    fw_profile_state(observer->profile, list);
    fw_rubbing_state(&observer->rubbing, list);
}

static fw_status add_profile(fw_observer *observer, fw_error *error)
{
    const fw_scenario *scenario = observer->experiment->scenario;
    if (scenario->profile.every == 0) return FW_OK;
    FW_TRY(fw_profile_create(&observer->profile, observer->experiment, error));
    fw_profile_follow(observer->profile, observer->experiment, 0);
    observer->rubbing = fw_rubbing_begin(scenario);
    fw_rubbing_follow(&observer->rubbing, observer->experiment, 0);
    return FW_OK;
}

static fw_status analyse(fw_observer *observer, fw_error *error)
{
    const fw_scenario *scenario = observer->experiment->scenario;
    observer->analyses = calloc((size_t)scenario->analysis_count + 1, sizeof(fw_analysis *));
    if (!observer->analyses) return fw_fail_memory(error, "the analyses of an experiment");
    for (int n = 0; n < scenario->analysis_count; ++n) {
        FW_TRY(fw_analysis_create(&observer->analyses[n], scenario, n, error));
        observer->analysis_count += 1;
    }
    return FW_OK;
}

fw_status fw_observer_create(fw_observer **observer, const fw_scenario *scenario, fw_error *error)
{
    *observer = NULL;
    fw_observer *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "an observer");
    fw_status status = fw_experiment_create(&made->experiment, scenario, error);
    if (status == FW_OK) status = begin_following(made, error);
    if (status == FW_OK) status = add_profile(made, error);
    if (status == FW_OK) status = analyse(made, error);
    if (status != FW_OK) {
        fw_observer_destroy(made);
        return status;
    }
    *observer = made;
    return FW_OK;
}

void fw_observer_destroy(fw_observer *observer)
{
    if (!observer) return;
    fw_profile_destroy(observer->profile);
    free(observer->energy_scale);
    for (int n = 0; n < observer->analysis_count; ++n) fw_analysis_destroy(observer->analyses[n]);
    free(observer->analyses);
    fw_experiment_destroy(observer->experiment);
    free(observer);
}

static void follow_profile(fw_observer *observer, int64_t step)
{
    fw_profile_follow(observer->profile, observer->experiment, step);
    fw_rubbing_follow(&observer->rubbing, observer->experiment, step);
}

fw_status fw_observer_move(fw_observer *observer, int64_t most, fw_error *error)
{
    fw_scene *scene = observer->experiment->scene;
    const int64_t end = fw_scene_steps(scene) + most;
    FW_TRY(fw_experiment_advance(observer->experiment, observer->profile ? 1 : most, error));
    const int64_t step = fw_scene_steps(scene);
    /* Where the scene took several steps at once, only damping and fracture were at work: the
     * energies in between lie between those before and after. */
    follow_energy(observer);
    if (observer->profile) {
        FW_TRY(fw_scene_settle(scene, error));
        follow_profile(observer, step);
    } else if (step != end && step % FW_SCENE_SETTLES_EVERY == 0) {
        FW_TRY(fw_scene_settle_boundaries(scene, error));
    }
    return FW_OK;
}

fw_status fw_observer_advance(fw_observer *observer, int64_t most, fw_error *error)
{
    fw_scene *scene = observer->experiment->scene;
    const int64_t end = fw_scene_steps(scene) + most;
    FW_TRY(fw_observer_move(observer, most, error));
    return fw_scene_steps(scene) == end ? fw_scene_settle(scene, error) : FW_OK;
}
