/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_parts.h - how the parts of a checked document become the parts of a scenario; for the
 * files scenario*.c alone. Each returns FW_BAD_INPUT with a sentence for what the schema, which
 * looks at one key at a time, could not see. */
#ifndef FW_SCENARIO_PARTS_H
#define FW_SCENARIO_PARTS_H

#include "experiments/scenario/scenario.h"
#include "experiments/scenario/schema.h"

fw_status fw_scenario_read_materials(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_bodies(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_walls(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_forces(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_grips(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_phases(fw_scenario *scenario, fw_error *error);
/* Profile and study; after the phases. */
fw_status fw_scenario_read_study(fw_scenario *scenario, fw_error *error);
/* The sweep, and the settings of the case that the scenario is: before everything else. */
fw_status fw_scenario_read_sweep(fw_scenario *scenario, fw_error *error);
/* Number of the value of the sweep that is written there, which must be one. */
fw_status fw_scenario_find_value(const fw_scenario *scenario, const fw_node *node, int *number,
                                 fw_error *error);
/* Index of the phase of that name. */
fw_status fw_scenario_find_phase(const fw_scenario *scenario, const fw_node *name, int *phase,
                                 fw_error *error);
fw_status fw_scenario_read_expectations(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_pictures(fw_scenario *scenario, fw_error *error);

/* What belongs together in a material of movable particles, from the mapping with its keys. */
fw_status fw_scenario_read_particles(const fw_scenario *scenario, const fw_node *node,
                                     fw_scenario_particles *particles, fw_error *error);
/* Dynamics, and that bodies that share it go together. */
fw_status fw_scenario_check_dynamics(fw_scenario *scenario, fw_error *error);
/* A random placement from the mapping under `placed`. */
fw_status fw_scenario_read_placed(const fw_scenario *scenario, const fw_node *node,
                                  fw_scenario_body *body, fw_error *error);
fw_status fw_scenario_read_analyses(fw_scenario *scenario, fw_error *error);

/* The rest of a material from the mapping under its key `elastic-automaton`: speeds, checked. */
fw_status fw_scenario_read_automaton(const fw_scenario *scenario, const fw_node *node,
                                     fw_scenario_automaton *material, fw_error *error);
/* What the schema could not see about an automaton's body, once all of it is read. */
fw_status fw_scenario_check_automaton(const fw_scenario *scenario, const fw_node *node,
                                      const fw_scenario_body *body, fw_error *error);

/* That all bodies move in half-steps, or none does. */
fw_status fw_scenario_check_clock(const fw_scenario *scenario, fw_error *error);

/* Shape of a body from the mapping under its key `shape`. */
fw_status fw_scenario_read_shape(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_body *body, fw_error *error);
/* A drive whose keys have been filled in: what `hold` and `path` mean together. `kind` is what is
 * driven, "grip". */
fw_status fw_scenario_read_drive(const fw_scenario *scenario, const fw_node *node, const char *kind,
                                 const char *name, fw_scenario_drive *motion, fw_error *error);
/* Selection under the key `sites` of `owner`, or all sites where there is none. */
fw_status fw_scenario_read_selection(const fw_scenario *scenario, const fw_node *owner,
                                     const fw_scenario_body *body, fw_selection *selection,
                                     fw_error *error);
/* Is it a site of the body? Looks at the shape only. */
bool fw_scenario_has_site(const fw_scenario_body *body, fw_site site);

/* The child of the root, or NULL; and how many children that has. */
const fw_node *fw_scenario_part(const fw_scenario *scenario, const char *key, int *count);
/* Room for `count` objects of a part, as long as the scenario. */
fw_status fw_scenario_allocate(const fw_scenario *scenario, size_t count, size_t size, void *room,
                               fw_error *error);

/* Index of the child of that name in `named`, which is the part called `kind` ("material"); NULL:
 * there are none. FW_BAD_INPUT with the name that may have been meant. */
fw_status fw_scenario_find(const fw_scenario *scenario, const fw_node *named, const char *kind,
                           const fw_node *name, int *index, fw_error *error);

#endif
