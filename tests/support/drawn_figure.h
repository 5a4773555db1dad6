/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drawn_figure.h - figures drawn in all formats, and their files looked at. The pictures stay in
 * FW_PROGRAM-pictures/. */
#ifndef FW_DRAWN_FIGURE_H
#define FW_DRAWN_FIGURE_H

#include "experiments/drawing/figure.h"
#include "tests/support/laws.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PICTURES FW_PROGRAM "-pictures/"

typedef struct file_bytes {
    unsigned char *bytes;
    size_t count;
} file_bytes;

static inline file_bytes read_file(const char *name)
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

static inline uint32_t big_endian(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* The check sum of PNG chunks (ISO 3309). */
static inline uint32_t check_sum(const unsigned char *bytes, size_t count)
{
    uint32_t sum = 0xffffffff;
    for (size_t k = 0; k < count; ++k) {
        sum ^= bytes[k];
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum;
}

/* Signature, all chunks with their sums, the end chunk at the very end. */
static inline void assert_whole_png(const file_bytes *file, unsigned least_width)
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
static inline void assert_whole_pdf(const file_bytes *file)
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
static inline void assert_whole_svg(const file_bytes *file)
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
static inline void forget_surface_numbers(file_bytes *file)
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

static inline void draw_into(draw_figure draw, const void *data, fw_page page, const char *name,
                             const char *ending)
{
    fw_error error = {FW_OK, ""};
    page.file = picture_name(name, ending);
    if (draw(&page, data, &error) != FW_OK) fail_msg("%s%s: %s", name, ending, error.sentence);
}

/* Draws in all formats, each twice: whole files, and the same bytes again. */
static inline void draw_everywhere(draw_figure draw, const void *data, fw_page page,
                                   const char *name)
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

static inline fw_page page_with(const char *title, const char *caption)
{
    fw_page page = fw_page_default();
    page.title = title;
    page.caption = caption;
    return page;
}

/* A deterministic number in [0, 1) from an index. */
static inline double scatter(unsigned number)
{
    number = number * 2654435761u + 12345u;
    number ^= number >> 15;
    number *= 2246822519u;
    number ^= number >> 13;
    return (number >> 8) / (double)(1 << 24);
}

static inline int make_folder(void **state)
{
    (void)state;
    return mkdir(PICTURES, 0777) == 0 || errno == EEXIST ? 0 : -1;
}

#endif
