/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_parts.h - the parts of a report, as JSON; for the files report_*.c alone. */
#ifndef FW_REPORT_PARTS_H
#define FW_REPORT_PARTS_H

#include "experiments/text/json.h"
#include "plot_parts.h"

/* Bytes as a text of letters (base64.h). FW_SYSTEM_FAILED without memory. */
fw_status fw_report_bytes(fw_json *json, const char *key, const void *bytes, size_t count,
                          fw_error *error);

/* The motion of a result in about `budget` bytes, into the object that is open: of long or large
 * results every so many frames and particles. Places are those of a grid of 65535 x 65535 points
 * over all of it, fields have 255 values. *kept: the part of all places that is in it. */
fw_status fw_report_motion(fw_json *json, const fw_plot_result *result, size_t budget, double *kept,
                           fw_error *error);

/* Everything else about a run: what was asked, measured, expected, found, and where it comes from.
 */
fw_status fw_report_facts(fw_json *json, const fw_plot_result *result,
                          void (*cite)(FILE *out, const fw_scenario *scenario), fw_error *error);

/* The pictures of a result, or of a sweep, as a list of {title, image}. */
fw_status fw_report_pictures(fw_json *json, const char *directory, const fw_scenario *scenario,
                             fw_error *error);

/* The table of a sweep. */
fw_status fw_report_table(fw_json *json, const char *directory, const fw_scenario *scenario,
                          fw_error *error);

#endif
