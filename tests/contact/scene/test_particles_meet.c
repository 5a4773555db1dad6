/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particles_meet.c - bodies of movable particles on which no potential acts across: they keep
 * out of each other, and out of linear lattices, also where they flow. */
#include "tests/support/scenes.h"

#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

#include <omp.h>

typedef struct crystals {
    double across, step, temperature, speed, gap, amplitude;
    int columns;
} crystals;

static const crystals usual = {
    .step = 0.01, .speed = 0.3, .gap = 1.01, .amplitude = 1, .columns = 8};

/* Two bodies of one solid, side by side; the left one flies. */
static fw_solid *add_crystals(fw_scene *scene, crystals o)
{
    fw_sites sites;
    must(fw_sites_rectangle(&sites, o.columns, o.columns, &error));
    const size_t count = (size_t)sites.count;
    fw_vec2 *places = malloc(2 * count * sizeof *places);
    fw_vec2 *velocities = calloc(2 * count, sizeof *velocities);
    fw_lattice lattice = {.kind = FW_HEXAGONAL, .spacing = 1};
    for (size_t l = 0; l < count; ++l) {
        places[l] = fw_lattice_position(&lattice, sites.site[l]);
        places[count + l] = fw_vec2_add(places[l], (fw_vec2){o.columns - 0.5 + o.gap, 0.37});
        velocities[l].x = o.speed;
    }
    fw_particle_group_def groups[2];
    for (int g = 0; g < 2; ++g) {
        groups[g] = fw_particle_group_def_default();
        groups[g].name = g == 0 ? "left" : "right";
        groups[g].count = sites.count;
        groups[g].positions = places + (size_t)g * count;
        groups[g].velocities = velocities + (size_t)g * count;
        groups[g].return_force.amplitude = o.amplitude;
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    def.strength_across = o.across;
    def.controls.time_step = o.step;
    def.controls.temperature = o.temperature;
    def.controls.damping = o.temperature > 0 ? 0.5 : 0;
    fw_solid *solid;
    int body;
    must(fw_particles_create(&solid, &def, &error));
    must(fw_scene_adopt_body(scene, "crystals", solid, &body, &error));
    free(places);
    free(velocities);
    fw_sites_clear(&sites);
    return solid;
}

static double energy_missed(double step)
{
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.step = step;
    fw_solid *solid = add_crystals(scene, o);
    begin(scene);
    const double energy = energy_of(scene);
    const fw_vec2 momentum = fw_scene_momentum(scene);
    double missed = 0;
    for (int t = 0; t < (int)(12 / step); ++t) {
        must(fw_scene_step(scene, &error));
        missed = fmax(missed, fabs(energy_of(scene) - energy));
        assert_true(fw_scene_body_penetration(scene) == 0);
    }
    assert_close(fw_scene_momentum(scene).x, momentum.x, 1e-11);
    assert_close(fw_scene_momentum(scene).y, momentum.y, 1e-11);
    assert_true(fw_scene_contact_ledger(scene)->ticks > 5);
    assert_true(fw_scene_contact_ledger(scene)->unconverged == 0);
    /* Action and reaction of the parts, and what they did: the right one flies, too. */
    const fw_vec2 left = fw_scene_body_ledger(scene, 0, 0)->impulse;
    const fw_vec2 right = fw_scene_body_ledger(scene, 0, 1)->impulse;
    assert_close(left.x + right.x, 0, 1e-12);
    assert_close(left.y + right.y, 0, 1e-12);
    double carried = 0;
    for (int l = 64; l < 128; ++l) carried += fw_langevin_velocity(solid, l).x;
    assert_close(carried, right.x, 1e-11);
    assert_true(carried > 10);
    fw_scene_destroy(scene);
    return missed;
}

static void crystals_collide_as_exactly_as_verlet_steps(void **state)
{
    (void)state;
    const double coarse = energy_missed(0.02), fine = energy_missed(0.005);
    assert_true(coarse < 0.05);
    assert_true(fine < coarse / 6); /* 16 for a smooth force; gaps of landing are chance */
}

static void potential_across_lets_no_contact_act(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.across = 1;
    add_crystals(scene, o);
    begin(scene);
    run(scene, 200);
    assert_true(fw_scene_contact_ledger(scene)->ticks == 0);
    fw_scene_destroy(scene);
}

/* Hot enough for bonds to break and edges to change. */
static void bodies_that_flow_keep_out_of_each_other(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.temperature = 0.25;
    o.gap = 0.1;
    o.speed = 1;
    o.amplitude = 0.2;
    fw_solid *solid = add_crystals(scene, o);
    begin(scene);
    const int links = solid->link_count;
    int changes = 0, before = links, deep = 0;
    double most = 0;
    for (int t = 0; t < 3000; ++t) {
        run(scene, 1);
        changes += solid->link_count != before;
        before = solid->link_count;
        deep += fw_scene_body_penetration(scene) > 1e-9;
        most = fmax(most, fw_scene_body_penetration(scene));
    }
    printf("%d %d %g %g\n", changes, deep, most + 0 * fw_scene_contact_ledger(scene)->ticks,
           fw_scene_body_penetration(scene));
    assert_true(changes > 100);
    assert_true(fw_scene_contact_ledger(scene)->ticks > 50);
    /* Where bonds form, matter is where none was: a particle of the other body may lie in it, until
     * it leaves. */
    assert_true(deep < 300 && most < 0.3);
    assert_true(fw_scene_body_penetration(scene) == 0);
    fw_scene_destroy(scene);
}

static void particles_without_a_potential_are_no_matter(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    fw_particle_group_def groups[2];
    const fw_vec2 places[] = {{0, 0}, {1, 0}, {0.5, 0.8}};
    for (int g = 0; g < 2; ++g) {
        groups[g] = fw_particle_group_def_default();
        groups[g].name = g == 0 ? "one" : "other";
        groups[g].count = 3;
        groups[g].positions = places;
        groups[g].strength = 0;
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    def.strength_across = 0;
    fw_solid *solid;
    int body;
    must(fw_particles_create(&solid, &def, &error));
    must(fw_scene_adopt_body(scene, "gas", solid, &body, &error));
    begin(scene);
    assert_int_equal(solid->link_count, 0);
    fw_scene_destroy(scene);
}

static void crystal_and_linear_lattice_meet(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.across = 1; /* both crystals are one body to others */
    add_crystals(scene, o);
    fw_sites sites;
    must(fw_sites_rectangle(&sites, 6, 6, &error));
    fw_vec2 velocity[36];
    for (int l = 0; l < 36; ++l) velocity[l] = (fw_vec2){0, 0.4};
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.lattice = (fw_lattice){.kind = FW_HEXAGONAL, .spacing = 1, .origin = {6, -5}};
    def.velocities = velocity;
    def.controls.time_step = o.step;
    fw_solid *lattice;
    int body;
    must(fw_linear_lattice_create(&lattice, &def, &error));
    must(fw_scene_adopt_body(scene, "lattice", lattice, &body, &error));
    fw_sites_clear(&sites);
    begin(scene);
    const fw_vec2 momentum = fw_scene_momentum(scene);
    for (int t = 0; t < 1500; ++t) {
        run(scene, 1);
        assert_true(fw_scene_body_penetration(scene) == 0);
    }
    assert_true(fw_scene_contact_ledger(scene)->ticks > 5);
    assert_true(fw_solid_momentum(lattice).y < 10); /* of 14.4 */
    assert_close(fw_scene_momentum(scene).x, momentum.x, 1e-11);
    assert_close(fw_scene_momentum(scene).y, momentum.y, 1e-11);
    fw_scene_destroy(scene);
}

static void bodies_that_start_in_each_other_are_refused_by_name(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.gap = -0.3;
    add_crystals(scene, o);
    assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "starts in body"));
    assert_non_null(strstr(error.sentence, "right"));
    fw_scene_destroy(scene);
}

static fw_scene *hot_scene(void)
{
    fw_scene *scene = empty_scene(1e4);
    crystals o = usual;
    o.temperature = 0.2;
    o.gap = 0.2;
    o.amplitude = 0.2;
    add_crystals(scene, o);
    begin(scene);
    return scene;
}

static void run_that_goes_on_elsewhere_has_the_same_bytes(void **state)
{
    (void)state;
    assert_goes_on_elsewhere(hot_scene, 1500, 217, 391);
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    uint64_t hash[3];
    const int before = omp_get_max_threads();
    for (int n = 0; n < 3; ++n) {
        omp_set_num_threads(n + 1);
        fw_scene *scene = empty_scene(1e4);
        crystals o = usual;
        o.columns = 60;
        o.gap = 0.1;
        add_crystals(scene, o);
        begin(scene);
        run(scene, 160);
        assert_true(fw_scene_contact_ledger(scene)->ticks > 0);
        hash[n] = hash_of_scene(scene);
        fw_scene_destroy(scene);
    }
    omp_set_num_threads(before);
    assert_true(hash[0] == hash[1] && hash[0] == hash[2]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crystals_collide_as_exactly_as_verlet_steps),
        cmocka_unit_test(potential_across_lets_no_contact_act),
        cmocka_unit_test(bodies_that_flow_keep_out_of_each_other),
        cmocka_unit_test(particles_without_a_potential_are_no_matter),
        cmocka_unit_test(crystal_and_linear_lattice_meet),
        cmocka_unit_test(bodies_that_start_in_each_other_are_refused_by_name),
        cmocka_unit_test(run_that_goes_on_elsewhere_has_the_same_bytes),
        cmocka_unit_test(threads_do_not_change_a_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
