/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_place.c - positions, from the lattice and the displacements. Keeps no state.
 * Start reading at fw_automaton_place(). */
#include "automaton_body.h"

/* Site + displacement + drift, as fw_lattice_position() has the site. */
static fw_vec2 place_of(const fw_automaton *body, fw_site site, const fw_automaton_colour *colour,
                        int cell)
{
    const fw_vec2 grid = {body->lattice.spacing * site.i, body->lattice.spacing * site.j};
    const fw_vec2 cosine = body->turn;
    const fw_vec2 home = {body->lattice.origin.x + (cosine.x * grid.x - cosine.y * grid.y),
                          body->lattice.origin.y + (cosine.y * grid.x + cosine.x * grid.y)};
    return (fw_vec2){home.x + (colour->x[cell] + (double)body->drift[0] * body->quantum),
                     home.y + (colour->y[cell] + (double)body->drift[1] * body->quantum)};
}

static void place_run(fw_automaton *body, const fw_automaton_run *run)
{
    for (int parity = 0; parity < 2; ++parity) {
        const int first = run->particle + parity;
        if (parity >= run->count) break;
        const fw_automaton_colour *colour = &body->colour[body->white[first]];
        for (int k = 0; parity + 2 * k < run->count; ++k) {
            const fw_site site = {run->site.i + parity + 2 * k, run->site.j};
            const fw_vec2 at = place_of(body, site, colour, run->cell[parity] + k);
            body->head.x[first + 2 * k] = at.x;
            body->head.y[first + 2 * k] = at.y;
        }
    }
}

void fw_automaton_place(fw_solid *solid)
{
    fw_automaton *body = fw_automaton_of(solid);
    fw_automaton_drop_bonds(body);
    for (int r = 0; r < body->run_count; ++r) place_run(body, &body->run[r]);
}

/* Particles of the boundary ascend, and so do the runs. */
void fw_automaton_place_boundary(fw_automaton *body)
{
    const fw_automaton_run *run = body->run;
    for (int n = 0; n < body->head.boundary_count; ++n) {
        const int particle = body->head.boundary[n];
        while (particle >= run->particle + run->count) ++run;
        const fw_site site = {run->site.i + particle - run->particle, run->site.j};
        const fw_vec2 at =
            place_of(body, site, &body->colour[body->white[particle]], body->cell[particle]);
        body->head.x[particle] = at.x;
        body->head.y[particle] = at.y;
    }
}
