/* SPDX-License-Identifier: GPL-3.0-or-later */
/* standing_wave.h - the speed of sound in any solid, as a test sees it: a standing plane wave along
 * x in the middle of a body that is so large that its edges are not felt there before three
 * quarters of a period have passed. Half a period lies between the first two zeros of a
 * displacement there, whatever the phase of the start. */
#ifndef FW_STANDING_WAVE_H
#define FW_STANDING_WAVE_H

#include "core/lattice.h"
#include "core/solid.h"
#include "tests/support/steps.h"

/* For longitudinal waves up to 1.75 times as fast as transverse ones. */
enum { STANDING_LENGTH = 30, STANDING_COLUMNS = 85, STANDING_ROWS = 96 };
/* How far dispersion takes the speed from that of long waves: k^2/24 = 2e-3. */
#define STANDING_ERROR 3e-3

typedef struct standing_wave {
    fw_lattice_kind kind;
    bool longitudinal;
} standing_wave;

static inline fw_vec2 standing_wave_home(const standing_wave *wave, fw_site site)
{
    const fw_lattice lattice = {.kind = wave->kind, .spacing = 1};
    return fw_lattice_position(&lattice, site);
}

/* Displacement at the start, in spacings. */
static inline fw_vec2 standing_wave_at(const standing_wave *wave, fw_site site)
{
    const fw_vec2 middle =
        standing_wave_home(wave, (fw_site){STANDING_COLUMNS / 2, STANDING_ROWS / 2});
    const double x = standing_wave_home(wave, site).x - middle.x;
    const double u = 1e-4 * cos(FW_TWO_PI / STANDING_LENGTH * x);
    return wave->longitudinal ? (fw_vec2){u, 0} : (fw_vec2){0, u};
}

/* Speed in spacings per unit of time, of a rectangle that started so. Destroys the solid. */
static inline double standing_wave_speed(const standing_wave *wave, fw_solid *solid)
{
    const fw_site site = {STANDING_COLUMNS / 2, STANDING_ROWS / 2};
    const int particle = site.j * STANDING_COLUMNS + site.i;
    const fw_vec2 home = standing_wave_home(wave, site);
    const double step = solid->tick * solid->model->ticks_per_step;
    double before = 1, now = 1, time = 0, zeros[2];
    for (int found = 0; found < 2;) {
        for (int tick = 0; tick < solid->model->ticks_per_step; ++tick) advance_free(solid);
        before = now;
        now = wave->longitudinal ? solid->x[particle] - home.x : solid->y[particle] - home.y;
        time += step;
        if (before * now <= 0) zeros[found++] = time - step * now / (now - before);
        if (!isfinite(now) || time > 1e5 * step) fail_msg("no wave");
    }
    fw_solid_destroy(solid);
    return STANDING_LENGTH / 2.0 / (zeros[1] - zeros[0]);
}

#endif
