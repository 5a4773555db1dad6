/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_layout.h - what follows from a shape and from the links that are whole. */
#ifndef FW_LB_LAYOUT_H
#define FW_LB_LAYOUT_H

#include "lb_state.h"

/* Neighbours, links and the eight-neighbour edge of the shape. */
void lb_layout_connect(lb_solid *lb, const fw_sites *sites);
/* Links, boundary and spans as they follow from `present`. */
void lb_layout_rebuild(lb_solid *lb);
/* FW_BAD_INPUT unless each link is there for both of its ends, and only where a neighbour lies. */
fw_status lb_layout_check(const lb_solid *lb, fw_error *error);

#endif
