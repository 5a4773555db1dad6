/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_foreign_folders.c - folders that are not as the program left them: with files of the user's
 * own under its names, with pipes and links in place of files, with bytes that were changed.
 * Nothing is lost, nothing is waited for, nothing is taken for what it is not. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

#include <fcntl.h>

static const char still[] = "title: a sheet flies\n"
                            "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
                            "bodies: {sheet: {material: rubber, shape: {rectangle: [3, 3]}}}\n"
                            "run: {steps: 20}\n";

/* With `set` a sweep, or a study with a control. */
#define SWEEP                                                                                      \
    "--set 'study={sweep: {parameters: {v: {values: [0.1, 0.2]}},"                                 \
    " set: [\"bodies.sheet.velocity=[v, 0]\"]}}'"                                                  \
    " --set 'expect=[{quantity: energy-drift, below: 1e-12}]'"

static void prepare(char *folder, size_t size)
{
    make_quick_folder(folder, size);
    write_scenario(folder, "still.yaml", still);
}

/* Ended by a limit of the shell where it waits for something. */
static outcome run_line(const char *folder, const char *line)
{
    return run_program(folder, line);
}

static void files_of_the_user_s_own_stay(void **state)
{
    static const struct {
        const char *name, *line;
    } files[] = {{"it/checkpoint-A", ""},
                 {"it/checkpoint-B", ""},
                 {"it/trajectory.h5", ""},
                 {"it/trajectory.h5.new", ""},
                 {"it/trajectory.h5.head", ""},
                 {"it/sweep.csv", ""},
                 {"it/sweep-as-run.yaml", ""},
                 {"it/summary.csv", ""},
                 {"it/motion.png", ""},
                 {"it/manifest", ""},
                 {"it/sweep.png", SWEEP},
                 {"it/v=0.1/summary.csv", SWEEP},
                 {"it/v=0.2/trajectory.h5", SWEEP}};
    char folder[64], line[512];
    (void)state;
    prepare(folder, sizeof folder);
    for (size_t n = 0; n < sizeof files / sizeof files[0]; ++n)
        for (int overwrite = 0; overwrite < 2; ++overwrite) {
            snprintf(line, sizeof line,
                     "rm -rf it; mkdir -p it/v=0.1 it/v=0.2 && echo mine > %s && ls -R it > before",
                     files[n].name);
            shell(folder, line);
            snprintf(line, sizeof line, "run still.yaml -q -o it %s %s", files[n].line,
                     overwrite ? "--overwrite" : "");
            const outcome seen = run_line(folder, line);
            snprintf(line, sizeof line, "%s is in the way", files[n].name);
            expect_end(&seen, 2, line);
            snprintf(line, sizeof line, "grep -q mine %s && ls -R it | cmp -s - before",
                     files[n].name);
            shell(folder, line);
        }
    remove_folder(folder);
}

static void overwrite_takes_what_is_of_the_result_and_leaves_the_rest(void **state)
{
    char folder[64];
    (void)state;
    prepare(folder, sizeof folder);
    outcome seen = run_line(folder, "run still.yaml -q -o it " SWEEP);
    expect_end(&seen, 0, "");
    assert_true(exists(folder, "it/sweep.png") || exists(folder, "it/sweep.csv"));
    shell(folder, "echo mine > it/notes.txt; echo mine > it/v=0.1/notes.txt;"
                  " echo mine > it/v=0.2/summary.csv");
    seen = run_line(folder, "run still.yaml -q -o it --overwrite");
    expect_end(&seen, 0, "");
    assert_true(exists(folder, "it/trajectory.h5") && exists(folder, "it/motion.png"));
    assert_false(exists(folder, "it/sweep.csv") || exists(folder, "it/sweep-as-run.yaml"));
    assert_false(exists(folder, "it/v=0.1/trajectory.h5") ||
                 exists(folder, "it/v=0.1/summary.csv"));
    shell(folder, "grep -q mine it/notes.txt it/v=0.1/notes.txt it/v=0.2/summary.csv");
    /* A picture that somebody has drawn upon is somebody's. */
    shell(folder, "echo mine >> it/motion.png");
    seen = run_line(folder, "run still.yaml -q -o it --overwrite");
    expect_end(&seen, 2, "it/motion.png is in the way");
    remove_folder(folder);
}

static void pipes_are_not_waited_for(void **state)
{
    static const char *const names[] = {"trajectory.h5",      "checkpoint-A", "checkpoint-B",
                                        "trajectory.h5.head", "manifest",     "sweep-as-run.yaml"};
    static const char *const lines[] = {"run still.yaml -q -o it", "resume it", "plot it",
                                        "table it", "run still.yaml -q -o it --overwrite"};
    char folder[64], line[256];
    (void)state;
    prepare(folder, sizeof folder);
    for (size_t n = 0; n < sizeof names / sizeof names[0]; ++n)
        for (size_t k = 0; k < sizeof lines / sizeof lines[0]; ++k) {
            snprintf(line, sizeof line, "rm -rf it; mkdir it && mkfifo it/%s", names[n]);
            shell(folder, line);
            const running started = start_program(folder, lines[k]);
            siginfo_t ended = {0};
            for (int t = 0; t < 1000 && ended.si_pid == 0; ++t) {
                usleep(10000);
                waitid(P_PID, (id_t)started.process, &ended, WEXITED | WNOHANG | WNOWAIT);
            }
            if (ended.si_pid == 0) kill(started.process, SIGKILL);
            const outcome seen = await_program(started);
            if (seen.signal != 0) fail_msg("fretwork %s waits for it/%s", lines[k], names[n]);
            assert_int_equal(seen.code, 2);
        }
    remove_folder(folder);
}

static void links_are_not_written_through(void **state)
{
    static const char *const links[] = {"trajectory.h5.new", "checkpoint-A.new", "manifest.new"};
    char folder[64], line[256];
    (void)state;
    prepare(folder, sizeof folder);
    for (size_t n = 0; n < sizeof links / sizeof links[0]; ++n) {
        /* A link to nothing is made by nobody, a link to something changes nothing there. */
        snprintf(line, sizeof line,
                 "rm -rf it; echo precious > kept; mkdir it && ln -s ../kept it/%s", links[n]);
        shell(folder, line);
        outcome seen = run_line(folder, "run still.yaml -q -o it");
        expect_end(&seen, 2, "is in the way");
        shell(folder, "grep -q precious kept");
    }
    shell(folder, "rm -rf it; mkdir elsewhere && echo precious > elsewhere/trajectory.h5");
    outcome seen = run_line(folder, "run still.yaml -q -o it " SWEEP);
    expect_end(&seen, 0, "");
    shell(folder, "rm -rf it/v=0.1 && ln -s ../elsewhere it/v=0.1");
    seen = run_line(folder, "run still.yaml -q -o it --overwrite");
    expect_end(&seen, 0, "");
    shell(folder, "grep -q precious elsewhere/trajectory.h5");
    seen = run_line(folder, "run still.yaml -q -o it --overwrite " SWEEP);
    expect_end(&seen, 2, "it/v=0.1 is a link");
    shell(folder, "grep -q precious elsewhere/trajectory.h5");
    remove_folder(folder);
}

/* Of killed processes: numbers that no process has. */
static void temporary_files_of_the_dead_go(void **state)
{
    char folder[64];
    (void)state;
    prepare(folder, sizeof folder);
    outcome seen = run_line(folder, "run still.yaml -q -o it");
    expect_end(&seen, 0, "");
    shell(folder, "echo half > it/motion.png.part-4194305; echo mine > it/motion.png.part-x;"
                  " echo half > it/trajectory.h5.new.part-4194305");
    seen = run_line(folder, "plot it");
    expect_end(&seen, 0, "");
    assert_false(exists(folder, "it/motion.png.part-4194305"));
    assert_true(exists(folder, "it/motion.png.part-x"));
    remove_folder(folder);
}

/* Every byte of the table of a case that is changed is noticed before it changes the sweep's. */
static void damaged_tables_are_refused(void **state)
{
    char folder[64], path[128], text[4096];
    (void)state;
    prepare(folder, sizeof folder);
    outcome seen = run_line(folder, "run still.yaml -q --no-plot -o it " SWEEP);
    expect_end(&seen, 0, "");
    shell(folder, "cp it/sweep.csv whole.csv && cp it/v=0.1/summary.csv whole-summary.csv");
    snprintf(path, sizeof path, "%s/it/v=0.1/summary.csv", folder);
    const int file = open(path, O_RDWR);
    const ssize_t length = read(file, text, sizeof text);
    assert_true(length > 40);
    for (ssize_t n = 0; n < length; n += 1 + length / 40) {
        const char changed = (char)(text[n] ^ 1);
        assert_int_equal(pwrite(file, &changed, 1, n), 1);
        shell(folder, "rm it/sweep.csv");
        seen = run_line(folder, "resume it -q --no-plot");
        expect_end(&seen, 2, "summary.csv is in the way, and is not as this program wrote it");
        assert_int_equal(pwrite(file, &text[n], 1, n), 1);
        shell(folder, "cp whole.csv it/sweep.csv");
    }
    close(file);
    shell(folder, "rm it/sweep.csv");
    seen = run_line(folder, "resume it -q --no-plot");
    expect_end(&seen, 0, "");
    shell(folder, "cmp whole.csv it/sweep.csv");
    remove_folder(folder);
}

/* A head of another run fits nothing, and nothing of it is written. */
static void head_of_another_run_is_refused(void **state)
{
    char folder[64];
    (void)state;
    prepare(folder, sizeof folder);
    shell(folder, "sed 's/steps: 20/steps: 30000000, record-every: 1000000,"
                  " measure-every: 1000000/' still.yaml > long.yaml");
    for (int n = 0; n < 2; ++n) {
        const char *name = n ? "two" : "one";
        char line[128], file[32];
        snprintf(line, sizeof line, "run long.yaml -q --no-plot --seed %d -o %s", n + 1, name);
        snprintf(file, sizeof file, "%s/checkpoint-A", name);
        outcome seen;
        /* A signal that comes before the first step ends the program at once. */
        for (unsigned wait = 50000; wait < 2000000; wait *= 2) {
            const running started = start_program(folder, line);
            await_file(folder, file);
            usleep(wait);
            kill(started.process, SIGINT);
            seen = await_program(started);
            if (seen.signal != SIGINT) break;
            shell(folder, n ? "rm -r two" : "rm -r one");
        }
        expect_end(&seen, 130, "interrupted");
    }
    shell(folder, "cp two/trajectory.h5.head one/ && cp one/trajectory.h5 before");
    outcome seen = run_line(folder, "resume one -q --no-plot");
    expect_end(&seen, 2, "belongs to another results file");
    shell(folder, "cmp one/trajectory.h5 before");
    shell(folder, "mv one/trajectory.h5.head one/trajectory.h5.cutting");
    seen = run_line(folder, "resume one -q --no-plot");
    expect_end(&seen, 2, "belongs to another results file");
    shell(folder, "cmp one/trajectory.h5 before");
    remove_folder(folder);
}

/* However long the path, the sentence ends with the reason. */
static void long_paths_keep_the_reason(void **state)
{
    char folder[64], path[2000] = "", line[2048];
    (void)state;
    prepare(folder, sizeof folder);
    for (int n = 0; n < 1400; ++n) path[n] = n % 100 == 0 ? '/' : 'd';
    snprintf(line, sizeof line, "table .%s", path);
    const outcome seen = run_line(folder, line);
    expect_end(&seen, 2, "No such file or directory\n");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_the_user_s_own_stay),
        cmocka_unit_test(overwrite_takes_what_is_of_the_result_and_leaves_the_rest),
        cmocka_unit_test(pipes_are_not_waited_for),
        cmocka_unit_test(links_are_not_written_through),
        cmocka_unit_test(temporary_files_of_the_dead_go),
        cmocka_unit_test(damaged_tables_are_refused),
        cmocka_unit_test(head_of_another_run_is_refused),
        cmocka_unit_test(long_paths_keep_the_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
