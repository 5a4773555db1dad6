/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_parts.h - the inside of a scene, shared by scene.c (the time step), scene_contact.c,
 * scene_soft.c, scene_carry.c and scene_room.c (its contact phase), scene_apart.c (when it needs
 * none), scene_edges.c, scene_overlap.c, scene_meet.c, scene_met.c, scene_turns.c, scene_grips.c,
 * scene_pistons.c, scene_joint.c, scene_ends.c and scene_rub.c (bodies and pistons), scene_record.c
 * (what particles felt), scene_make.c (making, restoring), scene_energy.c and scene_observe.c, and
 * by nobody else. */
#ifndef FW_SCENE_PARTS_H
#define FW_SCENE_PARTS_H

#include "contact/constraint/constrain.h"
#include "contact/constraint/joint.h"
#include "contact/scene/scene.h"
#include "contact/search/boundary.h"
#include "contact/search/meeting.h"

typedef struct scene_contact {
    int particle, entry;          /* of the solid, of the boundary */
    fw_contact_solution solution; /* of hard walls; with where the particle goes in any case */
    fw_vec2 soft;                 /* force of penalty walls ... */
    fw_vec2 soft_path; /* ... for this displacement: that of the constraint, to rounding */
    double mobility;   /* of the particle, the larger of x and y */
} scene_contact;

/* What a particle remembers of the edge that it rubbed on in the last tick; all zero: none. */
typedef struct scene_rub {
    double lambda, inertial;
    double crept;    /* along the edge since the tick after it stuck */
    int32_t other;   /* 1 + body */
    int32_t segment; /* of its contour */
    int32_t stuck;
    int32_t unused; /* no gap in the bytes of the state */
} scene_rub;

/* The edge of a body that meets others; per point of its contour. */
typedef struct scene_edge {
    int revision; /* of the solid when it was made */
    fw_contour contour;
    fw_vec2 *home; /* per particle: where it was when the scene began */
    fw_prediction *predictions;
    fw_vec2 *paths;       /* displacements in this tick, as far as they are known */
    int *end;             /* in the joint contact of this tick, or -1 */
    int *entry;           /* of the boundary; beyond it for points that meet no walls */
    int entries_revision; /* of the boundary when `entry` was made */
    scene_rub *rubs;      /* per particle; NULL where nothing rubs. Part of the state */
} scene_edge;

/* What is no particle of a body. */
enum { SCENE_PISTON = -1, SCENE_GRIP = -2 };

/* A particle that takes part in the joint contact of this tick, a piston, or a grip. */
typedef struct scene_end {
    int body;          /* or SCENE_PISTON, or SCENE_GRIP */
    int particle;      /* of the body; of a piston its wall; of a grip its number */
    int point;         /* of the body's contour, or -1 */
    int entry;         /* of the boundary; beyond it, or -1, for what meets no walls */
    fw_vec2 alone;     /* displacement without any contact */
    int contact;       /* what walls alone did to it, among the body's contacts; or -1 */
    int grip;          /* that holds it: rows take its end in the place of this one; or -1 */
    int row;           /* its latest row as the point that passes, or -1 */
    int wall_rows;     /* facets that are rows */
    bool later;        /* it moves in the second tick of the step */
    fw_vec2 soft;      /* force of penalty walls ... */
    fw_vec2 soft_path; /* ... for this displacement */
} scene_end;

/* What a row of the joint contact is about. */
typedef struct scene_row {
    int facet;             /* of a wall; of one that is a spring its first; -1: of a body */
    int body, from, to;    /* the other body's points */
    int segment;           /* of its contour */
    int next;              /* an earlier row of the same end, or -1 */
    bool met;              /* a corner `point` of the wall `point_body` passes that facet */
    double when;           /* part of the tick after which it was passed */
    int point_body, point; /* what passes */
    double crept;          /* by it along the segment, since the tick after it stuck */
} scene_row;

/* A particle that a piston comes to, or may come to: of the latter `facet` is -1. */
typedef struct scene_reach {
    int body, entry, particle, facet;
    bool spring;
    double excess; /* by how much it is passed */
} scene_reach;

/* Contact of bodies with each other and with pistons: all of it but the ledger is of one tick only.
 */
typedef struct scene_joint {
    fw_joint *solver;
    fw_meeting *search;       /* NULL where no bodies meet */
    bool rubs;                /* any body rubs on any other */
    bool search_is_new;       /* it knows of no step yet */
    fw_meeting_body *members; /* one per body that meets others, and per part of one */
    int *member_bodies;
    int member_count;
    fw_box *frames; /* of members, for a look at all pairs */
    int *slots;     /* per body of the scene: its first one in `bodies` */
    int slot_count;
    int predicted; /* busy runs of `search` whose points are predicted */
    int changes;   /* rows added or closed in this tick */
    double reach;  /* how far points may go for the pairs of `search` to be complete */
    int end_count, end_capacity;
    scene_end *ends;
    fw_joint_end *joint_ends;
    int row_count, row_capacity;
    scene_row *rows;
    fw_joint_row *joint_rows;
    int found_count, found_capacity;
    scene_row *found;
    int reach_count, reach_capacity;
    scene_reach *reached;
    fw_joint_outcome outcome; /* of this tick */
    fw_contact_ledger ledger;
    fw_body_ledger *bodies; /* per part of each body of the scene */
} scene_joint;

/* Forces of contacts and grips on the particles of a body, and which of them are not zero. */
typedef struct scene_felt {
    fw_vec2 *now, *before; /* in the last move, part of the state, and in the one before it */
    int *now_list, *before_list;
    int now_count, before_count;
} scene_felt;

/* What friction has done to a particle since the beginning. */
typedef struct scene_rubbed {
    double heat;
    double steps, sliding; /* in which it rubbed, and slid */
    double stuck;          /* ticks in a row in which it stuck, until ... */
    double last;           /* ... this one, in which it rubbed last; they are counted from 1 */
    double held;           /* the tick in which a row between bodies last stuck to it */
} scene_rubbed;

typedef struct scene_body {
    char *name;
    fw_solid *solid;
    int surface; /* its number among those of the scene */
    fw_boundary *boundary;
    int boundary_revision;     /* of the solid when `boundary` was made */
    fw_contact_memory *memory; /* per particle; NULL where no wall rubs */
    scene_contact *contacts;   /* of this tick, ascending; room for all particles */
    int contact_count;
    bool unsorted;  /* contacts do not ascend at present */
    int *entry_end; /* per entry of the boundary: the end of what is no point, or -1; NULL without
                       pistons and grips */
    int *entry_of;  /* per particle: its entry, or -1; NULL unless pistons meet half-steps */
    int entry_of_revision;            /* `boundary_revision` when it was made */
    fw_contact_memory *memory_before; /* at the beginning of the tick, per particle; NULL without
                                         pistons and grips */
    uint8_t *gripped; /* per particle: 1 + the grip that holds it; NULL where none holds any */
    fw_constraint *constraints; /* of contacts and grips, ascending; room for all particles */
    int constraint_count;
    fw_carry *carries;    /* after the tick; room for all particles */
    scene_edge *edge;     /* NULL where it meets no other body */
    fw_contour fold;      /* of a body without an edge, once somebody looked whether it folds ... */
    int fold_revision;    /* ... of the solid when it was made */
    scene_felt *felt;     /* NULL where nobody asked for it */
    scene_rubbed *rubbed; /* per particle, part of the state; NULL where nothing rubs it */
    double room;          /* how far any of it may go without meeting anything: at the last look */
} scene_body;

typedef struct scene_wall {
    fw_wall *wall;
    int first_facet;
    bool soft;             /* a penalty wall */
    fw_box bounds;         /* at the place of the definition */
    fw_vec2 place, motion; /* in this tick */
    fw_vec2 force_before;  /* of the last tick */
    double work_before;    /* done on bodies until the last tick */
    double cone, beyond;   /* of friction in this tick: the widest, and the most that exceeds it */
    fw_piston *piston;     /* what moves it; NULL: its path */
    bool yields;           /* forces move the piston */
    int end;               /* of a piston that yields, in the joint contact of this tick; or -1 */
    fw_vec2 push;          /* of the bodies on the piston, in this tick */
    double torque;         /* of that about the piston's middle */
    fw_vec2 met;           /* push of other walls on the piston, in this step */
    double deepest;        /* by how much new rows pass their particles at most */
} scene_wall;

/* A piston, and a wall that it does not pass through; by their numbers. */
typedef struct scene_met {
    int a, b;
} scene_met;

typedef struct scene_load {
    int body;
    fw_load *load;
} scene_load;

typedef struct scene_grip {
    int body;
    fw_grip *grip;
    int end;          /* in the joint contact of this tick, or -1 */
    fw_vec2 path;     /* displacement in this tick, as far as it is known; of scenes with a joint */
    fw_sym2 mobility; /* in this tick, of the whole block */
} scene_grip;

/* Counters of the scene, all part of the state. */
typedef struct scene_clock {
    int64_t step, ticks, unresolved;
} scene_clock;

/* Until which tick no body can come to anything, if a look at them says so: scene_apart.c. */
typedef struct scene_apart {
    int64_t until; /* 0: they may now */
    int64_t look;  /* before that tick nobody need look again */
    int stretch;   /* for how long it was the last time */
} scene_apart;

struct fw_scene {
    fw_vec2 middle;
    double limit;
    double tick;
    int ticks_per_step;
    scene_clock clock;
    int body_count, wall_count, load_count, grip_count, piston_count;
    scene_body *bodies;
    scene_wall *walls;
    fw_wall_ledger *ledgers; /* per wall */
    scene_load *loads;
    scene_grip *grips;
    int soft_count;        /* walls that are springs */
    double soft_stiffness; /* of all of them together */
    fw_broadphase *broadphase;
    int facet_count;
    fw_candidate *candidates; /* of all facets, in the broadphase's order */
    fw_candidate *near;       /* candidates of one run that are hard; room for all facets */
    int near_count;
    int met_count;
    scene_met *met;
    int *passable; /* facets that a particle, or a block of them, can pass; room for all facets */
    int passable_count;
    double distance;      /* that bodies keep from each other; the largest of all pairs */
    double *distances;    /* of surfaces, as `pairs`; NULL: `distance` */
    bool keeps_forces;    /* of contact, of two steps */
    fw_friction friction; /* between bodies where there are no pairs of surfaces */
    int surface_count;
    fw_friction *pairs; /* of surfaces, [surface_count][surface_count]; NULL: none are named */
    scene_joint *joint; /* NULL where no bodies meet */
    int refused;        /* 1 + the body that starts in another one */
    double energy_at_start;
    fw_vec2 momentum_at_start;
    double energy_scale; /* see fw_scene_energy_scale */
    scene_apart apart;
};

/* Looks for how long nothing can act on the bodies, after a step; right until then: for how many
 * steps. Before any other step, positions of boundaries and the search between bodies are made
 * anew where they were not needed. FW_SYSTEM_FAILED without memory. */
void scene_look_ahead(fw_scene *scene);
int64_t scene_steps_apart(const fw_scene *scene);
fw_status scene_end_apart(fw_scene *scene, fw_error *error);
/* Do pistons meet a body whose colours move in turn? They move once in a step, not in a tick. */
static inline bool scene_pistons_take_steps(const fw_scene *scene)
{
    return scene->ticks_per_step == 2 && scene->piston_count > 0;
}

/* When the present step began, and how long it takes. */
double scene_step_start(const fw_scene *scene);
double scene_step_length(const fw_scene *scene);
/* Keeps the largest energy or work so far, at the start and after a step. */
void scene_note_work(fw_scene *scene);

/* 3. and 4. of the time step: which facets are near which run of boundary particles, and the forces
 * that hold contact particles, with the motions of pistons. Enters nothing in the ledger. */
fw_status scene_find_contacts(fw_scene *scene, fw_error *error);
fw_status scene_constrain_bodies(fw_scene *scene, fw_error *error);
/* Contacts of a body ascend by particle. */
void scene_sort_contacts(scene_body *body);
/* Where boundary particles would go: in this tick; in its first one all that the step brings, if
 * pistons meet what moves in turn. */
void scene_predict_boundary(const fw_scene *scene, scene_body *body);
/* The facets of a run that are neither springs nor yield become scene->near. */
void scene_list_near(fw_scene *scene, fw_boundary_run run);

/* Where a point of an edge is. */
static inline fw_vec2 scene_place_of(const scene_body *body, int point)
{
    return fw_solid_position(body->solid, body->edge->contour.particles[point]);
}

/* The part of its solid that a particle belongs to. */
int scene_part_of(const fw_solid *solid, int particle);
/* Name of a member: of a body, or of its part. */
const char *scene_member_name(const fw_scene *scene, int member);
/* FW_BAD_INPUT: bodies start in each other. */
fw_status scene_refuse_overlaps(fw_scene *scene, fw_error *error);
/* Contours of bodies that meet others, made when the scene begins. FW_BAD_INPUT: bodies start in
 * each other. */
fw_status scene_make_edges(fw_scene *scene, fw_error *error);
/* For solids whose state was written from outside: what particles remember stays. */
fw_status scene_restore_edges(fw_scene *scene, fw_error *error);
void scene_destroy_edges(fw_scene *scene);
/* The search between bodies begins anew, for the present positions. */
fw_status scene_renew_search(fw_scene *scene, fw_error *error);
/* Brings contours up to date where links have broken, and predicts the points that are near another
 * body. FW_DIVERGED where a body may have passed another one unseen. */
fw_status scene_predict_edges(fw_scene *scene, fw_error *error);
/* Of runs that have become busy since. */
void scene_predict_busy(fw_scene *scene);
/* What keeps bodies out of each other and of pistons, on top of what other walls do. */
fw_status scene_meet_bodies(fw_scene *scene, fw_error *error);
/* Bodies in which two colours move in turn: scene_turns.c. Is this their second tick? */
bool scene_is_second_tick(const fw_scene *scene);
/* What the whole step brings, before its first tick. */
void scene_predict_points(const fw_solid *solid, const int *particles, int count,
                          fw_prediction *out);
/* Of busy runs from that one on: takes into account what walls did to particles that lead others.
 */
void scene_lead_points(fw_scene *scene, int first_busy);
/* The same of boundary particles, whose lists of walls are extended to where that takes them. */
fw_status scene_lead_entries(fw_scene *scene, fw_error *error);
/* Makes the ends that follow an end. */
fw_status scene_couple_end(fw_scene *scene, int end, fw_error *error);
/* In the second tick, the forces that were found before the first. */
void scene_hand_over_second(fw_scene *scene);
/* Walls as ends meet them that move in the second tick. */
void scene_follow_wall_later(fw_scene *scene, int wall);
fw_candidate scene_candidate_for(const fw_scene *scene, int facet, bool later);

/* The ends of a contour's point, of a particle that meets walls, and of a piston; made where there
 * are none yet. FW_SYSTEM_FAILED without memory. */
fw_status scene_find_end(fw_scene *scene, int body, int point, int *end, fw_error *error);
fw_status scene_find_entry(fw_scene *scene, int body, int entry, int *end, fw_error *error);
fw_status scene_find_piston(fw_scene *scene, int wall, int *end, fw_error *error);
fw_status scene_find_grip(fw_scene *scene, int grip, int *end, fw_error *error);
/* The end whose motion is that of an end: itself, or its grip's. `offset`: where it lies from
 * there. FW_SYSTEM_FAILED without memory. */
fw_status scene_find_mover(fw_scene *scene, int end, int *mover, fw_vec2 *offset, fw_error *error);
/* The entry of a particle, where `entry_of` is kept; -1: it has none. */
int scene_entry_of(scene_body *body, int particle);
/* Where the end of a particle stands. */
int *scene_end_of_entry(const scene_body *body, int entry);
/* What walls alone did to a particle, among the body's contacts; or -1. */
int scene_find_contact(const scene_body *body, int particle);
void scene_forget_ends(fw_scene *scene);
/* What walls do to an end. */
fw_contact_solution scene_solution_of(const fw_scene *scene, int end);
/* The force on an end becomes a contact of its body. */
scene_contact *scene_hand_over_end(fw_scene *scene, int end);
/* A row of another body that a point must not pass; known rows are left alone. FW_SYSTEM_FAILED
 * without memory. */
fw_status scene_add_row(fw_scene *scene, const scene_row *row, fw_error *error);
/* The same of a facet and an end. `open`: it only rubs. */
fw_status scene_add_facet(fw_scene *scene, int end, int facet, bool open, fw_error *error);
/* A piston that is a spring. */
fw_status scene_add_spring(fw_scene *scene, int end, int wall, fw_error *error);
/* Its number, or -1. */
int scene_find_row(const scene_joint *joint, int end, const scene_row *row);
/* Rows on which particles still rub that rubbed in the last tick; they bar no way. */
fw_status scene_add_rubbing(fw_scene *scene, fw_error *error);
/* Friction of a new row, on which the end is to rub from now on. */
fw_joint_rub scene_take_rub(fw_scene *scene, const scene_row *row, int end);
/* That two bodies keep from each other. */
double scene_distance_between(const fw_scene *scene, int a, int b);
/* Does any body rub on another? */
bool scene_bodies_rub(const fw_scene *scene);
/* Of a wall, the coefficients that it has against that body. */
void scene_take_surface(const fw_scene *scene, int body, fw_surface *surface);
/* What particles remember for the next tick, and the heat. */
void scene_remember_rubbing(fw_scene *scene);
/* Where pistons take part, and of what grips hold. (Elsewhere a wall does not rub a particle that
 * touches another body in the same tick.) */
bool scene_walls_rub(const fw_scene *scene, const scene_end *end);
/* Friction of a wall's row, and what of an end's rows a particle remembers. */
fw_joint_rub scene_take_wall_rub(const fw_scene *scene, int end, int facet);
void scene_remember_wall(fw_scene *scene, int end);
/* Rows of all walls that ends pass. */
fw_status scene_add_passed_walls(fw_scene *scene, fw_error *error);
/* Solves all rows, and puts the points where that leads. */
fw_status scene_solve_joint(fw_scene *scene, fw_error *error);
/* The forces that were found become contacts of the bodies. */
void scene_hand_over_joint(fw_scene *scene);
/* Enters the tick in the ledgers of the bodies, and of grips that were pushed. */
void scene_book_joint(fw_scene *scene);
void scene_book_on_grips(fw_scene *scene, int body);

/* What contact has done to each particle. */
fw_status scene_make_records(fw_scene *scene, fw_error *error);
void scene_destroy_records(scene_body *body);
void scene_list_records(scene_body *body, fw_state_list *list);
void scene_restore_records(scene_body *body);
/* The constraints of this tick. */
void scene_record_forces(fw_scene *scene, int body);
/* First of all rows: which particles are held. */
void scene_record_hold(fw_scene *scene, const scene_row *row, const fw_joint_rub *rub);
void scene_record_rub(fw_scene *scene, const scene_row *row, const fw_joint_rub *rub);
void scene_record_rub_on_walls(const fw_scene *scene, scene_body *body,
                               const scene_contact *contact);

/* Grips, where anything may touch what they hold: scene_grips.c. They begin the tick as if they met
 * nothing. */
void scene_begin_grips(fw_scene *scene);
/* Points that grips hold go where these go. */
void scene_follow_grips(fw_scene *scene);
/* Facets that gripped particles pass get rows; FW_DIVERGED where neither can give way. */
fw_status scene_add_gripped(fw_scene *scene, fw_error *error);
/* FW_DIVERGED: grips hold all that the row is about, and none of them gives way. */
fw_status scene_refuse_gripped(const fw_scene *scene, const scene_row *row, fw_error *error);

/* Rows of pistons and walls that come to each other on their present paths; what walls that meet
 * do to pistons. FW_BAD_INPUT: some overlap at the start. */
fw_status scene_add_met(fw_scene *scene, fw_error *error);
void scene_push_met(fw_scene *scene);
fw_status scene_refuse_met(const fw_scene *scene, fw_error *error);
/* One more row. `owner`: the end of the particle, or piston, that passes. */
fw_status scene_append_row(fw_scene *scene, int owner, const scene_row *row,
                           const fw_joint_row *what, fw_error *error);

/* Pistons begin the tick as if they met nothing. FW_DIVERGED: not by finite numbers. */
fw_status scene_begin_pistons(fw_scene *scene, fw_error *error);
/* Particles that a piston comes to on their present paths get rows. */
fw_status scene_add_reached(fw_scene *scene, fw_error *error);
/* Particles on which a piston rubbed in the last tick are ends of this one. */
fw_status scene_add_rubbed_by_pistons(fw_scene *scene, fw_error *error);
/* Pistons move as their ends do. FW_DIVERGED as above. */
fw_status scene_follow_ends(fw_scene *scene, fw_error *error);
/* Ends the tick of the pistons. */
void scene_advance_pistons(fw_scene *scene);
/* A force on a particle at `position` pushes the piston back. */
void scene_push_piston(scene_wall *wall, fw_vec2 position, fw_vec2 force);
/* Place and motion of a wall in this tick, for bodies each of whose particles moves once in so many
 * ticks. */
void scene_follow_wall(fw_scene *scene, int wall, int ticks);
/* What the contacts of the tick do to the walls' ledgers. */
void scene_book_contacts(fw_scene *scene);
/* Of one penalty wall, or of all that do not yield, on a particle at `position` that moves by w in
 * this tick; and what that does to their ledgers. */
fw_vec2 scene_soft_force_of(const scene_wall *wall, fw_vec2 position, fw_vec2 w);
fw_vec2 scene_soft_force(const fw_scene *scene, fw_vec2 position, fw_vec2 w);
/* Only true where none of those acts on that path. */
bool scene_is_clear_of_soft(const fw_scene *scene, fw_vec2 position, fw_vec2 w);
void scene_book_soft(fw_scene *scene, const scene_contact *contact, fw_vec2 position, int ticks);
/* The energy that one stores more after that path. */
double scene_stored_by(const scene_wall *wall, fw_vec2 position, fw_vec2 w);
/* FW_DIVERGED where a particle was taken through a wall in this tick; before pistons advance. */
fw_status scene_check_room(fw_scene *scene, fw_error *error);
/* Of all penalty walls, on ends of the joint contact. */
fw_joint_springs scene_springs(fw_scene *scene);
/* FW_BAD_INPUT for a penalty wall that is too stiff for the time step. */
fw_status scene_check_soft(fw_scene *scene, fw_error *error);
/* All constraints of the body in this tick: contacts and grips. */
void scene_collect_constraints(fw_scene *scene, int body);
/* After the body has moved: what is held on a path moves on with it. */
void scene_carry(fw_scene *scene, int body);

#endif
