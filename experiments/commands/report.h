/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report.h - what comes after the last step: the table of verdicts, where everything lies, and the
 * pictures. */
#ifndef FW_REPORT_H
#define FW_REPORT_H

#include "experiments/measures/verdict.h"
#include "experiments/study/sweep.h"
#include "experiments/text/json.h"

/* What one of each unit is in nature, on one line; for a scenario that has units. */
void fw_report_units(FILE *out, const fw_scenario *scenario);
/* A line of a run's certificate; none where it says nothing. */
void fw_report_certificate(FILE *out, const fw_certificate *certificate);
/* The numbers of what applies, as member `certificate` of an object. */
void fw_report_certificate_as_json(fw_json *json, const fw_certificate *certificate);
/* `certificate` and `warnings` may be NULL. FW_EXPECTATION_FAILED where one did not hold. */
fw_status fw_report_result(const fw_scenario *scenario, const fw_verdicts *verdicts,
                           const fw_certificate *certificate, const char *warnings,
                           const char *directory, bool no_plot, fw_error *error);
/* Runs the sweep to its end and reports it, as far as no other process is at work on it. */
fw_status fw_report_sweep(fw_sweep *sweep, const fw_scenario *scenario, const char *directory,
                          bool no_plot, fw_error *error);
/* The same of a sweep whose cases were all run. */
fw_status fw_report_collected(fw_sweep *sweep, const fw_scenario *scenario, const char *directory,
                              bool no_plot, fw_error *error);

#endif
