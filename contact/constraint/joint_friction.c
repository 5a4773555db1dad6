/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_friction.c - Coulomb friction of many particles on segments: for given normal forces the
 * tractions that let each stuck particle move by what sticking lets through, within the cone.
 * State: none but what rows remember. Start reading at joint_rub(). */
#include "contact/constraint/friction_law.h"
#include "joint_parts.h"

#include <math.h>

/* A slip below this part of how far the ends go does not let a particle break loose that has come
 * to its limit. */
#define SLIPS 1e-9
/* What is left of a slip, as a part of how far the ends go, means nothing below this. */
#define ROUNDING 1e-13
/* A row at its limit feeds only beyond this part: it moves by the rounding of all that stick, too.
 */
#define FEEDS 1e-12
/* What sticking still lets through is left out below this part of how far loads would take a
 * particle in the step. */
#define STILL 1e-4

bool joint_rubs(const fw_joint_row *rows, const int *list, int count)
{
    for (int n = 0; n < count; ++n)
        if (rows[list[n]].rub.coefficient > 0) return true;
    return false;
}

/* Of end 0, relative to what it rubs on. */
static double along(const fw_joint_row *row, const fw_vec2 displacement[3])
{
    double sum = -row->rub.drift;
    for (int k = 0; k < fw_joint_end_count(row); ++k)
        sum += fw_vec2_dot(row->rub.weight[k], displacement[k]);
    return sum;
}

/* The unit vector along the segment, on the point; on the segment's ends by how near they are. */
static void weigh_segment(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 i = joint_middle_of(joint, ends, row, 0),
                  j = joint_middle_of(joint, ends, row, 1),
                  k = joint_middle_of(joint, ends, row, 2);
    const fw_vec2 edge = fw_vec2_subtract(k, j);
    const double squared = fw_vec2_dot(edge, edge);
    const double part = fw_vec2_dot(fw_vec2_subtract(i, j), edge) / squared;
    const fw_vec2 tangent = fw_vec2_scale(1 / sqrt(squared), edge);
    row->rub.weight[0] = tangent;
    row->rub.weight[2] = fw_vec2_scale(-fmin(fmax(part, 0), 1), tangent);
    row->rub.weight[1] = fw_vec2_scale(-1, fw_vec2_add(row->rub.weight[0], row->rub.weight[2]));
}

/* Across the normal of the wall. */
static void weigh_wall(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    joint_weigh(joint, ends, row, 0);
    row->rub.weight[0] = fw_vec2_turn(row->weight[0]);
    row->rub.weight[1] = fw_vec2_scale(-1, row->rub.weight[0]);
    row->rub.drift = row->borne ? 0 : fw_vec2_dot(row->rub.weight[0], row->motion);
}

void joint_weigh_tangents(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                          const int *list, int count)
{
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        if (!(row->rub.coefficient > 0)) continue;
        if (row->kind == FW_JOINT_SEGMENT)
            weigh_segment(joint, ends, row);
        else
            weigh_wall(joint, ends, row);
    }
}

/* Displacements of the ends without friction, and by momentum alone. Without z also without normal
 * forces. */
static void collect(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                    const fw_vec2 *z, fw_vec2 smooth[3], fw_vec2 inertial[3])
{
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &ends[row->end[k]];
        smooth[k] = inertial[k] = end->free;
        if (!joint_moves(end)) continue;
        inertial[k] = end->inertial;
        if (!z) continue;
        smooth[k] = fw_vec2_add(
            end->free, joint_apply(joint_root_of(end->mobility), z[joint->local[row->end[k]]]));
    }
}

static void solve_for(fw_joint *joint, joint_system *system, int bandwidth, double part)
{
    for (int n = 0; n < system->line_count; ++n)
        system->lines[n].wanted = part * joint->target[n] - joint->slip[n];
    (void)joint_solve_box(system, joint->limit, bandwidth, joint->room);
    joint->part = part;
}

static double power_of(const fw_joint *joint, const joint_system *system)
{
    double sum = 0;
    for (int n = 0; n < system->line_count; ++n)
        if (fabs(system->lambda[n]) < joint->limit[n]) sum += joint->target[n] * system->lambda[n];
    return sum;
}

/* Stuck particles move as the filter says, all of them by the same part of it: the largest with
 * which their friction takes energy, or leaves it, as a whole. Tractions are linear in that part,
 * and so the power of friction is the part times a linear function of it. */
static void find_tractions(fw_joint *joint, joint_system *system, int bandwidth)
{
    solve_for(joint, system, bandwidth, 1);
    const double whole = power_of(joint, system);
    if (whole <= 0) return;
    solve_for(joint, system, bandwidth, 0);
    const double none = power_of(joint, system);
    if (none >= 0) return;
    /* A little less than where the power is zero, so that rounding does not make it positive. */
    solve_for(joint, system, bandwidth, 0.999 * none / (none - whole));
    if (power_of(joint, system) > 0) solve_for(joint, system, bandwidth, 0);
}

/* Target and slip of a row that rubs; how far it would slip with z, and no friction. */
static void set_tangent(fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row,
                        const fw_vec2 *z, int line)
{
    fw_joint_rub *rub = &row->rub;
    fw_vec2 smooth[3], inertial[3];
    collect(joint, ends, row, z, smooth, inertial);
    rub->inertial = along(row, inertial);
    const double change = rub->stuck_before ? rub->inertial - rub->inertial_before : 0;
    joint->target[line] =
        rub->firm ? 0 : fw_friction_filter(rub->stuck_before, rub->inertial, change);
    joint->slip[line] = along(row, smooth);
}

/* How far a row would slip freely by all but momentum: by loads and what is stretched. */
static double pulled_along(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row)
{
    fw_vec2 free[3], inertial[3];
    collect(joint, ends, row, NULL, free, inertial);
    return along(row, free) - along(row, inertial);
}

/* Friction only takes energy: of what swings about a load, the half that goes with the load is let
 * through, and the other is not. Where it swings by that little, all hold, or the half that passes
 * would add up. */
static void hold_what_swings(fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *rows,
                             const int *list, int count)
{
    double load = 0, target = 0;
    for (int n = 0; n < count; ++n) {
        const int line = joint->tangent_of[n];
        if (line < 0) continue;
        load = fmax(load, fabs(pulled_along(joint, ends, &rows[list[n]])));
        target = fmax(target, fabs(joint->target[line]));
    }
    if (target > STILL * load) return;
    for (int n = 0; n < count; ++n)
        if (joint->tangent_of[n] >= 0) joint->target[joint->tangent_of[n]] = 0;
}

/* The tangents of the island as lines, each with its limit and target. Returns how many. */
static int make_tangents(fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                         const int *list, int count, const fw_vec2 *z)
{
    int lines = 0;
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        fw_joint_rub *rub = &row->rub;
        joint->tangent_of[n] = -1;
        rub->traction = 0;
        rub->stuck = false;
        if (!(rub->coefficient > 0)) continue;
        set_tangent(joint, ends, row, z, lines);
        rub->limit = rub->barred ? 0 : fw_joint_cone(row);
        if (!(rub->limit > 0) ||
            !joint_make_line(joint, ends, row, rub->weight, &joint->tangents[lines]))
            continue;
        joint->limit[lines] = rub->limit;
        joint->tangent_of[n] = lines++;
    }
    hold_what_swings(joint, ends, rows, list, count);
    return lines;
}

int joint_make_all_tangents(fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                            const int *list, int count)
{
    int lines = 0;
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        joint->tangent_of[n] = -1;
        if (!(row->rub.coefficient > 0) || row->rub.barred ||
            !joint_make_line(joint, ends, row, row->rub.weight, &joint->tangents[lines])) {
            row->rub.traction = row->rub.limit = 0;
            row->rub.stuck = false;
            continue;
        }
        set_tangent(joint, ends, row, NULL, lines);
        joint->tangent_of[n] = lines++;
    }
    hold_what_swings(joint, ends, rows, list, count);
    return lines;
}

void joint_share_out(const fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                     int count, int moving)
{
    for (int e = 0; e < moving; ++e) ends[joint->global[e]].rubbed = (fw_vec2){0, 0};
    for (int n = 0; n < count; ++n) {
        if (joint->tangent_of[n] < 0) continue;
        fw_joint_row *row = &rows[list[n]];
        row->rub.traction = joint->traction[joint->tangent_of[n]];
        row->rub.stuck = fabs(row->rub.traction) < row->rub.limit;
        for (int k = 0; k < fw_joint_end_count(row); ++k) {
            fw_joint_end *end = &ends[row->end[k]];
            if (!joint_moves(end)) continue;
            const fw_vec2 force = fw_vec2_scale(row->rub.traction, row->rub.weight[k]);
            end->rubbed = fw_vec2_add(end->rubbed, fw_sym2_apply(end->mobility, force));
        }
    }
}

fw_status joint_rub(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                    int count, const joint_system *normal, int moving, fw_error *error)
{
    joint_system system = {.lines = joint->tangents,
                           .lambda = joint->traction,
                           .end_count = moving,
                           .first_wide = normal->first_wide,
                           .wide_count = normal->wide_count};
    system.line_count = make_tangents(joint, ends, rows, list, count, normal->z);
    joint->part = 1;
    if (system.line_count == 0) {
        joint_share_out(joint, ends, rows, list, count, moving);
        return FW_OK;
    }
    const int bandwidth = joint_bandwidth(&system, joint->first);
    FW_TRY(joint_reserve_room(
        joint, joint_interior_room(system.line_count, bandwidth, system.wide_count), error));
    find_tractions(joint, &system, bandwidth);
    joint_share_out(joint, ends, rows, list, count, moving);
    return FW_OK;
}

static double slip_of(const fw_joint_row *row, const fw_joint_end *ends)
{
    fw_vec2 displacement[3];
    for (int k = 0; k < fw_joint_end_count(row); ++k)
        displacement[k] = ends[row->end[k]].displacement;
    return along(row, displacement);
}

void joint_find_slips(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count)
{
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        if (row->rub.coefficient > 0) row->rub.slip = slip_of(row, ends);
    }
}

/* How far the ends of a row go altogether: what is small beside that is rounding. */
static double size_of(const fw_joint_end *ends, const fw_joint_row *row)
{
    double size = 0;
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_vec2 w = ends[row->end[k]].displacement;
        size += fabs(w.x) + fabs(w.y);
    }
    return size;
}

/* The same with where they would go without forces, which rounding of what forces do is a part of.
 */
static double span_of(const fw_joint_end *ends, const fw_joint_row *row)
{
    double size = size_of(ends, row);
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_vec2 free = ends[row->end[k]].free;
        size += fabs(free.x) + fabs(free.y);
    }
    return size;
}

double joint_friction_misfit(const fw_joint *joint, const fw_joint_end *ends,
                             const fw_joint_row *rows, const int *list, int count)
{
    double widest = 0, furthest = 0, force = 0, slip = 0;
    for (int n = 0; n < count; ++n) {
        const fw_joint_row *row = &rows[list[n]];
        if (!(row->rub.coefficient > 0)) continue;
        widest = fmax(widest, fw_joint_cone(row));
        furthest = fmax(furthest, span_of(ends, row));
    }
    for (int n = 0; n < count; ++n) {
        const fw_joint_row *row = &rows[list[n]];
        const fw_joint_rub *rub = &row->rub;
        if (!(rub->coefficient > 0) || rub->barred || joint->tangent_of[n] < 0) continue;
        const double cone = fw_joint_cone(row), traction = rub->traction;
        const double off = slip_of(row, ends) - joint->part * joint->target[joint->tangent_of[n]];
        force = fmax(force, rub->stuck ? fabs(traction) - cone : fabs(fabs(traction) - cone));
        if (rub->stuck || traction * off > 0) slip = fmax(slip, fabs(off));
    }
    return fmax(widest > 0 ? force / widest : 0, furthest > 0 ? slip / furthest : 0);
}

bool joint_break_loose(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count)
{
    bool any = false;
    joint_find_slips(ends, rows, list, count);
    for (int n = 0; n < count; ++n) {
        fw_joint_rub *rub = &rows[list[n]].rub;
        if (rub->slides || !(rub->at_rest > rub->coefficient) || rub->stuck || rub->barred ||
            !(rub->limit > 0) ||
            -rub->traction * rub->slip <= SLIPS * rub->limit * size_of(ends, &rows[list[n]]))
            continue;
        rub->slides = any = true;
    }
    return any;
}

/* Of what slides; for all that stick together see find_tractions(). What is left of a slip by
 * rounding means nothing: where all ends rest, they would go far without forces. */
bool joint_bar_feeding(const fw_joint_end *ends, fw_joint_row *rows, const int *list, int count)
{
    bool any = false;
    joint_find_slips(ends, rows, list, count);
    for (int n = 0; n < count; ++n) {
        fw_joint_rub *rub = &rows[list[n]].rub;
        if (!(rub->coefficient > 0) || rub->stuck) continue;
        if (rub->traction * rub->slip <=
            FEEDS * fabs(rub->traction) * span_of(ends, &rows[list[n]]))
            continue;
        if (rub->firm)
            rub->barred = true;
        else
            rub->firm = true;
        any = true;
    }
    return any;
}

void joint_hold_beside_firm(fw_joint_row *rows, const int *list, int count)
{
    bool any = false;
    for (int n = 0; n < count; ++n) any |= rows[list[n]].rub.firm;
    for (int n = 0; n < count; ++n) rows[list[n]].rub.firm |= any;
}

/* Where something else holds a particle along the face no law says what friction bears: at its
 * limit or not, what has no slip has not broken loose. */
void joint_stick_what_rests(const fw_joint_end *ends, fw_joint_row *rows, const int *list,
                            int count)
{
    joint_find_slips(ends, rows, list, count);
    for (int n = 0; n < count; ++n) {
        fw_joint_rub *rub = &rows[list[n]].rub;
        if (!(rub->coefficient > 0) || rub->barred || !(rub->limit > 0)) continue;
        rub->stuck |= fabs(rub->slip) <= ROUNDING * span_of(ends, &rows[list[n]]);
    }
}

/* Traction times slip. */
static double power_of_row(const fw_joint_end *ends, const fw_joint_row *row)
{
    return row->rub.coefficient > 0 ? row->rub.traction * slip_of(row, ends) : 0;
}

/* What that may be by rounding alone. */
static double rounding_of_row(const fw_joint_end *ends, const fw_joint_row *row)
{
    return ROUNDING * fabs(row->rub.traction) * span_of(ends, row);
}

bool joint_feeds(const fw_joint_end *ends, const fw_joint_row *rows, const int *list, int count)
{
    double power = 0, rounding = 0;
    for (int n = 0; n < count; ++n) {
        power += power_of_row(ends, &rows[list[n]]);
        rounding += rounding_of_row(ends, &rows[list[n]]);
    }
    return power > rounding;
}

void joint_bar_all_that_feed(const fw_joint_end *ends, fw_joint_row *rows, const int *list,
                             int count)
{
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        row->rub.barred |= power_of_row(ends, row) > rounding_of_row(ends, row);
    }
}

bool joint_any_barred(const fw_joint_row *rows, const int *list, int count)
{
    for (int n = 0; n < count; ++n)
        if (rows[list[n]].rub.barred) return true;
    return false;
}
