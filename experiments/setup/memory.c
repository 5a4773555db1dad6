/* SPDX-License-Identifier: GPL-3.0-or-later */
/* memory.c - what the bodies need, and the places where a Linux system has its limits. A place
 * without a number is no limit. Keeps no state. Start reading at fw_memory_check(). */
#include "experiments/setup/memory.h"

#include "experiments/setup/solids.h"
#include "experiments/text/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* --- what is needed --- */

/* The program, its libraries and what it writes with, measured: about 24 MB. */
static const double PROGRAM = 24e6;

/* All but the program. */
static double needed_by_bodies(const fw_scenario *scenario)
{
    double bytes = 0;
    for (int b = 0; b < scenario->body_count; ++b)
        bytes += (double)scenario->bodies[b].shape.count *
                 fw_solid_kind_of(scenario, b)->bytes_per_particle;
    return bytes;
}

double fw_memory_needed(const fw_scenario *scenario)
{
    return PROGRAM + needed_by_bodies(scenario);
}

/* --- what there is --- */

/* The first number in a file, or behind a word at the beginning of a line; INFINITY: none. */
static double read_number(const char *path, const char *word)
{
    FILE *in = fopen(path, "r");
    char line[256];
    double value = INFINITY;
    while (in && fgets(line, sizeof line, in)) {
        if (strncmp(line, word, strlen(word)) != 0) continue;
        const char *end;
        const double found = fw_number_scan(line + strlen(word), &end);
        if (end != line + strlen(word)) value = found;
        break;
    }
    if (in) fclose(in);
    return value;
}

/* What a group of processes may still take; caches count as free, since they give way. */
static double free_in_group(const char *folder, const char *limit_file, const char *used_file)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, limit_file);
    const double limit = read_number(path, "");
    /* Version 1 writes no limit as a number near 2^63. */
    if (!isfinite(limit) || limit > 1e18) return INFINITY;
    snprintf(path, sizeof path, "%s/%s", folder, used_file);
    const double used = read_number(path, "");
    snprintf(path, sizeof path, "%s/memory.stat", folder);
    double cached = read_number(path, "inactive_file ");
    if (!isfinite(cached)) cached = 0;
    return limit - (isfinite(used) ? used : 0) + cached;
}

/* Of one hierarchy: the group of the process and those above it, which all hold. */
static double free_in_groups(const char *root, const char *group, const char *limit_file,
                             const char *used_file)
{
    char folder[768];
    snprintf(folder, sizeof folder, "%s%s", root, group);
    double least = free_in_group(root, limit_file, used_file);
    while (strlen(folder) > strlen(root)) {
        least = fmin(least, free_in_group(folder, limit_file, used_file));
        *strrchr(folder, '/') = '\0';
    }
    return least;
}

/* Lines of /proc/self/cgroup: "0::/a/b" of version 2, "4:memory:/a/b" of version 1. */
static double free_in_control_groups(void)
{
    FILE *in = fopen("/proc/self/cgroup", "r");
    char line[512];
    double least = INFINITY;
    while (in && fgets(line, sizeof line, in)) {
        line[strcspn(line, "\n")] = '\0';
        const char *group = strrchr(line, ':') ? strrchr(line, ':') + 1 : "";
        if (*group != '/') continue;
        if (strncmp(line, "0::", 3) == 0)
            least = fmin(least,
                         free_in_groups("/sys/fs/cgroup", group, "memory.max", "memory.current"));
        else if (strstr(line, ":memory:"))
            least = fmin(least, free_in_groups("/sys/fs/cgroup/memory", group,
                                               "memory.limit_in_bytes", "memory.usage_in_bytes"));
    }
    if (in) fclose(in);
    return least;
}

/* Below a limit of this process, by what it takes already. */
static double free_below(bool space, double used)
{
    struct rlimit limit;
    if (getrlimit(space ? RLIMIT_AS : RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return INFINITY;
    return (double)limit.rlim_cur - used;
}

double fw_memory_available(const char **limit)
{
    const double page = (double)sysconf(_SC_PAGESIZE);
    const double space = page * read_number("/proc/self/statm", "");
    const struct {
        const char *name;
        double bytes;
    } limits[] = {
        {"in the system", 1024 * (read_number("/proc/meminfo", "MemAvailable:") +
                                  fmin(1e300, read_number("/proc/meminfo", "SwapFree:")))},
        {"in its control group", free_in_control_groups()},
        {"below the limit of its address space", free_below(true, isfinite(space) ? space : 0)},
        {"below the limit of its data", free_below(false, 0)}};
    int least = 0;
    for (int n = 1; n < 4; ++n)
        if (limits[n].bytes < limits[least].bytes) least = n;
    if (limit) *limit = limits[least].name;
    return fmax(0, limits[least].bytes);
}

fw_status fw_memory_check(const fw_scenario *scenario, int runs, fw_error *error)
{
    const char *limit;
    const double needed = runs * needed_by_bodies(scenario), there = fw_memory_available(&limit);
    if (needed <= there) return FW_OK;
    double particles = 0;
    for (int b = 0; b < scenario->body_count; ++b)
        particles += (double)scenario->bodies[b].shape.count;
    char each[48] = "";
    if (runs > 1) snprintf(each, sizeof each, " in each of %d runs", runs);
    return fw_fail(error, FW_SYSTEM_FAILED,
                   "%.0f particles%s take about %.0f MB of memory, but %.0f MB are free %s",
                   particles, each, 1e-6 * needed, 1e-6 * there, limit);
}
