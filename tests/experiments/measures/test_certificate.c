/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_certificate.c - a run's certificate has the worst of what was looked at, and only of what
 * applies. */
#include "tests/support/laws.h"

#include "experiments/measures/certificate.h"
#include "experiments/study/run.h"
#include "tests/support/scratch.h"

#include <string.h>

static char folder[64];

/* Runs to its end; into the folder. */
static fw_run *run_of(const char *text, fw_scenario **scenario)
{
    fw_run *run;
    const fw_run_options options = {.directory = folder, .overwrite = true, .threads = 1};
    assert_fine(fw_scenario_read(scenario, "s.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_run_begin(&run, *scenario, &options, &error));
    assert_fine(fw_run_to_end(run, &error));
    return run;
}

/* The largest size of a measured number. */
static double largest(const fw_run *run, const char *label, int component)
{
    const fw_measurement *m = fw_run_measurement(run);
    double most = 0;
    for (int n = 0; n < m->probe_count; ++n)
        for (int64_t row = 0; row < m->count && strcmp(m->probes[n].label, label) == 0; ++row)
            most = fmax(most, fabs(m->values[row * m->width + m->probes[n].first + component]));
    return most;
}

static double last(const fw_run *run, const char *label)
{
    const fw_measurement *m = fw_run_measurement(run);
    for (int n = 0; n < m->probe_count; ++n)
        if (strcmp(m->probes[n].label, label) == 0)
            return m->values[(m->count - 1) * m->width + m->probes[n].first];
    fail_msg("nothing is called %s", label);
    return NAN;
}

static const char pressed[] =
    "title: a sheet falls into a soft floor that rubs a hard wall\n"
    "materials: {felt: {lattice-boltzmann: {rest-mass: 0.4}}}\n"
    "bodies: {sheet: {material: felt, shape: {rectangle: [5, 4]}, origin: [0.2, 0.13],"
    " velocity: [-0.1, -0.2]}}\n"
    "walls:\n"
    "  floor: {box: [-50, -9, 50, 0], side: outside, surface: {penalty: 0.3}}\n"
    "  side: {chain: [[0, 50], [0, -50]], surface: {coulomb: 0.4}}\n"
    "run: {steps: 120, record-every: 10, measure-every: 2}\n"
    "measure: [energy-error, momentum-error, penetration, certificate-penetration,\n"
    "  certificate-energy, certificate-momentum, certificate-creep, unresolved]\n";

static void certificate_has_the_worst_of_the_samples(void **state)
{
    (void)state;
    fw_scenario *scenario;
    fw_run *run = run_of(pressed, &scenario);
    const fw_certificate *c = fw_run_certificate(run);
    assert_true(c->worst[FW_CERTIFICATE_PENETRATION] > 0.01);
    assert_close(c->worst[FW_CERTIFICATE_PENETRATION], largest(run, "penetration", 0), 0);
    assert_close(c->worst[FW_CERTIFICATE_ENERGY], largest(run, "energy-error", 0), 0);
    assert_true(c->worst[FW_CERTIFICATE_ENERGY] > 0);
    const double apart = fmax(largest(run, "momentum-error", 0), largest(run, "momentum-error", 1));
    assert_true(apart > 0);
    /* What it is a part of grows while the sheet is thrown back: by less than twice, to this. */
    const fw_scene *scene = fw_run_experiment(run)->scene;
    const fw_vec2 impulse = fw_scene_wall_ledger(scene, 0)->impulse;
    const double most =
        fmax(hypot(impulse.x, impulse.y), sqrt(2 * 20 * 2.4 * fw_scene_energy_scale(scene)));
    const double ratio = c->worst[FW_CERTIFICATE_MOMENTUM] / (apart / most);
    assert_true(ratio >= 1 && ratio < 2);
    assert_close(c->worst[FW_CERTIFICATE_UNRESOLVED], last(run, "unresolved"), 0);
    assert_true(!isnan(c->worst[FW_CERTIFICATE_CREEP]));
    assert_true(isnan(c->worst[FW_CERTIFICATE_UNCONVERGED]) != 0);
    /* Quantities say the same. */
    assert_close(last(run, "certificate-penetration"), c->worst[FW_CERTIFICATE_PENETRATION], 0);
    assert_close(last(run, "certificate-energy"), c->worst[FW_CERTIFICATE_ENERGY], 0);
    assert_close(last(run, "certificate-momentum"), c->worst[FW_CERTIFICATE_MOMENTUM], 0);
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
}

static void certificate_is_kept_in_the_results(void **state)
{
    (void)state;
    fw_scenario *scenario;
    fw_playback *playback;
    fw_certificate kept;
    char said[FW_CERTIFICATE_SIZE], read[FW_CERTIFICATE_SIZE];
    fw_run *run = run_of(pressed, &scenario);
    fw_certificate_print(fw_run_certificate(run), said);
    const fw_certificate at_end = *fw_run_certificate(run);
    fw_run_destroy(run);
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_fine(fw_certificate_read(&kept, playback, &error));
    fw_certificate_print(&kept, read);
    assert_string_equal(read, said);
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n)
        assert_true(kept.worst[n] == at_end.worst[n] ||
                    (isnan(kept.worst[n]) && isnan(at_end.worst[n])));
    fw_playback_close(playback);
    fw_scenario_destroy(scenario);
}

static void certificate_speaks_of_what_applies_only(void **state)
{
    (void)state;
    fw_scenario *scenario;
    char line[FW_CERTIFICATE_SIZE];
    fw_run *run = run_of("title: nothing touches\n"
                         "materials: {felt: {lattice-boltzmann: {}}}\n"
                         "bodies: {sheet: {material: felt, shape: {rectangle: [5, 4]}}}\n"
                         "run: {steps: 4}\n",
                         &scenario);
    fw_certificate_print(fw_run_certificate(run), line);
    assert_string_equal(line, "energy ledger closed to 0, momentum ledger to 0");
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
}

/* A block inside the cone of a floor stays where it is to the last bit: there is no creep. One that
 * is shaken within the cone gives way by what the filter of sticking lets through, and no more. */
static void what_rests_does_not_creep(void **state)
{
    (void)state;
    fw_scenario *scenario;
    fw_run *run = run_of("title: a block rests on a slope\n"
                         "materials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
                         "bodies: {b: {material: m, shape: {sites: [[0, 0]]}, origin: [0, 0]}}\n"
                         "walls: {floor: {chain: [[-10, 0], [10, 0]], surface: {coulomb: 0.5}}}\n"
                         "forces: {weight: {body: b, force: [0.004, -0.01]}}\n"
                         "run: {steps: 1000, measure-every: 10}\n"
                         "measure: [certificate-creep, friction-heat]\n",
                         &scenario);
    assert_close(fw_run_certificate(run)->worst[FW_CERTIFICATE_CREEP], 0, 1e-17);
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
}

static void worst_of_two_runs_is_that_of_either(void **state)
{
    (void)state;
    fw_certificate one = fw_certificate_begin(), other = fw_certificate_begin();
    one.worst[FW_CERTIFICATE_ENERGY] = 1e-3;
    other.worst[FW_CERTIFICATE_ENERGY] = 1e-6;
    other.worst[FW_CERTIFICATE_CREEP] = 0.25;
    fw_certificate_join(&one, &other);
    assert_close(one.worst[FW_CERTIFICATE_ENERGY], 1e-3, 0);
    assert_close(one.worst[FW_CERTIFICATE_CREEP], .25, 0);
    assert_true(isnan(one.worst[FW_CERTIFICATE_OVERSTEP]) != 0);
}

static int set_up(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(certificate_has_the_worst_of_the_samples),
        cmocka_unit_test(certificate_is_kept_in_the_results),
        cmocka_unit_test(certificate_speaks_of_what_applies_only),
        cmocka_unit_test(what_rests_does_not_creep),
        cmocka_unit_test(worst_of_two_runs_is_that_of_either),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
