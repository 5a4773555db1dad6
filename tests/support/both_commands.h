/* SPDX-License-Identifier: GPL-3.0-or-later */
/* both_commands.h - `check` refuses what `run` refuses, in the same words, and neither leaves
 * anything. */
#ifndef FW_BOTH_COMMANDS_H
#define FW_BOTH_COMMANDS_H

#include "tests/support/program.h"

/* Holds both commands to it for a scenario that is refused, and to what the sentence begins with or
 * holds. Returns how many faults there were; each is printed. */
static inline int both_refuse(const char *folder, const char *text, const char *sentence)
{
    char path[128];
    snprintf(path, sizeof path, "%s/scenario.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
    const outcome run = run_program(folder, "run scenario.yaml -q --no-plot -o left");
    const outcome check = run_program(folder, "check scenario.yaml");
    snprintf(path, sizeof path, "%s/left", folder);
    const bool left = access(path, F_OK) == 0;
    if (run.code == 2 && check.code == 2 && !left && strcmp(run.err, check.err) == 0 &&
        strstr(run.err, sentence))
        return 0;
    print_error("%s\n  run   %d %s  check %d %s  expected exit code 2 and %s%s\n", text, run.code,
                run.err, check.code, check.err, sentence, left ? ", and nothing left" : "");
    return 1;
}

/* A scenario that is refused, and what its sentence says; a place in it is one in t.yaml. */
typedef struct bad_scenario {
    const char *text, *sentence;
} bad_scenario;

static inline void expect_both_refuse(const bad_scenario *bad, size_t count)
{
    char folder[64];
    int wrong = 0;
    make_quick_folder(folder, sizeof folder);
    for (size_t n = 0; n < count; ++n) {
        /* The place is that of another file's name here. */
        const char *sentence = bad[n].sentence;
        if (strncmp(sentence, "t.yaml", 6) == 0) sentence += 6;
        wrong += both_refuse(folder, bad[n].text, sentence);
    }
    remove_folder(folder);
    assert_int_equal(wrong, 0);
}

#endif
