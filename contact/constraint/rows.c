/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rows.c - the displacement of one particle between several walls, without friction. Keeps no
 * state. Start reading at constrain_solve(). */
#include "rows.h"

#include <math.h>

static fw_vec2 relative_position(const constrain_problem *p, const fw_candidate *candidate)
{
    return fw_vec2_subtract(p->position, candidate->place);
}

/* How far the wall is from its definition, for tolerances. */
static double away(const fw_candidate *candidate)
{
    return fmax(fabs(candidate->place.x), fabs(candidate->place.y));
}

bool constrain_is_passed(const constrain_problem *p, const fw_candidate *candidate)
{
    return fw_facet_is_passed(candidate->facet, relative_position(p, candidate),
                              fw_vec2_subtract(p->w, candidate->motion), away(candidate));
}

/* At the middle of the step, where the normal of a curved facet holds its distance exactly. */
static fw_vec2 midpoint_normal(const constrain_problem *p, const fw_candidate *candidate)
{
    return fw_facet_normal(
        candidate->facet,
        fw_vec2_add(fw_vec2_subtract(relative_position(p, candidate), candidate->facet->a),
                    fw_vec2_scale(0.5, fw_vec2_subtract(p->w, candidate->motion))));
}

/* A particle that rounding put a few last bits behind the surface is brought back to it. */
static double bound_of(const constrain_problem *p, const constrain_row *r)
{
    double bound = fw_vec2_dot(r->normal, r->candidate->motion);
    double gap = fw_facet_gap(r->candidate->facet, relative_position(p, r->candidate));
    return gap < 0 ? bound - gap : bound;
}

void constrain_update_row(const constrain_problem *p, constrain_row *r)
{
    r->normal = midpoint_normal(p, r->candidate);
    r->bound = bound_of(p, r);
}

fw_vec2 constrain_displacement_for(const constrain_problem *p, fw_vec2 force)
{
    return fw_vec2_add(p->free->displacement, fw_sym2_apply(p->free->mobility, force));
}

fw_vec2 constrain_force_for(const constrain_problem *p)
{
    return fw_sym2_apply(fw_sym2_invert(p->free->mobility),
                         fw_vec2_subtract(p->w, p->free->displacement));
}

static bool is_feasible(const constrain_problem *p, fw_vec2 w, int a, int b)
{
    double scale = fabs(p->free->displacement.x) + fabs(p->free->displacement.y);
    for (int k = 0; k < p->count; ++k) {
        if (k == a || k == b) continue;
        const constrain_row *r = &p->rows[k];
        if (fw_vec2_dot(r->normal, w) < r->bound - 1e-14 * (scale + fabs(r->bound))) return false;
    }
    return true;
}

/* Only row k active. The last line takes out what rounding left along the normal: for a wall
 * along an axis the particle stays where it is to the last bit. */
static bool solve_one(constrain_problem *p, int k)
{
    constrain_row *r = &p->rows[k];
    double excess = r->bound - fw_vec2_dot(r->normal, p->free->displacement);
    double lambda = excess / fw_sym2_form(r->normal, p->free->mobility, r->normal);
    if (!(lambda >= 0)) return false;
    fw_vec2 w = constrain_displacement_for(p, fw_vec2_scale(lambda, r->normal));
    w = fw_vec2_subtract(w, fw_vec2_scale(fw_vec2_dot(r->normal, w) - r->bound, r->normal));
    if (!is_feasible(p, w, k, k)) return false;
    for (int j = 0; j < p->count; ++j) p->rows[j].lambda = 0;
    r->lambda = lambda;
    p->w = w;
    return true;
}

/* Rows a and b active: w follows from the normals alone, the forces from the mobility. */
static bool solve_two(constrain_problem *p, int a, int b)
{
    constrain_row *ra = &p->rows[a], *rb = &p->rows[b];
    double det = fw_vec2_cross(ra->normal, rb->normal);
    if (fabs(det) < 1e-12) return false;
    fw_vec2 w = {(ra->bound * rb->normal.y - rb->bound * ra->normal.y) / det,
                 (rb->bound * ra->normal.x - ra->bound * rb->normal.x) / det};
    fw_vec2 force = fw_sym2_apply(fw_sym2_invert(p->free->mobility),
                                  fw_vec2_subtract(w, p->free->displacement));
    double la = fw_vec2_cross(force, rb->normal) / det;
    double lb = fw_vec2_cross(ra->normal, force) / det;
    if (!(la >= 0 && lb >= 0) || !is_feasible(p, w, a, b)) return false;
    for (int j = 0; j < p->count; ++j) p->rows[j].lambda = 0;
    ra->lambda = la;
    rb->lambda = lb;
    p->w = w;
    return true;
}

/* In the plane at most two rows are active: try all ones and pairs. */
static bool solve_rows(constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k)
        if (solve_one(p, k)) return true;
    for (int a = 0; a < p->count; ++a)
        for (int b = a + 1; b < p->count; ++b)
            if (solve_two(p, a, b)) return true;
    return false;
}

void constrain_keep_radius(constrain_problem *p, const constrain_row *r)
{
    const fw_facet *facet = r->candidate->facet;
    fw_vec2 from = fw_vec2_subtract(relative_position(p, r->candidate), facet->a);
    fw_vec2 to = fw_vec2_add(from, fw_vec2_subtract(p->w, r->candidate->motion));
    double radius = sqrt(fw_vec2_dot(from, from)), length = sqrt(fw_vec2_dot(to, to));
    radius = facet->side == FW_INSIDE ? fmin(radius, facet->length) : fmax(radius, facet->length);
    if (length > 0) to = fw_vec2_scale(radius / length, to);
    p->w = fw_vec2_add(fw_vec2_subtract(to, from), r->candidate->motion);
}

/* A single circle and an isotropic mobility have a closed form: r_new = ((1+s) r + w)/(1-s) lies
 * at the radius of r. Rounding is taken out by scaling to that radius. */
static bool solve_circle(constrain_problem *p)
{
    constrain_row *r = &p->rows[0];
    const fw_sym2 mobility = p->free->mobility;
    if (p->count != 1 || !fw_facet_is_curved(r->candidate->facet) || mobility.xy != 0 ||
        mobility.xx != mobility.yy)
        return false;
    const fw_facet *facet = r->candidate->facet;
    fw_vec2 from = fw_vec2_subtract(relative_position(p, r->candidate), facet->a);
    fw_vec2 w = fw_vec2_subtract(p->free->displacement, r->candidate->motion);
    double r2 = fw_vec2_dot(from, from), rw = fw_vec2_dot(from, w), w2 = fw_vec2_dot(w, w);
    if (!(4 * r2 + 2 * rw > 0)) return false;
    double s = -(2 * rw + w2) / (4 * r2 + 2 * rw);
    if (!(s < 1)) return false;
    fw_vec2 to = fw_vec2_scale(1 / (1 - s), fw_vec2_add(fw_vec2_scale(1 + s, from), w));
    p->w = fw_vec2_add(fw_vec2_subtract(to, from), r->candidate->motion);
    constrain_keep_radius(p, r);
    constrain_update_row(p, r);
    r->lambda = fw_vec2_dot(r->normal, fw_vec2_subtract(p->w, p->free->displacement)) / mobility.xx;
    return r->lambda >= 0;
}

/* The fixed point of w and its midpoint normals. False where it is not reached. */
static bool solve_normals(constrain_problem *p)
{
    if (solve_circle(p)) return true;
    bool curved = false;
    for (int k = 0; k < p->count; ++k) curved |= fw_facet_is_curved(p->rows[k].candidate->facet);
    for (int k = 0; k < p->count; ++k) constrain_update_row(p, &p->rows[k]);
    if (!curved) return solve_rows(p);
    for (int round = 0; round < 100; ++round) {
        fw_vec2 before = p->w;
        for (int k = 0; k < p->count; ++k) constrain_update_row(p, &p->rows[k]);
        if (!solve_rows(p)) return false;
        double change = fabs(p->w.x - before.x) + fabs(p->w.y - before.y);
        if (change <= 1e-16 + 1e-14 * (fabs(p->w.x) + fabs(p->w.y))) return true;
        double relax = round < 20 ? 1 : round < 60 ? 0.5 : 0.2;
        p->w = fw_vec2_add(before, fw_vec2_scale(relax, fw_vec2_subtract(p->w, before)));
    }
    return false;
}

/* The whole force that w takes belongs to row k. */
static void book_whole(constrain_problem *p, int k)
{
    for (int j = 0; j < p->count; ++j) {
        p->rows[j].lambda = 0;
        p->rows[j].pinned = j == k;
    }
    p->rows[k].lambda = fw_vec2_dot(p->rows[k].normal, constrain_force_for(p));
}

/* Pinned to a wall: all components follow it. */
void constrain_pin(constrain_problem *p, int k)
{
    p->w = p->rows[k].candidate->motion;
    book_whole(p, k);
}

/* The paper's words for the automaton: what would pass is frozen, the rest is left alone. */
static void freeze_components(constrain_problem *p)
{
    p->w = p->free->displacement;
    for (int k = 0; k < p->count; ++k) {
        constrain_row *r = &p->rows[k];
        double excess = fw_vec2_dot(r->normal, p->w) - r->bound;
        if (excess < 0) p->w = fw_vec2_subtract(p->w, fw_vec2_scale(excess, r->normal));
    }
    /* The force is not along the normals where they are oblique or the mobility couples: it is
     * booked whole, on the first. */
    book_whole(p, 0);
}

/* Does w keep to all rows? */
bool constrain_keeps_rows(const constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k) {
        const constrain_row *r = &p->rows[k];
        const fw_facet *facet = r->candidate->facet;
        const double tolerance = fw_facet_tolerance(facet, away(r->candidate));
        if (fw_facet_is_curved(facet)) {
            fw_vec2 end = fw_vec2_add(relative_position(p, r->candidate),
                                      fw_vec2_subtract(p->w, r->candidate->motion));
            if (fw_facet_gap(facet, end) < -tolerance) return false;
        } else if (!(fw_vec2_dot(r->normal, p->w) >= r->bound - tolerance)) {
            return false;
        }
    }
    return true;
}

bool constrain_solve(constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k) constrain_update_row(p, &p->rows[k]);
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].candidate->surface.law == FW_STICK) {
            constrain_pin(p, k);
            if (constrain_keeps_rows(p)) return true;
            /* Another wall pushes it off. */
            for (int j = 0; j < p->count; ++j) p->rows[j].pinned = false;
            return solve_normals(p);
        }
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].candidate->surface.law == FW_COMPONENTWISE) {
            freeze_components(p);
            return true;
        }
    return solve_normals(p);
}

/* The first candidate that the present displacement passes and that is not a row yet, or NULL. */
const fw_candidate *constrain_find_passed(const constrain_problem *p,
                                          const fw_candidate *candidates, int count)
{
    for (int n = 0; n < count; ++n) {
        const fw_candidate *candidate = &candidates[n];
        bool known = candidate->surface.law == FW_PENALTY;
        for (int k = 0; k < p->count; ++k)
            known |= p->rows[k].candidate->number == candidate->number;
        if (!known && constrain_is_passed(p, candidate)) return candidate;
    }
    return NULL;
}
