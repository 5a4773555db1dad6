/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_lattice.c - particles tied to their six neighbours by linear forces.
 * State: that of langevin.c. Each particle gathers from its neighbours in the order of directions.
 * The step is in langevin.c; start reading at find_forces(). */
#include "core/particles/linear_lattice.h"

#include "linear_bonds.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NEIGHBOURS = FW_BOND_DIRECTIONS, PARALLEL_FROM = 4096 };

#define ROOT_3 1.73205080756887729353

typedef struct fw_linear_lattice {
    fw_langevin langevin; /* first */
    double k1, k2;
    fw_vec2 direction[NEIGHBOURS]; /* Eq 1, turned with the lattice */
    double *homes;                 /* memory of the two below, which may be read a block beyond */
    double *home_x, *home_y;       /* places at rest */
    fw_linear_bonds bonds;
} fw_linear_lattice;

fw_linear_lattice_def fw_linear_lattice_def_default(void)
{
    return (fw_linear_lattice_def){.lattice = {.kind = FW_HEXAGONAL, .spacing = 1},
                                   .mass = 1,
                                   .k1 = 10,
                                   .k2 = 50,
                                   .compensated = true,
                                   .controls = {.time_step = 0.005}};
}

void fw_linear_lattice_from_lame(double lambda, double mu, double *k1, double *k2)
{
    *k2 = 2 * (lambda + mu) / ROOT_3;
    *k1 = mu / ROOT_3 - *k2 / 4;
}

/* e_alpha of Eq 1 in the turned lattice. */
static fw_vec2 bond_direction(const fw_lattice *lattice, int alpha)
{
    static const fw_vec2 straight[NEIGHBOURS] = {{1, 0},  {0.5, ROOT_3 / 2},   {-0.5, ROOT_3 / 2},
                                                 {-1, 0}, {-0.5, -ROOT_3 / 2}, {0.5, -ROOT_3 / 2}};
    const double c = cos(lattice->angle), s = sin(lattice->angle);
    const fw_vec2 e = straight[alpha];
    return (fw_vec2){c * e.x - s * e.y, s * e.x + c * e.y};
}

fw_sym2 fw_linear_lattice_dynamical_matrix(const fw_linear_lattice_def *def, fw_vec2 wave_vector)
{
    fw_sym2 matrix = {0, 0, 0};
    for (int alpha = 0; alpha < NEIGHBOURS / 2; ++alpha) {
        const fw_vec2 e = bond_direction(&def->lattice, alpha);
        const double half = sin(0.5 * def->lattice.spacing * fw_vec2_dot(wave_vector, e));
        const double factor = 4 * half * half / def->mass;
        const fw_sym2 bond = {def->k1 + def->k2 * e.x * e.x, def->k2 * e.x * e.y,
                              def->k1 + def->k2 * e.y * e.y};
        matrix = fw_sym2_add(matrix, fw_sym2_scale(factor, bond));
    }
    return matrix;
}

/* --- forces --- */

static fw_linear_task task_of(const fw_linear_lattice *lattice)
{
    const fw_solid *head = &lattice->langevin.head;
    fw_linear_task task = {.bonds = &lattice->bonds,
                           .k1 = lattice->k1,
                           .k2 = lattice->k2,
                           .x = head->x,
                           .y = head->y,
                           .home_x = lattice->home_x,
                           .home_y = lattice->home_y};
    memcpy(task.direction, lattice->direction, sizeof task.direction);
    return task;
}

static fw_status find_forces(fw_langevin *solid, double travel, const struct fw_move_task *kick,
                             fw_error *error)
{
    (void)travel;
    (void)error;
    enum { SOME = 64 }; /* blocks that a thread takes at a time */
    const fw_linear_task task = task_of((const fw_linear_lattice *)solid);
    const fw_linear_kernels *kernels = FW_KERNELS_CHOSEN(fw_linear_loops);
    const int count = solid->head.count, blocks = (count + FW_LANES - 1) / FW_LANES;
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int begin = 0; begin < blocks; begin += SOME) {
        const int end = begin + SOME < blocks ? begin + SOME : blocks;
        kernels->forces(&task, begin, end, solid->force_x, solid->force_y);
        const int first = begin * FW_LANES, past = end * FW_LANES < count ? end * FW_LANES : count;
        fw_langevin_kick(kick, first, past - first);
    }
    return FW_OK;
}

/* Every force is linear in the displacements and has a potential, so the energy is
 * -1/2 sum u . F(u), and with u = u_i + stretch for each particle the same as summed here:
 * half of each bond's energy, and of u_i . (turning force), at either end. */
static void fill_potential_energy(const fw_solid *head, double *values)
{
    const fw_linear_lattice *lattice = (const fw_linear_lattice *)head;
    const fw_linear_task task = task_of(lattice);
    const fw_vec2 middle = {head->x[0] - lattice->home_x[0], head->y[0] - lattice->home_y[0]};
    FW_KERNELS_CHOSEN(fw_linear_loops)
        ->energies(&task, middle, 0, (head->count + FW_LANES - 1) / FW_LANES, values);
}

/* --- the model --- */

static void destroy(fw_solid *solid)
{
    if (!solid) return;
    fw_linear_lattice *lattice = (fw_linear_lattice *)solid;
    free(lattice->homes);
    fw_linear_bonds_release(&lattice->bonds);
    fw_langevin_release(&lattice->langevin);
    free(lattice);
}

static fw_energies energies(const fw_solid *solid)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    fw_langevin_known *known = langevin->known;
    if (!known->has_elastic) {
        fill_potential_energy(solid, langevin->scratch);
        known->elastic = fw_array_sum(langevin->scratch, (size_t)solid->count);
    }
    known->has_elastic = true;
    return (fw_energies){.kinetic = fw_langevin_kinetic_energy(langevin),
                         .elastic = known->elastic};
}

static void fill_displacement_x(const fw_solid *solid, double *values)
{
    for (int i = 0; i < solid->count; ++i)
        values[i] = solid->x[i] - fw_linear_lattice_home(solid, i).x;
}

static void fill_displacement_y(const fw_solid *solid, double *values)
{
    for (int i = 0; i < solid->count; ++i)
        values[i] = solid->y[i] - fw_linear_lattice_home(solid, i).y;
}

static void fill_speed(const fw_solid *solid, double *values)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    for (int i = 0; i < solid->count; ++i)
        values[i] = hypot(langevin->velocity_x[i], langevin->velocity_y[i]);
}

static const fw_field fields[] = {
    {"displacement-x", "length", "x from the place in the undeformed lattice", fill_displacement_x},
    {"displacement-y", "length", "y from the place in the undeformed lattice", fill_displacement_y},
    {"speed", "length/time", "length of the velocity", fill_speed},
    {"potential-energy", "energy",
     "half of the energy of the particle's bonds, and its surface forces'", fill_potential_energy},
    {NULL, NULL, NULL, NULL},
};

const fw_solid_model fw_linear_lattice_model = {
    .name = "linear-lattice",
    FW_LANGEVIN_OPERATIONS,
    .destroy = destroy,
    .energies = energies,
    .state = fw_langevin_state,
    .restored = fw_langevin_restored,
    .fields = fields,
    .solid_between_links = true,
};

fw_vec2 fw_linear_lattice_home(const fw_solid *solid, int particle)
{
    assert(solid->model == &fw_linear_lattice_model);
    const fw_linear_lattice *lattice = (const fw_linear_lattice *)solid;
    return (fw_vec2){lattice->home_x[particle], lattice->home_y[particle]};
}

/* --- building --- */

double fw_linear_lattice_time_step_limit(double k1, double k2, double mass)
{
    /* With s = sin^2(c q . e/2) of the three bonds, the larger m omega^2 is
     *     a sum s + b |sum s e^(2 i theta)|,   a = 4 k1 + 2 k2,   b = 2 |k2|,
     * and largest from the zone's corner to the middle of its edge, s = (x, x, 4x(1 - x)) with x
     * from 3/4 to 1: where x = (6 a - 3 b)/(8 a - 8 b), if that comes before the middle. */
    const double a = 4 * k1 + 2 * k2, b = 2 * fabs(k2);
    const double corner = 2.25 * a, middle = 2 * a + b;
    const double fastest = 5 * b < 2 * a ? corner + 9. / 16 * b * b / (a - b) : middle;
    return 2 / sqrt(fastest / mass);
}

/* Waves must not grow, and no body may: with surface forces each triangle is a body of its own,
 * with the bulk modulus (sqrt3/2) k2; without them each bond is one, and k1 its resistance to
 * turning. */
static fw_status check_material(double k1, double k2, bool compensated, fw_error *error)
{
    if (!(k1 + 0.25 * k2 > 0 && k1 + 0.75 * k2 > 0))
        return fw_fail(error, FW_BAD_INPUT,
                       "the linear lattice has k1 = %g and k2 = %g, expected k1 + k2/4 > 0 and k1 "
                       "+ 3 k2/4 > 0: otherwise it collapses",
                       k1, k2);
    if (compensated && !(k2 >= 0))
        return fw_fail(error, FW_BAD_INPUT,
                       "the linear lattice has k2 = %g, expected k2 >= 0: with surface forces its "
                       "bulk modulus is (sqrt3/2) k2, and a body with free sides collapses",
                       k2);
    if (!compensated && !(k1 >= 0 && k1 + k2 >= 0))
        return fw_fail(
            error, FW_BAD_INPUT,
            "the linear lattice has k1 = %g and k2 = %g without surface forces, expected "
            "k1 >= 0 and k1 + k2 >= 0: otherwise a body with free sides turns or grows "
            "without end",
            k1, k2);
    return FW_OK;
}

static fw_status check_time_step(double k1, double k2, double mass, double time_step,
                                 fw_error *error)
{
    const double limit = fw_linear_lattice_time_step_limit(k1, k2, mass);
    if (!(time_step < limit))
        return fw_fail(error, FW_BAD_INPUT,
                       "the time step is %g, expected less than %.4g: beyond it the lattice's "
                       "fastest oscillation grows",
                       time_step, limit);
    return FW_OK;
}

static fw_status check_def(const fw_linear_lattice_def *def, fw_error *error)
{
    if (def->lattice.kind != FW_HEXAGONAL)
        return fw_fail(error, FW_BAD_INPUT,
                       "the linear lattice stands on square sites, expected hexagonal ones");
    if (!(def->mass > 0 && isfinite(def->mass)))
        return fw_fail(error, FW_BAD_INPUT, "the particles have mass %g, expected a number > 0",
                       def->mass);
    if (!(def->lattice.spacing > 0 && isfinite(def->lattice.spacing)))
        return fw_fail(error, FW_BAD_INPUT, "the lattice has spacing %g, expected a number > 0",
                       def->lattice.spacing);
    if (!isfinite(def->k1) || !isfinite(def->k2))
        return fw_fail(error, FW_BAD_INPUT, "k1 = %g and k2 = %g, expected finite numbers", def->k1,
                       def->k2);
    FW_TRY(fw_langevin_check(&def->controls, error));
    FW_TRY(check_material(def->k1, def->k2, def->compensated, error));
    return check_time_step(def->k1, def->k2, def->mass, def->controls.time_step, error);
}

static fw_site neighbour_site(fw_site site, int alpha)
{
    const int odd = site.j & 1;
    const fw_site step[NEIGHBOURS] = {{1, 0},  {odd, 1},      {odd - 1, 1},
                                      {-1, 0}, {odd - 1, -1}, {odd, -1}};
    return (fw_site){site.i + step[alpha].i, site.j + step[alpha].j};
}

/* As many as were counted. */
static fw_status list_links(fw_solid *head, const fw_linear_neighbours *around, fw_error *error)
{
    int count = 0;
    head->links = fw_array_zeroed((size_t)head->link_count, sizeof *head->links);
    if (!head->links) return fw_fail_memory(error, "the links of a linear lattice");
    for (int i = 0; i < head->count; ++i)
        for (int alpha = 0; alpha < NEIGHBOURS / 2; ++alpha) {
            const int j = around[i][alpha];
            if (j < 0) continue;
            head->links[count][0] = i;
            head->links[count][1] = j;
            count += 1;
        }
    return FW_OK;
}

static void place(fw_linear_lattice *lattice, const fw_linear_lattice_def *def)
{
    fw_langevin *langevin = &lattice->langevin;
    fw_solid *head = &langevin->head;
    for (int i = 0; i < head->count; ++i) {
        const fw_vec2 home = fw_lattice_position(&def->lattice, def->sites->site[i]);
        const fw_vec2 moved = def->displacements ? def->displacements[i] : (fw_vec2){0, 0};
        lattice->home_x[i] = home.x;
        lattice->home_y[i] = home.y;
        head->x[i] = home.x + moved.x;
        head->y[i] = home.y + moved.y;
        langevin->mass[i] = def->mass;
        if (def->velocities) {
            langevin->velocity_x[i] = def->velocities[i].x;
            langevin->velocity_y[i] = def->velocities[i].y;
        }
    }
}

static fw_status tie(fw_linear_lattice *lattice, const fw_linear_lattice_def *def,
                     fw_linear_neighbours *around, fw_error *error)
{
    fw_solid *head = &lattice->langevin.head;
    int at[NEIGHBOURS / 2] = {0};
    memset(around, 0xff, (size_t)head->count * sizeof *around); /* -1: none */
    for (int i = 0; i < head->count; ++i)
        for (int alpha = 0; alpha < NEIGHBOURS / 2; ++alpha) {
            const int j = fw_sites_find_next(def->sites, neighbour_site(def->sites->site[i], alpha),
                                             &at[alpha]);
            if (j < 0) continue;
            around[i][alpha] = j;
            around[j][alpha + NEIGHBOURS / 2] = i;
            head->link_count += 1;
        }
    for (int i = 0; i < head->count; ++i) {
        int found = 0;
        for (int alpha = 0; alpha < NEIGHBOURS; ++alpha) found += around[i][alpha] >= 0;
        if (found < NEIGHBOURS) head->boundary[head->boundary_count++] = i;
    }
    FW_TRY(list_links(head, (const fw_linear_neighbours *)around, error));
    return fw_linear_bonds_create(&lattice->bonds, head->count, lattice->k1, def->compensated,
                                  (const fw_linear_neighbours *)around, error);
}

static fw_status build(fw_linear_lattice *lattice, const fw_linear_lattice_def *def,
                       fw_error *error)
{
    fw_langevin *langevin = &lattice->langevin;
    const size_t count = (size_t)langevin->head.count, row = count + 2 * FW_LANES;
    lattice->k1 = def->k1;
    lattice->k2 = def->k2;
    lattice->homes = fw_array_of_doubles(2 * row);
    if (!lattice->homes) return fw_fail_memory(error, "the places of a linear lattice");
    lattice->home_x = lattice->homes + FW_LANES;
    lattice->home_y = lattice->home_x + row;
    for (int alpha = 0; alpha < NEIGHBOURS; ++alpha)
        lattice->direction[alpha] = bond_direction(&def->lattice, alpha);
    place(lattice, def);
    fw_linear_neighbours *around = fw_array_zeroed(count, sizeof *around);
    if (!around) return fw_fail_memory(error, "the bonds of a linear lattice");
    const fw_status status = tie(lattice, def, around, error);
    free(around);
    if (status != FW_OK) return status;
    langevin->seed = def->seed;
    langevin->find_forces = find_forces;
    fw_langevin_set_controls(langevin, &def->controls);
    return fw_langevin_start(langevin, error);
}

fw_status fw_linear_lattice_create(fw_solid **solid, const fw_linear_lattice_def *def,
                                   fw_error *error)
{
    *solid = NULL;
    FW_TRY(check_def(def, error));
    fw_linear_lattice *lattice = calloc(1, sizeof *lattice);
    if (!lattice) return fw_fail_memory(error, "a linear lattice");
    fw_status status =
        fw_langevin_create(&lattice->langevin, &fw_linear_lattice_model, def->sites->count, error);
    if (status == FW_OK) status = build(lattice, def, error);
    if (status != FW_OK) {
        destroy(&lattice->langevin.head);
        return status;
    }
    *solid = &lattice->langevin.head;
    return FW_OK;
}
