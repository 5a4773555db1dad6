/* SPDX-License-Identifier: GPL-3.0-or-later */
/* unit_attribute.c - two texts beside a dataset. Keeps no state. */
#include "experiments/results/unit_attribute.h"

void fw_unit_attach(fw_hdf5 *file, const fw_units *units, const char *path, const char *unit)
{
    char physical[FW_PHYSICAL_TEXT];
    fw_hdf5_attach_text(file, path, "unit", unit);
    fw_units_print(physical, units, unit, 10);
    if (physical[0]) fw_hdf5_attach_text(file, path, "physical", physical);
}
