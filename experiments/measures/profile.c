/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile.c - sums over particles, bin by bin.
 * State: the sums, and places and bonds at the last sample. Invariant: particles are added in
 * ascending order, so that a sum does not depend on threads. Start reading at fw_profile_follow().
 */
#include "experiments/measures/profile.h"

#include "core/particles/particles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const fw_profile_column_row fw_profile_columns[FW_PROFILE_COLUMNS] = {
    [FW_PROFILE_RETURN_FORCE] = {"return-force", "force",
                                 "mean length of a particle's net return force (Eqs 24, 25)"},
    [FW_PROFILE_BOND_FORCE] = {"bond-return-force", "force",
                               "mean length of the return force of a single bond"},
    [FW_PROFILE_ORDER] = {"order", "1", "mean of |psi_n| over particles"},
    [FW_PROFILE_DENSITY] = {"density", "1/length^2", "particles per area"},
    [FW_PROFILE_TEMPERATURE] = {"temperature", "energy",
                                "m v^2/2 relative to the mean of the bin in each sample"},
    [FW_PROFILE_DRIFT] = {"drift-velocity", "length/time",
                          "root mean square over samples of the bin's mean velocity along the bin"},
    [FW_PROFILE_EXCHANGES] = {"bond-exchanges", "1/time",
                              "bonds lost per particle and time: closer than the bond radius in "
                              "one sample, 1.2 times further in the next"},
    [FW_PROFILE_MOBILITY] = {"relative-displacement", "length^2",
                             "mean square change of a bond's vector between two samples"},
};

/* A bond is lost when it is so many bond radii long; what trembles at the radius itself is not. */
#define LOST 1.2

enum { BONDS_MAX = 12 };

/* What is summed. Pairs of a sum and what it is divided by. */
typedef enum fw_sum {
    SUM_PARTICLES,
    SUM_RETURN_FORCE,
    SUM_BOND_FORCE,
    SUM_BONDED, /* particles with bonds in their own body */
    SUM_ORDER,
    SUM_HEAT,    /* m (v - mean)^2 */
    SUM_FREEDOM, /* degrees of freedom that it belongs to */
    SUM_DRIFT,   /* particles times square of the mean velocity */
    SUM_LOST,
    SUM_FOLLOWED, /* particles with a sample before */
    SUM_CHANGE,
    SUM_CHANGED, /* bonds that were followed */
    SUMS
} fw_sum;

/* Velocities of a bin in one sample. */
typedef struct fw_flow {
    double count, along, across;
} fw_flow;

struct fw_profile {
    fw_scenario_profile plan;
    double window_low, window_high, time_step;
    int particle_count, bin_count, first_bin; /* bin b is centred on middle + (first + b) width */
    double (*sums)[SUMS];                     /* bins, contact, far */
    fw_flow *flow;
    double *force_x, *force_y, *bond_force, *velocity_x, *velocity_y, *mass; /* scratch */
    int64_t samples, followed; /* followed: places and bonds of the last sample are known */
    double *last_x, *last_y;
    int32_t (*last_bonds)[BONDS_MAX]; /* ascending, ended by -1 */
};

/* --- where --- */

static double across_of(const fw_profile *p, const fw_solid *solid, int i)
{
    return p->plan.axis == 0 ? solid->x[i] : solid->y[i];
}

static bool in_window(const fw_profile *p, const fw_solid *solid, int i)
{
    const double along = p->plan.axis == 0 ? solid->y[i] : solid->x[i];
    return along >= p->window_low && along <= p->window_high;
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

static void add_flow(fw_profile *p, const fw_solid *solid)
{
    memset(p->flow, 0, ((size_t)p->bin_count + 2) * sizeof *p->flow);
    solid->model->velocities(solid, p->velocity_x, p->velocity_y);
    for (int i = 0; i < solid->count; ++i) {
        int rows[2];
        if (!in_window(p, solid, i)) continue;
        const int count = rows_at(p, across_of(p, solid, i), rows);
        for (int n = 0; n < count; ++n) {
            fw_flow *flow = &p->flow[rows[n]];
            flow->count += 1;
            flow->along += p->plan.axis == 0 ? p->velocity_y[i] : p->velocity_x[i];
            flow->across += p->plan.axis == 0 ? p->velocity_x[i] : p->velocity_y[i];
        }
    }
    for (int row = 0; row < p->bin_count + 2; ++row) {
        const fw_flow *flow = &p->flow[row];
        if (flow->count == 0) continue;
        p->sums[row][SUM_DRIFT] += flow->along * flow->along / flow->count;
        p->sums[row][SUM_FREEDOM] += 2 * (flow->count - 1);
    }
}

/* What happened to the bonds of the last sample. */
static void follow_bonds(const fw_profile *p, const fw_solid *solid, int i, double *sums)
{
    const double lost = LOST * fw_particles_bond_radius(solid);
    sums[SUM_FOLLOWED] += 1;
    for (int n = 0; n < BONDS_MAX && p->last_bonds[i][n] >= 0; ++n) {
        const int j = p->last_bonds[i][n];
        const double dx = solid->x[j] - solid->x[i], dy = solid->y[j] - solid->y[i];
        const double mx = dx - (p->last_x[j] - p->last_x[i]);
        const double my = dy - (p->last_y[j] - p->last_y[i]);
        sums[SUM_LOST] += dx * dx + dy * dy > lost * lost;
        sums[SUM_CHANGE] += mx * mx + my * my;
        sums[SUM_CHANGED] += 1;
    }
}

static void add_particle(fw_profile *p, const fw_solid *solid, int i)
{
    int rows[2], bonds;
    const int count = rows_at(p, across_of(p, solid, i), rows);
    if (count == 0) return;
    const fw_phase order = fw_particles_bond_order(solid, i, &bonds);
    const double along = p->plan.axis == 0 ? p->velocity_y[i] : p->velocity_x[i];
    const double across = p->plan.axis == 0 ? p->velocity_x[i] : p->velocity_y[i];
    for (int n = 0; n < count; ++n) {
        double *sums = p->sums[rows[n]];
        const fw_flow *flow = &p->flow[rows[n]];
        const double u = along - flow->along / flow->count, v = across - flow->across / flow->count;
        sums[SUM_PARTICLES] += 1;
        sums[SUM_RETURN_FORCE] +=
            sqrt(p->force_x[i] * p->force_x[i] + p->force_y[i] * p->force_y[i]);
        if (!isnan(p->bond_force[i])) {
            sums[SUM_BOND_FORCE] += p->bond_force[i];
            sums[SUM_BONDED] += 1;
        }
        sums[SUM_ORDER] += sqrt(order.cosine * order.cosine + order.sine * order.sine);
        sums[SUM_HEAT] += p->mass[i] * (u * u + v * v);
        if (p->followed) follow_bonds(p, solid, i, sums);
    }
}

static void remember(fw_profile *p, const fw_solid *solid)
{
    const fw_neighbours *neighbours = fw_particles_neighbours(solid);
    const double radius = fw_particles_bond_radius(solid);
    for (int i = 0; i < solid->count; ++i) {
        int count = 0;
        for (size_t k = neighbours->begin[i]; k < neighbours->begin[i + 1]; ++k) {
            const int j = neighbours->list[k];
            const double dx = solid->x[j] - solid->x[i], dy = solid->y[j] - solid->y[i];
            if (dx * dx + dy * dy < radius * radius && count < BONDS_MAX)
                p->last_bonds[i][count++] = j;
        }
        if (count < BONDS_MAX) p->last_bonds[i][count] = -1;
        p->last_x[i] = solid->x[i];
        p->last_y[i] = solid->y[i];
    }
    p->followed = 1;
}

static void take(fw_profile *p, const fw_solid *solid)
{
    fw_particles_return_forces(solid, p->force_x, p->force_y);
    fw_particles_bond_return_forces(solid, p->bond_force);
    add_flow(p, solid);
    for (int i = 0; i < solid->count; ++i)
        if (in_window(p, solid, i)) add_particle(p, solid, i);
    p->samples += 1;
}

void fw_profile_follow(fw_profile *profile, const fw_solid *solid, int64_t step)
{
    const fw_scenario_profile *plan = &profile->plan;
    if (step < plan->from || step > plan->until || (step - plan->from) % plan->every != 0) return;
    if (step > plan->from) take(profile, solid);
    remember(profile, solid);
}

/* --- life --- */

static bool allocate(fw_profile *p)
{
    const size_t count = (size_t)p->particle_count, rows = (size_t)p->bin_count + 2;
    p->sums = fw_array_allocate(rows, sizeof *p->sums);
    p->flow = fw_array_allocate(rows, sizeof *p->flow);
    p->force_x = fw_array_of_doubles(count);
    p->force_y = fw_array_of_doubles(count);
    p->bond_force = fw_array_of_doubles(count);
    p->velocity_x = fw_array_of_doubles(count);
    p->velocity_y = fw_array_of_doubles(count);
    p->mass = fw_array_of_doubles(count);
    p->last_x = fw_array_of_doubles(count);
    p->last_y = fw_array_of_doubles(count);
    p->last_bonds = fw_array_allocate(count, sizeof *p->last_bonds);
    return p->sums && p->flow && p->force_x && p->force_y && p->bond_force && p->velocity_x &&
           p->velocity_y && p->mass && p->last_x && p->last_y && p->last_bonds;
}

static fw_status refuse_empty(const fw_profile *p, const fw_scenario *scenario,
                              const fw_solid *solid, fw_error *error)
{
    int window = 0, contact = 0, far = 0;
    for (int i = 0; i < solid->count; ++i) {
        if (!in_window(p, solid, i)) continue;
        const double distance = fabs(across_of(p, solid, i) - p->plan.middle);
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

static fw_status build(fw_profile *p, const fw_scenario *scenario, const fw_solid *solid,
                       fw_error *error)
{
    enum { BINS_MAX = 100000 };
    double low = INFINITY, high = -INFINITY;
    p->plan = scenario->profile;
    p->time_step = solid->tick;
    p->particle_count = solid->count;
    p->window_low = p->plan.window[0];
    p->window_high = p->plan.window[1];
    const bool all = p->window_low == p->window_high;
    if (all) p->window_low = INFINITY, p->window_high = -INFINITY;
    for (int i = 0; i < solid->count; ++i) {
        const double along = p->plan.axis == 0 ? solid->y[i] : solid->x[i];
        low = fmin(low, across_of(p, solid, i));
        high = fmax(high, across_of(p, solid, i));
        if (all) p->window_low = fmin(p->window_low, along);
        if (all) p->window_high = fmax(p->window_high, along);
    }
    const double first = floor((low - p->plan.middle) / p->plan.bin + .5);
    const double last = floor((high - p->plan.middle) / p->plan.bin + .5);
    FW_TRY(refuse_empty(p, scenario, solid, error));
    if (last - first >= BINS_MAX || fabs(first) > 1e9)
        return fw_scenario_fail(scenario, p->plan.place, error,
                                "profile.bin is %g, which makes %.0f bins, expected at most %d",
                                p->plan.bin, last - first + 1, BINS_MAX);
    p->first_bin = (int)first;
    p->bin_count = (int)(last - first) + 1;
    if (!allocate(p)) return fw_fail_memory(error, "a profile");
    solid->model->masses(solid, p->mass);
    return FW_OK;
}

fw_status fw_profile_create(fw_profile **profile, const fw_scenario *scenario,
                            const fw_solid *solid, fw_error *error)
{
    *profile = calloc(1, sizeof **profile);
    if (!*profile) return fw_fail_memory(error, "a profile");
    const fw_status status = build(*profile, scenario, solid, error);
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
    free(profile->force_x);
    free(profile->force_y);
    free(profile->bond_force);
    free(profile->velocity_x);
    free(profile->velocity_y);
    free(profile->mass);
    free(profile->last_x);
    free(profile->last_y);
    free(profile->last_bonds);
    free(profile);
}

void fw_profile_state(fw_profile *profile, fw_state_list *list)
{
    const size_t count = (size_t)profile->particle_count;
    fw_state_list_add(list, "sums", FW_F64, ((size_t)profile->bin_count + 2) * SUMS, profile->sums);
    fw_state_list_add(list, "samples", FW_I64, 1, &profile->samples);
    fw_state_list_add(list, "followed", FW_I64, 1, &profile->followed);
    fw_state_list_add(list, "last-x", FW_F64, count, profile->last_x);
    fw_state_list_add(list, "last-y", FW_F64, count, profile->last_y);
    fw_state_list_add(list, "last-bonds", FW_I32, count * BONDS_MAX, profile->last_bonds);
}

fw_status fw_profile_restored(const fw_profile *profile, fw_error *error)
{
    if (profile->samples < 0 || profile->followed < 0 || profile->followed > 1)
        return fw_fail(error, FW_BAD_INPUT, "the profile has %lld samples, expected 0 or more",
                       (long long)profile->samples);
    for (int i = 0; i < profile->particle_count; ++i)
        for (int n = 0; n < BONDS_MAX; ++n)
            if (profile->last_bonds[i][n] < -1 ||
                profile->last_bonds[i][n] >= profile->particle_count)
                return fw_fail(
                    error, FW_BAD_INPUT,
                    "the profile follows a bond from particle %d to %d, expected 0 to %d", i,
                    profile->last_bonds[i][n], profile->particle_count - 1);
    return FW_OK;
}

/* --- what came out --- */

double fw_profile_contact_now(fw_profile *p, const fw_solid *solid)
{
    double sum = 0;
    int count = 0;
    fw_particles_return_forces(solid, p->force_x, p->force_y);
    for (int i = 0; i < solid->count; ++i) {
        if (!in_window(p, solid, i)) continue;
        if (!(fabs(across_of(p, solid, i) - p->plan.middle) < p->plan.contact)) continue;
        sum += sqrt(p->force_x[i] * p->force_x[i] + p->force_y[i] * p->force_y[i]);
        count += 1;
    }
    return count > 0 ? sum / count : NAN;
}

int fw_profile_bin_count(const fw_profile *profile)
{
    return profile->bin_count;
}

double fw_profile_edge(const fw_profile *profile, int bin)
{
    return profile->plan.middle + (profile->first_bin + bin - .5) * profile->plan.bin;
}

int64_t fw_profile_sample_count(const fw_profile *profile)
{
    return profile->samples;
}

static double over(double sum, double count)
{
    return count > 0 ? sum / count : NAN;
}

static int row_of(const fw_profile *p, int bin)
{
    return bin >= 0 ? bin : p->bin_count + (bin == FW_PROFILE_FAR);
}

double fw_profile_least_exchange(const fw_profile *p, int bin)
{
    return over(1, p->sums[row_of(p, bin)][SUM_FOLLOWED] * (double)p->plan.every * p->time_step);
}

double fw_profile_value(const fw_profile *p, int bin, fw_profile_column column)
{
    const int row = row_of(p, bin);
    const double *sums = p->sums[row];
    const double width = bin >= 0                    ? p->plan.bin
                         : bin == FW_PROFILE_CONTACT ? 2 * p->plan.contact
                                                     : 2 * (p->plan.far[1] - p->plan.far[0]);
    const double area = width * (p->window_high - p->window_low);
    switch (column) {
    case FW_PROFILE_RETURN_FORCE:
        return over(sums[SUM_RETURN_FORCE], sums[SUM_PARTICLES]);
    case FW_PROFILE_BOND_FORCE:
        return over(sums[SUM_BOND_FORCE], sums[SUM_BONDED]);
    case FW_PROFILE_ORDER:
        return over(sums[SUM_ORDER], sums[SUM_PARTICLES]);
    case FW_PROFILE_DENSITY:
        return over(sums[SUM_PARTICLES], (double)p->samples * area);
    case FW_PROFILE_TEMPERATURE:
        return over(sums[SUM_HEAT], sums[SUM_FREEDOM]);
    case FW_PROFILE_DRIFT:
        return sqrt(over(sums[SUM_DRIFT], sums[SUM_PARTICLES]));
    case FW_PROFILE_EXCHANGES:
        return over(sums[SUM_LOST], sums[SUM_FOLLOWED] * (double)p->plan.every * p->time_step);
    case FW_PROFILE_MOBILITY:
        return over(sums[SUM_CHANGE], sums[SUM_CHANGED]);
    case FW_PROFILE_COLUMNS:
        break;
    }
    return NAN;
}
