/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_system.h - the rows of one island as a problem of numbers: z is the point nearest to the
 * origin with C z >= wanted, and z = C^T lambda with lambda >= 0. A row c of C is G A^(1/2), wanted
 * is bound - G w_p, and w = w_p + A^(1/2) z. Shared by joint.c and joint_friction.c (which make
 * it), nearest.c, interior.c, box.c and joint_couple.c (which solve it), band.c, and by nobody
 * else. */
#ifndef FW_JOINT_SYSTEM_H
#define FW_JOINT_SYSTEM_H

#include "core/vec2.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct joint_line {
    int count; /* of ends that can move */
    int end[3];
    fw_vec2 c[3];
    double wanted;
    double length; /* |c| > 0 */
    bool both;     /* c z = wanted, lambda of any sign */
} joint_line;

typedef struct joint_system {
    int line_count, end_count;
    int first_wide, wide_count; /* ends that many lines share */
    joint_line *lines;          /* those that share an end that is not wide lie near each other */
    double *lambda;             /* in: where to begin; out */
    fw_vec2 *z;                 /* out, per end */
} joint_system;

static inline double joint_dot(const joint_line *line, const fw_vec2 *z)
{
    double sum = 0;
    for (int n = 0; n < line->count; ++n) sum += fw_vec2_dot(line->c[n], z[line->end[n]]);
    return sum;
}

/* z = C^T lambda. What the rows weigh to zero, momentum, then is so to rounding: nearly dependent
 * lines let z lean out of what they span wherever else it comes from. */
static inline void joint_add_up(joint_system *system)
{
    for (int e = 0; e < system->end_count; ++e) system->z[e] = (fw_vec2){0, 0};
    for (int n = 0; n < system->line_count; ++n) {
        const joint_line *line = &system->lines[n];
        if (system->lambda[n] == 0) continue;
        for (int k = 0; k < line->count; ++k)
            system->z[line->end[k]] =
                fw_vec2_add(system->z[line->end[k]], fw_vec2_scale(system->lambda[n], line->c[k]));
    }
}

static inline bool joint_is_wide(const joint_system *system, int end)
{
    return end >= system->first_wide && end < system->first_wide + system->wide_count;
}

/* c_a . c_b, of the ends that are not wide */
static inline double joint_product(const joint_system *system, const joint_line *a,
                                   const joint_line *b)
{
    double sum = 0;
    for (int n = 0; n < a->count; ++n)
        for (int m = 0; m < b->count; ++m)
            if (a->end[n] == b->end[m] && !joint_is_wide(system, a->end[n]))
                sum += fw_vec2_dot(a->c[n], b->c[m]);
    return sum;
}

/* Doubles that nearest and interior need for their work. */
size_t joint_nearest_room(int line_count, int end_count);
size_t joint_interior_room(int line_count, int bandwidth, int wide_count);
/* The largest distance between two lines that share an end that is not wide. */
int joint_bandwidth(const joint_system *system, int *first_of_end);

/* For few lines: exact to rounding, whatever depends on what. False where rounding kept it from an
 * end, or where no point suits all lines. */
bool joint_solve_nearest(joint_system *system, double *room);
/* C C^T tau = wanted, where |tau| does not come to its limit; where it does, tau is +- limit, and
 * C C^T tau - wanted has the other sign or none. False where rounding kept it from an end. lambda
 * is tau. */
bool joint_solve_box(joint_system *system, const double *limit, int bandwidth, double *room);
/* For many lines that form a band, but for wide ends. False as above. */
bool joint_solve_interior(joint_system *system, int bandwidth, double *room);

#endif
