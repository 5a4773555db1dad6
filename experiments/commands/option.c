/* SPDX-License-Identifier: GPL-3.0-or-later */
/* option.c - the rows, and how a command line is read by them. Keeps no state.
 * Start reading at fw_arguments_read(). */
#include "option.h"

#include "experiments/commands/command.h"
#include "experiments/drawing/encoder.h"
#include "experiments/drawing/palette.h"
#include "experiments/exchange/export.h"
#include "experiments/scenario/picture_kind.h"
#include "experiments/schema/schema.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <assert.h>
#include <string.h>

const fw_option fw_option_folder = {"--output",      "-o",
                                    "DIR",           "folder of the results (results/NAME)",
                                    FW_INTO(output), .complete = FW_COMPLETE_FOLDER};
const fw_option fw_option_picture_file = {
    "--output",      "-o",
    "FILE",          "file of the picture: .png, .svg or .pdf",
    FW_INTO(output), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_table_file = {"--output",      "-o",
                                        "FILE",          "file of the table (standard output)",
                                        FW_INTO(output), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_export_file = {
    "--output",      "-o",
    "FILE",          "file that is made (DIR with the ending of the format; of vtp .pvd)",
    FW_INTO(output), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_to = {
    "--to", NULL, "FORMAT", FW_EXPORT_FORMATS, FW_INTO(to), .choices = FW_EXPORT_FORMATS};
const fw_option fw_option_every = {"--every",
                                   NULL,
                                   "N",
                                   "only every Nth frame, from the first on",
                                   FW_INTO(every),
                                   .least = 1,
                                   .most = INT64_MAX};
const fw_option fw_option_film_file = {"--output",      "-o",
                                       "FILE",          "the film, which ends in " FW_FILM_ENDINGS,
                                       FW_INTO(output), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_report_file = {"--output",      "-o",
                                         "FILE",          "the page, which ends in .html",
                                         FW_INTO(output), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_width = {
    "--width",      NULL,
    "MM",           "width of the picture in mm (160); a column of a journal has 86",
    FW_INTO(width), .least = 40,
    .most = 1000};
const fw_option fw_option_dots = {
    "--dpi",       NULL,        "N",         "dots per inch of a PNG file (200)",
    FW_INTO(dots), .least = 20, .most = 2400};
const fw_option fw_option_height = {
    "--height",      NULL,        "MM",        "height of all charts together in mm",
    FW_INTO(height), .least = 10, .most = 1000};
const fw_option fw_option_palette = {
    "--palette", NULL, "NAME", FW_PALETTE_NAMES, FW_INTO(palette), .choices = FW_PALETTE_NAMES};
const fw_option fw_option_in_steps = {"--in-steps", NULL, NULL, "a series over steps, not times",
                                      FW_INTO(in_steps)};
const fw_option fw_option_font_size = {"--font-size", NULL, "PT",
                                       "size of the labels in points (8.5); lines go with it",
                                       FW_INTO(font_size)};
const fw_option fw_option_x_range = {"--x-range", NULL, "LOW,HIGH",
                                     "ends of the x axis, in the units that are shown",
                                     FW_INTO(x_range)};
const fw_option fw_option_y_range = {"--y-range", NULL, "LOW,HIGH", "the same of the y axis",
                                     FW_INTO(y_range)};
const fw_option fw_option_with = {
    "--with",      NULL,
    "DIR",         "a series: the same of this result, too (may be repeated)",
    FW_INTO(with), .complete = FW_COMPLETE_FOLDER};
const fw_option fw_option_style = {
    "--style",      NULL,
    "FILE",         "width, dpi, font-size and bare from a file: one look for all",
    FW_INTO(style), .complete = FW_COMPLETE_FILE};
const fw_option fw_option_bare = {"--bare", NULL, NULL,
                                  "without title and caption, which the paper around it has",
                                  FW_INTO(bare)};
const fw_option fw_option_letter = {"--letter", NULL, "LETTER",
                                    "in the place of the title, as 'a' of a figure's panel",
                                    FW_INTO(letter)};
const fw_option fw_option_rerun_folder = {"--output",      "-o",
                                          "DIR",           "folder of the new results (DIR-again)",
                                          FW_INTO(output), .complete = FW_COMPLETE_FOLDER};
const fw_option fw_option_film_kind = {
    "--kind",      NULL,
    "KIND",        "motion, or field: by a field as colour (where one was recorded)",
    FW_INTO(kind), .choices = "motion, field"};
const fw_option fw_option_rate = {
    "--rate",      NULL,       "N",        "frames that are shown in a second (25)",
    FW_INTO(rate), .least = 1, .most = 240};
const fw_option fw_option_set = {
    "--set",
    NULL,
    "KEY=VALUE",
    "changes a value, as 'bodies.sheet.velocity=[0.1,0]'; items of lists count from 0",
    FW_INTO(settings),
    .complete = FW_COMPLETE_SETTING};
const fw_option fw_option_seed = {"--seed",
                                  NULL,
                                  "N",
                                  "one run from this seed of everything random, also of a study",
                                  FW_INTO(seed),
                                  .least = 0,
                                  .most = (int64_t)FW_INTEGER_MAX};
const fw_option fw_option_threads = {
    "--threads",
    "-j",
    "N",
    "threads of a run (1); of a study or a sweep, runs side by side (as many as there are "
    "processors)",
    FW_INTO(threads),
    .least = 1,
    .most = 1024};
const fw_option fw_option_quiet = {"--quiet", "-q", NULL, "no progress", FW_INTO(quiet)};
const fw_option fw_option_overwrite = {
    "--overwrite", NULL, NULL, "replaces an earlier result in the folder", FW_INTO(overwrite)};
const fw_option fw_option_no_plot = {"--no-plot", NULL, NULL, "draws no pictures",
                                     FW_INTO(no_plot)};
const fw_option fw_option_kind = {"--kind",         NULL,          "KIND",
                                  FW_PICTURE_NAMES, FW_INTO(kind), .choices = FW_PICTURE_NAMES};
const fw_option fw_option_field = {"--field", NULL, "NAME",
                                   "field that is drawn as colour, or printed", FW_INTO(field)};
const fw_option fw_option_observable = {
    "--observable",      NULL,
    "NAME[,NAME]",       "observables that are drawn or written over time",
    FW_INTO(observable), .complete = FW_COMPLETE_QUANTITY};
const fw_option fw_option_at = {
    "--at", NULL, "STEP[,STEP]",
    "steps that are drawn; of a series or a map over time, from the first to the second",
    FW_INTO(at)};
const fw_option fw_option_logarithmic = {"--logarithmic", NULL, NULL,
                                         "logarithmic axes for the values of a series",
                                         FW_INTO(logarithmic)};
const fw_option fw_option_range = {
    "--range", NULL, "LOW,HIGH",
    "ends of the colours of a field (the least and greatest value of the whole result)",
    FW_INTO(range)};
const fw_option fw_option_along = {
    "--along", NULL, "NAME",
    "along the x axis: of a sweep a parameter or number, of a series an observable",
    FW_INTO(along)};
const fw_option fw_option_level = {"--level", NULL, "VALUE",
                                   "of a map of a sweep: a line where its number has this value",
                                   FW_INTO(level)};
const fw_option fw_option_body = {
    "--body", NULL, "NAME", "of slip and heat: the body whose particles are shown", FW_INTO(body)};
const fw_option fw_option_from = {
    "--from",      NULL,       "STEP",           "first step of a series or a map over time",
    FW_INTO(from), .least = 0, .most = INT64_MAX};
const fw_option fw_option_until = {
    "--until",      NULL,       "STEP",           "last step of a series or a map over time",
    FW_INTO(until), .least = 1, .most = INT64_MAX};
const fw_option fw_option_picture = {"--picture", NULL, "NAME",
                                     "one of the scenario's own pictures", FW_INTO(picture)};
const fw_option fw_option_verdicts = {"--json",
                                      NULL,
                                      "FILE",
                                      "the verdicts as JSON too; - : on stdout, instead of tables",
                                      FW_INTO(json_file),
                                      .complete = FW_COMPLETE_FILE};
const fw_option fw_option_axis = {"--axis",      NULL,
                                  "AXIS",        "x or y: the coordinate of the profile",
                                  FW_INTO(axis), .choices = "x, y"};
const fw_option fw_option_json = {"--json", NULL, NULL, "the same as one value of JSON",
                                  FW_INTO(json)};
const fw_option fw_option_list_cases = {
    "--list", NULL, NULL, "one command line per case, to be run in any order by any engine",
    FW_INTO(list)};
const fw_option fw_option_case = {"--case", NULL, "CASE",
                                  "runs this case of the sweep in DIR, as A=1,p=2, unless it is "
                                  "finished or taken",
                                  FW_INTO(one_case)};
const fw_option fw_option_add = {"--add", NULL, "NAME=VALUE",
                                 "a further value of a parameter; of a sweep with points all of "
                                 "them, as A=1,p=2",
                                 FW_INTO(additions)};
const fw_option fw_option_names = {"--names", NULL, NULL, "only the names, one a line",
                                   FW_INTO(names)};
const fw_option fw_option_full = {
    "--full", NULL, NULL, "also the experiments that a small one stands for", FW_INTO(full)};
const fw_option fw_option_help = {"--help", "-h", NULL, "this text", FW_INTO(help)};

static bool is_named(const char *name, const char *word, size_t length)
{
    return name && strlen(name) == length && strncmp(name, word, length) == 0;
}

/* The number of one that the command takes, or -1. */
static int find_option(const fw_command *command, const char *word, size_t length)
{
    for (int n = 0; command->options[n]; ++n)
        if (is_named(command->options[n]->name, word, length) ||
            is_named(command->options[n]->brief, word, length))
            return n;
    return -1;
}

static fw_status refuse_option(const fw_command *command, const char *word, size_t length,
                               fw_error *error)
{
    const fw_quote name = fw_text_quote(word, length);
    /* The dashes, which are always right, say nothing about the word. */
    fw_suggestion suggestion = fw_suggestion_begin(name.text + strspn(name.text, "-"));
    for (int n = 0; command->options[n]; ++n)
        fw_suggestion_offer(&suggestion, command->options[n]->name + 2);
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "fretwork %s has no option %s; did you mean --%s?",
                       command->name, name.text, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "fretwork %s has no option %s, expected one of `fretwork %s --help`",
                   command->name, name.text, command->name);
}

static fw_status read_count(const fw_option *o, const char *value, int64_t *count, fw_error *error)
{
    const size_t length = strlen(value);
    if (fw_integer_read(value, length, count) == FW_NUMBER_FINE && *count >= o->least &&
        *count <= o->most)
        return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s %s, expected a whole number from %lld to %lld", o->name,
                   fw_text_quote(value, length).text, (long long)o->least, (long long)o->most);
}

static fw_status append(const fw_option *o, const char *value, fw_option_list *list,
                        fw_error *error)
{
    if (list->count == FW_SETTINGS_MAX)
        return fw_fail(error, FW_BAD_INPUT, "more than %d %s options", FW_SETTINGS_MAX, o->name);
    list->item[list->count++] = value;
    return FW_OK;
}

static fw_status store(fw_arguments *arguments, const fw_option *o, const char *value,
                       fw_error *error)
{
    void *member = (char *)arguments + o->at;
    switch (o->form) {
    case FW_OPTION_FLAG:
        *(bool *)member = true;
        return FW_OK;
    case FW_OPTION_TEXT:
        *(const char **)member = value;
        return FW_OK;
    case FW_OPTION_COUNT:
        return read_count(o, value, member, error);
    case FW_OPTION_LIST:
        break;
    }
    return append(o, value, member, error);
}

static fw_status read_option(fw_arguments *arguments, const fw_command *command, int count,
                             char **words, int *n, fw_error *error)
{
    const char *word = words[*n], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    int number = find_option(command, word, length);
    /* -j2, as other programs have it. */
    if (number < 0 && word[1] != '-' && length > 2) {
        number = find_option(command, word, 2);
        if (number >= 0 && command->options[number]->form != FW_OPTION_FLAG) length = 2;
        if (length > 2) number = -1;
        if (length == 2) equals = NULL;
    }
    if (number < 0) return refuse_option(command, word, length, error);
    const fw_option *o = command->options[number];
    if (o->form == FW_OPTION_FLAG) {
        if (!equals) return store(arguments, o, NULL, error);
        return fw_fail(error, FW_BAD_INPUT, "%s takes no value, but has %s", o->name,
                       fw_text_quote(equals + 1, strlen(equals + 1)).text);
    }
    const char *value = equals           ? equals + 1
                        : word[length]   ? word + length
                        : *n + 1 < count ? words[++*n]
                                         : NULL;
    if (!value)
        return fw_fail(error, FW_BAD_INPUT, "%s comes last, expected %s behind it", o->name,
                       o->value);
    /* Of two folders or seeds one would be lost without a word. */
    assert(number < FW_OPTIONS_MAX);
    if (o->form != FW_OPTION_LIST && arguments->given[number])
        return fw_fail(error, FW_BAD_INPUT, "%s is given a second time, as %s", o->name,
                       fw_text_quote(value, strlen(value)).text);
    arguments->given[number] = true;
    return store(arguments, o, value, error);
}

fw_status fw_arguments_read(fw_arguments *arguments, const fw_command *command, int count,
                            char **words, fw_error *error)
{
    bool only_words = false;
    *arguments = (fw_arguments){.seed = -1};
    for (int n = 0; n < count; ++n) {
        if (!only_words && strcmp(words[n], "--") == 0) {
            only_words = true;
        } else if (!only_words && words[n][0] == '-' && words[n][1] != '\0') {
            FW_TRY(read_option(arguments, command, count, words, &n, error));
        } else if (arguments->word_count == FW_WORDS_MAX) {
            return fw_fail(error, FW_BAD_INPUT, "more than %d words", FW_WORDS_MAX);
        } else {
            arguments->words[arguments->word_count++] = words[n];
        }
    }
    if (arguments->help) return FW_OK;
    if (arguments->word_count < command->words_min)
        return fw_fail(error, FW_BAD_INPUT, "expected fretwork %s", command->usage);
    if (arguments->word_count <= command->words_max) return FW_OK;
    const char *extra = arguments->words[command->words_max];
    return fw_fail(error, FW_BAD_INPUT, "%s is one word too many, expected fretwork %s",
                   fw_text_quote(extra, strlen(extra)).text, command->usage);
}

void fw_option_usage(const fw_option *option, char left[64])
{
    snprintf(left, 64, "%s%s%s%s%s", option->brief ? option->brief : "", option->brief ? ", " : "",
             option->name, option->value ? " " : "", option->value ? option->value : "");
}

void fw_option_print(FILE *out, const fw_command *command)
{
    for (int n = 0; command->options[n]; ++n) {
        char left[64];
        fw_option_usage(command->options[n], left);
        fprintf(out, "  %-32s %s\n", left, command->options[n]->meaning);
    }
}
