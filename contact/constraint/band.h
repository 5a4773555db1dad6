/* SPDX-License-Identifier: GPL-3.0-or-later */
/* band.h - S = C C^T of the lines of an island as a band, and what is solved with it. Ends that
 * many lines share, pistons, couple them all: S = B + V V^T with a band B and a column of V for
 * each component of such an end. Systems are solved with the factor of the band alone (Sherman,
 * Morrison and Woodbury). Lines are scaled to S_ii = 1. Shared by band.c, interior.c and box.c,
 * and by nobody else. */
#ifndef FW_BAND_H
#define FW_BAND_H

#include "joint_system.h"

/* Added to the diagonal of lines that are to have no force. */
#define JOINT_HELD_OFF 1e30
/* Solutions are corrected by what is left so often. */
enum { JOINT_CORRECTIONS = 4 };

/* The numbers of one problem, per line, and two bands with the diagonal first. */
typedef struct joint_band {
    int count, width; /* width: entries per line of a band */
    int columns;      /* of V */
    const joint_line *lines;
    double *scale, *want;
    double *lambda, *s, *rest, *step, *s_step, *right, *best;
    double *band, *factor;
    double *wide;   /* V, column after column */
    double *spread; /* V over the factor */
    double *inner;  /* the factor of 1 + V^T V over the band, row after row; and a column */
} joint_band;

/* In place of fmin and fmax, which are calls; the second where the first is no number. */
static inline double joint_smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double joint_larger(double a, double b)
{
    return a > b ? a : b;
}

/* `room` for joint_interior_room() numbers. Scales, wants and all else are the caller's to set. */
joint_band joint_band_open(const joint_system *system, int bandwidth, double *room);
/* S, once the scales are set. */
void joint_band_fill(joint_band *p, const joint_system *system);
/* out = S x */
void joint_band_multiply(const joint_band *p, const double *x, double *out);
/* The factor of S + diagonal; then x = (S + diagonal)^-1 right. */
void joint_band_factorise(joint_band *p, const double *diagonal);
void joint_band_solve(const joint_band *p, const double *right, double *x);

#endif
