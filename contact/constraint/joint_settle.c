/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_settle.c - normal forces where ends follow others, exactly: with the weights and tractions
 * as they stand, rows that push hold and the others do not. How ends follow makes the matrix
 * unsymmetric, G (A + K A) G^T with K of joint_leads.c, so that it is solved as it is, by
 * elimination with complete pivoting, for few rows; rows that say the same twice drop out.
 * Whatever set of rows it ends with, displacements belong to the forces, and rows that push hold,
 * so that energy and momentum are kept. State: none. Start reading at joint_settle(). */
#include "joint_parts.h"

#include <math.h>
#include <string.h>

/* More rows are not tried: the work grows with their third power. */
enum { ROWS_MOST = 300 };
/* How often the set of rows that push is changed, as a whole and then one by one; and solutions are
 * corrected. */
enum { PASSES_OF_ALL = 12, PASSES = 100, CORRECTIONS = 2 };
/* A pivot of rows of length 1 that is smaller means that they say the same. */
#define PIVOT_LEAST 1e-11
/* A row that pulls by this part of the largest force, or is passed by that much, is not as it
 * should be. */
#define PULLS  1e-13
#define PASSED 1e-13
/* A row that should hold and is off by more contradicts others. */
#define CONTRADICTS 1e-10

/* Equations, their factors and the order of pivots. */
typedef struct settle {
    fw_joint *joint;
    fw_joint_end *ends;
    fw_joint_row *rows;
    const int *list;
    int count, moving;      /* rows, ends that can move */
    bool pushes[ROWS_MOST]; /* the set that is tried, and its list */
    int pushing[ROWS_MOST];
    int size, rank;
    double *matrix, *factor, *right, *x, *work;
    int row_order[ROWS_MOST], column_order[ROWS_MOST];
    fw_vec2 *alone, *response, *w; /* per end of the island */
} settle;

static size_t room_of(int count, int moving)
{
    const size_t n = (size_t)count;
    return 2 * n * n + 3 * n + 6 * (size_t)moving;
}

static void take_room(settle *s, double *room)
{
    const size_t n = (size_t)s->count;
    s->matrix = room;
    s->factor = s->matrix + n * n;
    s->right = s->factor + n * n;
    s->x = s->right + n;
    s->work = s->x + n;
    s->alone = (fw_vec2 *)(void *)(s->work + n);
    s->response = s->alone + s->moving;
    s->w = s->response + s->moving;
}

static fw_joint_row *row_of(const settle *s, int n)
{
    return &s->rows[s->list[n]];
}

static double length_of(const settle *s, int n)
{
    return s->joint->lines[s->joint->line_of[n]].length;
}

/* Where an end goes without rows and without leads. */
static fw_vec2 unled_of(const settle *s, int e)
{
    const int number = s->joint->global[e];
    const fw_joint_end *end = &s->ends[number];
    const fw_joint_springs *springs = s->joint->springs;
    if (springs) return springs->free(springs->context, number, s->joint->w[e]);
    return end->lead_count > 0 ? end->unled : end->free;
}

/* What leads add to where an end goes. */
static fw_vec2 led(const settle *s, const fw_joint_end *end)
{
    fw_vec2 sum = {0, 0};
    for (int k = 0; k < end->lead_count; ++k) {
        const fw_joint_lead *lead = &end->lead[k];
        const fw_vec2 more = fw_vec2_subtract(s->ends[lead->end].displacement, lead->expected);
        sum = fw_vec2_add(sum, (fw_vec2){fw_vec2_dot(lead->x, more), fw_vec2_dot(lead->y, more)});
    }
    return sum;
}

static void push(const settle *s, const fw_joint_row *row, double force, const fw_vec2 *weight)
{
    for (int k = 0; force != 0 && k < fw_joint_end_count(row); ++k) {
        fw_vec2 *sum = &s->ends[row->end[k]].force;
        *sum = fw_vec2_add(*sum, fw_vec2_scale(force, weight[k]));
    }
}

/* Puts the ends where the forces of all rows take them: leaders first, they follow nobody. */
static void go(const settle *s)
{
    for (int e = 0; e < s->moving; ++e) s->ends[s->joint->global[e]].force = (fw_vec2){0, 0};
    for (int n = 0; n < s->count; ++n)
        push(s, row_of(s, n), row_of(s, n)->lambda, row_of(s, n)->weight);
    for (int n = 0; n < s->count; ++n)
        push(s, row_of(s, n), row_of(s, n)->rub.traction, row_of(s, n)->rub.weight);
    for (int follows = 0; follows < 2; ++follows)
        for (int e = 0; e < s->moving; ++e) {
            fw_joint_end *end = &s->ends[s->joint->global[e]];
            if ((end->lead_count > 0) != (follows > 0)) continue;
            end->free = s->alone[e];
            if (follows) end->free = fw_vec2_add(end->free, led(s, end));
            end->displacement = fw_vec2_add(end->free, fw_sym2_apply(end->mobility, end->force));
        }
}

/* How much further ends go for a force of 1 on the row. */
static void respond(const settle *s, const fw_joint_row *row)
{
    for (int e = 0; e < s->moving; ++e) s->response[e] = (fw_vec2){0, 0};
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &s->ends[row->end[k]];
        const int e = s->joint->local[row->end[k]];
        if (e < 0) continue;
        const fw_vec2 w = fw_sym2_apply(end->mobility, row->weight[k]);
        s->response[e] = fw_vec2_add(s->response[e], w);
        for (int m = 0; m < end->follower_count; ++m) {
            const int f = s->joint->local[end->follower[m]];
            const fw_joint_end *follower = &s->ends[end->follower[m]];
            for (int l = 0; f >= 0 && l < follower->lead_count; ++l) {
                const fw_joint_lead *lead = &follower->lead[l];
                if (lead->end != row->end[k]) continue;
                s->response[f] = fw_vec2_add(
                    s->response[f], (fw_vec2){fw_vec2_dot(lead->x, w), fw_vec2_dot(lead->y, w)});
            }
        }
    }
}

static double weighed(const settle *s, const fw_joint_row *row)
{
    double sum = 0;
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const int e = s->joint->local[row->end[k]];
        if (e >= 0) sum += fw_vec2_dot(row->weight[k], s->response[e]);
    }
    return sum;
}

/* By how much the row is passed. */
static double rest_of(const settle *s, int n)
{
    const fw_joint_row *row = row_of(s, n);
    return row->bound - fw_joint_motion(row, s->ends) - row->compliance * row->lambda;
}

/* Two rows, whose entries are 1 apart and which are `size` apart themselves, or two columns, the
 * other way round; with their places in the order. */
static void swap_lines(settle *s, int *order, size_t one, size_t other, size_t apart, size_t step)
{
    const int place = order[one];
    order[one] = order[other];
    order[other] = place;
    for (size_t k = 0; k < (size_t)s->size; ++k) {
        const double swap = s->factor[one * apart + k * step];
        s->factor[one * apart + k * step] = s->factor[other * apart + k * step];
        s->factor[other * apart + k * step] = swap;
    }
}

/* The largest entry of what is left. */
static double find_pivot(const settle *s, size_t *row, size_t *column)
{
    const size_t n = (size_t)s->size;
    double most = 0;
    for (size_t i = (size_t)s->rank; i < n; ++i)
        for (size_t j = (size_t)s->rank; j < n; ++j)
            if (fabs(s->factor[i * n + j]) > most) {
                most = fabs(s->factor[i * n + j]);
                *row = i;
                *column = j;
            }
    return most;
}

static void factorise(settle *s)
{
    const size_t n = (size_t)s->size;
    double *a = s->factor;
    memcpy(a, s->matrix, n * n * sizeof *a);
    for (int k = 0; k < s->size; ++k) s->row_order[k] = s->column_order[k] = k;
    for (s->rank = 0; s->rank < s->size; ++s->rank) {
        const size_t p = (size_t)s->rank;
        size_t row = p, column = p;
        if (!(find_pivot(s, &row, &column) > PIVOT_LEAST)) return;
        if (row != p) swap_lines(s, s->row_order, row, p, n, 1);
        if (column != p) swap_lines(s, s->column_order, column, p, 1, n);
        for (size_t i = p + 1; i < n; ++i) {
            const double part = a[i * n + p] / a[p * n + p];
            a[i * n + p] = part;
            for (size_t j = p + 1; part != 0 && j < n; ++j) a[i * n + j] -= part * a[p * n + j];
        }
    }
}

/* Adds to x what the right side asks for, of what has a pivot. */
static void solve(settle *s)
{
    const size_t n = (size_t)s->size;
    const double *a = s->factor;
    for (int i = 0; i < s->rank; ++i) {
        s->work[i] = s->right[s->row_order[i]];
        for (int j = 0; j < i; ++j) s->work[i] -= a[(size_t)i * n + (size_t)j] * s->work[j];
    }
    for (int i = s->rank - 1; i >= 0; --i) {
        for (int j = i + 1; j < s->rank; ++j)
            s->work[i] -= a[(size_t)i * n + (size_t)j] * s->work[j];
        s->work[i] /= a[(size_t)i * n + (size_t)i];
    }
    for (int i = 0; i < s->rank; ++i) s->x[s->column_order[i]] += s->work[i];
}

static void fill(settle *s)
{
    const size_t n = (size_t)s->size;
    for (size_t b = 0; b < n; ++b) {
        const int column = s->pushing[b];
        respond(s, row_of(s, column));
        for (size_t a = 0; a < n; ++a)
            s->matrix[a * n + b] = weighed(s, row_of(s, s->pushing[a])) /
                                   (length_of(s, column) * length_of(s, s->pushing[a]));
        s->matrix[b * n + b] +=
            row_of(s, column)->compliance / (length_of(s, column) * length_of(s, column));
        s->x[b] = 0;
    }
}

/* All that pushes holds. */
static void hold(settle *s)
{
    s->size = 0;
    for (int n = 0; n < s->count; ++n) {
        if (s->pushes[n]) s->pushing[s->size++] = n;
        row_of(s, n)->lambda = 0;
    }
    fill(s);
    factorise(s);
    go(s);
    for (int round = 0; round <= CORRECTIONS; ++round) {
        for (int a = 0; a < s->size; ++a)
            s->right[a] = rest_of(s, s->pushing[a]) / length_of(s, s->pushing[a]);
        solve(s);
        for (int a = 0; a < s->size; ++a)
            row_of(s, s->pushing[a])->lambda = s->x[a] / length_of(s, s->pushing[a]);
        go(s);
    }
}

/* Changes all rows that pull or are passed, or the first of them: where a matrix has positive
 * principal minors, that ends (Murty, 1974). Whether there was any. */
static bool change_set(settle *s, bool all)
{
    double largest = 0;
    bool any = false;
    for (int n = 0; n < s->count; ++n)
        if (s->joint->line_of[n] >= 0)
            largest = fmax(largest, fabs(row_of(s, n)->lambda) * length_of(s, n));
    for (int n = 0; n < s->count && (all || !any); ++n) {
        const fw_joint_row *row = row_of(s, n);
        if (s->joint->line_of[n] < 0 || row->both) continue;
        const bool pushes = s->pushes[n] ? row->lambda * length_of(s, n) >= -PULLS * largest
                                         : rest_of(s, n) > PASSED;
        any |= pushes != s->pushes[n];
        s->pushes[n] = pushes;
    }
    return any;
}

/* Do all rows that push hold? Where some contradict each other there is no way. */
static bool holds(const settle *s)
{
    for (int k = 0; k < s->size; ++k)
        if (fabs(rest_of(s, s->pushing[k])) > CONTRADICTS) return false;
    return true;
}

static bool find_set(settle *s)
{
    for (int n = 0; n < s->count; ++n)
        s->pushes[n] =
            s->joint->line_of[n] >= 0 && (row_of(s, n)->both || row_of(s, n)->lambda > 0);
    for (int pass = 0; pass < PASSES; ++pass) {
        hold(s);
        if (!change_set(s, pass < PASSES_OF_ALL)) return holds(s);
    }
    hold(s);
    return false;
}

fw_status joint_settle(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                       int count, int moving, bool *settled, double *change, fw_error *error)
{
    *settled = false;
    *change = INFINITY;
    if (count > ROWS_MOST) return FW_OK;
    FW_TRY(joint_reserve_room(joint, room_of(count, moving), error));
    settle s = {
        .joint = joint, .ends = ends, .rows = rows, .list = list, .count = count, .moving = moving};
    take_room(&s, joint->room);
    for (int e = 0; e < moving; ++e) s.alone[e] = unled_of(&s, e);
    *settled = find_set(&s);
    *change = 0;
    for (int e = 0; e < moving; ++e) {
        const fw_vec2 far = fw_vec2_subtract(ends[joint->global[e]].displacement, joint->w[e]);
        *change = fmax(*change, fabs(far.x) + fabs(far.y));
    }
    return FW_OK;
}
