/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_structure.c - maps of the structure factor and histograms of a field: the tables that
 * stand beside the pictures, held against closed forms. */
#include "tests/support/laws.h"

#include "experiments/pictures/plot.h"
#include "experiments/storage/csv.h"

#include "tests/support/plotted_run.h"

#include <stdlib.h>
#include <unistd.h>

enum { SIDE = 8 };

/* Particles that feel nothing fly apart with v = r/10: x at time t is (1 + t/10) x. */
static const char crystal_text[] =
    "title: A square of particles grows\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies:\n"
    "  square:\n"
    "    material: gas\n"
    "    shape: {rectangle: [8, 8]}\n"
    "    velocities: [{gradient: [0.1, 0, 0, 0.1]}]\n"
    "dynamics: {time-step: 0.1}\n"
    "run: {steps: 10, record-every: 5, measure-every: 5}\n"
    "record: {fields: [gaussian-density]}\n"
    "measure: [gaussian-density]\n"
    "pictures:\n"
    "  map: {kind: structure, instants: [0, 10]}\n"
    "  one: {kind: structure}\n"
    "  parts: {kind: stages, field: gaussian-density, range: [0, 4], instants: [0, 10]}\n"
    "  time: {kind: histogram, field: gaussian-density, range: [0, 4], from: 5}\n";

static int make_crystal(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    run_scenario(crystal_text, folder);
    return 0;
}

static void draw(const char *picture, const char *file)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    const fw_plot_wish wish = {.picture = picture, .file = file};
    assert_fine(fw_plot_one(folder, &wish, out, &error));
    fclose(out);
    free(text);
}

/* Rows of numbers of a table in the folder; its first line is its head. */
enum { COLUMNS_MAX = 8 };
typedef struct rows {
    int count;
    double (*row)[COLUMNS_MAX];
} rows;

static rows read_rows(const char *name, const char *head)
{
    char path[256], line[512];
    rows r = {0, NULL};
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    assert_non_null(fgets(line, sizeof line, in));
    line[strcspn(line, "\n")] = '\0';
    assert_string_equal(line, head);
    while (fgets(line, sizeof line, in)) {
        r.row = realloc(r.row, ((size_t)r.count + 1) * sizeof *r.row);
        line[strcspn(line, "\n")] = '\0';
        char *rest = line, *value;
        for (int c = 0; c < COLUMNS_MAX && rest; ++c) {
            rest = fw_csv_cut(rest, &value);
            r.row[r.count][c] = fw_csv_read_number(value);
        }
        r.count += 1;
    }
    fclose(in);
    return r;
}

/* |sum_k e^{i q a k}|^2/SIDE^2 of a row of SIDE points, a apart. */
static double of_row(double q, double spacing)
{
    const double half = q * spacing / 2, sine = sin(half);
    return fabs(sine) < 1e-9 ? 1 : pow(sin(SIDE * half) / (SIDE * sine), 2);
}

static void the_map_is_that_of_a_square_lattice(void **state)
{
    (void)state;
    draw("map", NULL);
    const rows r = read_rows("map-data.csv", "step,qx,qy,S");
    int middle = 0, last = 0;
    for (int n = 0; n < r.count; ++n) {
        const double *row = r.row[n], spacing = row[0] == 0 ? 1 : 1.1;
        const double exact = of_row(row[1], spacing) * of_row(row[2], spacing);
        /* q has six digits, and changes S by 2 SIDE per unit of it at most. */
        assert_close(row[3], exact, 1e-5 * exact + 1e-3 * exact / (1 + exact) + 2e-4);
        if (row[1] == 0 && row[2] == 0) {
            assert_close(row[3], 1, 1e-12);
            middle += 1;
        }
        last += row[0] == 10;
    }
    assert_int_equal(middle, 2);
    assert_int_equal(2 * last, r.count);
    free(r.row);
}

/* The density on particle (i, j) is that of its row times that of its column. */
static double density_on(int number, double spacing)
{
    double along = 0, across = 0;
    for (int k = 0; k < SIDE; ++k) {
        along += exp(-pow((number % SIDE - k) * spacing, 2));
        across += exp(-pow((number / SIDE - k) * spacing, 2));
    }
    return along * across;
}

static void check_histograms(const char *name, int frames, int64_t first, int64_t every)
{
    const rows r = read_rows(name, "step,time,mean,spread,maximum,from,until,part");
    const int bins = r.count / frames;
    assert_int_equal(bins * frames, r.count);
    for (int k = 0; k < frames; ++k) {
        const double time = (double)(first + k * every) / 10, spacing = 1 + time / 10;
        double mean = 0, square = 0, highest = 0, sum = 0;
        for (int i = 0; i < SIDE * SIDE; ++i) {
            const double value = density_on(i, spacing);
            mean += value / (SIDE * SIDE), square += value * value / (SIDE * SIDE);
            highest = fmax(highest, value);
        }
        for (int bin = 0; bin < bins; ++bin) {
            const double *row = r.row[k * bins + bin];
            int inside = 0;
            for (int i = 0; i < SIDE * SIDE; ++i)
                inside += density_on(i, spacing) >= row[5] && density_on(i, spacing) < row[6];
            assert_close(row[1], time, 1e-12);
            assert_close(row[2], mean, 1e-12);
            assert_close(row[3], sqrt(square - mean * mean), 1e-9);
            assert_close(row[4], highest, 1e-12);
            assert_close(row[7], (double)inside / (SIDE * SIDE), 1e-12);
            sum += row[7];
        }
        assert_close(sum, 1, 1e-12);
    }
    free(r.row);
}

static void histograms_are_those_of_the_density(void **state)
{
    (void)state;
    draw("parts", NULL);
    check_histograms("parts-data.csv", 2, 0, 10);
    draw("time", NULL);
    check_histograms("time-data.csv", 2, 5, 5);
}

/* Where the user names the file, nothing else is written. */
static void a_picture_elsewhere_has_no_table(void **state)
{
    (void)state;
    char file[128], table[128];
    snprintf(file, sizeof file, "%s/elsewhere.png", folder);
    snprintf(table, sizeof table, "%s/one-data.csv", folder);
    draw("one", file);
    assert_int_equal(access(file, F_OK), 0);
    assert_int_not_equal(access(table, F_OK), 0);
    unlink(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_map_is_that_of_a_square_lattice),
        cmocka_unit_test(histograms_are_those_of_the_density),
        cmocka_unit_test(a_picture_elsewhere_has_no_table),
    };
    return cmocka_run_group_tests(tests, make_crystal, remove_run);
}
