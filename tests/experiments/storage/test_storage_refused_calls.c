/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_storage_refused_calls.c - files and folders where the system refuses a call, is interrupted
 * or moves fewer bytes than it was asked for. */
#include "tests/support/laws.h"

#include "experiments/storage/checksum.h"
#include "experiments/storage/claim.h"
#include "experiments/storage/row_writer.h"
#include "experiments/storage/sealed_file.h"
#include "experiments/storage/whole_file.h"
#include "tests/support/refused_calls.h"
#include "tests/support/scratch.h"

#include <errno.h>
#include <fcntl.h>

static const char words[] = "the quick brown fox jumps";
static char parent[64], file[80], topmost[80], fresh[96], row_file[80];

static int begin(void **state)
{
    (void)state;
    make_folder(parent, sizeof parent);
    snprintf(file, sizeof file, "%s/words", parent);
    snprintf(topmost, sizeof topmost, "%s/new", parent);
    snprintf(fresh, sizeof fresh, "%s/folder", topmost);
    snprintf(row_file, sizeof row_file, "%s/row", parent);
    FILE *out = fopen(file, "w");
    assert_non_null(out);
    fputs(words, out);
    fclose(out);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(parent);
    return 0;
}

/* What may fail: its status, and what it came to is as it should be wherever that is FW_OK. */
typedef fw_status attempted(void);

static fw_status read_file(void)
{
    char *bytes;
    size_t size;
    FW_TRY(fw_regular_file_read(&bytes, &size, file, 100, &error));
    assert_int_equal(size, strlen(words));
    assert_string_equal(bytes, words);
    free(bytes);
    return FW_OK;
}

static fw_status make_new_folder(void)
{
    fw_folder *folder;
    const fw_status status = fw_folder_create(&folder, fresh, &error);
    if (status != FW_OK) {
        assert_null(folder);
        if (error.status == FW_SYSTEM_FAILED) assert_int_equal(access(topmost, F_OK), -1);
        if (access(topmost, F_OK) == 0) assert_int_equal(rmdir(fresh) + rmdir(topmost), 0);
        return status;
    }
    assert_int_equal(access(fresh, W_OK), 0);
    fw_folder_abandon(folder);
    assert_int_equal(access(topmost, F_OK), -1);
    return FW_OK;
}

static fw_status synchronise(void)
{
    fw_folder *folder;
    FW_TRY(fw_folder_visit(&folder, parent, &error));
    const fw_status status = fw_folder_sync(folder, &error);
    fw_folder_close(folder);
    return status;
}

/* FW_BAD_INPUT: somebody else has it. */
static fw_status claim_folder(void)
{
    fw_claim *claim;
    FW_TRY(fw_claim_take(&claim, fresh, &error));
    fw_claim_release(claim);
    return claim ? FW_OK : FW_BAD_INPUT;
}

static fw_status seal_and_read(void)
{
    fw_folder *folder;
    fw_sealed_file *sealed;
    unsigned char *payload = NULL;
    uint64_t size;
    FW_TRY(fw_folder_visit(&folder, parent, &error));
    fw_status status =
        fw_sealed_file_create(&sealed, folder, "sealed", "WORDS", sizeof words, &error);
    if (status == FW_OK) {
        fw_sealed_file_write(sealed, words, sizeof words);
        status = fw_sealed_file_commit(sealed, &error);
        if (status != FW_OK) assert_false(fw_folder_has(folder, "sealed"));
        assert_false(fw_folder_has(folder, "sealed" FW_FRESH_SUFFIX));
    }
    if (status == FW_OK)
        status = fw_sealed_file_read(folder, "sealed", "WORDS", &payload, &size, &error);
    if (status == FW_OK) assert_memory_equal(payload, words, sizeof words);
    free(payload);
    fw_error ignored;
    fw_folder_remove(folder, "sealed", &ignored);
    fw_folder_close(folder);
    return status;
}

/* A checksum knows no sentence: here it has one. */
static fw_status add_up(void)
{
    uint64_t checksum = FW_CHECKSUM_OF_NOTHING;
    const int descriptor = open(file, O_RDONLY | O_CLOEXEC);
    const int reason = fw_checksum_file(descriptor, 4, strlen(words) - 4, &checksum);
    close(descriptor);
    if (reason != 0) return fw_fail(&error, FW_SYSTEM_FAILED, "%s", strerror(reason));
    assert_true(checksum == fw_checksum_add(FW_CHECKSUM_OF_NOTHING, words + 4, strlen(words) - 4));
    return FW_OK;
}

static void keep_reason(void *owner, int reason)
{
    *(int *)owner = reason;
}

static fw_status write_row(void)
{
    static const double row[] = {1, -2, 3.5, 1e300};
    double found[4] = {0};
    int reason = -1;
    const fw_row_piece piece = {row, sizeof row, 8};
    const int descriptor = open(row_file, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    fw_row_writer *writer = fw_row_writer_create(descriptor, keep_reason, &reason);
    assert_non_null(writer);
    fw_row_writer_start(writer, &piece, 1);
    fw_row_writer_destroy(writer);
    const ssize_t moved = pread(descriptor, found, sizeof found, 8);
    close(descriptor);
    if (reason != 0) return fw_fail(&error, FW_SYSTEM_FAILED, "%s", strerror(reason));
    assert_int_equal(moved, sizeof found);
    assert_memory_equal(found, row, sizeof row);
    return FW_OK;
}

/* A row that is long enough to go past the cache, where the file lies on a disk that has that: what
 * lies between two multiples of 4096, and its two ends apart. */
static fw_status write_long_row(void)
{
    enum { NUMBERS = 2048, ADDRESS = 4096 - 64 };
    static double found[NUMBERS];
    int reason = -1;
    double *memory = fw_row_memory(sizeof found), *row = fw_row_place(memory, ADDRESS);
    for (int n = 0; n < NUMBERS; ++n) row[n] = n + .5;
    const fw_row_piece piece = {row, sizeof found, ADDRESS};
    const int descriptor = open(row_file, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    fw_row_writer *writer = fw_row_writer_create(descriptor, keep_reason, &reason);
    assert_non_null(writer);
    fw_row_writer_start(writer, &piece, 1);
    fw_row_writer_destroy(writer);
    const ssize_t moved = pread(descriptor, found, sizeof found, ADDRESS);
    close(descriptor);
    const bool same = moved == sizeof found && memcmp(found, row, sizeof found) == 0;
    free(memory);
    if (reason != 0) return fw_fail(&error, FW_SYSTEM_FAILED, "%s", strerror(reason));
    assert_true(same);
    return FW_OK;
}

/* What was there stays where the new file cannot be brought to disk. */
static fw_status expect_whole(fw_status status, const char *fresh_words)
{
    char *bytes;
    size_t size;
    fw_error ignored;
    assert_int_equal(fw_regular_file_read(&bytes, &size, file, 100, &ignored), FW_OK);
    assert_string_equal(bytes, status == FW_OK ? fresh_words : words);
    free(bytes);
    assert_int_equal(fw_whole_file_write(file, words, strlen(words), &ignored), FW_OK);
    return status;
}

static fw_status write_whole(void)
{
    return expect_whole(fw_whole_file_write(file, "other", 5, &error), "other");
}

static fw_status write_by_and_by(void)
{
    fw_whole_file *whole;
    FW_TRY(fw_whole_file_begin(&whole, file, &error));
    fputs("other", fw_whole_file_stream(whole));
    return expect_whole(fw_whole_file_commit(whole, &error), "other");
}

static const struct {
    attempted *attempt;
    refused_call kind;
    int which, reason;
    fw_status status;
    const char *says; /* %s: the file's or the folder's path */
} rows[] = {
    {read_file, REFUSED_OPEN, 1, EIO, FW_SYSTEM_FAILED, "cannot open %s: Input/output error"},
    {read_file, REFUSED_OPEN, 1, ENXIO, FW_BAD_INPUT, "%s is not a file"},
    {read_file, REFUSED_FSTAT, 1, EIO, FW_SYSTEM_FAILED, "cannot open %s: Input/output error"},
    {read_file, REFUSED_FSTAT, 2, EIO, FW_SYSTEM_FAILED, "cannot read %s: Input/output error"},
    {read_file, REFUSED_READ, 1, EINTR, FW_OK, NULL},
    {read_file, REFUSED_READ, 1, BY_HALF, FW_OK, NULL},
    {read_file, REFUSED_READ, 1, EIO, FW_SYSTEM_FAILED, "cannot read %s: Input/output error"},
    {make_new_folder, REFUSED_OPEN, 1, EMFILE, FW_SYSTEM_FAILED,
     "cannot open the folder %s: Too many open files"},
    {make_new_folder, REFUSED_FLOCK, 1, ENOLCK, FW_OK, NULL},
    {make_new_folder, REFUSED_FLOCK, 1, EWOULDBLOCK, FW_BAD_INPUT,
     "another run is writing into %s"},
    {make_new_folder, REFUSED_ACCESS, 1, EROFS, FW_SYSTEM_FAILED,
     "cannot write into the folder %s: Read-only file system"},
    {synchronise, REFUSED_FSYNC, 1, EINVAL, FW_OK, NULL},
    {synchronise, REFUSED_FSYNC, 1, EIO, FW_SYSTEM_FAILED,
     "cannot write the folder %s: Input/output error"},
    {claim_folder, REFUSED_OPEN, 1, EACCES, FW_SYSTEM_FAILED, "cannot make %s"},
    {claim_folder, REFUSED_OPEN, 1, ENOENT, FW_BAD_INPUT, NULL},
    {claim_folder, REFUSED_FLOCK, 1, ENOLCK, FW_SYSTEM_FAILED, "cannot lock %s"},
    {claim_folder, REFUSED_FLOCK, 1, EWOULDBLOCK, FW_BAD_INPUT, NULL},
    {claim_folder, REFUSED_FLOCK, 2, EWOULDBLOCK, FW_BAD_INPUT, NULL},
    {claim_folder, REFUSED_FSTAT, 1, EIO, FW_OK, NULL}, /* looked for once more */
    {seal_and_read, REFUSED_FSYNC, 1, EIO, FW_SYSTEM_FAILED, "cannot write %s"},
    {seal_and_read, REFUSED_FCLOSE, 1, ENOSPC, FW_SYSTEM_FAILED, "No space left on device"},
    {seal_and_read, REFUSED_FSTAT, 2, EIO, FW_SYSTEM_FAILED, "cannot read %s"},
    {seal_and_read, REFUSED_FREAD, 1, BY_HALF, FW_BAD_INPUT, "is cut short"},
    {seal_and_read, REFUSED_FREAD, 2, BY_HALF, FW_BAD_INPUT,
     "%s/sealed became shorter while it was read"},
    {add_up, REFUSED_PREAD, 1, EINTR, FW_OK, NULL},
    {add_up, REFUSED_PREAD, 1, BY_HALF, FW_OK, NULL},
    {add_up, REFUSED_PREAD, 1, NOTHING_MOVES, FW_SYSTEM_FAILED, "Input/output error"},
    {add_up, REFUSED_PREAD, 1, ESTALE, FW_SYSTEM_FAILED, "Stale file handle"},
    {write_row, REFUSED_PWRITE, 1, EINTR, FW_OK, NULL},
    {write_row, REFUSED_PWRITE, 1, BY_HALF, FW_OK, NULL},
    {write_row, REFUSED_PWRITE, 1, NOTHING_MOVES, FW_SYSTEM_FAILED, "Input/output error"},
    {write_row, REFUSED_PWRITE, 1, ENOSPC, FW_SYSTEM_FAILED, "No space left on device"},
    {write_row, REFUSED_OPEN, 2, EINVAL, FW_OK, NULL}, /* all goes through the cache */
    {write_long_row, REFUSED_OPEN, 2, EINVAL, FW_OK, NULL},
    {write_long_row, REFUSED_PWRITE, 1, EINTR, FW_OK, NULL},
    {write_long_row, REFUSED_PWRITE, 1, ENOSPC, FW_SYSTEM_FAILED, "No space left on device"},
    {write_whole, REFUSED_OPEN, 1, EACCES, FW_SYSTEM_FAILED, "words' (5 bytes): Permission denied"},
    {write_whole, REFUSED_FSYNC, 1, EIO, FW_SYSTEM_FAILED, "words' (5 bytes): Input/output error"},
    {write_whole, REFUSED_FSYNC, 1, EROFS, FW_OK, NULL}, /* there is nothing to synchronise */
    {write_whole, REFUSED_FSYNC, 1, ENOTSUP, FW_OK, NULL},
    {write_whole, REFUSED_FSYNC, 2, EIO, FW_OK, NULL}, /* of the folder */
    {write_by_and_by, REFUSED_OPEN, 1, EACCES, FW_SYSTEM_FAILED, "words': Permission denied"},
    {write_by_and_by, REFUSED_FSYNC, 1, EIO, FW_SYSTEM_FAILED, "words': Input/output error"},
    {write_by_and_by, REFUSED_FCLOSE, 1, ENOSPC, FW_SYSTEM_FAILED, "words': No space left"},
};

static void what_the_system_refuses_is_said_or_done_again(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char says[256];
        const char *path = rows[n].attempt == read_file         ? file
                           : rows[n].attempt == make_new_folder ? fresh
                           : rows[n].attempt == claim_folder    ? fresh
                                                                : parent;
        error = (fw_error){0};
        refuse_call(rows[n].kind, rows[n].which, rows[n].reason);
        const fw_status status = rows[n].attempt();
        if (!call_was_refused()) fail_msg("row %zu: there is no such call", n);
        if (status != rows[n].status)
            fail_msg("row %zu: status %d: %s", n, (int)status, error.sentence);
        if (!rows[n].says) continue;
        snprintf(says, sizeof says, rows[n].says, path);
        if (!strstr(error.sentence, says))
            fail_msg("row %zu: '%s' does not speak of '%s'", n, error.sentence, says);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_the_system_refuses_is_said_or_done_again, begin, end)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
