/* SPDX-License-Identifier: GPL-3.0-or-later */
/* simulation.h - a scenario that runs inside another program: made, advanced, looked at.
 *
 * The numbers are those of `fretwork run`, to the last bit, however the way is cut into pieces.
 * With a directory the results are written as well, the same as by the program but for pictures.
 *
 * Memory. Pointers that a simulation hands out belong to it and are good until it is destroyed.
 * They show the present: what they point to changes when the simulation is advanced, and for what
 * is computed (velocities, forces, fields) when it is asked for again. Whoever wants to keep
 * numbers copies them. */
#ifndef FW_SIMULATION_H
#define FW_SIMULATION_H

#include "core/public.h"
#include "core/status.h"

#include <stdbool.h>
#include <stdint.h>

FW_PUBLIC_BEGIN

typedef struct fw_simulation fw_simulation;
struct fw_scene;

/* Plain data, only read during creation; start from fw_simulation_def_default(). */
typedef struct fw_simulation_def {
    /* What `fretwork run` takes: an experiment of the catalogue, or a file, which has a slash or
     * ends in .yaml or .yml. With `text`: what sentences call it, or NULL. */
    const char *scenario;
    const char *text;            /* the scenario itself; NULL: `scenario` says where it is */
    const char *const *settings; /* as --set has them: "run.steps=200" */
    int setting_count;
    const char *sweep_case; /* of a sweep, as `fretwork sweep --list` names it: "A=2.5"; or NULL */
    const char *directory;  /* of the results; NULL: nothing is written */
    bool overwrite;         /* an earlier result there is replaced, else refused */
    int threads;            /* >= 1; results do not depend on it */
} fw_simulation_def;

/* Neither scenario nor settings, no results, one thread. */
fw_simulation_def fw_simulation_def_default(void);

/* Reads the scenario and builds its start. FW_BAD_INPUT with a sentence that names file, line and
 * column, or the setting, for whatever the program refuses, and for a sweep without a case;
 * FW_SYSTEM_FAILED. *simulation is then NULL. `error` may be NULL, here and below. */
fw_status fw_simulation_create(fw_simulation **simulation, const fw_simulation_def *def,
                               fw_error *error);
/* Stops it first, see below. NULL is legal. */
void fw_simulation_destroy(fw_simulation *simulation);

/* --- running --- */

/* So many steps, or fewer to the end. At the end a study runs its other seeds and its control, and
 * the results are complete. FW_DIVERGED: numbers are no longer finite, or a particle escaped;
 * FW_SYSTEM_FAILED. Then the state can be looked at, and every further call fails in the same way.
 */
fw_status fw_simulation_advance(fw_simulation *simulation, int64_t steps, fw_error *error);

/* Called between steps; may look at everything, but neither advance nor destroy. false: enough. */
typedef bool fw_simulation_look(fw_simulation *simulation, void *context);

/* To the end, or until `look` says enough, after which it may go on. `look` is called at once, and
 * whenever the number of steps is a multiple of `every` (>= 1), and at the end. */
fw_status fw_simulation_run(fw_simulation *simulation, int64_t every, fw_simulation_look *look,
                            void *context, fw_error *error);

/* Leaves off before the end: the results, if any, are closed, and the program can resume them. The
 * state can still be looked at; to advance it fails with FW_INTERRUPTED. Nothing happens where the
 * end was reached or the run has failed. FW_SYSTEM_FAILED: the last checkpoint stays whole. */
fw_status fw_simulation_stop(fw_simulation *simulation, fw_error *error);

int64_t fw_simulation_step(const fw_simulation *simulation);       /* steps done */
int64_t fw_simulation_step_count(const fw_simulation *simulation); /* of the whole run */
double fw_simulation_time(const fw_simulation *simulation);
bool fw_simulation_is_at_end(const fw_simulation *simulation);

/* --- looking --- */

const char *fw_simulation_name(const fw_simulation *simulation);  /* of experiment or file */
const char *fw_simulation_title(const fw_simulation *simulation); /* as the scenario has it */
/* What the program would have warned of so far, a line each; "" if of nothing. Good until the
 * simulation is advanced. */
const char *fw_simulation_warnings(const fw_simulation *simulation);

/* A body of the scenario. */
typedef struct fw_body_view {
    const char *name;
    const char *model;   /* of its solid: "lattice-boltzmann" */
    int count;           /* particles */
    const double *x, *y; /* positions: [count] */
} fw_body_view;

int fw_simulation_body_count(const fw_simulation *simulation);
fw_body_view fw_simulation_body(const fw_simulation *simulation, int body);
int fw_simulation_find_body(const fw_simulation *simulation, const char *name); /* -1: none */

/* Two numbers per particle of a body: *x and *y are [count]. */
fw_status fw_simulation_velocities(fw_simulation *simulation, int body, const double **x,
                                   const double **y, fw_error *error);
/* External forces, and reactions of walls, grips and other bodies: as results have them where the
 * scenario records forces, otherwise those of the last step. */
fw_status fw_simulation_forces(fw_simulation *simulation, int body, const double **x,
                               const double **y, fw_error *error);

/* A number per particle: a field that results may record (`record.fields`). FW_BAD_INPUT: the body
 * has no such field. */
fw_status fw_simulation_field(fw_simulation *simulation, int body, const char *name,
                              const double **values, fw_error *error);
/* The n-th field that the body has; NULL after the last. */
const char *fw_simulation_field_name(const fw_simulation *simulation, int body, int n);

/* Measures at present what `fretwork quantities` names: "energy", "energy.sheet",
 * "momentum.sheet.x". *count: how many numbers there are; what cannot be measured is NaN. What is
 * measured of several things must name one. FW_BAD_INPUT where the name means nothing. */
enum { FW_SIMULATION_NUMBERS = 8 };
fw_status fw_simulation_measure(const fw_simulation *simulation, const char *name,
                                double values[FW_SIMULATION_NUMBERS], int *count, fw_error *error);

/* What the scenario measures, as the results hold it: a row every run.measure-every steps and at
 * the end. Number c of row r stands at values[r * stride + c]. */
typedef struct fw_series_view {
    const char *name; /* "momentum.sheet" */
    int components;
    int64_t count;  /* rows so far */
    int64_t stride; /* numbers from row to row */
    const double *values;
    const int64_t *steps;
    const double *times;
} fw_series_view;

int fw_simulation_series_count(const fw_simulation *simulation);
fw_series_view fw_simulation_series(const fw_simulation *simulation, int number);

/* At the end: how many numbers the scenario expects, and how many of them did not come out. Both 0
 * before. FW_SYSTEM_FAILED without memory. */
fw_status fw_simulation_judge(const fw_simulation *simulation, int *expected, int *failed,
                              fw_error *error);

/* The scene of the run, for whatever scene.h tells of it. */
const struct fw_scene *fw_simulation_scene(const fw_simulation *simulation);

FW_PUBLIC_END

#endif
