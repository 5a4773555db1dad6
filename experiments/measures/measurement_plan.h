/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement_plan.h - the probes that a scenario needs. */
#ifndef FW_MEASUREMENT_PLAN_H
#define FW_MEASUREMENT_PLAN_H

#include "experiments/measures/measurement.h"

/* Fills probes, width, expected and component; the last two have room for every expectation. Fails
 * as fw_measurement_create does. */
fw_status fw_measurement_plan(fw_measurement *measurement, const fw_observer *observer,
                              fw_error *error);

/* Adds to probes and width what one name stands for, "elongation", "elongation.chain" or either
 * with a component behind it: whole quantities, of all that they can be measured of where none is
 * named. Fails as fw_measurement_create does; where nothing can be measured, nothing is added. */
fw_status fw_measurement_plan_named(fw_measurement *measurement, const fw_observer *observer,
                                    fw_schema_name name, fw_error *error);

#endif
