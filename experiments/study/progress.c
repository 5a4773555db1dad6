/* SPDX-License-Identifier: GPL-3.0-or-later */
/* progress.c - the progress line. State: the caller's. Start reading at fw_progress_add(). */
#include "experiments/study/progress.h"

#include "experiments/text/terminal.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <time.h>

enum { LINE = 512, BAR_MIN = 8, BAR_MAX = 30 };

double fw_progress_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

fw_progress fw_progress_begin(FILE *out, const char *label)
{
    fw_progress progress = {.out = out};
    snprintf(progress.label, sizeof progress.label, "%s", label ? label : "run");
    progress.terminal = out && fw_terminal_is(out);
    progress.every = progress.terminal ? 0.1 : 30;
    return progress;
}

static void write_time(char text[32], double seconds)
{
    if (seconds < 60)
        snprintf(text, 32, "%.0f s", seconds);
    else if (seconds < 3600)
        snprintf(text, 32, "%d min %02d s", (int)seconds / 60, (int)seconds % 60);
    else
        snprintf(text, 32, "%.1f h", seconds / 3600);
}

/* "45 %, 3 min 02 s left" */
static void write_state(const fw_progress *progress, double now, char text[96])
{
    const double part = progress->total > 0 ? fmin(1, progress->done / progress->total) : 0;
    const double rate = (progress->done - progress->found) / (now - progress->began);
    char left[32];
    int used = snprintf(text, 96, "%.0f %%", floor(100 * part));
    if (!(rate > 0) || progress->done > progress->total) return;
    write_time(left, (progress->total - progress->done) / rate);
    snprintf(text + used, 96 - (size_t)used, ", %s left", left);
}

/* The rate where there is room, then a bar; a label that is too long is cut. */
static void show_line(const fw_progress *progress, double now)
{
    char state[96], rate[64], line[LINE] = "";
    const int width = progress->width > 0 ? progress->width : fw_terminal_width(progress->out);
    int room = (width < LINE ? width : LINE) - 1;
    write_state(progress, now, state);
    snprintf(rate, sizeof rate, ", %.3g million particle steps/s",
             1e-6 * (progress->done - progress->found) / (now - progress->began));
    room -= (int)strlen(state) + 1;
    int label = (int)strlen(progress->label);
    if (label > room) label = room > 0 ? room : 0;
    room -= label;
    int bar = room - 3 < BAR_MAX ? room - 3 : BAR_MAX;
    const bool rated = room - BAR_MIN - 3 >= (int)strlen(rate);
    if (rated && bar > room - 3 - (int)strlen(rate)) bar = room - 3 - (int)strlen(rate);
    if (bar < BAR_MIN) bar = 0;
    int used = snprintf(line, sizeof line, "%.*s ", label, progress->label);
    if (bar > 0) {
        const double part = progress->total > 0 ? progress->done / progress->total : 0;
        line[used++] = '[';
        for (int n = 0; n < bar; ++n) line[used++] = n < part * bar ? '#' : '.';
        line[used++] = ']';
        line[used++] = ' ';
    }
    snprintf(line + used, sizeof line - (size_t)used, "%s%s", state, rated ? rate : "");
    fprintf(progress->out, "\r%s\033[K", line);
}

static void show(fw_progress *progress)
{
    const double now = fw_progress_clock();
    if (progress->began == 0) progress->began = progress->shown = now;
    if (now - progress->shown < progress->every || now <= progress->began) return;
    progress->shown = now;
    if (progress->terminal) {
        show_line(progress, now);
    } else {
        char state[96];
        write_state(progress, now, state);
        fprintf(progress->out, "%s: %s\n", progress->label, state);
    }
    fflush(progress->out);
}

void fw_progress_name(fw_progress *progress, const char *format, ...)
{
    char label[sizeof progress->label];
    va_list arguments;
    if (!progress) return;
    va_start(arguments, format);
    vsnprintf(label, sizeof label, format, arguments);
    va_end(arguments);
#pragma omp critical(progress)
    memcpy(progress->label, label, sizeof label);
}

void fw_progress_find(fw_progress *progress, double work)
{
    if (!progress || !progress->out) return;
#pragma omp critical(progress)
    {
        progress->done += work;
        progress->found += work;
    }
}

void fw_progress_add(fw_progress *progress, double work)
{
    if (!progress || !progress->out) return;
#pragma omp critical(progress)
    {
        /* Before the first step of all there is nothing to measure a rate by. */
        if (progress->began == 0) progress->found += work;
        progress->done += work;
        show(progress);
    }
}

void fw_progress_end(fw_progress *progress)
{
    if (!progress || !progress->out || !progress->terminal) return;
    fputs("\r\033[K", progress->out);
    fflush(progress->out);
}
