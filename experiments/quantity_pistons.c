/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_pistons.c - what can be measured of walls that are pistons. Keeps no state. */
#include "experiments/quantity.h"

static const fw_piston *piston_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_scene_observe_piston(experiment->scene, subject.wall);
}

static const fw_piston_account *account_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_piston_observe_account(piston_of(experiment, subject));
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

static void velocity(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, account_of(experiment, subject)->velocity);
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

static void heat(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = account_of(experiment, subject)->heat;
}

static void kinetic_energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_piston_kinetic_energy(piston_of(experiment, subject));
}

static void energy_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_piston_energy_error(piston_of(experiment, subject));
}

static void momentum_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    put(out, fw_piston_momentum_error(piston_of(experiment, subject)));
}

static void unresolved(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = account_of(experiment, subject)->unresolved;
}

static void unmatched(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = account_of(experiment, subject)->unmatched_work;
}

/* clang-format off */
const fw_quantity fw_piston_quantities[] = {
    {"piston-displacement", FW_SCOPE_PISTON, "x y", "length", "since the start", NULL, displacement},
    {"piston-velocity", FW_SCOPE_PISTON, "x y", "length/time", "now", NULL, velocity},
    {"piston-force", FW_SCOPE_PISTON, "x y", "force", "[D(t) + D(t-1)]/2, all that drives the piston", NULL, force},
    {"piston-impulse", FW_SCOPE_PISTON, "x y", "momentum", "of what drives the piston, since the start", NULL, impulse},
    {"piston-work", FW_SCOPE_PISTON, "", "energy", "of what drives the piston, since the start", NULL, work},
    {"piston-heat", FW_SCOPE_PISTON, "", "energy", "taken by the piston's damping since the start", NULL, heat},
    {"piston-kinetic-energy", FW_SCOPE_PISTON, "", "energy", "of the piston itself", NULL, kinetic_energy},
    {"piston-torque", FW_SCOPE_PISTON, "", "energy", "of the bodies about the middle of the piston, which does not turn", NULL, torque},
    {"piston-way", FW_SCOPE_PISTON, "x y", "length", "length of its way since the start, per component", NULL, way},
    {"piston-energy-error", FW_SCOPE_PISTON, "", "energy", "kinetic energy of the piston minus what work and heat say", NULL, energy_error},
    {"piston-momentum-error", FW_SCOPE_PISTON, "x y", "momentum", "momentum of the piston minus what the impulses say", NULL, momentum_error},
    {"piston-unresolved", FW_SCOPE_PISTON, "", "1", "steps since the start in which no motion was found that fits the forces on the piston", NULL, unresolved},
    {"piston-unmatched", FW_SCOPE_PISTON, "", "energy", "work of the bodies on the piston that does not fit its motion: rounding, but for unresolved steps", NULL, unmatched},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL},
};
/* clang-format on */
