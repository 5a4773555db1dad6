/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analysis.h - what a scenario computes without running: arrays for the results file and pictures,
 * and a few numbers for expectations. They follow from the scenario alone. */
#ifndef FW_ANALYSIS_H
#define FW_ANALYSIS_H

#include "experiments/scenario/scenario.h"
#include "experiments/storage/table.h"

enum { FW_ANALYSIS_TABLES_MAX = 6 };

typedef struct fw_analysis {
    const fw_scenario_analysis *what; /* observed */
    int table_count;
    fw_table tables[FW_ANALYSIS_TABLES_MAX]; /* values owned */
    /* Those of its kind. */
    struct {
        double excess;   /* inside the disc: largest singular value of H(k), minus 2 */
        double least;    /* outside: smallest growth factor */
        double greatest; /* largest growth factor anywhere */
        double error;    /* outside: largest distance of a factor from that of (pi/2, pi/2) */
    } map;
    double frequency_error; /* dispersion: largest distance of simulated from closed form */
    struct {
        double speed[2]; /* slow, fast */
        fw_vec2 polarisation[2];
    } mode;
    double spectral_radius;
    double reference_error; /* largest distance of a cell from its reference, in x or y */
} fw_analysis;

/* FW_BAD_INPUT at the place of the analysis. */
fw_status fw_analysis_create(fw_analysis **analysis, const fw_scenario *scenario, int number,
                             fw_error *error);
void fw_analysis_destroy(fw_analysis *analysis);

/* The key of a kind in scenario files: "stability-map". */
const char *fw_analysis_kind_name(fw_analysis_kind kind);

/* The table of that name; NULL: there is none. */
const fw_table *fw_analysis_find(const fw_analysis *analysis, const char *name);

#endif
