/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interrupt.h - SIGINT, SIGTERM and SIGHUP, noted for a run to end at its next step. */
#ifndef FW_INTERRUPT_H
#define FW_INTERRUPT_H

#include "core/status.h"

#include <stdbool.h>

/* From now on these signals are noted instead of ending the process; one that was ignored at the
 * start stays ignored, as under nohup. Another one that comes half a second after the first or
 * later ends the process as usual, but not while a checkpoint is being written. (Terminals and
 * shells may send one signal twice within an instant.) */
void fw_interrupt_watch(void);
/* From now on the signals do what they did before. */
void fw_interrupt_leave(void);

/* Between these the process is not ended by a second signal. */
void fw_interrupt_hold(void);
void fw_interrupt_release(void);

/* FW_OK, FW_HUNG_UP (SIGHUP), FW_INTERRUPTED (SIGINT) or FW_TERMINATED (SIGTERM). */
fw_status fw_interrupt_seen(void);
/* Is it one of these three? */
bool fw_interrupt_is(fw_status status);

#endif
