/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario.h - a scenario file as plain data: checked, with every default filled in.
 *
 * Everything is owned by the scenario and lives until it is destroyed; names and texts are never
 * NULL unless said so. Angles and phases are written in degrees and held here in radians. What can
 * only be judged later (an observable's name, a body that starts in a wall) keeps its fw_place, to
 * be reported with fw_scenario_fail. Each part has a header and a reader, scenario_PART.h and .c,
 * with its keys, ranges and defaults; the list of parts is in scenario.c: start there. */
#ifndef FW_SCENARIO_H
#define FW_SCENARIO_H

#include "experiments/scenario/scenario_analyses.h"
#include "experiments/scenario/scenario_bodies.h"
#include "experiments/scenario/scenario_contact.h"
#include "experiments/scenario/scenario_expect.h"
#include "experiments/scenario/scenario_forces.h"
#include "experiments/scenario/scenario_grips.h"
#include "experiments/scenario/scenario_materials.h"
#include "experiments/scenario/scenario_phases.h"
#include "experiments/scenario/scenario_pictures.h"
#include "experiments/scenario/scenario_run.h"
#include "experiments/scenario/scenario_study.h"
#include "experiments/scenario/scenario_walls.h"
#include "experiments/schema/schema.h"
#include "experiments/units/units.h"

/* The keys of a scenario: the root, from which the sections of all its parts can be reached. */
extern const fw_section fw_scenario_section;

typedef struct fw_scenario fw_scenario;

/* Under which heading `fretwork list` names it. */
typedef enum fw_scenario_group {
    FW_GROUP_OWN,
    FW_GROUP_START_HERE,
    FW_GROUP_LB_SOLID,
    FW_GROUP_ELASTIC_AUTOMATON,
    FW_GROUP_MOVABLE_PARTICLES,
    FW_GROUP_WALLS_AND_CONTACT,
    FW_GROUP_FRICTION,
    FW_GROUP_STUDIES,
    FW_GROUPS
} fw_scenario_group;

struct fw_scenario {
    fw_document *document; /* as run: after all --set options */
    const char *title;
    const char *source; /* NULL: none given */
    const char *about;  /* NULL: none given */
    const char *figure; /* NULL: none given */
    fw_scenario_group group;
    double takes;         /* measured seconds of a run; 0: unknown */
    fw_schema_name small; /* what stands for it where time is short; text NULL: nothing does */
    fw_units units;       /* what the reduced ones are in nature; may be none */
    int material_count;
    fw_scenario_material *materials;
    int body_count;
    fw_scenario_body *bodies;
    int wall_count;
    fw_scenario_wall *walls;
    int force_count;
    fw_scenario_force *forces;
    int grip_count;
    fw_scenario_grip *grips;
    int phase_count;
    fw_scenario_phase *phases; /* one after the other, from step 0 to the last */
    fw_scenario_profile profile;
    fw_scenario_study study;
    fw_scenario_dynamics dynamics;
    fw_scenario_run run;
    fw_scenario_contact contact;
    fw_scenario_record record;
    fw_schema_names measure; /* count 0: the standard set */
    int expectation_count;
    fw_expectation *expectations;
    int picture_count;
    fw_scenario_picture *pictures;
    int analysis_count;
    fw_scenario_analysis *analyses;
};

/* Reads a scenario; `file` is what sentences call it, NULL: nobody wrote it (document.h).
 * `settings` are the arguments of the --set options in order. On failure *scenario is NULL:
 * FW_BAD_INPUT with one sentence that begins with "FILE:LINE:COLUMN: " or "--set OPTION: ", or
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_scenario_read(fw_scenario **scenario, const char *file, const char *text,
                           size_t length, const char *const *settings, int setting_count,
                           fw_error *error);
/* The same for a file on disk. */
fw_status fw_scenario_load(fw_scenario **scenario, const char *path, const char *const *settings,
                           int setting_count, fw_error *error);
void fw_scenario_destroy(fw_scenario *scenario);

/* Are forces recorded, by its own wish or for a picture? */
bool fw_scenario_records_force(const fw_scenario *scenario);

/* Is it a sweep as a whole, which is not run itself but case by case? */
bool fw_scenario_is_sweep(const fw_scenario *scenario);
/* One case of a sweep: a scenario of its own, that says which case it is. Sentences about it begin
 * with the place of the sweep. */
fw_status fw_scenario_read_case(fw_scenario **made, const fw_scenario *sweep, int number,
                                fw_error *error);
/* "A=2.5", "A=2.5,p=1": what sentences and folders call the case. Returns its length, which is
 * below FW_CASE_NAME in a scenario that was read. */
enum { FW_CASE_NAME = 256 };
int fw_scenario_case_name(const fw_scenario *scenario, int number, char name[FW_CASE_NAME]);
/* FW_BAD_INPUT of a case: its sentence goes behind the place of the sweep. Returns the status, and
 * changes nothing of others. */
fw_status fw_scenario_fail_case(const fw_scenario *sweep, int number, fw_status status,
                                fw_error *error);

/* FW_BAD_INPUT with the sentence after the place where the fault was written. */
fw_status fw_scenario_fail(const fw_scenario *scenario, fw_place place, fw_error *error,
                           const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Puts the place in front of a sentence that was made without one. Only FW_BAD_INPUT has a place:
 * any other status changes nothing. Returns the status. */
fw_status fw_scenario_fail_again(const fw_scenario *scenario, fw_place place, fw_status status,
                                 fw_error *error);
/* The same with "format: " between the place and the sentence, as in "body a: ". */
fw_status fw_scenario_fail_within(const fw_scenario *scenario, fw_place place, fw_status status,
                                  fw_error *error, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* The scenario as run, as a text that reads back to the same scenario: *text is malloc'ed. */
fw_status fw_scenario_print(const fw_scenario *scenario, char **text, fw_error *error);

/* How many values of the observables are measured in the steps from <= step <= until. One is due at
 * multiples of run.measure-every, and at the end. */
int64_t fw_scenario_count_samples(const fw_scenario *scenario, int64_t from, int64_t until);

#endif
