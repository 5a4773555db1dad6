/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbour_lists.h - who is near whom while particles move, flow and leave; for kernels.
 *
 * Two lists of slots (slots.h) for each block of particles. The far one holds all pairs closer than
 * `reach` and a wide margin. It is made anew only when two particles that were far from each other
 * may have come near, which is looked up cell by cell: a body that slides, bends slowly or vibrates
 * keeps its list for ever. The near list holds those of the far one that are closer than `reach`
 * and a narrow margin, and is renewed every few steps. Whoever sums over it must let what lies
 * beyond `reach` contribute exact zeros: then no result depends on when lists were made. */
#ifndef FW_NEIGHBOUR_LISTS_H
#define FW_NEIGHBOUR_LISTS_H

#include "core/particles/slots.h"
#include "core/status.h"

typedef struct fw_neighbour_lists fw_neighbour_lists;

/* Particles are numbered through, body after body. reach > 0, margin >= 0: lists are the longer and
 * the rarer, the larger the margin. FW_SYSTEM_FAILED without memory. */
fw_status fw_neighbour_lists_create(fw_neighbour_lists **lists, const int *counts, int bodies,
                                    double reach, double margin, fw_error *error);
void fw_neighbour_lists_destroy(fw_neighbour_lists *lists);

/* Offset slots are preferred up to so many times as many as gather slots would be; for tests, 0:
 * never, INFINITY: always. No result depends on it. */
void fw_neighbour_lists_favour(fw_neighbour_lists *lists, double favour);

/* Makes lists good for the present positions; kernels read x and y a block of eight beyond either
 * end, and the lists go on using them until they are refreshed again. `travel`: no two particles
 * have come closer to each other by more than that since the last call; INFINITY, if nothing is
 * known. FW_SYSTEM_FAILED without memory; the lists are then of no use. */
fw_status fw_neighbour_lists_refresh(fw_neighbour_lists *lists, const double *x, const double *y,
                                     double travel, fw_error *error);

/* The chunks, body after body. */
const fw_chunk *fw_neighbour_lists_chunk(const fw_neighbour_lists *lists, int chunk);
/* The chunks of a body are those from fw_neighbour_lists_first(body) to the next body's first. */
int fw_neighbour_lists_first(const fw_neighbour_lists *lists, int body);

/* Chunks hold particles in the lists' order, which is the solid's in bodies that have kept theirs.
 * Positions in that order, of which kernels may read a block beyond either end, and the solid's
 * number of particle k in it. */
const double *fw_neighbour_lists_x(const fw_neighbour_lists *lists);
const double *fw_neighbour_lists_y(const fw_neighbour_lists *lists);
bool fw_neighbour_lists_renumbered(const fw_neighbour_lists *lists, int body);
int fw_neighbour_lists_number(const fw_neighbour_lists *lists, int k);

/* The least squared distance of two particles that are in each other's list; INFINITY where nobody
 * is. */
double fw_neighbour_lists_closest(const fw_neighbour_lists *lists);

/* How often the far lists have been made. */
int64_t fw_neighbour_lists_made(const fw_neighbour_lists *lists);

/* Goes through the neighbours of one particle, ascending: all within reach, and some beyond.
 *     fw_neighbour_walk walk = fw_neighbours_around(lists, i);
 *     for (int j; (j = fw_neighbour_next(&walk)) >= 0;) ...
 * Valid until the lists are refreshed. */
typedef struct fw_neighbour_walk {
    const fw_slots *slots;
    const fw_slot_head *head;
    const int *number; /* NULL: the lists' order is the solid's */
    uint32_t slot, run_end;
    int run, particle, lane;
} fw_neighbour_walk;
fw_neighbour_walk fw_neighbours_around(const fw_neighbour_lists *lists, int particle);

/* -1 after the last. */
static inline int fw_neighbour_next(fw_neighbour_walk *walk)
{
    for (;;) {
        while (walk->slot == walk->run_end) {
            if (walk->run + 1 == FW_SLOT_RUNS) return -1;
            walk->run += 1;
            walk->run_end = walk->slot + walk->head->count[walk->run];
        }
        const uint32_t slot = walk->slot++;
        if (!(walk->slots->mask[slot] >> walk->lane & 1)) continue;
        const int32_t offset = walk->slots->offset[slot];
        const int k = walk->head->gathered[walk->run] ? walk->slots->row[offset][walk->lane]
                                                      : walk->particle + offset;
        return walk->number ? walk->number[k] : k;
    }
}

#endif
