/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise_kernels.c - Gaussian numbers for many particles; compiled once for each instruction set.
 * Keeps no state. */
#include "noise_kernels.h"

#include "core/noise_vectors.h"

static void gaussians(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                      double *restrict x, double *restrict y)
{
    fw_naturals lane;
    for (int k = 0; k < FW_WIDTH; ++k) lane[k] = (uint64_t)k;
    for (int begin = 0; begin < count; begin += FW_WIDTH) {
        const fw_naturals particle = (lane + (first + (uint32_t)begin)) & 0xffffffff;
        const fw_vector_pair drawn = fw_noise_gaussians_of(seed, particle, step, stream);
        if (count - begin >= FW_WIDTH) {
            fw_store(x + begin, drawn.x);
            fw_store(y + begin, drawn.y);
        } else {
            for (int k = 0; begin + k < count; ++k)
                x[begin + k] = drawn.x[k], y[begin + k] = drawn.y[k];
        }
    }
}

const fw_noise_kernels FW_KERNELS_HERE(fw_noise) = {.gaussians = gaussians};
