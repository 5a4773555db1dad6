/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lattice.c - shapes as sorted sets of sites, and where sites lie. Keeps no state.
 * Invariant of every set: rows ascend, columns ascend within a row, no site twice. */
#include "core/lattice.h"

#include "core/array.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* sqrt(3)/2, the height of a row of the hexagonal lattice. */
#define ROW_HEIGHT 0.86602540378443864676

static int compare_sites(const void *left, const void *right)
{
    const fw_site *a = left, *b = right;
    if (a->j != b->j) return a->j < b->j ? -1 : 1;
    return (a->i > b->i) - (a->i < b->i);
}

static fw_status allocate_sites(fw_sites *sites, long long count, fw_error *error)
{
    *sites = (fw_sites){0, NULL};
    if (count < 1)
        return fw_fail(error, FW_BAD_INPUT, "the shape has no sites, expected at least one");
    if (count > FW_SITES_MAX)
        return fw_fail(error, FW_BAD_INPUT, "the shape has %lld sites, expected at most %d", count,
                       FW_SITES_MAX);
    sites->site = fw_array_zeroed((size_t)count, sizeof *sites->site);
    if (!sites->site) return fw_fail_memory(error, "the sites of a shape");
    sites->count = (int)count;
    return FW_OK;
}

fw_status fw_sites_rectangle(fw_sites *sites, int columns, int rows, fw_error *error)
{
    *sites = (fw_sites){0, NULL};
    if (columns < 1 || rows < 1)
        return fw_fail(error, FW_BAD_INPUT, "a rectangle of %d x %d sites, expected at least 1 x 1",
                       columns, rows);
    FW_TRY(allocate_sites(sites, (long long)columns * rows, error));
    fw_site *site = sites->site;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) *site++ = (fw_site){i, j};
    return FW_OK;
}

static bool in_disc(const fw_lattice *lattice, fw_site site, double radius)
{
    fw_vec2 position = fw_lattice_vector(lattice, site);
    /* The margin keeps sites exactly on the rim in, whichever way their distance was rounded. */
    return fw_vec2_dot(position, position) <= radius * radius * (1 + 1e-12);
}

fw_status fw_sites_disc(fw_sites *sites, fw_lattice_kind kind, double radius, fw_error *error)
{
    *sites = (fw_sites){0, NULL};
    if (!(radius >= 0 && radius <= 16384))
        return fw_fail(error, FW_BAD_INPUT, "a disc of radius %g spacings, expected 0 to 16384",
                       radius);
    const fw_lattice lattice = {.kind = kind, .spacing = 1};
    const int reach = (int)ceil(radius / ROW_HEIGHT) + 1;
    long long count = 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) count += in_disc(&lattice, (fw_site){i, j}, radius);
    FW_TRY(allocate_sites(sites, count, error));
    fw_site *next = sites->site;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
            if (in_disc(&lattice, (fw_site){i, j}, radius)) *next++ = (fw_site){i, j};
    return FW_OK;
}

fw_status fw_sites_list(fw_sites *sites, const fw_site *list, int count, fw_error *error)
{
    FW_TRY(allocate_sites(sites, count, error));
    memcpy(sites->site, list, (size_t)count * sizeof *list);
    qsort(sites->site, (size_t)count, sizeof *sites->site, compare_sites);
    for (int n = 1; n < count; ++n)
        if (compare_sites(&sites->site[n - 1], &sites->site[n]) == 0) {
            fw_site twice = sites->site[n];
            fw_sites_clear(sites);
            return fw_fail(error, FW_BAD_INPUT, "site [%d, %d] is listed twice", twice.i, twice.j);
        }
    return FW_OK;
}

fw_status fw_sites_mask(fw_sites *sites, const char *text, fw_error *error)
{
    *sites = (fw_sites){0, NULL};
    long long count = 0;
    int rows = 0;
    for (const char *line = text; *line;) {
        size_t length = strcspn(line, "\n");
        rows += 1;
        for (size_t c = 0; c < length; ++c) {
            if (!strchr("#. ", line[c]))
                return fw_fail(error, FW_BAD_INPUT,
                               "character '%c' in row %d of a mask, expected '#' for a particle or "
                               "'.' for none",
                               line[c], rows);
            count += line[c] == '#';
        }
        line += length + (line[length] == '\n');
    }
    FW_TRY(allocate_sites(sites, count, error));
    fw_site *next = sites->site;
    int row = rows - 1;
    for (const char *line = text; *line; --row) {
        size_t length = strcspn(line, "\n");
        for (size_t c = 0; c < length; ++c)
            if (line[c] == '#') *next++ = (fw_site){(int)c, row};
        line += length + (line[length] == '\n');
    }
    qsort(sites->site, (size_t)sites->count, sizeof *sites->site, compare_sites);
    return FW_OK;
}

void fw_sites_clear(fw_sites *sites)
{
    free(sites->site);
    *sites = (fw_sites){0, NULL};
}

int fw_sites_find(const fw_sites *sites, fw_site site)
{
    const fw_site *found =
        bsearch(&site, sites->site, (size_t)sites->count, sizeof site, compare_sites);
    return found ? (int)(found - sites->site) : -1;
}

int fw_sites_walk(const fw_sites *sites, fw_site site, int *at)
{
    int n = *at;
    while (n < sites->count && compare_sites(&sites->site[n], &site) < 0) ++n;
    while (n > 0 && compare_sites(&sites->site[n - 1], &site) >= 0) --n;
    *at = n;
    return n < sites->count && compare_sites(&sites->site[n], &site) == 0 ? n : -1;
}

/* Sites ascend and none is there twice, so a run reaches to any site that is as many columns away
 * as it is numbers away. */
int fw_sites_run_end(const fw_sites *sites, int begin)
{
    const fw_site first = sites->site[begin];
    int last = begin;
    int64_t step = 1;
    for (bool grows = true; step > 0; step = grows ? 2 * step : step / 2) {
        const int64_t beyond = last + step;
        const bool joins = beyond < sites->count && sites->site[beyond].j == first.j &&
                           sites->site[beyond].i - (int64_t)first.i == beyond - begin;
        if (joins) last = (int)beyond;
        grows = grows && joins;
    }
    return last + 1;
}

fw_site fw_site_neighbour(fw_site site, int direction)
{
    static const fw_site step[FW_DIRECTIONS] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return (fw_site){site.i + step[direction].i, site.j + step[direction].j};
}

/* `turn`: cosine and sine. */
static fw_vec2 turned(fw_vec2 v, fw_vec2 turn)
{
    return (fw_vec2){turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y};
}

static fw_vec2 turn_by(fw_vec2 v, double angle)
{
    return angle == 0 ? v : turned(v, (fw_vec2){cos(angle), sin(angle)});
}

/* Before the lattice is turned. */
static fw_vec2 upright(const fw_lattice *lattice, fw_site site)
{
    fw_vec2 v = {site.i, site.j};
    if (lattice->kind == FW_HEXAGONAL)
        v = (fw_vec2){site.i + 0.5 * (site.j & 1), site.j * ROW_HEIGHT};
    return fw_vec2_scale(lattice->spacing, v);
}

fw_vec2 fw_lattice_vector(const fw_lattice *lattice, fw_site site)
{
    return turn_by(upright(lattice, site), lattice->angle);
}

void fw_lattice_place(const fw_lattice *lattice, const fw_site *sites, int count,
                      fw_vec2 *positions)
{
    const fw_vec2 turn = {cos(lattice->angle), sin(lattice->angle)};
    for (int n = 0; n < count; ++n) positions[n] = upright(lattice, sites[n]);
    for (int n = 0; n < count && lattice->angle != 0; ++n)
        positions[n] = turned(positions[n], turn);
    for (int n = 0; n < count; ++n) positions[n] = fw_vec2_add(lattice->origin, positions[n]);
}

fw_vec2 fw_lattice_position(const fw_lattice *lattice, fw_site site)
{
    return fw_vec2_add(lattice->origin, fw_lattice_vector(lattice, site));
}

fw_vec2 fw_lattice_step(const fw_lattice *lattice, int direction)
{
    fw_site step = fw_site_neighbour((fw_site){0, 0}, direction);
    return turn_by((fw_vec2){step.i * lattice->spacing, step.j * lattice->spacing}, lattice->angle);
}
