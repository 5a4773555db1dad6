/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_automaton.c - elastic automata from bodies of a scenario, and the modes they start with.
 * Keeps no state. Start reading at fw_build_automaton(). */
#include "experiments/setup/build_automaton.h"

#include "experiments/setup/build.h"
#include "experiments/setup/solids.h"

#include <math.h>
#include <stdlib.h>

/* The body without its starting state. */
static fw_elastic_automaton_def def_of(const fw_scenario *scenario, int number,
                                       const fw_sites *sites)
{
    static const fw_boundary_rule rules[] = {[FW_EDGES_BOND] = FW_BOUNDARY_BOND,
                                             [FW_EDGES_TRAPEZOID] = FW_BOUNDARY_TRAPEZOID,
                                             [FW_EDGES_MIRROR] = FW_BOUNDARY_MIRROR,
                                             [FW_EDGES_PERIODIC] = FW_BOUNDARY_BOND};
    const fw_scenario_body *body = &scenario->bodies[number];
    const fw_scenario_automaton *material = &scenario->materials[body->material].automaton;
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = sites;
    def.lattice = body->lattice;
    def.speeds = material->speeds;
    def.boundary = rules[material->boundary];
    if (material->boundary == FW_EDGES_PERIODIC) {
        def.period_columns = body->shape.last_column - body->shape.first_column + 1;
        def.period_rows = body->shape.last_row - body->shape.first_row + 1;
    }
    def.black_is_odd = material->black;
    def.reflection = 1 - material->damping;
    if (material->break_at > 0) def.break_at = material->break_at;
    return def;
}

/* The amplitude of a mode of one frequency is anything along its line: turned to a real positive x
 * of white, or y where x is nothing. */
static void turn_phase(fw_automaton_mode *mode)
{
    const double complex *white = mode->white;
    const double complex leading = cabs(white[0]) > 1e-6 ? white[0] : white[1];
    const double complex turn = conj(leading) / cabs(leading);
    for (int axis = 0; axis < 2; ++axis) {
        mode->black[axis] *= turn;
        mode->white[axis] *= turn;
    }
}

/* Where both branches run alike (Chopard's), any polarisation does: the fast one is taken along the
 * wave vector, the slow one across, as for all other automata at long waves. */
static void separate_twins(const fw_automaton_mode both[FW_MODES], fw_vec2 along,
                           fw_automaton_mode *mode)
{
    double complex black[2] = {0, 0};
    for (int m = 0; m < FW_MODES; ++m) {
        const double complex part =
            conj(both[m].white[0]) * along.x + conj(both[m].white[1]) * along.y;
        for (int axis = 0; axis < 2; ++axis) black[axis] += part * both[m].black[axis];
    }
    for (int axis = 0; axis < 2; ++axis) mode->black[axis] = black[axis];
    mode->white[0] = along.x;
    mode->white[1] = along.y;
}

fw_status fw_build_automaton_mode(const fw_scenario_automaton *material, const fw_lattice *lattice,
                                  fw_vec2 wave, int branch, fw_automaton_mode *mode,
                                  fw_error *error)
{
    fw_automaton_matrices matrices;
    fw_automaton_mode both[FW_MODES];
    FW_TRY(fw_automaton_matrices_make(&matrices, material->speeds, lattice->angle, error));
    FW_TRY(fw_automaton_modes(&matrices, wave, both, error));
    *mode = both[branch];
    if (fabs(both[FW_FAST].squared - both[FW_SLOW].squared) < 1e-12) {
        const double c = cos(lattice->angle), s = sin(lattice->angle), size = hypot(wave.x, wave.y);
        const fw_vec2 ahead = {(c * wave.x - s * wave.y) / size, (s * wave.x + c * wave.y) / size};
        separate_twins(both, branch == FW_FAST ? ahead : fw_vec2_turn(ahead), mode);
    }
    turn_phase(mode);
    return FW_OK;
}

static fw_status add_mode(const fw_scenario *scenario, int number, const fw_pattern *pattern,
                          const fw_sites *sites, fw_vec2 *values, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const fw_scenario_automaton *material = &scenario->materials[body->material].automaton;
    fw_automaton_mode mode;
    FW_TRY(fw_build_automaton_mode(material, &body->lattice, pattern->wave_vector, pattern->branch,
                                   &mode, error));
    fw_vec2 *wave = fw_array_zeroed((size_t)sites->count, sizeof *wave);
    int *particles = NULL, count = 0;
    fw_status status =
        wave ? fw_selection_particles(&pattern->sites, sites, &particles, &count, error)
             : fw_fail_memory(error, "a wave");
    if (status == FW_OK) {
        fw_automaton_mode_fill(mode.black, mode.white, pattern->wave_vector,
                               pattern->size * cexp(I * pattern->phase), sites, material->black,
                               wave);
        for (int k = 0; k < count; ++k)
            values[particles[k]] = fw_vec2_add(values[particles[k]], wave[particles[k]]);
    }
    free(particles);
    free(wave);
    return status;
}

static fw_status fill_start(const fw_scenario *scenario, int number, const fw_sites *sites,
                            fw_vec2 *displacement, fw_vec2 *velocity, bool *modes, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const uint64_t seed = (uint64_t)scenario->run.seed;
    for (int p = 0; velocity && p < sites->count; ++p) velocity[p] = body->velocity;
    FW_TRY(fw_build_patterns(&body->displacement, sites, &body->lattice, seed,
                             fw_build_displacement_stream(number), displacement, error));
    FW_TRY(fw_build_patterns(&body->velocities, sites, &body->lattice, seed,
                             fw_build_velocity_stream(number), velocity, error));
    *modes = false;
    for (int n = 0; n < body->displacement.count; ++n) {
        if (body->displacement.item[n].kind != FW_PATTERN_MODE) continue;
        FW_TRY(add_mode(scenario, number, &body->displacement.item[n], sites, displacement, error));
        *modes = true;
    }
    return FW_OK;
}

/* White cells of a body that starts at rest lie at the mean of their black neighbours: one that is
 * displaced alone would lose its displacement. */
static fw_status refuse_lone_white(const fw_scenario *scenario, int number, const fw_sites *sites,
                                   const fw_vec2 *displacement, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const int black = scenario->materials[body->material].automaton.black;
    for (int p = 0; p < sites->count; ++p) {
        const fw_site site = sites->site[p];
        const bool displaced = displacement[p].x != 0 || displacement[p].y != 0;
        if (!displaced || ((site.i + site.j) & 1) == black) continue;
        bool alone = true;
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            const int next = fw_sites_find(sites, fw_site_neighbour(site, d));
            if (next >= 0) alone &= displacement[next].x == 0 && displacement[next].y == 0;
        }
        if (alone)
            return fw_fail(
                error, FW_BAD_INPUT,
                "site [%d, %d] is displaced and its neighbours are not, but it is white, "
                "and white cells start where their black neighbours put them; expected "
                "'displaced-as-given: true', or the other colour",
                site.i, site.j);
    }
    return FW_OK;
}

fw_status fw_build_automaton(const fw_scenario *scenario, int number, const fw_sites *sites,
                             fw_solid **solid, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    fw_elastic_automaton_def def = def_of(scenario, number, sites);
    const bool displaced = body->displacement.count > 0, varies = body->velocities.count > 0;
    fw_vec2 *displacement =
        displaced ? fw_array_zeroed((size_t)sites->count, sizeof *displacement) : NULL;
    fw_vec2 *velocity = varies ? fw_array_zeroed((size_t)sites->count, sizeof *velocity) : NULL;
    bool modes = false;
    fw_status status =
        (displacement || !displaced) && (velocity || !varies)
            ? fill_start(scenario, number, sites, displacement, velocity, &modes, error)
            : fw_fail_memory(error, "the starting state of a body");
    const bool as_given = body->displaced_as_given || modes;
    if (status == FW_OK && displaced && !as_given)
        status = refuse_lone_white(scenario, number, sites, displacement, error);
    if (status == FW_OK) {
        def.displacement = displacement;
        def.velocity = velocity;
        def.drift = body->velocity;
        def.displaced_as_given = as_given;
        status = fw_elastic_automaton_create(solid, &def, error);
    }
    free(displacement);
    free(velocity);
    return fw_build_fail(scenario, number, status, error);
}

/* A body that would grow has been refused before. */
static fw_status print_limits(FILE *out, const fw_start *start, int *warnings, fw_error *error)
{
    static const char *const edges[] = {[FW_EDGES_BOND] = "bond",
                                        [FW_EDGES_TRAPEZOID] = "trapezoid",
                                        [FW_EDGES_MIRROR] = "mirror",
                                        [FW_EDGES_PERIODIC] = "periodic"};
    const fw_scenario_body *body = &start->scenario->bodies[start->body];
    const fw_scenario_automaton *material = &start->scenario->materials[body->material].automaton;
    const fw_automaton_speeds c = material->speeds;
    (void)warnings;
    (void)error;
    fprintf(out,
            "  %-14s stable: c1^2 + c2^2 = %.6g, expected at most 2; boundary %s, under which this "
            "body does not grow%s\n",
            body->name, c.transverse * c.transverse + c.coupling * c.coupling,
            edges[material->boundary],
            material->boundary == FW_EDGES_MIRROR ? " but keeps neither energy nor momentum" : "");
    return FW_OK;
}

const fw_solid_kind fw_automaton_solid = {.model = &fw_elastic_automaton_model,
                                          .bytes_per_particle = 225,
                                          .build = fw_build_automaton,
                                          .print_limits = print_limits};
