/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_numbers.c - what pictures of forces, friction, series and analyses hand to their
 * figures, looked at on its way there: the numbers of the results, or closed forms. Bodies are
 * looked at in test_figure_plans.c, sweeps in test_figure_sweeps.c. */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/automaton/automaton_dispersion.h"
#include "experiments/drawing/palette.h"
#include "tests/support/program.h"
#include "tests/support/seen_figures.h"
#include "tests/support/sliding_block.h"

#include "tests/support/plotted_run.h"

static fw_playback *playback;
static char other[64]; /* the results that are drawn, beside the short run */

/* What figures without a plan of their own get. */
typedef struct seen_curves {
    const fw_chart *charts;
    int chart_count;
    fw_label x;
    const fw_axis_name *names;
    int name_count;
    const fw_figure_mark *marks;
    int mark_count;
} seen_curves;

SEEN_FIGURE(fw_figure_forces, fw_figure_forces_plan)
SEEN_FIGURE(fw_figure_map, fw_figure_map_plan)

fw_status __wrap_fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                                  const fw_axis_name *names, int name_count, fw_error *e);
fw_status __wrap_fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                                  const fw_axis_name *names, int name_count, fw_error *e)
{
    (void)e;
    see_figure(page, &(seen_curves){chart, 1, x, names, name_count, NULL, 0});
    return FW_OK;
}

fw_status __wrap_fw_figure_series(const fw_page *page, const fw_chart *charts, int count,
                                  fw_label time, const fw_figure_mark *marks, int mark_count,
                                  fw_error *e);
fw_status __wrap_fw_figure_series(const fw_page *page, const fw_chart *charts, int count,
                                  fw_label time, const fw_figure_mark *marks, int mark_count,
                                  fw_error *e)
{
    (void)e;
    see_figure(page, &(seen_curves){charts, count, time, NULL, 0, marks, mark_count});
    return FW_OK;
}

/* --- forces --- */

enum { SHEET = 9, ROD = 4, ALL = SHEET + ROD };

/* The sheet at rest and the rod that flies, where they are in the end; fat arrows are the forces
 * that were recorded, and thin ones those of both ends of each link. */
static void look_at_forces(const void *plan)
{
    const fw_figure_forces_plan *forces = plan;
    double x[ALL], y[ALL], force_x[ALL], force_y[ALL];
    const int64_t last = playback->frame_count - 1;
    assert_fine(fw_playback_read_positions(playback, last, x, y, &error));
    assert_fine(fw_playback_read_forces(playback, last, force_x, force_y, &error));
    assert_int_equal(forces->panel_count, 2);
    for (int b = 0, first = 0; b < 2; first += forces->panels[b++].count) {
        const fw_figure_forces_panel *panel = &forces->panels[b];
        assert_int_equal(panel->count, b == 0 ? SHEET : ROD);
        assert_memory_equal(panel->x, x + first, (size_t)panel->count * sizeof *x);
        assert_memory_equal(panel->y, y + first, (size_t)panel->count * sizeof *y);
        assert_int_equal(panel->link_count, b == 0 ? 12 : 3);
        fw_vec2 inner = {0, 0};
        int outer = 0;
        for (int k = 0; k < panel->force_count; ++k) {
            const fw_figure_force *of = &panel->forces[k];
            if (!of->external) inner = fw_vec2_add(inner, of->force);
            if (!of->external) continue;
            ++outer;
            assert_close(of->force.x, force_x[first + of->particle], 0);
            assert_close(of->force.y, force_y[first + of->particle], 0);
        }
        assert_int_equal(outer, b == 0 ? 3 : 0);
        assert_close(hypot(inner.x, inner.y), 0, 1e-15);
    }
}

static void forces_are_those_of_the_last_step(void **state)
{
    (void)state;
    assert_fine(fw_playback_open(&playback, folder, &error));
    draw_from(folder, &(fw_plot_wish){.file = NEVER_DRAWN, .kind = "forces"}, look_at_forces);
    fw_playback_close(playback);
}

/* A chain and a gas without forces that were recorded: arrows of the chain's links alone, at both
 * ends of each that is longer than at rest; a link from the stiff sites to others is stiff, between
 * them not. */
static void look_at_links(const void *plan)
{
    const fw_figure_forces_plan *forces = plan;
    const fw_figure_forces_panel *chain = &forces->panels[0], *gas = &forces->panels[1];
    static const double stiffness[] = {1, 5, 1, 5}, from[] = {0, 1, 2, 3};
    assert_int_equal(gas->force_count, 0);
    assert_int_equal(chain->force_count, 8);
    for (int k = 0; k < 8; k += 2) {
        const int a = chain->forces[k].particle, b = chain->forces[k + 1].particle;
        const double longer = chain->x[b] - chain->x[a] - 1;
        assert_close(a, from[k / 2], 0);
        assert_int_equal(b, a + 1);
        assert_close(chain->forces[k].force.x, stiffness[k / 2] * longer, 1e-12);
        assert_close(chain->forces[k + 1].force.x, -stiffness[k / 2] * longer, 1e-12);
    }
    assert_non_null(strstr(chain->name, ": 4 long at rest, "));
    expect_caption("External forces were not recorded (record.force): only those of the links");
}

static void forces_of_links_need_no_record(void **state)
{
    (void)state;
    static const int64_t steps[33] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,
                                      11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                      22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32};
    make_quick_folder(other, sizeof other);
    run_scenario(
        "title: a chain and a gas\n"
        "materials: {felt: {lattice-boltzmann: {}}, gas: {movable-particles: {strength: 0}}}\n"
        "bodies:\n"
        "  chain:\n"
        "    material: felt\n"
        "    shape: {rectangle: [5, 1]}\n"
        "    displacement: [{random: 0.1}]\n"
        "    link-stiffness: [{sites: [[2, 0], [3, 0]], links: across, value: 5}]\n"
        "  gas: {material: gas, lattice: hexagonal, origin: [0, 9], shape: {rectangle: "
        "[3, 3]}}\n"
        "dynamics: {time-step: 1}\n"
        "run: {steps: 32, record-every: 1}\n",
        other);
    const fw_plot_wish first = {
        .file = NEVER_DRAWN, .kind = "forces", .steps = steps, .step_count = 1};
    draw_from(other, &first, look_at_links);
    const fw_plot_wish many = {.kind = "forces", .steps = steps, .step_count = 33};
    assert_refused(look_at(other, &many, look_at_links), FW_BAD_INPUT,
                   "66 panels of forces (bodies times steps), expected at most 64");
    const fw_plot_wish seven = {.kind = "structure", .steps = steps, .step_count = 7};
    assert_refused(look_at(other, &seven, look_at_links), FW_BAD_INPUT,
                   "7 instants in one picture, expected at most 6");
    remove_folder(other);
}

/* --- series --- */

static void look_at_series(const void *plan)
{
    const seen_curves *series = plan;
    double times[1024], energy[1024], rod[2 * 1024];
    assert_true(playback->sample_count <= 1024);
    assert_fine(fw_playback_read_sample_times(playback, NULL, times, &error));
    assert_fine(fw_playback_read_observable(
        playback, fw_playback_find_observable(playback, "energy"), energy, &error));
    assert_fine(fw_playback_read_observable(
        playback, fw_playback_find_observable(playback, "momentum.rod"), rod, &error));
    assert_int_equal(series->chart_count, 2);
    assert_int_equal(series->mark_count, 0);
    assert_string_equal(series->x.text, "time (steps)");
    assert_int_equal(series->charts[0].curve_count, 1);
    assert_int_equal(series->charts[1].curve_count, 2);
    for (int n = 0; n < playback->sample_count; ++n) {
        assert_close(series->charts[0].curves[0].x[n], times[n], 0);
        assert_close(series->charts[0].curves[0].y[n], energy[n], 0);
        for (int c = 0; c < 2; ++c)
            assert_close(series->charts[1].curves[c].y[n], rod[2 * n + c], 0);
    }
}

static void series_are_what_was_measured(void **state)
{
    (void)state;
    static const char *const names[] = {"energy", "momentum.rod"};
    const fw_plot_wish wish = {.file = NEVER_DRAWN, .observables = names, .observable_count = 2};
    assert_fine(fw_playback_open(&playback, folder, &error));
    draw_from(folder, &wish, look_at_series);
    fw_playback_close(playback);
}

/* Time that runs backwards from step 5 on: the line that says so, and the fields and observables
 * that a picture without any has to refuse. */
static void look_at_reversal(const void *plan)
{
    const seen_curves *series = plan;
    assert_int_equal(series->mark_count, 1);
    assert_close(series->marks->at, 5, 0);
    assert_string_equal(series->marks->label, "reversal");
}

static void reversal_is_marked(void **state)
{
    (void)state;
    static const char *const momentum[] = {"momentum"};
    const struct {
        fw_plot_wish wish;
        const char *words;
    } refused[] = {
        {{.kind = "series"}, "no energy was measured, expected the names of observables to draw"},
        {{.kind = "stages"}, "no field was recorded; to have one, name it under record.fields"},
        {{.field = "mass-flow"}, "the field mass-flow was not recorded (no field was)"},
        {{.picture = "one"}, "has no picture one, and no other one"},
        {{.kind = "series", .observables = momentum, .observable_count = 1, .from = 7, .until = 9},
         "nothing was measured from step 7 to step 9"},
        {{.kind = "series", .observables = momentum, .observable_count = 1, .from = 13},
         "step 13, but the results hold the steps 0 to 12"},
        {{.kind = "series",
          .observables = momentum,
          .observable_count = 1,
          .logarithmic = true,
          .until = 5},
         "momentum goes from -1.2 to 0, expected values above 0 on a logarithmic axis"},
        {{.kind = "slip"}, "friction was not recorded particle by particle"},
        {{.kind = "loop"}, "slip was not measured, expected the results of a scenario with a "},
        {{.kind = "analysis"}, "the scenario has no analysis to draw"},
    };
    make_quick_folder(other, sizeof other);
    run_scenario(
        "title: there and back\n"
        "materials: {felt: {lattice-boltzmann: {}}}\n"
        "bodies: {sheet: {material: felt, shape: {rectangle: [3, 3]}, velocity: [-.1, 0]}}\n"
        "run: {steps: 12, reverse-at: 5, record-every: 6, measure-every: 6}\n"
        "measure: [momentum]\n",
        other);
    const fw_plot_wish wish = {.file = NEVER_DRAWN, .observables = momentum, .observable_count = 1};
    draw_from(other, &wish, look_at_reversal);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n)
        assert_refused(look_at(other, &refused[n].wish, look_at_reversal), FW_BAD_INPUT,
                       refused[n].words);
    remove_folder(other);
}

/* --- friction --- */

enum { BLOCK = 22, SIDE = 6 };

static const char *rubbed; /* the field of the map that is looked at */

/* Between two frames, at each particle of the lower side: by how much the field grew, over the
 * steps of rubbing or over the time. */
static void look_at_friction(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    const bool over_steps = strcmp(rubbed, FW_FIELD_SLIDING) == 0;
    double values[2][BLOCK], steps[2][BLOCK], times[64];
    int known = 0;
    assert_fine(fw_playback_read_frame_times(playback, NULL, times, &error));
    assert_int_equal(map->rows, SIDE);
    assert_int_equal(map->columns, playback->frame_count - 1);
    assert_string_equal(map->q_label.text, "x at rest, along block");
    assert_close(map->q_first, 0, 0);
    assert_close(map->q_step, 1, 0);
    assert_int_equal(map->colouring.map, over_steps ? FW_PALETTE_AUTO : FW_PALETTE_SEQUENTIAL);
    assert_close(map->colouring.range.high, over_steps, 0);
    for (int column = 0; column < map->columns; ++column) {
        for (int k = 0; k < 2; ++k) {
            assert_fine(fw_playback_read_field(playback, column + k, rubbed, values[k], &error));
            assert_fine(
                fw_playback_read_field(playback, column + k, FW_FIELD_RUBBING, steps[k], &error));
        }
        assert_close(map->p_first + column * map->p_step, (times[column] + times[column + 1]) / 2,
                     1e-12);
        for (int row = 0; row < SIDE; ++row) {
            const double of =
                over_steps ? steps[1][row] - steps[0][row] : times[column + 1] - times[column];
            const double found = map->values[row * map->columns + column];
            if (steps[1][row] == steps[0][row]) {
                assert_true(isnan(found));
                continue;
            }
            assert_close(found, (values[1][row] - values[0][row]) / of, 1e-15);
            ++known;
        }
    }
    assert_true(known > 40);
    expect_caption(over_steps ? "0 sticks, 1 slides all the time" : "Heat of friction");
    expect_caption(" Grey: no contact. ");
}

static void friction_is_drawn_where_it_was(void **state)
{
    (void)state;
    static const char *const maps[][2] = {{"slip", FW_FIELD_SLIDING}, {"heat", FW_FIELD_HEAT}};
    make_quick_folder(other, sizeof other);
    run_scenario(SLIDING_BLOCK "pictures: {where: {kind: slip}}\n", other);
    assert_fine(fw_playback_open(&playback, other, &error));
    for (int k = 0; k < 2; ++k) {
        rubbed = maps[k][1];
        draw_from(other, &(fw_plot_wish){.file = NEVER_DRAWN, .kind = maps[k][0]},
                  look_at_friction);
    }
    fw_playback_close(playback);
    const fw_plot_wish one_frame = {.kind = "slip", .from = 25, .until = 35};
    assert_refused(look_at(other, &one_frame, look_at_friction), FW_BAD_INPUT,
                   "friction is drawn between frames, expected at least two of them from step 25 "
                   "to 35");
    remove_folder(other);
}

/* The left side of a block that has a gap, on a wall: its places are named, as they are shown. */
static void look_at_uneven_places(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    static const char *const names[] = {"0", "2", "6", "8"};
    assert_int_equal(map->rows, 4);
    assert_string_equal(map->q_label.text, "y at rest, along block (nm)");
    assert_close(map->q_first, 0, 0);
    assert_close(map->q_step, 1, 0);
    assert_int_equal(map->q_name_count, 4);
    for (int n = 0; n < 4; ++n) {
        assert_close(map->q_names[n].at, n, 0);
        assert_string_equal(map->q_names[n].name, names[n]);
    }
    /* From step 40 to 100, the frame behind which comes early. */
    assert_int_equal(map->columns, 3);
    assert_close(map->p_first, 2.5 * map->p_step, 1e-12);
    assert_int_equal(map->colouring.map, FW_PALETTE_WARM);
}

static void uneven_places_have_names(void **state)
{
    (void)state;
    make_quick_folder(other, sizeof other);
    run_scenario("title: a block with a gap slides up a wall\n"
                 "units: {length: 2 nm, time: 1 ps, mass: 1 u}\n"
                 "materials: {felt: {lattice-boltzmann: {rest-mass: 0.5, damping: 0.01}}}\n"
                 "bodies:\n"
                 "  block:\n"
                 "    material: felt\n"
                 "    velocity: [0, 0.05]\n"
                 "    shape: {mask: \"###\\n###\\n.##\\n###\\n###\\n\"}\n"
                 "walls: {side: {chain: [[0, 99], [0, -99]], surface: {coulomb: 0.3}}}\n"
                 "forces: {weight: {body: block, acceleration: [-0.002, 0]}}\n"
                 "run: {steps: 110, record-every: 20}\n"
                 "pictures: {where: {kind: heat}}\n",
                 other);
    draw_from(other,
              &(fw_plot_wish){.file = NEVER_DRAWN, .kind = "heat", .from = 30, .palette = "warm"},
              look_at_uneven_places);
    remove_folder(other);
}

/* --- curves of analyses --- */

static const char waves[] = "title: waves\n"
                            "materials:\n"
                            "  foam: {elastic-automaton: {c1: .4, c2: .58, boundary: periodic}}\n"
                            "  chopard: {elastic-automaton: {chopard: true}}\n"
                            "bodies: {square: {material: chopard, shape: {rectangle: [4, 4]}, "
                            "velocities: [{random: .1}]}}\n"
                            "run: {steps: 2}\n"
                            "analysis:\n"
                            "  one: {plane-mode: {material: foam, wave-vector: [.3, .3]}}\n"
                            "  foam: {dispersion: {material: foam, size: 16, steps: 8}}\n"
                            "  square: {boltzmann-reference: {body: square, half-steps: 30}}\n"
                            "pictures:\n"
                            "  one: {kind: analysis, analysis: one}\n"
                            "  foam: {kind: analysis, analysis: foam}\n"
                            "  square: {kind: analysis, analysis: square}\n";

/* Eight waves on each leg of the way from Gamma over X and M: those that were simulated lie on the
 * closed form, which has ten points for each and begins and ends at rest. */
static void look_at_dispersion(const void *plan)
{
    enum { LEG = 80, EVERY = 10 };
    const seen_curves *seen = plan;
    const fw_curve *fast = &seen->charts->curves[0], *simulated = &seen->charts->curves[2];
    static const char *const places[] = {"Γ", "X", "M", "Γ"};
    const double at[] = {0, M_PI, 2 * M_PI, (2 + sqrt(2)) * M_PI};
    assert_int_equal(seen->name_count, 4);
    for (int n = 0; n < 4; ++n) {
        assert_string_equal(seen->names[n].name, places[n]);
        assert_close(seen->names[n].at, at[n], 1e-12);
        assert_close(fast->x[n * LEG], at[n], 1e-12);
    }
    assert_int_equal(simulated->count, 3 * 8 - 1);
    for (int m = 0; m < 2; ++m)
        for (int n = 0; n < simulated->count; ++n) {
            assert_close(simulated[m].x[n], fast[m].x[(n + 1) * EVERY], 1e-12);
            assert_close(simulated[m].y[n], fast[m].y[(n + 1) * EVERY], 1e-9);
        }
    for (int m = 0; m < 4; ++m) assert_close(fast[m / 2].y[m % 2 * 3 * LEG], 0, 1e-7);
    double highest = 0;
    for (int n = 0; n < fast->count; ++n) highest = fmax(highest, fast->y[n]);
    assert_close(seen->charts->range.high, 1.05 * highest, 1e-12);
}

/* Rounding, that may grow: never exactly nothing, and far from seen. */
static void look_at_reference(const void *plan)
{
    const seen_curves *seen = plan;
    fw_table steps, apart;
    assert_true(seen->charts->logarithmic);
    assert_string_equal(seen->x.text, "time (half-steps)");
    assert_fine(fw_playback_open(&playback, other, &error));
    assert_fine(fw_playback_read_table(playback, "square", "half-step", &steps, &error));
    assert_fine(fw_playback_read_table(playback, "square", "difference", &apart, &error));
    fw_playback_close(playback);
    const fw_curve *curve = seen->charts->curves;
    assert_int_equal(curve->count, steps.extent[0]);
    assert_close(curve->x[curve->count - 1], 30, 0);
    assert_memory_equal(curve->x, steps.values, (size_t)curve->count * sizeof *curve->x);
    assert_memory_equal(curve->y, apart.values, (size_t)curve->count * sizeof *curve->y);
    free(steps.values);
    free(apart.values);
}

static void curves_of_analyses_are_their_numbers(void **state)
{
    (void)state;
    make_quick_folder(other, sizeof other);
    run_scenario(waves, other);
    draw_from(other, &(fw_plot_wish){.file = NEVER_DRAWN, .picture = "foam"}, look_at_dispersion);
    draw_from(other, &(fw_plot_wish){.file = NEVER_DRAWN, .picture = "square"}, look_at_reference);
    assert_refused(look_at(other, &(fw_plot_wish){.picture = "one"}, look_at_reference),
                   FW_BAD_INPUT,
                   "the analysis one is a few numbers, expected one with a map or curves");
    remove_folder(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_those_of_the_last_step),
        cmocka_unit_test(forces_of_links_need_no_record),
        cmocka_unit_test(series_are_what_was_measured),
        cmocka_unit_test(reversal_is_marked),
        cmocka_unit_test(friction_is_drawn_where_it_was),
        cmocka_unit_test(uneven_places_have_names),
        cmocka_unit_test(curves_of_analyses_are_their_numbers),
    };
    return cmocka_run_group_tests(tests, make_run, remove_run);
}
