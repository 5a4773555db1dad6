/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export.c - which format, which file. Keeps no state. Start reading at fw_export(). */
#include "experiments/exchange/export.h"

#include "experiments/storage/regular_file.h"
#include "exported.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* What is made where no name is given has the first of the endings. */
typedef struct format {
    const char *name, *ending, *also; /* or NULL */
    fw_status (*write)(fw_exported *exported, const char *name, fw_error *error);
} format;

static const format formats[] = {
    {"xdmf", ".xdmf", ".xmf", fw_export_xdmf}, {"extxyz", ".extxyz", ".xyz", fw_export_extxyz},
    {"vtp", ".pvd", NULL, fw_export_vtp},      {"csv", ".csv", NULL, fw_export_csv},
    {"data", ".data", ".lmp", fw_export_data},
};
enum { FORMATS = sizeof formats / sizeof *formats };

static const format *find_format(const char *name)
{
    for (int n = 0; n < FORMATS; ++n)
        if (strcmp(formats[n].name, name) == 0) return &formats[n];
    return NULL;
}

static bool has_ending(const char *name, const char *ending)
{
    const size_t length = strlen(name), own = strlen(ending);
    return length > own && strcmp(name + length - own, ending) == 0;
}

/* Others tell by the ending what a file is. */
static fw_status check_name(const char *name, const format *of, fw_error *error)
{
    if (has_ending(name, of->ending) || (of->also && has_ending(name, of->also))) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "'%.60s' as %s, expected a name that ends in %s%s%s", name,
                   of->name, of->ending, of->also ? " or " : "", of->also ? of->also : "");
}

/* "results/bounce/" and "results/bounce/trajectory.h5", shorter than FW_PATH_SIZE, become
 * "results/bounce" and the ending. */
static fw_status default_name(char name[FW_PATH_SIZE], const char *results, const char *ending,
                              fw_error *error)
{
    static const char file[] = FW_TRAJECTORY_FILE;
    const char *slash = strrchr(results, '/');
    if (strcmp(slash ? slash + 1 : results, file) != 0)
        return fw_path_beside(name, results, ending, error);
    char folder[FW_PATH_SIZE] = ".";
    if (slash) snprintf(folder, sizeof folder, "%.*s", (int)(slash - results), results);
    return fw_path_beside(name, folder, ending, error);
}

static fw_status results_file(char path[FW_PATH_SIZE], const char *directory, fw_error *error)
{
    struct stat facts;
    if (stat(directory, &facts) == 0 && S_ISDIR(facts.st_mode))
        return fw_path_join(path, directory, FW_TRAJECTORY_FILE, error);
    if (strlen(directory) >= FW_PATH_SIZE)
        return fw_fail(error, FW_BAD_INPUT, "the name of the results is too long");
    strcpy(path, directory);
    return FW_OK;
}

fw_status fw_export(const fw_export_wish *wish, char **name, fw_error *error)
{
    const format *chosen = find_format(wish->format);
    char path[FW_PATH_SIZE], usual[FW_PATH_SIZE];
    fw_exported exported;
    *name = NULL;
    if (!chosen)
        return fw_fail(error, FW_BAD_INPUT, "there is no format '%s', expected one of %s",
                       wish->format, FW_EXPORT_FORMATS);
    if (wish->name) FW_TRY(check_name(wish->name, chosen, error));
    FW_TRY(results_file(path, wish->directory, error));
    if (!wish->name) FW_TRY(default_name(usual, wish->directory, chosen->ending, error));
    char *made = strdup(wish->name ? wish->name : usual);
    if (!made) return fw_fail_memory(error, "the name of a file");
    fw_status status = fw_exported_open(&exported, path, wish->every, error);
    if (status == FW_OK) status = chosen->write(&exported, made, error);
    fw_exported_close(&exported);
    if (status == FW_OK)
        *name = made;
    else
        free(made);
    return status;
}
