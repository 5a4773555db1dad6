/* SPDX-License-Identifier: GPL-3.0-or-later */
/* laws.h - what all tests include first: cmocka and close comparison. */
#ifndef FW_LAWS_H
#define FW_LAWS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

/* Fails with both numbers when |measured - expected| > tolerance or either is not finite. */
#define assert_close(measured, expected, tolerance)                                                \
    do {                                                                                           \
        double fw_m = (measured), fw_e = (expected), fw_t = (tolerance);                           \
        if (!(fabs(fw_m - fw_e) <= fw_t))                                                          \
            fail_msg("%s = %.17g, expected %.17g within %g", #measured, fw_m, fw_e, fw_t);         \
    } while (0)

/* Fails when measured > limit or it is not finite. */
#define assert_below(measured, limit)                                                              \
    do {                                                                                           \
        double fw_m = (measured), fw_l = (limit);                                                  \
        if (!(fw_m < fw_l)) fail_msg("%s = %.17g, expected below %g", #measured, fw_m, fw_l);      \
    } while (0)

#endif
