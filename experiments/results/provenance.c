/* SPDX-License-Identifier: GPL-3.0-or-later */
/* provenance.c - facts about the program, the machine and the moment. Keeps no state; FW_VERSION,
 * FW_REVISION, FW_COMPILER, FW_FLAGS and FW_LIBRARIES come from experiments/CMakeLists.txt. */
#include "experiments/results/provenance.h"

#include "core/instruction_set.h"
#include "experiments/storage/hdf5_file.h"
#include "experiments/text/text.h"

#include <pwd.h>
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

fw_provenance fw_provenance_now(void)
{
    fw_provenance now = {.program = "fretwork",
                         .version = FW_VERSION,
                         .revision = FW_REVISION,
                         .compiler = FW_COMPILER,
                         .flags = FW_FLAGS,
                         .instructions = fw_instruction_set_name(fw_instruction_set())};
    char hdf5[64];
    fw_hdf5_version(hdf5, sizeof hdf5);
    snprintf(now.libraries, sizeof now.libraries, "%s, %s", hdf5, FW_LIBRARIES);
    struct utsname machine;
    if (uname(&machine) == 0)
        snprintf(now.host, sizeof now.host, "%.80s, %.40s %.80s, %.40s", machine.nodename,
                 machine.sysname, machine.release, machine.machine);
    fw_provenance_time(now.start, sizeof now.start);
    return now;
}

void fw_provenance_time(char *text, size_t size)
{
    time_t now = time(NULL);
    struct tm utc;
    if (!gmtime_r(&now, &utc) || strftime(text, size, "%Y-%m-%dT%H:%M:%SZ", &utc) == 0)
        text[0] = '\0';
}

void fw_provenance_author(char *text, size_t size)
{
    struct passwd entry, *found = NULL;
    char memory[4096];
    const char *name = "unknown";
    if (getpwuid_r(getuid(), &entry, memory, sizeof memory, &found) == 0 && found) {
        /* The first field of the comment is the full name. */
        found->pw_gecos[strcspn(found->pw_gecos, ",")] = '\0';
        name = found->pw_gecos[0] != '\0' ? found->pw_gecos : found->pw_name;
    }
    snprintf(text, size, "%s", name);
}

/* Results are the same to the last bit only within one build. */
void fw_provenance_compare(FILE *out, const char *revision, const char *directory)
{
    const fw_provenance now = fw_provenance_now();
    if (strcmp(revision, now.revision) == 0) return;
    fprintf(out, "fretwork: %s was begun by revision ", directory);
    fw_text_print_line(out, revision);
    fprintf(out, " and goes on with %s; results of two revisions may differ in the last digits\n",
            now.revision);
}
