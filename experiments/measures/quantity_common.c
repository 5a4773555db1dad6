/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_common.c - what can be measured of any solid and of walls. Keeps no state. */
#include "experiments/measures/quantity.h"
#include "experiments/setup/body_range.h"

#include <math.h>

static const fw_solid *body_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_experiment_solid(experiment, subject.body);
}

/* --- energy and momentum --- */

static fw_energies energies_of(const fw_experiment *experiment, fw_subject subject)
{
    if (subject.body < 0) return fw_scene_energies(experiment->scene);
    return fw_body_range_energies(experiment->scene, &experiment->bodies[subject.body]);
}

static fw_vec2 momentum_of(const fw_experiment *experiment, fw_subject subject)
{
    if (subject.body < 0) return fw_scene_momentum(experiment->scene);
    return fw_body_range_momentum(experiment->scene, &experiment->bodies[subject.body]);
}

static double total(fw_energies energies)
{
    return energies.kinetic + energies.elastic;
}

static void energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = total(energies_of(experiment, subject));
}

static void kinetic_energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = energies_of(experiment, subject).kinetic;
}

static void elastic_energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = energies_of(experiment, subject).elastic;
}

static void energy_per_particle(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double count = 0;
    for (int b = 0; b < experiment->body_count; ++b)
        if (subject.body < 0 || subject.body == b) count += experiment->bodies[b].count;
    const double walls = subject.body < 0 ? fw_scene_ledger(experiment->scene).wall_stored : 0;
    out[0] = (total(energies_of(experiment, subject)) + walls) / count;
}

/* A difference of energies over the largest energy or work so far, or that of this instant. */
static double relative(double difference, double now, double so_far)
{
    const double scale = fmax(fabs(now), so_far);
    return scale > 0 ? difference / scale : 0;
}

static void energy_drift(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    const fw_ledger ledger = fw_scene_ledger(experiment->scene);
    const double now = total(fw_scene_energies(experiment->scene)) + ledger.wall_stored;
    out[0] = relative(now - ledger.energy_at_start, now, fw_scene_energy_scale(experiment->scene));
}

/* Against what the ledger says that the energy should be. */
static void energy_error(const fw_experiment *experiment, double *out)
{
    const fw_ledger ledger = fw_scene_ledger(experiment->scene);
    const double now = total(fw_scene_energies(experiment->scene));
    out[0] =
        relative(now - fw_ledger_energy(&ledger), now, fw_scene_energy_scale(experiment->scene));
}

/* Movable particles of all bodies are one solid, with one ledger: theirs is taken together. */
static bool goes_with(const fw_experiment *experiment, int body, int other)
{
    return experiment->bodies[other].solid == experiment->bodies[body].solid;
}

static void body_energy_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    if (subject.body < 0) {
        energy_error(experiment, out);
        return;
    }
    /* The energy of a single body that meets no wall: all it exchanged is in its own ledger. */
    const fw_solid *solid = body_of(experiment, subject);
    const double expected = fw_experiment_energy_at_start(experiment, subject.body) +
                            solid->ledger.work - solid->ledger.dissipated + solid->ledger.heat;
    const double now = total(fw_solid_energies(solid));
    const double so_far = subject.observer ? subject.observer->energy_scale[subject.body] : 0;
    out[0] = relative(now - expected, now, so_far);
}

static void momentum(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, momentum_of(experiment, subject));
}

static void momentum_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_vec2 now, expected;
    if (subject.body < 0) {
        fw_ledger l = fw_scene_ledger(experiment->scene);
        now = fw_scene_momentum(experiment->scene);
        expected = fw_ledger_momentum(&l);
    } else {
        const fw_solid *solid = body_of(experiment, subject);
        now = fw_solid_momentum(solid);
        expected = fw_vec2_add(solid->ledger.impulse, solid->ledger.drag);
        for (int b = 0; b < experiment->body_count; ++b)
            if (goes_with(experiment, subject.body, b))
                expected = fw_vec2_add(expected, experiment->momentum_at_start[b]);
    }
    fw_quantity_put(out, fw_vec2_subtract(now, expected));
}

static void angular_momentum(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    out[0] = fw_solid_angular_momentum(body_of(experiment, subject), range->first, range->count);
}

/* By which rounding of a momentum is judged: what all of the start's energy could move with,
 * (2 M E)^(1/2). */
static double momentum_scale(const fw_experiment *experiment, fw_subject subject)
{
    const double energy = subject.body < 0
                              ? fw_scene_ledger(experiment->scene).energy_at_start
                              : fw_experiment_energy_at_start(experiment, subject.body);
    double mass = 0;
    for (int b = 0; b < experiment->body_count; ++b) {
        if (subject.body >= 0 && subject.body != b) continue;
        const fw_sym2 own = fw_body_range_mass(experiment->scene, &experiment->bodies[b]);
        mass += fmax(own.xx, own.yy);
    }
    return sqrt(2 * mass * fabs(energy));
}

static void momentum_ratio(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_vec2 now = momentum_of(experiment, subject);
    fw_vec2 start = subject.body < 0 ? fw_scene_ledger(experiment->scene).momentum_at_start
                                     : experiment->momentum_at_start[subject.body];
    const double square = fw_vec2_dot(start, start);
    const bool moves = sqrt(square) > FW_MEASURED * momentum_scale(experiment, subject);
    out[0] = moves ? sqrt(fw_vec2_dot(now, now) / square) : NAN;
}

/* (sum Psi)^2 / (2 sum M) / E: the part of the energy that the motion of the whole body holds. */
static void kinetic_fraction(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_vec2 p = fw_body_range_momentum(experiment->scene, range);
    const fw_sym2 inverse = fw_sym2_invert(fw_body_range_mass(experiment->scene, range));
    const double energy = total(fw_body_range_energies(experiment->scene, range));
    out[0] = energy > 0 ? 0.5 * fw_sym2_form(p, inverse, p) / energy : NAN;
}

static void mean_velocity(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, fw_sym2_apply(fw_sym2_invert(fw_body_range_mass(
                                           experiment->scene, &experiment->bodies[subject.body])),
                                       fw_body_range_momentum(experiment->scene,
                                                              &experiment->bodies[subject.body])));
}

/* --- the ledger --- */

static void external_work(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).external_work;
}

static void wall_work(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).wall_work;
}

static void wall_energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).wall_stored;
}

static void dissipated(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).dissipated;
}

static void friction_heat(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).friction_heat;
}

static void thermostat_heat(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = fw_scene_ledger(experiment->scene).thermostat_heat;
}

static void fracture_energy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = body_of(experiment, subject)->ledger.fracture;
}

/* --- motion and shape --- */

static void centre_of_mass(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(
        out, fw_body_range_centre_of_mass(experiment->scene, &experiment->bodies[subject.body]));
}

static void position(const fw_experiment *experiment, fw_subject subject, double *out)
{
    int particle = experiment->bodies[subject.body].first + subject.particle;
    fw_quantity_put(out, fw_solid_position(body_of(experiment, subject), particle));
}

static fw_vec2 displacement_of(const fw_experiment *experiment, int body, int particle)
{
    const fw_body_range *range = &experiment->bodies[body];
    const fw_scenario_body *from = &experiment->scenario->bodies[body];
    const fw_vec2 rest = fw_shape_is_free(from->shape.kind)
                             ? experiment->start[body][particle]
                             : fw_lattice_position(&from->lattice, range->sites.site[particle]);
    return fw_vec2_subtract(
        fw_solid_position(fw_experiment_solid(experiment, body), range->first + particle), rest);
}

static void displacement(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, displacement_of(experiment, subject.body, subject.particle));
}

static void elongation(const fw_experiment *experiment, fw_subject subject, double *out)
{
    int last = experiment->bodies[subject.body].count - 1;
    fw_quantity_put(out, fw_vec2_subtract(displacement_of(experiment, subject.body, last),
                                          displacement_of(experiment, subject.body, 0)));
}

/* Largest distance of any particle from where it started, in x or y. */
static void return_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = body_of(experiment, subject);
    const fw_vec2 *start = experiment->start[subject.body];
    out[0] = 0;
    for (int l = 0; l < experiment->bodies[subject.body].count; ++l) {
        fw_vec2 at = fw_solid_position(solid, experiment->bodies[subject.body].first + l);
        out[0] = fmax(out[0], fmax(fabs(at.x - start[l].x), fabs(at.y - start[l].y)));
    }
}

static void mean_square_displacement(const fw_experiment *experiment, fw_subject subject,
                                     double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_solid *solid = body_of(experiment, subject);
    double sum = 0;
    for (int l = 0; l < range->count; ++l) {
        const fw_vec2 moved = fw_vec2_subtract(fw_solid_position(solid, range->first + l),
                                               experiment->start[subject.body][l]);
        sum += fw_vec2_dot(moved, moved);
    }
    out[0] = sum / range->count;
}

/* The angle that turns the start best into the present (least squares), about the middle. */
static void rotation(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_body_range *range = &experiment->bodies[subject.body];
    const fw_vec2 *start = experiment->start[subject.body];
    const fw_solid *solid = body_of(experiment, subject);
    fw_vec2 before = {0, 0}, now = {0, 0};
    for (int l = 0; l < range->count; ++l) {
        before = fw_vec2_add(before, start[l]);
        now = fw_vec2_add(now, fw_solid_position(solid, range->first + l));
    }
    before = fw_vec2_scale(1. / range->count, before);
    now = fw_vec2_scale(1. / range->count, now);
    double cosine = 0, sine = 0;
    for (int l = 0; l < range->count; ++l) {
        const fw_vec2 from = fw_vec2_subtract(start[l], before);
        const fw_vec2 to = fw_vec2_subtract(fw_solid_position(solid, range->first + l), now);
        cosine += fw_vec2_dot(from, to);
        sine += fw_vec2_cross(from, to);
    }
    out[0] = atan2(sine, cosine) * 180 / FW_PI;
}

/* --- walls --- */

static void penetration(const fw_experiment *experiment, fw_subject subject, double *out)
{
    int body = subject.body < 0 ? -1 : experiment->bodies[subject.body].solid;
    out[0] = fw_scene_penetration(experiment->scene, body);
}

static void unresolved(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)subject;
    out[0] = (double)fw_scene_unresolved(experiment->scene);
}

static const fw_wall_ledger *ledger_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_scene_wall_ledger(experiment->scene, subject.wall);
}

static void reaction(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->reaction);
}

static void wall_impulse(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(out, ledger_of(experiment, subject)->impulse);
}

/* Along the tangent over along the normal, of the wall's first facet. */
static void friction_ratio(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_facet *facet = fw_wall_facet(fw_scene_wall(experiment->scene, subject.wall), 0);
    fw_vec2 impulse = ledger_of(experiment, subject)->impulse;
    const double along = fw_vec2_dot(impulse, fw_vec2_turn(facet->normal));
    const double pressed = fw_vec2_dot(impulse, facet->normal);
    out[0] = fabs(pressed) > FW_MEASURED * fabs(along) ? fabs(along) / pressed : NAN;
}

static void contacts(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = ledger_of(experiment, subject)->contacts;
}

static void contacts_so_far(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = ledger_of(experiment, subject)->held;
}

/* clang-format off */
const fw_quantity fw_common_quantities[] = {
    {"energy", FW_SCOPE_BODIES, "", "energy", "kinetic and elastic energy together", NULL, energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"kinetic-energy", FW_SCOPE_BODIES, "", "energy", "energy of motion", NULL, kinetic_energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"elastic-energy", FW_SCOPE_BODIES, "", "energy", "energy of deformation", NULL, elastic_energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"energy-per-particle", FW_SCOPE_BODIES, "", "energy", "kinetic and elastic energy (of the scene: and that in penalty walls) over the number of particles", NULL, energy_per_particle, NULL, FW_NEEDS_NO_POSITIONS},
    {"energy-drift", FW_SCOPE_SCENE, "", "1", "energy, with that in penalty walls, minus that at the start, over the largest energy or work so far", NULL, energy_drift, NULL, FW_NEEDS_NO_POSITIONS},
    {"energy-error", FW_SCOPE_BODIES, "", "1", "energy minus what the ledger of work and heat says, over the largest energy or work so far; of one body only while it meets no wall", NULL, body_energy_error, NULL, FW_NEEDS_NO_POSITIONS},
    {"kinetic-fraction", FW_SCOPE_BODY, "", "1", "energy of the motion of the centre of mass over all energy", NULL, kinetic_fraction, "the body has no energy", FW_NEEDS_NO_POSITIONS},
    {"momentum", FW_SCOPE_BODIES, "x y", "momentum", "sum over all particles", NULL, momentum, NULL, FW_NEEDS_NO_POSITIONS},
    {"momentum-error", FW_SCOPE_BODIES, "x y", "momentum", "momentum minus what the ledger of impulses says; of one body only while it meets no wall", NULL, momentum_error, NULL, FW_NEEDS_NO_POSITIONS},
    {"angular-momentum", FW_SCOPE_BODY, "", "angular momentum", "about the origin of the coordinates", NULL, angular_momentum, NULL, FW_NEEDS_NOTHING},
    {"momentum-ratio", FW_SCOPE_BODIES, "", "1", "size of the momentum over that at the start", NULL, momentum_ratio, "it started without momentum, but for rounding", FW_NEEDS_NO_POSITIONS},
    {"mean-velocity", FW_SCOPE_BODY, "x y", "length/time", "momentum over mass, both of the whole body", NULL, mean_velocity, NULL, FW_NEEDS_NO_POSITIONS},
    {"external-work", FW_SCOPE_SCENE, "", "energy", "work of all external forces since the start", NULL, external_work, NULL, FW_NEEDS_NO_POSITIONS},
    {"wall-work", FW_SCOPE_SCENE, "", "energy", "work of all moving walls since the start", NULL, wall_work, NULL, FW_NEEDS_NO_POSITIONS},
    {"wall-energy", FW_SCOPE_SCENE, "", "energy", "stored in the springs of penalty walls", NULL, wall_energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"dissipated", FW_SCOPE_SCENE, "", "energy", "taken by damping and fracture since the start", NULL, dissipated, NULL, FW_NEEDS_NO_POSITIONS},
    {"friction-heat", FW_SCOPE_SCENE, "", "energy", "of friction since the start, at walls and between bodies", NULL, friction_heat, NULL, FW_NEEDS_NO_POSITIONS},
    {"thermostat-heat", FW_SCOPE_SCENE, "", "energy", "brought by the noise of the heat bath since the start; what its damping took is in `dissipated`", NULL, thermostat_heat, NULL, FW_NEEDS_NO_POSITIONS},
    {"fracture-energy", FW_SCOPE_BODY, "", "energy", "taken by breaking links since the start", NULL, fracture_energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"centre-of-mass", FW_SCOPE_BODY, "x y", "length", "weighted by mass", NULL, centre_of_mass, NULL, FW_NEEDS_NO_POSITIONS},
    {"position", FW_SCOPE_SITE, "x y", "length", "of one particle", NULL, position, NULL, FW_NEEDS_NOTHING},
    {"displacement", FW_SCOPE_SITE, "x y", "length", "of one particle from its place in the lattice, or from where it was placed", NULL, displacement, NULL, FW_NEEDS_NOTHING},
    {"elongation", FW_SCOPE_BODY, "x y", "length", "displacement of the last particle minus that of the first", NULL, elongation, NULL, FW_NEEDS_NOTHING},
    {"return-error", FW_SCOPE_BODY, "", "length", "largest distance of a particle from its start, in x or y", NULL, return_error, NULL, FW_NEEDS_NOTHING},
    {"mean-square-displacement", FW_SCOPE_BODY, "", "length^2", "of all particles from where they started", NULL, mean_square_displacement, NULL, FW_NEEDS_NOTHING},
    {"rotation", FW_SCOPE_BODY, "", "degrees", "by which the body has turned since the start, -180 to 180", NULL, rotation, NULL, FW_NEEDS_NOTHING},
    {"penetration", FW_SCOPE_BODIES, "", "length", "how deep any particle lies behind a wall", NULL, penetration, NULL, FW_NEEDS_NOTHING},
    {"unresolved", FW_SCOPE_SCENE, "", "1", "contacts since the start in which no consistent set of walls was found and the particle was held fast", NULL, unresolved, NULL, FW_NEEDS_NOTHING},
    {"reaction", FW_SCOPE_WALL, "x y", "force", "[F(t) + F(t-1)]/2 of the wall on all bodies, of the last step and the one before it", NULL, reaction, NULL, FW_NEEDS_NO_POSITIONS},
    {"wall-impulse", FW_SCOPE_WALL, "x y", "momentum", "of the wall on all bodies since the start", NULL, wall_impulse, NULL, FW_NEEDS_NO_POSITIONS},
    {"friction-ratio", FW_SCOPE_WALL, "", "1", "impulse of a straight wall along its tangent over that along its normal, since the start", NULL, friction_ratio, "nothing has pressed on the wall", FW_NEEDS_NOTHING},
    {"contacts", FW_SCOPE_WALL, "", "1", "particles that the wall held in the last step", NULL, contacts, NULL, FW_NEEDS_NO_POSITIONS},
    {"contacts-so-far", FW_SCOPE_WALL, "", "1", "the same, summed over all steps", NULL, contacts_so_far, NULL, FW_NEEDS_NO_POSITIONS},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
