/* SPDX-License-Identifier: GPL-3.0-or-later */
/* citation.h - what a scenario rests on: papers and programs, a constant row each. */
#ifndef FW_CITATION_H
#define FW_CITATION_H

#include "experiments/scenario/scenario.h"

#include <stdio.h>

typedef struct fw_citation {
    const char *key; /* of the BibTeX entry; NULL ends the table */
    const char *entry;
    const char *authors; /* a scenario whose source names them rests on it; NULL: none does */
    /* Does the scenario rest on it, beside by its materials and its source? NULL: no. */
    bool (*needed)(const fw_scenario *scenario);
} fw_citation;

extern const fw_citation fw_citations[];

/* The entries that the scenario rests on, and this program's own. */
void fw_citation_print(FILE *out, const fw_scenario *scenario);

#endif
