/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_series.c - observables over time: which curves, in which panels, under which names.
 * Keeps no state. Invariant: quantities of one unit share a panel, unless one would flatten the
 * other; pure numbers have nothing in common and get one each. Start reading at
 * fw_plot_series_find(). */
#include "plot_compare.h"

#include "experiments/drawing/label.h"
#include "experiments/measures/column.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CURVES_MAX = 256 };

/* One component of an observable. */
typedef struct fw_plot_curve {
    int observable, component;
    char quantity[FW_NAME_SIZE], subject[FW_NAME_SIZE]; /* "momentum", "sheet" */
    char part[FW_COLUMN_PART];                          /* "x" */
    const char *unit;
    int panel;
    double *values; /* of all samples */
    char label[4 * FW_NAME_SIZE];
} fw_plot_curve;

typedef fw_plot_curve curve;

typedef fw_plot_series series;

/* --- which curves --- */

/* "momentum.sheet" is the momentum of sheet. */
static void split_label(const char *label, char quantity[FW_NAME_SIZE], char subject[FW_NAME_SIZE])
{
    size_t length = strcspn(label, ".");
    memcpy(quantity, label, length);
    quantity[length] = '\0';
    snprintf(subject, FW_NAME_SIZE, "%s", label[length] ? label + length + 1 : "");
}

/* Where there is one body, or one wall, its name says nothing new. */
static void drop_only_subject(const fw_scenario *scenario, char *subject)
{
    const char *body = scenario->body_count == 1 ? scenario->bodies[0].name : NULL;
    const char *wall = scenario->wall_count == 1 ? scenario->walls[0].def.name : NULL;
    if ((body && strcmp(subject, body) == 0) || (wall && strcmp(subject, wall) == 0))
        subject[0] = '\0';
}

static void add_curve(series *s, const fw_column *column)
{
    const fw_playback_observable *of = &s->result->playback->observables[column->observable];
    curve *added = &s->curves[s->curve_count++];
    *added =
        (curve){.observable = column->observable, .component = column->component, .unit = of->unit};
    split_label(of->name, added->quantity, added->subject);
    drop_only_subject(s->result->scenario, added->subject);
    memcpy(added->part, column->part, sizeof added->part);
}

static fw_status gather_curves(series *s, const fw_plot_picture *picture, fw_error *error)
{
    fw_column *columns;
    int count;
    fw_status status =
        fw_columns_find(s->result->playback, s->result->directory, picture->observables,
                        picture->observable_count, &columns, &count, error);
    if (status == FW_OK && count > CURVES_MAX)
        status = fw_fail(error, FW_BAD_INPUT,
                         "%s: %d curves in one picture, expected at most %d: fewer observables",
                         s->result->directory, count, CURVES_MAX);
    for (int n = 0; status == FW_OK && n < count; ++n) add_curve(s, &columns[n]);
    free(columns);
    return status;
}

/* --- numbers --- */

/* The samples between the steps that are drawn. */
static fw_status read_times(series *s, const fw_plot_picture *picture, fw_error *error)
{
    size_t count = (size_t)s->result->playback->sample_count;
    s->steps = fw_array_allocate(count, sizeof *s->steps);
    s->times = fw_array_of_doubles(count);
    if (!s->steps || !s->times) return fw_fail_memory(error, "the times of a picture");
    FW_TRY(fw_playback_read_sample_times(s->result->playback, s->steps, s->times, error));
    for (size_t k = 0; k < count && picture->in_steps; ++k) s->times[k] = (double)s->steps[k];
    for (size_t k = 0; k < count; ++k) {
        if (s->steps[k] < picture->asked.from) s->first += 1;
        if (s->steps[k] >= picture->asked.from && s->steps[k] <= picture->asked.until)
            s->shown += 1;
    }
    if (s->shown > 0) return FW_OK;
    if (picture->asked.until == INT64_MAX)
        return fw_fail(error, FW_BAD_INPUT, "%s: nothing was measured from step %lld on",
                       s->result->directory, (long long)picture->asked.from);
    return fw_fail(error, FW_BAD_INPUT, "%s: nothing was measured from step %lld to step %lld",
                   s->result->directory, (long long)picture->asked.from,
                   (long long)picture->asked.until);
}

static fw_status read_curves(series *s, fw_error *error)
{
    fw_playback *playback = s->result->playback;
    size_t count = (size_t)playback->sample_count;
    int most = 1;
    for (int n = 0; n < s->curve_count; ++n) {
        int components = playback->observables[s->curves[n].observable].components;
        most = components > most ? components : most;
    }
    double *rows = fw_array_of_doubles(count * (size_t)most);
    fw_status status = rows ? FW_OK : fw_fail_memory(error, "the observables of a picture");
    for (int n = 0; n < s->curve_count && status == FW_OK; ++n) {
        curve *c = &s->curves[n];
        size_t components = (size_t)playback->observables[c->observable].components;
        c->values = fw_array_of_doubles(count);
        status = c->values ? fw_playback_read_observable(playback, c->observable, rows, error)
                           : fw_fail_memory(error, "the observables of a picture");
        for (size_t k = 0; k < count && status == FW_OK; ++k)
            c->values[k] = rows[k * components + (size_t)c->component];
    }
    free(rows);
    return status;
}

/* Is a step one unit of time? */
static bool steps_are_times(const series *s)
{
    for (int k = s->first; k < s->first + s->shown; ++k)
        if (s->times[k] != (double)s->steps[k]) return false;
    return true;
}

/* --- panels and names --- */

static fw_range range_of(const series *s, const curve *c)
{
    fw_range range = fw_range_empty();
    fw_range_include(&range, c->values + s->first, s->shown, false);
    return fw_range_without_rounding(range);
}

/* Would the changes of one be lost beside the other? What is constant has none. */
static bool flattens(fw_range one, fw_range other)
{
    fw_range both = one;
    fw_range_include(&both, (double[]){other.low, other.high}, 2, false);
    const double extent = both.high - both.low, least = extent / 60;
    const double a = one.high - one.low, b = other.high - other.low;
    return (a > 0 && a < least) || (b > 0 && b < least);
}

static bool share_panel(const series *s, const curve *one, const curve *other)
{
    if (strcmp(one->quantity, other->quantity) == 0) return true;
    return strcmp(one->unit, other->unit) == 0 && strcmp(one->unit, "1") != 0 &&
           !flattens(range_of(s, one), range_of(s, other));
}

/* The first panel all of whose curves the next one can stand beside. */
static int panel_for(const series *s, int number)
{
    for (int panel = 0; panel < s->panel_count; ++panel) {
        bool fits = true, same = false;
        for (int n = 0; n < number; ++n) {
            if (s->curves[n].panel != panel) continue;
            fits &= share_panel(s, &s->curves[n], &s->curves[number]);
            same |= strcmp(s->curves[n].quantity, s->curves[number].quantity) == 0;
        }
        if (fits || same) return panel;
    }
    return s->panel_count;
}

static void assign_panels(series *s)
{
    for (int n = 0; n < s->curve_count; ++n) {
        const int panel = panel_for(s, n);
        s->curves[n].panel = panel;
        if (panel == s->panel_count) s->panel_count += 1;
    }
}

/* What the curves of a panel have in common is said beside its axis, the rest in its legend. */
typedef struct panel_facts {
    const curve *first;
    int curves;
    bool one_quantity, one_subject, one_part;
} panel_facts;

static panel_facts facts_of(const series *s, int panel)
{
    panel_facts facts = {NULL, 0, true, true, true};
    for (int n = 0; n < s->curve_count; ++n) {
        const curve *c = &s->curves[n];
        if (c->panel != panel) continue;
        if (!facts.first) facts.first = c;
        facts.curves += 1;
        facts.one_quantity &= strcmp(c->quantity, facts.first->quantity) == 0;
        facts.one_subject &= strcmp(c->subject, facts.first->subject) == 0;
        facts.one_part &= strcmp(c->part, facts.first->part) == 0;
    }
    facts.one_part &= facts.one_quantity;
    return facts;
}

/* "nine: elongation x", "nine: x", "x", "kinetic energy". */
static void name_curve(curve *c, panel_facts facts)
{
    char quantity[FW_NAME_SIZE] = "";
    if (!facts.one_quantity) fw_label_print(quantity, sizeof quantity, c->quantity, NULL);
    const char *subject = facts.one_subject ? "" : c->subject[0] ? c->subject : "all";
    const char *part = facts.one_part ? "" : c->part;
    snprintf(c->label, sizeof c->label, "%s%s%s%s%s", subject,
             subject[0] && (quantity[0] || part[0]) ? ": " : "", quantity,
             quantity[0] && part[0] ? " " : "", part);
}

/* "elongation x of nine (length)", "energy", "kinetic fraction". */
static fw_label name_panel(panel_facts facts, char *label, size_t size, const fw_units *units)
{
    const curve *c = facts.first;
    char whole[4 * FW_NAME_SIZE];
    const bool own_unit = facts.one_quantity && strcmp(c->unit, c->quantity) != 0;
    const bool physical = fw_units_physical(units, c->unit).factor > 0;
    const char *part = facts.one_part ? c->part : "";
    const char *subject = facts.one_subject ? c->subject : "";
    snprintf(whole, sizeof whole, "%s%s%s%s%s", facts.one_quantity ? c->quantity : c->unit,
             part[0] ? " " : "", part, subject[0] ? " of " : "", subject);
    return fw_plot_label(label, size, whole, own_unit || physical ? c->unit : NULL, units);
}

/* One number in place of the time. */
static fw_status read_along(series *s, const fw_plot_picture *picture, fw_error *error)
{
    fw_column *columns = NULL;
    int count = 0;
    curve *of = calloc(1, sizeof *of);
    series other = {.result = s->result, .curves = of};
    fw_status status = of ? fw_columns_find(s->result->playback, s->result->directory,
                                            &picture->along, 1, &columns, &count, error)
                          : fw_fail_memory(error, "the curves of a picture");
    if (status == FW_OK && count != 1)
        status = fw_fail(error, FW_BAD_INPUT,
                         "--along %s are %d numbers, expected one, such as its component x",
                         picture->along, count);
    if (status == FW_OK) {
        add_curve(&other, &columns[0]);
        status = read_curves(&other, error);
        s->along = of->values;
        s->along_label = name_panel((panel_facts){of, 1, true, true, true}, s->along_text,
                                    sizeof s->along_text, &s->result->scenario->units);
    }
    free(of);
    free(columns);
    return status;
}

static const double *x_of(const series *s)
{
    return (s->along ? s->along : s->times) + s->first;
}

/* A curve that lies on another one would hide it: it is dashed, so that both are seen. */
static bool lies_on(const series *s, const curve *one, const curve *other, fw_range values)
{
    const double unseen = .004 * (values.high - values.low);
    for (int k = s->first; k < s->first + s->shown; ++k)
        if (!(fabs(one->values[k] - other->values[k]) <= unseen) &&
            isfinite(one->values[k]) + isfinite(other->values[k]) > 0)
            return false;
    return true;
}

static fw_curve_look look_of(const series *s, int number)
{
    const curve *c = &s->curves[number];
    fw_range values = fw_range_empty();
    for (int n = 0; n < s->curve_count; ++n)
        if (s->curves[n].panel == c->panel)
            fw_range_include(&values, s->curves[n].values + s->first, s->shown, false);
    for (int n = 0; n < number; ++n)
        if (s->curves[n].panel == c->panel && lies_on(s, c, &s->curves[n], values))
            return FW_CURVE_DASHES;
    return FW_CURVE_LINE;
}

/* What a heat bath was set to in the step that ended there; NAN: there is none. */
static double set_temperature(const fw_scenario *scenario, int64_t end)
{
    const int64_t step = end > 0 ? end - 1 : 0;
    double damping = scenario->dynamics.damping, temperature = scenario->dynamics.temperature;
    for (int n = 0; n < scenario->phase_count; ++n) {
        const fw_scenario_phase *phase = &scenario->phases[n];
        if (step < phase->from || step >= phase->until) continue;
        if (phase->damping >= 0) damping = phase->damping;
        if (phase->temperature >= 0) temperature = phase->temperature;
    }
    return damping > 0 ? temperature : NAN;
}

/* A temperature is shown beside what is set. */
static fw_status add_reference(series *s, fw_chart *chart, panel_facts facts, fw_error *error)
{
    if (s->along || !facts.one_quantity || strcmp(facts.first->quantity, "temperature") != 0)
        return FW_OK;
    const size_t count = (size_t)s->shown;
    if (!s->set) s->set = fw_array_of_doubles(count);
    if (!s->set) return fw_fail_memory(error, "the temperature that is set");
    bool any = false;
    for (size_t k = 0; k < count; ++k) {
        s->set[k] = set_temperature(s->result->scenario, s->steps[(size_t)s->first + k]);
        any |= isfinite(s->set[k]);
    }
    if (!any) return FW_OK;
    fw_curve *drawn = (fw_curve *)chart->curves;
    if (facts.curves == 1) drawn[0].label = "measured";
    drawn[chart->curve_count++] = (fw_curve){.label = "set by the heat bath",
                                             .count = s->shown,
                                             .x = x_of(s),
                                             .y = s->set,
                                             .look = FW_CURVE_DASHES,
                                             .colour = FW_PLOT_BATH_COLOUR};
    return FW_OK;
}

static fw_status lay_out(series *s, bool logarithmic, fw_error *error)
{
    assign_panels(s);
    s->charts = calloc((size_t)s->panel_count, sizeof *s->charts);
    s->labels = calloc((size_t)s->panel_count, sizeof *s->labels);
    s->drawn = calloc(2 * (size_t)s->curve_count, sizeof *s->drawn);
    if (!s->charts || !s->labels || !s->drawn) return fw_fail_memory(error, "the panels");
    fw_curve *next = s->drawn;
    for (int p = 0; p < s->panel_count; ++p) {
        panel_facts facts = facts_of(s, p);
        const fw_label label =
            name_panel(facts, s->labels[p], sizeof s->labels[p], &s->result->scenario->units);
        s->charts[p] = (fw_chart){.label = label,
                                  .curves = next,
                                  .curve_count = facts.curves,
                                  .logarithmic = logarithmic};
        for (int n = 0; n < s->curve_count; ++n) {
            curve *c = &s->curves[n];
            if (c->panel != p) continue;
            name_curve(c, facts);
            *next++ = (fw_curve){.label = facts.curves > 1 ? c->label : NULL,
                                 .count = s->shown,
                                 .x = x_of(s),
                                 .y = c->values + s->first,
                                 .look = look_of(s, n)};
        }
        FW_TRY(add_reference(s, &s->charts[p], facts, error));
        next = (fw_curve *)s->charts[p].curves + s->charts[p].curve_count;
    }
    return FW_OK;
}

/* A panel whose values are all <= 0 would stay empty on a logarithmic axis. */
static fw_status check_logarithmic(const series *s, fw_error *error)
{
    for (int p = 0; p < s->panel_count; ++p) {
        fw_range all = fw_range_empty(), above = fw_range_empty();
        for (int n = 0; n < s->curve_count; ++n) {
            if (s->curves[n].panel != p) continue;
            const double *values = s->curves[n].values + s->first;
            fw_range_include(&all, values, s->shown, false);
            fw_range_include(&above, values, s->shown, true);
        }
        if (fw_range_is_empty(all) || !fw_range_is_empty(above)) continue;
        const curve *c = facts_of(s, p).first;
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: %s%s%s goes from %.4g to %.4g, expected values above 0 on a "
                       "logarithmic axis",
                       s->result->directory, c->quantity, c->subject[0] ? "." : "", c->subject,
                       all.low, all.high);
    }
    return FW_OK;
}

static fw_status draw(const series *s, const fw_chart *charts, const fw_plot_picture *picture,
                      fw_error *error)
{
    const bool by_step = steps_are_times(s) && !s->along;
    char time[32];
    const fw_units *units = &s->result->scenario->units;
    const fw_scenario_run *run = &s->result->scenario->run;
    const fw_figure_mark reversal = {(double)run->reverse_at, "reversal"};
    const fw_label x = s->along            ? s->along_label
                       : picture->in_steps ? (fw_label){"time (steps)", 0}
                                           : fw_plot_time_label(time, sizeof time, by_step, units);
    return fw_figure_series(&picture->page, charts, s->panel_count, x, &reversal,
                            run->reverse_at > 0 && by_step, error);
}

fw_status fw_plot_series_find(fw_plot_series *s, const fw_plot_result *result,
                              const fw_plot_picture *picture, fw_error *error)
{
    *s = (fw_plot_series){.result = result, .curves = calloc(CURVES_MAX, sizeof *s->curves)};
    if (!s->curves) return fw_fail_memory(error, "the curves of a picture");
    FW_TRY(gather_curves(s, picture, error));
    FW_TRY(read_times(s, picture, error));
    FW_TRY(read_curves(s, error));
    if (picture->along) FW_TRY(read_along(s, picture, error));
    FW_TRY(lay_out(s, picture->asked.logarithmic, error));
    return picture->asked.logarithmic ? check_logarithmic(s, error) : FW_OK;
}

void fw_plot_series_clear(fw_plot_series *s)
{
    for (int n = 0; n < s->curve_count; ++n) free(s->curves[n].values);
    free(s->curves);
    free(s->steps);
    free(s->times);
    free(s->charts);
    free(s->drawn);
    free(s->labels);
    free(s->set);
    free(s->along);
    *s = (fw_plot_series){0};
}

fw_status fw_plot_draw_series(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error)
{
    series s;
    fw_status status = fw_plot_series_find(&s, result, picture, error);
    fw_plot_compared *all = calloc(1, sizeof *all);
    if (status == FW_OK && !all) status = fw_fail_memory(error, "a picture of several results");
    if (status == FW_OK && picture->with_count > 0)
        status = fw_plot_compared_find(all, &s, picture, error);
    if (status == FW_OK)
        status = draw(&s, picture->with_count > 0 ? all->charts : s.charts, picture, error);
    if (all) fw_plot_compared_clear(all);
    free(all);
    fw_plot_series_clear(&s);
    return status;
}
