/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_automaton.h - an elastic automaton as plain data. */
#ifndef FW_SCENARIO_AUTOMATON_H
#define FW_SCENARIO_AUTOMATON_H

#include "core/automaton/automaton_matrices.h"

typedef enum fw_automaton_edges {
    FW_EDGES_BOND,
    FW_EDGES_TRAPEZOID,
    FW_EDGES_MIRROR,
    FW_EDGES_PERIODIC
} fw_automaton_edges;

typedef struct fw_scenario_automaton {
    fw_automaton_speeds speeds; /* inside the disc of stability */
    fw_automaton_edges boundary;
    double damping;  /* 1 - a, 0 <= damping < 1 */
    int black;       /* which sites move first: 0 those with i + j even, 1 odd */
    double break_at; /* 0: never */
} fw_scenario_automaton;

#endif
