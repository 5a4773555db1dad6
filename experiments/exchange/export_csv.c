/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export_csv.c - a row for each particle of each frame, as spreadsheets and data frames read it.
 * Keeps no state. */
#include "experiments/storage/csv.h"
#include "experiments/text/text.h"
#include "exported.h"

#include <string.h>

/* "x", "velocity-x" */
static void write_head(FILE *out, const fw_exported *e)
{
    fputs("# ", out);
    fw_text_print_line(out, e->playback->title);
    fputs("\nstep,time,id,body", out);
    if (e->playback->mass) fputs(",mass", out);
    for (int v = 0; v < e->vector_count; ++v) {
        const char *name = e->vectors[v].name;
        if (v == 0)
            fputs(",x,y", out);
        else
            fprintf(out, ",%s-x,%s-y", name, name);
    }
    for (int f = 0; f < e->playback->field_count; ++f)
        fprintf(out, ",%s", e->playback->fields[f].name);
    fputc('\n', out);
}

static void write_number(FILE *out, double value)
{
    fputc(',', out);
    fw_csv_write_number(out, value);
}

static void write_frame(FILE *out, const fw_exported *e, int64_t frame)
{
    const fw_playback *playback = e->playback;
    for (int i = 0; i < playback->particle_count; ++i) {
        fprintf(out, "%lld,%.17g,%d,%s", (long long)e->steps[frame], e->times[frame], i,
                playback->bodies[e->body[i]].name);
        if (playback->mass) write_number(out, e->mass[i]);
        for (int v = 0; v < e->vector_count; ++v) {
            write_number(out, e->vectors[v].x[i]);
            write_number(out, e->vectors[v].y[i]);
        }
        for (int f = 0; f < playback->field_count; ++f) write_number(out, e->fields[f][i]);
        fputc('\n', out);
    }
}

fw_status fw_export_csv(fw_exported *e, const char *name, fw_error *error)
{
    return fw_exported_write(e, name, write_head, write_frame, error);
}
