/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_layout.c - from a set of sites to colours, spans and rims. Keeps no state.
 * Start reading at fw_automaton_lay_out(). */
#include "automaton_sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 1 << FW_DIRECTIONS };

/* Neighbours by particle; -1: none. `seam` has bit d set where the neighbour lies across the seam
 * of a periodic lattice. */
typedef struct surroundings {
    int (*next)[FW_DIRECTIONS];
    uint8_t *seam;
} surroundings;

static void join(surroundings *around, int from, int direction, int to)
{
    around->next[from][direction] = to;
    around->next[to][fw_opposite(direction)] = from;
}

/* Sites ascend row by row, and so do their northern neighbours: one pointer finds them all. */
static void find_neighbours(surroundings *around, const fw_sites *sites)
{
    const fw_site *site = sites->site;
    for (int p = 0; p < sites->count; ++p)
        for (int d = 0; d < FW_DIRECTIONS; ++d) around->next[p][d] = -1;
    int north = 0;
    for (int p = 0; p < sites->count; ++p) {
        if (p + 1 < sites->count && site[p + 1].j == site[p].j && site[p + 1].i == site[p].i + 1)
            join(around, p, FW_EAST, p + 1);
        while (north < sites->count &&
               (site[north].j < site[p].j + 1 ||
                (site[north].j == site[p].j + 1 && site[north].i < site[p].i)))
            ++north;
        if (north < sites->count && site[north].j == site[p].j + 1 && site[north].i == site[p].i)
            join(around, p, FW_NORTH, north);
    }
}

static void close_seam(surroundings *around, const fw_sites *sites, int direction, fw_site back)
{
    for (int p = 0; p < sites->count; ++p) {
        if (around->next[p][direction] >= 0) continue;
        const fw_site beyond = fw_site_neighbour(sites->site[p], direction);
        const int partner = fw_sites_find(sites, (fw_site){beyond.i - back.i, beyond.j - back.j});
        if (partner < 0) continue;
        join(around, p, direction, partner);
        around->seam[p] |= (uint8_t)(1 << direction);
        around->seam[partner] |= (uint8_t)(1 << fw_opposite(direction));
    }
}

static fw_status check_period(int period, int extent, const char *what, fw_error *error)
{
    if (period == 0) return FW_OK;
    if (period < 2 || period % 2 != 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "a period of %d %s, expected an even number: black and white cells must "
                       "alternate across the seam too",
                       period, what);
    if (extent > period)
        return fw_fail(error, FW_BAD_INPUT,
                       "the shape takes %d %s, expected at most its period of %d", extent, what,
                       period);
    return FW_OK;
}

static fw_status surround(surroundings *around, const fw_elastic_automaton_def *def,
                          fw_error *error)
{
    const fw_sites *sites = def->sites;
    int low = sites->site[0].i, high = low;
    for (int p = 1; p < sites->count; ++p) {
        if (sites->site[p].i < low) low = sites->site[p].i;
        if (sites->site[p].i > high) high = sites->site[p].i;
    }
    const int rows = sites->site[sites->count - 1].j - sites->site[0].j + 1;
    FW_TRY(check_period(def->period_columns, high - low + 1, "columns", error));
    FW_TRY(check_period(def->period_rows, rows, "rows", error));
    find_neighbours(around, sites);
    if (def->period_columns > 0)
        close_seam(around, sites, FW_EAST, (fw_site){def->period_columns, 0});
    if (def->period_rows > 0) close_seam(around, sites, FW_NORTH, (fw_site){0, def->period_rows});
    for (int p = 0; p < sites->count; ++p) {
        const int *next = around->next[p];
        if (next[0] < 0 && next[1] < 0 && next[2] < 0 && next[3] < 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "site [%d, %d] has no neighbour, expected at least one: a cell of the "
                           "automaton without bonds has neither mass nor velocity",
                           sites->site[p].i, sites->site[p].j);
    }
    return FW_OK;
}

/* 1, or 1/2 for `trapezoid` where at most one of the two squares of cells beside a bond is full:
 * the energy of a bond is that of the squares it borders. */
static double bond_weight(const surroundings *around, fw_boundary_rule boundary, int particle,
                          int direction)
{
    const int partner = around->next[particle][direction];
    if (partner < 0) return 0;
    if (boundary != FW_BOUNDARY_TRAPEZOID) return 1;
    int full = 0;
    for (int side = 1; side <= 3; side += 2) {
        const int sideways = (direction + side) % FW_DIRECTIONS;
        const int near = around->next[particle][sideways];
        full +=
            near >= 0 && around->next[partner][sideways] >= 0 && around->next[near][direction] >= 0;
    }
    return full == 2 ? 1 : 0.5;
}

static bool is_inside(const fw_automaton *body, const surroundings *around, int particle)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (bond_weight(around, body->boundary, particle, d) < 1) return false;
    return true;
}

/* Deals the particles out to the colours. */
static fw_status deal_colours(fw_automaton *body, const fw_elastic_automaton_def *def,
                              fw_error *error)
{
    const size_t size = (size_t)body->head.count;
    body->cell = fw_array_zeroed(size, sizeof *body->cell);
    body->white = fw_array_zeroed(size, sizeof *body->white);
    if (!body->cell || !body->white) return fw_fail_memory(error, "the colours of an automaton");
    for (int p = 0; p < body->head.count; ++p) {
        const fw_site site = def->sites->site[p];
        body->white[p] = (uint8_t)(((site.i + site.j) & 1) != (int)def->black_is_odd);
        body->cell[p] = body->colour[body->white[p]].count++;
    }
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        const size_t cells = (size_t)colour->count;
        FW_ARENA_ADD(&body->cells, colour->x, cells);
        FW_ARENA_ADD(&body->cells, colour->y, cells);
        FW_ARENA_ADD(&body->cells, colour->particle, cells);
        FW_ARENA_ADD(&body->cells, colour->place, cells);
        FW_ARENA_ADD(&body->cells, colour->held, cells);
    }
    FW_ARENA_ADD(&body->cells, body->sums, 1);
    FW_TRY(fw_arena_allocate(&body->cells, "the cells of an automaton", error));
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        for (int n = 0; n < colour->count; ++n) colour->held[n] = -1;
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            colour->matrix[d] = &body->matrices.bond[c == FW_BLACK ? d : fw_opposite(d)];
    }
    for (int p = 0; p < body->head.count; ++p)
        body->colour[body->white[p]].particle[body->cell[p]] = p;
    return FW_OK;
}

static bool continues(const fw_automaton_span *span, const fw_automaton *body, const int *next,
                      int cell, int particle)
{
    if (span->count == 0) return false;
    if (span->begin + span->count != cell || span->particle + 2 * span->count != particle)
        return false;
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (body->cell[next[d]] != cell + span->offset[d]) return false;
    return true;
}

/* Numbers rows and lists the runs of sites side by side, where there is room for them already. */
static void cut_runs(fw_automaton *body, const fw_sites *sites)
{
    body->run_count = body->row_count = 0;
    for (int p = 0; p < sites->count; ++p) {
        const fw_site site = sites->site[p];
        const bool same_row = p > 0 && site.j == sites->site[p - 1].j;
        body->row_count += !same_row;
        if (same_row && site.i == sites->site[p - 1].i + 1) {
            fw_automaton_run *run = body->run ? &body->run[body->run_count - 1] : NULL;
            if (run && run->count == 1) run->cell[1] = body->cell[p];
            if (run) run->count += 1;
            continue;
        }
        if (body->run)
            body->run[body->run_count] = (fw_automaton_run){
                .site = site, .particle = p, .count = 1, .cell = {body->cell[p]}};
        body->run_count += 1;
    }
}

static fw_status list_runs(fw_automaton *body, const fw_sites *sites, fw_error *error)
{
    cut_runs(body, sites);
    body->run = fw_array_allocate((size_t)body->run_count, sizeof *body->run);
    body->share = fw_array_allocate(FW_SHARED_TICKS * (size_t)body->row_count, sizeof *body->share);
    if (!body->run || !body->share) return fw_fail_memory(error, "the rows of an automaton");
    cut_runs(body, sites);
    return FW_OK;
}

/* Cuts the inside of a colour into spans, each in one row, and counts its rim; fills colour->place
 * and the rows. */
static void cut_spans(fw_automaton *body, const surroundings *around, fw_automaton_colour *colour)
{
    fw_automaton_span span = {0};
    colour->span_count = colour->rim_count = 0;
    int n = 0, row = 0;
    for (int r = 0; r < body->run_count; ++r) {
        const fw_automaton_run *run = &body->run[r];
        if (r == 0 || run->site.j != run[-1].site.j) {
            colour->row[row++] = (fw_automaton_row){n, colour->span_count, colour->rim_count};
            span.count = 0;
        }
        for (; n < colour->count && colour->particle[n] < run->particle + run->count; ++n) {
            const int particle = colour->particle[n], *next = around->next[particle];
            if (!is_inside(body, around, particle)) {
                colour->place[n] = colour->rim_count++;
                continue;
            }
            if (!continues(&span, body, next, n, particle)) {
                colour->span_count += 1;
                span = (fw_automaton_span){.begin = n, .particle = particle};
                for (int d = 0; d < FW_DIRECTIONS; ++d) span.offset[d] = body->cell[next[d]] - n;
            }
            span.count += 1;
            colour->place[n] = ~(colour->span_count - 1);
        }
    }
    colour->row[row] = (fw_automaton_row){n, colour->span_count, colour->rim_count};
}

static void fill_spans(const fw_automaton *body, const surroundings *around,
                       fw_automaton_colour *colour)
{
    for (int n = 0; n < colour->count; ++n) {
        if (colour->place[n] >= 0) continue;
        fw_automaton_span *span = &colour->span[~colour->place[n]];
        if (span->count++ > 0) continue;
        span->begin = n;
        span->particle = colour->particle[n];
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            span->offset[d] = body->cell[around->next[span->particle][d]] - n;
    }
}

static fw_status fill_rim(fw_automaton *body, const surroundings *around, int c,
                          const fw_sites *sites, fw_error *error)
{
    fw_automaton_colour *colour = &body->colour[c];
    for (int n = 0; n < colour->count; ++n) {
        if (colour->place[n] < 0) continue;
        const int particle = colour->particle[n], *next = around->next[particle];
        const fw_site site = sites->site[particle];
        fw_automaton_rim *rim = &colour->rim[colour->place[n]];
        rim->cell = n;
        rim->span = -1;
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            rim->neighbour[d] = next[d] < 0 ? -1 : body->cell[next[d]];
            rim->weight[d] = bond_weight(around, body->boundary, particle, d);
            if (body->boundary == FW_BOUNDARY_MIRROR && next[d] < 0 && next[fw_opposite(d)] < 0)
                return fw_fail(error, FW_BAD_INPUT,
                               "boundary rule 'mirror': site [%d, %d] lacks two opposite "
                               "neighbours, expected one of them as the image of the other",
                               site.i, site.j);
        }
        if (!fw_automaton_rim_weigh(body, c, rim))
            return fw_fail(error, FW_BAD_INPUT,
                           "boundary rule '%s' with c1 = %g, c2 = %g: the bonds of site [%d, %d] "
                           "give it a mass that is not positive, which is unstable; expected other "
                           "speeds or another rule",
                           body->boundary == FW_BOUNDARY_BOND ? "bond" : "trapezoid",
                           body->matrices.speeds.transverse, body->matrices.speeds.coupling, site.i,
                           site.j);
    }
    return FW_OK;
}

static fw_status lay_out_colour(fw_automaton *body, const surroundings *around, int c,
                                const fw_sites *sites, fw_error *error)
{
    fw_automaton_colour *colour = &body->colour[c];
    colour->row = fw_array_allocate((size_t)body->row_count + 1, sizeof *colour->row);
    if (!colour->row) return fw_fail_memory(error, "the rows of an automaton");
    cut_spans(body, around, colour);
    colour->span = fw_array_allocate((size_t)colour->span_count, sizeof *colour->span);
    colour->rim = fw_array_allocate((size_t)colour->rim_count, sizeof *colour->rim);
    colour->rim_room = colour->rim_count;
    if (!colour->span || !colour->rim) return fw_fail_memory(error, "the rims of an automaton");
    fill_spans(body, around, colour);
    return fill_rim(body, around, c, sites, error);
}

/* Remembers seams and edges; makes room for the list of bonds and fills it. */
static fw_status find_borders(fw_automaton *body, const surroundings *around, fw_error *error)
{
    const size_t size = (size_t)body->head.count;
    size_t links = 0;
    body->border = fw_array_zeroed(size, sizeof *body->border);
    if (!body->border) return fw_fail_memory(error, "the borders of an automaton");
    for (int p = 0; p < body->head.count; ++p) {
        const int *next = around->next[p];
        body->border[p] = around->seam[p];
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            const int turned = (d + 1) % FW_DIRECTIONS;
            if (next[d] < 0 || around->next[next[d]][turned] < 0) body->border[p] |= EDGE;
        }
        for (int d = FW_EAST; d <= FW_NORTH; ++d) links += next[d] >= 0;
    }
    body->head.links = fw_array_zeroed(links, sizeof *body->head.links);
    if (!body->head.links) return fw_fail_memory(error, "the bonds of an automaton");
    fw_automaton_list_bonds(body);
    return FW_OK;
}

void fw_automaton_list_bonds(fw_automaton *body)
{
    fw_solid *head = &body->head;
    head->link_count = head->boundary_count = 0;
    for (int p = 0; p < head->count; ++p) {
        const int colour = body->white[p];
        bool exposed = body->border[p] & EDGE;
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            double weight;
            const int partner =
                fw_automaton_cell_neighbour(body, colour, body->cell[p], d, &weight);
            exposed |= partner < 0;
            if (d > FW_NORTH || partner < 0 || body->border[p] >> d & 1) continue;
            head->links[head->link_count][0] = p;
            head->links[head->link_count][1] = body->colour[!colour].particle[partner];
            head->link_count += 1;
        }
        if (exposed) head->boundary[head->boundary_count++] = p;
    }
    head->boundary_revision += 1;
    body->gone_count = 0;
}

static fw_status lay_out_breakable(fw_automaton *body, fw_error *error)
{
    const fw_automaton_colour *black = &body->colour[FW_BLACK];
    const int most =
        black->count > body->colour[FW_WHITE].count ? black->count : body->colour[FW_WHITE].count;
    body->bonds = fw_array_allocate((size_t)black->count, sizeof *body->bonds);
    body->built = fw_array_allocate((size_t)black->count, sizeof *body->built);
    body->torn = fw_array_allocate((size_t)most, sizeof *body->torn);
    for (int c = 0; c < FW_COLOURS; ++c)
        body->colour[c].gaps =
            fw_array_allocate((size_t)body->row_count, sizeof *body->colour[c].gaps);
    if (!body->bonds || !body->built || !body->torn || !body->colour[FW_BLACK].gaps ||
        !body->colour[FW_WHITE].gaps)
        return fw_fail_memory(error, "the breaking bonds");
    for (int n = 0; n < black->count; ++n)
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            double weight;
            body->built[n][d] = fw_automaton_cell_neighbour(body, FW_BLACK, n, d, &weight);
            if (body->built[n][d] >= 0) body->bonds[n] |= (uint8_t)(1 << d);
        }
    return FW_OK;
}

fw_status fw_automaton_lay_out(fw_automaton *body, const fw_elastic_automaton_def *def,
                               fw_error *error)
{
    const size_t size = (size_t)body->head.count;
    surroundings around = {fw_array_zeroed(size, sizeof *around.next),
                           fw_array_zeroed(size, sizeof *around.seam)};
    body->ring_of_rows = def->period_rows > 0;
    fw_status status = around.next && around.seam
                           ? FW_OK
                           : fw_fail_memory(error, "the neighbours of an automaton");
    if (status == FW_OK) status = surround(&around, def, error);
    if (status == FW_OK) status = deal_colours(body, def, error);
    if (status == FW_OK) status = list_runs(body, def->sites, error);
    for (int c = 0; c < FW_COLOURS && status == FW_OK; ++c)
        status = lay_out_colour(body, &around, c, def->sites, error);
    if (status == FW_OK) status = find_borders(body, &around, error);
    if (status == FW_OK && body->breaks) status = lay_out_breakable(body, error);
    free(around.next);
    free(around.seam);
    return status;
}
