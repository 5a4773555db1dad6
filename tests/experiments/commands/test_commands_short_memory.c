/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_commands_short_memory.c - what a command asks for fails once at each place: the command says
 * that memory is missing, or prints and writes the same as with enough of it, and leaves nothing
 * behind. Start reading at the lines. */
#include "tests/support/short_memory.h"

#include "experiments/commands/command.h"
#include "experiments/storage/checksum.h"
#include "tests/support/program.h"

#include <omp.h>

static const char blocks[] =
    "title: a block on another one\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies:\n"
    "  upper: {material: soft, shape: {rectangle: [3, 2]}, origin: [0, 3]}\n"
    "  lower: {material: soft, shape: {rectangle: [3, 2]}}\n"
    "walls: {floor: {chain: [[-5, -1], [9, -1]]}}\n"
    "run: {steps: 4, record-every: 2}\n"
    "record: {force: true, fields: [strain-yy]}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, below: 1}]\n";

static const char sheets[] =
    "title: a sheet at two speeds\n"
    "parameters: {v: .1}\n"
    "materials: {rubber: {lattice-boltzmann: {}}}\n"
    "bodies: {sheet: {material: rubber, shape: {rectangle: [3, 3]}, velocity: [v, 0]}}\n"
    "run: {steps: 4, measure-every: 4}\n"
    "measure: [centre-of-mass]\n"
    "expect: [{quantity: centre-of-mass, component: x, above: 0}]\n"
    "study: {sweep: {parameters: {v: {values: [.1, .2]}}}}\n";

/* Two crystals over seeds, with a control. */
static const char crystals[] =
    "title: two crystals rest\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [-4, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [.5, 0]}\n"
    "dynamics: {damping: 1, temperature: 0.001}\n"
    "run: {steps: 4, measure-every: 2}\n"
    "profile: {every: 2, far: [1, 3], contact: 1.5}\n"
    "study: {seeds: 2, keep: true, control: ['dynamics.temperature=0']}\n"
    "pictures: {across: {kind: profile}}\n";

/* Places from files of other programs. */
#define PLACED(name)                                                                               \
    "title: placed\n"                                                                              \
    "materials: {gas: {movable-particles: {strength: 0}}}\n"                                       \
    "bodies: {cloud: {material: gas, shape: {file: " name "}}}\n"                                  \
    "run: {steps: 1}\n"

static char folder[64];

static void run_it(const char *line)
{
    const outcome seen = run_program(folder, line);
    expect_end(&seen, 0, "");
}

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "blocks.yaml", blocks);
    write_scenario(folder, "sheets.yaml", sheets);
    write_scenario(folder, "crystals.yaml", crystals);
    write_scenario(folder, "data.yaml", PLACED("two.data"));
    write_scenario(folder, "xyz.yaml", PLACED("two.xyz"));
    write_scenario(folder, "two.data", "two\n2 atoms\nAtoms\n\n1 1 0 0 0\n2 1 3 0 0\n");
    write_scenario(folder, "two.xyz", "2\n\nA 0 0 0\nA 3 0 0\n");
    run_it("run blocks.yaml -q --no-plot -o good");
    run_it("run crystals.yaml -q --no-plot -o studied");
    run_it("run sheets.yaml -q --no-plot -o swept");
    run_it("sweep sheets.yaml --list -o cases");
    shell(folder, "mkdir empty; cp -r swept finished; rm finished/sweep.csv finished/sweep.h5");
    return chdir(folder);
}

static int end(void **state)
{
    (void)state;
    assert_int_equal(chdir("/"), 0);
    remove_folder(folder);
    return 0;
}

typedef struct line {
    const char *words, *made; /* what it writes, or NULL */
    bool says_times;          /* and so never quite the same */
    const char *from;         /* a copy of what `it` is at the beginning, or NULL */
} line;

static void add_file(uint64_t *hash, FILE *file)
{
    char bytes[4096];
    for (size_t count; (count = fread(bytes, 1, sizeof bytes, file)) > 0;)
        *hash = fw_checksum_add(*hash, bytes, count);
}

/* What it prints, the file that it writes, and what there is in its folder. */
static fw_status do_line(const void *input, uint64_t *result, fw_error *failed)
{
    const line *of = input;
    static fw_arguments arguments;
    char copy[256], *words[PROGRAM_WORDS];
    int count = 0;
    snprintf(copy, sizeof copy, "%s", of->words);
    split_line(copy, words);
    while (words[count]) ++count;
    const fw_command *command = fw_command_find(words[0]);
    assert_non_null(command);
    if (of->made) unlink(of->made);
    if (of->from) {
        char copied[128];
        snprintf(copied, sizeof copied, "rm -rf it && cp -r %s it", of->from);
        shell(folder, copied);
    }
    FW_TRY(fw_arguments_read(&arguments, command, count - 1, words + 1, failed));

    fflush(stdout);
    FILE *said = tmpfile();
    const int before = dup(STDOUT_FILENO);
    assert_true(said && before >= 0 && dup2(fileno(said), STDOUT_FILENO) >= 0);
    const fw_status status = command->run(&arguments, failed);
    fflush(stdout);
    assert_true(dup2(before, STDOUT_FILENO) >= 0);
    close(before);

    rewind(said);
    *result = FW_CHECKSUM_OF_NOTHING;
    if (!of->says_times) add_file(result, said);
    fclose(said);
    if (of->from && status == FW_OK) {
        shell(folder, "find it | sort > listed");
        FILE *listed = fopen("listed", "rb");
        assert_non_null(listed);
        add_file(result, listed);
        fclose(listed);
    }
    FILE *made = of->made ? fopen(of->made, "rb") : NULL;
    if (status == FW_OK && of->made && !made) fail_msg("%s makes no %s", of->words, of->made);
    /* Of `check` the picture is whole before the rest is said. */
    if (status != FW_OK && made && !of->says_times && !of->from)
        fail_msg("%s fails and leaves %s", of->words, of->made);
    if (made && !of->says_times) add_file(result, made);
    if (made) fclose(made);
    return status;
}

#define BISECTED                                                                                   \
    "'study.sweep.parameters.v={from: .1, to: .3, tolerance: .05}' --set "                         \
    "'expect=[{quantity: centre-of-mass, component: x, crosses: 1.7, value: .2, within: .2}]'"

#define ONE_CASE "study.sweep.parameters.v.values=[.1]"

static void each_command_says_that_memory_is_missing(void **state)
{
    (void)state;
    static const line lines[] = {
        {"export good --to csv -o x.csv", "x.csv", false, NULL},
        {"export good --to xdmf -o x.xdmf", "x.xdmf", false, NULL},
        {"export good --to extxyz -o x.xyz", "x.xyz", false, NULL},
        {"export good --to data -o x.data", "x.data", false, NULL},
        {"table good -o x.csv", "x.csv", false, NULL},
        {"list good", NULL, false, NULL},
        {"list good --json", NULL, false, NULL},
        {"reference contact --json", NULL, false, NULL},
        {"show blocks.yaml", NULL, false, NULL},
        {"cite good", NULL, false, NULL},
        {"check blocks.yaml -o x.svg", "x.svg", true, NULL},
        {"check blocks.yaml --json", NULL, true, NULL},
        {"check sheets.yaml", NULL, true, NULL},
        {"check data.yaml --json", NULL, true, NULL},
        {"check xyz.yaml --json", NULL, true, NULL},
        {"verify blocks.yaml -q --json x.json", "x.json", true, NULL},
        {"verify sheets.yaml -q -j 1", NULL, true, NULL},
        {"profile studied --field order", NULL, false, NULL},
        {"sweep swept --list", NULL, false, NULL},
        {"sweep sheets.yaml --list -o cases", NULL, false, NULL},
        {"plot good --kind motion -o x.svg", "x.svg", false, NULL},
        {"rerun good -q --no-plot -o it --overwrite", NULL, false, "good"},
        {"run crystals.yaml -q --no-plot -o it --overwrite", "it/layer.csv", false, "studied"},
        {"run blocks.yaml -q --no-plot -o it --overwrite", NULL, false, "studied"},
        {"run sheets.yaml -q --no-plot -o it --overwrite -j 1", "it/sweep.csv", false, "swept"},
        {"run sheets.yaml -q --no-plot -o it -j 1 --set " BISECTED, "it/thresholds.csv", false,
         "empty"},
        {"run sheets.yaml -q --no-plot -o it --overwrite -j 1 --set " ONE_CASE, NULL, false,
         "swept"},
        {"run blocks.yaml -q --no-plot -o it --overwrite", NULL, false, "swept"},
        {"resume it -q --no-plot -j 1", "it/sweep.csv", false, "cases"},
        {"sweep it --case v=0.2 -q", "it/v=0.2/summary.csv", false, "cases"},
        {"collect it --no-plot", "it/sweep.csv", false, "finished"},
        {"extend it --add v=0.3 -q --no-plot -j 1", "it/sweep.csv", false, "swept"},
    };
    int refused = 0;
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n)
        refused += fail_each_place(lines[n].words, do_line, &lines[n]);
    assert_true(refused > 100);
}

/* The first of its 83 scenarios and what it keeps of all. */
static void the_catalogue_says_that_memory_is_missing(void **state)
{
    (void)state;
    const line list = {"list --names", NULL, false, NULL};
    int refused = 0, given = 0;
    const uint64_t expected = attempt_whole(list.words, do_line, &list);
    for (long which = 1; which <= 40; ++which)
        if (!fail_allocation(list.words, do_line, &list, which, expected, &refused, &given))
            fail_msg("the catalogue asks for %ld pieces of memory", which - 1);
    assert_true(refused >= 30);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_command_says_that_memory_is_missing),
        cmocka_unit_test(the_catalogue_says_that_memory_is_missing),
    };
    omp_set_num_threads(1);
    return cmocka_run_group_tests(tests, begin, end);
}
