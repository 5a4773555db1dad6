/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_curves.c - figures of curves, profiles and maps, drawn from small synthetic data in
 * all formats. */
#include "tests/support/drawn_figure.h"

static fw_status draw_stack(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_stack(page, data, error);
}

enum { SAMPLES = 400 };

static void observables_over_time_are_drawn(void **state)
{
    (void)state;
    double time[SAMPLES], energy[SAMPLES], kinetic[SAMPLES], elastic[SAMPLES], error[SAMPLES];
    double drift[SAMPLES];
    for (int k = 0; k < SAMPLES; ++k) {
        time[k] = 10 * k;
        kinetic[k] = .4 + .1 * cos(.05 * k) * exp(-.004 * k);
        elastic[k] = .5387123456 - kinetic[k];
        energy[k] = .5387123456 + 4e-15 * (scatter((unsigned)k) - .5) * sqrt(k);
        error[k] = .02 + .01 * scatter((unsigned)k / 20);
        drift[k] = k == 0 ? 0 : 1e-16 * pow(10, 4 * k / (double)SAMPLES);
    }
    kinetic[150] = kinetic[151] = NAN;
    const fw_curve parts[2] = {
        {"kinetic", SAMPLES, time, kinetic, error, NULL, FW_CURVE_LINE, 0, NULL},
        {"elastic", SAMPLES, time, elastic, NULL, NULL, FW_CURVE_LINE, 0, NULL}};
    const fw_curve total = {NULL, SAMPLES, time, energy, NULL, NULL, FW_CURVE_LINE, 0, NULL};
    const fw_curve change = {NULL, SAMPLES, time, drift, NULL, NULL, FW_CURVE_LINE, 0, NULL};
    const fw_chart charts[3] = {
        {.label = {"energy / m v^{2}", 0}, .curves = parts, .curve_count = 2},
        {.label = {"total energy", 0}, .curves = &total, .curve_count = 1},
        {.label = {"|ΔE| / E", 0}, .curves = &change, .curve_count = 1, .logarithmic = true}};
    const fw_figure_mark marks[3] = {{600, "settle"}, {1400, "drive"}, {1500, "sample"}};
    fw_figure_stack_plan plan = {.charts = charts,
                                 .chart_count = 3,
                                 .label = {"time / steps", 0},
                                 .marks = marks,
                                 .mark_count = 3};
    draw_everywhere(draw_stack, &plan, page_with("Energy of the sheet", NULL), "series");
}

static void a_dispersion_is_drawn(void **state)
{
    (void)state;
    enum { POINTS = 200, MEASURED = 24 };
    double k[POINTS], slow[POINTS], fast[POINTS], at[MEASURED], seen[MEASURED], error[MEASURED];
    for (int i = 0; i < POINTS; ++i) {
        k[i] = 3. * i / (POINTS - 1);
        fast[i] = 1.9 * fabs(sin(M_PI * k[i] / 3)) + .2 * fabs(sin(M_PI * k[i]));
        slow[i] = .6 * fast[i];
    }
    for (int i = 0; i < MEASURED; ++i) {
        at[i] = k[8 * i];
        seen[i] = fast[8 * i] + .02 * (scatter((unsigned)i) - .5);
        error[i] = .05;
    }
    const fw_curve curves[3] = {
        {"longitudinal, closed form", POINTS, k, fast, NULL, NULL, FW_CURVE_LINE, 0, NULL},
        {"transverse, closed form", POINTS, k, slow, NULL, NULL, FW_CURVE_DASHES, 0, NULL},
        {"simulated", MEASURED, at, seen, error, NULL, FW_CURVE_MARKERS, FW_PALETTE_KINDS - 1,
         NULL}};
    const fw_axis_name names[4] = {{0, "Γ"}, {1, "X"}, {2, "M"}, {3, "Γ"}};
    const fw_chart chart = {.label = {"frequency ω τ", 0}, .curves = curves, .curve_count = 3};
    fw_figure_stack_plan plan = {.charts = &chart,
                                 .chart_count = 1,
                                 .label = {"wave vector along Γ–X–M–Γ", 0},
                                 .names = names,
                                 .name_count = 4};
    draw_everywhere(draw_stack, &plan, page_with("Dispersion of the elastic automaton", NULL),
                    "curves");
}

static fw_status draw_pair(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_columns(page, data, 2, error);
}

/* Two beams of hexagonal lattices whose axes differ, as in Popov & Filippov Fig 6. */
enum { BEAM = 14 * 24, BEAMS = 2 * BEAM, BINS = 28 };

static void a_profile_is_drawn_under_its_configuration(void **state)
{
    (void)state;
    double x[BEAMS], y[BEAMS], force[BEAMS];
    for (int k = 0; k < BEAM; ++k) {
        int i = k % 14, j = k / 14;
        x[k] = -.5 - .866 * i;
        y[k] = j - 12 + (i % 2 ? .5 : 0);
        x[BEAM + k] = .5 + i * .866;
        y[BEAM + k] = (j - 12) * 1. + (i % 2 ? .25 : 0);
    }
    for (int k = 0; k < BEAMS; ++k) {
        double depth = exp(-x[k] * x[k] / 4);
        force[k] = .15 + .9 * depth * (.6 + .8 * scatter((unsigned)k)) + .05 * scatter((unsigned)k);
        x[k] += .4 * depth * (scatter(3u * (unsigned)k + 1) - .5);
        y[k] += .6 * depth * (scatter(7u * (unsigned)k + 5) - .5);
    }
    double place[BINS], value[BINS], error[BINS], control[BINS], order[BINS], order_error[BINS];
    for (int k = 0; k < BINS; ++k) {
        place[k] = .866 * (k - BINS / 2 + .5);
        value[k] = .176 + .65 * exp(-place[k] * place[k] / 3);
        control[k] = .04 + .53 * exp(-place[k] * place[k] / 1.5);
        error[k] = .02 + .03 * exp(-place[k] * place[k] / 4);
        order[k] = 1 - .6 * exp(-place[k] * place[k] / 2);
        order_error[k] = .02;
    }
    const fw_view_body bodies[2] = {
        {.name = "left", .count = BEAM, .x = x, .y = y, .field = force, .spacing = 1},
        {.name = "right",
         .count = BEAM,
         .x = x + BEAM,
         .y = y + BEAM,
         .field = force + BEAM,
         .spacing = 1}};
    const fw_view view = {.name = "configuration at t = 323", .bodies = bodies, .body_count = 2};
    const fw_curve returns[2] = {
        {"driven, A = 2.5 (mean of 4 seeds ± standard error)", BINS, place, value, error, NULL,
         FW_CURVE_LINE, 0, NULL},
        {"control, A = 0", BINS, place, control, NULL, NULL, FW_CURVE_LINE, FW_CURVE_GREY, NULL}};
    const fw_curve bond_order = {NULL, BINS,          place, order, order_error,
                                 NULL, FW_CURVE_LINE, 2,     NULL};
    const fw_chart charts[2] = {
        {.label = {"⟨|F_{return}|⟩ / ε r_{0}^{−1}", 0}, .curves = returns, .curve_count = 2},
        {.label = {"bond order ψ_{6}", 0}, .curves = &bond_order, .curve_count = 1}};
    const fw_figure_region regions[5] = {{-9, -6, "far", 0},
                                         {-6, -1.8, "intermediate", .45},
                                         {-1.8, 1.8, "contact", 1},
                                         {1.8, 6, "intermediate", .45},
                                         {6, 9, "far", 0}};
    fw_figure_stack_plan plan = {.views = &view,
                                 .view_count = 1,
                                 .colouring = {.label = {"return force |F| / ε r_{0}^{−1}", 0}},
                                 .charts = charts,
                                 .chart_count = 2,
                                 .label = {"x / r_{0}", 0},
                                 .regions = regions,
                                 .region_count = 5};
    draw_everywhere(draw_stack, &plan,
                    page_with("Two beams rub until their contact turns liquid",
                              "After Popov & Filippov 2008, Fig. 6."),
                    "profile");
    /* The control in a column of its own. */
    double calm[BEAMS];
    for (int k = 0; k < BEAMS; ++k) calm[k] = .04 + .6 * exp(-x[k] * x[k]);
    const fw_view_body resting[2] = {
        {.name = "left", .count = BEAM, .x = x, .y = y, .field = calm, .spacing = 1},
        {.name = "right",
         .count = BEAM,
         .x = x + BEAM,
         .y = y + BEAM,
         .field = calm + BEAM,
         .spacing = 1}};
    const fw_view rest = {.name = "control, A = 0", .bodies = resting, .body_count = 2};
    const fw_chart control_charts[2] = {
        {.label = charts[0].label, .curves = returns + 1, .curve_count = 1}, charts[1]};
    fw_figure_stack_plan both[2] = {plan, plan};
    both[1].views = &rest;
    both[1].charts = control_charts;
    draw_everywhere(draw_pair, both, page_with("Driven beams and their control", NULL), "columns");
}

static fw_status draw_map(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_map(page, data, error);
}

static void a_map_is_drawn_with_a_curve_over_it(void **state)
{
    (void)state;
    enum { SIZE = 65, ARC = 100 };
    double growth[SIZE * SIZE], arc_x[ARC], arc_y[ARC];
    for (int k = 0; k < SIZE * SIZE; ++k) {
        double c1 = 1.6 * (k % SIZE) / (SIZE - 1.), c2 = 1.6 * (k / SIZE) / (SIZE - 1.);
        double excess = c1 * c1 + c2 * c2 - 2;
        growth[k] = excess > 0 ? 1 + excess : 1;
    }
    for (int k = 0; k < ARC; ++k) {
        arc_x[k] = M_SQRT2 * cos(M_PI_2 * k / (ARC - 1));
        arc_y[k] = M_SQRT2 * sin(M_PI_2 * k / (ARC - 1));
    }
    const fw_curve arc = {
        "c_{1}^{2} + c_{2}^{2} = 2", ARC, arc_x, arc_y, NULL, NULL, FW_CURVE_LINE, 0, NULL};
    fw_figure_map_plan plan = {.columns = SIZE,
                               .rows = SIZE,
                               .values = growth,
                               .p_step = .025,
                               .q_step = .025,
                               .p_label = {"c_{1}", 0},
                               .q_label = {"c_{2}", 0},
                               .equal_aspect = true,
                               .colouring = {.label = {"largest |λ|", 0}},
                               .curves = &arc,
                               .curve_count = 1};
    draw_everywhere(draw_map, &plan, page_with("Stability of the elastic automaton", NULL), "map");
    plan.equal_aspect = false;
    plan.p_label = (fw_label){"time / steps", 0};
    plan.q_label = (fw_label){"density", 0};
    growth[1000] = NAN;
    draw_everywhere(draw_map, &plan, page_with(NULL, NULL), "map-wide");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(observables_over_time_are_drawn),
        cmocka_unit_test(a_dispersion_is_drawn),
        cmocka_unit_test(a_profile_is_drawn_under_its_configuration),
        cmocka_unit_test(a_map_is_drawn_with_a_curve_over_it),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
