/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_energy.c - whether the energy of a scene is what its ledger says.
 * State: the largest energy or work so far. Start reading at fw_scene_check_energy(). */
#include "scene_parts.h"

#include <float.h>
#include <math.h>

/* What energy and ledger may be apart, as a part of the largest energy or work so far, or of the
 * energies now: the kinetic and the elastic one may be large and their sum small. The LB solid and
 * the automaton close their ledgers to rounding, the steps of point masses to 1e-3 at the highest
 * temperatures that their time step allows, and a run whose numbers explode is off by 1: energy and
 * scale are then the same number. */
#define APART_MAX 0.5

static double largest_of(const fw_ledger *ledger)
{
    const double sums[] = {ledger->energy_at_start, fw_ledger_energy(ledger),
                           ledger->external_work,   ledger->wall_work,
                           ledger->grip_work,       ledger->dissipated + ledger->friction_heat,
                           ledger->thermostat_heat, ledger->wall_stored};
    double largest = 0;
    for (size_t n = 0; n < sizeof sums / sizeof *sums; ++n) largest = fmax(largest, fabs(sums[n]));
    return largest;
}

void scene_note_work(fw_scene *scene)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    scene->energy_scale = fmax(scene->energy_scale, largest_of(&ledger));
}

double fw_scene_energy_scale(const fw_scene *scene)
{
    return scene->energy_scale;
}

static bool conserves(const fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b)
        if (!scene->bodies[b].solid->conserves) return false;
    for (int w = 0; w < scene->wall_count; ++w)
        if (fw_wall_surface(scene->walls[w].wall).law == FW_COMPONENTWISE) return false;
    return true;
}

/* Work of the external forces along a last bit of the coordinates: what a body that they only press
 * on a wall has in place of energy. */
static double rounding_of_work(const fw_scene *scene)
{
    double sum = 0;
    for (int b = 0; b < scene->body_count; ++b) {
        const fw_solid *solid = scene->bodies[b].solid;
        for (int i = 0; solid->loaded && i < solid->count; ++i) {
            const fw_vec2 at = fw_solid_position(solid, i);
            sum += (fabs(solid->external_x[i]) + fabs(solid->external_y[i])) *
                   (fabs(at.x) + fabs(at.y) + 1);
        }
    }
    return sum * DBL_EPSILON;
}

fw_status fw_scene_check_energy(const fw_scene *scene, fw_error *error)
{
    const fw_energies now = fw_scene_energies(scene);
    const fw_ledger ledger = fw_scene_ledger(scene);
    const double energy = now.kinetic + now.elastic, expected = fw_ledger_energy(&ledger);
    const double scale = fmax(scene->energy_scale, fabs(now.kinetic) + fabs(now.elastic));
    if (fabs(energy - expected) <= APART_MAX * scale || !conserves(scene)) return FW_OK;
    if (fabs(energy - expected) <= rounding_of_work(scene)) return FW_OK;
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: the energy is %g, the ledger of work and heat has %g, expected a "
                   "difference of at most %g of the largest energy or work so far, %g: the time "
                   "step does not follow this motion",
                   (long long)scene->clock.step, energy, expected, APART_MAX, scale);
}
