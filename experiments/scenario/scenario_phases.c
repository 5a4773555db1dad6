/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_phases.c - phases of a scenario. Keeps no state. Start reading at
 * fw_scenario_read_phases(). */
#include "scenario_parts.h"

#include <string.h>

static const fw_key phase_grip_keys[] = {DRIVE_KEYS(fw_phase_drive, NULL, AS_BY_ITSELF),
                                         {.name = NULL}};

static const fw_section fw_phase_grip_section = {
    "`phases.NAME.grips.NAME`", "the drive of a grip in a phase",
    "Changes the grip's own drive during the phase. What is not written here is as in "
    "`grips.NAME`, "
    "not as in the phase before; `path` is changed as a whole.",
    .keys = phase_grip_keys};

static const fw_key phase_piston_keys[] = {{"damping", AT_NUMBER(fw_phase_piston, damping),
                                            AT_LEAST(0), .default_meaning = "the piston's own",
                                            .unit = "1/time",
                                            .meaning = "rate at which its velocity decays"},
                                           DRIVE_KEYS(fw_phase_piston, NULL, AS_BY_ITSELF),
                                           {.name = NULL}};

static const fw_section fw_phase_piston_section = {
    "`phases.NAME.pistons.NAME`", "the drive of a piston in a phase",
    "Changes the piston's own drive during the phase. What is not written here is as in "
    "`walls.NAME.piston`, not as in the phase before; `path` is changed as a whole.",
    .keys = phase_piston_keys};

static const fw_key phase_keys[] = {
    {"until", AT_INTEGER(fw_scenario_phase, until), REQUIRED, AT_LEAST(1), .unit = "steps",
     .meaning = "the step that ends it"},
    {"damping", AT_NUMBER(fw_scenario_phase, damping), AT_LEAST(0),
     .default_meaning = "that of `dynamics`", .unit = "1/time", .meaning = "of movable particles"},
    {"temperature", AT_NUMBER(fw_scenario_phase, temperature), AT_LEAST(0),
     .default_meaning = "that of `dynamics`", .unit = "energy", .meaning = "of movable particles"},
    {"grips", FW_FORM_NAMED, .subsection = &fw_phase_grip_section, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "each as driven by itself", .meaning = "other drives, by name of the grip"},
    {"pistons", FW_FORM_NAMED, .subsection = &fw_phase_piston_section, .most = FW_NAMED_MAX,
     NOT_STORED, .default_meaning = "each as driven by itself",
     .meaning = "other drives, by name of the wall that is a piston"},
    {.name = NULL}};

const fw_section fw_phase_section = {
    "`phases.NAME`", "a phase",
    "A part of the run with parameters of its own, from the end of the phase before. The last one "
    "ends with the run. What a phase does not say is as without phases.",
    .keys = phase_keys};

/* What is written in a phase, and of `own` the keys of that section that are not. */
static fw_status complete(const fw_scenario *scenario, const fw_node *written, const fw_node *own,
                          const fw_section *section, fw_node *whole, fw_error *error)
{
    fw_node *copies;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)(written->count + own->count), sizeof *copies,
                                &copies, error));
    *whole = (fw_node){.kind = FW_MAPPING, .key = written->key, .place = written->place};
    const fw_node *const sources[] = {written, own};
    for (int n = 0; n < 2; ++n)
        for (const fw_node *node = sources[n]->first; node; node = node->next) {
            if (fw_node_find(whole, node->key) || !fw_section_find(section, node->key)) continue;
            *copies = *node;
            copies->next = NULL;
            fw_node_append(whole, copies++);
        }
    return FW_OK;
}

static fw_status read_drives(fw_scenario *scenario, const fw_node *named, fw_scenario_phase *phase,
                             fw_error *error)
{
    if (!named) return FW_OK;
    int count;
    const fw_node *grips = fw_scenario_part(scenario, "grips", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)named->count, sizeof *phase->drives,
                                &phase->drives, error));
    for (const fw_node *node = named->first; node; node = node->next) {
        fw_phase_drive *drive = &phase->drives[phase->drive_count++];
        const fw_node name = {
            .text = node->key, .length = strlen(node->key), .place = node->key_place};
        drive->place = node->key_place;
        FW_TRY(fw_scenario_find(scenario, grips, "grip", &name, &drive->grip, error));
        fw_node whole;
        FW_TRY(complete(scenario, node, fw_node_find(grips, node->key), &fw_phase_grip_section,
                        &whole, error));
        FW_TRY(fw_schema_fill(scenario->document, &fw_phase_grip_section, &whole, drive, error));
        FW_TRY(fw_scenario_read_drive(scenario, node, &whole, "grip", node->key, &drive->motion,
                                      error));
    }
    return FW_OK;
}

static fw_status read_pistons(fw_scenario *scenario, const fw_node *named, fw_scenario_phase *phase,
                              fw_error *error)
{
    if (!named) return FW_OK;
    int count;
    const fw_node *walls = fw_scenario_part(scenario, "walls", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)named->count, sizeof *phase->pistons,
                                &phase->pistons, error));
    for (const fw_node *node = named->first; node; node = node->next) {
        fw_phase_piston *piston = &phase->pistons[phase->piston_count++];
        const fw_node name = {
            .text = node->key, .length = strlen(node->key), .place = node->key_place};
        *piston = (fw_phase_piston){.place = node->key_place, .damping = -1};
        FW_TRY(fw_scenario_find(scenario, walls, "wall", &name, &piston->wall, error));
        if (!scenario->walls[piston->wall].is_piston)
            return fw_scenario_fail(scenario, node->key_place, error,
                                    "wall '%s' is no piston, expected one with the key 'piston'",
                                    node->key);
        const fw_node *own = fw_node_find(fw_node_find(walls, node->key), "piston");
        fw_node whole;
        FW_TRY(complete(scenario, node, own, &fw_phase_piston_section, &whole, error));
        FW_TRY(fw_schema_fill(scenario->document, &fw_phase_piston_section, &whole, piston, error));
        FW_TRY(fw_scenario_read_drive(scenario, node, &whole, "piston", node->key, &piston->motion,
                                      error));
    }
    return FW_OK;
}

static fw_status check_order(const fw_scenario *scenario, const fw_node *node,
                             const fw_scenario_phase *phase, fw_error *error)
{
    const fw_place place = fw_node_find(node, "until")->place;
    if (phase->until <= phase->from)
        return fw_scenario_fail(scenario, place, error,
                                "phases out of order: '%s' ends at step %lld, expected more than "
                                "the %lld steps at which the one before ends",
                                phase->name, (long long)phase->until, (long long)phase->from);
    if (phase->until > scenario->run.steps || (!node->next && phase->until < scenario->run.steps))
        return fw_scenario_fail(scenario, place, error,
                                "phases out of order: '%s' ends at step %lld, expected %s the %lld "
                                "steps of the run",
                                phase->name, (long long)phase->until,
                                node->next ? "less than" : "that the last one ends with",
                                (long long)scenario->run.steps);
    return FW_OK;
}

fw_status fw_scenario_read_phases(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "phases", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->phases,
                                &scenario->phases, error));
    int64_t from = 0;
    for (const fw_node *node = part->first; node; node = node->next) {
        fw_scenario_phase *phase = &scenario->phases[scenario->phase_count++];
        *phase = (fw_scenario_phase){.name = node->key,
                                     .place = node->key_place,
                                     .from = from,
                                     .damping = -1,
                                     .temperature = -1};
        FW_TRY(fw_schema_fill(scenario->document, &fw_phase_section, node, phase, error));
        FW_TRY(check_order(scenario, node, phase, error));
        FW_TRY(read_drives(scenario, fw_node_find(node, "grips"), phase, error));
        FW_TRY(read_pistons(scenario, fw_node_find(node, "pistons"), phase, error));
        from = phase->until;
    }
    return FW_OK;
}

fw_status fw_scenario_find_phase(const fw_scenario *scenario, const fw_node *name, int *phase,
                                 fw_error *error)
{
    int count;
    return fw_scenario_find(scenario, fw_scenario_part(scenario, "phases", &count), "phase", name,
                            phase, error);
}
