/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_measure.c - quantities of an LB solid: fields, deformations, strain, residual; and reversal.
 * Only fw_lb_solid_reverse changes the state, which is that of lb_layout.h. */
#include "lb_measure.h"

#include <math.h>

static const lb_solid *of(const fw_solid *solid)
{
    return (const lb_solid *)solid;
}

fw_vec2 fw_lb_solid_psi(const fw_solid *solid, int particle)
{
    return lb_psi(of(solid), particle);
}

fw_sym2 fw_lb_solid_mass(const fw_solid *solid, int particle)
{
    return lb_mass_of(of(solid), particle);
}

int fw_lb_solid_neighbour(const fw_solid *solid, int particle, int direction)
{
    const lb_solid *lb = of(solid);
    return lb->present[particle] & (1u << direction) ? lb_neighbour(lb, particle, direction) : -1;
}

fw_vec2 fw_lb_solid_deformation(const fw_solid *solid, int particle, int direction)
{
    int beside = fw_lb_solid_neighbour(solid, particle, direction);
    if (beside < 0) return (fw_vec2){0, 0};
    return fw_vec2_subtract(lb_field(of(solid), particle, direction),
                            lb_field(of(solid), beside, fw_opposite(direction)));
}

/* Mean deformation over the links along one axis, counted in that axis' positive direction. */
static fw_vec2 mean_along(const fw_solid *solid, int particle, int forward)
{
    int backward = fw_opposite(forward), count = 0;
    fw_vec2 sum = {0, 0};
    if (fw_lb_solid_neighbour(solid, particle, forward) >= 0) {
        sum = fw_lb_solid_deformation(solid, particle, forward);
        count += 1;
    }
    if (fw_lb_solid_neighbour(solid, particle, backward) >= 0) {
        sum = fw_vec2_subtract(sum, fw_lb_solid_deformation(solid, particle, backward));
        count += 1;
    }
    return count == 2 ? fw_vec2_scale(0.5, sum) : sum;
}

/* The paper's strain e_{i alpha} (Section 9.2) at a particle, as a mean over its links along i = x
 * (east and west) and i = y (north and south), in length per link. */
typedef struct lb_strain {
    fw_vec2 x, y; /* x.y is e_{xy}: shift in y from link to link along x */
} lb_strain;

static lb_strain strain_of(const fw_solid *solid, int particle)
{
    return (lb_strain){mean_along(solid, particle, FW_EAST), mean_along(solid, particle, FW_NORTH)};
}

double fw_lb_solid_energy(const fw_solid *solid, int particle)
{
    const lb_solid *lb = of(solid);
    fw_vec2 rest = lb_rest(lb, particle);
    double sum = fw_vec2_dot(rest, rest);
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[particle] & (1u << d))) continue;
        fw_vec2 field = lb_field(lb, particle, d);
        sum += fw_sym2_form(field, lb_stiffness(lb, particle, d), field);
    }
    return sum;
}

static double larger(double a, fw_vec2 v)
{
    return fmax(a, fmax(fabs(v.x), fabs(v.y)));
}

double fw_lb_solid_link_error(const fw_solid *solid)
{
    const lb_solid *lb = of(solid);
    double worst = 0;
    for (int l = 0; l < solid->count; ++l)
        for (int d = FW_EAST; d <= FW_NORTH; ++d) {
            int m = fw_lb_solid_neighbour(solid, l, d);
            if (m < 0) continue;
            fw_vec2 apart =
                fw_vec2_subtract(fw_solid_position(solid, m), fw_solid_position(solid, l));
            fw_vec2 rest = fw_vec2_subtract(apart, fw_lb_solid_deformation(solid, l, d));
            worst = larger(worst, fw_vec2_subtract(rest, lb->step[d]));
        }
    return worst;
}

double fw_lb_solid_rest_residual(const fw_solid *solid)
{
    const lb_solid *lb = of(solid);
    double worst = 0;
    for (int l = 0; l < solid->count; ++l) {
        fw_vec2 load = {solid->external_x[l], solid->external_y[l]};
        worst = larger(worst, fw_vec2_add(lb_psi(lb, l), fw_vec2_scale(0.5, load)));
        worst = larger(worst, lb_rest(lb, l));
        for (int d = FW_EAST; d <= FW_NORTH; ++d) {
            int m = fw_lb_solid_neighbour(solid, l, d);
            if (m >= 0)
                worst =
                    larger(worst, fw_vec2_add(lb_field(lb, l, d), lb_field(lb, m, fw_opposite(d))));
        }
    }
    return worst;
}

/* The state whose next step undoes the last one has the two fields of every link exchanged and
 * all fields negated; exchanging them is what a change of parity means. In displacement form that
 * exchanges x(t) and x(t-1), which is all: V changes its sign, u does not. */
void fw_lb_solid_reverse(fw_solid *solid)
{
    lb_solid *lb = (lb_solid *)solid;
    lb->parity = !lb->parity;
    lb->sums->known = false;
    for (int l = 0; l < solid->count && !lb->displaced; ++l) {
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            lb->slot_x[d][l] = -lb->slot_x[d][l];
            lb->slot_y[d][l] = -lb->slot_y[d][l];
        }
        if (lb->resting) {
            lb->rest_x[l] = -lb->rest_x[l];
            lb->rest_y[l] = -lb->rest_y[l];
        }
    }
}

fw_lb_form fw_lb_solid_form(const fw_solid *solid)
{
    return of(solid)->displaced ? FW_LB_DISPLACEMENTS : FW_LB_POPULATIONS;
}

int fw_lb_solid_broken(const fw_solid *solid)
{
    return of(solid)->broken;
}

/* Fields for pictures and files. */

static void fill_speed(const fw_solid *solid, double *values)
{
    const lb_solid *lb = of(solid);
    for (int l = 0; l < solid->count; ++l) {
        fw_vec2 v = fw_sym2_apply(lb_inverse_of(lb, l), lb_psi(lb, l));
        values[l] = sqrt(fw_vec2_dot(v, v));
    }
}

static void fill_energy(const fw_solid *solid, double *values)
{
    for (int l = 0; l < solid->count; ++l) values[l] = fw_lb_solid_energy(solid, l);
}

static void fill_strain_xx(const fw_solid *solid, double *values)
{
    for (int l = 0; l < solid->count; ++l) values[l] = strain_of(solid, l).x.x;
}

static void fill_strain_yy(const fw_solid *solid, double *values)
{
    for (int l = 0; l < solid->count; ++l) values[l] = strain_of(solid, l).y.y;
}

static void fill_strain_xy(const fw_solid *solid, double *values)
{
    for (int l = 0; l < solid->count; ++l) {
        lb_strain e = strain_of(solid, l);
        values[l] = 0.5 * (e.x.y + e.y.x);
    }
}

static void fill_links(const fw_solid *solid, double *values)
{
    for (int l = 0; l < solid->count; ++l) {
        values[l] = 0;
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            values[l] += fw_lb_solid_neighbour(solid, l, d) >= 0;
    }
}

const fw_field lb_fields[] = {
    {"speed", "length/time", "|M^-1 Psi|, length per step", fill_speed},
    {"energy", "energy", "sum of f^2 of a particle (Eq 11)", fill_energy},
    {"strain-xx", "1", "stretch of the links along x, length per link", fill_strain_xx},
    {"strain-yy", "1", "stretch of the links along y, length per link", fill_strain_yy},
    {"strain-xy", "1", "half the sum of both shears, length per link", fill_strain_xy},
    {"links", "1", "number of links", fill_links},
    {NULL, NULL, NULL, NULL},
};
