/* SPDX-License-Identifier: GPL-3.0-or-later */
/* layer.c - one number at a time from a profile and from series. Keeps no state. Start reading at
 * fw_layer_of(). */
#include "experiments/measures/layer.h"

#include "core/averages.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* clang-format off */
const fw_quantity fw_layer_quantities[] = {
    [FW_LAYER_CONTACT] = {"layer-contact", FW_SCOPE_STUDY, "", "force", "return force at the contact", NULL, NULL},
    [FW_LAYER_FAR] = {"layer-far", FW_SCOPE_STUDY, "", "force", "return force far from it", NULL, NULL},
    [FW_LAYER_CONTACT_OVER_FAR] = {"layer-contact-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other", NULL, NULL},
    [FW_LAYER_PEAK_OVER_FAR] = {"layer-peak-over-far", FW_SCOPE_STUDY, "", "1", "return force of the highest bin nearer than far, over far", NULL, NULL},
    [FW_LAYER_CONTACT_OVER_CONTROL] = {"layer-contact-over-control", FW_SCOPE_STUDY, "", "1", "return force at the contact over the control's", NULL, NULL},
    [FW_LAYER_EXCHANGES] = {"layer-exchanges", FW_SCOPE_STUDY, "", "1/time", "bonds lost per particle and time at the contact", NULL, NULL},
    [FW_LAYER_EXCHANGES_FAR] = {"layer-exchanges-far", FW_SCOPE_STUDY, "", "1/time", "the same far from it", NULL, NULL},
    [FW_LAYER_EXCHANGES_OVER_FAR] = {"layer-exchanges-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other, or over a single one seen: at least so much", NULL, NULL},
    [FW_LAYER_EXCHANGES_OVER_CONTROL] = {"layer-exchanges-over-control", FW_SCOPE_STUDY, "", "1", "at the contact over the control's, or over a single one seen: at least so much", NULL, NULL},
    [FW_LAYER_MOBILITY] = {"layer-mobility", FW_SCOPE_STUDY, "", "length^2", "mean square change of a bond's vector between samples at the contact", NULL, NULL},
    [FW_LAYER_MOBILITY_FAR] = {"layer-mobility-far", FW_SCOPE_STUDY, "", "length^2", "the same far from it", NULL, NULL},
    [FW_LAYER_MOBILITY_OVER_FAR] = {"layer-mobility-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other", NULL, NULL},
    [FW_LAYER_MOBILITY_OVER_CONTROL] = {"layer-mobility-over-control", FW_SCOPE_STUDY, "", "1", "at the contact over the control's", NULL, NULL},
    [FW_LAYER_WIDTH_ORDER] = {"layer-width-order", FW_SCOPE_STUDY, "", "length", "bins nearer than far in which the order |psi_n| is below .9; of seeds whose bodies have not parted (density at the contact above half of that far from it)", NULL, NULL},
    [FW_LAYER_WIDTH_HALF] = {"layer-width-half", FW_SCOPE_STUDY, "", "length", "the same, in which the return force is above the middle of contact and far", NULL, NULL},
    [FW_LAYER_WIDTH_DOUBLE] = {"layer-width-double", FW_SCOPE_STUDY, "", "length", "the same, in which the return force is above twice that of far", NULL, NULL},
    [FW_LAYER_TEMPERATURE] = {"layer-temperature", FW_SCOPE_STUDY, "", "energy", "of the contact, relative to its mean motion in each sample", NULL, NULL},
    [FW_LAYER_SLIP_PATH] = {"layer-slip-path", FW_SCOPE_STUDY, "", "length", "way of the first grip along the second in the phase before the samples", NULL, NULL},
    [FW_LAYER_OFFSET] = {"layer-offset", FW_SCOPE_STUDY, "", "length", "size of the mean displacement of the first grip along the second while samples are taken: how far the bodies have walked off each other", NULL, NULL},
    [FW_LAYER_FRICTION_FORCE] = {"layer-friction-force", FW_SCOPE_STUDY, "", "force", "mean size of the force along the interface while samples are taken", NULL, NULL},
    [FW_LAYER_NORMAL_FORCE] = {"layer-normal-force", FW_SCOPE_STUDY, "", "force", "mean force across the interface while samples are taken, pressing counts positive", NULL, NULL},
    [FW_LAYER_FRICTION_COEFFICIENT] = {"layer-friction-coefficient", FW_SCOPE_STUDY, "", "1", "energy of the loop over its way and the normal force", NULL, NULL},
    [FW_LAYER_LOOP_ENERGY] = {"layer-loop-energy", FW_SCOPE_STUDY, "", "energy", "area of the fretting loop (force along the interface against slip) per cycle", NULL, NULL},
    [FW_LAYER_UNSTEADINESS] = {"layer-unsteadiness", FW_SCOPE_STUDY, "", "1", "standard errors between both halves of contact-return-force, over as long before the samples as they take: steady below 3", NULL, NULL},
    {NULL, FW_SCOPE_STUDY, NULL, NULL, NULL, NULL, NULL},
};
/* clang-format on */

/* --- from the profile --- */

static double middle_of(const fw_profile *profile, int bin)
{
    return 0.5 * (fw_profile_edge(profile, bin) + fw_profile_edge(profile, bin + 1));
}

static bool is_near(const fw_observer *observer, int bin)
{
    const fw_scenario_profile *plan = &observer->experiment->scenario->profile;
    return fabs(middle_of(observer->profile, bin) - plan->middle) < plan->far[0];
}

static void measure_profile(double *values, const fw_observer *observer)
{
    const fw_profile *p = observer->profile;
    const double bin = observer->experiment->scenario->profile.bin;
    const double contact = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_RETURN_FORCE);
    const double far = fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_RETURN_FORCE);
    double peak = 0, width_order = 0, width_half = 0, width_double = 0;
    for (int b = 0; b < fw_profile_bin_count(p); ++b) {
        const double force = fw_profile_value(p, b, FW_PROFILE_RETURN_FORCE);
        if (!is_near(observer, b)) continue;
        peak = fmax(peak, force);
        width_order += fw_profile_value(p, b, FW_PROFILE_ORDER) < .9 ? bin : 0;
        width_half += force > .5 * (contact + far) ? bin : 0;
        width_double += force > 2 * far ? bin : 0;
    }
    /* Bodies that have parted have no layer whose width could be told. */
    const double density = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_DENSITY);
    if (!(density > .5 * fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_DENSITY)))
        width_order = width_half = width_double = NAN;
    values[FW_LAYER_CONTACT] = contact;
    values[FW_LAYER_FAR] = far;
    values[FW_LAYER_CONTACT_OVER_FAR] = contact / far;
    values[FW_LAYER_PEAK_OVER_FAR] = peak / far;
    values[FW_LAYER_WIDTH_ORDER] = width_order;
    values[FW_LAYER_WIDTH_HALF] = width_half;
    values[FW_LAYER_WIDTH_DOUBLE] = width_double;
    values[FW_LAYER_TEMPERATURE] = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_TEMPERATURE);
    values[FW_LAYER_EXCHANGES] = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_EXCHANGES);
    values[FW_LAYER_EXCHANGES_FAR] = fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_EXCHANGES);
    values[FW_LAYER_EXCHANGES_OVER_FAR] =
        values[FW_LAYER_EXCHANGES] /
        fmax(values[FW_LAYER_EXCHANGES_FAR], fw_profile_least_exchange(p, FW_PROFILE_FAR));
    values[FW_LAYER_MOBILITY] = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_MOBILITY);
    values[FW_LAYER_MOBILITY_FAR] = fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_MOBILITY);
    values[FW_LAYER_MOBILITY_OVER_FAR] = values[FW_LAYER_MOBILITY] / values[FW_LAYER_MOBILITY_FAR];
}

/* --- from the series --- */

/* Rows of a measurement in the steps from <= step <= until. */
typedef struct fw_rows {
    const fw_measurement *m;
    int64_t first, end;
} fw_rows;

static fw_rows rows_between(const fw_measurement *m, int64_t from, int64_t until)
{
    fw_rows rows = {m, m->count, m->count};
    for (int64_t row = m->count - 1; row >= 0; --row) {
        if (m->steps[row] > until) rows.end = row;
        if (m->steps[row] >= from) rows.first = row;
    }
    return rows;
}

static int column_of(const fw_measurement *m, const char *quantity, int component)
{
    for (int n = 0; n < m->probe_count; ++n)
        if (strcmp(m->probes[n].quantity->name, quantity) == 0)
            return m->probes[n].first + component;
    return -1;
}

static double at(const fw_measurement *m, int64_t row, int column)
{
    return column < 0 ? NAN : m->values[row * m->width + column];
}

static double path_of(fw_rows rows, int column)
{
    double path = 0;
    for (int64_t row = rows.first + 1; row < rows.end; ++row)
        path += fabs(at(rows.m, row, column) - at(rows.m, row - 1, column));
    return path;
}

/* Integral of the force along the second body against slip, by trapezoids: what rubbing takes. */
static double loop_of(fw_rows rows, int force, int slip)
{
    double area = 0;
    for (int64_t row = rows.first + 1; row < rows.end; ++row)
        area -= 0.5 * (at(rows.m, row, force) + at(rows.m, row - 1, force)) *
                (at(rows.m, row, slip) - at(rows.m, row - 1, slip));
    return area;
}

/* How many cycles of the drive the samples take; 1 where nothing oscillates. */
static double cycles_of(const fw_experiment *experiment)
{
    const fw_scenario *scenario = experiment->scenario;
    const fw_scenario_profile *plan = &scenario->profile;
    double period = 0;
    for (int g = 0; g < scenario->grip_count; ++g)
        period = fmax(period, scenario->grips[g].motion.drive.period);
    for (int p = 0; p < scenario->phase_count; ++p)
        for (int d = 0; d < scenario->phases[p].drive_count; ++d)
            period = fmax(period, scenario->phases[p].drives[d].motion.drive.period);
    const double span =
        (double)(plan->until - plan->from) * fw_experiment_particles(experiment)->tick;
    return period > 0 ? span / period : 1;
}

static void measure_friction(double *values, const fw_experiment *experiment,
                             const fw_measurement *m)
{
    const fw_scenario *scenario = experiment->scenario;
    const fw_scenario_profile *plan = &scenario->profile;
    const int along = plan->axis == 0 ? 1 : 0, across = plan->axis;
    const int slip = column_of(m, "slip", along);
    const int force = column_of(m, "interface-force", along);
    const int normal = column_of(m, "interface-force", across);
    const fw_rows rows = rows_between(m, plan->from, plan->until);
    int64_t before = 0;
    for (int p = 0; p < scenario->phase_count; ++p)
        if (scenario->phases[p].until == plan->from) before = scenario->phases[p].from;
    double size = 0, press = 0, offset = 0;
    for (int64_t row = rows.first; row < rows.end; ++row) {
        offset += at(m, row, slip);
        size += fabs(at(m, row, force));
        press += fabs(at(m, row, normal));
    }
    const double count = (double)(rows.end - rows.first);
    const double area = loop_of(rows, force, slip);
    values[FW_LAYER_SLIP_PATH] = path_of(rows_between(m, before, plan->from), slip);
    values[FW_LAYER_OFFSET] = fabs(offset / count);
    values[FW_LAYER_FRICTION_FORCE] = size / count;
    values[FW_LAYER_NORMAL_FORCE] = press / count;
    values[FW_LAYER_LOOP_ENERGY] = area / cycles_of(experiment);
    values[FW_LAYER_FRICTION_COEFFICIENT] = area / (path_of(rows, slip) * (press / count));
}

static fw_status measure_steadiness(double *value, const fw_experiment *experiment,
                                    const fw_measurement *m, fw_error *error)
{
    const fw_scenario_profile *plan = &experiment->scenario->profile;
    const int64_t span = plan->until - plan->from;
    const fw_rows rows = rows_between(m, plan->from > span ? plan->from - span : 0, plan->from - 1);
    const int column = column_of(m, "contact-return-force", 0);
    *value = NAN;
    if (rows.end - rows.first < 8) return FW_OK;
    const size_t count = (size_t)(rows.end - rows.first);
    double *series = malloc(count * sizeof *series);
    if (!series) return fw_fail_memory(error, "a series");
    for (size_t n = 0; n < count; ++n) series[n] = at(m, rows.first + (int64_t)n, column);
    const fw_status status = fw_average_drift(value, series, count, error);
    free(series);
    *value = fabs(*value);
    return status;
}

fw_status fw_layer_of(double values[FW_LAYER_MEASURES], const fw_observer *observer,
                      const fw_measurement *measurement, fw_error *error)
{
    for (int n = 0; n < FW_LAYER_MEASURES; ++n) values[n] = NAN;
    measure_profile(values, observer);
    measure_friction(values, observer->experiment, measurement);
    return measure_steadiness(&values[FW_LAYER_UNSTEADINESS], observer->experiment, measurement,
                              error);
}

bool fw_layer_needs_control(int measure)
{
    return measure == FW_LAYER_CONTACT_OVER_CONTROL || measure == FW_LAYER_EXCHANGES_OVER_CONTROL ||
           measure == FW_LAYER_MOBILITY_OVER_CONTROL;
}

void fw_layer_compare(double values[FW_LAYER_MEASURES], const double control[FW_LAYER_MEASURES],
                      const fw_profile *profile)
{
    values[FW_LAYER_CONTACT_OVER_CONTROL] = values[FW_LAYER_CONTACT] / control[FW_LAYER_CONTACT];
    values[FW_LAYER_MOBILITY_OVER_CONTROL] = values[FW_LAYER_MOBILITY] / control[FW_LAYER_MOBILITY];
    values[FW_LAYER_EXCHANGES_OVER_CONTROL] =
        values[FW_LAYER_EXCHANGES] /
        fmax(control[FW_LAYER_EXCHANGES], fw_profile_least_exchange(profile, FW_PROFILE_CONTACT));
}
