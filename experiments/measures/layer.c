/* SPDX-License-Identifier: GPL-3.0-or-later */
/* layer.c - one number at a time from a profile and from series. Keeps no state. Start reading at
 * fw_layer_of(). */
#include "experiments/measures/layer.h"

#include "core/array.h"
#include "core/averages.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* clang-format off */
const fw_quantity fw_layer_quantities[] = {
    [FW_LAYER_CONTACT] = {"layer-contact", FW_SCOPE_STUDY, "", "force", "return force at the contact", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_FAR] = {"layer-far", FW_SCOPE_STUDY, "", "force", "return force far from it", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_CONTACT_OVER_FAR] = {"layer-contact-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other", NULL, NULL, "no return force acts far from the contact", FW_NEEDS_PROFILE},
    [FW_LAYER_PEAK_OVER_FAR] = {"layer-peak-over-far", FW_SCOPE_STUDY, "", "1", "return force of the highest bin nearer than far, over far", NULL, NULL, "no return force acts far from the contact", FW_NEEDS_PROFILE},
    [FW_LAYER_CONTACT_OVER_CONTROL] = {"layer-contact-over-control", FW_SCOPE_STUDY, "", "1", "return force at the contact over the control's", NULL, NULL, "no return force acts at the control's contact", FW_NEEDS_PROFILE},
    [FW_LAYER_BOND_BREAKING] = {"layer-bond-breaking", FW_SCOPE_STUDY, "", "1/time", "bonds broken per particle and time at the contact", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_BOND_BREAKING_FAR] = {"layer-bond-breaking-far", FW_SCOPE_STUDY, "", "1/time", "the same far from it", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_BOND_BREAKING_OVER_FAR] = {"layer-bond-breaking-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other, or over a single one seen: at least so much", NULL, NULL, "no particle was looked at far from the contact", FW_NEEDS_PROFILE},
    [FW_LAYER_BOND_BREAKING_OVER_CONTROL] = {"layer-bond-breaking-over-control", FW_SCOPE_STUDY, "", "1", "at the contact over the control's, or over a single one seen: at least so much", NULL, NULL, "no particle was looked at at the control's contact", FW_NEEDS_PROFILE},
    [FW_LAYER_RELATIVE_DISPLACEMENT] = {"layer-relative-displacement", FW_SCOPE_STUDY, "", "length^2", "mean square change of a bond's vector over one unit of time, r0 (m/epsilon)^(1/2), at the contact", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_RELATIVE_DISPLACEMENT_FAR] = {"layer-relative-displacement-far", FW_SCOPE_STUDY, "", "length^2", "the same far from it", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_RELATIVE_DISPLACEMENT_OVER_FAR] = {"layer-relative-displacement-over-far", FW_SCOPE_STUDY, "", "1", "the one over the other", NULL, NULL, "no bond changes far from the contact", FW_NEEDS_PROFILE},
    [FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL] = {"layer-relative-displacement-over-control", FW_SCOPE_STUDY, "", "1", "at the contact over the control's", NULL, NULL, "no bond changes at the control's contact", FW_NEEDS_PROFILE},
    [FW_LAYER_DIFFUSIVITY] = {"layer-diffusivity", FW_SCOPE_STUDY, "", "length^2/time", "of the particles at the contact, across it: 0 within its error where they only slide", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_DIFFUSIVITY_FAR] = {"layer-diffusivity-far", FW_SCOPE_STUDY, "", "length^2/time", "the same far from it", NULL, NULL, NULL, FW_NEEDS_PROFILE},
    [FW_LAYER_WIDTH_ORDER] = {"layer-width-order", FW_SCOPE_STUDY, "", "length", "how far across, nearer than far, the order |psi_n| is below .9, straight lines between the bins, whose width it depends on: compare equal ones; of seeds whose bodies have not parted (density at the contact above half of that far from it)", NULL, NULL, "the bodies have parted", FW_NEEDS_PROFILE},
    [FW_LAYER_WIDTH_HALF] = {"layer-width-half", FW_SCOPE_STUDY, "", "length", "the same, where the return force is above the middle of contact and far", NULL, NULL, "the bodies have parted", FW_NEEDS_PROFILE},
    [FW_LAYER_WIDTH_DOUBLE] = {"layer-width-double", FW_SCOPE_STUDY, "", "length", "the same, where the return force is above twice that of far", NULL, NULL, "the bodies have parted", FW_NEEDS_PROFILE},
    [FW_LAYER_TEMPERATURE] = {"layer-temperature", FW_SCOPE_STUDY, "", "energy/k_B", "of the contact, relative to its mean motion in each sample", NULL, NULL, "nothing at the contact is free", FW_NEEDS_PROFILE},
    [FW_LAYER_SLIP_PATH] = {"layer-slip-path", FW_SCOPE_STUDY, "", "length", "path length of the first grip along the second in the phase before the samples, summed in every step", NULL, NULL, "there are fewer than two grips", FW_NEEDS_PROFILE},
    [FW_LAYER_OFFSET] = {"layer-offset", FW_SCOPE_STUDY, "", "length", "size of the mean displacement of the first grip along the second while samples are taken: how far the bodies have walked off each other", NULL, NULL, "there are fewer than two grips", FW_NEEDS_PROFILE},
    [FW_LAYER_FRICTION_FORCE] = {"layer-friction-force", FW_SCOPE_STUDY, "", "force", "mean size of the force along the interface while samples are taken", NULL, NULL, "there are fewer than two bodies of movable particles, and no other two", FW_NEEDS_PROFILE},
    [FW_LAYER_NORMAL_FORCE] = {"layer-normal-force", FW_SCOPE_STUDY, "", "force", "mean size of the force across the interface while samples are taken, pressing or pulling", NULL, NULL, "there are fewer than two bodies of movable particles, and no other two", FW_NEEDS_PROFILE},
    [FW_LAYER_FRICTION_COEFFICIENT] = {"layer-friction-coefficient", FW_SCOPE_STUDY, "", "1", "energy of the loop over its path length and the normal force", NULL, NULL, "nothing slips under a normal force", FW_NEEDS_PROFILE},
    [FW_LAYER_LOOP_ENERGY] = {"layer-loop-energy", FW_SCOPE_STUDY, "", "energy", "area of the fretting loop (force along the interface against slip, step by step) per cycle", NULL, NULL, "it takes two grips and two bodies", FW_NEEDS_PROFILE},
    [FW_LAYER_UNSTEADINESS] = {"layer-unsteadiness", FW_SCOPE_STUDY, "", "1", "standard errors between both halves of contact-return-force, over as long before the samples as they take: steady below 3", NULL, NULL, "fewer than 8 rows are measured before the samples", FW_NEEDS_PROFILE},
    [FW_LAYER_VELOCITY_BELOW] = {"layer-velocity-below", FW_SCOPE_STUDY, "", "length/time", "drift velocity of the last bin before the contact region (at smaller coordinates)", NULL, NULL, "no bin there has particles", FW_NEEDS_PROFILE},
    [FW_LAYER_VELOCITY_ABOVE] = {"layer-velocity-above", FW_SCOPE_STUDY, "", "length/time", "drift velocity of the first bin behind the contact region (at greater coordinates)", NULL, NULL, "no bin there has particles", FW_NEEDS_PROFILE},
    {NULL, FW_SCOPE_STUDY, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */

/* No number over nothing, nor over what is rounding beside it. */
static double over(double value, double below)
{
    return below > FW_MEASURED * fabs(value) ? value / below : NAN;
}

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

static double highest_force(const fw_observer *observer)
{
    double highest = 0;
    for (int b = 0; b < fw_profile_bin_count(observer->profile); ++b)
        if (is_near(observer, b))
            highest =
                fmax(highest, fw_profile_value(observer->profile, b, FW_PROFILE_RETURN_FORCE));
    return highest;
}

/* The length of low .. high on which the line from (from, first) to (until, second) is above 0. */
static double length_above(double from, double first, double until, double second, double low,
                           double high)
{
    if (first <= 0 && second <= 0) return 0;
    if ((first > 0) != (second > 0)) {
        const double crossing = from + (until - from) * first / (first - second);
        if (first > 0)
            until = crossing;
        else
            from = crossing;
    }
    return fmax(fmin(until, high) - fmax(from, low), 0);
}

double fw_layer_width(const double *places, const double *values, int count, double level,
                      double sign, double low, double high)
{
    double width = 0;
    int last = -1;
    for (int n = 0; n < count; ++n) {
        if (isnan(values[n])) continue;
        if (last >= 0)
            width += length_above(places[last], sign * (values[last] - level), places[n],
                                  sign * (values[n] - level), low, high);
        last = n;
    }
    return last < 0 ? NAN : width;
}

/* Where the lines between the middles of the bins are above the level (sign 1) or below it (-1),
 * nearer than far. */
static double width_of(const fw_observer *observer, const double *places, double *values,
                       fw_profile_column column, double level, double sign)
{
    const fw_profile *p = observer->profile;
    const fw_scenario_profile *plan = &observer->experiment->scenario->profile;
    const int count = fw_profile_bin_count(p);
    for (int b = 0; b < count; ++b) values[b] = fw_profile_value(p, b, column);
    return fw_layer_width(places, values, count, level, sign, plan->middle - plan->far[0],
                          plan->middle + plan->far[0]);
}

static fw_status measure_widths(double *measures, const fw_observer *observer, fw_error *error)
{
    const fw_profile *p = observer->profile;
    const size_t count = (size_t)fw_profile_bin_count(p);
    const double contact = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_RETURN_FORCE);
    const double far = fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_RETURN_FORCE);
    /* Bodies that have parted have no layer with a width. */
    const double density = fw_profile_value(p, FW_PROFILE_CONTACT, FW_PROFILE_DENSITY);
    if (!(density > .5 * fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_DENSITY))) return FW_OK;
    double *places = fw_array_of_doubles(count), *values = fw_array_of_doubles(count);
    if (places && values) {
        for (size_t b = 0; b < count; ++b) places[b] = middle_of(p, (int)b);
        measures[FW_LAYER_WIDTH_ORDER] =
            width_of(observer, places, values, FW_PROFILE_ORDER, .9, -1);
        measures[FW_LAYER_WIDTH_HALF] =
            width_of(observer, places, values, FW_PROFILE_RETURN_FORCE, .5 * (contact + far), 1);
        measures[FW_LAYER_WIDTH_DOUBLE] =
            width_of(observer, places, values, FW_PROFILE_RETURN_FORCE, 2 * far, 1);
    }
    const bool fine = places && values;
    free(places);
    free(values);
    return fine ? FW_OK : fw_fail_memory(error, "the width of a layer");
}

/* Of the bin with particles that is the nearest to the contact region, on one side of it. */
static double velocity_beside(const fw_observer *observer, double side)
{
    const fw_profile *p = observer->profile;
    const fw_scenario_profile *plan = &observer->experiment->scenario->profile;
    double nearest = INFINITY, velocity = NAN;
    for (int b = 0; b < fw_profile_bin_count(p); ++b) {
        const double away = side * (middle_of(p, b) - plan->middle);
        const double drift = fw_profile_value(p, b, FW_PROFILE_DRIFT);
        if (away < plan->contact || away > nearest || isnan(drift)) continue;
        nearest = away;
        velocity = drift;
    }
    return velocity;
}

static void measure_profile(double *values, const fw_observer *observer)
{
    const fw_profile *p = observer->profile;
    static const struct {
        fw_layer_measure measure;
        int region;
        fw_profile_column column;
    } plain[] = {
        {FW_LAYER_CONTACT, FW_PROFILE_CONTACT, FW_PROFILE_RETURN_FORCE},
        {FW_LAYER_FAR, FW_PROFILE_FAR, FW_PROFILE_RETURN_FORCE},
        {FW_LAYER_TEMPERATURE, FW_PROFILE_CONTACT, FW_PROFILE_TEMPERATURE},
        {FW_LAYER_BOND_BREAKING, FW_PROFILE_CONTACT, FW_PROFILE_BOND_BREAKING},
        {FW_LAYER_BOND_BREAKING_FAR, FW_PROFILE_FAR, FW_PROFILE_BOND_BREAKING},
        {FW_LAYER_RELATIVE_DISPLACEMENT, FW_PROFILE_CONTACT, FW_PROFILE_RELATIVE_DISPLACEMENT},
        {FW_LAYER_RELATIVE_DISPLACEMENT_FAR, FW_PROFILE_FAR, FW_PROFILE_RELATIVE_DISPLACEMENT},
        {FW_LAYER_DIFFUSIVITY, FW_PROFILE_CONTACT, FW_PROFILE_DIFFUSIVITY},
        {FW_LAYER_DIFFUSIVITY_FAR, FW_PROFILE_FAR, FW_PROFILE_DIFFUSIVITY},
    };
    for (size_t n = 0; n < sizeof plain / sizeof plain[0]; ++n)
        values[plain[n].measure] = fw_profile_value(p, plain[n].region, plain[n].column);
    values[FW_LAYER_VELOCITY_BELOW] = velocity_beside(observer, -1);
    values[FW_LAYER_VELOCITY_ABOVE] = velocity_beside(observer, 1);
    const double far = values[FW_LAYER_FAR];
    values[FW_LAYER_CONTACT_OVER_FAR] = over(values[FW_LAYER_CONTACT], far);
    values[FW_LAYER_PEAK_OVER_FAR] = over(highest_force(observer), far);
    values[FW_LAYER_BOND_BREAKING_OVER_FAR] =
        over(values[FW_LAYER_BOND_BREAKING], fmax(values[FW_LAYER_BOND_BREAKING_FAR],
                                                  fw_profile_least_breaking(p, FW_PROFILE_FAR)));
    values[FW_LAYER_RELATIVE_DISPLACEMENT_OVER_FAR] =
        over(values[FW_LAYER_RELATIVE_DISPLACEMENT], values[FW_LAYER_RELATIVE_DISPLACEMENT_FAR]);
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

static double period_of(const fw_drive *drive)
{
    return fmax(drive->period, drive->path.period);
}

/* How many cycles of the drive the samples take; 1 where nothing oscillates. */
static double cycles_of(const fw_experiment *experiment)
{
    const fw_scenario *scenario = experiment->scenario;
    const fw_scenario_profile *plan = &scenario->profile;
    double period = 0;
    for (int g = 0; g < scenario->grip_count; ++g)
        period = fmax(period, period_of(&scenario->grips[g].motion.drive));
    for (int p = 0; p < scenario->phase_count; ++p)
        for (int d = 0; d < scenario->phases[p].drive_count; ++d)
            period = fmax(period, period_of(&scenario->phases[p].drives[d].motion.drive));
    const fw_solid *solid = fw_scene_observe_body(experiment->scene, 0);
    const double span =
        (double)(plan->until - plan->from) * solid->tick * solid->model->ticks_per_step;
    return period > 0 ? span / period : 1;
}

static void measure_friction(double *values, const fw_observer *observer)
{
    const fw_rubbing_sums *s = &observer->rubbing.sums;
    values[FW_LAYER_SLIP_PATH] = s->path_before;
    values[FW_LAYER_OFFSET] = fabs(s->slip / s->steps);
    values[FW_LAYER_FRICTION_FORCE] = s->force / s->steps;
    values[FW_LAYER_NORMAL_FORCE] = s->pressing / s->steps;
    values[FW_LAYER_LOOP_ENERGY] = s->work / cycles_of(observer->experiment);
    values[FW_LAYER_FRICTION_COEFFICIENT] = over(s->work, s->path * (s->pressing / s->steps));
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
    FW_TRY(measure_widths(values, observer, error));
    measure_friction(values, observer);
    return measure_steadiness(&values[FW_LAYER_UNSTEADINESS], observer->experiment, measurement,
                              error);
}

bool fw_layer_needs_control(int measure)
{
    return measure == FW_LAYER_CONTACT_OVER_CONTROL ||
           measure == FW_LAYER_BOND_BREAKING_OVER_CONTROL ||
           measure == FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL;
}

void fw_layer_compare(double values[FW_LAYER_MEASURES], const double control[FW_LAYER_MEASURES],
                      const fw_profile *profile)
{
    values[FW_LAYER_CONTACT_OVER_CONTROL] =
        over(values[FW_LAYER_CONTACT], control[FW_LAYER_CONTACT]);
    values[FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL] =
        over(values[FW_LAYER_RELATIVE_DISPLACEMENT], control[FW_LAYER_RELATIVE_DISPLACEMENT]);
    values[FW_LAYER_BOND_BREAKING_OVER_CONTROL] =
        over(values[FW_LAYER_BOND_BREAKING],
             fmax(control[FW_LAYER_BOND_BREAKING],
                  fw_profile_least_breaking(profile, FW_PROFILE_CONTACT)));
}
