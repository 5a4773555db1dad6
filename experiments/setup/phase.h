/* SPDX-License-Identifier: GPL-3.0-or-later */
/* phase.h - grips, and the phases of a run that change what drives them and the heat bath.
 * Which phase holds follows from the step alone: it is no part of the state. */
#ifndef FW_PHASE_H
#define FW_PHASE_H

#include "experiments/scenario/scenario.h"
#include "experiments/setup/body_range.h"

/* Adds the scenario's grips to the scene, each with its own drive; `ranges` has one for each body.
 * FW_BAD_INPUT at the place of a grip that holds nothing, or a particle that another one holds. */
fw_status fw_grips_add(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *ranges,
                       fw_error *error);

/* FW_BAD_INPUT where a phase has a bath too hot for the time step. */
fw_status fw_phases_check(const fw_scenario *scenario, const fw_scene *scene, fw_error *error);

/* The time at which a phase begins. */
double fw_phase_time(const fw_scenario *scenario, const fw_scene *scene, int phase);
/* What drives a grip, or the wall that is a piston, in that phase: of its own, or the phase's. */
fw_drive fw_phase_grip(const fw_scenario *scenario, const fw_scene *scene, int phase, int grip);
fw_drive fw_phase_piston_drive(const fw_scenario *scenario, const fw_scene *scene, int phase,
                               int wall);

/* Gives the scene the parameters of the phase that the next step belongs to. *current: the one that
 * it has, -1: none yet. */
fw_status fw_phase_enter(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *ranges,
                         int *current, fw_error *error);

#endif
