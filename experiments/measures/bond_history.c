/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bond_history.c - bonds from look to look, and from snapshot to snapshot.
 * State: the bonds of the last look, places and bonds of the last snapshots. Invariant: if i lists
 * j, j lists i. Start reading at fw_bond_history_look(). */
#include "bond_history.h"

#include "core/particles/neighbour_lists.h"
#include "core/particles/particles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- life --- */

fw_status fw_bond_history_create(fw_bond_history **history, const fw_solid *solid, int64_t from,
                                 int64_t until, double time_unit, fw_error *error)
{
    fw_bond_history *made = calloc(1, sizeof *made);
    *history = made;
    if (!made) return fw_fail_memory(error, "the history of bonds");
    const double lag = fmin(fmax(round(time_unit / solid->tick), 1), 1e15);
    const size_t count = (size_t)solid->count, past = count * FW_HISTORY_LAGS;
    made->from = from;
    made->until = until;
    made->lag = (int64_t)lag;
    made->look = (int64_t)fmax(floor(lag / FW_HISTORY_LOOKS), 1);
    made->count = solid->count;
    made->bonds = fw_array_allocate(count, sizeof *made->bonds);
    made->broken = fw_array_of_doubles(count);
    made->past_x = fw_array_of_doubles(past);
    made->past_y = fw_array_of_doubles(past);
    made->past_bonds = fw_array_allocate(past, sizeof *made->past_bonds);
    if (made->bonds && made->broken && made->past_x && made->past_y && made->past_bonds)
        return FW_OK;
    fw_bond_history_destroy(made);
    *history = NULL;
    return fw_fail_memory(error, "the history of bonds");
}

void fw_bond_history_destroy(fw_bond_history *history)
{
    if (!history) return;
    free(history->bonds);
    free(history->broken);
    free(history->past_x);
    free(history->past_y);
    free(history->past_bonds);
    free(history);
}

void fw_bond_history_state(fw_bond_history *history, fw_state_list *list)
{
    const size_t count = (size_t)history->count, past = count * FW_HISTORY_LAGS;
    fw_state_list_add(list, "bonds", FW_I32, count * FW_HISTORY_BONDS, history->bonds);
    fw_state_list_add(list, "past-x", FW_F64, past, history->past_x);
    fw_state_list_add(list, "past-y", FW_F64, past, history->past_y);
    fw_state_list_add(list, "past-bonds", FW_I32, past * FW_HISTORY_BONDS, history->past_bonds);
}

static bool are_sound(const int32_t *bonds, size_t size, int count)
{
    for (size_t n = 0; n < size; ++n)
        if (bonds[n] < -1 || bonds[n] >= count) return false;
    return true;
}

bool fw_bond_history_is_sound(const fw_bond_history *h)
{
    const size_t size = (size_t)h->count * FW_HISTORY_BONDS;
    return are_sound(h->bonds[0], size, h->count) &&
           are_sound(h->past_bonds[0], size * FW_HISTORY_LAGS, h->count);
}

static bool is_due(const fw_bond_history *h, int64_t step, int64_t every)
{
    return step >= h->from && step <= h->until && (step - h->from) % every == 0;
}

/* --- bonds --- */

static double square_between(const fw_solid *solid, int i, int j)
{
    const double dx = solid->x[j] - solid->x[i], dy = solid->y[j] - solid->y[i];
    return dx * dx + dy * dy;
}

static int length_of(const int32_t *bonds)
{
    int length = 0;
    while (length < FW_HISTORY_BONDS && bonds[length] >= 0) ++length;
    return length;
}

/* Drops the bonds that are broken now; returns how many. */
static int drop_broken(const fw_solid *solid, int i, int32_t *bonds)
{
    const double radius = FW_BOND_BROKEN * fw_particles_bond_radius(solid);
    const int before = length_of(bonds);
    int left = 0;
    for (int n = 0; n < before; ++n)
        if (square_between(solid, i, bonds[n]) <= radius * radius) bonds[left++] = bonds[n];
    if (left < FW_HISTORY_BONDS) bonds[left] = -1;
    return before - left;
}

static bool holds(const int32_t *bonds, int length, int j)
{
    for (int n = 0; n < length; ++n)
        if (bonds[n] == j) return true;
    return false;
}

static void add_new(const fw_solid *solid, int i, int32_t *bonds)
{
    fw_neighbour_walk walk = fw_neighbours_around(fw_particles_neighbours(solid), i);
    const double radius = fw_particles_bond_radius(solid);
    int length = length_of(bonds);
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
        if (length == FW_HISTORY_BONDS || square_between(solid, i, j) >= radius * radius) continue;
        if (!holds(bonds, length, j)) bonds[length++] = j;
    }
    if (length < FW_HISTORY_BONDS) bonds[length] = -1;
}

bool fw_bond_history_look(fw_bond_history *h, const fw_solid *solid, int64_t step)
{
    if (!is_due(h, step, h->look)) return false;
    for (int i = 0; i < h->count; ++i) {
        if (step == h->from) h->bonds[i][0] = -1;
        h->broken[i] = drop_broken(solid, i, h->bonds[i]);
        add_new(solid, i, h->bonds[i]);
    }
    return step > h->from;
}

/* --- motion --- */

static int slot_of(const fw_bond_history *h, int64_t step)
{
    return (int)((step - h->from) / h->lag % FW_HISTORY_LAGS);
}

int fw_bond_history_snapshot(const fw_bond_history *h, int64_t step, int lags)
{
    const int64_t then = step - lags * h->lag;
    return is_due(h, step, h->lag) && then >= h->from ? slot_of(h, then) : -1;
}

fw_bond_change fw_bond_history_change(const fw_bond_history *h, const fw_solid *solid, int snapshot,
                                      int i)
{
    const size_t first = (size_t)snapshot * (size_t)h->count;
    const double *x = h->past_x + first, *y = h->past_y + first;
    const int32_t *bonds = h->past_bonds[first + (size_t)i];
    fw_bond_change change = {0};
    for (int n = 0; n < FW_HISTORY_BONDS && bonds[n] >= 0; ++n) {
        const int j = bonds[n];
        const double dx = solid->x[j] - solid->x[i] - (x[j] - x[i]);
        const double dy = solid->y[j] - solid->y[i] - (y[j] - y[i]);
        change.bonds += 1;
        change.square += dx * dx + dy * dy;
        change.along[0] += dx * dx;
        change.along[1] += dy * dy;
    }
    return change;
}

void fw_bond_history_remember(fw_bond_history *h, const fw_solid *solid, int64_t step)
{
    if (!is_due(h, step, h->lag)) return;
    const size_t first = (size_t)slot_of(h, step) * (size_t)h->count;
    for (int i = 0; i < h->count; ++i) {
        h->past_bonds[first + (size_t)i][0] = -1;
        add_new(solid, i, h->past_bonds[first + (size_t)i]);
        h->past_x[first + (size_t)i] = solid->x[i];
        h->past_y[first + (size_t)i] = solid->y[i];
    }
}
