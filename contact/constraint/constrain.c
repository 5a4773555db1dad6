/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constrain.c - contact of one particle with several walls; friction stands in rub.c.
 * State: none but the particle's own memory. Rows are only ever added, so the search ends.
 * Start reading at fw_constrain(). */
#include "constrain_parts.h"

#include <math.h>

static fw_vec2 relative_position(const constrain_problem *p, const fw_barrier *barrier)
{
    return fw_vec2_subtract(p->position, barrier->place);
}

/* How far the wall is from its definition, for tolerances. */
static double away(const fw_barrier *barrier)
{
    return fmax(fabs(barrier->place.x), fabs(barrier->place.y));
}

static bool is_passed(const constrain_problem *p, const fw_barrier *barrier)
{
    return fw_facet_is_passed(barrier->facet, relative_position(p, barrier),
                              fw_vec2_subtract(p->w, barrier->motion), away(barrier));
}

/* At the middle of the step, where the normal of a curved facet holds its distance exactly. */
static fw_vec2 midpoint_normal(const constrain_problem *p, const fw_barrier *barrier)
{
    return fw_facet_normal(
        barrier->facet,
        fw_vec2_add(fw_vec2_subtract(relative_position(p, barrier), barrier->facet->a),
                    fw_vec2_scale(0.5, fw_vec2_subtract(p->w, barrier->motion))));
}

/* A particle that rounding put a few last bits behind the surface is asked to come back to it. */
static double bound_of(const constrain_problem *p, const constrain_row *r)
{
    double bound = fw_vec2_dot(r->normal, r->barrier->motion);
    double gap = fw_facet_gap(r->barrier->facet, relative_position(p, r->barrier));
    return gap < 0 ? bound - gap : bound;
}

void constrain_update_row(const constrain_problem *p, constrain_row *r)
{
    r->normal = midpoint_normal(p, r->barrier);
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
    const fw_facet *facet = r->barrier->facet;
    fw_vec2 from = fw_vec2_subtract(relative_position(p, r->barrier), facet->a);
    fw_vec2 to = fw_vec2_add(from, fw_vec2_subtract(p->w, r->barrier->motion));
    double radius = sqrt(fw_vec2_dot(from, from)), length = sqrt(fw_vec2_dot(to, to));
    radius = facet->side == FW_INSIDE ? fmin(radius, facet->length) : fmax(radius, facet->length);
    if (length > 0) to = fw_vec2_scale(radius / length, to);
    p->w = fw_vec2_add(fw_vec2_subtract(to, from), r->barrier->motion);
}

/* A single circle and an isotropic mobility have a closed form: r_new = ((1+s) r + w)/(1-s) lies
 * at the radius of r. Rounding is taken out by scaling to that radius. */
static bool solve_circle(constrain_problem *p)
{
    constrain_row *r = &p->rows[0];
    const fw_sym2 mobility = p->free->mobility;
    if (p->count != 1 || !fw_facet_is_curved(r->barrier->facet) || mobility.xy != 0 ||
        mobility.xx != mobility.yy)
        return false;
    const fw_facet *facet = r->barrier->facet;
    fw_vec2 from = fw_vec2_subtract(relative_position(p, r->barrier), facet->a);
    fw_vec2 w = fw_vec2_subtract(p->free->displacement, r->barrier->motion);
    double r2 = fw_vec2_dot(from, from), rw = fw_vec2_dot(from, w), w2 = fw_vec2_dot(w, w);
    if (!(4 * r2 + 2 * rw > 0)) return false;
    double s = -(2 * rw + w2) / (4 * r2 + 2 * rw);
    if (!(s < 1)) return false;
    fw_vec2 to = fw_vec2_scale(1 / (1 - s), fw_vec2_add(fw_vec2_scale(1 + s, from), w));
    p->w = fw_vec2_add(fw_vec2_subtract(to, from), r->barrier->motion);
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
    for (int k = 0; k < p->count; ++k) curved |= fw_facet_is_curved(p->rows[k].barrier->facet);
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
        p->rows[j].fast = j == k;
    }
    p->rows[k].lambda = fw_vec2_dot(p->rows[k].normal, constrain_force_for(p));
}

/* Held fast to a wall: all components follow it. */
static void hold_fast(constrain_problem *p, int k)
{
    p->w = p->rows[k].barrier->motion;
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
static bool keeps_rows(const constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k) {
        const constrain_row *r = &p->rows[k];
        const fw_facet *facet = r->barrier->facet;
        const double tolerance = fw_facet_tolerance(facet, away(r->barrier));
        if (r->lame) continue;
        if (fw_facet_is_curved(facet)) {
            fw_vec2 end = fw_vec2_add(relative_position(p, r->barrier),
                                      fw_vec2_subtract(p->w, r->barrier->motion));
            if (fw_facet_gap(facet, end) < -tolerance) return false;
        } else if (!(fw_vec2_dot(r->normal, p->w) >= r->bound - tolerance)) {
            return false;
        }
    }
    return true;
}

static bool solve_together(constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k) constrain_update_row(p, &p->rows[k]);
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].barrier->surface.law == FW_STICK) {
            hold_fast(p, k);
            if (keeps_rows(p)) return true;
            /* Another wall pushes it off. */
            for (int j = 0; j < p->count; ++j) p->rows[j].fast = false;
            return solve_normals(p);
        }
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].barrier->surface.law == FW_COMPONENTWISE) {
            freeze_components(p);
            return true;
        }
    return solve_normals(p);
}

/* The wall that stands behind a particle, as seen along the normal of a piston: the most opposite
 * of those that push, or one that holds it fast; -1: there is none. */
static int find_behind(const constrain_problem *firm, fw_vec2 normal)
{
    int behind = -1;
    double most_opposite = -1e-9;
    for (int n = 0; n < firm->count; ++n) {
        const constrain_row *r = &firm->rows[n];
        const double along = fw_vec2_dot(r->normal, normal);
        if (along < most_opposite || (r->fast && behind < 0)) {
            most_opposite = fmin(along, most_opposite);
            behind = r->barrier->facet->wall;
        }
    }
    return behind;
}

/* Of a particle that a piston presses against walls that do not yield: they hold it, and it stops
 * the piston. False where it is not they that hold it. */
static bool stop_pistons(constrain_problem *p)
{
    constrain_problem firm = *p;
    double deepest = 0;
    fw_stop stop = {0};
    firm.count = 0;
    for (int k = 0; k < p->count; ++k)
        if (!p->rows[k].barrier->yields) firm.rows[firm.count++] = p->rows[k];
    if (firm.count == 0 || firm.count == p->count || !solve_together(&firm)) return false;
    for (int k = 0; k < p->count; ++k) {
        const constrain_row *r = &p->rows[k];
        const double along = fw_vec2_dot(r->normal, firm.w);
        if (!r->barrier->yields || r->bound - along <= deepest) continue;
        deepest = r->bound - along;
        /* The bound is the wall's motion, and more where the particle is behind it. */
        const double limit = along - (r->bound - fw_vec2_dot(r->normal, r->barrier->motion));
        stop =
            (fw_stop){1 + r->barrier->facet->wall, find_behind(&firm, r->normal), r->normal, limit};
    }
    if (stop.piston == 0 || stop.against < 0) return false;
    for (int k = 0, n = 0; k < p->count; ++k) {
        constrain_row *r = &p->rows[k];
        if (r->barrier->yields)
            *r = (constrain_row){
                .barrier = r->barrier, .normal = r->normal, .bound = r->bound, .lame = true};
        else
            *r = firm.rows[n++];
    }
    p->stop = stop;
    p->w = firm.w;
    return true;
}

static bool solve(constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k) p->rows[k].lame = false;
    return solve_together(p) || stop_pistons(p);
}

/* The first barrier that the present displacement passes and that is not a row yet, or NULL. */
static const fw_barrier *find_passed(const constrain_problem *p, const fw_barrier *barriers,
                                     int count)
{
    for (int n = 0; n < count; ++n) {
        const fw_barrier *barrier = &barriers[n];
        bool known = barrier->surface.law == FW_PENALTY;
        for (int k = 0; k < p->count; ++k) known |= p->rows[k].barrier->number == barrier->number;
        if (!known && is_passed(p, barrier)) return barrier;
    }
    return NULL;
}

static fw_sym2 square_of(fw_vec2 v, double factor)
{
    return (fw_sym2){factor * v.x * v.x, factor * v.x * v.y, factor * v.y * v.y};
}

/* - dF/d(motion of its wall) of row k: along the normal d lambda_k/d b_k, from the inverse of N A
 * N^T of the active rows (of three or more any two will do), along the tangent what friction says.
 */
static fw_sym2 stiffness_of(const constrain_problem *p, int k)
{
    const constrain_row *r = &p->rows[k], *other = NULL;
    const fw_sym2 mobility = p->free->mobility,
                  tangential = square_of(fw_vec2_turn(r->normal), r->grasp);
    if (r->fast) return fw_sym2_invert(mobility);
    if (!(r->lambda > 0)) return tangential;
    for (int j = 0; j < p->count && !other; ++j)
        if (j != k && p->rows[j].lambda > 0) other = &p->rows[j];
    double stiffness = 1 / fw_sym2_form(r->normal, mobility, r->normal);
    if (other) {
        const double crossed = fw_sym2_form(r->normal, mobility, other->normal);
        const double second = fw_sym2_form(other->normal, mobility, other->normal);
        const double less = 1 - crossed * crossed * stiffness / second;
        if (less > 1e-6) stiffness /= less;
    }
    return fw_sym2_add(square_of(r->normal, stiffness), tangential);
}

static fw_row_list rows_of(const constrain_problem *p)
{
    fw_row_list rows = {.count = p->count, .stop = p->stop};
    for (int k = 0; k < p->count; ++k) rows.facet[k] = p->rows[k].barrier->number;
    return rows;
}

static fw_contact_solution report(const constrain_problem *p, const double *tension)
{
    fw_contact_solution c = {.displacement = p->w, .rows = rows_of(p)};
    for (int k = 0; k < p->count; ++k) {
        const constrain_row *r = &p->rows[k];
        if (!r->fast && r->lambda == 0 && tension[k] == 0) continue;
        const fw_vec2 motion = r->barrier->motion;
        fw_vec2 normal_force = fw_vec2_scale(r->lambda, r->normal);
        fw_vec2 friction = fw_vec2_scale(tension[k], fw_vec2_turn(r->normal));
        if (r->fast) {
            normal_force = (fw_vec2){0, 0};
            friction = constrain_force_for(p);
        }
        fw_touch touch = {.wall = r->barrier->facet->wall,
                          .force = fw_vec2_add(normal_force, friction)};
        touch.work = fw_vec2_dot(touch.force, motion);
        touch.dissipated = -fw_vec2_dot(friction, fw_vec2_subtract(p->w, motion));
        touch.stiffness = stiffness_of(p, k);
        c.touch[c.touch_count++] = touch;
        c.force = fw_vec2_add(c.force, touch.force);
    }
    c.held = c.touch_count > 0;
    return c;
}

static bool adds_friction(const constrain_problem *p, int *k)
{
    int active = 0;
    for (int n = 0; n < p->count; ++n)
        if (p->rows[n].lambda > 0) {
            active += 1;
            *k = n;
        }
    return active == 1 && p->rows[*k].barrier->surface.law == FW_COULOMB;
}

/* Adds rows until the path passes nothing more. False where no displacement was found. */
static bool find_rows(constrain_problem *p, const fw_barrier *near, int near_count)
{
    for (const fw_barrier *passed = find_passed(p, near, near_count); passed;
         passed = find_passed(p, near, near_count)) {
        if (p->count == FW_TOUCH_MAX) return false;
        p->rows[p->count++] = (constrain_row){.barrier = passed};
        if (!solve(p)) return false;
    }
    return true;
}

/* The step after a release, in which the wall still rubs, unless that would turn the path through
 * a wall. (A mobility that is a matrix turns it away from the tangent.) */
static fw_contact_solution rub_once_more(constrain_problem *p, const fw_barrier *near,
                                         int near_count, const fw_barrier *all,
                                         fw_contact_memory *memory)
{
    const fw_barrier *barrier = &all[memory->facet - 1];
    double tension[FW_TOUCH_MAX] = {0};
    constrain_row *r = &p->rows[0];
    *r = (constrain_row){.barrier = barrier};
    constrain_update_row(p, r);
    tension[0] = constrain_rub(p, r, all, memory);
    p->count = 1;
    const bool turned = is_passed(p, barrier) || find_passed(p, near, near_count);
    if (!turned) return report(p, tension);
    *memory = (fw_contact_memory){0};
    return (fw_contact_solution){0};
}

/* Begins with the rows of an earlier try, of which none may be needed any more. False where no
 * displacement was found. */
static bool keep_rows(constrain_problem *p, const fw_row_list *kept, const fw_barrier *all)
{
    bool needed = false;
    for (int k = 0; kept && k < kept->count; ++k) {
        constrain_row *r = &p->rows[p->count++];
        r->barrier = &all[kept->facet[k]];
        constrain_update_row(p, r);
        needed |= fw_vec2_dot(r->normal, p->w) < r->bound;
    }
    return !needed || solve(p);
}

static bool is_free(const constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].lambda != 0 || p->rows[k].fast) return false;
    return true;
}

fw_contact_solution fw_constrain(fw_vec2 position, const fw_prediction *free,
                                 const fw_row_list *kept, const fw_barrier *near, int near_count,
                                 const fw_barrier *all, fw_contact_memory *memory)
{
    constrain_problem p = {.position = position, .free = free, .w = free->displacement};
    double tension[FW_TOUCH_MAX] = {0};
    if (free->mobility.xx == 0) return (fw_contact_solution){0}; /* a resting colour */
    bool resolved = keep_rows(&p, kept, all) && find_rows(&p, near, near_count);
    if (resolved && is_free(&p)) {
        fw_row_list rows = rows_of(&p);
        fw_contact_solution c = {0};
        rows.let_go = kept && kept->let_go;
        if (memory && memory->reaction > 0 && !rows.let_go) {
            c = rub_once_more(&p, near, near_count, all, memory);
            rows.let_go = !c.held;
        } else if (memory) {
            *memory = (fw_contact_memory){0};
        }
        c.rows = rows;
        return c;
    }
    int k = 0;
    const bool rubs = resolved && memory && adds_friction(&p, &k);
    if (rubs) tension[k] = constrain_rub(&p, &p.rows[k], all, memory);
    /* Friction may have turned the path through another wall. */
    if (rubs || p.count > 1)
        resolved = resolved && keeps_rows(&p) && !find_passed(&p, near, near_count);
    if (!resolved) {
        while (k < p.count - 1 && p.rows[k].lame) ++k;
        hold_fast(&p, k);
        tension[k] = 0;
    }
    if (memory && !(rubs && resolved)) *memory = (fw_contact_memory){0};
    fw_contact_solution c = report(&p, tension);
    c.unresolved = !resolved;
    return c;
}
