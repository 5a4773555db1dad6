/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drive.h - what moves a grip or a piston, each component by itself: forces, or a
 * prescribed path that is followed whatever force it takes.
 *
 * The tether acts at the middle of a step, D = force(t) - k (u + w/2): its energy k u^2/2 is then
 * exact for every time step. A spring that pulled with what it was at the beginning would pump
 * energy into what it holds, by k dt/(4 M) of it per time.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_DRIVE_H
#define FW_DRIVE_H

#include "contact/geometry/path.h"
#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

FW_PUBLIC_BEGIN

/* Forces are totals over what is driven. Time t of the oscillation and of `path` is what
 * has passed since `origin`. */
typedef struct fw_drive {
    bool prescribed_x, prescribed_y; /* follows `path` instead of the forces */
    fw_path path;
    fw_vec2 force;     /* constant */
    fw_vec2 amplitude; /* times sin(2 pi t / period + phase) */
    double period;     /* 0: no oscillation */
    double phase;      /* radians */
    double origin;     /* time of the scene at which t = 0 */
    fw_vec2 tether;    /* stiffness of a spring to where it began, >= 0 */
} fw_drive;

/* amplitude sin(2 pi t / period + phase) at the scene's `time`; zero without a period. */
fw_vec2 fw_drive_oscillation(const fw_drive *drive, double time);
/* Velocity of the path at the end of a tick, see fw_path_velocity. */
fw_vec2 fw_drive_velocity(const fw_drive *drive, double time, double tick);

/* FW_BAD_INPUT for numbers that are not finite, and for a period or tether < 0; `kind` and `name`
 * begin the sentence. */
fw_status fw_drive_check(const fw_drive *drive, const char *kind, const char *name,
                         fw_error *error);

/* The displacement w in the tick that begins at `time`, of a body displaced by u so far:
 * prescribed where the drive says so, otherwise the solution of inertia w = push + D. */
fw_vec2 fw_drive_solve(const fw_drive *drive, fw_sym2 inertia, fw_vec2 push, fw_vec2 u, double time,
                       double tick);

/* dw/dF of that for a force on the body: zero in components that are prescribed. */
fw_sym2 fw_drive_mobility(const fw_drive *drive, fw_sym2 inertia);

/* D for that displacement, of the components that are not prescribed (zero of the others). */
fw_vec2 fw_drive_force(const fw_drive *drive, fw_vec2 u, fw_vec2 w, double time);

FW_PUBLIC_END

#endif
