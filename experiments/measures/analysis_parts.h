/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analysis_parts.h - the computations behind analysis.c, one file each or two; for the files
 * analysis*.c alone. */
#ifndef FW_ANALYSIS_PARTS_H
#define FW_ANALYSIS_PARTS_H

#include "experiments/measures/analysis.h"

/* Room for one more table of the analysis; columns 0: of rank 1. NULL, with its sentence, without
 * memory. */
double *fw_analysis_add(fw_analysis *analysis, const char *name, const char *unit,
                        const char *meaning, int rows, int columns, fw_error *error);

fw_status fw_analysis_map(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error);
fw_status fw_analysis_dispersion(fw_analysis *analysis, const fw_scenario *scenario,
                                 fw_error *error);
fw_status fw_analysis_mode(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error);
fw_status fw_analysis_body(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error);
fw_status fw_analysis_reference(fw_analysis *analysis, const fw_scenario *scenario,
                                fw_error *error);

#endif
