/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_run.h - how a run goes, and what is recorded of it, as plain data. */
#ifndef FW_SCENARIO_RUN_H
#define FW_SCENARIO_RUN_H

#include "experiments/schema/schema.h"

/* Of all movable particles and linear lattices of a scenario. */
typedef struct fw_scenario_dynamics {
    double time_step, damping, temperature;
    double strength_across; /* of the potential between particles of different bodies */
    double bond_radius;
    double overlap_energy;
    fw_place time_step_place; /* line 0: not given */
} fw_scenario_dynamics;

typedef struct fw_scenario_run {
    int64_t steps;
    int64_t record_every;     /* >= 1 */
    int64_t measure_every;    /* >= 1 */
    int64_t checkpoint_every; /* 0: left to the program */
    int64_t reverse_at;       /* fields are reversed after so many steps; 0: never */
    int64_t seed;
    double limit; /* a particle further than this from the scene's middle has escaped */
} fw_scenario_run;

typedef struct fw_scenario_record {
    bool velocity, force;
    fw_schema_names fields; /* fields per particle, by the solid's names */
} fw_scenario_record;

#endif
