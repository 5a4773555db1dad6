/* SPDX-License-Identifier: GPL-3.0-or-later */
/* caution.h - what a user should know of a run that goes on all the same: where a solid leaves what
 * it can describe. */
#ifndef FW_CAUTION_H
#define FW_CAUTION_H

#include "experiments/setup/experiment.h"

#include <stdio.h>

typedef struct fw_caution {
    FILE *out;    /* NULL: says nothing */
    bool met;     /* bodies were seen to pass through each other, and it was said */
    bool hurried; /* an LB body was too fast, and it was said */
    bool looked;  /* not for the first time */
} fw_caution;

/* Names the walls that break a law which all others keep, a line each; returns how many there are.
 */
int fw_caution_walls(FILE *out, const fw_experiment *experiment);

/* Looks at the scene as it is now, and says what is new, a line each. To be called at the start and
 * now and then. */
fw_status fw_caution_look(fw_caution *caution, const fw_experiment *experiment, fw_error *error);

#endif
