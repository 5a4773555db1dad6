/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solid.h - what every solid of the project can do.
 *
 * A solid is a const table of few whole-lattice operations (never an indirect call inside a loop
 * over particles) and a head of data that all models share. A model embeds fw_solid as its first
 * member. Contact knows nothing else of a solid: the solid says where boundary particles
 * would go (predict), contact decides where they do go and hands that back (advance).
 *
 * Units are reduced: lattice spacing and particle masses of the model; time in the model's own
 * unit, of which one tick takes `tick`.
 *
 * Public: the head and the functions that read are meant to stay, the table of operations is
 * not. */
#ifndef FW_SOLID_H
#define FW_SOLID_H

#include "core/arena.h"
#include "core/array.h"
#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>
#include <stdint.h>

FW_PUBLIC_BEGIN

typedef struct fw_solid fw_solid;

/* What a particle would do in this tick without contact. With a constraint force F on top it moves
 * by `displacement + mobility F`: for the LB solid mobility = mu M^-1/2; for velocity Verlet
 * dt^2/2m; for BAOAB dt^2 (1+c)/4m; for the automaton that of the colour that moves now, zero for
 * the resting one. */
typedef struct fw_prediction {
    fw_vec2 displacement; /* external force, damping and noise included */
    fw_sym2 mobility;     /* positive definite, or zero where the particle rests in this tick */
    fw_vec2 inertial;     /* displacement by momentum alone, without elastic and external force */
    bool later;           /* of `predict_step`: it moves in the second tick of the step */
    bool led;             /* for whoever keeps it: what leads it was taken into account */
} fw_prediction;

/* A neighbour of the other colour, in a solid whose colours move in turn. What the neighbour is
 * displaced in a first tick more than it was predicted, r, brings the particle (x.r, y.r) in the
 * second one. */
typedef struct fw_partner {
    int particle;
    fw_vec2 x, y;
} fw_partner;

enum { FW_PARTNERS = 4 };

/* Particles first .. first + count - 1: one of several bodies that share a solid and on which no
 * potential acts across. */
typedef struct fw_part {
    const char *name;
    int first, count;
} fw_part;

/* What contact decides for a particle. The solid moves it by exactly `displacement` (zero stays
 * zero, which no force could promise after rounding); `force` is the constraint force that does it.
 */
typedef struct fw_constraint {
    int particle;
    fw_vec2 displacement;
    fw_vec2 force;
} fw_constraint;

/* A particle whose velocity is prescribed at the end of a tick, in one component or both: what is
 * held on a path moves on with the path. `owner` is for whoever makes the list. */
typedef struct fw_carry {
    int particle, owner;
    bool x, y; /* the components that are prescribed */
    fw_vec2 velocity;
    fw_vec2 impulse; /* momentum that this takes, */
    double work;     /* and energy; both 0 when the list is handed over */
} fw_carry;

typedef struct fw_energies {
    double kinetic;
    double elastic; /* every potential energy of the solid's own forces */
} fw_energies;

/* What has passed through the solid's bounds since it was created, added up in a fixed order. The
 * constraints' share is not in here: it stands in the ledger of each wall. */
typedef struct fw_solid_ledger {
    double work;       /* of the external forces, sum F . w */
    double dissipated; /* energy taken by damping and by the material's own failure, >= 0 */
    double heat;       /* energy brought in by a thermostat's noise */
    double fracture;   /* the part of `dissipated` that breaking links took */
    fw_vec2 impulse;   /* of the external forces, sum F dt */
    fw_vec2 drag;      /* momentum added by damping and noise */
} fw_solid_ledger;

/* Adds what passed in a part of a step to the ledger. */
void fw_solid_ledger_add(fw_solid_ledger *ledger, const fw_solid_ledger *part);

/* How particles move, a number for each of them. */
typedef struct fw_motions {
    double *x, *y, *velocity_x, *velocity_y;
} fw_motions;

/* A quantity per particle, for pictures and files. */
typedef struct fw_field {
    const char *name; /* NULL ends a table */
    const char *unit; /* "1": a pure number */
    const char *meaning;
    void (*fill)(const fw_solid *solid, double *values);
} fw_field;

typedef struct fw_solid_model {
    const char *name;   /* as in scenario files: "lattice-boltzmann" */
    int ticks_per_step; /* 1, or 2 where two colours move in turn */
    void (*destroy)(fw_solid *solid);
    /* For each listed particle what this tick would bring; the solid is unaltered. */
    void (*predict)(const fw_solid *solid, const int *particles, int count, fw_prediction *out);
    /* Where a step has two ticks, before the first of them: what the whole step would bring, in
     * whichever tick a particle moves; and whom it follows or leads. NULL: a step has one. */
    void (*predict_step)(const fw_solid *solid, const int *particles, int count,
                         fw_prediction *out);
    int (*partners)(const fw_solid *solid, int particle, fw_partner partners[FW_PARTNERS]);
    /* One tick. `constraints` ascends by particle, each particle at most once. FW_SYSTEM_FAILED
     * without memory; the solid is then of no further use. A model with `place` need move x, y of
     * boundary particles only. */
    fw_status (*advance)(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                         fw_error *error);
    /* So many ticks without constraints, under the external forces as they stand: the same bytes
     * as one by one, sooner. A model with `place` may leave all of x, y as they are. NULL: one by
     * one. */
    fw_status (*advance_free)(fw_solid *solid, int ticks, fw_error *error);
    /* Makes x, y of all particles from the rest of the state. NULL: they are the state. */
    void (*place)(fw_solid *solid);
    /* The same of boundary particles alone. NULL where `place` is; there where `reach` or
     * `stays_within` is. */
    void (*place_boundary)(fw_solid *solid);
    /* Do all particles surely lie within `limit` of `centre` in x and y, wherever x, y of the head
     * are? As quick as may be; false: it is not known. NULL: only x, y tell. */
    bool (*stays_within)(const fw_solid *solid, fw_vec2 centre, double limit);
    /* No boundary particle moves further than that within so many ticks from now on, if nothing
     * acts on the solid; a reversal of time on the way changes nothing. INFINITY: who knows. NULL:
     * nobody ever knows. The solid is unaltered. */
    double (*reach)(const fw_solid *solid, int ticks);
    /* After a tick: gives particles their velocities. `carries` ascends by particle, each at most
     * once. NULL: the solid has no velocities of its own to keep. */
    void (*carry)(fw_solid *solid, fw_carry *carries, int count);
    fw_energies (*energies)(const fw_solid *solid);
    fw_vec2 (*momentum)(const fw_solid *solid);
    /* About the origin, of `count` particles from `first` on. */
    double (*angular_momentum)(const fw_solid *solid, int first, int count);
    /* Weighted by mass, straight for a free body. */
    fw_vec2 (*centre_of_mass)(const fw_solid *solid);
    /* Total mass; a matrix where rest masses are. */
    fw_sym2 (*mass)(const fw_solid *solid);
    /* Velocities of all particles, in length per unit of time. */
    void (*velocities)(const fw_solid *solid, double *x, double *y);
    /* What `place` and `velocities` make, of `count` particles from `first` on, without either: for
     * whoever looks once. NULL: they are there as arrays. */
    void (*motions)(const fw_solid *solid, int first, int count, const fw_motions *out);
    /* Masses of all particles (half the trace where they are matrices). */
    void (*masses)(const fw_solid *solid, double *mass);
    /* Appends every array that changes while the solid runs. Writing saved values back into the
     * same arrays and calling `restored` puts the solid exactly where it was. */
    void (*state)(fw_solid *solid, fw_state_list *list);
    /* Rebuilds what follows from the state. FW_BAD_INPUT: the arrays hold what no solid of this
     * model writes, such as an index out of range; FW_SYSTEM_FAILED without memory. The solid is
     * then of no further use. */
    fw_status (*restored)(fw_solid *solid, fw_error *error);
    /* Turns the arrow of time: the solid runs back the way it came; NULL: it cannot. */
    void (*reverse)(fw_solid *solid);
    /* In which of several ways the solid is kept, "populations"; NULL: there is but one. */
    const char *(*form)(const fw_solid *solid);
    /* Returns how many parts there are, and fills *part, unless NULL, with that one. NULL: the
     * solid is one body. */
    int (*parts)(const fw_solid *solid, int number, fw_part *part);
    /* Makes the links for the present positions where they are not kept by the solid itself; called
     * where bodies meet. FW_SYSTEM_FAILED without memory. */
    fw_status (*list_links)(fw_solid *solid, bool *changed, fw_error *error);
    const fw_field *fields;
    bool solid_between_links; /* its links enclose matter: no other such body may enter it */
    bool bare_is_nothing;     /* a particle without links has no mass, and bars no way */
} fw_solid_model;

/* The head shared by all models. Everybody may read it; external_x/y is what loads write. */
struct fw_solid {
    const fw_solid_model *model;
    int count;                       /* particles */
    double tick;                     /* time of one tick: LB 1, particles dt, automaton 1/2 */
    double *x, *y;                   /* positions: right once fw_solid_place() was called */
    double *external_x, *external_y; /* external force of this tick; kept by the loads */
    bool loaded;                     /* false: external_x/y are all zero and need not be read */
    bool conserves;                  /* energy changes only by what the ledger says */
    int *boundary;                   /* particles that can touch something, ascending */
    int boundary_count;
    int boundary_revision; /* grows whenever the boundary changes (links break, particles flow) */
    int (*links)[2];       /* pairs of linked particles, for files and pictures; NULL if none */
    int link_count;
    fw_solid_ledger ledger;
    int64_t ticks;  /* advanced since creation */
    fw_arena arena; /* of these arrays but `links`, and of those that a model adds */
};

/* Begins a head for `count` particles: its arrays stand in the arena, to which the model adds its
 * own before it calls fw_solid_allocate. */
void fw_solid_head_begin(fw_solid *solid, const fw_solid_model *model, int count);
/* FW_SYSTEM_FAILED without memory; the head is to be released then too. */
fw_status fw_solid_allocate(fw_solid *solid, fw_error *error);
/* Releases the arrays of the arena and the links, not the struct itself. */
void fw_solid_head_release(fw_solid *solid);
/* The part of `restored` that all models share: positions are finite, counters not negative. */
fw_status fw_solid_head_restored(const fw_solid *solid, fw_error *error);
/* Appends the head's own state: positions, ledger, ticks. */
void fw_solid_head_state(fw_solid *solid, fw_state_list *list);

static inline void fw_solid_destroy(fw_solid *solid)
{
    if (solid) solid->model->destroy(solid);
}

static inline void fw_solid_predict(const fw_solid *solid, const int *particles, int count,
                                    fw_prediction *out)
{
    solid->model->predict(solid, particles, count, out);
}

static inline int fw_solid_parts(const fw_solid *solid, int number, fw_part *part)
{
    if (solid->model->parts) return solid->model->parts(solid, number, part);
    if (part) *part = (fw_part){NULL, 0, solid->count};
    return 1;
}

static inline void fw_solid_place(fw_solid *solid)
{
    if (solid->model->place) solid->model->place(solid);
}

/* One tick, after which only the positions of boundary particles are sure to be right: the others
 * wait for fw_solid_place(). */
static inline fw_status fw_solid_move(fw_solid *solid, const fw_constraint *constraints,
                                      int constraint_count, fw_error *error)
{
    return solid->model->advance(solid, constraints, constraint_count, error);
}

/* So many ticks without contact, after which all positions wait for fw_solid_place(). */
fw_status fw_solid_move_free(fw_solid *solid, int ticks, fw_error *error);

/* One tick, positions included; without contact, and with it. */
fw_status fw_solid_advance_free(fw_solid *solid, fw_error *error);
fw_status fw_solid_advance(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                           fw_error *error);

/* To be called after state was written from outside: what follows from it is made anew. */
static inline fw_status fw_solid_restored(fw_solid *solid, fw_error *error)
{
    return solid->model->restored(solid, error);
}

/* Reverses a solid whose model can, and adds what that does to its momentum to the impulse. */
void fw_solid_reverse(fw_solid *solid);

static inline fw_energies fw_solid_energies(const fw_solid *solid)
{
    return solid->model->energies(solid);
}

static inline fw_vec2 fw_solid_momentum(const fw_solid *solid)
{
    return solid->model->momentum(solid);
}

static inline double fw_solid_angular_momentum(const fw_solid *solid, int first, int count)
{
    return solid->model->angular_momentum(solid, first, count);
}

static inline fw_vec2 fw_solid_position(const fw_solid *solid, int particle)
{
    return (fw_vec2){solid->x[particle], solid->y[particle]};
}

/* The field of that name, or NULL. */
const fw_field *fw_solid_find_field(const fw_solid *solid, const char *name);

/* Index of the first particle whose position is not finite or lies further than `limit` from
 * `centre` in x or y; -1 if there is none. */
int fw_solid_find_lost(const fw_solid *solid, fw_vec2 centre, double limit);
/* The same of boundary particles alone. */
int fw_solid_find_lost_boundary(const fw_solid *solid, fw_vec2 centre, double limit);

FW_PUBLIC_END

#endif
