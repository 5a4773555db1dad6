/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solids.h - the table of all solids, as tests see them, and how a test makes and pushes one.
 * Start reading at the table. */
#ifndef FW_SOLIDS_H
#define FW_SOLIDS_H

#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/noise.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

#include <stdlib.h>

/* How a body starts; arrays per site, owned. */
typedef struct start {
    fw_sites sites;
    fw_lattice lattice;
    fw_vec2 *displacement, *velocity; /* displacement in spacings, velocity in units of sound */
    double loss;                      /* of momentum while sound runs one spacing */
} start;

typedef struct solid_kind {
    const char *name;
    fw_lattice_kind lattice;
    fw_solid *(*make)(const start *s);
    double transverse, longitudinal; /* speed of sound, in spacings per unit of time */
    double energy_error; /* part of the energy that rounding or the time step may take */
    double nonlinearity; /* part by which twice the force may not stretch twice as far */
    bool binds;          /* has an energy at rest, above which ringing is measured */
} solid_kind;

static inline fw_solid *checked(fw_status status, fw_solid *solid, const fw_error *error)
{
    if (status != FW_OK) fail_msg("%s", error->sentence);
    return solid;
}

static inline fw_vec2 *scaled(const start *s, double speed)
{
    fw_vec2 *velocity = malloc((size_t)s->sites.count * sizeof *velocity);
    for (int p = 0; p < s->sites.count; ++p) velocity[p] = fw_vec2_scale(speed, s->velocity[p]);
    return velocity;
}

/* M0 = .8: M = (.64 + 4)/2. */
#define LB_SOUND 0.65653216429861311
static inline fw_solid *make_any_boltzmann(const start *s, fw_lb_form form)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, LB_SOUND);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.rest_mass = fw_sym2_scalar(0.8);
    def.form = form;
    def.mu = 1 - s->loss * LB_SOUND / 2;
    def.displacement = s->displacement;
    def.velocity = velocity;
    const fw_status status = fw_lb_solid_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

static inline fw_solid *make_boltzmann(const start *s)
{
    return make_any_boltzmann(s, FW_LB_POPULATIONS);
}

static inline fw_solid *make_displaced(const start *s)
{
    return make_any_boltzmann(s, FW_LB_DISPLACEMENTS);
}

static inline fw_solid *make_any_automaton(const start *s, fw_automaton_speeds speeds,
                                           fw_boundary_rule boundary)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, speeds.transverse);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.speeds = speeds;
    def.boundary = boundary;
    def.reflection = 1 - s->loss * speeds.transverse;
    def.displacement = s->displacement;
    def.velocity = velocity;
    const fw_status status = fw_elastic_automaton_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

static inline fw_solid *make_automaton(const start *s)
{
    return make_any_automaton(s, (fw_automaton_speeds){0.9, 0.5}, FW_BOUNDARY_BOND);
}

static inline fw_solid *make_trapezoid(const start *s)
{
    return make_any_automaton(s, (fw_automaton_speeds){0.9, 0.5}, FW_BOUNDARY_TRAPEZOID);
}

static inline fw_solid *make_chopard(const start *s)
{
    return make_any_automaton(s, fw_automaton_chopard(), FW_BOUNDARY_BOND);
}

/* k1 = 10, k2 = 50, mass 1: c_T^2 = 3/2 (10 + 50/4), c_L^2 = 3/2 (10 + 3 50/4). */
#define LINEAR_SOUND 5.8094750193111255
static inline fw_solid *make_linear(const start *s)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, LINEAR_SOUND);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &s->sites;
    def.lattice = s->lattice;
    def.displacements = s->displacement;
    def.velocities = velocity;
    def.controls.time_step = 0.005;
    def.controls.damping = s->loss * LINEAR_SOUND;
    const fw_status status = fw_linear_lattice_create(&solid, &def, &error);
    free(velocity);
    return checked(status, solid, &error);
}

/* Lennard-Jones: U'' = 72, c_T^2 = 9/8 72/3, c_L^2 = 9/8 72, with no return force. */
#define PARTICLE_SOUND 5.1961524227066320
static inline fw_solid *make_particles(const start *s)
{
    fw_error error;
    fw_solid *solid;
    fw_vec2 *velocity = scaled(s, PARTICLE_SOUND);
    fw_vec2 *positions = malloc((size_t)s->sites.count * sizeof *positions);
    for (int p = 0; p < s->sites.count; ++p)
        positions[p] =
            fw_vec2_add(fw_lattice_position(&s->lattice, s->sites.site[p]), s->displacement[p]);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.name = "body";
    group.count = s->sites.count;
    group.positions = positions;
    group.velocities = velocity;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls.time_step = 0.005;
    def.controls.damping = s->loss * PARTICLE_SOUND;
    const fw_status status = fw_particles_create(&solid, &def, &error);
    free(velocity);
    free(positions);
    return checked(status, solid, &error);
}

/* Verlet's energy error is (omega dt)^2/8 of the ringing: .005 x 17 (20) of the stiffest bond. */
static const solid_kind kinds[] = {
    {"lattice Boltzmann", FW_SQUARE, make_boltzmann, LB_SOUND, LB_SOUND, 1e-12, 1e-9, false},
    {"displaced Boltzmann", FW_SQUARE, make_displaced, LB_SOUND, LB_SOUND, 1e-12, 1e-9, false},
    {"elastic automaton", FW_SQUARE, make_automaton, 0.9, 1.0295630140987001, 1e-12, 1e-9, false},
    {"automaton, trapezoid", FW_SQUARE, make_trapezoid, 0.9, 1.0295630140987001, 1e-12, 1e-9,
     false},
    {"Chopard's automaton", FW_SQUARE, make_chopard, 1.4142135623730951, 1.4142135623730951, 1e-12,
     1e-9, false},
    {"linear lattice", FW_HEXAGONAL, make_linear, LINEAR_SOUND, 8.4409715080670666, 3e-3, 1e-9,
     false},
    {"movable particles", FW_HEXAGONAL, make_particles, PARTICLE_SOUND, 9, 5e-3, 0.1, true},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* --- starts --- */

static inline start rectangle(const solid_kind *kind, int columns, int rows)
{
    start s = {.lattice = {.kind = kind->lattice, .spacing = 1}};
    assert_int_equal(fw_sites_rectangle(&s.sites, columns, rows, NULL), FW_OK);
    s.displacement = calloc((size_t)s.sites.count, sizeof *s.displacement);
    s.velocity = calloc((size_t)s.sites.count, sizeof *s.velocity);
    return s;
}

static inline void shake(start *s, double displacement, double velocity)
{
    for (int p = 0; p < s->sites.count; ++p) {
        s->displacement[p] = fw_vec2_scale(displacement, fw_noise_uniform(1, (uint32_t)p, 0, 1));
        s->velocity[p] = fw_vec2_scale(velocity, fw_noise_uniform(1, (uint32_t)p, 0, 2));
    }
}

static inline void release_start(start *s)
{
    fw_sites_clear(&s->sites);
    free(s->displacement);
    free(s->velocity);
}

static inline fw_solid *made(const solid_kind *kind, start *s)
{
    fw_solid *solid = kind->make(s);
    release_start(s);
    return solid;
}

static inline fw_solid *shaken(const solid_kind *kind, int columns, int rows, double loss)
{
    start s = rectangle(kind, columns, rows);
    shake(&s, 0.02, 0.02);
    s.loss = loss;
    return made(kind, &s);
}

/* Ticks in which transverse sound runs so many spacings. */
static inline int ticks_for(const solid_kind *kind, const fw_solid *solid, double spacings)
{
    const int ticks = (int)ceil(spacings / kind->transverse / solid->tick);
    return ticks + ticks % solid->model->ticks_per_step;
}

static inline double energy_of(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

/* Forces of the step, new at the start of each: an automaton keeps them for both of its ticks. */
static inline void push_at_random(fw_solid *solid, const solid_kind *kind, double size)
{
    const int64_t step = solid->ticks / solid->model->ticks_per_step;
    double *masses = fw_array_of_doubles((size_t)solid->count);
    solid->model->masses(solid, masses);
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p) {
        const fw_vec2 r = fw_noise_uniform(5, (uint32_t)p, (uint64_t)step, 3);
        const double weight = size * masses[p] * kind->transverse * kind->transverse;
        solid->external_x[p] = weight * r.x;
        solid->external_y[p] = weight * r.y;
    }
    free(masses);
}

#endif
