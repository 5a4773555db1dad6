/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_state.h - the inside of an LB solid, shared by lb_layout.c (links and spans), lb_sums.c,
 * lb_measure.c (quantities), lb_fracture.c (breaking links), lb_displacements.c, lb_reach.c,
 * lb_step.c and lb_carry.c (motion) and lb_solid.c (making), each of which may use those before it,
 * and by nobody else.
 *
 * A solid is kept in one of two forms from its creation on: by its populations, or by its
 * displacements. Both are read through lb_field() and lb_rest().
 *
 * Displacements. x(t) is the displacement half a step ahead of u(t) and x(t-1) that half a step
 * behind: u(t) = (x(t) + x(t-1))/2, and with V(t) = x(t) - x(t-1)
 *     f_i(l) = (x_m(t) - x_l(t-1))/2,   f_0 = M0 V/2
 * are the fields of a body without hidden modes (lb_displacements.c).
 *
 * Populations: slots. The field that arrives at particle l from its neighbour in direction d lives
 * in one slot per link end. A step replaces each slot by `w - slot` in place: the value is then the
 * field that arrives at the *other* end of the link. So with parity 0 it lies in the particle's own
 * slot, with parity 1 in its neighbour's, and no second array is needed. Each slot is read and
 * written by exactly one particle per step: threads never meet. */
#ifndef FW_LB_STATE_H
#define FW_LB_STATE_H

#include "core/boltzmann/lb_solid.h"
#include "lb_grid.h"
#include "lb_sums.h"

enum { LB_ALL_LINKS = 15, LB_CHUNK = 4096, LB_DEPTH = 16 };

/* A symmetric matrix per particle; xy and yy are NULL where all are multiples of one. */
typedef struct matrices {
    double *xx, *xy, *yy;
} matrices;

/* Room for so many of them: `full`, or multiples of 1 (xx alone). */
static inline void lb_add_matrices(fw_arena *arena, matrices *m, size_t count, bool full)
{
    FW_ARENA_ADD(arena, m->xx, count);
    if (!full) return;
    FW_ARENA_ADD(arena, m->xy, count);
    FW_ARENA_ADD(arena, m->yy, count);
}

/* Consecutive particles. `full`: all have four links, and their neighbours lie at constant
 * distances in memory, so that the step runs over contiguous memory without tables. A span never
 * crosses a chunk. */
typedef struct span {
    int begin, end;
    int offset[FW_DIRECTIONS];
    bool full;
} span;

/* Squares of 16 x 16 places of the grid, by rows: what lb_reach.c works with. */
typedef struct lb_tiles {
    int rows, columns; /* 0: too many for so few sites */
    double *squares;   /* of each tile; right for one call */
    uint8_t *wanted;   /* of each tile; right for one call */
    double *sums;      /* per column of the lattice */
} lb_tiles;

/* The arrays of the displacement form, by place of the grid where nothing else is said. */
typedef struct displacement_form {
    fw_arena arena; /* of all of them */
    lb_grid grid;
    double *x[2], *y[2]; /* x(t) in [parity], x(t-1) in the other */
    double *force_x, *force_y;
    matrices mobility, mass; /* mu M^-1; M only if mu < 1 */
    fw_sym2 plain_mobility, plain_mass, plain_inverse;
    double *site_x, *site_y; /* of each particle */
    fw_vec2 common;          /* part of all displacements: r = site + (common + u) */
    fw_solid_ledger *passed; /* of each row in each of up to LB_DEPTH steps */
    fw_vec2 *kept;           /* x(t-1) of particles that are held */
    int kept_capacity;
    lb_tiles tiles;
    double heaviest; /* no M0^2 exceeds it */
} displacement_form;

typedef struct lb_solid {
    fw_solid head;
    double mu;       /* damping factor */
    double break_at; /* stretch, or INFINITY */
    bool resting;    /* has rest fields (some M0 is not zero, or links may break) */
    bool matrix;     /* some M0 or kappa is a matrix */
    bool weighted;   /* some kappa is not 1 */
    bool displaced;  /* kept by its displacements: no slots, no rest fields */
    bool counted;    /* then: M0 is the same number everywhere, so that masses follow from how many
                        links there are, and have no arrays */
    int parity;      /* 0: fields in their own particle's slots; 1: in the neighbours' */
    int broken;      /* links broken since creation */
    double *slot_x[FW_DIRECTIONS], *slot_y[FW_DIRECTIONS];
    double *rest_x, *rest_y;           /* f_0 */
    matrices inverse, mass, rest_mass; /* the first two unless counted */
    double rest_square;                /* M0^2, if counted */
    matrices stiffness[2];             /* of the links to the east and north; only if weighted */
    int *north, *south;                /* where there is such a link: see lb_neighbour() */
    uint8_t *present;                  /* bit d: the link in direction d exists */
    uint8_t *built;                    /* what was there at first; NULL: links do not break */
    uint8_t *edge;                     /* a corner beside a row above or below was never there */
    fw_vec2 step[FW_DIRECTIONS];       /* Delta0 of the links */
    span *spans;
    int *chunk_span; /* first span of each chunk, and their number */
    int chunk_count;
    fw_solid_ledger *chunk_ledger;
    lb_sums *sums;          /* of the present fields; nobody else's, so that sums can be observed */
    displacement_form form; /* only if displaced */
} lb_solid;

static inline fw_sym2 lb_get(const matrices *m, int l)
{
    if (!m->xy) return fw_sym2_scalar(m->xx[l]);
    return (fw_sym2){m->xx[l], m->xy[l], m->yy[l]};
}

static inline void lb_put(matrices *m, int l, fw_sym2 value)
{
    m->xx[l] = value.xx;
    if (m->xy) {
        m->xy[l] = value.xy;
        m->yy[l] = value.yy;
    }
}

/* Who is at the other end of an existing link. Particles of a row follow each other. */
static inline int lb_neighbour(const lb_solid *lb, int l, int direction)
{
    switch (direction) {
    case FW_EAST:
        return l + 1;
    case FW_WEST:
        return l - 1;
    case FW_NORTH:
        return lb->north[l];
    default:
        return lb->south[l];
    }
}

/* (M0^2 + number of links)/2, added up as where stiffnesses differ (Eq 4). */
static inline double lb_counted_mass(double rest_square, unsigned present)
{
    double sum = rest_square;
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (present & (1u << d)) sum += 1;
    return 0.5 * sum;
}

static inline fw_sym2 lb_mass_of(const lb_solid *lb, int l)
{
    if (!lb->counted) return lb_get(&lb->mass, l);
    return fw_sym2_scalar(lb_counted_mass(lb->rest_square, lb->present[l]));
}

static inline fw_sym2 lb_inverse_of(const lb_solid *lb, int l)
{
    if (!lb->counted) return lb_get(&lb->inverse, l);
    return fw_sym2_invert(lb_mass_of(lb, l));
}

/* kappa of an existing link. */
static inline fw_sym2 lb_stiffness(const lb_solid *lb, int l, int direction)
{
    if (!lb->weighted) return fw_sym2_scalar(1);
    int owner = direction <= FW_NORTH ? l : lb_neighbour(lb, l, direction);
    return lb_get(&lb->stiffness[direction % 2], owner);
}

/* u and V of a particle at the start. */
static inline fw_vec2 lb_start_displacement(const fw_lb_solid_def *def, int l)
{
    return def->displacement ? def->displacement[l] : (fw_vec2){0, 0};
}
static inline fw_vec2 lb_start_velocity(const fw_lb_solid_def *def, int l)
{
    return def->velocity ? def->velocity[l] : def->drift;
}

/* Where the field arriving at l from direction d is kept. */
typedef struct slot_place {
    double *x, *y;
} slot_place;
static inline slot_place lb_slot(const lb_solid *lb, int l, int direction)
{
    if (lb->parity == 0) return (slot_place){&lb->slot_x[direction][l], &lb->slot_y[direction][l]};
    int opposite = fw_opposite(direction), m = lb_neighbour(lb, l, direction);
    return (slot_place){&lb->slot_x[opposite][m], &lb->slot_y[opposite][m]};
}

/* (x_m(t) - x_l(t-1))/2 */
static inline fw_vec2 lb_half_difference(const lb_solid *lb, int m, int l)
{
    const displacement_form *form = &lb->form;
    const int there = form->grid.place[m], here = form->grid.place[l];
    const int ahead = lb->parity, behind = !lb->parity;
    return (fw_vec2){0.5 * (form->x[ahead][there] - form->x[behind][here]),
                     0.5 * (form->y[ahead][there] - form->y[behind][here])};
}

/* f_{d+2}(l), of an existing link. */
static inline fw_vec2 lb_field(const lb_solid *lb, int l, int direction)
{
    if (lb->displaced) return lb_half_difference(lb, lb_neighbour(lb, l, direction), l);
    slot_place slot = lb_slot(lb, l, direction);
    return (fw_vec2){*slot.x, *slot.y};
}

static inline fw_vec2 lb_rest(const lb_solid *lb, int l)
{
    if (!lb->resting) return (fw_vec2){0, 0};
    if (lb->displaced)
        return fw_sym2_apply(lb_get(&lb->rest_mass, l), lb_half_difference(lb, l, l));
    return (fw_vec2){lb->rest_x[l], lb->rest_y[l]};
}

/* Psi = M0 f_0 + sum kappa f_i (Eq 2). */
static inline fw_vec2 lb_psi(const lb_solid *lb, int l)
{
    fw_vec2 along[2] = {{0, 0}, {0, 0}}; /* east + west, north + south: mirror images agree */
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        fw_vec2 field = lb_field(lb, l, d);
        if (lb->weighted) field = fw_sym2_apply(lb_stiffness(lb, l, d), field);
        along[d % 2] = fw_vec2_add(along[d % 2], field);
    }
    fw_vec2 psi = fw_vec2_add(along[0], along[1]);
    if (lb->resting)
        psi = fw_vec2_add(psi, fw_sym2_apply(lb_get(&lb->rest_mass, l), lb_rest(lb, l)));
    return psi;
}

#endif
