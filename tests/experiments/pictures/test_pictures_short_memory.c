/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_pictures_short_memory.c - every allocation of a picture, and everything that it reads of a
 * result, fails once: it says so, or comes to the same bytes, and leaves nothing behind. Start
 * reading at the table of pictures. */
#include "tests/support/short_memory.h"

#include "core/array.h"
#include "experiments/pictures/plot_choice.h"
#include "experiments/pictures/plot_sweep.h"
#include "experiments/pictures/plot_sweep_parts.h"
#include "experiments/pictures/report_page.h"
#include "tests/support/beams.h"
#include "tests/support/flying_sheets.h"
#include "tests/support/program.h"
#include "tests/support/sliding_block.h"

#include "tests/experiments/results/failing_reads.h"
#include "tests/support/plotted_run.h"

/* --- pictures --- */

static const char waves[] =
    "title: waves\n"
    "materials:\n"
    "  foam: {elastic-automaton: {c1: .4, c2: .58, boundary: periodic}}\n"
    "  chopard: {elastic-automaton: {chopard: true}}\n"
    "bodies: {square: {material: foam, shape: {rectangle: [8, 8]}, displacement:\n"
    "  [{mode: {wave-vector: [0.7853981633974483, 0], branch: fast, amplitude: .1}}]}}\n"
    "run: {steps: 2, record-every: 1}\n"
    "record: {fields: [displacement-x]}\n"
    "analysis:\n"
    "  foam: {dispersion: {material: foam, size: 8, steps: 4}}\n"
    "  map: {stability-map: {c1: [.5, 1.5], c2: [.2, 1.4], points: [3, 3], waves: 16}}\n"
    "pictures:\n"
    "  foam: {kind: analysis, analysis: foam}\n"
    "  map: {kind: analysis, analysis: map}\n";

/* Two frames with everything that a report shows. */
static const char falling[] =
    "title: a block falls\n"
    "materials: {felt: {lattice-boltzmann: {rest-mass: 0.5, break-at: 1}}}\n"
    "bodies: {block: {material: felt, shape: {rectangle: [3, 2]}, velocity: [0.05, -0.1]}}\n"
    "walls: {floor: {chain: [[-9, -0.1], [9, -0.1]], surface: {coulomb: 0.3}}}\n"
    "run: {steps: 4, record-every: 4}\n"
    "record: {force: true, fields: [energy]}\n"
    "measure: [energy, reaction]\n"
    "expect: [{quantity: energy, above: 0, source: nobody}]\n"
    "pictures: {one: {kind: series, observables: [energy]}}\n";

enum { SHORT_RUN, BLOCK, WAVES, PAGE, BEAMS, RESULTS };
static char folders[RESULTS][64];
static fw_plot_result results[RESULTS];

typedef struct wanted_picture {
    int result;
    fw_plot_wish wish;
} wanted_picture;

#define DRAW_FUNCTION(id, draw, name, meaning, keys, needs, frames, field) fw_plot_draw_##draw,
static fw_status (*const draws[])(const fw_plot_result *, const fw_plot_picture *,
                                  fw_error *) = {FW_PICTURE_ROWS(DRAW_FUNCTION)};

/* Without the drawings in a report, which cairo numbers as they come in a process. */
static uint64_t hash_of_file(const char *path)
{
    static char bytes[1 << 20];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t count = fread(bytes, 1, sizeof bytes - 1, file);
    fclose(file);
    bytes[count] = '\0';
    for (char *image = bytes; (image = strstr(image, "data:image/svg")); ++image) {
        const size_t length = strcspn(image, "\n");
        memmove(image, image + length, count - (size_t)(image + length - bytes) + 1);
        count -= length;
    }
    unlink(path);
    assert_true(count > 1000 && count < sizeof bytes);
    fw_state_list list = {0};
    fw_state_list_add(&list, "picture", FW_U8, count, bytes);
    return fw_state_list_hash(&list);
}

static fw_status draw_one(const void *input, uint64_t *result, fw_error *e)
{
    const wanted_picture *wanted = input;
    static fw_plot_choice choice;
    char path[128];
    fw_plot_wish wish = wanted->wish;
    snprintf(path, sizeof path, "%s/it.pdf", folders[SHORT_RUN]);
    wish.file = path;
    fw_status status = fw_plot_choose(&choice, &results[wanted->result], &wish, e);
    if (status == FW_OK)
        status = draws[choice.picture.asked.kind](&results[wanted->result], &choice.picture, e);
    fw_plot_choice_clear(&choice);
    if (status == FW_OK) *result = hash_of_file(path);
    if (status != FW_OK) assert_int_not_equal(access(path, F_OK), 0);
    return status;
}

static void every_picture_says_what_it_misses(void **state)
{
    (void)state;
    static const int64_t three[] = {0, 400, 800};
    static const char *const names[] = {"temperature", "energy"};
    static const char *with[1];
    with[0] = folders[SHORT_RUN];
    const wanted_picture pictures[] = {
        {SHORT_RUN, {.kind = "motion", .steps = three, .step_count = 2}},
        {SHORT_RUN, {.kind = "forces"}},
        {SHORT_RUN, {.kind = "contact", .steps = three, .step_count = 2}},
        {SHORT_RUN, {.kind = "field", .field = "energy", .steps = three, .step_count = 1}},
        {SHORT_RUN, {.kind = "strip", .steps = three, .step_count = 2}},
        {SHORT_RUN, {.kind = "structure", .steps = three, .step_count = 1}},
        {SHORT_RUN, {.kind = "stages", .steps = three, .step_count = 2}},
        {SHORT_RUN, {.kind = "histogram"}},
        {SHORT_RUN, {.kind = "series", .with = with, .with_count = 1}},
        {SHORT_RUN,
         {.along = "centre-of-mass.rod.x", .observables = names + 1, .observable_count = 1}},
        {BLOCK, {.kind = "slip"}},
        {WAVES, {.picture = "foam"}},
        {WAVES, {.picture = "map"}},
        {WAVES, {.kind = "strip", .field = "displacement-x"}},
        {BEAMS, {.observables = names, .observable_count = 1}},
        {BEAMS, {.kind = "profile"}},
        {BEAMS, {.kind = "loop"}},
    };
    for (size_t n = 0; n < sizeof pictures / sizeof *pictures; ++n) {
        const fw_plot_wish *wish = &pictures[n].wish;
        const char *name = wish->kind ? wish->kind : wish->picture ? wish->picture : "observables";
        assert_true(fail_each_allocation(name, draw_one, &pictures[n]) > 5);
    }
}

/* --- sweeps --- */

static fw_plot_sweep sweeps[2];

static fw_status draw_sweep(const void *input, uint64_t *result, fw_error *e)
{
    const int number = *(const int *)input;
    const double level = 10;
    const fw_plot_wish wish = {.level = number > 0 ? &level : NULL};
    char path[128];
    fw_page page = fw_plot_page(&wish);
    snprintf(path, sizeof path, "%s/it.pdf", folders[SHORT_RUN]);
    page.file = path;
    FW_TRY((number > 0 ? fw_plot_sweep_map : fw_plot_sweep_curves)(&sweeps[number / 2], &wish, NULL,
                                                                   &page, e));
    *result = hash_of_file(path);
    return FW_OK;
}

static void sweeps_say_what_they_miss(void **state)
{
    (void)state;
    static const char *const texts[] = {
        FLIGHT("v: {values: [.1, .2, .3]}, x0: {values: [0, 2]}", "above: 0"),
        FLIGHT("v: {from: .1, to: .5, tolerance: .1, unit: length/time}, x0: {values: [0, 2]}",
               "crosses: 10, value: .2, within: 9")};
    static const char *const names[] = {"lines of a sweep", "map", "map of a bisection"};
    for (int n = 0; n < 2; ++n) {
        char made[64];
        make_quick_folder(made, sizeof made);
        write_scenario(made, "file.yaml", texts[n]);
        const outcome seen = run_program(made, "run file.yaml -q --no-plot -o . -j 1");
        expect_end(&seen, 0, "");
        sweeps[n].directory = strdup(made);
        assert_fine(fw_sweep_load(&sweeps[n].scenario, made, &error));
        assert_fine(fw_sweep_table_read(&sweeps[n].table, made, 2, &error));
    }
    for (int n = 0; n < 3; ++n) assert_true(fail_each_allocation(names[n], draw_sweep, &n) > 5);
    for (int n = 0; n < 2; ++n) {
        fw_sweep_table_clear(&sweeps[n].table);
        fw_scenario_destroy(sweeps[n].scenario);
        remove_folder(sweeps[n].directory);
        free((char *)(uintptr_t)sweeps[n].directory);
    }
}

/* --- results --- */

static void cite_nothing(FILE *out, const fw_scenario *scenario)
{
    fprintf(out, "@misc{%s}\n", scenario->title);
}

static fw_status make_report(const void *input, uint64_t *result, fw_error *e)
{
    char path[128];
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    snprintf(path, sizeof path, "%s/it.html", folders[SHORT_RUN]);
    const fw_report_wish wish = {.directory = input, .file = path, .cite = cite_nothing};
    const fw_status status = fw_report_make(&wish, nowhere, e);
    fclose(nowhere);
    if (status == FW_OK) *result = hash_of_file(path);
    if (status != FW_OK) assert_int_not_equal(access(path, F_OK), 0);
    return status;
}

static void a_report_says_what_it_misses(void **state)
{
    (void)state;
    assert_true(fail_each_allocation("report", make_report, folders[PAGE]) > 100);
}

static fw_status open_one(const void *input, uint64_t *result, fw_error *e)
{
    fw_plot_result opened;
    const fw_status status = fw_plot_result_open(&opened, input, e);
    if (status == FW_OK) *result = (uint64_t)opened.playback->frame_count;
    fw_plot_result_close(&opened);
    return status;
}

static void opening_says_what_it_misses(void **state)
{
    (void)state;
    assert_true(fail_each_allocation("open", open_one, folders[WAVES]) > 20);
}

static void run_file(const char *directory, const char *text, const char *settings)
{
    char line[512];
    write_scenario(directory, "file.yaml", text);
    snprintf(line, sizeof line, "run file.yaml -o . -q --no-plot %s", settings);
    assert_int_equal(run_program(directory, line).code, 0);
}

static int make_results(void **state)
{
    const int made = make_run(state);
    snprintf(folders[SHORT_RUN], sizeof folders[SHORT_RUN], "%s", folder);
    for (int n = BLOCK; n < RESULTS; ++n) make_quick_folder(folders[n], sizeof folders[n]);
    run_scenario(SLIDING_BLOCK "pictures: {where: {kind: slip}}\n", folders[BLOCK]);
    run_scenario(waves, folders[WAVES]);
    run_file(folders[PAGE], falling, "");
    run_file(folders[BEAMS], small_beams,
             "--set study.seeds=1 --set run.record-every=500 --set expect=[] --set "
             "measure=[temperature]");
    for (int n = 0; n < RESULTS; ++n)
        assert_fine(fw_plot_result_open(&results[n], folders[n], &error));
    return made;
}

static int remove_results(void **state)
{
    (void)state;
    for (int n = 0; n < RESULTS; ++n) {
        fw_plot_result_close(&results[n]);
        remove_folder(folders[n]);
    }
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_picture_says_what_it_misses),
        cmocka_unit_test(sweeps_say_what_they_miss),
        cmocka_unit_test(a_report_says_what_it_misses),
        cmocka_unit_test(opening_says_what_it_misses),
    };
    return cmocka_run_group_tests(tests, make_results, remove_results);
}
