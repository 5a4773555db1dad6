/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_completion.c - the script by which bash completes what is typed: commands, options and
 * their values, names of experiments, quantities and keys. Written from the tables. Keeps no
 * state. Start reading at fw_command_completion(). */
#include "experiments/commands/command.h"
#include "experiments/measures/quantity.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/scenario.h"

#include <string.h>

/* What goes between the words of a list in the script. */
static void print_word(const char *word)
{
    printf(" %s", word);
}

static void print_key_path(void *object, const char *path, const fw_key *key)
{
    (void)object;
    (void)key;
    print_word(path);
}

/* Keys that --set can change as they stand; names of the user's own are not known here. */
static void print_setting(void *object, const char *path, const fw_key *key)
{
    (void)object;
    if (key->subsection || strstr(path, "NAME") || strstr(path, ".N.")) return;
    printf(" %s=", path);
}

static void print_lists(void)
{
    printf("_fretwork_commands='");
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (!c->hidden) print_word(c->name);
    printf(" --help --version'\n_fretwork_experiments='");
    for (const fw_catalogue_entry *e = fw_catalogue; e->name; ++e) print_word(e->name);
    printf("'\n_fretwork_quantities='");
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q))
        print_word(q->name);
    printf("'\n_fretwork_keys='");
    fw_schema_walk(&fw_scenario_section, print_key_path, NULL);
    printf("'\n_fretwork_settings='");
    fw_schema_walk(&fw_scenario_section, print_setting, NULL);
    printf("'\n\n");
}

/* The line that fills COMPREPLY with what such a word may be. */
static void print_answer(fw_complete complete, const char *choices)
{
    if (choices) {
        printf("COMPREPLY=($(IFS=', '; compgen -W '%s' -- \"$word\"))", choices);
        return;
    }
    switch (complete) {
    case FW_COMPLETE_NOTHING:
        printf("COMPREPLY=()");
        return;
    case FW_COMPLETE_FILE:
        printf("COMPREPLY=($(compgen -f -- \"$word\"))");
        return;
    case FW_COMPLETE_FOLDER:
        printf("COMPREPLY=($(compgen -d -- \"$word\"))");
        return;
    case FW_COMPLETE_EXPERIMENT:
        printf("COMPREPLY=($(compgen -W \"$_fretwork_experiments\" -- \"$word\") "
               "$(compgen -f -X '!*.y*ml' -- \"$word\") $(compgen -d -S / -- \"$word\"))");
        return;
    case FW_COMPLETE_NAME:
        printf("COMPREPLY=($(compgen -W \"$_fretwork_experiments\" -- \"$word\"))");
        return;
    case FW_COMPLETE_QUANTITY:
        printf("COMPREPLY=($(compgen -W \"$_fretwork_quantities\" -- \"$word\"))");
        return;
    case FW_COMPLETE_KEY:
        printf("COMPREPLY=($(compgen -W \"$_fretwork_keys\" -- \"$word\"))");
        return;
    case FW_COMPLETE_SETTING:
        printf("COMPREPLY=($(compgen -W \"$_fretwork_settings\" -- \"$word\")); "
               "[[ ${COMPREPLY[0]-} == *= ]] && compopt -o nospace 2>/dev/null");
        return;
    }
}

/* One command: the value of an option that stands before, an option, or a word. */
static void print_command(const fw_command *command)
{
    printf("    %s)\n        case $before in\n", command->name);
    for (int n = 0; command->options[n]; ++n) {
        const fw_option *o = command->options[n];
        if (o->form == FW_OPTION_FLAG) continue;
        printf("        %s%s%s) ", o->name, o->brief ? "|" : "", o->brief ? o->brief : "");
        print_answer(o->complete, o->choices);
        printf("; return ;;\n");
    }
    printf("        esac\n        if [[ $word == -* ]]; then\n"
           "            COMPREPLY=($(compgen -W '");
    for (int n = 0; command->options[n]; ++n) {
        const fw_option *o = command->options[n];
        printf("%s%s", n > 0 ? " " : "", o->name);
        if (o->brief) print_word(o->brief);
    }
    printf("' -- \"$word\"))\n        else\n            ");
    print_answer(command->words_max > 0 ? command->complete : FW_COMPLETE_NOTHING, NULL);
    printf("\n        fi\n        ;;\n");
}

fw_status fw_command_completion(const fw_arguments *arguments, fw_error *error)
{
    (void)arguments;
    (void)error;
    printf("# Completion of fretwork for bash; written by `fretwork completion`.\n"
           "# SPDX-License-Identifier: GPL-3.0-or-later\n");
    print_lists();
    printf("_fretwork()\n{\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
           "    COMPREPLY=()\n"
           "    if [[ $COMP_CWORD -eq 1 ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$_fretwork_commands\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]} in\n");
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (!c->hidden) print_command(c);
    printf("    esac\n}\ncomplete -F _fretwork fretwork\n");
    return FW_OK;
}
