/* SPDX-License-Identifier: GPL-3.0-or-later */
/* couple.h - normal forces and tractions of an island as the unknowns of one problem, with what
 * each of them does. Shared by couple.c (which finds them), joint_pivot.c (which finds their
 * states) and joint_couple.c (which asks), and by nobody else. */
#ifndef FW_COUPLE_H
#define FW_COUPLE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum couple_state { RESTS, PUSHES, STICKS, SLIDES_BACK, SLIDES_ON } couple_state;

/* Unknowns: the normal forces of all lines, then the tractions of all tangents; scaled so that the
 * diagonal of `product` is near 1. */
typedef struct couple {
    int normals, count;
    int both_count;  /* of normals that hold both ways */
    double *product; /* S: what unknowns (columns) add to the motions of lines (rows) */
    int active_count;
    double *matrix, *right; /* of the unknowns that push or stick */
    double *scale;
    double *wanted;      /* of C z, and of T z where all sticks without moving */
    double *target;      /* of tangents: what sticking lets through */
    double *half, *rest; /* of tangents: the cone is half times the normal force, and rest */
    double *x, *motion;  /* S x */
    double *start;       /* forces near which those are looked for that are not unique */
    int *normal_of;      /* of a tangent: its normal, or -1 */
    int *both;           /* of a normal: it holds both ways, with a force of any sign */
    int *active, *column, *order;
    couple_state *state;
} couple;

static inline double couple_product(const couple *p, int row, int column)
{
    return p->product[(size_t)row * (size_t)p->count + (size_t)column];
}

static inline bool couple_is_tangent(const couple *p, int n)
{
    return n >= p->normals;
}

static inline double couple_cone(const couple *p, int n)
{
    const int normal = p->normal_of[n];
    return (normal < 0 ? 0 : p->half[n] * fmax(p->x[normal], 0)) + p->rest[n];
}

/* Of what slides: +1 or -1. */
static inline double couple_direction(const couple *p, int n)
{
    return p->state[n] == SLIDES_ON ? 1 : -1;
}

/* Doubles for the numbers of so many unknowns, and a problem that has them there. */
size_t couple_room(int count);
couple couple_open(int normals, int count, double *room);
/* Finds x and the states, from those that there are, for the largest part of what sticking lets
 * through with which friction takes energy as a whole. False where none is found. `room` for
 * joint_pivot_room() doubles. */
bool couple_find_part(couple *p, double *part, double *room);

/* Doubles that joint_pivot() needs for its work. */
size_t joint_pivot_room(int normals, int both_count, int count);
/* The states of a solution, for that part of what sticking lets through. False where pivots find
 * none. */
bool joint_pivot(couple *p, double part, double *room);

#endif
