/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surroundings.c - sums over the neighbours of points. Keeps no state. Start reading at
 * fw_surroundings_density(). */
#include "core/particles/surroundings.h"

#include "core/particles/neighbours.h"
#include "core/particles/return_force.h"

#include <math.h>
#include <stdlib.h>

/* --- bonds --- */

/* e^{i n phi} of a bond of length 1, by repeated squaring: no trigonometry. */
static fw_phase power_of(fw_phase bond, int fold)
{
    fw_phase power = {1, 0};
    for (int rest = fold; rest > 0; rest /= 2) {
        if (rest & 1) power = fw_phase_product(power, bond);
        bond = fw_phase_product(bond, bond);
    }
    return power;
}

static double order_at(const fw_neighbours *near, const double *x, const double *y, int i, int fold)
{
    fw_phase sum = {0, 0};
    for (size_t k = near->begin[i]; k < near->begin[i + 1]; ++k) {
        const double dx = x[near->list[k]] - x[i], dy = y[near->list[k]] - y[i];
        const double length = hypot(dx, dy);
        const fw_phase term = power_of((fw_phase){dx / length, dy / length}, fold);
        sum.cosine += term.cosine;
        sum.sine += term.sine;
    }
    const double bonds = (double)(near->begin[i + 1] - near->begin[i]);
    return bonds > 0 ? hypot(sum.cosine, sum.sine) / bonds : NAN;
}

fw_status fw_surroundings_order(const double *x, const double *y, int count, double radius,
                                const int *folds, int fold_count, double *values, fw_error *error)
{
    fw_neighbours *near;
    FW_TRY(fw_neighbours_create(&near, x, y, count, radius, error));
    for (int f = 0; f < fold_count; ++f)
        for (int i = 0; i < count; ++i)
            values[(size_t)f * (size_t)count + (size_t)i] = order_at(near, x, y, i, folds[f]);
    fw_neighbours_destroy(near);
    return FW_OK;
}

/* --- density --- */

fw_status fw_surroundings_density(const double *x, const double *y, int count, double lambda,
                                  double *values, fw_error *error)
{
    fw_neighbours *near;
    FW_TRY(fw_neighbours_create(&near, x, y, count, 6 * sqrt(lambda), error));
    for (int i = 0; i < count; ++i) {
        double sum = 1; /* the point itself */
        for (size_t k = near->begin[i]; k < near->begin[i + 1]; ++k) {
            const double dx = x[near->list[k]] - x[i], dy = y[near->list[k]] - y[i];
            sum += exp(-(dx * dx + dy * dy) / lambda);
        }
        values[i] = sum;
    }
    fw_neighbours_destroy(near);
    return FW_OK;
}

/* --- clusters --- */

/* The lowest point that i is known to be linked to; shortens the chain for later calls. */
static int root_of(int *parent, int i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

static void link_all(const fw_neighbours *near, int count, int *parent)
{
    for (int i = 0; i < count; ++i) parent[i] = i;
    for (int i = 0; i < count; ++i)
        for (size_t k = near->begin[i]; k < near->begin[i + 1]; ++k) {
            const int a = root_of(parent, i), b = root_of(parent, near->list[k]);
            if (a < b) parent[b] = a;
            if (b < a) parent[a] = b;
        }
}

/* Counts the points of each cluster into `size`, all zero before; returns the largest count. */
static int mark_largest(int count, int *parent, int *size, uint8_t *members)
{
    int largest = 0;
    for (int i = 0; i < count; ++i) size[root_of(parent, i)] += 1;
    for (int i = 0; i < count; ++i)
        if (size[i] > size[largest]) largest = i;
    for (int i = 0; i < count; ++i) members[i] = root_of(parent, i) == largest;
    return size[largest];
}

fw_status fw_surroundings_cluster(const double *x, const double *y, int count, double link,
                                  uint8_t *members, int *found, fw_error *error)
{
    fw_neighbours *near;
    FW_TRY(fw_neighbours_create(&near, x, y, count, link, error));
    int *parent = malloc((size_t)count * sizeof *parent);
    int *size = calloc((size_t)count, sizeof *size);
    const fw_status status =
        parent && size ? FW_OK : fw_fail_memory(error, "the clusters of particles");
    if (status == FW_OK) {
        link_all(near, count, parent);
        *found = mark_largest(count, parent, size, members);
    }
    free(parent);
    free(size);
    fw_neighbours_destroy(near);
    return status;
}
