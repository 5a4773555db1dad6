/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenes.h - what tests of scenes share: LB bodies, steps that must not fail, ledgers that
 * must close, and states that go on elsewhere. */
#ifndef FW_TEST_SCENES_H
#define FW_TEST_SCENES_H

#include "contact/scene/scene.h"
#include "core/boltzmann/lb_solid.h"
#include "tests/support/laws.h"
#include "tests/support/scene_hash.h"

#include <stdlib.h>
#include <string.h>

static fw_error error;

/* Fails with the sentence of `error`. */
static inline void must(fw_status status)
{
    if (status != FW_OK) fail_msg("%s", error.sentence);
}

typedef struct body_options {
    int columns, rows;
    fw_vec2 origin, velocity;
    double rest_mass, mu, angle;
    fw_sym2 rest_matrix;
    fw_lb_form form; /* populations, where nothing is said */
} body_options;

/* An LB body called "sheet". */
static inline void add_body(fw_scene *scene, body_options o)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, o.columns, o.rows, NULL), FW_OK);
    fw_vec2 *velocity = malloc((size_t)sites.count * sizeof *velocity);
    for (int l = 0; l < sites.count; ++l) velocity[l] = o.velocity;
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    def.lattice.origin = o.origin;
    def.lattice.angle = o.angle;
    def.velocity = velocity;
    def.rest_mass = o.rest_matrix.xx != 0 ? o.rest_matrix : fw_sym2_scalar(o.rest_mass);
    def.mu = o.mu > 0 ? o.mu : 1;
    def.form = o.form;
    fw_solid *solid;
    must(fw_lb_solid_create(&solid, &def, &error));
    int body;
    must(fw_scene_adopt_body(scene, "sheet", solid, &body, &error));
    free(velocity);
    fw_sites_clear(&sites);
}

static inline fw_scene *empty_scene(double limit)
{
    fw_scene *scene;
    must(fw_scene_create(&scene, (fw_vec2){0, 0}, limit, &error));
    return scene;
}

static inline void begin(fw_scene *scene)
{
    must(fw_scene_begin(scene, &error));
}

static inline void run(fw_scene *scene, int steps)
{
    for (int t = 0; t < steps; ++t) must(fw_scene_step(scene, &error));
}

static inline double energy_of(const fw_scene *scene)
{
    const fw_energies e = fw_scene_energies(scene);
    return e.kinetic + e.elastic;
}

static inline fw_vec2 velocity_of(const fw_scene *scene, int body)
{
    const fw_solid *solid = fw_scene_observe_body(scene, body);
    return fw_sym2_apply(fw_sym2_invert(solid->model->mass(solid)), fw_solid_momentum(solid));
}

/* Energy to `tolerance` of the largest so far, momentum to 100 times that. */
static inline void assert_ledger_closes(const fw_scene *scene, double tolerance)
{
    const fw_ledger ledger = fw_scene_ledger(scene);
    const fw_vec2 p = fw_scene_momentum(scene), wanted = fw_ledger_momentum(&ledger);
    assert_close(energy_of(scene), fw_ledger_energy(&ledger),
                 tolerance * fw_scene_energy_scale(scene));
    assert_close(p.x, wanted.x, 100 * tolerance);
    assert_close(p.y, wanted.y, 100 * tolerance);
}

/* Into a scene that was made in the same way. */
static inline void copy_state(fw_scene *from, fw_scene *to)
{
    for (int n = 0; n < fw_scene_section_count(from); ++n) {
        fw_state_list source = {0}, target = {0};
        fw_scene_section(from, n, &source);
        fw_scene_section(to, n, &target);
        for (int k = 0; k < source.count; ++k)
            if (source.array[k].count > 0)
                memcpy(target.array[k].data, source.array[k].data,
                       source.array[k].count * fw_element_size(source.array[k].element));
    }
    must(fw_scene_restored(to, &error));
}

/* A run to tick `ticks`, and runs whose state goes over into another scene at tick `from` and every
 * `apart` ticks from there, end with the same bytes. `make`: a scene that has begun. */
static inline void assert_goes_on_elsewhere(fw_scene *(*make)(void), int ticks, int from, int apart)
{
    fw_scene *whole = make();
    run(whole, ticks);
    for (int at = from; at < ticks; at += apart) {
        fw_scene *first = make(), *second = make();
        run(first, at);
        copy_state(first, second);
        run(second, ticks - at);
        assert_true(hash_of_scene(second) == hash_of_scene(whole));
        fw_scene_destroy(first);
        fw_scene_destroy(second);
    }
    fw_scene_destroy(whole);
}

/* What bodies gave each other, each by its first part, adds up to nothing. */
static inline void assert_action_is_reaction(const fw_scene *scene, int bodies, double tolerance)
{
    fw_vec2 sum = {0, 0};
    for (int b = 0; b < bodies; ++b)
        sum = fw_vec2_add(sum, fw_scene_body_ledger(scene, b, 0)->impulse);
    assert_close(sum.x, 0, tolerance);
    assert_close(sum.y, 0, tolerance);
}

#endif
