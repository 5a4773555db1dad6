/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command.c - the table of commands, and how they load what they run. Keeps no state. Start
 * reading at fw_commands. */
#include "experiments/commands/command.h"

#include "experiments/scenario/catalogue.h"

#include <string.h>
#include <strings.h>
#include <unistd.h>

#define OPTIONS(...)                                                                               \
    .options = (const fw_option *const[])                                                          \
    {                                                                                              \
        __VA_ARGS__, &fw_option_help, NULL                                                         \
    }
#define NO_OPTIONS                                                                                 \
    .options = (const fw_option *const[])                                                          \
    {                                                                                              \
        &fw_option_help, NULL                                                                      \
    }

const fw_command fw_commands[] = {
    {"list", "list [WORD...|DIR]",
     "named experiments, or those that speak of all words; of a result, what it holds and where it "
     "comes from",
     0, FW_WORDS_MAX, FW_COMPLETE_EXPERIMENT, OPTIONS(&fw_option_names, &fw_option_json),
     .run = fw_command_list},
    {"show", "show NAME|FILE",
     "its scenario file, ready to copy and edit, with the values of formulas behind them", 1, 1,
     FW_COMPLETE_EXPERIMENT, OPTIONS(&fw_option_set), .run = fw_command_show},
    {"check", "check NAME|FILE",
     "says without running it what an experiment takes; with -o FILE draws its start", 1, 1,
     FW_COMPLETE_EXPERIMENT,
     OPTIONS(&fw_option_picture_file, &fw_option_set, &fw_option_seed, &fw_option_threads,
             &fw_option_json),
     .run = fw_command_check},
    {"run", "run NAME|FILE", "runs an experiment, draws its pictures and says what came out", 1, 1,
     FW_COMPLETE_EXPERIMENT,
     OPTIONS(&fw_option_folder, &fw_option_set, &fw_option_seed, &fw_option_threads,
             &fw_option_quiet, &fw_option_overwrite, &fw_option_no_plot),
     .run = fw_command_run},
    {"rerun", "rerun DIR|FILE", "runs a result's own scenario again: are the results the same?", 1,
     1, FW_COMPLETE_FOLDER,
     OPTIONS(&fw_option_rerun_folder, &fw_option_threads, &fw_option_quiet, &fw_option_overwrite,
             &fw_option_no_plot),
     .run = fw_command_rerun},
    {"resume", "resume DIR", "goes on exactly where a run stopped", 1, 1, FW_COMPLETE_FOLDER,
     OPTIONS(&fw_option_threads, &fw_option_quiet, &fw_option_no_plot), .run = fw_command_resume},
    {"sweep", "sweep NAME|FILE|DIR",
     "prepares a sweep and lists a command for each case, or runs one of them", 1, 1,
     FW_COMPLETE_EXPERIMENT,
     OPTIONS(&fw_option_folder, &fw_option_list_cases, &fw_option_case, &fw_option_set,
             &fw_option_seed, &fw_option_threads, &fw_option_quiet, &fw_option_overwrite),
     .run = fw_command_sweep},
    {"collect", "collect DIR", "makes the table of a sweep whose cases were run one by one", 1, 1,
     FW_COMPLETE_FOLDER, OPTIONS(&fw_option_no_plot), .run = fw_command_collect},
    {"extend", "extend DIR", "runs further values of a sweep; what was run stays as it is", 1, 1,
     FW_COMPLETE_FOLDER,
     OPTIONS(&fw_option_add, &fw_option_set, &fw_option_threads, &fw_option_quiet,
             &fw_option_no_plot),
     .run = fw_command_extend},
    {"verify", "verify [NAME...]", "runs experiments and holds them against what they should show",
     0, FW_WORDS_MAX, FW_COMPLETE_EXPERIMENT,
     OPTIONS(&fw_option_set, &fw_option_threads, &fw_option_quiet, &fw_option_verdicts,
             &fw_option_full),
     .run = fw_command_verify},
    {"plot", "plot DIR", "draws pictures of a result", 1, 1, FW_COMPLETE_FOLDER,
     OPTIONS(&fw_option_picture_file, &fw_option_kind, &fw_option_field, &fw_option_observable,
             &fw_option_at, &fw_option_from, &fw_option_until, &fw_option_body,
             &fw_option_logarithmic, &fw_option_range, &fw_option_along, &fw_option_level,
             &fw_option_picture, &fw_option_width, &fw_option_dots, &fw_option_bare,
             &fw_option_letter, &fw_option_height, &fw_option_palette, &fw_option_in_steps,
             &fw_option_font_size, &fw_option_x_range, &fw_option_y_range, &fw_option_with,
             &fw_option_style),
     .run = fw_command_plot},
    {"film", "film DIR", "the motion of a result as a film", 1, 1, FW_COMPLETE_FOLDER,
     OPTIONS(&fw_option_film_file, &fw_option_film_kind, &fw_option_field, &fw_option_range,
             &fw_option_picture, &fw_option_every, &fw_option_rate),
     .run = fw_command_film},
    {"report", "report DIR",
     "a result, or a sweep with its cases, as one page: player, pictures, numbers, provenance", 1,
     1, FW_COMPLETE_FOLDER, OPTIONS(&fw_option_report_file), .run = fw_command_report},
    {"table", "table DIR", "observables of a result as comma-separated values", 1, 1,
     FW_COMPLETE_FOLDER, OPTIONS(&fw_option_table_file, &fw_option_observable),
     .run = fw_command_table},
    {"export", "export DIR",
     "the motion of a result as files of other programs: ParaView, OVITO, ASE, MDAnalysis, tables",
     1, 1, FW_COMPLETE_FOLDER, OPTIONS(&fw_option_to, &fw_option_export_file, &fw_option_every),
     .run = fw_command_export},
    {"profile", "profile DIR",
     "what a result says across the contact: profile and layer; with --field beside the control", 1,
     1, FW_COMPLETE_FOLDER, OPTIONS(&fw_option_field, &fw_option_axis), .run = fw_command_profile},
    {"quantities", "quantities [WORD...]",
     "what can be measured, recorded and expected: all, one by name, or those that speak of all "
     "words",
     0, FW_WORDS_MAX, FW_COMPLETE_QUANTITY, OPTIONS(&fw_option_json), .run = fw_command_quantities},
    {"reference", "reference [WORD...]",
     "every key of a scenario file, those of a name or path, or those that speak of all words", 0,
     FW_WORDS_MAX, FW_COMPLETE_KEY, OPTIONS(&fw_option_json), .run = fw_command_reference},
    {"cite", "cite NAME|FILE|DIR", "BibTeX of the papers that an experiment or a result rests on",
     1, 1, FW_COMPLETE_EXPERIMENT, NO_OPTIONS, .run = fw_command_cite},
    {"completion", "completion", "what makes bash complete its words", 0, 0, FW_COMPLETE_NOTHING,
     NO_OPTIONS, .run = fw_command_completion, .hidden = true},
    {"manual-page", "manual-page", "the manual page fretwork(1)", 0, 0, FW_COMPLETE_NOTHING,
     NO_OPTIONS, .run = fw_command_manual_page, .hidden = true},
    {.name = NULL}};

const fw_exit_code fw_exit_codes[] = {
    {0, "fine"},
    {1, "an expectation failed"},
    {2, "bad input: one sentence says what was found and what was expected"},
    {3, "the numbers diverged, or a particle escaped"},
    {4, "the system failed (disk, memory)"},
    {129, "hung up (SIGHUP), with a checkpoint"},
    {130, "interrupted (SIGINT), with a checkpoint"},
    {143, "terminated (SIGTERM), with a checkpoint"},
    {.code = -1}};

const fw_command *fw_command_find(const char *name)
{
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (strcmp(c->name, name) == 0) return c;
    return NULL;
}

void fw_command_print_help(FILE *out)
{
    fputs("fretwork: contact and friction experiments on lattice solids\n\n", out);
    for (const fw_command *c = fw_commands; c->name; ++c)
        if (!c->hidden) fprintf(out, "  fretwork %-20s %s\n", c->usage, c->summary);
    fputs("\nfretwork COMMAND --help prints the options of a command; fretwork --version the "
          "version.\n\nExit codes:\n",
          out);
    for (const fw_exit_code *e = fw_exit_codes; e->code >= 0; ++e)
        fprintf(out, "  %3d  %s\n", e->code, e->meaning);
}

fw_status fw_command_load(fw_scenario **scenario, const char *word, const fw_arguments *arguments,
                          char name[FW_NAME_BYTES + 1], fw_error *error)
{
    const fw_option_list *given = &arguments->settings;
    FW_TRY(fw_catalogue_load(scenario, word, given->item, given->count, name, error));
    if (arguments->seed < 0) return FW_OK;
    /* Read again, so that the scenario as run says what was run. */
    fw_option_list settings = arguments->settings;
    char seed[48];
    const bool several = (*scenario)->study.seeds > 1;
    fw_scenario_destroy(*scenario);
    *scenario = NULL;
    if (settings.count + 2 > FW_SETTINGS_MAX)
        return fw_fail(error, FW_BAD_INPUT, "more than %d --set options", FW_SETTINGS_MAX - 2);
    snprintf(seed, sizeof seed, "run.seed=%lld", (long long)arguments->seed);
    settings.item[settings.count++] = seed;
    if (several) settings.item[settings.count++] = "study.seeds=1";
    return fw_catalogue_load(scenario, word, settings.item, settings.count, name, error);
}

int fw_command_threads(const fw_arguments *arguments)
{
    return arguments->threads > 0 ? (int)arguments->threads : 1;
}

fw_run_options fw_command_run_options(const fw_arguments *arguments, const char *directory,
                                      const char *name, fw_progress *progress)
{
    *progress = fw_progress_begin(arguments->quiet ? NULL : stderr, name);
    return (fw_run_options){.directory = directory,
                            .threads = fw_command_threads(arguments),
                            .at_once = (int)arguments->threads,
                            .name = name,
                            .progress = progress,
                            .warnings = stderr};
}
