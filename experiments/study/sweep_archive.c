/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_archive.c - the tables of a sweep as one HDF5 file: `cases` with a row per case, `seeds`
 * with a row per case and seed. Keeps no state. Start reading at fw_sweep_seeds_write_hdf5(). */
#include "sweep_seeds.h"

#include "experiments/results/unit_attribute.h"
#include "experiments/storage/folder.h"
#include "experiments/storage/hdf5_file.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/regular_file.h"
#include "experiments/storage/sealed_file.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_SIZE = FW_SWEEP_NAME + 64, STRUCTURE = 1 << 16 };
static const size_t largest = (size_t)1 << 32;

/* "energy, at the end" as part of a path: no name of a scenario has a '/'. */
static const char *join(char path[PATH_SIZE], const char *group, const char *name, const char *part)
{
    snprintf(path, PATH_SIZE, "%s/%.*s%s%s", group, FW_SWEEP_NAME, name, part[0] ? "/" : "", part);
    return path;
}

static void put(fw_hdf5 *file, const char *path, fw_element element, int count, const void *values)
{
    const uint64_t extent = (uint64_t)count;
    const fw_dataset made = fw_hdf5_make_array(file, path, element, 1, &extent);
    fw_hdf5_write(file, made, element, 0, extent, values);
    fw_hdf5_release(made);
}

/* Of each row the value of its case. */
static void put_parameters(fw_hdf5 *file, const fw_sweep_table *table, const char *group,
                           int per_case, double *room)
{
    char path[PATH_SIZE];
    fw_hdf5_make_group(file, group);
    for (int a = 0; a < table->axis_count; ++a) {
        for (int r = 0; r < table->row_count * per_case; ++r)
            room[r] = table->values[r / per_case * table->axis_count + a];
        join(path, group, table->axes[a].name, "");
        put(file, path, FW_F64, table->row_count * per_case, room);
        fw_unit_attach(file, table->units, path, table->axes[a].unit);
    }
}

static void put_cases(fw_hdf5 *file, const fw_sweep_seeds *seeds, double *room)
{
    const fw_sweep_table *table = seeds->table;
    char path[PATH_SIZE];
    fw_hdf5_make_group(file, "cases");
    put_parameters(file, table, "cases/parameters", 1, room);
    for (int r = 0; r < table->row_count; ++r) room[r] = seeds->seed_count;
    put(file, "cases/seeds", FW_F64, table->row_count, room);
    for (int r = 0; r < table->row_count; ++r) room[r] = table->failures[r] != NULL;
    put(file, "cases/failed", FW_F64, table->row_count, room);
    fw_hdf5_make_group(file, "cases/numbers");
    for (int c = 0; c < table->column_count; ++c) {
        const fw_sweep_column *column = &table->columns[c];
        const struct {
            const char *name;
            const double *values;
        } parts[] = {{"mean", column->mean},
                     {"error", column->error},
                     {"error-is-lower-bound", column->at_least},
                     {"expected", column->expected},
                     {"within", column->within}};
        fw_hdf5_make_group(file, join(path, "cases/numbers", column->name, ""));
        fw_unit_attach(file, table->units, path, column->unit);
        for (size_t p = 0; p < sizeof parts / sizeof parts[0]; ++p)
            put(file, join(path, "cases/numbers", column->name, parts[p].name), FW_F64,
                table->row_count, parts[p].values);
    }
}

static void put_seeds(fw_hdf5 *file, const fw_sweep_seeds *seeds, double *room)
{
    const fw_sweep_table *table = seeds->table;
    char path[PATH_SIZE];
    fw_hdf5_make_group(file, "seeds");
    put_parameters(file, table, "seeds/parameters", seeds->seed_count, room);
    for (int r = 0; r < seeds->row_count; ++r)
        room[r] = (double)(seeds->first + r % seeds->seed_count);
    put(file, "seeds/seed", FW_F64, seeds->row_count, room);
    for (int r = 0; r < seeds->row_count; ++r) room[r] = r / seeds->seed_count;
    put(file, "seeds/case", FW_F64, seeds->row_count, room);
    fw_hdf5_make_group(file, "seeds/numbers");
    for (int c = 0; c < table->column_count; ++c) {
        join(path, "seeds/numbers", table->columns[c].name, "");
        put(file, path, FW_F64, seeds->row_count, seeds->columns[c]);
        fw_unit_attach(file, table->units, path, table->columns[c].unit);
    }
}

static fw_status write_file(const fw_sweep_seeds *seeds, const char *title, const char *path,
                            fw_error *error)
{
    fw_hdf5 *file;
    double *room = fw_array_of_doubles((size_t)seeds->row_count + 1);
    if (!room) return fw_fail_memory(error, path);
    fw_status status = fw_hdf5_create(&file, path, STRUCTURE, error);
    if (status == FW_OK) {
        fw_hdf5_attach_text(file, "/", "title", title);
        put_cases(file, seeds, room);
        put_seeds(file, seeds, room);
        status = fw_hdf5_close(file, error);
    }
    free(room);
    return status;
}

/* First beside its place, so that what is there is always whole. */
fw_status fw_sweep_seeds_write_hdf5(const fw_sweep_seeds *seeds, const char *title,
                                    const char *directory, fw_error *error)
{
    char path[FW_PATH_SIZE], *bytes;
    size_t size;
    FW_TRY(fw_path_join(path, directory, FW_SWEEP_HDF5 FW_FRESH_SUFFIX, error));
    fw_status status = write_file(seeds, title, path, error);
    if (status == FW_OK) status = fw_regular_file_read(&bytes, &size, path, largest, error);
    unlink(path);
    FW_TRY(status);
    status = fw_manifest_write(directory, FW_SWEEP_HDF5, bytes, size, error);
    free(bytes);
    return status;
}
