/* SPDX-License-Identifier: GPL-3.0-or-later */
/* path.c - prescribed motion. Keeps no state. */
#include "contact/geometry/path.h"

fw_vec2 fw_path_displacement(const fw_path *path, double time)
{
    double elapsed = fmin(fmax(time, path->from), path->until) - path->from;
    fw_vec2 displacement = fw_vec2_scale(elapsed, path->velocity);
    if (path->period > 0) {
        /* Whole periods are taken off first: the phase stays exact however late it is. */
        double angle = FW_TWO_PI * fmod(time, path->period) / path->period + path->phase;
        displacement = fw_vec2_add(displacement, fw_vec2_scale(sin(angle), path->amplitude));
    }
    return displacement;
}

fw_vec2 fw_path_velocity(const fw_path *path, double time, double tick)
{
    /* Which part of the tick lies in the time window; time minus tick is not exact. */
    const double part = (fmin(time, path->until) - fmax(time - tick, path->from)) / tick;
    fw_vec2 velocity = fw_vec2_scale(part > 1 - 1e-6 ? 1 : fmax(part, 0), path->velocity);
    if (path->period > 0) {
        const double rate = FW_TWO_PI / path->period;
        const double angle = FW_TWO_PI * fmod(time, path->period) / path->period + path->phase;
        velocity = fw_vec2_add(velocity, fw_vec2_scale(rate * cos(angle), path->amplitude));
    }
    return velocity;
}
