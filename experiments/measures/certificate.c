/* SPDX-License-Identifier: GPL-3.0-or-later */
/* certificate.c - the worst of what a run promises to keep.
 * State: fw_certificate. Start reading at fw_certificate_look(). */
#include "experiments/measures/certificate.h"

#include "experiments/setup/body_range.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* clang-format off */
const fw_certificate_row fw_certificate_rows[FW_CERTIFICATE_ITEMS] = {
    [FW_CERTIFICATE_PENETRATION] = {"penetration", "length", "how deep any particle lay behind a wall or in another body"},
    [FW_CERTIFICATE_ENERGY] = {"energy", "1", "energy minus what the ledger of work and heat says, over the largest energy or work so far"},
    [FW_CERTIFICATE_MOMENTUM] = {"momentum", "1", "momentum minus what the ledger of impulses says, over the largest impulse so far, or (2 M E)^(1/2) of all bodies with that energy"},
    [FW_CERTIFICATE_OVERSTEP] = {"overstep", "1", "by how much friction went beyond its cone, as a part of the widest one of that step"},
    [FW_CERTIFICATE_CREEP] = {"creep", "length", "how far any particle moved along a wall or an edge while it stuck to it"},
    [FW_CERTIFICATE_UNCONVERGED] = {"unconverged", "1", "steps in which normals or friction of bodies that touch did not settle: gaps, or the bound of friction, are inexact there, energy and momentum are not"},
    [FW_CERTIFICATE_UNRESOLVED] = {"unresolved", "1", "contacts with walls in which no consistent set of them was found"},
    [FW_CERTIFICATE_STEPS] = {"contact-steps", "1", "steps in which bodies touched"},
};
/* clang-format on */

fw_certificate fw_certificate_begin(void)
{
    fw_certificate made = {.worst = {0}};
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n) made.worst[n] = NAN;
    return made;
}

/* A number that is none, such as an energy that overflowed, stays. */
static void note(fw_certificate *certificate, fw_certificate_item item, double value)
{
    double *worst = &certificate->worst[item];
    if (isnan(*worst) || !(value <= *worst)) *worst = value;
}

static bool bodies_meet(const fw_scene *scene)
{
    for (int a = 0; a < fw_scene_body_count(scene); ++a)
        for (int b = 0; b < a; ++b)
            if (fw_scene_bodies_meet(scene, a, b)) return true;
    return false;
}

static double size_of(fw_vec2 v)
{
    return sqrt(fw_vec2_dot(v, v));
}

/* The largest impulse that a wall, a grip or the loads gave, or the momentum of the bodies if all
 * of the energy moved them as one, (2 M E)^(1/2). */
static double momentum_scale(const fw_experiment *experiment, const fw_ledger *ledger)
{
    const fw_scene *scene = experiment->scene;
    double mass = 0, largest = fmax(size_of(ledger->external_impulse), size_of(ledger->drag));
    for (int w = 0; w < fw_scene_wall_count(scene); ++w)
        largest = fmax(largest, size_of(fw_scene_wall_ledger(scene, w)->impulse));
    for (int g = 0; g < fw_scene_grip_count(scene); ++g)
        largest = fmax(largest,
                       size_of(fw_grip_observe_ledger(fw_scene_observe_grip(scene, g))->impulse));
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_sym2 own = fw_body_range_mass(scene, &experiment->bodies[b]);
        mass += fmax(own.xx, own.yy);
    }
    return fmax(largest, sqrt(2 * mass * fw_scene_energy_scale(scene)));
}

/* A ledger lacks so much of what is of that size. */
static void note_lack(fw_certificate *certificate, fw_certificate_item item, double lack,
                      double scale)
{
    const int n = (int)item - (int)FW_CERTIFICATE_ENERGY;
    double *most = &certificate->lacking[n];
    if (!(lack <= *most)) *most = lack;
    certificate->scale[n] = fmax(certificate->scale[n], scale);
    certificate->worst[item] = *most == 0 ? 0 : *most / certificate->scale[n];
}

static void look_at_ledgers(fw_certificate *certificate, const fw_experiment *experiment)
{
    const fw_scene *scene = experiment->scene;
    const fw_ledger ledger = fw_scene_ledger(scene);
    const fw_energies energies = fw_scene_energies(scene);
    const double energy = energies.kinetic + energies.elastic;
    const double scale = fmax(fabs(energy), fw_scene_energy_scale(scene));
    const fw_vec2 apart = fw_vec2_subtract(fw_scene_momentum(scene), fw_ledger_momentum(&ledger));
    const double most = momentum_scale(experiment, &ledger),
                 size = fmax(fabs(apart.x), fabs(apart.y));
    note_lack(certificate, FW_CERTIFICATE_ENERGY, fabs(energy - fw_ledger_energy(&ledger)), scale);
    note_lack(certificate, FW_CERTIFICATE_MOMENTUM, size, most);
}

static void look_at_walls(fw_certificate *certificate, const fw_scene *scene)
{
    const int walls = fw_scene_wall_count(scene);
    if (walls == 0) return;
    note(certificate, FW_CERTIFICATE_PENETRATION, fw_scene_penetration(scene, -1));
    note(certificate, FW_CERTIFICATE_UNRESOLVED, (double)fw_scene_unresolved(scene));
    for (int w = 0; w < walls; ++w) {
        const fw_wall_ledger *ledger = fw_scene_wall_ledger(scene, w);
        if (fw_wall_surface(fw_scene_wall(scene, w)).law != FW_COULOMB) continue;
        note(certificate, FW_CERTIFICATE_OVERSTEP, ledger->overstep);
        note(certificate, FW_CERTIFICATE_CREEP, ledger->creep);
    }
}

static void look_at_bodies(fw_certificate *certificate, const fw_scene *scene)
{
    const fw_contact_ledger *ledger = fw_scene_contact_ledger(scene);
    if (!bodies_meet(scene)) return;
    note(certificate, FW_CERTIFICATE_PENETRATION, fw_scene_body_penetration(scene));
    note(certificate, FW_CERTIFICATE_UNCONVERGED, ledger->unconverged);
    note(certificate, FW_CERTIFICATE_STEPS, ledger->ticks);
    if (!fw_scene_bodies_rub(scene)) return;
    note(certificate, FW_CERTIFICATE_OVERSTEP, ledger->overstep);
    note(certificate, FW_CERTIFICATE_CREEP, ledger->creep);
}

void fw_certificate_look(fw_certificate *certificate, const fw_experiment *experiment)
{
    look_at_ledgers(certificate, experiment);
    look_at_walls(certificate, experiment->scene);
    look_at_bodies(certificate, experiment->scene);
}

void fw_certificate_join(fw_certificate *certificate, const fw_certificate *other)
{
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n)
        if (!isnan(other->worst[n])) note(certificate, (fw_certificate_item)n, other->worst[n]);
}

void fw_certificate_state(fw_certificate *certificate, fw_state_list *list)
{
    fw_state_list_add(list, "certificate", FW_F64, FW_CERTIFICATE_ITEMS, certificate->worst);
    fw_state_list_add(list, "certificate-lacking", FW_F64, 2, certificate->lacking);
    fw_state_list_add(list, "certificate-scale", FW_F64, 2, certificate->scale);
}

/* --- in a results file --- */

#define GROUP "certificate/"

fw_trajectory_array fw_certificate_array(fw_certificate_item item)
{
    const fw_certificate_row *row = &fw_certificate_rows[item];
    fw_trajectory_array array = {
        .unit = row->unit, .meaning = row->meaning, .rows = 1, .columns = 1};
    snprintf(array.name, sizeof array.name, GROUP "%s", row->name);
    return array;
}

int fw_certificate_find(const char *array_name)
{
    const size_t prefix = strlen(GROUP);
    if (strncmp(array_name, GROUP, prefix) != 0) return -1;
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n)
        if (strcmp(array_name + prefix, fw_certificate_rows[n].name) == 0) return n;
    return -1;
}

fw_status fw_certificate_read(fw_certificate *certificate, fw_playback *playback, fw_error *error)
{
    *certificate = fw_certificate_begin();
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n) {
        const fw_trajectory_array array = fw_certificate_array((fw_certificate_item)n);
        if (fw_playback_array_rows(playback, array.name, 1) != 1) continue;
        FW_TRY(fw_playback_read_array(playback, array.name, 1, 1, &certificate->worst[n], error));
    }
    return fw_playback_check(playback, error);
}

/* --- in words --- */

static void add(char line[FW_CERTIFICATE_SIZE], const char *format, ...)
{
    const size_t length = strlen(line);
    va_list arguments;
    va_start(arguments, format);
    if (length > 0) snprintf(line + length, FW_CERTIFICATE_SIZE - length, ", ");
    const size_t more = strlen(line);
    vsnprintf(line + more, FW_CERTIFICATE_SIZE - more, format, arguments);
    va_end(arguments);
}

void fw_certificate_print(const fw_certificate *certificate, char line[FW_CERTIFICATE_SIZE])
{
    const double *worst = certificate->worst;
    line[0] = '\0';
    if (worst[FW_CERTIFICATE_PENETRATION] == 0)
        add(line, "no penetration");
    else if (!isnan(worst[FW_CERTIFICATE_PENETRATION]))
        add(line, "penetration at most %.2g", worst[FW_CERTIFICATE_PENETRATION]);
    if (!isnan(worst[FW_CERTIFICATE_ENERGY]))
        add(line, "energy ledger closed to %.2g", worst[FW_CERTIFICATE_ENERGY]);
    if (!isnan(worst[FW_CERTIFICATE_MOMENTUM]))
        add(line, "momentum ledger to %.2g", worst[FW_CERTIFICATE_MOMENTUM]);
    if (!isnan(worst[FW_CERTIFICATE_OVERSTEP]))
        add(line, "friction beyond its cone by at most %.2g", worst[FW_CERTIFICATE_OVERSTEP]);
    if (!isnan(worst[FW_CERTIFICATE_CREEP]))
        add(line, "creep while stuck at most %.2g", worst[FW_CERTIFICATE_CREEP]);
    if (!isnan(worst[FW_CERTIFICATE_UNCONVERGED]))
        add(line, "%.0f of %.0f contact steps not converged", worst[FW_CERTIFICATE_UNCONVERGED],
            worst[FW_CERTIFICATE_STEPS]);
    if (!isnan(worst[FW_CERTIFICATE_UNRESOLVED]))
        add(line, "%.0f contacts with walls not resolved", worst[FW_CERTIFICATE_UNRESOLVED]);
}
