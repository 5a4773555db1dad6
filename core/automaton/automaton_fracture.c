/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_fracture.c - bonds that break ("via breaking the neighbouring relations of particles",
 * Dong, closing section). What remains of a cell is renormalised as at a free boundary of kind
 * `bond`: its mass is that of the bonds it still has. The energy and the momentum that the bond
 * carried go with it, into the ledger.
 *
 * A cell that loses a bond leaves its span and gets a rim entry; its row remembers where the span
 * is interrupted. So a body costs what its whole cells cost in spans, and more only where it broke.
 * State: one bit per bond, kept at its black end. Start reading at fw_automaton_tear_row(). */
#include "automaton_sweep.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The row in which a span lies. */
static int row_of_span(const fw_automaton *body, const fw_automaton_colour *colour, int span)
{
    int low = 0, high = body->row_count - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (colour->row[middle + 1].span > span)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Takes a cell out of its span. */
static fw_status leave_span(fw_automaton *body, int c, int cell, fw_error *error)
{
    fw_automaton_colour *colour = &body->colour[c];
    const int place = colour->place[cell];
    if (place >= 0) return FW_OK;
    const int number = ~place;
    fw_automaton_gaps *gaps = &colour->gaps[row_of_span(body, colour, number)];
    fw_automaton_rim *rims =
        fw_automaton_make_room(colour->rim, colour->rim_count, &colour->rim_room, sizeof *rims);
    if (rims) colour->rim = rims;
    int *list = fw_automaton_make_room(gaps->rim, gaps->count, &gaps->room, sizeof *list);
    if (list) gaps->rim = list;
    if (!rims || !list) return fw_fail_memory(error, "the broken bonds of an automaton");
    fw_automaton_rim *rim = &colour->rim[colour->rim_count];
    *rim = (fw_automaton_rim){.cell = cell, .span = number};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        rim->neighbour[d] = cell + colour->span[number].offset[d];
        rim->weight[d] = 1;
    }
    (void)fw_automaton_rim_weigh(body, c, rim);
    colour->place[cell] = colour->rim_count;
    int at = gaps->count++;
    for (; at > 0 && colour->rim[gaps->rim[at - 1]].cell > cell; --at)
        gaps->rim[at] = gaps->rim[at - 1];
    gaps->rim[at] = colour->rim_count++;
    return FW_OK;
}

/* Makes the rim entries of both ends say whether a bond of the black cell is whole; a whole one
 * needs none. */
static fw_status set_bond(fw_automaton *body, int black_cell, int direction, bool whole,
                          fw_error *error)
{
    const int end[FW_COLOURS] = {black_cell, body->built[black_cell][direction]};
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        if (!whole) FW_TRY(leave_span(body, c, end[c], error));
        if (colour->place[end[c]] < 0) continue;
        fw_automaton_rim *rim = &colour->rim[colour->place[end[c]]];
        const int d = c == FW_BLACK ? direction : fw_opposite(direction);
        rim->neighbour[d] = whole ? end[!c] : -1;
        rim->weight[d] = whole ? 1 : 0;
        /* Cannot fail: only matrices that are positive definite may break. */
        (void)fw_automaton_rim_weigh(body, c, rim);
    }
    return FW_OK;
}

/* Both ends of a broken bond are exposed from now on. */
static void expose(fw_solid *head, int particle)
{
    int low = 0, high = head->boundary_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (head->boundary[middle] < particle)
            low = middle + 1;
        else
            high = middle;
    }
    if (low < head->boundary_count && head->boundary[low] == particle) return;
    for (int n = head->boundary_count++; n > low; --n) head->boundary[n] = head->boundary[n - 1];
    head->boundary[low] = particle;
}

/* `moved`: the colour that moved last. What goes into the ledger waits for
 * fw_automaton_book_tears(). */
static fw_status break_bond(fw_automaton *body, int cell, int direction, int moved, int tick,
                            fw_error *error)
{
    const int partner = body->built[cell][direction];
    void *list =
        fw_automaton_make_room(body->tear, body->tear_count, &body->tear_room, sizeof *body->tear);
    if (!list) return fw_fail_memory(error, "the broken bonds of an automaton");
    body->tear = list;
    const fw_vec2 difference = fw_vec2_subtract(fw_automaton_at(&body->colour[FW_WHITE], partner),
                                                fw_automaton_at(&body->colour[FW_BLACK], cell));
    const fw_vec2 pull = fw_sym2_apply(body->matrices.bond[direction], difference);
    /* p = 1/2 sum B (w - b) once white has moved, the negative once black has. */
    body->tear[body->tear_count++] =
        (fw_automaton_tear){.tick = tick,
                            .cell = cell,
                            .direction = direction,
                            .energy = fw_vec2_dot(difference, pull) / 2,
                            .drag = fw_vec2_scale(moved == FW_WHITE ? -0.5 : 0.5, pull)};
    body->bonds[cell] &= (uint8_t) ~(1 << direction);
    FW_TRY(set_bond(body, cell, direction, false, error));
    const int black = body->colour[FW_BLACK].particle[cell];
    const int white = body->colour[FW_WHITE].particle[partner];
    expose(&body->head, black);
    expose(&body->head, white);
    body->head.boundary_revision += 1;
    list =
        fw_automaton_make_room(body->gone, body->gone_count, &body->gone_room, sizeof *body->gone);
    if (!list) return fw_fail_memory(error, "the broken bonds of an automaton");
    body->gone = list;
    const bool from_black = direction <= FW_NORTH;
    body->gone[body->gone_count][0] = from_black ? black : white;
    body->gone[body->gone_count++][1] = from_black ? white : black;
    return FW_OK;
}

/* Its place in the list, which ascends by first particles; -1: it crosses a seam. */
static int find_link(const fw_solid *head, const int link[2])
{
    int low = 0, high = head->link_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (head->links[middle][0] < link[0])
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < head->link_count && head->links[low][0] == link[0]; ++low)
        if (head->links[low][1] == link[1]) return low;
    return -1;
}

static int compare_places(const void *left, const void *right)
{
    const int a = *(const int *)left, b = *(const int *)right;
    return (a > b) - (a < b);
}

/* What lies between two that are gone moves up as a whole. */
void fw_automaton_drop_bonds(fw_automaton *body)
{
    fw_solid *head = &body->head;
    if (body->gone_count == 0) return;
    int *places = &body->gone[0][0], count = 0; /* no longer than what it is made from */
    for (int n = 0; n < body->gone_count; ++n) {
        const int place = find_link(head, body->gone[n]);
        if (place >= 0) places[count++] = place;
    }
    qsort(places, (size_t)count, sizeof *places, compare_places);
    for (int n = 0; n < count; ++n) {
        const int from = places[n] + 1, until = n + 1 < count ? places[n + 1] : head->link_count;
        memmove(head->links + from - 1 - n, head->links + from,
                (size_t)(until - from) * sizeof *head->links);
    }
    head->link_count -= count;
    body->gone_count = 0;
}

fw_status fw_automaton_tear_row(fw_automaton *body, int colour, int row, int tick, fw_error *error)
{
    const fw_automaton_row *cells = &body->colour[colour].row[row];
    for (int n = cells[0].cell; n < cells[1].cell; ++n) {
        const uint8_t torn = body->torn[n];
        body->torn[n] = 0;
        for (int d = 0; d < FW_DIRECTIONS && torn; ++d) {
            if (!(torn >> d & 1)) continue;
            double weight;
            const int partner = fw_automaton_cell_neighbour(body, colour, n, d, &weight);
            if (colour == FW_BLACK)
                FW_TRY(break_bond(body, n, d, colour, tick, error));
            else
                FW_TRY(break_bond(body, partner, fw_opposite(d), colour, tick, error));
        }
    }
    return FW_OK;
}

static int compare_tears(const void *left, const void *right)
{
    const fw_automaton_tear *a = left, *b = right;
    if (a->tick != b->tick) return a->tick < b->tick ? -1 : 1;
    if (a->cell != b->cell) return a->cell < b->cell ? -1 : 1;
    return (a->direction > b->direction) - (a->direction < b->direction);
}

void fw_automaton_sort_tears(fw_automaton *body)
{
    if (body->tear_count > 0)
        qsort(body->tear, (size_t)body->tear_count, sizeof *body->tear, compare_tears);
    body->tear_booked = 0;
}

void fw_automaton_book_tears(fw_automaton *body, int tick)
{
    fw_solid_ledger *ledger = &body->head.ledger;
    for (; body->tear_booked < body->tear_count; ++body->tear_booked) {
        const fw_automaton_tear *tear = &body->tear[body->tear_booked];
        if (tear->tick != tick) return;
        ledger->fracture += tear->energy;
        ledger->dissipated += tear->energy;
        ledger->drag = fw_vec2_add(ledger->drag, tear->drag);
    }
    body->tear_count = 0;
}

/* All cells that left their spans go back. */
static void close_gaps(fw_automaton *body)
{
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        for (int row = 0; row < body->row_count; ++row) colour->gaps[row].count = 0;
        while (colour->rim_count > 0 && colour->rim[colour->rim_count - 1].span >= 0) {
            const fw_automaton_rim *rim = &colour->rim[--colour->rim_count];
            colour->place[rim->cell] = ~rim->span;
        }
    }
}

fw_status fw_automaton_rebuild_bonds(fw_automaton *body, fw_error *error)
{
    if (!body->bonds) return FW_OK;
    close_gaps(body);
    for (int n = 0; n < body->colour[FW_BLACK].count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            if (body->built[n][d] >= 0)
                FW_TRY(set_bond(body, n, d, body->bonds[n] >> d & 1, error));
    fw_automaton_list_bonds(body);
    return FW_OK;
}

bool fw_elastic_automaton_break(fw_solid *solid, int particle, int direction)
{
    fw_automaton *body = fw_automaton_of(solid);
    assert(body->bonds);
    const int colour = body->white[particle], cell = body->cell[particle];
    double weight;
    const int partner = fw_automaton_cell_neighbour(body, colour, cell, direction, &weight);
    if (partner < 0) return false;
    /* Between ticks the colour that moved last is the one that does not move next. */
    const int moved = !fw_automaton_moving(body);
    const int black = colour == FW_BLACK ? cell : partner;
    const int from_black = colour == FW_BLACK ? direction : fw_opposite(direction);
    if (break_bond(body, black, from_black, moved, 0, NULL) != FW_OK) return false;
    fw_automaton_sort_tears(body);
    fw_automaton_book_tears(body, 0);
    fw_automaton_drop_bonds(body);
    return true;
}

int fw_elastic_automaton_frozen(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    int frozen = 0;
    for (int c = 0; c < FW_COLOURS; ++c)
        for (int n = 0; n < body->colour[c].rim_count; ++n)
            frozen += !(body->colour[c].rim[n].inverse_mass.xx > 0);
    return frozen;
}

int fw_elastic_automaton_broken(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    if (!body->bonds) return 0;
    int broken = 0;
    for (int n = 0; n < body->colour[FW_BLACK].count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            broken += body->built[n][d] >= 0 && !(body->bonds[n] >> d & 1);
    return broken;
}
