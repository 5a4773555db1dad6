/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_exact.c - running waves in closed form. Keeps no state. Start reading at
 * fw_plot_exact_load(). */
#include "plot_exact.h"

#include "experiments/setup/build_automaton.h"

#include <stdlib.h>
#include <string.h>

static bool is_exact(const fw_scenario *scenario, const fw_scenario_body *body)
{
    const fw_scenario_material *material = &scenario->materials[body->material];
    if (material->kind != FW_ELASTIC_AUTOMATON || body->displacement.count == 0 ||
        body->velocities.count > 0 || body->velocity.x != 0 || body->velocity.y != 0 ||
        material->automaton.boundary != FW_EDGES_PERIODIC)
        return false;
    for (int n = 0; n < body->displacement.count; ++n)
        if (body->displacement.item[n].kind != FW_PATTERN_MODE) return false;
    return true;
}

bool fw_plot_exact_exists(const fw_plot_result *result, const char *field)
{
    const fw_scenario *scenario = result->scenario;
    if (!field || (strcmp(field, "displacement-x") != 0 && strcmp(field, "displacement-y") != 0))
        return false;
    for (int b = 0; b < scenario->body_count; ++b)
        if (!is_exact(scenario, &scenario->bodies[b])) return false;
    return scenario->body_count > 0 && scenario->wall_count == 0 && scenario->force_count == 0 &&
           scenario->grip_count == 0 && scenario->run.reverse_at == 0;
}

/* Adds Re(a exp(i (k.s + omega t))) to the displacement of each cell s, a being that of its colour.
 */
static fw_status add_mode(const fw_scenario_body *body, const fw_scenario_automaton *material,
                          const fw_pattern *pattern, const fw_sites *sites, double time,
                          fw_vec2 *displacement, fw_error *error)
{
    fw_automaton_mode mode;
    FW_TRY(fw_build_automaton_mode(material, &body->lattice, pattern->wave_vector, pattern->branch,
                                   &mode, error));
    for (int n = 0; n < sites->count; ++n) {
        const fw_site s = sites->site[n];
        const bool black = ((s.i + s.j) % 2 != 0) == (material->black != 0);
        const double complex *a = black ? mode.black : mode.white;
        const double complex turn =
            pattern->size * cexp(I * (pattern->wave_vector.x * s.i + pattern->wave_vector.y * s.j +
                                      mode.frequency * time + pattern->phase));
        displacement[n].x += creal(a[0] * turn);
        displacement[n].y += creal(a[1] * turn);
    }
    return FW_OK;
}

static fw_status displace(fw_plot_view *view, const fw_plot_result *result, int body, double time,
                          bool along_x, fw_error *error)
{
    const fw_scenario_body *of = &result->scenario->bodies[body];
    const fw_scenario_automaton *material = &result->scenario->materials[of->material].automaton;
    const int first = result->playback->bodies[body].first;
    fw_sites sites;
    FW_TRY(fw_scenario_sites(of, &sites, error));
    fw_vec2 *displacement = calloc((size_t)sites.count + 1, sizeof *displacement);
    fw_status status =
        displacement ? FW_OK : fw_fail_memory(error, "the exact solution of a picture");
    for (int n = 0; n < of->displacement.count && status == FW_OK; ++n)
        status =
            add_mode(of, material, &of->displacement.item[n], &sites, time, displacement, error);
    for (int n = 0; n < sites.count && status == FW_OK; ++n) {
        view->x[first + n] = result->rest_x[first + n] + displacement[n].x;
        view->y[first + n] = result->rest_y[first + n] + displacement[n].y;
        view->field[first + n] = along_x ? displacement[n].x : displacement[n].y;
    }
    free(displacement);
    fw_sites_clear(&sites);
    return status;
}

fw_status fw_plot_exact_load(fw_plot_view *view, const fw_plot_result *result, int64_t frame,
                             const char *field, fw_error *error)
{
    char name[sizeof view->name];
    FW_TRY(fw_plot_view_load(view, result, frame, field, error));
    memcpy(name, view->name, sizeof name);
    snprintf(view->name, sizeof view->name, "exact, %.*s", (int)sizeof view->name - 8, name);
    for (int b = 0; b < result->scenario->body_count; ++b)
        FW_TRY(displace(view, result, b, result->times[frame], strcmp(field, "displacement-x") == 0,
                        error));
    return FW_OK;
}
