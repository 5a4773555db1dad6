/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meeting.c - pairs of runs of contours that are near each other.
 * State: fat boxes, and pairs of runs whose fat boxes meet. Invariant after fw_meeting_find: the
 * paths of a busy run lie in its fat box, an idle one lies well within its own, and `near` has
 * every pair of runs of different bodies whose fat boxes meet. Start reading at fw_meeting_begin().
 */
#include "contact/search/meeting.h"

#include "box_tree.h"

#include <math.h>
#include <stdlib.h>

enum { RUN = 16, NAP = 3 };

/* A fat box has room for so many steps like the present one. */
static const double steps_ahead = 16;

struct fw_meeting {
    int run_count;
    fw_meeting_run *runs;
    fw_box *here, *fat; /* per run: where it is now, and where it may be for some steps */
    double *margin;     /* per run: by how much the fat box was larger when it was made */
    uint8_t *moved;     /* per run: its fat box has just been made */
    uint8_t *is_busy;   /* per run */
    int busy_count;
    int *busy;
    int *found; /* what the tree finds: room for all runs */
    fw_box_tree *tree;
    int nap;    /* steps in which nobody has to look */
    int napped; /* since the last look */
    int near_count, near_capacity;
    fw_meeting_pair *near;
    int pair_count;
    fw_meeting_pair *pairs; /* of this step; room for all that are near */
    long queries;
};

static fw_box joined(fw_box box, fw_vec2 point)
{
    return fw_box_joined(box, (fw_box){point, point});
}

static bool meets(fw_box a, fw_box b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

static fw_box nothing(void)
{
    return (fw_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

static fw_vec2 place_of(const fw_meeting_body *body, int point)
{
    return fw_solid_position(body->solid, body->contour->particles[point]);
}

static fw_box box_of(const fw_meeting_body *body, const fw_meeting_run *run)
{
    fw_box box = nothing();
    const fw_contour_segment *segments = body->contour->segments + run->first;
    for (int n = 0; n < run->count; ++n) box = joined(box, place_of(body, segments[n].from));
    /* Chains are closed, but a run of them is not. */
    for (int n = 0; n < run->count; ++n)
        if (n + 1 == run->count || segments[n].to != segments[n + 1].from)
            box = joined(box, place_of(body, segments[n].to));
    return box;
}

static fw_box extent_of(const fw_meeting_body *bodies, int body_count)
{
    fw_box box = nothing();
    for (int b = 0; b < body_count; ++b)
        for (int n = bodies[b].first; n < bodies[b].first + bodies[b].count; ++n)
            box = joined(box, place_of(&bodies[b], bodies[b].contour->segments[n].from));
    return box;
}

static void cut_into_runs(fw_meeting *meeting, const fw_meeting_body *bodies, int body_count)
{
    int count = 0;
    for (int b = 0; b < body_count; ++b)
        for (int done = 0; done < bodies[b].count; done += RUN) {
            const int left = bodies[b].count - done, first = bodies[b].first + done;
            meeting->runs[count++] =
                (fw_meeting_run){.body = b, .first = first, .count = left < RUN ? left : RUN};
        }
    meeting->run_count = count;
}

fw_status fw_meeting_create(fw_meeting **meeting, const fw_meeting_body *bodies, int body_count,
                            fw_error *error)
{
    fw_meeting *made = calloc(1, sizeof *made);
    *meeting = made;
    if (!made) return fw_fail_memory(error, "the search between bodies");
    size_t runs = 1;
    for (int b = 0; b < body_count; ++b) runs += (size_t)bodies[b].count / RUN + 1;
    made->runs = calloc(runs, sizeof *made->runs);
    made->here = calloc(runs, sizeof *made->here);
    made->margin = calloc(runs, sizeof *made->margin);
    made->is_busy = calloc(runs, sizeof *made->is_busy);
    made->busy = calloc(runs, sizeof *made->busy);
    made->fat = calloc(runs, sizeof *made->fat);
    made->moved = calloc(runs, sizeof *made->moved);
    made->found = calloc(runs, sizeof *made->found);
    if (made->runs) cut_into_runs(made, bodies, body_count);
    made->tree = fw_box_tree_create(made->run_count, extent_of(bodies, body_count));
    if (made->runs && made->here && made->margin && made->is_busy && made->busy && made->fat &&
        made->moved && made->found && made->tree) {
        for (int run = 0; run < made->run_count; ++run) made->fat[run] = nothing();
        return FW_OK;
    }
    fw_meeting_destroy(made);
    *meeting = NULL;
    return fw_fail_memory(error, "the search between bodies");
}

void fw_meeting_destroy(fw_meeting *meeting)
{
    if (!meeting) return;
    free(meeting->runs);
    free(meeting->here);
    free(meeting->margin);
    free(meeting->is_busy);
    free(meeting->busy);
    free(meeting->fat);
    free(meeting->moved);
    free(meeting->found);
    fw_box_tree_destroy(meeting->tree);
    free(meeting->near);
    free(meeting->pairs);
    free(meeting);
}

static fw_status add_near(fw_meeting *meeting, int a, int b, fw_error *error)
{
    if (meeting->near_count == meeting->near_capacity) {
        const size_t capacity = 2 * (size_t)meeting->near_capacity + 64;
        fw_meeting_pair *near = realloc(meeting->near, capacity * sizeof *near);
        if (near) meeting->near = near;
        fw_meeting_pair *pairs = realloc(meeting->pairs, capacity * sizeof *pairs);
        if (pairs) meeting->pairs = pairs;
        if (!near || !pairs) return fw_fail_memory(error, "the search between bodies");
        meeting->near_capacity = (int)capacity;
    }
    meeting->near[meeting->near_count++] = (fw_meeting_pair){a < b ? a : b, a < b ? b : a};
    return FW_OK;
}

/* A new fat box, which has to be put into the tree. */
static void fatten(fw_meeting *meeting, int run, double margin)
{
    meeting->margin[run] = margin;
    meeting->fat[run] = fw_box_grown(meeting->here[run], margin);
    meeting->moved[run] = 1;
}

static fw_status search_around(fw_meeting *meeting, int run, fw_error *error)
{
    const int count =
        fw_box_tree_query(meeting->tree, meeting->fat[run], meeting->found, meeting->run_count);
    meeting->queries += 1;
    for (int n = 0; n < count; ++n) {
        const int other = meeting->found[n];
        if (meeting->runs[other].body == meeting->runs[run].body) continue;
        if (meeting->moved[other] && other < run) continue; /* found from there */
        if (meets(meeting->fat[other], meeting->fat[run]))
            FW_TRY(add_near(meeting, run, other, error));
    }
    return FW_OK;
}

static fw_status renew_pairs(fw_meeting *meeting, fw_error *error)
{
    int kept = 0;
    for (int n = 0; n < meeting->near_count; ++n) {
        const fw_meeting_pair pair = meeting->near[n];
        if (!meeting->moved[pair.a] && !meeting->moved[pair.b]) meeting->near[kept++] = pair;
    }
    meeting->near_count = kept;
    for (int run = 0; run < meeting->run_count; ++run)
        if (meeting->moved[run]) fw_box_tree_put(meeting->tree, run, meeting->fat[run]);
    for (int run = 0; run < meeting->run_count; ++run)
        if (meeting->moved[run]) FW_TRY(search_around(meeting, run, error));
    return FW_OK;
}

static void list_busy(fw_meeting *meeting)
{
    for (int n = 0; n < meeting->near_count; ++n)
        for (int k = 0; k < 2; ++k) {
            const int run = k == 0 ? meeting->near[n].a : meeting->near[n].b;
            if (!meeting->is_busy[run]) meeting->busy[meeting->busy_count++] = run;
            meeting->is_busy[run] = 1;
        }
}

/* Did a run that has left its fat box within one step come near another one on its way? */
static bool may_have_passed(fw_meeting *meeting, int run, fw_box before)
{
    const fw_box here = meeting->here[run];
    const fw_box swept = joined(joined(before, here.low), here.high);
    const int count = fw_box_tree_query(meeting->tree, swept, meeting->found, meeting->run_count);
    for (int n = 0; n < count; ++n) {
        const int other = meeting->found[n];
        if (meeting->runs[other].body != meeting->runs[run].body &&
            meets(swept, meeting->fat[other]))
            return true;
    }
    return false;
}

static double farthest_corner(fw_box a, fw_box b)
{
    return fmax(fmax(fabs(a.low.x - b.low.x), fabs(a.low.y - b.low.y)),
                fmax(fabs(a.high.x - b.high.x), fabs(a.high.y - b.high.y)));
}

/* Its longest segment: a spacing, of a body that is not much strained. */
static double spacing_of(const fw_meeting_body *body, const fw_meeting_run *run)
{
    double longest = 0;
    const fw_contour_segment *segments = body->contour->segments + run->first;
    for (int n = 0; n < run->count; ++n) {
        const fw_vec2 along =
            fw_vec2_subtract(place_of(body, segments[n].to), place_of(body, segments[n].from));
        longest = fmax(longest, fw_vec2_dot(along, along));
    }
    return longest > 0 ? sqrt(longest) : 1;
}

fw_status fw_meeting_begin(fw_meeting *meeting, const fw_meeting_body *bodies, double expected,
                           int *jumped, fw_error *error)
{
    int moved = 0;
    *jumped = -1;
    meeting->pair_count = 0;
    if (meeting->nap > 0) {
        meeting->nap -= 1;
        return FW_OK;
    }
    const int steps = meeting->napped + 1;
    bool calm = true;
    for (int run = 0; run < meeting->run_count; ++run) {
        const fw_meeting_run *of = &meeting->runs[run];
        const fw_box before = meeting->here[run];
        const bool known = meeting->margin[run] > 0;
        meeting->here[run] = box_of(&bodies[of->body], of);
        const double pace = known ? farthest_corner(before, meeting->here[run]) / steps : expected;
        calm &= known && 2 * (NAP + 1) * pace <= 0.5 * meeting->margin[run];
        meeting->moved[run] = 0;
        if (known &&
            fw_box_lies_within(fw_box_grown(meeting->here[run], 0.5 * meeting->margin[run]),
                               meeting->fat[run]))
            continue;
        if (known && !meeting->is_busy[run] &&
            !fw_box_lies_within(meeting->here[run], meeting->fat[run]) &&
            may_have_passed(meeting, run, before)) {
            *jumped = run;
            return fw_fail(error, FW_DIVERGED, "points jump");
        }
        fatten(meeting, run, fmax(2 * steps_ahead * pace, 2 * spacing_of(&bodies[of->body], of)));
        moved += 1;
    }
    for (int n = 0; n < meeting->busy_count; ++n) meeting->is_busy[meeting->busy[n]] = 0;
    meeting->busy_count = 0;
    if (moved > 0) FW_TRY(renew_pairs(meeting, error));
    for (int run = 0; run < meeting->run_count; ++run) meeting->moved[run] = 0;
    list_busy(meeting);
    meeting->nap = meeting->napped = calm && meeting->busy_count == 0 ? NAP : 0;
    return FW_OK;
}

const int *fw_meeting_busy(const fw_meeting *meeting, int *count)
{
    *count = meeting->busy_count;
    return meeting->busy;
}

fw_status fw_meeting_find(fw_meeting *meeting, double reach, fw_error *error)
{
    int moved = 0;
    for (int n = 0; n < meeting->busy_count; ++n) {
        const int run = meeting->busy[n];
        meeting->moved[run] = 0;
        if (fw_box_lies_within(fw_box_grown(meeting->here[run], reach), meeting->fat[run]))
            continue;
        fatten(meeting, run, steps_ahead * reach);
        moved += 1;
    }
    if (moved > 0) {
        FW_TRY(renew_pairs(meeting, error));
        list_busy(meeting);
    }
    meeting->pair_count = 0;
    for (int n = 0; n < meeting->near_count; ++n) {
        const fw_meeting_pair pair = meeting->near[n];
        if (meets(fw_box_grown(meeting->here[pair.a], reach),
                  fw_box_grown(meeting->here[pair.b], reach)))
            meeting->pairs[meeting->pair_count++] = pair;
    }
    return FW_OK;
}

fw_meeting_run fw_meeting_observe_run(const fw_meeting *meeting, int run)
{
    return meeting->runs[run];
}

const fw_meeting_pair *fw_meeting_pairs(const fw_meeting *meeting, int *count)
{
    *count = meeting->pair_count;
    return meeting->pairs;
}

long fw_meeting_query_count(const fw_meeting *meeting)
{
    return meeting->queries;
}
