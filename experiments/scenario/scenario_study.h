/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_study.h - profile, sweep and study as plain data. */
#ifndef FW_SCENARIO_STUDY_H
#define FW_SCENARIO_STUDY_H

#include "experiments/schema/schema.h"

enum { FW_SEEDS_MAX = 1024 };

/* What is averaged across the scene; no `every`: nothing is. */
typedef struct fw_scenario_profile {
    fw_place place;
    int axis;             /* 0: x, 1: y */
    fw_schema_name phase; /* text NULL: the whole run */
    int64_t from, until;  /* samples are taken after the steps from < step <= until */
    int64_t every;
    double bin, middle;
    double window[2]; /* of the other coordinate; low == high: all */
    double contact;   /* half width of the contact region */
    double far[2];    /* distances from the middle */
} fw_scenario_profile;

enum { FW_PARAMETERS_MAX = 8, FW_CASES_MAX = 10000 };

/* What is varied. */
typedef struct fw_scenario_parameter {
    const char *name; /* of the user's own, fit for formulas */
    fw_place place;
    const char *unit; /* NULL: none given */
} fw_scenario_parameter;

/* The study once for each of several points, a point being a value of each parameter; no
 * parameters: once. */
typedef struct fw_scenario_sweep {
    fw_place place;
    int parameter_count;
    fw_scenario_parameter *parameters;
    int case_count;
    double *values; /* [case_count][parameter_count], no two rows the same */
    int setting_count;
    const char **settings; /* changes that make a case, as --set has them, with formulas */
    bool is_case;          /* it is one of the cases, the only one that is known */
    double tolerance;      /* of a bisection, 0: there is none; ... */
    int bisected;          /* ... of this parameter, ... */
    bool logarithmic;      /* ... whose intervals are cut in two equal factors */
} fw_scenario_sweep;

/* Of a parameter in a case. */
static inline double fw_sweep_value(const fw_scenario_sweep *sweep, int number, int parameter)
{
    return sweep->values[(size_t)number * (size_t)sweep->parameter_count + (size_t)parameter];
}

/* More runs of the same scenario. */
typedef struct fw_scenario_study {
    fw_scenario_sweep sweep;
    int64_t seeds; /* run.seed and the following ones */
    bool keep;     /* trajectories of all seeds, not of the first alone */
    int control_count;
    const char **control; /* changes that make the control run, as --set has them */
    fw_place control_place;
} fw_scenario_study;

/* Does the case lie at that point, whose NaN stand for any value? */
bool fw_sweep_is_at(const fw_scenario_sweep *sweep, int number, const double *point);

#endif
