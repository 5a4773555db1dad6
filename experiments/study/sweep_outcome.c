/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_outcome.c - the cases side by side: their numbers as a table, and how they change.
 * Keeps no state. Start reading at fw_sweep_outcome_table(). */
#include "sweep_outcome.h"

#include "sweep_threshold.h"

#include <math.h>
#include <stdlib.h>

/* --- the table --- */

/* Over which steps, where that is not the whole run: else two numbers could have one name. */
void fw_sweep_outcome_name(const fw_verdict *verdict, char name[FW_SWEEP_NAME])
{
    const size_t size = FW_SWEEP_NAME;
    const fw_expectation *e = verdict->expectation;
    if (e->has_at || (e->from == 0 && e->until == INT64_MAX))
        snprintf(name, size, "%s", verdict->quantity);
    else if (e->phase.text)
        snprintf(name, size, "%s in %.*s", verdict->quantity, FW_NAME_BYTES, e->phase.text);
    else if (e->until == INT64_MAX)
        snprintf(name, size, "%s from %lld", verdict->quantity, (long long)e->from);
    else
        snprintf(name, size, "%s from %lld to %lld", verdict->quantity, (long long)e->from,
                 (long long)e->until);
}

/* Of what is measured, not of the quantity that it is measured of. */
static void name_unit(const fw_expectation *e, char unit[64])
{
    const fw_quantity *quantity = fw_quantity_find(e->quantity.text);
    const bool in_time = !e->has_at;
    snprintf(unit, 64, "%s", quantity ? quantity->unit : "");
    if (in_time && e->statistic == FW_STATISTIC_RATE)
        snprintf(unit, 64, "%.50s/time", quantity ? quantity->unit : "1");
    if (in_time && (e->statistic == FW_STATISTIC_TIME_OF_MAXIMUM ||
                    e->statistic == FW_STATISTIC_TIME_OF_MINIMUM))
        snprintf(unit, 64, "time");
}

static bool add_verdict(fw_sweep_table *table, int row, const fw_verdict *verdict)
{
    const fw_expectation *e = verdict->expectation;
    char name[FW_SWEEP_NAME], unit[64];
    fw_sweep_outcome_name(verdict, name);
    name_unit(e, unit);
    fw_sweep_column *column = fw_sweep_table_column(table, name, unit);
    if (!column) return false;
    column->mean[row] = verdict->measured;
    column->error[row] = verdict->error;
    column->at_least[row] = verdict->at_least;
    const bool valued = e->kind == FW_VERDICT_VALUE || e->kind == FW_VERDICT_RELATIVE;
    if (!verdict->asked || !valued || !isnan(column->expected[row])) return true;
    column->expected[row] = e->value;
    column->within[row] = e->kind == FW_VERDICT_VALUE ? e->within : e->within * fabs(e->value);
    return true;
}

static bool add_case(fw_sweep_table *table, int row, const fw_sweep_case *c)
{
    if (c->failure.status != FW_OK) return fw_sweep_table_fail(table, row, c->failure.sentence);
    for (int m = 0; m < FW_LAYER_MEASURES && c->scenario->profile.every != 0; ++m) {
        const fw_quantity *quantity = &fw_layer_quantities[m];
        fw_sweep_column *column = fw_sweep_table_column(table, quantity->name, quantity->unit);
        if (!column) return false;
        column->mean[row] = c->layer[m].mean;
        column->error[row] = c->layer[m].error;
    }
    for (int n = 0; n < c->verdicts.count; ++n)
        if (!add_verdict(table, row, &c->verdicts.item[n])) return false;
    return true;
}

fw_status fw_sweep_outcome_table(fw_sweep_table *table, const fw_scenario *sweep,
                                 const fw_sweep_case *cases, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    FW_TRY(fw_sweep_table_create(table, plan, (int)sweep->study.seeds, error));
    table->units = &sweep->units;
    for (int n = 0; n < plan->case_count; ++n)
        if (!add_case(table, n, &cases[n])) return fw_fail_memory(error, "the table of a sweep");
    return FW_OK;
}

/* --- verdicts --- */

/* The case with the next larger value of the parameter, and the same ones of all others, that has
 * not failed; or -1. */
static int case_after(const fw_scenario_sweep *plan, const fw_sweep_case *cases, int number,
                      int along)
{
    const double value = fw_sweep_value(plan, number, along);
    double point[FW_PARAMETERS_MAX];
    int next = -1;
    for (int p = 0; p < plan->parameter_count; ++p)
        point[p] = p == along ? NAN : fw_sweep_value(plan, number, p);
    for (int n = 0; n < plan->case_count; ++n) {
        if (cases[n].failure.status != FW_OK || !fw_sweep_is_at(plan, n, point)) continue;
        const double other = fw_sweep_value(plan, n, along);
        if (other > value && (next < 0 || other < fw_sweep_value(plan, next, along))) next = n;
    }
    return next;
}

/* Of the changes from each value to the next, the one that speaks most against the trend: a change
 * counts less the less it is known. */
static fw_verdict judge_trend(const fw_scenario *sweep, const fw_sweep_case *cases, int number)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    const fw_expectation *e = &sweep->expectations[number];
    const double sign = e->kind == FW_VERDICT_RISES ? 1 : -1;
    fw_verdict verdict = {.expectation = e,
                          .asked = true,
                          .seeds = (int)sweep->study.seeds,
                          .measured = NAN,
                          .error = NAN};
    double worst = INFINITY;
    bool has_error = false;
    snprintf(verdict.quantity, sizeof verdict.quantity, "%s", e->quantity.text);
    for (int n = 0; n < plan->case_count; ++n) {
        const int next = case_after(plan, cases, n, e->along);
        if (next < 0 || cases[n].failure.status != FW_OK) continue;
        const fw_verdict *low = &cases[n].verdicts.item[number];
        const fw_verdict *high = &cases[next].verdicts.item[number];
        const double change = high->measured - low->measured;
        const double scatter = hypot(low->error, high->error);
        /* What may be rounding is no trend, however many seeds agree on it. */
        const double rounding = 1e-9 * (fabs(low->measured) + fabs(high->measured));
        const double unsure = isfinite(scatter) ? fmax(scatter, rounding) : rounding;
        const double margin = isfinite(change) ? sign * change - unsure : -INFINITY;
        if (margin >= worst) continue; /* what is not finite is taken: it cannot hide */
        worst = margin;
        verdict.measured = change;
        verdict.error = unsure;
        has_error = isfinite(scatter);
        verdict.at_least = low->at_least || high->at_least;
        verdict.in = cases[next].name;
        snprintf(verdict.quantity, sizeof verdict.quantity, "%.100s, least %s (from %.100s)",
                 low->quantity, sign > 0 ? "rise" : "fall", cases[n].name);
    }
    fw_verdict_judge(&verdict);
    if (!has_error && isfinite(verdict.measured)) {
        /* Rounding is no error of the number: one seed has none. */
        verdict.error = NAN;
        snprintf(verdict.found, sizeof verdict.found, "%.10g", verdict.measured);
    }
    return verdict;
}

/* Where the mean crosses its level, on every line of which it is expected. */
static fw_status judge_crossings(fw_verdicts *verdicts, const fw_scenario *sweep,
                                 const fw_sweep_case *cases, int number, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    const fw_expectation *e = &sweep->expectations[number];
    for (int n = 0; n < plan->case_count; ++n) {
        fw_threshold t;
        if (!fw_sweep_is_head(plan, n, e->along)) continue;
        if (e->when && !fw_sweep_is_at(plan, n, e->when)) continue;
        FW_TRY(fw_sweep_threshold_find(&t, sweep, cases, n, number, error));
        fw_verdict *verdict = &verdicts->item[verdicts->count++];
        *verdict = (fw_verdict){
            .expectation = e, .asked = true, .seeds = t.seeds, .measured = t.at, .error = t.error};
        const bool failed = cases[n].failure.status != FW_OK;
        snprintf(verdict->quantity, sizeof verdict->quantity, "%s where %.80s crosses %.6g%s%.60s",
                 plan->parameters[e->along].name,
                 failed ? e->quantity.text : cases[n].verdicts.item[number].quantity, e->level,
                 t.line[0] ? ", " : "", t.line);
        snprintf(verdict->why, sizeof verdict->why, "%s", t.why);
        fw_verdict_judge(verdict);
    }
    return FW_OK;
}

fw_status fw_sweep_outcome_verdicts(fw_verdicts *verdicts, const fw_scenario *sweep,
                                    const fw_sweep_case *cases, fw_error *error)
{
    const int case_count = sweep->study.sweep.case_count;
    const size_t most = (size_t)sweep->expectation_count * (size_t)(case_count + 1);
    *verdicts = (fw_verdicts){.item = calloc(most + 1, sizeof *verdicts->item)};
    if (!verdicts->item) return fw_fail_memory(error, "the verdicts of a sweep");
    for (int n = 0; n < case_count; ++n)
        for (int k = 0; k < cases[n].verdicts.count; ++k) {
            fw_verdict *next = &verdicts->item[verdicts->count];
            if (!cases[n].verdicts.item[k].asked) continue;
            *next = cases[n].verdicts.item[k];
            next->in = cases[n].name;
            verdicts->count += 1;
        }
    for (int k = 0; k < sweep->expectation_count; ++k)
        if (fw_expectation_is_trend(&sweep->expectations[k]))
            verdicts->item[verdicts->count++] = judge_trend(sweep, cases, k);
    for (int k = 0; k < sweep->expectation_count; ++k)
        if (sweep->expectations[k].has_level)
            FW_TRY(judge_crossings(verdicts, sweep, cases, k, error));
    return FW_OK;
}
