/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_durability.c - what a loss of power would leave: a recorder sees that every file is on the
 * disk with all its bytes before it gets its name, its name before anything that follows, and
 * frames before the checkpoint that counts them. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

enum { EVENTS_MAX = 20000 };

typedef struct event {
    char what; /* w, f, r */
    long long size;
    char path[160], to[160];
} event;

static event events[EVENTS_MAX];
static int event_count;

static const char study[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 60, record-every: 5, measure-every: 5, checkpoint-every: 20}\n"
    "measure: [energy]\n"
    "profile: {every: 5, bin: 1, middle: 2, far: [0.5, 3]}\n"
    "study: {seeds: 2}\n"
    "expect: [{quantity: layer-temperature, above: 0}]\n"
    "pictures: {energy: {kind: series, observables: [energy]}}\n";

static void read_events(const char *name)
{
    char word[16];
    FILE *in = fopen(name, "r");
    assert_non_null(in);
    for (event_count = 0; event_count < EVENTS_MAX; ++event_count) {
        event *e = &events[event_count];
        *e = (event){0};
        if (fscanf(in, "%15s %lld %159s", word, &e->size, e->path) != 3) break;
        e->what = word[0];
        if (e->what == 'r') assert_int_equal(fscanf(in, "%159s", e->to), 1);
    }
    fclose(in);
    assert_in_range(event_count, 20, EVENTS_MAX - 1);
}

/* The last event of a file before another event, or -1. */
static int last_before(int before, const char *path)
{
    for (int n = before - 1; n >= 0; --n)
        if (events[n].what != 'r' && strcmp(events[n].path, path) == 0) return n;
    return -1;
}

static bool ends_with(const char *text, const char *end)
{
    const size_t length = strlen(text), tail = strlen(end);
    return length >= tail && strcmp(text + length - tail, end) == 0;
}

/* Bytes first: the last that was done to it was to bring all of it to the disk. */
static void assert_whole(int rename)
{
    const event *named = &events[rename];
    const int last = last_before(rename, named->path);
    if (last < 0 || events[last].what != 'f')
        fail_msg("%s gets its name before it is on the disk", named->to);
    if (events[last].size != named->size)
        fail_msg("%s has %lld bytes, %lld on the disk", named->to, named->size, events[last].size);
}

/* Then the name: its folder is brought to the disk before anything else is renamed or written. */
static void assert_named(int rename)
{
    char folder[160];
    snprintf(folder, sizeof folder, "%.*s",
             (int)(strrchr(events[rename].to, '/') - events[rename].to), events[rename].to);
    const event *next = &events[rename + 1];
    if (rename + 1 >= event_count || next->what != 'f' || strcmp(next->path, folder) != 0)
        fail_msg("the name of %s is not on the disk", events[rename].to);
}

/* What a checkpoint counts is on the disk before it. */
static void assert_frames(int rename)
{
    char frames[200];
    const char *to = events[rename].to;
    snprintf(frames, sizeof frames, "%.*s/trajectory.h5", (int)(strrchr(to, '/') - to), to);
    const int last = last_before(rename, frames);
    if (last >= 0 && events[last].what != 'f') fail_msg("frames are not there before %s", to);
}

static void everything_is_on_the_disk_before_what_follows(void **state)
{
    (void)state;
#ifdef FW_ASSERTS_EXPECTED
    skip(); /* the sanitizers must be loaded before anything else */
#endif
    char folder[64], line[900], path[96];
    int checkpoints = 0, tables = 0, pictures = 0, frames = 0;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", study);
    /* Runs one after the other, so that their events are not mixed. */
    snprintf(line, sizeof line,
             "OMP_WAIT_POLICY=passive FW_DISK_RECORD='%s/record' LD_PRELOAD='%s' '%s' run gas.yaml "
             "-q --threads 1 -o it > out",
             folder, FW_RECORDER, FW_PROGRAM);
    shell(folder, line);
    snprintf(path, sizeof path, "%s/record", folder);
    read_events(path);
    for (int n = 0; n < event_count; ++n) {
        frames += events[n].what == 'w' && ends_with(events[n].path, ".h5");
        if (events[n].what != 'r') continue;
        assert_whole(n);
        assert_named(n);
        if (strstr(events[n].to, "/checkpoint-")) assert_frames(n);
        checkpoints += strstr(events[n].to, "/checkpoint-") != NULL;
        tables += ends_with(events[n].to, ".csv");
        pictures += ends_with(events[n].to, ".png");
    }
    assert_true(checkpoints >= 3 && tables >= 2 && pictures >= 1 && frames > 0);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_on_the_disk_before_what_follows)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
