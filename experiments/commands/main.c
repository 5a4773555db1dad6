/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.c - the program fretwork. Only here and in the commands does anything print or exit. Keeps
 * no state. Start reading at main(). */
#include "core/instruction_set.h"
#include "experiments/commands/command.h"
#include "experiments/results/provenance.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int refuse_command(const char *name)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (const fw_command *c = fw_commands; c->name; ++c) fw_suggestion_offer(&suggestion, c->name);
    const fw_quote quote = fw_text_quote(name, strlen(name));
    if (suggestion.best)
        fprintf(stderr, "fretwork: no command %s; did you mean %s?\n", quote.text, suggestion.best);
    else
        fprintf(stderr, "fretwork: no command %s, expected one of `fretwork --help`\n", quote.text);
    return FW_BAD_INPUT;
}

/* What went to stdout must have arrived: a full disk behind a pipe or a file is a failure. */
static int close_output(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return code;
    fputs("fretwork: standard output cannot be written\n", stderr);
    return code == FW_OK ? FW_SYSTEM_FAILED : code;
}

/* A stream that was closed at the start would be the next file that is opened: messages would be
 * written into results. Descriptors are opened from the lowest on, so each gets its own number. */
static void open_streams(void)
{
    for (int n = STDIN_FILENO; n <= STDERR_FILENO; ++n)
        if (fcntl(n, F_GETFD) < 0 && open("/dev/null", O_RDWR) != n) _exit(FW_SYSTEM_FAILED);
}

/* Threads that wait for each other should sleep: on cores that are shared, those that spin make
 * steps 20 times as long. OpenMP looks for that before main() begins, so the program of a command
 * that runs threads starts anew. Users who set it otherwise know why. */
static void wait_asleep(const fw_command *command, char **words)
{
    if (getenv("OMP_WAIT_POLICY") || getenv("GOMP_SPINCOUNT")) return;
    for (const fw_option *const *option = command->options; *option; ++option)
        if (*option == &fw_option_threads && setenv("OMP_WAIT_POLICY", "passive", 1) == 0)
            execv("/proc/self/exe", words);
}

int main(int count, char **words)
{
    open_streams();
    /* A file that may not grow further is a failure like a full disk: a sentence, not a death. */
    signal(SIGXFSZ, SIG_IGN);
    if (count < 2) {
        fw_command_print_help(stderr);
        return FW_BAD_INPUT;
    }
    const bool asks_help = strcmp(words[1], "help") == 0;
    if (strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0 ||
        (asks_help && count < 3)) {
        fw_command_print_help(stdout);
        return close_output(FW_OK);
    }
    if (strcmp(words[1], "--version") == 0) {
        fw_provenance about = fw_provenance_now();
        printf("%s %s (%s, %s)\n", about.program, about.version, about.revision, about.compiler);
        return close_output(FW_OK);
    }
    const fw_command *command = fw_command_find(words[asks_help ? 2 : 1]);
    /* `help run` is `run --help`. */
    static char *help[] = {"--help"};
    if (!command) return refuse_command(words[asks_help ? 2 : 1]);
    wait_asleep(command, words);
    fw_arguments *arguments = malloc(sizeof *arguments);
    fw_error error = {.status = FW_SYSTEM_FAILED, .sentence = "not enough memory"};
    fw_status status = FW_OK;
    const char *instructions = getenv("FRETWORK_INSTRUCTIONS");
    if (instructions && *instructions) status = fw_instruction_set_use(instructions, &error);
    if (!arguments) status = FW_SYSTEM_FAILED;
    if (status == FW_OK)
        status = fw_arguments_read(arguments, command, asks_help ? 1 : count - 2,
                                   asks_help ? help : words + 2, &error);
    if (status == FW_OK && arguments->help) {
        printf("fretwork %s\n  %s\n\n", command->usage, command->summary);
        fw_option_print(stdout, command);
    } else if (status == FW_OK) {
        status = command->run(arguments, &error);
    }
    free(arguments);
    if (status > FW_EXPECTATION_FAILED) {
        fputs("fretwork: ", stderr);
        fw_text_print_line(stderr, error.sentence);
        fputc('\n', stderr);
    }
    return close_output((int)status);
}
