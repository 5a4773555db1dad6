/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_order.h - in which order lists hold the particles of a solid. In a body whose numbers say
 * nothing any more of where its particles are, neighbours lie all over memory: for its lists they
 * are numbered anew, as their cells follow each other. No result depends on it. */
#ifndef FW_LIST_ORDER_H
#define FW_LIST_ORDER_H

#include "core/particles/cells.h"
#include "core/particles/slots.h"

typedef struct fw_list_order {
    int bodies;
    int *first;      /* particle of each body, and the end; the same in either order */
    bool *scattered; /* has the body lost its order? */
    int *next;       /* scratch, one per body */
    /* All NULL as long as every body keeps its order. */
    int *number;    /* the solid's, of each in the lists' order */
    int *place;     /* the other way round */
    double *memory; /* of the two below, and a block before and behind either */
    double *x, *y;  /* positions in the lists' order */
} fw_list_order;

/* False without memory; to be released then too. */
bool fw_list_order_create(fw_list_order *order, const int *counts, int bodies);
void fw_list_order_release(fw_list_order *order);

int fw_list_order_body(const fw_list_order *order, int particle);

/* Marks bodies of at least so many particles, most of which lie further than `distance` from those
 * before them; are there any that were not marked yet? */
bool fw_list_order_find_scattered(fw_list_order *order, const double *x, const double *y,
                                  double distance, int smallest);
/* Numbers of its own from now on; tells the chunks in which runs neighbours do not ascend by
 * themselves. False without memory. */
bool fw_list_order_begin(fw_list_order *order, fw_chunk *chunks, int chunk_count);
/* Numbers the particles of marked bodies as these cells, which hold the solid's numbers, do. */
void fw_list_order_renumber(fw_list_order *order, const fw_cells *cells);
/* Fills order->x, y with these positions; not before fw_list_order_renumber. */
void fw_list_order_place(const fw_list_order *order, const double *x, const double *y);

#endif
