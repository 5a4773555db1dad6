/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_run.c - how a run goes: dynamics, length, what is recorded. Keeps no state. Start
 * reading at fw_scenario_complete_run(). */
#include "scenario_parts.h"

static const fw_key dynamics_keys[] = {
    {"time-step", AT_NUMBER(fw_scenario_dynamics, time_step), ABOVE_ZERO, .default_value = "0.005",
     .unit = "time", .meaning = "below the limit that the stiffest bond sets, about 0.1"},
    {"damping", AT_NUMBER(fw_scenario_dynamics, damping), AT_LEAST(0), .default_value = "0",
     .unit = "1/time", .meaning = "eta/m: rate at which velocities decay"},
    {"temperature", AT_NUMBER(fw_scenario_dynamics, temperature), AT_LEAST(0), .default_value = "0",
     .unit = "energy", .meaning = "k_B T of the heat bath, which acts where there is damping"},
    {"strength-across", AT_NUMBER(fw_scenario_dynamics, strength_across), AT_LEAST(0),
     .default_value = "1",
     .meaning = "factor on the potential between movable particles of different bodies"},
    {"bond-radius", AT_NUMBER(fw_scenario_dynamics, bond_radius), ABOVE_ZERO,
     .default_value = "1.25", .unit = "length",
     .meaning = "what counts as a bond where order and coordination are measured"},
    {"overlap-energy", AT_NUMBER(fw_scenario_dynamics, overlap_energy), AT_LEAST(0),
     .default_value = "100", .unit = "energy",
     .meaning = "a pair of movable particles that starts with more is refused"},
    {.name = NULL}};

const fw_section fw_dynamics_section = {
    "`dynamics`", "a set of dynamics",
    "How movable particles and linear lattices move: m dv/dt = F - m damping v + noise, in steps "
    "of velocity Verlet, or of BAOAB where there is damping. Everything that counts steps (`run`, "
    "forces, expectations) counts these; walls' paths are in time, steps times `time-step`.",
    .keys = dynamics_keys};

static const fw_key run_keys[] = {
    {"steps", AT_INTEGER(fw_scenario_run, steps), REQUIRED, AT_LEAST(1), .unit = "steps",
     .meaning = "length of the run"},
    {"record-every", AT_INTEGER(fw_scenario_run, record_every), AT_LEAST(1),
     .default_meaning = "a 200th of `steps`", .unit = "steps",
     .meaning =
         "between two frames in the results file; the start and the end are always recorded"},
    {"measure-every", AT_INTEGER(fw_scenario_run, measure_every), AT_LEAST(1), .default_value = "1",
     .unit = "steps",
     .meaning = "between two values of the observables; the start and the end are always measured"},
    {"checkpoint-every", AT_INTEGER(fw_scenario_run, checkpoint_every), AT_LEAST(1),
     .default_meaning = "about once a minute", .unit = "steps",
     .meaning = "between two checkpoints"},
    {"seed", AT_INTEGER(fw_scenario_run, seed), AT_LEAST(0), .default_value = "1",
     .meaning = "of everything random; the same seed gives the same run, to the last bit"},
    {"limit", AT_NUMBER(fw_scenario_run, limit), ABOVE_ZERO, .default_value = "1e6",
     .unit = "length",
     .meaning = "a particle further than this from where site [0, 0] of the first body began stops "
                "the run"},
    {"reverse-at", AT_INTEGER(fw_scenario_run, reverse_at), AT_LEAST(1), .default_meaning = "never",
     .unit = "steps",
     .meaning =
         "after so many steps the arrow of time is turned: every body runs back the way it came"},
    {.name = NULL}};

const fw_section fw_run_section = {"`run`", "a run", "How long, and what happens on the way.",
                                   .keys = run_keys};

static const fw_key record_keys[] = {
    {"velocity", AT_FLAG(fw_scenario_record, velocity), .default_value = "true",
     .meaning = "velocities"},
    {"force", AT_FLAG(fw_scenario_record, force), .default_value = "false",
     .meaning = "external forces and reactions of contacts, [F(t) + F(t-1)]/2"},
    {"fields", AT_NAMES(FW_FORM_NAME, fw_scenario_record, fields), .most = 64,
     .default_meaning = "none", .meaning = "fields of the solids, by name"},
    {.name = NULL}};

const fw_section fw_record_section = {
    "`record`", "a record", "What the results file holds of each particle, beside its position.",
    .keys = record_keys};

fw_status fw_scenario_check_dynamics(fw_scenario *scenario, fw_error *error)
{
    bool moves = false;
    for (int b = 0; b < scenario->body_count; ++b)
        moves |= fw_scenario_model(scenario, b)->has_dynamics;
    int count;
    const fw_node *dynamics = fw_scenario_part(scenario, "dynamics", &count);
    const fw_node *time_step = dynamics ? fw_node_find(dynamics, "time-step") : NULL;
    if (time_step) scenario->dynamics.time_step_place = time_step->place;
    if (moves && scenario->run.reverse_at > 0 && scenario->dynamics.damping > 0)
        return fw_scenario_fail(
            scenario, fw_node_find(dynamics, "damping")->place, error,
            "dynamics.damping is %g in a run that is reversed, expected 0: what "
            "damping took does not come back",
            scenario->dynamics.damping);
    const fw_node *phases = fw_scenario_part(scenario, "phases", &count);
    for (const fw_node *phase = phases ? phases->first : NULL; phase && !moves;
         phase = phase->next) {
        const fw_node *bath = fw_node_find(phase, "damping");
        if (!bath) bath = fw_node_find(phase, "temperature");
        if (bath)
            return fw_scenario_fail(scenario, bath->key_place, error,
                                    "phase '%s' has '%s', which is for movable particles and "
                                    "linear lattices, and no body is one",
                                    phase->key, bath->key);
    }
    if (!dynamics || moves) return FW_OK;
    return fw_scenario_fail(scenario, dynamics->key_place, error,
                            "'dynamics' is for movable particles and linear lattices, and no body "
                            "is one");
}

static const fw_node *run_key(const fw_scenario *scenario, const char *key)
{
    int count;
    return fw_node_find(fw_scenario_part(scenario, "run", &count), key);
}

fw_status fw_scenario_complete_run(fw_scenario *scenario, fw_error *error)
{
    enum { FRAMES = 200 };
    fw_scenario_run *run = &scenario->run;
    if (!run->record_every) run->record_every = (run->steps + FRAMES - 1) / FRAMES;
    if (run->reverse_at >= run->steps)
        return fw_scenario_fail(scenario, run_key(scenario, "reverse-at")->place, error,
                                "run.reverse-at is %lld, expected less than the %lld steps of the "
                                "run",
                                (long long)run->reverse_at, (long long)run->steps);
    return FW_OK;
}

int64_t fw_scenario_count_samples(const fw_scenario *scenario, int64_t from, int64_t until)
{
    const fw_scenario_run *run = &scenario->run;
    if (until > run->steps) until = run->steps;
    if (from > until) return 0;
    const int64_t before = from > 0 ? (from - 1) / run->measure_every + 1 : 0;
    const int64_t upto = until / run->measure_every + 1;
    const bool end = until == run->steps && run->steps % run->measure_every != 0;
    return upto - before + end;
}
