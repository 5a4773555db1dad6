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
