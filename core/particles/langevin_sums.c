/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin_sums.c - sums over point masses, in a fixed order. Keeps no state. */
#include "core/particles/langevin.h"

#include <assert.h>
#include <string.h>

void fw_langevin_forget(fw_langevin *solid)
{
    *solid->known = (fw_langevin_known){0};
}

/* Products are made a run at a time, so that they are summed where they still lie in the cache. */
fw_motion_sums fw_langevin_sum_motion(const fw_langevin *solid, int first, int count)
{
    double kinetic[FW_SUM_RUN], x[FW_SUM_RUN], y[FW_SUM_RUN];
    fw_motion_sums sums = {0};
    const int end = first + count;
    for (int begin = first; begin < end; begin += FW_SUM_RUN) {
        const int run = end - begin < FW_SUM_RUN ? end - begin : FW_SUM_RUN;
        const double *mass = solid->mass + begin;
        const double *vx = solid->velocity_x + begin, *vy = solid->velocity_y + begin;
        for (int k = 0; k < run; ++k) {
            kinetic[k] = 0.5 * mass[k] * (vx[k] * vx[k] + vy[k] * vy[k]);
            x[k] = mass[k] * vx[k];
            y[k] = mass[k] * vy[k];
        }
        sums.kinetic = fw_array_sum_on(sums.kinetic, kinetic, (size_t)run);
        sums.momentum.x = fw_array_sum_on(sums.momentum.x, x, (size_t)run);
        sums.momentum.y = fw_array_sum_on(sums.momentum.y, y, (size_t)run);
    }
    return sums;
}

fw_vec2 fw_langevin_sum_places(const fw_langevin *solid, int first, int count)
{
    double x[FW_SUM_RUN], y[FW_SUM_RUN];
    fw_vec2 sum = {0, 0};
    const int end = first + count;
    for (int begin = first; begin < end; begin += FW_SUM_RUN) {
        const int run = end - begin < FW_SUM_RUN ? end - begin : FW_SUM_RUN;
        const double *mass = solid->mass + begin;
        const double *from_x = solid->head.x + begin, *from_y = solid->head.y + begin;
        for (int k = 0; k < run; ++k) {
            x[k] = mass[k] * from_x[k];
            y[k] = mass[k] * from_y[k];
        }
        sum.x = fw_array_sum_on(sum.x, x, (size_t)run);
        sum.y = fw_array_sum_on(sum.y, y, (size_t)run);
    }
    return sum;
}

static const fw_motion_sums *motion_of_all(const fw_langevin *solid)
{
    fw_langevin_known *known = solid->known;
    if (!known->has_motion) known->motion = fw_langevin_sum_motion(solid, 0, solid->head.count);
    known->has_motion = true;
    return &known->motion;
}

double fw_langevin_kinetic_energy(const fw_langevin *solid)
{
    return motion_of_all(solid)->kinetic;
}

fw_vec2 fw_langevin_momentum(const fw_solid *solid)
{
    return motion_of_all((const fw_langevin *)solid)->momentum;
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
    const fw_vec2 sum = fw_langevin_sum_places(solid, 0, head->count);
    return (fw_vec2){sum.x / mass, sum.y / mass};
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
