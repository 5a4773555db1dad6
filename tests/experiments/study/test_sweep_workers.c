/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_workers.c - the cases of a sweep, run by one process or by many, side by side, in any
 * order, killed and started again: the same bytes come out. */
#include "tests/support/laws.h"

#include "experiments/storage/claim.h"
#include "tests/support/program.h"

/* Eight cases with noise, of two seeds each, of some hundredths of a second. */
static const char gas[] =
    "title: a gas of few particles\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 0}}}}\n"
    "dynamics: {time-step: 0.005, damping: 0.5, temperature: 1}\n"
    "bodies: {gas: {material: grain, lattice: square, spacing: 3, shape: {rectangle: [4, 4]}}}\n"
    "run: {steps: 3000, record-every: 500, checkpoint-every: 500}\n"
    "study:\n"
    "  seeds: 2\n"
    "  sweep:\n"
    "    parameters:\n"
    "      T: {from: 0.1, to: 0.4, count: 4, unit: energy}\n"
    "      mu: {values: [0.5, 2]}\n"
    "    set: [dynamics.temperature=T, dynamics.damping=mu]\n"
    "expect:\n"
    "  - {quantity: temperature, statistic: mean, above: 0}\n";
static const char cases[] =
    "T=0.1,mu=0.5 T=0.1,mu=2 T=0.2,mu=0.5 T=0.2,mu=2 T=0.3,mu=0.5 T=0.3,mu=2 "
    "T=0.4,mu=0.5 T=0.4,mu=2";

/* Tables and datasets of two sweeps, and nothing that only the workers need. */
static void expect_same_sweep(const char *folder, const char *wanted, const char *found)
{
    char line[1024], one[160], other[160];
    snprintf(line, sizeof line,
             "cmp %s/sweep.csv %s/sweep.csv && for c in %s; do cmp %s/$c/summary.csv "
             "%s/$c/summary.csv || exit 1; done; test -z \"$(find %s -name taken)\"",
             wanted, found, cases, wanted, found, found);
    shell(folder, line);
    static const char *const some[] = {"T=0.1,mu=0.5", "T=0.2,mu=2", "T=0.4,mu=2"};
    for (int n = 0; n < 3; ++n) {
        snprintf(one, sizeof one, "%s/%s", wanted, some[n]);
        snprintf(other, sizeof other, "%s/%s", found, some[n]);
        expect_same_results(folder, one, other);
    }
}

static void any_number_side_by_side_gives_the_same_bytes(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -j1 -o one");
    expect_end(&seen, 0, "");
    const outcome many = run_program(folder, "run gas.yaml -q --no-plot -j 64 -o many");
    expect_end(&many, 0, "");
    expect_same_sweep(folder, "one", "many");
    /* Verdicts in the order of the cases, whoever was first. */
    assert_true(strncmp(seen.out, many.out, (size_t)(strstr(seen.out, "results:") - seen.out)) ==
                0);
    remove_folder(folder);
    skip_unseen();
}

static void listed_commands_give_the_same_bytes_in_any_order(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o here");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "sweep gas.yaml -o 'out there' --list");
    expect_end(&seen, 0, "");
    assert_true(strncmp(seen.out, "fretwork sweep 'out there' --case T=0.1,mu=0.5\n", 47) == 0);
    /* Nothing was run, and asking again changes nothing. */
    const outcome again = run_program(folder, "sweep gas.yaml -o 'out there' --list");
    expect_end(&again, 0, "");
    assert_string_equal(seen.out, again.out);
    const outcome of_folder = run_program(folder, "sweep 'out there' --list");
    expect_end(&of_folder, 0, "");
    assert_string_equal(seen.out, of_folder.out);
    seen = run_program(folder, "collect 'out there'");
    expect_end(&seen, 2,
               "out there: 8 of 8 cases are not finished; the first, T=0.1,mu=0.5, has not begun. "
               "`fretwork resume out there` runs those that nobody is running");
    /* By two shells at once, one from the last case on: they meet, and leave each other alone. */
    write_scenario(folder, "cases", again.out);
    char line[1024];
    snprintf(
        line, sizeof line,
        "sed 's,^fretwork,%s,' cases > them; (sh -e them > a) & (tac them | sh -e > b) && wait;"
        " test $(cat a b | grep -c finished) -ge 8",
        FW_PROGRAM);
    shell(folder, line);
    seen = run_program(folder, "collect 'out there' --no-plot");
    expect_end(&seen, 0, "");
    shell(folder, "mv 'out there' there");
    expect_same_sweep(folder, "here", "there");
    seen = run_program(folder, "collect there --no-plot");
    expect_end(&seen, 0, "");
    remove_folder(folder);
    skip_unseen();
}

/* What one worker has no other takes; when it died, another goes on from where it was. */
static void a_case_has_one_worker_and_is_free_when_that_died(void **state)
{
    char folder[64];
    fw_claim *claim, *second;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    /* One case is long enough to be caught at work. */
    shell(folder, "sed -i 's/damping=mu]/damping=mu, \"run.steps=(T < 0.15 \\&\\& mu > 1 ? 90000 : "
                  "3000)\"]/' gas.yaml");
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o here");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "sweep gas.yaml -o there --list");
    expect_end(&seen, 0, "");
    running worker = start_program(folder, "sweep there --case T=0.1,mu=2 -q --threads 1");
    await_file(folder, "there/T=0.1,mu=2/taken");
    kill(worker.process, SIGSTOP);
    seen = run_program(folder, "sweep there --case T=0.1,mu=2 -q");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "T=0.1,mu=2: another worker has it\n");
    seen = run_program(folder, "resume there -q --no-plot");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "1 of 8 cases are being run by others; once they are finished, "
                                  "`fretwork collect there` makes the table and the pictures\n");
    assert_false(exists(folder, "there/sweep.csv"));
    kill(worker.process, SIGKILL);
    await_program(worker);
    assert_true(exists(folder, "there/T=0.1,mu=2/taken"));
    seen = run_program(folder, "sweep there --case T=0.1,mu=2 -q");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "T=0.1,mu=2: finished\n");
    seen = run_program(folder, "collect there --no-plot");
    expect_end(&seen, 0, "");
    expect_same_sweep(folder, "here", "there");
    /* The claim itself. */
    char path[128];
    snprintf(path, sizeof path, "%s/work", folder);
    assert_fine(fw_claim_take(&claim, path, &error));
    assert_non_null(claim);
    assert_fine(fw_claim_take(&second, path, &error));
    assert_null(second);
    fw_claim_release(claim);
    assert_false(exists(folder, "work"));
    assert_fine(fw_claim_take(&second, path, &error));
    assert_non_null(second);
    fw_claim_release(second);
    remove_folder(folder);
    skip_unseen();
}

static void killed_again_and_again_it_comes_to_the_same_bytes(void **state)
{
    char folder[64];
    outcome seen;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    seen = run_program(folder, "run gas.yaml -q --no-plot -o whole");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "sweep gas.yaml -o part --list");
    expect_end(&seen, 0, "");
    unsigned random = 12345;
    for (int n = 0; n < 10 && !exists(folder, "part/sweep.csv"); ++n) {
        running master = start_program(folder, "resume part -q --no-plot -j 2");
        random = random * 1103515245u + 12345u;
        usleep(20000 + random / 65536 % 80000);
        kill(master.process, SIGKILL);
        await_program(master);
    }
    if (!exists(folder, "part/sweep.csv")) {
        seen = run_program(folder, "resume part -q --no-plot");
        expect_end(&seen, 0, "");
    }
    expect_same_sweep(folder, "whole", "part");
    remove_folder(folder);
    skip_unseen();
}

static void wrong_commands_get_their_sentence(void **state)
{
    static const struct {
        const char *line, *sentence;
    } rows[] = {
        {"sweep gas.yaml -o it", "expected --list or --case; `fretwork run` runs all cases here"},
        {"sweep it --list --case T=1", "both --list and --case, expected one of them"},
        {"sweep one.yaml -o one --list", "one has no study.sweep whose cases could be listed"},
        {"sweep nothing --case T=1", "nothing holds no sweep, expected a folder that"},
        {"sweep it --case T=0.1,mu=1",
         "it: the sweep has no case T=0.1,mu=1, expected one such as T=0.1"},
        {"sweep it --case T=0.1,mu=2 --set run.steps=3",
         "--case runs what lies in the folder: --set belongs to --list"},
        {"sweep it --case T=0.1,mu=2 --seed 3",
         "--case runs what lies in the folder: --seed belongs to --list"},
        {"sweep it --case T=0.1,mu=2 --overwrite",
         "--case runs what lies in the folder: --overwrite belongs to --list"},
        {"sweep it --case T=0.1,mu=2 -o there",
         "--case runs what lies in the folder: -o belongs to --list"},
        {"sweep it --list --overwrite",
         "it holds a sweep, whose cases are listed as they are: expected --list alone"},
        {"sweep it --list --seed 3",
         "it holds a sweep, whose cases are listed as they are: expected --list alone"},
        {"sweep gas.yaml -o it --list --set run.steps=3000 --set study.seeds=3",
         "it holds a result already"},
        {"sweep it --list --set run.steps=3000",
         "it holds a sweep, whose cases are listed as they are: expected --list alone"},
        {"collect .", ". holds no sweep, whose cases could be collected"},
    };
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    shell(folder, "sed '/^study:/,$d' gas.yaml > one.yaml");
    outcome seen = run_program(folder, "sweep gas.yaml -o it --list");
    expect_end(&seen, 0, "");
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        seen = run_program(folder, rows[n].line);
        expect_end(&seen, 2, rows[n].sentence);
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_side_by_side_gives_the_same_bytes),
        cmocka_unit_test(listed_commands_give_the_same_bytes_in_any_order),
        cmocka_unit_test(a_case_has_one_worker_and_is_free_when_that_died),
        cmocka_unit_test(killed_again_and_again_it_comes_to_the_same_bytes),
        cmocka_unit_test(wrong_commands_get_their_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
