/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_arrays.c - what a results file holds of the run as a whole: profiles, the certificate,
 * tables of analyses. Keeps no state. */
#include "trajectory_layout.h"

#include "experiments/results/unit_attribute.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Arrays of the run as a whole. They are no observables of H5MD: readers expect a row per frame of
 * these. */
void fw_layout_make_arrays(fw_hdf5 *file, const fw_trajectory_def *def)
{
    for (int i = 0; i < def->array_count; ++i) {
        const fw_trajectory_array *array = &def->arrays[i];
        char path[FW_NAME_SIZE + 64];
        const size_t group = strcspn(array->name, "/");
        const size_t count = (size_t)array->rows * (size_t)array->columns;
        if (i == 0 || strncmp(array->name, def->arrays[i - 1].name, group + 1) != 0) {
            snprintf(path, sizeof path, "parameters/%.*s", (int)group, array->name);
            fw_hdf5_make_group(file, path);
        }
        snprintf(path, sizeof path, "parameters/%s", array->name);
        uint64_t extent[2] = {(uint64_t)array->rows, (uint64_t)array->columns};
        if (array->rows == 1) extent[0] = extent[1];
        const int rank = array->rows > 1 && array->columns > 1 ? 2 : 1;
        double *unknown = fw_array_of_doubles(count);
        fw_dataset dataset = fw_hdf5_make_array(file, path, FW_F64, rank, extent);
        if (unknown) {
            for (size_t n = 0; n < count; ++n) unknown[n] = NAN;
            fw_hdf5_write(file, dataset, FW_F64, 0, extent[0], unknown);
        } else {
            fw_hdf5_give_up(file, "the arrays of a run");
        }
        free(unknown);
        fw_unit_attach(file, def->units, path, array->unit);
        fw_hdf5_attach_text(file, path, "meaning", array->meaning);
        if (array->columns > 1)
            fw_hdf5_attach_text(file, path, "columns",
                                "mean, standard error, control, its standard error");
    }
}

void fw_layout_make_tables(fw_hdf5 *file, const fw_trajectory_def *def)
{
    char path[3 * FW_NAME_SIZE];
    if (def->group_count > 0) fw_hdf5_make_group(file, "parameters/analysis");
    for (int g = 0; g < def->group_count; ++g) {
        const fw_table_group *group = &def->groups[g];
        snprintf(path, sizeof path, "parameters/analysis/%s", group->name);
        fw_hdf5_make_group(file, path);
        for (int n = 0; n < group->table_count; ++n) {
            const fw_table *table = &group->tables[n];
            const uint64_t extent[] = {(uint64_t)table->extent[0], (uint64_t)table->extent[1]};
            snprintf(path, sizeof path, "parameters/analysis/%s/%s", group->name, table->name);
            fw_dataset made = fw_hdf5_make_array(file, path, FW_F64, table->rank, extent);
            fw_hdf5_write(file, made, FW_F64, 0, extent[0], table->values);
            fw_unit_attach(file, def->units, path, table->unit);
            fw_hdf5_attach_text(file, path, "meaning", table->meaning);
        }
    }
}
