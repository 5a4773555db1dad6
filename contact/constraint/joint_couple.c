/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_couple.c - normal forces and friction of an island at once, and with what its ends lead,
 * where solving them in turn does not settle. State: none. Start reading at joint_couple(). */
#include "couple.h"
#include "joint_parts.h"

#include <math.h>

/* Islands of so few forces settle to the last digits; and beyond so many it is not tried: a step
 * takes the third power of those that push or stick, 1 ms for 80 of them. */
enum { FEW = 64, UNKNOWNS = 80 };

/* What a row weighs of the forces on ends: of its own, and of those that lead them. */
enum { WEIGHED = 3 * (1 + FW_JOINT_LEADS) };
typedef struct couple_reach {
    int count, end[WEIGHED];
    fw_vec2 c[WEIGHED];
} couple_reach;

static couple_reach reach_of(const fw_joint *joint, const fw_joint_end *ends,
                             const joint_line *line, const fw_joint_row *row, const fw_vec2 *weight)
{
    couple_reach reach = {.count = line->count};
    for (int k = 0; k < line->count; ++k) {
        reach.end[k] = line->end[k];
        reach.c[k] = line->c[k];
    }
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &ends[row->end[k]];
        for (int m = 0; joint_moves(end) && m < end->lead_count; ++m) {
            const fw_joint_lead *lead = &end->lead[m];
            if (joint->local[lead->end] < 0) continue;
            const fw_vec2 back = {lead->x.x * weight[k].x + lead->y.x * weight[k].y,
                                  lead->x.y * weight[k].x + lead->y.y * weight[k].y};
            reach.end[reach.count] = joint->local[lead->end];
            reach.c[reach.count++] =
                joint_apply_transposed(joint_root_of(ends[lead->end].mobility), back);
        }
    }
    return reach;
}

static double reach_product(const couple_reach *a, const joint_line *b)
{
    double sum = 0;
    for (int n = 0; n < a->count; ++n)
        for (int m = 0; m < b->count; ++m)
            if (a->end[n] == b->end[m]) sum += fw_vec2_dot(a->c[n], b->c[m]);
    return sum;
}

static const joint_line *line_at(const couple *p, const fw_joint *joint, int n)
{
    return couple_is_tangent(p, n) ? &joint->tangents[n - p->normals] : &joint->lines[n];
}

static void fill_products(couple *p, const fw_joint *joint, const fw_joint_end *ends, int n,
                          const fw_joint_row *row, const fw_vec2 *weight)
{
    const couple_reach reach = reach_of(joint, ends, line_at(p, joint, n), row, weight);
    for (int m = 0; m < p->count; ++m)
        p->product[(size_t)n * (size_t)p->count + (size_t)m] =
            p->scale[n] * p->scale[m] * reach_product(&reach, line_at(p, joint, m));
}

static void fill_tangent(couple *p, const fw_joint *joint, const fw_joint_rub *rub, int n,
                         int normal)
{
    const double half = 0.5 * fw_joint_coefficient(rub);
    p->wanted[n] = -p->scale[n] * joint->slip[n - p->normals];
    p->target[n] = p->scale[n] * joint->target[n - p->normals];
    p->normal_of[n] = normal;
    p->half[n] = normal < 0 ? 0 : half * p->scale[normal] / p->scale[n];
    p->rest[n] = half * rub->before / p->scale[n];
    p->start[n] = rub->traction / p->scale[n];
    p->state[n] = fabs(rub->traction) < rub->limit ? STICKS
                  : rub->traction > 0              ? SLIDES_ON
                                                   : SLIDES_BACK;
}

/* Of lines and tangents as they are, with the states of the forces that they have. */
static void fill(couple *p, const fw_joint *joint, const fw_joint_end *ends,
                 const fw_joint_row *rows, const int *list, int count)
{
    for (int n = 0; n < p->count; ++n) p->scale[n] = 1 / line_at(p, joint, n)->length;
    for (int k = 0; k < count; ++k) {
        const fw_joint_row *row = &rows[list[k]];
        const int normal = joint->line_of[k];
        if (normal >= 0) {
            p->wanted[normal] = p->scale[normal] * joint->lines[normal].wanted;
            p->both[normal] = joint->lines[normal].both;
            p->both_count += p->both[normal];
            p->state[normal] = p->both[normal] || joint->lambda[normal] > 0 ? PUSHES : RESTS;
            p->start[normal] = joint->lambda[normal] / p->scale[normal];
            fill_products(p, joint, ends, normal, row, row->weight);
        }
        if (joint->tangent_of[k] < 0) continue;
        const int n = p->normals + joint->tangent_of[k];
        fill_tangent(p, joint, &row->rub, n, normal);
        fill_products(p, joint, ends, n, row, row->rub.weight);
    }
}

/* Adds to where ends that follow would go what their leads do beside w, with which that was found:
 * where these go without forces, with them, or w again. */
typedef enum couple_course { FREELY, FORCED, AS_BEFORE } couple_course;
static void lead(const fw_joint *joint, fw_joint_end *ends, int moving, couple_course course)
{
    for (int e = 0; e < moving; ++e) {
        fw_joint_end *follower = &ends[joint->global[e]];
        for (int m = 0; m < follower->lead_count; ++m) {
            const fw_joint_lead *lead = &follower->lead[m];
            const int local = joint->local[lead->end];
            if (local < 0) continue;
            const fw_joint_end *leader = &ends[lead->end];
            fw_vec2 by = fw_vec2_subtract(leader->free, joint->w[local]);
            if (course == AS_BEFORE) by = fw_vec2_scale(-1, by);
            if (course == FORCED)
                by = fw_vec2_add(leader->rubbed,
                                 joint_apply(joint_root_of(leader->mobility), joint->z[local]));
            follower->free = fw_vec2_add(
                follower->free, (fw_vec2){fw_vec2_dot(lead->x, by), fw_vec2_dot(lead->y, by)});
        }
    }
}

static void take_solution(const couple *p, fw_joint *joint, fw_joint_row *rows, const int *list,
                          int count)
{
    for (int n = 0; n < p->normals; ++n)
        joint->lambda[n] = p->scale[n] * (joint->lines[n].both ? p->x[n] : fmax(p->x[n], 0));
    for (int k = 0; k < count; ++k) {
        if (joint->tangent_of[k] < 0) continue;
        const int n = p->normals + joint->tangent_of[k];
        const double limit = couple_cone(p, n) * p->scale[n];
        rows[list[k]].rub.limit = limit;
        joint->traction[joint->tangent_of[k]] =
            p->state[n] == STICKS ? fmin(fmax(p->x[n] * p->scale[n], -limit), limit)
                                  : couple_direction(p, n) * limit;
    }
}

bool joint_is_few(const fw_joint_row *rows, const int *list, int count)
{
    int unknowns = 0;
    for (int n = 0; n < count; ++n)
        unknowns += !rows[list[n]].open + (rows[list[n]].rub.coefficient > 0);
    return unknowns <= FEW;
}

fw_status joint_couple(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                       int count, joint_system *normal, int moving, bool *found, fw_error *error)
{
    *found = false;
    lead(joint, ends, moving, FREELY);
    const int tangents = joint_make_all_tangents(joint, ends, rows, list, count);
    const int unknowns = normal->line_count + tangents;
    if (unknowns > 0 && unknowns <= UNKNOWNS) {
        const size_t own = couple_room(unknowns);
        int both = 0;
        for (int n = 0; n < normal->line_count; ++n) both += joint->lines[n].both;
        FW_TRY(joint_reserve_room(joint, own + joint_pivot_room(normal->line_count, both, unknowns),
                                  error));
        couple p = couple_open(normal->line_count, unknowns, joint->room);
        joint_want(joint, ends, rows, list, count);
        fill(&p, joint, ends, rows, list, count);
        *found = couple_find_part(&p, &joint->part, joint->room + own);
        if (*found) take_solution(&p, joint, rows, list, count);
        if (*found) {
            joint_add_up(normal);
            joint_share_out(joint, ends, rows, list, count, moving);
            /* What slides is at its limit, whatever rounding says. */
            for (int k = 0; k < count; ++k)
                if (joint->tangent_of[k] >= 0)
                    rows[list[k]].rub.stuck = p.state[p.normals + joint->tangent_of[k]] == STICKS;
        }
    }
    lead(joint, ends, moving, *found ? FORCED : AS_BEFORE);
    return FW_OK;
}
