/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_print.c - figures for a paper: as wide as asked, with dots of the size that is written into
 * the file, with a letter in the place of the title or with nothing. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char scenario[] =
    "title: a body goes to the right\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies: {block: {material: soft, shape: {rectangle: [4, 3]}, velocity: [.5, 0]}}\n"
    "run: {steps: 20, record-every: 2}\n"
    "measure: [energy, momentum]\n";

typedef struct png {
    unsigned width, height, dots_x, dots_y, unit;
} png;

static unsigned big_endian(const unsigned char *bytes)
{
    return (unsigned)bytes[0] << 24 | (unsigned)bytes[1] << 16 | (unsigned)bytes[2] << 8 | bytes[3];
}

/* The checksum of a chunk is the remainder of a division (ISO 3309): with it behind them, its name
 * and data leave this one. */
static bool is_whole(const unsigned char *chunk, size_t count)
{
    unsigned rest = 0xffffffff;
    unsigned char bytes[32];
    memcpy(bytes, chunk, count);
    for (int n = 0; n < 4; ++n) bytes[count + (size_t)n] = chunk[count + 3 - (size_t)n];
    for (size_t n = 0; n < count + 4; ++n)
        for (int bit = 0; bit < 8; ++bit)
            rest = rest >> 1 ^ ((rest ^ (unsigned)bytes[n] >> bit) & 1 ? 0xedb88320 : 0);
    return rest == 0xdebb20e3;
}

static png read_png(const char *folder, const char *name)
{
    unsigned char head[54];
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fread(head, 1, sizeof head, file), sizeof head);
    fclose(file);
    assert_memory_equal(head + 33, "\0\0\0\x9pHYs", 8);
    assert_true(is_whole(head + 37, 13));
    return (png){big_endian(head + 16), big_endian(head + 20), big_endian(head + 41),
                 big_endian(head + 45), head[49]};
}

/* A new folder with a result to draw. */
static void make_result(char *folder, size_t size)
{
    make_quick_folder(folder, size);
    write_scenario(folder, "file.yaml", scenario);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
}

static png draw(const char *folder, const char *options)
{
    char line[256];
    snprintf(line, sizeof line, "plot out -o picture.png %s", options);
    const outcome seen = run_program(folder, line);
    expect_end(&seen, 0, "");
    return read_png(folder, "picture.png");
}

static void figures_have_the_width_and_dots_asked_for(void **state)
{
    (void)state;
    char folder[64];
    outcome seen;
    make_result(folder, sizeof folder);
    const png usual = draw(folder, "");
    assert_int_equal(usual.width, 1260); /* 160 mm of 200 dots to 25.4 mm */
    assert_int_equal(usual.dots_x, 7874);
    assert_int_equal(usual.dots_y, 7874);
    assert_int_equal(usual.unit, 1);
    const png column = draw(folder, "--width 86 --dpi 600");
    assert_int_equal(column.width, 2032);
    assert_int_equal(column.dots_x, 23622);
    const png bare = draw(folder, "--width 86 --dpi 600 --bare");
    const png lettered = draw(folder, "--width 86 --dpi 600 --bare --letter a");
    assert_true(bare.height < lettered.height && lettered.height < column.height);
    const png wide = draw(folder, "--observable energy");
    const png narrow = draw(folder, "--observable energy --width 86");
    assert_true(narrow.height < wide.height);
    seen = run_program(folder, "plot out --width 3");
    expect_end(&seen, 2, "--width");
    remove_folder(folder);
}

/* Larger letters leave the width as it is; what the command line says goes before the file. */
static void a_style_file_says_how_figures_look(void **state)
{
    (void)state;
    char folder[64];
    outcome seen;
    make_result(folder, sizeof folder);
    const png plain = draw(folder, "--observable energy --width 86");
    write_scenario(folder, "paper.style", "width: 86\ndpi: 100\nfont-size: 17\nbare: true\n");
    const png styled = draw(folder, "--observable energy --style paper.style");
    assert_int_equal(styled.width, 339); /* 86 mm of 100 dots to 25.4 mm */
    assert_int_equal(styled.dots_x, 3937);
    const png large = draw(folder, "--observable energy --width 86 --font-size 17");
    assert_int_equal(large.width, plain.width);
    assert_true(large.height != plain.height);
    const png own = draw(folder, "--observable energy --style paper.style --dpi 200");
    assert_int_equal(own.width, 678);
    const png low = draw(folder, "--observable energy --height 30");
    const png high = draw(folder, "--observable energy --height 90");
    assert_in_range(high.height - low.height, 472, 473); /* 60 mm of 200 dots to 25.4 mm */
    write_scenario(folder, "paper.style", "width: 86\nheigth: 3\n");
    seen = run_program(folder, "plot out --style paper.style");
    expect_end(&seen, 2, "paper.style:2:1: unknown key 'heigth'");
    static const char *const refused[][2] = {
        {"plot out --style nowhere", "nowhere"},
        {"plot out --font-size 3", "--font-size 3, expected a number from 4 to 40 points"},
        {"plot out --font-size big", "--font-size big, expected a number from 4 to 40 points"},
        {"plot out --letter abc", "--letter abc, expected a letter or two"},
        {"plot out --letter ''", "expected a letter or two"},
        {"plot out --letter '(a.'", "--letter (a., expected a letter or two"},
        {"plot out --x-range 3,2", "--x-range 3,2, expected two numbers"},
        {"plot out --observable energy --x-range 30,40", "nothing lies between 30 and 40 along x"},
        {"plot out --observable energy --logarithmic --y-range 0,1",
         "the y axis is logarithmic and cannot go from 0 to 1, expected both above 0"},
        {"plot out --kind structure --y-range 0,1", "does not draw a chosen part of its axes"},
        {"plot out --kind motion --height 30", "does not draw charts"},
        {"plot out --kind motion --in-steps", "does not draw anything over steps"},
        {"plot out --palette rainbow", "there is no palette 'rainbow', expected one of auto, "},
        {"plot out --kind motion --with out", "does not draw several results"},
        {"plot out --kind motion --along energy", "does not draw anything along another number"},
        {"plot out --observable energy --along momentum", "are 2 numbers, expected one"},
        {"plot out --observable energy --along speed", "speed"},
        {"plot out --observable energy --with nowhere", "nowhere"}};
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n) {
        seen = run_program(folder, refused[n][0]);
        expect_end(&seen, 2, refused[n][1]);
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures_have_the_width_and_dots_asked_for),
        cmocka_unit_test(a_style_file_says_how_figures_look),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
