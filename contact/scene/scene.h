/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene.h - solids, walls and loads in one place, and the time step that moves them.
 * A scene is made in three stages: create; add bodies, walls, grips and loads; begin. Then step.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_SCENE_H
#define FW_SCENE_H

#include "contact/constraint/friction_law.h"
#include "contact/geometry/wall.h"
#include "contact/scene/grip.h"
#include "contact/scene/load.h"
#include "contact/scene/piston.h"
#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

typedef struct fw_scene fw_scene;
struct scene_rubbed;

/* What has passed between the scene and one wall. Forces are those of the wall on the bodies. */
typedef struct fw_wall_ledger {
    fw_vec2 force;     /* of this tick: momentum per time */
    fw_vec2 reaction;  /* [F(t) + F(t-1)]/2: the physical reaction, free of the held mode */
    fw_vec2 impulse;   /* sum of force times tick */
    double work;       /* done on the bodies by the wall's motion */
    double dissipated; /* heat of friction, >= 0 */
    double stored;     /* energy in the springs of a penalty wall */
    double contacts;   /* particles held in this step */
    double held;       /* particle steps held since the beginning */
    double overstep;   /* the most by which friction went beyond its cone, as a part of the widest
                          cone of that tick */
    double creep;      /* the furthest that any particle moved along the wall while it stuck */
} fw_wall_ledger;

/* What other bodies do to a body. Forces are those on the body; of all bodies they add up to zero.
 */
typedef struct fw_body_ledger {
    fw_vec2 force;    /* of this tick: momentum per time */
    fw_vec2 reaction; /* [F(t) + F(t-1)]/2: the physical force, free of the held mode */
    fw_vec2 impulse;  /* sum of force times tick */
    double contacts;  /* its particles and segments that push in this tick */
} fw_body_ledger;

/* How contact between bodies was solved since the beginning. */
typedef struct fw_contact_ledger {
    double ticks;       /* in which bodies touched */
    double iterations;  /* of midpoint normals, of all islands together */
    double unconverged; /* ticks with an island in which normals or friction did not settle: gaps
                           or cones are then inexact, energy and momentum are not */
    double heat;        /* of friction between bodies, >= 0 */
    double overstep;    /* the most by which friction went beyond its cone, as a part of the widest
                           cone of that tick */
    double residual;    /* the largest energy that a tick took or gave by rounding, of one island */
    double creep;       /* the furthest that any particle moved along an edge while it stuck */
} fw_contact_ledger;

/* What the whole scene has exchanged since it began. Closes to rounding:
 * see fw_ledger_energy and fw_ledger_momentum. */
typedef struct fw_ledger {
    double energy_at_start;
    fw_vec2 momentum_at_start;
    double external_work, wall_work, grip_work, dissipated, friction_heat, thermostat_heat;
    double wall_stored; /* in penalty walls, at present; not a part of the bodies' energy */
    fw_vec2 external_impulse, wall_impulse, grip_impulse, drag;
} fw_ledger;

/* What energy and momentum should be, by the ledger. */
double fw_ledger_energy(const fw_ledger *ledger);
fw_vec2 fw_ledger_momentum(const fw_ledger *ledger);

/* A particle further than `limit` from `middle` in x or y has escaped; INFINITY: none can. */
fw_status fw_scene_create(fw_scene **scene, fw_vec2 middle, double limit, fw_error *error);
void fw_scene_destroy(fw_scene *scene);

/* The scene takes the solid over, also on failure. Returns through *body its number. All solids of
 * a scene must share one tick. */
fw_status fw_scene_adopt_body(fw_scene *scene, const char *name, fw_solid *solid, int *body,
                              fw_error *error);
fw_status fw_scene_add_wall(fw_scene *scene, const fw_wall_def *def, fw_error *error);
/* A wall that is a piston: it is moved by its drive and by what touches it, not by def->path. It
 * passes through other walls but those that it is let meet. */
fw_status fw_scene_add_piston(fw_scene *scene, const fw_wall_def *def, const fw_piston_def *piston,
                              fw_error *error);
/* The piston, by its number among the walls, and another wall or piston do not pass through each
 * other: as rigid bodies without friction, whatever their surfaces are; hits are elastic. Before
 * fw_scene_begin(), which refuses those that overlap (FW_BAD_INPUT). FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_scene_let_meet(fw_scene *scene, int piston, int other, fw_error *error);
/* Holds particles of that body. FW_BAD_INPUT: another grip holds one of them already, or the body
 * is an automaton. */
fw_status fw_scene_add_grip(fw_scene *scene, int body, const fw_grip_def *def, fw_error *error);
/* The load acts on particles of that body. */
fw_status fw_scene_add_load(fw_scene *scene, int body, const fw_load_def *def, fw_error *error);

/* How far bodies keep from each other, >= 0, as they do from what they must not enter: penetration
 * counts from there. (Walls at a distance: wall_offset.h.) Before fw_scene_begin(). */
void fw_scene_set_distance(fw_scene *scene, double distance);
/* By pairs of surfaces, as fw_scene_set_surfaces() numbers them, which is called before. */
fw_status fw_scene_set_distances(fw_scene *scene, const double *distances, fw_error *error);

/* Coulomb friction between bodies, of one coefficient; 0, as it is without, is none. Before
 * fw_scene_begin(). */
void fw_scene_set_friction(fw_scene *scene, double coefficient);
/* Coulomb friction by pairs of surfaces: pairs[count][count], the same both ways; of_bodies[body of
 * the scene] is its surface. Walls say theirs in fw_surface.number. Both are copied. After all
 * bodies, before fw_scene_begin(). */
fw_status fw_scene_set_surfaces(fw_scene *scene, int count, const fw_friction *pairs,
                                const int *of_bodies, fw_error *error);

/* Forces of the step before are to be kept for fw_scene_add_contact_forces(). Before
 * fw_scene_begin(). */
void fw_scene_keep_forces(fw_scene *scene);

/* Builds the broadphase and boundaries. FW_BAD_INPUT where a particle starts behind a wall, or a
 * body in another one. */
fw_status fw_scene_begin(fw_scene *scene, fw_error *error);
/* The body that starts in another one, where that was refused; -1: none was. */
int fw_scene_refused_body(const fw_scene *scene);

/* One step of time (two ticks where an automaton takes part). FW_DIVERGED names a particle or
 * piston whose numbers are no longer finite, or that escaped, and a particle that walls which close
 * on it, or its grip, have taken through a wall. */
fw_status fw_scene_step(fw_scene *scene, fw_error *error);

/* The same, quicker where nobody looks at every step: advances by 1 to `most` steps, by more than
 * one only where nothing acts on the bodies, be it that walls and other bodies are too far away for
 * these steps. Positions are right, and particles inside bodies are looked for, after
 * fw_scene_settle() only; nothing else of the scene waits for it. */
fw_status fw_scene_advance(fw_scene *scene, int64_t most, fw_error *error);
fw_status fw_scene_settle(fw_scene *scene, fw_error *error);
/* The same, sooner, where nobody looks at positions but those of boundary particles: what is lost
 * is found, and inside of bodies positions may stay as they are. */
fw_status fw_scene_settle_boundaries(fw_scene *scene, fw_error *error);
/* Whoever advances settles either at least at all multiples of so many steps: what is lost is
 * found. */
enum { FW_SCENE_SETTLES_EVERY = 16 };

/* The largest energy or work so far, by the ledger at the start and after each step: what errors of
 * the energy are a part of. */
double fw_scene_energy_scale(const fw_scene *scene);
/* FW_DIVERGED where energy and ledger are apart by a large part of that, or of the kinetic and the
 * elastic energy together if these are larger. Scenes with a boundary rule or surface that does not
 * conserve energy pass. As dear as the energies are. */
fw_status fw_scene_check_energy(const fw_scene *scene, fw_error *error);

int64_t fw_scene_steps(const fw_scene *scene); /* since the beginning */
double fw_scene_time(const fw_scene *scene);

int fw_scene_body_count(const fw_scene *scene);
fw_solid *fw_scene_body(fw_scene *scene, int body);
const fw_solid *fw_scene_observe_body(const fw_scene *scene, int body);
int fw_scene_wall_count(const fw_scene *scene);
const fw_wall *fw_scene_wall(const fw_scene *scene, int wall);
fw_vec2 fw_scene_wall_displacement(const fw_scene *scene, int wall);

/* The piston that moves the wall; NULL where it is none. Another drive may be set for the next
 * phase. */
fw_piston *fw_scene_piston(fw_scene *scene, int wall);
const fw_piston *fw_scene_observe_piston(const fw_scene *scene, int wall);

int fw_scene_grip_count(const fw_scene *scene);
/* For another drive in the next phase. */
fw_grip *fw_scene_grip(fw_scene *scene, int grip);
const fw_grip *fw_scene_observe_grip(const fw_scene *scene, int grip);

/* Do two bodies keep out of each other: is there matter between their links? The same one: do its
 * parts? */
bool fw_scene_bodies_meet(const fw_scene *scene, int a, int b);
/* Is there friction between them? */
bool fw_scene_bodies_rub(const fw_scene *scene);
/* Of a body, or of one of those that share the solid. */
const fw_body_ledger *fw_scene_body_ledger(const fw_scene *scene, int body, int part);
const fw_contact_ledger *fw_scene_contact_ledger(const fw_scene *scene);
const fw_wall_ledger *fw_scene_wall_ledger(const fw_scene *scene, int wall);
fw_ledger fw_scene_ledger(const fw_scene *scene);
fw_energies fw_scene_energies(const fw_scene *scene);
fw_vec2 fw_scene_momentum(const fw_scene *scene);
/* Steps in which a particle had to be pinned to one wall since no consistent set of walls was
 * found. */
int64_t fw_scene_unresolved(const fw_scene *scene);
/* How deep any boundary particle of the body (-1: of any body) lies behind a wall; 0 if none does.
 */
double fw_scene_penetration(const fw_scene *scene, int body);
/* The same for bodies that keep out of each other: how deep any particle lies in another body. */
double fw_scene_body_penetration(const fw_scene *scene);
/* Does the edge of the body cross itself, and where? Self-contact is not looked for. `home`: where
 * its particles were before it was deformed. Goes with n log n of its boundary particles, but for
 * the first time. FW_SYSTEM_FAILED without memory. */
fw_status fw_scene_find_fold(fw_scene *scene, int body, const fw_vec2 *home, bool *found,
                             fw_vec2 *where, fw_error *error);
/* Adds the forces of walls, grips and other bodies to x and y, one number per particle of the body:
 * the reactions [F(t) + F(t-1)]/2 where fw_scene_keep_forces() was called, else F of the last tick.
 */
void fw_scene_add_contact_forces(const fw_scene *scene, int body, double *x, double *y);

/* What friction has done to each particle, for pictures and files. */
#define FW_FIELD_HEAT    "friction-heat"
#define FW_FIELD_RUBBING "rubbing"
#define FW_FIELD_SLIDING "sliding"
typedef struct fw_contact_field {
    const char *name; /* NULL ends the table */
    const char *unit;
    const char *meaning;
    void (*fill)(const struct scene_rubbed *rubbed, int count, double *values);
} fw_contact_field;
enum { FW_CONTACT_FIELDS = 3 };
extern const fw_contact_field fw_contact_fields[FW_CONTACT_FIELDS + 1];
/* NULL where nothing rubs the body, or there is no such field. */
const fw_contact_field *fw_scene_find_field(const fw_scene *scene, int body, const char *name);
/* A number per particle of the body. */
void fw_scene_fill_field(const fw_scene *scene, int body, const fw_contact_field *field,
                         double *values);

/* Of `count` particles of the body from the first one on, those that have stuck to what rubs them
 * for so many steps on end. (Of what is lightly pressed and bounces each touch begins anew.) */
enum { FW_SCENE_STUCK_STEPS = 50 };
int fw_scene_count_stuck(const fw_scene *scene, int body, int first, int count);

/* Marks with 1, and leaves the others alone, the body's particles that a grip holds: they all move
 * as one, and have no temperature. */
void fw_scene_mark_held(const fw_scene *scene, int body, uint8_t *held);
/* How many queries the broadphase has answered. */
long fw_scene_query_count(const fw_scene *scene);

/* The state, section by section: the scene's own, one per body, those of the grips, of the pistons
 * and of the contact between bodies. */
int fw_scene_section_count(const fw_scene *scene);
const char *fw_scene_section(fw_scene *scene, int section, fw_state_list *list);
/* After saved values were written back into the arrays of all sections. FW_BAD_INPUT: they hold
 * what no scene writes, such as an index out of range; the scene is then of no further use. */
fw_status fw_scene_restored(fw_scene *scene, fw_error *error);

FW_PUBLIC_END

#endif
