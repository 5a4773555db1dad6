/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_rerun.c - a result gives itself again from its file alone; where it does not, what differs
 * is named. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

#include "experiments/results/compare.h"

static const char scenario[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 20, record-every: 2, seed: 7}\n"
    "record: {fields: [local-order]}\n"
    "measure: [energy, momentum]\n"
    "expect: [{quantity: energy, above: 1e9}]\n";

static void make_result(char folder[64])
{
    make_quick_folder(folder, 64);
    write_scenario(folder, "file.yaml", scenario);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 1, ""); /* what is expected fails, which is another question */
    shell(folder, "rm file.yaml");
}

static void a_result_gives_itself_again(void **state)
{
    (void)state;
    char folder[64];
    make_result(folder);
    outcome seen = run_program(folder, "rerun out --no-plot --quiet -j 2");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "out and out-again are the same, bit by bit"));
    shell(folder, "mv out/trajectory.h5 alone.h5");
    seen = run_program(folder, "rerun alone.h5 -o new --no-plot --quiet");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "alone.h5 and new are the same, bit by bit"));
    remove_folder(folder);
}

static void what_differs_is_named(void **state)
{
    (void)state;
    char folder[64], arguments[128];
    make_result(folder);
    snprintf(arguments, sizeof arguments, "%s/out/trajectory.h5 3 1e-9", folder);
    const int status = run_python("changed.py", arguments);
    if (status == 0) {
        const outcome seen = run_program(folder, "rerun out --no-plot --quiet");
        expect_end(&seen, 1, "");
        assert_non_null(strstr(seen.out, "out and out-again differ"));
        assert_non_null(
            strstr(seen.out, "position differs from frame 3 (step 6) on, by up to 1e-09"));
        assert_non_null(strstr(seen.out, "nothing that the results know of"));
        assert_null(strstr(seen.out, "velocity differs"));
    }
    remove_folder(folder);
    skip_unseen();
}

/* Of several differences the first is named, and the largest, wherever that is. */
static void the_first_difference_is_named_and_the_largest(void **state)
{
    (void)state;
    static const char *const changes[] = {"3 1e-9", "5 1e-6", "7 1e-8"};
    char folder[64], arguments[128];
    int status = 0;
    make_result(folder);
    for (int n = 0; n < 3 && status == 0; ++n) {
        snprintf(arguments, sizeof arguments, "%s/out/trajectory.h5 %s", folder, changes[n]);
        status = run_python("changed.py", arguments);
    }
    if (status == 0) {
        const outcome seen = run_program(folder, "rerun out --no-plot --quiet");
        expect_end(&seen, 1, "");
        assert_non_null(
            strstr(seen.out, "position differs from frame 3 (step 6) on, by up to 1e-06"));
    }
    remove_folder(folder);
    skip_unseen();
}

/* The same motion, recorded otherwise. */
static void what_is_only_in_one_is_named(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"record.velocity=false", "  velocity is only in one of them\n"},
        {"measure=[energy]", "  observables: 2 and 1\n"}};
    char folder[64], text[128];
    make_result(folder);
    write_scenario(folder, "file.yaml", scenario);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_playback *one, *other;
        char *said = NULL;
        size_t size;
        int differing;
        snprintf(text, sizeof text, "run file.yaml -o other --overwrite --no-plot --quiet --set %s",
                 cases[n][0]);
        const outcome seen = run_program(folder, text);
        expect_end(&seen, 1, "");
        snprintf(text, sizeof text, "%s/out", folder);
        assert_int_equal(fw_playback_open(&one, text, &error), FW_OK);
        snprintf(text, sizeof text, "%s/other", folder);
        assert_int_equal(fw_playback_open(&other, text, &error), FW_OK);
        FILE *out = open_memstream(&said, &size);
        assert_int_equal(fw_compare(one, other, out, &differing, &error), FW_OK);
        fclose(out);
        assert_string_equal(said, cases[n][1]);
        assert_int_equal(differing, 1);
        free(said);
        fw_playback_close(one);
        fw_playback_close(other);
    }
    remove_folder(folder);
}

static void rerun_refuses_what_it_cannot_do(void **state)
{
    (void)state;
    static const char *const refused[][2] = {{"rerun nothing", "nothing"},
                                             {"rerun out/trajectory.h5", "expected -o DIR"},
                                             {"rerun out -o out", "--overwrite"}};
    char folder[64];
    make_result(folder);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n) {
        const outcome seen = run_program(folder, refused[n][0]);
        expect_end(&seen, 2, refused[n][1]);
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_result_gives_itself_again),
        cmocka_unit_test(what_differs_is_named),
        cmocka_unit_test(the_first_difference_is_named_and_the_largest),
        cmocka_unit_test(what_is_only_in_one_is_named),
        cmocka_unit_test(rerun_refuses_what_it_cannot_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
