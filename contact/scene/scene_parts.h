/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_parts.h - the inside of a scene, shared by scene.c (the time step), scene_contact.c,
 * scene_soft.c, scene_carry.c, scene_room.c, scene_pistons.c and scene_jams.c (its contact phase),
 * scene_make.c (making, restoring) and scene_observe.c, and by nobody else. */
#ifndef FW_SCENE_PARTS_H
#define FW_SCENE_PARTS_H

#include "contact/scene/scene.h"
#include "contact/search/boundary.h"

typedef struct scene_contact {
    int particle, entry;          /* of the solid, of the boundary */
    fw_contact_solution solution; /* of hard walls; with where the particle goes in any case */
    fw_vec2 soft;                 /* force of penalty walls ... */
    fw_vec2 soft_path; /* ... for this displacement: that of the constraint, to rounding */
    double mobility;   /* of the particle, the larger of x and y */
} scene_contact;

typedef struct scene_body {
    char *name;
    fw_solid *solid;
    fw_boundary *boundary;
    int boundary_revision;     /* of the solid when `boundary` was made */
    fw_contact_memory *memory; /* per particle; NULL where no wall rubs */
    scene_contact *contacts;   /* of this tick, ascending; room for all particles of the boundary */
    int contact_count;
    fw_row_list *rows; /* known in this tick, per entry of the boundary; NULL without pistons */
    fw_contact_memory *memory_before; /* at the beginning of the tick, per entry of the boundary */
    uint8_t *gripped;                 /* per particle; NULL where no grip holds the body */
    fw_constraint *constraints;       /* of contacts and grips, ascending; room for all particles */
    int constraint_count;
    fw_carry *carries; /* after the tick; room for all particles */
} scene_body;

/* A number lies between these. */
typedef struct scene_bracket {
    double low, high;
} scene_bracket;

/* The search for the motion of a piston in this tick. */
typedef struct scene_search {
    fw_vec2 push; /* of the bodies on the piston, moving as the wall's `motion` says ... */
    fw_sym2
        stiffness;  /* ... and - d push/d motion, where no particle comes or goes; steers Newton */
    double torque;  /* of the push about the piston's middle */
    fw_jam jam;     /* the tightest of all; piston 0: there is none */
    double jammed;  /* with which force, along the normal of the jam */
    double deepest; /* by how much a new row passes its particle at most, along ... */
    fw_vec2 deepest_normal;
    bool takes, draws_back; /* what becomes of new rows */
    bool fits;              /* the motion of the last try */
    scene_bracket x, y;
    double least_error; /* relative, since the last row was activated */
    int stale;          /* tries since then that did not improve it */
    double part;        /* of Newton's step that is taken */
} scene_search;

typedef struct scene_wall {
    fw_wall *wall;
    int first_facet;
    bool soft;             /* a penalty wall */
    fw_box bounds;         /* at the place of the definition */
    fw_vec2 place, motion; /* in this tick */
    fw_vec2 force_before;  /* of the last tick */
    double work_before;    /* done on bodies until the last tick */
    fw_piston *piston;     /* what moves it; NULL: its path */
    scene_search search;   /* of a piston */
} scene_wall;

typedef struct scene_load {
    int body;
    fw_load *load;
} scene_load;

typedef struct scene_grip {
    int body;
    fw_grip *grip;
} scene_grip;

/* Counters of the scene, all part of the state. */
typedef struct scene_clock {
    int64_t step, ticks, unresolved;
} scene_clock;

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
    int *passable; /* facets that a particle, or a block of them, can pass; room for all facets */
    int passable_count;
    double energy_at_start;
    fw_vec2 momentum_at_start;
    double energy_scale; /* see fw_scene_energy_scale */
};

/* Keeps the largest energy or work so far, at the start and after a step. */
void scene_note_work(fw_scene *scene);

/* 3. and 4. of the time step for given motions of the walls: which facets are near which run of
 * boundary particles, and the forces that hold contact particles. Enters nothing in the ledger. */
fw_status scene_find_contacts(fw_scene *scene, fw_error *error);
fw_status scene_constrain_bodies(fw_scene *scene, fw_error *error);
/* The same together with the motions of the pistons, which follow from those forces. */
fw_status scene_move_pistons(fw_scene *scene, fw_error *error);
/* Ends the tick of the pistons. */
void scene_advance_pistons(fw_scene *scene);
/* A force on a particle at `position` pushes the piston back. */
void scene_push_piston(scene_wall *wall, fw_vec2 position, fw_vec2 force, fw_sym2 stiffness);
/* What a contact of this try says of jams: for the particle, and for the piston. */
void scene_note_jam(fw_scene *scene, scene_body *body, const scene_contact *contact);
/* The particles that jam the piston of a wall share its force and pass it on. */
void scene_pass_on_jam(fw_scene *scene, int wall);
/* Pistons that have run over a jam do not fit. */
void scene_look_for_overrun(fw_scene *scene);
/* Place and motion of a wall in this tick, for bodies each of whose particles moves once in so many
 * ticks. */
void scene_follow_wall(fw_scene *scene, int wall, int ticks);
/* What the contacts of the tick do to the walls' ledgers. */
void scene_book_contacts(fw_scene *scene);
/* Of one penalty wall, or of all, on a particle at `position` that moves by w in this tick; and
 * what that does to their ledgers. */
fw_vec2 scene_soft_force_of(const scene_wall *wall, fw_vec2 position, fw_vec2 w);
fw_vec2 scene_soft_force(const fw_scene *scene, fw_vec2 position, fw_vec2 w);
/* Only true where no penalty wall acts on that path. */
bool scene_is_clear_of_soft(const fw_scene *scene, fw_vec2 position, fw_vec2 w);
void scene_book_soft(fw_scene *scene, const scene_contact *contact, fw_vec2 position, int ticks);
/* FW_DIVERGED where a particle was taken through a wall in this tick; before pistons advance. */
fw_status scene_check_room(fw_scene *scene, fw_error *error);
/* FW_BAD_INPUT for a penalty wall that is too stiff for the time step. */
fw_status scene_check_soft(fw_scene *scene, fw_error *error);
/* All constraints of the body in this tick: contacts and grips. */
void scene_collect_constraints(fw_scene *scene, int body);
/* After the body has moved: what is held on a path moves on with it. */
void scene_carry(fw_scene *scene, int body);

#endif
