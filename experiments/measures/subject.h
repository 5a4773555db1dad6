/* SPDX-License-Identifier: GPL-3.0-or-later */
/* subject.h - what a quantity can be measured of, and what names of it mean: "energy",
 * "energy.sheet", "reaction.floor.x", "position.sheet[0,3]". Every place that names one reads it
 * here. */
#ifndef FW_SUBJECT_H
#define FW_SUBJECT_H

#include "experiments/measures/quantity.h"

/* "sheet" or "sheet[0,3]"; names may be as long as the scenario allows. */
enum { FW_SUBJECT_NAME = FW_NAME_BYTES + 32 };

/* The whole scene. */
fw_subject fw_subject_none(const fw_observer *observer);
bool fw_subject_equals(fw_subject one, fw_subject other);

/* How many subjects there may be; the n-th of them, false where the quantity is not measured of it.
 * Single sites are not among them. */
int fw_subject_count(const fw_observer *observer, const fw_quantity *quantity);
bool fw_subject_at(const fw_observer *observer, const fw_quantity *quantity, int n,
                   fw_subject *subject);

/* The name of what is measured, "" for the whole scene. */
void fw_subject_name(const fw_observer *observer, fw_subject subject, char name[FW_SUBJECT_NAME]);

/* Has the scene what the quantity needs? */
bool fw_subject_exists(const fw_observer *observer, const fw_quantity *quantity);

/* The quantity that a name begins with. FW_BAD_INPUT at its place, with the one that may have been
 * meant. */
fw_status fw_subject_find_quantity(const fw_observer *observer, fw_schema_name name,
                                   const fw_quantity **quantity, fw_error *error);
/* What is behind the quantity in a name: a subject, a component of the quantity, both or neither.
 * *named: a subject is. FW_BAD_INPUT where it is something else. */
fw_status fw_subject_find(const fw_observer *observer, const fw_quantity *quantity,
                          fw_schema_name name, bool *named, fw_subject *subject, fw_error *error);

#endif
