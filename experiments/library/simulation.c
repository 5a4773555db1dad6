/* SPDX-License-Identifier: GPL-3.0-or-later */
/* simulation.c - makes and runs simulations.
 * State: a study whose own run is advanced piece by piece, and what was handed out. Invariant: a
 * pointer that was handed out is good until the end. Start reading at fw_simulation_advance(). */
#include "simulation_parts.h"

#include "experiments/results/provenance.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/study/leftovers.h"
#include "fretwork.h"

#include <assert.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

static const char UNNAMED[] = "scenario";

const char *fw_version(void)
{
    return fw_provenance_now().version;
}

fw_simulation_def fw_simulation_def_default(void)
{
    return (fw_simulation_def){.threads = 1};
}

/* --- making --- */

static fw_status read_scenario(fw_simulation *s, const fw_simulation_def *def, fw_error *error)
{
    if (!def->text && !def->scenario)
        return fw_fail(error, FW_BAD_INPUT,
                       "a simulation without a scenario, expected a name, a file or a text");
    if (!def->text)
        return fw_catalogue_load(&s->scenario, def->scenario, def->settings, def->setting_count,
                                 s->name, error);
    const char *name = def->scenario ? def->scenario : UNNAMED;
    snprintf(s->name, sizeof s->name, "%s", name);
    return fw_scenario_read(&s->scenario, name, def->text, strlen(def->text), def->settings,
                            def->setting_count, error);
}

/* The case of a sweep takes the place of the sweep. */
static fw_status choose_case(fw_simulation *s, const char *wanted, fw_error *error)
{
    char name[FW_CASE_NAME];
    fw_scenario *sweep = s->scenario;
    if (!fw_scenario_is_sweep(sweep)) {
        if (!wanted) return FW_OK;
        return fw_fail(error, FW_BAD_INPUT, "%s is no sweep: it has no case %s", s->name, wanted);
    }
    for (int n = 0; wanted && n < sweep->study.sweep.case_count; ++n) {
        fw_scenario_case_name(sweep, n, name);
        if (strcmp(name, wanted) != 0) continue;
        fw_scenario *chosen;
        FW_TRY(fw_scenario_read_case(&chosen, sweep, n, error));
        fw_scenario_destroy(sweep);
        s->scenario = chosen;
        return FW_OK;
    }
    fw_scenario_case_name(sweep, 0, name);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s is a sweep%s%s, expected one of its %d cases, such as %s", s->name,
                   wanted ? " without the case " : "", wanted ? wanted : "",
                   sweep->study.sweep.case_count, name);
}

static fw_status begin(fw_simulation *s, const fw_simulation_def *def, fw_error *error)
{
    fw_leftovers *leftovers = NULL;
    const fw_run_options options = {.directory = s->directory,
                                    .overwrite = def->overwrite,
                                    .threads = s->threads,
                                    .at_once = s->threads,
                                    .name = s->name,
                                    .warnings = s->warnings};
    if (s->directory)
        FW_TRY(fw_leftovers_find(&leftovers, s->directory, s->scenario, def->overwrite, error));
    fw_status status = fw_study_begin(&s->study, s->scenario, &options, error);
    if (status == FW_OK && leftovers) status = fw_leftovers_remove(leftovers, error);
    fw_leftovers_destroy(leftovers);
    if (status == FW_OK) s->run = fw_study_run(s->study);
    return status;
}

static fw_status make(fw_simulation *s, const fw_simulation_def *def, fw_error *error)
{
    s->threads = def->threads > 0 ? def->threads : 1;
    s->warnings = open_memstream(&s->warning_lines, &s->warning_size);
    if (def->directory) s->directory = strdup(def->directory);
    if (!s->warnings || (def->directory && !s->directory))
        return fw_fail_memory(error, "a simulation");
    FW_TRY(read_scenario(s, def, error));
    FW_TRY(choose_case(s, def->sweep_case, error));
    return begin(s, def, error);
}

fw_status fw_simulation_create(fw_simulation **simulation, const fw_simulation_def *def,
                               fw_error *error)
{
    fw_error unwanted;
    if (!error) error = &unwanted;
    const int threads = omp_get_max_threads();
    *simulation = calloc(1, sizeof **simulation);
    if (!*simulation) return fw_fail_memory(error, "a simulation");
    const fw_status status = make(*simulation, def, error);
    omp_set_num_threads(threads);
    if (status != FW_OK) {
        fw_simulation_destroy(*simulation);
        *simulation = NULL;
    }
    return status;
}

void fw_simulation_destroy(fw_simulation *s)
{
    if (!s) return;
    /* Nobody is left to tell of a failure, and what was written before stays as it is. */
    if (s->run) fw_simulation_stop(s, NULL);
    fw_study_destroy(s->study);
    fw_scenario_destroy(s->scenario);
    if (s->warnings) fclose(s->warnings);
    free(s->warning_lines);
    free(s->directory);
    while (s->windows) {
        simulation_window *window = s->windows;
        s->windows = window->next;
        free(window->values);
        free(window);
    }
    free(s);
}

/* --- running --- */

static fw_status go_on(fw_simulation *s, int64_t steps, fw_error *error)
{
    FW_TRY(fw_run_advance(s->run, steps, error));
    if (fw_simulation_step(s) < fw_simulation_step_count(s)) return FW_OK;
    FW_TRY(fw_study_to_end(s->study, error));
    s->at_end = true;
    return FW_OK;
}

fw_status fw_simulation_advance(fw_simulation *s, int64_t steps, fw_error *error)
{
    const int threads = omp_get_max_threads();
    if (s->failure.status == FW_OK && !s->at_end && steps > 0) {
        omp_set_num_threads(s->threads);
        s->failure.status = go_on(s, steps, &s->failure);
        omp_set_num_threads(threads);
        if (s->at_end || s->failure.status != FW_OK) fw_run_close(s->run);
    }
    if (s->failure.status != FW_OK && error) *error = s->failure;
    return s->failure.status;
}

fw_status fw_simulation_run(fw_simulation *s, int64_t every, fw_simulation_look *look,
                            void *context, fw_error *error)
{
    assert(every > 0);
    while (look(s, context) && !s->at_end)
        FW_TRY(fw_simulation_advance(s, every - fw_simulation_step(s) % every, error));
    return FW_OK;
}

fw_status fw_simulation_stop(fw_simulation *s, fw_error *error)
{
    if (s->at_end || s->failure.status != FW_OK) return FW_OK;
    s->failure.status = fw_run_stop(s->run, &s->failure);
    fw_run_close(s->run);
    if (s->failure.status == FW_INTERRUPTED) return FW_OK;
    if (error) *error = s->failure;
    return s->failure.status;
}

int64_t fw_simulation_step(const fw_simulation *s)
{
    return fw_scene_steps(fw_simulation_scene(s));
}

int64_t fw_simulation_step_count(const fw_simulation *s)
{
    return s->scenario->run.steps;
}

double fw_simulation_time(const fw_simulation *s)
{
    return fw_scene_time(fw_simulation_scene(s));
}

bool fw_simulation_is_at_end(const fw_simulation *s)
{
    return s->at_end;
}
