/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scenario_pieces_short_memory.c - of every experiment of the catalogue, of settings and of
 * places from a file, each piece that they are read into is once the one that is missing: it is
 * said, and leaves no memory behind. test_scenario_short_memory.c asks the same of the blocks that
 * pieces are cut from. */
#include "tests/support/short_memory.h"

#include "experiments/measures/measurement.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/storage/checksum.h"
#include "tests/support/scratch.h"

void *__real_fw_document_allocate(fw_document *document, size_t count, size_t size);
void *__wrap_fw_document_allocate(fw_document *document, size_t count, size_t size);
void *__wrap_fw_document_allocate(fw_document *document, size_t count, size_t size)
{
    return short_memory_fails_here() ? NULL : __real_fw_document_allocate(document, count, size);
}

const char *__real_fw_document_copy(fw_document *document, const char *text, size_t length);
const char *__wrap_fw_document_copy(fw_document *document, const char *text, size_t length);
const char *__wrap_fw_document_copy(fw_document *document, const char *text, size_t length)
{
    return short_memory_fails_here() ? NULL : __real_fw_document_copy(document, text, length);
}

/* --- reading --- */

typedef struct written {
    const char *file, *text;
    const char *settings[4];
    int setting_count;
} written;

static fw_status read_written(fw_scenario **scenario, const written *from, fw_error *failed)
{
    return fw_scenario_read(scenario, from->file, from->text, strlen(from->text), from->settings,
                            from->setting_count, failed);
}

/* The scenario as run, and of a sweep its first case. */
static fw_status read_scenario(const void *input, uint64_t *hash, fw_error *failed)
{
    fw_scenario *scenario, *first = NULL;
    char *text = NULL;
    FW_TRY(read_written(&scenario, input, failed));
    fw_status status = fw_scenario_print(scenario, &text, failed);
    if (status == FW_OK) *hash = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, text, strlen(text));
    free(text);
    if (status == FW_OK && fw_scenario_is_sweep(scenario))
        status = fw_scenario_read_case(&first, scenario, 0, failed);
    fw_scenario_destroy(first);
    fw_scenario_destroy(scenario);
    return status;
}

static void every_experiment_is_read_or_not(void **state)
{
    (void)state;
    int refused = 0;
    for (const fw_catalogue_entry *entry = fw_catalogue; entry->name; ++entry) {
        const written from = {.text = entry->text};
        refused += fail_each_place(entry->name, read_scenario, &from);
    }
    assert_true(refused > 50);
}

static void settings_are_done_or_not(void **state)
{
    (void)state;
    const fw_catalogue_entry *entry;
    assert_fine(fw_catalogue_find(&entry, "friction", &error));
    const written from = {
        .text = entry->text,
        .settings = {"run.seed=7", "measure=[energy]", "measure.1=momentum", NULL},
        .setting_count = 3};
    fail_each_place("settings", read_scenario, &from);
}

/* Places from a file beside the scenario. */
static void places_of_a_file_are_read_or_not(void **state)
{
    (void)state;
    char folder[64], path[96], name[96];
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/places.xyz", folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs("3\nthree places\nA 0 0 0\nA 2 0 0\nA 0 2 0\n", out);
    assert_int_equal(fclose(out), 0);
    snprintf(name, sizeof name, "%s/scenario.yaml", folder);
    const written from = {.file = name,
                          .text = "title: places\nmaterials: {m: {movable-particles: {}}}\n"
                                  "bodies: {b: {material: m, shape: {file: places.xyz}}}\n"
                                  "run: {steps: 1}\n"};
    assert_true(fail_each_place("places", read_scenario, &from) > 0);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_experiment_is_read_or_not),
        cmocka_unit_test(settings_are_done_or_not),
        cmocka_unit_test(places_of_a_file_are_read_or_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
