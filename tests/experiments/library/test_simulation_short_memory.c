/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_simulation_short_memory.c - what a simulation asks for while it is made, run and looked at
 * fails once at each place: the caller is told, or sees the same, and nothing is left behind. */
#include "tests/support/short_memory.h"

#include "experiments/library/fretwork.h"
#include "experiments/storage/checksum.h"
#include "tests/support/program.h"

#include <omp.h>

/* A case of a sweep over two seeds, with a wall. */
static const char text[] =
    "title: a gas at two temperatures\n"
    "materials: {gas: {movable-particles: {strength: 0.1}}}\n"
    "parameters: {T: .1}\n"
    "bodies: {cloud: {material: gas, lattice: hexagonal, shape: {rectangle: [3, 3]}}}\n"
    "walls: {floor: {chain: [[-9, -9], [9, -9]]}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: T}\n"
    "run: {steps: 6, record-every: 3}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, above: 0}]\n"
    "study: {seeds: 2, sweep: {parameters: {T: {values: [.1, .2]}}}}\n";

static char folder[64];

static void add(uint64_t *hash, const double *values, int count)
{
    *hash = fw_checksum_add(*hash, values, (size_t)count * sizeof *values);
}

/* Half of it, everything there is to be seen, the rest, and the verdicts. */
static fw_status look_at(fw_simulation *s, uint64_t *hash, fw_error *e)
{
    double values[FW_SIMULATION_NUMBERS];
    const double *x, *y;
    int count, expected, failed;
    const fw_body_view view = fw_simulation_body(s, 0);
    FW_TRY(fw_simulation_advance(s, 3, e));
    FW_TRY(fw_simulation_velocities(s, 0, &x, &y, e));
    add(hash, x, view.count);
    add(hash, y, view.count);
    FW_TRY(fw_simulation_forces(s, 0, &x, &y, e));
    add(hash, y, view.count);
    FW_TRY(fw_simulation_field(s, 0, "speed", &x, e));
    add(hash, x, view.count);
    FW_TRY(fw_simulation_measure(s, "momentum.cloud", values, &count, e));
    add(hash, values, count);
    FW_TRY(fw_simulation_advance(s, 3, e));
    add(hash, view.x, view.count);
    FW_TRY(fw_simulation_judge(s, &expected, &failed, e));
    *hash = fw_checksum_add(*hash, &expected, sizeof expected);
    *hash = fw_checksum_add(*hash, &failed, sizeof failed);
    return FW_OK;
}

static fw_status simulate(const void *input, uint64_t *hash, fw_error *e)
{
    fw_simulation_def def = fw_simulation_def_default();
    fw_simulation *simulation;
    def.text = text;
    def.sweep_case = "T=0.2";
    def.directory = input;
    def.overwrite = true;
    *hash = FW_CHECKSUM_OF_NOTHING;
    if (input) shell(folder, "rm -rf out; if [ -d before ]; then cp -r before out; fi");
    const fw_status made = fw_simulation_create(&simulation, &def, e);
    if (made != FW_OK) assert_null(simulation);
    FW_TRY(made);
    const fw_status status = look_at(simulation, hash, e);
    fw_simulation_destroy(simulation);
    return status;
}

static void a_simulation_says_that_memory_is_missing(void **state)
{
    (void)state;
    char path[96];
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/out", folder);
    assert_true(fail_each_place("alone", simulate, NULL) > 80);
    attempt_whole("with results", simulate, path);
    shell(folder, "mv out before");
    assert_true(fail_each_place("with results", simulate, path) > 40);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_simulation_says_that_memory_is_missing),
    };
    omp_set_num_threads(1);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
