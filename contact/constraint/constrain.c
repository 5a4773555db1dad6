/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constrain.c - contact of one particle with several walls: rows (rows.c) and friction (rub.c)
 * together. State: none but the particle's own memory. Rows are only ever added, so the search
 * ends. Start reading at fw_constrain(). */
#include "rub.h"

#include <math.h>

static fw_row_list rows_of(const constrain_problem *p)
{
    fw_row_list rows = {.count = p->count};
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

static bool is_free(const constrain_problem *p)
{
    for (int k = 0; k < p->count; ++k)
        if (p->rows[k].lambda != 0 || p->rows[k].pinned) return false;
    return true;
}

fw_contact_solution fw_constrain(fw_vec2 position, const fw_prediction *free,
                                 const fw_candidate *near, int near_count, const fw_candidate *all,
                                 fw_contact_memory *memory)
{
    constrain_problem p = {.position = position, .free = free, .w = free->displacement};
    double traction[FW_WALL_CONTACTS] = {0};
    if (free->mobility.xx == 0) return (fw_contact_solution){0}; /* a resting colour */
    bool resolved = find_rows(&p, near, near_count);
    if (resolved && is_free(&p)) {
        const fw_row_list rows = rows_of(&p);
        fw_contact_solution c = {0};
        if (memory && memory->reaction > 0)
            c = rub_once_more(&p, near, near_count, all, memory);
        else if (memory)
            *memory = (fw_contact_memory){0};
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
        constrain_pin(&p, k);
        traction[k] = 0;
    }
    if (memory && !(rubs && resolved)) *memory = (fw_contact_memory){0};
    fw_contact_solution c = report(&p, traction);
    c.unresolved = !resolved;
    return c;
}
