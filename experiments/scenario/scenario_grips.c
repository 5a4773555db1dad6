/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_grips.c - grips, phases, profile and study of a scenario. Keeps no state. */
#include "scenario_parts.h"

#include <string.h>

/* --- grips --- */

fw_status fw_scenario_read_drive(const fw_scenario *scenario, const fw_node *node, const char *kind,
                                 const char *name, fw_scenario_drive *motion, fw_error *error)
{
    const fw_node *path = fw_node_find(node, "path"), *hold = fw_node_find(node, "hold");
    motion->drive.prescribed_x = motion->hold == FW_HOLD_X || motion->hold == FW_HOLD_BOTH;
    motion->drive.prescribed_y = motion->hold == FW_HOLD_Y || motion->hold == FW_HOLD_BOTH;
    if (path && motion->hold == FW_HOLD_NONE)
        return fw_scenario_fail(scenario, path->key_place, error,
                                "%s '%s' has a path that no component follows, expected 'hold: "
                                "x', 'y' or 'both'",
                                kind, name);
    const fw_node *period = fw_node_find(node, "period");
    if (period && !fw_node_find(node, "amplitude"))
        return fw_scenario_fail(scenario, period->key_place, error,
                                "%s '%s' has 'period' but no 'amplitude', without which it means "
                                "nothing",
                                kind, name);
    static const char *const forces[] = {"force", "amplitude", "tether"};
    for (int n = 0; n < 3; ++n) {
        const fw_node *force = fw_node_find(node, forces[n]);
        if (!force) continue;
        if ((motion->drive.prescribed_x && fw_node_number(force->first) != 0) ||
            (motion->drive.prescribed_y && fw_node_number(force->last) != 0))
            return fw_scenario_fail(scenario, force->place, error,
                                    "%s '%s' has the %s [%g, %g], but 'hold: %s' moves that "
                                    "component whatever force acts; expected 0 there",
                                    kind, name, forces[n], fw_node_number(force->first),
                                    fw_node_number(force->last), hold->text);
    }
    return FW_OK;
}

static fw_status read_grip(fw_scenario *scenario, const fw_node *node, fw_scenario_grip *grip,
                           fw_error *error)
{
    grip->name = node->key;
    grip->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, "grip", node, grip, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body",
                            fw_node_find(node, "body"), &grip->body, error));
    FW_TRY(fw_scenario_read_selection(scenario, node, &scenario->bodies[grip->body], &grip->sites,
                                      error));
    return fw_scenario_read_drive(scenario, node, "grip", node->key, &grip->motion, error);
}

fw_status fw_scenario_read_grips(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "grips", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->grips, &scenario->grips,
                                error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_grip(scenario, node, &scenario->grips[scenario->grip_count++], error));
    return FW_OK;
}

/* --- phases --- */

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
        FW_TRY(fw_schema_fill(scenario->document, "phase-grip", node, drive, error));
        FW_TRY(fw_scenario_read_drive(scenario, node, "grip", node->key, &drive->motion, error));
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
        FW_TRY(fw_schema_fill(scenario->document, "phase-piston", node, piston, error));
        FW_TRY(fw_scenario_read_drive(scenario, node, "piston", node->key, &piston->motion, error));
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
        FW_TRY(fw_schema_fill(scenario->document, "phase", node, phase, error));
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

/* --- profile and study --- */

static fw_status read_profile(fw_scenario *scenario, const fw_node *node, fw_error *error)
{
    fw_scenario_profile *profile = &scenario->profile;
    FW_TRY(fw_schema_fill(scenario->document, "profile", node, profile, error));
    profile->place = node->key_place;
    profile->from = 0;
    profile->until = scenario->run.steps;
    const fw_node *name = fw_node_find(node, "phase");
    if (name) {
        int phase;
        FW_TRY(fw_scenario_find_phase(scenario, name, &phase, error));
        profile->from = scenario->phases[phase].from;
        profile->until = scenario->phases[phase].until;
    }
    if (profile->every > profile->until - profile->from)
        return fw_scenario_fail(scenario, fw_node_find(node, "every")->place, error,
                                "profile.every is %lld, expected at most the %lld steps in which "
                                "samples are taken",
                                (long long)profile->every,
                                (long long)(profile->until - profile->from));
    static const char *const pairs[] = {"window", "far"};
    for (int n = 0; n < 2; ++n) {
        const fw_node *pair = fw_node_find(node, pairs[n]);
        if (pair && fw_node_number(pair->first) >= fw_node_number(pair->last))
            return fw_scenario_fail(scenario, pair->place, error,
                                    "profile.%s is [%g, %g], expected the smaller number first",
                                    pairs[n], fw_node_number(pair->first),
                                    fw_node_number(pair->last));
    }
    return FW_OK;
}

fw_status fw_scenario_read_study(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *profile = fw_scenario_part(scenario, "profile", &count);
    if (profile) FW_TRY(read_profile(scenario, profile, error));
    fw_scenario_study *study = &scenario->study;
    study->seeds = 1;
    const fw_node *node = fw_scenario_part(scenario, "study", &count);
    if (!node) return FW_OK;
    FW_TRY(fw_schema_fill(scenario->document, "study", node, study, error));
    const fw_node *control = fw_node_find(node, "control");
    if (!control) return FW_OK;
    if (!profile)
        return fw_scenario_fail(scenario, control->key_place, error,
                                "a control stands beside the profile of the experiment, and there "
                                "is no 'profile'");
    study->control_place = control->place;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)control->count, sizeof *study->control,
                                &study->control, error));
    for (const fw_node *item = control->first; item; item = item->next)
        study->control[study->control_count++] = item->text;
    return FW_OK;
}
