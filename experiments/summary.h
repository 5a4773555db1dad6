/* SPDX-License-Identifier: GPL-3.0-or-later */
/* summary.h - what was expected of a study and what each of its seeds showed, as a table in a file.
 */
#ifndef FW_SUMMARY_H
#define FW_SUMMARY_H

#include "experiments/measurement.h"

#define FW_SUMMARY_FILE "summary.csv"

/* One row per expectation that each seed answers by itself: quantity, expected, mean over the
 * seeds, its standard error, verdict, and the number of each seed. FW_SYSTEM_FAILED where the file
 * cannot be written. */
fw_status fw_summary_write(const char *path, const fw_scenario *scenario,
                           const fw_measurement *measurement, fw_error *error);

#endif
