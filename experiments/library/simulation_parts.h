/* SPDX-License-Identifier: GPL-3.0-or-later */
/* simulation_parts.h - the inside of a simulation, shared by simulation.c (making and running) and
 * simulation_look.c (looking), and by nobody else. */
#ifndef FW_SIMULATION_PARTS_H
#define FW_SIMULATION_PARTS_H

#include "experiments/library/simulation.h"
#include "experiments/study/study.h"

/* Numbers per particle of one solid that were computed for somebody who looks. */
typedef struct simulation_window simulation_window;
struct simulation_window {
    simulation_window *next;
    int solid;
    const char *name; /* a constant, or that of a field */
    double *values;   /* of all particles; of vectors first every x, then every y */
};

struct fw_simulation {
    fw_scenario *scenario;
    fw_study *study;
    fw_run *run; /* of the study: the experiment's own */
    char name[FW_NAME_BYTES + 1];
    char *directory; /* NULL: nothing is written */
    int threads;
    bool at_end;
    FILE *warnings; /* into warning_lines */
    char *warning_lines;
    size_t warning_size;
    simulation_window *windows;
    fw_error failure; /* status FW_OK: none */
};

#endif
