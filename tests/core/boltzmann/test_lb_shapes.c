/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_shapes.c - links, boundary and masses of LB solids of any shape, against a search among
 * all sites; and bodies whose masses follow from numbers of links, against those that keep them. */
#include "tests/support/lb_bodies.h"

#include "core/boltzmann/lb_state.h"

#include <string.h>

enum { COLUMNS = 19, ROWS = 11 };

/* So many of a hundred sites at random, by rows, in columns on both sides of 0. */
static fw_sites draw_shape(int percent, uint64_t *seed)
{
    fw_site list[ROWS * COLUMNS];
    int count = 0;
    for (int j = 0; j < ROWS; ++j)
        for (int i = 0; i < COLUMNS; ++i)
            if (50 * (random_number(seed) + 1) < percent) list[count++] = (fw_site){i - 9, j - 4};
    fw_sites sites;
    assert_int_equal(fw_sites_list(&sites, list, count, NULL), FW_OK);
    return sites;
}

static fw_lb_solid_def def_of(const fw_sites *sites, fw_lb_form form)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = sites;
    def.form = form;
    def.rest_mass = fw_sym2_scalar(0.7); /* sites without links are allowed */
    return def;
}

static fw_solid *made(const fw_lb_solid_def *def)
{
    fw_solid *solid;
    fw_error error;
    if (fw_lb_solid_create(&solid, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return solid;
}

static int at(const fw_sites *sites, int i, int j)
{
    return fw_sites_find(sites, (fw_site){i, j});
}

static void expect_surroundings(const fw_sites *sites, const fw_solid *solid)
{
    int links = 0, exposed = 0;
    for (int l = 0; l < sites->count; ++l) {
        const int i = sites->site[l].i, j = sites->site[l].j;
        const int around[FW_DIRECTIONS] = {at(sites, i + 1, j), at(sites, i, j + 1),
                                           at(sites, i - 1, j), at(sites, i, j - 1)};
        bool inside = at(sites, i + 1, j + 1) >= 0 && at(sites, i - 1, j + 1) >= 0 &&
                      at(sites, i - 1, j - 1) >= 0 && at(sites, i + 1, j - 1) >= 0;
        int count = 0;
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            assert_int_equal(fw_lb_solid_neighbour(solid, l, d), around[d]);
            inside = inside && around[d] >= 0;
            count += around[d] >= 0;
            if (around[d] < 0 || d > FW_NORTH) continue;
            assert_true(links < solid->link_count);
            assert_int_equal(solid->links[links][0], l);
            assert_int_equal(solid->links[links++][1], around[d]);
        }
        if (!inside) {
            assert_true(exposed < solid->boundary_count);
            assert_int_equal(solid->boundary[exposed++], l);
        }
        const fw_sym2 mass = fw_lb_solid_mass(solid, l);
        assert_close(mass.xx, 0.5 * (0.49 + count), 1e-15);
        assert_true(mass.yy == mass.xx && mass.xy == 0);
    }
    assert_int_equal(links, solid->link_count);
    assert_int_equal(exposed, solid->boundary_count);
}

static void shapes_with_holes_have_the_links_of_their_sites(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int percent = 10; percent <= 100; percent += 5)
        for (int form = 0; form < 3; ++form) {
            fw_sites sites = draw_shape(percent, &seed);
            fw_lb_solid_def def =
                def_of(&sites, form == 0 ? FW_LB_DISPLACEMENTS : FW_LB_POPULATIONS);
            if (form == 2) def.break_at = 1;
            fw_solid *solid = made(&def);
            expect_surroundings(&sites, solid);
            fw_solid_destroy(solid);
            fw_sites_clear(&sites);
        }
}

static void expect_same_bytes(fw_solid *a, fw_solid *b)
{
    fw_state_list one = {0}, two = {0};
    fw_solid_place(a);
    fw_solid_place(b);
    a->model->state(a, &one);
    b->model->state(b, &two);
    assert_true(fw_state_list_hash(&one) == fw_state_list_hash(&two));
    double x[2][ROWS * COLUMNS], y[2][ROWS * COLUMNS];
    a->model->velocities(a, x[0], y[0]);
    b->model->velocities(b, x[1], y[1]);
    assert_memory_equal(x[0], x[1], (size_t)a->count * sizeof(double));
    assert_memory_equal(y[0], y[1], (size_t)a->count * sizeof(double));
    const fw_vec2 here = a->model->centre_of_mass(a), there = b->model->centre_of_mass(b);
    assert_true(here.x == there.x && here.y == there.y);
    assert_true(a->model->mass(a).xx == b->model->mass(b).xx);
    assert_true(a->model->reach(a, 20) == b->model->reach(b, 20) || a->loaded);
}

/* The same rest mass, said once or of each site. */
static void counted_masses_give_the_same_bytes(void **state)
{
    (void)state;
    const double rest[] = {0, 0.7}, mu[] = {1, 0.93};
    uint64_t seed = 11;
    for (int n = 0; n < 8; ++n) {
        fw_sites sites = n & 4 ? draw_shape(85, &seed) : blob(200, 3);
        if ((n & 4) && rest[n & 1] == 0) { /* no site without links then */
            fw_sites_clear(&sites);
            assert_int_equal(fw_sites_rectangle(&sites, COLUMNS, ROWS, NULL), FW_OK);
        }
        fw_sym2 masses[ROWS * COLUMNS];
        fw_vec2 velocity[ROWS * COLUMNS];
        for (int l = 0; l < sites.count; ++l) {
            masses[l] = fw_sym2_scalar(rest[n & 1]);
            velocity[l] = (fw_vec2){0.1 * random_number(&seed), 0.1 * random_number(&seed)};
        }
        fw_lb_solid_def def = def_of(&sites, FW_LB_DISPLACEMENTS);
        def.mu = mu[n >> 1 & 1];
        def.velocity = velocity;
        def.rest_mass = masses[0];
        fw_solid *counted = made(&def);
        def.rest_masses = masses;
        fw_solid *kept = made(&def);
        assert_true(((lb_solid *)counted)->counted && !((lb_solid *)kept)->counted);
        for (int step = 0; step < 40; ++step) {
            uint64_t same = (uint64_t)step, again = same;
            fw_error error;
            if (step % 4 == 1) {
                push_at_random(counted, &same);
                push_at_random(kept, &again);
            }
            assert_moved(fw_solid_move_free(counted, 1 + step % 3, &error), &error);
            assert_moved(fw_solid_move_free(kept, 1 + step % 3, &error), &error);
            if (step % 4 == 2) counted->loaded = kept->loaded = false;
        }
        counted->loaded = kept->loaded = false;
        expect_same_bytes(counted, kept);
        fw_solid_destroy(counted);
        fw_solid_destroy(kept);
        fw_sites_clear(&sites);
    }
}

/* Neither to the first site of the next row, nor behind the last one. */
static void links_that_never_were_are_refused(void **state)
{
    (void)state;
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 4, 3, NULL), FW_OK);
    fw_lb_solid_def def = def_of(&sites, FW_LB_POPULATIONS);
    def.break_at = 1;
    for (int last = 3; last < 12; last += 8) {
        fw_solid *solid = made(&def);
        lb_solid *lb = (lb_solid *)solid;
        fw_error error;
        assert_int_equal(fw_solid_restored(solid, &error), FW_OK);
        lb->present[last] |= 1u << FW_EAST;
        if (last + 1 < sites.count) lb->present[last + 1] |= 1u << FW_WEST;
        assert_int_equal(fw_solid_restored(solid, &error), FW_BAD_INPUT);
        assert_non_null(strstr(error.sentence, "leads nowhere"));
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_with_holes_have_the_links_of_their_sites),
        cmocka_unit_test(counted_masses_give_the_same_bytes),
        cmocka_unit_test(links_that_never_were_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
