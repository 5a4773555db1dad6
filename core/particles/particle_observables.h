/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_observables.h - what is measured on movable lattice particles at one instant. All of
 * them only read. A group < 0 means all particles of the solid. */
#ifndef FW_PARTICLE_OBSERVABLES_H
#define FW_PARTICLE_OBSERVABLES_H

#include "core/particles/particles.h"

/* Mean velocity, weighted by mass. */
fw_vec2 fw_particle_drift_velocity(const fw_solid *solid, int group);

/* sum m |v - drift|^2 / (2 N): kB T where all 2 N degrees of freedom are thermal. */
double fw_particle_temperature(const fw_solid *solid, int group, fw_vec2 drift);

/* [sum m (v - V)(v - V) + virial]/area with V the drift velocity: the pressure tensor that a body
 * has in `area`. Its antisymmetric part is the torque density of return forces. */
fw_tensor fw_particle_pressure(const fw_solid *solid, int group, double area);

/* How well bonds (closer than the solid's bond radius, across bodies too) lie along axes. */
typedef struct fw_particle_order {
    double lab;          /* mean of cos n(phi - axes) over all bonds of the group's particles */
    double local;        /* mean of |psi_n| over particles with bonds, psi_n = mean e^{i n phi} */
    double coordination; /* mean number of bonds */
} fw_particle_order;
fw_particle_order fw_particle_order_of(const fw_solid *solid, int group);

/* |sum e^{i q . r}|^2/N^2 (Eqs 19-21, with the e^{i q . r} that Eq 19 lacks): 1 for a perfect
 * crystal at a vector of its reciprocal lattice, 1/N for a gas. */
double fw_particle_structure_factor(const fw_solid *solid, int group, fw_vec2 wave_vector);

/* Mean height of the first Bragg peaks that a crystal of fold 4 or 6 and lattice angle `angle` (of
 * a row of bonds) would have: the largest structure factor in a square window about each of its
 * shortest reciprocal vectors, which reaches `tolerance` of the vector's length along it and
 * across. Crystals that are turned or stretched by less are found. Takes a time that grows with the
 * number of particles times the body's area. */
double fw_particle_bragg_peak(const fw_solid *solid, int group, int fold, double angle,
                              double spacing, double tolerance);

/* Radial distribution: g[k] for k step <= r < (k + 1) step, k < bins: neighbours found, over those
 * of an ideal gas of that number density. FW_SYSTEM_FAILED without memory. */
fw_status fw_particle_pair_correlation(const fw_solid *solid, int group, double density,
                                       double step, int bins, double *g, fw_error *error);

#endif
