/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_boltzmann.c - LB solids from bodies of a scenario. Keeps no state. Start reading at
 * fw_build_boltzmann(). */
#include "experiments/setup/build.h"
#include "experiments/setup/solids.h"

#include "core/array.h"
#include "core/boltzmann/lb_solid.h"

#include <math.h>
#include <stdlib.h>

/* Arrays per site that are only needed while a solid is made. */
typedef struct start_values {
    fw_vec2 *displacement, *velocity;
    fw_sym2 *rest_mass, *stiffness[2];
    bool *selected;
} start_values;

static void release_start(start_values *start)
{
    free(start->displacement);
    free(start->velocity);
    free(start->rest_mass);
    free(start->stiffness[FW_EAST]);
    free(start->stiffness[FW_NORTH]);
    free(start->selected);
}

/* What is the same at all sites has no array. */
static bool allocate_start(start_values *start, const fw_scenario_body *body, size_t count)
{
    const bool varies[] = {body->displacement.count > 0, body->velocities.count > 0,
                           body->rest_mass.count > 0, body->link_stiffness.count > 0};
    if (varies[0]) start->displacement = fw_array_zeroed(count, sizeof *start->displacement);
    if (varies[1]) start->velocity = fw_array_zeroed(count, sizeof *start->velocity);
    if (varies[2]) start->rest_mass = fw_array_zeroed(count, sizeof *start->rest_mass);
    for (int d = FW_EAST; d <= FW_NORTH && varies[3]; ++d)
        start->stiffness[d] = fw_array_zeroed(count, sizeof *start->stiffness[d]);
    start->selected = calloc(count, sizeof *start->selected);
    return start->selected && (start->displacement || !varies[0]) &&
           (start->velocity || !varies[1]) && (start->rest_mass || !varies[2]) &&
           ((start->stiffness[FW_EAST] && start->stiffness[FW_NORTH]) || !varies[3]);
}

static fw_status mark_selected(const fw_selection *selection, const fw_sites *sites, bool *selected,
                               fw_error *error)
{
    int *particles, count;
    FW_TRY(fw_selection_particles(selection, sites, &particles, &count, error));
    for (int l = 0; l < sites->count; ++l) selected[l] = false;
    for (int k = 0; k < count; ++k) selected[particles[k]] = true;
    free(particles);
    return FW_OK;
}

static bool is_chosen(fw_link_choice choice, bool here, bool there)
{
    switch (choice) {
    case FW_LINKS_INSIDE:
        return here && there;
    case FW_LINKS_ACROSS:
        return here != there;
    case FW_LINKS_TOUCHING:
        return here || there;
    }
    return false;
}

static fw_status fill_masses_and_links(const fw_scenario_body *body, const fw_sites *sites,
                                       start_values *start, fw_error *error)
{
    for (int n = 0; n < body->rest_mass.count; ++n) {
        FW_TRY(mark_selected(&body->rest_mass.item[n].sites, sites, start->selected, error));
        for (int l = 0; l < sites->count; ++l)
            if (start->selected[l]) start->rest_mass[l] = body->rest_mass.item[n].value;
    }
    for (int n = 0; n < body->link_stiffness.count; ++n) {
        const fw_replacement *change = &body->link_stiffness.item[n];
        FW_TRY(mark_selected(&change->sites, sites, start->selected, error));
        for (int l = 0; l < sites->count; ++l)
            for (int d = FW_EAST; d <= FW_NORTH; ++d) {
                int m = fw_sites_find(sites, fw_site_neighbour(sites->site[l], d));
                if (m >= 0 && is_chosen(change->links, start->selected[l], start->selected[m]))
                    start->stiffness[d][l] = change->value;
            }
    }
    return FW_OK;
}

static fw_status fill_start(const fw_scenario *scenario, int number, const fw_sites *sites,
                            start_values *start, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const fw_scenario_boltzmann *material = &scenario->materials[body->material].boltzmann;
    const uint64_t seed = (uint64_t)scenario->run.seed;
    for (int l = 0; l < sites->count; ++l) {
        if (start->velocity) start->velocity[l] = body->velocity;
        if (start->rest_mass) start->rest_mass[l] = material->rest_mass;
        for (int d = FW_EAST; d <= FW_NORTH; ++d)
            if (start->stiffness[d]) start->stiffness[d][l] = material->link_stiffness;
    }
    FW_TRY(fw_build_patterns(&body->displacement, sites, &body->lattice, seed,
                             fw_build_displacement_stream(number), start->displacement, error));
    FW_TRY(fw_build_patterns(&body->velocities, sites, &body->lattice, seed,
                             fw_build_velocity_stream(number), start->velocity, error));
    return fill_masses_and_links(body, sites, start, error);
}

/* Grips, and walls that stick, prescribe velocities (fw_solid_model.carry). */
static bool may_be_carried(const fw_scenario *scenario)
{
    for (int w = 0; w < scenario->wall_count; ++w)
        if (scenario->walls[w].def.surface.law == FW_STICK) return true;
    return scenario->grip_count > 0;
}

static fw_status build(const fw_scenario *scenario, int number, const fw_sites *sites,
                       fw_solid **solid, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const fw_scenario_boltzmann *material = &scenario->materials[body->material].boltzmann;
    start_values start = {0};
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_status status = FW_OK;
    if (!allocate_start(&start, body, (size_t)sites->count))
        status = fw_fail_memory(error, "the starting state of a body");
    if (status == FW_OK) status = fill_start(scenario, number, sites, &start, error);
    if (status == FW_OK) {
        def.sites = sites;
        def.lattice = body->lattice;
        def.mu = 1 - material->damping;
        def.rest_mass = material->rest_mass;
        def.rest_masses = start.rest_mass;
        def.stiffness = material->link_stiffness;
        def.stiffness_east = start.stiffness[FW_EAST];
        def.stiffness_north = start.stiffness[FW_NORTH];
        if (!may_be_carried(scenario)) def.form = FW_LB_DISPLACEMENTS;
        if (material->break_at > 0) def.break_at = material->break_at;
        def.displacement = start.displacement;
        def.velocity = start.velocity;
        def.drift = body->velocity;
        status = fw_lb_solid_create(solid, &def, error);
        status = fw_build_fail(scenario, number, status, error);
    }
    release_start(&start);
    return status;
}

/* The largest speed of a particle at the start. */
static fw_status find_speed(const fw_start *start, double *speed, fw_error *error)
{
    const fw_body_range *range = start->range;
    double *x = fw_array_of_doubles((size_t)start->solid->count);
    double *y = fw_array_of_doubles((size_t)start->solid->count);
    *speed = 0;
    if (x && y) {
        start->solid->model->velocities(start->solid, x, y);
        for (int l = range->first; l < range->first + range->count; ++l)
            *speed = fmax(*speed, hypot(x[l], y[l]));
    }
    free(x);
    free(y);
    return x && y ? FW_OK : fw_fail_memory(error, "the velocities at the start");
}

static fw_status print_limits(FILE *out, const fw_start *start, int *warnings, fw_error *error)
{
    const fw_scenario_body *body = &start->scenario->bodies[start->body];
    const double damping = start->scenario->materials[body->material].boltzmann.damping;
    double speed, fastest = FW_LB_FASTEST * body->lattice.spacing;
    FW_TRY(find_speed(start, &speed, error));
    fprintf(out, "  %-14s stable: damping %g, expected below 0.5\n", body->name, damping);
    fprintf(out,
            "  %-14s largest speed at the start %.3g, where something is hit it should stay below "
            "%.3g\n",
            "", speed, fastest);
    if (speed <= fastest || !start->meets) return FW_OK;
    *warnings += 1;
    fprintf(out, "  %-14s warning: at such a speed particles pass each other where the body hits\n",
            "");
    return FW_OK;
}

const fw_solid_kind fw_boltzmann_solid = {.model = &fw_lb_solid_model,
                                          .bytes_per_particle = 265,
                                          .fastest = FW_LB_FASTEST,
                                          .build = build,
                                          .print_limits = print_limits};
