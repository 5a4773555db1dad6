/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_shape.c - the shape of bodies, how it changes, and what is inside: extent, rate of
 * deformation, torque, order of their bonds, density. Keeps no state. */
#include "experiments/measures/quantity.h"

#include "core/particles/langevin.h"
#include "core/particles/neighbours.h"
#include "core/particles/surroundings.h"

#include <math.h>
#include <stdlib.h>

#define MLP          "movable-particles"
#define POINT_MASSES "movable-particles linear-lattice"

/* A bond of the start is lost by degrees, while its length grows from 1 to so many bond radii: its
 * loss has a rate then. */
#define LOST 1.3

static const fw_solid *solid_of(const fw_experiment *experiment, int body)
{
    return fw_experiment_solid(experiment, body);
}

/* What counts as a bond, and as a link of a cluster: of movable particles what the scenario says
 * and the reach of their potential, of others the same in spacings. */
static double bond_radius_of(const fw_experiment *experiment, int body)
{
    if (fw_body_range_group(experiment->scene, &experiment->bodies[body]) >= 0)
        return experiment->scenario->dynamics.bond_radius;
    return 1.25 * experiment->bodies[body].spacing;
}

static double link_of(const fw_experiment *experiment, int body)
{
    const fw_scenario *scenario = experiment->scenario;
    if (fw_body_range_group(experiment->scene, &experiment->bodies[body]) >= 0)
        return scenario->materials[scenario->bodies[body].material].particles.potential.cut.outer;
    return 1.7 * experiment->bodies[body].spacing;
}

/* --- extent --- */

typedef struct bounds {
    fw_vec2 low, high;
} bounds;

static const bounds nothing = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

static void include(bounds *b, fw_vec2 at)
{
    b->low = (fw_vec2){fmin(b->low.x, at.x), fmin(b->low.y, at.y)};
    b->high = (fw_vec2){fmax(b->high.x, at.x), fmax(b->high.y, at.y)};
}

static fw_vec2 extent_of(bounds b)
{
    return fw_vec2_subtract(b.high, b.low);
}

static void extent(const fw_experiment *experiment, fw_subject subject, double *out)
{
    bounds all = nothing;
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        if (subject.body >= 0 && subject.body != b) continue;
        for (int i = range->first; i < range->first + range->count; ++i)
            include(&all, fw_solid_position(solid_of(experiment, b), i));
    }
    fw_quantity_put(out, extent_of(all));
}

/* Which of a body's particles are in its largest cluster: malloc'ed, NULL without memory. */
static uint8_t *cluster_of(const fw_experiment *experiment, int body)
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_solid *solid = solid_of(experiment, body);
    uint8_t *members = malloc((size_t)range->count);
    int count;
    if (!members ||
        fw_surroundings_cluster(solid->x + range->first, solid->y + range->first, range->count,
                                link_of(experiment, body), members, &count, NULL) == FW_OK)
        return members;
    free(members);
    return NULL;
}

/* Popov & Filippov Eq 23, without what has come off. */
static void relative_extent(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    uint8_t *members = cluster_of(experiment, subject.body);
    bounds start = nothing, now = nothing;
    out[0] = out[1] = NAN;
    if (!members) return;
    for (int l = 0; l < range->count; ++l) {
        include(&start, experiment->start[subject.body][l]);
        if (members[l])
            include(&now, fw_solid_position(solid_of(experiment, subject.body), range->first + l));
    }
    free(members);
    const fw_vec2 before = extent_of(start), after = extent_of(now);
    out[0] = before.x > 0 ? after.x / before.x : NAN;
    out[1] = before.y > 0 ? after.y / before.y : NAN;
}

/* --- deformation --- */

/* The matrix L of the linear field v = V + L (r - R) that the velocities are nearest to by least
 * squares: L = <(v - V)(r - R)> <(r - R)(r - R)>^-1, V and R their means. */
static void deformation_rate(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_solid *solid = solid_of(experiment, subject.body);
    double *vx = calloc(2 * (size_t)solid->count, sizeof *vx), *vy = vx ? vx + solid->count : NULL;
    for (int c = 0; c < 4; ++c) out[c] = NAN;
    if (!vx) return;
    solid->model->velocities(solid, vx, vy);
    fw_vec2 middle = {0, 0}, drift = {0, 0};
    const double part = 1. / range->count;
    for (int i = range->first; i < range->first + range->count; ++i) {
        middle = fw_vec2_add(middle, fw_vec2_scale(part, fw_solid_position(solid, i)));
        drift = fw_vec2_add(drift, fw_vec2_scale(part, (fw_vec2){vx[i], vy[i]}));
    }
    fw_sym2 spread = {0, 0, 0};
    double flux[4] = {0};
    for (int i = range->first; i < range->first + range->count; ++i) {
        const fw_vec2 r = fw_vec2_subtract(fw_solid_position(solid, i), middle);
        const fw_vec2 v = fw_vec2_subtract((fw_vec2){vx[i], vy[i]}, drift);
        spread.xx += r.x * r.x, spread.xy += r.x * r.y, spread.yy += r.y * r.y;
        flux[0] += v.x * r.x, flux[1] += v.x * r.y, flux[2] += v.y * r.x, flux[3] += v.y * r.y;
    }
    free(vx);
    const double determinant = spread.xx * spread.yy - spread.xy * spread.xy;
    if (!(determinant > FW_MEASURED * (spread.xx + spread.yy) * (spread.xx + spread.yy))) return;
    for (int row = 0; row < 2; ++row) {
        const double x = flux[2 * row], y = flux[2 * row + 1];
        out[2 * row] = (x * spread.yy - y * spread.xy) / determinant;
        out[2 * row + 1] = (y * spread.xx - x * spread.xy) / determinant;
    }
}

/* Bonds of the start, by the particles' own numbers: NULL without memory. */
static fw_neighbours *bonds_at_start(const fw_experiment *experiment, int body)
{
    const size_t count = (size_t)experiment->bodies[body].count;
    const fw_vec2 *start = experiment->start[body];
    double *x = calloc(2 * count, sizeof *x), *y = x ? x + count : NULL;
    fw_neighbours *near = NULL;
    for (size_t l = 0; x && l < count; ++l) x[l] = start[l].x, y[l] = start[l].y;
    if (x) fw_neighbours_create(&near, x, y, (int)count, bond_radius_of(experiment, body), NULL);
    free(x);
    return near;
}

/* Plastic deformation takes bonds apart, elastic deformation does not. loss[0] is the mean over the
 * bonds of the start of how far each is lost, loss[1] its derivative in time, from the velocities:
 * that of the length while the bond is being lost. NaN without memory or bonds. */
static void find_loss(const fw_experiment *experiment, int body, double loss[2])
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_solid *solid = solid_of(experiment, body);
    const double radius = bond_radius_of(experiment, body), width = (LOST - 1) * radius;
    double *vx = calloc(2 * (size_t)solid->count, sizeof *vx), *vy = vx ? vx + solid->count : NULL;
    fw_neighbours *near = bonds_at_start(experiment, body);
    const size_t bonds = near ? near->begin[range->count] : 0;
    double sum = 0, rate = 0;
    if (vx) solid->model->velocities(solid, vx, vy);
    for (int l = 0; vx && bonds > 0 && l < range->count; ++l)
        for (size_t k = near->begin[l]; k < near->begin[l + 1]; ++k) {
            const int i = range->first + l, j = range->first + near->list[k];
            const fw_vec2 bond =
                fw_vec2_subtract(fw_solid_position(solid, j), fw_solid_position(solid, i));
            const double length = sqrt(fw_vec2_dot(bond, bond)), part = (length - radius) / width;
            sum += fmin(fmax(part, 0), 1);
            if (part > 0 && part < 1)
                rate +=
                    fw_vec2_dot(bond, (fw_vec2){vx[j] - vx[i], vy[j] - vy[i]}) / (length * width);
        }
    loss[0] = vx && bonds > 0 ? sum / (double)bonds : NAN;
    loss[1] = vx && bonds > 0 ? rate / (double)bonds : NAN;
    fw_neighbours_destroy(near);
    free(vx);
}

static void lost_bonds(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double loss[2];
    find_loss(experiment, subject.body, loss);
    out[0] = loss[0];
}

static void plastic_rate(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double loss[2];
    find_loss(experiment, subject.body, loss);
    out[0] = loss[1];
}

/* --- forces --- */

static void torque(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_langevin *solid = (const fw_langevin *)solid_of(experiment, subject.body);
    const fw_vec2 middle = fw_body_range_centre_of_mass(experiment->scene, range);
    out[0] = 0;
    for (int i = range->first; i < range->first + range->count; ++i) {
        const fw_vec2 arm = fw_vec2_subtract(fw_solid_position(&solid->head, i), middle);
        fw_vec2 force = {solid->force_x[i], solid->force_y[i]};
        if (solid->head.loaded)
            force =
                fw_vec2_add(force, (fw_vec2){solid->head.external_x[i], solid->head.external_y[i]});
        out[0] += fw_vec2_cross(arm, force);
    }
}

/* --- order --- */

enum { FOLDS = 8 };
static const int folds[FOLDS] = {2, 3, 4, 5, 6, 8, 10, 12};

/* Of the particles of one body, added to sum[] and count. */
static bool add_order(const fw_experiment *experiment, int body, double sum[FOLDS], int *bonded)
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_solid *solid = solid_of(experiment, body);
    const size_t count = (size_t)range->count;
    double *values = calloc(count * FOLDS, sizeof *values);
    const bool found =
        values && fw_surroundings_order(solid->x + range->first, solid->y + range->first,
                                        range->count, bond_radius_of(experiment, body), folds,
                                        FOLDS, values, NULL) == FW_OK;
    for (size_t l = 0; found && l < count; ++l) {
        if (isnan(values[l])) continue; /* without bonds */
        for (size_t f = 0; f < FOLDS; ++f) sum[f] += values[f * count + l];
        *bonded += 1;
    }
    free(values);
    return found;
}

static void bond_order(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double sum[FOLDS] = {0};
    int bonded = 0;
    bool found = true;
    for (int b = 0; b < experiment->body_count; ++b)
        if (subject.body < 0 || subject.body == b) found &= add_order(experiment, b, sum, &bonded);
    for (int f = 0; f < FOLDS; ++f) out[f] = found && bonded > 0 ? sum[f] / bonded : NAN;
}

/* --- density --- */

/* Mean, standard deviation and maximum over the particles; all of the scene's contribute. */
static void gaussian_density(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = fw_experiment_particles(experiment);
    const fw_body_range *range = subject.body < 0 ? NULL : &experiment->bodies[subject.body];
    const int first = range ? range->first : 0, count = range ? range->count : solid->count;
    double *values = calloc((size_t)solid->count, sizeof *values);
    out[0] = out[1] = out[2] = NAN;
    if (values &&
        fw_surroundings_density(solid->x, solid->y, solid->count, 1, values, NULL) == FW_OK) {
        const double mean = fw_array_sum(values + first, (size_t)count) / count;
        double square = 0, highest = 0;
        for (int i = first; i < first + count; ++i) {
            square += (values[i] - mean) * (values[i] - mean);
            highest = fmax(highest, values[i]);
        }
        out[0] = mean;
        out[1] = sqrt(square / count);
        out[2] = highest;
    }
    free(values);
}

/* clang-format off */
const fw_quantity fw_shape_quantities[] = {
    {"extent", FW_SCOPE_BODIES, "x y", "length", "from the lowest to the highest coordinate of a particle", NULL, extent, NULL, FW_NEEDS_NOTHING},
    {"relative-extent", FW_SCOPE_BODY, "x y", "1", "extent of the body's largest cluster over that of the body at the start; a cluster is linked where the potential reaches, in other solids below 1.7 spacings", NULL, relative_extent, "the body started as a line", FW_NEEDS_NOTHING},
    {"deformation-rate", FW_SCOPE_BODY, "xx xy yx yy", "1/time", "gradient of the linear field that the velocities are nearest to: xy is that of v_x along y", NULL, deformation_rate, "its particles lie on a line", FW_NEEDS_NOTHING},
    {"lost-bonds", FW_SCOPE_BODY, "", "1", "plastic deformation: part of the bonds of the start that are lost, each by degrees from 1 to 1.3 bond radii", NULL, lost_bonds, "it started without bonds", FW_NEEDS_NOTHING},
    {"plastic-rate", FW_SCOPE_BODY, "", "1/time", "rate of plastic deformation: derivative of lost-bonds in time, from the velocities", NULL, plastic_rate, "it started without bonds", FW_NEEDS_NOTHING},
    {"torque", FW_SCOPE_BODY, "", "torque", "about its centre of mass, of all particles' forces on its own and of external ones; without walls and grips", POINT_MASSES, torque, NULL, FW_NEEDS_NOTHING},
    {"bond-order", FW_SCOPE_BODIES, "psi2 psi3 psi4 psi5 psi6 psi8 psi10 psi12", "1", "mean of |mean of e^{i n phi}| over the bonds inside the body of each particle that has any, for n = 2, 3, ...", NULL, bond_order, "no particle has a bond", FW_NEEDS_NOTHING},
    {"gaussian-density", FW_SCOPE_BODIES, "mean spread maximum", "1", "sum of exp(-distance^2) over all particles (Eq 22), on the particles: its mean over them, standard deviation and maximum", MLP, gaussian_density, NULL, FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
