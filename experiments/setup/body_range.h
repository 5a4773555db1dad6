/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_range.h - energy, momentum, mass and centre of a body of the scenario, whether it has a
 * solid to itself or shares one, as movable particles do. */
#ifndef FW_BODY_RANGE_H
#define FW_BODY_RANGE_H

#include "experiments/setup/experiment.h"

fw_energies fw_body_range_energies(const fw_experiment *experiment, int body);
fw_vec2 fw_body_range_momentum(const fw_experiment *experiment, int body);
fw_sym2 fw_body_range_mass(const fw_experiment *experiment, int body);
fw_vec2 fw_body_range_centre_of_mass(const fw_experiment *experiment, int body);
/* Its group among the movable particles of its solid; -1: it is of another model. */
int fw_body_range_group(const fw_experiment *experiment, int body);

#endif
