/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_automaton.c - what can be measured of elastic automata only. Keeps no state.
 *
 * The wave of a body is the first mode or wave among its displacements. Its amplitude is looked for
 * among black and among white cells apart: at half a step between their moves they are two waves.
 * Of a body without a wave the quantities of waves are not a number. */
#include "experiments/measures/quantity.h"

#include "experiments/setup/build_automaton.h"

#include <complex.h>
#include <math.h>

#define CA "elastic-automaton"

static const fw_solid *body_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_experiment_solid(experiment, subject.body);
}

static const fw_scenario_body *written_of(const fw_experiment *experiment, fw_subject subject)
{
    return &experiment->scenario->bodies[subject.body];
}

static const fw_scenario_automaton *material_of(const fw_experiment *experiment, fw_subject subject)
{
    return &experiment->scenario->materials[written_of(experiment, subject)->material].automaton;
}

static void largest_displacement(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = body_of(experiment, subject);
    out[0] = out[1] = 0;
    for (int p = 0; p < solid->count; ++p) {
        const fw_vec2 u = fw_elastic_automaton_displacement(solid, p);
        out[0] = fmax(out[0], fabs(u.x));
        out[1] = fmax(out[1], fabs(u.y));
    }
}

static void broken_bonds(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_elastic_automaton_broken(body_of(experiment, subject));
}

static void frozen_cells(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_elastic_automaton_frozen(body_of(experiment, subject));
}

/* --- the wave of a body --- */

typedef struct carried {
    bool exists;
    fw_vec2 wave;                      /* radians per site */
    double complex black[2], white[2]; /* at the start */
} carried;

static carried carried_by_pattern(const fw_experiment *experiment, fw_subject subject,
                                  const fw_pattern *pattern)
{
    carried c = {.exists = true, .wave = pattern->wave_vector};
    const double complex turn = cexp(I * pattern->phase);
    if (pattern->kind == FW_PATTERN_WAVE) {
        const double along[2] = {pattern->amplitude.x, pattern->amplitude.y};
        for (int axis = 0; axis < 2; ++axis) c.black[axis] = c.white[axis] = turn * along[axis];
        return c;
    }
    fw_automaton_mode mode;
    c.exists = fw_build_automaton_mode(material_of(experiment, subject),
                                       &written_of(experiment, subject)->lattice, c.wave,
                                       pattern->branch, &mode, NULL) == FW_OK;
    for (int axis = 0; axis < 2 && c.exists; ++axis) {
        c.black[axis] = pattern->size * turn * mode.black[axis];
        c.white[axis] = pattern->size * turn * mode.white[axis];
    }
    return c;
}

/* Where the wave and its opposite look the same on the cells of one colour, nothing sets them
 * apart: those with kx + ky and kx - ky multiples of pi. */
static bool is_ambiguous(fw_vec2 wave)
{
    return fabs(sin(wave.x + wave.y)) < 1e-9 && fabs(sin(wave.x - wave.y)) < 1e-9;
}

static carried carried_by(const fw_experiment *experiment, fw_subject subject)
{
    const fw_patterns *patterns = &written_of(experiment, subject)->displacement;
    for (int n = 0; n < patterns->count; ++n)
        if (patterns->item[n].kind == FW_PATTERN_MODE ||
            patterns->item[n].kind == FW_PATTERN_WAVE) {
            if (is_ambiguous(patterns->item[n].wave_vector)) break;
            return carried_by_pattern(experiment, subject, &patterns->item[n]);
        }
    return (carried){.exists = false};
}

/* Fourier amplitudes of the displacements, black and white, at the body's wave vector; at the
 * start, where `start` are its positions then. */
typedef struct amplitudes {
    double complex black[2], white[2];
} amplitudes;

static amplitudes amplitudes_of(const fw_experiment *experiment, fw_subject subject, fw_vec2 wave,
                                const fw_vec2 *start)
{
    const fw_solid *solid = body_of(experiment, subject);
    const fw_lattice *lattice = &written_of(experiment, subject)->lattice;
    const fw_sites *sites = &experiment->bodies[subject.body].sites;
    amplitudes sum = {{0, 0}, {0, 0}};
    for (int p = 0; p < sites->count; ++p) {
        const fw_site site = sites->site[p];
        const fw_vec2 u = start ? fw_vec2_subtract(start[p], fw_lattice_position(lattice, site))
                                : fw_elastic_automaton_displacement(solid, p);
        const double complex turn = cexp(-I * (wave.x * site.i + wave.y * site.j));
        double complex *part = fw_elastic_automaton_is_black(solid, p) ? sum.black : sum.white;
        part[0] += turn * u.x;
        part[1] += turn * u.y;
    }
    for (int axis = 0; axis < 2; ++axis) {
        sum.black[axis] *= 4.0 / sites->count;
        sum.white[axis] *= 4.0 / sites->count;
    }
    return sum;
}

/* How much of the wave at the start the body still carries: 1 then. */
static double complex part_of_start(const carried *c, const amplitudes *a)
{
    double complex sum = 0;
    double whole = 0;
    for (int axis = 0; axis < 2; ++axis) {
        sum += conj(c->black[axis]) * a->black[axis] + conj(c->white[axis]) * a->white[axis];
        whole += creal(conj(c->black[axis]) * c->black[axis]) +
                 creal(conj(c->white[axis]) * c->white[axis]);
    }
    return sum / whole;
}

static void wave_turn(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const carried c = carried_by(experiment, subject);
    out[0] = NAN;
    if (!c.exists) return;
    const amplitudes now = amplitudes_of(experiment, subject, c.wave, NULL);
    out[0] = carg(part_of_start(&c, &now));
}

static void wave_path(const fw_experiment *experiment, fw_subject subject, double *out)
{
    wave_turn(experiment, subject, out);
    const fw_vec2 wave = carried_by(experiment, subject).wave;
    out[0] *= written_of(experiment, subject)->lattice.spacing / hypot(wave.x, wave.y);
}

static void wave_size(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const carried c = carried_by(experiment, subject);
    out[0] = NAN;
    if (!c.exists) return;
    const amplitudes now = amplitudes_of(experiment, subject, c.wave, NULL);
    out[0] = cabs(part_of_start(&c, &now));
}

/* Wave action, Im (H w)^+ b with H = sum B_i exp(i k.Delta_i): both half-steps multiply it by
 * exactly -a and thus a step by a^2, whatever the shape of the wave. */
static double action_of(const fw_automaton_matrices *matrices, fw_vec2 wave, const amplitudes *a)
{
    const double complex phase[FW_DIRECTIONS] = {cexp(I * wave.x), cexp(I * wave.y),
                                                 cexp(-I * wave.x), cexp(-I * wave.y)};
    double complex x = 0, y = 0;
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const fw_sym2 b = matrices->bond[d];
        x += phase[d] * (b.xx * a->white[0] + b.xy * a->white[1]);
        y += phase[d] * (b.xy * a->white[0] + b.yy * a->white[1]);
    }
    return cimag(conj(x) * a->black[0] + conj(y) * a->black[1]);
}

static void wave_damping(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const carried c = carried_by(experiment, subject);
    const double steps = (double)fw_scene_steps(experiment->scene);
    fw_automaton_matrices matrices;
    out[0] = NAN;
    if (!c.exists ||
        fw_automaton_matrices_make(&matrices, material_of(experiment, subject)->speeds,
                                   written_of(experiment, subject)->lattice.angle, NULL) != FW_OK)
        return;
    out[0] = 1;
    if (steps == 0) return;
    const amplitudes now = amplitudes_of(experiment, subject, c.wave, NULL);
    const amplitudes start =
        amplitudes_of(experiment, subject, c.wave, experiment->start[subject.body]);
    out[0] =
        pow(action_of(&matrices, c.wave, &now) / action_of(&matrices, c.wave, &start), 0.5 / steps);
}

/* Adds what a mode does in closed form to the expected displacements' difference at one cell. */
static void subtract_mode(const carried *c, double frequency, double time, fw_site site, bool black,
                          fw_vec2 *difference)
{
    const double complex *a = black ? c->black : c->white;
    const double complex turn =
        cexp(I * (c->wave.x * site.i + c->wave.y * site.j + frequency * time));
    difference->x -= creal(a[0] * turn);
    difference->y -= creal(a[1] * turn);
}

static void mode_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    enum { MODES_MAX = 16 };
    const fw_solid *solid = body_of(experiment, subject);
    const fw_patterns *patterns = &written_of(experiment, subject)->displacement;
    const fw_sites *sites = &experiment->bodies[subject.body].sites;
    carried modes[MODES_MAX];
    double frequency[MODES_MAX];
    out[0] = NAN;
    if (patterns->count == 0 || patterns->count > MODES_MAX) return;
    for (int n = 0; n < patterns->count; ++n) {
        const fw_pattern *pattern = &patterns->item[n];
        if (pattern->kind != FW_PATTERN_MODE) return;
        double squared[FW_MODES];
        modes[n] = carried_by_pattern(experiment, subject, pattern);
        if (!modes[n].exists) return;
        fw_automaton_closed_form(material_of(experiment, subject)->speeds, pattern->wave_vector,
                                 squared);
        frequency[n] = 2 * asin(fmin(1, sqrt(fmax(0, squared[pattern->branch])) / 2));
    }
    out[0] = 0;
    for (int p = 0; p < sites->count; ++p) {
        fw_vec2 difference = fw_elastic_automaton_displacement(solid, p);
        for (int n = 0; n < patterns->count; ++n)
            subtract_mode(&modes[n], frequency[n], fw_scene_time(experiment->scene), sites->site[p],
                          fw_elastic_automaton_is_black(solid, p), &difference);
        out[0] = fmax(out[0], fmax(fabs(difference.x), fabs(difference.y)));
    }
}

/* --- analyses --- */

static void growth_inside(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->map.excess;
}

static void growth_outside(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->map.least;
}

static void largest_growth(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->map.greatest;
}

static void growth_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->map.error;
}

static void frequency_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->frequency_error;
}

static void phase_speed(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    for (int m = 0; m < FW_MODES; ++m) out[m] = subject.analysis->mode.speed[m];
}

static void put_polarisation(fw_subject subject, int mode, double *out)
{
    fw_quantity_put(out, subject.analysis->mode.polarisation[mode]);
}

static void slow_polarisation(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    put_polarisation(subject, FW_SLOW, out);
}

static void fast_polarisation(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    put_polarisation(subject, FW_FAST, out);
}

static void spectral_radius(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->spectral_radius;
}

static void reference_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    (void)experiment;
    out[0] = subject.analysis->reference_error;
}

/* clang-format off */
const fw_quantity fw_automaton_quantities[] = {
    {"largest-displacement", FW_SCOPE_BODY, "x y", "length", "of any cell from its place in the lattice, in size", CA, largest_displacement, NULL, FW_NEEDS_NOTHING},
    {"broken-bonds", FW_SCOPE_BODY, "", "1", "bonds broken since the start", CA, broken_bonds, NULL, FW_NEEDS_NOTHING},
    {"frozen-cells", FW_SCOPE_BODY, "", "1", "cells that have lost their last bond, and with it mass and velocity", CA, frozen_cells, NULL, FW_NEEDS_NOTHING},
    {"wave-turn", FW_SCOPE_BODY, "", "radians", "phase by which the body's first wave or mode has turned, between -pi and pi", CA, wave_turn, "the body started without a wave, or its wave cannot be distinguished from its opposite", FW_NEEDS_NOTHING},
    {"wave-path", FW_SCOPE_BODY, "", "length", "the same as a path of its crests, against the wave vector", CA, wave_path, "the body started without a wave, or its wave cannot be distinguished from its opposite", FW_NEEDS_NOTHING},
    {"wave-size", FW_SCOPE_BODY, "", "1", "how much of the body's first wave or mode is left", CA, wave_size, "the body started without a wave, or its wave cannot be distinguished from its opposite", FW_NEEDS_NOTHING},
    {"wave-damping", FW_SCOPE_BODY, "", "1", "factor by which the body's first wave or mode shrank per step, from its wave action: |lambda| exactly", CA, wave_damping, "the body started without a wave, or its wave cannot be distinguished from its opposite", FW_NEEDS_NOTHING},
    {"mode-error", FW_SCOPE_BODY, "", "length", "largest distance of a cell from where the modes that the body started with would have it (Dong Eq 40), in x or y", CA, mode_error, "the body did not start with modes alone", FW_NEEDS_NOTHING},
    {"growth-inside", FW_SCOPE_ANALYSIS, "", "1", "largest singular value of H(k) inside the disc c1^2 + c2^2 <= 2, minus 2: above 0 a wave grows", "stability-map", growth_inside, NULL, FW_NEEDS_NOTHING},
    {"growth-outside", FW_SCOPE_ANALYSIS, "", "1", "smallest growth per step outside the disc", "stability-map", growth_outside, NULL, FW_NEEDS_NOTHING},
    {"largest-growth", FW_SCOPE_ANALYSIS, "", "1", "largest growth per step of the map", "stability-map", largest_growth, NULL, FW_NEEDS_NOTHING},
    {"growth-error", FW_SCOPE_ANALYSIS, "", "1", "outside the disc: growth minus ((h + (h^2 - 4)^(1/2))/2)^2, h^2 = 2 (c1^2 + c2^2), in size", "stability-map", growth_error, NULL, FW_NEEDS_NOTHING},
    {"frequency-error", FW_SCOPE_ANALYSIS, "", "radians/step", "simulated minus closed form, in size", "dispersion", frequency_error, NULL, FW_NEEDS_NOTHING},
    {"phase-speed", FW_SCOPE_ANALYSIS, "slow fast", "spacings/step", "omega/k of both modes", "plane-mode", phase_speed, NULL, FW_NEEDS_NOTHING},
    {"slow-polarisation", FW_SCOPE_ANALYSIS, "x y", "1", "direction in which white cells move in the slow mode", "plane-mode", slow_polarisation, NULL, FW_NEEDS_NOTHING},
    {"fast-polarisation", FW_SCOPE_ANALYSIS, "x y", "1", "direction in which white cells move in the fast mode", "plane-mode", fast_polarisation, NULL, FW_NEEDS_NOTHING},
    {"spectral-radius", FW_SCOPE_ANALYSIS, "", "1", "growth per step by the body's own update; 1 shows as up to 1 + 1e-6", "body-stability", spectral_radius, NULL, FW_NEEDS_NOTHING},
    {"reference-error", FW_SCOPE_ANALYSIS, "", "length", "largest distance of a cell from its lattice Boltzmann reference, in x or y", "boltzmann-reference", reference_error, NULL, FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
