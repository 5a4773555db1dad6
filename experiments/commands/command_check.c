/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_check.c - what a scenario would take, without running it: size, memory, time and how
 * near it is to where its solids stop being right; on request a picture of its start. Keeps no
 * state. Start reading at fw_command_check(). */
#include "experiments/commands/command.h"
#include "experiments/measures/warning.h"
#include "experiments/setup/memory.h"
#include "experiments/setup/solids.h"
#include "experiments/study/study.h"
#include "experiments/study/sweep.h"
#include "experiments/text/json.h"
#include "experiments/text/text.h"
#include "experiments/units/units.h"
#include "report.h"
#include "start_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* For how many seconds steps are taken for real. */
static const double REHEARSAL_SECONDS = 0.4;

/* --- time --- */

/* Seconds of a run: making it and measuring its start, each step, and what it writes. */
typedef struct run_cost {
    double begin, step, write;
} run_cost;

/* Files are opened, sealed and closed; a frame has a dozen entries; the rest goes by bytes. As it
 * was measured on one machine, for runs so short that this is most of what they take. */
static double seconds_to_write(const fw_results_size *size)
{
    return 0.02 + 4e-5 * (double)size->frames + 2e-9 * (size->file + size->checkpoint);
}

static double seconds_beside_steps(const run_cost *cost)
{
    return cost->begin + cost->write;
}

/* --- sizes --- */

static void print_bytes(const char *what, double bytes, const char *more)
{
    static const char *const units[] = {"B", "kB", "MB", "GB", "TB", "PB", "EB"};
    int unit = 0;
    for (; bytes >= 999.5 && unit < 6; ++unit) bytes /= 1000;
    printf("  %-14s %.3g %s%s\n", what, bytes, units[unit], more);
}

static void print_time(double seconds)
{
    if (seconds < 100)
        printf("%.2g s", seconds);
    else if (seconds < 6000)
        printf("%.0f min", seconds / 60);
    else if (seconds < 200000)
        printf("%.1f h", seconds / 3600);
    else
        printf("%.3g days", seconds / 86400);
}

static void print_bodies(const fw_experiment *experiment)
{
    double particles = 0, links = 0;
    for (int b = 0; b < experiment->body_count; ++b) particles += experiment->bodies[b].count;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s)
        links += fw_scene_observe_body(experiment->scene, s)->link_count;
    printf("  %-14s %d\n", "bodies", experiment->body_count);
    for (int b = 0; b < experiment->body_count; ++b)
        printf("  %-14s %d particles, %s\n", "", experiment->bodies[b].count,
               experiment->bodies[b].name);
    printf("  %-14s %.0f\n  %-14s %.0f\n", "particles", particles, "links", links);
    printf("  %-14s %d\n", "walls", fw_scene_wall_count(experiment->scene));
}

static int64_t run_count(const fw_scenario *scenario)
{
    return fw_study_run_count(scenario);
}

static void print_study(const fw_scenario *scenario)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    if (sweep->case_count > 0) {
        char first[FW_CASE_NAME], last[FW_CASE_NAME];
        fw_scenario_case_name(scenario, 0, first);
        fw_scenario_case_name(scenario, sweep->case_count - 1, last);
        if (sweep->is_case)
            printf("  %-14s the case %s\n", "sweep", first);
        else
            printf("  %-14s %d cases, %s to %s; what follows is of %s\n", "sweep",
                   sweep->case_count, first, last, first);
        if (sweep->tolerance > 0)
            printf("  %-14s and those to which bisection comes between them\n", "");
    }
    if (run_count(scenario) > 1)
        printf("  %-14s %lld seeds%s; what follows is of one run\n", "study",
               (long long)scenario->study.seeds,
               scenario->study.control_count > 0 ? ", each with its control" : "");
}

static void print_sizes(const fw_scenario *scenario, const fw_results_size *size, double memory)
{
    printf("  %-14s %lld\n", "steps", (long long)scenario->run.steps);
    printf("  %-14s %lld\n", "frames", (long long)size->frames);
    printf("  %-14s %lld of %d numbers\n", "samples", (long long)size->rows, size->row_width);
    print_bytes("results file", size->file, "");
    print_bytes("checkpoints", size->checkpoint, " each, two are kept");
    print_bytes("memory", memory, ", about");
}

/* --- how near a solid is to its limits --- */

static fw_status check_limits(const fw_experiment *experiment, int *warnings, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_start start = {.scenario = scenario,
                                .body = b,
                                .solid = fw_experiment_solid(experiment, b),
                                .range = &experiment->bodies[b],
                                .meets = fw_scene_wall_count(experiment->scene) > 0 ||
                                         experiment->body_count > 1};
        const fw_solid_kind *kind = fw_solid_kind_of(scenario, b);
        if (kind->print_limits) FW_TRY(kind->print_limits(stdout, &start, warnings, error));
    }
    return FW_OK;
}

/* --- all of it --- */

/* What is checked: a scenario, or a sweep by its first case. */
typedef struct check_plan {
    const fw_scenario *scenario;
    int64_t run_count;
    double step_count; /* of all runs together */
    run_cost cost;     /* of one of them; its steps are known last */
} check_plan;

/* What a run would warn of at its start; the speed was reported in better words. */
static fw_status warn_as_run(const fw_experiment *experiment, int *warnings, fw_error *error)
{
    fw_warning warning = {.out = stdout, .hurried = *warnings > 0};
    const fw_status status = fw_warning_look(&warning, experiment, error);
    *warnings += warning.count;
    fw_warning_clear(&warning);
    return status;
}

/* Last, since it moves what was looked at so far. */
static fw_status rehearse(fw_run *run, const fw_results_size *size, run_cost *cost, fw_error *error)
{
    cost->write = seconds_to_write(size);
    return fw_run_rehearse(run, REHEARSAL_SECONDS, &cost->step, error);
}

static double seconds_of_all(const check_plan *plan)
{
    return plan->cost.step * plan->step_count +
           seconds_beside_steps(&plan->cost) * (double)plan->run_count;
}

static fw_status check_run(fw_run *run, const char *name, check_plan *plan,
                           const fw_arguments *arguments, fw_error *error)
{
    const fw_experiment *experiment = fw_run_experiment(run);
    run_cost *cost = &plan->cost;
    fw_results_size size;
    int warnings = 0;
    FW_TRY(fw_run_size(run, &size, error));
    const double memory = fw_memory_needed(experiment->scenario);
    if (arguments->output) FW_TRY(fw_start_picture_draw(experiment, arguments->output, error));
    printf("%s: ", name);
    fw_text_print_line(stdout, experiment->scenario->title);
    printf("\n");
    print_bodies(experiment);
    if (fw_units_given(&experiment->scenario->units)) {
        printf("  %-14s ", "one unit is");
        fw_report_units(stdout, experiment->scenario);
        printf("\n");
    }
    print_study(plan->scenario);
    print_sizes(experiment->scenario, &size, memory);
    FW_TRY(check_limits(experiment, &warnings, error));
    FW_TRY(warn_as_run(experiment, &warnings, error));
    if (arguments->output) printf("  %-14s %s\n", "picture", arguments->output);
    fflush(stdout);
    FW_TRY(rehearse(run, &size, cost, error));
    printf("  %-14s ", "time");
    print_time(cost->step * (double)experiment->scenario->run.steps + seconds_beside_steps(cost));
    printf(", about, with %d thread%s (%.3g ms a step), %.2g s of it to begin and to write\n",
           fw_command_threads(arguments), fw_command_threads(arguments) > 1 ? "s" : "",
           1e3 * cost->step, seconds_beside_steps(cost));
    if (plan->run_count > 1) {
        printf("  %-14s ", "in all");
        print_time(seconds_of_all(plan));
        printf(", about, for the %lld runs, shared by as many processors as run them\n",
               (long long)plan->run_count);
    }
    if (warnings > 0)
        printf("%s can be run, with %d warning%s\n", name, warnings, warnings > 1 ? "s" : "");
    else
        printf("%s can be run\n", name);
    return FW_OK;
}

/* {name, title, bodies: [{name, particles}], walls, steps, frames, samples, numbers_per_sample,
 * file_bytes, checkpoint_bytes, memory_bytes, runs, threads, seconds_to_begin, seconds_per_step,
 * seconds_to_write: of one run, seconds: of all runs one after the other, warnings: [...]}. */
static void write_json(const fw_experiment *experiment, const char *name, const check_plan *plan,
                       const fw_results_size *size, int threads, const char *warnings)
{
    const fw_scenario *scenario = experiment->scenario;
    fw_json json = {.out = stdout};
    fw_json_begin(&json, NULL, '{');
    fw_json_text(&json, "name", name);
    fw_json_text(&json, "title", scenario->title);
    fw_json_begin(&json, "bodies", '[');
    for (int b = 0; b < experiment->body_count; ++b) {
        fw_json_begin(&json, NULL, '{');
        fw_json_text(&json, "name", experiment->bodies[b].name);
        fw_json_integer(&json, "particles", experiment->bodies[b].count);
        fw_json_end(&json, '}');
    }
    fw_json_end(&json, ']');
    fw_json_integer(&json, "walls", fw_scene_wall_count(experiment->scene));
    fw_json_integer(&json, "steps", scenario->run.steps);
    fw_json_integer(&json, "frames", size->frames);
    fw_json_integer(&json, "samples", size->rows);
    fw_json_integer(&json, "numbers_per_sample", size->row_width);
    fw_json_integer(&json, "file_bytes", (int64_t)size->file);
    fw_json_integer(&json, "checkpoint_bytes", (int64_t)size->checkpoint);
    fw_json_integer(&json, "memory_bytes", (int64_t)fw_memory_needed(scenario));
    fw_json_integer(&json, "runs", plan->run_count);
    fw_json_integer(&json, "threads", threads);
    fw_json_number(&json, "seconds_to_begin", plan->cost.begin);
    fw_json_number(&json, "seconds_per_step", plan->cost.step);
    fw_json_number(&json, "seconds_to_write", plan->cost.write);
    fw_json_number(&json, "seconds", seconds_of_all(plan));
    fw_json_begin(&json, "warnings", '[');
    while (warnings && *warnings) {
        char line[512];
        const int length = (int)strcspn(warnings, "\n");
        snprintf(line, sizeof line, "%.*s", length, warnings);
        fw_json_text(&json, NULL, line);
        warnings += length + (warnings[length] == '\n');
    }
    fw_json_end(&json, ']');
    fw_json_end(&json, '}');
}

static fw_status check_run_as_json(fw_run *run, const char *name, check_plan *plan,
                                   const fw_arguments *arguments, fw_error *error)
{
    const fw_experiment *experiment = fw_run_experiment(run);
    fw_results_size size;
    char *said = NULL;
    size_t length = 0;
    FW_TRY(fw_run_size(run, &size, error));
    if (arguments->output) FW_TRY(fw_start_picture_draw(experiment, arguments->output, error));
    fw_warning warning = {.out = open_memstream(&said, &length)};
    if (!warning.out) return fw_fail_memory(error, "the warnings");
    fw_status status = fw_warning_look(&warning, experiment, error);
    if (status == FW_OK) status = rehearse(run, &size, &plan->cost, error);
    if (status == FW_OK)
        write_json(experiment, name, plan, &size, fw_command_threads(arguments), warning.text);
    fclose(warning.out);
    free(said);
    fw_warning_clear(&warning);
    return status;
}

static fw_status check_scenario(const fw_scenario *scenario, const char *name, check_plan *plan,
                                const fw_arguments *arguments, fw_error *error)
{
    const fw_run_options options = {.threads = fw_command_threads(arguments), .name = name};
    const double begun = fw_progress_clock();
    fw_run *run;
    FW_TRY(fw_run_begin(&run, scenario, &options, error));
    plan->cost.begin = fw_progress_clock() - begun;
    const fw_status status =
        (arguments->json ? check_run_as_json : check_run)(run, name, plan, arguments, error);
    fw_run_destroy(run);
    return status;
}

static void count_runs(check_plan *plan, const fw_scenario *scenario)
{
    plan->run_count += run_count(scenario);
    plan->step_count += (double)run_count(scenario) * (double)scenario->run.steps;
}

static fw_status check_study(const fw_scenario *scenario, const char *name,
                             const fw_arguments *arguments, fw_error *error)
{
    check_plan plan = {.scenario = scenario};
    count_runs(&plan, scenario);
    if (plan.run_count > 1) {
        /* Whatever a run would refuse of other seeds and of the control. */
        const fw_run_options options = {.threads = fw_command_threads(arguments), .name = name};
        fw_study *study;
        FW_TRY(fw_study_begin(&study, scenario, &options, error));
        fw_study_destroy(study);
    }
    return check_scenario(scenario, name, &plan, arguments, error);
}

static fw_status check_sweep(const fw_scenario *scenario, const char *name,
                             const fw_arguments *arguments, fw_error *error)
{
    const fw_run_options options = {.threads = fw_command_threads(arguments), .name = name};
    check_plan plan = {.scenario = scenario};
    fw_sweep *sweep;
    FW_TRY(fw_sweep_begin(&sweep, scenario, &options, error));
    for (int n = 0; n < fw_sweep_case_count(sweep); ++n)
        count_runs(&plan, fw_sweep_scenario(sweep, n));
    const fw_status status =
        check_scenario(fw_sweep_scenario(sweep, 0), name, &plan, arguments, error);
    fw_sweep_destroy(sweep);
    return status;
}

fw_status fw_command_check(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    FW_TRY(fw_command_load(&scenario, arguments->words[0], arguments, name, error));
    const fw_status status = fw_scenario_is_sweep(scenario)
                                 ? check_sweep(scenario, name, arguments, error)
                                 : check_study(scenario, name, arguments, error);
    fw_scenario_destroy(scenario);
    return status;
}
