/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint.c - contact of many particles: island after island, the fixed point of displacements and
 * midpoint normals. State: memory only. Start reading at fw_joint_solve(). */
#include "contact/constraint/joint.h"

#include "joint_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Rows that are solved one by one as a set of active ones; more of them as a band. */
enum { FEW = 30, FEW_ON_PISTONS = 6 };
/* Of the fixed point of weights; in each of them, of normal forces and friction. */
enum { ROUNDS = 100, TURNS = 3 };
/* Rounds of turns before both are found at once; and how often that may fail. */
enum { PATIENCE = 12, FAILURES = 2 };
/* Rounds of exact normal forces where ends follow others. */
enum { SETTLINGS = 20 };
/* Where the furthest end moves no further than by this, in units of length, the fixed point is
 * there: rounding of displacements of a spacing. Or no further than NEARLY, if gaps are kept. */
#define ARRIVED 1e-13
#define NEARLY  1e-8
/* Where ends follow others, what is left costs energy and momentum, not gap alone. */
#define LED 1e-15
/* Friction that misses its law by less, as a part of forces and of motions, has settled; and where
 * it is found in turn with more normal forces: how rows of both faces for the same place share what
 * they bear is nearly free, and is found last. */
#define MISFIT         1e-9
#define MISFIT_OF_MANY 1e-4
/* So often forces are found anew before rows whose friction gives energy lose it; and in all. */
enum { POLISHINGS = 3, BARRINGS = 8 };
/* Between these lies the part of a change that is taken. */
#define PART_MIN 0.1
#define PART_MAX 1.5

int fw_joint_end_count(const fw_joint_row *row)
{
    switch (row->kind) {
    case FW_JOINT_PLANE:
    case FW_JOINT_ROUND:
        return row->borne ? 2 : 1;
    case FW_JOINT_POINT:
    case FW_JOINT_SPRING:
        return 2;
    case FW_JOINT_SEGMENT:
        return 3;
    }
    assert(false);
    return 0;
}

double fw_joint_motion(const fw_joint_row *row, const fw_joint_end *ends)
{
    double sum = 0;
    for (int k = 0; k < fw_joint_end_count(row); ++k)
        sum += fw_vec2_dot(row->weight[k], ends[row->end[k]].displacement);
    return sum;
}

/* bound - G (w_p + what friction adds to it) */
static double wanted_of(const fw_joint_end *ends, const fw_joint_row *row)
{
    double wanted = row->bound;
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &ends[row->end[k]];
        wanted -= fw_vec2_dot(row->weight[k], fw_vec2_add(end->free, end->rubbed));
    }
    return wanted;
}

/* Ends of the island that are wide, or are not, in the order in which its rows name them. Returns
 * how many are found, with those that there are. */
static int list_ends(fw_joint *joint, fw_joint_end *ends, const fw_joint_row *rows, const int *list,
                     int count, bool wide, int found)
{
    for (int n = 0; n < count; ++n)
        for (int k = 0; k < fw_joint_end_count(&rows[list[n]]); ++k) {
            const int end = rows[list[n]].end[k];
            if (joint->local[end] >= 0 || !joint_moves(&ends[end]) || ends[end].wide != wide)
                continue;
            joint->local[end] = found;
            joint->w[found] = ends[end].displacement;
            ends[end].rubbed = (fw_vec2){0, 0};
            joint->global[found++] = end;
        }
    return found;
}

/* Those that can move, wide ones last; and one more for each spring. Returns the first number. */
static int number_ends(fw_joint *joint, fw_joint_end *ends, const fw_joint_row *rows,
                       const int *list, int count, joint_system *system)
{
    system->first_wide = list_ends(joint, ends, rows, list, count, false, 0);
    const int moving = list_ends(joint, ends, rows, list, count, true, system->first_wide);
    system->wide_count = moving - system->first_wide;
    system->end_count = moving;
    for (int n = 0; n < count; ++n) system->end_count += rows[list[n]].kind == FW_JOINT_SPRING;
    return moving;
}

static fw_status solve_system(fw_joint *joint, joint_system *system, bool *solved, fw_error *error)
{
    const size_t room = joint_nearest_room(system->line_count, system->end_count);
    *solved = false;
    if (system->line_count > (system->wide_count > 0 ? FEW_ON_PISTONS : FEW)) {
        const int bandwidth = joint_bandwidth(system, joint->first);
        FW_TRY(joint_reserve_room(
            joint, joint_interior_room(system->line_count, bandwidth, system->wide_count), error));
        *solved = joint_solve_interior(system, bandwidth, joint->room);
        if (*solved) return FW_OK;
    }
    FW_TRY(joint_reserve_room(joint, room, error));
    *solved = joint_solve_nearest(system, joint->room);
    return FW_OK;
}

/* Moves from w to what the weights there give. Returns how far the furthest end goes. */
static double follow(fw_joint *joint, fw_joint_end *ends, const joint_system *system, int moving)
{
    double furthest = 0;
    for (int e = 0; e < moving; ++e) {
        fw_joint_end *end = &ends[joint->global[e]];
        end->displacement = fw_vec2_add(fw_vec2_add(end->free, end->rubbed),
                                        joint_apply(joint_root_of(end->mobility), system->z[e]));
        const fw_vec2 change = fw_vec2_subtract(end->displacement, joint->w[e]);
        furthest = fmax(furthest, fabs(change.x) + fabs(change.y));
    }
    return furthest;
}

/* How much of a change is taken (Aitken's extrapolation, as Irons and Tuck do it for vectors, 1969:
 * changes that alternate are damped, changes that creep are stretched). */
static double next_part(const fw_joint *joint, const fw_joint_end *ends, int end_count, double part)
{
    double along = 0, squared = 0;
    for (int e = 0; e < end_count; ++e) {
        const fw_vec2 change = fw_vec2_subtract(ends[joint->global[e]].displacement, joint->w[e]);
        const fw_vec2 turn = fw_vec2_subtract(change, joint->change[e]);
        along += fw_vec2_dot(joint->change[e], turn);
        squared += fw_vec2_dot(turn, turn);
    }
    return squared > 0 ? fmin(fmax(-part * along / squared, PART_MIN), PART_MAX) : part;
}

static void relax(fw_joint *joint, const fw_joint_end *ends, int end_count,
                  const fw_joint_springs *springs, double part)
{
    for (int e = 0; e < end_count; ++e) {
        const int end = joint->global[e];
        const double softening = springs ? springs->softening(springs->context, end) : 0;
        joint->change[e] = fw_vec2_subtract(ends[end].displacement, joint->w[e]);
        joint->w[e] =
            fw_vec2_add(joint->w[e], fw_vec2_scale(part / (1 + softening), joint->change[e]));
    }
}

static bool depends_on_displacement(const fw_joint_row *rows, const int *list, int count,
                                    const fw_joint_springs *springs)
{
    for (int n = 0; n < count; ++n)
        if (rows[list[n]].kind != FW_JOINT_PLANE) return true;
    return springs != NULL;
}

/* A spring yields, as if it moved an end of its own with a mobility of 1/slope. */
static void add_slack(const fw_joint_row *row, int end, joint_line *line)
{
    line->end[line->count] = end;
    line->c[line->count++] = (fw_vec2){sqrt(row->compliance), 0};
    line->length = sqrt(line->length * line->length + row->compliance);
}

/* Lines of the island for the present w, with weights of their own or as they stand; lambda of its
 * rows is where the solver begins. */
static void make_system(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows, const int *list,
                        int count, int moving, bool weighs, joint_system *system)
{
    const fw_joint_springs *springs = joint->springs;
    int slack = moving;
    for (int e = 0; e < moving; ++e) {
        fw_joint_end *end = &ends[joint->global[e]];
        if (springs)
            end->free = springs->free(springs->context, joint->global[e], joint->w[e]);
        else if (end->lead_count > 0)
            end->free = end->unled;
        if (end->lead_count > 0) end->free = fw_vec2_add(end->free, joint_led_by(joint, ends, end));
    }
    if (weighs) joint_weigh_tangents(joint, ends, rows, list, count);
    system->line_count = 0;
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        if (weighs) joint_weigh(joint, ends, row, list[n]);
        joint_line *line = &joint->lines[system->line_count];
        joint->line_of[n] = -1;
        if (row->open || !joint_make_line(joint, ends, row, row->weight, line)) continue;
        if (row->kind == FW_JOINT_SPRING) add_slack(row, slack++, line);
        line->wanted = wanted_of(ends, row);
        line->both = row->both;
        joint->line_of[n] = system->line_count;
        joint->lambda[system->line_count++] = row->lambda;
    }
}

/* Weights at w itself say what becomes of each gap: is none passed by more than rounding? Then it
 * does not matter that ends still move along the tangent. */
static bool keeps_gaps(fw_joint *joint, const fw_joint_end *ends, int end_count, fw_joint_row *rows,
                       const int *list, int count)
{
    bool keeps = true;
    for (int e = 0; e < end_count; ++e) {
        joint->z[e] = joint->w[e];
        joint->w[e] = ends[joint->global[e]].displacement;
    }
    for (int n = 0; n < count && keeps; ++n) {
        fw_joint_row there = rows[list[n]];
        joint_weigh(joint, ends, &there, list[n]);
        const double gap = fw_joint_motion(&there, ends) - there.bound;
        keeps = there.open || (gap >= -ARRIVED && (!there.both || gap <= ARRIVED));
    }
    for (int e = 0; e < end_count; ++e) joint->w[e] = joint->z[e];
    return keeps;
}

static double residual_of(const fw_joint_end *ends, const fw_joint_row *rows, const int *list,
                          int count)
{
    double sum = 0;
    for (int n = 0; n < count; ++n) {
        const fw_joint_row *row = &rows[list[n]];
        if (row->lambda != 0 && row->kind != FW_JOINT_SPRING)
            sum += row->lambda * (fw_joint_motion(row, ends) - row->bound);
    }
    return fabs(sum);
}

static void store_lambda(const fw_joint *joint, fw_joint_row *rows, const int *list, int count)
{
    for (int n = 0; n < count; ++n)
        rows[list[n]].lambda = joint->line_of[n] < 0 ? 0 : joint->lambda[joint->line_of[n]];
}

void joint_want(fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *rows,
                const int *list, int count)
{
    for (int n = 0; n < count; ++n)
        if (joint->line_of[n] >= 0)
            joint->lines[joint->line_of[n]].wanted = wanted_of(ends, &rows[list[n]]);
}

/* Normal forces for the present weights, and friction with them: at once, where that has not failed
 * too often, or else in turn; then normal forces come last, so that nothing passes. */
static fw_status solve_forces(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows,
                              const int *list, int count, int moving, joint_system *system,
                              int *failures, bool *solved, double *change, fw_error *error)
{
    const bool rubs = joint_rubs(rows, list, count);
    bool found = false;
    if (rubs && *failures < FAILURES) {
        for (int e = 0; e < moving; ++e) ends[joint->global[e]].rubbed = (fw_vec2){0, 0};
        FW_TRY(joint_couple(joint, ends, rows, list, count, system, moving, &found, error));
        *failures += !found;
        if (!found) joint_want(joint, ends, rows, list, count);
    }
    const int turns = rubs && !found ? TURNS : 0;
    for (int turn = 0; turn < turns; ++turn) {
        FW_TRY(solve_system(joint, system, solved, error));
        store_lambda(joint, rows, list, count);
        FW_TRY(joint_rub(joint, ends, rows, list, count, system, moving, error));
        joint_want(joint, ends, rows, list, count);
    }
    if (!found) FW_TRY(solve_system(joint, system, solved, error));
    joint->coupled = found;
    store_lambda(joint, rows, list, count);
    *change = follow(joint, ends, system, moving);
    return FW_OK;
}

/* Where ends follow others and turns did not lead to a fixed point: exact normal forces for weights
 * that follow. What does not settle costs gaps and cones; change is 0 then. */
static fw_status settle_island(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows,
                               const int *list, int count, int moving, joint_system *system,
                               bool *arrived, double *change, bool *solved, fw_error *error)
{
    double part = 1;
    for (int round = 0; round < SETTLINGS && !*arrived; ++round) {
        bool settled;
        if (round == 0)
            for (int e = 0; e < moving; ++e) joint->w[e] = ends[joint->global[e]].displacement;
        if (round > 1) part = next_part(joint, ends, moving, part);
        if (round > 0) relax(joint, ends, moving, joint->springs, part);
        make_system(joint, ends, rows, list, count, moving, true, system);
        FW_TRY(joint_settle(joint, ends, rows, list, count, moving, &settled, change, error));
        if (!isfinite(*change)) return FW_OK;
        *solved = true;
        *arrived = settled && *change <= ARRIVED;
    }
    joint_find_slips(ends, rows, list, count);
    *change = 0;
    return FW_OK;
}

static fw_status solve_island(fw_joint *joint, fw_joint_end *ends, fw_joint_row *rows,
                              const int *list, int count, fw_joint_outcome *outcome,
                              fw_error *error)
{
    const fw_joint_springs *springs = joint->springs;
    joint_system system = {.lines = joint->lines, .lambda = joint->lambda, .z = joint->z};
    const int moving = number_ends(joint, ends, rows, list, count, &system);
    const bool follows = joint_follows(joint, ends, moving);
    const bool rubs = joint_rubs(rows, list, count);
    const bool iterates = follows || depends_on_displacement(rows, list, count, springs);
    double change = INFINITY, part = 1;
    bool arrived = false, solved = true;
    int failures = follows ? 0 : FAILURES;
    const bool few = joint_is_few(rows, list, count);
    const double misfit = few ? MISFIT : MISFIT_OF_MANY;
    int changed = 0; /* the round after which a row last changed its law */
    for (int round = 0; round < changed + ROUNDS && !arrived && solved; ++round) {
        if (round == changed + PATIENCE) {
            failures = few ? 0 : FAILURES - 1;
            joint_hold_beside_firm(rows, list, count);
        }
        if (round == changed + 2 * PATIENCE && !few) failures = FAILURES;
        if (round > 1)
            part = round == changed + PATIENCE ? 1 : next_part(joint, ends, moving, part);
        if (round > 0) relax(joint, ends, moving, springs, part);
        make_system(joint, ends, rows, list, count, moving, true, &system);
        const double before = change;
        FW_TRY(solve_forces(joint, ends, rows, list, count, moving, &system, &failures, &solved,
                            &change, error));
        outcome->iterations += 1;
        const bool led = follows && !joint->coupled;
        arrived = !iterates || change <= (led ? LED : ARRIVED) ||
                  (led && change <= ARRIVED && change >= before) ||
                  (change <= NEARLY && !springs && !led &&
                   keeps_gaps(joint, ends, moving, rows, list, count));
        if (rubs && arrived)
            arrived = joint_friction_misfit(joint, ends, rows, list, count) <= misfit;
        if (arrived && (joint_break_loose(ends, rows, list, count) ||
                        joint_bar_feeding(ends, rows, list, count))) {
            arrived = false;
            changed = round + 1;
        }
    }
    if (follows && !arrived) {
        FW_TRY(settle_island(joint, ends, rows, list, count, moving, &system, &arrived, &change,
                             &solved, error));
        if (rubs && arrived)
            arrived = joint_friction_misfit(joint, ends, rows, list, count) <= misfit;
    }
    /* With the weights as they stand: gaps stay inexact, energy and momentum are kept. */
    for (int round = 0;
         follows && !joint->coupled && !arrived && solved && round < ROUNDS && change > LED;
         ++round) {
        part = next_part(joint, ends, moving, part);
        relax(joint, ends, moving, springs, part);
        make_system(joint, ends, rows, list, count, moving, false, &system);
        FW_TRY(solve_forces(joint, ends, rows, list, count, moving, &system, &failures, &solved,
                            &change, error));
    }
    /* Turns leave slips of what sticks that are small, and yet not rounding: at once there are
     * none. Where friction feeds all the same, that has not settled: rows lose theirs. */
    for (int round = 0; rubs && round < BARRINGS && joint_feeds(ends, rows, list, count); ++round) {
        if (round >= POLISHINGS) joint_bar_all_that_feed(ends, rows, list, count);
        failures = 0;
        make_system(joint, ends, rows, list, count, moving, false, &system);
        FW_TRY(solve_forces(joint, ends, rows, list, count, moving, &system, &failures, &solved,
                            &change, error));
        bool settled;
        if (follows && !joint->coupled)
            FW_TRY(joint_settle(joint, ends, rows, list, count, moving, &settled, &change, error));
    }
    joint_stick_what_rests(ends, rows, list, count);
    joint_rub_driven(joint, ends, rows, list, count);
    outcome->islands += 1;
    outcome->unconverged += !arrived || !solved || joint_any_barred(rows, list, count);
    if (iterates) outcome->change = fmax(outcome->change, change);
    outcome->residual = fmax(outcome->residual, residual_of(ends, rows, list, count));
    for (int e = 0; e < moving; ++e) joint->local[joint->global[e]] = -1;
    for (int n = 0; n < count; ++n) rows[list[n]].fresh = false;
    return FW_OK;
}

fw_status fw_joint_solve(fw_joint *joint, fw_joint_end *ends, int end_count, fw_joint_row *rows,
                         int row_count, const fw_joint_springs *springs, fw_joint_outcome *outcome,
                         fw_error *error)
{
    *outcome = (fw_joint_outcome){0};
    joint->springs = springs;
    FW_TRY(joint_reserve(joint, end_count, row_count, error));
    FW_TRY(joint_islands_begin(&joint->islands, ends, end_count, rows, row_count, error));
    for (int e = 0; e < end_count; ++e) {
        joint->local[e] = -1;
        if (!joint_moves(&ends[e])) ends[e].displacement = ends[e].free;
    }
    int first = 0, count;
    for (;;) {
        const int *list =
            joint_islands_next(&joint->islands, ends, rows, row_count, &first, &count);
        if (!list) break;
        FW_TRY(solve_island(joint, ends, rows, list, count, outcome, error));
    }
    joint_move_followers(joint, ends, end_count, rows, row_count);
    for (int e = 0; e < end_count; ++e) ends[e].force = (fw_vec2){0, 0};
    for (int n = 0; n < row_count; ++n)
        for (int k = 0; rows[n].lambda != 0 && k < fw_joint_end_count(&rows[n]); ++k) {
            fw_vec2 *force = &ends[rows[n].end[k]].force;
            *force = fw_vec2_add(*force, fw_vec2_scale(rows[n].lambda, rows[n].weight[k]));
        }
    for (int n = 0; n < row_count; ++n)
        for (int k = 0; rows[n].rub.traction != 0 && k < fw_joint_end_count(&rows[n]); ++k) {
            fw_vec2 *force = &ends[rows[n].end[k]].force;
            *force =
                fw_vec2_add(*force, fw_vec2_scale(rows[n].rub.traction, rows[n].rub.weight[k]));
        }
    return FW_OK;
}
