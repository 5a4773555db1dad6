/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_materials.h - what bodies are made of, as plain data. */
#ifndef FW_SCENARIO_MATERIALS_H
#define FW_SCENARIO_MATERIALS_H

#include "experiments/scenario/scenario_automaton.h"
#include "experiments/scenario/scenario_boltzmann.h"
#include "experiments/scenario/scenario_linear.h"
#include "experiments/scenario/scenario_particles.h"
#include "experiments/schema/schema.h"

typedef struct fw_scenario fw_scenario;
typedef struct fw_scenario_body fw_scenario_body;

/* All materials. Columns: name in the enum; member of fw_scenario_material; key; meaning. A member
 * NAME stands for what the files of the material define, and without which nothing links:
 * scenario_NAME.h has its plain data, fw_scenario_NAME; scenario_NAME.c has its keys,
 * fw_NAME_section, and fw_NAME_material; build_NAME.c in experiments/setup has fw_NAME_solid. */
#define FW_MATERIAL_ROWS(ROW)                                                                      \
    ROW(LATTICE_BOLTZMANN, boltzmann, "lattice-boltzmann", "the lattice Boltzmann solid")          \
    ROW(MOVABLE_PARTICLES, particles, "movable-particles", "movable lattice particles")            \
    ROW(LINEAR_LATTICE, linear, "linear-lattice", "the linear lattice")                            \
    ROW(ELASTIC_AUTOMATON, automaton, "elastic-automaton", "the elastic automaton")

#define FW_MATERIAL_ENUM(id, member, word, meaning) FW_##id,
#define FW_MATERIAL_DATA(id, member, word, meaning) fw_scenario_##member member;
#define FW_MATERIAL_PARTS(id, member, word, meaning)                                               \
    extern const fw_section fw_##member##_section;                                                 \
    extern const fw_material_model fw_##member##_material;
#define FW_MATERIAL_ONE(id, member, word, meaning) +1
typedef enum fw_material_kind { FW_MATERIAL_ROWS(FW_MATERIAL_ENUM) } fw_material_kind;

enum { FW_MATERIAL_KINDS = 0 FW_MATERIAL_ROWS(FW_MATERIAL_ONE) };

typedef struct fw_scenario_material {
    const char *name;
    fw_place place;
    fw_material_kind kind;
    union {
        FW_MATERIAL_ROWS(FW_MATERIAL_DATA)
    };
} fw_scenario_material;

/* One model of a solid, as a scenario has it. */
typedef struct fw_material_model {
    const char *bodies;    /* "elastic automata" */
    unsigned lattices;     /* bits 1 << FW_SQUARE, 1 << FW_HEXAGONAL */
    const char *why;       /* no other lattice will do */
    const char *body_keys; /* keys of a body that not all models have, each between blanks */
    bool flows;            /* particles need no lattice: placed at random, drawn as discs */
    bool has_modes;        /* displacements that are a mode of its endless lattice */
    bool has_dynamics;     /* moves by `dynamics` */
    const char *citation;  /* key of the paper that it rests on; NULL: none */
    size_t break_at; /* offset in a material of the stretch that breaks its links; 0: none does */
    size_t link_stiffness; /* offset of a fw_sym2: force over deformation of a link; 0: none */
    /* The unit of time that its forces make; 0, or NULL: none. */
    double (*time_unit)(const fw_scenario_material *material);
    /* What belongs together in a material, from the mapping with its keys; NULL: nothing. */
    fw_status (*read)(const fw_scenario *scenario, const fw_node *node,
                      fw_scenario_material *material, fw_error *error);
    /* What the schema could not see about one of its bodies, once all of it is read; or NULL. */
    fw_status (*check_body)(const fw_scenario *scenario, const fw_scenario_body *body,
                            fw_error *error);
    /* What its bodies may not have beside each other or beside others; or NULL. */
    fw_status (*check_bodies)(const fw_scenario *scenario, fw_error *error);
} fw_material_model;

FW_MATERIAL_ROWS(FW_MATERIAL_PARTS)

/* The row of a kind. */
const fw_material_model *fw_material_model_of(fw_material_kind kind);

/* The stretch at which links of the material break; 0: they do not. */
double fw_material_break_at(const fw_scenario_material *material);

/* The stiffness of its links, where they are springs that the displacements of their ends deform;
 * NULL: they are not. */
const fw_sym2 *fw_material_link_stiffness(const fw_scenario_material *material);

/* The unit of time that its forces make; 0: they make none. */
double fw_material_time_unit(const fw_scenario_material *material);

/* The model that a body of the scenario is of. */
const fw_material_model *fw_scenario_model(const fw_scenario *scenario, int body);

#endif
