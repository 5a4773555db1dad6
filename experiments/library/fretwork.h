/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fretwork.h - libfretwork: everything that a program includes of it, from C or from C++.
 *
 * Two heights. Whoever has a scenario, or wants to run one of the catalogue, takes a simulation
 * (simulation.h): it is made of a file, a name or a text, advanced, and looked at, and it measures
 * and records as the program `fretwork` does. Whoever builds by hand makes solids (lb_solid.h,
 * elastic_automaton.h, linear_lattice.h, particles.h), puts them into a scene with walls, pistons,
 * grips and loads, and steps it (scene.h). A simulation's scene can be looked at in the same way.
 *
 * What is stable. Until version 1.0 a change of the second number of the version may change
 * anything here, a change of the third one nothing; the name of the shared library holds the first
 * two. Meant to stay: all of simulation.h and status.h; of the solids the ..._def structures, their
 * defaults, and create; of scene.h what makes, steps and looks at a scene; wall.h, path.h, drive.h,
 * grip.h, piston.h and load.h. May change with any second number: solid.h but its head, since it is
 * how solids and contact speak with each other, and facet.h, wall_shape.h, arena.h, array.h and
 * langevin.h but for its controls, which are here because others are made of them.
 *
 * Errors. What can fail returns an fw_status; a sentence says what was found and what was expected.
 * Nothing prints, nothing ends the process, and no signal is taken. A mistake of the calling
 * program, such as a body that does not exist, is an assert in a library built for debugging and
 * not looked for otherwise.
 *
 * Threads. Different simulations and scenes may be used by different threads at a time; one of them
 * by one thread at a time. Results are the same bytes for any number of threads. Loops of large
 * solids run on as many threads as OpenMP is told (omp_set_num_threads); a simulation sets that
 * number for its own steps alone. With OMP_WAIT_POLICY=passive in the environment threads that wait
 * sleep, which is quicker where cores are shared. Files are written one at a time; a program that
 * uses HDF5 itself must not do so in another thread while a simulation with a directory advances,
 * and closes its files before it ends: HDF5 no longer does that for it.
 *
 * Units are reduced, as everywhere in Fretwork; the manual says how for each solid. */
#ifndef FW_FRETWORK_H
#define FW_FRETWORK_H

#include "contact/scene/scene.h"
#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/lattice.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"
#include "core/placement.h"
#include "core/public.h"
#include "core/solid.h"
#include "core/status.h"
#include "core/vec2.h"
#include "experiments/library/simulation.h"

FW_PUBLIC_BEGIN

/* Of the library that runs: "0.1.0". */
const char *fw_version(void);

FW_PUBLIC_END

#endif
