/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_make.c - groups, datasets and attributes of a new file. Keeps no state beyond the file's;
 * start reading at make_dataset(). */
#include "hdf5_parts.h"

#include <stdlib.h>
#include <string.h>

hid_t fw_hdf5_number_type(fw_element element)
{
    switch (element) {
    case FW_F64:
        return H5T_NATIVE_DOUBLE;
    case FW_I32:
        return H5T_NATIVE_INT32;
    case FW_I64:
        return H5T_NATIVE_INT64;
    case FW_U8:
        return H5T_NATIVE_UINT8;
    }
    return H5I_INVALID_HID;
}

/* A string of fixed length; at least one byte, since HDF5 has no empty type. */
hid_t fw_hdf5_text_type(size_t size)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size > 0 ? size : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

void fw_hdf5_make_group(fw_hdf5 *file, const char *path)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    hid_t properties = H5Pcreate(H5P_GROUP_CREATE);
    H5Pset_obj_track_times(properties, false);
    H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    hid_t group = H5Gcreate2(file->id, path, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (group < 0 || H5Gclose(group) < 0) fw_hdf5_fail_writing(file, path);
    H5Pclose(properties);
}

static void remember(fw_hdf5 *file, hid_t dataset)
{
    haddr_t address = H5Dget_offset(dataset); /* undefined where there are chunks */
    if (address != HADDR_UNDEF && file->head == 0) file->head = address;
    hid_t *more = realloc(file->made, (size_t)(file->made_count + 1) * sizeof *more);
    if (!more) {
        fw_hdf5_give_up(file, "a list of datasets");
        return;
    }
    file->made = more;
    file->made[file->made_count++] = dataset;
}

/* Takes over type and space. Raw data is allocated now and never filled. */
static fw_dataset make_dataset(fw_hdf5 *file, const char *path, hid_t type, hid_t space,
                               int chunk_rank, const hsize_t *chunk)
{
    hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(properties, false);
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
    if (chunk_rank > 0) H5Pset_chunk(properties, chunk_rank, chunk);
    hid_t dataset = H5Dcreate2(file->id, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (dataset < 0)
        fw_hdf5_fail_writing(file, path);
    else
        remember(file, dataset);
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
    return dataset;
}

fw_dataset fw_hdf5_make_array(fw_hdf5 *file, const char *path, fw_element element, int rank,
                              const uint64_t *extent)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return -1;
    hsize_t size[FW_DATASET_RANK];
    for (int i = 0; i < rank; ++i) size[i] = extent[i];
    return make_dataset(file, path, H5Tcopy(fw_hdf5_number_type(element)),
                        rank > 0 ? H5Screate_simple(rank, size, NULL) : H5Screate(H5S_SCALAR), 0,
                        NULL);
}

fw_dataset fw_hdf5_make_text(fw_hdf5 *file, const char *path, size_t capacity)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return -1;
    /* So numbers behind it begin at a multiple of their size (row_writer.h). */
    const size_t whole = (capacity / sizeof(double) + 1) * sizeof(double);
    return make_dataset(file, path, fw_hdf5_text_type(whole), H5Screate(H5S_SCALAR), 0, NULL);
}

fw_dataset fw_hdf5_make_rows(fw_hdf5 *file, const char *path, fw_element element, int rank,
                             const uint64_t *extent, uint64_t chunk)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return -1;
    hsize_t none[FW_DATASET_RANK] = {0}, limit[FW_DATASET_RANK] = {H5S_UNLIMITED};
    hsize_t together[FW_DATASET_RANK] = {chunk};
    for (int i = 0; i < rank; ++i) none[i + 1] = limit[i + 1] = together[i + 1] = extent[i];
    return make_dataset(file, path, H5Tcopy(fw_hdf5_number_type(element)),
                        H5Screate_simple(rank + 1, none, limit), rank + 1, together);
}

void fw_hdf5_link(fw_hdf5 *file, const char *existing, const char *path)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    if (H5Lcreate_hard(file->id, existing, file->id, path, H5P_DEFAULT, H5P_DEFAULT) < 0)
        fw_hdf5_fail_writing(file, path);
}

/* Takes over type and space. */
static void attach(fw_hdf5 *file, const char *path, const char *name, hid_t type, hid_t space,
                   const void *values)
{
    hid_t attribute =
        H5Acreate_by_name(file->id, path, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0 || H5Awrite(attribute, type, values) < 0) fw_hdf5_fail_writing(file, path);
    if (attribute >= 0) H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
}

static hid_t line_of(int count)
{
    hsize_t extent = (hsize_t)count;
    return count > 0 ? H5Screate_simple(1, &extent, NULL) : H5Screate(H5S_SCALAR);
}

void fw_hdf5_attach_text(fw_hdf5 *file, const char *path, const char *name, const char *text)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    attach(file, path, name, fw_hdf5_text_type(strlen(text)), H5Screate(H5S_SCALAR), text);
}

void fw_hdf5_attach_texts(fw_hdf5 *file, const char *path, const char *name,
                          const char *const *texts, int count)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    size_t longest = 1;
    for (int i = 0; i < count; ++i)
        if (strlen(texts[i]) > longest) longest = strlen(texts[i]);
    char *packed = calloc((size_t)count + 1, longest);
    if (!packed) {
        fw_fail_memory(&file->failure, path);
        return;
    }
    for (int i = 0; i < count; ++i)
        memcpy(packed + (size_t)i * longest, texts[i], strlen(texts[i]));
    attach(file, path, name, fw_hdf5_text_type(longest), line_of(count), packed);
    free(packed);
}

void fw_hdf5_attach_integers(fw_hdf5 *file, const char *path, const char *name, const int *values,
                             int count)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    attach(file, path, name, H5Tcopy(H5T_NATIVE_INT), line_of(count), values);
}

void fw_hdf5_attach_reference(fw_hdf5 *file, const char *path, const char *name, const char *target)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    hobj_ref_t reference;
    if (H5Rcreate(&reference, file->id, target, H5R_OBJECT, -1) < 0)
        fw_hdf5_fail_writing(file, target);
    else
        attach(file, path, name, H5Tcopy(H5T_STD_REF_OBJ), H5Screate(H5S_SCALAR), &reference);
}
