/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_layout.h - the parts of a results file that stay as they are while a run writes:
 * H5MD's metadata, bodies, links, scenario and provenance. For the files of this wing only. */
#ifndef FW_TRAJECTORY_LAYOUT_H
#define FW_TRAJECTORY_LAYOUT_H

#include "experiments/results/trajectory.h"
#include "experiments/storage/hdf5_file.h"

/* FW_BAD_INPUT when a name or number of the definition cannot be used. */
fw_status fw_layout_check(const fw_trajectory_def *def, fw_error *error);

/* Bytes that the structure of the file is likely to take. */
size_t fw_layout_structure(const fw_trajectory_def *def);

/* Everything but the series. Failures stick to the file. */
void fw_layout_make(fw_hdf5 *file, const fw_trajectory_def *def);
/* Its parts: the arrays of the run as a whole, and the tables of its analyses. */
void fw_layout_make_arrays(fw_hdf5 *file, const fw_trajectory_def *def);
void fw_layout_make_tables(fw_hdf5 *file, const fw_trajectory_def *def);
/* Attributes of the series' elements, once these are there. */
void fw_layout_describe(fw_hdf5 *file, const fw_trajectory_def *def);

/* FW_BAD_INPUT when the file is not one of ours, was closed for good, or holds other bodies than
 * the definition. */
fw_status fw_layout_compare(fw_hdf5 *file, const fw_trajectory_def *def, fw_error *error);
/* Notes that the run goes on. */
void fw_layout_reopen(fw_hdf5 *file);
/* Bytes at the head of the file that hold its structure and no data. */
uint64_t fw_layout_head(fw_hdf5 *file);

/* The seal is a checksum of everything in front of it: the structure, and the data that never
 * change. It holds while rows are written, and is to be renewed when the structure has changed. */
void fw_layout_seal(fw_hdf5 *file);
/* FW_BAD_INPUT when the file does not have the right one. */
fw_status fw_layout_check_seal(fw_hdf5 *file, fw_error *error);
/* Where it lies in the file, as 8 bytes. */
uint64_t fw_layout_seal_place(fw_hdf5 *file);

/* Rewrites parameters/provenance/exit_status; FW_OK: the run has not failed. */
void fw_layout_note_status(fw_hdf5 *file, fw_status status);
/* Rewrites the warnings, a line each. */
void fw_layout_warn(fw_hdf5 *file, const char *warnings);
/* Rewrites one text of parameters/provenance. */
void fw_layout_note(fw_hdf5 *file, const char *name, const char *text);

#endif
