/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meeting.c - pairs of runs of contours that are near each other.
 * State: fat boxes, and pairs of runs whose fat boxes meet. Invariant after a refresh: the paths of
 * a run lie in its fat box, and `near` has every pair of runs of different bodies whose fat boxes
 * meet. Start reading at fw_meeting_refresh(). */
#include "contact/search/meeting.h"

#include "box_tree.h"

#include <math.h>
#include <stdlib.h>

enum { RUN = 16 };

/* A fat box has room for so many steps like the present one. */
static const double steps_ahead = 16;

struct fw_meeting {
    int run_count;
    fw_meeting_run *runs;
    fw_box *swept, *fat; /* per run: of this step, and for some to come */
    uint8_t *moved;      /* per run: its fat box is a new one in this refresh */
    int *found;          /* what the tree finds: room for all runs */
    fw_box_tree *tree;
    int near_count, near_capacity;
    fw_meeting_pair *near;
    int pair_count;
    fw_meeting_pair *pairs; /* of this step; room for all that are near */
    long queries;
};

static fw_box joined(fw_box box, fw_vec2 point)
{
    return (fw_box){{fmin(box.low.x, point.x), fmin(box.low.y, point.y)},
                    {fmax(box.high.x, point.x), fmax(box.high.y, point.y)}};
}

static fw_box grown(fw_box box, double margin)
{
    return (fw_box){{box.low.x - margin, box.low.y - margin},
                    {box.high.x + margin, box.high.y + margin}};
}

static bool lies_within(fw_box inner, fw_box outer)
{
    return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y &&
           inner.high.x <= outer.high.x && inner.high.y <= outer.high.y;
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
        for (int point = 0; point < bodies[b].contour->point_count; ++point)
            box = joined(box, place_of(&bodies[b], point));
    return box;
}

static void cut_into_runs(fw_meeting *meeting, const fw_meeting_body *bodies, int body_count)
{
    int count = 0;
    for (int b = 0; b < body_count; ++b)
        for (int first = 0; first < bodies[b].contour->segment_count; first += RUN) {
            const int left = bodies[b].contour->segment_count - first;
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
    for (int b = 0; b < body_count; ++b) runs += (size_t)bodies[b].contour->segment_count / RUN + 1;
    made->runs = calloc(runs, sizeof *made->runs);
    made->swept = calloc(runs, sizeof *made->swept);
    made->fat = calloc(runs, sizeof *made->fat);
    made->moved = calloc(runs, sizeof *made->moved);
    made->found = calloc(runs, sizeof *made->found);
    if (made->runs) cut_into_runs(made, bodies, body_count);
    made->tree = fw_box_tree_create(made->run_count, extent_of(bodies, body_count));
    if (made->runs && made->swept && made->fat && made->moved && made->found && made->tree) {
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
    free(meeting->swept);
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

/* Fat boxes for runs that have left theirs. Returns how many. */
static int move_boxes(fw_meeting *meeting, double reach)
{
    int count = 0;
    for (int run = 0; run < meeting->run_count; ++run) {
        const fw_box swept = meeting->swept[run];
        meeting->moved[run] = !lies_within(swept, meeting->fat[run]);
        if (!meeting->moved[run]) continue;
        /* A quarter of the spacing at least, so that trembling needs no search. */
        const double spacing = (swept.high.x - swept.low.x + swept.high.y - swept.low.y) / RUN;
        meeting->fat[run] = grown(swept, fmax(steps_ahead * reach, spacing / 4));
        count += 1;
    }
    return count;
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
        if (meeting->moved[run] && !fw_box_tree_put(meeting->tree, run, meeting->fat[run]))
            return fw_fail_memory(error, "the search between bodies");
    for (int run = 0; run < meeting->run_count; ++run)
        if (meeting->moved[run]) FW_TRY(search_around(meeting, run, error));
    return FW_OK;
}

fw_status fw_meeting_refresh(fw_meeting *meeting, const fw_meeting_body *bodies, double reach,
                             fw_error *error)
{
    for (int run = 0; run < meeting->run_count; ++run) {
        const fw_meeting_run *of = &meeting->runs[run];
        meeting->swept[run] = grown(box_of(&bodies[of->body], of), reach);
    }
    if (move_boxes(meeting, reach) > 0) FW_TRY(renew_pairs(meeting, error));
    meeting->pair_count = 0;
    for (int n = 0; n < meeting->near_count; ++n) {
        const fw_meeting_pair pair = meeting->near[n];
        if (meets(meeting->swept[pair.a], meeting->swept[pair.b]))
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
