/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command.h - the commands of the program, one file each: command_NAME.c. */
#ifndef FW_COMMAND_H
#define FW_COMMAND_H

#include "core/status.h"
#include "experiments/scenario/scenario.h"

#include <stdio.h>

/* What the command line said, options and words apart. */
enum { FW_SETTINGS_MAX = 256, FW_WORDS_MAX = 1024 };
typedef struct fw_arguments {
    int word_count;
    const char *words[FW_WORDS_MAX]; /* names, files and folders, in order */
    int setting_count;
    const char *settings[FW_SETTINGS_MAX]; /* of --set and --seed, in order */
    const char *output;                    /* -o; NULL: not given */
    const char *field, *picture, *observable, *at, *range, *kind, *json, *axis;
    char seed[48];  /* the setting that --seed stands for */
    char given[32]; /* letters of the options that had a value */
    int threads;    /* 0: not given */
    bool quiet, overwrite, no_plot, logarithmic, help;
} fw_arguments;

/* One row per command. `options` are the letters of those it takes, see command.c. */
typedef struct fw_command {
    const char *name; /* NULL ends the table */
    const char *usage;
    const char *summary;
    const char *options;
    int least_words, most_words;
    fw_status (*run)(const fw_arguments *arguments, fw_error *error);
} fw_command;

extern const fw_command fw_commands[];

/* Reads the command line behind the command's name. FW_BAD_INPUT with the option at fault. */
fw_status fw_arguments_read(fw_arguments *arguments, const fw_command *command, int count,
                            char **words, fw_error *error);
void fw_command_print_options(FILE *out, const fw_command *command);

/* A scenario by name or file: a word with a '/' or ending in .yaml is a file. *name is how
 * sentences and folders call it: "wall-bounce" for either; it lives as long as the arguments. */
fw_status fw_command_load(fw_scenario **scenario, const char *word, const fw_arguments *arguments,
                          char name[FW_NAME_BYTES + 1], fw_error *error);
int fw_command_threads(const fw_arguments *arguments);

fw_status fw_command_list(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_show(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_run(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_check(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_resume(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_verify(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_plot(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_table(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_profile(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_quantities(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_reference(const fw_arguments *arguments, fw_error *error);

#endif
