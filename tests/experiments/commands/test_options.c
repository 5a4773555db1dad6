/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_options.c - rows of options: each value arrives where its row says, and nowhere else. */
#include "tests/support/laws.h"

#include "experiments/commands/command.h"
#include "tests/support/program.h"

static void read_line(fw_arguments *arguments, const char *command, char **words, int count)
{
    assert_fine(fw_arguments_read(arguments, fw_command_find(command), count, words, &error));
}

static void every_value_goes_where_its_row_says(void **state)
{
    static fw_arguments a;
    (void)state;
    char *run[] = {"--set", "a=1", "it", "-j", "3", "--set=b=2", "-q", "-o", "d"};
    read_line(&a, "run", run, 9);
    assert_int_equal(a.settings.count, 2);
    assert_string_equal(a.settings.item[0], "a=1");
    assert_string_equal(a.settings.item[1], "b=2");
    assert_int_equal(a.threads, 3);
    assert_int_equal(a.seed, -1);
    assert_string_equal(a.output, "d");
    assert_true(a.quiet && !a.overwrite && !a.no_plot && !a.help);
    assert_int_equal(a.word_count, 1);
    /* A short name may have its value behind it at once. */
    char *close[] = {"it", "-j2", "-od=3", "-q"};
    read_line(&a, "run", close, 4);
    assert_int_equal(a.threads, 2);
    assert_string_equal(a.output, "d=3");
    assert_true(a.quiet);
    char *wrong[] = {"it", "-qj"};
    assert_refused(fw_arguments_read(&a, fw_command_find("run"), 2, wrong, &error), FW_BAD_INPUT,
                   "has no option -qj");
    /* Behind -- there are words only. */
    char *verify[] = {"-q", "--", "--set", "-"};
    read_line(&a, "verify", verify, 4);
    assert_int_equal(a.word_count, 2);
    assert_string_equal(a.words[0], "--set");
    assert_true(a.quiet && a.settings.count == 0);
    char *plot[] = {"d",  "--kind",       "motion", "--at",      "1,2", "--field",
                    "f",  "--observable", "energy", "--picture", "p",   "--logarithmic",
                    "-o", "x.png"};
    read_line(&a, "plot", plot, 14);
    assert_string_equal(a.kind, "motion");
    assert_string_equal(a.at, "1,2");
    assert_string_equal(a.field, "f");
    assert_string_equal(a.observable, "energy");
    assert_string_equal(a.picture, "p");
    assert_string_equal(a.output, "x.png");
    assert_true(a.logarithmic && !a.quiet);
}

/* Two rows of one command never share a name or a place, and every one has words for the help. */
static void rows_of_a_command_do_not_collide(void **state)
{
    (void)state;
    for (const fw_command *c = fw_commands; c->name; ++c) {
        int count = 0;
        for (int n = 0; c->options[n]; ++n, ++count) {
            const fw_option *o = c->options[n];
            assert_true(strncmp(o->name, "--", 2) == 0 && *o->meaning);
            assert_true((o->form == FW_OPTION_FLAG) == (o->value == NULL));
            if (o->form == FW_OPTION_COUNT) assert_true(o->least < o->most);
            for (int m = 0; m < n; ++m) {
                assert_string_not_equal(o->name, c->options[m]->name);
                assert_true(o->at != c->options[m]->at);
                if (o->brief && c->options[m]->brief)
                    assert_string_not_equal(o->brief, c->options[m]->brief);
            }
        }
        assert_true(count <= FW_OPTIONS_MAX);
        assert_ptr_equal(c->options[count - 1], &fw_option_help);
        assert_true(c->run && *c->usage && *c->summary);
    }
}

/* A line for each row of a command, in their order: names, value, and what it is for. */
static void help_says_of_each_option_what_its_row_says(void **state)
{
    (void)state;
    for (const fw_command *c = fw_commands; c->name; ++c) {
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        fw_option_print(out, c);
        fclose(out);
        char *rest = text;
        for (int n = 0; c->options[n]; ++n) {
            const fw_option *o = c->options[n];
            char *line = strsep(&rest, "\n"), left[64];
            assert_non_null(rest);
            snprintf(left, sizeof left, "%s%s%s%s%s ", o->brief ? o->brief : "",
                     o->brief ? ", " : "", o->name, o->value ? " " : "", o->value ? o->value : "");
            assert_true(strncmp(line, "  ", 2) == 0);
            assert_true(strncmp(line + 2, left, strlen(left)) == 0);
            assert_string_equal(line + 2 + strlen(left) + strspn(line + 2 + strlen(left), " "),
                                o->meaning);
        }
        assert_string_equal(rest, "");
        free(text);
    }
}

/* Each command's section is its summary and its options in their order, but for --help. */
static void the_manual_page_says_what_the_rows_say(void **state)
{
    (void)state;
    char *page = NULL, *section = NULL, *line = NULL;
    size_t size = 0, room = 0;
    FILE *made = popen("'" FW_PROGRAM "' manual-page | sed 's/\\\\-/-/g'", "r");
    FILE *kept = open_memstream(&page, &size);
    assert_true(made && kept);
    while (getline(&line, &room, made) > 0) fputs(line, kept);
    assert_int_equal(pclose(made), 0);
    fclose(kept);
    free(line);
    for (const fw_command *c = fw_commands; c->name; ++c) {
        if (c->hidden) continue;
        FILE *wanted = open_memstream(&section, &size);
        fprintf(wanted, ".SS \"fretwork %s\"\n%s.\n", c->usage, c->summary);
        for (int n = 0; c->options[n] != &fw_option_help; ++n) {
            char left[64];
            fw_option_usage(c->options[n], left);
            fprintf(wanted, ".TP\n.B %s\n%s\n", left, c->options[n]->meaning);
        }
        fprintf(wanted, ".S");
        fclose(wanted);
        if (!strstr(page, section)) fail_msg("the page does not have\n%s", section);
        free(section);
    }
    for (const fw_exit_code *e = fw_exit_codes; e->code >= 0; ++e) {
        char wanted[256];
        snprintf(wanted, sizeof wanted, "\n.B %d\n%s\n", e->code, e->meaning);
        if (!strstr(page, wanted)) fail_msg("the page does not have%s", wanted);
    }
    free(page);
}

static const char study[] = "title: a gas that warms\n"
                            "materials: {gas: {movable-particles: {strength: 0}}}\n"
                            "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}}}\n"
                            "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
                            "run: {steps: 20}\n"
                            "study: {seeds: 3}\n"
                            "expect: [{quantity: kinetic-energy, above: 0}]\n";

/* The scenario as run says so, and the numbers are those that the study had for this seed. */
static void a_seed_makes_one_run_of_a_study(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", study);
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o all");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "(3 seeds)"));
    seen = run_program(folder, "run gas.yaml -q --no-plot --seed 2 -o one");
    expect_end(&seen, 0, "");
    assert_null(strstr(seen.out, "seeds)"));
    shell(folder, "head -1 one/summary.csv | grep -q 'since,seed 2$'");
    shell(folder, "grep -q '^[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,'\"$(" FW_PROGRAM
                  " table one --observable kinetic-energy | tail -1 | cut -d, -f3)"
                  "\", all/summary.csv");
    seen = run_program(folder, "check gas.yaml --seed 2");
    expect_end(&seen, 0, "");
    assert_null(strstr(seen.out, "seeds"));
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_goes_where_its_row_says),
        cmocka_unit_test(rows_of_a_command_do_not_collide),
        cmocka_unit_test(help_says_of_each_option_what_its_row_says),
        cmocka_unit_test(the_manual_page_says_what_the_rows_say),
        cmocka_unit_test(a_seed_makes_one_run_of_a_study),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
