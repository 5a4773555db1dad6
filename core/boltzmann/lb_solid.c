/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_solid.c - making an LB solid, its sums, and its table of operations; see lb_state.h.
 * State: a field per link end (`slot`), rest fields, positions; links and rest masses where links
 * break. Invariant: Eq 30 on every existing link. Start reading at fw_lb_solid_create(). */
#include "core/boltzmann/lb_solid.h"

#include "lb_displacements.h"
#include "lb_layout.h"
#include "lb_measure.h"
#include "lb_motion.h"
#include "lb_reach.h"
#include "lb_step.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

fw_lb_solid_def fw_lb_solid_def_default(void)
{
    return (fw_lb_solid_def){.lattice = {.kind = FW_SQUARE, .spacing = 1},
                             .mu = 1,
                             .stiffness = fw_sym2_scalar(1),
                             .break_at = INFINITY};
}

static bool is_finite(fw_sym2 m)
{
    return isfinite(m.xx) && isfinite(m.xy) && isfinite(m.yy);
}

static bool is_positive(fw_sym2 m)
{
    /* Not below DBL_MIN, so that the inverse is finite. */
    if (!(is_finite(m) && m.xx >= DBL_MIN && m.yy >= DBL_MIN)) return false;
    return m.xy == 0 || fw_sym2_determinant(m) > 0;
}

static bool is_scalar(fw_sym2 m)
{
    return m.xy == 0 && m.xx == m.yy;
}

static fw_sym2 rest_mass_of(const fw_lb_solid_def *def, int site)
{
    return def->rest_masses ? def->rest_masses[site] : def->rest_mass;
}

/* kappa of the link that leaves `site` to the east or north. */
static fw_sym2 stiffness_of(const fw_lb_solid_def *def, int site, int direction)
{
    const fw_sym2 *own = direction == FW_EAST ? def->stiffness_east : def->stiffness_north;
    return own ? own[site] : def->stiffness;
}

/* Sites with masses and stiffnesses that may be those of no site before: the first, where all are
 * the same. */
static int described(const fw_lb_solid_def *def)
{
    const bool vary = def->rest_masses || def->stiffness_east || def->stiffness_north;
    return vary || def->sites->count < 1 ? def->sites->count : 1;
}

static fw_status check_stiffness(fw_sym2 kappa, fw_site site, fw_error *error)
{
    if (!is_positive(kappa))
        return fw_fail(error, FW_BAD_INPUT,
                       "link stiffness %g at site [%d, %d], expected a positive number or a "
                       "positive definite matrix",
                       kappa.xx, site.i, site.j);
    if (!(fw_sym2_condition(kappa) <= FW_LB_CONDITION_MAX))
        return fw_fail(error, FW_BAD_INPUT,
                       "link stiffness [%.17g, %.17g, %.17g] at site [%d, %d] has the condition "
                       "number %.2g, expected at most %.2g: beyond it rounding takes energy and "
                       "momentum from the body",
                       kappa.xx, kappa.xy, kappa.yy, site.i, site.j, fw_sym2_condition(kappa),
                       FW_LB_CONDITION_MAX);
    return FW_OK;
}

static fw_status check_definition(const fw_lb_solid_def *def, fw_error *error)
{
    if (def->lattice.kind != FW_SQUARE)
        return fw_fail(error, FW_BAD_INPUT,
                       "an LB solid on a hexagonal lattice, expected a square one");
    if (!(def->lattice.spacing > 0 && isfinite(def->lattice.spacing)))
        return fw_fail(error, FW_BAD_INPUT, "spacing %g, expected a positive number",
                       def->lattice.spacing);
    if (!(def->mu > 0.5 && def->mu <= 1))
        return fw_fail(
            error, FW_BAD_INPUT,
            "damping factor mu %g, expected more than 0.5 (below it momentum would change sign "
            "each step) and at most 1",
            def->mu);
    if (!(def->break_at > 0))
        return fw_fail(error, FW_BAD_INPUT, "break-at %g, expected a positive stretch",
                       def->break_at);
    for (int l = 0; l < described(def); ++l) {
        fw_site site = def->sites->site[l];
        if (!is_finite(rest_mass_of(def, l)))
            return fw_fail(error, FW_BAD_INPUT, "rest mass of site [%d, %d] is not finite", site.i,
                           site.j);
        for (int d = FW_EAST; d <= FW_NORTH; ++d)
            FW_TRY(check_stiffness(stiffness_of(def, l, d), site, error));
    }
    return FW_OK;
}

static void choose_kernels(lb_solid *lb, const fw_lb_solid_def *def)
{
    lb->mu = def->mu;
    lb->break_at = def->break_at;
    lb->resting = isfinite(def->break_at); /* breaking makes rest mass */
    for (int l = 0; l < described(def); ++l) {
        fw_sym2 rest = rest_mass_of(def, l), east = stiffness_of(def, l, FW_EAST),
                north = stiffness_of(def, l, FW_NORTH);
        lb->resting |= rest.xx != 0 || rest.xy != 0 || rest.yy != 0;
        lb->matrix |= !is_scalar(rest) || !is_scalar(east) || !is_scalar(north);
        lb->weighted |= !is_scalar(east) || east.xx != 1 || !is_scalar(north) || north.xx != 1;
    }
    lb->displaced = def->form == FW_LB_DISPLACEMENTS && !lb->weighted && !isfinite(def->break_at) &&
                    lb_grid_pays(def->sites);
    lb->counted = lb->displaced && !def->rest_masses && !lb->matrix;
    lb->rest_square = fw_sym2_square(def->rest_mass).xx;
}

static fw_status allocate(lb_solid *lb, fw_error *error)
{
    fw_arena *arena = &lb->head.arena;
    const size_t count = (size_t)lb->head.count;
    const size_t chunks = (count + LB_CHUNK - 1) / LB_CHUNK;
    for (int d = 0; d < FW_DIRECTIONS && !lb->displaced; ++d) {
        FW_ARENA_ADD(arena, lb->slot_x[d], count);
        FW_ARENA_ADD(arena, lb->slot_y[d], count);
    }
    if (!lb->counted) {
        lb_add_matrices(arena, &lb->inverse, count, lb->matrix);
        lb_add_matrices(arena, &lb->mass, count, lb->matrix);
    }
    if (lb->resting) lb_add_matrices(arena, &lb->rest_mass, count, lb->matrix);
    if (lb->resting && !lb->displaced) {
        FW_ARENA_ADD(arena, lb->rest_x, count);
        FW_ARENA_ADD(arena, lb->rest_y, count);
    }
    for (int d = FW_EAST; d <= FW_NORTH && lb->weighted; ++d)
        lb_add_matrices(arena, &lb->stiffness[d], count, lb->matrix);
    FW_ARENA_ADD(arena, lb->north, count);
    FW_ARENA_ADD(arena, lb->south, count);
    FW_ARENA_ADD(arena, lb->present, count);
    if (isfinite(lb->break_at)) FW_ARENA_ADD(arena, lb->built, count);
    FW_ARENA_ADD(arena, lb->edge, count);
    FW_ARENA_ADD(arena, lb->sums, 1);
    if (!lb->displaced) {
        FW_ARENA_ADD(arena, lb->spans, count);
        FW_ARENA_ADD(arena, lb->chunk_span, chunks + 1);
        FW_ARENA_ADD(arena, lb->chunk_ledger, chunks);
        lb->chunk_count = (int)chunks;
    }
    return fw_solid_allocate(&lb->head, error);
}

static void destroy(fw_solid *solid)
{
    lb_displacements_release((lb_solid *)solid);
    fw_solid_head_release(solid);
    free(solid);
}

/* Its mass (M0^2 + sum of its link stiffnesses)/2 (Eq 4), where that can be inverted. */
static fw_status check_mass(fw_sym2 mass, fw_site site, fw_error *error)
{
    if (!is_positive(mass))
        return fw_fail(error, FW_BAD_INPUT,
                       "site [%d, %d] has no links and a rest mass that leaves it without "
                       "mass, expected a rest mass that is not singular",
                       site.i, site.j);
    const double condition = fw_sym2_condition(mass);
    if (!(condition <= FW_LB_CONDITION_MAX))
        return fw_fail(error, FW_BAD_INPUT,
                       "site [%d, %d] has the mass (M0^2 + sum of its link stiffnesses)/2 = "
                       "[%.17g, %.17g, %.17g] with the condition number %.2g, expected at most "
                       "%.2g: beyond it rounding takes energy and momentum from the body",
                       site.i, site.j, mass.xx, mass.xy, mass.yy, condition, FW_LB_CONDITION_MAX);
    return FW_OK;
}

static bool is_same(fw_sym2 a, fw_sym2 b)
{
    return a.xx == b.xx && a.xy == b.xy && a.yy == b.yy;
}

static void put_rest_and_stiffness(lb_solid *lb, const fw_lb_solid_def *def)
{
    for (int l = 0; l < lb->head.count; ++l) {
        if (lb->resting) lb_put(&lb->rest_mass, l, rest_mass_of(def, l));
        if (lb->weighted)
            for (int d = FW_EAST; d <= FW_NORTH; ++d)
                lb_put(&lb->stiffness[d], l, stiffness_of(def, l, d));
    }
}

/* No two sites with the same links differ. */
static fw_status check_counted(const lb_solid *lb, const fw_sites *sites, fw_error *error)
{
    bool checked[LB_ALL_LINKS + 1] = {0};
    for (int l = 0; l < lb->head.count; ++l) {
        if (checked[lb->present[l]]) continue;
        FW_TRY(check_mass(lb_mass_of(lb, l), sites->site[l], error));
        checked[lb->present[l]] = true;
    }
    return FW_OK;
}

static fw_status weigh(lb_solid *lb, const fw_lb_solid_def *def, fw_error *error)
{
    fw_sym2 before = {0, 0, 0}, inverse = {0, 0, 0}; /* of the site before, mostly the same */
    if (lb->resting || lb->weighted) put_rest_and_stiffness(lb, def);
    if (lb->counted) return check_counted(lb, def->sites, error);
    for (int l = 0; l < lb->head.count; ++l) {
        fw_sym2 sum = fw_sym2_square(rest_mass_of(def, l));
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            if (lb->present[l] & (1u << d)) sum = fw_sym2_add(sum, lb_stiffness(lb, l, d));
        const fw_sym2 mass = fw_sym2_scale(0.5, sum); /* Eq 4 */
        if (l == 0 || !is_same(mass, before)) {
            FW_TRY(check_mass(mass, def->sites->site[l], error));
            inverse = fw_sym2_invert(mass);
            before = mass;
        }
        lb_put(&lb->mass, l, mass);
        lb_put(&lb->inverse, l, inverse);
    }
    return FW_OK;
}

static fw_status list_links(lb_solid *lb, fw_error *error)
{
    int count = 0;
    for (int l = 0; l < lb->head.count; ++l)
        for (int d = FW_EAST; d <= FW_NORTH; ++d) count += (lb->present[l] >> d) & 1;
    lb->head.link_count = count;
    lb->head.links = fw_array_zeroed((size_t)count, sizeof *lb->head.links);
    if (!lb->head.links) return fw_fail_memory(error, "the links of an LB solid");
    lb_layout_rebuild(lb);
    return FW_OK;
}

/* Starting fields for displacements u and velocities V: half the stretch, a quarter of the summed
 * velocities per link end, M0 V/2 at rest. A rigid motion started so does not ring. */
static void start_populations(lb_solid *lb, const fw_lb_solid_def *def, int l)
{
    const fw_vec2 u = lb_start_displacement(def, l), velocity = lb_start_velocity(def, l);
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        const int m = lb_neighbour(lb, l, d);
        const fw_vec2 um = lb_start_displacement(def, m), vm = lb_start_velocity(def, m);
        lb->slot_x[d][l] = 0.5 * (um.x - u.x) + 0.25 * (velocity.x + vm.x);
        lb->slot_y[d][l] = 0.5 * (um.y - u.y) + 0.25 * (velocity.y + vm.y);
    }
    if (!lb->resting) return;
    fw_vec2 rest = fw_sym2_apply(lb_get(&lb->rest_mass, l), fw_vec2_scale(0.5, velocity));
    lb->rest_x[l] = rest.x;
    lb->rest_y[l] = rest.y;
}

static void start(lb_solid *lb, const fw_lb_solid_def *def)
{
    enum { SOME = 256 };
    for (int first = 0; first < lb->head.count; first += SOME) {
        fw_vec2 site[SOME];
        const int left = lb->head.count - first, count = left < SOME ? left : SOME;
        fw_lattice_place(&def->lattice, def->sites->site + first, count, site);
        for (int k = 0; k < count; ++k) {
            const fw_vec2 u = lb_start_displacement(def, first + k);
            lb->head.x[first + k] = site[k].x + u.x;
            lb->head.y[first + k] = site[k].y + u.y;
        }
        if (lb->displaced)
            lb_displacements_start(lb, first, count, site, def);
        else
            for (int k = 0; k < count; ++k) start_populations(lb, def, first + k);
    }
}

fw_status fw_lb_solid_create(fw_solid **solid, const fw_lb_solid_def *def, fw_error *error)
{
    *solid = NULL;
    FW_TRY(check_definition(def, error));
    lb_solid *lb = calloc(1, sizeof *lb);
    if (!lb) return fw_fail_memory(error, "an LB solid");
    fw_solid_head_begin(&lb->head, &fw_lb_solid_model, def->sites->count);
    choose_kernels(lb, def);
    for (int d = 0; d < FW_DIRECTIONS; ++d) lb->step[d] = fw_lattice_step(&def->lattice, d);
    fw_status status = allocate(lb, error);
    if (status != FW_OK) {
        destroy(&lb->head);
        return status;
    }
    lb_layout_connect(lb, def->sites);
    status = weigh(lb, def, error);
    if (status == FW_OK) status = list_links(lb, error);
    if (status == FW_OK && lb->displaced) status = lb_displacements_make(lb, def->sites, error);
    if (status != FW_OK) {
        destroy(&lb->head);
        return status;
    }
    start(lb, def);
    *solid = &lb->head;
    return FW_OK;
}

/* The table of operations. */

static double angular_momentum(const fw_solid *solid, int first, int count)
{
    const lb_solid *lb = (const lb_solid *)solid;
    double sum = 0;
    for (int l = first; l < first + count; ++l)
        sum += fw_vec2_cross(fw_solid_position(solid, l), lb_psi(lb, l));
    return sum;
}

static void masses(const fw_solid *solid, double *out)
{
    const lb_solid *lb = (const lb_solid *)solid;
    for (int l = 0; l < solid->count; ++l) {
        fw_sym2 m = lb_mass_of(lb, l);
        out[l] = 0.5 * (m.xx + m.yy);
    }
}

static void place(fw_solid *solid)
{
    lb_solid *lb = (lb_solid *)solid;
    if (lb->displaced) lb_displacements_place(lb);
}

static void place_boundary(fw_solid *solid)
{
    lb_solid *lb = (lb_solid *)solid;
    if (lb->displaced) lb_displacements_place_boundary(lb);
}

static void state(fw_solid *solid, fw_state_list *list)
{
    static const char *const name[FW_DIRECTIONS][2] = {
        {"field-east-x", "field-east-y"},
        {"field-north-x", "field-north-y"},
        {"field-west-x", "field-west-y"},
        {"field-south-x", "field-south-y"},
    };
    lb_solid *lb = (lb_solid *)solid;
    size_t count = (size_t)solid->count;
    fw_solid_head_state(solid, list);
    fw_state_list_add(list, "parity", FW_I32, 1, &lb->parity);
    if (lb->displaced) {
        lb_displacements_state(lb, list);
        return;
    }
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        fw_state_list_add(list, name[d][0], FW_F64, count, lb->slot_x[d]);
        fw_state_list_add(list, name[d][1], FW_F64, count, lb->slot_y[d]);
    }
    if (lb->resting) {
        fw_state_list_add(list, "field-rest-x", FW_F64, count, lb->rest_x);
        fw_state_list_add(list, "field-rest-y", FW_F64, count, lb->rest_y);
    }
    if (isfinite(lb->break_at)) {
        fw_state_list_add(list, "links-present", FW_U8, count, lb->present);
        fw_state_list_add(list, "links-broken", FW_I32, 1, &lb->broken);
        fw_state_list_add(list, "rest-mass-xx", FW_F64, count, lb->rest_mass.xx);
        if (lb->matrix) {
            fw_state_list_add(list, "rest-mass-xy", FW_F64, count, lb->rest_mass.xy);
            fw_state_list_add(list, "rest-mass-yy", FW_F64, count, lb->rest_mass.yy);
        }
    }
}

static fw_status restored(fw_solid *solid, fw_error *error)
{
    lb_solid *lb = (lb_solid *)solid;
    FW_TRY(fw_solid_head_restored(solid, error));
    if (lb->parity != 0 && lb->parity != 1)
        return fw_fail(error, FW_BAD_INPUT, "the parity of the fields is %d, expected 0 or 1",
                       lb->parity);
    FW_TRY(lb_layout_check(lb, error));
    lb_layout_rebuild(lb);
    lb->sums->known = false;
    place(solid);
    return FW_OK;
}

static const char *form(const fw_solid *solid)
{
    return ((const lb_solid *)solid)->displaced ? "displacements" : "populations";
}

const fw_solid_model fw_lb_solid_model = {
    .name = "lattice-boltzmann",
    .ticks_per_step = 1,
    .destroy = destroy,
    .predict = lb_predict,
    .advance = lb_advance,
    .advance_free = lb_advance_free,
    .place = place,
    .place_boundary = place_boundary,
    .reach = lb_reach,
    .carry = lb_carry,
    .energies = lb_energies,
    .momentum = lb_momentum,
    .angular_momentum = angular_momentum,
    .centre_of_mass = lb_centre_of_mass,
    .mass = lb_mass,
    .velocities = lb_velocities,
    .motions = lb_motions,
    .stays_within = lb_stays_within,
    .masses = masses,
    .state = state,
    .restored = restored,
    .reverse = fw_lb_solid_reverse,
    .form = form,
    .fields = lb_fields,
    .solid_between_links = true,
};
