/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_order.c - bodies that have lost their order. State: fw_list_order, the lists'. Start reading
 * at fw_list_order_find_scattered(). */
#include "list_order.h"

#include "core/array.h"

#include <stdlib.h>

enum { PARALLEL_FROM = 1024 }; /* particles; below it threads cost more than they bring */

bool fw_list_order_create(fw_list_order *order, const int *counts, int bodies)
{
    const size_t size = (size_t)bodies;
    *order = (fw_list_order){.bodies = bodies,
                             .first = calloc(size + 1, sizeof *order->first),
                             .scattered = calloc(size, sizeof *order->scattered),
                             .next = calloc(size, sizeof *order->next)};
    if (!order->first || !order->scattered || !order->next) return false;
    for (int body = 0; body < bodies; ++body)
        order->first[body + 1] = order->first[body] + counts[body];
    return true;
}

void fw_list_order_release(fw_list_order *order)
{
    free(order->first);
    free(order->scattered);
    free(order->next);
    free(order->number);
    free(order->place);
    free(order->memory);
    *order = (fw_list_order){0};
}

int fw_list_order_body(const fw_list_order *order, int particle)
{
    int low = 0, high = order->bodies;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(order->first[middle] <= particle ? &low : &high) = middle;
    }
    return low;
}

bool fw_list_order_find_scattered(fw_list_order *order, const double *x, const double *y,
                                  double distance, int smallest)
{
    bool found = false;
    for (int body = 0; body < order->bodies; ++body) {
        const int first = order->first[body], end = order->first[body + 1];
        if (order->scattered[body] || end - first < smallest) continue;
        int apart = 0;
        for (int i = first + 1; i < end; ++i) {
            const double dx = x[i] - x[i - 1], dy = y[i] - y[i - 1];
            apart += dx * dx + dy * dy > distance * distance;
        }
        order->scattered[body] = 2 * apart > end - first;
        found = found || order->scattered[body];
    }
    return found;
}

static void mark_chunks(const fw_list_order *order, fw_chunk *chunks, int chunk_count)
{
    for (int c = 0; c < chunk_count; ++c) {
        bool *in_order = chunks[c].in_order;
        for (int run = 0; run < FW_SLOT_RUNS; ++run) in_order[run] = true;
        for (int body = 0; body < order->bodies; ++body) {
            const int own = chunks[c].body;
            const int run = body < own ? 0 : body == own ? FW_RUN_OWN : FW_RUN_OWN + 1;
            in_order[run] = in_order[run] && !order->scattered[body];
        }
    }
}

bool fw_list_order_begin(fw_list_order *order, fw_chunk *chunks, int chunk_count)
{
    const size_t count = (size_t)order->first[order->bodies], row = count + 2 * FW_LANES;
    if (!order->number) order->number = fw_array_allocate(count, sizeof *order->number);
    if (!order->place) order->place = fw_array_allocate(count, sizeof *order->place);
    if (!order->memory) order->memory = fw_array_of_doubles(2 * row);
    if (!order->number || !order->place || !order->memory) return false;
    order->x = order->memory + FW_LANES;
    order->y = order->x + row;
    mark_chunks(order, chunks, chunk_count);
    return true;
}

void fw_list_order_renumber(fw_list_order *order, const fw_cells *cells)
{
    for (int body = 0; body < order->bodies; ++body) order->next[body] = order->first[body];
    for (int m = 0; m < cells->count; ++m) {
        const int particle = cells->member[m], body = fw_list_order_body(order, particle);
        const int place = order->scattered[body] ? order->next[body]++ : particle;
        order->number[place] = particle;
        order->place[particle] = place;
    }
}

void fw_list_order_place(const fw_list_order *order, const double *x, const double *y)
{
    const int count = order->first[order->bodies];
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int k = 0; k < count; ++k) {
        order->x[k] = x[order->number[k]];
        order->y[k] = y[order->number[k]];
    }
}
