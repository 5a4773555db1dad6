/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_contact.c - what can be measured of bodies that touch each other. Keeps no state. */
#include "experiments/measures/quantity.h"

#define LINKED "lattice-boltzmann linear-lattice elastic-automaton movable-particles"

static const fw_body_ledger *ledger_of(const fw_experiment *experiment, fw_subject subject)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_solid *solid = fw_body_range_solid(experiment->scene, range);
    const int group = fw_body_range_group(experiment->scene, range);
    const bool is_part = group >= 0 && fw_solid_parts(solid, 0, NULL) > 1;
    return fw_scene_body_ledger(experiment->scene, range->solid, is_part ? group : 0);
}

static void body_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->reaction);
}

static void body_impulse(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->impulse);
}

static void body_contacts(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = ledger_of(experiment, subject)->contacts;
}

static void body_stuck(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    out[0] = fw_scene_count_stuck(experiment->scene, range->solid, range->first, range->count);
}

static void body_penetration(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_body_penetration(experiment->scene);
}

static void contact_steps(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->ticks;
}

static void unconverged(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->unconverged;
}

static void residual(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->residual;
}

static void heat(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->heat;
}

static void creep(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->creep;
}

static void overstep(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_contact_ledger(experiment->scene)->overstep;
}

/* clang-format off */
const fw_quantity fw_contact_quantities[] = {
    {"body-force", FW_SCOPE_BODY, "x y", "force", "[F(t) + F(t-1)]/2, of all other bodies on the body", LINKED, body_force, NULL, FW_NEEDS_NOTHING},
    {"body-impulse", FW_SCOPE_BODY, "x y", "momentum", "of all other bodies on the body since the start", LINKED, body_impulse, NULL, FW_NEEDS_NOTHING},
    {"body-contacts", FW_SCOPE_BODY, "", "1", "places in which other bodies pushed the body in the last step", LINKED, body_contacts, NULL, FW_NEEDS_NOTHING},
    {"body-stuck", FW_SCOPE_BODY, "", "1", "its particles that have stuck to what rubs them, a wall or another body, for at least 50 steps on end", NULL, body_stuck, NULL, FW_NEEDS_NOTHING},
    {"body-penetration", FW_SCOPE_SCENE, "", "length", "how deep any particle lies in another body; bodies that keep out of each other", LINKED, body_penetration, NULL, FW_NEEDS_NOTHING},
    {"contact-steps", FW_SCOPE_SCENE, "", "1", "steps since the start in which bodies touched", LINKED, contact_steps, NULL, FW_NEEDS_NOTHING},
    {"contact-unconverged", FW_SCOPE_SCENE, "", "1", "those of them in which normals or friction did not settle: gaps, or the bound of friction, are inexact there, energy and momentum are not", LINKED, unconverged, NULL, FW_NEEDS_NOTHING},
    {"contact-heat", FW_SCOPE_SCENE, "", "energy", "of friction between bodies since the start", LINKED, heat, NULL, FW_NEEDS_NOTHING},
    {"contact-overstep", FW_SCOPE_SCENE, "", "1", "the most by which friction between bodies went beyond its cone since the start, as a part of the widest one of that step", LINKED, overstep, NULL, FW_NEEDS_NOTHING},
    {"contact-creep", FW_SCOPE_SCENE, "", "length", "the furthest that any particle moved along an edge while it stuck to it, since the start", LINKED, creep, NULL, FW_NEEDS_NOTHING},
    {"contact-residual", FW_SCOPE_SCENE, "", "energy", "the most that rounding took or gave where bodies touch, in one step", LINKED, residual, NULL, FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
