/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_film.c - a film has a frame for each frame of the result, all with the same axes and
 * colours: what is beside and below the bodies stays as it is. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char scenario[] =
    "title: a body goes to the right\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies: {block: {material: soft, shape: {rectangle: [4, 3]}, velocity: [.5, 0]}}\n"
    "forces: {pull: {body: block, sites: right, total: [.3, 0], ramp: 20}}\n"
    "run: {steps: 20, record-every: 2}\n"
    "record: {fields: [strain-xx]}\n"
    "measure: [energy]\n";

static void make_result(char *folder, size_t size)
{
    make_quick_folder(folder, size);
    write_scenario(folder, "file.yaml", scenario);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
}

static bool has_ffmpeg(void)
{
    const bool there = system("ffmpeg -version >/dev/null 2>&1") == 0;
    if (!there && getenv("FW_FFMPEG_EXPECTED")) fail_msg("no ffmpeg here");
    return there;
}

/* The leftmost pixels of all frames, in grey. */
static unsigned char *read_margin(const char *folder, const char *film, long *size)
{
    char line[256], path[128];
    snprintf(line, sizeof line,
             "ffmpeg -v error -y -i %s -vf crop=48:in_h-40:0:40 -f rawvideo -pix_fmt gray margin",
             film);
    shell(folder, line);
    snprintf(path, sizeof path, "%s/margin", folder);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = ftell(file);
    rewind(file);
    unsigned char *bytes = malloc((size_t)*size);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, (size_t)*size, file), *size);
    fclose(file);
    return bytes;
}

static void check_film(const char *folder, const char *film, int frames)
{
    enum { ROUNDING = 96 }; /* by compression, of 255 */
    long size;
    unsigned char *bytes = read_margin(folder, film, &size);
    assert_int_equal(size % frames, 0);
    const long frame = size / frames;
    assert_true(frame > 48 * 100);
    int darkest = 255;
    for (long n = 0; n < size; ++n) {
        darkest = bytes[n] < darkest ? bytes[n] : darkest;
        if (abs(bytes[n] - bytes[n % frame]) > ROUNDING)
            fail_msg("%s: the margin of frame %ld is another one", film, n / frame);
    }
    assert_in_range(darkest, 0, 100); /* there are numbers */
    free(bytes);
}

static void film_has_all_frames_on_the_same_axes(void **state)
{
    (void)state;
    static const char *const lines[] = {"film out -o film.mp4",
                                        "film out -o film.webm --kind motion",
                                        "film out -o film.gif --field strain-xx --range 0,.01"};
    static const char *const names[] = {"film.mp4", "film.webm", "film.gif"};
    char folder[64];
    if (!has_ffmpeg()) skip();
    make_result(folder, sizeof folder);
    for (int n = 0; n < 3; ++n) {
        const outcome seen = run_program(folder, lines[n]);
        expect_end(&seen, 0, "");
        assert_non_null(strstr(seen.out, "11 frames, 0.44 s"));
        check_film(folder, names[n], 11);
    }
    outcome seen = run_program(folder, "film out -o film.mp4 --every 5 --rate 1");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "3 frames, 3 s"));
    check_film(folder, "film.mp4", 3);
    remove_folder(folder);
}

/* A wall that goes away makes no frame larger; what was recorded for maps of friction is no field
 * that anybody named. */
static void film_keeps_its_size_where_walls_move(void **state)
{
    (void)state;
    static const char moved[] =
        "title: a piston goes up from a block that slides\n"
        "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
        "bodies: {block: {material: soft, shape: {rectangle: [4, 3]}, velocity: [.1, 0]}}\n"
        "walls:\n"
        "  floor: {chain: [[-9, -.01], [19, -.01]], surface: {coulomb: 0.3}}\n"
        "  lid: {box: [-1, 2.1, 6, 4], side: outside, piston: {mass: 5, velocity: [0, .1]}}\n"
        "forces: {weight: {body: block, acceleration: [0, -.01]}}\n"
        "run: {steps: 20, record-every: 2}\n"
        "measure: [energy]\n"
        "pictures: {where: {kind: slip}}\n";
    char folder[64];
    if (!has_ffmpeg()) skip();
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", moved);
    outcome seen = run_program(
        folder, "run file.yaml -o out --no-plot --quiet --set record.fields=[friction-heat]");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "film out -o film.mp4");
    expect_end(&seen, 0, "");
    check_film(folder, "film.mp4", 11);
    seen = run_program(
        folder, "run file.yaml -o out --overwrite --no-plot --quiet --set record.fields=[speed]");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "film out -o film.mp4 --field speed");
    expect_end(&seen, 0, "");
    check_film(folder, "film.mp4", 11);
    remove_folder(folder);
}

static void film_refuses_what_it_cannot_do(void **state)
{
    (void)state;
    static const char *const refused[][2] = {
        {"film out", "expected -o and a name that ends in .mp4, .webm or .gif"},
        {"film out -o film.avi", "film.avi"},
        {"film out -o film.mp4 --kind series", "series"},
        {"film out -o film.mp4 --field nothing", "nothing"},
        {"film out -o film.mp4 --range 2,1", "--range"},
        {"film out -o film.mp4 --rate 0", "--rate"},
        {"film missing -o film.mp4", "missing"},
    };
    char folder[64];
    make_result(folder, sizeof folder);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n) {
        const outcome seen = run_program(folder, refused[n][0]);
        expect_end(&seen, 2, refused[n][1]);
        assert_false(exists(folder, "film.mp4"));
    }
    remove_folder(folder);
}

/* Without ffmpeg, and with one that fails: a sentence, and nothing is left. */
static void film_that_fails_leaves_nothing(void **state)
{
    (void)state;
    char folder[64], path[128];
    const char *before = getenv("PATH");
    char kept[4096];
    snprintf(kept, sizeof kept, "%s", before ? before : "");
    make_result(folder, sizeof folder);
    shell(folder,
          "mkdir none bad; printf '#!/bin/sh\\necho it is full >&2\\nexit 1\\n' >bad/ffmpeg; "
          "chmod +x bad/ffmpeg; ls >none/before");
    static const char *const programs[] = {"none", "bad"};
    static const char *const words[] = {"there is no program ffmpeg", "it is full"};
    for (int n = 0; n < 2; ++n) {
        snprintf(path, sizeof path, "%s/%s", folder, programs[n]);
        setenv("PATH", path, 1);
        const outcome seen = run_program(folder, "film out -o film.mp4");
        setenv("PATH", kept, 1);
        expect_end(&seen, 4, words[n]);
    }
    shell(folder, "ls >none/after; cmp none/before none/after");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(film_has_all_frames_on_the_same_axes),
        cmocka_unit_test(film_keeps_its_size_where_walls_move),
        cmocka_unit_test(film_refuses_what_it_cannot_do),
        cmocka_unit_test(film_that_fails_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
