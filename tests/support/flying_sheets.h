/* SPDX-License-Identifier: GPL-3.0-or-later */
/* flying_sheets.h - a sweep whose numbers are known in closed form, for tests of its pictures. */
#ifndef FW_FLYING_SHEETS_H
#define FW_FLYING_SHEETS_H

/* A sheet that flies from x0 with v for 40 steps: its centre comes to x0 + 1.5 + 40 v. */
#define FLIGHT(parameters, expected)                                                               \
    "title: a sheet flies\n"                                                                       \
    "parameters: {v: .1, x0: 0}\n"                                                                 \
    "materials: {rubber: {lattice-boltzmann: {}}}\n"                                               \
    "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [x0, 0],\n"            \
    "  velocity: [v, 0]}}\n"                                                                       \
    "run: {steps: 40, record-every: 40, measure-every: 40}\n"                                      \
    "study: {sweep: {parameters: {" parameters "}}}\n"                                             \
    "expect: [{quantity: centre-of-mass, component: x, " expected "}]\n"

#endif
