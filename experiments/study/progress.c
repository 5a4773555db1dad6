/* SPDX-License-Identifier: GPL-3.0-or-later */
/* progress.c - the progress line. */
#include "experiments/study/progress.h"

#include <time.h>
#include <unistd.h>

double fw_progress_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

fw_progress fw_progress_begin(FILE *out, const char *name, int64_t first, int64_t last,
                              double particles)
{
    double now = fw_progress_clock();
    if (out && !isatty(fileno(out))) out = NULL;
    return (fw_progress){out, name, first, last, now, now, particles};
}

static void write_time(FILE *out, double seconds)
{
    if (seconds < 60)
        fprintf(out, "%.0f s", seconds);
    else if (seconds < 3600)
        fprintf(out, "%d min %02d s", (int)seconds / 60, (int)seconds % 60);
    else
        fprintf(out, "%.1f h", seconds / 3600);
}

void fw_progress_show(fw_progress *progress, int64_t step)
{
    enum { BAR = 30 };
    if (!progress->out) return;
    double now = fw_progress_clock();
    if (now - progress->shown < 0.1) return;
    progress->shown = now;
    double part = (double)(step - progress->first) / (double)(progress->last - progress->first);
    double rate = (double)(step - progress->first) / (now - progress->started);
    fprintf(progress->out, "\r%s [", progress->name);
    for (int n = 0; n < BAR; ++n) fputc(n < part * BAR ? '#' : '.', progress->out);
    fprintf(progress->out, "] %3.0f %%  %.3g steps/s  %.3g million particle steps/s  ", 100 * part,
            rate, 1e-6 * rate * progress->particles);
    if (rate > 0) {
        write_time(progress->out, (double)(progress->last - step) / rate);
        fputs(" left", progress->out);
    }
    fputs("\033[K", progress->out);
    fflush(progress->out);
}

void fw_progress_end(fw_progress *progress)
{
    if (!progress->out) return;
    fputs("\r\033[K", progress->out);
    fflush(progress->out);
}
