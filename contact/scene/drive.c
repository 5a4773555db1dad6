/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drive.c - what moves grips and pistons. Keeps no state. Start reading at fw_drive_solve(). */
#include "contact/scene/drive.h"

static bool is_finite(fw_vec2 v)
{
    return isfinite(v.x) && isfinite(v.y);
}

fw_status fw_drive_check(const fw_drive *drive, const char *kind, const char *name, fw_error *error)
{
    const fw_path *path = &drive->path;
    if (!is_finite(drive->force) || !is_finite(drive->amplitude) || !is_finite(drive->tether) ||
        !isfinite(drive->period) || !isfinite(drive->phase) || !isfinite(drive->origin) ||
        !is_finite(path->velocity) || !is_finite(path->amplitude) || !isfinite(path->phase) ||
        !isfinite(path->from) || isnan(path->until) || !isfinite(path->period))
        return fw_fail(error, FW_BAD_INPUT, "%s %s: the drive has a number that is not finite",
                       kind, name);
    if (drive->period < 0 || path->period < 0)
        return fw_fail(error, FW_BAD_INPUT, "%s %s: period %g, expected 0 or more", kind, name,
                       fmin(drive->period, path->period));
    if (drive->tether.x < 0 || drive->tether.y < 0)
        return fw_fail(error, FW_BAD_INPUT, "%s %s: tether [%g, %g], expected 0 or more", kind,
                       name, drive->tether.x, drive->tether.y);
    return FW_OK;
}

fw_vec2 fw_drive_oscillation(const fw_drive *d, double time)
{
    const double t = time - d->origin;
    const double swing = d->period > 0 ? sin(FW_TWO_PI * t / d->period + d->phase) : 0;
    return fw_vec2_scale(swing, d->amplitude);
}

fw_vec2 fw_drive_velocity(const fw_drive *d, double time, double tick)
{
    return fw_path_velocity(&d->path, time - d->origin, tick);
}

/* D without the tether. */
static fw_vec2 free_force(const fw_drive *d, double time)
{
    return fw_vec2_add(d->force, fw_drive_oscillation(d, time));
}

/* What resists w: the tether pulls at the middle of the step. */
static fw_sym2 with_tether(const fw_drive *d, fw_sym2 inertia)
{
    return (fw_sym2){inertia.xx + 0.5 * d->tether.x, inertia.xy, inertia.yy + 0.5 * d->tether.y};
}

fw_vec2 fw_drive_solve(const fw_drive *d, fw_sym2 inertia, fw_vec2 push, fw_vec2 u, double time,
                       double tick)
{
    const fw_vec2 prescribed =
        fw_vec2_subtract(fw_path_displacement(&d->path, time + tick - d->origin),
                         fw_path_displacement(&d->path, time - d->origin));
    const fw_vec2 pull = {d->tether.x * u.x, d->tether.y * u.y};
    const fw_vec2 right = fw_vec2_add(push, fw_vec2_subtract(free_force(d, time), pull));
    const fw_sym2 left = with_tether(d, inertia);
    if (d->prescribed_x && d->prescribed_y) return prescribed;
    if (d->prescribed_x)
        return (fw_vec2){prescribed.x, (right.y - left.xy * prescribed.x) / left.yy};
    if (d->prescribed_y)
        return (fw_vec2){(right.x - left.xy * prescribed.y) / left.xx, prescribed.y};
    return fw_sym2_apply(fw_sym2_invert(left), right);
}

fw_sym2 fw_drive_mobility(const fw_drive *d, fw_sym2 inertia)
{
    const fw_sym2 left = with_tether(d, inertia);
    if (!d->prescribed_x && !d->prescribed_y) return fw_sym2_invert(left);
    return (fw_sym2){d->prescribed_x ? 0 : 1 / left.xx, 0, d->prescribed_y ? 0 : 1 / left.yy};
}

fw_vec2 fw_drive_force(const fw_drive *d, fw_vec2 u, fw_vec2 w, double time)
{
    const fw_vec2 free = free_force(d, time);
    return (fw_vec2){d->prescribed_x ? 0 : free.x - d->tether.x * (u.x + 0.5 * w.x),
                     d->prescribed_y ? 0 : free.y - d->tether.y * (u.y + 0.5 * w.y)};
}
