/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_memory.c - what is said of memory is what a run takes, and too little of it gets a sentence
 * instead of a death. */
#include "tests/support/laws.h"

#include "experiments/setup/memory.h"
#include "tests/support/program.h"

#include <sys/prctl.h>
#include <sys/resource.h>

/* gcc and clang each say it in a way of their own. */
#if defined(__SANITIZE_ADDRESS__)
#define UNDER_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define UNDER_ADDRESS_SANITIZER
#endif
#endif

/* A square of n x n particles of some material. */
static void write_square(const char *folder, const char *name, const char *material, int n,
                         const char *more)
{
    char text[512];
    snprintf(text, sizeof text,
             "title: a square\n"
             "materials: {m: {%s}}\n"
             "bodies: {b: {material: m, shape: {rectangle: [%d, %d]}%s}}\n"
             "run: {steps: 2, record-every: 1}\n"
             "measure: [energy]\n",
             material, n, n, more);
    write_scenario(folder, name, text);
}

typedef struct solid {
    const char *material, *more;
} solid;

static const solid solids[] = {
    {"lattice-boltzmann: {}", ""},
    {"elastic-automaton: {c1: 0.4, c2: 0.58, boundary: periodic}", ""},
    {"movable-particles: {}", ", lattice: hexagonal"},
    {"linear-lattice: {k1: 1, k2: 1}", ", lattice: hexagonal"},
};

/* The largest resident size of a run of the program, in bytes. */
static double size_of_run(const char *folder, const char *line)
{
    struct rusage used;
    running run = start_program(folder, line);
    int status;
    assert_int_equal(wait4(run.process, &status, 0, &used), run.process);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    fclose(run.out);
    fclose(run.err);
    return 1024 * (double)used.ru_maxrss;
}

static void what_is_needed_is_what_a_run_takes(void **state)
{
    char folder[64], path[128];
    (void)state;
#ifdef UNDER_ADDRESS_SANITIZER
    skip(); /* every allocation takes more */
#endif
    /* What large pages round up depends on whether the system has some. */
    assert_int_equal(prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0), 0);
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/square.yaml", folder);
    for (size_t n = 0; n < sizeof solids / sizeof *solids; ++n) {
        fw_scenario *scenario;
        write_square(folder, "square.yaml", solids[n].material, 300, solids[n].more);
        assert_fine(fw_scenario_load(&scenario, path, NULL, 0, &error));
        const double needed = fw_memory_needed(scenario);
        const double taken = size_of_run(folder, "run square.yaml -q --no-plot --overwrite -o it");
        if (taken < 0.8 * needed || taken > 1.2 * needed)
            fail_msg("%s: said %.0f, took %.0f bytes", solids[n].material, needed, taken);
        print_message("%s: said %.0f, took %.0f bytes\n", solids[n].material, needed, taken);
        fw_scenario_destroy(scenario);
    }
    assert_int_equal(prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0), 0);
    remove_folder(folder);
}

static void too_little_memory_gets_a_sentence(void **state)
{
    static const char *const commands[] = {"check huge.yaml", "run huge.yaml -q -o it",
                                           "verify huge.yaml -q", "run seeds.yaml -q -o it"};
    char folder[64], line[512];
    (void)state;
#ifdef UNDER_ADDRESS_SANITIZER
    skip(); /* the sanitizer takes the address space for itself */
#endif
    make_quick_folder(folder, sizeof folder);
    write_square(folder, "huge.yaml", "lattice-boltzmann: {}", 4000, "");
    /* One run would do, a hundred side by side do not. */
    write_square(folder, "seeds.yaml", "lattice-boltzmann: {}", 300, "");
    shell(folder, "echo 'study: {seeds: 100}' >> seeds.yaml");
    for (size_t n = 0; n < sizeof commands / sizeof *commands; ++n) {
        snprintf(line, sizeof line,
                 "(ulimit -v 700000; '%s' %s > out 2> err); test $? = 4 && test ! -s out && "
                 "grep -q 'MB of memory, but [0-9]* MB are free below the limit of its address "
                 "space' err && test ! -e it",
                 FW_PROGRAM, commands[n]);
        shell(folder, line);
    }
    shell(folder, "grep -q 'in each of 100 runs' err");
    remove_folder(folder);
}

static void there_is_memory(void **state)
{
    const char *limit;
    const double bytes = fw_memory_available(&limit);
    (void)state;
    assert_true(bytes > 1e6);
    assert_true(strlen(limit) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_needed_is_what_a_run_takes),
        cmocka_unit_test(too_little_memory_gets_a_sentence),
        cmocka_unit_test(there_is_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
