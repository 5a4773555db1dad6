/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export_data.c - the last frame as a data file of LAMMPS, from which it (read_data), OVITO, ASE
 * and a scenario of ours (shape: {file: ...}) can start. Keeps no state.
 *
 * Types of atoms are bodies, 1, 2, ... with the mass of the first particle of each: LAMMPS has one
 * mass per type. Ids count from 1. Links are no bonds of LAMMPS and left out. */
#include "core/vec2.h"
#include "experiments/text/text.h"
#include "exported.h"

#include <math.h>

static fw_vec2 range_of(const double *values, int count)
{
    fw_vec2 range = {values[0], values[0]};
    for (int i = 1; i < count; ++i)
        range = (fw_vec2){fmin(range.x, values[i]), fmax(range.y, values[i])};
    return range;
}

static void write_head(FILE *out, const fw_exported *e, int64_t frame)
{
    const fw_playback *playback = e->playback;
    const fw_vec2 x = range_of(e->vectors[0].x, playback->particle_count);
    const fw_vec2 y = range_of(e->vectors[0].y, playback->particle_count);
    fputs("LAMMPS data file, ", out);
    fw_text_print_line(out, playback->title);
    fprintf(out, ", step %lld, time %.17g\n\n%d atoms\n%d atom types\n\n",
            (long long)e->steps[frame], e->times[frame], playback->particle_count,
            playback->body_count);
    /* A length of 1 around what there is: LAMMPS wants all atoms inside of its box. */
    fprintf(out, "%.17g %.17g xlo xhi\n%.17g %.17g ylo yhi\n-0.5 0.5 zlo zhi\n", x.x - 1, x.y + 1,
            y.x - 1, y.y + 1);
    if (!playback->mass) return;
    fputs("\nMasses\n\n", out);
    for (int b = 0; b < playback->body_count; ++b) {
        fprintf(out, "%d %.17g # ", b + 1, e->mass[playback->bodies[b].first]);
        fw_text_print_line(out, playback->bodies[b].name);
        fputc('\n', out);
    }
}

static void write_frame(FILE *out, const fw_exported *e, int64_t frame)
{
    write_head(out, e, frame);
    fputs("\nAtoms # atomic\n\n", out);
    for (int i = 0; i < e->playback->particle_count; ++i)
        fprintf(out, "%d %d %.17g %.17g 0\n", i + 1, e->body[i] + 1, e->vectors[0].x[i],
                e->vectors[0].y[i]);
    if (!e->playback->velocity) return;
    fputs("\nVelocities\n\n", out);
    for (int i = 0; i < e->playback->particle_count; ++i)
        fprintf(out, "%d %.17g %.17g 0\n", i + 1, e->vectors[1].x[i], e->vectors[1].y[i]);
}

fw_status fw_export_data(fw_exported *e, const char *name, fw_error *error)
{
    return fw_exported_write_last(e, name, write_frame, error);
}
