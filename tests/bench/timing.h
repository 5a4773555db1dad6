/* SPDX-License-Identifier: GPL-3.0-or-later */
/* timing.h - processor time, and how fast memory streams. */
#ifndef FW_TIMING_H
#define FW_TIMING_H

#include "core/array.h"

#include <stdlib.h>
#include <time.h>

/* Processor time: on one thread the same as time on a machine that does nothing else. */
static inline double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Bytes per second of a += b, 24 for each element, over two arrays of `count` numbers. */
typedef struct fw_stream {
    size_t count;
    double *a, *b;
} fw_stream;

static inline fw_stream stream_of(size_t count)
{
    fw_stream stream = {count, fw_array_of_doubles(count), fw_array_of_doubles(count + 64)};
    if (!stream.a || !stream.b) abort();
    for (size_t n = 0; n < count; ++n) stream.a[n] = stream.b[n] = 1e-3 * (double)n;
    return stream;
}

static inline double stream_rate(fw_stream *stream)
{
    double *restrict a = stream->a;
    /* A start that the first cache does not map upon that of `a`. */
    const double *restrict b = stream->b + 40;
    const double begun = processor_seconds();
    for (size_t n = 0; n < stream->count; ++n) a[n] += b[n];
    return 24 * (double)stream->count / (processor_seconds() - begun);
}

static inline void stream_free(fw_stream *stream)
{
    free(stream->a);
    free(stream->b);
}

#endif
