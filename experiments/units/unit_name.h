/* SPDX-License-Identifier: GPL-3.0-or-later */
/* unit_name.h - units by the names that people write: "nm", "meV", "kg"; for the files of this
 * folder alone. */
#ifndef FW_UNIT_NAME_H
#define FW_UNIT_NAME_H

#include "units.h"

#include <stdbool.h>
#include <stddef.h>

/* What a unit measures: its powers of metre, second, kilogram and kelvin. */
typedef struct fw_dimension {
    double length, time, mass, temperature;
} fw_dimension;

/* CODATA 2018, exact. */
#define ELECTRON_VOLT 1.602176634e-19

bool fw_dimension_equal(fw_dimension one, fw_dimension other);

typedef enum fw_unit_kind {
    FW_UNIT_LENGTH,
    FW_UNIT_TIME,
    FW_UNIT_MASS,
    FW_UNIT_ENERGY,
    FW_UNIT_KINDS
} fw_unit_kind;

/* What may be written for a unit of this kind, for sentences: "a unit of time: s with any prefix".
 */
const char *fw_unit_kind_choice(fw_unit_kind kind);

/* The unit of this name; false: there is none of this kind. */
bool fw_unit_name_read(fw_unit_kind kind, const char *text, size_t length, fw_unit_name *name);

/* `symbol`, which is `si` in SI units, with the largest prefix in which `value` (in SI) is at least
 * a tenth; `symbol` alone for a value that is 0. */
fw_unit_name fw_unit_name_prefixed(const char *symbol, double si, double value);

#endif
