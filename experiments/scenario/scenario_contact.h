/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_contact.h - how surfaces rub on each other, as plain data. */
#ifndef FW_SCENARIO_CONTACT_H
#define FW_SCENARIO_CONTACT_H

#include "contact/constraint/friction_law.h"
#include "experiments/schema/schema.h"

/* Surfaces count from 0, which is that of bodies without a name for theirs. */
typedef struct fw_scenario_contact {
    int surface_count;
    const char **surfaces; /* names; NULL: of surface 0 */
    double distance;    /* that bodies keep from walls, and from each other if no pair says else */
    double *distances;  /* that bodies keep from each other, as `pairs` */
    fw_friction *pairs; /* [surface_count][surface_count], the same both ways */
} fw_scenario_contact;

#endif
