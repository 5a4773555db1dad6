/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_measure.c - quantities of an elastic automaton: energy, momentum, masses,
 * velocities, fields for pictures. Keeps no state; sums run in fixed blocks.
 * Start reading at fw_automaton_energies(). */
#include "automaton_body.h"

#include <math.h>

enum { BLOCK = 1024 };

/* Adds up what `value` gives for each cell of a colour, block by block. */
typedef struct totals {
    double value[4];
} totals;

static totals sum_over(const fw_automaton *body, int colour,
                       totals (*value)(const fw_automaton *body, int colour, int cell))
{
    const int count = body->colour[colour].count;
    totals total = {{0}};
    for (int begin = 0; begin < count; begin += BLOCK) {
        const int end = begin + BLOCK < count ? begin + BLOCK : count;
        totals block = {{0}};
        for (int n = begin; n < end; ++n) {
            const totals here = value(body, colour, n);
            for (int k = 0; k < 4; ++k) block.value[k] += here.value[k];
        }
        for (int k = 0; k < 4; ++k) total.value[k] += block.value[k];
    }
    return total;
}

/* Half of 1/2 (w - b).B (w - b) over the bonds of a cell; kinetic part: of the two colours the one
 * that moved last is displaced from where its neighbours would have it at rest, by -m^-1 s/2 with
 * s = sum B (w - b): (m^-1 s/2).m (m^-1 s/2). What remains of E is the energy of the other colour
 * alone, the first one relaxed: elastic. */
static totals bond_energy(const fw_automaton *body, int colour, int cell)
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
    return (totals){{energy / 2}};
}

static totals kinetic_energy(const fw_automaton *body, int colour, int cell)
{
    const fw_vec2 pull = fw_automaton_cell_pull(body, colour, cell);
    return (totals){
        {fw_sym2_form(pull, fw_automaton_cell_inverse_mass(body, colour, cell), pull) / 4}};
}

fw_energies fw_automaton_energies(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const double total = sum_over(body, FW_BLACK, bond_energy).value[0];
    const int moved = !fw_automaton_moving(body);
    const double kinetic = sum_over(body, moved, kinetic_energy).value[0];
    return (fw_energies){.kinetic = kinetic, .elastic = total - kinetic};
}

/* 1/2 sum B (w - b) over the bonds of a black cell, 1/2 sum B (b - w) over those of a white one. */
static totals bond_momentum(const fw_automaton *body, int colour, int cell)
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
    return (totals){{sum.x / 2, sum.y / 2}};
}

fw_vec2 fw_automaton_momentum(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    const totals sum = sum_over(body, FW_BLACK, bond_momentum);
    const double sign = fw_automaton_moving(body) == FW_BLACK ? 1 : -1;
    return (fw_vec2){sign * sum.value[0], sign * sum.value[1]};
}

/* Each end of a bond has half of its momentum. */
double fw_automaton_angular_momentum(const fw_solid *solid, int first, int count)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    double sum = 0;
    for (int p = first; p < first + count; ++p) {
        const int colour = body->white[p];
        const totals whole = bond_momentum(body, colour, body->cell[p]);
        const double half = colour == fw_automaton_moving(body) ? 0.5 : -0.5;
        sum += half * fw_vec2_cross(fw_solid_position(solid, p),
                                    (fw_vec2){whole.value[0], whole.value[1]});
    }
    return sum;
}

static totals cell_mass(const fw_automaton *body, int colour, int cell)
{
    const fw_sym2 m = fw_automaton_cell_mass(body, colour, cell);
    return (totals){{m.xx, m.xy, m.yy}};
}

fw_sym2 fw_automaton_mass(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    fw_sym2 sum = {0, 0, 0};
    for (int c = 0; c < FW_COLOURS; ++c) {
        const totals m = sum_over(body, c, cell_mass);
        sum = fw_sym2_add(sum, (fw_sym2){m.value[0], m.value[1], m.value[2]});
    }
    return fw_sym2_scale(0.25, sum);
}

/* m (r - reference) / 4, reference being the first particle: sums of small numbers. */
static totals mass_moment(const fw_automaton *body, int colour, int cell)
{
    const int particle = body->colour[colour].particle[cell];
    const fw_vec2 r = fw_vec2_subtract(fw_solid_position(&body->head, particle),
                                       fw_solid_position(&body->head, 0));
    const fw_vec2 moment =
        fw_vec2_scale(0.25, fw_sym2_apply(fw_automaton_cell_mass(body, colour, cell), r));
    return (totals){{moment.x, moment.y}};
}

fw_vec2 fw_automaton_centre_of_mass(const fw_solid *solid)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    fw_vec2 moment = {0, 0};
    for (int c = 0; c < FW_COLOURS; ++c) {
        const totals sum = sum_over(body, c, mass_moment);
        moment = fw_vec2_add(moment, (fw_vec2){sum.value[0], sum.value[1]});
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

void fw_automaton_velocities(const fw_solid *solid, double *x, double *y)
{
    const fw_automaton *body = fw_automaton_of_const(solid);
    for (int c = 0; c < FW_COLOURS; ++c)
        for (int n = 0; n < body->colour[c].count; ++n) {
            const fw_vec2 v = velocity_of(body, c, n);
            x[body->colour[c].particle[n]] = v.x;
            y[body->colour[c].particle[n]] = v.y;
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
        values[p] = bond_energy(body, body->white[p], body->cell[p]).value[0] / 2;
}

static void fill_colour(const fw_solid *solid, double *values)
{
    for (int p = 0; p < solid->count; ++p) values[p] = fw_automaton_of_const(solid)->white[p];
}

const fw_field fw_automaton_fields[] = {
    {"displacement-x", "displacement from the lattice site along x", fill_displacement_x},
    {"displacement-y", "displacement from the lattice site along y", fill_displacement_y},
    {"speed", "speed of the cell", fill_speed},
    {"energy", "half of the energy of the cell's bonds", fill_energy},
    {"colour", "0 for black cells, which move first, 1 for white ones", fill_colour},
    {NULL, NULL, NULL},
};
