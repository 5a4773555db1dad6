/* SPDX-License-Identifier: GPL-3.0-or-later */
/* leftovers.c - what an earlier result leaves behind. State: files, and folders of results after
 * the other files that they hold. Start reading at add_result(). */
#include "experiments/study/leftovers.h"

#include "experiments/results/playback.h"
#include "experiments/study/study.h"
#include "experiments/study/sweep.h"
#include "summary.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* As it was run; NULL where nothing can be read. */
static fw_scenario *scenario_in(const char *directory)
{
    fw_scenario *scenario = NULL;
    fw_playback *playback;
    fw_error ignored;
    if (fw_sweep_is_in(directory))
        return fw_sweep_load(&scenario, directory, &ignored) == FW_OK ? scenario : NULL;
    if (fw_playback_open(&playback, directory, &ignored) != FW_OK) return NULL;
    if (fw_scenario_read(&scenario, directory, playback->scenario, strlen(playback->scenario), NULL,
                         0, &ignored) != FW_OK)
        scenario = NULL;
    fw_playback_close(playback);
    return scenario;
}

static bool has_case(const fw_scenario *scenario, const char *name)
{
    char own[FW_CASE_NAME];
    for (int n = 0;
         scenario && fw_scenario_is_sweep(scenario) && n < scenario->study.sweep.value_count; ++n) {
        fw_scenario_case_name(scenario, n, own);
        if (strcmp(own, name) == 0) return true;
    }
    return false;
}

static fw_status add_result(fw_leftovers *list, const char *directory, const fw_scenario *old,
                            const fw_scenario *fresh, fw_error *error);

/* A folder within, unless the new result has one of that name. */
static fw_status add_folder(fw_leftovers *list, const char *directory, const char *name,
                            const fw_scenario *old, fw_error *error)
{
    char path[FW_PATH_SIZE];
    if (snprintf(path, sizeof path, "%s/%s", directory, name) >= FW_PATH_SIZE) return FW_OK;
    FW_TRY(add_result(list, path, old, NULL, error));
    return add(list, error, path, "");
}

static fw_status add_result(fw_leftovers *list, const char *directory, const fw_scenario *old,
                            const fw_scenario *fresh, fw_error *error)
{
    static const char *const tables[] = {FW_SUMMARY_FILE, FW_PROFILE_FILE, FW_LAYER_FILE};
    char name[FW_NAME_BYTES + 8];
    for (size_t n = 0; n < sizeof tables / sizeof tables[0]; ++n)
        FW_TRY(add(list, error, directory, tables[n]));
    for (int n = 0; n < old->picture_count; ++n) {
        snprintf(name, sizeof name, "%.*s.png", FW_NAME_BYTES, old->pictures[n].name);
        FW_TRY(add(list, error, directory, name));
    }
    const bool is_sweep = fw_scenario_is_sweep(old);
    if (!is_sweep && old->study.control_count > 0 &&
        (!fresh || fw_scenario_is_sweep(fresh) || fresh->study.control_count == 0))
        FW_TRY(add_folder(list, directory, FW_CONTROL_FOLDER, old, error));
    for (int n = 0; is_sweep && n < old->study.sweep.value_count; ++n) {
        fw_scenario *case_of = NULL;
        char case_name[FW_CASE_NAME];
        fw_scenario_case_name(old, n, case_name);
        if (has_case(fresh, case_name)) continue;
        if (fw_scenario_read_case(&case_of, old, n, error) != FW_OK) continue;
        const fw_status status = add_folder(list, directory, case_name, case_of, error);
        fw_scenario_destroy(case_of);
        FW_TRY(status);
    }
    return FW_OK;
}

fw_status fw_leftovers_find(fw_leftovers **leftovers, const char *directory,
                            const fw_scenario *fresh, fw_error *error)
{
    *leftovers = calloc(1, sizeof **leftovers);
    if (!*leftovers) return fw_fail_memory(error, "a list of files");
    fw_scenario *old = scenario_in(directory);
    const fw_status status = old ? add_result(*leftovers, directory, old, fresh, error) : FW_OK;
    fw_scenario_destroy(old);
    if (status == FW_OK) return FW_OK;
    fw_leftovers_destroy(*leftovers);
    *leftovers = NULL;
    return status;
}

static void discard_result(const char *path)
{
    fw_folder *folder;
    fw_error ignored;
    if (fw_folder_visit(&folder, path, &ignored) != FW_OK) return;
    fw_trajectory_discard(folder, &ignored);
    fw_folder_close(folder);
}

void fw_leftovers_remove(const fw_leftovers *leftovers)
{
    for (int n = 0; n < leftovers->count; ++n) {
        const leftover *item = &leftovers->item[n];
        if (item->is_folder) discard_result(item->path);
        remove(item->path);
    }
}

void fw_leftovers_destroy(fw_leftovers *leftovers)
{
    if (!leftovers) return;
    for (int n = 0; n < leftovers->count; ++n) free(leftovers->item[n].path);
    free(leftovers->item);
    free(leftovers);
}
