/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_study.c - profile and study of a scenario. Keeps no state. Start reading at
 * fw_scenario_read_study(). */
#include "scenario_parts.h"

static const fw_key profile_keys[] = {
    {"axis", AT_WORD(fw_scenario_profile, axis), WORDS({"x", 0}, {"y", 1}), .default_value = "x",
     .meaning = "the coordinate that is cut into bins"},
    {"phase", AT_NAME(fw_scenario_profile, phase), .default_meaning = "the whole run",
     .meaning = "during which samples are taken"},
    {"every", AT_INTEGER(fw_scenario_profile, every), REQUIRED, AT_LEAST(1), .unit = "steps",
     .meaning = "between two samples"},
    {"bin", AT_NUMBER(fw_scenario_profile, bin), ABOVE_ZERO, .default_value = "1", .unit = "length",
     .meaning = "width of a bin; one is centred on the middle"},
    {"middle", AT_NUMBER(fw_scenario_profile, middle), .default_value = "0", .unit = "length",
     .meaning = "where the contact is"},
    {"window", AT_NUMBERS(fw_scenario_profile, window), .layout = "[from, to]",
     .default_value = "[0, 0]", .default_meaning = "all", .unit = "length",
     .meaning = "of the other coordinate: only particles in it count"},
    {"contact", AT_NUMBER(fw_scenario_profile, contact), ABOVE_ZERO, .default_value = "1.8",
     .unit = "length", .meaning = "the contact region is what is nearer to the middle than this"},
    {"far", AT_NUMBERS(fw_scenario_profile, far), .layout = "[from, to]", AT_LEAST(0),
     .default_value = "[6, 9]", .unit = "length",
     .meaning = "distances from the middle between which a place is far from the contact"},
    {.name = NULL}};

const fw_section fw_profile_section = {
    "`profile`", "a profile",
    "Averages across the scene, in bins of one coordinate, over samples of a phase and over the "
    "seeds of the study: what `fretwork profile` prints. Of movable particles; where there are "
    "none, of all bodies, which have no order and no bonds that break. An automaton knows no "
    "return force.",
    .keys = profile_keys};

static const fw_key study_keys[] = {
    {"seeds", AT_INTEGER(fw_scenario_study, seeds), FROM_TO(1, FW_SEEDS_MAX), .default_value = "1",
     .meaning = "how many runs, with `run.seed` and the numbers after it"},
    {"keep", AT_FLAG(fw_scenario_study, keep), .default_value = "false",
     .meaning = "keeps the trajectories of all seeds, in `DIR/seed-N`, and of their controls, in "
                "`DIR/control-seed-N`"},
    {"control", FW_FORM_LIST, .items = FW_FORM_TEXT, .least = 1, .most = 64, NOT_STORED,
     .default_meaning = "none",
     .meaning = "changes, as `--set` has them, that turn the experiment into its control; that is "
                "run with the same seeds"},
    {"sweep", FW_FORM_MAPPING, .subsection = &fw_sweep_section, NOT_STORED,
     .default_meaning = "none",
     .meaning = "the whole study once for each value of one or more parameters"},
    {.name = NULL}};

const fw_section fw_study_section = {
    "`study`", "a study",
    "More runs of the same scenario, side by side: means and standard errors come from all "
    "seeds, and what is expected is held against the mean. `summary.csv` in the results has the "
    "numbers of each seed.",
    .keys = study_keys};

static fw_status read_profile(fw_scenario *scenario, const fw_node *node, fw_error *error)
{
    fw_scenario_profile *profile = &scenario->profile;
    FW_TRY(fw_schema_fill(scenario->document, &fw_profile_section, node, profile, error));
    profile->place = node->key_place;
    profile->from = 0;
    profile->until = scenario->run.steps;
    const fw_node *name = fw_node_find(node, "phase");
    if (name) {
        int phase;
        FW_TRY(fw_scenario_find_phase(scenario, name, &phase, error));
        profile->from = scenario->phases[phase].from;
        profile->until = scenario->phases[phase].until;
    }
    if (profile->every > profile->until - profile->from)
        return fw_scenario_fail(scenario, fw_node_find(node, "every")->place, error,
                                "profile.every is %lld, expected at most the %lld steps in which "
                                "samples are taken",
                                (long long)profile->every,
                                (long long)(profile->until - profile->from));
    static const char *const pairs[] = {"window", "far"};
    for (int n = 0; n < 2; ++n) {
        const fw_node *pair = fw_node_find(node, pairs[n]);
        if (pair && fw_node_number(pair->first) >= fw_node_number(pair->last))
            return fw_scenario_fail(scenario, pair->place, error,
                                    "profile.%s is [%g, %g], expected the smaller number first",
                                    pairs[n], fw_node_number(pair->first),
                                    fw_node_number(pair->last));
    }
    return FW_OK;
}

fw_status fw_scenario_read_study(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *profile = fw_scenario_part(scenario, "profile", &count);
    if (profile) FW_TRY(read_profile(scenario, profile, error));
    fw_scenario_study *study = &scenario->study;
    study->seeds = 1;
    const fw_node *node = fw_scenario_part(scenario, "study", &count);
    if (!node) return FW_OK;
    FW_TRY(fw_schema_fill(scenario->document, &fw_study_section, node, study, error));
    if ((double)(scenario->run.seed + study->seeds - 1) > FW_INTEGER_MAX)
        return fw_scenario_fail(scenario, node->place, error,
                                "study.seeds is %lld and run.seed %lld, expected the last of the "
                                "seeds to be at most %lld",
                                (long long)study->seeds, (long long)scenario->run.seed,
                                (long long)FW_INTEGER_MAX);
    const fw_node *control = fw_node_find(node, "control");
    if (!control) return FW_OK;
    if (!profile)
        return fw_scenario_fail(scenario, control->key_place, error,
                                "a control stands beside the profile of the experiment, and there "
                                "is no 'profile'");
    study->control_place = control->place;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)control->count, sizeof *study->control,
                                &study->control, error));
    for (const fw_node *item = control->first; item; item = item->next)
        study->control[study->control_count++] = item->text;
    return FW_OK;
}
