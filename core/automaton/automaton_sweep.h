/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_sweep.h - half-steps row by row, shared by automaton_sweep.c (one at a time) and
 * automaton_wave.c (many in one sweep through memory). */
#ifndef FW_AUTOMATON_SWEEP_H
#define FW_AUTOMATON_SWEEP_H

#include "automaton_body.h"
#include "automaton_kernels.h"

enum {
    FW_THREADS_FROM = 32768, /* particles from which a body is worth two threads */
    FW_RECENTRE_EVERY = 16,  /* ticks */
    FW_SHARED_TICKS = 4      /* so many ticks of all rows have room in body->share */
};

/* What is the same for all cells in a half-step. */
typedef struct fw_half_step {
    const fw_automaton *body;
    int colour;
    const fw_constraint *constraints; /* NULL: nothing is held */
    double share_of_pull;             /* (1 + a)/2 */
    double loss;                      /* (1 - a)/(1 + a) */
    const fw_automaton_kernels *kernels;
    fw_automaton_move move; /* for the kernels */
} fw_half_step;

fw_half_step fw_half_step_of(const fw_automaton *body, int colour);

/* Does what passes through the cells' bounds change the ledger? */
static inline bool fw_half_step_passes(const fw_half_step *step)
{
    return step->body->head.loaded || step->loss > 0;
}

/* What the half-step brings a cell of its colour on which its neighbours pull so. */
fw_prediction fw_half_step_predict(const fw_half_step *step, int particle, fw_vec2 pull);

/* Moves the cells of a row. `share`: what they add to the ledger; all zero if nothing passes
 * and nothing tears. */
void fw_half_step_move_row(const fw_half_step *step, int row, fw_automaton_share *share);

/* Ends a half-step, or several: adds the rows' shares of one to the ledger. */
void fw_automaton_book(fw_automaton *body, const fw_automaton_share *shares);
/* Breaks the bonds of a row of the colour that has moved, in that tick of those that are taken
 * together, and after all of them: in order of black cells, by ticks into the ledger. Threads keep
 * off. */
fw_status fw_automaton_tear_row(fw_automaton *body, int colour, int row, int tick, fw_error *error);
void fw_automaton_sort_tears(fw_automaton *body);
void fw_automaton_book_tears(fw_automaton *body, int tick);
/* Counts ticks that were taken; displacements stay small. */
void fw_automaton_tick(fw_automaton *body, int ticks);

#endif
