/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise.c - Gaussian numbers by whatever instructions there are. Keeps no state. */
#include "core/noise.h"

#include "noise_kernels.h"

fw_vec2 fw_noise_gaussian(uint64_t seed, uint32_t particle, uint64_t step, uint32_t stream)
{
    fw_vec2 drawn;
    fw_noise_gaussians(seed, particle, step, stream, 1, &drawn.x, &drawn.y);
    return drawn;
}

void fw_noise_gaussians(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                        double *x, double *y)
{
    FW_KERNELS_CHOSEN(fw_noise)->gaussians(seed, first, step, stream, count, x, y);
}

void fw_noise_gaussians_of_some(uint64_t seed, const int *particles, uint64_t step, uint32_t stream,
                                int count, double *x, double *y)
{
    FW_KERNELS_CHOSEN(fw_noise)->gaussians_of_some(seed, particles, step, stream, count, x, y);
}
