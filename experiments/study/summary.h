/* SPDX-License-Identifier: GPL-3.0-or-later */
/* summary.h - what was expected of a study and what each of its seeds showed, as a table in a file.
 */
#ifndef FW_SUMMARY_H
#define FW_SUMMARY_H

#include "experiments/measures/verdict.h"

#define FW_SUMMARY_FILE "summary.csv"

/* One row per expectation: quantity, expected, mean over the seeds, its standard error, verdict,
 * and the number of each seed. FW_SYSTEM_FAILED where the file cannot be written. */
fw_status fw_summary_write(const char *directory, const fw_scenario *scenario,
                           const fw_measurement *measurement, fw_error *error);
/* The verdicts again, of the same scenario. FW_BAD_INPUT: the file is not as it was written. */
fw_status fw_summary_read(const char *directory, const fw_scenario *scenario, fw_verdicts *verdicts,
                          fw_error *error);

/* What each seed showed: values[expectation_count][seeds], NaN where it has no number. As above. */
fw_status fw_summary_read_seeds(const char *directory, const fw_scenario *scenario, double *values,
                                fw_error *error);

#endif
