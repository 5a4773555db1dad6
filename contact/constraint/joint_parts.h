/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_parts.h - the inside of the joint solver, shared by joint.c (normal contact),
 * joint_weights.c, joint_leads.c, joint_friction.c and joint_couple.c, and by nobody else. */
#ifndef FW_JOINT_PARTS_H
#define FW_JOINT_PARTS_H

#include "island.h"
#include "joint_system.h"

struct fw_joint {
    joint_islands islands;
    int end_capacity, row_capacity;
    int *local;      /* per end of the problem: its number in the island, or -1 */
    int *global;     /* and back */
    int *first;      /* per end of the island */
    fw_vec2 *w;      /* per end of the island, with which the weights are found */
    fw_vec2 *change; /* of w in the last iteration */
    fw_vec2 *z;      /* per end of the island */
    int *line_of;    /* per row of the island: its line, or -1 */
    joint_line *lines;
    double *lambda;
    joint_line *tangents; /* of friction, and per line of it ... */
    double *limit, *traction, *target, *slip;
    int *tangent_of; /* per row of the island, or -1 */
    double part;     /* of what sticking lets through, that it does */
    bool coupled;    /* the last forces were found at once */
    double *room;
    size_t room_size;
    const fw_joint_springs *springs; /* of this call; or NULL */
};

/* L L^T = A; L^T v and L v. */
typedef struct joint_root {
    double xx, yx, yy;
} joint_root;

static inline joint_root joint_root_of(fw_sym2 mobility)
{
    const double xx = sqrt(mobility.xx), yx = xx > 0 ? mobility.xy / xx : 0;
    return (joint_root){xx, yx, sqrt(mobility.yy - yx * yx)};
}

static inline fw_vec2 joint_apply_transposed(joint_root l, fw_vec2 v)
{
    return (fw_vec2){l.xx * v.x + l.yx * v.y, l.yy * v.y};
}

static inline fw_vec2 joint_apply(joint_root l, fw_vec2 v)
{
    return (fw_vec2){l.xx * v.x, l.yx * v.x + l.yy * v.y};
}

/* G and bound of a row, number `n` of the problem, at the middle of the step. */
void joint_weigh(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row, int n);
/* A line with these weights; `wanted` is left 0. False where no end can give way to it. */
bool joint_make_line(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                     const fw_vec2 *weight, joint_line *line);
/* Where an end is at the middle of the step. */
fw_vec2 joint_middle_of(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                        int k);
/* Memory for a problem of that size; for the work of the solvers. FW_SYSTEM_FAILED without. */
fw_status joint_reserve(fw_joint *joint, int end_count, int row_count, fw_error *error);
fw_status joint_reserve_room(fw_joint *joint, size_t size, fw_error *error);

/* Does any end of the island follow another one? */
bool joint_follows(const fw_joint *joint, const fw_joint_end *ends, int moving);
/* What leads add to the free displacement of an end, for the present w. */
fw_vec2 joint_led_by(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_end *end);
/* Moves ends that follow and that no row holds. */
void joint_move_followers(fw_joint *joint, fw_joint_end *ends, int end_count,
                          const fw_joint_row *rows, int row_count);

/* Friction of rows along whose tangents no end gives way, once all else is solved. */
void joint_rub_driven(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                      const int *list, int count);

/* Where ends follow others: normal forces for the weights and tractions as they stand, so that
 * energy and momentum are exact; where rows that pull or are passed cannot be mended, not settled.
 * *change: how far the furthest end goes further than `w`; infinite for islands that are too large.
 */
fw_status joint_settle(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                       int count, int moving, bool *settled, double *change, fw_error *error);

/* Does any row of the island rub? */
bool joint_rubs(const fw_joint_row *rows, const int *list, int count);
/* Tangents at the middle of the step. */
void joint_weigh_tangents(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                          const int *list, int count);
/* Friction for the present normal forces, whose part of the displacements is A^(1/2) z of their
 * system, in which so many ends move. */
fw_status joint_rub(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                    int count, const joint_system *normal, int moving, fw_error *error);
/* The same at once with the normal forces and what follows, where that can be done: then `found`,
 * and normal forces are those of `normal`. */
fw_status joint_couple(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                       int count, joint_system *normal, int moving, bool *found, fw_error *error);
/* Are all forces of the island few enough for that? */
bool joint_is_few(const fw_joint_row *rows, const int *list, int count);
/* By how much friction of the island misses its law, on the present displacements and forces: what
 * goes beyond the cone or, sliding, stays below it, as a part of the widest; what sticks and yet
 * slips, or slides the wrong way, as a part of how far the ends go. */
double joint_friction_misfit(const fw_joint *joint, const fw_joint_end *ends,
                             const fw_joint_row *rows, const int *list, int count);
/* What lines want, with the friction that there is. */
void joint_want(fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *rows,
                const int *list, int count);
/* Of all rows that rub and are not barred, without normal forces. Returns how many. */
int joint_make_all_tangents(fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                            const int *list, int count);
/* What the tractions add to the displacements of the ends. */
void joint_share_out(const fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                     int count, int moving);
/* How far points slide along segments on the present displacements. */
void joint_find_slips(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count);
/* The same; and what does not slide is stuck. */
void joint_stick_what_rests(const fw_joint_end *ends, fw_joint_row *rows, const int *list,
                            int count);
/* Rows that slip at their static limit slide from now on. Returns whether there are any. */
bool joint_break_loose(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count);
/* Does friction of the island give energy, as a whole? And bars those rows that do. */
bool joint_feeds(const fw_joint_end *ends, const fw_joint_row *rows, const int *list, int count);
void joint_bar_all_that_feed(const fw_joint_end *ends, fw_joint_row *rows, const int *list,
                             int count);
bool joint_any_barred(const fw_joint_row *rows, const int *list, int count);
/* Sticking lets nothing through in rows whose friction pushes along with the slip; bars those that
 * were firm already. Returns whether there are any. */
bool joint_bar_feeding(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count);
/* Where one row is firm, all are: rows that share an end cannot want different slips of it. */
void joint_hold_beside_firm(fw_joint_row *rows, const int *list, int count);

#endif
