/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity.h - everything that can be measured of an experiment, by name: constant tables, one for
 * any solid and one per model (quantity_MODEL.c).
 * Scenario files name quantities in `measure`, `expect` and `pictures`. */
#ifndef FW_QUANTITY_H
#define FW_QUANTITY_H

#include "experiments/measures/observer.h"

/* What a quantity is measured of. */
typedef enum fw_scope {
    FW_SCOPE_SCENE,   /* the whole scene only */
    FW_SCOPE_BODIES,  /* one body, or all together where none is named */
    FW_SCOPE_BODY,    /* one body; may be left out where there is only one */
    FW_SCOPE_SITE,    /* one site of a body */
    FW_SCOPE_WALL,    /* one wall; may be left out where there is only one */
    FW_SCOPE_PISTON,  /* one wall that is a piston; may be left out where there is only one */
    FW_SCOPE_GRIP,    /* one grip; may be left out where there is only one */
    FW_SCOPE_STUDY,   /* comes out of all runs of a study together; expected only */
    FW_SCOPE_ANALYSIS /* one analysis of its kind; may be left out where there is only one */
} fw_scope;

/* What must be there for it to be measured. */
typedef enum fw_needs {
    FW_NEEDS_NOTHING,
    FW_NEEDS_NO_POSITIONS, /* nothing, and positions inside of bodies need not be right */
    FW_NEEDS_TWO_GRIPS,
    FW_NEEDS_TWO_CRYSTALS, /* bodies of movable particles */
    FW_NEEDS_PROFILE
} fw_needs;

/* What one quantity is measured of. -1, NULL: none. */
typedef struct fw_subject {
    int body, wall, grip, particle; /* particle: within the body */
    const fw_analysis *analysis;
    const fw_observer *observer; /* what is followed beside the scene; NULL: nothing is */
} fw_subject;

enum { FW_COMPONENTS_MAX = 8 };

/* What is a smaller part than this of what it is compared with is rounding: nothing is divided by
 * it. */
#define FW_MEASURED 1e-12

typedef struct fw_quantity {
    const char *name; /* NULL ends the table */
    fw_scope scope;
    const char *components; /* "" for a number, else names: "x y", "xx xy yx yy" */
    const char *unit;
    const char *meaning;
    const char *model; /* only of bodies of these models (analyses of this kind), names with blanks
                        * between; NULL: of any */
    /* NULL for what comes out of a study. Without memory the numbers are NaN. */
    void (*measure)(const fw_experiment *experiment, fw_subject subject, double *out);
    /* When there is none to measure, as the end of a sentence: "no force acts along its normal".
     * The numbers are not finite then. NULL: there always is. */
    const char *absent;
    fw_needs needs;
} fw_quantity;

/* The two components of a vector, as a quantity's numbers. */
static inline void fw_quantity_put(double *out, fw_vec2 v)
{
    out[0] = v.x;
    out[1] = v.y;
}

/* The tables, each in the file of its name. */
extern const fw_quantity fw_common_quantities[];
extern const fw_quantity fw_contact_quantities[];
extern const fw_quantity fw_shape_quantities[];
extern const fw_quantity fw_boltzmann_quantities[];
extern const fw_quantity fw_elastic_quantities[];
extern const fw_quantity fw_particle_quantities[];
extern const fw_quantity fw_automaton_quantities[];
extern const fw_quantity fw_grip_quantities[];
extern const fw_quantity fw_piston_quantities[];
extern const fw_quantity fw_certificate_quantities[];
extern const fw_quantity fw_layer_quantities[]; /* in the order of fw_layer_measure */

/* A quantity that had another name: the refusal of the old one names the new one. */
typedef struct fw_renamed_quantity {
    const char *old_name, *name; /* NULL ends the table */
} fw_renamed_quantity;

extern const fw_renamed_quantity fw_renamed_quantities[];

/* All quantities, model by model: `for (q = first(); q; q = next(q))`. */
const fw_quantity *fw_quantity_first(void);
const fw_quantity *fw_quantity_next(const fw_quantity *quantity); /* NULL: that was the last */
const fw_quantity *fw_quantity_find(const char *name);            /* NULL: there is none */
/* Can it be measured of bodies of that model? */
bool fw_quantity_fits(const fw_quantity *quantity, const char *model);
int fw_quantity_component_count(const fw_quantity *quantity);
/* Number of a component by name, or -1. */
int fw_quantity_find_component(const fw_quantity *quantity, const char *name);
/* Name of a component, written into `name`. */
void fw_quantity_component_name(const fw_quantity *quantity, int component, char name[8]);

#endif
