/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_measure.c - quantities of an elastic automaton: what bonds hold, masses,
 * velocities, fields for pictures. Keeps no state; sums run in fixed blocks.
 * Start reading at fw_automaton_bond_energy(). */
#include "automaton_body.h"

#include <math.h>

enum { BLOCK = 1024 };

double fw_automaton_bond_energy(const fw_automaton *body, int colour, int cell)
{
    const fw_vec2 self = fw_automaton_at(&body->colour[colour], cell);
    double energy = 0;
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        double weight;
        const int partner = fw_automaton_cell_neighbour(body, colour, cell, d, &weight);
        if (partner < 0) continue;
        const fw_vec2 stretch =
            fw_vec2_subtract(fw_automaton_at(&body->colour[!colour], partner), self);
        energy += weight * fw_sym2_form(stretch, *body->colour[colour].matrix[d], stretch);
    }
    return energy / 2;
}

fw_vec2 fw_automaton_bond_momentum(const fw_automaton *body, int colour, int cell)
{
    const fw_vec2 self = fw_automaton_at(&body->colour[colour], cell);
    fw_vec2 sum = {0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        double weight;
        const int partner = fw_automaton_cell_neighbour(body, colour, cell, d, &weight);
        if (partner < 0) continue;
        const fw_vec2 stretch =
            fw_vec2_subtract(fw_automaton_at(&body->colour[!colour], partner), self);
        sum = fw_vec2_add(
            sum, fw_vec2_scale(weight, fw_sym2_apply(*body->colour[colour].matrix[d], stretch)));
    }
    return (fw_vec2){sum.x / 2, sum.y / 2};
}

/* Each end of a bond has half of its momentum. */
double fw_automaton_angular_momentum(const fw_solid *solid, int first, int count)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    double sum = 0;
    for (int p = first; p < first + count; ++p) {
        const int colour = body->white[p];
        const fw_vec2 whole = fw_automaton_bond_momentum(body, colour, body->cell[p]);
        const double half = colour == fw_automaton_moving(body) ? 0.5 : -0.5;
        sum += half * fw_vec2_cross(fw_solid_position(solid, p), whole);
    }
    return sum;
}

/* sum m/4, block by block. */
static fw_sym2 summed_mass(const fw_automaton *body)
{
    fw_sym2 sum = {0, 0, 0};
    for (int c = 0; c < FW_COLOURS; ++c) {
        const int count = body->colour[c].count;
        fw_sym2 total = {0, 0, 0};
        for (int begin = 0; begin < count; begin += BLOCK) {
            const int end = begin + BLOCK < count ? begin + BLOCK : count;
            fw_sym2 block = {0, 0, 0};
            for (int n = begin; n < end; ++n)
                block = fw_sym2_add(block, fw_automaton_cell_mass(body, c, n));
            total = fw_sym2_add(total, block);
        }
        sum = fw_sym2_add(sum, total);
    }
    return fw_sym2_scale(0.25, sum);
}

/* Only breaking changes it. */
fw_sym2 fw_automaton_mass(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    fw_automaton_sums *sums = body->sums;
    if (body->breaks) return summed_mass(body);
    if (!sums->mass_known) sums->mass = summed_mass(body);
    sums->mass_known = true;
    return sums->mass;
}

/* m (r - reference) / 4, reference being the first particle: sums of small numbers. */
static fw_vec2 mass_moment(const fw_automaton *body, int c, int cell)
{
    const fw_automaton_colour *colour = &body->colour[c];
    const int place = colour->place[cell];
    fw_vec2 r = fw_vec2_subtract(fw_solid_position(&body->head, colour->particle[cell]),
                                 fw_solid_position(&body->head, 0));
    if (place >= 0) r = fw_sym2_apply(colour->rim[place].mass, r);
    return fw_vec2_scale(0.25, r);
}

fw_vec2 fw_automaton_centre_of_mass(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    fw_vec2 moment = {0, 0};
    for (int c = 0; c < FW_COLOURS; ++c) {
        const int count = body->colour[c].count;
        fw_vec2 total = {0, 0};
        for (int begin = 0; begin < count; begin += BLOCK) {
            const int end = begin + BLOCK < count ? begin + BLOCK : count;
            fw_vec2 block = {0, 0};
            for (int n = begin; n < end; ++n) block = fw_vec2_add(block, mass_moment(body, c, n));
            total = fw_vec2_add(total, block);
        }
        moment = fw_vec2_add(moment, total);
    }
    return fw_vec2_add(fw_solid_position(solid, 0),
                       fw_sym2_apply(fw_sym2_invert(fw_automaton_mass(solid)), moment));
}

/* The colour that moved last: how far it moved; the other: how far it is about to move, at a = 1:
 * +-m^-1 (s + F) with s = sum B (neighbour - self) and the load F. So a loaded body that rests has
 * velocity zero; without a load, weighted with m/4, they add up to the momentum exactly. */
static fw_vec2 velocity_of(const fw_automaton *body, int colour, int cell)
{
    const fw_solid *head = &body->head;
    const int particle = body->colour[colour].particle[cell];
    fw_vec2 s = fw_automaton_cell_pull(body, colour, cell);
    if (head->loaded)
        s = fw_vec2_add(s, (fw_vec2){head->external_x[particle], head->external_y[particle]});
    const double sign = colour == fw_automaton_moving(body) ? 1 : -1;
    return fw_vec2_scale(sign,
                         fw_sym2_apply(fw_automaton_cell_inverse_mass(body, colour, cell), s));
}

/* The same of cells of a span from `begin` on, when no load acts: to the last bit, sooner. */
static void velocities_of_span(const fw_automaton *body, int c, const fw_automaton_span *span,
                               int begin, int count, double *restrict x, double *restrict y)
{
    const fw_automaton_colour *own = &body->colour[c], *other = &body->colour[!c];
    const double sign = c == fw_automaton_moving(body) ? 1 : -1;
    const fw_sym2 one = fw_sym2_scalar(1), east = *own->matrix[FW_EAST],
                  north = *own->matrix[FW_NORTH], west = *own->matrix[FW_WEST],
                  south = *own->matrix[FW_SOUTH];
    const int *offset = span->offset, first = own->particle[begin];
    for (int k = 0; k < count; ++k) {
        const int n = begin + k;
        const fw_vec2 self = fw_automaton_at(own, n);
        const fw_vec2 to_east = fw_vec2_subtract(fw_automaton_at(other, n + offset[FW_EAST]), self);
        const fw_vec2 to_north =
            fw_vec2_subtract(fw_automaton_at(other, n + offset[FW_NORTH]), self);
        const fw_vec2 to_west = fw_vec2_subtract(fw_automaton_at(other, n + offset[FW_WEST]), self);
        const fw_vec2 to_south =
            fw_vec2_subtract(fw_automaton_at(other, n + offset[FW_SOUTH]), self);
        const fw_vec2 s =
            fw_vec2_add(fw_vec2_add(fw_sym2_apply(east, to_east), fw_sym2_apply(north, to_north)),
                        fw_vec2_add(fw_sym2_apply(west, to_west), fw_sym2_apply(south, to_south)));
        const fw_vec2 v = fw_vec2_scale(sign, fw_sym2_apply(one, s));
        x[first + 2 * k] = v.x;
        y[first + 2 * k] = v.y;
    }
}

void fw_automaton_velocities(const fw_solid *solid, double *x, double *y)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    for (int c = 0; c < FW_COLOURS; ++c) {
        const fw_automaton_colour *colour = &body->colour[c];
        for (int n = 0, count; n < colour->count; n += count) {
            const int place = colour->place[n];
            count = 1;
            if (place < 0 && !solid->loaded) {
                while (n + count < colour->count && colour->place[n + count] == place) ++count;
                velocities_of_span(body, c, &colour->span[~place], n, count, x, y);
                continue;
            }
            const fw_vec2 v = velocity_of(body, c, n);
            x[colour->particle[n]] = v.x;
            y[colour->particle[n]] = v.y;
        }
    }
}

void fw_automaton_masses(const fw_solid *solid, double *values)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    for (int p = 0; p < solid->count; ++p) {
        const fw_sym2 m = fw_automaton_cell_mass(body, body->white[p], body->cell[p]);
        values[p] = (m.xx + m.yy) / 8;
    }
}

static void fill_displacement_x(const fw_solid *solid, double *values)
{
    for (int p = 0; p < solid->count; ++p)
        values[p] = fw_elastic_automaton_displacement(solid, p).x;
}

static void fill_displacement_y(const fw_solid *solid, double *values)
{
    for (int p = 0; p < solid->count; ++p)
        values[p] = fw_elastic_automaton_displacement(solid, p).y;
}

static void fill_speed(const fw_solid *solid, double *values)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    for (int p = 0; p < solid->count; ++p) {
        const fw_vec2 v = velocity_of(body, body->white[p], body->cell[p]);
        values[p] = hypot(v.x, v.y);
    }
}

static void fill_energy(const fw_solid *solid, double *values)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    for (int p = 0; p < solid->count; ++p)
        values[p] = fw_automaton_bond_energy(body, body->white[p], body->cell[p]) / 2;
}

static void fill_colour(const fw_solid *solid, double *values)
{
    for (int p = 0; p < solid->count; ++p) values[p] = fw_automaton_of_const(solid)->white[p];
}

const fw_field fw_automaton_fields[] = {
    {"displacement-x", "length", "displacement from the lattice site along x", fill_displacement_x},
    {"displacement-y", "length", "displacement from the lattice site along y", fill_displacement_y},
    {"speed", "length/time", "speed of the cell", fill_speed},
    {"energy", "energy", "half of the energy of the cell's bonds", fill_energy},
    {"colour", "1", "0 for black cells, which move first, 1 for white ones", fill_colour},
    {NULL, NULL, NULL, NULL},
};
