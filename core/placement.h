/* SPDX-License-Identifier: GPL-3.0-or-later */
/* placement.h - random sequential placement: particles are dropped one after the other, uniformly
 * in a rectangle; one that would lie too near an earlier one is dropped again.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_PLACEMENT_H
#define FW_PLACEMENT_H

#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdint.h>

FW_PUBLIC_BEGIN

/* Writes `count` positions in [low, high), no two closer than `distance` >= 0. The same seed gives
 * the same places. FW_BAD_INPUT with a sentence for an empty rectangle, at once where so many
 * cannot lie or would jam, and when after 1000 drops per particle not all have found a place;
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_placement_random(fw_vec2 *positions, int count, fw_vec2 low, fw_vec2 high,
                              double distance, uint64_t seed, fw_error *error);

FW_PUBLIC_END

#endif
