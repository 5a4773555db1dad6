/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_layout.c - from a set of sites to colours, spans and rims. Keeps no state.
 * Start reading at fw_automaton_lay_out(). */
#include "automaton_surroundings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 1 << FW_DIRECTIONS };

/* 1, or 1/2 for `trapezoid` where at most one of the two squares of cells beside a bond is full:
 * the energy of a bond is that of the squares it borders. */
static double bond_weight(const fw_automaton_surroundings *around, fw_boundary_rule boundary,
                          int particle, int direction)
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

/* Next to all four neighbours, and every bond of full weight? */
static bool is_inside(const fw_automaton *body, const fw_automaton_surroundings *around,
                      int particle)
{
    const int *next = around->next[particle];
    if ((next[0] | next[1] | next[2] | next[3]) < 0) return false;
    for (int d = 0; d < FW_DIRECTIONS && body->boundary == FW_BOUNDARY_TRAPEZOID; ++d)
        if (bond_weight(around, body->boundary, particle, d) < 1) return false;
    return true;
}

static int colour_of(fw_site site, const fw_elastic_automaton_def *def)
{
    return ((site.i + site.j) & 1) == (int)def->black_is_odd ? FW_BLACK : FW_WHITE;
}

/* Particles of a run are of either colour in turn, and so are their cells. */
static void deal_run(fw_automaton *body, fw_automaton_run *run, int first, int cell[FW_COLOURS])
{
    for (int parity = 0; parity < 2; ++parity) {
        const int colour = parity == 0 ? first : !first;
        int *particle = body->colour[colour].particle, n = cell[colour];
        run->cell[parity] = parity < run->count ? n : 0;
        for (int k = parity; k < run->count; k += 2, ++n) {
            body->white[run->particle + k] = (uint8_t)colour;
            body->cell[run->particle + k] = n;
            particle[n] = run->particle + k;
        }
        cell[colour] = n;
    }
}

/* Deals the particles out to the colours. */
static fw_status deal_colours(fw_automaton *body, const fw_elastic_automaton_def *def,
                              fw_error *error)
{
    const size_t size = (size_t)body->head.count;
    for (int r = 0; r < body->run_count; ++r) {
        const int first = colour_of(body->run[r].site, def), count = body->run[r].count;
        body->colour[first].count += count - count / 2;
        body->colour[!first].count += count / 2;
    }
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        const size_t cells = (size_t)colour->count;
        FW_ARENA_ADD(&body->cells, colour->x, cells);
        FW_ARENA_ADD(&body->cells, colour->y, cells);
        FW_ARENA_ADD(&body->cells, colour->particle, cells);
        FW_ARENA_ADD(&body->cells, colour->place, cells);
        FW_ARENA_ADD(&body->cells, colour->held, cells);
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            colour->matrix[d] = &body->matrices.bond[c == FW_BLACK ? d : fw_opposite(d)];
    }
    FW_ARENA_ADD(&body->cells, body->cell, size);
    FW_ARENA_ADD(&body->cells, body->white, size);
    FW_ARENA_ADD(&body->cells, body->border, size);
    FW_ARENA_ADD(&body->cells, body->sums, 1);
    FW_TRY(fw_arena_allocate(&body->cells, "the cells of an automaton", error));
    int cell[FW_COLOURS] = {0};
    for (int r = 0; r < body->run_count; ++r)
        deal_run(body, &body->run[r], colour_of(body->run[r].site, def), cell);
    return FW_OK;
}

/* Does a cell go on a span? `before`: neighbours of the cell before it. */
static bool continues(const fw_automaton_span *span, const fw_automaton *body, const int *before,
                      const int *next, int cell, int particle)
{
    if (span->begin + span->count != cell || span->particle + 2 * span->count != particle)
        return false;
    /* Two particles further there is one more cell of that colour. */
    bool two_further = true;
    for (int d = 0; d < FW_DIRECTIONS; ++d) two_further &= next[d] == before[d] + 2;
    if (two_further) return true;
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (body->cell[next[d]] != cell + span->offset[d]) return false;
    return true;
}

/* How many cells of an inner one's colour, itself the first, surely go on its span: their particles
 * lie before `end`, and all their neighbours two further each time. */
static int alike(const fw_automaton_surroundings *around, int particle, int end)
{
    const int(*next)[FW_DIRECTIONS] = (const int(*)[FW_DIRECTIONS])around->next;
    int count = 1;
    for (int p = particle + 2; p < end; p += 2, ++count) {
        bool two_further = true;
        for (int d = 0; d < FW_DIRECTIONS; ++d) two_further &= next[p][d] == next[p - 2][d] + 2;
        if (!two_further) break;
    }
    return count;
}

/* Cuts the inside of a colour into spans, each in one row, and lists its rim, of which the cells
 * are all that is known yet; fills colour->place and the rows. False without memory. */
static bool cut_spans(fw_automaton *body, const fw_automaton_surroundings *around,
                      fw_automaton_colour *colour)
{
    const bool one_by_one = body->boundary == FW_BOUNDARY_TRAPEZOID; /* bonds may differ */
    fw_automaton_span *span = NULL;
    const int *before = NULL;
    int n = 0, row = 0, span_room = 0;
    for (int r = 0; r < body->run_count; ++r) {
        const fw_automaton_run *run = &body->run[r];
        const int end = run->particle + run->count;
        if (r == 0 || run->site.j != run[-1].site.j) {
            colour->row[row++] = (fw_automaton_row){n, colour->span_count, colour->rim_count};
            span = NULL;
        }
        while (n < colour->count && colour->particle[n] < end) {
            const int particle = colour->particle[n], *next = around->next[particle];
            if (!is_inside(body, around, particle)) {
                fw_automaton_rim *rim = fw_automaton_make_room(colour->rim, colour->rim_count,
                                                               &colour->rim_room, sizeof *rim);
                if (!rim) return false;
                colour->rim = rim;
                colour->rim[colour->rim_count] = (fw_automaton_rim){.cell = n, .span = -1};
                colour->place[n++] = colour->rim_count++;
                continue;
            }
            if (!span || !continues(span, body, before, next, n, particle)) {
                span = fw_automaton_make_room(colour->span, colour->span_count, &span_room,
                                              sizeof *span);
                if (!span) return false;
                colour->span = span;
                span += colour->span_count++;
                *span = (fw_automaton_span){.begin = n, .particle = particle};
                for (int d = 0; d < FW_DIRECTIONS; ++d) span->offset[d] = body->cell[next[d]] - n;
            }
            const int count = alike(around, particle, one_by_one ? particle : end);
            for (int k = 0; k < count; ++k) colour->place[n + k] = ~(colour->span_count - 1);
            before = around->next[particle + 2 * (count - 1)];
            span->count += count;
            n += count;
        }
    }
    colour->row[row] = (fw_automaton_row){n, colour->span_count, colour->rim_count};
    return true;
}

static fw_status fill_rim(fw_automaton *body, const fw_automaton_surroundings *around, int c,
                          const fw_sites *sites, fw_error *error)
{
    fw_automaton_colour *colour = &body->colour[c];
    for (int n = 0; n < colour->rim_count; ++n) {
        fw_automaton_rim *rim = &colour->rim[n];
        const int particle = colour->particle[rim->cell], *next = around->next[particle];
        const fw_site site = sites->site[particle];
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

static fw_status lay_out_colour(fw_automaton *body, const fw_automaton_surroundings *around, int c,
                                const fw_sites *sites, fw_error *error)
{
    fw_automaton_colour *colour = &body->colour[c];
    colour->row = fw_array_allocate((size_t)body->row_count + 1, sizeof *colour->row);
    if (!colour->row) return fw_fail_memory(error, "the rows of an automaton");
    if (!cut_spans(body, around, colour)) return fw_fail_memory(error, "the rims of an automaton");
    return fill_rim(body, around, c, sites, error);
}

/* Are there particles on all eight sites around? */
static bool is_surrounded(const fw_automaton_surroundings *around, int particle)
{
    const int *next = around->next[particle];
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (next[d] < 0 || around->next[next[d]][(d + 1) % FW_DIRECTIONS] < 0) return false;
    return true;
}

/* Remembers seams and edges of a run, where there are any. Within it, who has neighbours north and
 * south of himself and of those beside him has all eight. Returns the bonds east and north. */
static size_t border_of_run(fw_automaton *body, const fw_automaton_surroundings *around,
                            const fw_automaton_run *run)
{
    const int begin = run->particle, last = begin + run->count - 1;
    size_t links = 0;
    int full = 0; /* particles up to this one that have both, one after the other */
    for (int p = begin; p <= last; ++p) {
        const int *next = around->next[p];
        links += (size_t)(next[FW_EAST] >= 0) + (size_t)(next[FW_NORTH] >= 0);
        full = (next[FW_NORTH] | next[FW_SOUTH]) < 0 ? 0 : full + 1;
        if (full < 3 && p > begin && !is_surrounded(around, p - 1)) body->border[p - 1] |= EDGE;
    }
    if (!is_surrounded(around, last)) body->border[last] |= EDGE;
    for (int p = begin; around->seam && p <= last; ++p) body->border[p] |= around->seam[p];
    return links;
}

/* As list_run() does, of a body as it is made. */
static void list_first_run(fw_automaton *body, const fw_automaton_surroundings *around,
                           const fw_automaton_run *run)
{
    fw_solid *head = &body->head;
    int links = head->link_count, boundary = head->boundary_count;
    for (int p = run->particle; p < run->particle + run->count; ++p) {
        const int *next = around->next[p], seam = body->border[p];
        for (int d = FW_EAST; d <= FW_NORTH; ++d) {
            /* Behind the last bond there is room for one more. */
            head->links[links][0] = p;
            head->links[links][1] = next[d];
            links += next[d] >= 0 && !(seam >> d & 1);
        }
        head->boundary[boundary] = p;
        boundary += (seam & EDGE) || (next[0] | next[1] | next[2] | next[3]) < 0;
    }
    head->link_count = links;
    head->boundary_count = boundary;
}

/* Makes room for the list of bonds and fills it. */
static fw_status find_borders(fw_automaton *body, const fw_automaton_surroundings *around,
                              fw_error *error)
{
    size_t links = 0;
    for (int r = 0; r < body->run_count; ++r) links += border_of_run(body, around, &body->run[r]);
    body->head.links = fw_array_zeroed(links + 1, sizeof *body->head.links);
    if (!body->head.links) return fw_fail_memory(error, "the bonds of an automaton");
    for (int r = 0; r < body->run_count; ++r) list_first_run(body, around, &body->run[r]);
    body->head.boundary_revision += 1;
    return FW_OK;
}

/* The bonds of a run's particles east and north, unless across a seam; and who lacks a neighbour.
 */
static void list_run(fw_automaton *body, const fw_automaton_run *run)
{
    fw_solid *head = &body->head;
    for (int k = 0; k < run->count; ++k) {
        const int p = run->particle + k, n = run->cell[k & 1] + k / 2, colour = body->white[p];
        const int place = body->colour[colour].place[n];
        const int *particle = body->colour[!colour].particle;
        bool exposed = body->border[p] & EDGE;
        int(*link)[2] = &head->links[head->link_count];
        if (place < 0 && (body->border[p] & ~EDGE) == 0) {
            const int north = n + body->colour[colour].span[~place].offset[FW_NORTH];
            link[0][0] = link[1][0] = p;
            link[0][1] = p + 1;
            link[1][1] = particle[north];
            head->link_count += 2;
        }
        for (int d = 0; d < FW_DIRECTIONS && (place >= 0 || (body->border[p] & ~EDGE)); ++d) {
            double weight;
            const int partner = fw_automaton_cell_neighbour(body, colour, n, d, &weight);
            exposed |= partner < 0;
            if (d > FW_NORTH || partner < 0 || body->border[p] >> d & 1) continue;
            head->links[head->link_count][0] = p;
            head->links[head->link_count++][1] = particle[partner];
        }
        if (exposed) head->boundary[head->boundary_count++] = p;
    }
}

void fw_automaton_list_bonds(fw_automaton *body)
{
    fw_solid *head = &body->head;
    head->link_count = head->boundary_count = 0;
    for (int r = 0; r < body->run_count; ++r) list_run(body, &body->run[r]);
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
    fw_automaton_surroundings around = {0};
    body->ring_of_rows = def->period_rows > 0;
    fw_status status = fw_automaton_list_runs(body, def->sites, error);
    if (status == FW_OK) status = fw_automaton_surround(&around, body, def, error);
    if (status == FW_OK) status = deal_colours(body, def, error);
    for (int c = 0; c < FW_COLOURS && status == FW_OK; ++c)
        status = lay_out_colour(body, &around, c, def->sites, error);
    if (status == FW_OK) status = find_borders(body, &around, error);
    if (status == FW_OK && body->breaks) status = lay_out_breakable(body, error);
    fw_automaton_surroundings_release(&around);
    return status;
}
