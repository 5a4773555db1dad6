/* SPDX-License-Identifier: GPL-3.0-or-later */
/* verdict.c - statistics of a series, held against what is expected. Keeps no state. Start
 * reading at fw_verdict_of(). */
#include "experiments/measures/verdict.h"

#include "core/averages.h"
#include "experiments/measures/layer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const statistic_names[] = {
    [FW_STATISTIC_LAST] = "at the end",
    [FW_STATISTIC_FIRST] = "at the start",
    [FW_STATISTIC_MAXIMUM] = "maximum",
    [FW_STATISTIC_MINIMUM] = "minimum",
    [FW_STATISTIC_LARGEST] = "largest",
    [FW_STATISTIC_MEAN] = "mean",
    [FW_STATISTIC_SPREAD] = "spread",
    [FW_STATISTIC_CHANGE] = "change",
    [FW_STATISTIC_RATE] = "rate",
    [FW_STATISTIC_TIME_OF_MAXIMUM] = "time of maximum",
    [FW_STATISTIC_TIME_OF_MINIMUM] = "time of minimum",
};

/* One component over the rows first .. last, which exist. */
typedef struct series {
    const fw_measurement *m;
    int column;
    int64_t first, last;
} series;

static double at(const series *s, int64_t row)
{
    return s->m->values[row * s->m->width + s->column];
}

/* Row of the extreme value: sign 1 for the maximum, -1 for the minimum. The first of equal ones.
 * A value that is not finite is taken at once, so that it cannot hide. */
static int64_t find_extreme(const series *s, double sign)
{
    int64_t best = s->first;
    for (int64_t row = s->first; row <= s->last; ++row) {
        if (!isfinite(at(s, row))) return row;
        if (sign * at(s, row) > sign * at(s, best)) best = row;
    }
    return best;
}

static double mean_of(const series *s)
{
    double sum = 0;
    for (int64_t row = s->first; row <= s->last; ++row) sum += at(s, row);
    return sum / (double)(s->last - s->first + 1);
}

static double spread_of(const series *s)
{
    double mean = mean_of(s), sum = 0;
    for (int64_t row = s->first; row <= s->last; ++row)
        sum += (at(s, row) - mean) * (at(s, row) - mean);
    int64_t count = s->last - s->first + 1;
    return sqrt(sum / (double)(count - 1));
}

/* Least-squares slope against time. */
static double rate_of(const series *s)
{
    double mean_time = 0, mean = mean_of(s), above = 0, below = 0;
    for (int64_t row = s->first; row <= s->last; ++row) mean_time += s->m->times[row];
    mean_time /= (double)(s->last - s->first + 1);
    for (int64_t row = s->first; row <= s->last; ++row) {
        double t = s->m->times[row] - mean_time;
        above += t * (at(s, row) - mean);
        below += t * t;
    }
    return above / below;
}

static double largest_of(const series *s)
{
    double largest = 0;
    for (int64_t row = s->first; row <= s->last; ++row) {
        if (!isfinite(at(s, row))) return at(s, row);
        largest = fmax(largest, fabs(at(s, row)));
    }
    return largest;
}

static double compute(const series *s, fw_statistic what)
{
    switch (what) {
    case FW_STATISTIC_LAST:
        return at(s, s->last);
    case FW_STATISTIC_FIRST:
        return at(s, s->first);
    case FW_STATISTIC_MAXIMUM:
        return at(s, find_extreme(s, 1));
    case FW_STATISTIC_MINIMUM:
        return at(s, find_extreme(s, -1));
    case FW_STATISTIC_LARGEST:
        return largest_of(s);
    case FW_STATISTIC_MEAN:
        return mean_of(s);
    case FW_STATISTIC_SPREAD:
        return spread_of(s);
    case FW_STATISTIC_CHANGE:
        return at(s, s->last) - at(s, s->first);
    case FW_STATISTIC_RATE:
        return rate_of(s);
    case FW_STATISTIC_TIME_OF_MAXIMUM:
        return s->m->times[find_extreme(s, 1)];
    case FW_STATISTIC_TIME_OF_MINIMUM:
        return s->m->times[find_extreme(s, -1)];
    }
    return NAN;
}

/* These say nothing of a single sample. */
static bool needs_two(fw_statistic what)
{
    return what == FW_STATISTIC_SPREAD || what == FW_STATISTIC_CHANGE || what == FW_STATISTIC_RATE;
}

/* The samples that an expectation speaks of; first < 0: there are none. */
static series series_of(const fw_measurement *m, const fw_expectation *e, int column)
{
    series s = {m, column, -1, -1};
    int64_t from = e->has_at ? e->at : e->from, until = e->has_at ? e->at : e->until;
    for (int64_t row = 0; row < m->count; ++row) {
        if (m->steps[row] < from || m->steps[row] > until) continue;
        if (s.first < 0) s.first = row;
        s.last = row;
    }
    return s;
}

static double measure(const fw_measurement *m, const fw_expectation *e, int column)
{
    const series s = series_of(m, e, column);
    const fw_statistic what = e->has_at ? FW_STATISTIC_LAST : e->statistic;
    if (s.first < 0 || (s.first == s.last && needs_two(what))) return NAN;
    return compute(&s, what);
}

/* Why an expectation's number is none. */
static const char *reason_of(const fw_measurement *m, const fw_expectation *e,
                             const fw_probe *probe, int column)
{
    const series s = series_of(m, e, column);
    if (s.first < 0) return "nothing is measured in these steps";
    if (s.first == s.last && !e->has_at && needs_two(e->statistic))
        return "one sample, where two are needed";
    if (!isfinite(measure(m, e, column)) && probe->quantity->absent) return probe->quantity->absent;
    return "a value is not finite";
}

static void name_quantity(fw_verdict *verdict, const fw_probe *probe, int component)
{
    const fw_expectation *e = verdict->expectation;
    char part[8];
    fw_quantity_component_name(probe->quantity, component, part);
    int length = snprintf(verdict->quantity, sizeof verdict->quantity, "%s%s%s, ", probe->label,
                          part[0] ? " " : "", part);
    char *end = verdict->quantity + length;
    size_t room = sizeof verdict->quantity - (size_t)length;
    if (e->has_at)
        snprintf(end, room, "step %lld", (long long)e->at);
    else
        snprintf(end, room, "%s", statistic_names[e->statistic]);
}

static void judge(fw_verdict *verdict)
{
    const fw_expectation *e = verdict->expectation;
    double x = verdict->measured;
    const double unsure = isfinite(verdict->error) ? verdict->error : 0;
    switch (e->kind) {
    case FW_VERDICT_VALUE:
        verdict->holds = fabs(x - e->value) <= e->within;
        snprintf(verdict->expected, sizeof verdict->expected, "%.10g +- %.2g", e->value, e->within);
        break;
    case FW_VERDICT_RELATIVE:
        verdict->holds = fabs(x - e->value) <= e->within * fabs(e->value);
        snprintf(verdict->expected, sizeof verdict->expected, "%.10g +- %.2g %%", e->value,
                 100 * e->within);
        break;
    case FW_VERDICT_BOUNDS:
        verdict->holds =
            isfinite(x) && (!e->has_below || x < e->below) && (!e->has_above || x > e->above);
        if (!e->has_below && !e->has_above)
            snprintf(verdict->expected, sizeof verdict->expected, "crosses %.6g", e->level);
        else if (e->has_below && e->has_above)
            snprintf(verdict->expected, sizeof verdict->expected, "%.6g to %.6g", e->above,
                     e->below);
        else
            snprintf(verdict->expected, sizeof verdict->expected, "%s %.6g",
                     e->has_below ? "<" : ">", e->has_below ? e->below : e->above);
        break;
    case FW_VERDICT_RISES:
        verdict->holds = isfinite(x) && x > unsure;
        snprintf(verdict->expected, sizeof verdict->expected, "rises");
        break;
    case FW_VERDICT_FALLS:
        verdict->holds = isfinite(x) && x < -unsure;
        snprintf(verdict->expected, sizeof verdict->expected, "falls");
        break;
    }
}

/* A number that comes out of all runs of a study, with its error. */
static fw_verdict verdict_of_outcome(const fw_expectation *e, const fw_measurement *measurement,
                                     int number)
{
    const int measure = measurement->component[number];
    fw_verdict verdict = {.expectation = e, .measured = NAN, .error = NAN};
    if (measurement->outcome) {
        verdict.measured = measurement->outcome[measure].mean;
        verdict.error = measurement->outcome[measure].error;
    }
    snprintf(verdict.quantity, sizeof verdict.quantity, "%s", e->quantity.text);
    return verdict;
}

/* The number that one run shows. */
static double value_in(const fw_measurement *measurement, const fw_expectation *e, int number)
{
    const fw_probe *probe = &measurement->probes[measurement->expected[number]];
    return measure(measurement, e, probe->first + measurement->component[number]);
}

/* Of a mean over time: from the blocks of its series. NaN of anything else, or without memory. */
static double error_in_time(const fw_measurement *m, const fw_expectation *e, int number,
                            bool *at_least)
{
    const int column = m->probes[m->expected[number]].first + m->component[number];
    fw_average average = {.error = NAN};
    *at_least = false;
    size_t count = 0;
    if (e->has_at || e->statistic != FW_STATISTIC_MEAN) return NAN;
    double *values = fw_array_of_doubles((size_t)m->count);
    for (int64_t row = 0; values && row < m->count; ++row)
        if (m->steps[row] >= e->from && m->steps[row] <= e->until)
            values[count++] = m->values[row * m->width + column];
    if (count < 2 || fw_average_of_series(&average, values, count, NULL) != FW_OK)
        average.error = NAN;
    free(values);
    /* That a constant is known but to rounding says nothing. */
    *at_least = average.error > FW_MEASURED * fabs(average.mean) && !average.converged;
    return average.error;
}

double fw_verdict_of_seed(const fw_scenario *scenario, const fw_measurement *measurement,
                          int number, int seed)
{
    const fw_measurement *of = measurement->seeds ? measurement->seeds[seed] : measurement;
    if (measurement->expected[number] < 0)
        return measurement
            ->outcome_of_seeds[seed * FW_LAYER_MEASURES + measurement->component[number]];
    return value_in(of, &scenario->expectations[number], number);
}

/* Mean over the seeds, and the error that follows from their spread. No number in one seed is no
 * number of the study: it cannot hide among the others. */
static void average_seeds(fw_verdict *verdict, const fw_measurement *measurement, int number)
{
    const size_t count = (size_t)measurement->seed_count;
    double values[FW_SEEDS_MAX];
    for (size_t n = 0; n < count; ++n)
        values[n] = value_in(measurement->seeds[n], verdict->expectation, number);
    const fw_average average = fw_average_of_known(values, count);
    verdict->measured = average.count == count ? average.mean : NAN;
    verdict->error = average.count == count ? average.error : NAN;
    verdict->seeds = verdict->seeds_asked = measurement->seed_count;
}

/* The first run that shows no number, to tell why; of a single run that one. */
static const fw_measurement *without_number(const fw_measurement *measurement,
                                            const fw_expectation *e, int number)
{
    for (int n = 0; measurement->seeds && n < measurement->seed_count; ++n)
        if (!isfinite(value_in(measurement->seeds[n], e, number))) return measurement->seeds[n];
    return measurement;
}

/* With as many digits as the first two of its error, where that is known. */
static void write_found(fw_verdict *verdict)
{
    char *end = verdict->found;
    size_t room = sizeof verdict->found;
    int length;
    if (verdict->error > 0 && isfinite(verdict->error)) {
        const double size = fmax(fabs(verdict->measured), verdict->error);
        int digits = 2 + (int)(floor(log10(size)) - floor(log10(verdict->error)));
        digits = digits > 12 ? 12 : digits;
        length = snprintf(end, room, "%#.*g +- %s%.2g", digits, verdict->measured,
                          verdict->at_least ? ">= " : "", verdict->error);
    } else if (!isfinite(verdict->measured)) {
        length =
            snprintf(end, room, "no number%s%.150s", verdict->why[0] ? ": " : "", verdict->why);
    } else {
        length = snprintf(end, room, "%.10g", verdict->measured);
    }
    if (verdict->seeds < verdict->seeds_asked)
        snprintf(end + length, room - (size_t)length, " (%d of %d seeds)", verdict->seeds,
                 verdict->seeds_asked);
    else if (verdict->seeds > 1)
        snprintf(end + length, room - (size_t)length, " (%d seeds)", verdict->seeds);
}

/* A measure of the layer is averaged over the seeds that have it. */
static void count_seeds(fw_verdict *verdict, const fw_scenario *scenario,
                        const fw_measurement *measurement, int number)
{
    const char *absent = fw_layer_quantities[measurement->component[number]].absent;
    if (!isfinite(verdict->measured))
        snprintf(verdict->why, sizeof verdict->why, "%s", absent ? absent : "no seed shows it");
    verdict->seeds = verdict->seeds_asked = (int)scenario->study.seeds;
    if (!measurement->outcome_of_seeds) return;
    verdict->seeds = 0;
    for (int n = 0; n < verdict->seeds_asked; ++n)
        verdict->seeds += isfinite(fw_verdict_of_seed(scenario, measurement, number, n));
}

fw_verdict fw_verdict_of(const fw_scenario *scenario, const fw_measurement *measurement, int number)
{
    const fw_expectation *e = &scenario->expectations[number];
    fw_verdict verdict = {.expectation = e, .error = NAN, .seeds = 1};
    if (measurement->expected[number] < 0) {
        verdict = verdict_of_outcome(e, measurement, number);
        count_seeds(&verdict, scenario, measurement, number);
    } else {
        const fw_probe *probe = &measurement->probes[measurement->expected[number]];
        if (measurement->seeds) {
            average_seeds(&verdict, measurement, number);
        } else {
            verdict.measured = value_in(measurement, e, number);
            verdict.error = error_in_time(measurement, e, number, &verdict.at_least);
        }
        if (!isfinite(verdict.measured))
            snprintf(verdict.why, sizeof verdict.why, "%s",
                     reason_of(without_number(measurement, e, number), e, probe,
                               probe->first + measurement->component[number]));
        name_quantity(&verdict, probe, measurement->component[number]);
    }
    verdict.asked = fw_verdict_is_asked(scenario, e);
    fw_verdict_judge(&verdict);
    return verdict;
}

void fw_verdict_judge(fw_verdict *verdict)
{
    judge(verdict);
    write_found(verdict);
}

const char *fw_verdict_word(const fw_verdict *verdict)
{
    if (verdict->holds) return "holds";
    return isfinite(verdict->measured) ? "FAILS" : "not measured";
}

bool fw_verdict_is_asked(const fw_scenario *scenario, const fw_expectation *expectation)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    if (fw_expectation_is_of_sweep(expectation)) return false;
    return !expectation->when || (sweep->is_case && fw_sweep_is_at(sweep, 0, expectation->when));
}
