/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_expect.h - what must come out, as plain data. */
#ifndef FW_SCENARIO_EXPECT_H
#define FW_SCENARIO_EXPECT_H

#include "core/lattice.h"
#include "experiments/schema/schema.h"

typedef enum fw_statistic {
    FW_STATISTIC_LAST,
    FW_STATISTIC_FIRST,
    FW_STATISTIC_MAXIMUM,
    FW_STATISTIC_MINIMUM,
    FW_STATISTIC_LARGEST, /* in magnitude */
    FW_STATISTIC_MEAN,
    FW_STATISTIC_SPREAD, /* standard deviation */
    FW_STATISTIC_CHANGE, /* last minus first */
    FW_STATISTIC_RATE,   /* least-squares slope against time */
    FW_STATISTIC_TIME_OF_MAXIMUM,
    FW_STATISTIC_TIME_OF_MINIMUM
} fw_statistic;

typedef enum fw_verdict_kind {
    FW_VERDICT_VALUE,
    FW_VERDICT_RELATIVE,
    FW_VERDICT_BOUNDS,
    FW_VERDICT_RISES, /* from each value of a sweep to the next */
    FW_VERDICT_FALLS
} fw_verdict_kind;

typedef struct fw_expectation {
    fw_place place;
    fw_schema_name quantity; /* an observable */
    fw_schema_name body;     /* text NULL: the whole scene, or the only body */
    int body_index;          /* -1: none given */
    fw_schema_name wall;
    int wall_index; /* -1: none given */
    fw_schema_name grip;
    int grip_index; /* -1: none given */
    fw_schema_name analysis;
    int analysis_index; /* -1: none given */
    bool has_site;      /* of that body; checked */
    fw_site site;
    fw_schema_name component; /* "x", "y", "xx", ...; text NULL: none given */
    bool has_at;
    int64_t at;             /* in that step */
    fw_statistic statistic; /* otherwise this of the series ... */
    int64_t from, until;    /* ... over the steps from <= step <= until */
    fw_schema_name phase;   /* that gives these; text NULL: none given */
    const double *when;     /* [parameters of the sweep] where it speaks, NaN: any; NULL: all */
    fw_verdict_kind kind;
    bool has_level; /* where along a sweep it crosses that is expected */
    double level;
    int along;            /* parameter of a trend or crossing */
    double value, within; /* within: absolute, or relative to |value| */
    bool has_below, has_above;
    double below, above;
    const char *source; /* NULL: none given */
    const char *note;   /* NULL: none given */
} fw_expectation;

static inline bool fw_expectation_is_trend(const fw_expectation *expectation)
{
    return expectation->kind == FW_VERDICT_RISES || expectation->kind == FW_VERDICT_FALLS;
}

/* It speaks of all cases of a sweep together, and asks nothing of a single one. */
static inline bool fw_expectation_is_of_sweep(const fw_expectation *expectation)
{
    return fw_expectation_is_trend(expectation) || expectation->has_level;
}

#endif
