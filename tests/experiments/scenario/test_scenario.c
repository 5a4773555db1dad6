/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scenario.c - a scenario means what it says: values, defaults, sites, --set, and what is
 * printed as run. */
#include "tests/support/laws.h"

#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/scenario.h"

#include <stdlib.h>
#include <string.h>

static const char everything[] =
    "title: Everything at once\n"
    "source: A paper\n"
    "figure: Fig. 7\n"
    "about: |\n"
    "  Two lines\n"
    "  of text.\n"
    "materials:\n"
    "  rubber: {lattice-boltzmann: {rest-mass: [[1, 0.6], [0.6, 0.3]], damping: 0.1,\n"
    "           link-stiffness: [2, 0.5, 1], break-at: 0.25}}\n"
    "  plain: {lattice-boltzmann: {}}\n"
    "bodies:\n"
    "  sheet:\n"
    "    material: plain\n"
    "    shape: {rectangle: [20, 10]}\n"
    "    spacing: 1.5\n"
    "    angle: 90\n"
    "    origin: [7.313, 11.747]\n"
    "    velocity: [0.05, 0.031]\n"
    "    displacement:\n"
    "      - {sites: [[3, 4], [2, 4], [0, 0]], by: [0.1, 0]}\n"
    "      - {gaussian: {amplitude: [0, 1], centre: [9.5, 4.5], width: 3}}\n"
    "    velocities:\n"
    "      - {sites: {side: top, layers: 2, columns: [5, 7]}, random: 0.01}\n"
    "      - {wave: {amplitude: [1, 2], wave-vector: [0.1, 0.2], phase: -45}}\n"
    "    rest-mass:\n"
    "      - {sites: left, value: 2}\n"
    "    link-stiffness:\n"
    "      - {sites: {rows: [3, 4]}, links: across, value: [1, 0, 4]}\n"
    "  blob: {material: rubber, shape: {mask: \".##\\n##.\\n\"}}\n"
    "  disc: {material: rubber, shape: {disc: 2.5}, origin: [-40, 0]}\n"
    "walls:\n"
    "  container: {box: [0, 0, 60, 50]}\n"
    "  hill: {polygon: [[0, 0], [9, 0], [0, 9]], side: outside, surface: stick}\n"
    "  ring: {circle: [1, 2, 3], surface: {coulomb: 0.3},\n"
    "         path: {velocity: [1, 0], from: 2, until: 5, amplitude: [0, 1], period: 8, phase: "
    "90}}\n"
    "  floor: {chain: [[0, 0], [9, 1], [9, 9]], closed: true}\n"
    "forces:\n"
    "  pull: {body: sheet, sites: right, total: [0.1, 0], from: 10, until: 20, ramp: 5}\n"
    "  shake: {body: blob, random: 0.5, balanced: true}\n"
    "  weight: {body: blob, acceleration: [0, -1e-4], period: 40, phase: 180}\n"
    "run: {steps: 4000, measure-every: 10, seed: 7, limit: 500, reverse-at: 1000}\n"
    "record: {velocity: false, force: true, fields: [energy]}\n"
    "measure: [energy, momentum]\n"
    "expect:\n"
    "  - {quantity: energy-drift, below: 1e-11}\n"
    "  - {quantity: fraction, body: sheet, site: [19, 9], component: x, at: 2000, value: -0.81,\n"
    "     within-relative: 0.01, source: Table 1, note: slow}\n"
    "  - {quantity: reaction, wall: floor, statistic: mean, from: 100, until: 200, above: 1, below: 2}\n"
    "pictures:\n"
    "  motion: {kind: motion, instants: [0, 100, 4000], title: Here}\n"
    "  curve: {kind: series, observables: [energy, momentum]}\n";

static fw_scenario *read_text(const char *text, const char *const *settings, int setting_count)
{
    fw_scenario *scenario;
    fw_error error;
    fw_status status = fw_scenario_read(&scenario, "test.yaml", text, strlen(text), settings,
                                        setting_count, &error);
    if (status != FW_OK) fail_msg("%s", error.sentence);
    return scenario;
}

static void assert_vector(fw_vec2 found, double x, double y)
{
    assert_close(found.x, x, 0);
    assert_close(found.y, y, 0);
}

static void materials_and_bodies_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_text(everything, NULL, 0);
    assert_string_equal(s->title, "Everything at once");
    assert_string_equal(s->about, "Two lines\nof text.\n");
    assert_int_equal(s->material_count, 2);
    fw_scenario_boltzmann rubber = s->materials[0].boltzmann, plain = s->materials[1].boltzmann;
    assert_close(rubber.rest_mass.xx, 1, 0);
    assert_close(rubber.rest_mass.xy, 0.6, 0);
    assert_close(rubber.rest_mass.yy, 0.3, 0);
    assert_close(rubber.damping, 0.1, 0);
    assert_close(rubber.link_stiffness.xy, 0.5, 0);
    assert_close(rubber.break_at, 0.25, 0);
    assert_close(plain.damping, 0, 0);
    assert_close(plain.link_stiffness.xx, 1, 0);
    assert_close(plain.link_stiffness.xy, 0, 0);
    assert_close(plain.break_at, 0, 0);

    const fw_scenario_body *sheet = &s->bodies[0];
    assert_int_equal(s->body_count, 3);
    assert_string_equal(sheet->name, "sheet");
    assert_int_equal(sheet->material, 1);
    assert_int_equal(sheet->place.line, 12);
    assert_int_equal(sheet->lattice.kind, FW_SQUARE);
    assert_close(sheet->lattice.spacing, 1.5, 0);
    assert_close(sheet->lattice.angle, FW_PI / 2, 1e-15);
    assert_vector(sheet->lattice.origin, 7.313, 11.747);
    assert_vector(sheet->velocity, 0.05, 0.031);
    assert_close(s->bodies[1].lattice.spacing, 1, 0);
    assert_vector(s->bodies[1].velocity, 0, 0);
    fw_scenario_destroy(s);
    fw_scenario_destroy(NULL);
}

static void starting_values_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_text(everything, NULL, 0);
    const fw_scenario_body *sheet = &s->bodies[0];
    assert_int_equal(sheet->displacement.count, 2);
    assert_int_equal(sheet->displacement.item[0].kind, FW_PATTERN_UNIFORM);
    assert_vector(sheet->displacement.item[0].amplitude, 0.1, 0);
    fw_pattern hill = sheet->displacement.item[1], wave = sheet->velocities.item[1];
    assert_int_equal(hill.kind, FW_PATTERN_GAUSSIAN);
    assert_vector(hill.amplitude, 0, 1);
    assert_vector(hill.centre, 9.5, 4.5);
    assert_close(hill.width, 3, 0);
    assert_int_equal(sheet->velocities.item[0].kind, FW_PATTERN_RANDOM);
    assert_close(sheet->velocities.item[0].random, 0.01, 0);
    assert_int_equal(wave.kind, FW_PATTERN_WAVE);
    assert_vector(wave.wave_vector, 0.1, 0.2);
    assert_close(wave.phase, -FW_PI / 4, 1e-15);
    assert_close(sheet->rest_mass.item[0].value.yy, 2, 0);
    assert_int_equal(sheet->link_stiffness.item[0].links, FW_LINKS_ACROSS);
    assert_close(sheet->link_stiffness.item[0].value.yy, 4, 0);
    fw_scenario_destroy(s);
}

static void walls_and_forces_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_text(everything, NULL, 0);
    assert_int_equal(s->wall_count, 4);
    const fw_wall_def *box = &s->walls[0].def, *hill = &s->walls[1].def;
    const fw_wall_def *ring = &s->walls[2].def, *floor_chain = &s->walls[3].def;
    assert_string_equal(box->name, "container");
    assert_int_equal(box->shape, FW_BOX);
    assert_int_equal(box->side, FW_INSIDE);
    assert_int_equal(box->surface.law, FW_FRICTIONLESS);
    assert_vector(box->points[1], 60, 50);
    assert_close(box->path.period, 0, 0);
    assert_int_equal(hill->shape, FW_POLYGON);
    assert_int_equal(hill->point_count, 3);
    assert_int_equal(hill->side, FW_OUTSIDE);
    assert_int_equal(hill->surface.law, FW_STICK);
    assert_int_equal(ring->shape, FW_CIRCLE);
    assert_close(ring->radius, 3, 0);
    assert_int_equal(ring->surface.law, FW_COULOMB);
    assert_close(ring->surface.friction, 0.3, 0);
    assert_vector(ring->path.velocity, 1, 0);
    assert_close(ring->path.until, 5, 0);
    assert_close(ring->path.phase, FW_PI / 2, 1e-15);
    assert_int_equal(floor_chain->shape, FW_CHAIN);
    assert_true(floor_chain->closed);

    assert_int_equal(s->force_count, 3);
    fw_scenario_force pull = s->forces[0], shake = s->forces[1], weight = s->forces[2];
    assert_int_equal(pull.kind, FW_FORCE_TOTAL);
    assert_int_equal(pull.body, 0);
    assert_vector(pull.vector, 0.1, 0);
    assert_true(pull.from == 10 && pull.until == 20 && pull.ramp == 5);
    assert_int_equal(shake.kind, FW_FORCE_RANDOM);
    assert_int_equal(shake.body, 1);
    assert_close(shake.random, 0.5, 0);
    assert_true(shake.balanced);
    assert_true(shake.from == 0 && shake.until == INT64_MAX && shake.period == 0);
    assert_int_equal(weight.kind, FW_FORCE_ACCELERATION);
    assert_close(weight.period, 40, 0);
    fw_scenario_destroy(s);
}

static void the_run_and_what_it_should_show_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_text(everything, NULL, 0);
    assert_true(s->run.steps == 4000 && s->run.record_every == 20 && s->run.measure_every == 10);
    assert_true(s->run.seed == 7 && s->run.reverse_at == 1000 && s->run.checkpoint_every == 0);
    assert_close(s->run.limit, 500, 0);
    assert_true(!s->record.velocity && s->record.force);
    assert_string_equal(s->record.fields.item[0].text, "energy");
    assert_int_equal(s->measure.count, 2);
    assert_string_equal(s->measure.item[1].text, "momentum");

    assert_int_equal(s->expectation_count, 3);
    const fw_expectation *drift = &s->expectations[0], *fraction = &s->expectations[1];
    const fw_expectation *reaction = &s->expectations[2];
    assert_int_equal(drift->kind, FW_VERDICT_BOUNDS);
    assert_true(drift->has_below && !drift->has_above && !drift->has_at);
    assert_int_equal(drift->statistic, FW_STATISTIC_LAST);
    assert_true(drift->body_index == -1 && drift->wall_index == -1 && !drift->body.text);
    assert_int_equal(fraction->kind, FW_VERDICT_RELATIVE);
    assert_true(fraction->has_at && fraction->at == 2000 && fraction->has_site);
    assert_true(fraction->site.i == 19 && fraction->site.j == 9 && fraction->body_index == 0);
    assert_close(fraction->value, -0.81, 0);
    assert_close(fraction->within, 0.01, 0);
    assert_string_equal(fraction->component.text, "x");
    assert_string_equal(fraction->source, "Table 1");
    assert_int_equal(reaction->statistic, FW_STATISTIC_MEAN);
    assert_true(reaction->wall_index == 3 && reaction->from == 100 && reaction->until == 200);
    assert_true(reaction->has_above && reaction->has_below);

    assert_int_equal(s->picture_count, 2);
    assert_int_equal(s->pictures[0].instant_count, 3);
    assert_true(s->pictures[0].instants[2] == 4000);
    assert_string_equal(s->pictures[0].title, "Here");
    assert_int_equal(s->pictures[1].kind, FW_PICTURE_SERIES);
    assert_int_equal(s->pictures[1].observables.count, 2);
    fw_scenario_destroy(s);
}

static int select_sites(const fw_scenario_body *body, const fw_selection *selection, fw_site *first,
                        fw_site *last)
{
    fw_sites sites;
    int *particles, count;
    assert_int_equal(fw_scenario_sites(body, &sites, NULL), FW_OK);
    assert_int_equal(sites.count, body->shape.count);
    assert_int_equal(fw_selection_particles(selection, &sites, &particles, &count, NULL), FW_OK);
    assert_true(count > 0);
    for (int n = 1; n < count; ++n) assert_true(particles[n] > particles[n - 1]);
    *first = sites.site[particles[0]];
    *last = sites.site[particles[count - 1]];
    free(particles);
    fw_sites_clear(&sites);
    return count;
}

static void selections_take_the_sites_they_name(void **state)
{
    (void)state;
    fw_scenario *s = read_text(everything, NULL, 0);
    const fw_scenario_body *sheet = &s->bodies[0];
    fw_site a, b;
    assert_int_equal(select_sites(sheet, &sheet->displacement.item[0].sites, &a, &b), 3);
    assert_true(a.i == 0 && a.j == 0 && b.i == 3 && b.j == 4);
    assert_int_equal(select_sites(sheet, &sheet->displacement.item[1].sites, &a, &b), 200);
    assert_int_equal(select_sites(sheet, &sheet->velocities.item[0].sites, &a, &b), 2 * 3);
    assert_true(a.i == 5 && a.j == 8 && b.i == 7 && b.j == 9);
    assert_int_equal(select_sites(sheet, &sheet->rest_mass.item[0].sites, &a, &b), 10);
    assert_true(a.i == 0 && b.i == 0);
    assert_int_equal(select_sites(sheet, &sheet->link_stiffness.item[0].sites, &a, &b), 2 * 20);
    assert_int_equal(select_sites(sheet, &s->forces[0].sites, &a, &b), 10);
    assert_true(a.i == 19 && b.i == 19);
    assert_int_equal(select_sites(&s->bodies[1], &s->forces[1].sites, &a, &b), 4);
    assert_true(a.i == 0 && a.j == 0 && b.i == 2 && b.j == 1);
    fw_scenario_destroy(s);
}

/* The count and the frame of a disc are found without making it; both must be those of the sites
 * that are made in the end. */
static void a_disc_is_measured_as_it_is_made(void **state)
{
    (void)state;
    static const double radii[] = {0, 0.5, 1, 1.4142135623730951, 2.5, 5, 13, 25.000001, 65};
    for (size_t n = 0; n < sizeof radii / sizeof radii[0]; ++n) {
        char setting[80];
        snprintf(setting, sizeof setting, "bodies.disc.shape.disc=%.17g", radii[n]);
        const char *settings[] = {setting};
        fw_scenario *s = read_text(everything, settings, 1);
        const fw_scenario_body *disc = &s->bodies[2];
        fw_sites sites;
        assert_int_equal(fw_scenario_sites(disc, &sites, NULL), FW_OK);
        assert_int_equal(sites.count, disc->shape.count);
        assert_int_equal(sites.site[0].j, disc->shape.first_row);
        assert_int_equal(sites.site[sites.count - 1].j, disc->shape.last_row);
        assert_int_equal(disc->shape.last_column, (int)floor(radii[n]));
        assert_int_equal(disc->shape.first_column, -(int)floor(radii[n]));
        fw_sites_clear(&sites);
        fw_scenario_destroy(s);
    }
}

static void settings_replace_and_add(void **state)
{
    (void)state;
    static const char *const settings[] = {
        "bodies.sheet.velocity=[.1,0]",
        "bodies.sheet.shape.mask=\"##\\n##\\n##\"",
        "bodies.sheet={material: rubber, shape: {rectangle: [3, 2]}}",
        "bodies.sheet.velocity=[.2,0]",
        "walls={}",
        "walls.left={chain: [[0, 9], [0, 0]]}",
        "expect.2.wall=left",
        "expect.1={quantity: momentum, statistic: largest, below: 1}",
        "expect.3={quantity: energy, above: 0}",
        "forces.pull.force=[1, 2]",
        "forces.pull.sites=[[2, 1]]",
        "record.fields=[]",
        "run.steps=5000",
        "run.seed=12",
        "run.seed=13",
    };
    fw_scenario *s = read_text(everything, settings, sizeof settings / sizeof settings[0]);
    assert_int_equal(s->bodies[0].material, 0);
    assert_vector(s->bodies[0].velocity, 0.2, 0);
    assert_vector(s->bodies[0].lattice.origin, 0, 0);
    assert_true(s->bodies[0].shape.count == 6);
    assert_int_equal(s->wall_count, 1);
    assert_int_equal(s->walls[0].def.shape, FW_CHAIN);
    assert_int_equal(s->expectation_count, 4);
    assert_int_equal(s->expectations[1].statistic, FW_STATISTIC_LARGEST);
    assert_int_equal(s->expectations[2].wall_index, 0);
    assert_true(s->expectations[3].has_above);
    assert_int_equal(s->forces[0].kind, FW_FORCE_EACH); /* one alternative in place of another */
    assert_int_equal(s->record.fields.count, 0);
    assert_true(s->run.steps == 5000 && s->run.seed == 13);
    fw_scenario_destroy(s);
}

static char *print(const fw_scenario *scenario)
{
    char *text;
    fw_error error;
    assert_int_equal(fw_scenario_print(scenario, &text, &error), FW_OK);
    return text;
}

static void assert_same_scenario(const fw_scenario *a, const fw_scenario *b)
{
    assert_string_equal(a->title, b->title);
    assert_memory_equal(&a->run, &b->run, sizeof a->run);
    assert_int_equal(a->body_count, b->body_count);
    for (int n = 0; n < a->body_count; ++n) {
        assert_memory_equal(&a->bodies[n].lattice, &b->bodies[n].lattice, sizeof(fw_lattice));
        assert_memory_equal(&a->bodies[n].velocity, &b->bodies[n].velocity, sizeof(fw_vec2));
        assert_true(a->bodies[n].shape.count == b->bodies[n].shape.count);
        assert_int_equal(a->bodies[n].displacement.count, b->bodies[n].displacement.count);
    }
    for (int n = 0; n < a->material_count; ++n)
        assert_memory_equal(&a->materials[n].boltzmann, &b->materials[n].boltzmann,
                            sizeof(fw_scenario_boltzmann));
    assert_int_equal(a->wall_count, b->wall_count);
    for (int n = 0; n < a->wall_count; ++n)
        assert_memory_equal(&a->walls[n].def.path, &b->walls[n].def.path, sizeof(fw_path));
    assert_int_equal(a->force_count, b->force_count);
    assert_int_equal(a->expectation_count, b->expectation_count);
    assert_int_equal(a->picture_count, b->picture_count);
}

/* `resume` builds the scene from the text in the results file. */
static void what_is_printed_is_the_scenario_as_run(void **state)
{
    (void)state;
    static const char *const settings[] = {"bodies.sheet.velocity=[.1, 1e-3]", "run.seed=9",
                                           "materials.plain.lattice-boltzmann.rest-mass=1.3"};
    fw_scenario *s = read_text(everything, settings, 3);
    char *text = print(s);
    fw_scenario *again = read_text(text, NULL, 0);
    assert_same_scenario(s, again);
    assert_true(again->run.seed == 9);
    assert_string_equal(again->about, s->about);
    char *text_again = print(again);
    assert_string_equal(text, text_again);
    free(text);
    free(text_again);
    fw_scenario_destroy(s);
    fw_scenario_destroy(again);
}

static void every_experiment_of_the_catalogue_is_whole(void **state)
{
    (void)state;
    const char *before = "";
    for (const fw_catalogue_entry *entry = fw_catalogue; entry->name; ++entry) {
        assert_true(strcmp(before, entry->name) < 0);
        before = entry->name;
        assert_int_equal(strlen(entry->text), entry->length);
        fw_scenario *s;
        fw_error error;
        fw_status status =
            fw_scenario_read(&s, entry->name, entry->text, entry->length, NULL, 0, &error);
        if (status != FW_OK) fail_msg("%s", error.sentence);
        if (s->expectation_count == 0) fail_msg("%s expects nothing", entry->name);
        const fw_catalogue_entry *found;
        if (s->small.text) {
            assert_int_equal(fw_catalogue_find(&found, s->small.text, NULL), FW_OK);
            assert_ptr_not_equal(found, entry);
        }
        fw_scenario_destroy(s);
        assert_int_equal(fw_catalogue_find(&found, entry->name, NULL), FW_OK);
        assert_ptr_equal(found, entry);
    }
    const fw_catalogue_entry *none;
    fw_error error;
    assert_int_equal(fw_catalogue_find(&none, "xyzzy", &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "there is no experiment 'xyzzy', expected one that "
                                        "`fretwork list` shows, or a scenario file");
    assert_null(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_and_bodies_are_what_was_written),
        cmocka_unit_test(starting_values_are_what_was_written),
        cmocka_unit_test(walls_and_forces_are_what_was_written),
        cmocka_unit_test(the_run_and_what_it_should_show_are_what_was_written),
        cmocka_unit_test(selections_take_the_sites_they_name),
        cmocka_unit_test(a_disc_is_measured_as_it_is_made),
        cmocka_unit_test(settings_replace_and_add),
        cmocka_unit_test(what_is_printed_is_the_scenario_as_run),
        cmocka_unit_test(every_experiment_of_the_catalogue_is_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
