/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_outcome.h - what the cases of a sweep, all of them run, say together. */
#ifndef FW_SWEEP_OUTCOME_H
#define FW_SWEEP_OUTCOME_H

#include "experiments/study/sweep_table.h"
#include "sweep_case.h"

/* The measures of the layer, where there is a profile, and every expected quantity. Cleared by the
 * caller, also after a failure: FW_SYSTEM_FAILED without memory. */
fw_status fw_sweep_outcome_table(fw_sweep_table *table, const fw_scenario *sweep,
                                 const fw_sweep_case *cases, fw_error *error);
/* Of each case what is expected of it, then the trends. They point into the cases. */
fw_status fw_sweep_outcome_verdicts(fw_verdicts *verdicts, const fw_scenario *sweep,
                                    const fw_sweep_case *cases, fw_error *error);

/* What the number of a verdict is called in the table. */
void fw_sweep_outcome_name(const fw_verdict *verdict, char name[FW_SWEEP_NAME]);

#endif
