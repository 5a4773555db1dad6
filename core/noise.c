/* SPDX-License-Identifier: GPL-3.0-or-later */
/* noise.c - philox numbers turned into Gaussian ones. Keeps no state.
 * Start reading at gaussian(). */
#include "core/noise.h"

#include <math.h>
#include <string.h>

/* The upper 53 of 64 bits: uniform in [0, 1). */
static inline double unit_interval(uint32_t high, uint32_t low)
{
    const uint64_t bits = (uint64_t)high << 21 | low >> 11;
    return (double)(int64_t)bits * 0x1p-53;
}

/* ln u for a normal u > 0: u = 2^e m with m in [sqrt(1/2), sqrt 2), ln m = 2 artanh t with
 * t = (m - 1)/(m + 1), |t| < .172: ten terms of the series leave 1e-17. */
static inline double logarithm(double u)
{
    uint64_t bits;
    memcpy(&bits, &u, sizeof bits);
    /* Adding makes every mantissa above sqrt 2 carry into the exponent. */
    const uint64_t shifted = bits + (0x3ff0000000000000 - 0x3fe6a09e667f3bcd);
    const int64_t exponent = (int64_t)(shifted >> 52) - 1023;
    bits -= (uint64_t)exponent << 52;
    double m;
    memcpy(&m, &bits, sizeof m);
    const double t = (m - 1) / (m + 1), z = t * t;
    double series = 1. / 19;
    series = fma(series, z, 1. / 17);
    series = fma(series, z, 1. / 15);
    series = fma(series, z, 1. / 13);
    series = fma(series, z, 1. / 11);
    series = fma(series, z, 1. / 9);
    series = fma(series, z, 1. / 7);
    series = fma(series, z, 1. / 5);
    series = fma(series, z, 1. / 3);
    series = fma(series, z, 1);
    return fma((double)exponent, 0.69314718055994530942, 2 * t * series);
}

/* (cos, sin) of 2 pi u, 0 <= u < 1: the nearest quarter turn k/4 is taken off, Taylor's series do
 * the rest (|angle| <= pi/4), and the quarter turns it back. */
static inline fw_vec2 unit_vector(double u)
{
    const double quarters = floor(fma(u, 4, 0.5));
    const double angle = (u - quarters * 0.25) * FW_TWO_PI;
    const double z = angle * angle;
    double sine = -1. / 1307674368000;
    sine = fma(sine, z, 1. / 6227020800);
    sine = fma(sine, z, -1. / 39916800);
    sine = fma(sine, z, 1. / 362880);
    sine = fma(sine, z, -1. / 5040);
    sine = fma(sine, z, 1. / 120);
    sine = fma(sine, z, -1. / 6);
    sine = fma(sine * z, angle, angle);
    double cosine = 1. / 20922789888000;
    cosine = fma(cosine, z, -1. / 87178291200);
    cosine = fma(cosine, z, 1. / 479001600);
    cosine = fma(cosine, z, -1. / 3628800);
    cosine = fma(cosine, z, 1. / 40320);
    cosine = fma(cosine, z, -1. / 720);
    cosine = fma(cosine, z, 1. / 24);
    cosine = fma(cosine, z, -1. / 2);
    cosine = fma(cosine, z, 1);
    const int64_t k = (int64_t)quarters;
    const double x = k & 1 ? -sine : cosine, y = k & 1 ? cosine : sine;
    return k & 2 ? (fw_vec2){-x, -y} : (fw_vec2){x, y};
}

/* Box and Muller: sqrt(-2 ln(1 - u)) (cos, sin)(2 pi w). 1 - u lies in (0, 1]. */
static inline fw_vec2 gaussian(philox4x32_ctr_t drawn)
{
    const double u = unit_interval(drawn.v[0], drawn.v[1]);
    const double w = unit_interval(drawn.v[2], drawn.v[3]);
    const double length = sqrt(-2 * logarithm(1 - u));
    const fw_vec2 direction = unit_vector(w);
    return (fw_vec2){length * direction.x, length * direction.y};
}

fw_vec2 fw_noise_gaussian(uint64_t seed, uint32_t particle, uint64_t step, uint32_t stream)
{
    return gaussian(fw_noise_bits(seed, particle, step, stream));
}

void fw_noise_gaussians(uint64_t seed, uint32_t first, uint64_t step, uint32_t stream, int count,
                        double *restrict x, double *restrict y)
{
    for (int k = 0; k < count; ++k) {
        const fw_vec2 pair = gaussian(fw_noise_bits(seed, first + (uint32_t)k, step, stream));
        x[k] = pair.x;
        y[k] = pair.y;
    }
}
