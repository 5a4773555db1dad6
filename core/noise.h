/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise.h - counter-based random numbers: pure functions of (seed, particle, step, stream), so that
 * they do not depend on threads, on order, or on where a run was resumed. The generator is
 * philox4x32-10 of Random123, with the seed in the key and the rest in the counter.
 *
 * Gaussians are Box and Muller's, with a logarithm, sine and cosine of our own: the same bits with
 * every C library, and loops over particles that a compiler can turn into vector code. */
#ifndef FW_NOISE_H
#define FW_NOISE_H

#include "core/vec2.h"

/* Philox is plain C: with this its header leaves those of the compiler's vector instructions
 * unread, which take longer than all else here. */
#define R123_USE_SSE 0
#include <Random123/philox.h>
#include <stdint.h>

/* What the numbers are for: draws of different streams are independent. */
typedef enum fw_noise_stream {
    FW_NOISE_THERMOSTAT,          /* Langevin noise */
    FW_NOISE_FORCE,               /* random external forces; 65535 streams from here */
    FW_NOISE_PLACEMENT = 1 << 17, /* random sequential placement */
    FW_NOISE_MAXWELL = 1 << 18,   /* thermal velocities */
    FW_NOISE_START = 1 << 24      /* random starts of single sites; all streams from here */
} fw_noise_stream;

/* 128 random bits. */
static inline philox4x32_ctr_t fw_noise_bits(uint64_t seed, uint32_t particle, uint64_t step,
                                             uint32_t stream)
{
    philox4x32_key_t key = {{(uint32_t)seed, (uint32_t)(seed >> 32)}};
    philox4x32_ctr_t counter = {{particle, (uint32_t)step, (uint32_t)(step >> 32), stream}};
    return philox4x32(counter, key);
}

/* Two numbers, uniform in [-1, 1), on a grid of 2^-52. */
static inline fw_vec2 fw_noise_uniform(uint64_t seed, uint32_t particle, uint64_t step,
                                       uint32_t stream)
{
    philox4x32_ctr_t bits = fw_noise_bits(seed, particle, step, stream);
    uint64_t first = ((uint64_t)bits.v[0] << 32 | bits.v[1]) >> 11;
    uint64_t second = ((uint64_t)bits.v[2] << 32 | bits.v[3]) >> 11;
    return (fw_vec2){(double)first * 0x1p-52 - 1, (double)second * 0x1p-52 - 1};
}

/* Two independent Gaussians of mean 0 and variance 1. */
fw_vec2 fw_noise_gaussian(uint64_t seed, uint32_t particle, uint64_t step, uint32_t stream);

/* The same for `count` particles from `first` on: x[k], y[k] belong to particle first + k. */
void fw_noise_gaussians(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                        double *x, double *y);

/* The same for particles[0] to particles[count - 1]. */
void fw_noise_gaussians_of_some(uint64_t seed, const int *particles, uint64_t step, uint32_t stream,
                                int count, double *x, double *y);

#endif
