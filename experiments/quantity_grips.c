/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_grips.c - what can be measured of grips, and where two bodies rub. Keeps no state. */
#include "experiments/quantity.h"

#include "core/particles.h"

#include <math.h>

static const fw_grip_account *account_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_grip_observe_account(fw_scene_observe_grip(experiment->scene, subject.grip));
}

static void put(double *out, fw_vec2 v)
{
    out[0] = v.x;
    out[1] = v.y;
}

static void displacement(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, account_of(experiment, subject)->displacement);
}

static void force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, account_of(experiment, subject)->reaction);
}

static void impulse(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, account_of(experiment, subject)->impulse);
}

static void way(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, account_of(experiment, subject)->way);
}

static void torque(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = account_of(experiment, subject)->torque;
}

static void work(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = account_of(experiment, subject)->work;
}

static void slip(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    if (fw_scene_grip_count(experiment->scene) < 2) {
        put(out, (fw_vec2){NAN, NAN});
        return;
    }
    const fw_subject first = {.grip = 0}, second = {.grip = 1};
    put(out, fw_vec2_subtract(account_of(experiment, first)->displacement,
                              account_of(experiment, second)->displacement));
}

static void interface_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    const fw_solid *particles = fw_experiment_particles(experiment);
    if (particles && fw_particles_group_count(particles) > 1)
        put(out, fw_particles_force_on(particles, 0, 1));
    else
        put(out, (fw_vec2){NAN, NAN});
}

static void contact_return_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = experiment->profile
                 ? fw_profile_contact_now(experiment->profile, fw_experiment_particles(experiment))
                 : NAN;
}

/* clang-format off */
const fw_quantity fw_grip_quantities[] = {
    {"grip-displacement", FW_SCOPE_GRIP, "x y", "length", "since the start", NULL, displacement},
    {"grip-force", FW_SCOPE_GRIP, "x y", "force", "[D(t) + D(t-1)]/2, all that drives the grip", NULL, force},
    {"grip-impulse", FW_SCOPE_GRIP, "x y", "momentum", "of what drives the grip, since the start", NULL, impulse},
    {"grip-work", FW_SCOPE_GRIP, "", "energy", "of what drives the grip, since the start", NULL, work},
    {"grip-torque", FW_SCOPE_GRIP, "", "energy", "of the constraint forces about the grip's centre", NULL, torque},
    {"grip-way", FW_SCOPE_GRIP, "x y", "length", "length of its way since the start, per component", NULL, way},
    {"slip", FW_SCOPE_SCENE, "x y", "length", "displacement of the first grip less that of the second", NULL, slip},
    {"interface-force", FW_SCOPE_SCENE, "x y", "force", "of the second body of movable particles on the first", NULL, interface_force},
    {"contact-return-force", FW_SCOPE_SCENE, "", "force", "mean length of the net return forces in the profile's contact region", NULL, contact_return_force},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL},
};
/* clang-format on */
