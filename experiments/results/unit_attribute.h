/* SPDX-License-Identifier: GPL-3.0-or-later */
/* unit_attribute.h - the unit of what lies in a file of results. */
#ifndef FW_UNIT_ATTRIBUTE_H
#define FW_UNIT_ATTRIBUTE_H

#include "experiments/storage/hdf5_file.h"
#include "experiments/units/units.h"

/* Attribute `unit` of what lies at `path`, and `physical`, what one of it is in nature, where that
 * is known; units NULL: it is not. Failures stick to the file. */
void fw_unit_attach(fw_hdf5 *file, const fw_units *units, const char *path, const char *unit);

#endif
