/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_layout.c - who is linked to whom, what lies at the surface, and the spans of the step.
 * State: `present`, a bit per link end. Invariant: the two ends of a link agree; links, boundary
 * and spans follow from `present`. Start reading at lb_layout_rebuild(). */
#include "lb_layout.h"

static bool lies_at(const fw_sites *sites, int l, int i, int j)
{
    return l >= 0 && l < sites->count && sites->site[l].i == i && sites->site[l].j == j;
}

/* Finds the neighbour in the row above or below, and tells whether both corners beside it are there
 * too. *at is where the row was left. */
static int connect_row(const fw_sites *sites, int l, int direction, int *at, bool *corners)
{
    const fw_site beside = fw_site_neighbour(sites->site[l], direction);
    const int found = fw_sites_find_next(sites, beside, at);
    const int after = found >= 0 ? *at + 1 : *at;
    *corners = lies_at(sites, *at - 1, beside.i - 1, beside.j) &&
               lies_at(sites, after, beside.i + 1, beside.j);
    return found;
}

void lb_layout_connect(lb_solid *lb, const fw_sites *sites)
{
    int above = 0, below = 0;
    for (int l = 0; l < sites->count; ++l) {
        const fw_site site = sites->site[l];
        bool corners_above, corners_below;
        const int beside[FW_DIRECTIONS] = {
            [FW_EAST] = lies_at(sites, l + 1, site.i + 1, site.j) ? l + 1 : -1,
            [FW_NORTH] = connect_row(sites, l, FW_NORTH, &above, &corners_above),
            [FW_WEST] = lies_at(sites, l - 1, site.i - 1, site.j) ? l - 1 : -1,
            [FW_SOUTH] = connect_row(sites, l, FW_SOUTH, &below, &corners_below),
        };
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            lb->neighbour[d][l] = beside[d];
            if (beside[d] >= 0) lb->present[l] |= (uint8_t)(1u << d);
        }
        lb->edge[l] = !corners_above || !corners_below;
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
