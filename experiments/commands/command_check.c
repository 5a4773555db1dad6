/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_check.c - what a scenario would take, without running it: size, memory, time and how near
 * it is to where its solids stop being right; on request a picture of its start.
 * Start reading at fw_command_check(). */
#include "experiments/commands/command.h"
#include "experiments/drawing/figure.h"
#include "experiments/measures/warning.h"
#include "experiments/pictures/wall_outline.h"
#include "experiments/setup/solids.h"
#include "experiments/study/sweep.h"

#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>

/* For how many seconds steps are taken for real. */
static const double REHEARSAL_SECONDS = 0.4;

/* --- a picture of the start --- */

typedef struct first_frame {
    fw_view_body *bodies;
    fw_outline *walls;
    fw_vec2 (*corners)[FW_SHAPE_CORNERS]; /* per wall */
    int **links;                          /* per body */
} first_frame;

static void release_frame(first_frame *frame, int bodies)
{
    for (int b = 0; frame->links && b < bodies; ++b) free(frame->links[b]);
    free(frame->links);
    free(frame->bodies);
    free(frame->walls);
    free(frame->corners);
}

/* The links of a body, numbered within it; NULL without memory. */
static int *links_of(const fw_body_range *range, const fw_solid *solid, int *count)
{
    int *links = calloc(2 * (size_t)solid->link_count + 1, sizeof *links);
    *count = 0;
    for (int n = 0; links && n < solid->link_count; ++n) {
        int one = solid->links[n][0] - range->first, other = solid->links[n][1] - range->first;
        if (one < 0 || one >= range->count || other < 0 || other >= range->count) continue;
        links[2 * *count] = one;
        links[2 * *count + 1] = other;
        *count += 1;
    }
    return links;
}

static fw_status fill_frame(const fw_experiment *experiment, first_frame *frame, fw_error *error)
{
    const fw_scene *scene = experiment->scene;
    int bodies = experiment->body_count, walls = fw_scene_wall_count(scene);
    frame->bodies = calloc((size_t)bodies + 1, sizeof *frame->bodies);
    frame->links = calloc((size_t)bodies + 1, sizeof *frame->links);
    frame->walls = calloc((size_t)walls + 1, sizeof *frame->walls);
    frame->corners = calloc((size_t)walls + 1, sizeof *frame->corners);
    if (!frame->bodies || !frame->links || !frame->walls || !frame->corners)
        return fw_fail_memory(error, "a picture of the start");
    for (int b = 0; b < bodies; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        int count;
        frame->links[b] = links_of(range, solid, &count);
        if (!frame->links[b]) return fw_fail_memory(error, "a picture of the start");
        frame->bodies[b] =
            (fw_view_body){.name = range->name,
                           .count = range->count,
                           .x = solid->x + range->first,
                           .y = solid->y + range->first,
                           .links = frame->links[b],
                           .link_count = count,
                           .kind = b % FW_PALETTE_KINDS,
                           .spacing = experiment->scenario->bodies[b].lattice.spacing};
    }
    for (int w = 0; w < walls; ++w) {
        frame->walls[w] =
            fw_wall_outline(fw_wall_definition(fw_scene_wall(scene, w)), frame->corners[w]);
        frame->walls[w].displacement = fw_scene_wall_displacement(scene, w);
    }
    return FW_OK;
}

static fw_status draw_start(const fw_experiment *experiment, const char *file, fw_error *error)
{
    first_frame frame = {0};
    fw_status status = fill_frame(experiment, &frame, error);
    if (status == FW_OK) {
        const fw_view view = {.bodies = frame.bodies,
                              .body_count = experiment->body_count,
                              .walls = frame.walls,
                              .wall_count = fw_scene_wall_count(experiment->scene)};
        const fw_figure_motion_plan plan = {.views = &view, .view_count = 1};
        fw_page page = fw_page_default();
        page.file = file;
        page.title = experiment->scenario->title;
        status = fw_figure_motion(&page, &plan, error);
    }
    release_frame(&frame, experiment->body_count);
    return status;
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

/* What this very process took to build all of it. */
static double memory_used(void)
{
    struct rusage used = {0};
    getrusage(RUSAGE_SELF, &used);
    return 1024 * (double)used.ru_maxrss;
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
    return scenario->study.seeds * (scenario->study.control_count > 0 ? 2 : 1);
}

static void print_study(const fw_scenario *scenario)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    if (sweep->value_count > 0) {
        char first[FW_CASE_NAME], last[FW_CASE_NAME];
        fw_scenario_case_name(scenario, 0, first);
        fw_scenario_case_name(scenario, sweep->value_count - 1, last);
        if (sweep->is_case) fw_scenario_case_name(scenario, sweep->number, first);
        printf("  %-14s %d cases, %s to %s; what follows is of %s\n", "sweep", sweep->value_count,
               first, last, first);
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
        FW_TRY(fw_solid_kind_of(scenario, b)->print_limits(stdout, &start, warnings, error));
    }
    return FW_OK;
}

/* --- all of it --- */

/* What is checked: a scenario, or a sweep by its first case. */
typedef struct check_plan {
    const fw_scenario *scenario;
    int64_t run_count;
    double step_count; /* of all runs together */
} check_plan;

static fw_status check_run(fw_run *run, const char *name, const check_plan *plan,
                           const fw_arguments *arguments, fw_error *error)
{
    const fw_experiment *experiment = fw_run_experiment(run);
    fw_results_size size;
    double step;
    int warnings = 0;
    FW_TRY(fw_run_size(run, &size, error));
    double memory = memory_used();
    if (arguments->output) FW_TRY(draw_start(experiment, arguments->output, error));
    printf("%s: %s\n", name, experiment->scenario->title);
    print_bodies(experiment);
    print_study(plan->scenario);
    print_sizes(experiment->scenario, &size, memory);
    FW_TRY(check_limits(experiment, &warnings, error));
    warnings += fw_warning_walls(stdout, experiment);
    if (arguments->output) printf("  %-14s %s\n", "picture", arguments->output);
    fflush(stdout);
    /* Last, since it moves what was looked at so far. */
    FW_TRY(fw_run_rehearse(run, REHEARSAL_SECONDS, &step, error));
    printf("  %-14s ", "time");
    print_time(step * (double)experiment->scenario->run.steps);
    printf(", about, with %d thread%s (%.3g ms a step), beside what writing takes\n",
           fw_command_threads(arguments), fw_command_threads(arguments) > 1 ? "s" : "", 1e3 * step);
    if (plan->run_count > 1) {
        printf("  %-14s ", "in all");
        print_time(step * plan->step_count);
        printf(", about, for the %lld runs, shared by as many processors as run them\n",
               (long long)plan->run_count);
    }
    if (warnings > 0)
        printf("%s can be run, with %d warning%s\n", name, warnings, warnings > 1 ? "s" : "");
    else
        printf("%s can be run\n", name);
    return FW_OK;
}

static fw_status check_scenario(const fw_scenario *scenario, const char *name,
                                const check_plan *plan, const fw_arguments *arguments,
                                fw_error *error)
{
    const fw_run_options options = {.threads = fw_command_threads(arguments), .name = name};
    fw_run *run;
    FW_TRY(fw_run_begin(&run, scenario, &options, error));
    const fw_status status = check_run(run, name, plan, arguments, error);
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
