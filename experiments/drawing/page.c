/* SPDX-License-Identifier: GPL-3.0-or-later */
/* page.c - sizes, title and caption of a figure.
 * Keeps no state. Start reading at fw_page_open(). */
#include "experiments/drawing/page.h"

#include <math.h>
#include <string.h>

static const fw_colour quiet_ink = {.33, .33, .33, 1};

fw_page fw_page_default(void)
{
    return (fw_page){.width = 160,
                     .resolution = 200,
                     .enlarged = 1,
                     .x_label = {"x (length)", 0},
                     .y_label = {"y (length)", 0}};
}

/* One line of a longer text: as many words as fit. Returns where the next line begins. */
static const char *take_line(const char *text, double width, double size, bool bold, char *line,
                             size_t line_size)
{
    size_t kept = 0, tried = 0;
    text += strspn(text, " \n");
    while (text[tried] && text[tried] != '\n') {
        size_t end = tried + strspn(text + tried, " ");
        end += strcspn(text + end, " \n");
        if (end + 1 > line_size) break;
        memcpy(line, text, end);
        line[end] = '\0';
        if (kept > 0 && fw_canvas_text_width(line, size, bold) > width) break;
        kept = tried = end;
    }
    if (kept == 0) kept = strnlen(text, line_size - 1); /* a word longer than any line */
    memcpy(line, text, kept);
    line[kept] = '\0';
    return text + kept;
}

/* Breaks a text into lines below `top`; draws them if there is a canvas; returns their height. */
static double set_text(const fw_page *page, fw_canvas *canvas, const char *text, double top,
                       double size, bool bold, fw_colour colour)
{
    enum { LINE_SIZE = 512 };
    char line[LINE_SIZE];
    double line_height = 1.05 * fw_canvas_line_height(size), height = 0;
    while (text && text[strspn(text, " \n")]) {
        text = take_line(text, page->width - 2 * FW_PAGE_MARGIN, size, bold, line, LINE_SIZE);
        if (canvas) {
            fw_canvas_text(canvas, (fw_vec2){FW_PAGE_MARGIN, top + height}, line,
                           (fw_text_look){size, colour, FW_TEXT_LEFT, FW_TEXT_TOP, 0, bold});
        }
        height += line_height;
    }
    return height;
}

static const char *title_of(const fw_page *page)
{
    return page->letter ? page->letter : page->bare ? NULL : page->title;
}

static const char *caption_of(const fw_page *page)
{
    return page->bare ? NULL : page->caption;
}

fw_range fw_page_range(fw_range asked, fw_range own, fw_label label)
{
    if (!(asked.low < asked.high)) return own;
    const double factor = label.factor > 0 ? label.factor : 1;
    return (fw_range){asked.low / factor, asked.high / factor};
}

fw_axis fw_page_axis(fw_range asked, fw_range own, fw_label label)
{
    return (fw_axis){.range = fw_page_range(asked, own, label), .label = label};
}

double fw_page_top(const fw_page *page)
{
    double title = set_text(page, NULL, title_of(page), 0, FW_TITLE_SIZE, true, fw_colour_ink());
    return FW_PAGE_MARGIN + title + (title > 0 ? 1.2 : 0);
}

fw_status fw_page_open(const fw_page *page, double bottom, fw_canvas **canvas, fw_error *error)
{
    double caption = set_text(page, NULL, caption_of(page), 0, FW_SMALL_SIZE, false, quiet_ink);
    double gap = caption > 0 ? 2.5 : 0;
    const double height = bottom + gap + caption + FW_PAGE_MARGIN;
    FW_TRY(fw_canvas_create(canvas, page->file, page->enlarged * page->width,
                            page->enlarged * height, page->resolution, error));
    fw_canvas_enlarge(*canvas, page->enlarged);
    set_text(page, *canvas, title_of(page), FW_PAGE_MARGIN, FW_TITLE_SIZE, true, fw_colour_ink());
    set_text(page, *canvas, caption_of(page), bottom + gap, FW_SMALL_SIZE, false, quiet_ink);
    return FW_OK;
}

fw_status fw_page_close(fw_canvas *canvas, fw_status status, fw_error *error)
{
    if (status == FW_OK) status = fw_canvas_save(canvas, error);
    fw_canvas_destroy(canvas);
    return status;
}

static fw_range widened(fw_range range, double extent)
{
    double middle = range.low + (range.high - range.low) / 2;
    return (fw_range){middle - extent / 2, middle + extent / 2};
}

void fw_page_fit_equal(const fw_page *page, fw_panel *panel, double right, double least,
                       double most)
{
    double x_extent = panel->x.range.high - panel->x.range.low;
    /* The room for the numbers depends on the numbers, and those on the height: twice is enough. */
    double depth = 12;
    if (panel->y.label.text) {
        least = fmax(least, fw_canvas_text_width(panel->y.label.text, FW_TEXT_SIZE, false));
    }
    for (int round = 0; round < 3; ++round) {
        double width = fmax(page->width - 2 * FW_PAGE_MARGIN - depth - right, 10);
        double least_extent = least / width * x_extent;
        if (panel->y.range.high - panel->y.range.low < least_extent) {
            panel->y.range = widened(panel->y.range, least_extent);
        }
        double height = (panel->y.range.high - panel->y.range.low) / x_extent * width;
        double shrink = fmin(1, most / height);
        panel->box.width = shrink * width;
        panel->box.height = shrink * height;
        panel->box.left = FW_PAGE_MARGIN + depth + (1 - shrink) * width / 2;
        fw_axis_prepare(&panel->x, panel->box.width, true);
        fw_axis_prepare(&panel->y, panel->box.height, false);
        depth = fw_axis_depth(&panel->y, false);
    }
}

void fw_page_fit(const fw_page *page, fw_panel *panel, double right, double height)
{
    panel->box.height = height;
    fw_axis_prepare(&panel->y, height, false);
    double depth = fw_axis_depth(&panel->y, false);
    panel->box.left = FW_PAGE_MARGIN + depth;
    panel->box.width = fmax(page->width - 2 * FW_PAGE_MARGIN - depth - right, 10);
    fw_axis_prepare(&panel->x, panel->box.width, true);
}
