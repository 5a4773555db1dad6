/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement.h - time series of everything that a scenario measures, in memory.
 * What is measured: the quantities of `measure` (or a standard set), and whatever expectations and
 * pictures speak of. Each once. */
#ifndef FW_MEASUREMENT_H
#define FW_MEASUREMENT_H

#include "experiments/measures/quantity.h"

/* One quantity of one subject. */
typedef struct fw_probe {
    const fw_quantity *quantity;
    fw_subject subject;
    char label[192]; /* "energy", "elongation.chain", "position.sheet[0,3]", "reaction.floor" */
    int first;       /* its first component in a row of values */
    int components;
} fw_probe;

/* A number of a study: means over the seeds and their errors, of the experiment and of its control.
 * Errors of a single seed, and the control where there is none, are NaN. */
typedef struct fw_outcome {
    double mean, error, control, control_error;
} fw_outcome;

typedef struct fw_measurement {
    int probe_count;
    fw_probe *probes;
    int width; /* components of all probes together */
    int64_t capacity, count;
    int64_t *steps;
    double *times;
    double *values; /* count rows of `width` */
    int *expected;  /* per expectation: its probe, or -1: it comes out of the study ... */
    int *component; /* ... and component, or number of the layer's measure */
    const fw_outcome *outcome;      /* of the study, by fw_layer_measure; NULL before its end */
    const double *outcome_of_seeds; /* the same numbers of each seed, one seed after the other */
    /* Of all seeds of the study, itself the first. NULL before its end, and of a single run. */
    const struct fw_measurement *const *seeds;
    int seed_count;
} fw_measurement;

/* Resolves all names. FW_BAD_INPUT at the place of a name that means nothing, or of an expectation
 * at a step that is not measured. */
fw_status fw_measurement_create(fw_measurement **measurement, const fw_observer *observer,
                                fw_error *error);
void fw_measurement_destroy(fw_measurement *measurement);

/* Is a row due after that many steps? The start and the end always are. */
bool fw_measurement_is_due(const fw_scenario *scenario, int64_t step);
/* How many rows a whole run takes. */
int64_t fw_measurement_row_count(const fw_scenario *scenario);

/* Does a row look at positions inside of bodies? */
bool fw_measurement_needs_positions(const fw_measurement *measurement);

/* Measures one row; returns it (width numbers). */
const double *fw_measurement_take(fw_measurement *measurement, const fw_experiment *experiment);
/* Measures what is so called, at present and apart from the series: "energy", "energy.sheet",
 * "momentum.sheet.x"; out takes FW_COMPONENTS_MAX numbers, *count says how many there are. What is
 * measured of several things must name one. FW_BAD_INPUT with a sentence where it means nothing. */
fw_status fw_measurement_look(const fw_observer *observer, const char *name, double *out,
                              int *count, fw_error *error);
/* Puts back a row that was measured before a restart. */
void fw_measurement_restore(fw_measurement *measurement, int64_t step, double time,
                            const double *row);

#endif
