/* SPDX-License-Identifier: GPL-3.0-or-later */
/* penalty.h - soft walls: a particle behind the surface by d is pushed back along the normal with
 * the force stiffness d, and the wall stores V = stiffness d^2/2.
 *
 * The force of a step is not the one at its beginning, which would pump energy into whatever
 * bounces, but a discrete gradient of V along the path: F . w = V(before) - V(after), exactly, so
 * that soft contact keeps energy as hard contact does, with every solid. It is along the normal (of
 * a circle: at the middle of the path), so that frictionless walls exert no other force and a
 * circle no torque. Points are in the frame of the wall. */
#ifndef FW_PENALTY_H
#define FW_PENALTY_H

#include "contact/geometry/wall.h"

/* V at that point; 0 where it is free. A box or polygon seen from inside has a spring per side, so
 * that two act in its corners; seen from outside the nearest side's. Chains have no inside and
 * cannot be soft. */
double fw_penalty_energy(const fw_wall *wall, fw_vec2 point);

/* The force on a particle that goes from `from` to `to` in a step. */
fw_vec2 fw_penalty_force(const fw_wall *wall, fw_vec2 from, fw_vec2 to);

#endif
