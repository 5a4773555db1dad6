/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view.h - what a picture shows of a scene at one instant: plain arrays that a running scene and a
 * results file can fill alike, and their drawing on a panel.
 *
 * All pointers are observed: they have to stay valid while a figure is drawn, nothing is owned. */
#ifndef FW_VIEW_H
#define FW_VIEW_H

#include "experiments/drawing/colour_scale.h"
#include "experiments/drawing/outline.h"
#include "experiments/drawing/panel.h"

#include <stddef.h>
#include <stdint.h>

typedef struct fw_view_body {
    const char *name; /* for legends; may be NULL */
    int count;
    const double *x, *y; /* [count]; a particle whose place is not finite is not drawn */
    const int *links;    /* [2 link_count] pairs of particles; may be NULL */
    int link_count;
    const double *field;          /* [count] what colours show, may be NULL */
    const unsigned char *species; /* [count] number of a kind, may be NULL: all of kind `kind` */
    int kind;
    double spacing;                  /* of the lattice; 0: mean length of the links, or 1 */
    const double *force_x, *force_y; /* [count] drawn as arrows where a figure has them; or NULL */
} fw_view_body;

typedef struct fw_view {
    const char *name; /* NULL: "step N" */
    int64_t step;
    const fw_view_body *bodies;
    int body_count;
    const fw_outline *walls;
    int wall_count;
    const char *const *kinds; /* [kind_count] names of the species for the legend; may be NULL */
    int kind_count;
} fw_view;

/* Ranges of x and y. */
typedef struct fw_view_bounds {
    fw_range x, y;
} fw_view_bounds;

fw_view_bounds fw_view_bounds_empty(void);
/* Are they all zero? */
bool fw_view_bounds_are_unset(fw_view_bounds bounds);
/* All zero counts as empty. */
fw_view_bounds fw_view_bounds_or_empty(fw_view_bounds bounds);
/* Widens the bounds by the particles, three quarters of a spacing more on each side. */
void fw_view_bounds_include_bodies(fw_view_bounds *bounds, const fw_view *view);
/* Widens the bounds of bodies by the walls of all views, along x and along y by themselves. In a
 * vast box a small body would vanish: no more of a wall is shown than leaves the bodies a third of
 * the frame, or a thirtieth of it between two particles. */
void fw_view_bounds_include_walls(fw_view_bounds *bounds, const fw_view *views, int view_count);

double fw_view_spacing(const fw_view_body *body);
/* The name of a view, or "step N". */
void fw_view_print_name(const fw_view *view, char *text, size_t size);
/* Particles of all bodies. */
long fw_view_count(const fw_view *view);

/* Where particles may not be: a band along each wall, or all of its inside. Drawn opaque below the
 * bodies, and as a veil over particles that fill
 * a place and not a point (`cells`), as wide as these reach. */
void fw_view_draw_walls(const fw_view *view, const fw_panel *panel, bool cells, double opacity);
#define FW_VIEW_VEIL .6
/* The surfaces themselves, to be drawn over the bodies. */
void fw_view_draw_surfaces(const fw_view *view, const fw_panel *panel);
/* Outlines of the walls that stand elsewhere in `last`, a later view of the same scene. */
void fw_view_draw_moved(const fw_view *view, const fw_view *last, const fw_panel *panel,
                        fw_stroke stroke);
void fw_view_draw_links(const fw_view_body *body, const fw_panel *panel, fw_stroke stroke);
/* Discs in one colour, radius in mm. */
void fw_view_draw_discs(const fw_view_body *body, const fw_panel *panel, double radius,
                        fw_colour colour);

/* All places that are nearest to a particle of the body, in one colour. FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_view_draw_silhouette(const fw_view_body *body, const fw_panel *panel, fw_colour colour,
                                  fw_error *error);

/* How particles are drawn where they carry colours. */
typedef enum fw_view_look {
    FW_VIEW_CELLS, /* each fills the places nearest to it: a solid looks solid, gaps are gaps */
    FW_VIEW_DISCS  /* discs of the spacing's diameter */
} fw_view_look;

/* Particles coloured by their field on `scale`, or by species where scale is NULL.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_view_draw_particles(const fw_view *view, const fw_panel *panel, fw_view_look look,
                                 const fw_colour_scale *scale, fw_error *error);

#endif
