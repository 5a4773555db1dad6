/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_random_collisions.c - two bodies of any shape, angle and offset collide: energy and momentum
 * stay, and no particle of one gets into a cell of the other. Cells are looked at one by one, with
 * nothing of what contact itself uses. */
#include "tests/support/scenes.h"

#include "core/automaton/elastic_automaton.h"
#include "core/noise.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

#include <stdio.h>

typedef struct shaped_body {
    fw_sites sites;
    fw_solid *solid;
} shaped_body;

typedef struct outcome {
    double energy, momentum, depth;
    double ticks, unconverged, iterations;
    int touched, deep;
} outcome;

static double between(uint64_t seed, int n, double low, double high)
{
    const double x = fw_noise_uniform(seed, (uint32_t)n, 0, FW_NOISE_PLACEMENT).x;
    return low + 0.5 * (x + 1) * (high - low);
}

static void make_sites(fw_sites *sites, uint64_t seed, int n)
{
    static const char ell[] = "###....\n###....\n###....\n#######\n#######\n#######\n";
    const int kind = (int)between(seed, n, 0, 4);
    const int columns = (int)between(seed, n + 1, 2, 9), rows = (int)between(seed, n + 2, 2, 9);
    if (kind == 0) must(fw_sites_rectangle(sites, columns, columns, &error));
    if (kind == 1) must(fw_sites_rectangle(sites, columns, rows, &error));
    if (kind == 2) must(fw_sites_disc(sites, FW_SQUARE, between(seed, n + 3, 1.5, 5), &error));
    if (kind == 3) must(fw_sites_mask(sites, ell, &error));
}

/* One of the kinds of solid; `dice` between 0 and 1 chooses among its materials. */
typedef void make_solid(shaped_body *body, fw_lattice lattice, const fw_vec2 *velocity,
                        double dice);

typedef struct solid_kind {
    const char *name;
    make_solid *make;
    fw_lattice_kind lattice;
    double step; /* time of one */
    int collisions;
    double energy; /* what its own steps may miss */
    int unconverged;
} solid_kind;

static void make_lb(shaped_body *body, fw_lattice lattice, const fw_vec2 *velocity, double dice)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &body->sites;
    def.velocity = velocity;
    def.lattice = lattice;
    def.rest_mass = fw_sym2_scalar(dice < 0.5 ? 0 : 1);
    must(fw_lb_solid_create(&body->solid, &def, &error));
}

static void make_automaton(shaped_body *body, fw_lattice lattice, const fw_vec2 *velocity,
                           double dice)
{
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &body->sites;
    def.velocity = velocity;
    def.lattice = lattice;
    if (dice < 0.5) def.speeds = (fw_automaton_speeds){1.0, 0.6};
    must(fw_elastic_automaton_create(&body->solid, &def, &error));
}

enum { PARTICLES_PER_STEP = 20 }; /* thousandths of a unit of time */

static void make_linear(shaped_body *body, fw_lattice lattice, const fw_vec2 *velocity, double dice)
{
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &body->sites;
    def.velocities = velocity;
    def.lattice = lattice;
    def.controls.time_step = 1e-3 * PARTICLES_PER_STEP;
    if (dice < 0.5) def.k2 = 20;
    must(fw_linear_lattice_create(&body->solid, &def, &error));
}

static void make_particles(shaped_body *body, fw_lattice lattice, const fw_vec2 *velocity,
                           double dice)
{
    fw_particle_group_def group = fw_particle_group_def_default();
    fw_particles_def def = fw_particles_def_default();
    fw_vec2 *places = malloc((size_t)body->sites.count * sizeof *places);
    for (int l = 0; l < body->sites.count; ++l)
        places[l] = fw_lattice_position(&lattice, body->sites.site[l]);
    group.count = body->sites.count;
    group.positions = places;
    group.velocities = velocity;
    group.return_force.angle = lattice.angle;
    if (dice < 0.5) group.return_force.amplitude = 0;
    def.groups = &group;
    def.group_count = 1;
    def.controls.time_step = 1e-3 * PARTICLES_PER_STEP;
    must(fw_particles_create(&body->solid, &def, &error));
    free(places);
}

static shaped_body add_shape(fw_scene *scene, uint64_t seed, int n, fw_vec2 middle, fw_vec2 v,
                             const solid_kind *kind)
{
    shaped_body made;
    make_sites(&made.sites, seed, n);
    fw_lattice lattice = {.kind = kind->lattice, .spacing = 1};
    fw_vec2 *velocity = malloc((size_t)made.sites.count * sizeof *velocity);
    for (int l = 0; l < made.sites.count; ++l) velocity[l] = v;
    lattice.angle = between(seed, n + 4, 0, 1) < 0.3 ? 0 : between(seed, n + 5, 0, FW_TWO_PI);
    fw_vec2 centre = {0, 0};
    for (int l = 0; l < made.sites.count; ++l)
        centre = fw_vec2_add(centre, fw_lattice_vector(&lattice, made.sites.site[l]));
    lattice.origin = fw_vec2_subtract(middle, fw_vec2_scale(1.0 / made.sites.count, centre));
    kind->make(&made, lattice, velocity, between(seed, n + 6, 0, 1));
    free(velocity);
    int body;
    must(fw_scene_adopt_body(scene, "shape", made.solid, &body, &error));
    return made;
}

/* How deep a place lies in a triangle; negative outside. */
static double depth_in_triangle(fw_vec2 at, fw_vec2 a, fw_vec2 b, fw_vec2 c)
{
    const fw_vec2 corner[] = {a, b, c};
    const double turn = fw_vec2_cross(fw_vec2_subtract(b, a), fw_vec2_subtract(c, a));
    double depth = INFINITY;
    for (int k = 0; k < 3; ++k) {
        const fw_vec2 edge = fw_vec2_subtract(corner[(k + 1) % 3], corner[k]);
        const double side = fw_vec2_cross(edge, fw_vec2_subtract(at, corner[k]));
        depth = fmin(depth, (turn > 0 ? side : -side) / sqrt(fw_vec2_dot(edge, edge)));
    }
    return depth;
}

/* Three or four particles around a cell whose first site is s; -1: there is none. */
static void cell_of(const fw_sites *sites, fw_lattice_kind kind, fw_site s, int half, int corner[4])
{
    const int odd = kind == FW_HEXAGONAL ? s.j & 1 : 0;
    const fw_site above = {s.i + odd, s.j + 1};
    corner[0] = fw_sites_find(sites, s);
    corner[1] = fw_sites_find(sites, (fw_site){s.i + 1, s.j});
    corner[2] = fw_sites_find(sites, above);
    corner[3] = corner[0];
    if (kind == FW_HEXAGONAL && half == 1) { /* the triangle that points down */
        corner[1] = corner[2];
        corner[2] = fw_sites_find(sites, (fw_site){above.i - 1, above.j});
    } else if (kind == FW_SQUARE) {
        corner[2] = fw_sites_find(sites, (fw_site){s.i + 1, s.j + 1});
        corner[3] = fw_sites_find(sites, above);
    }
}

/* Movable particles that have come apart are no matter. */
static bool holds_together(const fw_vec2 p[3])
{
    for (int k = 0; k < 3; ++k) {
        const fw_vec2 side = fw_vec2_subtract(p[(k + 1) % 3], p[k]);
        if (fw_vec2_dot(side, side) > 1.4 * 1.4) return false;
    }
    return true;
}

/* The deepest particle of one body in the cells of the other. */
static double depth_between(const shaped_body *in, const shaped_body *of, fw_lattice_kind kind)
{
    double deepest = 0;
    for (int n = 0; n < 2 * in->sites.count; ++n) {
        int corner[4];
        fw_vec2 p[4];
        if (kind == FW_SQUARE && n % 2 == 1) continue;
        cell_of(&in->sites, kind, in->sites.site[n / 2], n % 2, corner);
        if (corner[1] < 0 || corner[2] < 0 || corner[3] < 0) continue;
        for (int k = 0; k < 4; ++k) p[k] = fw_solid_position(in->solid, corner[k]);
        if (kind == FW_HEXAGONAL && !holds_together(p)) continue;
        for (int i = 0; i < of->solid->count; ++i) {
            const fw_vec2 at = fw_solid_position(of->solid, i);
            if (fabs(at.x - p[0].x) > 3 || fabs(at.y - p[0].y) > 3) continue;
            deepest = fmax(deepest, depth_in_triangle(at, p[0], p[1], p[2]));
            if (kind == FW_SQUARE) deepest = fmax(deepest, depth_in_triangle(at, p[0], p[2], p[3]));
        }
    }
    return deepest;
}

static void collide(uint64_t seed, double fastest, const solid_kind *kind, outcome *all)
{
    fw_scene *scene = empty_scene(1e4);
    const double angle = between(seed, 90, 0, FW_TWO_PI),
                 speed = between(seed, 91, 0.1, 1) * fastest; /* in a step */
    const fw_vec2 towards = {cos(angle), sin(angle)};
    const fw_vec2 middle = fw_vec2_add(
        fw_vec2_scale(13, towards), fw_vec2_scale(between(seed, 92, -5, 5), fw_vec2_turn(towards)));
    shaped_body a = add_shape(scene, seed, 0, (fw_vec2){0, 0},
                              fw_vec2_scale(speed / kind->step, towards), kind);
    shaped_body b = add_shape(scene, seed, 20, middle, (fw_vec2){0, 0}, kind);
    begin(scene);
    const double energy = energy_of(scene);
    const fw_vec2 momentum = fw_scene_momentum(scene);
    const int steps = (int)(14 / speed) + 40;
    double depth = 0;
    for (int t = 0; t < steps; ++t) {
        must(fw_scene_step(scene, &error));
        depth = fmax(depth, fmax(depth_between(&a, &b, kind->lattice),
                                 depth_between(&b, &a, kind->lattice)));
    }
    const fw_vec2 change = fw_vec2_subtract(fw_scene_momentum(scene), momentum);
    const double size = sqrt(fw_vec2_dot(momentum, momentum));
    const fw_contact_ledger *ledger = fw_scene_contact_ledger(scene);
    all->energy = fmax(all->energy, fabs(energy_of(scene) / energy - 1));
    all->momentum = fmax(all->momentum, (fabs(change.x) + fabs(change.y)) / size);
    all->depth = fmax(all->depth, depth);
    all->deep += depth > 1e-9;
    all->touched += ledger->ticks > 0;
    all->ticks += ledger->ticks;
    all->unconverged += ledger->unconverged;
    all->iterations += ledger->iterations;
    fw_scene_destroy(scene);
    fw_sites_clear(&a.sites);
    fw_sites_clear(&b.sites);
}

static void collide_often(const solid_kind *kind, double fastest)
{
    outcome all = {0};
    for (int n = 0; n < kind->collisions; ++n) collide((uint64_t)n, fastest, kind, &all);
    print_message(
        "%s, v <= %g in a step: %d of %d touch, in %g ticks; dE/E %.1e, dP/P %.1e, depth %.1e, %d "
        "bodies deeper than 1e-9, %g ticks not converged, %.1f iterations a tick\n",
        kind->name, fastest, all.touched, kind->collisions, all.ticks, all.energy, all.momentum,
        all.depth, all.deep, all.unconverged, all.iterations / all.ticks);
    assert_true(all.touched > 0.6 * kind->collisions);
    assert_true(all.energy < kind->energy);
    assert_true(all.momentum < 1e-12);
    /* An iterate that did not converge keeps energy and momentum, not the gap: the reference has 2
     * in 21,746 ticks. None of these lets a body in, and nothing else may. */
    assert_true(all.unconverged <= kind->unconverged);
    assert_int_equal(all.deep, 0);
}

static const solid_kind lb = {"LB solids", make_lb, FW_SQUARE, 1, 1000, 1e-12, 2};
static const solid_kind automata = {"automata", make_automaton, FW_SQUARE, 1, 1000, 1e-12, 2};
static const solid_kind linear = {
    "linear lattices", make_linear, FW_HEXAGONAL, 1e-3 * PARTICLES_PER_STEP, 1000, 0.1, 2};
static const solid_kind movable = {
    "movable particles", make_particles, FW_HEXAGONAL, 1e-3 * PARTICLES_PER_STEP, 200, 0.1, 2};

static void lb_solids_keep_everything_and_stay_out(void **state)
{
    (void)state;
    collide_often(&lb, 0.1);
    collide_often(&lb, 0.5);
}

static void automata_keep_everything_and_stay_out(void **state)
{
    (void)state;
    collide_often(&automata, 0.1);
    collide_often(&automata, 0.5);
}

/* A way of .02 in a step is a velocity of 1, an eighth of the sound's. */
static void linear_lattices_keep_momentum_and_stay_out(void **state)
{
    (void)state;
    collide_often(&linear, 0.01);
    collide_often(&linear, 0.05);
}

/* Slow enough for their bonds. */
static void movable_particles_keep_momentum_and_stay_out(void **state)
{
    (void)state;
    collide_often(&movable, 0.004);
    collide_often(&movable, 0.01);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lb_solids_keep_everything_and_stay_out),
        cmocka_unit_test(automata_keep_everything_and_stay_out),
        cmocka_unit_test(linear_lattices_keep_momentum_and_stay_out),
        cmocka_unit_test(movable_particles_keep_momentum_and_stay_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
