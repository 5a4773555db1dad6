/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_meet.c - which points of bodies pass which edges of others in this tick, found again and
 * again until none does: rows are added and never removed, so that it ends.
 * State: none. Start reading at scene_meet_bodies(). */
#include "contact/geometry/crossing.h"
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

enum { ROUNDS = 60 };

/* How far behind a segment a point may be, in units of its length, and count as on it: an iterate
 * that did not converge leaves such gaps. Nothing of another body lies there by right. */
static const double BEHIND = 1e-6;
/* How near a point may come to a segment that bars the way from both sides, in the same unit:
 * rounding shall not put it on the other side. */
static const double BESIDE = 1e-9;
/* --- where all points would go --- */

/* What walls and grips have decided; of points that are no ends yet. */
static void follow_walls_and_grips(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        const scene_edge *edge = body->edge;
        for (int n = 0; edge && n < body->contact_count; ++n) {
            const int point = edge->contour.points[body->contacts[n].particle];
            if (point >= 0 && edge->end[point] < 0)
                edge->paths[point] = body->contacts[n].solution.displacement;
        }
    }
    scene_follow_grips(scene);
}

static double longest_path(const fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    double squared = 0;
    int count;
    const int *busy = fw_meeting_busy(joint->search, &count);
    for (int n = 0; n < count; ++n) {
        const fw_meeting_run run = fw_meeting_observe_run(joint->search, busy[n]);
        const scene_edge *edge = scene->bodies[joint->member_bodies[run.body]].edge;
        const fw_contour_segment *segments = edge->contour.segments + run.first;
        for (int k = 0; k < run.count; ++k) {
            const fw_vec2 from = edge->paths[segments[k].from], to = edge->paths[segments[k].to];
            squared = fmax(squared, fmax(fw_vec2_dot(from, from), fw_vec2_dot(to, to)));
        }
    }
    for (int e = 0; e < joint->end_count; ++e) { /* pistons push what is not busy, too */
        const fw_vec2 w = joint->joint_ends[e].displacement;
        if (joint->ends[e].point >= 0) squared = fmax(squared, fw_vec2_dot(w, w));
    }
    return sqrt(squared);
}

/* Paths of busy points begin as predicted. */
static void begin_paths(fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    int count;
    const int *busy = fw_meeting_busy(joint->search, &count);
    for (int n = 0; n < count; ++n) {
        const fw_meeting_run run = fw_meeting_observe_run(joint->search, busy[n]);
        scene_edge *edge = scene->bodies[joint->member_bodies[run.body]].edge;
        const fw_contour_segment *segments = edge->contour.segments + run.first;
        for (int k = 0; k < run.count; ++k) {
            edge->paths[segments[k].from] = edge->predictions[segments[k].from].displacement;
            edge->paths[segments[k].to] = edge->predictions[segments[k].to].displacement;
        }
    }
    scene_lead_points(scene, 0);
    follow_walls_and_grips(scene);
}

/* --- which of them pass --- */

static fw_moving_point moving(const scene_body *body, int point)
{
    return (fw_moving_point){fw_solid_position(body->solid, body->edge->contour.particles[point]),
                             body->edge->paths[point]};
}

static fw_status note(scene_joint *joint, const scene_row *row, fw_error *error)
{
    if (joint->found_count == joint->found_capacity) {
        const size_t capacity = 2 * (size_t)joint->found_capacity + 64;
        scene_row *found = realloc(joint->found, capacity * sizeof *found);
        if (!found) return fw_fail_memory(error, "the contact of bodies");
        joint->found = found;
        joint->found_capacity = (int)capacity;
    }
    joint->found[joint->found_count++] = *row;
    return FW_OK;
}

/* What a point sweeps in the step. */
static fw_box box_of(fw_moving_point p)
{
    return fw_box_around(p.at, fw_vec2_add(p.at, p.motion));
}

/* Only false where what is in the first keeps apart from what is in the second, with room for a
 * point that counts as on a segment. */
static bool come_near(fw_box a, fw_box b, double distance)
{
    const double room = distance + BEHIND * (1 + (b.high.x - b.low.x) + (b.high.y - b.low.y));
    return a.high.x >= b.low.x - room && a.low.x <= b.high.x + room && a.high.y >= b.low.y - room &&
           a.low.y <= b.high.y + room;
}

static fw_status note_unknown(fw_scene *scene, const scene_row *row, fw_error *error)
{
    const int end = scene->bodies[row->point_body].edge->end[row->point];
    const int known = end >= 0 ? scene_find_row(scene->joint, end, row) : -1;
    if (known >= 0 && !scene->joint->joint_rows[known].open) return FW_OK;
    return note(scene->joint, row, error);
}

/* Does the point come too near to the segment, or to where it begins? Links of single particles
 * keep it off on the side where it is. */
static fw_status look_from_afar(fw_scene *scene, scene_row *row, const fw_contour_segment *segment,
                                fw_moving_point a, fw_moving_point from, fw_moving_point to,
                                double distance, fw_error *error)
{
    row->from = row->to = segment->from;
    if (fw_crossing_of_circle(a, from, distance, &row->when))
        FW_TRY(note_unknown(scene, row, error));
    if (segment->from == segment->to) return FW_OK;
    const fw_vec2 edge = fw_vec2_subtract(to.at, from.at);
    const bool turned =
        segment->two_sided && fw_vec2_cross(edge, fw_vec2_subtract(a.at, from.at)) < 0;
    row->from = turned ? segment->to : segment->from;
    row->to = turned ? segment->from : segment->to;
    /* A point that came round a corner is nearer by the square of its way: it goes no deeper. */
    const double behind = distance / sqrt(fw_vec2_dot(edge, edge));
    if (!fw_crossing_of_distance(a, turned ? to : from, turned ? from : to, distance, behind,
                                 &row->when))
        return FW_OK;
    return note_unknown(scene, row, error);
}

/* Does that point pass that segment, or the tip at which it begins? */
static fw_status look_at(fw_scene *scene, int body, int point, int other,
                         const fw_contour_segment *segment, double distance, fw_error *error)
{
    const int number = (int)(segment - scene->bodies[other].edge->contour.segments);
    const scene_body *of = &scene->bodies[other];
    const fw_moving_point a = moving(&scene->bodies[body], point), from = moving(of, segment->from),
                          to = moving(of, segment->to);
    scene_row row = {.facet = -1,
                     .body = other,
                     .segment = number,
                     .point_body = body,
                     .point = point,
                     .next = -1};
    if (!come_near(box_of(a), fw_box_joined(box_of(from), box_of(to)), distance)) return FW_OK;
    if (distance > 0) return look_from_afar(scene, &row, segment, a, from, to, distance, error);
    row.from = row.to = segment->from;
    if (scene->bodies[body].edge->contour.tips[point] && of->edge->contour.tips[segment->from] &&
        fw_crossing_of_points(a, from, &row.when))
        FW_TRY(note_unknown(scene, &row, error));
    row.to = segment->to;
    if (row.from == row.to) return FW_OK;
    if (fw_crossing_of_segment(a, from, to, segment->two_sided ? -BESIDE : BEHIND, &row.when))
        return note_unknown(scene, &row, error);
    /* No row with the segment would keep it out: it is behind its extension already. The corner
     * does, which it may not come nearer to. */
    bool at_from;
    if (segment->two_sided || !fw_crossing_round_end(a, from, to, BEHIND, &at_from)) return FW_OK;
    row.from = row.to = at_from ? segment->from : segment->to;
    row.when = 1;
    return note_unknown(scene, &row, error);
}

/* Points of one run against segments of another one. */
static fw_status look_at_runs(fw_scene *scene, const fw_meeting_run *points,
                              const fw_meeting_run *segments, fw_error *error)
{
    const int body = scene->joint->member_bodies[points->body];
    const int other = scene->joint->member_bodies[segments->body];
    const double distance = scene_distance_between(scene, body, other);
    const fw_contour *own = &scene->bodies[body].edge->contour;
    const fw_contour_segment *theirs =
        scene->bodies[other].edge->contour.segments + segments->first;
    fw_box swept = box_of(moving(&scene->bodies[other], theirs[0].from));
    for (int m = 0; m < segments->count; ++m)
        swept = fw_box_joined(swept,
                              fw_box_joined(box_of(moving(&scene->bodies[other], theirs[m].from)),
                                            box_of(moving(&scene->bodies[other], theirs[m].to))));
    for (int n = 0; n < points->count; ++n) {
        const int point = own->segments[points->first + n].from;
        if (!come_near(box_of(moving(&scene->bodies[body], point)), swept, distance)) continue;
        for (int m = 0; m < segments->count; ++m)
            FW_TRY(look_at(scene, body, point, other, &theirs[m], distance, error));
    }
    return FW_OK;
}

static int compare_ints(int a, int b)
{
    return (a > b) - (a < b);
}

/* By point; of each point, what it passes first. */
static int compare_found(const void *left, const void *right)
{
    const scene_row *a = left, *b = right;
    int order = compare_ints(a->point_body, b->point_body);
    if (order == 0) order = compare_ints(a->point, b->point);
    if (order == 0) order = (a->when > b->when) - (a->when < b->when);
    if (order == 0) order = compare_ints(a->body, b->body);
    if (order == 0) order = compare_ints(a->from, b->from);
    return order != 0 ? order : compare_ints(a->to, b->to);
}

/* Of each point what it passes first, in a list that is sorted so. */
static int keep_first_of_points(scene_row *found, int count)
{
    int kept = 0;
    for (int n = 0; n < count; ++n)
        if (kept == 0 || found[kept - 1].point_body != found[n].point_body ||
            found[kept - 1].point != found[n].point)
            found[kept++] = found[n];
    return kept;
}

static const scene_row *row_of_point(const scene_joint *joint, int body, int point)
{
    int low = 0, high = joint->found_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const scene_row *row = &joint->found[middle];
        if (row->point_body < body || (row->point_body == body && row->point < point))
            low = middle + 1;
        else
            high = middle;
    }
    const scene_row *row = &joint->found[low];
    return low < joint->found_count && row->point_body == body && row->point == point ? row : NULL;
}

/* Across a segment of a row, out of its body, of the segment's length; zero for a single point. */
static fw_vec2 outward(const fw_scene *scene, const scene_row *row)
{
    const scene_body *body = &scene->bodies[row->body];
    const fw_vec2 from = moving(body, row->from).at, to = moving(body, row->to).at;
    return fw_vec2_turn(fw_vec2_subtract(to, from));
}

/* Do two segments look at each other, as those of two faces that meet? */
static bool are_opposite(fw_vec2 a, fw_vec2 b)
{
    return fw_vec2_dot(a, b) < -0.5 * sqrt(fw_vec2_dot(a, a) * fw_vec2_dot(b, b));
}

/* Where a corner slides towards a particle of the face below it, its path leads through the face,
 * and so that particle's path through the side above the corner. Once the corner is held on the
 * face, the particle passes below it, and a row with the side would stop it dead. So of two points
 * that each pass a segment of the other, the one that does first has its row now; if the other
 * still passes then, it is found again. (Of two faces both have theirs: they say much the same.) */
static bool corner_comes_first(const fw_scene *scene, const scene_row *row)
{
    const scene_joint *joint = scene->joint;
    for (int k = 0; k < 2; ++k) {
        const scene_row *other = row_of_point(joint, row->body, k == 0 ? row->from : row->to);
        if (!other || other->body != row->point_body) continue;
        if (other->from != row->point && other->to != row->point) continue;
        if (are_opposite(outward(scene, row), outward(scene, other))) continue;
        if (other->when < row->when || (other->when == row->when && other < row)) return true;
    }
    return false;
}

/* One row for each point that passes something: a corner between two segments belongs to either,
 * and rows that say the same twice make the problem singular. */
static fw_status add_passed_edges(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    int count;
    const fw_meeting_pair *pairs = fw_meeting_pairs(joint->search, &count);
    joint->found_count = 0;
    for (int n = 0; n < count; ++n) {
        const fw_meeting_run a = fw_meeting_observe_run(joint->search, pairs[n].a),
                             b = fw_meeting_observe_run(joint->search, pairs[n].b);
        FW_TRY(look_at_runs(scene, &a, &b, error));
        FW_TRY(look_at_runs(scene, &b, &a, error));
    }
    if (joint->found_count > 0)
        qsort(joint->found, (size_t)joint->found_count, sizeof *joint->found, compare_found);
    joint->found_count = keep_first_of_points(joint->found, joint->found_count);
    for (int n = 0; n < joint->found_count; ++n) {
        const scene_row *row = &joint->found[n];
        if (corner_comes_first(scene, row)) continue;
        FW_TRY(scene_refuse_gripped(scene, row, error));
        FW_TRY(scene_add_row(scene, row, error));
    }
    return FW_OK;
}

/* --- until none does --- */

/* Twice as far as any busy point would go: another one may push it. What comes near by that may go
 * further still. */
static fw_status search_within_reach(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    for (;;) {
        const double longest = longest_path(scene);
        if (longest <= joint->reach) return FW_OK;
        const int predicted = joint->predicted;
        joint->reach = 2 * longest;
        FW_TRY(fw_meeting_find(joint->search, joint->reach + scene->distance, error));
        scene_predict_busy(scene);
        scene_lead_points(scene, predicted);
        follow_walls_and_grips(scene);
    }
}

static fw_status begin_bodies(fw_scene *scene, fw_error *error)
{
    scene->joint->reach = 0;
    if (!scene->joint->search) return FW_OK;
    begin_paths(scene);
    FW_TRY(scene_add_rubbing(scene, error));
    return fw_meeting_find(scene->joint->search, scene->distance, error);
}

/* All that passes something on its present path gets its row. */
static fw_status add_passed(fw_scene *scene, fw_error *error)
{
    if (scene->joint->search) {
        FW_TRY(search_within_reach(scene, error));
        FW_TRY(add_passed_edges(scene, error));
    }
    FW_TRY(scene_add_gripped(scene, error));
    FW_TRY(scene_add_reached(scene, error));
    return scene_add_passed_walls(scene, error);
}

fw_status scene_meet_bodies(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    if (scene_is_second_tick(scene)) {
        scene_hand_over_second(scene);
        return FW_OK;
    }
    scene_begin_grips(scene);
    FW_TRY(scene_lead_entries(scene, error));
    FW_TRY(begin_bodies(scene, error));
    FW_TRY(scene_add_rubbed_by_pistons(scene, error));
    for (int round = 0;; ++round) {
        const int known = joint->changes;
        FW_TRY(add_passed(scene, error));
        if (joint->changes == known) FW_TRY(scene_add_met(scene, error));
        if (joint->changes == known && round > 0) break;
        if (joint->row_count == 0) break;
        if (round == ROUNDS) { /* what still passes is in a state that no row can mend */
            joint->outcome.unconverged += 1;
            break;
        }
        FW_TRY(scene_solve_joint(scene, error));
    }
    scene_hand_over_joint(scene);
    return FW_OK;
}
