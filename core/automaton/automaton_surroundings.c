/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_surroundings.c - from a set of sites to runs, and from runs to neighbours: what lies in
 * a run is written without a look at its sites. Keeps no state. Start reading at
 * fw_automaton_surround(). */
#include "automaton_surroundings.h"

#include "automaton_sweep.h"

#include <stdlib.h>

/* --- runs --- */

/* Numbers rows and lists runs, where there is room for them already. */
static void cut_runs(fw_automaton *body, const fw_sites *sites)
{
    body->run_count = body->row_count = 0;
    for (int begin = 0, end; begin < sites->count; begin = end) {
        end = fw_sites_run_end(sites, begin);
        body->row_count += begin == 0 || sites->site[begin].j != sites->site[begin - 1].j;
        if (body->run)
            body->run[body->run_count] = (fw_automaton_run){
                .site = sites->site[begin], .particle = begin, .count = end - begin};
        body->run_count += 1;
    }
}

fw_status fw_automaton_list_runs(fw_automaton *body, const fw_sites *sites, fw_error *error)
{
    cut_runs(body, sites);
    body->run = fw_array_allocate((size_t)body->run_count, sizeof *body->run);
    body->share = fw_array_zeroed(FW_SHARED_TICKS * (size_t)body->row_count, sizeof *body->share);
    if (!body->run || !body->share) return fw_fail_memory(error, "the rows of an automaton");
    cut_runs(body, sites);
    return FW_OK;
}

/* --- neighbours --- */

/* Who lies beside whom in a run; of north and south nobody yet. */
static void join_run(int (*next)[FW_DIRECTIONS], const fw_automaton_run *run)
{
    const int begin = run->particle, end = begin + run->count;
    for (int p = begin; p < end; ++p) {
        next[p][FW_EAST] = p + 1;
        next[p][FW_NORTH] = -1;
        next[p][FW_WEST] = p - 1;
        next[p][FW_SOUTH] = -1;
    }
    next[begin][FW_WEST] = next[end - 1][FW_EAST] = -1;
}

/* Two runs, one in the row above the other's. */
static void join_rows(int (*next)[FW_DIRECTIONS], const fw_automaton_run *lower,
                      const fw_automaton_run *upper)
{
    const int shift = upper->site.i - lower->site.i;
    const int begin = shift > 0 ? shift : 0,
              end = lower->count < shift + upper->count ? lower->count : shift + upper->count;
    const int above = upper->particle - shift - lower->particle;
    for (int p = lower->particle + begin; p < lower->particle + end; ++p) {
        next[p][FW_NORTH] = p + above;
        next[p + above][FW_SOUTH] = p;
    }
}

/* Does a run end before another one in the row above begins, or lie in a lower row? */
static bool is_before(const fw_automaton_run *upper, const fw_automaton_run *run)
{
    if (upper->site.j != run->site.j + 1) return upper->site.j < run->site.j + 1;
    return upper->site.i + upper->count <= run->site.i;
}

/* Runs ascend row by row, and so do those above them: one pointer finds them all. */
static void find_neighbours(fw_automaton_surroundings *around, const fw_automaton *body)
{
    const fw_automaton_run *run = body->run, *end = run + body->run_count, *upper = run;
    for (int r = 0; r < body->run_count; ++r) join_run(around->next, &run[r]);
    for (; run < end; ++run) {
        while (upper < end && is_before(upper, run)) ++upper;
        for (const fw_automaton_run *u = upper;
             u < end && u->site.j == run->site.j + 1 && u->site.i < run->site.i + run->count; ++u)
            join_rows(around->next, run, u);
    }
}

/* --- seams --- */

static void close_seam(fw_automaton_surroundings *around, const fw_sites *sites, int direction,
                       fw_site back)
{
    for (int p = 0; p < sites->count; ++p) {
        if (around->next[p][direction] >= 0) continue;
        const fw_site beyond = fw_site_neighbour(sites->site[p], direction);
        const int partner = fw_sites_find(sites, (fw_site){beyond.i - back.i, beyond.j - back.j});
        if (partner < 0) continue;
        around->next[p][direction] = partner;
        around->next[partner][fw_opposite(direction)] = p;
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

static fw_status check_periods(const fw_automaton *body, const fw_elastic_automaton_def *def,
                               fw_error *error)
{
    const fw_automaton_run *run = body->run;
    int low = run->site.i, high = low;
    for (int r = 0; r < body->run_count; ++r) {
        const int last = run[r].site.i + run[r].count - 1;
        if (run[r].site.i < low) low = run[r].site.i;
        if (last > high) high = last;
    }
    const int rows = run[body->run_count - 1].site.j - run->site.j + 1;
    FW_TRY(check_period(def->period_columns, high - low + 1, "columns", error));
    return check_period(def->period_rows, rows, "rows", error);
}

/* Only a site that is alone in its run can have none. */
static fw_status refuse_lone_sites(const fw_automaton_surroundings *around,
                                   const fw_automaton *body, fw_error *error)
{
    for (int r = 0; r < body->run_count; ++r) {
        const fw_automaton_run *run = &body->run[r];
        const int *next = around->next[run->particle];
        if (run->count == 1 && next[0] < 0 && next[1] < 0 && next[2] < 0 && next[3] < 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "site [%d, %d] has no neighbour, expected at least one: a cell of the "
                           "automaton without bonds has neither mass nor velocity",
                           run->site.i, run->site.j);
    }
    return FW_OK;
}

fw_status fw_automaton_surround(fw_automaton_surroundings *around, const fw_automaton *body,
                                const fw_elastic_automaton_def *def, fw_error *error)
{
    const size_t size = (size_t)body->head.count;
    const bool periodic = def->period_columns > 0 || def->period_rows > 0;
    FW_TRY(check_periods(body, def, error));
    around->next = fw_array_zeroed(size, sizeof *around->next);
    around->seam = periodic ? fw_array_zeroed(size, sizeof *around->seam) : NULL;
    if (!around->next || (periodic && !around->seam))
        return fw_fail_memory(error, "the neighbours of an automaton");
    find_neighbours(around, body);
    if (def->period_columns > 0)
        close_seam(around, def->sites, FW_EAST, (fw_site){def->period_columns, 0});
    if (def->period_rows > 0)
        close_seam(around, def->sites, FW_NORTH, (fw_site){0, def->period_rows});
    return refuse_lone_sites(around, body, error);
}

void fw_automaton_surroundings_release(fw_automaton_surroundings *around)
{
    free(around->next);
    free(around->seam);
}
