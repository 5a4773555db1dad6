/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failed_calls.h - a line of the program done once for each place where it calls the disk, which
 * fails there (failing_disk.c): the program ends by itself, with code 0 or 4, and where it is 4
 * with one sentence that has the system's reason. What it was to make is as without the failure, or
 * not there, or is made by the next attempt; nothing else lies about. */
#ifndef FW_FAILED_CALLS_H
#define FW_FAILED_CALLS_H

#include "experiments/results/compare.h"
#include "tests/support/program.h"
#include "tests/support/small_scenarios.h"

#include <errno.h>

typedef struct failing_line {
    const char *line;
    const char *made;   /* what it makes or changes: names of files or folders */
    const char *before; /* what the shell does first */
    /* Is what was made sound? NULL: files that are whole or not there. Whole ones are in keep/. */
    void (*look)(const char *folder, const outcome *seen);
    bool says_times; /* and so never quite the same */
} failing_line;

static inline outcome run_failing(const char *folder, const char *line, int place, int reason)
{
    char failed[512], number[16], with[16];
    snprintf(failed, sizeof failed, "%s/failed", folder);
    snprintf(number, sizeof number, "%d", place);
    snprintf(with, sizeof with, "%d", reason);
    setenv("FW_FAIL_AT", number, 1);
    setenv("FW_FAIL_WITH", with, 1);
    setenv("FW_FAIL_BELOW", folder, 1);
    setenv("FW_FAILED", failed, 1);
    setenv("LD_PRELOAD", FW_FAILING_DISK, 1);
    /* HDF5 keeps what belongs to a file that could not be written. */
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    const outcome seen = run_program(folder, line);
    unsetenv("LD_PRELOAD");
    unsetenv("ASAN_OPTIONS");
    return seen;
}

/* A line of shell with one name in it; whether it succeeds. */
static inline bool holds(const char *folder, const char *format, const char *names)
{
    char inner[1024], line[1200];
    snprintf(inner, sizeof inner, format, names);
    snprintf(line, sizeof line, "cd '%s' && { %s; }", folder, inner);
    return system(line) == 0;
}

/* One sentence, with the system's reason. */
static inline void expect_reason(const outcome *seen, const char *line, int place, int reason)
{
    const char *end = strchr(seen->err, '\n');
    const bool one = strncmp(seen->err, "fretwork: ", 10) == 0 && end && end[1] == '\0';
    if (!one || !strstr(seen->err, strerror(reason)))
        fail_msg("%s, place %d: expected one sentence with '%s', found '%s'", line, place,
                 strerror(reason), seen->err);
}

/* Every `step`-th place, from `first` on. Returns how many failures were told of. */
static inline int fail_calls(const char *folder, const failing_line *f, int reason, int first,
                             int step)
{
    int told = 0, place = first;
    const char *before = f->before ? f->before : ":";
    if (!holds(folder, "rm -rf keep %s; mkdir keep", f->made)) fail_msg("%s remain", f->made);
    shell(folder, before);
    const outcome plain = run_program(folder, f->line);
    if (plain.code != 0) fail_msg("%s: code %d: %s", f->line, plain.code, plain.err);
    if (!holds(folder, "for n in %s; do cp -r $n keep || exit 1; done; ls > listed", f->made))
        fail_msg("%s: %s are not made", f->line, f->made);
    for (;; place += step) {
        if (!holds(folder, "rm -rf failed %s", f->made)) fail_msg("%s remain", f->made);
        shell(folder, before);
        const outcome seen = run_failing(folder, f->line, place, reason);
        if (!exists(folder, "failed")) break;
        if (seen.code != 0 && seen.code != 4)
            fail_msg("%s, place %d: code %d, signal %d: %s", f->line, place, seen.code, seen.signal,
                     seen.err);
        if (seen.code == 4) expect_reason(&seen, f->line, place, reason);
        if (seen.code == 0 && !f->says_times && strcmp(seen.out, plain.out) != 0)
            fail_msg("%s, place %d: code 0, but it says %s", f->line, place, seen.out);
        if (f->look)
            f->look(folder, &seen);
        else if (!holds(folder,
                        "for n in %s; do if [ -e $n ]; then cmp $n keep/$n || exit 1; fi; done",
                        f->made) ||
                 (seen.code == 0 && !holds(folder, "ls %s > failed", f->made)))
            fail_msg("%s, place %d, code %d: what it made is not whole", f->line, place, seen.code);
        if (!holds(folder,
                   "(ls; echo %s) | tr ' ' '\\n' | grep -Ev '^(failed)?$' | sort -u | cmp - "
                   "listed",
                   f->made))
            fail_msg("%s, place %d, code %d: it left something", f->line, place, seen.code);
        told += seen.code == 4;
    }
    print_message("%s, %s: %d places, %d told\n", f->line, strerror(reason), place, told);
    return told;
}

/* --- folders of results --- */

static inline void expect_equal_runs(const char *folder, const char *one, const char *other)
{
    char path[256];
    int differing;
    fw_playback *first, *second;
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    snprintf(path, sizeof path, "%s/%s", folder, one);
    assert_fine(fw_playback_open(&first, path, &error));
    snprintf(path, sizeof path, "%s/%s", folder, other);
    assert_fine(fw_playback_open(&second, path, &error));
    assert_string_equal(first->exit_reason, second->exit_reason);
    assert_fine(fw_compare(first, second, nowhere, &differing, &error));
    if (differing > 0) fail_msg("%s and %s differ", one, other);
    fw_playback_close(first);
    fw_playback_close(second);
    fclose(nowhere);
}

/* What a run leaves in out/: what resume or, where there is nothing to resume, another run makes
 * the whole result of. */
static inline void look_at_run(const char *folder, const outcome *seen)
{
    if (seen->code == 4) {
        const outcome resumed = run_program(folder, "resume out --quiet --no-plot");
        if (resumed.code == 2 && !strstr(resumed.err, "is finished")) {
            const outcome again =
                run_program(folder, "run file.yaml -o out --quiet --no-plot --overwrite");
            expect_end(&again, 0, "");
        } else if (resumed.code != 2 && resumed.code != 0) {
            fail_msg("resume ends with %d: %s", resumed.code, resumed.err);
        }
    }
    expect_equal_runs(folder, "keep/out", "out");
}

/* A picture in a folder of results: the results stay, and it can be drawn. */
static inline void look_at_plot(const char *folder, const outcome *seen)
{
    if (seen->code == 4) {
        if (!holds(folder, "cmp whole/trajectory.h5 %s/trajectory.h5", "keep/whole"))
            fail_msg("the results were changed by a picture");
        const outcome again = run_program(folder, "plot whole");
        expect_end(&again, 0, "");
    }
    if (!holds(folder, "diff -r whole %s", "keep/whole")) fail_msg("pictures differ");
}

#endif
