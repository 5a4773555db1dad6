/* SPDX-License-Identifier: GPL-3.0-or-later */
/* seen_texts.h - what a figure writes, and where: texts are noted on their way to the canvas, and
 * then drawn. For the tests *_texts (see tests/CMakeLists.txt). */
#ifndef FW_SEEN_TEXTS_H
#define FW_SEEN_TEXTS_H

#include "experiments/drawing/canvas.h"

#include <stdio.h>
#include <string.h>

typedef struct seen_text {
    char text[256];
    fw_vec2 at;
    double size;
} seen_text;

enum { SEEN_TEXTS_MAX = 256 };
static seen_text seen_texts[SEEN_TEXTS_MAX];
static int seen_text_count;

void __real_fw_canvas_text(fw_canvas *canvas, fw_vec2 at, const char *text, fw_text_look look);
void __wrap_fw_canvas_text(fw_canvas *canvas, fw_vec2 at, const char *text, fw_text_look look);
void __wrap_fw_canvas_text(fw_canvas *canvas, fw_vec2 at, const char *text, fw_text_look look)
{
    if (seen_text_count < SEEN_TEXTS_MAX) {
        seen_text *seen = &seen_texts[seen_text_count++];
        snprintf(seen->text, sizeof seen->text, "%s", text);
        seen->at = at;
        seen->size = look.size;
    }
    __real_fw_canvas_text(canvas, at, text, look);
}

/* The n-th text that begins so, or NULL. */
static inline const seen_text *find_seen_text(const char *begin, int n)
{
    for (int k = 0; k < seen_text_count; ++k)
        if (strncmp(seen_texts[k].text, begin, strlen(begin)) == 0 && n-- == 0)
            return &seen_texts[k];
    return NULL;
}

#endif
