/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_interruption.c - however a run of the program ends early, its checkpoint is whole, the exit
 * code says what happened, and `fretwork resume` goes on to the results of a run that was let be.
 */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "tests/support/program.h"

/* A run of some seconds; a checkpoint every 20 steps. */
#define BOUNCE                                                                                     \
    "run wall-bounce --quiet --no-plot --set run.steps=24000 --set run.record-every=400 "          \
    "--set run.measure-every=40 --set run.checkpoint-every=20 --set expect=[] -o "

static void check_exit_reason(const char *folder, const char *name, const char *words)
{
    char path[128];
    fw_playback *playback;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_fine(fw_playback_open(&playback, path, &error));
    if (!strstr(playback->exit_reason, words))
        fail_msg("exit reason '%s', expected '%s'", playback->exit_reason, words);
    fw_playback_close(playback);
}

/* The run is interrupted, and so is the resumed one. */
static void interrupt_twice(const char *folder, int signal_number, int code)
{
    running run = start_program(folder, BOUNCE "part");
    await_file(folder, "part/checkpoint-B");
    kill(run.process, signal_number);
    outcome seen = await_program(run);
    expect_end(&seen, code, "of 24000 steps; `fretwork resume part` goes on from here");
    check_exit_reason(folder, "part", "interrupted after");
    seen = run_program(folder, BOUNCE "part");
    expect_end(&seen, 2, "part holds a run that is not finished; `fretwork resume part` goes on");
    ino_t before = inode_of(folder, "part/checkpoint-B");
    run = start_program(folder, "resume part --quiet --no-plot");
    await_replacement(folder, "part/checkpoint-B", before);
    kill(run.process, signal_number);
    seen = await_program(run);
    expect_end(&seen, code, "interrupted after");
    seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "results: part/trajectory.h5"));
    expect_same_results(folder, "whole", "part");
    check_exit_reason(folder, "part", FW_RUN_FINISHED);
    seen = run_program(folder, "resume part --quiet");
    expect_end(&seen, 2, "part: the run is finished, there is nothing to resume");
    expect_same_results(folder, "whole", "part");
    shell(folder, "rm -r part");
}

static void signals_leave_a_run_that_goes_on(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, BOUNCE "whole");
    expect_end(&seen, 0, "");
    interrupt_twice(folder, SIGINT, 130);
    interrupt_twice(folder, SIGTERM, 143);
    interrupt_twice(folder, SIGHUP, 129);
    remove_folder(folder);
    skip_unseen();
}

/* What is counted are the steps that the progress counts: of all runs. */
static void signals_to_a_study_count_all_runs(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    running run = start_program(folder, BOUNCE "both --set study.seeds=2");
    await_file(folder, "both/checkpoint-B");
    kill(run.process, SIGTERM);
    outcome seen = await_program(run);
    expect_end(&seen, 143,
               " of 48000 steps of 2 runs; `fretwork resume both` goes on with that of seed 1 and "
               "begins the other again");
    remove_folder(folder);
}

static void killed_run_goes_on_from_its_last_checkpoint(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, BOUNCE "whole");
    expect_end(&seen, 0, "");
    running run = start_program(folder, BOUNCE "part");
    await_file(folder, "part/checkpoint-B");
    /* Nobody else may write here meanwhile. */
    seen = run_program(folder, "resume part --quiet");
    expect_end(&seen, 2, "another run is writing into part");
    seen = run_program(folder, BOUNCE "part --overwrite");
    expect_end(&seen, 2, "another run is writing into part");
    kill(run.process, SIGKILL);
    seen = await_program(run);
    assert_int_equal(seen.signal, SIGKILL);
    /* The newer checkpoint is damaged: the older one serves, and that is said. */
    shell(folder, "cp -r part hurt; newer=$(ls -t hurt/checkpoint-? | head -n 1); "
                  "printf 'these are not numbers' | "
                  "dd of=$newer bs=1 seek=1000 conv=notrunc status=none");
    seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "resume hurt --quiet --no-plot");
    expect_end(&seen, 0, "since the other checkpoint cannot be used");
    expect_same_results(folder, "whole", "part hurt");
    remove_folder(folder);
    skip_unseen();
}

/* The results are laid out, but there was no room for the first checkpoint. */
static void run_without_a_checkpoint_begins_again(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    const running killed = start_program(folder, BOUNCE "part --set run.record-every=24000");
    await_file(folder, "part/trajectory.h5");
    kill(killed.process, SIGKILL);
    await_program(killed);
    shell(folder, "rm -f part/checkpoint-*");
    outcome seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "the run ended before its first checkpoint, it begins again");
    seen = run_program(folder, BOUNCE "whole --set run.record-every=24000");
    expect_same_results(folder, "whole", "part");
    /* Frames without a checkpoint are not thrown away unasked. */
    seen = run_program(folder, "run wall-bounce -q --no-plot --set run.limit=21 -o lost");
    expect_end(&seen, 3, "of body sheet is at (");
    shell(folder, "rm lost/checkpoint-?");
    seen = run_program(folder, "resume lost -q");
    expect_end(&seen, 2, "frames but no checkpoint to go on from; `fretwork run --overwrite`");
    /* Before anything was laid out there is nothing to resume. */
    shell(folder, "mkdir early && touch early/trajectory.h5.new");
    seen = run_program(folder, "resume early -q");
    expect_end(&seen, 2,
               "early holds no results; a run that ended before it had laid them out is "
               "started again with `fretwork run`");
    remove_folder(folder);
    skip_unseen();
}

/* Killed while it closed its file: its structure is being rewritten, and put aside. */
static void file_torn_while_it_was_closed_is_mended(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, BOUNCE "whole");
    running run = start_program(folder, BOUNCE "part");
    await_file(folder, "part/checkpoint-B");
    kill(run.process, SIGTERM);
    seen = await_program(run);
    expect_end(&seen, 143, "interrupted");
    shell(folder, "cd part && mv trajectory.h5.head trajectory.h5.cutting && "
                  "dd if=/dev/zero of=trajectory.h5 bs=1k count=20 conv=notrunc status=none");
    seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "");
    expect_same_results(folder, "whole", "part");
    remove_folder(folder);
    skip_unseen();
}

static void diverged_run_keeps_its_checkpoint_and_is_not_finished(void **state)
{
    char folder[64], first[4096];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, BOUNCE "part --set run.limit=21");
    expect_end(&seen, 3, "of body sheet is at (");
    snprintf(first, sizeof first, "%s", seen.err);
    check_exit_reason(folder, "part", "of body sheet is at (");
    /* The resumed run meets the same end, having gone through the same steps. */
    shell(folder, "cp -r part again");
    seen = run_program(folder, "resume again --quiet");
    expect_end(&seen, 3, first);
    expect_same_results(folder, "part", "again");
    remove_folder(folder);
    skip_unseen();
}

/* Two seeds and their controls beside each other. */
static const char rubbing[] =
    "title: two crystals rub\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {time-step: 0.005, damping: 0.4, temperature: 0.01}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [6, 8]}, origin: [-6, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [6, 8]}, origin: [0.5, 0]}\n"
    "grips:\n"
    "  left: {body: left, side: left, layer: 1.2, force: [9, 0], tether: [0, 2]}\n"
    "  right: {body: right, side: right, layer: 1.2, force: [-9, 0], tether: [0, 2]}\n"
    "phases:\n"
    "  settle: {until: 1000, damping: 1}\n"
    "  sample: {until: 6000, grips: {left: {force: [9, 0], amplitude: [0, 9], period: 5}}}\n"
    "run: {steps: 6000, record-every: 50, measure-every: 10, checkpoint-every: 100}\n"
    "profile: {axis: x, phase: sample, every: 20, bin: 0.9, far: [2, 4]}\n"
    "study: {seeds: 2, control: ['phases.sample.grips.left.amplitude=[0, 0]']}\n";

static void study_that_is_interrupted_comes_to_the_same_outcome(void **state)
{
    char folder[64], path[128];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/rubbing.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(rubbing, file);
    fclose(file);
    outcome seen = run_program(folder, "run rubbing.yaml -q --no-plot -o whole");
    expect_end(&seen, 0, "");
    running run = start_program(folder, "run rubbing.yaml -q --no-plot --threads 2 -o part");
    for (int n = 0; n < 3; ++n) {
        await_file(folder, "part/checkpoint-B");
        ino_t before = inode_of(folder, "part/checkpoint-B");
        await_replacement(folder, "part/checkpoint-B", before);
        kill(run.process, n == 2 ? SIGKILL : SIGTERM);
        seen = await_program(run);
        if (n < 2) expect_end(&seen, 143, "`fretwork resume");
        run = start_program(folder, n == 1 ? "resume part -q --no-plot --threads 2"
                                           : "resume part -q --no-plot");
    }
    seen = await_program(run);
    expect_end(&seen, 0, "");
    expect_same_results(folder, "whole", "part");
    expect_same_results(folder, "whole/control", "part/control");
    shell(folder, "cmp whole/profile.csv part/profile.csv");
    seen = run_program(folder, "resume part -q");
    expect_end(&seen, 2, "part: the run is finished");
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signals_leave_a_run_that_goes_on),
        cmocka_unit_test(signals_to_a_study_count_all_runs),
        cmocka_unit_test(killed_run_goes_on_from_its_last_checkpoint),
        cmocka_unit_test(run_without_a_checkpoint_begins_again),
        cmocka_unit_test(file_torn_while_it_was_closed_is_mended),
        cmocka_unit_test(study_that_is_interrupted_comes_to_the_same_outcome),
        cmocka_unit_test(diverged_run_keeps_its_checkpoint_and_is_not_finished),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
