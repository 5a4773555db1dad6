/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command.c - the table of commands, and how their words and options are read. */
#include "experiments/commands/command.h"

#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/picture_kind.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

const fw_command fw_commands[] = {
    {"list", "list", "named experiments, one line each", "h", 0, 0, fw_command_list},
    {"show", "show NAME", "its scenario file, ready to copy and edit", "h", 1, 1, fw_command_show},
    {"check", "check NAME|FILE",
     "says without running it what an experiment takes; with -o FILE draws its start", "hiset", 1,
     1, fw_command_check},
    {"run", "run NAME|FILE", "runs an experiment, draws its pictures and says what came out",
     "hosetqwn", 1, 1, fw_command_run},
    {"resume", "resume DIR", "goes on exactly where a run stopped", "htqn", 1, 1,
     fw_command_resume},
    {"verify", "verify [NAME...]", "runs experiments and holds them against what they should show",
     "hstqj", 0, FW_WORDS_MAX, fw_command_verify},
    {"plot", "plot DIR", "draws pictures of a result", "hikfbaplr", 1, 1, fw_command_plot},
    {"table", "table DIR", "observables of a result as comma-separated values", "hcb", 1, 1,
     fw_command_table},
    {"profile", "profile DIR",
     "what a result says across the contact: profile and layer; with --field beside the control",
     "hfx", 1, 1, fw_command_profile},
    {"quantities", "quantities", "what can be measured, recorded and expected, by name", "h", 0, 0,
     fw_command_quantities},
    {"reference", "reference", "every key of a scenario file", "h", 0, 0, fw_command_reference},
    {NULL, NULL, NULL, NULL, 0, 0, NULL},
};

typedef struct option {
    char letter; /* in fw_command.options */
    const char *name, *brief, *value, *meaning;
} option;

static const option options[] = {
    {'o', "--output", "-o", "DIR", "folder of the results (results/NAME)"},
    {'i', "--output", "-o", "FILE", "file of the picture: .png, .svg or .pdf"},
    {'c', "--output", "-o", "FILE", "file of the table (standard output)"},
    {'s', "--set", NULL, "KEY=VALUE",
     "changes a value, as 'bodies.sheet.velocity=[0.1,0]'; items of lists count from 0"},
    {'e', "--seed", NULL, "N", "seed of everything random, the same as --set run.seed=N"},
    {'t', "--threads", "-j", "N",
     "threads (1); more pay from some 100,000 particles on, results do not depend on them"},
    {'q', "--quiet", "-q", NULL, "no progress"},
    {'w', "--overwrite", NULL, NULL, "replaces an earlier result in the folder"},
    {'n', "--no-plot", NULL, NULL, "draws no pictures"},
    {'k', "--kind", NULL, "KIND", FW_PICTURE_NAMES},
    {'f', "--field", NULL, "NAME", "field that is drawn as colour, or printed"},
    {'b', "--observable", NULL, "NAME[,NAME]", "observables that are drawn or written over time"},
    {'a', "--at", NULL, "STEP[,STEP]",
     "steps that are drawn; of a series, from the first to the second"},
    {'l', "--logarithmic", NULL, NULL, "logarithmic axes for the values of a series"},
    {'r', "--range", NULL, "LOW,HIGH",
     "ends of the colours of a field (the least and greatest value of the whole result)"},
    {'p', "--picture", NULL, "NAME", "one of the scenario's own pictures"},
    {'j', "--json", NULL, "FILE", "the verdicts as JSON too; - : on stdout, instead of tables"},
    {'x', "--axis", NULL, "AXIS", "x or y: the coordinate of the profile"},
    {'h', "--help", "-h", NULL, "this text"},
    {0, NULL, NULL, NULL, NULL},
};

static bool takes(const fw_command *command, const option *o)
{
    return strchr(command->options, o->letter) != NULL;
}

/* One that the command takes, or NULL. */
static const option *find_option(const fw_command *command, const char *word, size_t length)
{
    for (const option *o = options; o->letter; ++o) {
        if (!takes(command, o)) continue;
        if (strlen(o->name) == length && strncmp(o->name, word, length) == 0) return o;
        if (o->brief && strlen(o->brief) == length && strncmp(o->brief, word, length) == 0)
            return o;
    }
    return NULL;
}

static fw_status refuse_option(const fw_command *command, const char *word, size_t length,
                               fw_error *error)
{
    char name[FW_NAME_BYTES + 1];
    snprintf(name, sizeof name, "%.*s", (int)length, word);
    /* The dashes, which are always right, say nothing about the word. */
    fw_suggestion suggestion = fw_suggestion_begin(name + strspn(name, "-"));
    for (const option *o = options; o->letter; ++o)
        if (takes(command, o)) fw_suggestion_offer(&suggestion, o->name + 2);
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "fretwork %s has no option %s; did you mean --%s?",
                       command->name, name, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "fretwork %s has no option %s, expected one of `fretwork %s --help`",
                   command->name, name, command->name);
}

static fw_status add_setting(fw_arguments *arguments, const char *setting, fw_error *error)
{
    if (arguments->setting_count == FW_SETTINGS_MAX)
        return fw_fail(error, FW_BAD_INPUT, "more than %d --set options", FW_SETTINGS_MAX);
    arguments->settings[arguments->setting_count++] = setting;
    return FW_OK;
}

static fw_status read_threads(fw_arguments *arguments, const char *value, fw_error *error)
{
    int64_t threads;
    if (fw_integer_read(value, strlen(value), &threads) != FW_NUMBER_FINE || threads < 1 ||
        threads > 1024)
        return fw_fail(error, FW_BAD_INPUT, "--threads %s, expected a whole number from 1 to 1024",
                       value);
    arguments->threads = (int)threads;
    return FW_OK;
}

/* "run.seed=N" for --seed N; kept in the arguments' own memory. */
static fw_status add_seed(fw_arguments *arguments, const char *value, fw_error *error)
{
    snprintf(arguments->seed, sizeof arguments->seed, "run.seed=%s", value);
    if (strlen(value) >= sizeof arguments->seed - sizeof "run.seed=")
        return fw_fail(error, FW_BAD_INPUT, "--seed %.40s..., expected a whole number", value);
    return add_setting(arguments, arguments->seed, error);
}

static fw_status store(fw_arguments *a, const option *o, const char *value, fw_error *error)
{
    switch (o->letter) {
    case 'o':
    case 'i':
    case 'c':
        a->output = value;
        break;
    case 's':
        return add_setting(a, value, error);
    case 'e':
        return add_seed(a, value, error);
    case 't':
        return read_threads(a, value, error);
    case 'q':
        a->quiet = true;
        break;
    case 'w':
        a->overwrite = true;
        break;
    case 'n':
        a->no_plot = true;
        break;
    case 'k':
        a->kind = value;
        break;
    case 'f':
        a->field = value;
        break;
    case 'b':
        a->observable = value;
        break;
    case 'a':
        a->at = value;
        break;
    case 'p':
        a->picture = value;
        break;
    case 'l':
        a->logarithmic = true;
        break;
    case 'r':
        a->range = value;
        break;
    case 'j':
        a->json = value;
        break;
    case 'x':
        a->axis = value;
        break;
    case 'h':
        a->help = true;
        break;
    default:
        break;
    }
    return FW_OK;
}

static fw_status read_option(fw_arguments *arguments, const fw_command *command, int count,
                             char **words, int *n, fw_error *error)
{
    const char *word = words[*n], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const option *o = find_option(command, word, length);
    if (!o) return refuse_option(command, word, length, error);
    if (!o->value) {
        if (equals)
            return fw_fail(error, FW_BAD_INPUT, "%s takes no value, but has %s", o->name,
                           equals + 1);
        return store(arguments, o, NULL, error);
    }
    const char *value = equals ? equals + 1 : *n + 1 < count ? words[++*n] : NULL;
    if (!value)
        return fw_fail(error, FW_BAD_INPUT, "%s comes last, expected %s behind it", o->name,
                       o->value);
    /* Of two folders or seeds one would be lost without a word. */
    if (o->letter != 's' && strchr(arguments->given, o->letter))
        return fw_fail(error, FW_BAD_INPUT, "%s is given a second time, as %s", o->name, value);
    size_t given = strlen(arguments->given);
    if (given < sizeof arguments->given - 1) arguments->given[given] = o->letter;
    return store(arguments, o, value, error);
}

fw_status fw_arguments_read(fw_arguments *arguments, const fw_command *command, int count,
                            char **words, fw_error *error)
{
    bool only_words = false;
    *arguments = (fw_arguments){0};
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
    if (arguments->word_count < command->least_words)
        return fw_fail(error, FW_BAD_INPUT, "expected fretwork %s", command->usage);
    if (arguments->word_count > command->most_words)
        return fw_fail(error, FW_BAD_INPUT, "%s is one word too many, expected fretwork %s",
                       arguments->words[command->most_words], command->usage);
    return FW_OK;
}

void fw_command_print_options(FILE *out, const fw_command *command)
{
    for (const option *o = options; o->letter; ++o) {
        if (!takes(command, o)) continue;
        char left[64];
        snprintf(left, sizeof left, "%s%s%s%s%s", o->brief ? o->brief : "", o->brief ? ", " : "",
                 o->name, o->value ? " " : "", o->value ? o->value : "");
        fprintf(out, "  %-32s %s\n", left, o->meaning);
    }
}

static bool is_file(const char *word)
{
    size_t length = strlen(word);
    return strchr(word, '/') || (length > 5 && strcasecmp(word + length - 5, ".yaml") == 0) ||
           (length > 4 && strcasecmp(word + length - 4, ".yml") == 0);
}

fw_status fw_command_load(fw_scenario **scenario, const char *word, const fw_arguments *arguments,
                          char name[FW_NAME_BYTES + 1], fw_error *error)
{
    *scenario = NULL;
    if (is_file(word)) {
        const char *base = strrchr(word, '/') ? strrchr(word, '/') + 1 : word;
        size_t length = strrchr(base, '.') && strrchr(base, '.') > base
                            ? (size_t)(strrchr(base, '.') - base)
                            : strlen(base);
        snprintf(name, FW_NAME_BYTES + 1, "%.*s", (int)(length < 64 ? length : 64), base);
        return fw_scenario_load(scenario, word, arguments->settings, arguments->setting_count,
                                error);
    }
    const fw_catalogue_entry *entry;
    FW_TRY(fw_catalogue_find(&entry, word, error));
    snprintf(name, FW_NAME_BYTES + 1, "%s", entry->name);
    char file[FW_NAME_BYTES + 8];
    snprintf(file, sizeof file, "%s.yaml", entry->name);
    return fw_scenario_read(scenario, file, entry->text, entry->length, arguments->settings,
                            arguments->setting_count, error);
}

int fw_command_threads(const fw_arguments *arguments)
{
    return arguments->threads > 0 ? arguments->threads : 1;
}
