/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_scene.c - the second height of libfretwork: scenes built by hand. A square of each solid
 * flies into the floor of a box; prints how far it is from where it began, how hard the floor has
 * pushed, and how well the energy is kept: exactly where a solid's own steps keep it so, else to
 * what Verlet's steps leave. */
#include <fretwork.h>

#include <math.h>
#include <stdio.h>

enum { SIDE = 8 };
static const fw_vec2 fall = {0, -0.05};

static fw_status make_boltzmann(fw_solid **solid, const fw_sites *sites, fw_error *error)
{
    fw_vec2 velocity[SIDE * SIDE];
    fw_lb_solid_def def = fw_lb_solid_def_default();
    for (int i = 0; i < sites->count; ++i) velocity[i] = fall;
    def.sites = sites;
    def.velocity = velocity;
    return fw_lb_solid_create(solid, &def, error);
}

static fw_status make_automaton(fw_solid **solid, const fw_sites *sites, fw_error *error)
{
    fw_vec2 velocity[SIDE * SIDE];
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    for (int i = 0; i < sites->count; ++i) velocity[i] = fall;
    def.sites = sites;
    def.velocity = velocity;
    return fw_elastic_automaton_create(solid, &def, error);
}

static fw_status make_linear(fw_solid **solid, const fw_sites *sites, fw_error *error)
{
    fw_vec2 velocity[SIDE * SIDE];
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    for (int i = 0; i < sites->count; ++i) velocity[i] = fall;
    def.lattice.kind = FW_HEXAGONAL;
    def.lattice.spacing = 1;
    def.sites = sites;
    def.velocities = velocity;
    def.controls.time_step = 0.02;
    return fw_linear_lattice_create(solid, &def, error);
}

static fw_status make_particles(fw_solid **solid, const fw_sites *sites, fw_error *error)
{
    const fw_lattice lattice = {.kind = FW_HEXAGONAL, .spacing = 1};
    fw_vec2 position[SIDE * SIDE], velocity[SIDE * SIDE];
    fw_particle_group_def group = fw_particle_group_def_default();
    fw_particles_def def = fw_particles_def_default();
    for (int i = 0; i < sites->count; ++i) {
        position[i] = fw_lattice_position(&lattice, sites->site[i]);
        velocity[i] = fall;
    }
    group.name = "square";
    group.count = sites->count;
    group.positions = position;
    group.velocities = velocity;
    def.groups = &group;
    def.group_count = 1;
    return fw_particles_create(solid, &def, error);
}

static fw_status step(fw_scene *scene, int steps, fw_error *error)
{
    for (int n = 0; n < steps; ++n) FW_TRY(fw_scene_step(scene, error));
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    const fw_wall_ledger *floor = fw_scene_wall_ledger(scene, 0);
    const fw_energies now = fw_scene_energies(scene);
    const fw_ledger ledger = fw_scene_ledger(scene);
    const double off = fabs(now.kinetic + now.elastic - fw_ledger_energy(&ledger));
    printf("%-17s after %.0f: middle at y = %.2f, pushed up by %6.3f, energy %s\n",
           solid->model->name, fw_scene_time(scene), solid->model->centre_of_mass(solid).y,
           floor->impulse.y,
           off < 1e-12  ? "kept to rounding"
           : off < 1e-2 ? "kept to 0.01"
                        : "lost");
    return FW_OK;
}

/* The scene takes the solid over. */
static fw_status bounce(fw_solid *solid, double time, fw_error *error)
{
    const fw_vec2 corners[] = {{-20, -4.3}, {40, 50}};
    fw_wall_def box = fw_wall_def_default();
    fw_scene *scene;
    int body;
    box.name = "box";
    box.points = corners;
    box.point_count = 2;
    fw_status status = fw_scene_create(&scene, (fw_vec2){0, 0}, 1000, error);
    if (status != FW_OK) {
        fw_solid_destroy(solid);
        return status;
    }
    const int steps = (int)lround(time / solid->tick / solid->model->ticks_per_step);
    status = fw_scene_adopt_body(scene, "square", solid, &body, error);
    if (status == FW_OK) status = fw_scene_add_wall(scene, &box, error);
    if (status == FW_OK) status = fw_scene_begin(scene, error);
    if (status == FW_OK) status = step(scene, steps, error);
    fw_scene_destroy(scene);
    return status;
}

int main(void)
{
    fw_status (*const make[])(fw_solid **, const fw_sites *, fw_error *) = {
        make_boltzmann, make_automaton, make_linear, make_particles};
    fw_sites sites;
    fw_error error;
    fw_status status = fw_sites_rectangle(&sites, SIDE, SIDE, &error);
    for (int n = 0; n < 4 && status == FW_OK; ++n) {
        fw_solid *solid;
        status = make[n](&solid, &sites, &error);
        if (status == FW_OK) status = bounce(solid, 200, &error);
    }
    if (status != FW_OK) fprintf(stderr, "%s\n", error.sentence);
    fw_sites_clear(&sites);
    return (int)status;
}
