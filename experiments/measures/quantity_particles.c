/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_particles.c - what can be measured of movable particles, and of linear lattices as far
 * as they are point masses too. Keeps no state. */
#include "experiments/measures/quantity.h"
#include "experiments/setup/body_range.h"

#include "core/particles/particle_observables.h"

#include <math.h>
#include <stdlib.h>

#define MLP          "movable-particles"
#define POINT_MASSES "movable-particles linear-lattice"

/* The solid of all movable particles, and which group of it is meant: -1 for all. */
typedef struct particle_set {
    const fw_solid *solid;
    int group;
} particle_set;

static particle_set particles_of(const fw_experiment *experiment, fw_subject subject)
{
    if (subject.body >= 0)
        return (particle_set){
            fw_experiment_solid(experiment, subject.body),
            fw_body_range_group(experiment->scene, &experiment->bodies[subject.body])};
    int b = 0;
    while (!fw_solid_is_particles(fw_experiment_solid(experiment, b))) ++b;
    return (particle_set){fw_experiment_solid(experiment, b), -1};
}

static bool is_point_masses(const fw_experiment *experiment, int body)
{
    return fw_solid_is_langevin(fw_experiment_solid(experiment, body));
}

/* --- heat --- */

/* Adds sum m (v - V)^2 per component, V the body's mean velocity; returns how many particles' worth
 * of freedom that leaves. */
static int add_heat(const fw_experiment *experiment, int body, fw_vec2 *heat)
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_vec2 drift =
        fw_vec2_scale(1 / fw_body_range_mass(experiment->scene, &experiment->bodies[body]).xx,
                      fw_body_range_momentum(experiment->scene, &experiment->bodies[body]));
    fw_langevin_add_heat(fw_experiment_solid(experiment, body), range->first, range->count, drift,
                         heat);
    return range->count - 1;
}

static void temperature_along(const fw_experiment *experiment, fw_subject subject, double *out)
{
    int freedom = 0;
    fw_vec2 heat = {0, 0};
    for (int b = 0; b < experiment->body_count; ++b)
        if (subject.body == b || (subject.body < 0 && is_point_masses(experiment, b)))
            freedom += add_heat(experiment, b, &heat);
    out[0] = heat.x / freedom;
    out[1] = heat.y / freedom;
}

static void temperature(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double along[2];
    temperature_along(experiment, subject, along);
    out[0] = 0.5 * (along[0] + along[1]);
}

/* --- pressure --- */

/* What the body covered when it was made: its cells of the lattice, or the box it was dropped in.
 */
static double area_of(const fw_experiment *experiment, int body)
{
    const fw_scenario_body *from = &experiment->scenario->bodies[body];
    if (from->shape.kind == FW_SHAPE_PLACED)
        return (from->shape.high.x - from->shape.low.x) * (from->shape.high.y - from->shape.low.y);
    const double square = from->lattice.spacing * from->lattice.spacing;
    const double cell = from->lattice.kind == FW_HEXAGONAL ? 0.5 * sqrt(3) * square : square;
    return cell * experiment->bodies[body].count;
}

static void pressure(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const particle_set set = particles_of(experiment, subject);
    const fw_tensor tensor =
        fw_particle_pressure(set.solid, set.group, area_of(experiment, subject.body));
    out[0] = tensor.xx;
    out[1] = tensor.xy;
    out[2] = tensor.yx;
    out[3] = tensor.yy;
}

/* --- order --- */

static fw_particle_order order_of(const fw_experiment *experiment, fw_subject subject)
{
    const particle_set set = particles_of(experiment, subject);
    return fw_particle_order_of(set.solid, set.group);
}

static void lab_order(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = order_of(experiment, subject).lab;
}

static void local_order(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = order_of(experiment, subject).local;
}

static void coordination(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = order_of(experiment, subject).coordination;
}

static void bragg_peak(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const particle_set set = particles_of(experiment, subject);
    const fw_return_force *force = &fw_particles_group(set.solid, set.group)->return_force;
    out[0] = fw_particle_bragg_peak(set.solid, set.group, force->fold, force->angle,
                                    force->distance, 0.1);
}

static void largest_cluster(const fw_experiment *experiment, fw_subject subject, double *out)
{
    static const fw_subject all = {.body = -1};
    (void)subject;
    const particle_set set = particles_of(experiment, all);
    const fw_scenario *scenario = experiment->scenario;
    double link = 0;
    for (int m = 0; m < scenario->material_count; ++m)
        if (scenario->materials[m].kind == FW_MOVABLE_PARTICLES)
            link = scenario->materials[m].particles.potential.cut.outer;
    uint8_t *members = malloc((size_t)set.solid->count);
    int count = 0;
    out[0] = NAN;
    if (members && fw_particle_largest_cluster(set.solid, link, members, &count, NULL) == FW_OK)
        out[0] = count;
    free(members);
}

static void return_force(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const particle_set set = particles_of(experiment, subject);
    const fw_field *field = fw_solid_find_field(set.solid, "return-force");
    double *values = malloc((size_t)set.solid->count * sizeof *values);
    out[0] = NAN;
    if (!values) return;
    field->fill(set.solid, values);
    const int first = set.group < 0 ? 0 : fw_particles_group(set.solid, set.group)->first;
    const int count =
        set.group < 0 ? set.solid->count : fw_particles_group(set.solid, set.group)->count;
    out[0] = fw_array_sum(values + first, (size_t)count) / count;
    free(values);
}

/* --- motion --- */

static void bond_angle(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_solid *solid = fw_experiment_solid(experiment, subject.body);
    const fw_vec2 bond =
        fw_vec2_subtract(fw_solid_position(solid, range->first + (range->count > 1 ? 1 : 0)),
                         fw_solid_position(solid, range->first));
    out[0] = atan2(bond.y, bond.x) * 180 / FW_PI;
}

/* Mean square displacement over that of a free Brownian particle, 4 T/(m eta) [t - tau (1 -
 * e^{-t/tau})] with tau = 1/eta; 1 at the start, where both vanish. */
static void diffusion_ratio(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_scenario_dynamics *dynamics = &experiment->scenario->dynamics;
    const double rate = dynamics->damping;
    const double decay = rate * fw_scene_time(experiment->scene);
    const double mass =
        fw_body_range_mass(experiment->scene, &experiment->bodies[subject.body]).xx /
        experiment->bodies[subject.body].count;
    fw_quantity_find("mean-square-displacement")->measure(experiment, subject, out);
    const double exact = 4 * dynamics->temperature / (mass * rate * rate) * (decay + expm1(-decay));
    out[0] = decay > 0 ? out[0] / exact : 1;
}

/* clang-format off */
const fw_quantity fw_particle_quantities[] = {
    {"temperature", FW_SCOPE_BODIES, "", "energy", "k_B T: kinetic energy about the mean velocity of each body, per degree of freedom, times 2", POINT_MASSES, temperature},
    {"temperature-along", FW_SCOPE_BODIES, "x y", "energy", "the same of the velocities along x and along y", POINT_MASSES, temperature_along},
    {"pressure", FW_SCOPE_BODY, "xx xy yx yy", "force/length", "pressure tensor, over the area that the body covered when it was made", MLP, pressure},
    {"lab-order", FW_SCOPE_BODIES, "", "1", "mean of cos n(phi - axes) over all bonds", MLP, lab_order},
    {"local-order", FW_SCOPE_BODIES, "", "1", "mean of |psi_n|, psi_n the mean of e^{i n phi} over the bonds of a particle", MLP, local_order},
    {"coordination", FW_SCOPE_BODIES, "", "1", "mean number of bonds of a particle", MLP, coordination},
    {"bragg-peak", FW_SCOPE_BODY, "", "1", "mean height of the structure factor's first peaks, at the axes' directions: 1 for a perfect crystal", MLP, bragg_peak},
    {"largest-cluster", FW_SCOPE_SCENE, "", "1", "particles in the largest cluster, linked where the potential reaches", MLP, largest_cluster},
    {"return-force", FW_SCOPE_BODIES, "", "force", "mean size of the net return force on a particle", MLP, return_force},
    {"bond-angle", FW_SCOPE_BODY, "", "degrees", "direction of the second particle, seen from the first", POINT_MASSES, bond_angle},
    {"diffusion-ratio", FW_SCOPE_BODY, "", "1", "mean square displacement over the exact one of free Brownian particles that start thermal", POINT_MASSES, diffusion_ratio},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL},
};
/* clang-format on */
