/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_h5md.c - the results file that the program leaves is H5MD 1.1, item by item, says what the
 * scenario says, and is read by MDAnalysis: see results.py. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char scenario[] =
    "title: a sheet beside a chain\n"
    "materials:\n"
    "  rubber: {lattice-boltzmann: {}}\n"
    "  string: {lattice-boltzmann: {rest-mass: 1}}\n"
    "bodies:\n"
    "  sheet: {material: rubber, shape: {rectangle: [4, 3]}, origin: [2, 3],"
    " velocity: [0.1, -0.05]}\n"
    "  chain: {material: string, shape: {rectangle: [5, 1]}, spacing: 0.5, origin: [10, 4]}\n"
    "walls: {floor: {chain: [[-50, 2.9], [50, 2.9]]}}\n"
    "forces: {pull: {body: chain, sites: right, force: [0.02, 0]}}\n"
    "run: {steps: 10, record-every: 4}\n"
    "record: {force: true, fields: [energy]}\n"
    "measure: [energy, momentum, centre-of-mass]\n";

static void check(const char *job, const char *folder, const char *more)
{
    char arguments[512];
    snprintf(arguments, sizeof arguments, "%s %s/it/trajectory.h5 %s", job, folder, more);
    int status = run_python("results.py", arguments);
    if (status > 0) fail_msg("results.py %s failed", arguments);
}

static void results_of_the_program_are_h5md(void **state)
{
    char folder[64], path[128], revision[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/two.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(scenario, file);
    fclose(file);
    outcome seen = run_program(folder, "--version");
    expect_end(&seen, 0, "");
    assert_int_equal(sscanf(seen.out, "fretwork %*s (%63[^,]", revision), 1);
    seen = run_program(folder, "run two.yaml -q --no-plot --seed 42 --threads 2 -o it");
    expect_end(&seen, 0, "");
    check("h5md", folder, revision);
    check("reader", folder, "");
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(results_of_the_program_are_h5md)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
