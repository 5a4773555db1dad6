/* SPDX-License-Identifier: GPL-3.0-or-later */
/* layer.h - what the profile and the series of one run say about the layer where two bodies rub. */
#ifndef FW_LAYER_H
#define FW_LAYER_H

#include "experiments/measures/measurement.h"

/* In the order of fw_layer_quantities, which has names, units and meanings. */
typedef enum fw_layer_measure {
    FW_LAYER_CONTACT,
    FW_LAYER_FAR,
    FW_LAYER_CONTACT_OVER_FAR,
    FW_LAYER_PEAK_OVER_FAR,
    FW_LAYER_CONTACT_OVER_CONTROL,
    FW_LAYER_BOND_BREAKING,
    FW_LAYER_BOND_BREAKING_FAR,
    FW_LAYER_BOND_BREAKING_OVER_FAR,
    FW_LAYER_BOND_BREAKING_OVER_CONTROL,
    FW_LAYER_RELATIVE_DISPLACEMENT,
    FW_LAYER_RELATIVE_DISPLACEMENT_FAR,
    FW_LAYER_RELATIVE_DISPLACEMENT_OVER_FAR,
    FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL,
    FW_LAYER_DIFFUSIVITY,
    FW_LAYER_DIFFUSIVITY_FAR,
    FW_LAYER_WIDTH_ORDER,
    FW_LAYER_WIDTH_HALF,
    FW_LAYER_WIDTH_DOUBLE,
    FW_LAYER_TEMPERATURE,
    FW_LAYER_SLIP_PATH,
    FW_LAYER_OFFSET,
    FW_LAYER_FRICTION_FORCE,
    FW_LAYER_NORMAL_FORCE,
    FW_LAYER_FRICTION_COEFFICIENT,
    FW_LAYER_LOOP_ENERGY,
    FW_LAYER_UNSTEADINESS,
    FW_LAYER_VELOCITY_BELOW,
    FW_LAYER_VELOCITY_ABOVE,
    FW_LAYER_MEASURES
} fw_layer_measure;

/* Of one run; those over its control are NaN until fw_layer_compare. FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_layer_of(double values[FW_LAYER_MEASURES], const fw_observer *observer,
                      const fw_measurement *measurement, fw_error *error);

/* Is it measured against the control? */
bool fw_layer_needs_control(int measure);

/* The length, within low .. high, on which the straight lines between values at ascending places
 * are above the level (sign 1) or below it (sign -1). Values that are NaN are passed over. */
double fw_layer_width(const double *places, const double *values, int count, double level,
                      double sign, double low, double high);

/* Fills in what is over the control of the same seed. */
void fw_layer_compare(double values[FW_LAYER_MEASURES], const double control[FW_LAYER_MEASURES],
                      const fw_profile *profile);

#endif
