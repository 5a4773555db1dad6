/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rub.c - Coulomb friction of one particle on one wall: sticking by filtered hold, sliding bounded
 * by the reaction. State: none but the particle's own memory. Start reading at constrain_rub(). */
#include "rub.h"

#include "contact/constraint/friction_law.h"

#include <float.h>
#include <math.h>

/* What friction exceeds its cone by that part is rounding. */
#define ROUNDING 1e-9

/* After friction on a circle: back to the radius, with the forces along the normal and tangent of
 * the new middle of the step. Returns the tangential one. */
static double follow_curve(constrain_problem *p, constrain_row *r)
{
    constrain_keep_radius(p, r);
    constrain_update_row(p, r);
    fw_vec2 force = constrain_force_for(p);
    r->lambda = fw_vec2_dot(r->normal, force);
    return fw_vec2_dot(fw_vec2_turn(r->normal), force);
}

static double sticking_target(const fw_contact_memory *memory, bool same_wall, double inertial,
                              double slip)
{
    return fw_friction_target(same_wall && memory->stuck, inertial, inertial - memory->inertial,
                              slip);
}

/* Along the tangent, relative to the wall. */
static double slip_of(const constrain_problem *p, const constrain_row *r)
{
    return fw_vec2_dot(fw_vec2_turn(r->normal), fw_vec2_subtract(p->w, r->candidate->motion));
}

/* What is left of the slip of a particle that sticks to a circle: rounding of the way, and of where
 * it lies about the centre. */
static double slip_rounding(const constrain_problem *p, const constrain_row *r)
{
    const fw_vec2 motion = r->candidate->motion;
    const fw_vec2 from = fw_vec2_subtract(fw_vec2_subtract(p->position, r->candidate->place),
                                          r->candidate->facet->a);
    return 1e-12 * (fabs(p->free->displacement.x) + fabs(p->free->displacement.y) + fabs(motion.x) +
                    fabs(motion.y)) +
           4 * DBL_EPSILON * (fabs(from.x) + fabs(from.y));
}

/* A step that is long against the radius turns the tangent so far that friction would push along
 * with the slip: then there is none. What rounding leaves of a slip means nothing, and neither does
 * what is left of the traction of a particle that needs none. */
static bool feeds(const constrain_problem *p, const constrain_row *r, double traction)
{
    return fabs(traction) > 1e-12 * r->lambda &&
           traction * slip_of(p, r) > fabs(traction) * slip_rounding(p, r);
}

double constrain_rub(constrain_problem *p, constrain_row *r, const fw_candidate *all,
                     fw_contact_memory *memory)
{
    const fw_candidate *candidate = r->candidate;
    const constrain_row smooth = *r; /* without friction */
    const fw_vec2 smooth_path = p->w;
    const bool same_wall =
        memory->facet > 0 && all[memory->facet - 1].facet->wall == candidate->facet->wall;
    const double before = same_wall ? memory->reaction : 0;
    const fw_friction law =
        fw_friction_of(candidate->surface.friction, candidate->surface.static_friction);
    bool slides = same_wall && !memory->stuck;
    const fw_vec2 tangent = fw_vec2_turn(r->normal);
    const fw_sym2 mobility = p->free->mobility;
    const double nn = fw_sym2_form(r->normal, mobility, r->normal),
                 nt = fw_sym2_form(r->normal, mobility, tangent),
                 tt = fw_sym2_form(tangent, mobility, tangent);
    const double inertial =
        fw_vec2_dot(tangent, fw_vec2_subtract(p->free->inertial, candidate->motion));
    bool active = r->lambda > 0;
    double traction = 0, wanted = 0;
    if (active) {
        double slip = fw_vec2_dot(tangent, fw_vec2_subtract(p->w, candidate->motion));
        const double lambda = r->lambda;
        const double yielding = tt - nt * nt / nn;
        wanted = (sticking_target(memory, same_wall, inertial, slip) - slip) / yielding;
        traction = wanted;
        for (int round = 0; round < 4; ++round) { /* lambda moves with T where mobility couples */
            traction = fw_friction_traction(law, 0.5 * (r->lambda + before), wanted, &slides);
            r->lambda = fmax(0, lambda - traction * nt / nn);
        }
        /* Friction that lifts the particle off the wall acts on a free one. */
        active = r->lambda > 0;
    }
    if (!active) {
        double slip =
            fw_vec2_dot(tangent, fw_vec2_subtract(p->free->displacement, candidate->motion));
        wanted = (sticking_target(memory, same_wall, inertial, slip) - slip) / tt;
        traction = fw_friction_traction(law, 0.5 * before, wanted, &slides);
        r->lambda = 0;
    }
    p->w = constrain_displacement_for(
        p, fw_vec2_add(fw_vec2_scale(r->lambda, r->normal), fw_vec2_scale(traction, tangent)));
    if (active)
        p->w = fw_vec2_subtract(p->w,
                                fw_vec2_scale(fw_vec2_dot(r->normal, p->w) - r->bound, r->normal));
    bool stuck = traction == wanted;
    if (fw_facet_is_curved(candidate->facet) && active) {
        traction = follow_curve(p, r);
        if (feeds(p, r, traction)) {
            *r = smooth;
            p->w = smooth_path;
            traction = 0;
            stuck = false;
        }
    }
    r->cone = 0.5 * (slides ? law.kinetic : law.at_rest) * (r->lambda + before);
    r->beyond = fmax(0, fabs(traction) - r->cone * (1 + ROUNDING));
    const bool stays = stuck && same_wall && memory->stuck;
    *memory = (fw_contact_memory){.reaction = r->lambda,
                                  .inertial = inertial,
                                  .facet = candidate->number + 1,
                                  .stuck = stuck,
                                  .crept = stays ? memory->crept + slip_of(p, r) : 0};
    return traction;
}
