/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_step.c - one step of the LB solid (Chopard & Marconi Eqs 18-20, corrected).
 * State: see lb_state.h. Work is cut into chunks of fixed size whose sums are added in order, so
 * that the result does not depend on the number of threads. Start reading at lb_advance(). */
#include "lb_step.h"

#include "lb_fracture.h"

#include <math.h>

/* What an inner loop has to do; constant where it is inlined, so each combination is a loop of its
 * own without branches. */
typedef struct kernel {
    bool resting, matrix, loaded, damped;
} kernel;

/* Where the four fields of particle `begin` of a full span lie. */
typedef struct stream {
    double *x[FW_DIRECTIONS], *y[FW_DIRECTIONS];
} stream;

static stream open_stream(const lb_solid *lb, const span *s)
{
    stream in;
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        int slot = lb->parity == 0 ? d : fw_opposite(d);
        int shift = lb->parity == 0 ? 0 : s->offset[d];
        in.x[d] = lb->slot_x[slot] + shift;
        in.y[d] = lb->slot_y[slot] + shift;
    }
    return in;
}

/* Particles begin..end of a full span with kappa = 1. */
static inline void relax_full(lb_solid *lb, const span *s, int begin, int end, kernel k,
                              fw_solid_ledger *ledger)
{
    stream in = open_stream(lb, s);
    double *restrict ex = in.x[FW_EAST], *restrict ey = in.y[FW_EAST];
    double *restrict nx = in.x[FW_NORTH], *restrict ny = in.y[FW_NORTH];
    double *restrict wx = in.x[FW_WEST], *restrict wy = in.y[FW_WEST];
    double *restrict sx = in.x[FW_SOUTH], *restrict sy = in.y[FW_SOUTH];
    double *restrict zx = lb->rest_x, *restrict zy = lb->rest_y;
    double *restrict rx = lb->head.x, *restrict ry = lb->head.y;
    const double *restrict fx = lb->head.external_x, *restrict fy = lb->head.external_y;
    const double *restrict ixx = lb->inverse.xx, *restrict ixy = lb->inverse.xy,
                           *restrict iyy = lb->inverse.yy;
    const double *restrict zxx = lb->rest_mass.xx, *restrict zxy = lb->rest_mass.xy,
                           *restrict zyy = lb->rest_mass.yy;
    const double *restrict mxx = lb->mass.xx, *restrict mxy = lb->mass.xy,
                           *restrict myy = lb->mass.yy;
    const double mu = lb->mu;
    const double loss = 2 * (1 / mu - 1);
    double work = 0, dissipated = 0, impulse_x = 0, impulse_y = 0, drag_x = 0, drag_y = 0;
#pragma omp simd reduction(+ : work, dissipated, impulse_x, impulse_y, drag_x, drag_y)
    for (int l = begin; l < end; ++l) {
        double px = (ex[l] + wx[l]) + (nx[l] + sx[l]);
        double py = (ey[l] + wy[l]) + (ny[l] + sy[l]);
        if (k.resting) {
            px += k.matrix ? zxx[l] * zx[l] + zxy[l] * zy[l] : zxx[l] * zx[l];
            py += k.matrix ? zxy[l] * zx[l] + zyy[l] * zy[l] : zxx[l] * zy[l];
        }
        if (k.loaded) {
            px += 0.5 * fx[l];
            py += 0.5 * fy[l];
        }
        double ux = k.matrix ? ixx[l] * px + ixy[l] * py : ixx[l] * px;
        double uy = k.matrix ? ixy[l] * px + iyy[l] * py : ixx[l] * py;
        if (k.matrix) { /* see refine() */
            double ax = zxx[l] * ux + zxy[l] * uy, ay = zxy[l] * ux + zyy[l] * uy;
            double qx = px - (0.5 * (zxx[l] * ax + zxy[l] * ay) + 2 * ux);
            double qy = py - (0.5 * (zxy[l] * ax + zyy[l] * ay) + 2 * uy);
            ux += ixx[l] * qx + ixy[l] * qy;
            uy += ixy[l] * qx + iyy[l] * qy;
        }
        ux *= mu;
        uy *= mu;
        ex[l] = ux - ex[l];
        ey[l] = uy - ey[l];
        nx[l] = ux - nx[l];
        ny[l] = uy - ny[l];
        wx[l] = ux - wx[l];
        wy[l] = uy - wy[l];
        sx[l] = ux - sx[l];
        sy[l] = uy - sy[l];
        if (k.resting) {
            zx[l] = (k.matrix ? zxx[l] * ux + zxy[l] * uy : zxx[l] * ux) - zx[l];
            zy[l] = (k.matrix ? zxy[l] * ux + zyy[l] * uy : zxx[l] * uy) - zy[l];
        }
        rx[l] += ux;
        ry[l] += uy;
        if (k.loaded) {
            work += fx[l] * ux + fy[l] * uy;
            impulse_x += fx[l];
            impulse_y += fy[l];
        }
        if (k.damped) {
            double qx = k.matrix ? mxx[l] * ux + mxy[l] * uy : mxx[l] * ux;
            double qy = k.matrix ? mxy[l] * ux + myy[l] * uy : mxx[l] * uy;
            dissipated += loss * (ux * qx + uy * qy);
            drag_x -= loss * qx;
            drag_y -= loss * qy;
        }
    }
    ledger->work += work;
    ledger->dissipated += dissipated;
    ledger->impulse = fw_vec2_add(ledger->impulse, (fw_vec2){impulse_x, impulse_y});
    ledger->drag = fw_vec2_add(ledger->drag, (fw_vec2){drag_x, drag_y});
}

/* One of eight loops for each of the two kinds of mass. */
static void relax_stretch(lb_solid *lb, const span *s, int begin, int end, fw_solid_ledger *ledger)
{
    const bool loaded = lb->head.loaded, damped = lb->mu < 1;
#define RELAX(R, M, L, D) relax_full(lb, s, begin, end, (kernel){R, M, L, D}, ledger)
    if (lb->matrix && lb->resting)
        loaded   ? damped ? RELAX(true, true, true, true) : RELAX(true, true, true, false)
          : damped ? RELAX(true, true, false, true)
                 : RELAX(true, true, false, false);
    else if (lb->resting)
        loaded   ? damped ? RELAX(true, false, true, true) : RELAX(true, false, true, false)
          : damped ? RELAX(true, false, false, true)
                 : RELAX(true, false, false, false);
    else
        loaded   ? damped ? RELAX(false, false, true, true) : RELAX(false, false, true, false)
          : damped ? RELAX(false, false, false, true)
                 : RELAX(false, false, false, false);
#undef RELAX
}

static fw_vec2 external_force(const lb_solid *lb, int l)
{
    if (!lb->head.loaded) return (fw_vec2){0, 0};
    return (fw_vec2){lb->head.external_x[l], lb->head.external_y[l]};
}

/* One step of iterative refinement of w = M^-1 push, with M w taken through M0 as the update takes
 * it: where M is a matrix, the rounding of M and M^-1 is the same in every step and would let the
 * energy creep by some 1e-16 each. */
static fw_vec2 refine(const lb_solid *lb, int l, fw_vec2 push, fw_vec2 w)
{
    fw_vec2 rest = {0, 0}, links = {0, 0};
    if (lb->resting) {
        fw_sym2 rest_mass = lb_get(&lb->rest_mass, l);
        rest = fw_sym2_apply(rest_mass, fw_sym2_apply(rest_mass, w));
    }
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        if (lb->present[l] & (1u << d))
            links = fw_vec2_add(links, fw_sym2_apply(lb_stiffness(lb, l, d), w));
    fw_vec2 left = fw_vec2_subtract(push, fw_vec2_scale(0.5, fw_vec2_add(rest, links)));
    return fw_vec2_add(w, fw_sym2_apply(lb_get(&lb->inverse, l), left));
}

static fw_vec2 free_displacement(const lb_solid *lb, int l)
{
    fw_vec2 push = fw_vec2_add(lb_psi(lb, l), fw_vec2_scale(0.5, external_force(lb, l)));
    fw_vec2 w = fw_sym2_apply(lb_get(&lb->inverse, l), push);
    if (lb->matrix) w = refine(lb, l, push, w);
    return fw_vec2_scale(lb->mu, w);
}

/* Any particle: edges, weighted links, and those whose displacement w contact has decided. */
static void relax_one(lb_solid *lb, int l, fw_vec2 w, fw_solid_ledger *ledger)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        slot_place slot = lb_slot(lb, l, d);
        *slot.x = w.x - *slot.x;
        *slot.y = w.y - *slot.y;
    }
    if (lb->resting) {
        fw_vec2 rest = fw_sym2_apply(lb_get(&lb->rest_mass, l), w);
        lb->rest_x[l] = rest.x - lb->rest_x[l];
        lb->rest_y[l] = rest.y - lb->rest_y[l];
    }
    lb->head.x[l] += w.x;
    lb->head.y[l] += w.y;
    if (lb->head.loaded) {
        fw_vec2 force = external_force(lb, l);
        ledger->work += fw_vec2_dot(force, w);
        ledger->impulse = fw_vec2_add(ledger->impulse, force);
    }
    if (lb->mu < 1) {
        /* dE = F.w - 2(1/mu - 1) w.Mw, dPsi = F - 2(1/mu - 1) Mw */
        double loss = 2 * (1 / lb->mu - 1);
        fw_vec2 push = fw_vec2_scale(loss, fw_sym2_apply(lb_get(&lb->mass, l), w));
        ledger->dissipated += fw_vec2_dot(push, w);
        ledger->drag = fw_vec2_subtract(ledger->drag, push);
    }
}

static void relax_span(lb_solid *lb, const span *s, int begin, int end, fw_solid_ledger *ledger)
{
    if (s->full)
        relax_stretch(lb, s, begin, end, ledger);
    else
        for (int l = begin; l < end; ++l) relax_one(lb, l, free_displacement(lb, l), ledger);
}

/* First constraint at or after a particle. */
static int find_constraint(const fw_constraint *constraints, int count, int particle)
{
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (constraints[middle].particle < particle)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void relax_chunk(lb_solid *lb, int chunk, const fw_constraint *constraints,
                        int constraint_count)
{
    fw_solid_ledger *ledger = &lb->chunk_ledger[chunk];
    *ledger = (fw_solid_ledger){0};
    int next = find_constraint(constraints, constraint_count, chunk * LB_CHUNK);
    for (int n = lb->chunk_span[chunk]; n < lb->chunk_span[chunk + 1]; ++n) {
        const span *s = &lb->spans[n];
        int begin = s->begin;
        for (; next < constraint_count && constraints[next].particle < s->end; ++next) {
            relax_span(lb, s, begin, constraints[next].particle, ledger);
            relax_one(lb, constraints[next].particle, constraints[next].displacement, ledger);
            begin = constraints[next].particle + 1;
        }
        relax_span(lb, s, begin, s->end, ledger);
    }
}

fw_status lb_advance(fw_solid *solid, const fw_constraint *constraints, int constraint_count,
                     fw_error *error)
{
    (void)error;
    lb_solid *lb = (lb_solid *)solid;
#pragma omp parallel for schedule(static) if (lb->chunk_count > 4)
    for (int chunk = 0; chunk < lb->chunk_count; ++chunk)
        relax_chunk(lb, chunk, constraints, constraint_count);
    for (int chunk = 0; chunk < lb->chunk_count; ++chunk)
        fw_solid_ledger_add(&solid->ledger, &lb->chunk_ledger[chunk]);
    lb->parity = !lb->parity;
    solid->ticks += 1;
    if (lb->break_at < HUGE_VAL) lb_break_links(lb);
    return FW_OK;
}

static fw_prediction predict_one(const lb_solid *lb, int l)
{
    fw_sym2 inverse = fw_sym2_scale(lb->mu, lb_get(&lb->inverse, l));
    /* The elastic part of Psi is half the pull of the links; what is left of it, kappa times the
     * mean of each link's two fields and the rest field, is the particle's own momentum. */
    fw_vec2 momentum = {0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        if (!(lb->present[l] & (1u << d))) continue;
        fw_vec2 mean =
            fw_vec2_scale(0.5, fw_vec2_add(lb_field(lb, l, d),
                                           lb_field(lb, lb->neighbour[d][l], fw_opposite(d))));
        momentum = fw_vec2_add(momentum, fw_sym2_apply(lb_stiffness(lb, l, d), mean));
    }
    if (lb->resting)
        momentum = fw_vec2_add(momentum, fw_sym2_apply(lb_get(&lb->rest_mass, l), lb_rest(lb, l)));
    return (fw_prediction){.displacement = free_displacement(lb, l),
                           .mobility = fw_sym2_scale(0.5, inverse),
                           .inertial = fw_sym2_apply(inverse, momentum)};
}

void lb_predict(const fw_solid *solid, const int *particles, int count, fw_prediction *out)
{
    const lb_solid *lb = (const lb_solid *)solid;
    for (int n = 0; n < count; ++n) out[n] = predict_one(lb, particles[n]);
}
