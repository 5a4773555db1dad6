/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constrain_parts.h - the problem of one particle between walls, shared by constrain.c (normals)
 * and rub.c (friction), and by nobody else. */
#ifndef FW_CONSTRAIN_PARTS_H
#define FW_CONSTRAIN_PARTS_H

#include "contact/constraint/constrain.h"

/* One active barrier. */
typedef struct constrain_row {
    const fw_barrier *barrier;
    fw_vec2 normal;
    double bound;  /* n.w >= bound */
    double lambda; /* normal force */
    double grasp;  /* by how much friction grows with the wall's motion along the tangent */
    bool fast;     /* held in all components */
    bool lame;     /* of a piston that the particle cannot give way to: left out */
} constrain_row;

typedef struct constrain_problem {
    fw_vec2 position;
    const fw_prediction *free;
    int count;
    constrain_row rows[FW_TOUCH_MAX];
    fw_vec2 w;
    fw_stop stop;
} constrain_problem;

/* Normal and bound for the present w. */
void constrain_update_row(const constrain_problem *p, constrain_row *r);
/* Puts w where it ends at the radius where it began (at the circle itself, if rounding had put the
 * particle behind it). */
void constrain_keep_radius(constrain_problem *p, const constrain_row *r);
fw_vec2 constrain_displacement_for(const constrain_problem *p, fw_vec2 force);
/* The force with which the particle moves by w. */
fw_vec2 constrain_force_for(const constrain_problem *p);

/* Friction on the one row that is active, or that was in the step before (lambda = 0 now). Returns
 * the tangential force, and puts lambda and w to what they are with it. */
double constrain_rub(constrain_problem *p, constrain_row *r, const fw_barrier *all,
                     fw_contact_memory *memory);

#endif
