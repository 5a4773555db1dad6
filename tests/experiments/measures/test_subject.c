/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_subject.c - names of bodies, walls, grips, sites and components, wherever one may stand. */
#include "tests/support/laws.h"

#include "experiments/measures/measurement.h"

#include <string.h>

static fw_error error;

static const char scene[] =
    "title: named\n"
    "materials: {m: {linear-lattice: {}}, p: {movable-particles: {}}}\n"
    "bodies:\n"
    "  b: {material: m, lattice: hexagonal, shape: {rectangle: [4, 3]}}\n"
    "  c: {material: m, lattice: hexagonal, shape: {rectangle: [2, 2]}, origin: [20, 0]}\n"
    "  d: {material: p, shape: {rectangle: [3, 3]}, lattice: hexagonal, origin: [40, 0]}\n"
    "walls: {floor: {chain: [[-50, -9], [50, -9]]}, roof: {chain: [[50, 9], [-50, 9]]}}\n"
    "grips: {left: {body: b, sites: left}, right: {body: b, sites: right}}\n"
    "run: {steps: 1}\n";

/* What `measure: [names]`, or a picture of them, measures: labels with blanks between. The standard
 * set is not there where `measure` is. NULL: refused. */
static const char *measured(const char *names, bool by_picture)
{
    static char labels[1024];
    char text[2048];
    if (by_picture)
        snprintf(text, sizeof text,
                 "%smeasure: [unresolved]\npictures: {p: {kind: series, observables: [%s]}}\n",
                 scene, names);
    else
        snprintf(text, sizeof text, "%smeasure: [unresolved, %s]\n", scene, names);
    fw_scenario *scenario;
    fw_observer *observer;
    fw_measurement *m;
    if (fw_scenario_read(&scenario, "s.yaml", text, strlen(text), NULL, 0, &error) != FW_OK)
        return NULL;
    if (fw_observer_create(&observer, scenario, &error) != FW_OK) fail_msg("%s", error.sentence);
    const fw_status status = fw_measurement_create(&m, observer, &error);
    labels[0] = '\0';
    for (int n = 1; status == FW_OK && n < m->probe_count; ++n)
        snprintf(labels + strlen(labels), sizeof labels - strlen(labels), "%s%s", n > 1 ? " " : "",
                 m->probes[n].label);
    if (status == FW_OK) fw_measurement_destroy(m);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
    return status == FW_OK ? labels : NULL;
}

static void names_mean_the_same_wherever_they_stand(void **state)
{
    (void)state;
    static const struct {
        const char *names, *labels;
    } rows[] = {
        {"energy", "energy"},
        {"energy.b", "energy.b"},
        {"momentum.b.x", "momentum.b"},
        {"momentum.x", "momentum"},
        {"elongation", "elongation.b elongation.c elongation.d"},
        {"elongation.c", "elongation.c"},
        {"elongation.c, elongation.c.y", "elongation.c"},
        {"reaction", "reaction.floor reaction.roof"},
        {"reaction.roof.y", "reaction.roof"},
        {"grip-force", "grip-force.left grip-force.right"},
        {"grip-force.right", "grip-force.right"},
        {"grip-force.right.x", "grip-force.right"},
        {"grip-work.left", "grip-work.left"},
        {"slip.y", "slip"},
        {"lab-order.d", "lab-order.d"},
    };
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n)
        for (int by_picture = 0; by_picture < 2; ++by_picture) {
            const char *labels = measured(rows[n].names, by_picture == 1);
            if (!labels) fail_msg("%s: %s", rows[n].names, error.sentence);
            assert_string_equal(labels, rows[n].labels);
        }
}

static void names_of_nothing_are_refused_wherever_they_stand(void **state)
{
    (void)state;
    static const struct {
        const char *names, *words;
    } rows[] = {
        {"energy.e", "energy is not measured of e, expected energy with the name of a body"},
        {"momentum.b.z", "momentum is not measured of b.z"},
        {"lab-order.b", "lab-order is not measured of b"},
        {"reaction.b", "with the name of a wall"},
        {"grip-force.floor", "with the name of a grip"},
        {"position", "is measured of a single site"},
        {"slip.left", "slip is not measured of left, expected slip alone"},
        {"interface-force", "there is nothing to measure interface-force of"},
        {"contact-return-force", "there is nothing to measure contact-return-force of"},
        {"layer-contact", "comes out of all runs together"},
        {"enrgy.b", "did you mean energy?"},
        {"layer-mobility", "it is now called layer-relative-displacement"},
    };
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n)
        for (int by_picture = 0; by_picture < 2; ++by_picture) {
            if (measured(rows[n].names, by_picture == 1)) fail_msg("%s is taken", rows[n].names);
            if (!strstr(error.sentence, rows[n].words))
                fail_msg("%s: '%s' lacks '%s'", rows[n].names, error.sentence, rows[n].words);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_mean_the_same_wherever_they_stand),
        cmocka_unit_test(names_of_nothing_are_refused_wherever_they_stand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
