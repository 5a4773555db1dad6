/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_parts.h - a result as the pictures need it, and a picture that is decided; for the files
 * plot*.c alone. */
#ifndef FW_PLOT_PARTS_H
#define FW_PLOT_PARTS_H

#include "experiments/drawing/figure.h"
#include "experiments/measures/profile_table.h"
#include "experiments/pictures/wall_outline.h"
#include "experiments/results/playback.h"
#include "experiments/scenario/scenario.h"
#include "plot_label.h"

/* Everything but the numbers of single frames. */
typedef struct fw_plot_result {
    const char *directory;
    fw_playback *playback;
    fw_scenario *scenario; /* as it was run */
    int64_t *steps;        /* of all frames */
    double *times;
    double *rest_x, *rest_y; /* places of all particles in their lattices */
    int *links;              /* pairs of particles, numbered within their body, body by body */
    int *link_first;         /* per body: number of its first link; one more for the end */
    fw_wall **walls;
    fw_vec2 (*corners)[FW_WALL_CORNERS_MAX]; /* per wall: those of a box */
    double *
        *piston_paths; /* per wall: x and y of its displacement, per sample; NULL: on its path */
    int64_t *sample_steps;
    const char *units;            /* a sentence for captions */
    const fw_view_bounds *bounds; /* of all frames, where they were found before; or NULL */
} fw_plot_result;

/* FW_BAD_INPUT: there are no results, or no frame in them, or they are not of their scenario. */
fw_status fw_plot_result_open(fw_plot_result *result, const char *directory, fw_error *error);
/* Of a result that is all zero, opened, or could not be. */
void fw_plot_result_close(fw_plot_result *result);

/* The frame nearest to a step. */
int64_t fw_plot_nearest_frame(const fw_plot_result *result, int64_t step);

/* Outlines of all walls of the scenario, where they are in a frame. */
void fw_plot_walls_at(fw_outline *walls, const fw_plot_result *result, int64_t frame);

/* One frame as a view; the links that are broken (stretched beyond where they break) are left out.
 */
typedef struct fw_plot_view {
    fw_view view;
    char name[96]; /* "step 8 000, time 40" */
    double *x, *y, *field;
    int *links;
    fw_view_body *bodies;
    fw_outline *walls;
} fw_plot_view;

/* `field`: name of the field in the file, or NULL. Cleared also after a failure. */
fw_status fw_plot_view_load(fw_plot_view *view, const fw_plot_result *result, int64_t frame,
                            const char *field, fw_error *error);
void fw_plot_view_clear(fw_plot_view *view);

/* A picture with every choice made. */
typedef struct fw_plot_picture {
    fw_scenario_picture asked; /* by the scenario, the command line, or usual */
    fw_page page;
    bool fixed_axes; /* of the whole result: the scenario did not choose the instants */
    int frame_count; /* >= 1 where its kind shows frames */
    int64_t *frames; /* ascending */
    int observable_count;
    const char **observables;
    char field_label[FW_NAME_SIZE]; /* without unit, for sentences */
    char field_axis[2 * FW_NAME_SIZE];
    fw_label field;          /* points to it */
    fw_palette_map map;      /* wished for; AUTO: that of its kind */
    bool in_steps;           /* a series over steps, not times */
    const char *along;       /* of a series: what is along x in place of the time; NULL: time */
    const char *const *with; /* folders that a series is compared with */
    int with_count;
    const fw_scenario_analysis *analysis;
    const char *data; /* name of the table of its numbers in the result's folder; NULL: no table */
} fw_plot_picture;

/* Of the field that is asked for, or of none; the label points into the picture. */
void fw_plot_name_field(fw_plot_picture *picture, const fw_plot_result *result);

/* --- what is found before anything is drawn --- */

/* The paths of the centres of mass from the first frame shown to the last one (up to it, where it
 * is the only one), of the bodies whose centre moves. */
typedef struct fw_plot_paths {
    int count;
    fw_figure_path *path;
    double *x, *y; /* what they point into */
} fw_plot_paths;
fw_status fw_plot_paths_find(fw_plot_paths *paths, const fw_plot_result *result,
                             const fw_plot_picture *picture, fw_error *error);

/* A panel for each body in each frame, with the forces of its links, which follow from where its
 * particles are (Chopard & Marconi Eq 31), and the external ones where the file has them. Where a
 * body has travelled, its original places are moved along. */
typedef struct fw_plot_forces {
    const fw_plot_result *result;
    int panel_count;
    fw_figure_forces_panel *panels;
    char (*names)[256]; /* what the panels point into */
    fw_figure_force *arrows;
    int arrow_count, view_count;
    fw_plot_view *views;
    fw_sym2 *stiffness;              /* of all links of the result */
    double *force_x, *force_y;       /* of one frame */
    double *original_x, *original_y; /* of all frames: at rest, moved along with the body */
} fw_plot_forces;
fw_status fw_plot_forces_find(fw_plot_forces *forces, const fw_plot_result *result,
                              const fw_plot_picture *picture, fw_error *error);

/* The colour of what a heat bath is set to. */
enum { FW_PLOT_BATH_COLOUR = 7 };

/* The curves that the observables of a picture stand for, in panels. */
typedef struct fw_plot_series {
    const fw_plot_result *result;
    int panel_count;
    fw_chart *charts;
    fw_curve *drawn; /* what the charts point into */
    char (*labels)[4 * FW_NAME_SIZE];
    int curve_count;
    struct fw_plot_curve *curves;
    int64_t *steps; /* of all samples */
    double *times;
    double *along; /* what is along x in place of the times, or NULL */
    char along_text[4 * FW_NAME_SIZE];
    fw_label along_label;
    double *set;      /* temperature of the heat bath in those that are drawn, or NULL */
    int first, shown; /* samples that are drawn */
} fw_plot_series;
fw_status fw_plot_series_find(fw_plot_series *series, const fw_plot_result *result,
                              const fw_plot_picture *picture, fw_error *error);

/* The middles of the bins, what a column of the profile is there, of the experiment or of its
 * control (NaN where nothing was seen), and the errors, 0 where there are none: bin_count of each.
 */
void fw_plot_profile_values(const fw_profile_table *table, fw_profile_column column, bool control,
                            double *x, double *values, double *errors);

/* A number for each particle of a body that rubs, in the order of places, and for each time between
 * two frames: by how much a field grew there, over the steps in which it rubbed, or over the time.
 * NaN where it did not rub. */
typedef struct fw_plot_rubbing {
    const fw_plot_result *result;
    const fw_plot_picture *picture;
    int body, first, count; /* its particles among all */
    int64_t from, until;    /* first and last frame of the span */
    bool along_y;           /* the places of the particles that rub spread most along y */
    int row_count;
    int *particles;                                  /* one per row, ascending in place ... */
    double *places;                                  /* ... at rest */
    double *values;                                  /* row by row */
    double *before, *now, *steps_before, *steps_now; /* fields of two frames, all particles */
} fw_plot_rubbing;
fw_status fw_plot_rubbing_find(fw_plot_rubbing *rubbing, const fw_plot_result *result,
                               const fw_plot_picture *picture, const char *field, bool over_steps,
                               fw_error *error);

/* All may be cleared whether they were found or not. */
void fw_plot_paths_clear(fw_plot_paths *paths);
void fw_plot_forces_clear(fw_plot_forces *forces);
void fw_plot_rubbing_clear(fw_plot_rubbing *rubbing);
void fw_plot_series_clear(fw_plot_series *series);

/* --- pictures --- */

/* Each makes the file; the caption of the page is added to. */
fw_status fw_plot_draw_motion(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error);
fw_status fw_plot_draw_field(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error);
fw_status fw_plot_draw_strip(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error);
fw_status fw_plot_draw_forces(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error);
fw_status fw_plot_draw_structure(const fw_plot_result *result, const fw_plot_picture *picture,
                                 fw_error *error);
fw_status fw_plot_draw_stages(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error);
fw_status fw_plot_draw_histogram(const fw_plot_result *result, const fw_plot_picture *picture,
                                 fw_error *error);
fw_status fw_plot_draw_series(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error);
fw_status fw_plot_draw_profile(const fw_plot_result *result, const fw_plot_picture *picture,
                               fw_error *error);
fw_status fw_plot_draw_loop(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error);
fw_status fw_plot_draw_contact(const fw_plot_result *result, const fw_plot_picture *picture,
                               fw_error *error);
fw_status fw_plot_draw_slip(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error);
fw_status fw_plot_draw_heat(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error);
fw_status fw_plot_draw_analysis(const fw_plot_result *result, const fw_plot_picture *picture,
                                fw_error *error);

#endif
