/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lookup.c - list, quantities and reference: everything, or one thing by name; as JSON too. */
#include "tests/support/laws.h"

#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/scenario.h"
#include "tests/support/program.h"

static void contains(const char *text, const char *part)
{
    if (!strstr(text, part)) fail_msg("'%s' does not hold '%s'", text, part);
}

static void lacks(const char *text, const char *part)
{
    if (strstr(text, part)) fail_msg("'%s' holds '%s'", text, part);
}

static void every_experiment_has_a_group_and_a_time(void **state)
{
    (void)state;
    outcome names = run_program("/", "list --names"), all = run_program("/", "list");
    expect_end(&names, 0, "");
    expect_end(&all, 0, "");
    char *at = names.out;
    for (const fw_catalogue_entry *e = fw_catalogue; e->name; ++e) {
        fw_scenario *scenario;
        char line[128];
        assert_fine(fw_scenario_read(&scenario, e->name, e->text, e->length, NULL, 0, &error));
        assert_true(scenario->group != FW_GROUP_OWN);
        assert_true(scenario->takes > 0);
        /* The names alone, in alphabetical order, one a line. */
        assert_true(strncmp(at, e->name, strlen(e->name)) == 0 && at[strlen(e->name)] == '\n');
        at += strlen(e->name) + 1;
        snprintf(line, sizeof line, "\n  %s ", e->name);
        contains(all.out, line);
        contains(all.out, scenario->title);
        fw_scenario_destroy(scenario);
    }
    assert_string_equal(at, "");
    assert_true(strncmp(all.out, "Start here\n", 11) == 0);
    contains(all.out, "\n\nFriction\n");
    lacks(all.out, "Others");
    /* An experiment of a user's own tells neither. */
    outcome word = run_program("/", "list FRACTURE");
    contains(word.out, "fracture");
    lacks(word.out, "wall-bounce");
    word = run_program("/", "list chain");
    contains(word.out, "chain: Chains pulled at both ends");
    contains(word.out, "`fretwork run chain` runs it.\n");
    /* Of several words each must be there. */
    word = run_program("/", "list dong SPEED");
    contains(word.out, "wave-diagonal");
    lacks(word.out, "polarisation");
}

static void quantities_tells_one(void **state)
{
    (void)state;
    outcome seen = run_program("/", "quantities momentum");
    expect_end(&seen, 0, "");
    contains(seen.out, "momentum: sum over all particles\n");
    contains(seen.out, "components   x y\n");
    lacks(seen.out, "energy");
    /* A field of several solids. */
    seen = run_program("/", "quantities speed");
    contains(seen.out, "speed, a field of a lattice-boltzmann solid: ");
    contains(seen.out, "speed, a field of a movable-particles solid: ");
    contains(seen.out, "speed, a field of an elastic-automaton solid: ");
}

static void words_that_are_no_name_are_looked_for(void **state)
{
    (void)state;
    outcome seen = run_program("/", "quantities Heat");
    expect_end(&seen, 0, "");
    contains(seen.out, "Quantities (measure, ");
    contains(seen.out, "\n  friction-heat ");
    contains(seen.out, "\n  energy-error "); /* whose meaning speaks of it */
    lacks(seen.out, "centre-of-mass");
    lacks(seen.out, "Fields of a ");
    contains(seen.out, "\nFields of whatever body is rubbed");
    seen = run_program("/", "quantities heat friction");
    lacks(seen.out, "energy-error");
    /* Those that only one model has. */
    seen = run_program("/", "quantities linear-lattice second");
    contains(seen.out, "\n  bond-angle ");
    seen = run_program("/", "reference friction coefficient");
    expect_end(&seen, 0, "");
    contains(seen.out, "walls.NAME.surface.coulomb: friction coefficient");
    lacks(seen.out, "default");
    /* The place of a key may say one of the words, but not all. */
    seen = run_program("/", "reference piston mass");
    contains(seen.out, "walls.NAME.piston.mass: ");
    lacks(seen.out, "walls.NAME.piston.damping");
}

static void reference_finds_a_key_by_name_and_path(void **state)
{
    (void)state;
    outcome seen = run_program("/", "reference run.steps");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "run.steps: length of the run\n"
                                  "  value    a whole number of at least 1\n"
                                  "  unit     steps\n"
                                  "  default  none, it must be there\n");
    /* All keys of a name. */
    seen = run_program("/", "reference damping");
    contains(seen.out, "materials.NAME.lattice-boltzmann.damping: ");
    contains(seen.out, "\ndynamics.damping: ");
    contains(seen.out, "\nphases.NAME.damping: ");
    lacks(seen.out, "friction");
    /* A section with its keys; names of one's own stand where the schema has NAME. */
    seen = run_program("/", "reference walls.floor.path");
    contains(seen.out, "walls.NAME.path: how it moves");
    contains(seen.out, "    amplitude ");
    outcome same = run_program("/", "reference walls.NAME.path");
    assert_string_equal(same.out, seen.out);
    seen = run_program("/", "reference walls.floor");
    assert_true(strncmp(seen.out, "walls: walls by name\n", 21) == 0);
    seen = run_program("/", "reference expect.0.within");
    assert_true(strncmp(seen.out, "expect.N.within: ", 17) == 0);
}

static const char look_at_json[] =
    "import json, subprocess, sys\n"
    "def ask(*words):\n"
    "    done = subprocess.run([sys.argv[1], *words], capture_output=True, check=True)\n"
    "    assert done.stderr == b'', done.stderr\n"
    "    return json.loads(done.stdout)\n"
    "names = subprocess.run([sys.argv[1], 'list', '--names'], capture_output=True).stdout\n"
    "listed = ask('list', '--json')\n"
    "assert [e['name'] for e in listed] == names.decode().split()\n"
    "assert all(set(e) == set('name title group source figure takes about'.split()) "
    "for e in listed)\n"
    "one, = ask('list', 'wall-bounce', '--json')\n"
    "assert one['figure'] == 'Fig. 1' and one['takes'] == 0.1, one\n"
    "known = ask('quantities', '--json')\n"
    "assert len(known['quantities']) > 60 and len(known['fields']) > 10\n"
    "momentum, = ask('quantities', 'momentum', '--json')['quantities']\n"
    "assert momentum['components'] == ['x', 'y'] and momentum['of'] == 'body or scene'\n"
    "keys = ask('reference', '--json')\n"
    "assert len({k['path'] for k in keys}) == len(keys) > 200\n"
    "said = ask('check', 'friction', '--json')\n"
    "assert said['runs'] == 8 and said['bodies'][0]['particles'] > 100, said\n"
    "assert said['warnings'] == [] and said['seconds'] > said['seconds_per_step'] > 0\n"
    "assert said['memory_bytes'] > 1e7 and said['frames'] > 1 and said['threads'] == 1\n"
    "said = ask('check', 'bounce-as-printed', '--json')\n"
    "assert 'componentwise' in said['warnings'][0] and len(said['warnings']) == 1\n"
    "steps, = ask('reference', 'run.steps', '--json')\n"
    "assert steps['required'] and steps['default'] is None and steps['unit'] == 'steps', steps\n";

static void json_says_the_same(void **state)
{
    char folder[64], line[512];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "look.py", look_at_json);
    snprintf(line, sizeof line, "python3 look.py '%s'", FW_PROGRAM);
    shell(folder, line);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_experiment_has_a_group_and_a_time),
        cmocka_unit_test(quantities_tells_one),
        cmocka_unit_test(words_that_are_no_name_are_looked_for),
        cmocka_unit_test(reference_finds_a_key_by_name_and_path),
        cmocka_unit_test(json_says_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
