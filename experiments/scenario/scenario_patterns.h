/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_patterns.h - values of single sites and links of a body, as plain data. */
#ifndef FW_SCENARIO_PATTERNS_H
#define FW_SCENARIO_PATTERNS_H

#include "experiments/scenario/scenario_selection.h"

/* Values given to selected sites. */
typedef enum fw_pattern_kind {
    FW_PATTERN_UNIFORM,  /* amplitude */
    FW_PATTERN_GAUSSIAN, /* amplitude exp(-|s - centre|^2 / (2 width^2)), s = (i, j) */
    FW_PATTERN_WAVE,     /* amplitude cos(wave_vector . s + phase) */
    FW_PATTERN_PLANE,    /* amplitude cos(wave_vector . r + phase), r the place less the origin */
    FW_PATTERN_GRADIENT, /* gradient r */
    FW_PATTERN_MODE,     /* of an elastic automaton: a running wave of its endless lattice */
    FW_PATTERN_RANDOM    /* each component uniform in [-random, random) */
} fw_pattern_kind;

typedef struct fw_pattern {
    fw_selection sites;
    fw_pattern_kind kind;
    fw_vec2 amplitude;
    fw_vec2 centre;      /* in sites: [i, j] */
    double width;        /* in sites */
    fw_vec2 wave_vector; /* radians per site, or per length */
    double gradient[4];  /* xx xy yx yy */
    double phase;        /* radians */
    double random;
    int branch;  /* mode: FW_SLOW or FW_FAST */
    double size; /* mode: of the white cells' displacement */
} fw_pattern;

typedef struct fw_patterns {
    int count;
    fw_pattern *item; /* displacements and velocities add up */
} fw_patterns;

/* Which links a stiffness is given to, looking at the ends that are selected. */
typedef enum fw_link_choice { FW_LINKS_INSIDE, FW_LINKS_ACROSS, FW_LINKS_TOUCHING } fw_link_choice;

typedef struct fw_replacement {
    fw_selection sites;
    fw_sym2 value;
    fw_link_choice links; /* of link stiffnesses only */
} fw_replacement;

typedef struct fw_replacements {
    int count;
    fw_replacement *item; /* a later one replaces an earlier one */
} fw_replacements;

#endif
