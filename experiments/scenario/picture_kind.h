/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture_kind.h - the kinds of pictures: one row says of each what it shows, which keys it reads
 * and what it needs. The words of the schema, the help and the refusals follow from the rows; the
 * functions that draw them are in the wing of pictures.
 *
 * To add a kind: a row here, and its function fw_plot_draw_DRAW in the wing of pictures, without
 * which that does not compile. */
#ifndef FW_PICTURE_KIND_H
#define FW_PICTURE_KIND_H

#include <stdbool.h>
#include <stddef.h>

/* What of a scenario a picture needs, beside bodies. */
typedef enum fw_picture_need {
    FW_PICTURE_NEEDS_NOTHING = 0,
    FW_PICTURE_NEEDS_SWEEP = 1 << 0, /* it shows all cases: it is drawn in the sweep's folder */
    FW_PICTURE_NEEDS_PROFILE = 1 << 1,
    FW_PICTURE_NEEDS_TWO_GRIPS = 1 << 2,
    FW_PICTURE_NEEDS_ANALYSIS = 1 << 3,
    FW_PICTURE_NEEDS_TWO_PARAMETERS = 1 << 4,
    FW_PICTURE_NEEDS_FRICTION = 1 << 5, /* fields of which are recorded for it */
    FW_PICTURE_NEEDS_FORCE = 1 << 6     /* it is recorded for it */
} fw_picture_need;

/* So many instants fit side by side with what follows from them. */
enum { FW_PICTURE_PAIRS_MAX = 6 };

/* The solid's first field, where a row names none that is shown by default. */
#define FW_PICTURE_FIRST_FIELD ""

/* Columns: name in the enum; name of its function, after fw_plot_draw_; name; what it shows; keys
 * that it reads beside `kind` and `title`; needs; how many frames are chosen where none are named;
 * field shown where none is named. */
#define FW_PICTURE_ROWS(ROW)                                                                       \
    ROW(MOTION, motion, "motion",                                                                  \
        "the bodies at several instants with the path of the centre of mass", "instants",          \
        FW_PICTURE_NEEDS_NOTHING, 5, NULL)                                                         \
    ROW(FORCES, forces, "forces", "forces as arrows", "instants", FW_PICTURE_NEEDS_NOTHING, 1,     \
        NULL)                                                                                      \
    ROW(CONTACT, contact, "contact",                                                               \
        "the bodies with what acts on them as arrows, several instants side by side", "instants",  \
        FW_PICTURE_NEEDS_FORCE, 2, NULL)                                                           \
    ROW(FIELD, field, "field",                                                                     \
        "a field as colour on the particles, several instants side by side",                       \
        "field range instants", FW_PICTURE_NEEDS_NOTHING, 1, FW_PICTURE_FIRST_FIELD)               \
    ROW(STRIP, strip, "strip", "a field at six instants, or those that are named, side by side",   \
        "field range instants", FW_PICTURE_NEEDS_NOTHING, 6, FW_PICTURE_FIRST_FIELD)               \
    ROW(STRUCTURE, structure, "structure",                                                         \
        "the bodies beside the map of their structure factor (colours from 1/N to 1, if no range " \
        "is given)",                                                                               \
        "range instants", FW_PICTURE_NEEDS_NOTHING, 1, NULL)                                       \
    ROW(STAGES, stages, "stages",                                                                  \
        "the bodies, coloured by a field, above its histograms at several instants",               \
        "field range instants", FW_PICTURE_NEEDS_NOTHING, 3, FW_PICTURE_FIRST_FIELD)               \
    ROW(HISTOGRAM, histogram, "histogram",                                                         \
        "histograms of a field over time as colour, with its mean", "field range from until",      \
        FW_PICTURE_NEEDS_NOTHING, 0, FW_PICTURE_FIRST_FIELD)                                       \
    ROW(SERIES, series, "series", "observables over time", "observables from until logarithmic",   \
        FW_PICTURE_NEEDS_NOTHING, 0, NULL)                                                         \
    ROW(PROFILE, profile, "profile",                                                               \
        "the bodies, coloured by a field, above their profile, the control beside them",           \
        "field range", FW_PICTURE_NEEDS_PROFILE, 1, "return-force")                                \
    ROW(LOOP, loop, "loop", "force along the interface against slip, with a `profile`", "",        \
        FW_PICTURE_NEEDS_PROFILE | FW_PICTURE_NEEDS_TWO_GRIPS, 0, NULL)                            \
    ROW(SLIP, slip, "slip", "where a contact sticks and where it slides, over place and time",     \
        "body from until range", FW_PICTURE_NEEDS_FRICTION, 0, NULL)                               \
    ROW(HEAT, heat, "heat", "where the heat of friction goes, over place and time",                \
        "body from until range", FW_PICTURE_NEEDS_FRICTION, 0, NULL)                               \
    ROW(ANALYSIS, analysis, "analysis", "a map or curves of one of `analysis`", "analysis",        \
        FW_PICTURE_NEEDS_ANALYSIS, 0, NULL)                                                        \
    ROW(SWEEP, sweep, "sweep",                                                                     \
        "quantities of a sweep against a parameter, a line for every value of the others, or "     \
        "against another quantity",                                                                \
        "observables logarithmic along", FW_PICTURE_NEEDS_SWEEP, 0, NULL)                          \
    ROW(MAP, map, "map", "a quantity as colour over the two parameters of a sweep",                \
        "observables logarithmic along range level",                                               \
        FW_PICTURE_NEEDS_SWEEP | FW_PICTURE_NEEDS_TWO_PARAMETERS, 0, NULL)

#define FW_PICTURE_ENUM(id, draw, name, meaning, keys, needs, frames, field) FW_PICTURE_##id,
typedef enum fw_picture_kind { FW_PICTURE_ROWS(FW_PICTURE_ENUM) FW_PICTURE_KINDS } fw_picture_kind;

typedef struct fw_picture_row {
    const char *name, *meaning, *keys;
    unsigned needs;
    int frames;
    const char *field; /* NULL: it shows none */
} fw_picture_row;
extern const fw_picture_row fw_picture_rows[FW_PICTURE_KINDS];

/* "motion: the bodies ...; forces: ..." and "motion, forces, ...". */
#define FW_PICTURE_MEANING(id, draw, name, meaning, keys, needs, frames, field)                    \
    "; " name ": " meaning
#define FW_PICTURE_NAME(id, draw, name, meaning, keys, needs, frames, field) ", " name
#define FW_PICTURE_MEANINGS                                                  (&(FW_PICTURE_ROWS(FW_PICTURE_MEANING))[2])
#define FW_PICTURE_NAMES                                                     (&(FW_PICTURE_ROWS(FW_PICTURE_NAME))[2])

/* Does a picture of this kind read this key? `kind` and `title` are read by all. */
bool fw_picture_reads(fw_picture_kind kind, const char *key);

#endif
