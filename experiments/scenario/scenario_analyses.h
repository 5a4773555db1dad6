/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_analyses.h - what is computed without running, as plain data. */
#ifndef FW_SCENARIO_ANALYSES_H
#define FW_SCENARIO_ANALYSES_H

#include "core/vec2.h"
#include "experiments/scenario/scenario_automaton.h"
#include "experiments/schema/schema.h"

typedef enum fw_analysis_kind {
    FW_ANALYSIS_STABILITY_MAP,
    FW_ANALYSIS_DISPERSION,
    FW_ANALYSIS_PLANE_MODE,
    FW_ANALYSIS_BODY_STABILITY,
    FW_ANALYSIS_BOLTZMANN_REFERENCE
} fw_analysis_kind;

/* Members that its kind does not have are zero. */
typedef struct fw_scenario_analysis {
    const char *name;
    fw_place place;
    fw_analysis_kind kind;
    double c1[2], c2[2]; /* stability map: from, to; body stability: the first of each */
    int points[2];       /* of c1 and of c2, ends included */
    int64_t waves;       /* wave vectors along each side of the Brillouin zone */
    int material;        /* dispersion, plane mode: of kind FW_ELASTIC_AUTOMATON */
    int64_t size,
        steps; /* dispersion: of the periodic body that carries the waves, and of its run */
    fw_vec2 wave_vector; /* plane mode: radians per site */
    fw_automaton_edges boundary;
    int rectangle[2]; /* body stability: columns, rows */
    int body;         /* reference */
    int64_t ticks;    /* reference: half-steps of the automaton */
} fw_scenario_analysis;

#endif
