/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contour.c - walks around the faces of a body's links. A link has two halves, one for each
 * direction; the half that follows in a walk with the face on the left is, at the particle that it
 * leads to, the first one clockwise from the way back.
 *
 * Where links have broken since, a contour is renewed by walks that begin at its old particles and
 * around the faces that those links have left: every other face is the cell that it was. The result
 * is that of a contour made anew. State: the halves and links of the last walk, once it was
 * renewed. Start reading at fw_contour_create(). */
#include "contact/search/contour.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { CELL_MAX = 4 }; /* links around a cell */

/* Halves that start at particle p: heads[begin[p]] ... heads[end[p] - 1], counter-clockwise. */
struct fw_contour_halves {
    int *begin, *end, *heads;
    uint8_t *seen; /* per half: its face was walked around; all zero between walks */
    int touched_count;
    int *touched; /* halves that are seen */
    int link_count;
    int (*links)[2]; /* as in the solid then; kept with the halves only */
};
typedef struct fw_contour_halves halves;

static void release(halves *h)
{
    if (!h) return;
    free(h->begin);
    free(h->end);
    free(h->heads);
    free(h->seen);
    free(h->touched);
    free(h->links);
}

static void see(halves *h, int half, uint8_t as)
{
    if (!h->seen[half]) h->touched[h->touched_count++] = half;
    h->seen[half] = as;
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
    for (int n = h->begin[particle] + 1; n < h->end[particle]; ++n) {
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
    h->begin = calloc(particles + 1, sizeof *h->begin);
    h->end = calloc(particles + 1, sizeof *h->end);
    h->touched = calloc(count + 1, sizeof *h->touched);
    h->heads = calloc(count + 1, sizeof *h->heads);
    h->seen = calloc(count + 1, sizeof *h->seen);
    if (!h->begin || !h->end || !h->heads || !h->seen || !h->touched)
        return fw_fail_memory(error, "the contour of a body");
    for (int n = 0; n < solid->link_count; ++n)
        for (int k = 0; k < 2; ++k) h->begin[solid->links[n][k]] += 1;
    for (size_t p = 1; p <= particles; ++p) h->begin[p] += h->begin[p - 1];
    for (int n = solid->link_count - 1; n >= 0; --n)
        for (int k = 0; k < 2; ++k)
            h->heads[--h->begin[solid->links[n][k]]] = solid->links[n][1 - k];
    for (size_t p = 0; p < particles; ++p) h->end[p] = h->begin[p + 1];
    for (int p = 0; p < solid->count; ++p) sort_around(h, home, p);
    return FW_OK;
}

/* The half that follows the one from `tail` to `head`. */
static int next_half(const halves *h, int tail, int head)
{
    int back = h->begin[head];
    while (h->heads[back] != tail) ++back;
    return back > h->begin[head] ? back - 1 : h->end[head] - 1;
}

/* Marks the face of a half as seen if it is a cell. */
static bool is_cell(halves *h, const fw_vec2 *home, int tail, int half)
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
    for (int n = 0; n < count; ++n) see(h, walked[n], 1);
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

static void walk_around(fw_contour *contour, halves *h, int tail, int half)
{
    int at = tail, next = half;
    do {
        const int head = h->heads[next];
        const int from = point_of(contour, at), to = point_of(contour, head);
        see(h, next, 2);
        contour->segments[contour->segment_count++] = (fw_contour_segment){.from = from, .to = to};
        if (h->end[at] - h->begin[at] == 1) contour->tips[from] = 1;
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
    for (int half = h->begin[tail]; half < h->end[tail]; ++half)
        if (h->heads[half] == head) return h->seen[half] == 2;
    return false;
}

/* In the order of the particles that halves lead to, which does not hang on how the body lies; -1:
 * all are seen. */
static int first_unseen(const halves *h, int particle)
{
    int first = -1;
    for (int half = h->begin[particle]; half < h->end[particle]; ++half)
        if (!h->seen[half] && (first < 0 || h->heads[half] < h->heads[first])) first = half;
    return first;
}

static void walk_from(fw_contour *contour, halves *h, const fw_solid *solid, const fw_vec2 *home,
                      int particle)
{
    if (h->begin[particle] == h->end[particle] && !solid->model->bare_is_nothing)
        add_single(contour, particle);
    for (int half; (half = first_unseen(h, particle)) >= 0;)
        if (!is_cell(h, home, particle, half)) walk_around(contour, h, particle, half);
}

static void forget_seen(halves *h)
{
    for (int n = 0; n < h->touched_count; ++n) h->seen[h->touched[n]] = 0;
    h->touched_count = 0;
}

/* Which segments have a twin. */
static void end_walk(fw_contour *contour, halves *h)
{
    for (int n = 0; n < contour->segment_count; ++n) {
        fw_contour_segment *s = &contour->segments[n];
        if (s->from != s->to) s->two_sided = has_reverse(contour, h, s);
    }
    forget_seen(h);
}

static fw_status make(fw_contour *contour, halves *h, const fw_solid *solid, const fw_vec2 *home,
                      fw_error *error)
{
    const size_t particles = (size_t)solid->count;
    contour->particles = calloc(particles + 1, sizeof *contour->particles);
    contour->tips = calloc(particles + 1, sizeof *contour->tips);
    contour->points = calloc(particles + 1, sizeof *contour->points);
    contour->segments =
        calloc(2 * (size_t)solid->link_count + particles + 1, sizeof *contour->segments);
    if (!contour->particles || !contour->tips || !contour->points || !contour->segments)
        return fw_fail_memory(error, "the contour of a body");
    FW_TRY(list_halves(h, solid, home, error));
    for (size_t p = 0; p < particles; ++p) contour->points[p] = -1;
    for (int p = 0; p < solid->count; ++p) walk_from(contour, h, solid, home, p);
    end_walk(contour, h);
    return FW_OK;
}

fw_status fw_contour_create(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                            fw_error *error)
{
    halves h = {0};
    *contour = (fw_contour){0};
    const fw_status status = make(contour, &h, solid, home, error);
    if (status != FW_OK) fw_contour_clear(contour);
    release(&h);
    return status;
}

/* The same, and keeps the halves. */
static fw_status make_to_renew(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                               fw_error *error)
{
    fw_contour_clear(contour);
    halves *h = contour->halves = calloc(1, sizeof *h);
    fw_status status = h ? FW_OK : fw_fail_memory(error, "the contour of a body");
    if (status == FW_OK) status = make(contour, h, solid, home, error);
    if (status == FW_OK) {
        h->links = malloc(((size_t)solid->link_count + 1) * sizeof *h->links);
        if (!h->links) status = fw_fail_memory(error, "the contour of a body");
    }
    if (status == FW_OK) {
        h->link_count = solid->link_count;
        memcpy(h->links, solid->links, (size_t)h->link_count * sizeof *h->links);
    } else {
        fw_contour_clear(contour);
    }
    return status;
}

static void remove_half(halves *h, int tail, int head)
{
    int at = h->begin[tail];
    while (h->heads[at] != head) ++at;
    for (; at + 1 < h->end[tail]; ++at) h->heads[at] = h->heads[at + 1];
    h->end[tail] -= 1;
}

static int compare_ints(const void *left, const void *right)
{
    const int a = *(const int *)left, b = *(const int *)right;
    return (a > b) - (a < b);
}

/* Takes out the links that are no longer there, and lists their ends behind the contour's own
 * particles. Returns how many particles there are in the list; -1: links have come, too. */
static int follow_links(halves *h, const fw_solid *solid, int *list, int count, int room)
{
    int kept = 0;
    for (int n = 0; n < h->link_count; ++n) {
        const int *old = h->links[n];
        if (kept < solid->link_count && solid->links[kept][0] == old[0] &&
            solid->links[kept][1] == old[1]) {
            h->links[kept][0] = old[0];
            h->links[kept++][1] = old[1];
            continue;
        }
        if (count + 2 > room) return -1;
        for (int k = 0; k < 2; ++k) {
            remove_half(h, old[k], old[1 - k]);
            list[count++] = old[k];
        }
    }
    h->link_count = kept;
    return kept == solid->link_count ? count : -1;
}

/* Lists the particles around faces, other than cells, at the listed ones from `first` on: a chain
 * begins at its first particle. Returns how many there are in the list. */
static int list_faces(halves *h, const fw_vec2 *home, int *list, int first, int count)
{
    int longer = count;
    for (int n = first; n < count; ++n)
        for (int half; (half = first_unseen(h, list[n])) >= 0;) {
            if (is_cell(h, home, list[n], half)) continue;
            int at = list[n], next = half;
            do {
                const int head = h->heads[next];
                see(h, next, 2);
                list[longer++] = at;
                next = next_half(h, at, head);
                at = head;
            } while (next != half);
        }
    forget_seen(h);
    return longer;
}

fw_status fw_contour_renew(fw_contour *contour, const fw_solid *solid, const fw_vec2 *home,
                           fw_error *error)
{
    halves *h = contour->halves;
    if (!h || solid->link_count > h->link_count) return make_to_renew(contour, solid, home, error);
    const int room = contour->point_count + 2 * (h->link_count - solid->link_count);
    int *list = malloc(((size_t)room + 2 * (size_t)solid->link_count + 1) * sizeof *list);
    if (!list) return fw_fail_memory(error, "the contour of a body");
    memcpy(list, contour->particles, (size_t)contour->point_count * sizeof *list);
    int count = follow_links(h, solid, list, contour->point_count, room);
    if (count < 0) {
        free(list);
        return make_to_renew(contour, solid, home, error);
    }
    count = list_faces(h, home, list, contour->point_count, count);
    for (int point = 0; point < contour->point_count; ++point) {
        contour->points[contour->particles[point]] = -1;
        contour->tips[point] = 0;
    }
    contour->point_count = contour->segment_count = 0;
    qsort(list, (size_t)count, sizeof *list, compare_ints);
    for (int n = 0; n < count; ++n)
        if (n == 0 || list[n] != list[n - 1]) walk_from(contour, h, solid, home, list[n]);
    end_walk(contour, h);
    free(list);
    return FW_OK;
}

void fw_contour_clear(fw_contour *contour)
{
    free(contour->particles);
    free(contour->tips);
    free(contour->points);
    free(contour->segments);
    release(contour->halves);
    free(contour->halves);
    *contour = (fw_contour){0};
}
