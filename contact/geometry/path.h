/* SPDX-License-Identifier: GPL-3.0-or-later */
/* path.h - prescribed rigid motion, as a pure function of time: displacement from its
 * place in the definition, velocity (t - from) for from <= t <= until, plus
 * amplitude sin(2 pi t / period + phase).
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_PATH_H
#define FW_PATH_H

#include "core/public.h"
#include "core/vec2.h"

FW_PUBLIC_BEGIN

typedef struct fw_path {
    fw_vec2 velocity;
    double from, until; /* time window of the velocity */
    fw_vec2 amplitude;
    double period; /* 0: no oscillation */
    double phase;  /* radians */
} fw_path;

fw_vec2 fw_path_displacement(const fw_path *path, double time);

/* The velocity with which the path comes to `time`, at the end of a tick: that of the oscillation
 * then, and the mean of the constant one over the tick. */
fw_vec2 fw_path_velocity(const fw_path *path, double time, double tick);

FW_PUBLIC_END

#endif
