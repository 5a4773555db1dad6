/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_bodies.h - ragged LB bodies that move at random, with every kind of rest mass. */
#ifndef FW_LB_BODIES_H
#define FW_LB_BODIES_H

#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/boltzmann/lb_solid.h"

#include <stdlib.h>

/* Numbers in [-1, 1), the same in every run. */
static inline double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(*seed >> 11) / 4503599627370496.0 - 1;
}

/* A ragged, connected blob with holes: a random walk of `count` distinct sites. */
static inline fw_sites blob(int count, uint64_t seed)
{
    fw_site *list = malloc((size_t)count * sizeof *list);
    bool taken[101][101] = {{false}};
    fw_site at = {50, 50};
    int found = 0;
    while (found < count) {
        if (!taken[at.j][at.i]) {
            taken[at.j][at.i] = true;
            list[found++] = at;
        }
        fw_site next = fw_site_neighbour(at, (int)(2 * (random_number(&seed) + 1)));
        if (next.i > 0 && next.i < 100 && next.j > 0 && next.j < 100) at = next;
    }
    fw_sites sites;
    assert_int_equal(fw_sites_list(&sites, list, count, NULL), FW_OK);
    free(list);
    return sites;
}

static inline void push_at_random(fw_solid *solid, uint64_t *seed)
{
    solid->loaded = true;
    for (int l = 0; l < solid->count; ++l) {
        solid->external_x[l] = 0.1 * random_number(seed);
        solid->external_y[l] = 0.1 * random_number(seed);
    }
}

enum { REST_NONE, REST_SCALAR, REST_MATRIX, REST_PER_SITE, REST_KINDS };

static inline fw_solid *solid_in_form(fw_lb_form form, const fw_sites *sites, int kind, double mu,
                                      double break_at)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_sym2 *masses = malloc((size_t)sites->count * sizeof *masses);
    fw_vec2 *velocity = malloc((size_t)sites->count * sizeof *velocity);
    fw_vec2 *displacement = malloc((size_t)sites->count * sizeof *displacement);
    uint64_t seed = 77;
    for (int l = 0; l < sites->count; ++l) {
        masses[l] = (fw_sym2){1 + 0.5 * random_number(&seed), 0.3 * random_number(&seed),
                              1 + 0.5 * random_number(&seed)};
        velocity[l] = (fw_vec2){0.1 * random_number(&seed), 0.1 * random_number(&seed)};
        displacement[l] = (fw_vec2){0.1 * random_number(&seed), 0.1 * random_number(&seed)};
    }
    def.sites = sites;
    def.mu = mu;
    def.form = form;
    def.break_at = break_at;
    def.velocity = velocity;
    def.displacement = displacement;
    if (kind == REST_SCALAR) def.rest_mass = fw_sym2_scalar(1.3);
    if (kind == REST_MATRIX) def.rest_mass = (fw_sym2){1, 0.6, 0.3};
    if (kind == REST_PER_SITE) def.rest_masses = masses;
    fw_solid *solid;
    fw_error error;
    if (fw_lb_solid_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    free(masses);
    free(velocity);
    free(displacement);
    return solid;
}

static inline fw_solid *solid_of(const fw_sites *sites, int kind, double mu, double break_at)
{
    return solid_in_form(FW_LB_POPULATIONS, sites, kind, mu, break_at);
}

#endif
