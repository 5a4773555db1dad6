/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_contour.c - edges of bodies as chains, and which stretches of them are near each other. */
#include "tests/support/scenes.h"

#include "contact/search/meeting.h"
#include "core/noise.h"
#include "core/particles/linear_lattice.h"

static fw_solid *masked(const char *text)
{
    fw_sites sites;
    fw_solid *solid;
    must(fw_sites_mask(&sites, text, &error));
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &sites;
    def.rest_mass = fw_sym2_scalar(1);
    must(fw_lb_solid_create(&solid, &def, &error));
    fw_sites_clear(&sites);
    return solid;
}

static fw_contour contour_of(const fw_solid *solid)
{
    fw_contour contour;
    fw_vec2 *home = malloc((size_t)solid->count * sizeof *home);
    for (int i = 0; i < solid->count; ++i) home[i] = fw_solid_position(solid, i);
    must(fw_contour_create(&contour, solid, home, &error));
    free(home);
    return contour;
}

/* Matter lies to the right of the segments: around, their areas add up to minus it. */
static double area_of(const fw_solid *solid, const fw_contour *contour)
{
    double area = 0;
    for (int n = 0; n < contour->segment_count; ++n) {
        const fw_contour_segment *s = &contour->segments[n];
        area += fw_vec2_cross(fw_solid_position(solid, contour->particles[s->from]),
                              fw_solid_position(solid, contour->particles[s->to]));
    }
    return area / 2;
}

typedef struct expected {
    const char *mask;
    int points, segments, two_sided, tips;
    double cells;
} expected;

static void contours_go_around_matter(void **state)
{
    (void)state;
    static const expected cases[] = {
        {"#", 1, 1, 1, 1, 0},
        {"####", 4, 6, 6, 2, 0},
        {"##\n##", 4, 4, 0, 0, 1},
        {"####\n####\n####", 10, 10, 0, 0, 6},
        {"#####\n#####\n##.##\n#####\n#####", 24, 24, 0, 0, 12},
        {"##..\n####\n##..", 8, 10, 4, 1, 2},       /* with a tip */
        {"##...\n##...\n..#..", 5, 5, 1, 1, 1},     /* and a particle by itself */
        {"###.\n###.\n####\n..##", 11, 12, 0, 0, 5} /* that touch in a corner */
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_solid *solid = masked(cases[n].mask);
        fw_contour contour = contour_of(solid);
        int two_sided = 0, tips = 0;
        for (int k = 0; k < contour.segment_count; ++k) two_sided += contour.segments[k].two_sided;
        for (int k = 0; k < contour.point_count; ++k) {
            tips += contour.tips[k];
            assert_int_equal(contour.points[contour.particles[k]], k);
        }
        assert_int_equal(contour.point_count, cases[n].points);
        assert_int_equal(contour.segment_count, cases[n].segments);
        assert_int_equal(two_sided, cases[n].two_sided);
        assert_int_equal(tips, cases[n].tips);
        assert_close(area_of(solid, &contour), -cases[n].cells, 1e-12);
        fw_contour_clear(&contour);
        fw_solid_destroy(solid);
    }
}

static void triangles_are_cells_too(void **state)
{
    (void)state;
    fw_sites sites;
    fw_solid *solid;
    must(fw_sites_disc(&sites, FW_HEXAGONAL, 2.01, &error));
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.lattice = (fw_lattice){.kind = FW_HEXAGONAL, .spacing = 1, .angle = 0.7};
    must(fw_linear_lattice_create(&solid, &def, &error));
    fw_contour contour = contour_of(solid);
    assert_int_equal(contour.segment_count, 12);
    assert_close(area_of(solid, &contour), -24 * sqrt(3) / 4, 1e-12);
    fw_contour_clear(&contour);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* The same numbers as one made anew, whatever has broken: links, until particles are by themselves.
 */
static void renewed_contour_is_one_made_anew(void **state)
{
    (void)state;
    fw_solid *solid = masked("#########\n#########\n###..####\n###..####\n#########\n####.....\n"
                             "####.###.\n#########");
    fw_vec2 *home = calloc((size_t)solid->count, sizeof *home);
    for (int i = 0; i < solid->count; ++i) home[i] = fw_solid_position(solid, i);
    fw_contour renewed = {0};
    must(fw_contour_renew(&renewed, solid, home, &error));
    uint64_t seed = 3;
    while (solid->link_count > 0) {
        const int gone = 1 + (int)(seed >> 62);
        for (int n = 0; n < gone && solid->link_count > 0; ++n) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const int at = (int)((seed >> 33) % (uint64_t)solid->link_count);
            solid->link_count -= 1;
            memmove(solid->links + at, solid->links + at + 1,
                    (size_t)(solid->link_count - at) * sizeof *solid->links);
        }
        fw_contour anew;
        must(fw_contour_renew(&renewed, solid, home, &error));
        must(fw_contour_create(&anew, solid, home, &error));
        assert_int_equal(renewed.point_count, anew.point_count);
        assert_int_equal(renewed.segment_count, anew.segment_count);
        assert_memory_equal(renewed.particles, anew.particles,
                            (size_t)anew.point_count * sizeof *anew.particles);
        assert_memory_equal(renewed.tips, anew.tips, (size_t)anew.point_count);
        assert_memory_equal(renewed.points, anew.points,
                            (size_t)solid->count * sizeof *anew.points);
        for (int n = 0; n < anew.segment_count; ++n) {
            assert_int_equal(renewed.segments[n].from, anew.segments[n].from);
            assert_int_equal(renewed.segments[n].to, anew.segments[n].to);
            assert_int_equal(renewed.segments[n].two_sided, anew.segments[n].two_sided);
        }
        fw_contour_clear(&anew);
    }
    assert_int_equal(renewed.point_count, solid->count);
    fw_contour_clear(&renewed);
    fw_solid_destroy(solid);
    free(home);
}

/* One corner is carried over the opposite edge; and back. */
static void folds_are_found(void **state)
{
    (void)state;
    fw_solid *solid = masked("####\n####\n####\n####");
    fw_contour contour = contour_of(solid);
    int segment;
    must(fw_contour_find_fold(&contour, solid, &segment, &error));
    assert_int_equal(segment, -1);
    const double home = solid->x[0];
    solid->x[0] += 4.5;
    solid->y[0] += 1.5;
    must(fw_contour_find_fold(&contour, solid, &segment, &error));
    assert_true(segment >= 0);
    solid->x[0] = home + 0.5;
    solid->y[0] -= 1.5;
    must(fw_contour_find_fold(&contour, solid, &segment, &error));
    assert_int_equal(segment, -1);
    fw_contour_clear(&contour);
    fw_solid_destroy(solid);
}

/* --- pairs of runs --- */

enum { BODIES = 12 };

static bool near(const fw_meeting_body *a, int i, const fw_meeting_body *b, int k, double reach)
{
    const fw_vec2 p = fw_solid_position(a->solid, a->contour->particles[i]);
    const fw_vec2 q = fw_solid_position(b->solid, b->contour->particles[k]);
    return fabs(p.x - q.x) <= 2 * reach && fabs(p.y - q.y) <= 2 * reach;
}

/* All points that may touch, against the pairs. */
static int assert_none_missed(const fw_meeting *meeting, const fw_meeting_body *bodies,
                              double reach)
{
    int count, found = 0;
    const fw_meeting_pair *pairs = fw_meeting_pairs(meeting, &count);
    for (int a = 0; a < BODIES; ++a)
        for (int b = a + 1; b < BODIES; ++b)
            for (int i = 0; i < bodies[a].contour->segment_count; ++i)
                for (int k = 0; k < bodies[b].contour->segment_count; ++k) {
                    if (!near(&bodies[a], bodies[a].contour->segments[i].from, &bodies[b],
                              bodies[b].contour->segments[k].from, reach))
                        continue;
                    bool listed = false;
                    for (int n = 0; n < count && !listed; ++n) {
                        const fw_meeting_run first = fw_meeting_observe_run(meeting, pairs[n].a),
                                             second = fw_meeting_observe_run(meeting, pairs[n].b);
                        listed = first.body == a && second.body == b && i >= first.first &&
                                 i < first.first + first.count && k >= second.first &&
                                 k < second.first + second.count;
                    }
                    assert_true(listed);
                    found += 1;
                }
    return found;
}

static void no_pair_is_missed_wherever_bodies_are(void **state)
{
    (void)state;
    const double offsets[] = {0, 123.456, 1e4};
    for (size_t o = 0; o < sizeof offsets / sizeof *offsets; ++o) {
        fw_meeting_body bodies[BODIES];
        fw_contour contours[BODIES];
        fw_vec2 drift[BODIES];
        fw_solid *solids[BODIES];
        int found = 0, jumped;
        for (int b = 0; b < BODIES; ++b) {
            solids[b] = masked("#######\n#######\n#######\n#######\n###....\n###....\n");
            const fw_vec2 shift = fw_noise_uniform(5, (uint32_t)b, 0, 0);
            drift[b] = fw_vec2_scale(0.2, fw_noise_uniform(5, (uint32_t)b, 1, 0));
            contours[b] = contour_of(solids[b]);
            for (int i = 0; i < solids[b]->count; ++i) {
                solids[b]->x[i] += offsets[o] + 12 * shift.x;
                solids[b]->y[i] -= offsets[o] + 12 * shift.y;
            }
            bodies[b] = (fw_meeting_body){
                .solid = solids[b], .contour = &contours[b], .count = contours[b].segment_count};
        }
        fw_meeting *meeting;
        must(fw_meeting_create(&meeting, bodies, BODIES, &error));
        for (int step = 0; step < 100; ++step) {
            const double reach = step % 7 == 0 ? 0.5 : 0.3;
            must(fw_meeting_begin(meeting, bodies, 0, &jumped, &error));
            must(fw_meeting_find(meeting, reach, &error));
            assert_int_equal(jumped, -1);
            if (step % 5 == 0) found += assert_none_missed(meeting, bodies, reach);
            for (int b = 0; b < BODIES; ++b)
                for (int i = 0; i < solids[b]->count; ++i) {
                    solids[b]->x[i] += drift[b].x;
                    solids[b]->y[i] += drift[b].y;
                }
        }
        assert_true(found > 100);
        assert_true(fw_meeting_query_count(meeting) < 100 * BODIES); /* fat boxes last */
        fw_meeting_destroy(meeting);
        for (int b = 0; b < BODIES; ++b) {
            fw_contour_clear(&contours[b]);
            fw_solid_destroy(solids[b]);
        }
    }
}

/* Two bodies far from each other, one of which is thrown through the other in one step. */
static void nobody_jumps_over_another_body_unseen(void **state)
{
    (void)state;
    fw_solid *solids[2];
    fw_contour contours[2];
    fw_meeting_body bodies[2];
    int jumped, busy;
    for (int b = 0; b < 2; ++b) {
        solids[b] = masked("####\n####\n####\n");
        contours[b] = contour_of(solids[b]);
        for (int i = 0; i < solids[b]->count; ++i) solids[b]->x[i] += 20 * b;
        bodies[b] = (fw_meeting_body){
            .solid = solids[b], .contour = &contours[b], .count = contours[b].segment_count};
    }
    fw_meeting *meeting;
    must(fw_meeting_create(&meeting, bodies, 2, &error));
    must(fw_meeting_begin(meeting, bodies, 0, &jumped, &error));
    fw_meeting_busy(meeting, &busy);
    assert_int_equal(busy, 0);
    for (int i = 0; i < solids[0]->count; ++i) solids[0]->x[i] += 40;
    fw_status status = FW_OK;
    for (int step = 0; step < 4 && status == FW_OK; ++step) /* it looks at every fourth at least */
        status = fw_meeting_begin(meeting, bodies, 0, &jumped, &error);
    assert_int_equal(status, FW_DIVERGED);
    assert_int_equal(jumped, 0);
    fw_meeting_destroy(meeting);
    for (int b = 0; b < 2; ++b) {
        fw_contour_clear(&contours[b]);
        fw_solid_destroy(solids[b]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contours_go_around_matter),
        cmocka_unit_test(triangles_are_cells_too),
        cmocka_unit_test(folds_are_found),
        cmocka_unit_test(renewed_contour_is_one_made_anew),
        cmocka_unit_test(no_pair_is_missed_wherever_bodies_are),
        cmocka_unit_test(nobody_jumps_over_another_body_unseen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
