/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_long_rows.c - rows that are written while the program goes on: every byte comes to its place
 * and no other, rows that count are whole whenever the writer is killed, and what the disk refuses
 * is told. */
#include "tests/support/laws.h"

#include "experiments/storage/row_writer.h"
#include "experiments/storage/series.h"
#include "tests/support/scratch.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

static uint64_t draw(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return *seed >> 33;
}

/* --- pieces --- */

enum { FILE_BYTES = 1 << 21 };

static int reasons;

static void note(void *owner, int reason)
{
    *(int *)owner += 1;
    reasons += reason != 0;
}

static void every_byte_comes_to_its_place(void **state)
{
    enum { TRIALS = 40 };
    static char expected[FILE_BYTES], found[FILE_BYTES];
    char folder[64], path[96];
    uint64_t seed = 5;
    int written = 0;
    (void)state;
    make_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/bytes", folder);
    const int file = open(path, O_RDWR | O_CREAT, 0600);
    assert_true(file >= 0 && pwrite(file, expected, FILE_BYTES, 0) == FILE_BYTES);
    fw_row_writer *writer = fw_row_writer_create(file, note, &written);
    assert_non_null(writer);
    reasons = 0;
    for (int trial = 0; trial < TRIALS; ++trial) {
        fw_row_piece pieces[2];
        void *memory[2];
        for (int n = 0; n < 2; ++n) {
            const size_t bytes = draw(&seed) % (trial % 4 == 0 ? 9000 : 800000) + 1;
            const uint64_t any = (uint64_t)n * FILE_BYTES / 2 + draw(&seed) % 9000;
            const uint64_t address = trial % 3 == 0 ? any : any / 8 * 8;
            memory[n] = fw_row_memory(bytes);
            assert_non_null(memory[n]);
            char *row = fw_row_place(memory[n], address);
            for (size_t b = 0; b < bytes; ++b) row[b] = (char)draw(&seed);
            memcpy(expected + address, row, bytes);
            pieces[n] = (fw_row_piece){row, bytes, address};
        }
        fw_row_writer_start(writer, pieces, 2);
        fw_row_writer_wait(writer);
        assert_true(pread(file, found, FILE_BYTES, 0) == FILE_BYTES);
        assert_memory_equal(found, expected, FILE_BYTES);
        for (int n = 0; n < 2; ++n) free(memory[n]);
    }
    fw_row_writer_destroy(writer);
    assert_int_equal(written, TRIALS);
    assert_int_equal(reasons, 0);
    close(file);
    remove_folder(folder);
}

/* --- series --- */

enum { LONG = 150000, ROWS = 12 };

static double value_at(int64_t row, int quantity, int k)
{
    return (double)row * 3e6 + quantity * 1e6 + k;
}

/* Two long quantities and a short one. The file has an odd number of bytes in front of them. */
static fw_series *series_of(fw_hdf5 *file, bool fresh)
{
    const uint64_t wide[] = {LONG / 3, 3}, narrow[] = {LONG};
    if (fresh) fw_hdf5_write_text(file, fw_hdf5_make_text(file, "odd", 13), "odd");
    fw_series *series = fw_series_create(file, "committed", fresh, 1, 0);
    assert_non_null(series);
    assert_int_equal(fw_series_add(series, "wide", 2, wide), 0);
    assert_int_equal(fw_series_add(series, "short", 0, NULL), 1);
    assert_int_equal(fw_series_add(series, "narrow", 1, narrow), 2);
    if (fresh) fw_series_reserve(series, ROWS);
    return series;
}

static void add_row(fw_series *series, int64_t row)
{
    const double single = value_at(row, 1, 0);
    for (int quantity = 0; quantity < 3; quantity += 2) {
        double *values = fw_series_fill(series, quantity);
        for (int k = 0; k < LONG; ++k) values[k] = value_at(row, quantity, k);
    }
    fw_series_write(series, 1, &single);
    fw_series_end_row(series, row * 10, (double)row);
}

/* Rows that count are right; returns how many there are. */
static int64_t check_rows(const char *path)
{
    fw_hdf5 *file;
    int64_t rows = -1;
    double *values = malloc(LONG * sizeof *values), single;
    assert_non_null(values);
    assert_fine(fw_hdf5_open(&file, path, false, &error));
    fw_hdf5_read(file, fw_hdf5_find(file, "committed"), FW_I64, 0, 1, &rows);
    for (int64_t row = 0; row < rows; ++row) {
        for (int quantity = 0; quantity < 3; quantity += 2) {
            const char *name = quantity == 0 ? "wide/value" : "narrow/value";
            fw_hdf5_read(file, fw_hdf5_find(file, name), FW_F64, (uint64_t)row, 1, values);
            for (int k = 0; k < LONG; ++k)
                if (values[k] != value_at(row, quantity, k))
                    fail_msg("%s of row %lld, number %d is %g", name, (long long)row, k, values[k]);
        }
        fw_hdf5_read(file, fw_hdf5_find(file, "short/value"), FW_F64, (uint64_t)row, 1, &single);
        assert_true(single == value_at(row, 1, 0));
    }
    assert_fine(fw_hdf5_close(file, &error));
    free(values);
    return rows;
}

static void make_file(fw_hdf5 **file, const char *path)
{
    assert_fine(fw_hdf5_create(file, path, 65536, &error));
}

static void rows_read_back_however_they_were_cut(void **state)
{
    char folder[64], path[96];
    fw_hdf5 *file;
    (void)state;
    make_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/rows.h5", folder);
    make_file(&file, path);
    fw_series *series = series_of(file, true);
    for (int64_t row = 0; row < 5; ++row) add_row(series, row);
    fw_series_rewind(series, 3);
    for (int64_t row = 3; row < 6; ++row) add_row(series, row);
    assert_int_equal(fw_series_count(series), 6);
    fw_series_reserve(series, 6);
    fw_series_destroy(series);
    assert_fine(fw_hdf5_close(file, &error));
    assert_int_equal(check_rows(path), 6);
    assert_fine(fw_hdf5_open(&file, path, true, &error));
    series = series_of(file, false);
    fw_series_reserve(series, ROWS);
    for (int64_t row = 6; row < ROWS; ++row) add_row(series, row);
    /* The last row is still being written. */
    fw_series_destroy(series);
    assert_fine(fw_hdf5_close(file, &error));
    assert_int_equal(check_rows(path), ROWS);
    remove_folder(folder);
}

/* A long row that ends counts at once, as soon as it is written, and not with the next. */
static void row_counts_without_another(void **state)
{
    char folder[64], path[96];
    fw_hdf5 *file;
    (void)state;
    make_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/rows.h5", folder);
    make_file(&file, path);
    fw_series *series = series_of(file, true);
    add_row(series, 0);
    int64_t rows = 0;
    for (int wait = 0; wait < 3000 && rows == 0; ++wait) {
        usleep(10000);
        fw_hdf5_read(file, fw_hdf5_find(file, "committed"), FW_I64, 0, 1, &rows);
    }
    assert_int_equal(rows, 1);
    fw_series_destroy(series);
    assert_fine(fw_hdf5_close(file, &error));
    remove_folder(folder);
}

static void killed_writer_leaves_whole_rows(void **state)
{
    enum { WRITERS = 12, LONGEST_LIFE = 60000 };
    char folder[64], path[96];
    int64_t rows = 0;
    uint64_t seed = 9;
    (void)state;
    make_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/rows.h5", folder);
    for (int n = 0; n < WRITERS; ++n) {
        int status, ready[2];
        char byte = 0;
        assert_int_equal(pipe(ready), 0);
        const pid_t writer = fork();
        assert_true(writer >= 0);
        if (writer == 0) {
            fw_hdf5 *file;
            make_file(&file, path);
            fw_series *series = series_of(file, true);
            fw_hdf5_flush(file);
            if (write(ready[1], &byte, 1) != 1) _exit(1);
            for (int64_t row = 0; row < ROWS; ++row) add_row(series, row);
            for (;;) pause();
        }
        close(ready[1]);
        assert_true(read(ready[0], &byte, 1) == 1);
        close(ready[0]);
        usleep((useconds_t)(draw(&seed) % LONGEST_LIFE));
        kill(writer, SIGKILL);
        waitpid(writer, &status, 0);
        assert_true(WIFSIGNALED(status));
        rows += check_rows(path);
    }
    assert_true(rows > 0);
    remove_folder(folder);
}

static void refused_row_is_told(void **state)
{
    char folder[64], path[96];
    fw_hdf5 *file;
    struct rlimit before;
    (void)state;
    make_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/rows.h5", folder);
    make_file(&file, path);
    fw_series *series = series_of(file, true);
    add_row(series, 0);
    fw_series_commit(series);
    assert_fine(fw_hdf5_check(file, &error));
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit small = {500, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    add_row(series, 1);
    fw_series_commit(series);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    char sentence[160];
    snprintf(sentence, sizeof sentence, "cannot write %s: File too large", path);
    assert_refused(fw_hdf5_check(file, &error), FW_SYSTEM_FAILED, sentence);
    add_row(series, 2); /* does no harm */
    fw_series_destroy(series);
    assert_int_equal(fw_hdf5_close(file, &error), FW_SYSTEM_FAILED);
    assert_int_equal(check_rows(path), 1);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_byte_comes_to_its_place),
        cmocka_unit_test(rows_read_back_however_they_were_cut),
        cmocka_unit_test(row_counts_without_another),
        cmocka_unit_test(killed_writer_leaves_whole_rows),
        cmocka_unit_test(refused_row_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
