/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_pictures.h - which pictures are drawn, as plain data. */
#ifndef FW_SCENARIO_PICTURES_H
#define FW_SCENARIO_PICTURES_H

#include "experiments/scenario/picture_kind.h"
#include "experiments/schema/schema.h"

typedef struct fw_scenario_picture {
    const char *name;
    fw_place place;
    fw_picture_kind kind;
    const char *title; /* NULL: the scenario's */
    int instant_count; /* 0: the program chooses */
    int64_t *instants; /* steps, ascending */
    fw_schema_name field;
    fw_schema_names observables; /* "energy", "elongation.chain", "momentum.x" */
    int64_t from, until;         /* steps between which a series is drawn */
    bool logarithmic;            /* whether its values are drawn on logarithmic axes */
    double range[2];             /* ends of the colour scale; equal: those of all frames */
    fw_schema_name analysis, body;
    int along;                  /* parameter of a sweep along x; -1: chosen */
    const char *along_quantity; /* that is drawn along x in its place, or NULL */
    bool has_level;
    double level; /* where a map has a line */
} fw_scenario_picture;

#endif
