/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constrain.h - the force that walls put on one particle in one step.
 *
 * The displacement w of a particle is the point nearest to the free one, w_p, in the norm of its
 * mass, that passes no wall: w = w_p + A sum_k lambda_k n_k with 0 <= lambda_k _|_ n_k.w - b_k >=
 * 0, b_k the motion of the wall itself. For one resting wall this is the hold rule F_n = -2 Psi_n.
 * Complementarity is with the displacement, not with the gap: that is what keeps energy exact.
 * Curved walls take their normal at the middle of the step, so that the distance from the centre
 * is held exactly. Friction follows with the reaction [lambda(t) + lambda(t-1)]/2 as its bound. */
#ifndef FW_CONSTRAIN_H
#define FW_CONSTRAIN_H

#include "contact/geometry/wall.h"
#include "core/solid.h"

/* One facet as it stands in this step. */
typedef struct fw_candidate {
    const fw_facet *facet;
    int number; /* of the facet in the scene */
    fw_surface surface;
    fw_vec2 place;  /* displacement of its wall from its definition, at the start of the step */
    fw_vec2 motion; /* how far the wall moves in this step */
} fw_candidate;

/* What a particle remembers from step to step; all zero for one without contact. Part of the
 * state. */
typedef struct fw_contact_memory {
    double reaction; /* normal force of the last step, of the facet below */
    double inertial; /* tangential inertial displacement of the last step, relative to its wall */
    int32_t facet;   /* 1 + number; 0: none */
    int32_t stuck;   /* stuck in the last step */
    double crept;    /* along the tangent, relative to its wall, since the step after it stuck */
} fw_contact_memory;

/* What one wall does to the particle. */
typedef struct fw_wall_contact {
    int wall;
    fw_vec2 force;
    double work;       /* done by the wall's own motion */
    double dissipated; /* turned into heat by friction, >= 0 */
    double cone;       /* the bound of friction: its coefficient times the reaction; 0: none */
    double beyond;     /* by how much friction exceeds that */
    bool spring;       /* of a piston; its work is booked with what it stores */
} fw_wall_contact;

enum { FW_WALL_CONTACTS = 4 };

/* Facets that a particle must not pass, by their numbers in the scene, whether they push or not. */
typedef struct fw_row_list {
    int count;
    int facet[FW_WALL_CONTACTS];
} fw_row_list;

typedef struct fw_contact_solution {
    bool held; /* false: the free displacement stands, the rest is empty */
    fw_vec2 displacement;
    fw_vec2 force; /* sum over the walls */
    int wall_contact_count;
    fw_wall_contact wall_contact[FW_WALL_CONTACTS];
    fw_row_list rows;
    bool unresolved; /* no consistent set of rows was found: the particle is pinned to one wall */
} fw_contact_solution;

/* `near` are the candidates, `all` the scene's candidates by number (a particle rubs on in the step
 * after its release, however far its candidates were looked for). `memory` is updated; it may be
 * NULL where no wall has Coulomb friction. */
fw_contact_solution fw_constrain(fw_vec2 position, const fw_prediction *free,
                                 const fw_candidate *near, int near_count, const fw_candidate *all,
                                 fw_contact_memory *memory);

#endif
