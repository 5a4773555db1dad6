/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_checkpoint.c - a state that was saved comes back, or not a byte of the present one changes.
 */
#include "tests/support/laws.h"

#include "experiments/results/checkpoint.h"
#include "tests/support/recorded_run.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#define SCENARIO "title: bounce\n"

/* Two objects with an array of each type, one of them empty. */
typedef struct model {
    double x[7], y[7];
    int32_t owner[5];
    int64_t ticks;
    uint8_t broken[3];
    fw_state_list sheet, clock;
    fw_checkpoint_section sections[2];
} model;

static void model_fill(model *made, int64_t step)
{
    *made = (model){.ticks = step};
    for (int i = 0; i < 7; ++i) {
        made->x[i] = sin((double)(step + i));
        made->y[i] = -1.0 / (double)(step + i + 1);
    }
    for (int i = 0; i < 5; ++i) made->owner[i] = (int32_t)step - i;
    for (int i = 0; i < 3; ++i) made->broken[i] = (uint8_t)(step * 50 + i);
    fw_state_list_add(&made->sheet, "position-x", FW_F64, 7, made->x);
    fw_state_list_add(&made->sheet, "position-y", FW_F64, 7, made->y);
    fw_state_list_add(&made->sheet, "owner", FW_I32, 5, made->owner);
    fw_state_list_add(&made->sheet, "nothing", FW_F64, 0, made->x);
    fw_state_list_add(&made->clock, "ticks", FW_I64, 1, &made->ticks);
    fw_state_list_add(&made->clock, "broken", FW_U8, 3, made->broken);
    made->sections[0] = (fw_checkpoint_section){"body sheet", &made->sheet};
    made->sections[1] = (fw_checkpoint_section){"scene", &made->clock};
}

static uint64_t model_hash(const model *made)
{
    return fw_state_list_hash(&made->sheet) ^ (3 * fw_state_list_hash(&made->clock));
}

static uint64_t hash_at(int64_t step)
{
    model made;
    model_fill(&made, step);
    return model_hash(&made);
}

static fw_checkpoint *open_in(const char *folder)
{
    fw_checkpoint *checkpoint;
    assert_fine(fw_checkpoint_open(&checkpoint, folder, SCENARIO, &error));
    return checkpoint;
}

static void save(fw_checkpoint *checkpoint, int64_t step)
{
    model saved;
    model_fill(&saved, step);
    assert_fine(fw_checkpoint_write(checkpoint, saved.sections, 2, step, &error));
}

static void saved_state_comes_back(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    for (int64_t step = 1; step <= 4; ++step) {
        model loaded;
        fw_checkpoint_origin origin;
        save(checkpoint, step);
        model_fill(&loaded, 1000);
        assert_fine(fw_checkpoint_load(checkpoint, loaded.sections, 2, &origin, &error));
        assert_true(model_hash(&loaded) == hash_at(step));
        assert_int_equal(origin.step, step);
        assert_string_equal(origin.name, step % 2 == 1 ? "checkpoint-A" : "checkpoint-B");
        assert_false(origin.fallen_back);
        /* Another process finds the same. */
        fw_checkpoint_close(checkpoint);
        checkpoint = open_in(folder);
        model_fill(&loaded, 1000);
        assert_fine(fw_checkpoint_load(checkpoint, loaded.sections, 2, NULL, &error));
        assert_true(model_hash(&loaded) == hash_at(step));
    }
    fw_checkpoint_close(checkpoint);
    remove_folder(folder);
}

static size_t read_file(const char *path, unsigned char *bytes, size_t capacity)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, capacity, file);
    fclose(file);
    assert_true(size > 0 && size < capacity);
    return size;
}

static void write_file(const char *path, const unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

/* The newer checkpoint with one bit turned, at every bit, and cut short, at every length. */
static void every_damage_falls_back_to_the_older_checkpoint(void **state)
{
    (void)state;
    char folder[64], path[128];
    unsigned char whole[2048], damaged[2048];
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    save(checkpoint, 1);
    save(checkpoint, 2);
    snprintf(path, sizeof path, "%s/checkpoint-B", folder);
    size_t size = read_file(path, whole, sizeof whole);
    for (size_t trial = 0; trial < 9 * size; ++trial) {
        model loaded;
        fw_checkpoint_origin origin;
        size_t length = trial < 8 * size ? size : trial - 8 * size;
        memcpy(damaged, whole, size);
        if (length == size) damaged[trial / 8] ^= (unsigned char)(1u << trial % 8);
        write_file(path, damaged, length);
        model_fill(&loaded, 1000);
        assert_fine(fw_checkpoint_load(checkpoint, loaded.sections, 2, &origin, &error));
        assert_true(model_hash(&loaded) == hash_at(1));
        assert_int_equal(origin.step, 1);
        assert_true(origin.fallen_back);
        assert_non_null(strstr(origin.newer_error.sentence, "checkpoint-B"));
    }
    /* What is written next replaces the damaged file, not the whole one. */
    save(checkpoint, 3);
    snprintf(path, sizeof path, "%s/checkpoint-A", folder);
    write_file(path, whole, 10);
    model loaded;
    model_fill(&loaded, 1000);
    assert_fine(fw_checkpoint_load(checkpoint, loaded.sections, 2, NULL, &error));
    assert_true(model_hash(&loaded) == hash_at(3));
    fw_checkpoint_close(checkpoint);
    remove_folder(folder);
}

static void without_a_whole_checkpoint_nothing_changes(void **state)
{
    (void)state;
    char folder[64], path[128];
    model present;
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    model_fill(&present, 9);
    assert_refused(fw_checkpoint_load(checkpoint, present.sections, 2, NULL, &error), FW_BAD_INPUT,
                   "no checkpoint");
    static const struct {
        const char *content, *words;
    } files[] = {{"", "cut short"},
                 {"FWCHECKP", "cut short"},
                 {"a text that somebody put here, longer than the least checkpoint", "kind"}};
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        snprintf(path, sizeof path, "%s/checkpoint-A", folder);
        write_file(path, (const unsigned char *)files[i].content, strlen(files[i].content));
        assert_refused(fw_checkpoint_load(checkpoint, present.sections, 2, NULL, &error),
                       FW_BAD_INPUT, files[i].words);
        assert_true(model_hash(&present) == hash_at(9));
    }
    assert_int_equal(unlink(path), 0);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_refused(fw_checkpoint_load(checkpoint, present.sections, 2, NULL, &error), FW_BAD_INPUT,
                   "not a file");
    fw_checkpoint_close(checkpoint);
    assert_refused(fw_checkpoint_open(&checkpoint, "/tmp/fretwork-no-such", SCENARIO, &error),
                   FW_BAD_INPUT, "No such file");
    remove_folder(folder);
}

/* Every sentence about a checkpoint of something else; the present state stays as it is. */
static void checkpoint_of_another_state_is_refused(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    save(checkpoint, 1);
    static const char *const words[] = {
        "2 sections of the run, expected are 1",
        "the section 'body sheet' where 'body slab'",
        "4 arrays of body sheet, expected are 3",
        "the array 'position-y' where 'position-z'",
        "5 elements of type 1 in 'owner' of 'body sheet', expected are 4",
        "5 elements of type 1 in 'owner' of 'body sheet', expected are 5 of type 3",
    };
    for (int change = 0; change < 6; ++change) {
        model present;
        model_fill(&present, 9);
        if (change == 1) present.sections[0].name = "body slab";
        if (change == 2) present.sheet.count -= 1;
        if (change == 3) present.sheet.array[1].name = "position-z";
        if (change == 4) present.sheet.array[2].count = 4;
        if (change == 5) present.sheet.array[2].element = FW_U8;
        uint64_t before = model_hash(&present);
        assert_refused(
            fw_checkpoint_load(checkpoint, present.sections, change == 0 ? 1 : 2, NULL, &error),
            FW_BAD_INPUT, words[change]);
        assert_true(model_hash(&present) == before);
    }
    fw_checkpoint_close(checkpoint);
    assert_fine(fw_checkpoint_open(&checkpoint, folder, "title: slide\n", &error));
    model present;
    model_fill(&present, 9);
    assert_refused(fw_checkpoint_load(checkpoint, present.sections, 2, NULL, &error), FW_BAD_INPUT,
                   "another scenario");
    fw_checkpoint_close(checkpoint);
    remove_folder(folder);
}

/* The payload that a checkpoint file holds between its header of 24 bytes and its checksum. */
static size_t payload_of(const char *folder, unsigned char *payload, size_t capacity)
{
    char path[128];
    snprintf(path, sizeof path, "%s/checkpoint-A", folder);
    size_t size = read_file(path, payload, capacity);
    memmove(payload, payload + 24, size - 32);
    return size - 32;
}

/* Behind a right checksum any bytes may come: the reader meets 200 000 payloads with some bytes
 * changed, lengths among them, or cut short, and either refuses or loads arrays of the right size.
 * The sanitizers tell whether it ever reads or writes elsewhere. */
static void any_bytes_are_read_safely(void **state)
{
    (void)state;
    char folder[64];
    unsigned char payload[2048];
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    save(checkpoint, 1);
    size_t size = payload_of(folder, payload, sizeof payload);
    uint64_t scenario = fw_checkpoint_hash(SCENARIO), random = 12345;
    int refused = 0, loaded = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        size_t length = trial % 3 == 0 ? (random >> 33) % size : size;
        unsigned char *exact = malloc(length + 1); /* so that one byte too many is noticed */
        assert_non_null(exact);
        memcpy(exact, payload, length);
        for (int change = 0; change < 1 + trial % 4 && length > 0; ++change) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            static const unsigned char edges[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
            exact[(random >> 20) % length] =
                trial % 2 == 0 ? edges[(random >> 50) % 5] : (unsigned char)(random >> 56);
        }
        model present;
        int64_t step;
        model_fill(&present, 9);
        fw_status status =
            fw_checkpoint_decode(exact, length, scenario, present.sections, 2, &step, &error);
        if (status == FW_OK) {
            ++loaded;
        } else {
            ++refused;
            assert_int_equal(status, FW_BAD_INPUT);
            assert_true(model_hash(&present) == hash_at(9));
        }
        free(exact);
    }
    assert_true(refused > 100000 && loaded > 1000);
    fw_checkpoint_close(checkpoint);
    remove_folder(folder);
}

/* A limit on file sizes stands for a full disk: writing fails in the same place. */
static void failed_write_leaves_the_earlier_checkpoints(void **state)
{
    (void)state;
    char folder[64], command[128];
    make_folder(folder, sizeof folder);
    fw_checkpoint *checkpoint = open_in(folder);
    save(checkpoint, 1);
    save(checkpoint, 2);
    struct rlimit before, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 200;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    model present;
    model_fill(&present, 3);
    fw_status status = fw_checkpoint_write(checkpoint, present.sections, 2, 3, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_DFL);
    assert_int_equal(status, FW_SYSTEM_FAILED);
    assert_non_null(strstr(error.sentence, "checkpoint-A"));
    snprintf(command, sizeof command, "test $(ls %s | wc -l) = 2", folder);
    assert_int_equal(system(command), 0);
    fw_checkpoint_origin origin;
    assert_fine(fw_checkpoint_load(checkpoint, present.sections, 2, &origin, &error));
    assert_int_equal(origin.step, 2);
    assert_false(origin.fallen_back);
    save(checkpoint, 3);
    assert_fine(fw_checkpoint_load(checkpoint, present.sections, 2, &origin, &error));
    assert_int_equal(origin.step, 3);
    fw_checkpoint_close(checkpoint);
    remove_folder(folder);
}

/* A writer that reports every checkpoint it has written is killed while it writes the next ones. */
static void killed_writer_leaves_its_last_checkpoint(void **state)
{
    (void)state;
    for (int trial = 0; trial < 30; ++trial) {
        char folder[64];
        int channel[2];
        make_folder(folder, sizeof folder);
        assert_int_equal(pipe(channel), 0);
        pid_t writer = fork();
        assert_true(writer >= 0);
        if (writer == 0) {
            fw_checkpoint *checkpoint = open_in(folder);
            for (int64_t step = 1;; ++step) {
                save(checkpoint, step);
                if (write(channel[1], &step, sizeof step) != sizeof step) _exit(1);
            }
        }
        close(channel[1]);
        int64_t reported = 0, next;
        assert_int_equal(read(channel[0], &reported, sizeof reported), sizeof reported);
        usleep((useconds_t)(trial * 397 % 10000));
        kill(writer, SIGKILL);
        waitpid(writer, NULL, 0);
        while (read(channel[0], &next, sizeof next) == sizeof next) reported = next;
        close(channel[0]);
        fw_checkpoint *checkpoint = open_in(folder);
        fw_checkpoint_origin origin;
        model loaded;
        model_fill(&loaded, 1000);
        assert_fine(fw_checkpoint_load(checkpoint, loaded.sections, 2, &origin, &error));
        assert_true(origin.step == reported || origin.step == reported + 1);
        assert_false(origin.fallen_back);
        assert_true(model_hash(&loaded) == hash_at(origin.step));
        fw_checkpoint_close(checkpoint);
        remove_folder(folder);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(saved_state_comes_back),
        cmocka_unit_test(every_damage_falls_back_to_the_older_checkpoint),
        cmocka_unit_test(without_a_whole_checkpoint_nothing_changes),
        cmocka_unit_test(checkpoint_of_another_state_is_refused),
        cmocka_unit_test(any_bytes_are_read_safely),
        cmocka_unit_test(failed_write_leaves_the_earlier_checkpoints),
        cmocka_unit_test(killed_writer_leaves_its_last_checkpoint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
