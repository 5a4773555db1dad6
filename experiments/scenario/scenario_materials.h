/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_materials.h - what bodies are made of, as plain data. */
#ifndef FW_SCENARIO_MATERIALS_H
#define FW_SCENARIO_MATERIALS_H

#include "experiments/scenario/scenario_automaton.h"
#include "experiments/scenario/scenario_boltzmann.h"
#include "experiments/scenario/scenario_particles.h"
#include "experiments/schema/schema.h"

typedef struct fw_scenario fw_scenario;
typedef struct fw_scenario_body fw_scenario_body;

/* All materials. Columns: name in the enum; member of fw_scenario_material, and name of the rows
 * here and in experiments/setup/solids.c, without which it does not compile; section of its keys;
 * key; meaning. */
#define FW_MATERIAL_ROWS(ROW)                                                                      \
    ROW(LATTICE_BOLTZMANN, boltzmann, fw_lattice_boltzmann_section, "lattice-boltzmann",           \
        "the lattice Boltzmann solid")                                                             \
    ROW(MOVABLE_PARTICLES, particles, fw_movable_particles_section, "movable-particles",           \
        "movable lattice particles")                                                               \
    ROW(LINEAR_LATTICE, linear, fw_linear_lattice_section, "linear-lattice", "the linear lattice") \
    ROW(ELASTIC_AUTOMATON, automaton, fw_elastic_automaton_section, "elastic-automaton",           \
        "the elastic automaton")

#define FW_MATERIAL_ENUM(id, member, section, word, meaning) FW_##id,
#define FW_MATERIAL_ONE(id, member, section, word, meaning)  +1
typedef enum fw_material_kind { FW_MATERIAL_ROWS(FW_MATERIAL_ENUM) } fw_material_kind;

enum { FW_MATERIAL_KINDS = 0 FW_MATERIAL_ROWS(FW_MATERIAL_ONE) };

typedef struct fw_scenario_material {
    const char *name;
    fw_place place;
    fw_material_kind kind;
    union {
        fw_scenario_boltzmann boltzmann;
        fw_scenario_particles particles;
        fw_scenario_linear linear;
        fw_scenario_automaton automaton;
    };
} fw_scenario_material;

/* One model of a solid, as a scenario has it. What is built of it: experiments/setup/solids.h,
 * which has a row for each row here. */
typedef struct fw_material_model {
    const char *bodies;    /* "elastic automata" */
    unsigned lattices;     /* bits 1 << FW_SQUARE, 1 << FW_HEXAGONAL */
    const char *why;       /* no other lattice will do */
    const char *body_keys; /* keys of a body that not all models have, each between blanks */
    bool can_be_placed;    /* without a lattice, at random */
    bool has_modes;        /* displacements that are a mode of its endless lattice */
    bool has_dynamics;     /* moves by `dynamics` */
    const char *citation;  /* key of the paper that it rests on; NULL: none */
    size_t break_at; /* offset in a material of the stretch that breaks its links; 0: none does */
    /* What belongs together in a material, from the mapping with its keys; NULL: nothing. */
    fw_status (*read)(const fw_scenario *scenario, const fw_node *node,
                      fw_scenario_material *material, fw_error *error);
    /* What the schema could not see about one of its bodies, once all of it is read; or NULL. */
    fw_status (*check_body)(const fw_scenario *scenario, const fw_scenario_body *body,
                            fw_error *error);
    /* What its bodies may not have beside each other or beside others; or NULL. */
    fw_status (*check_bodies)(const fw_scenario *scenario, fw_error *error);
} fw_material_model;

/* The row of a kind. */
const fw_material_model *fw_material_model_of(fw_material_kind kind);

/* The stretch at which links of the material break; 0: they do not. */
double fw_material_break_at(const fw_scenario_material *material);

/* The model that a body of the scenario is of. */
const fw_material_model *fw_scenario_model(const fw_scenario *scenario, int body);

#endif
