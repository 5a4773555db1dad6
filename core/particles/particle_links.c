/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_links.c - what counts as one piece of matter where movable particles keep out of other
 * bodies: links between near neighbours. Two particles are linked that are closer than 1.4 of the
 * potential's distance, if no third one lies in the circle of which they are a diameter (Gabriel &
 * Sokal 1969). No two such links cross, whatever the order; a hexagonal or a square crystal has its
 * bonds. They follow from the present positions alone. Particles without a potential have none.
 * State: none but scratch. Start reading at fw_particles_list_links(). */
#include "particle_forces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A square's diagonal is longer. */
static const double LINK_LENGTH = 1.4;

enum { AROUND_MAX = 64 };

typedef struct neighbour {
    int particle;
    fw_vec2 away;
} neighbour;

static bool is_one(const fw_particles *particles)
{
    return particles->group_count == 1 || particles->strength_across > 0;
}

int fw_particles_parts(const fw_solid *solid, int number, fw_part *part)
{
    const fw_particles *particles = (const fw_particles *)solid;
    if (is_one(particles)) {
        if (part) *part = (fw_part){NULL, 0, solid->count};
        return 1;
    }
    if (part)
        *part = (fw_part){particles->groups[number].name, particles->groups[number].first,
                          particles->groups[number].count};
    return particles->group_count;
}

/* Within the longest link. */
static int list_around(const fw_particles *particles, int i, double longest, neighbour *around)
{
    const fw_solid *head = &particles->langevin.head;
    const bool one = is_one(particles);
    int count = 0;
    fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
        const fw_vec2 away = {head->x[j] - head->x[i], head->y[j] - head->y[i]};
        if (fw_vec2_dot(away, away) > longest * longest || count == AROUND_MAX) continue;
        if (!one && particles->group_of[j] != particles->group_of[i]) continue;
        around[count++] = (neighbour){j, away};
    }
    return count;
}

/* Does another one lie in the circle, |r - r_j/2|^2 <= r_j^2/4, that is r . (r - r_j) <= 0? */
static bool is_parted(const neighbour *around, int count, int n)
{
    const fw_vec2 to = around[n].away;
    for (int k = 0; k < count; ++k)
        if (k != n && fw_vec2_dot(around[k].away, fw_vec2_subtract(around[k].away, to)) <= 0)
            return true;
    return false;
}

fw_status fw_particles_list_links(fw_solid *solid, bool *changed, fw_error *error)
{
    fw_particles *particles = (fw_particles *)solid;
    const size_t room = 3 * (size_t)solid->count + 1; /* a plane graph has no more */
    *changed = false;
    if (!solid->links) {
        solid->links = malloc(room * sizeof *solid->links);
        particles->other_links = malloc(room * sizeof *particles->other_links);
        if (!solid->links || !particles->other_links)
            return fw_fail_memory(error, "the links of movable particles");
        *changed = true;
    }
    const double longest = fmin(LINK_LENGTH * particles->potential.distance,
                                fmax(particles->potential.cut.outer, particles->bond_radius));
    int(*links)[2] = particles->other_links, count = 0;
    for (int i = 0; i < solid->count; ++i) {
        neighbour around[AROUND_MAX];
        const fw_particle_group *group = &particles->groups[particles->group_of[i]];
        if (!(group->strength * particles->potential.depth > 0)) continue;
        const int near = list_around(particles, i, longest, around);
        for (int n = 0; n < near; ++n) {
            if (around[n].particle < i || is_parted(around, near, n)) continue;
            links[count][0] = i;
            links[count++][1] = around[n].particle;
        }
    }
    *changed |= count != solid->link_count ||
                memcmp(links, solid->links, (size_t)count * sizeof *links) != 0;
    if (!*changed) return FW_OK;
    particles->other_links = solid->links;
    solid->links = links;
    solid->link_count = count;
    return FW_OK;
}
