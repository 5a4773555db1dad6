/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_layout.c - who is linked to whom, what lies at the surface, and the spans of the step.
 * State: `present`, a bit per link end. Invariant: the two ends of a link agree; links, boundary
 * and spans follow from `present`. Start reading at lb_layout_rebuild(). */
#include "lb_layout.h"

#include <string.h>

static bool lies_at(const fw_sites *sites, int l, int i, int j)
{
    return l >= 0 && l < sites->count && sites->site[l].i == i && sites->site[l].j == j;
}

static void link(lb_solid *lb, int l, int direction, int m)
{
    lb->neighbour[direction][l] = m;
    lb->neighbour[fw_opposite(direction)][m] = l;
    lb->present[l] |= (uint8_t)(1u << direction);
    lb->present[m] |= (uint8_t)(1u << fw_opposite(direction));
}

/* A site whose neighbour above or below is missing has not all links: then it is of no matter
 * whether a corner is missing too. */
void lb_layout_connect(lb_solid *lb, const fw_sites *sites)
{
    int above = 0;
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        memset(lb->neighbour[d], 0xff, (size_t)sites->count * sizeof *lb->neighbour[d]); /* -1 */
    for (int l = 0; l < sites->count; ++l) {
        const fw_site site = sites->site[l], north = {site.i, site.j + 1};
        const bool east = lies_at(sites, l + 1, site.i + 1, site.j);
        const bool west = lb->neighbour[FW_WEST][l] >= 0;
        if (east) link(lb, l, FW_EAST, l + 1);
        const int m = fw_sites_find_next(sites, north, &above);
        if (m < 0) continue;
        link(lb, l, FW_NORTH, m);
        const bool corners = lies_at(sites, m - 1, north.i - 1, north.j) &&
                             lies_at(sites, m + 1, north.i + 1, north.j);
        if (!corners) lb->edge[l] = true;
        if (!east || !west) lb->edge[m] = true;
    }
}

/* Greedy: a span grows while the next particle is of the same kind and its neighbours lie at the
 * same distances. */
static bool continues(const lb_solid *lb, const span *s, int l, bool full)
{
    if (s->full != full || l % LB_CHUNK == 0) return false;
    for (int d = 0; full && d < FW_DIRECTIONS; ++d)
        if (lb->neighbour[d][l] - l != s->offset[d]) return false;
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
        for (int d = 0; full && d < FW_DIRECTIONS; ++d) s->offset[d] = lb->neighbour[d][l] - l;
    }
    lb->chunk_span[lb->chunk_count] = count;
}

/* Of a particle with four links: is a cell around it open? One side of the cell that does not touch
 * the particle is broken, and what comes through there can reach it. */
static bool lies_at_crack(const lb_solid *lb, int l)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int next = (d + 1) % FW_DIRECTIONS;
        if (!(lb->present[lb->neighbour[d][l]] & (1u << next)) ||
            !(lb->present[lb->neighbour[next][l]] & (1u << d)))
            return true;
    }
    return false;
}

void lb_layout_rebuild(lb_solid *lb)
{
    fw_solid *head = &lb->head;
    head->link_count = 0;
    head->boundary_count = 0;
    for (int l = 0; l < head->count; ++l) {
        for (int d = FW_EAST; d <= FW_NORTH; ++d)
            if (lb->present[l] & (1u << d)) {
                head->links[head->link_count][0] = l;
                head->links[head->link_count][1] = lb->neighbour[d][l];
                head->link_count += 1;
            }
        if (lb->edge[l] || lb->present[l] != LB_ALL_LINKS || lies_at_crack(lb, l))
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
            const int m = d < FW_DIRECTIONS ? lb->neighbour[d][l] : -1;
            if (m < 0 || !(lb->present[m] & (1u << fw_opposite(d))))
                return fw_fail(error, FW_BAD_INPUT,
                               "particle %d has a link in direction %d that leads nowhere", l, d);
        }
    return FW_OK;
}
