/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.c - the program fretwork. Only here and in the commands does anything print or exit. */
#include "experiments/commands/command.h"
#include "experiments/results/provenance.h"
#include "experiments/text/spelling.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

static void print_help(FILE *out)
{
    fputs("fretwork: contact and friction experiments on lattice solids\n\n", out);
    for (const fw_command *c = fw_commands; c->name; ++c)
        fprintf(out, "  fretwork %-18s %s\n", c->usage, c->summary);
    fputs("\nfretwork COMMAND --help tells the options of a command; fretwork --version the "
          "version.\n\nExit codes:\n"
          "    0  fine\n"
          "    1  an expectation failed\n"
          "    2  bad input: one sentence says what was found and what was expected\n"
          "    3  the numbers diverged, or a particle escaped\n"
          "    4  the system failed (disk, memory)\n"
          "  130  interrupted (SIGINT), with a checkpoint\n"
          "  143  terminated (SIGTERM), with a checkpoint\n",
          out);
}

static const fw_command *find_command(const char *name)
{
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (strcmp(c->name, name) == 0) return c;
    return NULL;
}

static int refuse_command(const char *name)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (const fw_command *c = fw_commands; c->name; ++c) fw_suggestion_offer(&suggestion, c->name);
    if (suggestion.best)
        fprintf(stderr, "fretwork: no command %s; did you mean %s?\n", name, suggestion.best);
    else
        fprintf(stderr, "fretwork: no command %s, expected one of `fretwork --help`\n", name);
    return FW_BAD_INPUT;
}

/* What went to stdout must have arrived: a full disk behind a pipe or a file is a failure. */
static int close_output(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return code;
    fputs("fretwork: standard output cannot be written\n", stderr);
    return code == FW_OK ? FW_SYSTEM_FAILED : code;
}

int main(int count, char **words)
{
    /* A file that may not grow further is a failure like a full disk: a sentence, not a death. */
    signal(SIGXFSZ, SIG_IGN);
    if (count < 2) {
        print_help(stderr);
        return FW_BAD_INPUT;
    }
    if (strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0 ||
        strcmp(words[1], "help") == 0) {
        print_help(stdout);
        return close_output(FW_OK);
    }
    if (strcmp(words[1], "--version") == 0) {
        fw_provenance about = fw_provenance_now();
        printf("%s %s (%s, %s)\n", about.program, about.version, about.revision, about.compiler);
        return close_output(FW_OK);
    }
    const fw_command *command = find_command(words[1]);
    if (!command) return refuse_command(words[1]);
    fw_arguments *arguments = malloc(sizeof *arguments);
    fw_error error = {.status = FW_SYSTEM_FAILED, .sentence = "not enough memory"};
    fw_status status = FW_SYSTEM_FAILED;
    if (arguments) status = fw_arguments_read(arguments, command, count - 2, words + 2, &error);
    if (status == FW_OK && arguments->help) {
        printf("fretwork %s\n  %s\n\n", command->usage, command->summary);
        fw_command_print_options(stdout, command);
    } else if (status == FW_OK) {
        status = command->run(arguments, &error);
    }
    free(arguments);
    if (status > FW_EXPECTATION_FAILED) fprintf(stderr, "fretwork: %s\n", error.sentence);
    return close_output((int)status);
}
