/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_sweep.c - pictures and tables of sweeps: lines of a level, quantities against each
 * other, and the numbers of single seeds. */
#include "tests/support/laws.h"

#include "experiments/pictures/plot_sweep_parts.h"
#include "experiments/storage/hdf5_file.h"
#include "tests/support/program.h"

enum { COLUMNS = 5, ROWS = 4 };

/* Of a plane the line is straight, wherever it crosses the grid: v = 1 + x + 2 y. Where it passes a
 * side of the grid, the errors at its ends give that of the place, over the slope. */
static void the_line_of_a_plane_is_straight(void **state)
{
    double values[ROWS * COLUMNS], errors[ROWS * COLUMNS];
    fw_sweep_level line;
    (void)state;
    for (int n = 0; n < ROWS * COLUMNS; ++n) {
        values[n] = 1 + n % COLUMNS + 2 * (n / COLUMNS);
        errors[n] = 0.1 * (1 + n % COLUMNS + n / COLUMNS);
    }
    const double level = 5.3;
    assert_fine(fw_plot_sweep_level_of_grid(&line, level, COLUMNS, ROWS, values, errors, &error));
    /* From (4, 0.15) to (0, 2.15). */
    double length = 0;
    for (int n = 0; n < line.count; ++n) {
        if (isnan(line.x[n])) continue;
        assert_close(1 + line.x[n] + 2 * line.y[n], level, 1e-12);
        if (n + 1 < line.count && !isnan(line.x[n + 1]))
            length += hypot(line.x[n + 1] - line.x[n], line.y[n + 1] - line.y[n]);
    }
    assert_close(length, hypot(4, 2), 1e-12);
    assert_int_equal(line.mark_count, 7);
    for (int n = 0; n < line.mark_count; ++n) {
        const double x = line.mark_x[n], y = line.mark_y[n];
        const bool upright = x == floor(x);
        const double t = upright ? y - floor(y) : x - floor(x);
        const double near = 0.1 * (1 + floor(x) + floor(y)), next = near + 0.1;
        const double expected = hypot((1 - t) * near, t * next) / (upright ? 2 : 1);
        assert_close(upright ? line.mark_error[n] : line.mark_spread[n], expected, 1e-12);
        assert_true(isnan(upright ? line.mark_spread[n] : line.mark_error[n]));
    }
    fw_plot_sweep_level_clear(&line);
}

/* Between two hills in opposite corners the middle decides what belongs together. */
static void a_saddle_is_parted_by_its_middle(void **state)
{
    const double high[4] = {1, 0.2, 0.2, 1}, low[4] = {0.8, 0, 0, 0.8}, errors[4] = {0};
    fw_sweep_level line;
    (void)state;
    for (int k = 0; k < 2; ++k) {
        assert_fine(fw_plot_sweep_level_of_grid(&line, 0.5, 2, 2, k ? low : high, errors, &error));
        assert_int_equal(line.count, 6);
        /* Each piece cuts off a corner: where the middle (0.6 or 0.4) is high, a low one. */
        for (int n = 0; n < 6; n += 3) {
            const double x = (line.x[n] + line.x[n + 1]) / 2, y = (line.y[n] + line.y[n + 1]) / 2;
            assert_true(k ? (x < .5) == (y < .5) : (x < .5) != (y < .5));
        }
        fw_plot_sweep_level_clear(&line);
    }
}

/* A hole in the grid ends the line, and makes no number of its own. */
static void a_hole_ends_the_line(void **state)
{
    const double values[6] = {0, 0, 0, 1, NAN, 1};
    const double errors[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    fw_sweep_level line;
    (void)state;
    assert_fine(fw_plot_sweep_level_of_grid(&line, 0.5, 3, 2, values, errors, &error));
    assert_int_equal(line.count, 0);
    assert_int_equal(line.mark_count, 2);
    fw_plot_sweep_level_clear(&line);
}

/* --- a sweep with seeds --- */

static const char gas[] =
    "title: heat\n"
    "parameters: {T: 1, n: 4}\n"
    "materials: {crystal: {movable-particles: {}}}\n"
    "bodies:\n"
    "  gas: {material: crystal, lattice: hexagonal, shape: {rectangle: [n, 4]}}\n"
    "dynamics: {time-step: 0.01, damping: 0.5, temperature: T/1000}\n"
    "run: {steps: 200, record-every: 100, measure-every: 10}\n"
    "study:\n"
    "  seeds: 3\n"
    "  sweep:\n"
    "    parameters: {T: {values: [1, 2, 4], unit: milli}, n: {values: [3, 4]}}\n"
    "expect:\n"
    "  - {quantity: kinetic-energy, statistic: mean, above: 0}\n"
    "  - {quantity: thermostat-heat, above: -1}\n"
    "pictures:\n"
    "  against: {kind: sweep, observables: [thermostat-heat], along: kinetic-energy}\n"
    "  map: {kind: map, observables: [kinetic-energy], along: T, level: 0.01}\n";

/* HDF5 has what the tables have. */
static void expect_archive(const char *folder)
{
    char path[128];
    double T[18], n[18], seed[18], cases[18], mean[6], energy[18];
    fw_hdf5 *file;
    snprintf(path, sizeof path, "%s/it/sweep.h5", folder);
    assert_fine(fw_hdf5_open(&file, path, false, &error));
    const struct {
        const char *path;
        double *values;
        uint64_t count;
    } wanted[] = {{"seeds/parameters/T", T, 18},
                  {"seeds/parameters/n", n, 18},
                  {"seeds/seed", seed, 18},
                  {"seeds/case", cases, 18},
                  {"seeds/numbers/thermostat-heat, at the end", energy, 18},
                  {"cases/numbers/thermostat-heat, at the end/mean", mean, 6}};
    for (size_t k = 0; k < sizeof wanted / sizeof wanted[0]; ++k) {
        const fw_dataset dataset = fw_hdf5_find(file, wanted[k].path);
        fw_hdf5_read(file, dataset, FW_F64, 0, wanted[k].count, wanted[k].values);
        fw_hdf5_release(dataset);
    }
    assert_fine(fw_hdf5_check(file, &error));
    assert_fine(fw_hdf5_close(file, &error));
    for (int r = 0; r < 18; ++r) {
        static const double temperatures[] = {1, 2, 4};
        assert_true(T[r] == temperatures[r / 6] && n[r] == 3 + r / 3 % 2);
        assert_true(seed[r] == 1 + r % 3 && cases[r] == r / 3);
    }
    for (int c = 0; c < 6; ++c)
        assert_close((energy[3 * c] + energy[3 * c + 1] + energy[3 * c + 2]) / 3, mean[c], 1e-15);
}

static void seeds_have_rows_whose_means_are_those_of_the_cases(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    outcome seen = run_program(folder, "run gas.yaml -q -o it -j 2");
    expect_end(&seen, 0, "");
    shell(folder, "head -c 4 it/against.png | grep -q PNG && head -c 4 it/map.png | grep -q PNG");
    shell(folder, "test $(grep -vc '^#' it/sweep-seeds.csv) = 19 &&"
                  " head -2 it/sweep-seeds.csv | tail -1 | grep -q '^# units: milli,,,energy'");
    shell(folder, "grep -q '^4,3,3,' it/sweep-seeds.csv && grep -q ',seeds$' it/sweep.csv &&"
                  " test $(grep -c ',3$' it/sweep.csv) = 6");
    /* Mean and standard error of a case are those of its three rows. */
    shell(folder, "grep '^2,4,' it/sweep-seeds.csv | awk -F, '{s += $4; q += $4^2} END {m = s/3;"
                  " printf \"%.12g %.6g\\n\", m, sqrt((q/3 - m^2)/2)}' > seeds;"
                  " grep '^2,4,' it/sweep.csv |"
                  " awk -F, '{printf \"%.12g %.6g\\n\", $3, $4}' | cmp - seeds");
    shell(folder, "grep '^4,3,' it/sweep-seeds.csv | awk -F, '{s += $5} END {printf \"%.12g\\n\","
                  " s/3}' > seeds; grep '^4,3,' it/sweep.csv | grep -q \",$(cut -c1-9 seeds)\"");
    expect_archive(folder);
    /* One after the other, and again: the same file. */
    seen = run_program(folder, "run gas.yaml -q -o again -j 1");
    expect_end(&seen, 0, "");
    shell(folder, "cmp it/sweep.h5 again/sweep.h5 && cmp it/sweep-seeds.csv again/sweep-seeds.csv");
    seen = run_program(folder, "plot it --kind map --observable kinetic-energy --level 1x");
    expect_end(&seen, 2, "--level 1x, expected a number");
    /* The line of the scenario's map is that of its own number. */
    static const char *const lines[] = {
        "plot it --kind map --observable thermostat-heat -o heat.png",
        "plot it --kind map --observable thermostat-heat --level 0.01 -o heat-line.png",
        "plot it --kind map --observable kinetic-energy -o energy.png",
        "plot it --kind map --observable kinetic-energy --level 0.01 -o energy-line.png"};
    for (int n = 0; n < 4; ++n) {
        seen = run_program(folder, lines[n]);
        expect_end(&seen, 0, "");
    }
    shell(folder, "cmp energy.png energy-line.png && ! cmp -s heat.png heat-line.png");
    /* A picture that cannot be written keeps no other one from being drawn. */
    shell(folder, "cp it/map.png map.png && rm it/*.png && mkdir it/against.png");
    seen = run_program(folder, "plot it");
    assert_int_not_equal(seen.code, 0);
    assert_non_null(strstr(seen.err, "against.png"));
    shell(folder, "cmp it/map.png map.png && rmdir it/against.png");
    seen = run_program(folder, "plot it --kind map --along thermostat-heat");
    expect_end(&seen, 2,
               "a map lies over two parameters, and thermostat-heat is a number of the sweep");
    seen = run_program(folder, "plot it --kind sweep --along kinetic-enrgy");
    expect_end(&seen, 2, "the sweep has no kinetic-enrgy; did you mean kinetic-energy?");
    seen = run_program(folder, "plot it/T=1,n=3 --along kinetic-energy");
    expect_end(&seen, 2, "does not draw anything along another number");
    seen = run_program(folder, "run gas.yaml -q -o other --set pictures.against.level=2");
    expect_end(&seen, 2,
               "pictures.against has 'level', which a picture of kind 'sweep' does not draw");
    seen = run_program(folder, "run gas.yaml -q -o other --set pictures.map.along=m");
    expect_end(&seen, 2, "'m' is no parameter of study.sweep, expected one of T, n");
    /* Results of a sweep may be replaced, these tables too, but no file of the user's. */
    seen = run_program(folder, "run gas.yaml -q -o it --overwrite");
    expect_end(&seen, 0, "");
    shell(folder, "echo mine > it/sweep.h5");
    seen = run_program(folder, "run gas.yaml -q -o it --overwrite");
    expect_end(&seen, 2, "it/sweep.h5 is in the way");
    remove_folder(folder);
    skip_unseen();
}

/* Panels of one quantity are told from each other. */
static void labels_name_what_differs(void **state)
{
    fw_sweep_column columns[] = {{.name = "centre-of-mass.block x, change", .unit = "length"},
                                 {.name = "centre-of-mass.slab y, at the end", .unit = "length"},
                                 {.name = "reaction.floor x, mean", .unit = "force"},
                                 {.name = "centre-of-mass-error, mean", .unit = "length"},
                                 {.name = "slip x", .unit = "length"},
                                 {.name = "layer-contact", .unit = "force"}};
    static const char *const wanted[][2] = {
        {"centre of mass x of block, change (length)", "block x, change"},
        {"centre of mass y of slab, at the end (length)", "slab y, at the end"},
        {"reaction x, mean (force)", "floor x, mean"},
        {"centre of mass error, mean (length)", "mean"},
        {"slip x (length)", "x"},
        {"layer contact (force)", ""}};
    const fw_sweep_table table = {.columns = columns, .column_count = 6};
    char label[200];
    fw_label axis;
    (void)state;
    for (int n = 0; n < 6; ++n) {
        const char *part =
            fw_plot_sweep_label(&columns[n], &table, NULL, true, label, sizeof label, &axis);
        assert_string_equal(label, wanted[n][0]);
        assert_string_equal(part, wanted[n][1]);
    }
    fw_plot_sweep_label(&columns[0], &table, NULL, false, label, sizeof label, &axis);
    assert_string_equal(label, "centre of mass (length)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_line_of_a_plane_is_straight),
        cmocka_unit_test(a_saddle_is_parted_by_its_middle),
        cmocka_unit_test(a_hole_ends_the_line),
        cmocka_unit_test(labels_name_what_differs),
        cmocka_unit_test(seeds_have_rows_whose_means_are_those_of_the_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
