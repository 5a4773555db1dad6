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

/* The study once for each of several values of a parameter; no values: once. */
typedef struct fw_scenario_sweep {
    fw_place place;
    fw_schema_name parameter; /* a name of the user's own */
    const char *unit;         /* NULL: none given */
    int value_count;
    double *values; /* all different */
    int setting_count;
    const char **settings; /* changes that make a case, as --set has them, with the parameter */
    bool is_case;          /* one value has been set already: */
    int number;            /* which */
} fw_scenario_sweep;

/* More runs of the same scenario. */
typedef struct fw_scenario_study {
    fw_scenario_sweep sweep;
    int64_t seeds; /* run.seed and the following ones */
    int control_count;
    const char **control; /* changes that make the control run, as --set has them */
    fw_place control_place;
} fw_scenario_study;

#endif
