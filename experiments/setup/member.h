/* SPDX-License-Identifier: GPL-3.0-or-later */
/* member.h - energy, momentum, mass and centre of a body of the scenario, whether it has a solid to
 * itself or shares one, as movable particles do. */
#ifndef FW_MEMBER_H
#define FW_MEMBER_H

#include "experiments/setup/experiment.h"

fw_energies fw_member_energies(const fw_experiment *experiment, int member);
fw_vec2 fw_member_momentum(const fw_experiment *experiment, int member);
fw_sym2 fw_member_mass(const fw_experiment *experiment, int member);
fw_vec2 fw_member_centre_of_mass(const fw_experiment *experiment, int member);
/* Its group among the movable particles of its solid; -1: it is of another model. */
int fw_member_group(const fw_experiment *experiment, int member);

#endif
