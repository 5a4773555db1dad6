/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_parts.h - how the parts of a checked document become the parts of a scenario; for the
 * files scenario*.c alone. Each returns FW_BAD_INPUT with a sentence for what the schema, which
 * looks at one key at a time, could not see. */
#ifndef FW_SCENARIO_PARTS_H
#define FW_SCENARIO_PARTS_H

#include "experiments/scenario/scenario.h"
#include "experiments/schema/constants.h"
#include "experiments/schema/schema.h"

/* --- keys --- */

extern const fw_section fw_material_section;
extern const fw_section fw_body_section;
extern const fw_section fw_shape_section;
extern const fw_section fw_pattern_section;
extern const fw_section fw_mass_change_section;
extern const fw_section fw_stiffness_change_section;
extern const fw_section fw_selection_section;
extern const fw_section fw_wall_section;
extern const fw_section fw_path_section;
extern const fw_section fw_force_section;
extern const fw_section fw_grip_section;
extern const fw_section fw_phase_section;
extern const fw_section fw_profile_section;
extern const fw_section fw_study_section;
extern const fw_section fw_sweep_section;
extern const fw_section fw_parameter_section;
extern const fw_section fw_dynamics_section;
extern const fw_section fw_run_section;
extern const fw_section fw_contact_section;
extern const fw_section fw_friction_section;
extern const fw_section fw_record_section;
extern const fw_section fw_expectation_section;
extern const fw_section fw_picture_section;
extern const fw_section fw_analysis_section;

/* A key whose value is a selection of a body's sites: see fw_scenario_read_selection. */
#define SELECTION                                                                                  \
    .forms = FW_FORM_SELECTION, .items = FW_FORM_INTEGERS, .layout = "[i, j]", .least = 1,         \
    WORDS({"all", 0}, {"left", 0}, {"right", 0}, {"bottom", 0}, {"top", 0}),                       \
    .subsection = &fw_selection_section

/* The keys of what moves a grip or piston: `needed` goes with those of an oscillation, WITHOUT
 * makes of the default's meaning what a phase, or the grip or piston itself, has. `object` has a
 * fw_scenario_drive called `motion`; what is read with them: fw_scenario_read_drive. */
#define ITSELF(meaning)       meaning
#define AS_BY_ITSELF(meaning) "its own"
#define DRIVE_KEYS(object, needed, WITHOUT)                                                        \
    {"force",                                                                                      \
     AT_VEC2(object, motion.drive.force),                                                          \
     .layout = "[x, y]",                                                                           \
     .default_value = "[0, 0]",                                                                    \
     .default_meaning = WITHOUT(NULL),                                                             \
     .unit = "force",                                                                              \
     .meaning = "on the whole of it, constant"},                                                   \
        {"amplitude",                                                                              \
         AT_VEC2(object, motion.drive.amplitude),                                                  \
         .layout = "[x, y]",                                                                       \
         .needs = needed,                                                                          \
         .default_value = "[0, 0]",                                                                \
         .default_meaning = WITHOUT(NULL),                                                         \
         .unit = "force",                                                                          \
         .meaning = "on top of it, times sin(360 t / period + phase)"},                            \
        {"period",       AT_NUMBER(object, motion.drive.period),                                   \
         ABOVE_ZERO,     .default_meaning = WITHOUT("no oscillation"),                             \
         .unit = "time", .meaning = "of the oscillation"},                                         \
        {"phase",                                                                                  \
         AT_ANGLE(object, motion.drive.phase),                                                     \
         .needs = needed,                                                                          \
         FROM_TO(-360, 360),                                                                       \
         .default_value = "0",                                                                     \
         .default_meaning = WITHOUT(NULL),                                                         \
         .unit = "degrees",                                                                        \
         .meaning = "of the oscillation at its time 0"},                                           \
        {"time-from", AT_NAME(object, motion.time_from), .default_meaning = WITHOUT("the run"),    \
         .meaning = "phase whose beginning is time 0 of the oscillation and of `path`, however "   \
                    "early or late"},                                                              \
        {"tether",                                                                                 \
         AT_VEC2(object, motion.drive.tether),                                                     \
         .layout = "[x, y]",                                                                       \
         AT_LEAST(0),                                                                              \
         .default_value = "[0, 0]",                                                                \
         .default_meaning = WITHOUT(NULL),                                                         \
         .unit = "force/length",                                                                   \
         .meaning = "a spring to where it began, per component"},                                  \
        {"hold",                                                                                   \
         AT_WORD(object, motion.hold),                                                             \
         WORDS({"none", FW_HOLD_NONE}, {"x", FW_HOLD_X}, {"y", FW_HOLD_Y},                         \
               {"both", FW_HOLD_BOTH}),                                                            \
         .default_value = "none",                                                                  \
         .default_meaning = WITHOUT(NULL),                                                         \
         .meaning = "components that follow the path whatever force it takes, or stay at rest "    \
                    "without one"},                                                                \
    {                                                                                              \
        "path", AT_OBJECT(object, motion.drive.path),                                              \
            .subsection = &fw_path_section, .default_meaning = WITHOUT("at rest"),                 \
            .meaning = "of the components that `hold` names"                                       \
    }

extern const fw_section fw_points_file_section;

/* --- readers --- */

/* Puts the places of particles in place of the files that shapes name; after the keys were
 * checked. */
fw_status fw_scenario_take_files(fw_scenario *scenario, fw_error *error);
/* Of a list [[x, y], ...]: count, points, low and high. */
fw_status fw_scenario_read_points(const fw_scenario *scenario, const fw_node *list,
                                  fw_scenario_body *body, fw_error *error);

fw_status fw_scenario_read_materials(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_bodies(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_walls(fw_scenario *scenario, fw_error *error);
/* Surfaces of bodies and walls, and their pairs; after both. */
fw_status fw_scenario_read_contact(fw_scenario *scenario, fw_error *error);
/* Is there friction between any two surfaces, whether bodies have them or walls? */
bool fw_scenario_bodies_rub(const fw_scenario *scenario);
/* A number, or a mapping with the static and the kinetic one; NULL: none. */
fw_status fw_scenario_read_friction(const fw_scenario *scenario, const fw_node *node,
                                    fw_friction *friction, fw_error *error);
fw_status fw_scenario_read_forces(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_grips(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_phases(fw_scenario *scenario, fw_error *error);
/* Profile and study; after the phases. */
fw_status fw_scenario_read_study(fw_scenario *scenario, fw_error *error);
/* The sweep, and the settings of the case that the scenario is: before everything else. */
fw_status fw_scenario_read_sweep(fw_scenario *scenario, fw_error *error);
/* The named numbers under `parameters`, at most FW_CONSTANTS_MAX; returns how many. */
int fw_scenario_constants(const fw_scenario *scenario, fw_variable *variables);
/* Does anything but other constants depend on it, by itself or through these? */
bool fw_scenario_needs_constant(const fw_scenario *scenario, const char *name);
/* FW_BAD_INPUT: a --set option gives one on which nothing depends. */
fw_status fw_scenario_check_constants(const fw_scenario *scenario, fw_error *error);
/* Parameters and cases of the sweep that is written there; `is_known`: it is a case that needs no
 * values, and has none but what `case` says. */
fw_status fw_scenario_read_parameters(fw_scenario *scenario, const fw_node *sweep_node,
                                      bool is_known, fw_error *error);
/* A number, or names with a number each, into point[parameter_count]: NaN where no value is given.
 * `whole`: each must be. */
fw_status fw_scenario_read_point(const fw_scenario *scenario, const fw_node *node, bool whole,
                                 double *point, fw_error *error);
/* Number of the parameter of that name. */
fw_status fw_scenario_find_parameter(const fw_scenario *scenario, const fw_node *name, int *number,
                                     fw_error *error);
/* FW_BAD_INPUT where no case lies at that point. */
fw_status fw_scenario_check_point(const fw_scenario *scenario, const fw_node *node,
                                  const double *point, fw_error *error);
/* Index of the phase of that name. */
fw_status fw_scenario_find_phase(const fw_scenario *scenario, const fw_node *name, int *phase,
                                 fw_error *error);
fw_status fw_scenario_read_expectations(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_pictures(fw_scenario *scenario, fw_error *error);

/* What the models have to say of the bodies together. */
fw_status fw_scenario_check_materials(const fw_scenario *scenario, fw_error *error);
/* The run, its defaults filled in. */
fw_status fw_scenario_complete_run(fw_scenario *scenario, fw_error *error);
/* That there are bodies which `dynamics` moves, and phases change only theirs. */
fw_status fw_scenario_check_dynamics(fw_scenario *scenario, fw_error *error);
fw_status fw_scenario_read_analyses(fw_scenario *scenario, fw_error *error);

/* Shape of a body from the mapping under its key `shape`. */
fw_status fw_scenario_read_shape(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_body *body, fw_error *error);
/* A drive whose keys have been filled in: what they mean together. `written` has the keys that
 * stand at this place, `whole` also those that it has from elsewhere: a sentence is about what is
 * written. `kind` is what is driven, "grip". */
fw_status fw_scenario_read_drive(const fw_scenario *scenario, const fw_node *written,
                                 const fw_node *whole, const char *kind, const char *name,
                                 fw_scenario_drive *motion, fw_error *error);
/* Selection under the key `sites` of `owner`, or all sites where there is none. */
fw_status fw_scenario_read_selection(const fw_scenario *scenario, const fw_node *owner,
                                     const fw_scenario_body *body, fw_selection *selection,
                                     fw_error *error);
/* Values of single sites; NULL: none. */
fw_status fw_scenario_read_patterns(fw_scenario *scenario, const fw_node *list,
                                    const fw_scenario_body *body, fw_patterns *patterns,
                                    fw_error *error);
/* The same for other masses or stiffnesses, the section says which. */
fw_status fw_scenario_read_replacements(fw_scenario *scenario, const fw_node *list,
                                        const fw_section *section, const fw_scenario_body *body,
                                        fw_replacements *replacements, fw_error *error);
/* Has the body a site in that row from column `first` to `last`? */
bool fw_scenario_meets_row(const fw_scenario_body *body, int row, int first, int last);
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

/* A pair [i, j]. */
static inline fw_site fw_scenario_read_site(const fw_node *pair)
{
    return (fw_site){(int)fw_node_integer(pair->first), (int)fw_node_integer(pair->last)};
}

#endif
