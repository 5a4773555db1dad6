/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_page.h - a result, or a sweep with all its cases, as one page that stands by itself:
 * figures, a player of the motion, what was expected, ledgers and provenance. Nothing is fetched
 * from anywhere. */
#ifndef FW_REPORT_PAGE_H
#define FW_REPORT_PAGE_H

#include "core/status.h"
#include "experiments/scenario/scenario.h"

#include <stdio.h>

typedef struct fw_report_wish {
    const char *directory;
    const char *file; /* ends in .html */
    /* Prints what the scenario rests on, as BibTeX. */
    void (*cite)(FILE *out, const fw_scenario *scenario);
} fw_report_wish;

/* Says on `out` what was made, and what was left out to keep it small. FW_BAD_INPUT: there are no
 * results, a sweep is not finished, or the name has another ending; FW_SYSTEM_FAILED: memory,
 * disk. */
fw_status fw_report_make(const fw_report_wish *wish, FILE *out, fw_error *error);

#endif
