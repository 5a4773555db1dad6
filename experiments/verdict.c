/* SPDX-License-Identifier: GPL-3.0-or-later */
/* verdict.c - statistics of a series, and the table of expectations. Keeps no state. */
#include "experiments/verdict.h"

#include "core/averages.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const take_names[] = {
    [FW_TAKE_LAST] = "at the end",
    [FW_TAKE_FIRST] = "at the start",
    [FW_TAKE_MAXIMUM] = "maximum",
    [FW_TAKE_MINIMUM] = "minimum",
    [FW_TAKE_LARGEST] = "largest",
    [FW_TAKE_MEAN] = "mean",
    [FW_TAKE_SPREAD] = "spread",
    [FW_TAKE_CHANGE] = "change",
    [FW_TAKE_RATE] = "rate",
    [FW_TAKE_TIME_OF_MAXIMUM] = "time of maximum",
    [FW_TAKE_TIME_OF_MINIMUM] = "time of minimum",
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
    return count > 1 ? sqrt(sum / (double)(count - 1)) : 0;
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

static double take(const series *s, fw_take what)
{
    switch (what) {
    case FW_TAKE_LAST:
        return at(s, s->last);
    case FW_TAKE_FIRST:
        return at(s, s->first);
    case FW_TAKE_MAXIMUM:
        return at(s, find_extreme(s, 1));
    case FW_TAKE_MINIMUM:
        return at(s, find_extreme(s, -1));
    case FW_TAKE_LARGEST:
        return largest_of(s);
    case FW_TAKE_MEAN:
        return mean_of(s);
    case FW_TAKE_SPREAD:
        return spread_of(s);
    case FW_TAKE_CHANGE:
        return at(s, s->last) - at(s, s->first);
    case FW_TAKE_RATE:
        return rate_of(s);
    case FW_TAKE_TIME_OF_MAXIMUM:
        return s->m->times[find_extreme(s, 1)];
    case FW_TAKE_TIME_OF_MINIMUM:
        return s->m->times[find_extreme(s, -1)];
    }
    return NAN;
}

static double measure(const fw_measurement *m, const fw_expectation *e, int column)
{
    series s = {m, column, -1, -1};
    int64_t from = e->has_at ? e->at : e->from, until = e->has_at ? e->at : e->until;
    for (int64_t row = 0; row < m->count; ++row) {
        if (m->steps[row] < from || m->steps[row] > until) continue;
        if (s.first < 0) s.first = row;
        s.last = row;
    }
    if (s.first < 0) return NAN;
    return take(&s, e->has_at ? FW_TAKE_LAST : e->take);
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
        snprintf(end, room, "%s", take_names[e->take]);
}

static void judge(fw_verdict *verdict)
{
    const fw_expectation *e = verdict->expectation;
    double x = verdict->measured;
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
        if (e->has_below && e->has_above)
            snprintf(verdict->expected, sizeof verdict->expected, "%.6g to %.6g", e->above,
                     e->below);
        else
            snprintf(verdict->expected, sizeof verdict->expected, "%s %.6g",
                     e->has_below ? "<" : ">", e->has_below ? e->below : e->above);
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
        verdict.measured = measurement->outcome[measure];
        verdict.error = measurement->outcome_error[measure];
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
static double error_in_time(const fw_measurement *m, const fw_expectation *e, int number)
{
    const int column = m->probes[m->expected[number]].first + m->component[number];
    fw_average average = {.error = NAN};
    size_t count = 0;
    if (e->has_at || e->take != FW_TAKE_MEAN) return NAN;
    double *values = fw_array_of_doubles((size_t)m->count);
    for (int64_t row = 0; values && row < m->count; ++row)
        if (m->steps[row] >= e->from && m->steps[row] <= e->until)
            values[count++] = m->values[row * m->width + column];
    if (count < 2 || fw_average_of_series(&average, values, count, NULL) != FW_OK)
        average.error = NAN;
    free(values);
    return average.error;
}

double fw_verdict_of_seed(const fw_scenario *scenario, const fw_measurement *measurement,
                          int number, int seed)
{
    const fw_measurement *of = measurement->seeds ? measurement->seeds[seed] : measurement;
    return value_in(of, &scenario->expectations[number], number);
}

/* Mean over the seeds, and the error that follows from their spread. */
static void average_seeds(fw_verdict *verdict, const fw_measurement *measurement, int number)
{
    const int count = measurement->seed_count;
    double sum = 0, squares = 0;
    for (int n = 0; n < count; ++n)
        sum += value_in(measurement->seeds[n], verdict->expectation, number);
    verdict->measured = sum / count;
    for (int n = 0; n < count; ++n) {
        const double off =
            value_in(measurement->seeds[n], verdict->expectation, number) - verdict->measured;
        squares += off * off;
    }
    verdict->error = sqrt(squares / ((double)count * (count - 1)));
    verdict->seeds = count;
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
        length = snprintf(end, room, "%#.*g +- %.2g", digits, verdict->measured, verdict->error);
    } else {
        length = snprintf(end, room, "%.10g", verdict->measured);
    }
    if (verdict->seeds > 1)
        snprintf(end + length, room - (size_t)length, " (%d seeds)", verdict->seeds);
}

fw_verdict fw_verdict_of(const fw_scenario *scenario, const fw_measurement *measurement, int number)
{
    const fw_expectation *e = &scenario->expectations[number];
    fw_verdict verdict = {.expectation = e, .error = NAN, .seeds = 1};
    if (measurement->expected[number] < 0) {
        verdict = verdict_of_outcome(e, measurement, number);
        verdict.seeds = (int)scenario->study.seeds;
    } else {
        const fw_probe *probe = &measurement->probes[measurement->expected[number]];
        if (measurement->seeds) {
            average_seeds(&verdict, measurement, number);
        } else {
            verdict.measured = value_in(measurement, e, number);
            verdict.error = error_in_time(measurement, e, number);
        }
        name_quantity(&verdict, probe, measurement->component[number]);
    }
    judge(&verdict);
    write_found(&verdict);
    return verdict;
}

static int longer(int width, const char *text)
{
    int length = (int)strlen(text);
    return length > width ? length : width;
}

int fw_verdict_print(FILE *out, const fw_scenario *scenario, const fw_measurement *measurement)
{
    int failures = 0, quantity_width = 8, expected_width = 8, found_width = 16;
    if (scenario->expectation_count == 0) return 0;
    for (int n = 0; n < scenario->expectation_count; ++n) {
        fw_verdict verdict = fw_verdict_of(scenario, measurement, n);
        quantity_width = longer(quantity_width, verdict.quantity);
        expected_width = longer(expected_width, verdict.expected);
        found_width = longer(found_width, verdict.found);
    }
    fprintf(out, "%-*s  %-*s  %-*s  %-7s  %s\n", quantity_width, "quantity", expected_width,
            "expected", found_width, "measured", "verdict", "source");
    for (int n = 0; n < scenario->expectation_count; ++n) {
        fw_verdict verdict = fw_verdict_of(scenario, measurement, n);
        const char *source = verdict.expectation->source;
        fprintf(out, "%-*s  %-*s  %-*s  %-7s  %s\n", quantity_width, verdict.quantity,
                expected_width, verdict.expected, found_width, verdict.found,
                verdict.holds ? "holds" : "FAILS", source ? source : "");
        if (verdict.expectation->note)
            fprintf(out, "%-*s  %s\n", quantity_width, "", verdict.expectation->note);
        failures += !verdict.holds;
    }
    return failures;
}
