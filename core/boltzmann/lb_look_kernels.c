/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_look_kernels.c - energies, momentum, positions and velocities out of the displacements of a
 * row; compiled once for each instruction set. Keeps no state. Start reading at fields_of(). */
#include "lb_look_kernels.h"

#include "lb_vectors.h"

#include <assert.h>
#include <string.h>

FW_INLINE fw_vector_pair add(fw_vector_pair a, fw_vector_pair b)
{
    return (fw_vector_pair){a.x + b.x, a.y + b.y};
}

FW_INLINE fw_vector_pair subtract(fw_vector_pair a, fw_vector_pair b)
{
    return (fw_vector_pair){a.x - b.x, a.y - b.y};
}

/* f_{d+2}(l) = (x_m(t) - x_l(t-1))/2 */
FW_INLINE fw_vector_pair half_difference(fw_vector_pair ahead, fw_vector_pair behind)
{
    return (fw_vector_pair){0.5 * (ahead.x - behind.x), 0.5 * (ahead.y - behind.y)};
}

/* (f.f)/2 */
FW_INLINE fw_vector half_square(fw_vector_pair f)
{
    return 0.5 * (f.x * f.x + f.y * f.y);
}

/* What is read for the first time, so many places before it is needed. */
FW_INLINE void fetch_ahead(const lb_grid_arrays *a, int place, int north)
{
    enum { AHEAD = 256 };
    __builtin_prefetch(a->ahead_x + place + north + AHEAD, 0);
    __builtin_prefetch(a->ahead_y + place + north + AHEAD, 0);
    __builtin_prefetch(a->behind_x + place + north + AHEAD, 0);
    __builtin_prefetch(a->behind_y + place + north + AHEAD, 0);
}

FW_INLINE void fetch_sites_ahead(const lb_particle_arrays *p, int particle)
{
    enum { AHEAD = 256 };
    __builtin_prefetch(p->site_x + particle + AHEAD, 0);
    __builtin_prefetch(p->site_y + particle + AHEAD, 0);
}

/* All links of the block that begins at a place are there. */
FW_INLINE bool is_whole(const lb_grid_arrays *a, int place)
{
    uint32_t bits;
    memcpy(&bits, a->links[place / FW_BLOCK], sizeof bits);
    return bits == UINT32_MAX;
}

FW_INLINE fw_vector_pair keep(fw_mask mask, fw_vector_pair v, bool whole)
{
    if (whole) return v;
    return (fw_vector_pair){fw_keep(mask, v.x), fw_keep(mask, v.y)};
}

/* The fields that come to as many places as a register holds, and their sum. */
typedef struct field_lanes {
    fw_vector_pair ahead, behind;
    fw_vector_pair field[FW_DIRECTIONS];
    fw_mask linked[FW_DIRECTIONS];
    fw_vector_pair psi;
} field_lanes;

FW_INLINE field_lanes fields_of(const lb_grid_arrays *a, int place, int part, const int distance[],
                                bool whole)
{
    field_lanes f = {.ahead = fw_load_pair(a->ahead_x, a->ahead_y, place),
                     .behind = fw_load_pair(a->behind_x, a->behind_y, place)};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!whole) f.linked[d] = fw_mask_of(a->links[place / FW_BLOCK][d], part);
        const fw_vector_pair beside = fw_load_pair(a->ahead_x, a->ahead_y, place + distance[d]);
        f.field[d] = keep(f.linked[d], half_difference(beside, f.behind), whole);
    }
    f.psi = add(add(f.field[FW_EAST], f.field[FW_WEST]), add(f.field[FW_NORTH], f.field[FW_SOUTH]));
    return f;
}

/* Both fields of a link: their difference is its stretch. */
FW_INLINE void terms_of_part(const lb_grid_arrays *a, int place, int part, const int distance[],
                             int at, bool whole, lb_field_terms *terms)
{
    const field_lanes f = fields_of(a, place, part, distance, whole);
    for (int d = FW_EAST; d <= FW_NORTH; ++d) {
        const fw_vector_pair here = f.field[d];
        const fw_vector_pair there =
            half_difference(f.ahead, fw_load_pair(a->behind_x, a->behind_y, place + distance[d]));
        const fw_vector elastic = half_square(subtract(here, there)),
                        kinetic = half_square(add(here, there));
        fw_store(terms->elastic[d] + at, whole ? elastic : fw_keep(f.linked[d], elastic));
        fw_store(terms->kinetic[d] + at, whole ? kinetic : fw_keep(f.linked[d], kinetic));
    }
    fw_store(terms->psi_x + at, f.psi.x);
    fw_store(terms->psi_y + at, f.psi.y);
}

static void terms(const lb_grid_arrays *arrays, int place, int count, int north, int south,
                  lb_field_terms *out)
{
    const lb_grid_arrays a = *arrays;
    const int distance[FW_DIRECTIONS] = {1, north, -1, south};
    assert(place % FW_BLOCK == 0 && count <= LB_TERMS_MAX);
    for (int k = 0; k < count; k += FW_BLOCK) {
        fetch_ahead(&a, place + k, north);
        const bool whole = is_whole(&a, place + k);
        for (int part = 0; part < FW_PARTS; ++part) {
            const int at = k + part * FW_WIDTH;
            if (whole)
                terms_of_part(&a, place + at, part, distance, at, true, out);
            else
                terms_of_part(&a, place + at, part, distance, at, false, out);
        }
    }
}

/* --- positions and velocities --- */

/* Of the lanes of a block, those that belong to a stretch. */
FW_INLINE uint8_t lanes_of(lb_stretch s, int place)
{
    const int before = s.place - place, left = s.place + s.count - place;
    const uint8_t from = before > 0 ? (uint8_t)(0xff << before) : 0xff;
    return (uint8_t)(from & fw_first_lanes(left));
}

FW_INLINE void put(double *to, uint8_t lanes, int part, fw_vector v)
{
    if (lanes == 0xff)
        fw_store(to, v);
    else
        fw_store_some(to, fw_mask_of(lanes, part), v);
}

/* r = site + (common + u) */
FW_INLINE fw_vector position_of(const double *site, double common, fw_vector ahead,
                                fw_vector behind)
{
    return fw_load(site) + (common + 0.5 * (ahead + behind));
}

/* A multiple of one times a vector, as fw_sym2_apply() has it. */
FW_INLINE fw_vector_pair scaled(fw_vector m, fw_vector_pair v)
{
    const fw_vector none = fw_splat(0);
    return (fw_vector_pair){m * v.x + none * v.y, none * v.x + m * v.y};
}

FW_INLINE fw_vector mass_of(const lb_grid_arrays *a, const lb_particle_arrays *p, int place,
                            int part, int particle)
{
    if (p->mass) return fw_load(p->mass + particle);
    return counted_mass(a->rest_square, a->links[place / FW_BLOCK], part);
}

FW_INLINE fw_vector inverse_of(const lb_grid_arrays *a, const lb_particle_arrays *p, int place,
                               int part, int particle)
{
    if (p->inverse) return fw_load(p->inverse + particle);
    return 1 / counted_mass(a->rest_square, a->links[place / FW_BLOCK], part);
}

static void motions(const lb_grid_arrays *arrays, const lb_particle_arrays *particles, lb_stretch s,
                    int north, int south, const fw_motions *out)
{
    const lb_grid_arrays a = *arrays;
    const lb_particle_arrays p = *particles;
    const fw_motions to = *out;
    const int distance[FW_DIRECTIONS] = {1, north, -1, south};
    for (int place = s.place / FW_BLOCK * FW_BLOCK; place < s.place + s.count; place += FW_BLOCK) {
        const bool whole = is_whole(&a, place);
        const uint8_t lanes = lanes_of(s, place);
        const bool plain = whole && p.plain;
        fetch_ahead(&a, place, north);
        fetch_sites_ahead(&p, s.particle + place - s.place);
        for (int part = 0; part < FW_PARTS; ++part) {
            const int here = place + part * FW_WIDTH, at = here - s.place,
                      particle = s.particle + at;
            const field_lanes f = whole ? fields_of(&a, here, part, distance, true)
                                        : fields_of(&a, here, part, distance, false);
            const fw_vector inverse =
                plain ? fw_splat(p.plain_inverse) : inverse_of(&a, &p, here, part, particle);
            const fw_vector_pair v = scaled(inverse, f.psi);
            put(to.x + at, lanes, part,
                position_of(p.site_x + particle, p.common.x, f.ahead.x, f.behind.x));
            put(to.y + at, lanes, part,
                position_of(p.site_y + particle, p.common.y, f.ahead.y, f.behind.y));
            put(to.velocity_x + at, lanes, part, v.x);
            put(to.velocity_y + at, lanes, part, v.y);
        }
    }
}

/* Positions, or M (r - base). */
FW_INLINE void place_stretch(const lb_grid_arrays *arrays, const lb_particle_arrays *particles,
                             lb_stretch s, bool weighted, fw_vec2 base, double *x, double *y)
{
    const lb_grid_arrays a = *arrays;
    const lb_particle_arrays p = *particles;
    for (int place = s.place / FW_BLOCK * FW_BLOCK; place < s.place + s.count; place += FW_BLOCK) {
        const uint8_t lanes = lanes_of(s, place);
        const bool plain = weighted && p.plain && is_whole(&a, place);
        fetch_ahead(&a, place, 0);
        fetch_sites_ahead(&p, s.particle + place - s.place);
        for (int part = 0; part < FW_PARTS; ++part) {
            const int here = place + part * FW_WIDTH, at = here - s.place,
                      particle = s.particle + at;
            const fw_vector_pair ahead = fw_load_pair(a.ahead_x, a.ahead_y, here),
                                 behind = fw_load_pair(a.behind_x, a.behind_y, here);
            fw_vector_pair r = {position_of(p.site_x + particle, p.common.x, ahead.x, behind.x),
                                position_of(p.site_y + particle, p.common.y, ahead.y, behind.y)};
            if (weighted) {
                const fw_vector mass =
                    plain ? fw_splat(p.plain_mass) : mass_of(&a, &p, here, part, particle);
                r = (fw_vector_pair){mass * (r.x - base.x), mass * (r.y - base.y)};
            }
            put(x + at, lanes, part, r.x);
            put(y + at, lanes, part, r.y);
        }
    }
}

static void positions(const lb_grid_arrays *arrays, const lb_particle_arrays *particles,
                      lb_stretch s, double *x, double *y)
{
    place_stretch(arrays, particles, s, false, (fw_vec2){0, 0}, x, y);
}

static void moments(const lb_grid_arrays *arrays, const lb_particle_arrays *particles, lb_stretch s,
                    fw_vec2 base, double *x, double *y)
{
    place_stretch(arrays, particles, s, true, base, x, y);
}

static bool within(const lb_grid_arrays *arrays, int begin, int end, double size)
{
    const lb_grid_arrays a = *arrays;
    const fw_vector most = fw_splat(size);
    fw_mask all = fw_everywhere();
    for (int place = begin; place < end; place += FW_BLOCK) {
        fetch_ahead(&a, place, 0);
        for (int at = place; at < place + FW_BLOCK; at += FW_WIDTH) {
            const fw_vector_pair ahead = fw_load_pair(a.ahead_x, a.ahead_y, at),
                                 behind = fw_load_pair(a.behind_x, a.behind_y, at);
            const fw_mask x = fw_and(fw_less(fw_size(ahead.x), most),
                                     fw_less(fw_size(behind.x), most)),
                          y = fw_and(fw_less(fw_size(ahead.y), most),
                                     fw_less(fw_size(behind.y), most));
            all = fw_and(all, fw_and(x, y));
        }
    }
    uint8_t bits = 0;
    for (int part = 0; part < FW_PARTS; ++part) bits |= fw_mask_bits(all, part);
    return bits == 0xff;
}

const lb_look_kernels FW_KERNELS_HERE(lb_looks) = {.terms = terms,
                                                   .motions = motions,
                                                   .positions = positions,
                                                   .moments = moments,
                                                   .within = within};
