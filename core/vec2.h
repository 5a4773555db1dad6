/* SPDX-License-Identifier: GPL-3.0-or-later */
/* vec2.h - vectors and symmetric matrices of the plane.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_VEC2_H
#define FW_VEC2_H

#include "core/public.h"

#include <math.h>

FW_PUBLIC_BEGIN

#define FW_PI     3.14159265358979323846
#define FW_TWO_PI 6.28318530717958647693

typedef struct fw_vec2 {
    double x, y;
} fw_vec2;

/* Symmetric 2x2 matrix [[xx, xy], [xy, yy]]. */
typedef struct fw_sym2 {
    double xx, xy, yy;
} fw_sym2;

static inline fw_vec2 fw_vec2_add(fw_vec2 a, fw_vec2 b)
{
    return (fw_vec2){a.x + b.x, a.y + b.y};
}

static inline fw_vec2 fw_vec2_subtract(fw_vec2 a, fw_vec2 b)
{
    return (fw_vec2){a.x - b.x, a.y - b.y};
}

static inline fw_vec2 fw_vec2_scale(double factor, fw_vec2 a)
{
    return (fw_vec2){factor * a.x, factor * a.y};
}

static inline double fw_vec2_dot(fw_vec2 a, fw_vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

/* z component of a x b. */
static inline double fw_vec2_cross(fw_vec2 a, fw_vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/* a turned by a right angle, counter-clockwise. */
static inline fw_vec2 fw_vec2_turn(fw_vec2 a)
{
    return (fw_vec2){-a.y, a.x};
}

static inline fw_sym2 fw_sym2_scalar(double value)
{
    return (fw_sym2){value, 0, value};
}

static inline fw_sym2 fw_sym2_scale(double factor, fw_sym2 m)
{
    return (fw_sym2){factor * m.xx, factor * m.xy, factor * m.yy};
}

static inline fw_sym2 fw_sym2_add(fw_sym2 a, fw_sym2 b)
{
    return (fw_sym2){a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

static inline fw_vec2 fw_sym2_apply(fw_sym2 m, fw_vec2 a)
{
    return (fw_vec2){m.xx * a.x + m.xy * a.y, m.xy * a.x + m.yy * a.y};
}

/* Kahan's product difference: right to the last bit or two even where the terms nearly cancel. */
static inline double fw_sym2_determinant(fw_sym2 m)
{
    double square = m.xy * m.xy;
    double error = fma(-m.xy, m.xy, square);
    return fma(m.xx, m.yy, -square) + error;
}

/* The determinant must not be zero. Each entry is rounded as few times as possible: an error of
 * M^-1 would be a steady gain or loss of energy. */
static inline fw_sym2 fw_sym2_invert(fw_sym2 m)
{
    if (m.xy == 0) return (fw_sym2){1 / m.xx, 0, 1 / m.yy};
    double determinant = fw_sym2_determinant(m);
    return (fw_sym2){m.yy / determinant, -m.xy / determinant, m.xx / determinant};
}

/* How many times the rounding of a is larger in m^-1 a, of a positive m: its condition number after
 * both axes are given their own unit, (1 + |r|)/(1 - |r|) with r = m_xy/(m_xx m_yy)^(1/2). A
 * diagonal matrix has 1, however different its entries. */
static inline double fw_sym2_condition(fw_sym2 m)
{
    const double diagonal = m.xx * m.yy, r = fabs(m.xy) / sqrt(diagonal);
    return m.xy == 0 ? 1 : (1 + r) * (1 + r) * diagonal / fw_sym2_determinant(m);
}

/* m m, which is symmetric. */
static inline fw_sym2 fw_sym2_square(fw_sym2 m)
{
    return (fw_sym2){m.xx * m.xx + m.xy * m.xy, m.xy * (m.xx + m.yy), m.xy * m.xy + m.yy * m.yy};
}

/* a . m b */
static inline double fw_sym2_form(fw_vec2 a, fw_sym2 m, fw_vec2 b)
{
    return fw_vec2_dot(a, fw_sym2_apply(m, b));
}

FW_PUBLIC_END

#endif
