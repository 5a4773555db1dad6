/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_file.c - the only file that knows HDF5.
 * State: the file's handle, the datasets made in it, its first failure. Invariant:
 * after a failure no call reaches HDF5 any more, except the one that closes. Start reading at
 * fw_hdf5_create() and make_dataset(). */
#include "experiments/hdf5_file.h"

#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

_Static_assert(sizeof(hid_t) == sizeof(fw_dataset), "a dataset is a handle of HDF5 1.10 or later");

struct fw_hdf5 {
    hid_t id;
    uint64_t head; /* address of the first raw data */
    hid_t *made;   /* all datasets made here */
    int made_count;
    bool writable, broken; /* broken: something could not be written */
    fw_error failure;      /* FW_OK: none so far */
    char path[];
};

/* The operating system's error number is only in the text of HDF5's error stack. */
static herr_t find_errno(unsigned depth, const H5E_error2_t *entry, void *number)
{
    (void)depth;
    const char *found = entry->desc ? strstr(entry->desc, "errno = ") : NULL;
    if (found) *(int *)number = atoi(found + strlen("errno = "));
    return 0;
}

/* The sentence with the system's reason, or `otherwise` when the system had none. */
static fw_status explain(fw_error *error, const char *path, const char *attempt,
                         fw_status otherwise, const char *reason)
{
    int number = 0;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_errno, &number);
    H5Eclear2(H5E_DEFAULT);
    if (number != 0) otherwise = FW_SYSTEM_FAILED;
    return fw_fail(error, otherwise, "cannot %s %s: %s", attempt, path,
                   number != 0 ? strerror(number) : reason);
}

static void fail_writing(fw_hdf5 *file, const char *object)
{
    char reason[FW_SENTENCE_SIZE];
    file->broken = true;
    snprintf(reason, sizeof reason, "HDF5 refuses %s", object);
    if (file->failure.status == FW_OK)
        explain(&file->failure, file->path, "write", FW_SYSTEM_FAILED, reason);
}

static void fail_reading(fw_hdf5 *file)
{
    if (file->failure.status == FW_OK)
        explain(&file->failure, file->path, "read", FW_BAD_INPUT, "it is damaged or foreign");
}

static bool failed(const fw_hdf5 *file)
{
    return file->failure.status != FW_OK;
}

/* HDF5 prints nothing by itself, and does not try to write at exit what could not be written
 * before: with a full disk that never ends. */
static void quieten(void)
{
    H5dont_atexit();
    H5open();
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

static hid_t access_properties(size_t structure)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    /* Without caches a write goes to its final place at once. */
    H5Pset_cache(access, 0, 0, 0, 0);
    H5Pset_sieve_buf_size(access, 0);
    /* Structure in one block at the head, raw data behind it without gaps. */
    if (structure > 0) H5Pset_meta_block_size(access, structure);
    H5Pset_small_data_block_size(access, 0);
    /* Readers may look at a running file; two writers are kept apart by the folder's lock. */
    H5Pset_file_locking(access, false, true);
    return access;
}

static fw_hdf5 *allocate(const char *path)
{
    fw_hdf5 *file = calloc(1, sizeof *file + strlen(path) + 1);
    if (!file) return NULL;
    strcpy(file->path, path);
    file->id = H5I_INVALID_HID;
    return file;
}

fw_status fw_hdf5_create(fw_hdf5 **file, const char *path, size_t structure, fw_error *error)
{
    *file = NULL;
    quieten();
    fw_hdf5 *fresh = allocate(path);
    if (!fresh) return fw_fail_memory(error, path);
    hid_t access = access_properties(structure);
    fresh->id = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    if (fresh->id < 0) {
        fw_status status = explain(error, path, "create", FW_SYSTEM_FAILED, "HDF5 refuses");
        free(fresh);
        return status;
    }
    fresh->writable = true;
    *file = fresh;
    return FW_OK;
}

fw_status fw_hdf5_open(fw_hdf5 **file, const char *path, bool writable, fw_error *error)
{
    *file = NULL;
    quieten();
    int descriptor = open(path, writable ? O_RDWR : O_RDONLY);
    if (descriptor < 0) {
        bool missing = errno == ENOENT || errno == ENOTDIR || errno == EISDIR;
        return fw_fail(error, missing ? FW_BAD_INPUT : FW_SYSTEM_FAILED, "cannot open %s: %s", path,
                       strerror(errno));
    }
    close(descriptor);
    fw_hdf5 *opened = allocate(path);
    if (!opened) return fw_fail_memory(error, path);
    hid_t access = access_properties(0);
    opened->id = H5Fopen(path, writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access);
    H5Pclose(access);
    if (opened->id < 0) {
        H5Eclear2(H5E_DEFAULT);
        free(opened);
        return fw_fail(error, FW_BAD_INPUT, "%s is not a whole HDF5 file", path);
    }
    opened->writable = writable;
    *file = opened;
    return FW_OK;
}

/* What cannot be written now could not be written while closing either, and HDF5 is left in pieces
 * by a close that fails: the next file then crashes. So a broken file is left open until the
 * process ends; its descriptor goes on standing for it, and no other file is taken for it. */
fw_status fw_hdf5_close(fw_hdf5 *file, fw_error *error)
{
    if (!file) return FW_OK;
    if (file->writable && !file->broken && H5Fflush(file->id, H5F_SCOPE_LOCAL) < 0)
        fail_writing(file, "the file");
    if (!file->broken && H5Fclose(file->id) < 0) fail_writing(file, "the file");
    fw_status status = fw_hdf5_check(file, error);
    free(file->made);
    free(file);
    return status;
}

fw_status fw_hdf5_check(const fw_hdf5 *file, fw_error *error)
{
    if (failed(file) && error) *error = file->failure;
    return file->failure.status;
}

void fw_hdf5_refuse(fw_hdf5 *file, const char *path)
{
    if (failed(file)) return;
    fw_fail(&file->failure, FW_BAD_INPUT,
            "%s is damaged or foreign: /%s is missing or not as expected", file->path, path);
}

void fw_hdf5_give_up(fw_hdf5 *file, const char *what)
{
    if (!failed(file)) fw_fail_memory(&file->failure, what);
}

void fw_hdf5_flush(fw_hdf5 *file)
{
    if (!failed(file) && H5Fflush(file->id, H5F_SCOPE_LOCAL) < 0) fail_writing(file, "the file");
}

/* The descriptor of the open file; -1 when the file has failed. */
static int descriptor_of(fw_hdf5 *file)
{
    int *descriptor = NULL;
    if (failed(file)) return -1;
    if (H5Fget_vfd_handle(file->id, H5P_DEFAULT, (void **)&descriptor) >= 0) return *descriptor;
    fail_writing(file, "a descriptor");
    return -1;
}

void fw_hdf5_sync(fw_hdf5 *file)
{
    fw_hdf5_flush(file);
    int descriptor = descriptor_of(file);
    if (descriptor < 0 || fsync(descriptor) == 0) return;
    file->broken = true;
    fw_fail(&file->failure, FW_SYSTEM_FAILED, "cannot write %s: %s", file->path, strerror(errno));
}

void fw_hdf5_reserve(fw_hdf5 *file)
{
    fw_hdf5_flush(file);
    uint64_t whole = fw_hdf5_size(file);
    int descriptor = descriptor_of(file);
    if (descriptor < 0) return;
    int reason = posix_fallocate(descriptor, 0, (off_t)whole);
    if (reason == 0 || reason == EOPNOTSUPP || reason == EINVAL) return;
    file->broken = true;
    fw_fail(&file->failure, FW_SYSTEM_FAILED, "no room for %s, which takes %.3g MB: %s", file->path,
            (double)whole / 1e6, strerror(reason));
}

uint64_t fw_hdf5_size(fw_hdf5 *file)
{
    hsize_t size = 0;
    if (!failed(file) && H5Fget_filesize(file->id, &size) < 0) fail_reading(file);
    return size;
}

bool fw_hdf5_is_compact(fw_hdf5 *file)
{
    fw_hdf5_flush(file);
    uint64_t raw = 0;
    for (int i = 0; i < file->made_count; ++i) raw += H5Dget_storage_size(file->made[i]);
    return file->head + raw == fw_hdf5_size(file);
}

uint64_t fw_hdf5_address(fw_hdf5 *file, fw_dataset dataset)
{
    if (failed(file)) return 0;
    haddr_t address = H5Dget_offset(dataset);
    if (address == HADDR_UNDEF) fail_reading(file);
    return address == HADDR_UNDEF ? 0 : address;
}

static hid_t number_type(fw_element element)
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

/* A string of fixed length; at least one byte, since HDF5 knows no empty type. */
static hid_t text_type(size_t size)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size > 0 ? size : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

void fw_hdf5_make_group(fw_hdf5 *file, const char *path)
{
    if (failed(file)) return;
    hid_t properties = H5Pcreate(H5P_GROUP_CREATE);
    H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    hid_t group = H5Gcreate2(file->id, path, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (group < 0 || H5Gclose(group) < 0) fail_writing(file, path);
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
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
    if (chunk_rank > 0) H5Pset_chunk(properties, chunk_rank, chunk);
    hid_t dataset = H5Dcreate2(file->id, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (dataset < 0)
        fail_writing(file, path);
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
    if (failed(file)) return -1;
    hsize_t size[FW_DATASET_RANK];
    for (int i = 0; i < rank; ++i) size[i] = extent[i];
    return make_dataset(file, path, H5Tcopy(number_type(element)),
                        rank > 0 ? H5Screate_simple(rank, size, NULL) : H5Screate(H5S_SCALAR), 0,
                        NULL);
}

fw_dataset fw_hdf5_make_text(fw_hdf5 *file, const char *path, size_t capacity)
{
    if (failed(file)) return -1;
    return make_dataset(file, path, text_type(capacity), H5Screate(H5S_SCALAR), 0, NULL);
}

fw_dataset fw_hdf5_make_rows(fw_hdf5 *file, const char *path, fw_element element, int rank,
                             const uint64_t *extent, uint64_t chunk)
{
    if (failed(file)) return -1;
    hsize_t none[FW_DATASET_RANK] = {0}, limit[FW_DATASET_RANK] = {H5S_UNLIMITED};
    hsize_t together[FW_DATASET_RANK] = {chunk};
    for (int i = 0; i < rank; ++i) none[i + 1] = limit[i + 1] = together[i + 1] = extent[i];
    return make_dataset(file, path, H5Tcopy(number_type(element)),
                        H5Screate_simple(rank + 1, none, limit), rank + 1, together);
}

void fw_hdf5_link(fw_hdf5 *file, const char *existing, const char *path)
{
    if (failed(file)) return;
    if (H5Lcreate_hard(file->id, existing, file->id, path, H5P_DEFAULT, H5P_DEFAULT) < 0)
        fail_writing(file, path);
}

/* Takes over type and space. */
static void attach(fw_hdf5 *file, const char *path, const char *name, hid_t type, hid_t space,
                   const void *values)
{
    hid_t attribute =
        H5Acreate_by_name(file->id, path, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0 || H5Awrite(attribute, type, values) < 0) fail_writing(file, path);
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
    if (failed(file)) return;
    attach(file, path, name, text_type(strlen(text)), H5Screate(H5S_SCALAR), text);
}

void fw_hdf5_attach_texts(fw_hdf5 *file, const char *path, const char *name,
                          const char *const *texts, int count)
{
    if (failed(file)) return;
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
    attach(file, path, name, text_type(longest), line_of(count), packed);
    free(packed);
}

void fw_hdf5_attach_integers(fw_hdf5 *file, const char *path, const char *name, const int *values,
                             int count)
{
    if (failed(file)) return;
    attach(file, path, name, H5Tcopy(H5T_NATIVE_INT), line_of(count), values);
}

void fw_hdf5_attach_reference(fw_hdf5 *file, const char *path, const char *name, const char *target)
{
    if (failed(file)) return;
    hobj_ref_t reference;
    if (H5Rcreate(&reference, file->id, target, H5R_OBJECT, -1) < 0)
        fail_writing(file, target);
    else
        attach(file, path, name, H5Tcopy(H5T_STD_REF_OBJ), H5Screate(H5S_SCALAR), &reference);
}

fw_dataset fw_hdf5_find(fw_hdf5 *file, const char *path)
{
    if (failed(file)) return -1;
    hid_t dataset = H5Dopen2(file->id, path, H5P_DEFAULT);
    H5Eclear2(H5E_DEFAULT);
    return dataset;
}

void fw_hdf5_release(fw_dataset dataset)
{
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
    *shape = (fw_shape){0};
    if (failed(file) || dataset < 0) return false;
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
    if (failed(file)) return 0;
    int count = 0;
    H5G_info_t members = {0};
    if (H5Gget_info_by_name(file->id, path, &members, H5P_DEFAULT) < 0) members.nlinks = 0;
    for (hsize_t i = 0; i < members.nlinks; ++i) {
        char *name = count < capacity ? names + (size_t)count * (size_t)size : NULL;
        ssize_t length = H5Lget_name_by_idx(file->id, path, H5_INDEX_CRT_ORDER, H5_ITER_INC, i,
                                            name, name ? (size_t)size : 0, H5P_DEFAULT);
        if (length >= 0 && length < size) ++count;
    }
    H5Eclear2(H5E_DEFAULT);
    return count;
}

bool fw_hdf5_read_attributes(fw_hdf5 *file, const char *path, const char *name, char *texts,
                             size_t size, int count)
{
    memset(texts, 0, size * (size_t)count);
    if (failed(file)) return false;
    hid_t attribute = H5Aopen_by_name(file->id, path, name, H5P_DEFAULT, H5P_DEFAULT);
    bool read = false;
    if (attribute >= 0) {
        hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
        /* HDF5 converts between strings of different fixed lengths; the last byte stays 0. */
        hid_t wanted = text_type(size);
        H5Tset_strpad(wanted, H5T_STR_NULLTERM);
        H5Tset_cset(wanted, H5Tget_cset(type));
        read = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
               H5Sget_simple_extent_npoints(space) == count &&
               H5Aread(attribute, wanted, texts) >= 0;
        H5Tclose(wanted);
        H5Sclose(space);
        H5Tclose(type);
        H5Aclose(attribute);
    }
    H5Eclear2(H5E_DEFAULT);
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
    if (failed(file)) return;
    hid_t memory, space;
    if (!select_rows(dataset, first, count, &memory, &space) ||
        H5Dwrite(dataset, number_type(element), memory, space, H5P_DEFAULT, values) < 0)
        fail_writing(file, "its data");
    H5Sclose(memory);
    H5Sclose(space);
}

void fw_hdf5_read(fw_hdf5 *file, fw_dataset dataset, fw_element element, uint64_t first,
                  uint64_t count, void *values)
{
    if (failed(file)) return;
    hid_t memory, space;
    if (!select_rows(dataset, first, count, &memory, &space) ||
        H5Dread(dataset, number_type(element), memory, space, H5P_DEFAULT, values) < 0)
        fail_reading(file);
    H5Sclose(memory);
    H5Sclose(space);
}

void fw_hdf5_resize(fw_hdf5 *file, fw_dataset dataset, uint64_t rows)
{
    if (failed(file)) return;
    hid_t space = H5Dget_space(dataset);
    hsize_t extent[H5S_MAX_RANK] = {0};
    int rank = H5Sget_simple_extent_dims(space, extent, NULL);
    H5Sclose(space);
    extent[0] = rows;
    if (rank < 1 || H5Dset_extent(dataset, extent) < 0) fail_writing(file, "the file");
}

void fw_hdf5_write_text(fw_hdf5 *file, fw_dataset dataset, const char *text)
{
    fw_shape shape;
    if (failed(file)) return;
    if (!fw_hdf5_shape(file, dataset, &shape) || !shape.text) {
        fail_writing(file, "a text");
        return;
    }
    char *padded = calloc(1, shape.width);
    if (!padded) {
        fw_fail_memory(&file->failure, "a text");
        return;
    }
    size_t length = strlen(text);
    memcpy(padded, text, length < shape.width ? length : shape.width);
    hid_t type = text_type(shape.width);
    if (H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded) < 0)
        fail_writing(file, "a text");
    H5Tclose(type);
    free(padded);
}

char *fw_hdf5_read_text(fw_hdf5 *file, fw_dataset dataset)
{
    fw_shape shape;
    if (!fw_hdf5_shape(file, dataset, &shape) || !shape.text || shape.rank != 0) return NULL;
    /* A damaged header could claim any length. */
    if (!fw_hdf5_is_stored(file, dataset)) return NULL;
    char *text = calloc(1, shape.width + 1);
    hid_t type = text_type(shape.width);
    H5Tset_cset(type, H5T_CSET_UTF8);
    if (text && H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text) < 0) {
        H5Eclear2(H5E_DEFAULT);
        free(text);
        text = NULL;
    }
    H5Tclose(type);
    return text;
}

void fw_hdf5_version(char *text, size_t size)
{
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    snprintf(text, size, "HDF5 %u.%u.%u", major, minor, release);
}
