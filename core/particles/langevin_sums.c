/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin_sums.c - sums over point masses, in a fixed order. Keeps no state. */
#include "core/particles/langevin.h"

#include <assert.h>
#include <string.h>

void fw_langevin_forget(fw_langevin *solid)
{
    *solid->known = (fw_langevin_known){0};
}

double fw_langevin_kinetic_energy(const fw_langevin *solid)
{
    for (int i = 0; i < solid->head.count; ++i)
        solid->scratch[i] = 0.5 * solid->mass[i] *
                            (solid->velocity_x[i] * solid->velocity_x[i] +
                             solid->velocity_y[i] * solid->velocity_y[i]);
    return fw_array_sum(solid->scratch, (size_t)solid->head.count);
}

static double weighted_sum(const fw_langevin *solid, const double *values)
{
    for (int i = 0; i < solid->head.count; ++i) solid->scratch[i] = solid->mass[i] * values[i];
    return fw_array_sum(solid->scratch, (size_t)solid->head.count);
}

fw_vec2 fw_langevin_momentum(const fw_solid *head)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    fw_langevin_known *known = solid->known;
    if (!known->has_momentum) {
        known->momentum.x = weighted_sum(solid, solid->velocity_x);
        known->momentum.y = weighted_sum(solid, solid->velocity_y);
    }
    known->has_momentum = true;
    return known->momentum;
}

static double total_mass(const fw_langevin *solid)
{
    fw_langevin_known *known = solid->known;
    if (!known->has_mass) known->mass = fw_array_sum(solid->mass, (size_t)solid->head.count);
    known->has_mass = true;
    return known->mass;
}

double fw_langevin_angular_momentum(const fw_solid *head, int first, int count)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    double sum = 0;
    for (int i = first; i < first + count; ++i) {
        const fw_vec2 velocity = {solid->velocity_x[i], solid->velocity_y[i]};
        sum += fw_vec2_cross(fw_solid_position(head, i), fw_vec2_scale(solid->mass[i], velocity));
    }
    return sum;
}

fw_vec2 fw_langevin_centre_of_mass(const fw_solid *head)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    const double mass = total_mass(solid);
    const double x = weighted_sum(solid, head->x);
    return (fw_vec2){x / mass, weighted_sum(solid, head->y) / mass};
}

fw_sym2 fw_langevin_mass(const fw_solid *head)
{
    return fw_sym2_scalar(total_mass((const fw_langevin *)head));
}

void fw_langevin_velocities(const fw_solid *head, double *x, double *y)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    memcpy(x, solid->velocity_x, (size_t)head->count * sizeof *x);
    memcpy(y, solid->velocity_y, (size_t)head->count * sizeof *y);
}

void fw_langevin_masses(const fw_solid *head, double *mass)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    memcpy(mass, solid->mass, (size_t)head->count * sizeof *mass);
}

void fw_langevin_add_heat(const fw_solid *head, int first, int count, fw_vec2 drift, fw_vec2 *heat)
{
    assert(fw_solid_is_langevin(head));
    const fw_langevin *solid = (const fw_langevin *)head;
    for (int i = first; i < first + count; ++i) {
        const double x = solid->velocity_x[i] - drift.x, y = solid->velocity_y[i] - drift.y;
        heat->x += solid->mass[i] * x * x;
        heat->y += solid->mass[i] * y * y;
    }
}
