/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sliding_block.h - a block that slides on a floor until it sticks, for tests of pictures of
 * friction; and another one that touches nothing. */
#ifndef FW_SLIDING_BLOCK_H
#define FW_SLIDING_BLOCK_H

#define SLIDING_BLOCK                                                                              \
    "title: A block slides until it sticks\n"                                                      \
    "materials: {felt: {lattice-boltzmann: {rest-mass: 0.5, damping: 0.01}}}\n"                    \
    "bodies:\n"                                                                                    \
    "  block: {material: felt, shape: {rectangle: [6, 3]}, velocity: [0.05, 0]}\n"                 \
    "  far: {material: felt, shape: {rectangle: [2, 2]}, origin: [20, 9]}\n"                       \
    "walls: {floor: {chain: [[-100, 0], [100, 0]], surface: {coulomb: 0.3}}}\n"                    \
    "forces: {weight: {body: block, acceleration: [0, -0.002]}}\n"                                 \
    "run: {steps: 300, record-every: 20}\n"                                                        \
    "measure: [friction-heat]\n"

#endif
