/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scratch_folder.c - files on their way lie where the user wants them. */
#include "tests/support/laws.h"

#include "experiments/storage/scratch_folder.h"
#include "tests/support/scratch.h"

static void it_lies_where_tmpdir_says(void **state)
{
    (void)state;
    char parent[64], wanted[128], path[FW_PATH_SIZE], other[FW_PATH_SIZE];
    make_folder(parent, sizeof parent);
    setenv("TMPDIR", parent, 1);
    assert_fine(fw_scratch_folder_make(path, "film", &error));
    assert_fine(fw_scratch_folder_make(other, "film", &error));
    snprintf(wanted, sizeof wanted, "%s/fretwork-film-", parent);
    assert_memory_equal(path, wanted, strlen(wanted));
    assert_string_not_equal(path, other);
    assert_int_equal(access(path, W_OK | X_OK), 0);
    remove_folder(parent);
    assert_refused(fw_scratch_folder_make(path, "film", &error), FW_SYSTEM_FAILED, parent);
    assert_string_equal(path, "");
    setenv("TMPDIR", "", 1);
    assert_fine(fw_scratch_folder_make(path, "report", &error));
    assert_memory_equal(path, "/tmp/fretwork-report-", strlen("/tmp/fretwork-report-"));
    assert_int_equal(rmdir(path), 0);
    unsetenv("TMPDIR");
}

static void a_name_that_is_too_long_is_refused(void **state)
{
    (void)state;
    char path[FW_PATH_SIZE], parent[FW_PATH_SIZE];
    memset(parent, 'x', sizeof parent);
    parent[0] = '/';
    parent[sizeof parent - 1] = '\0';
    setenv("TMPDIR", parent, 1);
    assert_refused(fw_scratch_folder_make(path, "film", &error), FW_SYSTEM_FAILED, "too long");
    unsetenv("TMPDIR");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_lies_where_tmpdir_says),
        cmocka_unit_test(a_name_that_is_too_long_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
