/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_expect.c - what a scenario expects. Keeps no state. Start reading at
 * fw_scenario_read_expectations(). */
#include "scenario_parts.h"

#include <string.h>

static const fw_word trend_words[] = {
    {"rises", FW_VERDICT_RISES}, {"falls", FW_VERDICT_FALLS}, {NULL, 0}};

static const fw_key expectation_keys[] = {
    {"quantity", AT_NAME(fw_expectation, quantity), REQUIRED, .meaning = "an observable"},
    {"body", AT_NAME(fw_expectation, body), .default_meaning = "the whole scene, or the only body",
     .meaning = "of which body"},
    {"wall", AT_NAME(fw_expectation, wall), .default_meaning = "the only one",
     .meaning = "of which wall"},
    {"grip", AT_NAME(fw_expectation, grip), .default_meaning = "the only one",
     .meaning = "of which grip"},
    {"phase", AT_NAME(fw_expectation, phase), .default_meaning = "the whole run",
     .meaning = "during which phase, in place of `from` and `until`"},
    {"analysis", AT_NAME(fw_expectation, analysis), .default_meaning = "the only one",
     .meaning = "of which analysis"},
    {"site", AT_SITE(fw_expectation, site), .layout = "[i, j]", .needs = "body",
     .default_meaning = "not of a single site", .meaning = "of which of the body's sites"},
    {"component", AT_NAME(fw_expectation, component), .default_meaning = "the only one",
     .meaning = "`x`, `y`, `xx`, ..."},
    {"at", AT_INTEGER(fw_expectation, at), AT_LEAST(0), .default_meaning = "see `statistic`",
     .unit = "steps", .meaning = "its value after so many steps, which must be measured there"},
    {"statistic", AT_WORD(fw_expectation, statistic),
     WORDS({"last", FW_STATISTIC_LAST}, {"first", FW_STATISTIC_FIRST},
           {"maximum", FW_STATISTIC_MAXIMUM}, {"minimum", FW_STATISTIC_MINIMUM},
           {"largest", FW_STATISTIC_LARGEST}, {"mean", FW_STATISTIC_MEAN},
           {"spread", FW_STATISTIC_SPREAD}, {"change", FW_STATISTIC_CHANGE},
           {"rate", FW_STATISTIC_RATE}, {"time-of-maximum", FW_STATISTIC_TIME_OF_MAXIMUM},
           {"time-of-minimum", FW_STATISTIC_TIME_OF_MINIMUM}),
     .default_value = "last",
     .meaning = "what of its values over time; largest: in magnitude; spread: standard deviation; "
                "change: last minus first; rate: least-squares slope against time",
     .old_name = "take"},
    {"from", AT_INTEGER(fw_expectation, from), AT_LEAST(0), .default_value = "0", .unit = "steps",
     .meaning = "first step that `statistic` looks at"},
    {"until", AT_INTEGER(fw_expectation, until), AT_LEAST(0),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "last step that `statistic` looks at"},
    {"when", FW_FORM_NUMBER | FW_FORM_POINT, NOT_STORED, .default_meaning = "every case of a sweep",
     .meaning = "values of a sweep's parameters for which it is expected, as {A: 2}; of one "
                "parameter its value is enough"},
    {"value", AT_NUMBER(fw_expectation, value), .default_meaning = "only bounds",
     .meaning = "what it should be"},
    {"within", FW_FORM_NUMBER, .needs = "value", AT_LEAST(0), NOT_STORED,
     .default_meaning = "see `within-relative`", .meaning = "by how much it may differ"},
    {"within-relative", FW_FORM_NUMBER, .needs = "value", AT_LEAST(0), NOT_STORED,
     .default_meaning = "see `within`",
     .meaning = "by how much it may differ, as a part of `value`"},
    {"below", AT_NUMBER(fw_expectation, below), .default_meaning = "no bound",
     .meaning = "it must be smaller"},
    {"above", AT_NUMBER(fw_expectation, above), .default_meaning = "no bound",
     .meaning = "it must be larger"},
    {"trend", FW_FORM_WORD, .words = trend_words, NOT_STORED, .default_meaning = "none",
     .meaning = "over a sweep: from each value to the next larger one its mean rises (falls) by "
                "more than the standard error of the difference, and than 1e-9 of its size"},
    {"crosses", AT_NUMBER(fw_expectation, level), .default_value = "0",
     .default_meaning = "no level",
     .meaning = "over a sweep: a level, and what is expected (`value` or bounds, or nothing but "
                "that there is one) is the value of the parameter at which the mean crosses it, "
                "see `tolerance`"},
    {"along", FW_FORM_NAME, NOT_STORED, .default_meaning = "the bisected or only parameter",
     .meaning = "which parameter's values a trend or a crossing compares, all others being the "
                "same"},
    {"source", AT_TEXT(fw_expectation, source), .default_meaning = "none",
     .meaning = "where the expected number comes from"},
    {"note", AT_TEXT(fw_expectation, note), .default_meaning = "none",
     .meaning = "a remark for the table of results"},
    {.name = NULL}};

const fw_section fw_expectation_section = {
    "Items of `expect`", "an expectation",
    "A number that the run must show, or it ends with exit code 1. Either `value` with `within` "
    "or `within-relative`, or `below`, `above` or both, or the `trend` of a sweep.",
    .keys = expectation_keys};

/* A phase in place of the steps that it takes. */
static fw_status read_phase(const fw_scenario *scenario, const fw_node *node, fw_expectation *e,
                            fw_error *error)
{
    const fw_node *name = fw_node_find(node, "phase");
    if (!name) return FW_OK;
    const fw_node *stray = fw_node_find(node, "from");
    if (!stray) stray = fw_node_find(node, "until");
    if (stray)
        return fw_scenario_fail(scenario, stray->key_place, error,
                                "the expectation of '%s' has both 'phase' and '%s', expected one "
                                "of them",
                                e->quantity.text, stray->key);
    int phase;
    FW_TRY(fw_scenario_find_phase(scenario, name, &phase, error));
    e->from = scenario->phases[phase].from;
    e->until = scenario->phases[phase].until;
    return FW_OK;
}

/* What `at` and `statistic` look at must be measured. */
static fw_status check_steps(const fw_scenario *scenario, const fw_node *node,
                             const fw_expectation *e, fw_error *error)
{
    static const char *const series_keys[] = {"statistic", "from", "until", "phase", NULL};
    const fw_scenario_run *run = &scenario->run;
    const char *quantity = e->quantity.text;
    if (e->has_at) {
        for (int n = 0; series_keys[n]; ++n) {
            const fw_node *other = fw_node_find(node, series_keys[n]);
            if (other)
                return fw_scenario_fail(scenario, other->key_place, error,
                                        "the expectation of '%s' has both 'at' and '%s', expected "
                                        "one step or a series",
                                        quantity, series_keys[n]);
        }
        bool measured = e->at % run->measure_every == 0 || e->at == run->steps;
        if (e->at <= run->steps && measured) return FW_OK;
        return fw_scenario_fail(scenario, fw_node_find(node, "at")->place, error,
                                "the expectation of '%s' is at step %lld, but the run ends at %lld "
                                "and measures at multiples of %lld",
                                quantity, (long long)e->at, (long long)run->steps,
                                (long long)run->measure_every);
    }
    const fw_node *until = fw_node_find(node, "until");
    if (e->from > run->steps)
        return fw_scenario_fail(scenario, fw_node_find(node, "from")->place, error,
                                "the expectation of '%s' begins at step %lld, after the %lld steps "
                                "of the run",
                                quantity, (long long)e->from, (long long)run->steps);
    if (until && (e->until < e->from || e->until > run->steps))
        return fw_scenario_fail(scenario, until->place, error,
                                "the expectation of '%s' ends at step %lld, expected %lld to %lld",
                                quantity, (long long)e->until, (long long)e->from,
                                (long long)run->steps);
    const fw_node *last = until;
    if (!last) last = fw_node_find(node, "phase");
    if (!last) last = fw_node_find(node, "from");
    if (!last) last = fw_node_find(node, "statistic");
    const int needed = e->statistic == FW_STATISTIC_RATE ? 2 : 1;
    const int64_t end = e->until < run->steps ? e->until : run->steps;
    const int64_t samples = fw_scenario_count_samples(scenario, e->from, end);
    if (samples >= needed) return FW_OK;
    return fw_scenario_fail(scenario, last->place, error,
                            "the expectation of '%s' looks at the steps %lld to %lld, of which "
                            "%lld are measured (run.measure-every is %lld), expected at least %s",
                            quantity, (long long)e->from, (long long)end, (long long)samples,
                            (long long)run->measure_every, needed == 2 ? "2 for a rate" : "1");
}

/* The parameter along which cases are compared. */
static fw_status read_along(const fw_scenario *scenario, const fw_node *node, const fw_node *why,
                            fw_expectation *e, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    const fw_node *along = fw_node_find(node, "along");
    if (sweep->parameter_count == 0 || (sweep->case_count < 2 && !sweep->is_case))
        return fw_scenario_fail(scenario, why->key_place, error,
                                "the expectation of '%s' has %s '%s', but the study has no "
                                "'sweep' of two values or more",
                                e->quantity.text, fw_expectation_is_trend(e) ? "a" : "the key",
                                why->key);
    if (along) return fw_scenario_find_parameter(scenario, along, &e->along, error);
    e->along = sweep->tolerance > 0 && e->has_level ? sweep->bisected : 0;
    if (sweep->parameter_count == 1 || (sweep->tolerance > 0 && e->has_level) || sweep->is_case)
        return FW_OK;
    return fw_scenario_fail(scenario, why->key_place, error,
                            "the expectation of '%s' has %s '%s', but study.sweep has %d "
                            "parameters: expected 'along' with one of them",
                            e->quantity.text, fw_expectation_is_trend(e) ? "a" : "the key",
                            why->key, sweep->parameter_count);
}

/* How it changes over a sweep, in place of a value. */
static fw_status read_trend(const fw_scenario *scenario, const fw_node *node, const fw_node *trend,
                            fw_expectation *e, fw_error *error)
{
    static const char *const others[] = {"value", "below", "above", "when", "crosses", NULL};
    for (int n = 0; others[n]; ++n) {
        const fw_node *other = fw_node_find(node, others[n]);
        if (other)
            return fw_scenario_fail(scenario, other->key_place, error,
                                    "the expectation of '%s' has both 'trend' and '%s', expected "
                                    "one of them",
                                    e->quantity.text, others[n]);
    }
    e->kind = (fw_verdict_kind)fw_node_word(trend, trend_words);
    return read_along(scenario, node, trend, e, error);
}

static fw_status read_verdict(const fw_scenario *scenario, const fw_node *node, fw_expectation *e,
                              fw_error *error)
{
    const fw_node *value = fw_node_find(node, "value");
    const fw_node *within = fw_node_find(node, "within");
    const fw_node *relative = fw_node_find(node, "within-relative");
    const fw_node *below = fw_node_find(node, "below"), *above = fw_node_find(node, "above");
    const fw_node *trend = fw_node_find(node, "trend");
    const char *quantity = e->quantity.text;
    if (trend) return read_trend(scenario, node, trend, e, error);
    const fw_node *crosses = fw_node_find(node, "crosses"), *along = fw_node_find(node, "along");
    e->has_level = crosses != NULL;
    if (along && !crosses)
        return fw_scenario_fail(scenario, along->key_place, error,
                                "the expectation of '%s' has 'along', but neither 'trend' nor "
                                "'crosses'",
                                quantity);
    if (crosses) FW_TRY(read_along(scenario, node, crosses, e, error));
    e->has_below = below != NULL;
    e->has_above = above != NULL;
    if (value && (below || above))
        return fw_scenario_fail(scenario, (below ? below : above)->key_place, error,
                                "the expectation of '%s' has both 'value' and '%s', expected a "
                                "value or bounds",
                                quantity, below ? "below" : "above");
    if (!value && !below && !above && !crosses)
        return fw_scenario_fail(scenario, node->place, error,
                                "the expectation of '%s' expects nothing: it needs 'value' with "
                                "'within', or 'below', or 'above', or 'trend'",
                                quantity);
    if (below && above && e->above >= e->below)
        return fw_scenario_fail(scenario, above->place, error,
                                "the expectation of '%s' is above %g and below %g, which no number "
                                "is",
                                quantity, e->above, e->below);
    e->kind = FW_VERDICT_BOUNDS;
    if (!value) return FW_OK;
    if (!within == !relative)
        return fw_scenario_fail(scenario, relative ? relative->key_place : value->key_place, error,
                                "the expectation of '%s' has %s, expected one of the two", quantity,
                                within ? "both 'within' and 'within-relative'"
                                       : "a 'value' without 'within' or 'within-relative'");
    if (relative && e->value == 0)
        return fw_scenario_fail(scenario, relative->key_place, error,
                                "the expectation of '%s' is 0 within a part of 0, expected "
                                "'within' instead of 'within-relative'",
                                quantity);
    e->kind = within ? FW_VERDICT_VALUE : FW_VERDICT_RELATIVE;
    e->within = fw_node_number(within ? within : relative);
    return FW_OK;
}

/* The cases that it speaks of: of a case that was made, others are not known. */
static fw_status read_when(const fw_scenario *scenario, const fw_node *node, fw_expectation *e,
                           fw_error *error)
{
    const size_t count = (size_t)scenario->study.sweep.parameter_count;
    double *point;
    FW_TRY(fw_scenario_allocate(scenario, count + 1, sizeof *point, &point, error));
    FW_TRY(fw_scenario_read_point(scenario, node, false, point, error));
    e->when = point;
    return scenario->study.sweep.is_case ? FW_OK
                                         : fw_scenario_check_point(scenario, node, point, error);
}

static fw_status read_expectation(fw_scenario *scenario, const fw_node *node, fw_expectation *e,
                                  fw_error *error)
{
    e->place = node->place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_expectation_section, node, e, error));
    e->has_at = fw_node_find(node, "at") != NULL;
    e->has_site = fw_node_find(node, "site") != NULL;
    const fw_node *when = fw_node_find(node, "when");
    if (when) FW_TRY(read_when(scenario, when, e, error));
    e->body_index = e->wall_index = e->grip_index = e->analysis_index = -1;
    int count;
    const fw_node *body = fw_node_find(node, "body"), *wall = fw_node_find(node, "wall");
    const fw_node *analysis = fw_node_find(node, "analysis");
    if (body)
        FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body",
                                body, &e->body_index, error));
    if (wall)
        FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "walls", &count), "wall", wall,
                                &e->wall_index, error));
    const fw_node *grip = fw_node_find(node, "grip");
    if (grip)
        FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "grips", &count), "grip", grip,
                                &e->grip_index, error));
    if (analysis)
        FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "analysis", &count),
                                "analysis", analysis, &e->analysis_index, error));
    if (e->has_site && !fw_scenario_has_site(&scenario->bodies[e->body_index], e->site))
        return fw_scenario_fail(scenario, fw_node_find(node, "site")->place, error,
                                "site [%d, %d] is not one of body '%s'", e->site.i, e->site.j,
                                e->body.text);
    FW_TRY(read_phase(scenario, node, e, error));
    FW_TRY(check_steps(scenario, node, e, error));
    return read_verdict(scenario, node, e, error);
}

/* What is bisected for, and nothing else, is what one expectation crosses. */
static fw_status check_bisection(const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    int count = 0;
    if (sweep->tolerance <= 0 || sweep->is_case) return FW_OK;
    const fw_scenario_parameter *parameter = &sweep->parameters[sweep->bisected];
    for (int n = 0; n < scenario->expectation_count; ++n) {
        const fw_expectation *e = &scenario->expectations[n];
        count += e->has_level;
        if (e->has_level && e->along != sweep->bisected)
            return fw_scenario_fail(scenario, e->place, error,
                                    "the expectation of '%s' crosses a level along %s, but %s is "
                                    "bisected: expected it along that",
                                    e->quantity.text, sweep->parameters[e->along].name,
                                    parameter->name);
    }
    if (count == 1) return FW_OK;
    return fw_scenario_fail(scenario, parameter->place, error,
                            "%s is bisected, and %d expectations cross a level, expected one with "
                            "'crosses'",
                            parameter->name, count);
}

fw_status fw_scenario_read_expectations(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "expect", &count);
    if (!part) return check_bisection(scenario, error);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->expectations,
                                &scenario->expectations, error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_expectation(scenario, node,
                                &scenario->expectations[scenario->expectation_count++], error));
    return check_bisection(scenario, error);
}
