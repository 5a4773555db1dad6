/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_noise.c - numbers that look random from every side. */
#include "tests/support/laws.h"

#include "core/instruction_set.h"
#include "core/noise.h"

#include <stdlib.h>

/* Random123's own known answers (kat_vectors, philox4x32 10): the generator is what it says. */
static void bits_are_philox(void **state)
{
    (void)state;
    const philox4x32_ctr_t zero = fw_noise_bits(0, 0, 0, 0);
    const uint32_t expected_zero[] = {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8};
    const philox4x32_ctr_t full = fw_noise_bits(UINT64_MAX, UINT32_MAX, UINT64_MAX, UINT32_MAX);
    const uint32_t expected_full[] = {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd};
    for (int word = 0; word < 4; ++word) {
        assert_int_equal(zero.v[word], expected_zero[word]);
        assert_int_equal(full.v[word], expected_full[word]);
    }
}

/* Box and Muller with the C library's functions on the same bits. */
static void gaussians_are_box_and_mullers(void **state)
{
    (void)state;
    const double turn = FW_TWO_PI;
    for (uint32_t i = 0; i < 100000; ++i) {
        const philox4x32_ctr_t bits = fw_noise_bits(11, i, 5, 2);
        const double u = (double)(((uint64_t)bits.v[0] << 32 | bits.v[1]) >> 11) * 0x1p-53;
        const double w = (double)(((uint64_t)bits.v[2] << 32 | bits.v[3]) >> 11) * 0x1p-53;
        const double length = sqrt(-2 * log1p(-u));
        const fw_vec2 drawn = fw_noise_gaussian(11, i, 5, 2);
        /* ln(1 - u) near u = 0 inherits the rounding of 1 - u; the rest is a few ulp of at most 8.
         */
        assert_close(drawn.x, length * cos(turn * w), 1e-14);
        assert_close(drawn.y, length * sin(turn * w), 1e-14);
    }
}

/* The counter of a register's last lanes wraps as each number by itself does. */
static void all_instructions_draw_the_same_bits(void **state)
{
    (void)state;
    enum { COUNT = 4099 };
    static double x[COUNT], y[COUNT], other_x[COUNT], other_y[COUNT];
    const int before = fw_instruction_set();
    fw_error error;
    for (int set = 0; set < FW_INSTRUCTION_SETS; ++set) {
        if (!fw_instruction_set_runs(set)) continue;
        assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), &error), FW_OK);
        fw_noise_gaussians(3, UINT32_MAX - 100, 1ull << 33, 9, COUNT, set == 0 ? x : other_x,
                           set == 0 ? y : other_y);
        if (set == 0) continue;
        assert_memory_equal(x, other_x, sizeof x);
        assert_memory_equal(y, other_y, sizeof y);
    }
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(before), &error), FW_OK);
    assert_int_equal(fw_instruction_set_use("x86-64-v9", &error), FW_BAD_INPUT);
    assert_int_equal(fw_instruction_set(), before);
}

static void many_are_the_same_as_one_by_one(void **state)
{
    (void)state;
    enum { COUNT = 1003 };
    double x[COUNT], y[COUNT];
    fw_noise_gaussians(77, 12345, 1ull << 40, 3, COUNT, x, y);
    for (int k = 0; k < COUNT; ++k) {
        const fw_vec2 one = fw_noise_gaussian(77, 12345u + (uint32_t)k, 1ull << 40, 3);
        assert_true(one.x == x[k] && one.y == y[k]);
    }
}

/* Moments 1 to 6 of 10^7 numbers against those of a Gaussian, each within 4 of its own standard
 * errors sqrt((m_2k - m_k^2)/N), with m_2k the exact moments 1, 3, 15, 105, 945, 10395. */
static void moments_are_gaussian(void **state)
{
    (void)state;
    enum { CHUNK = 1000, CHUNKS = 5000 };
    const double exact[13] = {1, 0, 1, 0, 3, 0, 15, 0, 105, 0, 945, 0, 10395};
    static double x[CHUNK], y[CHUNK];
    double sum[7] = {0};
    for (int chunk = 0; chunk < CHUNKS; ++chunk) {
        fw_noise_gaussians(2024, 0, (uint64_t)chunk, 0, CHUNK, x, y);
        for (int k = 0; k < CHUNK; ++k) {
            double power_x = 1, power_y = 1;
            for (int m = 1; m <= 6; ++m) {
                power_x *= x[k];
                power_y *= y[k];
                sum[m] += power_x + power_y;
            }
        }
    }
    const double count = 2. * CHUNK * CHUNKS;
    for (int m = 1; m <= 6; ++m)
        assert_close(sum[m] / count, exact[m],
                     4 * sqrt((exact[2 * m] - exact[m] * exact[m]) / count));
}

/* Tails: the share beyond 1, 2, 3, 4 against erfc, within 4 binomial errors. */
static void tails_are_gaussian(void **state)
{
    (void)state;
    enum { CHUNK = 1000, CHUNKS = 1000 };
    static double x[CHUNK], y[CHUNK];
    double beyond[5] = {0};
    for (int chunk = 0; chunk < CHUNKS; ++chunk) {
        fw_noise_gaussians(99, 0, (uint64_t)chunk, 1, CHUNK, x, y);
        for (int k = 0; k < CHUNK; ++k)
            for (int s = 1; s < 5; ++s) beyond[s] += (fabs(x[k]) > s) + (fabs(y[k]) > s);
    }
    const double count = 2. * CHUNK * CHUNKS;
    for (int s = 1; s < 5; ++s) {
        const double share = erfc(s / sqrt(2));
        assert_close(beyond[s] / count, share, 4 * sqrt(share * (1 - share) / count));
    }
}

/* Correlations of neighbours in every argument, and of the two components, of a number and of its
 * square: zero within 4/sqrt(N) and 4 * 2/sqrt(N). */
static void nothing_is_correlated(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    const struct {
        uint64_t seed;
        uint32_t particle;
        uint64_t step;
        uint32_t stream;
    } shifts[] = {{1, 0, 0, 0}, {1ull << 32, 0, 0, 0}, {0, 1, 0, 0},
                  {0, 0, 1, 0}, {0, 0, 1ull << 32, 0}, {0, 0, 0, 1}};
    for (size_t s = 0; s <= sizeof shifts / sizeof *shifts; ++s) {
        double product = 0, squares = 0;
        for (uint32_t n = 0; n < COUNT; ++n) {
            const uint32_t particle = 2 * (n % 1000);
            const uint64_t step = 2 * (n / 1000);
            const fw_vec2 a = fw_noise_gaussian(42, particle, step, 0);
            double other = a.y;
            if (s < sizeof shifts / sizeof *shifts)
                other = fw_noise_gaussian(42 + shifts[s].seed, particle + shifts[s].particle,
                                          step + shifts[s].step, shifts[s].stream)
                            .x;
            product += a.x * other;
            squares += (a.x * a.x - 1) * (other * other - 1);
        }
        assert_close(product / COUNT, 0, 4 / sqrt(COUNT));
        assert_close(squares / COUNT, 0, 8 / sqrt(COUNT));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_are_philox),
        cmocka_unit_test(gaussians_are_box_and_mullers),
        cmocka_unit_test(all_instructions_draw_the_same_bits),
        cmocka_unit_test(many_are_the_same_as_one_by_one),
        cmocka_unit_test(moments_are_gaussian),
        cmocka_unit_test(tails_are_gaussian),
        cmocka_unit_test(nothing_is_correlated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
