/* SPDX-License-Identifier: GPL-3.0-or-later */
/* file_plan.h - what the results file of an experiment will hold. */
#ifndef FW_FILE_PLAN_H
#define FW_FILE_PLAN_H

#include "experiments/measures/measurement.h"
#include "experiments/results/trajectory.h"

typedef struct fw_file_plan {
    fw_trajectory_def def; /* it points into what follows */
    const fw_observer *observer;
    const fw_experiment *experiment; /* of the observer */
    const fw_measurement *measurement;
    /* Owned. */
    char *directory, *scenario, *forms;
    fw_trajectory_body *bodies;
    double **masses; /* per body */
    int (**links)[2];
    fw_trajectory_field *fields;
    fw_observable *observables;
    fw_trajectory_array *arrays;
    fw_table_group *groups;
} fw_file_plan;

/* Observer and measurement are observed. To be cleared also after a failure: FW_SYSTEM_FAILED
 * without memory, FW_BAD_INPUT where a field is wanted that no body has. */
fw_status fw_file_plan_make(fw_file_plan *plan, const fw_observer *observer,
                            const fw_measurement *measurement, const char *directory, int threads,
                            fw_error *error);
/* One that is all zero may be cleared. */
void fw_file_plan_clear(fw_file_plan *plan);

#endif
