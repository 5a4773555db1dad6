/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_reach.h - how far the boundary of an LB solid can go in the next ticks, at most. */
#ifndef FW_LB_REACH_H
#define FW_LB_REACH_H

#include "lb_state.h"

/* Adds the tiles of a grid that was measured to the arena of the form. */
void lb_reach_allocate(lb_solid *lb);
/* Once rest masses are known. */
void lb_reach_begin(lb_solid *lb);
/* As `reach` of a solid (core/solid.h). */
double lb_reach(const fw_solid *solid, int ticks);

#endif
