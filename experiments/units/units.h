/* SPDX-License-Identifier: GPL-3.0-or-later */
/* units.h - what one of each reduced unit is in nature: a length of 1 is .286 nm, an energy of 1
 * .74 eV. The scenario, the run and what is stored of it stay reduced; whoever shows a number asks
 * here what else to say of it.
 *
 * A unit of the program is written as in its tables: "length", "energy/k_B", "force/length",
 * "(spacings/step)^2". From three of length, time, mass and energy all others follow, with
 * energy = mass length^2/time^2. */
#ifndef FW_UNITS_H
#define FW_UNITS_H

#include "experiments/schema/schema.h"

#include <stdio.h>

enum { FW_UNIT_TEXT = 48 };

/* A unit of nature, "nm", and its size in SI units, 1e-9. */
typedef struct fw_unit_name {
    char text[16];
    double size;
} fw_unit_name;

/* All zero: none are given. */
typedef struct fw_units {
    /* As written, "0.286 nm"; of time and energy one; depth may be NULL. Owned by the document. */
    const char *length_text, *time_text, *mass_text, *energy_text, *depth_text;
    /* From fw_units_complete: of one reduced unit, in m, s, kg, J. */
    double length, time, mass, energy;
    double depth; /* of the layer that the plane stands for, in m; 0: none */
    fw_unit_name length_name, time_name, mass_name, energy_name; /* in which they are shown */
} fw_units;

extern const fw_section fw_units_section;

/* Reads what is written. FW_BAD_INPUT: the sentence says what is wrong with the key *key. */
fw_status fw_units_complete(fw_units *units, const char **key, fw_error *error);

static inline bool fw_units_given(const fw_units *units)
{
    return units->length > 0;
}

/* What one of a unit of the program is: `factor` of `text`, .74 of "eV". Factor 0: nothing, for
 * there are no units (also NULL), or it is a pure number, an angle or a count. */
typedef struct fw_physical {
    double factor;
    char text[FW_UNIT_TEXT];
} fw_physical;
fw_physical fw_units_physical(const fw_units *units, const char *unit);

/* The value in that unit; as it is where there is none. */
static inline double fw_physical_value(const fw_physical *physical, double value)
{
    return physical->factor > 0 ? physical->factor * value : value;
}

/* "0.74 eV", with so many digits; "" where there is nothing to say. */
enum { FW_PHYSICAL_TEXT = FW_UNIT_TEXT + 32 };
void fw_units_print(char text[FW_PHYSICAL_TEXT], const fw_units *units, const char *unit,
                    int digits);

/* For the heads of tables: "energy = 0.74 eV", or the unit alone where there is no more to say. */
enum { FW_UNITS_SAID = 160 };
void fw_units_say(char text[FW_UNITS_SAID], const fw_units *units, const char *unit);
/* "length 0.2556 nm, mass 63.55 u, time 0.3242 ps, ...": what is most asked for, on one line;
 * temperatures only where something is `warm`. */
void fw_units_list(FILE *out, const fw_units *units, bool warm);

#endif
