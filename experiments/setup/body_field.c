/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_field.c - the fields of a body's solid and those of contact as one list. Keeps no state. */
#include "experiments/setup/body_field.h"

#include <string.h>

fw_body_field fw_body_field_at(const fw_experiment *experiment, int body, int n)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    const int number = experiment->bodies[body].solid;
    for (const fw_field *field = solid->model->fields; field && field->name; ++field)
        if (n-- == 0) return (fw_body_field){field->name, field->unit, field->meaning, field, NULL};
    for (const fw_contact_field *field = fw_contact_fields; field->name; ++field)
        if (fw_scene_find_field(experiment->scene, number, field->name) && n-- == 0)
            return (fw_body_field){field->name, field->unit, field->meaning, NULL, field};
    return (fw_body_field){0};
}

fw_body_field fw_body_field_find(const fw_experiment *experiment, int body, const char *name)
{
    fw_body_field field;
    for (int n = 0; (field = fw_body_field_at(experiment, body, n)).name; ++n)
        if (strcmp(field.name, name) == 0) break;
    return field;
}

void fw_body_field_fill(const fw_experiment *experiment, int body, const fw_body_field *field,
                        double *values)
{
    if (field->of_solid)
        field->of_solid->fill(fw_experiment_solid(experiment, body), values);
    else
        fw_scene_fill_field(experiment->scene, experiment->bodies[body].solid, field->of_contact,
                            values);
}
