/* SPDX-License-Identifier: GPL-3.0-or-later */
/* citation.h - what a scenario rests on: papers and programs, as BibTeX. */
#ifndef FW_CITATION_H
#define FW_CITATION_H

#include "experiments/scenario/scenario.h"

#include <stdio.h>

/* The entries that the scenario rests on, and this program's own. */
void fw_citation_print(FILE *out, const fw_scenario *scenario);

#endif
