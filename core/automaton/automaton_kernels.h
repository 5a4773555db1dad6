/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_kernels.h - the loops of a half-step over cells. */
#ifndef FW_AUTOMATON_KERNELS_H
#define FW_AUTOMATON_KERNELS_H

#include "automaton_body.h"

#include "core/instruction_set.h"

/* What is the same for all cells of the colour that moves. */
typedef struct fw_automaton_move {
    double *x, *y;                   /* displacements of that colour ... */
    const double *other_x, *other_y; /* ... and of the one that rests */
    fw_sym2 matrix[FW_DIRECTIONS];
    double share_of_pull;            /* (1 + a)/2 */
    double loss;                     /* (1 - a)/(1 + a) */
    const double *force_x, *force_y; /* of each particle; NULL: no loads */
    double break_at;                 /* stretch of a bond that breaks it */
    uint8_t *torn;                   /* of each cell: see the body's; NULL: unbreakable */
    bool mirror;                     /* the boundary rule of that name */
    bool fetches;                    /* the cells have to come from memory */
} fw_automaton_move;

enum { FW_AUTOMATON_TERMS_MAX = 1024 };

/* What cells one after the other add to energies and momentum. */
typedef struct fw_automaton_terms {
    double energy[FW_AUTOMATON_TERMS_MAX]; /* of their bonds, halved */
    double momentum_x[FW_AUTOMATON_TERMS_MAX], momentum_y[FW_AUTOMATON_TERMS_MAX];
    double kinetic[FW_AUTOMATON_TERMS_MAX];
} fw_automaton_terms;

typedef struct fw_automaton_kernels {
    /* Moves the cells of a span by (1 + a)/2 (s + F), s = sum_d matrix[d] (neighbour - self), and
     * adds what passed to the share. Breakable cells note the bonds that are stretched too far: by
     * where the cell was halfway, so that the ends of a bond in rigid motion are exactly at their
     * lattice distance. */
    void (*move)(const fw_automaton_move *move, const fw_automaton_span *span,
                 fw_automaton_share *share);
    /* The same of cells at a rim that nothing loads or damps. */
    void (*move_rim)(const fw_automaton_move *move, const fw_automaton_rim *rim, int count,
                     fw_automaton_share *share);
    /* Terms of `count` cells of a span, from a cell on, are put in their place from `at` on. */
    void (*terms)(const fw_automaton_move *move, const int offset[FW_DIRECTIONS], int cell,
                  int count, int at, fw_automaton_terms *terms);
} fw_automaton_kernels;

FW_KERNELS(fw_automaton_kernels, fw_automaton_kernels);

#endif
