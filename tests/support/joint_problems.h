/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_problems.h - joint contact problems that tests make by hand: ends, rows, their solution. */
#ifndef FW_TEST_JOINT_PROBLEMS_H
#define FW_TEST_JOINT_PROBLEMS_H

#include "contact/constraint/joint.h"
#include "core/noise.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef struct problem {
    int end_count, row_count;
    fw_joint_end *ends;
    fw_joint_row *rows;
    fw_joint_outcome outcome;
    double seconds;
} problem;

/* Between -1/2 and 1/2. */
static inline double random_of(uint64_t seed, int n)
{
    return 0.5 * fw_noise_uniform(seed, (uint32_t)n, 0, FW_NOISE_PLACEMENT).x;
}

static inline problem with_room(int ends, int rows)
{
    return (problem){.ends = calloc((size_t)ends, sizeof(fw_joint_end)),
                     .rows = calloc((size_t)rows, sizeof(fw_joint_row))};
}

static inline void release(problem *p)
{
    free(p->ends);
    free(p->rows);
}

static inline int add_end(problem *p, fw_vec2 position, fw_vec2 free, fw_sym2 mobility)
{
    p->ends[p->end_count] = (fw_joint_end){
        .position = position, .free = free, .displacement = free, .mobility = mobility};
    return p->end_count++;
}

static inline void add_segment(problem *p, int i, int j, int k)
{
    p->rows[p->row_count++] =
        (fw_joint_row){.kind = FW_JOINT_SEGMENT, .end = {i, j, k}, .fresh = true};
}

static inline void solve_with(problem *p, const fw_joint_springs *springs)
{
    fw_error error;
    fw_joint *joint = fw_joint_create();
    struct timespec from, to;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &from);
    assert_int_equal(fw_joint_solve(joint, p->ends, p->end_count, p->rows, p->row_count, springs,
                                    &p->outcome, &error),
                     FW_OK);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &to);
    p->seconds = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
    fw_joint_destroy(joint);
}

#endif
