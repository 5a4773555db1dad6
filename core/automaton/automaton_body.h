/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_body.h - how an elastic automaton lies in memory. For the automaton's own files only;
 * everybody else uses elastic_automaton.h.
 *
 * Cells of one colour lie together, row by row, apart from the other colour: a half-step reads one
 * colour and rewrites the other, each a stream of contiguous memory. Cells with all their
 * neighbours form spans, in which every neighbour is at a constant distance in memory; cells at a
 * rim have a table entry of their own. */
#ifndef FW_AUTOMATON_BODY_H
#define FW_AUTOMATON_BODY_H

#include "core/automaton/elastic_automaton.h"

enum { FW_BLACK, FW_WHITE, FW_COLOURS };

/* Cells begin .. begin + count - 1 of a colour: neighbours of cell n in direction d are cells
 * n + offset[d] of the other colour, with the full matrices; their particles are
 * particle + 2 (n - begin). */
typedef struct fw_automaton_span {
    int begin, count, particle;
    int offset[FW_DIRECTIONS];
    bool held; /* in this tick a constraint decides for one of its cells */
} fw_automaton_span;

/* The first cell, span and rim entry of a row of the lattice; the next row has those past the last.
 */
typedef struct fw_automaton_row {
    int cell, span, rim;
} fw_automaton_row;

/* Where spans of a row are interrupted: rim entries of cells that broke, ascending by cell. */
typedef struct fw_automaton_gaps {
    int count, room;
    int *rim;
} fw_automaton_gaps;

/* Sites side by side, and their particles: black and white in turn. */
typedef struct fw_automaton_run {
    fw_site site;
    int particle, count;
    int cell[2]; /* of the first two particles */
} fw_automaton_run;

/* A cell with its own rule: s = sum_d pull[d] (neighbour - self), free displacement
 * (1 + reflection)/2 inverse_mass s. */
typedef struct fw_automaton_rim {
    int cell;
    int span;                     /* that the cell left when it broke; -1: it was at a rim from the
                                   * first */
    int neighbour[FW_DIRECTIONS]; /* cells of the other colour; -1: no bond */
    double weight[FW_DIRECTIONS]; /* of the bond's energy: 1, 1/2 along an edge, 0: no bond */
    fw_sym2 pull[FW_DIRECTIONS];  /* weight B, or what `mirror` makes of it */
    fw_sym2 mass;                 /* m = 1/2 sum_d weight B */
    fw_sym2 inverse_mass;         /* zero for a cell without bonds, which is frozen */
} fw_automaton_rim;

typedef struct fw_automaton_colour {
    int count;
    double *x, *y; /* displacements from the lattice, less the body's drift */
    int *particle; /* of each cell */
    int *place;    /* of each cell: number of its rim entry, or ~number of its span */
    int *held;     /* of each cell: 1 + index of its constraint in this tick, else 0 */
    int span_count, rim_count, rim_room;
    fw_automaton_span *span;
    fw_automaton_rim *rim;
    fw_automaton_row *row;                /* row_count of the body and one more */
    fw_automaton_gaps *gaps;              /* of each row; NULL: the body is unbreakable */
    const fw_sym2 *matrix[FW_DIRECTIONS]; /* B for black, D for white */
} fw_automaton_colour;

/* What one piece of a half-step adds to the ledger. */
typedef struct fw_automaton_share {
    double work, dissipated;
    fw_vec2 impulse, drag;
    bool torn; /* some bond was stretched too far, and stands in `torn` of the body */
} fw_automaton_share;

/* What a bond took with it. */
typedef struct fw_automaton_tear {
    int tick;            /* of those that are taken together */
    int cell, direction; /* black end */
    double energy;
    fw_vec2 drag;
} fw_automaton_tear;

/* Made once for the displacements they belong to: several quantities ask for them in each step. */
typedef struct fw_automaton_sums {
    bool known; /* for the tick of that number */
    int64_t ticks;
    fw_energies energies;
    fw_vec2 momentum;
    bool mass_known; /* of a body that cannot break */
    fw_sym2 mass;
} fw_automaton_sums;

typedef struct fw_automaton {
    fw_solid head;
    fw_automaton_matrices matrices;
    fw_boundary_rule boundary;
    double reflection;
    double break_at; /* stretch of a bond that breaks it */
    bool breaks;     /* break_at is finite */
    fw_lattice lattice;
    fw_vec2 turn; /* cosine and sine of its angle */
    int run_count;
    fw_automaton_run *run; /* ascending: all particles */
    int row_count;         /* rows of the lattice that have cells, ascending */
    bool ring_of_rows;     /* the last row has bonds to the first */
    fw_automaton_colour colour[FW_COLOURS];
    fw_arena cells;   /* of the arrays of both colours but spans and rims, and of the next three */
    int *cell;        /* of each particle: its number within its colour */
    uint8_t *white;   /* of each particle: FW_BLACK or FW_WHITE */
    uint8_t *border;  /* of each particle: bit d, its bond in direction d crosses a seam; bit 4,
                       * one of the eight sites around was never there */
    int64_t drift[2]; /* displacement = x + drift quantum: see automaton_sweep.c */
    double quantum;   /* a power of two, at least one spacing */
    uint8_t *bonds;   /* breakable bodies: bit d of black cell n, its bond in direction d is
                       * whole; else NULL */
    int (*built)[FW_DIRECTIONS]; /* breakable bodies: white neighbours of each black cell as made */
    uint8_t *torn; /* breakable bodies: bit d of each cell that moved, its bond in direction d
                    * is to break; all zero between ticks */
    int gone_count, gone_room;
    int (*gone)[2]; /* links of the head that broke since it was listed */
    int tear_count, tear_booked, tear_room;
    fw_automaton_tear *tear;   /* not yet booked */
    fw_automaton_share *share; /* of each row in FW_SHARED_TICKS ticks */
    fw_automaton_sums *sums;   /* nobody else's, so that sums can be observed */
} fw_automaton;

static inline fw_automaton *fw_automaton_of(fw_solid *solid)
{
    return (fw_automaton *)(void *)solid;
}

static inline const fw_automaton *fw_automaton_of_const(const fw_solid *solid)
{
    return (const fw_automaton *)(const void *)solid;
}

/* The colour that moves in the coming tick; black at tick 0. */
static inline int fw_automaton_moving(const fw_automaton *body)
{
    return (int)(body->head.ticks & 1);
}

/* Lays out the cells of the definition: colours, neighbours, spans, rim, links, boundary. On
 * failure the caller destroys the body. */
fw_status fw_automaton_lay_out(fw_automaton *body, const fw_elastic_automaton_def *def,
                               fw_error *error);
void fw_automaton_release(fw_automaton *body);
/* A list that has room for more than `count` entries of that size: that one, or where it was moved
 * to. NULL without memory: the list is what it was. */
void *fw_automaton_make_room(void *list, int count, int *room, size_t size);

/* Sets masses and pulls of a rim cell from its weights. false: the mass is not positive definite.
 */
bool fw_automaton_rim_weigh(const fw_automaton *body, int colour, fw_automaton_rim *rim);

/* s = sum_d pull[d] (neighbour - self) of any cell. */
fw_vec2 fw_automaton_cell_pull(const fw_automaton *body, int colour, int cell);

/* Masses of any cell; the unit matrix inside. */
fw_sym2 fw_automaton_cell_mass(const fw_automaton *body, int colour, int cell);
fw_sym2 fw_automaton_cell_inverse_mass(const fw_automaton *body, int colour, int cell);
/* What a cell's difference to its neighbour in direction d is multiplied with. */
fw_sym2 fw_automaton_cell_matrix(const fw_automaton *body, int colour, int cell, int direction);
/* The cell of the other colour in direction d (-1: none) and the weight of the bond. */
int fw_automaton_cell_neighbour(const fw_automaton *body, int colour, int cell, int direction,
                                double *weight);

static inline fw_vec2 fw_automaton_at(const fw_automaton_colour *colour, int cell)
{
    return (fw_vec2){colour->x[cell], colour->y[cell]};
}

/* Positions of all particles, of those of the boundary: automaton_place.c. */
void fw_automaton_place(fw_solid *solid);
void fw_automaton_place_boundary(fw_automaton *body);

/* A half-step: automaton_sweep.c. */
void fw_automaton_predict(const fw_solid *solid, const int *particles, int count,
                          fw_prediction *out);
/* A whole step ahead: automaton_ahead.c. */
void fw_automaton_predict_step(const fw_solid *solid, const int *particles, int count,
                               fw_prediction *out);
int fw_automaton_partners(const fw_solid *solid, int particle, fw_partner partners[FW_PARTNERS]);
fw_status fw_automaton_advance(fw_solid *solid, const fw_constraint *constraints,
                               int constraint_count, fw_error *error);
/* Many of them in one sweep through memory: automaton_wave.c. */
fw_status fw_automaton_advance_free(fw_solid *solid, int ticks, fw_error *error);

/* The starting state of the definition: automaton_start.c. */
void fw_automaton_start(fw_automaton *body, const fw_elastic_automaton_def *def);

/* Bonds and boundary of the head, as they are now: listed anew; or those taken out that broke. */
void fw_automaton_list_bonds(fw_automaton *body);
void fw_automaton_drop_bonds(fw_automaton *body);

/* Energies and momentum: automaton_sums.c. */
fw_energies fw_automaton_energies(const fw_solid *solid);
fw_vec2 fw_automaton_momentum(const fw_solid *solid);
/* Half of 1/2 (w - b).B (w - b) over the bonds of a cell; 1/2 sum B (w - b) over those of a black
 * one, 1/2 sum B (b - w) over those of a white one. */
double fw_automaton_bond_energy(const fw_automaton *body, int colour, int cell);
fw_vec2 fw_automaton_bond_momentum(const fw_automaton *body, int colour, int cell);
/* The model's other measurements: automaton_measure.c. */
double fw_automaton_angular_momentum(const fw_solid *solid, int first, int count);
fw_sym2 fw_automaton_mass(const fw_solid *solid);
fw_vec2 fw_automaton_centre_of_mass(const fw_solid *solid);
void fw_automaton_velocities(const fw_solid *solid, double *x, double *y);
void fw_automaton_masses(const fw_solid *solid, double *values);
extern const fw_field fw_automaton_fields[];

/* Breaking: automaton_fracture.c. */
fw_status fw_automaton_rebuild_bonds(fw_automaton *body, fw_error *error);

#endif
