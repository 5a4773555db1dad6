/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_threshold.c - the crossing of a level along a line of cases, and bisection. Keeps no state.
 * Start reading at fw_sweep_threshold_find(). */
#include "sweep_threshold.h"

#include "experiments/storage/csv.h"
#include "experiments/study/sweep_extend.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A case on a line, and on which side of the level it surely is: -1, 1; 0: unsure. */
typedef struct place {
    double at;
    int side, number;
} place;

static bool same_line(const fw_scenario_sweep *plan, int number, int other, int along)
{
    for (int p = 0; p < plan->parameter_count; ++p)
        if (p != along && fw_sweep_value(plan, number, p) != fw_sweep_value(plan, other, p))
            return false;
    return true;
}

bool fw_sweep_is_head(const fw_scenario_sweep *plan, int number, int along)
{
    for (int n = 0; n < number; ++n)
        if (same_line(plan, number, n, along)) return false;
    return true;
}

static int side_of(const fw_verdict *verdict, double level)
{
    const double error = isfinite(verdict->error) ? verdict->error : 0;
    const double off = verdict->measured - level;
    return off > error ? 1 : off < -error ? -1 : 0;
}

/* The cases of the line by their values; -1: one of them has no number. */
static int collect(const fw_scenario_sweep *plan, const fw_sweep_case *cases, int head, int along,
                   int expectation, double level, place *line, int *without)
{
    int count = 0;
    for (int n = 0; n < plan->case_count; ++n) {
        if (!same_line(plan, head, n, along)) continue;
        const fw_sweep_case *c = &cases[n];
        if (c->failure.status != FW_OK || !isfinite(c->verdicts.item[expectation].measured)) {
            *without = n;
            return -1;
        }
        const place found = {fw_sweep_value(plan, n, along),
                             side_of(&c->verdicts.item[expectation], level), n};
        int at = count++;
        for (; at > 0 && line[at - 1].at > found.at; --at) line[at] = line[at - 1];
        line[at] = found;
    }
    return count;
}

/* The middle of two values, as somebody would write it. */
static double middle_of(const fw_scenario_sweep *plan, double low, double high)
{
    char text[FW_NUMBER_TEXT];
    const double middle = plan->logarithmic ? copysign(sqrt(low * high), low) : (low + high) / 2;
    snprintf(text, sizeof text, "%.10g", middle);
    return fw_number_scan(text, NULL);
}

/* The middle is wanted next, where it would say more. */
static void add_middle(fw_threshold *t, const fw_scenario_sweep *plan, double low, double high)
{
    const double middle = middle_of(plan, low, high);
    if (high - low > plan->tolerance && middle > low && middle < high)
        t->next[t->next_count++] = middle;
}

static void find_crossing(fw_threshold *t, const fw_scenario_sweep *plan, const place *line,
                          int count)
{
    const int first = line[0].side, last = line[count - 1].side;
    if (first * last >= 0) {
        snprintf(t->why, sizeof t->why, "%s",
                 first == 0 || last == 0 ? "at an end it is the level within its error"
                 : first > 0             ? "it is above the level at both ends"
                                         : "it is below the level at both ends");
        return;
    }
    int low = 0, high = count - 1;
    while (line[low + 1].side == first) ++low;
    while (line[high - 1].side == last) --high;
    t->at = (line[low].at + line[high].at) / 2;
    t->error = (line[high].at - line[low].at) / 2;
    if (plan->tolerance <= 0) return;
    add_middle(t, plan, line[low].at, line[low + 1].at);
    /* What lies in between is unsure: where that begins, and where it ends. */
    if (high > low + 1) add_middle(t, plan, line[high - 1].at, line[high].at);
}

static void name_line(const fw_scenario_sweep *plan, int number, int along, char *name)
{
    name[0] = '\0';
    for (int p = 0; p < plan->parameter_count; ++p) {
        char value[FW_NUMBER_TEXT];
        if (p == along) continue;
        fw_number_write(value, fw_sweep_value(plan, number, p));
        fw_text_append(name, FW_CASE_NAME, "%s%s=%s", name[0] ? "," : "", plan->parameters[p].name,
                       value);
    }
}

fw_status fw_sweep_threshold_find(fw_threshold *threshold, const fw_scenario *sweep,
                                  const fw_sweep_case *cases, int head, int expectation,
                                  fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    const fw_expectation *e = &sweep->expectations[expectation];
    int without = 0;
    *threshold = (fw_threshold){.at = NAN, .error = NAN, .seeds = (int)sweep->study.seeds};
    name_line(plan, head, e->along, threshold->line);
    place *line = calloc((size_t)plan->case_count + 1, sizeof *line);
    if (!line) return fw_fail_memory(error, "a threshold");
    const int count = collect(plan, cases, head, e->along, expectation, e->level, line, &without);
    if (count < 0)
        snprintf(threshold->why, sizeof threshold->why, "%.100s has no number",
                 cases[without].name);
    else if (count < 2)
        snprintf(threshold->why, sizeof threshold->why, "there is only one case");
    else
        find_crossing(threshold, plan, line, count);
    free(line);
    return FW_OK;
}

/* --- their table --- */

typedef struct threshold_table {
    const fw_scenario *sweep;
    const fw_sweep_case *cases;
    int count;
    struct {
        fw_threshold threshold;
        int head, expectation;
    } * row;
} threshold_table;

static void write_rows(FILE *out, const void *object)
{
    const threshold_table *table = object;
    const fw_scenario_sweep *plan = &table->sweep->study.sweep;
    fputs("quantity,crosses", out);
    for (int p = 0; p < plan->parameter_count; ++p) fprintf(out, ",%s", plan->parameters[p].name);
    fputs(",error,seeds,no number since\n", out);
    for (int n = 0; n < table->count; ++n) {
        const int head = table->row[n].head, number = table->row[n].expectation;
        const fw_expectation *e = &table->sweep->expectations[number];
        const fw_threshold *t = &table->row[n].threshold;
        const bool failed = table->cases[head].failure.status != FW_OK;
        fw_csv_write_text(out, failed ? e->quantity.text
                                      : table->cases[head].verdicts.item[number].quantity);
        fputc(',', out);
        fw_csv_write_number(out, e->level);
        for (int p = 0; p < plan->parameter_count; ++p) {
            fputc(',', out);
            fw_csv_write_number(out, p == e->along ? t->at : fw_sweep_value(plan, head, p));
        }
        fputc(',', out);
        fw_csv_write_number(out, t->error);
        fprintf(out, ",%d,", t->seeds);
        fw_csv_write_text(out, t->why);
        fputc('\n', out);
    }
}

static fw_status fill_rows(threshold_table *table, fw_error *error)
{
    const fw_scenario *sweep = table->sweep;
    for (int k = 0; k < sweep->expectation_count; ++k)
        for (int n = 0; sweep->expectations[k].has_level && n < sweep->study.sweep.case_count;
             ++n) {
            if (!fw_sweep_is_head(&sweep->study.sweep, n, sweep->expectations[k].along)) continue;
            FW_TRY(fw_sweep_threshold_find(&table->row[table->count].threshold, sweep, table->cases,
                                           n, k, error));
            table->row[table->count].head = n;
            table->row[table->count++].expectation = k;
        }
    return FW_OK;
}

fw_status fw_sweep_thresholds_write(const char *directory, const fw_scenario *sweep,
                                    const fw_sweep_case *cases, fw_error *error)
{
    threshold_table table = {.sweep = sweep, .cases = cases};
    size_t crossings = 0;
    for (int k = 0; k < sweep->expectation_count; ++k)
        crossings += sweep->expectations[k].has_level;
    if (crossings == 0) return FW_OK;
    table.row = calloc(crossings * (size_t)sweep->study.sweep.case_count, sizeof *table.row);
    if (!table.row) return fw_fail_memory(error, "the thresholds of a sweep");
    fw_status status = fill_rows(&table, error);
    if (status == FW_OK)
        status = fw_csv_keep(directory, FW_THRESHOLDS_FILE, write_rows, &table, error);
    free(table.row);
    return status;
}

/* --- bisection --- */

static int find_crossing_expectation(const fw_scenario *sweep)
{
    int number = 0;
    while (!sweep->expectations[number].has_level) ++number;
    return number;
}

fw_status fw_sweep_bisect(fw_scenario **larger, const fw_scenario *sweep,
                          const fw_sweep_case *cases, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    const size_t width = (size_t)plan->parameter_count;
    *larger = NULL;
    if (plan->tolerance <= 0) return FW_OK;
    double *points = fw_array_of_doubles(2 * (size_t)plan->case_count * width);
    if (!points) return fw_fail_memory(error, "a bisection");
    const int expectation = find_crossing_expectation(sweep);
    int count = 0;
    fw_status status = FW_OK;
    for (int n = 0; n < plan->case_count && status == FW_OK; ++n) {
        fw_threshold t;
        if (!fw_sweep_is_head(plan, n, plan->bisected)) continue;
        status = fw_sweep_threshold_find(&t, sweep, cases, n, expectation, error);
        for (int k = 0; status == FW_OK && k < t.next_count; ++k) {
            double *point = points + (size_t)count++ * width;
            memcpy(point, plan->values + (size_t)n * width, width * sizeof *point);
            point[plan->bisected] = t.next[k];
        }
    }
    if (status == FW_OK && count > 0)
        status = fw_sweep_add_points(larger, sweep, points, count, error);
    free(points);
    return status;
}
