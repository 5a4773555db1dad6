/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rows.h - the problem of one particle between walls: which walls, their normals, and the
 * displacement that passes none of them. Friction (rub.h) comes on top. */
#ifndef FW_ROWS_H
#define FW_ROWS_H

#include "contact/constraint/constrain.h"

/* One active candidate. */
typedef struct constrain_row {
    const fw_candidate *candidate;
    fw_vec2 normal;
    double bound;        /* n.w >= bound */
    double lambda;       /* normal force */
    double cone, beyond; /* bound of friction, and by how much friction exceeds it */
    bool pinned;         /* held in all components */
} constrain_row;

typedef struct constrain_problem {
    fw_vec2 position;
    const fw_prediction *free;
    int count;
    constrain_row rows[FW_WALL_CONTACTS];
    fw_vec2 w;
} constrain_problem;

/* Normal and bound for the present w. */
void constrain_update_row(const constrain_problem *p, constrain_row *r);
/* Puts w where it ends at the radius where it began (at the circle itself, if rounding had put the
 * particle behind it). */
void constrain_keep_radius(constrain_problem *p, const constrain_row *r);
fw_vec2 constrain_displacement_for(const constrain_problem *p, fw_vec2 force);
/* The force with which the particle moves by w. */
fw_vec2 constrain_force_for(const constrain_problem *p);

/* Finds w and the normal forces of all rows. False where no displacement suits all. */
bool constrain_solve(constrain_problem *p);
/* Puts w where wall k goes: all components follow it. */
void constrain_pin(constrain_problem *p, int k);
/* Does w keep to all rows? */
bool constrain_keeps_rows(const constrain_problem *p);
bool constrain_is_passed(const constrain_problem *p, const fw_candidate *candidate);
/* The first candidate that w passes and that is not a row yet, or NULL. */
const fw_candidate *constrain_find_passed(const constrain_problem *p,
                                          const fw_candidate *candidates, int count);

#endif
