/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_fields.c - the fields of an LB solid that was displaced by G x are G at every site, in
 * the inside, at edges and at corners; and its energy and speed are those by hand. */
#include "tests/support/laws.h"

#include "core/boltzmann/lb_solid.h"

enum { COLUMNS = 5, ROWS = 4, COUNT = COLUMNS * ROWS };
static const double gxx = 0.01, gxy = 0.03, gyx = -0.02, gyy = 0.04;

/* By `part` of G x. */
static fw_solid *displaced(fw_lb_form form, double part, fw_vec2 velocity)
{
    fw_sites sites;
    fw_solid *solid;
    fw_error error;
    fw_vec2 u[COUNT], v[COUNT];
    assert_int_equal(fw_sites_rectangle(&sites, COLUMNS, ROWS, NULL), FW_OK);
    fw_lb_solid_def def = fw_lb_solid_def_default();
    for (int l = 0; l < COUNT; ++l) {
        const double x = part * sites.site[l].i, y = part * sites.site[l].j;
        u[l] = (fw_vec2){gxx * x + gxy * y, gyx * x + gyy * y};
        v[l] = velocity;
    }
    def.sites = &sites;
    def.displacement = u;
    def.velocity = v;
    def.form = form;
    if (fw_lb_solid_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    fw_sites_clear(&sites);
    return solid;
}

static void fill(const fw_solid *solid, const char *name, double values[COUNT])
{
    const fw_field *field = fw_solid_find_field(solid, name);
    assert_non_null(field);
    field->fill(solid, values);
}

static void a_linear_displacement_shows_its_gradient_everywhere(void **state)
{
    (void)state;
    static const fw_lb_form forms[] = {FW_LB_POPULATIONS, FW_LB_DISPLACEMENTS};
    static const struct {
        const char *name;
        double value;
    } strains[] = {{"strain-xx", gxx}, {"strain-yy", gyy}, {"strain-xy", 0.5 * (gxy + gyx)}};
    for (int f = 0; f < 2; ++f) {
        fw_solid *solid = displaced(forms[f], 1, (fw_vec2){0, 0});
        double values[COUNT];
        for (int n = 0; n < 3; ++n) {
            fill(solid, strains[n].name, values);
            for (int l = 0; l < COUNT; ++l) assert_close(values[l], strains[n].value, 1e-14);
        }
        fw_solid_destroy(solid);
    }
}

/* Two links at a corner, three at an edge, four inside. */
static void links_are_counted_from_all_sides(void **state)
{
    (void)state;
    fw_solid *solid = displaced(FW_LB_POPULATIONS, 0, (fw_vec2){0, 0});
    double values[COUNT];
    fill(solid, "links", values);
    for (int l = 0; l < COUNT; ++l) {
        const long i = lround(solid->x[l]), j = lround(solid->y[l]);
        const bool edge_x = i == 0 || i == COLUMNS - 1, edge_y = j == 0 || j == ROWS - 1;
        assert_close(values[l], 4 - edge_x - edge_y, 0);
    }
    fw_solid_destroy(solid);
}

static void a_body_in_flight_shows_its_speed(void **state)
{
    (void)state;
    fw_solid *solid = displaced(FW_LB_POPULATIONS, 0, (fw_vec2){0.03, -0.04});
    double values[COUNT], sum = 0;
    fill(solid, "speed", values);
    for (int l = 0; l < COUNT; ++l) assert_close(values[l], 0.05, 1e-14);
    fill(solid, "energy", values);
    for (int l = 0; l < COUNT; ++l) sum += values[l];
    const fw_energies energies = fw_solid_energies(solid);
    assert_close(sum, energies.kinetic + energies.elastic, 1e-14);
    fw_solid_destroy(solid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_linear_displacement_shows_its_gradient_everywhere),
        cmocka_unit_test(links_are_counted_from_all_sides),
        cmocka_unit_test(a_body_in_flight_shows_its_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
