/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particles.c - movable lattice particles: building, changing, and the model's table.
 * State: that of langevin.c, and the return amplitude of each body. Invariant between steps: the
 * neighbour lists hold for the present positions. The step is in langevin.c, the forces are in
 * particle_forces.c. Start reading at fw_particles_create(). */
#include "core/particles/particles.h"

#include "particle_forces.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

fw_particle_group_def fw_particle_group_def_default(void)
{
    return (fw_particle_group_def){
        .name = "body", .mass = 1, .strength = 1, .return_force = fw_return_force_default()};
}

fw_particles_def fw_particles_def_default(void)
{
    return (fw_particles_def){.potential = fw_pair_potential_default(),
                              .strength_across = 1,
                              .controls = {.time_step = 0.005},
                              .overlap_energy = 100,
                              .bond_radius = 1.25,
                              .margin = 0.75};
}

/* --- life --- */

static void destroy(fw_solid *solid)
{
    if (!solid) return;
    fw_particles *particles = (fw_particles *)solid;
    for (int g = 0; particles->groups && g < particles->group_count; ++g)
        free((char *)particles->groups[g].name);
    free(particles->groups);
    free(particles->amplitudes);
    free(particles->group_of);
    fw_neighbour_lists_destroy(particles->lists);
    free(particles->first_x);
    free(particles->first_y);
    free(particles->second_x);
    free(particles->second_y);
    free(particles->sum_cosine);
    free(particles->sum_sine);
    for (int v = 0; v < 4; ++v) free(particles->virial[v]);
    for (int a = 0; a < FW_SUMS_MAX; ++a) free(particles->in_lists_order[a]);
    if (particles->energies) free(particles->energies->values);
    free(particles->energies);
    free(particles->other_links);
    fw_langevin_release(&particles->langevin);
    free(particles);
}

static fw_energies energies(const fw_solid *solid)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    fw_langevin_known *known = langevin->known;
    if (!known->has_elastic)
        known->elastic = fw_array_sum(fw_particles_own_energies((const fw_particles *)solid),
                                      (size_t)solid->count);
    known->has_elastic = true;
    return (fw_energies){.kinetic = fw_langevin_kinetic_energy(langevin),
                         .elastic = known->elastic};
}

static void state(fw_solid *solid, fw_state_list *list)
{
    fw_particles *particles = (fw_particles *)solid;
    fw_langevin_state(solid, list);
    fw_state_list_add(list, "return-amplitude", FW_F64, (size_t)particles->group_count,
                      particles->amplitudes);
}

static fw_status refresh(fw_solid *solid, fw_error *error)
{
    fw_particles *particles = (fw_particles *)solid;
    for (int g = 0; g < particles->group_count; ++g) {
        particles->groups[g].return_force.amplitude = particles->amplitudes[g];
        particles->groups[g].turn = (fw_turn){1, 0};
    }
    return fw_langevin_refresh(solid, error);
}

static fw_status restored(fw_solid *solid, fw_error *error)
{
    fw_particles *particles = (fw_particles *)solid;
    for (int g = 0; g < particles->group_count; ++g) {
        fw_return_force found = particles->groups[g].return_force;
        found.amplitude = particles->amplitudes[g];
        FW_TRY(fw_return_force_check(&found, error));
    }
    FW_TRY(fw_langevin_restored(solid, error));
    return refresh(solid, error);
}

const fw_solid_model fw_particles_model = {
    .name = "movable-particles",
    FW_LANGEVIN_OPERATIONS,
    .destroy = destroy,
    .energies = energies,
    .state = state,
    .restored = restored,
    .parts = fw_particles_parts,
    .list_links = fw_particles_list_links,
    .fields = fw_particle_fields,
    .solid_between_links = true,
};

bool fw_solid_is_particles(const fw_solid *solid)
{
    return solid->model == &fw_particles_model;
}

static fw_particles *particles_of(fw_solid *solid)
{
    assert(fw_solid_is_particles(solid));
    return (fw_particles *)solid;
}

static fw_status fill_group(fw_particles *particles, int g, const fw_particle_group_def *def,
                            int first, fw_error *error)
{
    fw_langevin *langevin = &particles->langevin;
    fw_particle_group *group = &particles->groups[g];
    *group = (fw_particle_group){.name = strdup(def->name),
                                 .first = first,
                                 .count = def->count,
                                 .strength = def->strength,
                                 .return_force = def->return_force,
                                 .axes = {1, 0},
                                 .turn = {1, 0}};
    if (!group->name) return fw_fail_memory(error, "the name of a body");
    particles->amplitudes[g] = def->return_force.amplitude;
    if (def->return_force.axes != FW_AXES_COROTATING) {
        const double turned = def->return_force.fold * def->return_force.angle;
        group->axes = (fw_phase){cos(turned), sin(turned)};
    }
    for (int k = 0; k < def->count; ++k) {
        const int i = first + k;
        langevin->head.x[i] = def->positions[k].x;
        langevin->head.y[i] = def->positions[k].y;
        langevin->mass[i] = def->mass;
        if (def->velocities) {
            langevin->velocity_x[i] = def->velocities[k].x;
            langevin->velocity_y[i] = def->velocities[k].y;
        }
        particles->group_of[i] = g;
    }
    return FW_OK;
}

static bool allocate_arrays(fw_particles *particles, bool turning)
{
    const size_t count = (size_t)particles->langevin.head.count;
    const size_t groups = (size_t)particles->group_count;
    particles->groups = calloc(groups, sizeof *particles->groups);
    particles->amplitudes = fw_array_of_doubles(groups);
    particles->group_of = fw_array_zeroed(count, sizeof *particles->group_of);
    bool complete = particles->groups && particles->amplitudes && particles->group_of;
    particles->energies = calloc(1, sizeof *particles->energies);
    if (!particles->energies) return false;
    particles->energies->values = fw_array_zeroed(count, sizeof(double));
    complete = complete && particles->energies->values;
    for (int v = 0; v < 4; ++v) {
        particles->virial[v] = fw_array_zeroed(count, sizeof(double));
        complete = complete && particles->virial[v];
    }
    if (!turning) return complete;
    double **parts[] = {&particles->first_x,  &particles->first_y,    &particles->second_x,
                        &particles->second_y, &particles->sum_cosine, &particles->sum_sine};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; ++p) {
        *parts[p] = fw_array_of_doubles(count);
        complete = complete && *parts[p];
    }
    return complete;
}

/* As far as any force and any bond reaches. */
static double longest_reach(const fw_particles_def *def)
{
    double reach = fmax(def->potential.cut.outer, def->bond_radius);
    for (int g = 0; g < def->group_count; ++g)
        reach = fmax(reach, def->groups[g].return_force.cut.outer);
    return reach;
}

static fw_status list_neighbours(fw_particles *particles, const fw_particles_def *def,
                                 fw_error *error)
{
    int *counts = fw_array_allocate((size_t)def->group_count, sizeof *counts);
    if (!counts) return fw_fail_memory(error, "neighbour lists");
    for (int g = 0; g < def->group_count; ++g) counts[g] = def->groups[g].count;
    const fw_status status = fw_neighbour_lists_create(&particles->lists, counts, def->group_count,
                                                       longest_reach(def), def->margin, error);
    free(counts);
    return status;
}

static fw_status build(fw_particles *particles, const fw_particles_def *def, fw_error *error)
{
    bool turning = false;
    for (int g = 0; g < def->group_count; ++g)
        turning = turning || def->groups[g].return_force.axes != FW_AXES_LAB;
    fw_langevin *langevin = &particles->langevin;
    const int count = langevin->head.count;
    particles->group_count = def->group_count;
    if (!allocate_arrays(particles, turning))
        return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for %d particles", count);
    particles->potential = def->potential;
    particles->strength_across = def->group_count > 1 ? def->strength_across : 0;
    particles->bond_radius = def->bond_radius;
    int first = 0;
    for (int g = 0; g < def->group_count; ++g) {
        FW_TRY(fill_group(particles, g, &def->groups[g], first, error));
        first += def->groups[g].count;
    }
    FW_TRY(list_neighbours(particles, def, error));
    /* A body that flows brings any particle to its surface. */
    for (int i = 0; i < count; ++i) langevin->head.boundary[i] = i;
    langevin->head.boundary_count = count;
    langevin->seed = def->seed;
    langevin->find_forces = fw_particles_find_forces;
    langevin->hottest = fw_particles_hottest_at;
    fw_langevin_set_controls(langevin, &def->controls);
    FW_TRY(fw_langevin_start(langevin, error));
    FW_TRY(fw_langevin_check_heat(&langevin->head, &def->controls, error));
    const double closest = sqrt(fw_neighbour_lists_closest(particles->lists));
    FW_TRY(fw_particles_check_overlaps(particles, closest, def->overlap_energy, error));
    return fw_particles_check_start(particles, closest, error);
}

fw_status fw_particles_create(fw_solid **solid, const fw_particles_def *def, fw_error *error)
{
    *solid = NULL;
    FW_TRY(fw_particles_check(def, error));
    fw_particles *particles = calloc(1, sizeof *particles);
    if (!particles) return fw_fail_memory(error, "a solid of movable particles");
    int count = 0;
    for (int g = 0; g < def->group_count; ++g) count += def->groups[g].count;
    fw_status status = fw_langevin_create(&particles->langevin, &fw_particles_model, count, error);
    if (status == FW_OK) status = build(particles, def, error);
    if (status != FW_OK) {
        destroy(&particles->langevin.head);
        return status;
    }
    *solid = &particles->langevin.head;
    return FW_OK;
}

/* --- changing --- */

/* For one body, if its return force were `force`. */
static double present_limit(const fw_particles *particles, int g, const fw_return_force *force)
{
    const fw_particle_group *group = &particles->groups[g];
    return fw_particles_longest_time_step(&particles->potential,
                                          fmax(group->strength, particles->strength_across), force,
                                          particles->langevin.mass[group->first]);
}

fw_status fw_particles_set_controls(fw_solid *solid, const fw_langevin_controls *controls,
                                    fw_error *error)
{
    fw_particles *particles = particles_of(solid);
    FW_TRY(fw_langevin_check(controls, error));
    for (int g = 0; g < particles->group_count; ++g)
        FW_TRY(fw_particles_check_time_step(
            controls->time_step, present_limit(particles, g, &particles->groups[g].return_force),
            error));
    FW_TRY(fw_langevin_check_heat(solid, controls, error));
    fw_langevin_set_controls(&particles->langevin, controls);
    return FW_OK;
}

fw_status fw_particles_set_damping(fw_solid *solid, double damping, fw_error *error)
{
    fw_langevin_controls controls = particles_of(solid)->langevin.controls;
    controls.damping = damping;
    return fw_particles_set_controls(solid, &controls, error);
}

fw_status fw_particles_set_temperature(fw_solid *solid, double temperature, fw_error *error)
{
    fw_langevin_controls controls = particles_of(solid)->langevin.controls;
    controls.temperature = temperature;
    return fw_particles_set_controls(solid, &controls, error);
}

fw_status fw_particles_set_amplitude(fw_solid *solid, int group, double amplitude, fw_error *error)
{
    fw_particles *particles = particles_of(solid);
    fw_return_force changed = particles->groups[group].return_force;
    changed.amplitude = amplitude;
    FW_TRY(fw_return_force_check(&changed, error));
    FW_TRY(fw_particles_check_time_step(particles->langevin.controls.time_step,
                                        present_limit(particles, group, &changed), error));
    particles->amplitudes[group] = amplitude;
    return refresh(solid, error);
}

void fw_particles_draw_velocities(fw_solid *solid, int group, double temperature)
{
    fw_particles *particles = particles_of(solid);
    const int first = group < 0 ? 0 : particles->groups[group].first;
    const int count = group < 0 ? solid->count : particles->groups[group].count;
    fw_langevin_draw_velocities(solid, first, count, temperature);
}

/* --- reading --- */

static const fw_particles *read_only(const fw_solid *solid)
{
    assert(fw_solid_is_particles(solid));
    return (const fw_particles *)solid;
}

int fw_particles_group_count(const fw_solid *solid)
{
    return read_only(solid)->group_count;
}

const fw_particle_group *fw_particles_group(const fw_solid *solid, int group)
{
    return &read_only(solid)->groups[group];
}

int fw_particles_find_group(const fw_solid *solid, const char *name)
{
    const fw_particles *particles = read_only(solid);
    for (int g = 0; g < particles->group_count; ++g)
        if (strcmp(particles->groups[g].name, name) == 0) return g;
    return -1;
}

int fw_particles_group_of(const fw_solid *solid, int particle)
{
    return read_only(solid)->group_of[particle];
}

const fw_neighbour_lists *fw_particles_neighbours(const fw_solid *solid)
{
    return read_only(solid)->lists;
}

const fw_langevin_controls *fw_particles_controls(const fw_solid *solid)
{
    return &read_only(solid)->langevin.controls;
}

double fw_particles_bond_radius(const fw_solid *solid)
{
    return read_only(solid)->bond_radius;
}
