/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box_tree.h - the C door to Box2D's tree of boxes, for boxes that move. As with the broadphase, it
 * never decides: what it finds is more than what was asked for. Not to be used from several threads
 * at once. */
#ifndef FW_BOX_TREE_H
#define FW_BOX_TREE_H

#include "contact/geometry/facet.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fw_box_tree fw_box_tree;

/* For boxes numbered from 0 on, about as large as `extent` all together. NULL: no memory. */
fw_box_tree *fw_box_tree_create(int count, fw_box extent);
void fw_box_tree_destroy(fw_box_tree *tree);

/* Puts a box where it is now, for the first time or again. */
void fw_box_tree_put(fw_box_tree *tree, int number, fw_box box);

/* Numbers of all boxes that meet this one, and perhaps of others near it, in no order. Writes at
 * most `capacity` and returns how many there are. */
int fw_box_tree_query(const fw_box_tree *tree, fw_box box, int *numbers, int capacity);

#ifdef __cplusplus
}
#endif
#endif
