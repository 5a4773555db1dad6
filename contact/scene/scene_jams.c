/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_jams.c - pistons that are jammed by a particle with no way out between them and a wall that
 * does not yield, and what the particle passes on. State: what is known of jams in this tick, in
 * the rows of each body. Start reading at scene_note_jam(). */
#include "scene_parts.h"

#include <math.h>

/* Is the particle still where it jammed the piston? */
static bool still_jams(const scene_contact *contact, const fw_jam *jam)
{
    const fw_vec2 w = contact->solution.displacement;
    const double along = fw_vec2_dot(jam->normal, w);
    return fabs(along - jam->limit) <= 1e-12 * (fabs(jam->limit) + fabs(w.x) + fabs(w.y)) + 1e-300;
}

/* Jams count while they are there: those of this try, and those that keep the piston from it. */
void scene_note_jam(fw_scene *scene, scene_body *body, const scene_contact *contact)
{
    fw_row_list *known = &body->rows[contact->entry];
    if (contact->solution.rows.jam.piston > 0)
        known->jam = contact->solution.rows.jam;
    else if (known->jam.piston > 0 && !still_jams(contact, &known->jam))
        known->jam = (fw_jam){0};
    if (known->jam.piston == 0) return;
    fw_jam *tightest = &scene->walls[known->jam.piston - 1].search.jam;
    if (tightest->piston == 0 || known->jam.limit < tightest->limit) *tightest = known->jam;
}

/* Of several jams the search keeps to the tightest; another may be run over. */
void scene_look_for_overrun(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b)
        for (int n = 0; n < scene->bodies[b].contact_count; ++n) {
            const fw_jam *jam = &scene->bodies[b].rows[scene->bodies[b].contacts[n].entry].jam;
            if (jam->piston == 0) continue;
            scene_wall *wall = &scene->walls[jam->piston - 1];
            const double beyond = fw_vec2_dot(jam->normal, wall->motion) - jam->limit;
            const double size = fabs(wall->motion.x) + fabs(wall->motion.y) + fabs(jam->limit);
            if (beyond > 1e-9 * size) wall->search.fits = false;
        }
}

static bool bears(const scene_body *body, const scene_contact *contact, int wall, const fw_jam *jam)
{
    const fw_jam *own = &body->rows[contact->entry].jam;
    return own->piston == wall + 1 && own->limit <= jam->limit &&
           contact->solution.wall_contact_count + 2 <= FW_WALL_CONTACTS;
}

/* What a force does beside the work of its wall's own motion is lost. */
static void add_wall_contact(fw_contact_solution *solution, int wall, fw_vec2 force, fw_vec2 motion)
{
    const fw_vec2 slip = fw_vec2_subtract(solution->displacement, motion);
    solution->wall_contact[solution->wall_contact_count++] =
        (fw_wall_contact){.wall = wall,
                          .force = force,
                          .work = fw_vec2_dot(force, motion),
                          .dissipated = -fw_vec2_dot(force, slip)};
}

/* The particles that jam a piston share its force and pass it on to the walls behind them. */
void scene_pass_on_jam(fw_scene *scene, int w)
{
    scene_wall *wall = &scene->walls[w];
    const fw_jam jam = wall->search.jam;
    int bearers = 0;
    for (int b = 0; b < scene->body_count; ++b)
        for (int n = 0; n < scene->bodies[b].contact_count; ++n)
            bearers += bears(&scene->bodies[b], &scene->bodies[b].contacts[n], w, &jam);
    if (bearers == 0) return;
    const fw_vec2 share = fw_vec2_scale(wall->search.jammed / bearers, jam.normal);
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int n = 0; n < body->contact_count; ++n) {
            scene_contact *contact = &body->contacts[n];
            if (!bears(body, contact, w, &jam)) continue;
            const int against = body->rows[contact->entry].jam.against;
            add_wall_contact(&contact->solution, w, share, wall->motion);
            add_wall_contact(&contact->solution, against, fw_vec2_scale(-1, share),
                             scene->walls[against].motion);
            scene_push_piston(wall, fw_solid_position(body->solid, contact->particle), share,
                              (fw_sym2){0, 0, 0});
        }
    }
}
