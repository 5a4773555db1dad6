/* SPDX-License-Identifier: GPL-3.0-or-later */
/* load.c - external forces. State: none that changes; a load is a function of the step, so a
 * resumed run has nothing to restore. */
#include "contact/scene/load.h"

#include "core/noise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct fw_load {
    fw_load_def def;
    int *particles;
    double *mass; /* of the selected particles, for accelerations */
};

fw_status fw_load_create(fw_load **load, const fw_load_def *def, const fw_solid *solid,
                         fw_error *error)
{
    *load = NULL;
    fw_load *made = calloc(1, sizeof *made);
    double *masses = fw_array_of_doubles((size_t)solid->count);
    if (made) {
        made->particles = fw_array_allocate((size_t)def->particle_count, sizeof *made->particles);
        made->mass = fw_array_of_doubles((size_t)def->particle_count);
    }
    if (!made || !masses || !made->particles || !made->mass) {
        free(masses);
        fw_load_destroy(made);
        return fw_fail_memory(error, "the external forces");
    }
    made->def = *def;
    memcpy(made->particles, def->particles, (size_t)def->particle_count * sizeof *def->particles);
    made->def.particles = made->particles;
    solid->model->masses(solid, masses);
    for (int n = 0; n < def->particle_count; ++n) made->mass[n] = masses[def->particles[n]];
    free(masses);
    *load = made;
    return FW_OK;
}

void fw_load_destroy(fw_load *load)
{
    if (!load) return;
    free(load->particles);
    free(load->mass);
    free(load);
}

static bool acts(const fw_load *load, int64_t step)
{
    return load->def.from <= step && step < load->def.until;
}

/* The factor in time: ramp and oscillation. */
static double strength(const fw_load_def *def, int64_t step)
{
    double factor = 1;
    if (def->ramp > 0 && step - def->from < def->ramp)
        factor = (double)(step - def->from + 1) / (double)def->ramp;
    if (def->period > 0) factor *= sin(FW_TWO_PI * (double)step / def->period + def->phase);
    return factor;
}

static fw_vec2 random_force(const fw_load_def *def, int n, int64_t step)
{
    return fw_vec2_scale(def->random, fw_noise_uniform(def->seed, (uint32_t)def->particles[n],
                                                       (uint64_t)step, def->stream));
}

void fw_load_apply(const fw_load *load, int64_t step, fw_solid *solid)
{
    const fw_load_def *def = &load->def;
    if (!acts(load, step)) return;
    const double factor = strength(def, step);
    fw_vec2 mean = {0, 0};
    if (def->kind == FW_LOAD_RANDOM && def->balanced) {
        for (int n = 0; n < def->particle_count; ++n)
            mean = fw_vec2_add(mean, random_force(def, n, step));
        mean = fw_vec2_scale(1.0 / def->particle_count, mean);
    }
    solid->loaded = true;
    for (int n = 0; n < def->particle_count; ++n) {
        fw_vec2 force = def->vector;
        if (def->kind == FW_LOAD_TOTAL) force = fw_vec2_scale(1.0 / def->particle_count, force);
        if (def->kind == FW_LOAD_ACCELERATION) force = fw_vec2_scale(load->mass[n], force);
        if (def->kind == FW_LOAD_RANDOM) force = fw_vec2_subtract(random_force(def, n, step), mean);
        solid->external_x[def->particles[n]] += factor * force.x;
        solid->external_y[def->particles[n]] += factor * force.y;
    }
}
