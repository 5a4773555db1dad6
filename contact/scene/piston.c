/* SPDX-License-Identifier: GPL-3.0-or-later */
/* piston.c - a rigid wall with a mass.
 * State: the ledger, with place and velocity. Start reading at fw_piston_displacement(). */
#include "contact/scene/piston.h"

#include <stdlib.h>
#include <string.h>

struct fw_piston {
    char *name;
    double mass, damping;
    double energy_at_start;
    fw_vec2 momentum_at_start;
    fw_drive drive;
    fw_piston_ledger ledger;
};

static fw_status check(const char *name, double mass, double damping, const fw_drive *drive,
                       fw_error *error)
{
    if (!(mass > 0 && isfinite(mass)))
        return fw_fail(error, FW_BAD_INPUT, "piston %s: mass %g, expected more than 0", name, mass);
    if (!(damping >= 0 && isfinite(damping)))
        return fw_fail(error, FW_BAD_INPUT, "piston %s: damping %g, expected 0 or more", name,
                       damping);
    return fw_drive_check(drive, "piston", name, error);
}

static fw_vec2 held_by(const fw_drive *drive)
{
    return (fw_vec2){drive->prescribed_x, drive->prescribed_y};
}

fw_status fw_piston_create(fw_piston **piston, const char *name, const fw_piston_def *def,
                           fw_error *error)
{
    *piston = NULL;
    FW_TRY(check(name, def->mass, def->damping, &def->drive, error));
    if (!isfinite(def->velocity.x) || !isfinite(def->velocity.y))
        return fw_fail(error, FW_BAD_INPUT, "piston %s: velocity [%g, %g], expected finite numbers",
                       name, def->velocity.x, def->velocity.y);
    if ((def->drive.prescribed_x && def->velocity.x != 0) ||
        (def->drive.prescribed_y && def->velocity.y != 0))
        return fw_fail(error, FW_BAD_INPUT,
                       "piston %s: velocity [%g, %g], expected 0 in a component that is held", name,
                       def->velocity.x, def->velocity.y);
    fw_piston *made = calloc(1, sizeof *made);
    if (made) made->name = strdup(name);
    if (!made || !made->name) {
        free(made);
        return fw_fail_memory(error, "a piston");
    }
    made->mass = def->mass;
    made->damping = def->damping;
    made->drive = def->drive;
    made->ledger.velocity = def->velocity;
    made->ledger.held = held_by(&def->drive);
    made->energy_at_start = fw_piston_kinetic_energy(made);
    made->momentum_at_start = fw_piston_momentum(made);
    *piston = made;
    return FW_OK;
}

void fw_piston_destroy(fw_piston *piston)
{
    if (!piston) return;
    free(piston->name);
    free(piston);
}

fw_piston_ledger *fw_piston_ledger_of(fw_piston *piston)
{
    return &piston->ledger;
}

const fw_piston_ledger *fw_piston_observe_ledger(const fw_piston *piston)
{
    return &piston->ledger;
}

/* What of a vector belongs to the components that forces move. */
static fw_vec2 driven(const fw_piston_ledger *ledger, fw_vec2 v)
{
    return (fw_vec2){(1 - ledger->held.x) * v.x, (1 - ledger->held.y) * v.y};
}

fw_vec2 fw_piston_momentum(const fw_piston *piston)
{
    return fw_vec2_scale(piston->mass, driven(&piston->ledger, piston->ledger.velocity));
}

double fw_piston_kinetic_energy(const fw_piston *piston)
{
    const fw_vec2 v = driven(&piston->ledger, piston->ledger.velocity);
    return 0.5 * piston->mass * fw_vec2_dot(v, v);
}

double fw_piston_energy_error(const fw_piston *piston)
{
    const fw_piston_ledger *a = &piston->ledger;
    return fw_piston_kinetic_energy(piston) - (piston->energy_at_start + a->work + a->pushed_by +
                                               a->met_work - a->unmatched_work - a->heat);
}

fw_vec2 fw_piston_momentum_error(const fw_piston *piston)
{
    const fw_piston_ledger *a = &piston->ledger;
    const fw_vec2 felt = fw_vec2_add(fw_vec2_subtract(a->pushed, a->unmatched), a->met);
    const fw_vec2 given =
        fw_vec2_add(fw_vec2_add(piston->momentum_at_start, a->impulse), fw_vec2_add(felt, a->drag));
    return fw_vec2_subtract(fw_piston_momentum(piston), given);
}

fw_status fw_piston_set_drive(fw_piston *piston, const fw_drive *drive, double damping,
                              fw_error *error)
{
    FW_TRY(check(piston->name, piston->mass, damping, drive, error));
    const double kinetic = fw_piston_kinetic_energy(piston);
    const fw_vec2 momentum = fw_piston_momentum(piston);
    fw_piston_ledger *ledger = &piston->ledger;
    piston->drive = *drive;
    piston->damping = damping;
    ledger->held = held_by(drive);
    ledger->work += fw_piston_kinetic_energy(piston) - kinetic;
    ledger->impulse =
        fw_vec2_add(ledger->impulse, fw_vec2_subtract(fw_piston_momentum(piston), momentum));
    return FW_OK;
}

/* c */
static double kept(const fw_piston *piston, double tick)
{
    return exp(-piston->damping * tick);
}

/* w over D + R: the mobility. */
static double yielding(const fw_piston *piston, double tick)
{
    return tick * tick * (1 + kept(piston, tick)) / (4 * piston->mass);
}

fw_vec2 fw_piston_displacement(const fw_piston *piston, fw_vec2 push, double time, double tick)
{
    const double inertia = 1 / yielding(piston, tick);
    const fw_vec2 inertial =
        fw_vec2_scale(0.5 * tick * (1 + kept(piston, tick)), piston->ledger.velocity);
    return fw_drive_solve(&piston->drive, fw_sym2_scalar(inertia),
                          fw_vec2_add(fw_vec2_scale(inertia, inertial), push),
                          piston->ledger.displacement, time, tick);
}

fw_sym2 fw_piston_mobility(const fw_piston *piston, double tick)
{
    const fw_drive *drive = &piston->drive;
    const double inertia = 1 / yielding(piston, tick);
    return (fw_sym2){drive->prescribed_x ? 0 : 1 / (inertia + 0.5 * drive->tether.x), 0,
                     drive->prescribed_y ? 0 : 1 / (inertia + 0.5 * drive->tether.y)};
}

fw_vec2 fw_piston_inertial(const fw_piston *piston, double time, double tick)
{
    const fw_vec2 along = fw_piston_displacement(piston, (fw_vec2){0, 0}, time, tick);
    const fw_vec2 inertial =
        fw_vec2_scale(0.5 * tick * (1 + kept(piston, tick)), piston->ledger.velocity);
    return (fw_vec2){piston->drive.prescribed_x ? along.x : inertial.x,
                     piston->drive.prescribed_y ? along.y : inertial.y};
}

bool fw_piston_yields(const fw_piston *piston)
{
    return !piston->drive.prescribed_x || !piston->drive.prescribed_y;
}

void fw_piston_advance(fw_piston *piston, fw_vec2 motion, fw_vec2 push, fw_vec2 met, double work,
                       double torque, double time, double tick)
{
    fw_piston_ledger *ledger = &piston->ledger;
    const fw_drive *drive = &piston->drive;
    const double c = kept(piston, tick), mass = piston->mass;
    const fw_vec2 free = fw_drive_force(drive, ledger->displacement, motion, time);
    const fw_vec2 force = {drive->prescribed_x ? -push.x - met.x : free.x,
                           drive->prescribed_y ? -push.y - met.y : free.y};
    /* w = dt (1 + c) u1 / 2 gives u1, and u1 the force on the piston: D + R, if all fits. */
    const fw_vec2 halfway = driven(ledger, fw_vec2_scale(2 / (tick * (1 + c)), motion));
    const fw_vec2 kick = driven(ledger, fw_vec2_subtract(halfway, ledger->velocity));
    const fw_vec2 felt =
        fw_vec2_subtract(fw_vec2_subtract(fw_vec2_scale(2 * mass / tick, kick), force), met);
    const fw_vec2 unmatched = driven(ledger, fw_vec2_subtract(push, felt));
    const fw_vec2 after = fw_vec2_add(fw_vec2_scale(c, halfway), kick);
    ledger->velocity = (fw_vec2){drive->prescribed_x ? motion.x / tick : after.x,
                                 drive->prescribed_y ? motion.y / tick : after.y};
    ledger->heat += 0.5 * mass * (1 - c * c) * fw_vec2_dot(halfway, halfway);
    ledger->drag = fw_vec2_add(ledger->drag, fw_vec2_scale(-(1 - c) * mass, halfway));
    ledger->reaction = fw_vec2_scale(0.5, fw_vec2_add(ledger->force, force));
    ledger->force = force;
    ledger->torque = torque;
    ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(tick, force));
    ledger->work += fw_vec2_dot(force, motion);
    ledger->pushed = fw_vec2_add(ledger->pushed, fw_vec2_scale(tick, push));
    ledger->pushed_by += work;
    ledger->unmatched = fw_vec2_add(ledger->unmatched, fw_vec2_scale(tick, unmatched));
    ledger->unmatched_work += work - fw_vec2_dot(fw_vec2_subtract(push, unmatched), motion);
    ledger->displacement = fw_vec2_add(ledger->displacement, motion);
    ledger->met = fw_vec2_add(ledger->met, fw_vec2_scale(tick, met));
    ledger->met_work += fw_vec2_dot(met, motion);
    ledger->path_length =
        fw_vec2_add(ledger->path_length, (fw_vec2){fabs(motion.x), fabs(motion.y)});
}
