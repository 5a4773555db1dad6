/* SPDX-License-Identifier: GPL-3.0-or-later */
/* instruction_set.h - which of the compiled kernels run.
 *
 * A kernel is a file of loops over particles that is compiled once for each instruction set
 * (KERNELS of fretwork_wing() in CMake), written with the vectors of core/vectors.h. It ends with a const
 * table of its functions, whose name FW_KERNELS_HERE completes; its header declares them all:
 *     FW_KERNELS(fw_noise_kernels, fw_noise);              in the header
 *     const fw_noise_kernels FW_KERNELS_HERE(fw_noise) = {...};     in the kernel's file
 *     FW_KERNELS_CHOSEN(fw_noise)->gaussians(...);         where it is used
 * The choice falls once, by what the processor can, unless fw_instruction_set_use() makes another.
 * All kernels give the same bytes. */
#ifndef FW_INSTRUCTION_SET_H
#define FW_INSTRUCTION_SET_H

#include "core/status.h"

#include <stdbool.h>

/* In ascending order. Elsewhere than on x86-64 there is but one. */
#if defined(__x86_64__)
#define FW_INSTRUCTION_SETS     3 /* x86-64-v2, -v3 (AVX2), -v4 (AVX-512) */
#define FW_KERNELS(type, table) extern const type table##_v2, table##_v3, table##_v4
#define FW_KERNELS_CHOSEN(table)                                                                   \
    (fw_instruction_set() == 2   ? &table##_v4                                                     \
     : fw_instruction_set() == 1 ? &table##_v3                                                     \
                                 : &table##_v2)
#else
#define FW_INSTRUCTION_SETS      1
#define FW_KERNELS(type, table)  extern const type table##_plain
#define FW_KERNELS_CHOSEN(table) (&table##_plain)
#endif

/* FW_INSTRUCTIONS is what CMake compiles the file for: v2, v3, v4, plain. */
#define FW_KERNELS_HERE(table)            FW_KERNELS_PASTE(table, FW_INSTRUCTIONS)
#define FW_KERNELS_PASTE(table, level)    FW_KERNELS_PASTE_IT(table, level)
#define FW_KERNELS_PASTE_IT(table, level) table##_##level

/* Index of the chosen one, 0 to FW_INSTRUCTION_SETS - 1. */
int fw_instruction_set(void);
/* "x86-64-v3"; "plain" where there is but one. */
const char *fw_instruction_set_name(int set);
/* Does this processor have it? */
bool fw_instruction_set_runs(int set);
/* Chooses by name; to be called before any thread runs kernels. FW_BAD_INPUT: no such name, or the
 * processor cannot; the choice stays as it was. */
fw_status fw_instruction_set_use(const char *name, fw_error *error);

#endif
