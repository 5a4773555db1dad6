/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise_vectors.h - the numbers of noise.h for as many particles as a register holds; for kernels.
 * Start reading at fw_noise_gaussians_of(). */
#ifndef FW_NOISE_VECTORS_H
#define FW_NOISE_VECTORS_H

#include "core/vec2.h"
#include "core/vectors.h"

enum {
    FW_NOISE_TOGETHER = 2, /* registers whose random words are made together */
    FW_NOISE_RUN = 64      /* particles whose noise is, see fw_noise_gaussians_run() */
};

/* philox4x32-10 (Salmon et al. 2011), a 32-bit word in each lane of 64 bits, of `registers`
 * registers whose rounds take turns: each waits long for its own products. */
FW_INLINE void fw_noise_philox(fw_naturals word[][4], int registers, uint64_t seed)
{
    /* Products take the lower 32 bits of each lane; what stands above them is dropped at the end.
     */
    const fw_naturals none = {0}, low = none + 0xffffffff;
    uint32_t key_a = (uint32_t)seed, key_b = (uint32_t)(seed >> 32);
    for (int round = 0; round < 10; ++round) {
        for (int n = 0; n < registers; ++n) {
            fw_naturals *w = word[n];
            const fw_naturals first = fw_multiply_low(w[0], none + 0xd2511f53);
            const fw_naturals second = fw_multiply_low(w[2], none + 0xcd9e8d57);
            w[0] = (second >> 32) ^ (w[1] ^ (none + key_a));
            w[1] = second;
            w[2] = (first >> 32) ^ (w[3] ^ (none + key_b));
            w[3] = first;
        }
        key_a += 0x9e3779b9;
        key_b += 0xbb67ae85;
    }
    for (int n = 0; n < registers; ++n)
        for (int k = 0; k < 4; ++k) word[n][k] &= low;
}

/* The upper 53 of 64 bits: uniform in [0, 1). */
FW_INLINE fw_vector fw_noise_unit_interval(fw_naturals high, fw_naturals low)
{
    return fw_from_naturals(high << 21 | low >> 11) * 0x1p-53;
}

/* ln u for a normal u > 0: u = 2^e m with m in [sqrt(1/2), sqrt 2), ln m = 2 artanh t with
 * t = (m - 1)/(m + 1), |t| < .172: ten terms of the series leave 1e-17. */
FW_INLINE fw_vector fw_noise_logarithm(fw_vector u)
{
    const fw_naturals bits = (fw_naturals)u;
    /* Adding makes every mantissa above sqrt 2 carry into the exponent. */
    const fw_naturals shifted = bits + (0x3ff0000000000000 - 0x3fe6a09e667f3bcd);
    const fw_naturals biased = shifted >> 52;
    const fw_vector m = (fw_vector)(bits - ((biased - 1023) << 52));
    const fw_vector t = (m - 1) / (m + 1), z = t * t;
    fw_vector series = fw_splat(1. / 19);
    series = fw_fma(series, z, fw_splat(1. / 17));
    series = fw_fma(series, z, fw_splat(1. / 15));
    series = fw_fma(series, z, fw_splat(1. / 13));
    series = fw_fma(series, z, fw_splat(1. / 11));
    series = fw_fma(series, z, fw_splat(1. / 9));
    series = fw_fma(series, z, fw_splat(1. / 7));
    series = fw_fma(series, z, fw_splat(1. / 5));
    series = fw_fma(series, z, fw_splat(1. / 3));
    series = fw_fma(series, z, fw_splat(1));
    const fw_vector exponent = fw_from_naturals(biased) - 1023;
    return fw_fma(exponent, fw_splat(0.69314718055994530942), 2 * t * series);
}

/* (cos, sin) of 2 pi u, 0 <= u < 1: the nearest quarter turn k/4 is taken off, Taylor's series do
 * the rest (|angle| <= pi/4), and the quarter turns it back. */
FW_INLINE fw_vector_pair fw_noise_unit_vector(fw_vector u)
{
    const fw_vector quarters = fw_floor(fw_fma(u, fw_splat(4), fw_splat(0.5)));
    const fw_vector angle = (u - quarters * 0.25) * FW_TWO_PI;
    const fw_vector z = angle * angle;
    fw_vector sine = fw_splat(-1. / 1307674368000);
    sine = fw_fma(sine, z, fw_splat(1. / 6227020800));
    sine = fw_fma(sine, z, fw_splat(-1. / 39916800));
    sine = fw_fma(sine, z, fw_splat(1. / 362880));
    sine = fw_fma(sine, z, fw_splat(-1. / 5040));
    sine = fw_fma(sine, z, fw_splat(1. / 120));
    sine = fw_fma(sine, z, fw_splat(-1. / 6));
    sine = fw_fma(sine * z, angle, angle);
    fw_vector cosine = fw_splat(1. / 20922789888000);
    cosine = fw_fma(cosine, z, fw_splat(-1. / 87178291200));
    cosine = fw_fma(cosine, z, fw_splat(1. / 479001600));
    cosine = fw_fma(cosine, z, fw_splat(-1. / 3628800));
    cosine = fw_fma(cosine, z, fw_splat(1. / 40320));
    cosine = fw_fma(cosine, z, fw_splat(-1. / 720));
    cosine = fw_fma(cosine, z, fw_splat(1. / 24));
    cosine = fw_fma(cosine, z, fw_splat(-1. / 2));
    cosine = fw_fma(cosine, z, fw_splat(1));
    /* k stands in the last bits of 2^52 + k: bit 0 exchanges the two, bit 1 turns both round. */
    const fw_naturals k = (fw_naturals)(quarters + 0x1p52);
    const fw_naturals odd = -(k & 1), half = (k & 2) << 62, quarter = (k & 1) << 63;
    const fw_naturals c = (fw_naturals)cosine, s = (fw_naturals)sine;
    return (fw_vector_pair){(fw_vector)(((c & ~odd) | ((s ^ quarter) & odd)) ^ half),
                            (fw_vector)(((s & ~odd) | (c & odd)) ^ half)};
}

/* u and w of Box and Muller, sqrt(-2 ln(1 - u)) (cos, sin)(2 pi w), with 1 - u in (0, 1]; for the
 * particles of so many registers. */
FW_INLINE void fw_noise_uniforms(uint64_t seed, const fw_naturals *particle, int registers,
                                 uint64_t step, uint32_t stream, fw_vector_pair *uniform)
{
    const fw_naturals none = {0};
    fw_naturals word[FW_NOISE_TOGETHER][4];
    for (int n = 0; n < registers; ++n) {
        word[n][0] = particle[n];
        word[n][1] = none + (step & 0xffffffff);
        word[n][2] = none + (step >> 32);
        word[n][3] = none + stream;
    }
    fw_noise_philox(word, registers, seed);
    for (int n = 0; n < registers; ++n)
        uniform[n] = (fw_vector_pair){fw_noise_unit_interval(word[n][0], word[n][1]),
                                      fw_noise_unit_interval(word[n][2], word[n][3])};
}

FW_INLINE fw_vector fw_noise_length(fw_vector u)
{
    return fw_root(-2 * fw_noise_logarithm(1 - u));
}

/* Two Gaussians for each of these particles. */
FW_INLINE fw_vector_pair fw_noise_gaussians_of(uint64_t seed, fw_naturals particle, uint64_t step,
                                               uint32_t stream)
{
    fw_vector_pair uniform;
    fw_noise_uniforms(seed, &particle, 1, step, stream, &uniform);
    const fw_vector length = fw_noise_length(uniform.x);
    const fw_vector_pair direction = fw_noise_unit_vector(uniform.y);
    return (fw_vector_pair){length * direction.x, length * direction.y};
}

/* The same for FW_NOISE_RUN particles from `first` on, stage by stage: the steps of one register
 * wait for each other, those of neighbouring registers do not. */
FW_INLINE void fw_noise_gaussians_run(uint64_t seed, uint64_t first, uint64_t step, uint32_t stream,
                                      double *restrict x, double *restrict y)
{
    fw_naturals lane;
    for (int k = 0; k < FW_WIDTH; ++k) lane[k] = first + (uint64_t)k;
    for (int at = 0; at < FW_NOISE_RUN; at += FW_NOISE_TOGETHER * FW_WIDTH) {
        fw_naturals particle[FW_NOISE_TOGETHER];
        fw_vector_pair uniform[FW_NOISE_TOGETHER];
        for (int n = 0; n < FW_NOISE_TOGETHER; ++n)
            particle[n] = lane + (uint64_t)(at + n * FW_WIDTH);
        fw_noise_uniforms(seed, particle, FW_NOISE_TOGETHER, step, stream, uniform);
        for (int n = 0; n < FW_NOISE_TOGETHER; ++n)
            fw_store_pair(x, y, at + n * FW_WIDTH, uniform[n]);
    }
    for (int at = 0; at < FW_NOISE_RUN; at += FW_WIDTH)
        fw_store(x + at, fw_noise_length(fw_load(x + at)));
    for (int at = 0; at < FW_NOISE_RUN; at += FW_WIDTH) {
        const fw_vector length = fw_load(x + at);
        const fw_vector_pair direction = fw_noise_unit_vector(fw_load(y + at));
        fw_store_pair(x, y, at, (fw_vector_pair){length * direction.x, length * direction.y});
    }
}

#endif
