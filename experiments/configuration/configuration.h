/* SPDX-License-Identifier: GPL-3.0-or-later */
/* configuration.h - places of particles in a plane, from a file of another program: extended XYZ
 * (its last frame), or a data file of LAMMPS. What else is in such a file is passed over. */
#ifndef FW_CONFIGURATION_H
#define FW_CONFIGURATION_H

#include "core/status.h"
#include "core/vec2.h"

/* How many particles a scenario can hold as a text. */
enum { FW_CONFIGURATION_MOST = 300000 };

typedef struct fw_configuration {
    int count;
    fw_vec2 *place;   /* owned; in the order of the file, those of LAMMPS by their number */
    char (*kind)[16]; /* owned: the species or type of each, "Cu" or "1" */
} fw_configuration;

/* By the ending of its name: .xyz and .extxyz, or .data and .lmp. FW_BAD_INPUT, with
 * "FILE:LINE: ...", for what is no such file, has no particles or too many, or does not lie in one
 * plane z; FW_SYSTEM_FAILED. */
fw_status fw_configuration_read(fw_configuration *configuration, const char *path, fw_error *error);
void fw_configuration_clear(fw_configuration *configuration);

#endif
