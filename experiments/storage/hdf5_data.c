/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_data.c - finding datasets and attributes, and reading and writing what they hold. Keeps no
 * state beyond the file's; start reading at select_rows(). */
#include "hdf5_parts.h"

#include <stdlib.h>
#include <string.h>

fw_dataset fw_hdf5_find(fw_hdf5 *file, const char *path)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return -1;
    hid_t dataset = H5Dopen2(file->id, path, H5P_DEFAULT);
    if (dataset < 0) fw_hdf5_miss(file);
    return dataset;
}

void fw_hdf5_release(fw_dataset dataset)
{
    FW_HDF5_ALONE;
    if (dataset >= 0) H5Dclose(dataset);
}

/* Which of the project's elements a number of the file is; false for all others. */
static bool recognise(hid_t type, fw_shape *shape)
{
    H5T_class_t class = H5Tget_class(type);
    shape->width = H5Tget_size(type);
    shape->text = class == H5T_STRING && H5Tis_variable_str(type) == 0;
    if (shape->text) return true;
    if (class == H5T_FLOAT && shape->width == 8)
        shape->element = FW_F64;
    else if (class == H5T_INTEGER && shape->width == 8)
        shape->element = FW_I64;
    else if (class == H5T_INTEGER && shape->width == 4)
        shape->element = FW_I32;
    else if (class == H5T_INTEGER && shape->width == 1)
        shape->element = FW_U8;
    else
        return false;
    return true;
}

bool fw_hdf5_shape(fw_hdf5 *file, fw_dataset dataset, fw_shape *shape)
{
    FW_HDF5_ALONE;
    *shape = (fw_shape){0};
    if (fw_hdf5_failed(file) || dataset < 0) return false;
    hid_t type = H5Dget_type(dataset), space = H5Dget_space(dataset);
    hsize_t extent[H5S_MAX_RANK] = {0};
    shape->rank = H5Sget_simple_extent_ndims(space);
    bool known = recognise(type, shape) && shape->rank >= 0 && shape->rank <= FW_DATASET_RANK &&
                 H5Sget_simple_extent_dims(space, extent, NULL) >= 0;
    for (int i = 0; known && i < shape->rank; ++i) shape->extent[i] = extent[i];
    H5Sclose(space);
    H5Tclose(type);
    H5Eclear2(H5E_DEFAULT);
    return known;
}

bool fw_hdf5_is_stored(fw_hdf5 *file, fw_dataset dataset)
{
    FW_HDF5_ALONE;
    fw_shape shape;
    hsize_t size = 0;
    if (!fw_hdf5_shape(file, dataset, &shape) || H5Fget_filesize(file->id, &size) < 0) return false;
    double claimed = (double)shape.width;
    for (int i = 0; i < shape.rank; ++i) claimed *= (double)shape.extent[i];
    double stored = (double)H5Dget_storage_size(dataset);
    return claimed <= stored && stored <= (double)size;
}

int fw_hdf5_list(fw_hdf5 *file, const char *path, char *names, int size, int capacity)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return 0;
    int count = 0;
    H5G_info_t members = {0};
    if (H5Gget_info_by_name(file->id, path, &members, H5P_DEFAULT) < 0) {
        fw_hdf5_miss(file);
        return -1;
    }
    for (hsize_t i = 0; i < members.nlinks; ++i) {
        char *name = count < capacity ? names + (size_t)count * (size_t)size : NULL;
        ssize_t length = H5Lget_name_by_idx(file->id, path, H5_INDEX_CRT_ORDER, H5_ITER_INC, i,
                                            name, name ? (size_t)size : 0, H5P_DEFAULT);
        if (length < 0) fw_hdf5_miss(file);
        if (length >= 0 && length < size) ++count;
    }
    return count;
}

bool fw_hdf5_read_attributes(fw_hdf5 *file, const char *path, const char *name, char *texts,
                             size_t size, int count)
{
    FW_HDF5_ALONE;
    memset(texts, 0, size * (size_t)count);
    if (fw_hdf5_failed(file)) return false;
    hid_t attribute = H5Aopen_by_name(file->id, path, name, H5P_DEFAULT, H5P_DEFAULT);
    bool read = false;
    if (attribute < 0) {
        fw_hdf5_miss(file);
    } else {
        hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
        /* HDF5 converts between strings of different fixed lengths; the last byte stays 0. */
        hid_t wanted = fw_hdf5_text_type(size);
        H5Tset_strpad(wanted, H5T_STR_NULLTERM);
        H5Tset_cset(wanted, H5Tget_cset(type));
        read = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
               H5Sget_simple_extent_npoints(space) == count &&
               H5Aread(attribute, wanted, texts) >= 0;
        if (!read) fw_hdf5_miss(file);
        H5Tclose(wanted);
        H5Sclose(space);
        H5Tclose(type);
        H5Aclose(attribute);
    }
    return read;
}

bool fw_hdf5_read_attribute(fw_hdf5 *file, const char *path, const char *name, char *text,
                            size_t size)
{
    return fw_hdf5_read_attributes(file, path, name, text, size, 1);
}

/* Spaces of `count` rows in memory and in the file, from row `first` on. */
static bool select_rows(hid_t dataset, uint64_t first, uint64_t count, hid_t *memory, hid_t *space)
{
    hsize_t start[H5S_MAX_RANK] = {first}, extent[H5S_MAX_RANK] = {0};
    *space = H5Dget_space(dataset);
    int rank = H5Sget_simple_extent_dims(*space, extent, NULL);
    *memory = H5I_INVALID_HID;
    if (rank < 0) return false;
    if (rank == 0) {
        *memory = H5Screate(H5S_SCALAR);
        return first == 0 && count == 1;
    }
    if (first > extent[0] || count > extent[0] - first) return false;
    extent[0] = count;
    *memory = H5Screate_simple(rank, extent, NULL);
    if (count == 0) return H5Sselect_none(*memory) >= 0 && H5Sselect_none(*space) >= 0;
    return H5Sselect_hyperslab(*space, H5S_SELECT_SET, start, NULL, extent, NULL) >= 0;
}

void fw_hdf5_write(fw_hdf5 *file, fw_dataset dataset, fw_element element, uint64_t first,
                   uint64_t count, const void *values)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    hid_t memory, space;
    if (!select_rows(dataset, first, count, &memory, &space) ||
        H5Dwrite(dataset, fw_hdf5_number_type(element), memory, space, H5P_DEFAULT, values) < 0)
        fw_hdf5_fail_writing(file, "its data");
    H5Sclose(memory);
    H5Sclose(space);
}

void fw_hdf5_read(fw_hdf5 *file, fw_dataset dataset, fw_element element, uint64_t first,
                  uint64_t count, void *values)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    hid_t memory, space;
    if (!select_rows(dataset, first, count, &memory, &space) ||
        H5Dread(dataset, fw_hdf5_number_type(element), memory, space, H5P_DEFAULT, values) < 0)
        fw_hdf5_fail_reading(file);
    H5Sclose(memory);
    H5Sclose(space);
}

void fw_hdf5_resize(fw_hdf5 *file, fw_dataset dataset, uint64_t rows)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    hid_t space = H5Dget_space(dataset);
    hsize_t extent[H5S_MAX_RANK] = {0};
    int rank = H5Sget_simple_extent_dims(space, extent, NULL);
    H5Sclose(space);
    extent[0] = rows;
    if (rank < 1 || H5Dset_extent(dataset, extent) < 0) fw_hdf5_fail_writing(file, "the file");
}

void fw_hdf5_write_text(fw_hdf5 *file, fw_dataset dataset, const char *text)
{
    FW_HDF5_ALONE;
    fw_shape shape;
    if (fw_hdf5_failed(file)) return;
    if (!fw_hdf5_shape(file, dataset, &shape) || !shape.text) {
        fw_hdf5_fail_writing(file, "a text");
        return;
    }
    char *padded = calloc(1, shape.width);
    if (!padded) {
        fw_fail_memory(&file->failure, "a text");
        return;
    }
    size_t length = strlen(text);
    memcpy(padded, text, length < shape.width ? length : shape.width);
    hid_t type = fw_hdf5_text_type(shape.width);
    if (H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded) < 0)
        fw_hdf5_fail_writing(file, "a text");
    H5Tclose(type);
    free(padded);
}

char *fw_hdf5_read_text(fw_hdf5 *file, fw_dataset dataset)
{
    FW_HDF5_ALONE;
    fw_shape shape;
    if (!fw_hdf5_shape(file, dataset, &shape) || !shape.text || shape.rank != 0) return NULL;
    /* A damaged header could claim any length. */
    if (!fw_hdf5_is_stored(file, dataset)) return NULL;
    char *text = calloc(1, shape.width + 1);
    if (!text) {
        fw_hdf5_give_up(file, file->path);
        return NULL;
    }
    hid_t type = fw_hdf5_text_type(shape.width);
    H5Tset_cset(type, H5T_CSET_UTF8);
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text) < 0) {
        fw_hdf5_miss(file);
        free(text);
        text = NULL;
    }
    H5Tclose(type);
    return text;
}
