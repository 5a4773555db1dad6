/* SPDX-License-Identifier: GPL-3.0-or-later */
/* presses.h - random presses: one or two bodies of any shape, of LB sites, particles or cells of an
 * automaton, under pistons of any shape, surface, mass and drive; and what they must hold. */
#ifndef FW_TEST_PRESSES_H
#define FW_TEST_PRESSES_H

#include "tests/support/pistons.h"

#include "core/automaton/elastic_automaton.h"
#include "core/noise.h"
#include "core/particles/linear_lattice.h"

typedef struct outcome {
    int runs, stopped, unresolved, books, deep, feeds, unconverged;
    double energy, momentum, depth, body_depth;
} outcome;

typedef enum layout { ONE_BODY, STACK, FOIL_ON_BODY, TWO_PISTONS, LAYOUTS } layout;

/* What bodies are made of. */
typedef enum matter { SITES_OR_PARTICLES, CELLS } matter;

static const char *const layout_names[] = {"one body", "stack", "foil under the piston",
                                           "two pistons"};

static inline double between(uint64_t seed, int n, double low, double high)
{
    const double x = fw_noise_uniform(seed, (uint32_t)n, 0, FW_NOISE_PLACEMENT).x;
    return low + 0.5 * (x + 1) * (high - low);
}

static inline void make_sites(fw_sites *sites, uint64_t seed, int n, bool foil)
{
    static const char ell[] = "###....\n###....\n#######\n#######\n#######\n";
    const int kind = foil ? 1 : (int)between(seed, n, 0, 4);
    const int columns = (int)between(seed, n + 1, 2, 10), rows = (int)between(seed, n + 2, 1, 8);
    if (kind == 0) must(fw_sites_rectangle(sites, columns, columns, &error));
    if (kind == 1) must(fw_sites_rectangle(sites, columns, foil ? 1 : rows, &error));
    if (kind == 2) must(fw_sites_disc(sites, FW_SQUARE, between(seed, n + 3, 1.5, 5), &error));
    if (kind == 3) must(fw_sites_mask(sites, ell, &error));
}

static inline fw_solid *make_lb(const fw_sites *sites, fw_lattice lattice, fw_vec2 v, uint64_t seed,
                                int n)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_vec2 *velocity = malloc((size_t)sites->count * sizeof *velocity);
    for (int l = 0; l < sites->count; ++l) velocity[l] = v;
    def.sites = sites;
    def.velocity = velocity;
    def.lattice = lattice;
    def.rest_mass = fw_sym2_scalar(between(seed, n, 0, 1) < 0.5 ? 0 : 1);
    if (between(seed, n + 1, 0, 1) < 0.2) def.rest_mass = (fw_sym2){1, 0.6, 0.3};
    def.mu = between(seed, n + 2, 0, 1) < 0.5 ? 1 : 0.97;
    fw_solid *solid;
    must(fw_lb_solid_create(&solid, &def, &error));
    free(velocity);
    return solid;
}

static inline fw_solid *make_particles(int columns, int rows, fw_lattice lattice, fw_vec2 v)
{
    fw_sites sites;
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    must(fw_sites_rectangle(&sites, columns, rows, &error));
    fw_vec2 *velocity = malloc((size_t)sites.count * sizeof *velocity);
    for (int l = 0; l < sites.count; ++l) velocity[l] = fw_vec2_scale(20, v);
    def.sites = &sites;
    def.velocities = velocity;
    def.lattice = lattice;
    def.lattice.kind = FW_HEXAGONAL;
    fw_solid *solid;
    must(fw_linear_lattice_create(&solid, &def, &error));
    free(velocity);
    fw_sites_clear(&sites);
    return solid;
}

static inline fw_solid *make_cells(const fw_sites *sites, fw_lattice lattice, fw_vec2 v,
                                   uint64_t seed, int n)
{
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    fw_vec2 *velocity = malloc((size_t)sites->count * sizeof *velocity);
    for (int l = 0; l < sites->count; ++l) velocity[l] = v;
    def.sites = sites;
    def.velocity = velocity;
    def.lattice = lattice;
    if (between(seed, n, 0, 1) < 0.5) def.speeds = (fw_automaton_speeds){1.0, 0.6};
    def.reflection = between(seed, n + 2, 0, 1) < 0.5 ? 1 : 0.97;
    fw_solid *solid;
    must(fw_elastic_automaton_create(&solid, &def, &error));
    free(velocity);
    return solid;
}

static inline double slope_of(uint64_t seed)
{
    return between(seed, 30, 0, 1) < 0.5 ? 0 : between(seed, 31, -0.3, 0.3);
}

static inline bool is_of_particles(matter of, uint64_t seed)
{
    return of == SITES_OR_PARTICLES && between(seed, 100, 0, 1) < 0.25;
}

/* Puts a body onto what reaches up to `below` on that slope; returns how far it reaches up itself.
 */
static inline double add_shape(fw_scene *scene, uint64_t seed, int n, double below, double slope,
                               bool foil, matter of)
{
    fw_sites sites;
    const bool particles = is_of_particles(of, seed);
    make_sites(&sites, seed, n, foil);
    fw_lattice lattice = fw_lb_solid_def_default().lattice;
    if (!foil && between(seed, n + 4, 0, 1) < 0.6) lattice.angle = between(seed, n + 5, 0, 6.3);
    const fw_vec2 v = {between(seed, n + 6, -0.05, 0.05), between(seed, n + 7, -0.1, 0)};
    double low = INFINITY, high = -INFINITY, middle = 0;
    for (int pass = 0; pass < 2; ++pass) {
        fw_solid *solid =
            of == CELLS ? make_cells(&sites, lattice, v, seed, n + 8)
            : particles ? make_particles((int)between(seed, n + 1, 2, 9),
                                         foil ? 1 : (int)between(seed, n + 2, 2, 7), lattice, v)
                        : make_lb(&sites, lattice, v, seed, n + 8);
        for (int i = 0; i < solid->count && pass == 0; ++i) {
            const fw_vec2 at = fw_solid_position(solid, i);
            low = fmin(low, at.y - slope * at.x);
            high = fmax(high, at.y);
            middle += at.x / solid->count;
        }
        if (pass == 0) {
            lattice.origin = (fw_vec2){-middle, below - low - slope * middle +
                                                    between(seed, n + 12, 0.001, 0.2)};
            fw_solid_destroy(solid);
            continue;
        }
        int body;
        must(fw_scene_adopt_body(scene, n == 0 ? "lower" : "upper", solid, &body, &error));
    }
    fw_sites_clear(&sites);
    return high + lattice.origin.y;
}

static inline fw_surface any_surface(uint64_t seed, int n, int most)
{
    static const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                          {.law = FW_COULOMB, .friction = 0.4},
                                          {.law = FW_STICK},
                                          {.law = FW_PENALTY, .stiffness = 0.5}};
    return surfaces[(int)between(seed, n, 0, most)];
}

static inline void add_piston(fw_scene *scene, matter of, uint64_t seed, int n, double x,
                              double top, bool soft)
{
    const double tilt = between(seed, n, -0.25, 0.25);
    const int kind = (int)between(seed, n + 1, 0, 4);
    const fw_vec2 box[] = {{x - 20, top}, {x + 20, top + 5}};
    const fw_vec2 wedge[] = {{x - 9, top + 4}, {x, top}, {x + 9, top + 4 + 9 * tilt}};
    const fw_vec2 blade[] = {{x + 20, top + 20 * fabs(tilt) + 20 * tilt},
                             {x - 20, top + 20 * fabs(tilt) - 20 * tilt}};
    const fw_vec2 centre = {x, top + 6};
    fw_wall_def def = fw_wall_def_default();
    def.name = n < 60 ? "piston" : "second";
    def.side = FW_OUTSIDE;
    def.surface = any_surface(seed, n + 2, soft && kind != 1 && kind != 3 ? 4 : 3);
    if (of == CELLS) def.surface.stiffness *= 0.08; /* cells at rims are light */
    def.shape = (fw_wall_shape_kind[]){FW_BOX, FW_POLYGON, FW_CIRCLE, FW_CHAIN}[kind];
    def.points = (const fw_vec2 *[]){box, wedge, &centre, blade}[kind];
    def.point_count = (int[]){2, 3, 1, 2}[kind];
    def.radius = kind == 2 ? 6 : 0;
    fw_piston_def piston = {.mass = exp(between(seed, n + 3, -1, 5)),
                            .damping = between(seed, n + 4, 0, 1) < 0.5 ? 0 : 0.05,
                            .velocity = {0, between(seed, n + 5, -0.1, 0)}};
    fw_drive *drive = &piston.drive;
    drive->force = (fw_vec2){between(seed, n + 6, -0.02, 0.02), between(seed, n + 7, -0.3, -0.05)};
    /* The sides of a soft box are far away, and stay there: see its corners in penalty.h. */
    if (def.surface.law == FW_PENALTY) drive->force.x = 0;
    if (def.surface.law == FW_PENALTY && of == CELLS) drive->force.y *= 0.1;
    if (between(seed, n + 8, 0, 1) < 0.3) drive->tether = (fw_vec2){0.01, 0.002};
    if (between(seed, n + 9, 0, 1) < 0.3) { /* a ramp */
        drive->period = 2000;
        drive->amplitude = (fw_vec2){0, -1};
    }
    /* A blade that slides away lets cells, which press it less, round its end. */
    if (between(seed, n + 10, 0, 1) < 0.4 || (of == CELLS && kind == 3)) {
        drive->prescribed_x = true;
        drive->force.x = drive->tether.x = 0;
        drive->path = (fw_path){.amplitude = {0.3, 0}, .period = 300, .until = INFINITY};
    }
    must(fw_scene_add_piston(scene, &def, &piston, &error));
}

static inline void add_floor(fw_scene *scene, uint64_t seed)
{
    const double slope = slope_of(seed);
    const fw_vec2 floor[] = {{-60, -60 * slope}, {60, 60 * slope}};
    const fw_vec2 room[] = {{-14, -60}, {14, 60}};
    fw_wall_def def = fw_wall_def_default();
    def.shape = FW_CHAIN;
    def.points = floor;
    def.point_count = 2;
    def.surface = any_surface(seed, 32, 3);
    def.name = "floor";
    must(fw_scene_add_wall(scene, &def, &error));
    def = fw_wall_def_default();
    def.points = room;
    def.name = "room";
    must(fw_scene_add_wall(scene, &def, &error));
}

/* Energy and momentum that bodies and pistons have, and should have. */
static inline void measure_books(const fw_scene *scene, outcome *all, bool verlet)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    const fw_energies e = fw_scene_energies(scene);
    double size = 1e-3 + fw_scene_energy_scale(scene), impulses = 1;
    double energy = verlet ? 0 : fabs(e.kinetic + e.elastic - fw_ledger_energy(&ledger));
    const fw_vec2 p = fw_vec2_subtract(fw_scene_momentum(scene), fw_ledger_momentum(&ledger));
    double momentum = fabs(p.x) + fabs(p.y);
    for (int w = 0; w < fw_scene_wall_count(scene); ++w) {
        const fw_piston *piston = fw_scene_observe_piston(scene, w);
        const fw_vec2 impulse = fw_scene_wall_ledger(scene, w)->impulse;
        impulses += fabs(impulse.x) + fabs(impulse.y);
        if (!piston) continue;
        const fw_piston_ledger *a = fw_piston_observe_ledger(piston);
        const fw_vec2 lost = fw_piston_momentum_error(piston);
        size += fabs(a->work) + fabs(a->pushed_by);
        energy += fabs(fw_piston_energy_error(piston)) + fabs(a->unmatched_work);
        momentum += fabs(lost.x) + fabs(lost.y) + fabs(a->unmatched.x) + fabs(a->unmatched.y);
        momentum += fabs(a->pushed.x + impulse.x) + fabs(a->pushed.y + impulse.y);
    }
    all->energy = fmax(all->energy, energy / size);
    all->momentum = fmax(all->momentum, momentum / impulses);
    all->books += energy > 1e-11 * size || momentum > 1e-11 * impulses;
}

static inline fw_scene *make_press(layout how, matter of, uint64_t seed)
{
    fw_scene *scene = empty_scene(1e6);
    const bool soft = how != STACK && between(seed, 101, 0, 1) < 0.25;
    add_floor(scene, seed);
    double top = add_shape(scene, seed, 0, 0, slope_of(seed), false, of);
    if (how == STACK || how == FOIL_ON_BODY)
        top = add_shape(scene, seed, 15, top, 0, how == FOIL_ON_BODY, of);
    fw_scene_set_friction(scene, between(seed, 102, 0, 1) < 0.5 ? 0 : 0.3);
    add_piston(scene, of, seed, 40, between(seed, 103, -2, 2), top + 0.01, soft);
    if (how == TWO_PISTONS)
        add_piston(scene, of, seed, 60, between(seed, 104, -2, 2), top + 0.3, soft);
    begin(scene);
    return scene;
}

static inline void press_once(layout how, matter of, uint64_t seed, outcome *all)
{
    fw_scene *scene = make_press(how, of, seed);
    const bool particles = is_of_particles(of, seed);
    double depth = 0, body_depth = 0, heat = 0;
    bool fed = false, stopped = false;
    const int steps = particles ? 500 : 200;
    for (int t = 0; t < steps && !stopped; ++t) {
        stopped = fw_scene_step(scene, &error) != FW_OK;
        if (stopped) print_message("seed %d: %s\n", (int)seed, error.sentence);
        const double now = fw_scene_ledger(scene).friction_heat;
        fed |= now < heat - 1e-13 * (1e-3 + fw_scene_energy_scale(scene));
        heat = now;
        depth = fmax(depth, fw_scene_penetration(scene, -1));
        body_depth = fmax(body_depth, fw_scene_body_penetration(scene));
    }
    double unresolved = (double)fw_scene_unresolved(scene);
    bool springs = false;
    for (int w = 0; w < fw_scene_wall_count(scene); ++w) {
        springs |= fw_wall_surface(fw_scene_wall(scene, w)).law == FW_PENALTY;
        if (fw_scene_observe_piston(scene, w)) unresolved += !motion_fits(scene, w);
    }
    if (springs) depth = 0;
    measure_books(scene, all, particles);
    all->runs += 1;
    all->stopped += stopped;
    all->unresolved += unresolved > 0;
    all->unconverged += fw_scene_contact_ledger(scene)->unconverged > 0;
    all->feeds += fed;
    all->deep += depth > 1e-10 || body_depth > 1e-9;
    all->depth = fmax(all->depth, depth);
    all->body_depth = fmax(all->body_depth, body_depth);
    fw_scene_destroy(scene);
}

/* So many of each layout keep their books and their room. */
static inline void assert_random_presses(matter of, uint64_t count)
{
    outcome sum = {0};
    for (layout how = ONE_BODY; how < LAYOUTS; ++how) {
        outcome all = {0};
        for (uint64_t n = 0; n < count; ++n) press_once(how, of, 1000 * (uint64_t)how + n, &all);
        print_message(
            "%-22s %d runs: %d stopped, %d unresolved, %d books open (energy %.1e, momentum %.1e), "
            "%d deep (%.1e in walls, %.1e in bodies), %d feed, %d unconverged\n",
            layout_names[how], all.runs, all.stopped, all.unresolved, all.books, all.energy,
            all.momentum, all.deep, all.depth, all.body_depth, all.feeds, all.unconverged);
        sum.unresolved += all.unresolved;
        sum.stopped += all.stopped;
        sum.books += all.books;
        sum.deep += all.deep;
        sum.feeds += all.feeds;
    }
    assert_int_equal(sum.stopped, 0);
    assert_int_equal(sum.unresolved, 0);
    assert_int_equal(sum.books, 0);
    assert_int_equal(sum.deep, 0);
    assert_int_equal(sum.feeds, 0);
}

/* Whatever was found in which order: they go on elsewhere with the same bytes. */
static inline void assert_presses_go_on_elsewhere(matter of, uint64_t count)
{
    for (layout how = ONE_BODY; how < LAYOUTS; ++how)
        for (uint64_t n = 0; n < count; ++n) {
            const uint64_t seed = 1000 * (uint64_t)how + n;
            fw_scene *scene = make_press(how, of, seed), *elsewhere = make_press(how, of, seed);
            run(scene, 100);
            copy_state(scene, elsewhere);
            run(scene, 100);
            run(elsewhere, 100);
            assert_true(hash_of_scene(scene) == hash_of_scene(elsewhere));
            fw_scene_destroy(scene);
            fw_scene_destroy(elsewhere);
        }
}

#endif
