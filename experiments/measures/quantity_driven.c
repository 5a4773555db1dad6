/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_driven.c - what can be measured of what is driven, grips and pistons, and where two
 * bodies rub. Keeps no state. */
#include "experiments/measures/quantity.h"

#include <math.h>

/* --- what grips and pistons have in common --- */

typedef struct driven {
    fw_vec2 displacement, reaction, impulse, path_length;
    double torque, work;
} driven;

static driven driven_of(const fw_experiment *experiment, fw_subject subject)
{
    if (subject.grip >= 0) {
        const fw_grip_ledger *a =
            fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, subject.grip));
        return (driven){a->displacement, a->reaction, a->impulse,
                        a->path_length,  a->torque,   a->work};
    }
    const fw_piston_ledger *a =
        fw_piston_observe_ledger(fw_scene_observe_piston(experiment->scene, subject.wall));
    return (driven){a->displacement, a->reaction, a->impulse, a->path_length, a->torque, a->work};
}

static void displacement(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, driven_of(experiment, subject).displacement);
}

static void force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, driven_of(experiment, subject).reaction);
}

static void impulse(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, driven_of(experiment, subject).impulse);
}

static void path_length(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, driven_of(experiment, subject).path_length);
}

static void torque(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = driven_of(experiment, subject).torque;
}

static void work(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = driven_of(experiment, subject).work;
}

/* --- pistons alone --- */

static const fw_piston *piston_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_scene_observe_piston(experiment->scene, subject.wall);
}

static const fw_piston_ledger *ledger_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_piston_observe_ledger(piston_of(experiment, subject));
}

static void velocity(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->velocity);
}

static void heat(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = ledger_of(experiment, subject)->heat;
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
    fw_quantity_put(out, fw_piston_momentum_error(piston_of(experiment, subject)));
}

static void met(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->met);
}

static void unmatched(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = ledger_of(experiment, subject)->unmatched_work;
}

/* --- where two bodies rub --- */

static void slip(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    fw_quantity_put(out, fw_rubbing_slip(experiment));
}

static void interface_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    fw_quantity_put(out, fw_rubbing_force(experiment));
}

static void contact_return_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_profile *profile = subject.observer ? subject.observer->profile : NULL;
    (void)experiment;
    out[0] = profile ? fw_profile_contact_now(profile) : NAN;
}

/* clang-format off */
const fw_quantity fw_grip_quantities[] = {
    {"grip-displacement", FW_SCOPE_GRIP, "x y", "length", "since the start", NULL, displacement, NULL, FW_NEEDS_NOTHING},
    {"grip-force", FW_SCOPE_GRIP, "x y", "force", "[D(t) + D(t-1)]/2, all that drives the grip", NULL, force, NULL, FW_NEEDS_NOTHING},
    {"grip-impulse", FW_SCOPE_GRIP, "x y", "momentum", "of what drives the grip, since the start", NULL, impulse, NULL, FW_NEEDS_NOTHING},
    {"grip-work", FW_SCOPE_GRIP, "", "energy", "of what drives the grip, since the start", NULL, work, NULL, FW_NEEDS_NOTHING},
    {"grip-torque", FW_SCOPE_GRIP, "", "energy", "of the constraint forces about the grip's centre", NULL, torque, NULL, FW_NEEDS_NOTHING},
    {"grip-path-length", FW_SCOPE_GRIP, "x y", "length", "length of its path since the start, per component", NULL, path_length, NULL, FW_NEEDS_NOTHING},
    {"slip", FW_SCOPE_SCENE, "x y", "length", "displacement of the first grip less that of the second", NULL, slip, "there are fewer than two grips", FW_NEEDS_TWO_GRIPS},
    {"interface-force", FW_SCOPE_SCENE, "x y", "force", "of the second body of movable particles on the first", NULL, interface_force, NULL, FW_NEEDS_TWO_CRYSTALS},
    {"contact-return-force", FW_SCOPE_SCENE, "", "force", "mean length of the net return forces in the profile's contact region", NULL, contact_return_force, "no particle is there", FW_NEEDS_PROFILE},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};

const fw_quantity fw_piston_quantities[] = {
    {"piston-displacement", FW_SCOPE_PISTON, "x y", "length", "since the start", NULL, displacement, NULL, FW_NEEDS_NOTHING},
    {"piston-velocity", FW_SCOPE_PISTON, "x y", "length/time", "of the piston", NULL, velocity, NULL, FW_NEEDS_NOTHING},
    {"piston-force", FW_SCOPE_PISTON, "x y", "force", "[D(t) + D(t-1)]/2, all that drives the piston", NULL, force, NULL, FW_NEEDS_NOTHING},
    {"piston-impulse", FW_SCOPE_PISTON, "x y", "momentum", "of what drives the piston, since the start", NULL, impulse, NULL, FW_NEEDS_NOTHING},
    {"piston-work", FW_SCOPE_PISTON, "", "energy", "of what drives the piston, since the start", NULL, work, NULL, FW_NEEDS_NOTHING},
    {"piston-heat", FW_SCOPE_PISTON, "", "energy", "taken by the piston's damping since the start", NULL, heat, NULL, FW_NEEDS_NOTHING},
    {"piston-kinetic-energy", FW_SCOPE_PISTON, "", "energy", "of the piston itself", NULL, kinetic_energy, NULL, FW_NEEDS_NOTHING},
    {"piston-torque", FW_SCOPE_PISTON, "", "energy", "of the bodies about the middle of the piston, which does not turn", NULL, torque, NULL, FW_NEEDS_NOTHING},
    {"piston-path-length", FW_SCOPE_PISTON, "x y", "length", "length of its path since the start, per component", NULL, path_length, NULL, FW_NEEDS_NOTHING},
    {"piston-energy-error", FW_SCOPE_PISTON, "", "energy", "kinetic energy of the piston minus what work and heat say", NULL, energy_error, NULL, FW_NEEDS_NOTHING},
    {"piston-momentum-error", FW_SCOPE_PISTON, "x y", "momentum", "momentum of the piston minus what the impulses say", NULL, momentum_error, NULL, FW_NEEDS_NOTHING},
    {"piston-meeting-impulse", FW_SCOPE_PISTON, "x y", "momentum", "of the walls and pistons that it `meets`, since the start", NULL, met, NULL, FW_NEEDS_NOTHING},
    {"piston-unmatched", FW_SCOPE_PISTON, "", "energy", "work of the bodies on the piston that does not fit its motion: rounding, unless a soft corner pushes", NULL, unmatched, NULL, FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
