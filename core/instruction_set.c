/* SPDX-License-Identifier: GPL-3.0-or-later */
/* instruction_set.c - what the processor can, and what was chosen of it.
 * State: the choice, for the whole program. */
#include "core/instruction_set.h"

#include <string.h>

#if defined(__x86_64__)
static const char *const names[FW_INSTRUCTION_SETS] = {"x86-64-v2", "x86-64-v3", "x86-64-v4"};
#else
static const char *const names[FW_INSTRUCTION_SETS] = {"plain"};
#endif

/* -1: not chosen yet. Every thread that finds that chooses the same. */
static int chosen = -1;

bool fw_instruction_set_runs(int set)
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi2");
    const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    return set == 0 || (v3 && (set == 1 || v4));
#else
    return set == 0;
#endif
}

int fw_instruction_set(void)
{
    int set;
#pragma omp atomic read
    set = chosen;
    if (set >= 0) return set;
    set = FW_INSTRUCTION_SETS - 1;
    while (!fw_instruction_set_runs(set)) --set;
#pragma omp atomic write
    chosen = set;
    return set;
}

const char *fw_instruction_set_name(int set)
{
    return names[set];
}

fw_status fw_instruction_set_use(const char *name, fw_error *error)
{
    for (int set = 0; set < FW_INSTRUCTION_SETS; ++set) {
        if (strcmp(name, names[set]) != 0) continue;
        if (!fw_instruction_set_runs(set))
            return fw_fail(error, FW_BAD_INPUT,
                           "this processor does not have the instructions %s, expected %s or less",
                           name, names[fw_instruction_set()]);
#pragma omp atomic write
        chosen = set;
        return FW_OK;
    }
    return fw_fail(error, FW_BAD_INPUT, "no instructions \"%.40s\", expected one of %s to %s", name,
                   names[0], names[FW_INSTRUCTION_SETS - 1]);
}
