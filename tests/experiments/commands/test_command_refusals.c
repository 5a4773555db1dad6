/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_command_refusals.c - bad input at the command line: what each gets, and that it leaves
 * nothing behind. test_refusals.c has the sentences of scenario files alone. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char bounce[] = "title: a sheet bounces\n"
                             "materials:\n"
                             "  rubber: {lattice-boltzmann: {rest-mass: 0, damping: 0}}\n"
                             "  dust: {lattice-boltzmann: {rest-mass: 1}}\n"
                             "bodies:\n"
                             "  sheet: {material: rubber, shape: {rectangle: [6, 6]}, origin: "
                             "[1.3, 2.7], velocity: [0.1, 0.05]}\n"
                             "  speck: {material: dust, shape: {rectangle: [1, 1]}, origin: [15.3, "
                             "15.7], velocity: [0.1, 0]}\n"
                             "walls:\n"
                             "  container: {box: [0, 0, 20, 20]}\n"
                             "run: {steps: 60, record-every: 5, checkpoint-every: 10}\n"
                             "record: {fields: [speed]}\n"
                             "measure: [energy, momentum, wall-energy]\n"
                             "expect:\n"
                             "  - {quantity: energy-drift, statistic: largest, below: 1e-12}\n";

/* Files and folders that are not what they should be. */
static const char *const mess[] = {
    ": > empty.yaml",
    "mkdir folder.yaml empty foreign stub",
    "printf 'title: x\\n' > short.yaml",
    "printf '\\177ELF\\002\\001' > binary.yaml",
    "printf '\\377\\376t\\0i\\0' > utf16.yaml",
    "printf 'run: {steps: 5\\n' > cut.yaml",
    "printf 'title: \"a\\n' > quote.yaml",
    "printf 'title: &x 1\\nabout: *x\\n' > anchor.yaml",
    "printf 'title: a\\ntitle: b\\n' > twice.yaml",
    "printf 'title: a\\n  about: b\\n' > indent.yaml",
    "printf 'title: a\\n---\\ntitle: b\\n' > two.yaml",
    "printf 'a: %s\\n' $(printf '[%.0s' $(seq 100)) > deep.yaml",
    "ln -s nowhere.yaml link.yaml",
    "echo text > foreign/trajectory.h5",
    "touch stub/trajectory.h5.new",
    "cp -r done torn && head -c 20000 done/trajectory.h5 > torn/trajectory.h5",
    "cp -r lost bare && rm bare/checkpoint-?",
    "cp -r lost hurt && echo x > hurt/checkpoint-A && echo x > hurt/checkpoint-B",
    "cp lost/checkpoint-? other",
};

typedef struct refusal {
    const char *line;
    int code;
    const char *sentence; /* all of it; up to a '*' where that ends it */
} refusal;

/* clang-format off */
static const refusal refusals[] = {
    /* words and options */
    {"bounce", 2, "no command bounce, expected one of `fretwork --help`"},
    {"rum bounce.yaml", 2, "no command rum; did you mean run?"},
    {"run", 2, "expected fretwork run NAME|FILE"},
    {"run bounce.yaml chain", 2, "chain is one word too many, expected fretwork run NAME|FILE"},
    {"run wall-bonce", 2, "there is no experiment 'wall-bonce'; did you mean 'wall-bounce'?"},
    {"run xylophone", 2, "there is no experiment 'xylophone', expected one that `fretwork list` shows, or a scenario file"},
    {"show wall-bonce", 2, "there is no experiment 'wall-bonce'; did you mean 'wall-bounce'?"},
    {"list friction xylophone", 2, "no experiment speaks of 'friction xylophone', expected words of those that `fretwork list` shows"},
    {"list frictoin", 2, "no experiment speaks of 'frictoin'; did you mean 'friction'?"},
    {"list --json xylophone", 2, "no experiment speaks of 'xylophone', expected words of those that `fretwork list` shows"},
    {"quantities energi", 2, "there is no quantity and no field 'energi'; did you mean 'energy'?"},
    {"quantities xylophone --json", 2, "there is no quantity and no field 'xylophone', and none speaks of it; expected one of `fretwork quantities`"},
    {"quantities heat momentum", 2, "there is no quantity and no field 'heat momentum', and none speaks of it; expected one of `fretwork quantities`"},
    {"run friction.yaml", 2, "there is no file friction.yaml; the experiment friction is called without .yaml, `fretwork show friction > friction.yaml` makes the file"},
    {"reference run.step", 2, "no key is called 'run.step'; did you mean 'steps'?"},
    {"reference walls.floor.pth --json", 2, "no key is called 'walls.floor.pth'; did you mean 'path'?"},
    {"reference ''", 2, "no key is called '', and none speaks of it; expected the name or path of one that `fretwork reference` lists"},
    {"verify dampng", 2, "there is no experiment 'dampng'; did you mean 'damping'?"},
    {"run bounce.yaml --thread 2", 2, "fretwork run has no option --thread; did you mean --threads?"},
    {"run bounce.yaml --threads 0", 2, "--threads 0, expected a whole number from 1 to 1024"},
    {"run bounce.yaml --threads 1.5", 2, "--threads 1.5, expected a whole number from 1 to 1024"},
    {"run bounce.yaml --threads", 2, "--threads comes last, expected N behind it"},
    {"run bounce.yaml --seed x", 2, "--seed x, expected a whole number from 0 to 1000000000000"},
    {"run bounce.yaml --seed -1", 2, "--seed -1, expected a whole number from 0 to 1000000000000"},
    {"run bounce.yaml -o one -o two", 2, "--output is given a second time, as two"},
    {"run bounce.yaml --seed 1 --seed=2", 2, "--seed is given a second time, as 2"},
    {"run bounce.yaml --set run.seed=999999999999 --set 'study={seeds: 3}'", 2, "--set study={seeds: 3}: study.seeds is 3 and run.seed 999999999999, expected the last of the seeds to be at most 1000000000000"},
    {"run bounce.yaml --quiet=yes", 2, "--quiet takes no value, but has yes"},
    {"run bounce.yaml -x", 2, "fretwork run has no option -x, expected one of `fretwork run --help`"},
    {"run bounce.yaml -o ''", 2, "the results folder has no name"},
    /* values, by --set */
    {"run bounce.yaml --set bodies.sheet.velocity=[nan,0]", 2, "--set bodies.sheet.velocity=[nan,0]: bodies.sheet.velocity.0 is 'nan', expected a number, finite and at most 1e+15 in size"},
    {"run bounce.yaml --set bodies.sheet.velocity=[.inf,0]", 2, "--set bodies.sheet.velocity=[.inf,0]: bodies.sheet.velocity.0 is '.inf', expected a number, finite and at most 1e+15 in size"},
    {"run bounce.yaml --set bodies.sheet.velocity=[0.1x,0]", 2, "--set bodies.sheet.velocity=[0.1x,0]: bodies.sheet.velocity.0 is '0.1x', expected a number"},
    {"run bounce.yaml --set bodies.sheet.velocity=[0]", 2, "--set bodies.sheet.velocity=[0]: bodies.sheet.velocity is a list of 1, expected [x, y], each a number"},
    {"run bounce.yaml --set bodies.sheet.velocty=[0,0]", 2, "--set bodies.sheet.velocty=[0,0]: unknown key 'velocty' in bodies.sheet; did you mean 'velocity'?"},
    {"run bounce.yaml --set bodies.shet.velocity=[0,0]", 2, "--set bodies.shet.velocity=[0,0]: there is no 'shet' in bodies; did you mean 'sheet'?"},
    {"run bounce.yaml --set run.steps=1e3", 2, "--set run.steps=1e3: run.steps is '1e3', expected a whole number of at least 1, written without point, exponent or leading zeros"},
    {"run bounce.yaml --set run.steps=0", 2, "--set run.steps=0: run.steps is '0', expected a whole number of at least 1"},
    {"run bounce.yaml --set run.steps", 2, "--set run.steps: expected KEY=VALUE, such as run.steps=1000"},
    {"run bounce.yaml --set run.steps=", 2, "--set run.steps=: nothing is written there, expected a value after '='"},
    {"run bounce.yaml --set 'walls.container.box=[0, 0'", 2, "--set walls.container.box=[0, 0: a ',' or the closing ']' is missing"},
    {"run bounce.yaml --set materials.rubber.lattice-boltzmann.damping=0.5", 2, "--set materials.rubber.lattice-boltzmann.damping=0.5: materials.rubber.lattice-boltzmann.damping is '0.5', expected a number from 0 to below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"run bounce.yaml --set materials.rubber.lattice-boltzmann.damping=1.1", 2, "--set materials.rubber.lattice-boltzmann.damping=1.1: materials.rubber.lattice-boltzmann.damping is '1.1', expected a number from 0 to below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"run bounce.yaml --set materials.rubber.lattice-boltzmann.rest-mass=[[1,2],[3,4]]", 2, "--set materials.rubber.lattice-boltzmann.rest-mass=[[1,2],[3,4]]: materials.rubber.lattice-boltzmann.rest-mass is a matrix with 2 to the right of 1 on its diagonal but 3 below it, expected a symmetric one: any other would create energy from nothing"},
    {"run bounce.yaml --set bodies.speck.material=rubber", 2, "bounce.yaml:7:3: body speck: site [0, 0] has no links and a rest mass that leaves it without mass, expected a rest mass that is not singular"},
    {"run bounce.yaml --set bodies.sheet.lattice=hexagonal", 2, "--set bodies.sheet.lattice=hexagonal: bodies.sheet.lattice is 'hexagonal', expected 'square': the lattice Boltzmann solid has four links per site"},
    {"run bounce.yaml --set bodies.sheet.material=felt", 2, "--set bodies.sheet.material=felt: there is no material 'felt', expected one that the scenario names, such as 'rubber'"},
    /* what does not fit together */
    {"run bounce.yaml --set bodies.sheet.origin=[16.2,3]", 2, "bounce.yaml:9:3: body sheet starts in wall container: particle 5 at (21.2, 3) lies 1.2 behind its surface, expected all particles on the free side"},
    {"run bounce.yaml --set bodies.speck.origin=[2.4,2.9]", 2, "bounce.yaml:7:3: body speck starts in body sheet: at its particle 0 near (2.4, 2.9) it lies 0.2 inside, expected bodies side by side"},
    {"run bounce.yaml --set 'walls.flat={polygon: [[0,0],[1,0],[2,0]]}'", 2, "--set walls.flat={polygon: [[0,0],[1,0],[2,0]]}: wall 'flat': the polygon of 3 corners has an area of 0 at a circumference of 4, expected corners that do not lie on a line"},
    {"run bounce.yaml --set 'walls.bent={polygon: [[0,0],[10,0],[5,1],[5,10]]}'", 2, "--set walls.bent={polygon: [[0,0],[10,0],[5,1],[5,10]]}: wall 'bent': the polygon is not convex at corner 3, [5, 1]; a closed chain can have any corners"},
    {"run bounce.yaml --set 'walls.ball={circle: [0,0,0]}'", 2, "--set walls.ball={circle: [0,0,0]}: wall 'ball': the radius is 0, expected more than 0"},
    {"run bounce.yaml --set 'forces.push={body: shet, force: [1,0]}'", 2, "--set forces.push={body: shet, force: [1,0]}: there is no body 'shet'; did you mean 'sheet'?"},
    {"run bounce.yaml --set 'forces.push={body: sheet, sites: [[6,6]], force: [1,0]}'", 2, "--set forces.push={body: sheet, sites: [[6,6]], force: [1,0]}: site [6, 6] is not one of body 'sheet', whose sites lie in columns 0 to 5 and rows 0 to 5"},
    {"run bounce.yaml --set record.fields=[sped]", 2, "--set record.fields=[sped]: no body has a field sped; did you mean speed?"},
    {"run friction-control --set expect.0.quantity=layer-contact-over-control", 2, "--set expect.0.quantity=layer-contact-over-control: layer-contact-over-control is measured against a control, and the study has none"},
    {"run friction --set study.control=[run.stepz=3]", 2, "--set study.control=[run.stepz=3]: control: --set run.stepz=3: unknown key 'stepz' in run; did you mean 'steps'?"},
    {"run bounce.yaml --set bodies.sheet.shape.rectangle=14,8", 2, "--set bodies.sheet.shape.rectangle=14,8: bodies.sheet.shape.rectangle is '14,8' without brackets, expected [columns, rows], each a whole number of at least 1"},
    {"run bounce.yaml --set record.fields=[colour]", 2, "--set record.fields=[colour]: no body has a field colour, expected one of those that `fretwork quantities` lists"},
    {"run bounce.yaml --set measure=[enrgy]", 2, "--set measure=[enrgy]: quantity enrgy is not known; did you mean energy?"},
    {"run bounce.yaml --set expect.0.quantity=colour", 2, "--set expect.0.quantity=colour: quantity colour is not known, expected one of `fretwork quantities`"},
    {"run bounce.yaml --set 'expect.1={quantity: energy, at: 31, above: 0}' --set run.measure-every=2", 2, "--set expect.1={quantity: energy, at: 31, above: 0}: the expectation of 'energy' is at step 31, but the run ends at 60 and measures at multiples of 2"},
    {"run bounce.yaml --set 'expect.1={quantity: energy, at: 61, above: 0}'", 2, "--set expect.1={quantity: energy, at: 61, above: 0}: the expectation of 'energy' is at step 61, but the run ends at 60 and measures at multiples of 1"},
    {"run bounce.yaml --set run.limit=5", 2, "bounce.yaml:7:3: body speck starts beyond run.limit: particle 0 at (15.3, 15.7), expected all within 5 of (1.3, 2.7)"},
    {"check bounce.yaml --set bodies.sheet.origin=[16.2,3]", 2, "bounce.yaml:9:3: body sheet starts in wall container: particle 5 at (21.2, 3) lies 1.2 behind its surface, expected all particles on the free side"},
    {"verify bounce.yaml --set measure=[enrgy]", 2, "--set measure=[enrgy]: quantity enrgy is not known; did you mean energy?"},
    /* scenario files */
    {"run nothing.yaml", 2, "nothing.yaml: cannot be opened: No such file or directory"},
    {"run folder.yaml", 2, "folder.yaml: cannot be read: Is a directory"},
    {"run ./empty.yaml", 2, "./empty.yaml:1:1: nothing is written there, expected a scenario"},
    {"run short.yaml", 2, "short.yaml:1:1: the scenario has no 'materials', which a scenario must have"},
    {"run binary.yaml", 2, "binary.yaml:1:1: a control character (hexadecimal 7F), expected plain text in UTF-8"},
    {"run utf16.yaml", 2, "utf16.yaml:1:1: a byte that is not UTF-8 text (hexadecimal FF), expected plain text in UTF-8"},
    {"run cut.yaml", 2, "cut.yaml:2:1: a ',' or the closing '}' is missing (in the mapping {...} that begins in line 1)"},
    {"run quote.yaml", 2, "quote.yaml:2:1: the file ends before the closing quote (in the quoted text that begins in line 1)"},
    {"run anchor.yaml", 2, "anchor.yaml:1:8: an anchor '&x'; a scenario is written out in full, without anchors and aliases"},
    {"run twice.yaml", 2, "twice.yaml:2:1: 'title' is given a second time, after line 1"},
    {"run indent.yaml", 2, "indent.yaml:2:8: a ':' cannot stand here; a text with ': ' in it needs quotes, and lines of one mapping begin in one column: look at the line before too"},
    {"run two.yaml", 2, "two.yaml:2:1: a second document begins, expected one scenario in a file"},
    {"run deep.yaml", 2, "deep.yaml:1:27: lists and mappings within each other more than 24 deep"},
    {"run link.yaml", 2, "link.yaml: cannot be opened: No such file or directory"},
    {"run short.yaml/x", 2, "short.yaml/x: cannot be opened: Not a directory"},
    {"run ./done/trajectory.h5", 2, "./done/trajectory.h5:1:1: a byte that is not UTF-8 text (hexadecimal 89), expected plain text in UTF-8"},
    /* folders and results */
    {"run bounce.yaml -o done", 2, "done holds a result already; --overwrite replaces it, -o DIR puts the new one elsewhere"},
    {"run bounce.yaml -o short.yaml", 2, "cannot open the folder short.yaml: Not a directory"},
    {"run bounce.yaml -o short.yaml/x", 2, "cannot make the folder short.yaml/x: Not a directory"},
    {"run bounce.yaml -o /proc/none/x", 4, "cannot make the folder /proc/none/x: No such file or directory"},
    {"resume", 2, "expected fretwork resume DIR"},
    {"resume done", 2, "done: the run is finished, there is nothing to resume"},
    {"resume lost --set run.steps=3", 2, "fretwork resume has no option --set, expected one of `fretwork resume --help`"},
    {"resume nothing", 2, "cannot open the folder nothing: No such file or directory"},
    {"resume short.yaml", 2, "cannot open the folder short.yaml: Not a directory"},
    {"resume empty", 2, "empty holds no results; a run that ended before it had laid them out is started again with `fretwork run`"},
    {"resume stub", 2, "stub holds no results; a run that ended before it had laid them out is started again with `fretwork run`"},
    {"resume foreign", 2, "foreign/trajectory.h5 is not a whole HDF5 file"},
    {"resume torn", 2, "torn/trajectory.h5 is not a whole HDF5 file"},
    {"resume bare", 2, "bare holds 3 frames but no checkpoint to go on from; `fretwork run --overwrite` computes all of them anew"},
    {"resume hurt", 2, "none of two checkpoints can be used: hurt/checkpoint-A is cut short: it has 2 bytes"},
    {"resume other", 2, "other/checkpoint-B: the checkpoint belongs to another scenario"},
    {"table nothing", 2, "cannot open nothing: No such file or directory"},
    {"table foreign", 2, "foreign/trajectory.h5 is not a whole HDF5 file"},
    {"table done --observable enrgy", 2, "done has no observable enrgy; did you mean energy?"},
    {"table done --observable energy,", 2, "--observable energy,, expected names with commas between them"},
    {"table done --observable friction-heat", 2, "done: friction-heat was not measured; to have it, name it under measure and run again"},
    {"table done -o nowhere/x.csv", 4, "cannot write 'nowhere/x.csv' *"},
    {"plot done --field enrgy", 2, "done: there is no field enrgy; did you mean energy? It was not recorded, name it under record.fields and run again"},
    {"plot done --field spead", 2, "done has no field spead; did you mean speed?"},
    {"plot done --observable wall-energy --logarithmic", 2, "done: wall-energy goes from 0 to 0, expected values above 0 on a logarithmic axis"},
    {"plot nothing", 2, "cannot open nothing: No such file or directory"},
    {"plot done --kind pie", 2, "no pictures of kind pie, expected one of motion, *"},
    {"plot done --at x", 2, "--at x, expected up to 1024 whole numbers with commas between them"},
    {"check bounce.yaml -o x.jpg", 2, "the picture 'x.jpg' cannot be drawn: its name has to end in .png, .svg or .pdf"},
    {"check bounce.yaml -o nowhere/x.png", 4, "cannot write 'nowhere/x.png' *"},
    {"verify bounce.yaml -q --json nowhere/x.json", 4, "cannot write 'nowhere/x.json' *"},
};
/* clang-format on */

/* Every name below the folder with size, number and time of its last change. */
static void take_stock(const char *folder, char *stock, size_t size)
{
    char command[256];
    snprintf(command, sizeof command, "cd '%s' && find . -printf '%%p %%s %%i %%T@\\n' | sort",
             folder);
    FILE *listing = popen(command, "r");
    assert_non_null(listing);
    size_t length = fread(stock, 1, size - 1, listing);
    stock[length] = '\0';
    assert_int_equal(pclose(listing), 0);
    assert_true(length > 100 && length < size - 1);
}

static bool is_wanted(const char *found, const char *wanted)
{
    static const char start[] = "fretwork: ";
    if (strncmp(found, start, strlen(start)) != 0) return false;
    found += strlen(start);
    size_t length = strcspn(wanted, "*");
    if (strncmp(found, wanted, length) != 0) return false;
    const char *line_end = strchr(found, '\n');
    return line_end && line_end[1] == '\0' && (wanted[length] == '*' || line_end == found + length);
}

/* The same line with another command; false where it has options that `check` does not know, or
 * where the sentence names the command. */
static bool as_check(const char *line, const char *sentence, char *check, size_t size)
{
    if (strncmp(line, "run ", 4) != 0 || strstr(sentence, "fretwork run")) return false;
    for (const char *at = strstr(line, " -"); at; at = strstr(at + 1, " -"))
        if (strncmp(at, " --set ", 7) != 0) return false;
    snprintf(check, size, "check %s", line + 4);
    return true;
}

static void every_bad_input_gets_its_sentence_and_leaves_nothing(void **state)
{
    static char before[65536], after[65536];
    char folder[64], path[128];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/bounce.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(bounce, file);
    fclose(file);
    outcome seen = run_program(folder, "run bounce.yaml -q --no-plot -o done");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run bounce.yaml -q --no-plot -o lost --set run.limit=15.45");
    expect_end(&seen, 3, "of body speck is at (");
    seen = run_program(folder, "run bounce.yaml -q --no-plot -o other --set run.limit=15.45 "
                               "--set run.seed=2");
    expect_end(&seen, 3, "of body speck is at (");
    for (size_t n = 0; n < sizeof mess / sizeof *mess; ++n) shell(folder, mess[n]);
    take_stock(folder, before, sizeof before);
    int wrong = 0, checked = 0;
    for (size_t n = 0; n < sizeof refusals / sizeof *refusals; ++n) {
        const refusal *r = &refusals[n];
        seen = run_program(folder, r->line);
        bool same = is_wanted(seen.err, r->sentence) && seen.code == r->code;
        if (!same)
            print_error("fretwork %s\n  exit %d: %s  expected exit %d: %s\n", r->line, seen.code,
                        seen.err, r->code, r->sentence);
        wrong += !same;
        char check[2048];
        if (r->code == 2 && as_check(r->line, r->sentence, check, sizeof check)) {
            const outcome other = run_program(folder, check);
            if (other.code != 2 || strcmp(other.err, seen.err) != 0) {
                print_error("fretwork %s\n  exit %d: %s  expected what `run` says: %s\n", check,
                            other.code, other.err, seen.err);
                wrong += 1;
            }
            checked += 1;
        }
        take_stock(folder, after, sizeof after);
        if (strcmp(before, after) != 0) fail_msg("fretwork %s has left something", r->line);
    }
    assert_int_equal(wrong, 0);
    assert_true(checked > 10);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_bad_input_gets_its_sentence_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
