/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analysis_bodies.c - bodies of the elastic automaton by themselves: whether one would grow, and
 * whether Chopard's is its lattice Boltzmann reference. Keeps no state. Start reading at
 * fw_analysis_body(). */
#include "analysis_parts.h"

#include "contact/scene/scene.h"
#include "core/array.h"
#include "core/boltzmann/lb_solid.h"
#include "experiments/setup/build.h"
#include "experiments/setup/build_automaton.h"

#include <math.h>
#include <stdlib.h>

fw_status fw_analysis_body(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error)
{
    (void)scenario;
    static const fw_boundary_rule rules[] = {[FW_EDGES_BOND] = FW_BOUNDARY_BOND,
                                             [FW_EDGES_TRAPEZOID] = FW_BOUNDARY_TRAPEZOID,
                                             [FW_EDGES_MIRROR] = FW_BOUNDARY_MIRROR};
    const fw_scenario_analysis *what = analysis->what;
    fw_sites sites;
    FW_TRY(fw_sites_rectangle(&sites, what->rectangle[0], what->rectangle[1], error));
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = (fw_automaton_speeds){what->c1[0], what->c2[0]};
    def.boundary = rules[what->boundary];
    const fw_status status =
        fw_elastic_automaton_spectral_radius(&def, &analysis->spectral_radius, error);
    fw_sites_clear(&sites);
    return status;
}

/* --- the reference solid --- */

/* With black to move next, f_(i+2) = w - b on black and 0 on white is
 * the LB start of displacements u = (b, w) and velocities (-2 b, 2 w). */
static fw_status make_reference(fw_solid **reference, const fw_scenario *scenario, int number,
                                const fw_sites *sites, const fw_solid *automaton, fw_error *error)
{
    const size_t count = (size_t)sites->count;
    fw_vec2 *u = calloc(count, sizeof *u), *v = calloc(count, sizeof *v);
    fw_status status = u && v ? FW_OK : fw_fail_memory(error, "a lattice Boltzmann reference");
    if (status == FW_OK) {
        for (int p = 0; p < sites->count; ++p) {
            u[p] = fw_elastic_automaton_displacement(automaton, p);
            v[p] = fw_vec2_scale(fw_elastic_automaton_is_black(automaton, p) ? -2 : 2, u[p]);
        }
        const fw_scenario_body *body = &scenario->bodies[number];
        fw_lb_solid_def def = fw_lb_solid_def_default();
        def.sites = sites;
        def.lattice = body->lattice;
        const double a = 1 - scenario->materials[body->material].automaton.damping;
        def.mu = (1 + a) / 2;
        def.displacement = u;
        def.velocity = v;
        status = fw_lb_solid_create(reference, &def, error);
    }
    free(u);
    free(v);
    return status;
}

/* The walls of the scenario round one solid, which the scene takes over. */
static fw_status enclose(fw_scene **scene, const fw_scenario *scenario, fw_solid *solid,
                         fw_error *error)
{
    int body;
    const fw_status status = fw_scene_create(scene, (fw_vec2){0, 0}, INFINITY, error);
    if (status != FW_OK) {
        fw_solid_destroy(solid);
        return status;
    }
    FW_TRY(fw_scene_adopt_body(*scene, "body", solid, &body, error));
    for (int w = 0; w < scenario->wall_count; ++w) {
        fw_wall_def def = scenario->walls[w].def;
        if (def.path.period != 0 || def.path.velocity.x != 0 || def.path.velocity.y != 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "wall %s moves, expected walls at rest: the two solids count time in "
                           "different units",
                           def.name);
        FW_TRY(fw_scene_add_wall(*scene, &def, error));
    }
    return fw_scene_begin(*scene, error);
}

static fw_status compare(fw_analysis *analysis, fw_scene *one, fw_scene *other, fw_error *error)
{
    const int steps = (int)((analysis->what->ticks + 1) / 2);
    double *time =
        fw_analysis_add(analysis, "half-step", "half-steps", "of the automaton", steps, 0, error);
    double *apart = fw_analysis_add(analysis, "difference", "length",
                                    "largest distance of a cell from its reference, in x or y",
                                    steps, 0, error);
    if (!time || !apart) return FW_SYSTEM_FAILED;
    const fw_solid *a = fw_scene_observe_body(one, 0), *b = fw_scene_observe_body(other, 0);
    for (int step = 0; step < steps; ++step) {
        FW_TRY(fw_scene_step(one, error));
        for (int tick = 0; tick < 2; ++tick) FW_TRY(fw_scene_step(other, error));
        time[step] = 2 * (step + 1);
        for (int p = 0; p < a->count; ++p)
            apart[step] = fmax(apart[step], fmax(fabs(a->x[p] - b->x[p]), fabs(a->y[p] - b->y[p])));
        analysis->reference_error = fmax(analysis->reference_error, apart[step]);
    }
    return FW_OK;
}

fw_status fw_analysis_reference(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error)
{
    const int number = analysis->what->body;
    fw_sites sites;
    fw_solid *automaton = NULL, *reference = NULL;
    fw_scene *one = NULL, *other = NULL;
    FW_TRY(fw_scenario_sites(&scenario->bodies[number], &sites, error));
    fw_status status = fw_build_automaton(scenario, number, &sites, &automaton, error);
    if (status == FW_OK) {
        status = make_reference(&reference, scenario, number, &sites, automaton, error);
        if (status != FW_OK) fw_solid_destroy(automaton);
    }
    if (status == FW_OK) {
        status = enclose(&one, scenario, automaton, error);
        if (status == FW_OK)
            status = enclose(&other, scenario, reference, error);
        else
            fw_solid_destroy(reference);
    }
    if (status == FW_OK) status = compare(analysis, one, other, error);
    fw_scene_destroy(one);
    fw_scene_destroy(other);
    fw_sites_clear(&sites);
    return status;
}
