/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame_kernels.c - rows (x, y, 0) out of two arrays; compiled once for each instruction set. Keeps
 * no state. Start reading at rows(). */
#include "frame_kernels.h"

#include "core/vectors.h"

#include <assert.h>
#include <string.h>

enum { LINE = 64, NUMBERS = LINE / (int)sizeof(double) };

/* Of as many particles as a register holds. */
FW_INLINE void put_rows(fw_vector x, fw_vector y, double *to)
{
#if defined(__AVX512F__)
    const __m512i first = _mm512_setr_epi64(0, 8, 0, 1, 9, 0, 2, 10),
                  second = _mm512_setr_epi64(0, 3, 11, 0, 4, 12, 0, 5),
                  third = _mm512_setr_epi64(13, 0, 6, 14, 0, 7, 15, 0);
    _mm512_storeu_pd(to, _mm512_maskz_permutex2var_pd(0xdb, (__m512d)x, first, (__m512d)y));
    _mm512_storeu_pd(to + 8, _mm512_maskz_permutex2var_pd(0xb6, (__m512d)x, second, (__m512d)y));
    _mm512_storeu_pd(to + 16, _mm512_maskz_permutex2var_pd(0x6d, (__m512d)x, third, (__m512d)y));
#else
    for (int lane = 0; lane < FW_WIDTH; ++lane) {
        to[3 * lane] = x[lane];
        to[3 * lane + 1] = y[lane];
        to[3 * lane + 2] = 0;
    }
#endif
}

/* A line of the cache, to a place that is a multiple of its size. */
FW_INLINE void send_line(double *to, const double *from)
{
#if defined(__AVX512F__)
    _mm512_stream_pd(to, _mm512_load_pd(from));
#elif defined(__AVX2__)
    for (int n = 0; n < NUMBERS; n += 4) _mm256_stream_pd(to + n, _mm256_load_pd(from + n));
#elif defined(__SSE2__)
    for (int n = 0; n < NUMBERS; n += 2) _mm_stream_pd(to + n, _mm_load_pd(from + n));
#else
    memcpy(to, from, LINE);
#endif
}

/* What whole lines do not take is written as usual. */
FW_INLINE void send(double *to, const double *from, int count)
{
    const int past = (int)((uintptr_t)to % LINE / sizeof *to);
    int n = past > 0 ? NUMBERS - past : 0;
    if (n > count) n = count;
    memcpy(to, from, (size_t)n * sizeof *to);
    for (; n + NUMBERS <= count; n += NUMBERS) send_line(to + n, from + n);
    memcpy(to + n, from + n, (size_t)(count - n) * sizeof *to);
}

static void settle(void)
{
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

FW_INLINE void make_rows(const double *x, const double *y, int count, double *to)
{
    int i = 0;
    for (; i + FW_WIDTH <= count; i += FW_WIDTH)
        put_rows(fw_load(x + i), fw_load(y + i), to + 3 * i);
    for (; i < count; ++i) {
        to[3 * i] = x[i];
        to[3 * i + 1] = y[i];
        to[3 * i + 2] = 0;
    }
}

static void rows(const double *x, const double *y, int count, bool past_cache, double *to)
{
    assert(count <= FW_FRAME_BLOCK);
    if (!past_cache) {
        make_rows(x, y, count, to);
        return;
    }
    /* As far behind the beginning of a line as where they go. */
    _Alignas(LINE) double made[3 * FW_FRAME_BLOCK + NUMBERS];
    double *begin = made + (uintptr_t)to % LINE / sizeof *to;
    make_rows(x, y, count, begin);
    send(to, begin, 3 * count);
}

const fw_frame_kernels FW_KERNELS_HERE(fw_frames) = {.rows = rows, .settle = settle};
