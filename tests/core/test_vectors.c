/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_vectors.c - vectors of the least instruction set do what the others' instructions do. */
#include "core/vectors.h"

#include "tests/support/laws.h"

static uint64_t drawn = 88172645463325252u;

/* Marsaglia's xorshift. */
static uint64_t draw(void)
{
    drawn ^= drawn << 13;
    drawn ^= drawn >> 7;
    drawn ^= drawn << 17;
    return drawn;
}

/* Any sign, an exponent up to `spread` from zero, and digits of which often many are 0, or 1. */
static double number(int spread)
{
    uint64_t digits = draw() & 0xfffffffffffff;
    if (draw() % 4 == 0) digits &= ~(uint64_t)0 << draw() % 52;
    if (draw() % 8 == 0) digits = ((uint64_t)1 << draw() % 52) - 1;
    if (draw() % 200 == 0) return 0;
    const double size = 1 + 0x1p-52 * (double)digits;
    return ldexp(draw() & 1 ? size : -size, (int)(draw() % (2 * (unsigned)spread + 1)) - spread);
}

static void a_product_and_a_sum_are_rounded_once(void **state)
{
    (void)state;
    static const int spreads[] = {1, 60, 1020};
    for (int n = 0; n < 600000; ++n) {
        const int spread = spreads[n % 3];
        fw_vector a, b, c;
        for (int k = 0; k < FW_WIDTH; ++k) {
            a[k] = number(spread);
            b[k] = number(spread);
            c[k] = number(spread);
            /* Sums that all but vanish. */
            if (draw() % 3 == 0) c[k] = -a[k] * b[k] * (1 + 0x1p-52 * ((double)(draw() % 3) - 1));
        }
        const fw_vector made = fw_fma(a, b, c);
        for (int k = 0; k < FW_WIDTH; ++k) {
            const double expected = fma(a[k], b[k], c[k]);
            if (made[k] == expected || (isnan(made[k]) && isnan(expected))) continue;
            fail_msg("%a %a + %a makes %a, expected %a", a[k], b[k], c[k], made[k], expected);
        }
    }
}

static void products_are_added_where_the_mask_is_true(void **state)
{
    (void)state;
    for (unsigned bits = 0; bits < 1u << FW_WIDTH; ++bits) {
        const fw_mask mask = fw_mask_of((uint8_t)bits, 0);
        const fw_vector nothing = fw_splat(NAN), five = fw_splat(5);
        const fw_vector a = fw_select(mask, fw_splat(2), nothing);
        const fw_vector made = fw_add_product(mask, a, fw_splat(3), five);
        for (int k = 0; k < FW_WIDTH; ++k) assert_true(made[k] == (bits >> k & 1 ? 11 : 5));
    }
    assert_int_equal(fw_mask_bits(fw_everywhere(), 0), (1 << FW_WIDTH) - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_product_and_a_sum_are_rounded_once),
        cmocka_unit_test(products_are_added_where_the_mask_is_true),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
