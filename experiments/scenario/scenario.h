/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario.h - a scenario file as plain data: checked, with every default filled in.
 *
 * Everything is owned by the scenario and lives until it is destroyed; names and texts are never
 * NULL unless said so. Angles and phases are written in degrees and held here in radians. What can
 * only be judged later (an observable's name, a body that starts in a wall) keeps its fw_place, to
 * be reported with fw_scenario_fail. Keys, ranges and defaults: schema_keys.c; start there. */
#ifndef FW_SCENARIO_H
#define FW_SCENARIO_H

#include "contact/geometry/wall.h"
#include "contact/scene/grip.h"
#include "core/automaton/automaton_matrices.h"
#include "core/lattice.h"
#include "core/particles/pair_potential.h"
#include "core/particles/return_force.h"
#include "experiments/scenario/picture_kind.h"
#include "experiments/text/document.h"

/* A text that is looked up later, and where it stands. */
typedef struct fw_scenario_name {
    const char *text; /* NULL: not given */
    fw_place place;
} fw_scenario_name;

typedef struct fw_scenario_names {
    int count;
    fw_scenario_name *item;
} fw_scenario_names;

/* --- materials --- */

typedef struct fw_scenario_boltzmann {
    fw_sym2 rest_mass;
    double damping; /* 1 - mu, 0 <= damping < 1/2 */
    fw_sym2 link_stiffness;
    double break_at; /* stretch beyond which a link breaks; 0: never */
} fw_scenario_boltzmann;

typedef struct fw_scenario_particles {
    fw_pair_potential potential;
    fw_return_force return_force; /* amplitude 0: none */
    int64_t symmetry;             /* its fold, as written */
    bool own_angle;               /* the axes were given an angle; else they are the lattice's */
    double mass, strength;
} fw_scenario_particles;

typedef struct fw_scenario_linear {
    double k1, k2, mass;
    bool compensated;
} fw_scenario_linear;

typedef enum fw_automaton_edges {
    FW_EDGES_BOND,
    FW_EDGES_TRAPEZOID,
    FW_EDGES_MIRROR,
    FW_EDGES_PERIODIC
} fw_automaton_edges;

typedef struct fw_scenario_automaton {
    fw_automaton_speeds speeds; /* inside the disc of stability */
    fw_automaton_edges boundary;
    double damping;  /* 1 - a, 0 <= damping < 1 */
    int black;       /* which sites move first: 0 those with i + j even, 1 odd */
    double break_at; /* 0: never */
} fw_scenario_automaton;

typedef enum fw_material_kind {
    FW_LATTICE_BOLTZMANN,
    FW_MOVABLE_PARTICLES,
    FW_LINEAR_LATTICE,
    FW_ELASTIC_AUTOMATON
} fw_material_kind;

typedef struct fw_scenario_material {
    const char *name;
    fw_place place;
    fw_material_kind kind;
    union {
        fw_scenario_boltzmann boltzmann;
        fw_scenario_particles particles;
        fw_scenario_linear linear;
        fw_scenario_automaton automaton;
    };
} fw_scenario_material;

/* --- sites of a body --- */

typedef enum fw_shape_kind {
    FW_SHAPE_RECTANGLE,
    FW_SHAPE_DISC,
    FW_SHAPE_SITES,
    FW_SHAPE_MASK,
    FW_SHAPE_PLACED
} fw_shape_kind;

typedef struct fw_scenario_shape {
    fw_shape_kind kind;
    int columns, rows; /* rectangle */
    double radius;     /* disc, in spacings */
    fw_vec2 low,
        high;     /* placed: somewhere in here, relative to the origin; sites [0, 0], [1, 0] ... */
    double apart; /* placed: at least */
    fw_sites sites; /* sites and mask: sorted, owned by the scenario; else empty */
    int64_t count;  /* how many sites, whatever the kind */
    int first_row, last_row, first_column, last_column; /* the smallest frame around them */
} fw_scenario_shape;

/* Which sites of a body: those of the list, or those within the rows and columns, which say
 * already which `side` and how many `layers` were asked for. At least one is the body's. */
typedef struct fw_selection {
    fw_place place;
    int first_row, last_row, first_column, last_column; /* inclusive */
    const fw_site *site; /* an explicit list, in the order of particles, or NULL */
    int site_count;
} fw_selection;

/* Values given to selected sites. */
typedef enum fw_pattern_kind {
    FW_PATTERN_UNIFORM,  /* amplitude */
    FW_PATTERN_GAUSSIAN, /* amplitude exp(-|s - centre|^2 / (2 width^2)), s = (i, j) */
    FW_PATTERN_WAVE,     /* amplitude cos(wave_vector . s + phase) */
    FW_PATTERN_PLANE,    /* amplitude cos(wave_vector . r + phase), r the place less the origin */
    FW_PATTERN_GRADIENT, /* gradient r */
    FW_PATTERN_MODE,     /* of an elastic automaton: a running wave of its endless lattice */
    FW_PATTERN_RANDOM    /* each component uniform in [-random, random) */
} fw_pattern_kind;

typedef struct fw_pattern {
    fw_selection sites;
    fw_pattern_kind kind;
    fw_vec2 amplitude;
    fw_vec2 centre;      /* in sites: [i, j] */
    double width;        /* in sites */
    fw_vec2 wave_vector; /* radians per site, or per length */
    double gradient[4];  /* xx xy yx yy */
    double phase;        /* radians */
    double random;
    int branch;  /* mode: FW_SLOW or FW_FAST */
    double size; /* mode: of the white cells' displacement */
} fw_pattern;

typedef struct fw_patterns {
    int count;
    fw_pattern *item; /* displacements and velocities add up */
} fw_patterns;

/* Which links a stiffness is given to, looking at the ends that are selected. */
typedef enum fw_link_choice { FW_LINKS_INSIDE, FW_LINKS_ACROSS, FW_LINKS_TOUCHING } fw_link_choice;

typedef struct fw_replacement {
    fw_selection sites;
    fw_sym2 value;
    fw_link_choice links; /* of link stiffnesses only */
} fw_replacement;

typedef struct fw_replacements {
    int count;
    fw_replacement *item; /* a later one replaces an earlier one */
} fw_replacements;

typedef struct fw_scenario_body {
    const char *name;
    fw_place place;
    int material; /* index into the scenario's materials */
    fw_scenario_shape shape;
    fw_place shape_place;
    fw_lattice lattice; /* kind, spacing, angle in radians, origin = position of site (0, 0) */
    fw_vec2 velocity;
    fw_patterns displacement;
    fw_patterns velocities;
    double spin;             /* angular velocity about its middle at the start */
    double temperature;      /* of its velocities at the start */
    bool displaced_as_given; /* elastic automaton: both colours alike */
    fw_replacements rest_mass;
    fw_replacements link_stiffness;
} fw_scenario_body;

/* --- walls and forces --- */

typedef enum fw_hold_choice { FW_HOLD_NONE, FW_HOLD_X, FW_HOLD_Y, FW_HOLD_BOTH } fw_hold_choice;

typedef struct fw_scenario_drive {
    fw_hold_choice hold; /* as written; what follows from it is in `drive` */
    fw_drive drive;
} fw_scenario_drive;

typedef struct fw_scenario_piston {
    double mass, damping;
    fw_vec2 velocity;
    fw_scenario_drive motion;
} fw_scenario_piston;

typedef struct fw_scenario_wall {
    fw_place place;
    fw_wall_def def; /* with its name */
    bool is_piston;
    fw_scenario_piston piston;
} fw_scenario_wall;

typedef enum fw_force_kind {
    FW_FORCE_EACH,         /* vector on each particle */
    FW_FORCE_TOTAL,        /* vector shared equally among the particles */
    FW_FORCE_ACCELERATION, /* vector times the particle's mass */
    FW_FORCE_RANDOM        /* each component uniform in [-random, random), new in each step */
} fw_force_kind;

typedef struct fw_scenario_force {
    const char *name;
    fw_place place;
    int body; /* index into the scenario's bodies */
    fw_selection sites;
    fw_force_kind kind;
    fw_vec2 vector;
    double random;
    bool balanced;        /* random forces minus their mean over the selection */
    int64_t from, until;  /* acts in the steps from <= step < until */
    int64_t ramp;         /* grows linearly over so many steps after `from`; 0: at once */
    double period, phase; /* times sin(2 pi step / period + phase); period 0: constant */
} fw_scenario_force;

/* --- grips and phases --- */

typedef struct fw_scenario_grip {
    const char *name;
    fw_place place;
    int body; /* index into the scenario's bodies */
    fw_selection sites;
    double layer; /* > 0: of these only what is so near to the outer face of `side` */
    int side;     /* 0 left, 1 right, 2 bottom, 3 top */
    fw_scenario_drive motion;
} fw_scenario_grip;

/* The whole drive of a grip during a phase. */
typedef struct fw_phase_drive {
    fw_place place;
    int grip; /* index into the scenario's grips */
    fw_scenario_drive motion;
} fw_phase_drive;

/* The whole drive of a piston during a phase. */
typedef struct fw_phase_piston {
    fw_place place;
    int wall;       /* index into the scenario's walls */
    double damping; /* < 0: as by itself */
    fw_scenario_drive motion;
} fw_phase_piston;

typedef struct fw_scenario_phase {
    const char *name;
    fw_place place;
    int64_t from, until;         /* the steps from <= step < until */
    double damping, temperature; /* < 0: those of `dynamics` */
    int drive_count, piston_count;
    fw_phase_drive *drives;
    fw_phase_piston *pistons;
} fw_scenario_phase;

/* What is averaged across the scene; no `every`: nothing is. */
typedef struct fw_scenario_profile {
    fw_place place;
    int axis;               /* 0: x, 1: y */
    fw_scenario_name phase; /* text NULL: the whole run */
    int64_t from, until;    /* samples are taken after the steps from < step <= until */
    int64_t every;
    double bin, middle;
    double window[2]; /* of the other coordinate; low == high: all */
    double contact;   /* half width of the contact region */
    double far[2];    /* distances from the middle */
} fw_scenario_profile;

/* The study once for each of several values of a parameter; no values: once. */
typedef struct fw_scenario_sweep {
    fw_place place;
    fw_scenario_name parameter; /* a name of the user's own */
    const char *unit;           /* NULL: none given */
    int value_count;
    double *values; /* all different */
    int setting_count;
    const char **settings; /* changes that make a case, as --set has them, with the parameter */
    bool is_case;          /* one value has been set already: */
    int number;            /* which */
} fw_scenario_sweep;

/* More runs of the same scenario. */
typedef struct fw_scenario_study {
    fw_scenario_sweep sweep;
    int64_t seeds; /* run.seed and the following ones */
    int control_count;
    const char **control; /* changes that make the control run, as --set has them */
    fw_place control_place;
} fw_scenario_study;

/* --- running and recording --- */

/* Of all movable particles and linear lattices of a scenario. */
typedef struct fw_scenario_dynamics {
    double time_step, damping, temperature;
    double strength_across; /* of the potential between particles of different bodies */
    double bond_radius;
    double overlap_energy;
    fw_place time_step_place; /* line 0: not given */
} fw_scenario_dynamics;

typedef struct fw_scenario_run {
    int64_t steps;
    int64_t record_every;     /* >= 1 */
    int64_t measure_every;    /* >= 1 */
    int64_t checkpoint_every; /* 0: left to the program */
    int64_t reverse_at;       /* fields are reversed after so many steps; 0: never */
    int64_t seed;
    double limit; /* a particle further than this from the scene's middle has escaped */
} fw_scenario_run;

typedef struct fw_scenario_record {
    bool velocity, force;
    fw_scenario_names fields; /* fields per particle, by the solid's names */
} fw_scenario_record;

/* --- what is expected --- */

typedef enum fw_statistic {
    FW_STATISTIC_LAST,
    FW_STATISTIC_FIRST,
    FW_STATISTIC_MAXIMUM,
    FW_STATISTIC_MINIMUM,
    FW_STATISTIC_LARGEST, /* in magnitude */
    FW_STATISTIC_MEAN,
    FW_STATISTIC_SPREAD, /* standard deviation */
    FW_STATISTIC_CHANGE, /* last minus first */
    FW_STATISTIC_RATE,   /* least-squares slope against time */
    FW_STATISTIC_TIME_OF_MAXIMUM,
    FW_STATISTIC_TIME_OF_MINIMUM
} fw_statistic;

typedef enum fw_verdict_kind {
    FW_VERDICT_VALUE,
    FW_VERDICT_RELATIVE,
    FW_VERDICT_BOUNDS,
    FW_VERDICT_RISES, /* from each value of a sweep to the next */
    FW_VERDICT_FALLS
} fw_verdict_kind;

typedef struct fw_expectation {
    fw_place place;
    fw_scenario_name quantity; /* an observable */
    fw_scenario_name body;     /* text NULL: the whole scene, or the only body */
    int body_index;            /* -1: none given */
    fw_scenario_name wall;
    int wall_index; /* -1: none given */
    fw_scenario_name grip;
    int grip_index; /* -1: none given */
    fw_scenario_name analysis;
    int analysis_index; /* -1: none given */
    bool has_site;      /* of that body; checked */
    fw_site site;
    fw_scenario_name component; /* "x", "y", "xx", ...; text NULL: none given */
    bool has_at;
    int64_t at;             /* in that step */
    fw_statistic statistic; /* otherwise this of the series ... */
    int64_t from, until;    /* ... over the steps from <= step <= until */
    fw_scenario_name phase; /* that gives these; text NULL: none given */
    int when;               /* number of the only case of a sweep that it speaks of; -1: all */
    fw_verdict_kind kind;
    double value, within; /* within: absolute, or relative to |value| */
    bool has_below, has_above;
    double below, above;
    const char *source; /* NULL: none given */
    const char *note;   /* NULL: none given */
} fw_expectation;

static inline bool fw_expectation_is_trend(const fw_expectation *expectation)
{
    return expectation->kind == FW_VERDICT_RISES || expectation->kind == FW_VERDICT_FALLS;
}

typedef struct fw_scenario_picture {
    const char *name;
    fw_place place;
    fw_picture_kind kind;
    const char *title; /* NULL: the scenario's */
    int instant_count; /* 0: the program chooses */
    int64_t *instants; /* steps, ascending */
    fw_scenario_name field;
    fw_scenario_names observables; /* "energy", "elongation.chain", "momentum.x" */
    int64_t from, until;           /* steps between which a series is drawn */
    bool logarithmic;              /* whether its values are drawn on logarithmic axes */
    double range[2];               /* ends of the colour scale; equal: those of all frames */
    fw_scenario_name analysis;
} fw_scenario_picture;

/* --- what is computed without running --- */

typedef enum fw_analysis_kind {
    FW_ANALYSIS_STABILITY_MAP,
    FW_ANALYSIS_DISPERSION,
    FW_ANALYSIS_PLANE_MODE,
    FW_ANALYSIS_BODY_STABILITY,
    FW_ANALYSIS_BOLTZMANN_REFERENCE
} fw_analysis_kind;

/* Members that its kind does not have are zero. */
typedef struct fw_scenario_analysis {
    const char *name;
    fw_place place;
    fw_analysis_kind kind;
    double c1[2], c2[2]; /* stability map: from, to; body stability: the first of each */
    int points[2];       /* of c1 and of c2, ends included */
    int64_t waves;       /* wave vectors along each side of the Brillouin zone */
    int material;        /* dispersion, plane mode: of kind FW_ELASTIC_AUTOMATON */
    int64_t size,
        steps; /* dispersion: of the periodic body that carries the waves, and of its run */
    fw_vec2 wave_vector; /* plane mode: radians per site */
    fw_automaton_edges boundary;
    int rectangle[2]; /* body stability: columns, rows */
    int body;         /* reference */
    int64_t ticks;    /* reference: half-steps of the automaton */
} fw_scenario_analysis;

/* --- the whole --- */

typedef struct fw_scenario {
    fw_document *document; /* as run: after all --set options */
    const char *title;
    const char *source; /* NULL: none given */
    const char *about;  /* NULL: none given */
    const char *figure; /* NULL: none given */
    int material_count;
    fw_scenario_material *materials;
    int body_count;
    fw_scenario_body *bodies;
    int wall_count;
    fw_scenario_wall *walls;
    int force_count;
    fw_scenario_force *forces;
    int grip_count;
    fw_scenario_grip *grips;
    int phase_count;
    fw_scenario_phase *phases; /* one after the other, from step 0 to the last */
    fw_scenario_profile profile;
    fw_scenario_study study;
    fw_scenario_dynamics dynamics;
    fw_scenario_run run;
    fw_scenario_record record;
    fw_scenario_names measure; /* count 0: the standard set */
    int expectation_count;
    fw_expectation *expectations;
    int picture_count;
    fw_scenario_picture *pictures;
    int analysis_count;
    fw_scenario_analysis *analyses;
} fw_scenario;

/* Reads a scenario; `file` is what sentences call it. `settings` are the arguments of the --set
 * options in order. On failure *scenario is NULL: FW_BAD_INPUT with one sentence that begins with
 * "FILE:LINE:COLUMN: " or "--set OPTION: ", or FW_SYSTEM_FAILED without memory. */
fw_status fw_scenario_read(fw_scenario **scenario, const char *file, const char *text,
                           size_t length, const char *const *settings, int setting_count,
                           fw_error *error);
/* The same for a file on disk. */
fw_status fw_scenario_load(fw_scenario **scenario, const char *path, const char *const *settings,
                           int setting_count, fw_error *error);
void fw_scenario_destroy(fw_scenario *scenario);

/* Is it a sweep as a whole, which is not run itself but case by case? */
bool fw_scenario_is_sweep(const fw_scenario *scenario);
/* One case of a sweep: a scenario of its own, that says which case it is. Sentences about it begin
 * with the place of the sweep. */
fw_status fw_scenario_read_case(fw_scenario **made, const fw_scenario *sweep, int number,
                                fw_error *error);
/* "A=2.5": what sentences and folders call the case. */
enum { FW_CASE_NAME = FW_NAME_BYTES + 32 };
void fw_scenario_case_name(const fw_scenario *scenario, int number, char name[FW_CASE_NAME]);
/* FW_BAD_INPUT of a case: its sentence goes behind the place of the sweep. Returns the status, and
 * changes nothing of others. */
fw_status fw_scenario_fail_case(const fw_scenario *sweep, int number, fw_status status,
                                fw_error *error);

/* FW_BAD_INPUT with the sentence after the place where the fault was written. */
fw_status fw_scenario_fail(const fw_scenario *scenario, fw_place place, fw_error *error,
                           const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The scenario as run, as a text that reads back to the same scenario: *text is malloc'ed. */
fw_status fw_scenario_print(const fw_scenario *scenario, char **text, fw_error *error);

/* Makes the body's sites: row by row, the order of the particles. Caller clears with
 * fw_sites_clear. */
fw_status fw_scenario_sites(const fw_scenario_body *body, fw_sites *sites, fw_error *error);
/* The selected ones as indices into `sites`, ascending: *particles is malloc'ed. Never empty for a
 * selection of this body that was read without error. */
fw_status fw_selection_particles(const fw_selection *selection, const fw_sites *sites,
                                 int **particles, int *count, fw_error *error);

#endif
