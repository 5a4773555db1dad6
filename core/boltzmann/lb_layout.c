/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_layout.c - who is linked to whom, what lies at the surface, and the spans of the step.
 * State: `present`, a bit per link end. Invariant: the two ends of a link agree; links, boundary
 * and spans follow from `present`. Start reading at lb_layout_rebuild(). */
#include "lb_layout.h"

#include <string.h>

/* Particles begin..end of one row, side by side; `column` is that of the first. */
typedef struct run {
    int begin, end;
    int64_t row, column;
} run;

/* Empty, and above all others, behind the last one. */
static run run_from(const fw_sites *sites, int begin)
{
    if (begin == sites->count) return (run){begin, begin, INT64_MAX, 0};
    return (run){begin, fw_sites_run_end(sites, begin), sites->site[begin].j, sites->site[begin].i};
}

static void link_run(lb_solid *lb, run here)
{
    for (int l = here.begin; l < here.end; ++l) lb->present[l] |= 1u << FW_EAST | 1u << FW_WEST;
    lb->present[here.begin] &= (uint8_t) ~(1u << FW_WEST);
    lb->present[here.end - 1] &= (uint8_t) ~(1u << FW_EAST);
}

/* Two runs, one in the row above the other's. Where one of them ends, the particles of the other
 * lack a corner; those that have not all links anyway are of no matter. */
static void link_rows(lb_solid *lb, run lower, run upper)
{
    const int64_t shift = upper.column - lower.column;
    const int begin = lower.begin + (int)(shift > 0 ? shift : 0);
    const int64_t reach = lower.begin + shift + (upper.end - upper.begin);
    const int end = reach < lower.end ? (int)reach : lower.end;
    const int above = (int)(upper.begin - shift - lower.begin);
    for (int l = begin; l < end; ++l) {
        lb->north[l] = l + above;
        lb->present[l] |= 1u << FW_NORTH;
    }
    for (int m = begin + above; m < end + above; ++m) {
        lb->south[m] = m - above;
        lb->present[m] |= 1u << FW_SOUTH;
    }
    if (begin == lower.begin) lb->edge[begin + above] = true;
    if (end == lower.end) lb->edge[end - 1 + above] = true;
    if (begin + above == upper.begin) lb->edge[begin] = true;
    if (end + above == upper.end) lb->edge[end - 1] = true;
}

static bool overlap(run lower, run upper)
{
    return upper.row == lower.row + 1 && upper.column < lower.column + lower.end - lower.begin &&
           lower.column < upper.column + upper.end - upper.begin;
}

/* Does a run end before those begin that lie above another one? */
static bool lies_before(run upper, run lower)
{
    if (upper.row != lower.row + 1) return upper.row < lower.row + 1;
    return upper.column + upper.end - upper.begin <= lower.column;
}

/* Runs ascend row by row, and so do those above them. */
void lb_layout_connect(lb_solid *lb, const fw_sites *sites)
{
    run above = run_from(sites, 0);
    for (run here = above; here.begin < sites->count; here = run_from(sites, here.end)) {
        link_run(lb, here);
        while (lies_before(above, here)) above = run_from(sites, above.end);
        for (run upper = above; overlap(here, upper); upper = run_from(sites, upper.end))
            link_rows(lb, here, upper);
    }
    if (lb->built) memcpy(lb->built, lb->present, (size_t)sites->count);
}

/* Greedy: a span grows while the next particle is of the same kind and its neighbours lie at the
 * same distances. */
static bool continues(const lb_solid *lb, const span *s, int l, bool full)
{
    if (s->full != full || l % LB_CHUNK == 0) return false;
    for (int d = 0; full && d < FW_DIRECTIONS; ++d)
        if (lb_neighbour(lb, l, d) - l != s->offset[d]) return false;
    return true;
}

static void cut_into_spans(lb_solid *lb)
{
    int count = 0;
    for (int l = 0; l < lb->head.count; ++l) {
        bool full = lb->present[l] == LB_ALL_LINKS && !lb->weighted;
        if (l % LB_CHUNK == 0) lb->chunk_span[l / LB_CHUNK] = count;
        if (count > 0 && continues(lb, &lb->spans[count - 1], l, full)) {
            lb->spans[count - 1].end = l + 1;
            continue;
        }
        span *s = &lb->spans[count++];
        *s = (span){.begin = l, .end = l + 1, .full = full};
        for (int d = 0; full && d < FW_DIRECTIONS; ++d) s->offset[d] = lb_neighbour(lb, l, d) - l;
    }
    lb->chunk_span[lb->chunk_count] = count;
}

/* Of a particle with four links: is a cell around it open? One side of the cell that does not touch
 * the particle is broken, and what comes through there can reach it. */
static bool lies_at_crack(const lb_solid *lb, int l)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int next = (d + 1) % FW_DIRECTIONS;
        if (!(lb->present[lb_neighbour(lb, l, d)] & (1u << next)) ||
            !(lb->present[lb_neighbour(lb, l, next)] & (1u << d)))
            return true;
    }
    return false;
}

/* Those of one particle to the east and north. */
static inline void list_links_of(lb_solid *lb, int l)
{
    int(*link)[2] = &lb->head.links[lb->head.link_count];
    if (lb->present[l] == LB_ALL_LINKS) {
        link[0][0] = link[1][0] = l;
        link[0][1] = l + 1;
        link[1][1] = lb->north[l];
        lb->head.link_count += 2;
        return;
    }
    for (int d = FW_EAST; d <= FW_NORTH; ++d)
        if (lb->present[l] & (1u << d)) {
            lb->head.links[lb->head.link_count][0] = l;
            lb->head.links[lb->head.link_count][1] = lb_neighbour(lb, l, d);
            lb->head.link_count += 1;
        }
}

void lb_layout_rebuild(lb_solid *lb)
{
    fw_solid *head = &lb->head;
    head->link_count = 0;
    head->boundary_count = 0;
    for (int l = 0; l < head->count; ++l) {
        list_links_of(lb, l);
        if (lb->edge[l] || lb->present[l] != LB_ALL_LINKS || (lb->built && lies_at_crack(lb, l)))
            head->boundary[head->boundary_count++] = l;
    }
    head->boundary_revision += 1;
    if (!lb->displaced) cut_into_spans(lb);
}

fw_status lb_layout_check(const lb_solid *lb, fw_error *error)
{
    for (int l = 0; l < lb->head.count; ++l)
        for (int d = 0; d < 8; ++d) {
            if (!(lb->present[l] & (1u << d))) continue;
            const bool known = (lb->built ? lb->built[l] : LB_ALL_LINKS) & (1u << d);
            if (!known || !(lb->present[lb_neighbour(lb, l, d)] & (1u << fw_opposite(d))))
                return fw_fail(error, FW_BAD_INPUT,
                               "particle %d has a link in direction %d that leads nowhere", l, d);
        }
    return FW_OK;
}
