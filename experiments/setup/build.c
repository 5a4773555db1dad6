/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build.c - what the builders of all models share: starting values per site. Keeps no state.
 * Start reading at fw_build_patterns(). */
#include "experiments/setup/build.h"

#include "core/noise.h"

#include <math.h>
#include <stdlib.h>

/* Patterns that one list may have, so that streams of different lists never meet. */
enum { PATTERNS_MAX = 4096 };

uint32_t fw_build_displacement_stream(int body)
{
    return FW_NOISE_START + (uint32_t)body * 2 * PATTERNS_MAX;
}

uint32_t fw_build_velocity_stream(int body)
{
    return fw_build_displacement_stream(body) + PATTERNS_MAX;
}

fw_status fw_build_fail(const fw_scenario *scenario, int body, fw_status status, fw_error *error)
{
    return fw_scenario_fail_within(scenario, scenario->bodies[body].place, status, error, "body %s",
                                   scenario->bodies[body].name);
}

static fw_vec2 pattern_value(const fw_pattern *pattern, fw_site site, fw_vec2 place, int particle,
                             uint64_t seed, uint32_t stream)
{
    switch (pattern->kind) {
    case FW_PATTERN_UNIFORM:
        return pattern->amplitude;
    case FW_PATTERN_GAUSSIAN: {
        double i = site.i - pattern->centre.x, j = site.j - pattern->centre.y;
        double width2 = pattern->width * pattern->width;
        return fw_vec2_scale(exp(-0.5 * (i * i + j * j) / width2), pattern->amplitude);
    }
    case FW_PATTERN_WAVE: {
        double angle = pattern->wave_vector.x * site.i + pattern->wave_vector.y * site.j;
        return fw_vec2_scale(cos(angle + pattern->phase), pattern->amplitude);
    }
    case FW_PATTERN_PLANE:
        return fw_vec2_scale(cos(fw_vec2_dot(pattern->wave_vector, place) + pattern->phase),
                             pattern->amplitude);
    case FW_PATTERN_GRADIENT: {
        const double *g = pattern->gradient;
        return (fw_vec2){g[0] * place.x + g[1] * place.y, g[2] * place.x + g[3] * place.y};
    }
    case FW_PATTERN_MODE:
        break; /* depends on the material: build_automaton.c adds it */
    case FW_PATTERN_RANDOM:
        return fw_vec2_scale(pattern->random,
                             fw_noise_uniform(seed, (uint32_t)particle, 0, stream));
    }
    return (fw_vec2){0, 0};
}

fw_status fw_build_patterns(const fw_patterns *patterns, const fw_sites *sites,
                            const fw_lattice *lattice, uint64_t seed, uint32_t first_stream,
                            fw_vec2 *values, fw_error *error)
{
    for (int n = 0; n < patterns->count; ++n) {
        const fw_pattern *pattern = &patterns->item[n];
        int *particles, count;
        FW_TRY(fw_selection_particles(&pattern->sites, sites, &particles, &count, error));
        for (int k = 0; k < count; ++k) {
            const int l = particles[k];
            const fw_vec2 place = fw_lattice_vector(lattice, sites->site[l]);
            values[l] = fw_vec2_add(values[l], pattern_value(pattern, sites->site[l], place, l,
                                                             seed, first_stream + (uint32_t)n));
        }
        free(particles);
    }
    return FW_OK;
}
