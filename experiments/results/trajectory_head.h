/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_head.h - a copy of the results file's structure, as long as it is cut to fewer rows
 * than it was laid out for.
 *
 * Cutting is the one moment in which structure changes, in several writes; and a run that is
 * resumed needs its room again. So the head of the file, which holds all structure and no data, is
 * put aside first, under a name that says that structure is changing, and afterwards under another
 * that says that it is settled. Putting it back gives exactly the file that was laid out at
 * creation; while that goes on the first name is back, and HDF5 refuses to open the file. */
#ifndef FW_TRAJECTORY_HEAD_H
#define FW_TRAJECTORY_HEAD_H

#include "experiments/results/trajectory.h"
#include "experiments/storage/folder.h"

#include <stdint.h>

#define FW_HEAD_KIND          "FWHEAD" /* with which the copy begins */
#define FW_HEAD_WHILE_CUTTING FW_TRAJECTORY_FILE ".cutting"
#define FW_HEAD_AFTER_CUTTING FW_TRAJECTORY_FILE ".head"

/* Of the results file, in bytes. */
typedef struct fw_head_facts {
    uint64_t size;    /* of its structure, at its head */
    uint64_t seal_at; /* where its seal lies (trajectory_layout.h), behind data that never change */
    uint64_t whole;   /* all of it */
} fw_head_facts;

/* Puts the structure of the results file aside, with its seal; to be called after the file was
 * synchronised and before it is cut. */
fw_status fw_head_save(const fw_folder *folder, const fw_head_facts *facts, fw_error *error);
/* Seals the file after it was cut and closed. */
fw_status fw_head_seal(const fw_folder *folder, uint64_t seal_at, fw_error *error);
/* The cut is done. The copy is kept for a file that may be resumed. */
fw_status fw_head_settle(const fw_folder *folder, bool keep, fw_error *error);
/* Whether structure is changing, or a process was killed in changing it: the file may be
 * unreadable. */
bool fw_head_is_torn(const fw_folder *folder);
/* Gives the results file its structure and length back, if there is a copy; it counts as torn until
 * fw_head_remove, and until then this may be repeated. FW_SYSTEM_FAILED when there is no room,
 * FW_BAD_INPUT when the copy is of another file; the file is then as it was. */
fw_status fw_head_restore(const fw_folder *folder, fw_error *error);
/* Forgets the copy, once rows are to be written again. */
fw_status fw_head_remove(const fw_folder *folder, fw_error *error);

#endif
