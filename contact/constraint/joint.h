/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint.h - one contact problem of many particles: bodies against bodies, walls on the same
 * particles, and walls that yield.
 *
 * An end is what moves: a particle or a piston with its mobility A, or something on a prescribed
 * path (A = 0).
 * A row is what must not happen: it weighs the displacements w of at most three ends, G w >= bound,
 * lambda >= 0,   lambda (G w - bound) = 0,   w = w_p + A G^T lambda, so that w is the point nearest
 * to the free displacement w_p in the norm of the masses. Since lambda . G w = lambda . bound,
 * contact without prescribed motion does no work, and since the weights of a row between bodies add
 * up to zero, it gives no momentum.
 *
 * The area between a point and a segment is quadratic in the displacements, and so is a squared
 * distance. With the gradient taken at the middle of the step, G(r + w/2) w is exactly its change:
 * the gap is held while energy is kept. That makes it a fixed point, w and G in turn. An iterate
 * that has not arrived costs gap only, never energy or momentum. */
#ifndef FW_JOINT_H
#define FW_JOINT_H

#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

/* An end of a solid whose colours move in turn follows others: r, what an end that leads is
 * displaced more than `expected`, adds (x.r, y.r) to its free displacement. */
enum { FW_JOINT_LEADS = 4 };
typedef struct fw_joint_lead {
    int end;
    fw_vec2 x, y;
    fw_vec2 expected;
} fw_joint_lead;

typedef struct fw_joint_end {
    fw_vec2 position;     /* at the start of the step */
    fw_vec2 free;         /* displacement without any row; follows `unled` where there are leads */
    fw_sym2 mobility;     /* dw/dF, positive definite; zero: `free` is prescribed; a diagonal one
                             may be zero in one component, which is then prescribed */
    fw_vec2 displacement; /* in: where to begin, as near as is known; out: w */
    fw_vec2 inertial;     /* displacement by momentum alone, for sticking */
    bool wide;            /* many rows share it, as those of all particles on a piston */
    fw_vec2 rubbed;       /* out: the part of w that friction makes */
    fw_vec2 force;        /* out: of all rows; w = free + mobility force */
    fw_vec2 unled;        /* `free` where all that lead go as expected */
    int lead_count, follower_count;
    fw_joint_lead lead[FW_JOINT_LEADS];
    int follower[FW_JOINT_LEADS]; /* ends that this one leads */
} fw_joint_end;

typedef enum fw_joint_kind {
    FW_JOINT_PLANE,   /* end 0 stays before a plane of that normal */
    FW_JOINT_ROUND,   /* end 0 keeps its distance from a centre: outside, or inside */
    FW_JOINT_SEGMENT, /* end 0 stays to the left of the segment from end 1 to end 2 */
    FW_JOINT_POINT,   /* end 0 comes no nearer to end 1, which lies elsewhere */
    FW_JOINT_SPRING   /* end 1 is a spring that pushes end 0: see fw_joint_springs */
} fw_joint_kind;

/* Coulomb friction along a segment or wall, bounded by the reaction [lambda(t) + lambda(t-1)]/2. */
typedef struct fw_joint_rub {
    double coefficient;     /* in: of what slides, >= 0; 0: none */
    double at_rest;         /* in: of what sticks; below `coefficient`: that */
    double before;          /* in: lambda of the step before */
    double inertial_before; /* in: what `inertial` was then, if `stuck_before` */
    bool stuck_before;
    bool slides;       /* in: it slid in the step before; out: or has broken loose in this one */
    bool barred;       /* it would have pushed along with the slip: there is none in this step */
    bool firm;         /* sticking lets nothing through in this step */
    bool stuck;        /* out */
    double limit;      /* out: that coefficient times the reaction */
    double traction;   /* out: force on end 0 along the segment */
    double inertial;   /* out: displacement by momentum alone, along it */
    double slip;       /* out: displacement along it, relative to the segment */
    double drift;      /* out: how far a wall that is no end moves along it */
    fw_vec2 weight[3]; /* out */
} fw_joint_rub;

typedef struct fw_joint_row {
    fw_joint_kind kind;
    int end[3];        /* of a segment's ends, none is the point */
    fw_vec2 offset[3]; /* of what the row touches, from the position of its end: many particles of
                          a grip are one end; two of a segment's may be the same */
    fw_vec2 normal;    /* of a plane, a unit vector to the free side */
    fw_vec2 centre;    /* of a circle, at the start of the step */
    bool inside;       /* of a circle */
    bool borne;        /* the plane or circle moves as end 1 does; else ... */
    fw_vec2 motion;    /* ... so far in this step */
    double behind;     /* by how much a plane or circle is to push end 0 back, >= 0 */
    bool both;         /* of a plane: held both ways, lambda has any sign */
    double distance;   /* that end 0 keeps from a segment or a point, >= 0 */
    bool open;         /* only rubs: the point may come nearer */
    fw_joint_rub rub;  /* of a segment */
    bool fresh;        /* in: its island has to be solved (again) */
    double lambda;     /* in: as near as is known, or 0; out: its force, >= 0 */
    fw_vec2 weight[3]; /* out: the gradient G; zero where there is no end */
    double bound;      /* out: G w + compliance lambda >= bound */
    double compliance; /* out: of a spring; else 0 */
} fw_joint_row;

/* What one call of fw_joint_solve has done. */
typedef struct fw_joint_outcome {
    int islands, iterations; /* solved; and of all of them together */
    int unconverged;         /* islands whose fixed point was not reached, or not solved */
    double change;           /* how far the last iteration still moved an end, the worst island */
    double residual;         /* |sum lambda (G w - bound)|, the worst island: energy */
} fw_joint_outcome;

/* Where an end would go freely depends on where it goes: springs act on it. NULL: on none. Springs
 * that are ends themselves push with a force that depends on how end 0 of their row moves relative
 * to end 1; `slope`, by how much it grows as that shrinks, only steers. */
typedef struct fw_joint_springs {
    fw_vec2 (*free)(void *context, int end, fw_vec2 displacement);
    double (*softening)(void *context, int end); /* A K/2 >= 0: steps are divided by 1 + this */
    fw_vec2 (*push)(void *context, int row, fw_vec2 relative, double *slope);
    void *context;
} fw_joint_springs;

/* Memory for the solver; it grows as problems do and is kept. */
typedef struct fw_joint fw_joint;
fw_joint *fw_joint_create(void); /* NULL: no memory */
void fw_joint_destroy(fw_joint *joint);

/* Solves all islands that have a fresh row: rows that share an end that can move, or have ends of
 * which one follows the other, belong together. Ends that follow and have no row are moved along.
 * The displacements of the others' ends stay as they are. The result depends on the order of rows,
 * in its last bits, and on nothing else. FW_SYSTEM_FAILED without memory. */
fw_status fw_joint_solve(fw_joint *joint, fw_joint_end *ends, int end_count, fw_joint_row *rows,
                         int row_count, const fw_joint_springs *springs, fw_joint_outcome *outcome,
                         fw_error *error);

/* The coefficient that holds for the row: see fw_friction_traction. */
static inline double fw_joint_coefficient(const fw_joint_rub *rub)
{
    return !rub->slides && rub->at_rest > rub->coefficient ? rub->at_rest : rub->coefficient;
}

/* What bounds the row's traction: that coefficient times the reaction. */
static inline double fw_joint_cone(const fw_joint_row *row)
{
    return 0.5 * fw_joint_coefficient(&row->rub) * (row->lambda + row->rub.before);
}

/* G w of a row with the weights that it has. */
double fw_joint_motion(const fw_joint_row *row, const fw_joint_end *ends);

/* Ends that a row weighs. */
int fw_joint_end_count(const fw_joint_row *row);

#endif
