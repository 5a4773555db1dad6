/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interrupt.h - SIGINT and SIGTERM, noted for a run to end at its next step. */
#ifndef FW_INTERRUPT_H
#define FW_INTERRUPT_H

#include "core/status.h"

/* From now on the signals are noted instead of ending the process; a second one of the same kind
 * ends it as usual. */
void fw_interrupt_watch(void);

/* FW_OK, FW_INTERRUPTED (SIGINT) or FW_TERMINATED (SIGTERM). */
fw_status fw_interrupt_seen(void);

#endif
