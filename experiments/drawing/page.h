/* SPDX-License-Identifier: GPL-3.0-or-later */
/* page.h - the paper of a figure: its file, its size, title above and caption below. */
#ifndef FW_PAGE_H
#define FW_PAGE_H

#include "experiments/drawing/panel.h"

typedef struct fw_page {
    const char *file;  /* ends in .png, .svg or .pdf */
    double width;      /* mm; the height follows from what is on it */
    double resolution; /* dots per inch */
    double enlarged;   /* all of it, letters and lines, by this factor; the width above is before */
    double chart_height;       /* of all charts together, mm; 0: chosen */
    fw_range x_range, y_range; /* of the axes, as shown; no extent: chosen */
    const char *title;         /* may be NULL */
    const char *caption;       /* may be NULL; broken into lines where it is long */
    bool bare;                 /* neither is drawn: the paper around it says it */
    fw_label x_label, y_label; /* of places */
    fw_label force;            /* the unit of a force, of 1 if it has no text */
    const char *letter;        /* of a panel, "a", in the place of the title; may be NULL */
} fw_page;

/* 160 mm wide, 200 dots per inch. */
fw_page fw_page_default(void);

/* White margin all round, in mm. */
#define FW_PAGE_MARGIN 3.0

/* The range that an axis has on this page: that which was asked for, or its own. */
fw_range fw_page_range(fw_range asked, fw_range own, fw_label label);
/* An axis of such a range. */
fw_axis fw_page_axis(fw_range asked, fw_range own, fw_label label);

/* Where what is below the title begins, in mm from the top. */
double fw_page_top(const fw_page *page);

/* A canvas as high as the content, which ends at `bottom`, and the caption need; with title and
 * caption drawn. */
fw_status fw_page_open(const fw_page *page, double bottom, fw_canvas **canvas, fw_error *error);

/* Saves if `status` is FW_OK; destroys the canvas in any case; returns the first failure. */
fw_status fw_page_close(fw_canvas *canvas, fw_status status, fw_error *error);

/* Ranges of a panel such that x and y have the same scale: sets width, height and left edge of its
 * box for the page's width less `right` mm. What is flatter than `least` mm gets more range in y;
 * what is higher than `most` mm becomes narrower and stands in the middle. Prepares both axes. */
void fw_page_fit_equal(const fw_page *page, fw_panel *panel, double right, double least,
                       double most);

/* The same for axes of different kinds: all of that width, and the given height. */
void fw_page_fit(const fw_page *page, fw_panel *panel, double right, double height);

#endif
