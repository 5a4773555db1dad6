/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure.c - every figure drawn from small synthetic data, in all formats, and from data that
 * nobody wishes for. The pictures stay in FW_PROGRAM-pictures/ to be looked at. */
#include "tests/support/laws.h"

#include "experiments/drawing/figure.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PICTURES FW_PROGRAM "-pictures/"

/* --- files --- */

typedef struct file_bytes {
    unsigned char *bytes;
    size_t count;
} file_bytes;

static file_bytes read_file(const char *name)
{
    file_bytes file = {NULL, 0};
    FILE *stream = fopen(name, "rb");
    if (!stream) fail_msg("'%s' is not there", name);
    fseek(stream, 0, SEEK_END);
    file.count = (size_t)ftell(stream);
    rewind(stream);
    file.bytes = malloc(file.count + 1);
    assert_non_null(file.bytes);
    assert_int_equal(fread(file.bytes, 1, file.count, stream), file.count);
    file.bytes[file.count] = '\0';
    fclose(stream);
    return file;
}

static uint32_t big_endian(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* The check sum of PNG chunks (ISO 3309). */
static uint32_t check_sum(const unsigned char *bytes, size_t count)
{
    uint32_t sum = 0xffffffff;
    for (size_t k = 0; k < count; ++k) {
        sum ^= bytes[k];
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum;
}

/* Signature, all chunks with their sums, the end chunk at the very end. */
static void assert_whole_png(const file_bytes *file, unsigned least_width)
{
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    assert_true(file->count > 1000);
    assert_memory_equal(file->bytes, signature, sizeof signature);
    assert_true(big_endian(file->bytes + 16) >= least_width);
    size_t at = sizeof signature;
    bool ended = false;
    while (at + 12 <= file->count) {
        size_t length = big_endian(file->bytes + at);
        assert_true(at + 12 + length <= file->count);
        uint32_t sum = big_endian(file->bytes + at + 8 + length);
        assert_int_equal(check_sum(file->bytes + at + 4, length + 4), sum);
        ended = memcmp(file->bytes + at + 4, "IEND", 4) == 0;
        at += 12 + length;
    }
    assert_int_equal(at, file->count);
    assert_true(ended);
}

/* Where the last cross-reference table lies stands at the end. */
static void assert_whole_pdf(const file_bytes *file)
{
    assert_memory_equal(file->bytes, "%PDF-", 5);
    assert_memory_equal(file->bytes + file->count - 6, "%%EOF\n", 6);
    const char *end = (const char *)file->bytes + file->count - 40;
    const char *start = strstr(end, "startxref");
    assert_non_null(start);
    long place = atol(start + strlen("startxref"));
    assert_in_range(place, 100, file->count);
    assert_memory_equal(file->bytes + place, "xref", 4);
}

/* Every opened element is closed. */
static void assert_whole_svg(const file_bytes *file)
{
    const char *text = (const char *)file->bytes;
    int depth = 0;
    assert_memory_equal(text, "<?xml", 5);
    assert_null(strstr(text, " nan"));
    for (const char *tag = strchr(text, '<'); tag; tag = strchr(tag + 1, '<')) {
        const char *close = strchr(tag, '>');
        assert_non_null(close);
        if (tag[1] == '?' || tag[1] == '!') continue;
        if (tag[1] == '/') {
            depth -= 1;
        } else if (close[-1] != '/') {
            depth += 1;
        }
        assert_true(depth >= 0);
    }
    assert_int_equal(depth, 0);
    assert_string_equal(text + file->count - 7, "</svg>\n");
}

/* Cairo numbers the surfaces of a process in its SVG files; those numbers are cut out here. */
static void forget_surface_numbers(file_bytes *file)
{
    static const char *const words[] = {"surface", "image", "mask"};
    for (int w = 0; w < 3; ++w) {
        char *found = (char *)file->bytes;
        while ((found = strstr(found, words[w]))) {
            found += strlen(words[w]);
            size_t digits = strspn(found, "0123456789");
            memmove(found, found + digits, strlen(found + digits) + 1);
            file->count -= digits;
        }
    }
}

typedef fw_status (*draw_figure)(const fw_page *page, const void *data, fw_error *error);

static const char *picture_name(const char *name, const char *ending)
{
    static char full[512];
    snprintf(full, sizeof full, PICTURES "%s%s", name, ending);
    return full;
}

static void draw_into(draw_figure draw, const void *data, fw_page page, const char *name,
                      const char *ending)
{
    fw_error error = {FW_OK, ""};
    page.file = picture_name(name, ending);
    if (draw(&page, data, &error) != FW_OK) fail_msg("%s%s: %s", name, ending, error.sentence);
}

/* Draws in all formats, each twice: whole files, and the same bytes again. */
static void draw_everywhere(draw_figure draw, const void *data, fw_page page, const char *name)
{
    static const char *const endings[] = {".png", ".svg", ".pdf"};
    for (int k = 0; k < 3; ++k) {
        draw_into(draw, data, page, name, endings[k]);
        file_bytes first = read_file(picture_name(name, endings[k]));
        draw_into(draw, data, page, name, endings[k]);
        file_bytes again = read_file(picture_name(name, endings[k]));
        if (k == 1) {
            forget_surface_numbers(&first);
            forget_surface_numbers(&again);
        }
        assert_int_equal(first.count, again.count);
        assert_memory_equal(first.bytes, again.bytes, first.count);
        if (k == 0) assert_whole_png(&first, 1200);
        if (k == 1) assert_whole_svg(&first);
        if (k == 2) assert_whole_pdf(&first);
        free(first.bytes);
        free(again.bytes);
    }
}

static fw_page page_with(const char *title, const char *caption)
{
    fw_page page = fw_page_default();
    page.title = title;
    page.caption = caption;
    return page;
}

/* --- data --- */

/* A square sheet of SIDE x SIDE particles that obey Newton with unit springs for x and y, in a box:
 * enough to look like the solids this is for. */
enum { SIDE = 20, SHEET = SIDE * SIDE, LINKS = 2 * SIDE * (SIDE - 1), STEPS = 1600 };

typedef struct sheet {
    double x[SHEET], y[SHEET], u[SHEET], v[SHEET];
    double speed[SHEET];
    int links[LINKS][2];
} sheet;

static void start_sheet(sheet *s)
{
    int link = 0;
    for (int k = 0; k < SHEET; ++k) {
        int i = k % SIDE, j = k / SIDE;
        s->x[k] = 7.313 + i;
        s->y[k] = 11.747 + j;
        s->u[k] = .07;
        s->v[k] = .045;
        s->speed[k] = hypot(.07, .045);
        if (i + 1 < SIDE) memcpy(s->links[link++], (int[2]){k, k + 1}, sizeof(int[2]));
        if (j + 1 < SIDE) memcpy(s->links[link++], (int[2]){k, k + SIDE}, sizeof(int[2]));
    }
    assert_int_equal(link, LINKS);
}

static void advance_sheet(sheet *s, double low, double high)
{
    const double dt = .5;
    for (int link = 0; link < LINKS; ++link) {
        int a = s->links[link][0], b = s->links[link][1];
        double fx = s->x[b] - s->x[a] - (b == a + 1 ? 1 : 0);
        double fy = s->y[b] - s->y[a] - (b == a + 1 ? 0 : 1);
        s->u[a] += dt * fx;
        s->u[b] -= dt * fx;
        s->v[a] += dt * fy;
        s->v[b] -= dt * fy;
    }
    for (int k = 0; k < SHEET; ++k) {
        double x = s->x[k] + dt * s->u[k], y = s->y[k] + dt * s->v[k];
        if (x < low || x > high) s->u[k] = -s->u[k];
        if (y < low || y > high) s->v[k] = -s->v[k];
        if (x >= low && x <= high) s->x[k] = x;
        if (y >= low && y <= high) s->y[k] = y;
        s->speed[k] = hypot(s->u[k], s->v[k]);
    }
}

static fw_view_body body_of(const sheet *s)
{
    return (fw_view_body){.name = "sheet",
                          .count = SHEET,
                          .x = s->x,
                          .y = s->y,
                          .links = *s->links,
                          .link_count = LINKS,
                          .spacing = 1};
}

static double mean(const double *values, int count)
{
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += values[k];
    return sum / count;
}

/* A deterministic number in [0, 1) from an index. */
static double scatter(unsigned number)
{
    number = number * 2654435761u + 12345u;
    number ^= number >> 15;
    number *= 2246822519u;
    number ^= number >> 13;
    return (number >> 8) / (double)(1 << 24);
}

/* --- figures of bodies --- */

static fw_status draw_motion(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_motion(page, data, error);
}

static fw_status draw_field(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_field(page, data, error);
}

static fw_status draw_strip(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_strip(page, data, error);
}

enum { INSTANTS = 5 };

typedef struct journey {
    sheet at[INSTANTS];
    fw_view_body bodies[INSTANTS];
    fw_view views[INSTANTS];
    double path_x[STEPS + 1], path_y[STEPS + 1];
    fw_figure_path path;
    fw_outline wall;
} journey;

static const fw_vec2 box_corners[4] = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};

static journey *travel(void)
{
    journey *j = calloc(1, sizeof *j);
    assert_non_null(j);
    sheet now;
    start_sheet(&now);
    j->wall = (fw_outline){
        .points = box_corners, .count = 4, .closed = true, .forbidden = FW_FORBIDDEN_OUTSIDE};
    for (int step = 0; step <= STEPS; ++step) {
        int instant = step / (STEPS / (INSTANTS - 1));
        j->path_x[step] = mean(now.x, SHEET);
        j->path_y[step] = mean(now.y, SHEET);
        if (step % (STEPS / (INSTANTS - 1)) == 0) {
            j->at[instant] = now;
            j->bodies[instant] = body_of(&j->at[instant]);
            j->bodies[instant].field = j->at[instant].speed;
            j->views[instant] = (fw_view){.step = step,
                                          .bodies = &j->bodies[instant],
                                          .body_count = 1,
                                          .walls = &j->wall,
                                          .wall_count = 1};
        }
        advance_sheet(&now, 0, 60);
    }
    j->path = (fw_figure_path){j->path_x, j->path_y, STEPS + 1};
    return j;
}

static void a_sheet_on_its_way_is_drawn(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_motion_plan plan = {
        .views = j->views, .view_count = INSTANTS, .paths = &j->path, .path_count = 1};
    draw_everywhere(draw_motion, &plan,
                    page_with("A lattice Boltzmann sheet bounces in a rigid box",
                              "20 × 20 particles, box 60 × 60, frictionless walls. After Chopard & "
                              "Marconi 2002, Fig. 1."),
                    "motion");
    free(j);
}

static void a_field_is_drawn_on_the_particles(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_field_plan plan = {.view = &j->views[1],
                                 .colouring = {.label = "speed / lattice units per step"}};
    draw_everywhere(draw_field, &plan, page_with("Speed of the particles", NULL), "field");
    plan.look = FW_VIEW_DISCS;
    plan.colouring = (fw_colouring){.label = "velocity along x", .trim = .02};
    j->bodies[1].field = j->at[1].u;
    draw_everywhere(draw_field, &plan, page_with(NULL, NULL), "field-signs");
    free(j);
}

static void a_sequence_is_drawn_side_by_side(void **state)
{
    (void)state;
    journey *j = travel();
    fw_figure_strip_plan plan = {
        .views = j->views, .view_count = INSTANTS, .colouring = {.label = "speed"}};
    draw_everywhere(draw_strip, &plan, page_with("The bounce in frames", NULL), "strip");
    static const char *const kinds[7] = {"white", NULL, NULL, NULL, NULL, NULL, "black"};
    unsigned char species[SHEET];
    for (int k = 0; k < SHEET; ++k) species[k] = (unsigned char)((k % SIDE + k / SIDE) % 2 ? 6 : 0);
    for (int k = 0; k < INSTANTS; ++k) {
        j->bodies[k].field = NULL;
        j->bodies[k].species = species;
        j->views[k].kinds = kinds;
        j->views[k].kind_count = 7;
    }
    plan.columns = 3;
    plan.look = FW_VIEW_DISCS;
    draw_everywhere(draw_strip, &plan, page_with(NULL, "Black and white cells."), "strip-species");
    free(j);
}

/* --- forces --- */

static fw_status draw_forces(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_forces(page, data, error);
}

/* A chain pulled at both ends: each link is stretched by 2 F (Chopard & Marconi Fig 4). */
typedef struct chain {
    double original[9], x[9], zero[9];
    int links[8][2];
    fw_figure_force forces[18];
    fw_figure_forces_panel panel;
} chain;

static void pull_chain(chain *c, int count, double stretch, const char *name)
{
    int forces = 0;
    memset(c, 0, sizeof *c);
    for (int k = 0; k < count; ++k) {
        c->original[k] = 8. * k / (count - 1);
        c->x[k] = c->original[k] + stretch * (k - (count - 1) / 2.);
        if (k > 0) c->forces[forces++] = (fw_figure_force){k, {-.1, 0}, false};
        if (k + 1 < count) c->forces[forces++] = (fw_figure_force){k, {.1, 0}, false};
        if (k > 0) memcpy(c->links[k - 1], (int[2]){k - 1, k}, sizeof(int[2]));
    }
    c->forces[forces++] = (fw_figure_force){0, {-.1, 0}, true};
    c->forces[forces++] = (fw_figure_force){count - 1, {.1, 0}, true};
    c->panel = (fw_figure_forces_panel){name,    count,     c->original, c->zero,   c->x,
                                        c->zero, *c->links, count - 1,   c->forces, forces};
}

static void forces_on_chains_are_drawn(void **state)
{
    (void)state;
    chain nine, three;
    pull_chain(&nine, 9, .2, "9 particles, F = 0.1: elongation 1.6");
    pull_chain(&three, 3, .2, "3 particles, F = 0.1: elongation 0.4");
    fw_figure_forces_panel panels[2] = {nine.panel, three.panel};
    fw_figure_forces_plan plan = {.panels = panels, .panel_count = 2};
    draw_everywhere(draw_forces, &plan,
                    page_with("A chain under tension", "After Chopard & Marconi 2002, Fig. 4."),
                    "forces-chains");
}

static void forces_on_a_sheet_are_drawn(void **state)
{
    (void)state;
    const double x0[4] = {0, 1, 0, 1}, y0[4] = {1, 1, 0, 0};
    const double x[4] = {-.08, 1.05, -.02, 1.12}, y[4] = {1.1, 1.04, -.06, -.05};
    const int links[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    const fw_figure_force forces[12] = {
        {0, {-.1, .08}, true},   {1, {.05, .06}, true},    {2, {-.05, -.08}, true},
        {3, {.1, -.06}, true},   {0, {.065, -.02}, false}, {1, {-.065, .02}, false},
        {2, {.07, .01}, false},  {3, {-.07, -.01}, false}, {0, {.03, -.06}, false},
        {2, {-.03, .06}, false}, {1, {.02, -.045}, false}, {3, {-.02, .045}, false}};
    fw_figure_forces_panel panel = {
        "four particles under balanced forces", 4, x0, y0, x, y, *links, 4, forces, 12};
    fw_figure_forces_plan plan = {.panels = &panel, .panel_count = 1};
    draw_everywhere(draw_forces, &plan, page_with("A sheet of four particles", NULL),
                    "forces-sheet");
}

/* --- curves --- */

static fw_status draw_stack(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_stack(page, data, error);
}

enum { SAMPLES = 400 };

static void observables_over_time_are_drawn(void **state)
{
    (void)state;
    double time[SAMPLES], energy[SAMPLES], kinetic[SAMPLES], elastic[SAMPLES], error[SAMPLES];
    double drift[SAMPLES];
    for (int k = 0; k < SAMPLES; ++k) {
        time[k] = 10 * k;
        kinetic[k] = .4 + .1 * cos(.05 * k) * exp(-.004 * k);
        elastic[k] = .5387123456 - kinetic[k];
        energy[k] = .5387123456 + 4e-15 * (scatter((unsigned)k) - .5) * sqrt(k);
        error[k] = .02 + .01 * scatter((unsigned)k / 20);
        drift[k] = k == 0 ? 0 : 1e-16 * pow(10, 4 * k / (double)SAMPLES);
    }
    kinetic[150] = kinetic[151] = NAN;
    const fw_curve parts[2] = {{"kinetic", SAMPLES, time, kinetic, error, FW_CURVE_LINE, 0},
                               {"elastic", SAMPLES, time, elastic, NULL, FW_CURVE_LINE, 0}};
    const fw_curve total = {NULL, SAMPLES, time, energy, NULL, FW_CURVE_LINE, 0};
    const fw_curve change = {NULL, SAMPLES, time, drift, NULL, FW_CURVE_LINE, 0};
    const fw_chart charts[3] = {
        {.label = "energy / m v^{2}", .curves = parts, .curve_count = 2},
        {.label = "total energy", .curves = &total, .curve_count = 1},
        {.label = "|ΔE| / E", .curves = &change, .curve_count = 1, .logarithmic = true}};
    const fw_figure_mark marks[3] = {{600, "settle"}, {1400, "drive"}, {1500, "sample"}};
    fw_figure_stack_plan plan = {.charts = charts,
                                 .chart_count = 3,
                                 .label = "time / steps",
                                 .marks = marks,
                                 .mark_count = 3};
    draw_everywhere(draw_stack, &plan, page_with("Energy of the sheet", NULL), "series");
}

static void a_dispersion_is_drawn(void **state)
{
    (void)state;
    enum { POINTS = 200, MEASURED = 24 };
    double k[POINTS], slow[POINTS], fast[POINTS], at[MEASURED], seen[MEASURED], error[MEASURED];
    for (int i = 0; i < POINTS; ++i) {
        k[i] = 3. * i / (POINTS - 1);
        fast[i] = 1.9 * fabs(sin(M_PI * k[i] / 3)) + .2 * fabs(sin(M_PI * k[i]));
        slow[i] = .6 * fast[i];
    }
    for (int i = 0; i < MEASURED; ++i) {
        at[i] = k[8 * i];
        seen[i] = fast[8 * i] + .02 * (scatter((unsigned)i) - .5);
        error[i] = .05;
    }
    const fw_curve curves[3] = {
        {"longitudinal, closed form", POINTS, k, fast, NULL, FW_CURVE_LINE, 0},
        {"transverse, closed form", POINTS, k, slow, NULL, FW_CURVE_DASHES, 0},
        {"simulated", MEASURED, at, seen, error, FW_CURVE_MARKERS, FW_PALETTE_KINDS - 1}};
    const fw_axis_name names[4] = {{0, "Γ"}, {1, "X"}, {2, "M"}, {3, "Γ"}};
    const fw_chart chart = {.label = "frequency ω τ", .curves = curves, .curve_count = 3};
    fw_figure_stack_plan plan = {.charts = &chart,
                                 .chart_count = 1,
                                 .label = "wave vector along Γ–X–M–Γ",
                                 .names = names,
                                 .name_count = 4};
    draw_everywhere(draw_stack, &plan, page_with("Dispersion of the elastic automaton", NULL),
                    "curves");
}

static fw_status draw_pair(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_columns(page, data, 2, error);
}

/* Two beams of hexagonal lattices whose axes differ, as in Popov & Filippov Fig 6. */
enum { BEAM = 14 * 24, BEAMS = 2 * BEAM, BINS = 28 };

static void a_profile_is_drawn_under_its_configuration(void **state)
{
    (void)state;
    double x[BEAMS], y[BEAMS], force[BEAMS];
    for (int k = 0; k < BEAM; ++k) {
        int i = k % 14, j = k / 14;
        x[k] = -.5 - .866 * i;
        y[k] = j - 12 + (i % 2 ? .5 : 0);
        x[BEAM + k] = .5 + i * .866;
        y[BEAM + k] = (j - 12) * 1. + (i % 2 ? .25 : 0);
    }
    for (int k = 0; k < BEAMS; ++k) {
        double depth = exp(-x[k] * x[k] / 4);
        force[k] = .15 + .9 * depth * (.6 + .8 * scatter((unsigned)k)) + .05 * scatter((unsigned)k);
        x[k] += .4 * depth * (scatter(3u * (unsigned)k + 1) - .5);
        y[k] += .6 * depth * (scatter(7u * (unsigned)k + 5) - .5);
    }
    double place[BINS], value[BINS], error[BINS], control[BINS], order[BINS], order_error[BINS];
    for (int k = 0; k < BINS; ++k) {
        place[k] = .866 * (k - BINS / 2 + .5);
        value[k] = .176 + .65 * exp(-place[k] * place[k] / 3);
        control[k] = .04 + .53 * exp(-place[k] * place[k] / 1.5);
        error[k] = .02 + .03 * exp(-place[k] * place[k] / 4);
        order[k] = 1 - .6 * exp(-place[k] * place[k] / 2);
        order_error[k] = .02;
    }
    const fw_view_body bodies[2] = {
        {.name = "left", .count = BEAM, .x = x, .y = y, .field = force, .spacing = 1},
        {.name = "right",
         .count = BEAM,
         .x = x + BEAM,
         .y = y + BEAM,
         .field = force + BEAM,
         .spacing = 1}};
    const fw_view view = {.name = "configuration at t = 323", .bodies = bodies, .body_count = 2};
    const fw_curve returns[2] = {
        {"driven, A = 2.5 (mean of 4 seeds ± standard error)", BINS, place, value, error,
         FW_CURVE_LINE, 0},
        {"control, A = 0", BINS, place, control, NULL, FW_CURVE_LINE, FW_CURVE_GREY}};
    const fw_curve bond_order = {NULL, BINS, place, order, order_error, FW_CURVE_LINE, 2};
    const fw_chart charts[2] = {
        {.label = "⟨|F_{return}|⟩ / ε r_{0}^{−1}", .curves = returns, .curve_count = 2},
        {.label = "bond order ψ_{6}", .curves = &bond_order, .curve_count = 1}};
    const fw_figure_region regions[5] = {{-9, -6, "far", 0},
                                         {-6, -1.8, "intermediate", .45},
                                         {-1.8, 1.8, "contact", 1},
                                         {1.8, 6, "intermediate", .45},
                                         {6, 9, "far", 0}};
    fw_figure_stack_plan plan = {.views = &view,
                                 .view_count = 1,
                                 .colouring = {.label = "return force |F| / ε r_{0}^{−1}"},
                                 .charts = charts,
                                 .chart_count = 2,
                                 .label = "x / r_{0}",
                                 .regions = regions,
                                 .region_count = 5};
    draw_everywhere(draw_stack, &plan,
                    page_with("Two beams rub until their contact turns liquid",
                              "After Popov & Filippov 2008, Fig. 6."),
                    "profile");
    /* The control in a column of its own. */
    double calm[BEAMS];
    for (int k = 0; k < BEAMS; ++k) calm[k] = .04 + .6 * exp(-x[k] * x[k]);
    const fw_view_body resting[2] = {
        {.name = "left", .count = BEAM, .x = x, .y = y, .field = calm, .spacing = 1},
        {.name = "right",
         .count = BEAM,
         .x = x + BEAM,
         .y = y + BEAM,
         .field = calm + BEAM,
         .spacing = 1}};
    const fw_view rest = {.name = "control, A = 0", .bodies = resting, .body_count = 2};
    const fw_chart control_charts[2] = {
        {.label = charts[0].label, .curves = returns + 1, .curve_count = 1}, charts[1]};
    fw_figure_stack_plan both[2] = {plan, plan};
    both[1].views = &rest;
    both[1].charts = control_charts;
    draw_everywhere(draw_pair, both, page_with("Driven beams and their control", NULL), "columns");
}

static fw_status draw_map(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_map(page, data, error);
}

static void a_map_is_drawn_with_a_curve_over_it(void **state)
{
    (void)state;
    enum { SIZE = 65, ARC = 100 };
    double growth[SIZE * SIZE], arc_x[ARC], arc_y[ARC];
    for (int k = 0; k < SIZE * SIZE; ++k) {
        double c1 = 1.6 * (k % SIZE) / (SIZE - 1.), c2 = 1.6 * (k / SIZE) / (SIZE - 1.);
        double excess = c1 * c1 + c2 * c2 - 2;
        growth[k] = excess > 0 ? 1 + excess : 1;
    }
    for (int k = 0; k < ARC; ++k) {
        arc_x[k] = M_SQRT2 * cos(M_PI_2 * k / (ARC - 1));
        arc_y[k] = M_SQRT2 * sin(M_PI_2 * k / (ARC - 1));
    }
    const fw_curve arc = {"c_{1}^{2} + c_{2}^{2} = 2", ARC, arc_x, arc_y, NULL, FW_CURVE_LINE, 0};
    fw_figure_map_plan plan = {.columns = SIZE,
                               .rows = SIZE,
                               .values = growth,
                               .p_step = .025,
                               .q_step = .025,
                               .p_label = "c_{1}",
                               .q_label = "c_{2}",
                               .equal_aspect = true,
                               .colouring = {.label = "largest |λ|"},
                               .curves = &arc,
                               .curve_count = 1};
    draw_everywhere(draw_map, &plan, page_with("Stability of the elastic automaton", NULL), "map");
    plan.equal_aspect = false;
    plan.p_label = "time / steps";
    plan.q_label = "density";
    growth[1000] = NAN;
    draw_everywhere(draw_map, &plan, page_with(NULL, NULL), "map-wide");
}

/* --- data nobody wishes for --- */

static void walls_of_every_shape_are_drawn(void **state)
{
    (void)state;
    const fw_vec2 slope[3] = {{0, 14}, {12, 4}, {30, 4}};
    const fw_vec2 wedge[3] = {{20, 10}, {26, 10}, {23, 16}};
    const fw_vec2 wedge_turned[3] = {{12, 22}, {15, 26}, {18, 22}};
    const fw_vec2 middle[1] = {{24, 22}}, ring[1] = {{16, 14}};
    const fw_vec2 block[4] = {{3, 20}, {7, 20}, {7, 24}, {3, 24}};
    fw_outline walls[6] = {
        {.points = slope, .count = 3, .forbidden = FW_FORBIDDEN_RIGHT},
        {.points = wedge, .count = 3, .closed = true, .forbidden = FW_FORBIDDEN_INSIDE},
        {.points = wedge_turned, .count = 3, .closed = true, .forbidden = FW_FORBIDDEN_OUTSIDE},
        {.points = middle, .count = 1, .radius = 3, .forbidden = FW_FORBIDDEN_INSIDE},
        {.points = ring, .count = 1, .radius = 18, .forbidden = FW_FORBIDDEN_OUTSIDE},
        {.points = block, .count = 4, .closed = true, .forbidden = FW_FORBIDDEN_INSIDE}};
    walls[5].displacement = (fw_vec2){2, -3};
    const double x[4] = {8, 9, 8, 9}, y[4] = {14, 14, 15, 15}, field[4] = {-1, .5, NAN, 2};
    const fw_view_body body = {.count = 4, .x = x, .y = y, .field = field, .spacing = 1};
    const fw_view view = {.bodies = &body, .body_count = 1, .walls = walls, .wall_count = 6};
    fw_figure_field_plan plan = {.view = &view, .colouring = {.label = "charge"}};
    /* Too small a body for its walls: they are left out ... */
    draw_everywhere(draw_field, &plan, page_with("A small body in the middle of things", NULL),
                    "walls-left-out");
    /* ... and taken in where the body comes around. */
    const double path_x[3] = {4, 20, 30}, path_y[3] = {30, 16, 0};
    const fw_figure_path path = {path_x, path_y, 3};
    fw_figure_motion_plan motion = {
        .views = &view, .view_count = 1, .paths = &path, .path_count = 1};
    draw_everywhere(draw_motion, &motion, page_with("Walls of every shape", NULL), "walls");
}

static void one_particle_has_a_picture(void **state)
{
    (void)state;
    const double x = 1e4 + .25, y = -3e4, value = 5;
    const fw_view_body body = {.count = 1, .x = &x, .y = &y, .field = &value};
    const fw_view view = {.bodies = &body, .body_count = 1};
    fw_figure_field_plan plan = {.view = &view, .colouring = {.label = "mass"}};
    draw_everywhere(draw_field, &plan, page_with("One particle", NULL), "one-particle");
    const fw_figure_path path = {&x, &y, 1};
    fw_figure_motion_plan motion = {
        .views = &view, .view_count = 1, .paths = &path, .path_count = 1};
    draw_everywhere(draw_motion, &motion, page_with(NULL, NULL), "one-particle-motion");
}

static void nothing_has_a_picture_that_says_so(void **state)
{
    (void)state;
    const fw_view view = {.step = 7};
    fw_figure_field_plan plan = {.view = &view};
    draw_everywhere(draw_field, &plan, page_with(NULL, NULL), "no-particles");
    fw_figure_motion_plan motion = {.view_count = 0};
    draw_everywhere(draw_motion, &motion, page_with(NULL, NULL), "no-motion");
    const double gap[3] = {NAN, INFINITY, -INFINITY}, time[3] = {0, 1, 2};
    const fw_curve curves[2] = {{"none", 0, NULL, NULL, NULL, FW_CURVE_LINE, 0},
                                {"undefined", 3, time, gap, gap, FW_CURVE_LINE, 0}};
    const fw_chart charts[2] = {{.label = "a", .curves = curves, .curve_count = 1},
                                {.label = "b", .curves = curves + 1, .curve_count = 1}};
    fw_figure_stack_plan stack = {.charts = charts, .chart_count = 2, .label = "time"};
    draw_everywhere(draw_stack, &stack, page_with(NULL, NULL), "no-data");
}

static void a_hundred_thousand_particles_have_a_picture(void **state)
{
    (void)state;
    enum { ROW = 400, ROWS = 250, MANY = ROW * ROWS };
    double *numbers = malloc(3 * MANY * sizeof *numbers);
    assert_non_null(numbers);
    double *x = numbers, *y = numbers + MANY, *value = numbers + 2 * MANY;
    for (int k = 0; k < MANY; ++k) {
        int i = k % ROW, j = k / ROW;
        x[k] = i + .5 * (j % 2) + .1 * scatter((unsigned)k);
        y[k] = .866 * j + .1 * scatter((unsigned)k + 7);
        value[k] = sin(.05 * i) * cos(.03 * j) + .2 * scatter((unsigned)k);
    }
    value[5] = 1e9; /* one wild value must not wash out the rest */
    const fw_view_body body = {.count = MANY, .x = x, .y = y, .field = value, .spacing = 1};
    const fw_view view = {.bodies = &body, .body_count = 1};
    fw_figure_field_plan plan = {.view = &view, .colouring = {.label = "pressure", .trim = .001}};
    fw_page page = page_with("A hundred thousand particles", NULL);
    draw_into(draw_field, &plan, page, "many", ".png");
    draw_into(draw_field, &plan, page, "many", ".pdf");
    draw_into(draw_field, &plan, page, "many", ".svg");
    file_bytes svg = read_file(picture_name("many", ".svg"));
    assert_whole_svg(&svg);
    assert_true(svg.count < 4000000);
    free(svg.bytes);
    free(numbers);
}

static void long_noisy_series_stay_small(void **state)
{
    (void)state;
    enum { LONG = 300000 };
    double *numbers = malloc(3 * LONG * sizeof *numbers);
    assert_non_null(numbers);
    double *time = numbers, *value = numbers + LONG, *error = numbers + 2 * LONG;
    for (int k = 0; k < LONG; ++k) {
        time[k] = k;
        value[k] = 1e22 * (3 + sin(2e-5 * k) + .3 * scatter((unsigned)k));
        error[k] = 2e21;
    }
    value[LONG / 2] = 6e22; /* a single spike is seen */
    const fw_curve curve = {"force", LONG, time, value, error, FW_CURVE_LINE, 0};
    const fw_chart charts[2] = {
        {.label = "force", .curves = &curve, .curve_count = 1},
        {.label = "force", .curves = &curve, .curve_count = 1, .logarithmic = true}};
    fw_figure_stack_plan stack = {.charts = charts, .chart_count = 2, .label = "time / steps"};
    draw_everywhere(draw_stack, &stack, page_with("Long", NULL), "long");
    file_bytes svg = read_file(picture_name("long", ".svg"));
    assert_true(svg.count < 4000000);
    free(svg.bytes);
    free(numbers);
}

static void many_instants_get_a_colour_bar(void **state)
{
    (void)state;
    enum { MANY = 24 };
    static double x[MANY][9], y[MANY][9], path_x[MANY], path_y[MANY];
    fw_view_body bodies[MANY];
    fw_view views[MANY];
    for (int k = 0; k < MANY; ++k) {
        for (int p = 0; p < 9; ++p) {
            x[k][p] = 1e4 + 3 * k + p % 3;
            y[k][p] = 1e4 + 8 * fabs(sin(.4 * k)) + p / 3;
        }
        path_x[k] = x[k][4];
        path_y[k] = y[k][4];
        bodies[k] = (fw_view_body){.count = 9, .x = x[k], .y = y[k], .spacing = 1};
        views[k] = (fw_view){.step = 1000 * k, .bodies = &bodies[k], .body_count = 1};
    }
    const fw_figure_path path = {path_x, path_y, MANY};
    fw_figure_motion_plan plan = {
        .views = views, .view_count = MANY, .paths = &path, .path_count = 1};
    draw_everywhere(
        draw_motion, &plan,
        page_with("A title that is much too long for one line of the page, and so has "
                  "to be broken into two of them",
                  "A caption with bytes that are no text: \xff\xfe, and with a raised "
                  "10^{−3} and a lowered c_{1} in it, which goes on and on until it has "
                  "to be broken."),
        "many-instants");
}

static void what_cannot_be_drawn_is_said(void **state)
{
    (void)state;
    fw_error error = {FW_OK, ""};
    fw_page page = fw_page_default();
    page.file = "picture.bmp";
    fw_figure_motion_plan nothing = {.view_count = 0};
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "'picture.bmp'"));
    page.file = PICTURES "no-such-folder/a.png";
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_SYSTEM_FAILED);
    assert_non_null(strstr(error.sentence, "no-such-folder/a.png"));
    page.file = "a.png";
    assert_int_equal(fw_figure_strip(&page, &(fw_figure_strip_plan){.columns = 1}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_map(&page, &(fw_figure_map_plan){.columns = 1}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_forces(&page, &(fw_figure_forces_plan){.panel_count = 0}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_stack(&page, &(fw_figure_stack_plan){.label = "x"}, &error),
                     FW_BAD_INPUT);
    page.resolution = 1e6;
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_BAD_INPUT);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdir(PICTURES, 0777) == 0 || errno == EEXIST ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_on_its_way_is_drawn),
        cmocka_unit_test(a_field_is_drawn_on_the_particles),
        cmocka_unit_test(a_sequence_is_drawn_side_by_side),
        cmocka_unit_test(forces_on_chains_are_drawn),
        cmocka_unit_test(forces_on_a_sheet_are_drawn),
        cmocka_unit_test(observables_over_time_are_drawn),
        cmocka_unit_test(a_dispersion_is_drawn),
        cmocka_unit_test(a_profile_is_drawn_under_its_configuration),
        cmocka_unit_test(a_map_is_drawn_with_a_curve_over_it),
        cmocka_unit_test(walls_of_every_shape_are_drawn),
        cmocka_unit_test(one_particle_has_a_picture),
        cmocka_unit_test(nothing_has_a_picture_that_says_so),
        cmocka_unit_test(a_hundred_thousand_particles_have_a_picture),
        cmocka_unit_test(long_noisy_series_stay_small),
        cmocka_unit_test(many_instants_get_a_colour_bar),
        cmocka_unit_test(what_cannot_be_drawn_is_said),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
