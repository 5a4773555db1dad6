/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_surroundings.h - rows of sites, and who lies beside whom, while a body is made. For the
 * automaton's own files only. */
#ifndef FW_AUTOMATON_SURROUNDINGS_H
#define FW_AUTOMATON_SURROUNDINGS_H

#include "automaton_body.h"

/* Neighbours by particle; -1: none. */
typedef struct fw_automaton_surroundings {
    int (*next)[FW_DIRECTIONS];
    uint8_t *seam; /* bit d: the neighbour lies across the seam of a periodic lattice; NULL where no
                    * lattice is periodic */
} fw_automaton_surroundings;

/* Lists the runs of the body, whose cells nobody knows yet, and makes room for what its rows share.
 */
fw_status fw_automaton_list_runs(fw_automaton *body, const fw_sites *sites, fw_error *error);

/* Of a body whose runs are listed. Refuses periods that do not fit, and sites without neighbours.
 * Released by the caller, also after a failure. */
fw_status fw_automaton_surround(fw_automaton_surroundings *around, const fw_automaton *body,
                                const fw_elastic_automaton_def *def, fw_error *error);
void fw_automaton_surroundings_release(fw_automaton_surroundings *around);

#endif
