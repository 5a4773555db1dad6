/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_encoder.c - films by programs that stand in for ffmpeg: what they get, and what is said and
 * left where they fail. */
#include "tests/support/laws.h"

#include "experiments/drawing/encoder.h"
#include "tests/support/scratch.h"

#include <stdio.h>
#include <sys/stat.h>

/* More than a pipe holds. */
enum { LARGE = 1 << 18, HEAD = 24 };

static char folder[64], film[96], kept_path[4096];

static void write_picture(const char *name, size_t size, char width)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (size_t n = 0; n < size; ++n) fputc(n == HEAD - 5 ? width : 'x', file);
    fclose(file);
}

/* The program that is found as ffmpeg; NULL: there is none. */
static void write_ffmpeg(const char *script)
{
    char path[96];
    snprintf(path, sizeof path, "%s/ffmpeg", folder);
    unlink(path);
    if (!script) return;
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "#!/bin/sh\nPATH='%s'\n%s\n", kept_path, script);
    fchmod(fileno(file), 0755);
    fclose(file);
}

static fw_status make_film(const char *const *pictures)
{
    fw_encoder *encoder;
    FW_TRY(fw_encoder_begin(&encoder, film, 30, &error));
    for (; *pictures; ++pictures) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, *pictures);
        const fw_status status = fw_encoder_add(encoder, path, &error);
        if (status == FW_OK) continue;
        fw_encoder_abandon(encoder);
        return status;
    }
    return fw_encoder_commit(encoder, &error);
}

static void all_pictures_come_in_order(void **state)
{
    (void)state;
    char line[8192];
    write_ffmpeg("cd ${0%/*} && echo \"$@\" >words && for last; do :; done && cat >\"$last\"");
    assert_fine(make_film((const char *[]){"small", "large", "small", NULL}));
    snprintf(
        line, sizeof line,
        "PATH=%s; cd %s && cat small large small | cmp - film.gif && grep -q -- '-framerate 30 -i "
        "pipe:0 .*-f gif' words",
        kept_path, folder);
    assert_int_equal(system(line), 0);
    unlink(film);
}

static void a_film_that_fails_says_why_and_leaves_nothing(void **state)
{
    (void)state;
    static const struct {
        const char *script, *pictures[4];
        const char *sentence;
    } rows[] = {
        {NULL, {"small"}, "there is no program ffmpeg, which makes films: install its package"},
        {"cat >/dev/null; exit 3",
         {"small"},
         "ffmpeg cannot make the film: it ended without a word"},
        {"echo no room >&2; echo at all >&2; exit 1",
         {"small"},
         "ffmpeg cannot make the film: no room"},
        {"echo tired >&2; kill -9 $$", {"large"}, "ffmpeg cannot make the film: tired"},
        {"exit 0", {"large", "large"}, "ffmpeg ended before the film did"},
        {"cat >/dev/null", {"small", "wide"}, "the pictures of a film are not equally large"},
        {"cat >/dev/null", {"short"}, "/short is no picture"},
        {"cat >/dev/null", {"small", "nowhere"}, "/nowhere"},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char line[8192];
        write_ffmpeg(rows[n].script);
        const fw_status status = make_film(rows[n].pictures);
        if (status == FW_OK || !strstr(error.sentence, rows[n].sentence))
            fail_msg("row %zu: '%s' is not '%s'", n, error.sentence, rows[n].sentence);
        snprintf(line, sizeof line, "PATH=%s; test -z \"$(ls -A %s | grep -i film)\"", kept_path,
                 folder);
        assert_int_equal(system(line), 0);
    }
    fw_encoder_abandon(NULL);
}

static int set_up(void **state)
{
    (void)state;
    const char *path = getenv("PATH");
    snprintf(kept_path, sizeof kept_path, "%s", path ? path : "");
    make_folder(folder, sizeof folder);
    snprintf(film, sizeof film, "%s/film.gif", folder);
    write_picture("small", 100, 'a');
    write_picture("large", LARGE, 'a');
    write_picture("wide", 100, 'b');
    write_picture("short", HEAD - 1, 'a');
    return setenv("PATH", folder, 1);
}

static int tear_down(void **state)
{
    (void)state;
    setenv("PATH", kept_path, 1);
    remove_folder(folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_pictures_come_in_order),
        cmocka_unit_test(a_film_that_fails_says_why_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
