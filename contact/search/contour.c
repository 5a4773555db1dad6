/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contour.c - walks around the faces of a body's links. A link has two halves, one for each
 * direction; the half that follows in a walk with the face on the left is, at the particle that it
 * leads to, the first one clockwise from the way back. Keeps no state.
 * Start reading at fw_contour_create(). */
#include "contact/search/contour.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { CELL_MAX = 4 }; /* links around a cell */

/* Halves that start at particle p: heads[begin[p]] ... heads[begin[p + 1] - 1], counter-clockwise.
 */
typedef struct halves {
    int count;
    int *begin, *heads;
    uint8_t *seen; /* per half: its face was walked around */
} halves;

static void release(halves *h)
{
    free(h->begin);
    free(h->heads);
    free(h->seen);
}

/* Is the direction a before b, counter-clockwise from the positive x axis? */
static bool precedes(fw_vec2 a, fw_vec2 b)
{
    const bool upper_a = a.y > 0 || (a.y == 0 && a.x > 0);
    const bool upper_b = b.y > 0 || (b.y == 0 && b.x > 0);
    if (upper_a != upper_b) return upper_a;
    return fw_vec2_cross(a, b) > 0;
}

/* By insertion: a particle has few links. */
static void sort_around(const halves *h, const fw_vec2 *home, int particle)
{
    for (int n = h->begin[particle] + 1; n < h->begin[particle + 1]; ++n) {
        const int head = h->heads[n];
        const fw_vec2 direction = fw_vec2_subtract(home[head], home[particle]);
        int at = n;
        for (; at > h->begin[particle]; --at) {
            const int other = h->heads[at - 1];
            if (!precedes(direction, fw_vec2_subtract(home[other], home[particle]))) break;
            h->heads[at] = other;
        }
        h->heads[at] = head;
    }
}

static fw_status list_halves(halves *h, const fw_solid *solid, const fw_vec2 *home, fw_error *error)
{
    const size_t particles = (size_t)solid->count, count = 2 * (size_t)solid->link_count;
    h->count = 2 * solid->link_count;
    h->begin = calloc(particles + 1, sizeof *h->begin);
    h->heads = calloc(count + 1, sizeof *h->heads);
    h->seen = calloc(count + 1, sizeof *h->seen);
    if (!h->begin || !h->heads || !h->seen) return fw_fail_memory(error, "the contour of a body");
    for (int n = 0; n < solid->link_count; ++n)
        for (int k = 0; k < 2; ++k) h->begin[solid->links[n][k]] += 1;
    for (size_t p = 1; p <= particles; ++p) h->begin[p] += h->begin[p - 1];
    for (int n = solid->link_count - 1; n >= 0; --n)
        for (int k = 0; k < 2; ++k)
            h->heads[--h->begin[solid->links[n][k]]] = solid->links[n][1 - k];
    for (int p = 0; p < solid->count; ++p) sort_around(h, home, p);
    return FW_OK;
}

/* The half that follows the one from `tail` to `head`. */
static int next_half(const halves *h, int tail, int head)
{
    int back = h->begin[head];
    while (h->heads[back] != tail) ++back;
    return back > h->begin[head] ? back - 1 : h->begin[head + 1] - 1;
}

/* Marks the face of a half as seen if it is a cell. */
static bool is_cell(const halves *h, const fw_vec2 *home, int tail, int half)
{
    int walked[CELL_MAX], count = 0, at = tail, next = half;
    double area = 0;
    do {
        if (count == CELL_MAX) return false;
        walked[count++] = next;
        const int head = h->heads[next];
        area += fw_vec2_cross(fw_vec2_subtract(home[at], home[tail]),
                              fw_vec2_subtract(home[head], home[tail]));
        next = next_half(h, at, head);
        at = head;
    } while (next != half);
    if (!(area > 0)) return false;
    for (int n = 0; n < count; ++n) h->seen[walked[n]] = 1;
    return true;
}

static int point_of(fw_contour *contour, int particle)
{
    int *point = &contour->points[particle];
    if (*point < 0) {
        *point = contour->point_count++;
        contour->particles[*point] = particle;
    }
    return *point;
}

static void walk_around(fw_contour *contour, const halves *h, int tail, int half)
{
    int at = tail, next = half;
    do {
        const int head = h->heads[next];
        const int from = point_of(contour, at), to = point_of(contour, head);
        h->seen[next] = 2;
        contour->segments[contour->segment_count++] = (fw_contour_segment){.from = from, .to = to};
        if (h->begin[at + 1] - h->begin[at] == 1) contour->tips[from] = 1;
        next = next_half(h, at, head);
        at = head;
    } while (next != half);
}

static void add_single(fw_contour *contour, int particle)
{
    const int point = point_of(contour, particle);
    contour->segments[contour->segment_count++] =
        (fw_contour_segment){.from = point, .to = point, .two_sided = true};
    contour->tips[point] = 1;
}

static bool has_reverse(const fw_contour *contour, const halves *h, const fw_contour_segment *s)
{
    const int tail = contour->particles[s->to], head = contour->particles[s->from];
    for (int half = h->begin[tail]; half < h->begin[tail + 1]; ++half)
        if (h->heads[half] == head) return h->seen[half] == 2;
    return false;
}

/* In the order of the particles that halves lead to, which does not hang on how the body lies; -1:
 * all are seen. */
static int first_unseen(const halves *h, int particle)
{
    int first = -1;
    for (int half = h->begin[particle]; half < h->begin[particle + 1]; ++half)
        if (!h->seen[half] && (first < 0 || h->heads[half] < h->heads[first])) first = half;
    return first;
}

static void walk_all(fw_contour *contour, const halves *h, const fw_solid *solid,
                     const fw_vec2 *home)
{
    for (int p = 0; p < solid->count; ++p) {
        if (h->begin[p] == h->begin[p + 1] && !solid->model->bare_is_nothing)
            add_single(contour, p);
        for (int half; (half = first_unseen(h, p)) >= 0;)
            if (!is_cell(h, home, p, half)) walk_around(contour, h, p, half);
    }
    for (int n = 0; n < contour->segment_count; ++n) {
        fw_contour_segment *s = &contour->segments[n];
        if (s->from != s->to) s->two_sided = has_reverse(contour, h, s);
    }
}

fw_status fw_contour_create(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                            fw_error *error)
{
    halves h = {0};
    const size_t particles = (size_t)solid->count;
    *contour = (fw_contour){0};
    contour->particles = calloc(particles + 1, sizeof *contour->particles);
    contour->tips = calloc(particles + 1, sizeof *contour->tips);
    contour->points = calloc(particles + 1, sizeof *contour->points);
    contour->segments =
        calloc(2 * (size_t)solid->link_count + particles + 1, sizeof *contour->segments);
    fw_status status = FW_OK;
    if (!contour->particles || !contour->tips || !contour->points || !contour->segments)
        status = fw_fail_memory(error, "the contour of a body");
    if (status == FW_OK) status = list_halves(&h, solid, home, error);
    if (status == FW_OK) {
        for (size_t p = 0; p < particles; ++p) contour->points[p] = -1;
        walk_all(contour, &h, solid, home);
    } else {
        fw_contour_clear(contour);
    }
    release(&h);
    return status;
}

void fw_contour_clear(fw_contour *contour)
{
    free(contour->particles);
    free(contour->tips);
    free(contour->points);
    free(contour->segments);
    *contour = (fw_contour){0};
}
