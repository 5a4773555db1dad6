/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise_kernels.h - the loops of noise.c. */
#ifndef FW_NOISE_KERNELS_H
#define FW_NOISE_KERNELS_H

#include "core/instruction_set.h"

#include <stdint.h>

typedef struct fw_noise_kernels {
    /* As fw_noise_gaussians(). */
    void (*gaussians)(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                      double *x, double *y);
    /* As fw_noise_gaussians_of_some(). */
    void (*gaussians_of_some)(uint64_t seed, const int *particles, uint64_t step, uint32_t stream,
                              int count, double *x, double *y);
} fw_noise_kernels;

FW_KERNELS(fw_noise_kernels, fw_noise);

#endif
