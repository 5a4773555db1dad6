/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise_kernels.c - Gaussian numbers for many particles; compiled once for each instruction set.
 * Keeps no state. */
#include "noise_kernels.h"

#include "core/noise_vectors.h"

FW_INLINE void draw(uint64_t seed, fw_naturals particle, uint64_t step, uint32_t stream, int left,
                    double *x, double *y)
{
    const fw_vector_pair drawn = fw_noise_gaussians_of(seed, particle, step, stream);
    if (left >= FW_WIDTH) {
        fw_store(x, drawn.x);
        fw_store(y, drawn.y);
    } else {
        for (int k = 0; k < left; ++k) x[k] = drawn.x[k], y[k] = drawn.y[k];
    }
}

static void gaussians(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                      double *restrict x, double *restrict y)
{
    fw_naturals lane;
    for (int k = 0; k < FW_WIDTH; ++k) lane[k] = (uint64_t)k;
    for (int begin = 0; begin < count; begin += FW_WIDTH) {
        const fw_naturals particle = (lane + (first + (uint32_t)begin)) & 0xffffffff;
        draw(seed, particle, step, stream, count - begin, x + begin, y + begin);
    }
}

static void gaussians_of_some(uint64_t seed, const int *particles, uint64_t step, uint32_t stream,
                              int count, double *restrict x, double *restrict y)
{
    for (int begin = 0; begin < count; begin += FW_WIDTH) {
        fw_naturals particle = {0};
        for (int k = 0; k < FW_WIDTH && begin + k < count; ++k)
            particle[k] = (uint64_t)particles[begin + k];
        draw(seed, particle, step, stream, count - begin, x + begin, y + begin);
    }
}

const fw_noise_kernels FW_KERNELS_HERE(fw_noise) = {.gaussians = gaussians,
                                                    .gaussians_of_some = gaussians_of_some};
