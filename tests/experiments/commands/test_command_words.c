/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_command_words.c - what commands print, write and refuse, word for word, where no other test
 * has it: options one by one, names that a shell must quote, results that lack something. */
#include "tests/support/laws.h"

#include "experiments/commands/command.h"
#include "tests/support/program.h"

#include <stdlib.h>

static const char sheets[] =
    "title: two sheets\n"
    "units: {length: 0.25 nm, energy: 0.2 eV, mass: 63.5 u}\n"
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies:\n"
    "  one: {material: rubber, shape: {rectangle: [3, 2]}, velocity: [0.1, 0]}\n"
    "  two: {material: rubber, shape: {rectangle: [2, 2]}, origin: [9, 0]}\n"
    "run: {steps: 6, record-every: 3}\n"
    "record: {velocity: false}\n"
    "measure: [energy]\n";

#define SPECK                                                                                      \
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"                                     \
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}, velocity: [0.5, 0]}}\n"          \
    "run: {steps: 4}\n"

static const char swept[] = "title: swept\n" SPECK "expect: [{quantity: energy, above: 0}]\n"
                            "study: {sweep: {parameters: {v: {values: [0.1, 1e6]}}, set: "
                            "['bodies.speck.velocity=[v, 0]']}}\n";

/* Not one bit of noise, so the seeds have no error. */
static const char failing[] =
    "title: fails\n" SPECK "study: {seeds: 2}\nexpect: [{quantity: energy, above: 1}]\n";

static const char compared[] =
    "title: an automaton and its reference\n"
    "materials: {sheet: {elastic-automaton: {chopard: true}}}\n"
    "bodies: {block: {material: sheet, shape: {rectangle: [6, 4]}, velocities: [{random: .1}]}}\n"
    "run: {steps: 4}\n"
    "analysis: {twin: {boltzmann-reference: {body: block, half-steps: 8}}}\n";

static char folder[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "sheets.yaml", sheets);
    write_scenario(folder, "swept.yaml", swept);
    write_scenario(folder, "failing.yaml", failing);
    write_scenario(folder, "compared.yaml", compared);
    write_scenario(folder, "endless.yaml", "title: no line end\n" SPECK "# behind");
    const outcome seen = run_program(folder, "run sheets.yaml -q --no-plot -o done");
    expect_end(&seen, 0, "");
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

/* clang-format off */
static const struct {
    const char *line;
    int code;
    const char *err, *out; /* all of the one; what the other holds, and nothing where that is "" */
} rows[] = {
    /* units of nature, and what was not recorded */
    {"table done", 0, "", "# two sheets\n# units: steps,time = 0.4535041079 ps,energy = 0.2 eV\nstep,time,energy\n0,0,"},
    {"list done", 0, "", "\n  frames       3, with position\n  samples      7\n"},
    /* pictures that do not draw what is asked for */
    {"plot done --from 3", 2, "a picture of kind motion does not draw anything from one step until another", ""},
    {"plot done --until 3", 2, "a picture of kind motion does not draw anything from one step until another", ""},
    {"plot done --in-steps", 2, "a picture of kind motion does not draw anything over steps", ""},
    {"plot done --height 50", 2, "a picture of kind motion does not draw charts, whose height could be chosen", ""},
    {"plot done --level 2", 2, "a picture of kind motion does not draw a level", ""},
    {"plot done --level two", 2, "--level two, expected a number", ""},
    {"plot done --along v", 2, "a picture of kind motion does not draw anything along another number", ""},
    {"plot done --logarithmic", 2, "a picture of kind motion does not draw anything on logarithmic axes", ""},
    {"plot done --range 1,2", 2, "a picture of kind motion does not draw a range of colours", ""},
    {"plot done --body one", 2, "a picture of kind motion does not draw one body", ""},
    {"plot done --with done", 2, "a picture of kind motion does not draw several results", ""},
    {"plot done --range 1", 2, "--range 1, expected two numbers with a comma between them, the lower first", ""},
    {"plot done --x-range a,2", 2, "--x-range a,2, expected two numbers with a comma between them, the lower first", ""},
    {"plot done --y-range 2,2", 2, "--y-range 2,2, expected two numbers with a comma between them, the lower first", ""},
    {"plot done --at 3,", 2, "--at 3,, expected up to 1024 whole numbers with commas between them", ""},
    {"plot done --font-size 50", 2, "--font-size 50, expected a number from 4 to 40 points", ""},
    {"plot done --font-size 3", 2, "--font-size 3, expected a number from 4 to 40 points", ""},
    {"plot done --font-size big", 2, "--font-size big, expected a number from 4 to 40 points", ""},
    {"plot done --letter a.", 2, "--letter a., expected a letter or two, as a, B, ii or (a)", ""},
    {"plot done --letter abc", 2, "--letter abc, expected a letter or two, as a, B, ii or (a)", ""},
    {"plot done --letter (a", 2, "--letter (a, expected a letter or two, as a, B, ii or (a)", ""},
    {"plot done --bare", 0, "", "picture: done/motion.png\n"},
    {"plot done --letter (a)", 0, "", "picture: done/motion.png\n"},
    {"plot done --width 60", 0, "", "picture: done/motion.png\n"},
    {"plot done --palette grey", 0, "", "picture: done/motion.png\n"},
    {"plot done --x-range 0,2", 0, "", "picture: done/motion.png\n"},
    {"plot done --font-size 9", 0, "", "picture: done/motion.png\n"},
    /* cases of a sweep */
    {"sweep swept.yaml --list", 0, "", "fretwork sweep results/swept --case v=0.1\nfretwork sweep results/swept --case v=1000000\n"},
    {"sweep results/swept --case v=1000000 -q", 3, "case v=1000000: step 2: particle 0 of body speck is at (2e+06, 0) under the external force (0, 0), expected finite numbers within 1e+06 of (0, 0)", ""},
    {"sweep results/swept --case v=0.1 -q", 0, "", "v=0.1: finished\n"},
    {"sweep sheets.yaml --list", 2, "sheets has no study.sweep whose cases could be listed", ""},
    {"sweep nothing.yaml --list", 2, "nothing.yaml: cannot be opened: No such file or directory", ""},
    /* verdicts over seeds, without an end to what is printed */
    {"verify failing.yaml -q --json -", 1, "", "\"seeds\": 2,"},
    {"run failing.yaml -q2", 2, "fretwork run has no option -q2, expected one of `fretwork run --help`", ""},
    {"run failing.yaml -j1025", 2, "--threads 1025, expected a whole number from 1 to 1024", ""},
    {"run failing.yaml - -", 2, "- is one word too many, expected fretwork run NAME|FILE", ""},
    /* what is a name of the catalogue and of a folder */
    {"show chain", 0, "", "\nsource: Chopard & Marconi 2002, Fig. 4\n"},
    {"cite chain", 0, "", "@unpublished{chopard2002,"},
    {"cite compared.yaml", 0, "", "@inproceedings{salmon2011,"},
    {"show endless.yaml", 0, "", "run: {steps: 4}\n# behind\n"},
    /* keys by the places where any name stands */
    {"reference walls.N", 0, "", "walls: walls by name\n  value    names of your own, each with a mapping with one of box, polygon, circle, chain\n"},
    {"reference shape", 0, "", "bodies.NAME.shape: the sites it occupies\n"},
    {"quantities reference-error", 0, "", "  measured of  analysis\n  components   -\n  unit         length\n  models       boltzmann-reference\n"},
    {"-h", 0, "", "fretwork: contact and friction experiments on lattice solids\n\n  fretwork list"},
    {"help", 0, "", "fretwork: contact and friction experiments on lattice solids\n\n  fretwork list"},
    {"help table", 0, "", "fretwork table DIR\n  observables of a result as comma-separated values\n"},
};
/* clang-format on */

static void every_line_has_its_words(void **state)
{
    (void)state;
    int wrong = 0;
    shell(folder, "mkdir chain");
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char sentence[FW_SENTENCE_SIZE] = "";
        const outcome seen = run_program(folder, rows[n].line);
        if (rows[n].err[0]) snprintf(sentence, sizeof sentence, "fretwork: %s", rows[n].err);
        const bool out = rows[n].out[0] ? strstr(seen.out, rows[n].out) != NULL : !seen.out[0];
        const size_t length = strlen(sentence);
        const bool err = strncmp(seen.err, sentence, length) == 0 && (length > 0 || !seen.err[0]);
        if (seen.code == rows[n].code && out && err) continue;
        print_error("fretwork %s\n  exit %d: %s%s\n  expected exit %d: %s%s\n", rows[n].line,
                    seen.code, seen.err, seen.out, rows[n].code, rows[n].err, rows[n].out);
        wrong += 1;
    }
    assert_int_equal(wrong, 0);
}

/* A shell that reads what is listed runs the case of that folder. */
static void names_are_quoted_for_a_shell(void **state)
{
    (void)state;
    shell(folder, FW_PROGRAM " sweep swept.yaml --list -o \"it's a b\" > said");
    shell(folder, "test \"$(head -1 said)\" = \"fretwork sweep 'it'\\\\''s a b' --case v=0.1\"");
    shell(folder, "head -1 said | sed 's,^fretwork," FW_PROGRAM ",' | sh > ran 2> /dev/null");
    shell(folder, "test \"$(cat ran)\" = 'v=0.1: finished' && test -d \"it's a b/v=0.1\"");
}

/* What is to be said by an exit code is said, whatever becomes of the rest. */
static void a_full_disk_hides_no_verdict(void **state)
{
    (void)state;
    shell(folder, FW_PROGRAM " verify failing.yaml -q > /dev/full 2> said; test $? = 1");
    shell(folder, "test \"$(cat said)\" = 'fretwork: standard output cannot be written'");
    shell(folder, FW_PROGRAM " list > /dev/full 2> said; test $? = 4");
}

static void the_start_is_drawn_beside_its_numbers(void **state)
{
    (void)state;
    const outcome seen = run_program(folder, "check sheets.yaml --json -o start.svg");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "\"steps\": 6,"));
    shell(folder, "grep -q '</svg>' start.svg");
    const outcome refused = run_program(folder, "check sheets.yaml --json -o start.bmp");
    expect_end(&refused, 2,
               "fretwork: the picture 'start.bmp' cannot be drawn: its name has to end in .png, "
               ".svg or .pdf\n");
    assert_string_equal(refused.out, "");
}

/* --- more of something than there is room for --- */

static fw_status read_many(fw_arguments *arguments, const char *command, const char *word,
                           int count)
{
    static char *words[2048];
    static char text[64];
    fw_error own;
    strcpy(text, word);
    for (int n = 0; n < count; ++n) words[n] = text;
    const fw_status status =
        fw_arguments_read(arguments, fw_command_find(command), count, words, &own);
    if (status != FW_OK) error = own;
    return status;
}

static void more_than_there_is_room_for_is_refused(void **state)
{
    (void)state;
    static fw_arguments arguments;
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    assert_int_equal(read_many(&arguments, "list", "word", FW_WORDS_MAX), FW_OK);
    assert_int_equal(arguments.word_count, 1024);
    assert_int_equal(read_many(&arguments, "list", "word", FW_WORDS_MAX + 1), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "more than 1024 words");
    assert_int_equal(read_many(&arguments, "show", "--set=a=1", FW_SETTINGS_MAX + 1), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "more than 256 --set options");
    /* A seed needs room for two of its own. */
    arguments = (fw_arguments){.seed = 3};
    for (int n = 0; n < 255; ++n) arguments.settings.item[n] = "title=seeded";
    arguments.settings.count = 254;
    assert_fine(fw_command_load(&scenario, "chain", &arguments, name, &error));
    assert_string_equal(scenario->title, "seeded");
    assert_int_equal(scenario->run.seed, 3);
    fw_scenario_destroy(scenario);
    arguments.settings.count = 255;
    assert_refused(fw_command_load(&scenario, "chain", &arguments, name, &error), FW_BAD_INPUT,
                   "more than 254 --set options");
    assert_null(scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_line_has_its_words),
        cmocka_unit_test(names_are_quoted_for_a_shell),
        cmocka_unit_test(a_full_disk_hides_no_verdict),
        cmocka_unit_test(the_start_is_drawn_beside_its_numbers),
        cmocka_unit_test(more_than_there_is_room_for_is_refused),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
