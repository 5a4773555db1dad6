/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_manual_page.c - the manual page fretwork(1), in the macros of man(7); written from the
 * tables of commands, options and exit codes. Keeps no state. Start reading at
 * fw_command_manual_page(). */
#include "experiments/commands/command.h"
#include "experiments/results/provenance.h"

#include <string.h>

/* As it stands: '-' is a minus that can be copied, a '.' at the beginning of a line no macro. */
static void print_text(const char *text)
{
    if (*text == '.' || *text == '\'') printf("\\&");
    for (; *text; ++text) {
        if (*text == '-' || *text == '\\') putchar('\\');
        if (*text == '\\') {
            putchar('e');
            continue;
        }
        putchar(*text);
    }
}

static void print_item(const char *head, const char *text)
{
    printf(".TP\n.B ");
    print_text(head);
    putchar('\n');
    print_text(text);
    putchar('\n');
}

static void print_command(const fw_command *command)
{
    char head[128];
    printf(".SS \"fretwork ");
    print_text(command->usage);
    printf("\"\n");
    print_text(command->summary);
    printf(".\n");
    for (int n = 0; command->options[n]; ++n) {
        if (command->options[n] == &fw_option_help) continue;
        fw_option_usage(command->options[n], head);
        print_item(head, command->options[n]->meaning);
    }
}

fw_status fw_command_manual_page(const fw_arguments *arguments, fw_error *error)
{
    const fw_provenance now = fw_provenance_now();
    char code[16];
    (void)arguments;
    (void)error;
    printf(".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
           ".\\\" Written by `fretwork manual-page`: do not edit.\n"
           ".TH FRETWORK 1 \"\" \"fretwork %s\" \"User Commands\"\n"
           ".SH NAME\nfretwork \\- contact and friction experiments on lattice solids\n"
           ".SH SYNOPSIS\n.B fretwork\n.I COMMAND\n.RI [ OPTIONS ]\n.RI [ WORDS ]\n.br\n"
           ".B fretwork \\-\\-version\n"
           ".SH DESCRIPTION\n",
           now.version);
    print_text("Runs experiments on three lattice solids (lattice Boltzmann solid, movable lattice "
               "particles, elastic automaton) that touch walls and each other, draws their "
               "pictures, and holds what came out against what is expected. An experiment is named "
               "by its name in the catalogue, or by its scenario file: a word with a '/' in it or "
               "that ends in .yaml is a file. Results and tables go to standard output, messages "
               "and progress to standard error.");
    printf("\n.SH COMMANDS\n");
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (!c->hidden) print_command(c);
    printf(".SH SIGNALS\n");
    print_text("SIGINT, SIGTERM and SIGHUP let a run write a checkpoint and end; `fretwork resume` "
               "goes on from there to the same results. Another signal half a second later or more "
               "ends the process at once, but not while a checkpoint is being written. Signals "
               "that were ignored at the start stay ignored.");
    printf("\n.SH \"EXIT STATUS\"\n");
    for (const fw_exit_code *e = fw_exit_codes; e->code >= 0; ++e) {
        snprintf(code, sizeof code, "%d", e->code);
        print_item(code, e->meaning);
    }
    printf(".SH ENVIRONMENT\n");
    print_item("FRETWORK_INSTRUCTIONS",
               "x86-64-v2, x86-64-v3 or x86-64-v4: the instructions that the loops over particles "
               "use, instead of the best that the processor has; results are the same");
    print_item("NO_COLOR", "where it is set and not empty, no colours are used on terminals");
    printf(".SH FILES\n");
    print_item("share/fretwork/catalogue", "the scenario files of the named experiments");
    print_item("share/doc/fretwork", "the manual");
    printf(".SH EXAMPLES\n.nf\nfretwork list\nfretwork run wall\\-bounce\n"
           "fretwork show friction > my.yaml\nfretwork check my.yaml\n"
           "fretwork run my.yaml \\-\\-set run.seed=2 \\-o results/second\n.fi\n");
    return FW_OK;
}
