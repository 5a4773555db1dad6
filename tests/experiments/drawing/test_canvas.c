/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_canvas.c - what is drawn is where it should be, walls and particles too; and a picture
 * appears whole or not at all. */
#include "tests/support/laws.h"

#include "experiments/drawing/canvas.h"
#include "experiments/drawing/tiles.h"
#include "experiments/drawing/view.h"
#include "experiments/pictures/wall_outline.h"
#include "experiments/storage/whole_file.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDER FW_PROGRAM "-canvas/"

static const fw_colour red = {1, 0, 0, 1}, blue = {0, 0, 1, 1};

static fw_canvas *canvas_of(double width, double height)
{
    fw_canvas *canvas;
    fw_error error = {FW_OK, ""};
    if (fw_canvas_create(&canvas, FOLDER "a.png", width, height, 254, &error) != FW_OK) {
        fail_msg("%s", error.sentence);
    }
    return canvas;
}

static void assert_colour(fw_canvas *canvas, double x, double y, fw_colour expected)
{
    fw_colour found = fw_canvas_colour_at(canvas, (fw_vec2){x, y});
    /* One part in 255 is lost in the pixel. */
    if (fabs(found.red - expected.red) > .006 || fabs(found.green - expected.green) > .006 ||
        fabs(found.blue - expected.blue) > .006) {
        fail_msg("at (%g, %g): %.3f %.3f %.3f, expected %.3f %.3f %.3f", x, y, found.red,
                 found.green, found.blue, expected.red, expected.green, expected.blue);
    }
}

static void shapes_lie_where_they_should(void **state)
{
    (void)state;
    const fw_colour white = fw_colour_grey(1);
    fw_canvas *canvas = canvas_of(40, 30);
    assert_colour(canvas, 20, 15, white);
    fw_canvas_disc(canvas, (fw_vec2){10, 10}, 4, red);
    assert_colour(canvas, 10, 13.7, red);
    assert_colour(canvas, 10, 14.4, white);
    fw_canvas_rectangle(canvas, (fw_rect){20, 5, 10, 5}, blue);
    assert_colour(canvas, 20.1, 9.9, blue);
    assert_colour(canvas, 20.1, 10.1, white);
    fw_canvas_line(canvas, (fw_vec2){0, 20}, (fw_vec2){40, 20}, (fw_stroke){red, 1, FW_DASH_NONE});
    assert_colour(canvas, 35, 20.3, red);
    assert_colour(canvas, 35, 20.7, white);
    fw_canvas_rectangle(canvas, (fw_rect){30, 22, 8, 8}, fw_colour_fade(blue, .5));
    assert_colour(canvas, 34, 26, (fw_colour){.5, .5, 1, 1});
    fw_canvas_clip(canvas, (fw_rect){0, 25, 10, 5});
    fw_canvas_rectangle(canvas, (fw_rect){0, 22, 40, 8}, red);
    fw_canvas_unclip(canvas);
    assert_colour(canvas, 5, 27, red);
    assert_colour(canvas, 5, 24, white);
    assert_colour(canvas, 15, 27, white);
    fw_canvas_destroy(canvas);
}

static void points_that_are_not_finite_do_no_harm(void **state)
{
    (void)state;
    fw_error error = {FW_OK, ""};
    fw_canvas *canvas = canvas_of(20, 20);
    const fw_stroke line = {red, 1, FW_DASH_LONG};
    const fw_vec2 points[6] = {{2, 10}, {NAN, 3}, {5, 10}, {9, 10}, {INFINITY, 1}, {1e300, -1e300}};
    fw_canvas_polyline(canvas, points, 6, true, line);
    fw_canvas_polygon(canvas, points, 6, blue, 1);
    fw_canvas_disc(canvas, points[1], 3, red);
    fw_canvas_disc(canvas, points[0], INFINITY, red);
    fw_canvas_disc(canvas, points[0], NAN, red);
    fw_canvas_circle(canvas, points[4], 1, line);
    fw_canvas_arrow(canvas, points[0], points[1], line, 3);
    fw_canvas_arrow(canvas, points[0], points[0], line, 3);
    fw_canvas_text(canvas, points[1], "nowhere", (fw_text_look){.size = 8});
    fw_canvas_segments(canvas, points, 3, line);
    assert_colour(canvas, 3.5, 15, fw_colour_grey(1));
    assert_int_equal(fw_canvas_save(canvas, &error), FW_OK);
    fw_canvas_destroy(canvas);
    fw_canvas_destroy(NULL);
}

static void text_has_the_width_it_promises(void **state)
{
    (void)state;
    fw_canvas *canvas = canvas_of(60, 20);
    const char *text = "x^{2} + y_{0} |";
    double width = fw_canvas_text_width(text, 12, false);
    fw_canvas_text(
        canvas, (fw_vec2){50, 10}, text,
        (fw_text_look){
            .size = 12, .colour = red, .across = FW_TEXT_RIGHT, .along = FW_TEXT_MIDDLE});
    double first = 60, last = 0;
    for (double x = 0; x < 60; x += .1) {
        for (double y = 5; y < 15; y += .1) {
            if (fw_canvas_colour_at(canvas, (fw_vec2){x + .05, y + .05}).green > .6) continue;
            first = fmin(first, x);
            last = fmax(last, x);
        }
    }
    /* The side bearings of the first and last letter: at most a third of a letter. */
    assert_close(first, 50 - width, 1);
    assert_close(last, 50, 2);
    assert_true(fw_canvas_text_width("10^{12}", 12, false) <
                fw_canvas_text_width("1012", 12, false));
    assert_true(fw_canvas_text_width(text, 12, true) > width);
    assert_close(fw_canvas_text_width("\xff\xc0\xed\xa0\x80", 12, false),
                 fw_canvas_text_width("?????", 12, false), 1e-9);
    assert_close(fw_canvas_text_width("open ^{", 8, false), fw_canvas_text_width("open ", 8, false),
                 1e-9);
    double small = fw_canvas_fitting_size(text, 12, .8 * width);
    assert_close(fw_canvas_text_width(text, small, false), .8 * width, .02 * width);
    fw_canvas_destroy(canvas);
}

/* --- walls: which side is grey --- */

static fw_panel panel_on(fw_canvas *canvas)
{
    /* One unit is 10 mm; y upwards. */
    return (fw_panel){.canvas = canvas,
                      .box = {0, 0, 100, 100},
                      .x = {.range = {0, 10}},
                      .y = {.range = {0, 10}}};
}

static void assert_forbidden(const fw_wall_def *def, fw_vec2 place, bool forbidden)
{
    fw_canvas *canvas = canvas_of(100, 100);
    fw_panel panel = panel_on(canvas);
    /* Far off, and back again by the displacement. */
    fw_vec2 corners[FW_WALL_CORNERS_MAX];
    fw_outline wall = fw_wall_outline(def, corners);
    wall.displacement = (fw_vec2){1, 2};
    const fw_view view = {.walls = &wall, .wall_count = 1};
    fw_view_draw_walls(&view, &panel, false, 1);
    fw_vec2 paper = fw_panel_place(&panel, place.x + 1, place.y + 2);
    bool grey = fw_canvas_colour_at(canvas, paper).red < .95;
    if (grey != forbidden) {
        fail_msg("%s: (%g, %g) is %s", def->name, place.x, place.y, grey ? "grey" : "white");
    }
    fw_canvas_destroy(canvas);
}

static void the_forbidden_side_of_walls_is_grey(void **state)
{
    (void)state;
    const fw_vec2 corners[2] = {{6, 2}, {2, 5}}, centre[1] = {{4, 4}};
    const fw_vec2 left_turn[3] = {{2, 2}, {6, 2}, {4, 5}}, right_turn[3] = {{4, 5}, {6, 2}, {2, 2}};
    fw_wall_def box = {.name = "box", .shape = FW_BOX, .points = corners, .point_count = 2};
    fw_wall_def circle = {
        .name = "circle", .shape = FW_CIRCLE, .points = centre, .point_count = 1, .radius = 2};
    fw_wall_def polygon = {
        .name = "polygon", .shape = FW_POLYGON, .points = left_turn, .point_count = 3};
    fw_wall_def turned = {
        .name = "turned", .shape = FW_POLYGON, .points = right_turn, .point_count = 3};
    fw_wall_def chain = {.name = "chain", .shape = FW_CHAIN, .points = left_turn, .point_count = 3};
    /* The band is 2.2 mm wide: a tenth of a unit is 1 mm. */
    box.side = circle.side = polygon.side = turned.side = FW_INSIDE;
    assert_forbidden(&box, (fw_vec2){4, 4.9}, false);
    assert_forbidden(&box, (fw_vec2){4, 5.1}, true);
    assert_forbidden(&box, (fw_vec2){1.9, 3}, true);
    assert_forbidden(&box, (fw_vec2){1.85, 1.85}, true);
    assert_forbidden(&circle, (fw_vec2){4, 5.9}, false);
    assert_forbidden(&circle, (fw_vec2){4, 6.1}, true);
    assert_forbidden(&polygon, (fw_vec2){4, 2.1}, false);
    assert_forbidden(&polygon, (fw_vec2){4, 1.9}, true);
    assert_forbidden(&turned, (fw_vec2){4, 2.1}, false);
    assert_forbidden(&turned, (fw_vec2){4, 1.9}, true);
    box.side = circle.side = polygon.side = turned.side = FW_OUTSIDE;
    assert_forbidden(&box, (fw_vec2){4, 3}, true);
    assert_forbidden(&box, (fw_vec2){4, 5.1}, false);
    assert_forbidden(&circle, (fw_vec2){4, 4}, true);
    assert_forbidden(&circle, (fw_vec2){4, 6.1}, false);
    assert_forbidden(&polygon, (fw_vec2){4, 3}, true);
    assert_forbidden(&turned, (fw_vec2){4, 3}, true);
    assert_forbidden(&turned, (fw_vec2){4, 1.9}, false);
    /* A chain is free to its left: walking east, forbidden below. */
    assert_forbidden(&chain, (fw_vec2){4, 1.9}, true);
    assert_forbidden(&chain, (fw_vec2){4, 2.1}, false);
    assert_forbidden(&chain, (fw_vec2){3, 3.7}, false);
    chain.closed = true;
    assert_forbidden(&chain, (fw_vec2){2.85, 3.6}, true);
}

/* --- tiles --- */

static double area_of(const fw_vec2 *corners, int count)
{
    double area = 0;
    for (int k = 0; k < count; ++k) {
        area += fw_vec2_cross(fw_vec2_subtract(corners[k], corners[0]),
                              fw_vec2_subtract(corners[(k + 1) % count], corners[0])) /
                2;
    }
    return area;
}

static void tiles_of_a_lattice_fill_its_plane(void **state)
{
    (void)state;
    enum { SIDE = 9 };
    fw_vec2 points[SIDE * SIDE + 2], corners[FW_TILE_CORNERS];
    for (int k = 0; k < SIDE * SIDE; ++k) {
        points[k] = (fw_vec2){1e4 + 2 * (k % SIDE), -1e4 + 2. * (k / SIDE)};
    }
    points[SIDE * SIDE] = (fw_vec2){NAN, 0};
    points[SIDE * SIDE + 1] = points[0]; /* two at one place share a tile */
    fw_tiles *tiles;
    assert_int_equal(fw_tiles_create(&tiles, points, SIDE * SIDE + 2, 1.5, NULL), FW_OK);
    for (int k = 0; k < SIDE * SIDE; ++k) {
        int count = fw_tiles_corners(tiles, k, corners);
        /* Also along the boundary, where no neighbour is. Coordinates of 1e4 have 2e-12 to spare.
         */
        assert_close(area_of(corners, count), 4, 1e-10);
    }
    assert_int_equal(fw_tiles_corners(tiles, SIDE * SIDE, corners), 0);
    fw_tiles_destroy(tiles);
    fw_tiles_destroy(NULL);
}

static void a_lonely_point_has_a_round_tile(void **state)
{
    (void)state;
    const fw_vec2 point = {3, 4};
    fw_vec2 corners[FW_TILE_CORNERS];
    fw_tiles *tiles;
    assert_int_equal(fw_tiles_create(&tiles, &point, 1, 2, NULL), FW_OK);
    int count = fw_tiles_corners(tiles, 0, corners);
    /* A polygon of n corners lacks the part (2 pi^2 / 3) / n^2 of the circle's area. */
    assert_close(area_of(corners, count), 4 * M_PI, 4 * M_PI * 7. / (count * count));
    fw_tiles_destroy(tiles);
}

/* Beside points that are far apart, one of a finer lattice does not grow to their size. */
static void a_tile_ends_at_its_own_reach(void **state)
{
    (void)state;
    const fw_vec2 points[] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {.5, -3}, {4.5, -3}};
    fw_vec2 corners[FW_TILE_CORNERS];
    fw_tiles *tiles;
    assert_int_equal(fw_tiles_create(&tiles, points, 6, 2.9, NULL), FW_OK);
    for (int k = 0; k < 4; ++k) {
        int count = fw_tiles_corners(tiles, k, corners);
        assert_true(k > 1 || area_of(corners, count) > 1.2);
        count = fw_tiles_corners_within(tiles, k, .72, corners);
        assert_close(area_of(corners, count), 1, 1e-12);
    }
    fw_tiles_destroy(tiles);
}

static void points_in_a_heap_are_done_with_soon(void **state)
{
    (void)state;
    enum { MANY = 20000 };
    fw_vec2 *points = calloc(MANY, sizeof *points);
    assert_non_null(points);
    for (int k = 0; k < MANY; ++k) points[k].x = 1e-9 * k;
    points[MANY - 1] = (fw_vec2){1e300, -1e300};
    fw_tiles *tiles;
    fw_vec2 corners[FW_TILE_CORNERS];
    assert_int_equal(fw_tiles_create(&tiles, points, MANY, 1, NULL), FW_OK);
    for (int k = 0; k < MANY; ++k) {
        assert_in_range(fw_tiles_corners(tiles, k, corners), 0, FW_TILE_CORNERS);
    }
    fw_tiles_destroy(tiles);
    free(points);
}

/* --- files --- */

static void assert_content(const char *name, const char *expected)
{
    char found[64] = "";
    FILE *file = fopen(name, "r");
    assert_non_null(file);
    size_t count = fread(found, 1, sizeof found - 1, file);
    fclose(file);
    found[count] = '\0';
    assert_string_equal(found, expected);
}

static void a_file_is_replaced_as_a_whole(void **state)
{
    (void)state;
    fw_error error = {FW_OK, ""};
    assert_int_equal(fw_whole_file_write(FOLDER "text", "old", 3, &error), FW_OK);
    assert_int_equal(fw_whole_file_write(FOLDER "text", "newer", 5, &error), FW_OK);
    assert_content(FOLDER "text", "newer");
}

/* A limit to the size of files stands for a full disk: writing stops half way. */
static void a_full_disk_leaves_what_was_there(void **state)
{
    (void)state;
    enum { LARGE = 1 << 20 };
    fw_error error = {FW_OK, ""};
    struct rlimit before, little;
    char *large = calloc(1, LARGE);
    assert_non_null(large);
    assert_int_equal(fw_whole_file_write(FOLDER "full", "old", 3, &error), FW_OK);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    little = before;
    little.rlim_cur = 4096;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &little), 0);
    fw_status status = fw_whole_file_write(FOLDER "full", large, LARGE, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, handler);
    assert_int_equal(status, FW_SYSTEM_FAILED);
    assert_non_null(strstr(error.sentence, FOLDER "full"));
    assert_non_null(strstr(error.sentence, strerror(EFBIG)));
    assert_content(FOLDER "full", "old");
    char temporary[512];
    snprintf(temporary, sizeof temporary, FOLDER "full.part-%ld", (long)getpid());
    assert_int_not_equal(access(temporary, F_OK), 0);
    free(large);
}

static void a_device_is_written_to_and_its_failure_told(void **state)
{
    (void)state;
    fw_error error = {FW_OK, ""};
    const char *name = FOLDER "device.png";
    unlink(name);
    assert_int_equal(symlink("/dev/full", name), 0);
    fw_canvas *canvas;
    assert_int_equal(fw_canvas_create(&canvas, name, 20, 20, 100, &error), FW_OK);
    assert_int_equal(fw_canvas_save(canvas, &error), FW_SYSTEM_FAILED);
    fw_canvas_destroy(canvas);
    assert_non_null(strstr(error.sentence, strerror(ENOSPC)));
    struct stat present;
    assert_int_equal(lstat(name, &present), 0);
    assert_true(S_ISLNK(present.st_mode));
    unlink(name);
}

static void a_picture_that_is_not_saved_leaves_nothing(void **state)
{
    (void)state;
    static const char *const names[] = {FOLDER "never.png", FOLDER "never.svg", FOLDER "never.PDF"};
    for (int k = 0; k < 3; ++k) {
        fw_error error = {FW_OK, ""};
        fw_canvas *canvas;
        assert_int_equal(fw_canvas_create(&canvas, names[k], 20, 20, 100, &error), FW_OK);
        fw_canvas_raster_begin(canvas, (fw_rect){0, 0, 10, 10});
        fw_canvas_disc(canvas, (fw_vec2){5, 5}, 3, red);
        fw_canvas_destroy(canvas);
        assert_int_not_equal(access(names[k], F_OK), 0);
    }
}

static void names_and_sizes_that_cannot_be_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *name, *words;
        double width, height, resolution;
    } cases[] = {
        {"figure", "end in .png, .svg or .pdf", 100, 100, 200},
        {"figure.jpeg", "'figure.jpeg'", 100, 100, 200},
        {"a.png/b", "end in", 100, 100, 200},
        {"a.png", "between 0 and 2000 mm", 0, 100, 200},
        {"a.png", "between 0 and 2000 mm", 100, NAN, 200},
        {"a.svg", "between 0 and 2000 mm", 100, 5000, 200},
        {"a.png", "dots per inch", 100, 100, 10000},
        {"a.png", "dots per inch", 100, 100, NAN},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        fw_error error = {FW_OK, ""};
        fw_canvas *canvas;
        assert_int_equal(fw_canvas_create(&canvas, cases[k].name, cases[k].width, cases[k].height,
                                          cases[k].resolution, &error),
                         FW_BAD_INPUT);
        assert_null(canvas);
        if (!strstr(error.sentence, cases[k].words)) fail_msg("%s", error.sentence);
    }
}

static int make_folder(void **state)
{
    (void)state;
    return mkdir(FOLDER, 0777) == 0 || errno == EEXIST ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_lie_where_they_should),
        cmocka_unit_test(points_that_are_not_finite_do_no_harm),
        cmocka_unit_test(text_has_the_width_it_promises),
        cmocka_unit_test(the_forbidden_side_of_walls_is_grey),
        cmocka_unit_test(tiles_of_a_lattice_fill_its_plane),
        cmocka_unit_test(a_lonely_point_has_a_round_tile),
        cmocka_unit_test(a_tile_ends_at_its_own_reach),
        cmocka_unit_test(points_in_a_heap_are_done_with_soon),
        cmocka_unit_test(a_file_is_replaced_as_a_whole),
        cmocka_unit_test(a_full_disk_leaves_what_was_there),
        cmocka_unit_test(a_device_is_written_to_and_its_failure_told),
        cmocka_unit_test(a_picture_that_is_not_saved_leaves_nothing),
        cmocka_unit_test(names_and_sizes_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
