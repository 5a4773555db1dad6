/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warning.h - what a user should know of a run that goes on all the same: where a solid leaves what
 * it can describe. */
#ifndef FW_WARNING_H
#define FW_WARNING_H

#include "experiments/setup/experiment.h"

#include <stdio.h>

typedef struct fw_warning {
    FILE *out;    /* NULL: looks for nothing */
    int count;    /* how many there were */
    char *text;   /* a line each, without "warning: "; NULL: none */
    bool folded;  /* a body was folded, and it was said */
    bool hurried; /* an LB body was too fast, and it was said */
    bool looked;  /* not for the first time */
} fw_warning;

void fw_warning_clear(fw_warning *warning);

/* Looks at the scene as it is now, and says what is new, a line each. To be called at the start and
 * now and then. */
fw_status fw_warning_look(fw_warning *warning, const fw_experiment *experiment, fw_error *error);

#endif
