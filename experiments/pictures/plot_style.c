/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_style.c - the keys of a style file. Keeps no state. */
#include "experiments/pictures/plot_style.h"

typedef struct style {
    double width, height, resolution, font_size;

    bool bare;
} style;

static const fw_key style_keys[] = {
    {"width", AT_NUMBER(style, width), FROM_TO(40, 1000), .default_value = "0",
     .default_meaning = "160", .unit = "mm", .meaning = "of the picture; a column has 86"},
    {"height", AT_NUMBER(style, height), FROM_TO(10, 1000), .default_value = "0",
     .default_meaning = "chosen", .unit = "mm", .meaning = "of all charts together"},
    {"dpi", AT_NUMBER(style, resolution), FROM_TO(20, 2400), .default_value = "0",
     .default_meaning = "200", .meaning = "dots per inch of a PNG file"},
    {"font-size", AT_NUMBER(style, font_size), FROM_TO(4, 40), .default_value = "0",
     .default_meaning = "8.5", .unit = "points", .meaning = "of labels; lines go with it"},
    {"bare", AT_FLAG(style, bare), .default_value = "false",
     .meaning = "without title and caption, which the paper around it has"},
    {.name = NULL}};

const fw_section fw_plot_style_section = {"A style file", "a style",
                                          "How pictures look, `fretwork plot --style FILE`.",
                                          .keys = style_keys};

fw_status fw_plot_style_read(fw_plot_wish *wish, const char *path, fw_error *error)
{
    fw_document *document;
    style read = {.width = 0};
    FW_TRY(fw_document_load(&document, path, error));
    fw_status status = fw_schema_check(document, &fw_plot_style_section, error);
    if (status == FW_OK)
        status = fw_schema_fill(document, &fw_plot_style_section, fw_document_root(document), &read,
                                error);
    fw_document_destroy(document);
    if (status != FW_OK) return status;
    if (wish->width == 0) wish->width = read.width;
    if (wish->height == 0) wish->height = read.height;
    if (wish->resolution == 0) wish->resolution = read.resolution;
    if (wish->font_size == 0) wish->font_size = read.font_size;
    wish->bare |= read.bare;
    return FW_OK;
}
