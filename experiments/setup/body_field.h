/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_field.h - a number per particle of a body: what its solid has, and what contact has done to
 * it. */
#ifndef FW_BODY_FIELD_H
#define FW_BODY_FIELD_H

#include "experiments/setup/experiment.h"

typedef struct fw_body_field {
    const char *name, *unit, *meaning; /* NULL: there is none */
    const fw_field *of_solid;          /* one of these ... */
    const fw_contact_field *of_contact;
} fw_body_field;

fw_body_field fw_body_field_find(const fw_experiment *experiment, int body, const char *name);
/* The n-th that there is; name NULL after the last. */
fw_body_field fw_body_field_at(const fw_experiment *experiment, int body, int n);
/* Of all particles of the body's solid. */
void fw_body_field_fill(const fw_experiment *experiment, int body, const fw_body_field *field,
                        double *values);

#endif
