/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_limits.c - scenarios beyond what rounding and time step allow: `check` and `run` refuse them
 * alike, and what only shows in motion is stopped. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char scenario[] =
    "title: beyond the limits\n"
    "materials:\n"
    "  rubber: {lattice-boltzmann: {rest-mass: 0}}\n"
    "  crystal: {movable-particles: {}}\n"
    "  net: {linear-lattice: {}}\n"
    "bodies:\n"
    "  sheet: {material: rubber, shape: {rectangle: [6, 6]}, origin: [3.3, 4.7], velocity: [0.05, "
    "0.031]}\n"
    "walls: {box: {box: [0, 0, 20, 20]}}\n"
    "run: {steps: 500, record-every: 50}\n";

#define SHEET   " --set bodies.sheet.material="
#define CRYSTAL SHEET "crystal --set bodies.sheet.lattice=hexagonal"
#define NET     SHEET "net --set bodies.sheet.lattice=hexagonal"
#define RUBBER  " --set materials.rubber.lattice-boltzmann."

static const struct {
    const char *settings, *sentence;
} refused[] = {
    {RUBBER "link-stiffness=[1,0.9999999999999,1]", "has the condition number 2e+13"},
    {RUBBER "rest-mass=[1e6,1e6,1e6]", "the condition number 2e+12"},
    {RUBBER "link-stiffness=1e-320", "link stiffness"},
    {CRYSTAL " --set dynamics.damping=1 --set dynamics.temperature=1e9",
     "the temperature is 1e+09, expected at most 18.86"},
    {CRYSTAL " --set bodies.sheet.temperature=1e9",
     "the temperature is 1e+09, expected at most 18.86"},
    {CRYSTAL " --set dynamics.damping=1 --set 'phases.warm={until: 450}' --set "
             "'phases.hot={until: 500, temperature: 1e9}'",
     "phase hot: the temperature is 1e+09"},
    {CRYSTAL " --set bodies.sheet.spacing=0.85 --set dynamics.time-step=0.03",
     "starts so near to its neighbours"},
    {NET " --set materials.net.linear-lattice.k2=-5", "a body with free sides collapses"},
};

static void check_and_run_refuse_alike(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "beyond.yaml", scenario);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n)
        for (int run = 0; run < 2; ++run) {
            char line[1024];
            snprintf(line, sizeof line, "%s beyond.yaml %s%s", run ? "run" : "check",
                     run ? "-o out" : "", refused[n].settings);
            const outcome seen = run_program(folder, line);
            expect_end(&seen, 2, refused[n].sentence);
            if (exists(folder, "out")) fail_msg("%s: a result was begun", refused[n].sentence);
        }
    const outcome seen = run_program(folder, "check beyond.yaml");
    expect_end(&seen, 0, "");
    remove_folder(folder);
}

/* Thrown at a wall a crystal is pressed together so far that the step no longer follows. */
static void energy_out_of_its_ledger_ends_the_run(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "beyond.yaml", scenario);
    const char *const fast = "run beyond.yaml -o fast" CRYSTAL " --set 'bodies.sheet.velocity=[0, "
                             "-300]' --set 'bodies.sheet.origin=[4, 8]'";
    const outcome seen = run_program(folder, fast);
    expect_end(&seen, 3, "the ledger of work and heat has");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(check_and_run_refuse_alike),
        cmocka_unit_test(energy_out_of_its_ledger_ends_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
