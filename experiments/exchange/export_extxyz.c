/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export_extxyz.c - extended XYZ, as ASE, OVITO and MDAnalysis read it: for each frame the number
 * of particles, a line of what the columns are, and a line per particle. Keeps no state.
 *
 * Columns have the names that these programs give a meaning to: species (X, no element), pos, velo,
 * forces, masses, id. Velocities and forces are the results file's own; z is 0 everywhere. */
#include "exported.h"

#include <string.h>

static const char *column_of(const char *vector)
{
    return strcmp(vector, "position") == 0   ? "pos"
           : strcmp(vector, "velocity") == 0 ? "velo"
                                             : "forces";
}

static void write_head(FILE *out, const fw_exported *e, int64_t frame)
{
    const fw_playback *playback = e->playback;
    fprintf(out, "%d\nProperties=species:S:1", playback->particle_count);
    for (int v = 0; v < e->vector_count; ++v)
        fprintf(out, ":%s:R:3", column_of(e->vectors[v].name));
    fputs(":id:I:1:body:I:1", out);
    if (playback->mass) fputs(":masses:R:1", out);
    for (int f = 0; f < playback->field_count; ++f)
        fprintf(out, ":%s:R:1", playback->fields[f].name);
    fprintf(out, " step=%lld time=%.17g pbc=\"F F F\" bodies=\"", (long long)e->steps[frame],
            e->times[frame]);
    for (int b = 0; b < playback->body_count; ++b)
        fprintf(out, "%s%s", b > 0 ? " " : "", playback->bodies[b].name);
    fputs("\"\n", out);
}

static void write_frame(FILE *out, const fw_exported *e, int64_t frame)
{
    const fw_playback *playback = e->playback;
    write_head(out, e, frame);
    for (int i = 0; i < playback->particle_count; ++i) {
        fputc('X', out);
        for (int v = 0; v < e->vector_count; ++v)
            fprintf(out, " %.17g %.17g 0", e->vectors[v].x[i], e->vectors[v].y[i]);
        fprintf(out, " %d %d", i, e->body[i]);
        if (playback->mass) fprintf(out, " %.17g", e->mass[i]);
        for (int f = 0; f < playback->field_count; ++f) fprintf(out, " %.17g", e->fields[f][i]);
        fputc('\n', out);
    }
}

fw_status fw_export_extxyz(fw_exported *e, const char *name, fw_error *error)
{
    return fw_exported_write(e, name, NULL, write_frame, error);
}
