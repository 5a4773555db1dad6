/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_list.c - list: the named experiments, grouped by what one wants to see, and what a result
 * is. Keeps no state. Start reading at fw_command_list(). */
#include "command_list_result.h"
#include "experiments/commands/command.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/text/json.h"
#include "experiments/text/spelling.h"
#include "lookup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const groups[FW_GROUPS] = {
    [FW_GROUP_OWN] = "Others",
    [FW_GROUP_START_HERE] = "Start here",
    [FW_GROUP_LB_SOLID] = "The lattice Boltzmann solid",
    [FW_GROUP_ELASTIC_AUTOMATON] = "The elastic automaton",
    [FW_GROUP_MOVABLE_PARTICLES] = "Movable lattice particles",
    [FW_GROUP_WALLS_AND_CONTACT] = "Walls and contact",
    [FW_GROUP_FRICTION] = "Friction",
    [FW_GROUP_STUDIES] = "Studies",
};

typedef struct catalogue {
    int count;
    fw_scenario **scenarios; /* of fw_catalogue, in its order */
    bool *wanted;
} catalogue;

static void release(catalogue *c)
{
    for (int n = 0; c->scenarios && n < c->count; ++n) fw_scenario_destroy(c->scenarios[n]);
    free(c->scenarios);
    free(c->wanted);
}

static fw_status load(catalogue *c, fw_error *error)
{
    while (fw_catalogue[c->count].name) c->count += 1;
    c->scenarios = calloc((size_t)c->count, sizeof *c->scenarios);
    c->wanted = calloc((size_t)c->count, sizeof *c->wanted);
    if (!c->scenarios || !c->wanted) return fw_fail_memory(error, "the catalogue");
    for (int n = 0; n < c->count; ++n)
        FW_TRY(fw_scenario_read(&c->scenarios[n], fw_catalogue[n].name, fw_catalogue[n].text,
                                fw_catalogue[n].length, NULL, 0, error));
    return FW_OK;
}

/* --- which ones --- */

static fw_status choose(catalogue *c, const fw_arguments *arguments, fw_error *error)
{
    int found = 0;
    const char *word = arguments->word_count > 0 ? arguments->words[0] : "";
    fw_suggestion suggestion = fw_suggestion_begin(word);
    for (int n = 0; n < c->count; ++n) {
        const fw_scenario *s = c->scenarios[n];
        const char *const texts[] = {fw_catalogue[n].name, s->title, s->source, groups[s->group]};
        c->wanted[n] = fw_lookup_fits(arguments, texts, 4);
        found += c->wanted[n];
        fw_suggestion_offer(&suggestion, fw_catalogue[n].name);
    }
    if (found > 0) return FW_OK;
    const fw_quote quote = fw_lookup_quote(arguments);
    if (suggestion.best && arguments->word_count == 1)
        return fw_fail(error, FW_BAD_INPUT, "no experiment speaks of '%s'; did you mean '%s'?",
                       quote.text, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "no experiment speaks of '%s', expected words of those that `fretwork list` "
                   "shows",
                   quote.text);
}

/* --- how they are printed --- */

/* "0.02 s", "2 min" */
static void write_time(double seconds, char text[16])
{
    text[0] = '\0';
    if (seconds >= 100)
        snprintf(text, 16, "%.0f min", seconds / 60);
    else if (seconds > 0)
        snprintf(text, 16, "%.2g s", seconds);
}

static void print_line(const char *name, const fw_scenario *scenario)
{
    char time[16];
    write_time(scenario->takes, time);
    printf("  %-20s %7s  %s", name, time, scenario->title);
    if (scenario->source) printf("  [%s]", scenario->source);
    printf("\n");
}

static void print_groups(const catalogue *c)
{
    bool first = true;
    for (int pass = 1; pass <= FW_GROUPS; ++pass) {
        const fw_scenario_group group = (fw_scenario_group)(pass % FW_GROUPS);
        bool begun = false;
        for (int n = 0; n < c->count; ++n) {
            if (!c->wanted[n] || c->scenarios[n]->group != group) continue;
            if (!begun) printf("%s%s\n", first ? "" : "\n", groups[group]);
            first = false;
            begun = true;
            print_line(fw_catalogue[n].name, c->scenarios[n]);
        }
    }
}

static void print_one(const char *name, const fw_scenario *scenario)
{
    char time[16];
    write_time(scenario->takes, time);
    printf("%s: %s\n", name, scenario->title);
    printf("  %-8s %s\n", "group", groups[scenario->group]);
    if (scenario->source) printf("  %-8s %s\n", "source", scenario->source);
    if (scenario->figure) printf("  %-8s %s\n", "figure", scenario->figure);
    if (*time) printf("  %-8s %s, about\n", "takes", time);
    if (scenario->about) printf("\n%s", scenario->about);
    printf("\n`fretwork show %s` prints its scenario, `fretwork run %s` runs it.\n", name, name);
}

/* A list of {name, title, group, source, figure, takes, about}; null: unknown. */
static void write_json(const catalogue *c)
{
    fw_json json = {.out = stdout};
    fw_json_begin(&json, NULL, '[');
    for (int n = 0; n < c->count; ++n) {
        const fw_scenario *s = c->scenarios[n];
        if (!c->wanted[n]) continue;
        fw_json_begin(&json, NULL, '{');
        fw_json_text(&json, "name", fw_catalogue[n].name);
        fw_json_text(&json, "title", s->title);
        fw_json_text(&json, "group", groups[s->group]);
        fw_json_text(&json, "source", s->source);
        fw_json_text(&json, "figure", s->figure);
        fw_json_number(&json, "takes", s->takes > 0 ? s->takes : NAN);
        fw_json_text(&json, "about", s->about);
        fw_json_end(&json, '}');
    }
    fw_json_end(&json, ']');
}

/* The number of the experiment of that name, or -1. */
static int find_name(const char *word)
{
    for (int n = 0; fw_catalogue[n].name; ++n)
        if (strcmp(fw_catalogue[n].name, word) == 0) return n;
    return -1;
}

fw_status fw_command_list(const fw_arguments *arguments, fw_error *error)
{
    const char *word = arguments->word_count == 1 ? arguments->words[0] : "";
    const int named = find_name(word);
    catalogue c = {0};
    if (named < 0 && fw_command_is_result(word))
        return fw_command_list_result(word, arguments->json, error);
    fw_status status = load(&c, error);
    if (status == FW_OK && named < 0) status = choose(&c, arguments, error);
    if (status == FW_OK && named >= 0) c.wanted[named] = true;
    if (status == FW_OK && arguments->json)
        write_json(&c);
    else if (status == FW_OK && arguments->names)
        for (int n = 0; n < c.count; ++n) {
            if (c.wanted[n]) printf("%s\n", fw_catalogue[n].name);
        }
    else if (status == FW_OK && named >= 0)
        print_one(word, c.scenarios[named]);
    else if (status == FW_OK)
        print_groups(&c);
    release(&c);
    return status;
}
