/* SPDX-License-Identifier: GPL-3.0-or-later */
/* island.c - islands of rows, by going from row to row over shared ends, breadth first. From the
 * row that was reached last the same is done again: it lies at one end of the contact, and the
 * order in which rows are reached from there is that of Cuthill and McKee. Ends that many rows
 * share, pistons, hold an island together and are left out of its order.
 * State: which rows meet at an end, and which were seen. Start reading at joint_islands_next(). */
#include "island.h"

#include <stdlib.h>
#include <string.h>

static bool enlarge(int **list, size_t count)
{
    int *larger = realloc(*list, (count + 1) * sizeof *larger);
    if (larger) *list = larger;
    return larger != NULL;
}

static fw_status reserve(joint_islands *islands, int end_count, int row_count, fw_error *error)
{
    if (end_count >= islands->end_capacity) {
        const int capacity = 2 * end_count + 64;
        if (!enlarge(&islands->begin, (size_t)capacity + 1))
            return fw_fail_memory(error, "the contact of bodies");
        islands->end_capacity = capacity;
    }
    if (row_count > islands->row_capacity) {
        const int capacity = 2 * row_count + 64;
        if (!enlarge(&islands->incident, 3 * (size_t)capacity) ||
            !enlarge(&islands->order, (size_t)capacity) ||
            !enlarge(&islands->scratch, (size_t)capacity) ||
            !enlarge(&islands->seen, (size_t)capacity))
            return fw_fail_memory(error, "the contact of bodies");
        islands->row_capacity = capacity;
    }
    return FW_OK;
}

fw_status joint_islands_begin(joint_islands *islands, const fw_joint_end *ends, int end_count,
                              const fw_joint_row *rows, int row_count, fw_error *error)
{
    FW_TRY(reserve(islands, end_count, row_count, error));
    int *begin = islands->begin;
    memset(begin, 0, ((size_t)end_count + 1) * sizeof *begin);
    memset(islands->seen, 0, (size_t)row_count * sizeof *islands->seen);
    islands->count = 0;
    for (int n = 0; n < row_count; ++n)
        for (int k = 0; k < fw_joint_end_count(&rows[n]); ++k)
            if (joint_moves(&ends[rows[n].end[k]])) begin[rows[n].end[k] + 1] += 1;
    for (int e = 0; e < end_count; ++e) begin[e + 1] += begin[e];
    for (int n = row_count - 1; n >= 0; --n)
        for (int k = fw_joint_end_count(&rows[n]) - 1; k >= 0; --k)
            if (joint_moves(&ends[rows[n].end[k]]))
                islands->incident[--begin[rows[n].end[k] + 1]] = n;
    /* begin[e + 1] has come down to where end e begins. */
    memmove(begin, begin + 1, (size_t)end_count * sizeof *begin);
    int total = 0;
    for (int n = 0; n < row_count; ++n)
        for (int k = 0; k < fw_joint_end_count(&rows[n]); ++k)
            total += joint_moves(&ends[rows[n].end[k]]);
    begin[end_count] = total;
    return FW_OK;
}

void joint_islands_release(joint_islands *islands)
{
    free(islands->begin);
    free(islands->incident);
    free(islands->order);
    free(islands->scratch);
    free(islands->seen);
    *islands = (joint_islands){0};
}

static int list_rows_of(joint_islands *islands, int end, int mark, int *list, int count)
{
    for (int m = islands->begin[end]; m < islands->begin[end + 1]; ++m) {
        const int other = islands->incident[m];
        if (islands->seen[other] == mark) continue;
        islands->seen[other] = mark;
        list[count++] = other;
    }
    return count;
}

/* Lists all rows that can be reached, over wide ends or not, marks them, and returns how many. */
static int spread_from(joint_islands *islands, const fw_joint_end *ends, const fw_joint_row *rows,
                       int start, bool wide, int mark, int *list)
{
    int count = 1;
    list[0] = start;
    islands->seen[start] = mark;
    for (int n = 0; n < count; ++n) {
        const fw_joint_row *row = &rows[list[n]];
        for (int k = 0; k < fw_joint_end_count(row); ++k) {
            const fw_joint_end *end = &ends[row->end[k]];
            if (!joint_moves(end) || (end->wide && !wide)) continue;
            count = list_rows_of(islands, row->end[k], mark, list, count);
            for (int m = 0; m < end->lead_count; ++m)
                count = list_rows_of(islands, end->lead[m].end, mark, list, count);
            for (int m = 0; m < end->follower_count; ++m)
                count = list_rows_of(islands, end->follower[m], mark, list, count);
        }
    }
    return count;
}

/* Puts the rows of an island in order. Of the pieces that only wide ends hold together, each by
 * itself. */
static void put_in_order(joint_islands *islands, const fw_joint_end *ends, const fw_joint_row *rows,
                         const int *island, int count, int *list)
{
    int done = 0;
    for (int n = 0; n < count; ++n) {
        if (islands->seen[island[n]] != 1) continue;
        int *piece = list + done;
        const int size = spread_from(islands, ends, rows, island[n], false, 2, piece);
        done += spread_from(islands, ends, rows, piece[size - 1], false, 3, piece);
    }
}

static bool can_give_way(const fw_joint_end *ends, const fw_joint_row *row)
{
    for (int k = 0; k < fw_joint_end_count(row); ++k)
        if (joint_moves(&ends[row->end[k]])) return true;
    return false;
}

const int *joint_islands_next(joint_islands *islands, const fw_joint_end *ends,
                              const fw_joint_row *rows, int row_count, int *first, int *count)
{
    for (; *first < row_count; ++*first) {
        if (islands->seen[*first] || !can_give_way(ends, &rows[*first])) continue;
        int *list = islands->order + islands->count;
        *count = spread_from(islands, ends, rows, *first, true, 1, islands->scratch);
        bool fresh = false;
        for (int n = 0; n < *count; ++n) fresh |= rows[islands->scratch[n]].fresh;
        if (!fresh) continue;
        put_in_order(islands, ends, rows, islands->scratch, *count, list);
        islands->count += *count;
        return list;
    }
    return NULL;
}
