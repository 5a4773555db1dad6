/* SPDX-License-Identifier: GPL-3.0-or-later */
/* program.h - runs the program fretwork as its users do, and keeps what it printed. */
#ifndef FW_PROGRAM_H
#define FW_PROGRAM_H

#include "tests/support/scratch.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <sys/stat.h>
#include <sys/wait.h>

extern char **environ;

typedef struct outcome {
    int code;   /* exit code; -1 where a signal ended it */
    int signal; /* that ended it, or 0 */
    char out[65536], err[4096];
} outcome;

/* A program that runs, with its streams going into files that nobody else sees. */
typedef struct running {
    pid_t process;
    FILE *out, *err;
} running;

enum { PROGRAM_WORDS = 32 };

/* Splits at blanks; '...' keeps them. Writes into `words`, and into `line` itself. */
static inline void split_line(char *line, char *words[PROGRAM_WORDS])
{
    int count = 0;
    for (char *at = line; *at;) {
        while (*at == ' ') ++at;
        if (!*at) break;
        char stop = *at == '\'' ? '\'' : ' ';
        if (stop == '\'') ++at;
        if (count >= PROGRAM_WORDS - 1) fail_msg("too many words");
        words[count++] = at;
        while (*at && *at != stop) ++at;
        if (*at) *at++ = '\0';
    }
    words[count] = NULL;
}

/* Starts `fretwork LINE` in a folder, as another user where `user` is not 0: root may write
 * anywhere. */
static inline running start_program_as(const char *folder, const char *line, uid_t user)
{
    int program = open(FW_PROGRAM, O_RDONLY);
    assert_true(program >= 0);
    char copy[2048] = "fretwork ", *words[PROGRAM_WORDS];
    running started = {.out = tmpfile(), .err = tmpfile()};
    assert_non_null(started.out);
    assert_non_null(started.err);
    assert_true(strlen(line) + strlen(copy) < sizeof copy);
    strcat(copy, line);
    split_line(copy, words);
    fflush(NULL);
    started.process = fork();
    assert_true(started.process >= 0);
    if (started.process > 0) {
        close(program);
        return started;
    }
    if (chdir(folder) != 0 || dup2(fileno(started.out), STDOUT_FILENO) < 0 ||
        dup2(fileno(started.err), STDERR_FILENO) < 0 || (user != 0 && setuid(user) != 0))
        _exit(126);
    /* The file is open already: its folders may be closed to that user. */
    fexecve(program, words, environ);
    _exit(127);
}

static inline running start_program(const char *folder, const char *line)
{
    return start_program_as(folder, line, 0);
}

static inline void take_stream(FILE *stream, char *text, size_t size)
{
    rewind(stream);
    size_t length = fread(text, 1, size - 1, stream);
    text[length] = '\0';
    fclose(stream);
}

/* Waits for its end. */
static inline outcome await_program(running program)
{
    int status;
    outcome seen = {.code = -1};
    assert_int_equal(waitpid(program.process, &status, 0), program.process);
    if (WIFEXITED(status)) seen.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) seen.signal = WTERMSIG(status);
    take_stream(program.out, seen.out, sizeof seen.out);
    take_stream(program.err, seen.err, sizeof seen.err);
    return seen;
}

static inline outcome run_program(const char *folder, const char *line)
{
    return await_program(start_program(folder, line));
}

/* It ended with this code, and said these words, or nothing at all. */
static inline void expect_end(const outcome *seen, int code, const char *words)
{
    if (seen->code != code)
        fail_msg("exit code %d (signal %d), expected %d; it said: %s%s", seen->code, seen->signal,
                 code, seen->err, seen->out);
    if (!*words) assert_string_equal(seen->err, "");
    if (!strstr(seen->err, words)) fail_msg("'%s' does not speak of '%s'", seen->err, words);
}

/* Runs a line of shell in a folder; it must succeed. */
static inline void shell(const char *folder, const char *line)
{
    char command[2048];
    snprintf(command, sizeof command, "cd '%s' && { %s; }", folder, line);
    if (system(command) != 0) fail_msg("failed: %s", command);
}

static inline void write_scenario(const char *folder, const char *name, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static inline bool exists(const char *folder, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return access(path, F_OK) == 0;
}

/* Waits until a file is there, at most half a minute. */
static inline void await_file(const char *folder, const char *name)
{
    for (int n = 0; n < 30000 && !exists(folder, name); ++n) usleep(1000);
    if (!exists(folder, name)) fail_msg("%s/%s did not appear", folder, name);
}

static inline ino_t inode_of(const char *folder, const char *name)
{
    char path[512];
    struct stat facts;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return stat(path, &facts) == 0 ? facts.st_ino : 0;
}

/* Waits until another file has taken its place, at most half a minute. */
static inline void await_replacement(const char *folder, const char *name, ino_t before)
{
    for (int n = 0; n < 30000 && inode_of(folder, name) == before; ++n) usleep(1000);
    if (inode_of(folder, name) == before) fail_msg("%s/%s was not replaced", folder, name);
}

/* All datasets of the results in `found` (one folder or several) are those in `wanted`. */
static inline void expect_same_results(const char *folder, const char *wanted, const char *found)
{
    char arguments[900] = "", copy[512], *words[PROGRAM_WORDS];
    snprintf(copy, sizeof copy, "%s", found);
    split_line(copy, words);
    snprintf(arguments, sizeof arguments, "same %s/%s/trajectory.h5", folder, wanted);
    for (int n = 0; words[n]; ++n) {
        size_t length = strlen(arguments);
        snprintf(arguments + length, sizeof arguments - length, " %s/%s/trajectory.h5", folder,
                 words[n]);
    }
    int status = run_python("trajectory.py", arguments);
    if (status > 0) fail_msg("results differ: trajectory.py %s", arguments);
}

#endif
