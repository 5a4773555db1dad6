/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command.h - the commands of the program, one file each: command_NAME.c. A new one is a row in
 * command.c and its file. */
#ifndef FW_COMMAND_H
#define FW_COMMAND_H

#include "core/status.h"
#include "experiments/commands/option.h"
#include "experiments/scenario/scenario.h"
#include "experiments/study/run.h"

typedef struct fw_command {
    const char *name; /* NULL ends the table */
    const char *usage;
    const char *summary;
    int words_min, words_max;
    fw_complete complete;            /* what its words are */
    const fw_option *const *options; /* ended by NULL */
    fw_status (*run)(const fw_arguments *arguments, fw_error *error);
    bool hidden; /* not in the help: for whoever installs the program */
} fw_command;

extern const fw_command fw_commands[];

/* NULL where there is none of that name. */
const fw_command *fw_command_find(const char *name);
/* The help of the whole program. */
void fw_command_print_help(FILE *out);

typedef struct fw_exit_code {
    int code; /* negative ends the table */
    const char *meaning;
} fw_exit_code;
extern const fw_exit_code fw_exit_codes[];

/* A scenario by name or file: a word with a '/' or ending in .yaml is a file. *name is how
 * sentences and folders call it: "wall-bounce" for either; it lives as long as the arguments.
 * --seed makes it one run, or one of each case of a sweep, from that seed. */
fw_status fw_command_load(fw_scenario **scenario, const char *word, const fw_arguments *arguments,
                          char name[FW_NAME_BYTES + 1], fw_error *error);
int fw_command_threads(const fw_arguments *arguments);
/* How a command that runs something does so in `directory`; begins `progress`, which is to outlive
 * what runs, under that name. */
fw_run_options fw_command_run_options(const fw_arguments *arguments, const char *directory,
                                      const char *name, fw_progress *progress);

/* --range LOW,HIGH; NULL leaves the range as it is. */
fw_status fw_command_read_range(const char *option, const char *text, double range[2],
                                fw_error *error);

/* Runs a scenario into a folder and reports it, as `run` does with these options. */
fw_status fw_command_run_scenario(const fw_scenario *scenario, const fw_arguments *arguments,
                                  const char *directory, const char *name, fw_error *error);

fw_status fw_command_list(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_show(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_run(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_check(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_rerun(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_resume(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_sweep(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_extend(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_collect(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_verify(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_plot(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_film(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_report(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_table(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_export(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_profile(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_quantities(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_reference(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_completion(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_manual_page(const fw_arguments *arguments, fw_error *error);
fw_status fw_command_cite(const fw_arguments *arguments, fw_error *error);

#endif
