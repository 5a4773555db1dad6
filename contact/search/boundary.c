/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary.c - runs of boundary particles with cached boxes and candidate lists.
 * State: the order of the particles; per run a fat box and the facets that meet it.
 * Invariant after a refresh: the paths of a run lie in its fat box, and its list holds every facet
 * that can be passed there while the walls stay within the margins of this generation.
 * Start reading at fw_boundary_refresh(). */
#include "contact/search/boundary.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELL_BITS = 12, CELLS = 1 << CELL_BITS };
enum { RUN = 32, FIRST_CAPACITY = 8, THREADS_FROM = 20000 };

/* A fat box has room for so many steps like the present one; more of it where no wall is near,
 * since it costs nothing there. */
static const double steps_ahead = 16, steps_ahead_if_alone = 128;

struct fw_boundary {
    int count, run_count;
    int *particles;
    fw_prediction *predictions;
    /* per run */
    fw_box *swept; /* of this step */
    fw_box *fat;
    double *reach; /* longest predicted displacement */
    int *facets;   /* capacity per run */
    int *facet_count;
    int capacity;
    long generation; /* of the walls, for which the lists were made */
    long queries;
};

/* How far along a Hilbert curve through 4096 x 4096 cells a cell lies. */
static uint32_t hilbert_index(uint32_t x, uint32_t y)
{
    uint32_t index = 0;
    for (int bit = CELL_BITS - 1; bit >= 0; --bit) {
        uint32_t right = x >> bit & 1, upper = y >> bit & 1;
        index = index << 2 | ((3 * right) ^ upper);
        /* The lower quarters hold the curve turned: axes swapped, in the right one mirrored. In
         * masks, since no processor can foresee such a branch. */
        uint32_t lower = upper - 1, mirror = lower & (0 - right);
        uint32_t differ = (x ^ y) & lower;
        x ^= differ ^ mirror;
        y ^= differ ^ mirror;
    }
    return index;
}

typedef struct keyed_particle {
    uint32_t key;
    int particle;
} keyed_particle;

/* Stable, in two passes of 12 bits each; the result is in `list` again. */
static void sort_by_key(keyed_particle *list, keyed_particle *other, size_t count)
{
    for (int shift = 0; shift < 2 * CELL_BITS; shift += CELL_BITS) {
        uint32_t begin[CELLS + 1] = {0};
        for (size_t i = 0; i < count; ++i) begin[(list[i].key >> shift) % CELLS + 1] += 1;
        for (int digit = 0; digit < CELLS; ++digit) begin[digit + 1] += begin[digit];
        for (size_t i = 0; i < count; ++i) other[begin[(list[i].key >> shift) % CELLS]++] = list[i];
        keyed_particle *swap = list;
        list = other;
        other = swap;
    }
}

static uint32_t cell_of(double offset, double cells_per_length)
{
    double cell = offset * cells_per_length;
    return cell > 0 ? (uint32_t)fmin(cell, CELLS - 1) : 0;
}

static fw_status order_particles(fw_boundary *boundary, const fw_solid *solid, fw_error *error)
{
    const size_t count = (size_t)boundary->count;
    keyed_particle *list = malloc((2 * count + 1) * sizeof *list);
    if (!list) return fw_fail_memory(error, "the order of boundary particles");
    fw_box around = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t i = 0; i < count; ++i) {
        fw_vec2 r = fw_solid_position(solid, solid->boundary[i]);
        around = fw_box_joined(around, (fw_box){r, r});
    }
    double size = fmax(around.high.x - around.low.x, around.high.y - around.low.y);
    double cells = size > 0 ? CELLS / size : 0;
    for (size_t i = 0; i < count; ++i) {
        fw_vec2 r = fw_vec2_subtract(fw_solid_position(solid, solid->boundary[i]), around.low);
        list[i] = (keyed_particle){hilbert_index(cell_of(r.x, cells), cell_of(r.y, cells)),
                                   solid->boundary[i]};
    }
    sort_by_key(list, list + count, count);
    for (size_t i = 0; i < count; ++i) boundary->particles[i] = list[i].particle;
    free(list);
    return FW_OK;
}

fw_status fw_boundary_create(fw_boundary **boundary, const fw_solid *solid, fw_error *error)
{
    *boundary = NULL;
    fw_boundary *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "the boundary of a body");
    made->count = solid->boundary_count;
    made->run_count = (solid->boundary_count + RUN - 1) / RUN;
    made->capacity = FIRST_CAPACITY;
    made->generation = -1; /* older than any: the first refresh fills all lists */
    const size_t count = (size_t)made->count, runs = (size_t)made->run_count;
    made->particles = fw_array_allocate(count, sizeof *made->particles);
    made->predictions = fw_array_allocate(count, sizeof *made->predictions);
    made->swept = fw_array_allocate(runs, sizeof *made->swept);
    made->fat = fw_array_allocate(runs, sizeof *made->fat);
    made->reach = fw_array_of_doubles(runs);
    made->facets = malloc((runs + 1) * FIRST_CAPACITY * sizeof *made->facets);
    made->facet_count = fw_array_allocate(runs, sizeof *made->facet_count);
    fw_status status = FW_OK;
    if (!made->particles || !made->predictions || !made->swept || !made->fat || !made->reach ||
        !made->facets || !made->facet_count)
        status = fw_fail_memory(error, "the boundary of a body");
    if (status == FW_OK) status = order_particles(made, solid, error);
    if (status != FW_OK) {
        fw_boundary_destroy(made);
        return status;
    }
    *boundary = made;
    return FW_OK;
}

void fw_boundary_destroy(fw_boundary *boundary)
{
    if (!boundary) return;
    free(boundary->particles);
    free(boundary->predictions);
    free(boundary->swept);
    free(boundary->fat);
    free(boundary->reach);
    free(boundary->facets);
    free(boundary->facet_count);
    free(boundary);
}

int fw_boundary_count(const fw_boundary *boundary)
{
    return boundary->count;
}

const int *fw_boundary_particles(const fw_boundary *boundary)
{
    return boundary->particles;
}

fw_prediction *fw_boundary_predictions(fw_boundary *boundary)
{
    return boundary->predictions;
}

int fw_boundary_run_of(const fw_boundary *boundary, int entry)
{
    assert(entry >= 0 && entry < boundary->count);
    (void)boundary;
    return entry / RUN;
}

int fw_boundary_run_count(const fw_boundary *boundary)
{
    return boundary->run_count;
}

fw_boundary_run fw_boundary_observe_run(const fw_boundary *boundary, int run)
{
    assert(run >= 0 && run < boundary->run_count);
    const int first = run * RUN, left = boundary->count - first;
    return (fw_boundary_run){.first = first,
                             .count = left < RUN ? left : RUN,
                             .facets = boundary->facets + (size_t)run * (size_t)boundary->capacity,
                             .facet_count = boundary->facet_count[run]};
}

long fw_boundary_query_count(const fw_boundary *boundary)
{
    return boundary->queries;
}

/* Fills swept[run] and reach[run]. Least and greatest values do not depend on the order in which
 * they are looked for, so the compiler may do it in vectors. */
static void sweep_run(fw_boundary *boundary, int run, const double *restrict x,
                      const double *restrict y, double wall_sweep)
{
    const int first = run * RUN;
    const int count = boundary->count - first < RUN ? boundary->count - first : RUN;
    const int *restrict particles = boundary->particles + first;
    const fw_prediction *restrict predictions = boundary->predictions + first;
    double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
    double reach_squared = 0;
#pragma omp simd reduction(min : low_x, low_y) reduction(max : high_x, high_y, reach_squared)
    for (int k = 0; k < count; ++k) {
        double here_x = x[particles[k]], here_y = y[particles[k]];
        double squared = fw_vec2_dot(predictions[k].displacement, predictions[k].displacement);
        low_x = here_x < low_x ? here_x : low_x;
        low_y = here_y < low_y ? here_y : low_y;
        high_x = here_x > high_x ? here_x : high_x;
        high_y = here_y > high_y ? here_y : high_y;
        reach_squared = squared > reach_squared ? squared : reach_squared;
    }
    boundary->reach[run] = sqrt(reach_squared);
    /* Friction and slanting walls can turn and lengthen a displacement, a wall can push. */
    const double room = 2 * boundary->reach[run] + wall_sweep;
    boundary->swept[run] = (fw_box){{low_x - room, low_y - room}, {high_x + room, high_y + room}};
}

/* Room for `capacity` facets in every run; the lists move, from the last to the first. */
static fw_status enlarge_lists(fw_boundary *boundary, int capacity, fw_error *error)
{
    const size_t runs = (size_t)boundary->run_count, old_stride = (size_t)boundary->capacity;
    size_t stride = old_stride;
    while (stride < (size_t)capacity) stride *= 2;
    int *larger = realloc(boundary->facets, runs * stride * sizeof *larger);
    if (!larger) return fw_fail_memory(error, "candidate walls of a body");
    for (size_t run = runs; run-- > 0;)
        memmove(larger + run * stride, larger + run * old_stride,
                (size_t)boundary->facet_count[run] * sizeof *larger);
    boundary->facets = larger;
    boundary->capacity = (int)stride;
    return FW_OK;
}

/* Makes `box` the fat box of the run and finds its facets. */
static fw_status query(fw_boundary *boundary, const fw_broadphase *broadphase, int run, fw_box box,
                       fw_error *error)
{
    boundary->facet_count[run] = 0;
    boundary->fat[run] = box;
    for (;;) {
        int *list = boundary->facets + (size_t)run * (size_t)boundary->capacity;
        int found = fw_broadphase_query(broadphase, box, list, boundary->capacity);
        boundary->queries += 1;
        if (found <= boundary->capacity) {
            boundary->facet_count[run] = found;
            return FW_OK;
        }
        FW_TRY(enlarge_lists(boundary, found, error));
    }
}

fw_status fw_boundary_refresh(fw_boundary *boundary, const fw_solid *solid,
                              const fw_broadphase *broadphase, fw_error *error)
{
    const double wall_sweep = fw_broadphase_largest_sweep(broadphase);
    const long generation = fw_broadphase_generation(broadphase);
#pragma omp parallel for schedule(static) if (boundary->count > THREADS_FROM)
    for (int run = 0; run < boundary->run_count; ++run)
        sweep_run(boundary, run, solid->x, solid->y, wall_sweep);
    for (int run = 0; run < boundary->run_count; ++run) {
        const fw_box swept = boundary->swept[run];
        if (generation == boundary->generation && fw_box_lies_within(swept, boundary->fat[run]))
            continue;
        double step = boundary->reach[run] + wall_sweep;
        /* A quarter of the spacing at least, so that the trembling of a body at rest needs no
         * query: 32 particles in a row are 31 spacings long. */
        double spacing = (swept.high.x - swept.low.x + swept.high.y - swept.low.y) / RUN;
        FW_TRY(query(boundary, broadphase, run,
                     fw_box_grown(swept, fmax(steps_ahead_if_alone * step, spacing)), error));
        if (boundary->facet_count[run] > 0)
            FW_TRY(query(boundary, broadphase, run,
                         fw_box_grown(swept, fmax(steps_ahead * step, spacing / 4)), error));
    }
    boundary->generation = generation;
    return FW_OK;
}

static fw_box box_of_run(const fw_boundary *boundary, const fw_solid *solid, int run)
{
    const fw_boundary_run of = fw_boundary_observe_run(boundary, run);
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int n = of.first; n < of.first + of.count; ++n) {
        const fw_vec2 at = fw_solid_position(solid, boundary->particles[n]);
        box = fw_box_joined(box, (fw_box){at, at});
    }
    return box;
}

double fw_boundary_clearance(const fw_boundary *boundary, const fw_solid *solid,
                             const fw_broadphase *broadphase, double most)
{
    double clear = most;
    for (int run = 0; run < boundary->run_count; ++run)
        if (boundary->facet_count[run] > 0) return 0; /* near enough to be asked in each step */
    for (int run = 0; run < boundary->run_count; ++run) {
        const fw_box box = box_of_run(boundary, solid, run);
        int facet;
        while (fw_broadphase_query(broadphase, fw_box_grown(box, clear), &facet, 1) > 0)
            if ((clear /= 2) < most / 256) return 0;
    }
    return clear;
}

fw_status fw_boundary_extend(fw_boundary *boundary, const fw_broadphase *broadphase, int run,
                             fw_vec2 point, fw_error *error)
{
    assert(run >= 0 && run < boundary->run_count);
    fw_box *fat = &boundary->fat[run];
    if (fw_box_lies_within((fw_box){point, point}, *fat)) return FW_OK;
    const fw_box wider = fw_box_joined(*fat, (fw_box){point, point});
    return query(boundary, broadphase, run, wider, error);
}
