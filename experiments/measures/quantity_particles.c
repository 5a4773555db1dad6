/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_particles.c - what can be measured of movable particles, and of linear lattices as far
 * as they are point masses too. Keeps no state. */
#include "experiments/measures/quantity.h"
#include "experiments/setup/body_range.h"

#include "core/particles/particle_observables.h"
#include "core/particles/surroundings.h"

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
    return (particle_set){fw_experiment_particles(experiment), -1};
}

static bool is_point_masses(const fw_experiment *experiment, int body)
{
    return fw_solid_is_langevin(fw_experiment_solid(experiment, body));
}

/* --- heat --- */

/* Momentum and mass of the particles that a grip holds, and how many there are. */
static int held_part(const fw_experiment *experiment, const fw_body_range *range,
                     const uint8_t *held, double *buffer, fw_vec2 *momentum, double *mass)
{
    const fw_solid *solid = fw_scene_observe_body(experiment->scene, range->solid);
    double *x = buffer, *y = x + solid->count, *m = y + solid->count;
    int count = 0;
    solid->model->velocities(solid, x, y);
    solid->model->masses(solid, m);
    for (int i = range->first; i < range->first + range->count; ++i) {
        if (!held[i]) continue;
        *momentum = fw_vec2_add(*momentum, fw_vec2_scale(m[i], (fw_vec2){x[i], y[i]}));
        *mass += m[i];
        count += 1;
    }
    return count;
}

/* Adds sum m (v - V)^2 per component, V the mean velocity of the body's particles that no grip
 * holds: what a grip holds moves as one, and has no temperature. Returns how many particles' worth
 * of freedom that leaves; -1 without memory. */
static int add_heat(const fw_experiment *experiment, int body, fw_vec2 *heat)
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    const size_t count = (size_t)solid->count;
    uint8_t *held = calloc(count, sizeof *held);
    double *buffer = malloc(3 * count * sizeof *buffer), mass = 0;
    fw_vec2 momentum = {0, 0};
    int free_count = -1;
    if (held && buffer) {
        fw_scene_mark_held(experiment->scene, range->solid, held);
        free_count = range->count - held_part(experiment, range, held, buffer, &momentum, &mass);
        const fw_vec2 drift = fw_vec2_scale(
            1 / (fw_body_range_mass(experiment->scene, range).xx - mass),
            fw_vec2_subtract(fw_body_range_momentum(experiment->scene, range), momentum));
        const int end = range->first + range->count;
        for (int first = range->first, next; first < end; first = next) {
            for (next = first + 1; next < end && held[next] == held[first];) ++next;
            if (!held[first]) fw_langevin_add_heat(solid, first, next - first, drift, heat);
        }
        free_count = free_count > 0 ? free_count - 1 : 0;
    }
    free(held);
    free(buffer);
    return free_count;
}

static void temperature_along(const fw_experiment *experiment, fw_subject subject, double *out)
{
    int freedom = 0;
    fw_vec2 heat = {0, 0};
    for (int b = 0; b < experiment->body_count; ++b) {
        if (subject.body != b && (subject.body >= 0 || !is_point_masses(experiment, b))) continue;
        const int added = add_heat(experiment, b, &heat);
        if (added < 0) {
            out[0] = out[1] = NAN;
            return;
        }
        freedom += added;
    }
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

/* What the body covered when it was made: its cells of the lattice, the box it was dropped in, or
 * the box around its places, half a distance of neighbours wider on each side.
 */
static double area_of(const fw_experiment *experiment, int body)
{
    const fw_scenario_body *from = &experiment->scenario->bodies[body];
    const fw_vec2 size = fw_vec2_subtract(from->shape.high, from->shape.low);
    if (from->shape.kind == FW_SHAPE_PLACED) return size.x * size.y;
    if (from->shape.kind == FW_SHAPE_POINTS)
        return (size.x + from->lattice.spacing) * (size.y + from->lattice.spacing);
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
    const fw_solid *solid = particles_of(experiment, subject).solid;
    const fw_body_range all = {.count = solid->count};
    const fw_body_range *range = subject.body < 0 ? &all : &experiment->bodies[subject.body];
    const fw_scenario *scenario = experiment->scenario;
    double link = 0;
    for (int m = 0; m < scenario->material_count; ++m)
        if (scenario->materials[m].kind == FW_MOVABLE_PARTICLES)
            link = scenario->materials[m].particles.potential.cut.outer;
    uint8_t *members = malloc((size_t)range->count);
    int count = 0;
    out[0] = NAN;
    if (members && fw_surroundings_cluster(solid->x + range->first, solid->y + range->first,
                                           range->count, link, members, &count, NULL) == FW_OK)
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
    out[0] = decay > 0 ? (exact > 0 ? out[0] / exact : NAN) : 1;
}

/* clang-format off */
const fw_quantity fw_particle_quantities[] = {
    {"temperature", FW_SCOPE_BODIES, "", "energy/k_B", "kinetic energy about the mean velocity of each body, per degree of freedom, times 2/k_B; of what no grip holds", POINT_MASSES, temperature, "fewer than two of its particles are free", FW_NEEDS_NOTHING},
    {"temperature-along", FW_SCOPE_BODIES, "x y", "energy/k_B", "the same of the velocities along x and along y", POINT_MASSES, temperature_along, "fewer than two of its particles are free", FW_NEEDS_NOTHING},
    {"pressure", FW_SCOPE_BODY, "xx xy yx yy", "force/length", "pressure tensor, over the area that the body covered when it was made", MLP, pressure, NULL, FW_NEEDS_NOTHING},
    {"lab-order", FW_SCOPE_BODIES, "", "1", "mean of cos n(phi - axes) over all bonds", MLP, lab_order, NULL, FW_NEEDS_NOTHING},
    {"local-order", FW_SCOPE_BODIES, "", "1", "mean of |psi_n|, psi_n the mean of e^{i n phi} over the bonds of a particle", MLP, local_order, NULL, FW_NEEDS_NOTHING},
    {"coordination", FW_SCOPE_BODIES, "", "1", "mean number of bonds of a particle", MLP, coordination, NULL, FW_NEEDS_NOTHING},
    {"bragg-peak", FW_SCOPE_BODY, "", "1", "mean height of the structure factor's first peaks, each the largest value within a tenth of its wave number from where the axes have it: 1 for a perfect crystal", MLP, bragg_peak, NULL, FW_NEEDS_NOTHING},
    {"largest-cluster", FW_SCOPE_BODIES, "", "1", "particles in the largest cluster, linked where the potential reaches, of a body inside it", MLP, largest_cluster, NULL, FW_NEEDS_NOTHING},
    {"return-force", FW_SCOPE_BODIES, "", "force", "mean size of the net return force on a particle", MLP, return_force, NULL, FW_NEEDS_NOTHING},
    {"bond-angle", FW_SCOPE_BODY, "", "degrees", "direction of the second particle, seen from the first", POINT_MASSES, bond_angle, NULL, FW_NEEDS_NOTHING},
    {"diffusion-ratio", FW_SCOPE_BODY, "", "1", "mean square displacement over the exact one of free Brownian particles that start thermal", POINT_MASSES, diffusion_ratio, "without damping or temperature nothing diffuses", FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
