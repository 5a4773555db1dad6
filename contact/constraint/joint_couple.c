/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_couple.c - normal forces and friction of an island at once, where solving them in turn does
 * not settle: a semismooth Newton iteration over what each row does. A normal pushes or does not; a
 * tangent sticks, with a slip of its target, or slides, with a traction of its cone, which moves
 * with the normal force. For given states all that is linear; each state that the solution
 * contradicts is changed, and it is solved again.
 * State: none. Start reading at joint_couple(). */
#include "joint_parts.h"

#include <math.h>
#include <string.h>

/* Unknowns beyond which it is not tried: a step takes their third power. */
enum { UNKNOWNS = 64 };
/* So many times all states are changed, then one at a time; and so many parts of what sticking lets
 * through are tried. */
enum { AT_ONCE = 15, STEPS = 60, PARTS = 40 };
/* Pivots below this part of the first one are dependences, not numbers. */
#define DEPENDENT 1e-11
/* Contradictions below this part of the largest numbers are rounding. */
#define ROUNDING 1e-13

typedef enum couple_state { RESTS, PUSHES, STICKS, SLIDES_BACK, SLIDES_ON } couple_state;

/* Unknowns: the normal forces of all lines, then the tractions of all tangents; scaled so that the
 * diagonal of `product` is 1. */
typedef struct couple {
    int normals, count;
    double *product; /* S = [C; T] [C; T]^T */
    double *matrix, *right, *scale;
    double *wanted;      /* of C z, and of T z where all sticks without moving */
    double *target;      /* of tangents: what sticking lets through */
    double *half, *rest; /* of tangents: the cone is half times the normal force, and rest */
    double *x, *motion;  /* S x */
    int *normal_of;      /* of a tangent: its normal, or -1 */
    int *column;
    couple_state *state;
} couple;

static size_t room_of(int count)
{
    const size_t n = (size_t)count;
    /* Whole numbers and states take no more room than doubles. */
    return 2 * n * n + 12 * n;
}

static couple open_couple(int normals, int count, double *room)
{
    const size_t n = (size_t)count;
    couple p = {.normals = normals, .count = count};
    double **arrays[] = {&p.right, &p.scale, &p.wanted, &p.target,
                         &p.half,  &p.rest,  &p.x,      &p.motion};
    p.product = room;
    p.matrix = room += n * n;
    room += n * n;
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k, room += n) *arrays[k] = room;
    p.normal_of = (int *)room;
    p.column = (int *)(room + n);
    p.state = (couple_state *)(room + 2 * n);
    return p;
}

static double *at(const couple *p, double *matrix, int row, int column)
{
    return &matrix[(size_t)row * (size_t)p->count + (size_t)column];
}

static bool is_tangent(const couple *p, int n)
{
    return n >= p->normals;
}

static double cone_of(const couple *p, int n)
{
    const int normal = p->normal_of[n];
    return (normal < 0 ? 0 : p->half[n] * fmax(p->x[normal], 0)) + p->rest[n];
}

/* The equation of unknown n. */
static void write_row(const couple *p, int n, double part)
{
    double *row = at(p, p->matrix, n, 0);
    const double sign = p->state[n] == SLIDES_ON ? 1 : -1;
    p->right[n] = p->wanted[n];
    switch (p->state[n]) {
    case STICKS:
        p->right[n] += part * p->target[n];
        memcpy(row, at(p, p->product, n, 0), (size_t)p->count * sizeof *row);
        return;
    case PUSHES:
        memcpy(row, at(p, p->product, n, 0), (size_t)p->count * sizeof *row);
        return;
    case RESTS:
        memset(row, 0, (size_t)p->count * sizeof *row);
        row[n] = 1;
        p->right[n] = 0;
        return;
    case SLIDES_BACK:
    case SLIDES_ON:
        memset(row, 0, (size_t)p->count * sizeof *row);
        row[n] = 1;
        if (p->normal_of[n] >= 0) row[p->normal_of[n]] = -sign * p->half[n];
        p->right[n] = sign * p->rest[n];
        return;
    }
}

static void swap(double *a, double *b)
{
    const double c = *a;
    *a = *b;
    *b = c;
}

/* The largest entry from (k, k) on comes to (k, k). Returns its size. */
static double find_pivot(const couple *p, int k)
{
    int row = k, column = k;
    double largest = 0;
    for (int i = k; i < p->count; ++i)
        for (int j = k; j < p->count; ++j)
            if (fabs(*at(p, p->matrix, i, j)) > largest) {
                largest = fabs(*at(p, p->matrix, i, j));
                row = i;
                column = j;
            }
    for (int j = 0; j < p->count && row != k; ++j)
        swap(at(p, p->matrix, k, j), at(p, p->matrix, row, j));
    if (row != k) swap(&p->right[k], &p->right[row]);
    for (int i = 0; i < p->count && column != k; ++i)
        swap(at(p, p->matrix, i, k), at(p, p->matrix, i, column));
    const int moved = p->column[k];
    p->column[k] = p->column[column];
    p->column[column] = moved;
    return largest;
}

/* Rows that say what others say already have no force. */
static void solve_states(couple *p, double part)
{
    int rank = 0;
    double first = 0;
    for (int n = 0; n < p->count; ++n) {
        write_row(p, n, part);
        p->column[n] = n;
    }
    for (; rank < p->count; ++rank) {
        const double pivot = find_pivot(p, rank);
        if (rank == 0) first = pivot;
        if (!(pivot > DEPENDENT * first)) break;
        for (int i = rank + 1; i < p->count; ++i) {
            double *row = at(p, p->matrix, i, 0);
            const double *above = at(p, p->matrix, rank, 0);
            const double factor = row[rank] / above[rank];
            if (factor == 0) continue;
            for (int j = rank; j < p->count; ++j) row[j] -= factor * above[j];
            p->right[i] -= factor * p->right[rank];
        }
    }
    for (int n = 0; n < p->count; ++n) p->x[n] = 0;
    for (int k = rank - 1; k >= 0; --k) {
        double sum = p->right[k];
        for (int j = k + 1; j < rank; ++j) sum -= *at(p, p->matrix, k, j) * p->x[p->column[j]];
        p->x[p->column[k]] = sum / *at(p, p->matrix, k, k);
    }
    for (int n = 0; n < p->count; ++n) {
        p->motion[n] = 0;
        for (int j = 0; j < p->count; ++j) p->motion[n] += *at(p, p->product, n, j) * p->x[j];
    }
}

/* By how much the solution contradicts the state of n, and what it should be. */
static double contradiction(const couple *p, int n, bool both, double part, couple_state *other)
{
    const double off = p->motion[n] - p->wanted[n];
    switch (p->state[n]) {
    case RESTS:
        *other = PUSHES;
        return -off;
    case PUSHES:
        *other = RESTS;
        return both ? fabs(off) : fmax(-p->x[n], fabs(off));
    case STICKS:
        *other = p->x[n] > 0 ? SLIDES_ON : SLIDES_BACK;
        return fabs(p->x[n]) - cone_of(p, n);
    case SLIDES_BACK:
        *other = STICKS;
        return -(off - part * p->target[n]);
    case SLIDES_ON:
        *other = STICKS;
        return off - part * p->target[n];
    }
    return 0;
}

static bool find_states(couple *p, const joint_line *lines, double part)
{
    for (int step = 0; step < STEPS; ++step) {
        double size = 0, worst = 0;
        int changes = 0, which = -1;
        couple_state what = RESTS;
        solve_states(p, part);
        for (int n = 0; n < p->count; ++n)
            size = fmax(size, fmax(fabs(p->x[n]), fabs(p->wanted[n])));
        for (int n = 0; n < p->count; ++n) {
            couple_state other = RESTS;
            const bool both = !is_tangent(p, n) && lines[n].both;
            const double beyond = contradiction(p, n, both, part, &other);
            if (!(beyond > ROUNDING * size)) continue;
            changes += 1;
            if (both) return false;
            if (beyond > worst) {
                worst = beyond;
                which = n;
                what = other;
            }
            if (step < AT_ONCE) p->state[n] = other;
        }
        if (changes == 0) return true;
        if (step >= AT_ONCE) p->state[which] = what;
    }
    return false;
}

/* Of friction: tractions times slips. */
static double power_of(const couple *p)
{
    double sum = 0;
    for (int n = p->normals; n < p->count; ++n) sum += p->x[n] * (p->motion[n] - p->wanted[n]);
    return sum;
}

/* The largest part of what sticking lets through with which friction takes energy as a whole. */
static bool find_part(couple *p, const joint_line *lines)
{
    double low = 0, high = 1, at_low, at_high;
    if (!find_states(p, lines, 1)) return false;
    at_high = power_of(p);
    if (at_high <= 0) return true;
    if (!find_states(p, lines, 0)) return false;
    at_low = power_of(p);
    for (int n = 0; n < PARTS && at_low < 0 && high - low > 1e-9; ++n) {
        const double between = (low * at_high - high * at_low) / (at_high - at_low);
        const double middle = n % 3 == 2 ? 0.5 * (low + high) : between;
        if (!find_states(p, lines, middle)) return false;
        const double power = power_of(p);
        if (power <= 0) {
            low = middle;
            at_low = power;
        } else {
            high = middle;
            at_high = power;
        }
    }
    return find_states(p, lines, low);
}

/* Of lines and tangents as they are, with the states of the forces that they have. */
static void fill(couple *p, const fw_joint *joint, const fw_joint_row *rows, const int *list,
                 int count)
{
    const joint_system none = {0}; /* no end is wide */
    for (int a = 0; a < p->count; ++a) {
        const joint_line *line =
            is_tangent(p, a) ? &joint->tangents[a - p->normals] : &joint->lines[a];
        p->scale[a] = 1 / line->length;
        for (int b = 0; b <= a; ++b) {
            const joint_line *other =
                is_tangent(p, b) ? &joint->tangents[b - p->normals] : &joint->lines[b];
            *at(p, p->product, a, b) = *at(p, p->product, b, a) =
                a == b ? 1 : p->scale[a] * p->scale[b] * joint_product(&none, line, other);
        }
    }
    for (int n = 0; n < p->normals; ++n) {
        p->wanted[n] = p->scale[n] * joint->lines[n].wanted;
        p->state[n] = joint->lines[n].both || joint->lambda[n] > 0 ? PUSHES : RESTS;
    }
    for (int k = 0; k < count; ++k) {
        if (joint->tangent_of[k] < 0) continue;
        const int n = p->normals + joint->tangent_of[k], normal = joint->line_of[k];
        const fw_joint_rub *rub = &rows[list[k]].rub;
        const double half = 0.5 * fw_joint_coefficient(rub);
        p->wanted[n] = -p->scale[n] * joint->slip[joint->tangent_of[k]];
        p->target[n] = p->scale[n] * joint->target[joint->tangent_of[k]];
        p->normal_of[n] = normal;
        p->half[n] = normal < 0 ? 0 : half * p->scale[normal] / p->scale[n];
        p->rest[n] = half * rub->before / p->scale[n];
        p->state[n] = fabs(rub->traction) < rub->limit ? STICKS
                      : rub->traction > 0              ? SLIDES_ON
                                                       : SLIDES_BACK;
    }
}

fw_status joint_couple(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                       int count, const joint_system *normal, int moving, bool *found,
                       fw_error *error)
{
    *found = false;
    const int tangents = joint_make_all_tangents(joint, ends, rows, list, count);
    const int unknowns = normal->line_count + tangents;
    if (tangents == 0 || unknowns > UNKNOWNS) return FW_OK;
    FW_TRY(joint_reserve_room(joint, room_of(unknowns), error));
    couple p = open_couple(normal->line_count, unknowns, joint->room);
    fill(&p, joint, rows, list, count);
    if (!find_part(&p, joint->lines)) return FW_OK;
    *found = joint->settled = true;
    for (int n = 0; n < p.normals; ++n) joint->lambda[n] = p.x[n] * p.scale[n];
    for (int k = 0; k < count; ++k) {
        if (joint->tangent_of[k] < 0) continue;
        const int n = p.normals + joint->tangent_of[k];
        rows[list[k]].rub.limit = cone_of(&p, n) * p.scale[n];
        joint->traction[joint->tangent_of[k]] = p.x[n] * p.scale[n];
    }
    joint_share_out(joint, ends, rows, list, count, moving);
    /* What slides is at its limit, whatever rounding says. */
    for (int k = 0; k < count; ++k)
        if (joint->tangent_of[k] >= 0)
            rows[list[k]].rub.stuck = p.state[p.normals + joint->tangent_of[k]] == STICKS;
    return FW_OK;
}
