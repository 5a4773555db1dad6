/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_column.c - which observables of a result names mean: of all or one body, with all components
 * or one, each once, in the order of the names. */
#include "tests/support/laws.h"

#include "experiments/measures/column.h"
#include "tests/support/scratch.h"

static fw_playback_observable observables[] = {
    {.name = "energy", .components = 1},
    {.name = "momentum.sheet", .components = 2},
    {.name = "momentum.rod", .components = 2},
    {.name = "heat-of-others", .components = 3}, /* of no quantity that this program knows */
};
static const fw_playback result = {.observables = observables, .observable_count = 4};

/* The names of what a list of names means, with blanks between them. */
static void expect_columns(const char *list, const char *wanted)
{
    char *text, found[512] = "";
    const char **names;
    int name_count, count;
    fw_column *columns;
    assert_fine(fw_column_names_read(list, &text, &names, &name_count, &error));
    assert_fine(fw_columns_find(&result, "it", names, name_count, &columns, &count, &error));
    for (int n = 0; n < count; ++n) {
        char name[FW_COLUMN_NAME];
        fw_column_name(&result, &columns[n], name);
        snprintf(found + strlen(found), sizeof found - strlen(found), "%s%s", n > 0 ? " " : "",
                 name);
    }
    assert_string_equal(found, wanted);
    free(columns);
    free(names);
    free(text);
}

static void names_mean_bodies_and_components(void **state)
{
    (void)state;
    expect_columns("energy", "energy");
    expect_columns("momentum.rod", "momentum.rod.x momentum.rod.y");
    expect_columns("momentum.rod.y", "momentum.rod.y");
    expect_columns("momentum", "momentum.sheet.x momentum.sheet.y momentum.rod.x momentum.rod.y");
    expect_columns("momentum.x", "momentum.sheet.x momentum.rod.x");
    expect_columns("heat-of-others", "heat-of-others.1 heat-of-others.2 heat-of-others.3");
}

static void what_is_meant_twice_stands_once(void **state)
{
    (void)state;
    expect_columns("momentum.rod.y,energy,momentum.rod,energy",
                   "momentum.rod.y energy momentum.rod.x");
}

static void no_names_mean_all(void **state)
{
    (void)state;
    int count;
    fw_column *columns;
    assert_fine(fw_columns_find(&result, "it", NULL, 0, &columns, &count, &error));
    assert_int_equal(count, 1 + 2 + 2 + 3);
    for (int n = 1, first = 0; n < count; ++n) {
        first = columns[n].observable == columns[n - 1].observable ? first : n;
        assert_int_equal(columns[n].component, n - first);
    }
    free(columns);
}

static void expect_refusal(const char *name, const char *words)
{
    int count;
    fw_column *columns;
    assert_refused(fw_columns_find(&result, "it", &name, 1, &columns, &count, &error), FW_BAD_INPUT,
                   words);
    free(columns);
}

static void what_is_not_there_is_refused(void **state)
{
    (void)state;
    expect_refusal("enrgy", "it has no observable enrgy; did you mean energy?");
    expect_refusal("elongation", "it: elongation was not measured");
    expect_refusal("momentum.rod.z", "it has no observable momentum.rod.z");
    expect_refusal("momentum.plate", "it has no observable momentum.plate");
    expect_refusal("heat-of-others.1", "it has no observable heat-of-others.1");
    expect_refusal("zzzzzzzzzzzzzz",
                   "expected one of energy, momentum.sheet, momentum.rod, heat-of-others");
    char *text;
    const char **names;
    assert_refused(fw_column_names_read("energy,,momentum", &text, &names, &(int){0}, &error),
                   FW_BAD_INPUT, "energy,,momentum");
    free(names);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_mean_bodies_and_components),
        cmocka_unit_test(what_is_meant_twice_stands_once),
        cmocka_unit_test(no_names_mean_all),
        cmocka_unit_test(what_is_not_there_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
