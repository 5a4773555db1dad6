/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_file.h - the door to HDF5: groups, attributes, arrays and rows of numbers in one file.
 *
 * The first failure of a file sticks: every later call does nothing, and
 * fw_hdf5_check reports the sentence. So a layout of forty objects is written without forty checks.
 *
 * A file made here never changes its own structure while rows are written: every chunk is allocated
 * when room is made for it, no fill values are written, nothing is cached. Together with the bounds
 * of format 1.8, whose superblock does not mark files that are open, a file whose writer was killed
 * opens and reads. Several threads may use it, each a file of its own: HDF5 can do one call at a
 * time, and each function here waits for its turn. */
#ifndef FW_HDF5_FILE_H
#define FW_HDF5_FILE_H

#include "core/array.h"
#include "core/status.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct fw_hdf5 fw_hdf5;

/* A dataset of an open file; closed with it. Negative: there is none. */
typedef int64_t fw_dataset;

enum { FW_DATASET_RANK = 4 };

/* What a dataset holds. The first extent of a dataset made of rows is their number. */
typedef struct fw_shape {
    bool text; /* one string of fixed length `width` */
    fw_element element;
    size_t width; /* bytes of one element */
    int rank;     /* 0: a single value */
    uint64_t extent[FW_DATASET_RANK];
} fw_shape;

/* An empty file in place of whatever was at `path`. `structure` is how many bytes the groups,
 * attributes and chunk addresses may take: they are kept together at the head of the file. */
fw_status fw_hdf5_create(fw_hdf5 **file, const char *path, size_t structure, fw_error *error);
/* FW_BAD_INPUT when there is none or it is not a whole HDF5 file, FW_SYSTEM_FAILED when it cannot
 * be read. */
fw_status fw_hdf5_open(fw_hdf5 **file, const char *path, bool writable, fw_error *error);
/* Writes what is left and releases the file; after a failure in writing the system keeps it open
 * until the process ends, and this process must not open it again. NULL is legal. */
fw_status fw_hdf5_close(fw_hdf5 *file, fw_error *error);

/* The first failure since the file was opened. */
fw_status fw_hdf5_check(const fw_hdf5 *file, fw_error *error);
/* Lets the file fail because what is at `path` is not what it should be. */
void fw_hdf5_refuse(fw_hdf5 *file, const char *path);
/* Lets it fail for want of memory for `what`. */
void fw_hdf5_give_up(fw_hdf5 *file, const char *what);
/* Hands everything to the operating system, where it survives the end of this process. */
void fw_hdf5_flush(fw_hdf5 *file);
/* Waits until the disk has it, where it survives a power cut. */
void fw_hdf5_sync(fw_hdf5 *file);
/* Takes the disk space of the whole file now, so that a full disk shows before a run and not in the
 * middle of it. File systems that cannot do that are left alone. */
void fw_hdf5_reserve(fw_hdf5 *file);
uint64_t fw_hdf5_size(fw_hdf5 *file);
/* FNV-1a of the file as it lies on disk, up to byte `end`, without its superblock: that changes
 * when the file is opened, and HDF5 itself keeps a checksum of it. */
enum { FW_HDF5_SUPERBLOCK = 48 };
uint64_t fw_hdf5_checksum(fw_hdf5 *file, uint64_t end);
const char *fw_hdf5_path(const fw_hdf5 *file);
/* Whether all structure lies in front of all data, so that none of it is further back than the
 * first dataset's data. Only files that were created, not opened, know. */
bool fw_hdf5_is_compact(fw_hdf5 *file);
/* Where the data of an array begins. */
uint64_t fw_hdf5_address(fw_hdf5 *file, fw_dataset dataset);
/* Where one row lies, of a dataset whose rows are chunks of their own. */
uint64_t fw_hdf5_row_address(fw_hdf5 *file, fw_dataset dataset, uint64_t row);
/* The file as the operating system knows it, for data that are written to their addresses without
 * HDF5; -1 when the file has failed. */
int fw_hdf5_descriptor(fw_hdf5 *file);
/* Lets the file fail because the operating system did not take such data; `reason`: errno. */
void fw_hdf5_fail_system(fw_hdf5 *file, int reason);

/* Making. Groups on the way to `path` must be there. */
void fw_hdf5_make_group(fw_hdf5 *file, const char *path);
fw_dataset fw_hdf5_make_array(fw_hdf5 *file, const char *path, fw_element element, int rank,
                              const uint64_t *extent);
/* A string of at most `capacity` bytes that can be rewritten in place. */
fw_dataset fw_hdf5_make_text(fw_hdf5 *file, const char *path, size_t capacity);
/* A growing number of rows, now none; each row is an array of the given extents (rank 0: a number),
 * and `chunk` rows lie together. */
fw_dataset fw_hdf5_make_rows(fw_hdf5 *file, const char *path, fw_element element, int rank,
                             const uint64_t *extent, uint64_t chunk);
/* A second name for an object of the file. */
void fw_hdf5_link(fw_hdf5 *file, const char *existing, const char *path);

/* Attributes. Texts are of fixed length, as H5MD requires. A count of 0 makes a single value. */
void fw_hdf5_attach_text(fw_hdf5 *file, const char *path, const char *name, const char *text);
void fw_hdf5_attach_texts(fw_hdf5 *file, const char *path, const char *name,
                          const char *const *texts, int count);
void fw_hdf5_attach_integers(fw_hdf5 *file, const char *path, const char *name, const int *values,
                             int count);
void fw_hdf5_attach_reference(fw_hdf5 *file, const char *path, const char *name,
                              const char *target);

/* Finding. */
fw_dataset fw_hdf5_find(fw_hdf5 *file, const char *path); /* negative: there is none */
/* Closes a dataset before its file. A negative one is legal. */
void fw_hdf5_release(fw_dataset dataset);
/* False when it is neither a text nor an array of the project's elements. */
bool fw_hdf5_shape(fw_hdf5 *file, fw_dataset dataset, fw_shape *shape);
/* Whether the file has as many bytes for it as its extents claim; to be checked before memory is
 * allocated for it. */
bool fw_hdf5_is_stored(fw_hdf5 *file, fw_dataset dataset);
/* Names of the members of a group in the order of their making, each at most `size` - 1 bytes long;
 * returns how many there are, -1 where there is no such group, and writes at most `capacity`. Longer
 * names are left out. */
int fw_hdf5_list(fw_hdf5 *file, const char *path, char *names, int size, int capacity);
/* The text of an attribute into `text`; false, and "" there, when there is no such text. */
bool fw_hdf5_read_attribute(fw_hdf5 *file, const char *path, const char *name, char *text,
                            size_t size);
/* `count` texts of an attribute, each into `size` bytes of `texts`; false when it is otherwise. */
bool fw_hdf5_read_attributes(fw_hdf5 *file, const char *path, const char *name, char *texts,
                             size_t size, int count);

/* Data. `element` is that of the memory; rows begin at `first`. A whole array is rows 0 to its
 * first extent; a single value or text is row 0, count 1. */
void fw_hdf5_write(fw_hdf5 *file, fw_dataset dataset, fw_element element, uint64_t first,
                   uint64_t count, const void *values);
void fw_hdf5_read(fw_hdf5 *file, fw_dataset dataset, fw_element element, uint64_t first,
                  uint64_t count, void *values);
void fw_hdf5_resize(fw_hdf5 *file, fw_dataset dataset, uint64_t rows);
/* A longer text is cut. */
void fw_hdf5_write_text(fw_hdf5 *file, fw_dataset dataset, const char *text);
/* The text in memory of its own, to be freed; NULL when it is none or there is no memory. */
char *fw_hdf5_read_text(fw_hdf5 *file, fw_dataset dataset);

/* "HDF5 1.10.8" */
void fw_hdf5_version(char *text, size_t size);

#endif
