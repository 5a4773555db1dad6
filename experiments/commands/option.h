/* SPDX-License-Identifier: GPL-3.0-or-later */
/* option.h - the options of the command line: one constant row each, which says where its value
 * goes. Help, refusals, the manual page and completion follow from the rows. */
#ifndef FW_OPTION_H
#define FW_OPTION_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* What the command line said, options and words apart. */
enum { FW_SETTINGS_MAX = 256, FW_WORDS_MAX = 1024, FW_OPTIONS_MAX = 32 };

typedef struct fw_option_list {
    int count;
    const char *item[FW_SETTINGS_MAX];
} fw_option_list;

typedef struct fw_arguments {
    int word_count;
    const char *words[FW_WORDS_MAX]; /* names, files and folders, in order */
    fw_option_list settings;         /* of --set, in order */
    fw_option_list additions;        /* of --add */
    const char *output;              /* -o; NULL: not given */
    const char *field, *picture, *observable, *at, *kind, *json_file, *axis, *range, *along, *level,
        *body;
    int64_t threads;     /* 0: not given */
    int64_t seed;        /* -1: not given */
    int64_t from, until; /* steps; 0: not given */
    const char *one_case;
    const char *to; /* the format of export */
    const char *letter;
    const char *palette, *font_size, *x_range, *y_range, *style;
    fw_option_list with;
    int64_t width, height, dots; /* mm and dots per inch; 0: not given */
    bool bare;
    int64_t every, rate; /* frames, and frames in a second; 0: not given */
    bool list;
    bool in_steps, quiet, overwrite, no_plot, logarithmic, json, names, full, help;
    bool given[FW_OPTIONS_MAX]; /* per option of the command */
} fw_arguments;

/* How a value is read; it follows from the type of the member that it goes to. */
typedef enum fw_option_form {
    FW_OPTION_FLAG = 1, /* bool: no value */
    FW_OPTION_TEXT,     /* const char *: observed */
    FW_OPTION_COUNT,    /* int64_t: a whole number from `least` to `most` */
    FW_OPTION_LIST      /* fw_option_list: may be given again */
} fw_option_form;

/* What a value or a word is, for completion. */
typedef enum fw_complete {
    FW_COMPLETE_NOTHING,
    FW_COMPLETE_FILE,
    FW_COMPLETE_FOLDER,
    FW_COMPLETE_EXPERIMENT, /* a name of the catalogue, or a scenario file */
    FW_COMPLETE_NAME,       /* a name of the catalogue */
    FW_COMPLETE_QUANTITY,
    FW_COMPLETE_KEY,    /* of a scenario */
    FW_COMPLETE_SETTING /* the same, with '=' behind it */
} fw_complete;

typedef struct fw_option {
    const char *name, *brief, *value, *meaning; /* "--output", "-o" or NULL, "DIR" or NULL */
    fw_option_form form;
    size_t at; /* offset in fw_arguments */
    int64_t least, most;
    fw_complete complete;
    const char *choices; /* words that the value may be: "x, y"; or NULL */
} fw_option;

/* Into a member of fw_arguments; a type that no form reads does not compile. */
#define FW_INTO(member)                                                                            \
    .at = offsetof(fw_arguments, member),                                                          \
    .form = _Generic(((fw_arguments *)0)->member,                                                  \
            bool: FW_OPTION_FLAG,                                                                  \
            const char *: FW_OPTION_TEXT,                                                          \
            int64_t: FW_OPTION_COUNT,                                                              \
            fw_option_list: FW_OPTION_LIST)

extern const fw_option fw_option_folder, fw_option_picture_file, fw_option_table_file,
    fw_option_set, fw_option_seed, fw_option_threads, fw_option_quiet, fw_option_overwrite,
    fw_option_no_plot, fw_option_kind, fw_option_field, fw_option_observable, fw_option_at,
    fw_option_logarithmic, fw_option_range, fw_option_along, fw_option_level, fw_option_body,
    fw_option_from, fw_option_until, fw_option_picture, fw_option_verdicts, fw_option_axis,
    fw_option_list_cases, fw_option_case, fw_option_add, fw_option_json, fw_option_names,
    fw_option_full, fw_option_export_file, fw_option_to, fw_option_every, fw_option_film_file,
    fw_option_film_kind, fw_option_rate, fw_option_report_file, fw_option_rerun_folder,
    fw_option_width, fw_option_dots, fw_option_bare, fw_option_letter, fw_option_height,
    fw_option_palette, fw_option_in_steps, fw_option_font_size, fw_option_x_range,
    fw_option_y_range, fw_option_with, fw_option_style, fw_option_help;

struct fw_command;

/* Reads the command line behind the command's name. FW_BAD_INPUT with the option at fault. */
fw_status fw_arguments_read(fw_arguments *arguments, const struct fw_command *command, int count,
                            char **words, fw_error *error);
/* "-o, --output DIR" into `left`. */
void fw_option_usage(const fw_option *option, char left[64]);
void fw_option_print(FILE *out, const struct fw_command *command);

#endif
