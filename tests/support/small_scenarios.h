/* SPDX-License-Identifier: GPL-3.0-or-later */
/* small_scenarios.h - scenarios that run in a blink and use much of what there is: tests that let
 * one thing after the other fail run them once for each. */
#ifndef FW_SMALL_SCENARIOS_H
#define FW_SMALL_SCENARIOS_H

static const char two_blocks[] =
    "title: two blocks and a wall\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0, damping: .05}}}\n"
    "bodies:\n"
    "  upper: {material: soft, shape: {rectangle: [4, 3]}, origin: [.3, 3.05], velocity: [.01, "
    "-.02]}\n"
    "  lower: {material: soft, shape: {rectangle: [5, 3]}}\n"
    "contact: {friction: .3}\n"
    "walls: {floor: {chain: [[-5, -.1], [9, -.1]], surface: {coulomb: .2}}}\n"
    "forces: {weight: {body: upper, acceleration: [0, -.0005]}}\n"
    "run: {steps: 60, record-every: 10, measure-every: 10, checkpoint-every: 20}\n"
    "record: {fields: [strain-yy]}\n"
    "measure: [energy, momentum]\n"
    "expect: [{quantity: energy, statistic: largest, above: 0}]\n"
    "pictures: {motion: {kind: motion, instants: [0, 60]}}\n";

static const char held_crystal[] =
    "title: a crystal with a bath, held\n"
    "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: corotating}}}}\n"
    "bodies: {block: {material: crystal, lattice: hexagonal, shape: {rectangle: [6, 5]}, "
    "temperature: .01}}\n"
    "dynamics: {time-step: .005, damping: 1, temperature: .01}\n"
    "grips: {hand: {body: block, side: left, layer: .5, hold: both}}\n"
    "run: {steps: 20, record-every: 10, measure-every: 5}\n"
    "record: {fields: [local-order]}\n"
    "measure: [energy]\n"
    "profile: {every: 5, bin: 1, middle: 2, far: [0.5, 3]}\n"
    "study: {seeds: 2}\n"
    "pictures: {energy: {kind: series, observables: [energy]}}\n";

#endif
