/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile.c - sums over particles, bin by bin.
 * State: the sums, and the history of bonds. Invariant: particles are added in ascending order, so
 * that a sum does not depend on threads. Start reading at fw_profile_follow(). */
#include "experiments/measures/profile.h"

#include "core/particles/particles.h"
#include "profile_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- where --- */

static double across_of(const fw_profile *p, const fw_solid *solid, int i)
{
    return p->plan.axis == 0 ? solid->x[i] : solid->y[i];
}

static bool window_holds(const fw_profile *p, double along)
{
    return along >= p->window_low && along <= p->window_high;
}

static bool in_window(const fw_profile *p, const fw_solid *solid, int i)
{
    return window_holds(p, p->plan.axis == 0 ? solid->y[i] : solid->x[i]);
}

static int bin_at(const fw_profile *p, double place)
{
    const double number = floor((place - p->plan.middle) / p->plan.bin + .5) - p->first_bin;
    return number >= 0 && number < p->bin_count ? (int)number : -1;
}

/* The sums that a place belongs to, at most two. */
static int rows_at(const fw_profile *p, double place, int rows[2])
{
    int count = 0;
    const int bin = bin_at(p, place);
    const double distance = fabs(place - p->plan.middle);
    if (bin >= 0) rows[count++] = bin;
    if (distance < p->plan.contact)
        rows[count++] = p->bin_count;
    else if (distance > p->plan.far[0] && distance < p->plan.far[1])
        rows[count++] = p->bin_count + 1;
    return count;
}

/* --- one sample --- */

static void add_velocity(fw_flow *flow, const fw_profile *p, int i)
{
    flow->count += 1;
    flow->along += p->plan.axis == 0 ? p->velocity_y[i] : p->velocity_x[i];
    flow->across += p->plan.axis == 0 ? p->velocity_x[i] : p->velocity_y[i];
}

static void add_flow_of(fw_profile *p, const profile_part *part)
{
    for (int i = 0; i < part->solid->count; ++i) {
        int rows[2];
        if (!in_window(p, part->solid, i)) continue;
        const int count = rows_at(p, across_of(p, part->solid, i), rows);
        for (int n = 0; n < count; ++n) {
            add_velocity(&p->flow[rows[n]], p, part->first + i);
            if (!p->held[part->first + i]) add_velocity(&p->free_flow[rows[n]], p, part->first + i);
        }
    }
}

static void add_flow(fw_profile *p)
{
    memset(p->flow, 0, ((size_t)p->bin_count + 2) * sizeof *p->flow);
    memset(p->free_flow, 0, ((size_t)p->bin_count + 2) * sizeof *p->free_flow);
    for (int n = 0; n < p->part_count; ++n) add_flow_of(p, &p->parts[n]);
    for (int row = 0; row < p->bin_count + 2; ++row) {
        const fw_flow *flow = &p->flow[row];
        const double free_count = p->free_flow[row].count;
        if (flow->count > 0) p->sums[row][SUM_DRIFT] += flow->along * flow->along / flow->count;
        if (free_count > 0) p->sums[row][SUM_FREEDOM] += 2 * (free_count - 1);
    }
}

static double order_of(const fw_profile *p, const fw_solid *solid, int i)
{
    int bonds;
    if (!p->flows) return NAN;
    const fw_phase order = fw_particles_bond_order(solid, i, &bonds);
    return sqrt(order.cosine * order.cosine + order.sine * order.sine);
}

static void add_particle(fw_profile *p, const profile_part *part, int i)
{
    int rows[2];
    const int count = rows_at(p, across_of(p, part->solid, i), rows), at = part->first + i;
    if (count == 0) return;
    const double order = order_of(p, part->solid, i);
    const double along = p->plan.axis == 0 ? p->velocity_y[at] : p->velocity_x[at];
    const double across = p->plan.axis == 0 ? p->velocity_x[at] : p->velocity_y[at];
    for (int n = 0; n < count; ++n) {
        double *sums = p->sums[rows[n]];
        sums[SUM_PARTICLES] += 1;
        sums[SUM_RETURN_FORCE] +=
            sqrt(p->force_x[at] * p->force_x[at] + p->force_y[at] * p->force_y[at]);
        if (!isnan(p->bond_force[at])) {
            sums[SUM_BOND_FORCE] += p->bond_force[at];
            sums[SUM_BONDED] += 1;
        }
        sums[SUM_ORDER] += order;
        if (p->held[at]) continue;
        const fw_flow *flow = &p->free_flow[rows[n]];
        const double u = along - flow->along / flow->count, v = across - flow->across / flow->count;
        sums[SUM_HEAT] += p->mass[at] * (u * u + v * v);
    }
}

static void take(fw_profile *p, const fw_experiment *experiment)
{
    profile_look(p, experiment);
    add_flow(p);
    for (int n = 0; n < p->part_count; ++n)
        for (int i = 0; i < p->parts[n].solid->count; ++i)
            if (in_window(p, p->parts[n].solid, i)) add_particle(p, &p->parts[n], i);
    p->samples += 1;
}

/* Beside the samples: of this instant. */
double fw_profile_contact_now(fw_profile *p)
{
    double sum = 0;
    int count = 0;
    profile_fill_forces(p);
    for (int n = 0; n < p->part_count; ++n)
        for (int i = 0; i < p->parts[n].solid->count; ++i) {
            const fw_solid *solid = p->parts[n].solid;
            const double *x = p->force_x + p->parts[n].first, *y = p->force_y + p->parts[n].first;
            if (!in_window(p, solid, i)) continue;
            if (!(fabs(across_of(p, solid, i) - p->plan.middle) < p->plan.contact)) continue;
            sum += sqrt(x[i] * x[i] + y[i] * y[i]);
            count += 1;
        }
    return count > 0 ? sum / count : NAN;
}

/* --- from look to look --- */

static void add_broken(fw_profile *p, const fw_solid *solid)
{
    for (int i = 0; i < solid->count; ++i) {
        int rows[2];
        if (!in_window(p, solid, i)) continue;
        const int count = rows_at(p, across_of(p, solid, i), rows);
        for (int n = 0; n < count; ++n) {
            p->sums[rows[n]][SUM_BROKEN] += p->history->broken[i];
            p->sums[rows[n]][SUM_LOOKS] += 1;
        }
    }
}

/* Motion since a snapshot belongs where the particle was then. */
static void add_motion(fw_profile *p, const fw_solid *solid, int snapshot, bool late)
{
    const fw_bond_history *h = p->history;
    const size_t first = (size_t)snapshot * (size_t)h->count;
    const double *x = h->past_x + first, *y = h->past_y + first;
    for (int i = 0; i < solid->count; ++i) {
        int rows[2];
        if (!window_holds(p, p->plan.axis == 0 ? y[i] : x[i])) continue;
        const int count = rows_at(p, p->plan.axis == 0 ? x[i] : y[i], rows);
        if (count == 0) continue;
        const fw_bond_change change = fw_bond_history_change(h, solid, snapshot, i);
        for (int n = 0; n < count; ++n) {
            double *sums = p->sums[rows[n]];
            sums[SUM_CHANGE] += late ? 0 : change.square;
            sums[late ? SUM_ACROSS_LATE : SUM_ACROSS] += change.along[p->plan.axis];
            sums[late ? SUM_CHANGED_LATE : SUM_CHANGED] += change.bonds;
        }
    }
}

static void follow_bonds(fw_profile *p, const fw_solid *solid, int64_t step)
{
    if (fw_bond_history_look(p->history, solid, step)) add_broken(p, solid);
    const int last = fw_bond_history_snapshot(p->history, step, 1);
    const int oldest = fw_bond_history_snapshot(p->history, step, FW_HISTORY_LAGS);
    if (last >= 0) add_motion(p, solid, last, false);
    if (oldest >= 0) add_motion(p, solid, oldest, true);
    fw_bond_history_remember(p->history, solid, step);
}

void fw_profile_follow(fw_profile *profile, const fw_experiment *experiment, int64_t step)
{
    const fw_scenario_profile *plan = &profile->plan;
    if (step < plan->from || step > plan->until) return;
    if (step > plan->from && (step - plan->from) % plan->every == 0) take(profile, experiment);
    if (!profile->flows && (step + 1 - plan->from) % plan->every == 0)
        profile_remember_places(profile);
    if (profile->flows) follow_bonds(profile, profile->parts[0].solid, step);
}

/* --- life --- */

static bool allocate(fw_profile *p)
{
    const size_t count = (size_t)p->particle_count, rows = (size_t)p->bin_count + 2;
    double **const parts[] = {&p->force_x,    &p->force_y,    &p->bond_force,
                              &p->velocity_x, &p->velocity_y, &p->mass};
    const size_t part_count = sizeof parts / sizeof parts[0];
    p->sums = fw_array_allocate(rows, sizeof *p->sums);
    p->flow = fw_array_allocate(rows, sizeof *p->flow);
    p->free_flow = fw_array_allocate(rows, sizeof *p->free_flow);
    p->held = fw_array_allocate(count, sizeof *p->held);
    p->scratch = fw_array_of_doubles(part_count * count);
    for (size_t n = 0; p->scratch && n < part_count; ++n) *parts[n] = p->scratch + n * count;
    return p->sums && p->flow && p->free_flow && p->held && p->scratch;
}

static fw_status refuse_empty(const fw_profile *p, const fw_scenario *scenario, fw_error *error)
{
    int window = 0, contact = 0, far = 0;
    for (int n = 0; n < p->part_count; ++n)
        for (int i = 0; i < p->parts[n].solid->count; ++i) {
            if (!in_window(p, p->parts[n].solid, i)) continue;
            const double distance = fabs(across_of(p, p->parts[n].solid, i) - p->plan.middle);
            window += 1;
            contact += distance < p->plan.contact;
            far += distance > p->plan.far[0] && distance < p->plan.far[1];
        }
    const fw_place place = p->plan.place;
    const char *axis = p->plan.axis == 0 ? "x" : "y", *other = p->plan.axis == 0 ? "y" : "x";
    if (window == 0)
        return fw_scenario_fail(scenario, place, error,
                                "the profile has no particles: none lies at %g <= %s <= %g",
                                p->window_low, other, p->window_high);
    if (contact == 0)
        return fw_scenario_fail(scenario, place, error,
                                "the profile has no particles at the contact: none lies within %g "
                                "of %s = %g",
                                p->plan.contact, axis, p->plan.middle);
    if (far == 0)
        return fw_scenario_fail(scenario, place, error,
                                "the profile has no particles far from the contact: none lies %g "
                                "to %g from %s = %g",
                                p->plan.far[0], p->plan.far[1], axis, p->plan.middle);
    return FW_OK;
}

/* The longest of all materials that have one; 1 where none has. */
static double time_unit(const fw_scenario *scenario)
{
    double unit = 0;
    for (int m = 0; m < scenario->material_count; ++m)
        unit = fmax(unit, fw_material_time_unit(&scenario->materials[m]));
    return unit > 0 ? unit : 1;
}

/* Where particles are: across the bins, and along them. */
static void find_extent(const fw_profile *p, fw_vec2 *across, fw_vec2 *along)
{
    *across = *along = (fw_vec2){INFINITY, -INFINITY};
    for (int n = 0; n < p->part_count; ++n) {
        const fw_solid *solid = p->parts[n].solid;
        for (int i = 0; i < solid->count; ++i) {
            const double there = p->plan.axis == 0 ? solid->y[i] : solid->x[i];
            const double here = across_of(p, solid, i);
            *across = (fw_vec2){fmin(across->x, here), fmax(across->y, here)};
            *along = (fw_vec2){fmin(along->x, there), fmax(along->y, there)};
        }
    }
}

static fw_status build(fw_profile *p, const fw_scenario *scenario, const fw_experiment *experiment,
                       fw_error *error)
{
    enum { BINS_MAX = 100000 };
    fw_vec2 across, along;
    p->plan = scenario->profile;
    FW_TRY(profile_list_parts(p, experiment, error));
    find_extent(p, &across, &along);
    const bool all = p->plan.window[0] == p->plan.window[1];
    p->window_low = all ? along.x : p->plan.window[0];
    p->window_high = all ? along.y : p->plan.window[1];
    const double low = across.x, high = across.y;
    const double first = floor((low - p->plan.middle) / p->plan.bin + .5);
    const double last = floor((high - p->plan.middle) / p->plan.bin + .5);
    FW_TRY(refuse_empty(p, scenario, error));
    if (last - first >= BINS_MAX || fabs(first) > 1e9)
        return fw_scenario_fail(scenario, p->plan.place, error,
                                "profile.bin is %g, which makes %.0f bins, expected at most %d",
                                p->plan.bin, last - first + 1, BINS_MAX);
    p->first_bin = (int)first;
    p->bin_count = (int)(last - first) + 1;
    if (!allocate(p)) return fw_fail_memory(error, "a profile");
    for (int n = 0; n < p->part_count; ++n)
        p->parts[n].solid->model->masses(p->parts[n].solid, p->mass + p->parts[n].first);
    if (!p->flows) return FW_OK;
    return fw_bond_history_create(&p->history, p->parts[0].solid, p->plan.from, p->plan.until,
                                  time_unit(scenario), error);
}

fw_status fw_profile_create(fw_profile **profile, const fw_experiment *experiment, fw_error *error)
{
    *profile = calloc(1, sizeof **profile);
    if (!*profile) return fw_fail_memory(error, "a profile");
    const fw_status status = build(*profile, experiment->scenario, experiment, error);
    if (status == FW_OK) return FW_OK;
    fw_profile_destroy(*profile);
    *profile = NULL;
    return status;
}

void fw_profile_destroy(fw_profile *profile)
{
    if (!profile) return;
    free(profile->sums);
    free(profile->flow);
    free(profile->free_flow);
    free(profile->held);
    free(profile->scratch);
    free(profile->parts);
    free(profile->past_x);
    free(profile->past_y);
    free(profile->numbers);
    free(profile->predictions);
    fw_bond_history_destroy(profile->history);
    free(profile);
}

void fw_profile_state(fw_profile *profile, fw_state_list *list)
{
    fw_state_list_add(list, "sums", FW_F64, ((size_t)profile->bin_count + 2) * SUMS, profile->sums);
    fw_state_list_add(list, "samples", FW_I64, 1, &profile->samples);
    const size_t count = (size_t)profile->particle_count;
    if (profile->past_x) fw_state_list_add(list, "past-x", FW_F64, count, profile->past_x);
    if (profile->past_y) fw_state_list_add(list, "past-y", FW_F64, count, profile->past_y);
    if (profile->history) fw_bond_history_state(profile->history, list);
}

fw_status fw_profile_restored(const fw_profile *profile, fw_error *error)
{
    if (profile->samples < 0)
        return fw_fail(error, FW_BAD_INPUT, "the profile has %lld samples, expected 0 or more",
                       (long long)profile->samples);
    if (profile->history && !fw_bond_history_is_sound(profile->history))
        return fw_fail(error, FW_BAD_INPUT,
                       "the profile follows a bond of a particle that is none of the %d",
                       profile->particle_count);
    return FW_OK;
}
