/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_stops.c - pistons that are stopped by a particle with no way out between them and a wall
 * that does not yield, and what the particle passes on. State: what is known of stops in this tick,
 * in the rows of each body. Start reading at scene_look_at_stop(). */
#include "scene_parts.h"

#include <math.h>

/* Is the particle still where it stopped the piston? */
static bool still_stops(const scene_contact *contact, const fw_stop *stop)
{
    const fw_vec2 w = contact->solution.displacement;
    const double along = fw_vec2_dot(stop->normal, w);
    return fabs(along - stop->limit) <=
           1e-12 * (fabs(stop->limit) + fabs(w.x) + fabs(w.y)) + 1e-300;
}

/* Stops count while they are there: those of this try, and those that keep the piston from it. */
void scene_look_at_stop(fw_scene *scene, scene_body *body, const scene_contact *contact)
{
    fw_row_list *known = &body->rows[contact->entry];
    if (contact->solution.rows.stop.piston > 0)
        known->stop = contact->solution.rows.stop;
    else if (known->stop.piston > 0 && !still_stops(contact, &known->stop))
        known->stop = (fw_stop){0};
    if (known->stop.piston == 0) return;
    fw_stop *tightest = &scene->walls[known->stop.piston - 1].search.stop;
    if (tightest->piston == 0 || known->stop.limit < tightest->limit) *tightest = known->stop;
}

/* Of several stops the search keeps to the tightest; another may be run over. */
void scene_look_for_overrun(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b)
        for (int n = 0; n < scene->bodies[b].contact_count; ++n) {
            const fw_stop *stop = &scene->bodies[b].rows[scene->bodies[b].contacts[n].entry].stop;
            if (stop->piston == 0) continue;
            scene_wall *wall = &scene->walls[stop->piston - 1];
            const double beyond = fw_vec2_dot(stop->normal, wall->motion) - stop->limit;
            const double size = fabs(wall->motion.x) + fabs(wall->motion.y) + fabs(stop->limit);
            if (beyond > 1e-9 * size) wall->search.fits = false;
        }
}

static bool bears(const scene_body *body, const scene_contact *contact, int wall,
                  const fw_stop *stop)
{
    const fw_stop *own = &body->rows[contact->entry].stop;
    return own->piston == wall + 1 && own->limit <= stop->limit &&
           contact->solution.touch_count + 2 <= FW_TOUCH_MAX;
}

/* What a force does beside the work of its wall's own motion is lost. */
static void add_touch(fw_contact_solution *solution, int wall, fw_vec2 force, fw_vec2 motion)
{
    const fw_vec2 slip = fw_vec2_subtract(solution->displacement, motion);
    solution->touch[solution->touch_count++] = (fw_touch){.wall = wall,
                                                          .force = force,
                                                          .work = fw_vec2_dot(force, motion),
                                                          .dissipated = -fw_vec2_dot(force, slip)};
}

/* The particles that stop a piston share its force and pass it on to the walls behind them. */
void scene_pass_on_stop(fw_scene *scene, int w)
{
    scene_wall *wall = &scene->walls[w];
    const fw_stop stop = wall->search.stop;
    int bearers = 0;
    for (int b = 0; b < scene->body_count; ++b)
        for (int n = 0; n < scene->bodies[b].contact_count; ++n)
            bearers += bears(&scene->bodies[b], &scene->bodies[b].contacts[n], w, &stop);
    if (bearers == 0) return;
    const fw_vec2 share = fw_vec2_scale(wall->search.stopped / bearers, stop.normal);
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int n = 0; n < body->contact_count; ++n) {
            scene_contact *contact = &body->contacts[n];
            if (!bears(body, contact, w, &stop)) continue;
            const int against = body->rows[contact->entry].stop.against;
            add_touch(&contact->solution, w, share, wall->motion);
            add_touch(&contact->solution, against, fw_vec2_scale(-1, share),
                      scene->walls[against].motion);
            scene_push_piston(wall, fw_solid_position(body->solid, contact->particle), share,
                              (fw_sym2){0, 0, 0});
        }
    }
}
