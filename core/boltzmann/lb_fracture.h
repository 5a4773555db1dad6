/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_fracture.h - links that break under stretch. */
#ifndef FW_LB_FRACTURE_H
#define FW_LB_FRACTURE_H

#include "lb_state.h"

/* Breaks every link stretched beyond break_at, and puts the energy into the ledger. */
void lb_break_links(lb_solid *lb);

#endif
