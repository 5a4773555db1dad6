/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scratch.h - what tests of files need: folders that go away, sentences of failures, and scripts
 * that look at results with other people's readers. */
#ifndef FW_SCRATCH_H
#define FW_SCRATCH_H

#include "core/status.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Of the last call; some tests of the program need none. */
static fw_error error __attribute__((unused));

#define assert_fine(call)                                                                          \
    do {                                                                                           \
        if ((call) != FW_OK) fail_msg("%s: %s", #call, error.sentence);                            \
    } while (0)

#define assert_refused(call, wanted, words)                                                        \
    do {                                                                                           \
        error = (fw_error){0};                                                                     \
        assert_int_equal((call), (wanted));                                                        \
        assert_int_equal(error.status, (wanted));                                                  \
        if (!strstr(error.sentence, (words)))                                                      \
            fail_msg("'%s' does not speak of '%s'", error.sentence, (words));                      \
    } while (0)

/* A fresh empty folder; remove_folder removes it with its files. */
static inline void make_folder(char *path, size_t size)
{
    snprintf(path, size, "/tmp/fretwork-test-XXXXXX");
    if (!mkdtemp(path)) fail_msg("no folder %s", path);
}

/* The same in memory where there is such a place, for tests that wait for the disk too often. */
static inline void make_quick_folder(char *path, size_t size)
{
    if (access("/dev/shm", W_OK | X_OK) != 0) {
        make_folder(path, size);
        return;
    }
    snprintf(path, size, "/dev/shm/fretwork-test-XXXXXX");
    if (!mkdtemp(path)) fail_msg("no folder %s", path);
}

static inline void remove_folder(const char *path)
{
    char command[512];
    snprintf(command, sizeof command, "chmod -R u+w '%s' && rm -rf '%s'", path, path);
    if (system(command) != 0) fail_msg("%s remains", path);
}

/* Whether a script was to look at a file and could not. */
static bool h5py_missing __attribute__((unused));

/* To end a test with that has asked scripts: where they could not look, it is skipped, and not
 * passed; where h5py is expected (FW_H5PY_EXPECTED is set), it fails. */
#define skip_unseen()                                                                              \
    do {                                                                                           \
        if (h5py_missing && getenv("FW_H5PY_EXPECTED")) fail_msg("no Python with h5py here");      \
        if (h5py_missing) skip();                                                                  \
    } while (0)

/* The exit status of a script in tests/support, or -1 where no Python with h5py is installed. It
 * leaves no compiled modules beside the sources. */
static inline int run_python(const char *script, const char *arguments)
{
    static const char *const interpreters[] = {"python3", "/usr/bin/python3"};
    static int found = -1; /* it takes a while to find that out */
    char command[1024];
    for (int i = found < 0 ? 0 : found; i < 2; ++i) {
        snprintf(command, sizeof command, "%s -c 'import h5py' 2>/dev/null", interpreters[i]);
        if (found < 0 && system(command) != 0) continue;
        found = i;
        snprintf(command, sizeof command, "%s -B '%s/tests/support/%s' %s", interpreters[i],
                 FW_SOURCE_DIR, script, arguments);
        int status = system(command);
        return status == -1 ? 127 : status;
    }
    h5py_missing = true;
    return -1;
}

#endif
