/* SPDX-License-Identifier: GPL-3.0-or-later */
/* steps.h - ticks of a solid that must not fail. */
#ifndef FW_STEPS_H
#define FW_STEPS_H

#include "core/solid.h"
#include "tests/support/laws.h"

static inline void assert_moved(fw_status status, const fw_error *error)
{
    if (status != FW_OK) fail_msg("%s", error->sentence);
}

static inline void advance_free(fw_solid *solid)
{
    fw_error error = {0};
    assert_moved(fw_solid_advance_free(solid, &error), &error);
}

static inline void advance_held(fw_solid *solid, const fw_constraint *constraints,
                                int constraint_count)
{
    fw_error error = {0};
    assert_moved(fw_solid_advance(solid, constraints, constraint_count, &error), &error);
}

/* After state was written from outside. */
static inline void restore(fw_solid *solid)
{
    fw_error error = {0};
    assert_moved(fw_solid_restored(solid, &error), &error);
}

#endif
