/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failing_reads.h - what is read of a result fails in the order of the allocations: of tests that
 * are linked so (tests/CMakeLists.txt). */
#ifndef FW_FAILING_READS_H
#define FW_FAILING_READS_H

#include "experiments/results/playback.h"
#include "tests/support/short_memory.h"

#define FAILING_READ(name, ask, give)                                                              \
    fw_status __real_fw_playback_read_##name ask;                                                  \
    fw_status __wrap_fw_playback_read_##name ask;                                                  \
    fw_status __wrap_fw_playback_read_##name ask                                                   \
    {                                                                                              \
        return short_memory_fails_here() ? fw_fail_memory(e, "what is read")                       \
                                         : __real_fw_playback_read_##name give;                    \
    }
FAILING_READ(positions, (fw_playback * p, int64_t frame, double *x, double *y, fw_error *e),
             (p, frame, x, y, e))
FAILING_READ(velocities, (fw_playback * p, int64_t frame, double *x, double *y, fw_error *e),
             (p, frame, x, y, e))
FAILING_READ(forces, (fw_playback * p, int64_t frame, double *x, double *y, fw_error *e),
             (p, frame, x, y, e))
FAILING_READ(field,
             (fw_playback * p, int64_t frame, const char *field, double *values, fw_error *e),
             (p, frame, field, values, e))
FAILING_READ(masses, (fw_playback * p, double *masses, fw_error *e), (p, masses, e))
FAILING_READ(observable, (fw_playback * p, int number, double *values, fw_error *e),
             (p, number, values, e))
FAILING_READ(sample_times, (fw_playback * p, int64_t *steps, double *times, fw_error *e),
             (p, steps, times, e))
FAILING_READ(frame_times, (fw_playback * p, int64_t *steps, double *times, fw_error *e),
             (p, steps, times, e))
FAILING_READ(table,
             (fw_playback * p, const char *group, const char *name, fw_table *table, fw_error *e),
             (p, group, name, table, e))

#endif
