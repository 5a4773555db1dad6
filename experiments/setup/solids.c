/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solids.c - one row for each material. Constant. */
#include "experiments/setup/solids.h"

#define SOLID(id, member, word, meaning) &fw_##member##_solid,
static const fw_solid_kind *const solids[] = {FW_MATERIAL_ROWS(SOLID)};

const fw_solid_kind *fw_solid_kind_at(fw_material_kind kind)
{
    return solids[kind];
}

const fw_solid_kind *fw_solid_kind_of(const fw_scenario *scenario, int body)
{
    return solids[scenario->materials[scenario->bodies[body].material].kind];
}
