/* SPDX-License-Identifier: GPL-3.0-or-later */
/* beams.h - two small beams in grips, rubbed against each other. */
#ifndef FW_TEST_BEAMS_H
#define FW_TEST_BEAMS_H

/* 6 columns of 8 against 10 rows of 5, rubbed for some cycles. */
static const char small_beams[] =
    "title: two small beams\n"
    "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  left: {material: crystal, lattice: hexagonal, angle: 90, shape: {rectangle: [8, 6]},\n"
    "    origin: [-0.5, -3.75]}\n"
    "  right: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 10]},\n"
    "    origin: [0.5, -3.9]}\n"
    "dynamics: {time-step: 0.005, damping: 0.3, temperature: 0.0005}\n"
    "grips:\n"
    "  left: {body: left, side: left, layer: 1.34, force: [16, 0], tether: [0, 1]}\n"
    "  right: {body: right, side: right, layer: 1.34, force: [-16, 0], tether: [0, 1]}\n"
    "phases:\n"
    "  settle: {until: 500, damping: 1}\n"
    "  drive: {until: 1500, temperature: 0.001, grips: {\n"
    "    left: {force: [16, 0], amplitude: [0, 30], period: 4, tether: [0, 1]},\n"
    "    right: {force: [-16, 0], amplitude: [0, -30], period: 4, tether: [0, 1]}}}\n"
    "  sample: {until: 2500, grips: {\n"
    "    left: {force: [16, 0], amplitude: [0, 30], period: 4, tether: [0, 1]},\n"
    "    right: {force: [-16, 0], amplitude: [0, -30], period: 4, tether: [0, 1]}}}\n"
    "run: {steps: 2500, measure-every: 10}\n"
    "record: {fields: [return-force]}\n"
    "profile: {axis: x, phase: sample, every: 100, far: [2.5, 4], contact: 1.2}\n"
    "study: {seeds: 2, control: [\n"
    "  'phases.drive.grips.left.amplitude=[0, 0]', 'phases.drive.grips.right.amplitude=[0, 0]',\n"
    "  'phases.sample.grips.left.amplitude=[0, 0]',\n"
    "  'phases.sample.grips.right.amplitude=[0, 0]']}\n"
    "expect: [{quantity: layer-contact-over-control, above: 1}]\n";

#endif
