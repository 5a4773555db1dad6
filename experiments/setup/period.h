/* SPDX-License-Identifier: GPL-3.0-or-later */
/* period.h - whether oscillating forces, paths and drives are slow enough for the time step. */
#ifndef FW_PERIOD_H
#define FW_PERIOD_H

#include "contact/scene/scene.h"
#include "experiments/scenario/scenario.h"

/* Forces and paths are evaluated once per step. */
#define FW_SHORTEST_PERIOD 4 /* steps */

/* FW_BAD_INPUT, at its place in the scenario, for the first oscillation of a wall, force, grip or
 * piston, at the start or in a phase, whose period is shorter than that. The scene must have its
 * bodies. */
fw_status fw_period_check(const fw_scenario *scenario, const fw_scene *scene, fw_error *error);

#endif
