/* SPDX-License-Identifier: GPL-3.0-or-later */
/* compare.h - are two results the same, bit by bit? */
#ifndef FW_COMPARE_H
#define FW_COMPARE_H

#include "experiments/results/playback.h"

#include <stdio.h>

/* Writes a line on `out` for each thing that differs (particles, frames, samples, positions,
 * velocities, forces, fields, observables; not profiles and analyses), with where it differs first
 * and by how much at most. *differing: how many do. Failures are those of reading. */
fw_status fw_compare(fw_playback *one, fw_playback *other, FILE *out, int *differing,
                     fw_error *error);

/* Writes a line for each fact of the provenance that could explain it: program, compiler, flags,
 * instruction set, libraries. Returns how many differ. */
int fw_compare_provenance(fw_playback *one, fw_playback *other, FILE *out);

#endif
