/* SPDX-License-Identifier: GPL-3.0-or-later */
/* load.h - external forces on selected particles, as functions of the step alone.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_LOAD_H
#define FW_LOAD_H

#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

typedef enum fw_load_kind {
    FW_LOAD_EACH,         /* `vector` on each particle */
    FW_LOAD_TOTAL,        /* `vector` shared equally */
    FW_LOAD_ACCELERATION, /* `vector` times the particle's mass */
    FW_LOAD_RANDOM        /* each component uniform in [-random, random), new in each step */
} fw_load_kind;

/* Plain data. Times are steps; the load acts in the steps from <= step < until. */
typedef struct fw_load_def {
    fw_load_kind kind;
    const int *particles; /* copied */
    int particle_count;
    fw_vec2 vector;
    double random;
    bool balanced; /* random forces minus their mean over the selection */
    int64_t from, until;
    int64_t ramp;         /* grows linearly over so many steps after `from`; 0: at once */
    double period, phase; /* times sin(2 pi step / period + phase); period 0: constant */
    uint64_t seed;
    uint32_t stream; /* of the random numbers; different for each load */
} fw_load_def;

typedef struct fw_load fw_load;

/* `solid` gives the masses; it must outlive nothing. */
fw_status fw_load_create(fw_load **load, const fw_load_def *def, const fw_solid *solid,
                         fw_error *error);
void fw_load_destroy(fw_load *load);

/* Adds the forces of this step to the solid's external forces. */
void fw_load_apply(const fw_load *load, int64_t step, fw_solid *solid);

FW_PUBLIC_END

#endif
