/* SPDX-License-Identifier: GPL-3.0-or-later */
/* vectors.h - a register full of doubles, for kernels only (core/instruction_set.h).
 *
 * fw_vector is as wide as the instruction set's registers: FW_WIDTH = 8, 4 or 2 numbers, with
 * arithmetic and + - * / as in C. Data are cut into blocks of FW_BLOCK = 8 on every machine,
 * FW_PARTS registers each, and what is summed over particles is summed in FW_BLOCK lanes: so the
 * same numbers are added in the same order whatever the width. */
#ifndef FW_VECTORS_H
#define FW_VECTORS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(FW_COVERAGE)
/* Branches are counted once, not in each copy. */
#define FW_INLINE static __attribute__((noinline, unused))
#else
#define FW_INLINE static inline __attribute__((always_inline))
#endif

enum {
    FW_BLOCK = 8,
#if defined(__AVX512F__)
    FW_WIDTH = 8,
#elif defined(__AVX2__)
    FW_WIDTH = 4,
#else
    FW_WIDTH = 2,
#endif
    FW_PARTS = FW_BLOCK / FW_WIDTH
};

#if defined(__AVX512F__)
#define FW_VECTOR_BYTES 64
#elif defined(__AVX2__)
#define FW_VECTOR_BYTES 32
#else
#define FW_VECTOR_BYTES 16
#endif

typedef double fw_vector __attribute__((vector_size(FW_VECTOR_BYTES)));
typedef int64_t fw_integers __attribute__((vector_size(FW_VECTOR_BYTES)));
typedef uint64_t fw_naturals __attribute__((vector_size(FW_VECTOR_BYTES)));

/* A vector of the plane in each lane. */
typedef struct fw_vector_pair {
    fw_vector x, y;
} fw_vector_pair;

/* Of each lane: true or false. */
#if defined(__AVX512F__)
typedef __mmask8 fw_mask;
#else
typedef fw_integers fw_mask;
#endif

FW_INLINE fw_vector fw_splat(double value)
{
    return value - (fw_vector){0};
}

/* From any address. */
FW_INLINE fw_vector fw_load(const double *from)
{
    fw_vector v;
    memcpy(&v, from, sizeof v);
    return v;
}

FW_INLINE void fw_store(double *to, fw_vector v)
{
    memcpy(to, &v, sizeof v);
}

FW_INLINE fw_vector_pair fw_load_pair(const double *x, const double *y, int at)
{
    return (fw_vector_pair){fw_load(x + at), fw_load(y + at)};
}

FW_INLINE void fw_store_pair(double *x, double *y, int at, fw_vector_pair v)
{
    fw_store(x + at, v.x);
    fw_store(y + at, v.y);
}

FW_INLINE fw_vector fw_root(fw_vector v)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_sqrt_pd((__m512d)v);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_sqrt_pd((__m256d)v);
#else
    for (int lane = 0; lane < FW_WIDTH; ++lane) v[lane] = sqrt(v[lane]);
    return v;
#endif
}

/* v, as if it became known only here: what is computed from it stays behind the branch that this is
 * in. Compilers would have roots computed beforehand, wanted or not. */
FW_INLINE fw_vector fw_only_here(fw_vector v)
{
#if defined(__AVX512F__)
    __asm__ volatile("" : "+v"(v));
#elif defined(__SSE2__)
    __asm__ volatile("" : "+x"(v));
#endif
    return v;
}

FW_INLINE fw_vector fw_floor(fw_vector v)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_floor_pd((__m512d)v);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_floor_pd((__m256d)v);
#else
    for (int lane = 0; lane < FW_WIDTH; ++lane) v[lane] = floor(v[lane]);
    return v;
#endif
}

#if !defined(__AVX2__) && defined(__SSE2__)
/* a + b = sum + rest exactly (Knuth, The Art of Computer Programming 2, 4.2.2). */
typedef struct fw_exact {
    fw_vector value, rest;
} fw_exact;

FW_INLINE fw_exact fw_exact_sum(fw_vector a, fw_vector b)
{
    const fw_vector sum = a + b, part = sum - a;
    return (fw_exact){sum, (a - (sum - part)) + (b - part)};
}

/* a b = product + rest exactly: both are cut into halves of 26 digits (Dekker 1971). */
FW_INLINE fw_exact fw_exact_product(fw_vector a, fw_vector b)
{
    const fw_vector wide_a = a * 0x8000001p0, wide_b = b * 0x8000001p0;
    const fw_vector high_a = wide_a - (wide_a - a), low_a = a - high_a;
    const fw_vector high_b = wide_b - (wide_b - b), low_b = b - high_b;
    const fw_vector product = a * b;
    const fw_vector rest =
        ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b;
    return (fw_exact){product, rest};
}

/* a + b, rounded to the neighbour whose last digit is odd where it is not exact. */
FW_INLINE fw_vector fw_odd_sum(fw_vector a, fw_vector b)
{
    const fw_exact sum = fw_exact_sum(a, b);
    const fw_integers bits = (fw_integers)sum.value;
    const fw_integers away = ((bits ^ (fw_integers)sum.rest) >> 63) | 1; /* 1 or -1 */
    const fw_integers even = (bits & 1) - 1, inexact = (fw_integers)(sum.rest != 0);
    return (fw_vector)(bits + (away & even & inexact));
}

/* Neither products nor their rests overflow or underflow. */
FW_INLINE bool fw_is_moderate(fw_vector a, fw_vector b, fw_vector c)
{
    const fw_integers sign = (fw_integers){0} + INT64_MIN;
    const fw_vector size_a = (fw_vector)((fw_integers)a & ~sign),
                    size_b = (fw_vector)((fw_integers)b & ~sign),
                    size_c = (fw_vector)((fw_integers)c & ~sign);
    const fw_integers bounded = (size_a < 0x1p400) & (size_b < 0x1p400) & (size_c < 0x1p400);
    const fw_integers normal = (size_a > 0x1p-400) & (size_b > 0x1p-400);
    return _mm_movemask_pd((__m128d)(bounded & normal)) == 3;
}
#endif

/* a b + c, rounded once. Where the instruction set has none, it is put together from sums that are
 * rounded often (Boldo and Melquiond 2008, Emulation of FMA and correctly rounded sums): some fifty
 * operations. */
FW_INLINE fw_vector fw_fma(fw_vector a, fw_vector b, fw_vector c)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#else
#if defined(__SSE2__)
    if (fw_is_moderate(a, b, c)) {
        const fw_exact product = fw_exact_product(a, b), low = fw_exact_sum(c, product.rest);
        const fw_exact high = fw_exact_sum(product.value, low.value);
        return high.value + fw_odd_sum(low.rest, high.rest);
    }
#endif
    for (int lane = 0; lane < FW_WIDTH; ++lane) c[lane] = fma(a[lane], b[lane], c[lane]);
    return c;
#endif
}

/* --- masks --- */

FW_INLINE fw_mask fw_less(fw_vector a, fw_vector b)
{
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ);
#else
    return (fw_mask)(a < b);
#endif
}

/* The same where `among` is true; false elsewhere. */
FW_INLINE fw_mask fw_less_among(fw_mask among, fw_vector a, fw_vector b)
{
#if defined(__AVX512F__)
    return _mm512_mask_cmp_pd_mask(among, (__m512d)a, (__m512d)b, _CMP_LT_OQ);
#else
    return among & (fw_mask)(a < b);
#endif
}

/* Bits of the first `count` lanes of a block, or of all where there are more. */
FW_INLINE uint8_t fw_first_lanes(int count)
{
    return count >= FW_BLOCK ? 0xff : (uint8_t)((1 << count) - 1);
}

/* Lane k of part `part` of a block is bit part FW_WIDTH + k. */
FW_INLINE fw_mask fw_mask_of(uint8_t bits, int part)
{
#if defined(__AVX512F__)
    (void)part;
    return bits;
#else
    fw_integers bit;
    for (int lane = 0; lane < FW_WIDTH; ++lane) bit[lane] = 1 << lane;
    return (((bits >> part * FW_WIDTH) - (fw_integers){0}) & bit) == bit;
#endif
}

FW_INLINE fw_mask fw_everywhere(void)
{
#if defined(__AVX512F__)
    return 0xff;
#else
    return (fw_mask){0} == 0;
#endif
}

/* The other way round: bits of this part at their place in the block. */
FW_INLINE uint8_t fw_mask_bits(fw_mask mask, int part)
{
#if defined(__AVX512F__)
    (void)part;
    return mask;
#elif defined(__AVX2__)
    return (uint8_t)(_mm256_movemask_pd((__m256d)mask) << part * FW_WIDTH);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < FW_WIDTH; ++lane) bits |= (unsigned)(mask[lane] & 1) << lane;
    return (uint8_t)(bits << part * FW_WIDTH);
#endif
}

FW_INLINE bool fw_any(fw_mask mask)
{
    return fw_mask_bits(mask, 0) != 0;
}

FW_INLINE fw_mask fw_and(fw_mask a, fw_mask b)
{
    return (fw_mask)(a & b);
}

/* |v| */
FW_INLINE fw_vector fw_size(fw_vector v)
{
    return (fw_vector)((fw_integers)v & INT64_MAX);
}

FW_INLINE fw_vector fw_larger(fw_vector a, fw_vector b)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    const fw_mask first = a > b;
    return (fw_vector)((first & (fw_integers)a) | (~first & (fw_integers)b));
#endif
}

FW_INLINE fw_vector fw_smaller(fw_vector a, fw_vector b)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
    const fw_mask first = a < b;
    return (fw_vector)((first & (fw_integers)a) | (~first & (fw_integers)b));
#endif
}

/* Lanes where the mask is true; the others are +0. */
FW_INLINE fw_vector fw_load_some(const double *from, fw_mask mask)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_maskz_loadu_pd(mask, from);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_maskload_pd(from, (__m256i)mask);
#else
    fw_vector v = {0};
    for (int lane = 0; lane < FW_WIDTH; ++lane)
        if (mask[lane]) v[lane] = from[lane];
    return v;
#endif
}

/* Where the mask is false nothing is written. */
FW_INLINE void fw_store_some(double *to, fw_mask mask, fw_vector v)
{
#if defined(__AVX512F__)
    _mm512_mask_storeu_pd(to, mask, (__m512d)v);
#elif defined(__AVX2__)
    _mm256_maskstore_pd(to, (__m256i)mask, (__m256d)v);
#else
    for (int lane = 0; lane < FW_WIDTH; ++lane)
        if (mask[lane]) to[lane] = v[lane];
#endif
}

/* v where the mask is true, +0 elsewhere. */
FW_INLINE fw_vector fw_keep(fw_mask mask, fw_vector v)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_maskz_mov_pd(mask, (__m512d)v);
#else
    return (fw_vector)(mask & (fw_integers)v);
#endif
}

/* c + a b, rounded once, where the mask is true; c elsewhere. */
FW_INLINE fw_vector fw_add_chosen(fw_mask mask, fw_vector a, fw_vector b, fw_vector c)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_mask3_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c, mask);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_blendv_pd((__m256d)c, (__m256d)fw_fma(a, b, c), (__m256d)mask);
#else
    const fw_integers sum = (fw_integers)fw_fma(a, b, c);
    return (fw_vector)((mask & sum) | (~mask & (fw_integers)c));
#endif
}

/* The same for c that is not -0. With AVX2 +0 is added elsewhere: a sum that grows by such steps
 * then waits for one instruction only. Not without fma: nothing but fw_fma's slow way adds 0. */
FW_INLINE fw_vector fw_add_product(fw_mask mask, fw_vector a, fw_vector b, fw_vector c)
{
#if defined(__AVX2__) && !defined(__AVX512F__)
    return fw_fma((fw_vector)(mask & (fw_integers)a), (fw_vector)(mask & (fw_integers)b), c);
#else
    return fw_add_chosen(mask, a, b, c);
#endif
}

FW_INLINE fw_vector fw_select(fw_mask mask, fw_vector yes, fw_vector no)
{
#if defined(__AVX512F__)
    return (fw_vector)_mm512_mask_blend_pd(mask, (__m512d)no, (__m512d)yes);
#elif defined(__AVX2__)
    return (fw_vector)_mm256_blendv_pd((__m256d)no, (__m256d)yes, (__m256d)mask);
#else
    return (fw_vector)((mask & (fw_integers)yes) | (~mask & (fw_integers)no));
#endif
}

/* from[index[k]] in lane k, load by load: on many processors that is sooner done than by their
 * instruction for it. */
FW_INLINE fw_vector fw_gather(const double *from, const int32_t *index)
{
#if defined(__AVX512F__)
    return (fw_vector){from[index[0]], from[index[1]], from[index[2]], from[index[3]],
                       from[index[4]], from[index[5]], from[index[6]], from[index[7]]};
#elif defined(__AVX2__)
    return (fw_vector){from[index[0]], from[index[1]], from[index[2]], from[index[3]]};
#else
    return (fw_vector){from[index[0]], from[index[1]]};
#endif
}

/* --- whole numbers --- */

/* The product of the lower 32 bits of each lane. */
FW_INLINE fw_naturals fw_multiply_low(fw_naturals a, fw_naturals b)
{
#if defined(__AVX512F__)
    return (fw_naturals)_mm512_mul_epu32((__m512i)a, (__m512i)b);
#elif defined(__AVX2__)
    return (fw_naturals)_mm256_mul_epu32((__m256i)a, (__m256i)b);
#else
    return (a & 0xffffffff) * (b & 0xffffffff);
#endif
}

/* n < 2^53, exactly: without an instruction for it both halves are written into the mantissa of a
 * power of two. */
FW_INLINE fw_vector fw_from_naturals(fw_naturals n)
{
#if defined(__AVX512DQ__)
    return (fw_vector)_mm512_cvtepu64_pd((__m512i)n);
#else
    const fw_naturals high = (n >> 32) | 0x4530000000000000,
                      low = (n & 0xffffffff) | 0x4330000000000000;
    return ((fw_vector)high - 0x1p84) + ((fw_vector)low - 0x1p52);
#endif
}

/* --- sums --- */

/* The sum of the lanes of a block, always in the same order. */
FW_INLINE double fw_sum_block(const fw_vector parts[FW_PARTS])
{
    double lanes[FW_BLOCK];
    for (int part = 0; part < FW_PARTS; ++part) fw_store(lanes + part * FW_WIDTH, parts[part]);
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
           ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

#endif
