/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constrain.c - contact of one particle with several walls: rows (rows.c) and friction (rub.c)
 * together. State: none but the particle's own memory. Rows are only ever added, so the search
 * ends. Start reading at fw_constrain(). */
#include "rub.h"

#include <math.h>

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
                  tangential = square_of(fw_vec2_turn(r->normal), r->tangential_stiffness);
    if (r->pinned) return fw_sym2_invert(mobility);
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
    fw_row_list rows = {.count = p->count, .jam = p->jam};
    for (int k = 0; k < p->count; ++k) rows.facet[k] = p->rows[k].candidate->number;
    return rows;
}

static fw_contact_solution report(const constrain_problem *p, const double *traction)
{
    fw_contact_solution c = {.displacement = p->w, .rows = rows_of(p)};
    for (int k = 0; k < p->count; ++k) {
        const constrain_row *r = &p->rows[k];
        if (!r->pinned && r->lambda == 0 && traction[k] == 0) continue;
        const fw_vec2 motion = r->candidate->motion;
        fw_vec2 normal_force = fw_vec2_scale(r->lambda, r->normal);
        fw_vec2 friction = fw_vec2_scale(traction[k], fw_vec2_turn(r->normal));
        if (r->pinned) {
            normal_force = (fw_vec2){0, 0};
            friction = constrain_force_for(p);
        }
        fw_wall_contact wall_contact = {.wall = r->candidate->facet->wall,
                                        .force = fw_vec2_add(normal_force, friction)};
        wall_contact.work = fw_vec2_dot(wall_contact.force, motion);
        wall_contact.dissipated = -fw_vec2_dot(friction, fw_vec2_subtract(p->w, motion));
        wall_contact.stiffness = stiffness_of(p, k);
        wall_contact.cone = r->cone;
        wall_contact.beyond = r->beyond;
        c.wall_contact[c.wall_contact_count++] = wall_contact;
        c.force = fw_vec2_add(c.force, wall_contact.force);
    }
    c.held = c.wall_contact_count > 0;
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
    return active == 1 && p->rows[*k].candidate->surface.law == FW_COULOMB;
}

/* Adds rows until the path passes nothing more. False where no displacement was found. */
static bool find_rows(constrain_problem *p, const fw_candidate *near, int near_count)
{
    for (const fw_candidate *passed = constrain_find_passed(p, near, near_count); passed;
         passed = constrain_find_passed(p, near, near_count)) {
        if (p->count == FW_WALL_CONTACTS) return false;
        p->rows[p->count++] = (constrain_row){.candidate = passed};
        if (!constrain_solve(p)) return false;
    }
    return true;
}

/* The step after a release, in which the wall still rubs, unless that would turn the path through
 * a wall. (A mobility that is a matrix turns it away from the tangent.) */
static fw_contact_solution rub_once_more(constrain_problem *p, const fw_candidate *near,
                                         int near_count, const fw_candidate *all,
                                         fw_contact_memory *memory)
{
    const fw_candidate *candidate = &all[memory->facet - 1];
    double traction[FW_WALL_CONTACTS] = {0};
    constrain_row *r = &p->rows[0];
    *r = (constrain_row){.candidate = candidate};
    constrain_update_row(p, r);
    traction[0] = constrain_rub(p, r, all, memory);
    p->count = 1;
    const bool turned =
        constrain_is_passed(p, candidate) || constrain_find_passed(p, near, near_count);
    if (!turned) return report(p, traction);
    *memory = (fw_contact_memory){0};
    return (fw_contact_solution){0};
}

/* Begins with the rows of an earlier try, of which none may be needed any more. False where no
 * displacement was found. */
static bool keep_rows(constrain_problem *p, const fw_row_list *kept, const fw_candidate *all)
{
    bool needed = false;
    for (int k = 0; kept && k < kept->count; ++k) {
        constrain_row *r = &p->rows[p->count++];
        r->candidate = &all[kept->facet[k]];
        constrain_update_row(p, r);
        needed |= fw_vec2_dot(r->normal, p->w) < r->bound;
    }
    return !needed || constrain_solve(p);
}

static bool is_free(const constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].lambda != 0 || p->rows[k].pinned) return false;
    return true;
}

fw_contact_solution fw_constrain(fw_vec2 position, const fw_prediction *free,
                                 const fw_row_list *kept, const fw_candidate *near, int near_count,
                                 const fw_candidate *all, fw_contact_memory *memory)
{
    constrain_problem p = {.position = position, .free = free, .w = free->displacement};
    double traction[FW_WALL_CONTACTS] = {0};
    if (free->mobility.xx == 0) return (fw_contact_solution){0}; /* a resting colour */
    bool resolved = keep_rows(&p, kept, all) && find_rows(&p, near, near_count);
    if (resolved && is_free(&p)) {
        fw_row_list rows = rows_of(&p);
        fw_contact_solution c = {0};
        rows.released = kept && kept->released;
        if (memory && memory->reaction > 0 && !rows.released) {
            c = rub_once_more(&p, near, near_count, all, memory);
            rows.released = !c.held;
        } else if (memory) {
            *memory = (fw_contact_memory){0};
        }
        c.rows = rows;
        return c;
    }
    int k = 0;
    const bool rubs = resolved && memory && adds_friction(&p, &k);
    if (rubs) traction[k] = constrain_rub(&p, &p.rows[k], all, memory);
    /* Friction may have turned the path through another wall. */
    if (rubs || p.count > 1)
        resolved =
            resolved && constrain_keeps_rows(&p) && !constrain_find_passed(&p, near, near_count);
    if (!resolved) {
        while (k < p.count - 1 && p.rows[k].infeasible) ++k;
        constrain_pin(&p, k);
        traction[k] = 0;
    }
    if (memory && !(rubs && resolved)) *memory = (fw_contact_memory){0};
    fw_contact_solution c = report(&p, traction);
    c.unresolved = !resolved;
    return c;
}
