/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_parts.h - what the files behind hdf5_file.h share, and the only include of HDF5. */
#ifndef FW_HDF5_PARTS_H
#define FW_HDF5_PARTS_H

#include "experiments/storage/hdf5_file.h"

#include <hdf5.h>

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

/* HDF5 serves one thread at a time, also where they work on different files. Every function of the
 * door holds it until it returns; one may call another. */
int fw_hdf5_lock(void);
void fw_hdf5_unlock(const int *held);
#define FW_HDF5_ALONE __attribute__((cleanup(fw_hdf5_unlock), unused)) int held = fw_hdf5_lock()

bool fw_hdf5_failed(const fw_hdf5 *file);
/* The first failure, with the system's reason where there is one; `object` is what HDF5 refuses. */
void fw_hdf5_fail_writing(fw_hdf5 *file, const char *object);
void fw_hdf5_fail_reading(fw_hdf5 *file);
/* After a call that did not find what it looked for: it may not be there, which is no failure; but
 * where the system could not read, the file fails. At once, before another call to HDF5. */
void fw_hdf5_miss(fw_hdf5 *file);

hid_t fw_hdf5_number_type(fw_element element);
/* A string of fixed length, to be closed by the caller. */
hid_t fw_hdf5_text_type(size_t size);

#endif
