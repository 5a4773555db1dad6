/* SPDX-License-Identifier: GPL-3.0-or-later */
/* leftovers.c - what an earlier result leaves behind. State: files, and folders of results after
 * the other files that they hold. Start reading at
 * fw_leftovers_find(). */
#include "experiments/study/leftovers.h"

#include "experiments/results/playback.h"
#include "experiments/results/result_files.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/sealed_file.h"
#include "experiments/study/study.h"
#include "experiments/study/summary.h"
#include "experiments/study/sweep.h"
#include "sweep_seeds.h"
#include "sweep_threshold.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct leftover {
    char *path;
    bool is_folder; /* with a result in it */
} leftover;

struct fw_leftovers {
    int count;
    leftover *item;
};

static fw_status add(fw_leftovers *list, fw_error *error, const char *directory, const char *name)
{
    const size_t length = strlen(directory) + strlen(name) + 2;
    leftover *more = realloc(list->item, ((size_t)list->count + 1) * sizeof *more);
    if (more) list->item = more;
    char *path = malloc(length);
    if (!more || !path) {
        free(path);
        return fw_fail_memory(error, "a list of files");
    }
    snprintf(path, length, "%s%s%s", directory, name[0] ? "/" : "", name);
    list->item[list->count++] = (leftover){path, name[0] == '\0'};
    return FW_OK;
}

static fw_status load(fw_scenario **scenario, const char *directory, fw_error *error)
{
    fw_playback *playback;
    if (fw_sweep_is_in(directory)) return fw_sweep_load(scenario, directory, error);
    FW_TRY(fw_playback_open(&playback, directory, error));
    const fw_status status = fw_scenario_read(scenario, directory, playback->scenario,
                                              strlen(playback->scenario), NULL, 0, error);
    fw_playback_close(playback);
    return status;
}

/* As it was run; *old is NULL where there is nothing to be read. */
static fw_status load_old(fw_scenario **old, const char *directory, fw_error *error)
{
    fw_error own;
    *old = NULL;
    const fw_status status = load(old, directory, &own);
    if (status != FW_OK) *old = NULL;
    if (status != FW_SYSTEM_FAILED) return FW_OK;
    *error = own;
    return status;
}

/* Number of the case of that name, or -1. */
static int find_case(const fw_scenario *scenario, const char *name)
{
    char own[FW_CASE_NAME];
    if (!scenario || !fw_scenario_is_sweep(scenario)) return -1;
    for (int n = 0; n < scenario->study.sweep.case_count; ++n) {
        fw_scenario_case_name(scenario, n, own);
        if (strcmp(own, name) == 0) return n;
    }
    return -1;
}

/* How many runs of a study may have folders of their own: none of a sweep. */
static int run_count(const fw_scenario *scenario)
{
    return scenario && !fw_scenario_is_sweep(scenario) ? fw_study_run_count(scenario) : 0;
}

/* Has a run of the study a folder of that name? */
static bool has_run(const fw_scenario *scenario, const char *name)
{
    char folder[FW_RUN_FOLDER];
    for (int n = 1; n < run_count(scenario); ++n)
        if (fw_study_folder(scenario, n, folder) && strcmp(folder, name) == 0) return true;
    return false;
}

/* What is done with each table and picture that a result of a scenario has. */
typedef fw_status visitor(void *object, const char *directory, const char *name, fw_error *error);

static fw_status visit_files(const fw_scenario *scenario, const char *directory, visitor *visit,
                             void *object, fw_error *error)
{
    static const char *const tables[] = {FW_SUMMARY_FILE,    FW_PROFILE_FILE, FW_LAYER_FILE,
                                         FW_THRESHOLDS_FILE, FW_SEEDS_FILE,   FW_SWEEP_HDF5};
    char name[FW_NAME_BYTES + 8];
    for (size_t n = 0; n < sizeof tables / sizeof tables[0]; ++n)
        FW_TRY(visit(object, directory, tables[n], error));
    for (int n = 0; n < scenario->picture_count; ++n) {
        snprintf(name, sizeof name, "%.*s.png", FW_NAME_BYTES, scenario->pictures[n].name);
        FW_TRY(visit(object, directory, name, error));
    }
    /* What is drawn where the scenario has no picture of its own. */
    return visit(object, directory, fw_scenario_is_sweep(scenario) ? "sweep.png" : "motion.png",
                 error);
}

/* --- what the new result needs --- */

static bool is_there(const char *directory, const char *name)
{
    char path[FW_PATH_SIZE];
    struct stat facts;
    fw_error ignored;
    return fw_path_join(path, directory, name, &ignored) == FW_OK && lstat(path, &facts) == 0;
}

/* `found` says that a file is not ours, or why that cannot be told. */
static fw_status refuse(const char *directory, const char *name, fw_status found, fw_error *error)
{
    if (found != FW_BAD_INPUT) return found;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s/%s is in the way, and is not as this program wrote it: move it away, or "
                   "put the result elsewhere with -o DIR",
                   directory, name);
}

static fw_status check_file(void *object, const char *directory, const char *name, fw_error *error)
{
    const bool *overwrite = object;
    if (!is_there(directory, name)) return FW_OK;
    const fw_status found = fw_manifest_check(directory, name, error);
    if (found != FW_OK) return refuse(directory, name, found, error);
    return *overwrite ? FW_OK : fw_trajectory_refuse(directory, error);
}

/* Files by which a folder holds a result. */
static fw_status check_result(const char *directory, bool overwrite, fw_error *error)
{
    for (int n = 0; fw_result_file(n); ++n) {
        if (!is_there(directory, fw_result_file(n))) continue;
        const fw_status found = fw_result_file_check(directory, n, error);
        if (found != FW_OK) return refuse(directory, fw_result_file(n), found, error);
        /* What a killed run left before it was whole is no result yet. */
        const bool unfinished = strstr(fw_result_file(n), FW_FRESH_SUFFIX) != NULL;
        if (!overwrite && !unfinished) return fw_trajectory_refuse(directory, error);
    }
    return FW_OK;
}

/* `fixed`: also the files by which a folder holds a result, which a run that goes on has. */
static fw_status check_needs(const char *directory, const fw_scenario *fresh, bool fixed,
                             bool overwrite, fw_error *error)
{
    char path[FW_PATH_SIZE], name[FW_CASE_NAME];
    if (fixed) FW_TRY(check_result(directory, overwrite, error));
    FW_TRY(visit_files(fresh, directory, check_file, &overwrite, error));
    for (int n = 1; n < run_count(fresh); ++n) {
        if (!fw_study_folder(fresh, n, name)) continue;
        FW_TRY(fw_path_join(path, directory, name, error));
        FW_TRY(fw_path_check_inner(path, error));
        if (fixed) FW_TRY(check_result(path, overwrite, error));
    }
    for (int n = 0; fw_scenario_is_sweep(fresh) && n < fresh->study.sweep.case_count; ++n) {
        fw_scenario *case_of = NULL;
        fw_scenario_case_name(fresh, n, name);
        FW_TRY(fw_path_join(path, directory, name, error));
        FW_TRY(fw_path_check_inner(path, error));
        FW_TRY(fw_scenario_read_case(&case_of, fresh, n, error));
        const fw_status status = check_needs(path, case_of, fixed, overwrite, error);
        fw_scenario_destroy(case_of);
        FW_TRY(status);
    }
    return FW_OK;
}

fw_status fw_leftovers_check(const char *directory, const fw_scenario *scenario, fw_error *error)
{
    return check_needs(directory, scenario, false, true, error);
}

/* --- what the old one leaves --- */

static fw_status add_file(void *object, const char *directory, const char *name, fw_error *error)
{
    fw_error own;
    const fw_status found = fw_manifest_check(directory, name, &own);
    if (found == FW_SYSTEM_FAILED) *error = own;
    if (found != FW_OK) return found == FW_BAD_INPUT ? FW_OK : found;
    return add(object, error, directory, name);
}

/* The folder of a result within another one; it stays, unless the new result has none of that name.
 */
static fw_status add_folder(fw_leftovers *list, const char *directory, const char *name,
                            const fw_scenario *old, bool stays, fw_error *error)
{
    char path[FW_PATH_SIZE], folder[FW_RUN_FOLDER];
    fw_error ignored;
    if (fw_path_join(path, directory, name, &ignored) != FW_OK ||
        fw_path_check_inner(path, &ignored) != FW_OK || !is_there(directory, name))
        return FW_OK;
    FW_TRY(visit_files(old, path, add_file, list, error));
    /* Of a case; of a single run there are no such folders. */
    for (int n = 1; n < run_count(old); ++n)
        if (fw_study_folder(old, n, folder) && is_there(path, folder))
            FW_TRY(add_folder(list, path, folder, old, false, error));
    return stays ? FW_OK : add(list, error, path, "");
}

static fw_status add_result(fw_leftovers *list, const char *directory, const fw_scenario *old,
                            const fw_scenario *fresh, fw_error *error)
{
    char folder[FW_RUN_FOLDER], name[FW_CASE_NAME];
    FW_TRY(visit_files(old, directory, add_file, list, error));
    for (int n = 1; n < run_count(old); ++n)
        if (fw_study_folder(old, n, folder))
            FW_TRY(add_folder(list, directory, folder, old, has_run(fresh, folder), error));
    for (int n = 0; fw_scenario_is_sweep(old) && n < old->study.sweep.case_count; ++n) {
        fw_scenario *case_of = NULL;
        fw_error reason;
        fw_scenario_case_name(old, n, name);
        fw_status status = fw_scenario_read_case(&case_of, old, n, &reason);
        /* A case that is no scenario any more is nothing to look for. */
        if (status == FW_BAD_INPUT) continue;
        if (status != FW_OK) {
            *error = reason;
            return status;
        }
        status = add_folder(list, directory, name, case_of, find_case(fresh, name) >= 0, error);
        fw_scenario_destroy(case_of);
        FW_TRY(status);
    }
    return FW_OK;
}

fw_status fw_leftovers_find(fw_leftovers **leftovers, const char *directory,
                            const fw_scenario *fresh, bool overwrite, fw_error *error)
{
    *leftovers = NULL;
    FW_TRY(check_needs(directory, fresh, true, overwrite, error));
    *leftovers = calloc(1, sizeof **leftovers);
    if (!*leftovers) return fw_fail_memory(error, "a list of files");
    fw_scenario *old;
    fw_status status = load_old(&old, directory, error);
    if (old) status = add_result(*leftovers, directory, old, fresh, error);
    fw_scenario_destroy(old);
    if (status == FW_OK) return FW_OK;
    fw_leftovers_destroy(*leftovers);
    *leftovers = NULL;
    return status;
}

/* The files by which a folder holds a result, as far as they are ours. */
static fw_status discard_result(const char *path, fw_error *error)
{
    fw_folder *folder;
    fw_error own;
    int count = 0;
    bool ours[32];
    if (fw_path_check_inner(path, &own) != FW_OK) return FW_OK;
    for (; fw_result_file(count); ++count) {
        const fw_status found = fw_result_file_check(path, count, &own);
        if (found == FW_SYSTEM_FAILED && is_there(path, fw_result_file(count)))
            return fw_fail(error, found, "%s", own.sentence);
        ours[count] = found == FW_OK;
    }
    /* Whoever writes there keeps them. */
    const fw_status opened = fw_folder_open(&folder, path, &own);
    if (opened == FW_SYSTEM_FAILED) return fw_fail(error, opened, "%s", own.sentence);
    if (opened != FW_OK) return FW_OK;
    for (int n = 0; n < count; ++n)
        if (ours[n]) fw_folder_remove(folder, fw_result_file(n), &own);
    fw_folder_close(folder);
    return FW_OK;
}

fw_status fw_leftovers_remove(const fw_leftovers *leftovers, fw_error *error)
{
    for (int n = 0; n < leftovers->count; ++n) {
        const leftover *item = &leftovers->item[n];
        if (item->is_folder) FW_TRY(discard_result(item->path, error));
        if (item->is_folder)
            rmdir(item->path);
        else
            unlink(item->path);
    }
    return FW_OK;
}

void fw_leftovers_destroy(fw_leftovers *leftovers)
{
    if (!leftovers) return;
    for (int n = 0; n < leftovers->count; ++n) free(leftovers->item[n].path);
    free(leftovers->item);
    free(leftovers);
}
