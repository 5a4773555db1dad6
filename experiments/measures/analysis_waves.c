/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analysis_waves.c - plane waves of the elastic automaton: where they grow, how fast they run,
 * and whether those of a simulated body do what the closed form says. Keeps no state. Start
 * reading at fw_analysis_map(). */
#include "analysis_parts.h"

#include "core/array.h"
#include "experiments/setup/build_automaton.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>

/* --- the map over c1 and c2 --- */

static double along(const double range[2], int points, int n)
{
    return points > 1 ? range[0] + (range[1] - range[0]) * n / (points - 1) : range[0];
}

static void judge_point(fw_analysis *analysis, fw_automaton_speeds speeds, double largest,
                        double factor)
{
    const double square = speeds.transverse * speeds.transverse + speeds.coupling * speeds.coupling;
    analysis->map.greatest = fmax(analysis->map.greatest, factor);
    if (fw_automaton_speeds_check(speeds, NULL) == FW_OK) {
        analysis->map.excess = fmax(analysis->map.excess, largest - 2);
        return;
    }
    /* 4 sin^2(omega/2) of the wave (pi/2, pi/2) is 2 (c1^2 + c2^2). */
    const double h = sqrt(2 * square), root = (h + sqrt(h * h - 4)) / 2;
    analysis->map.least = fmin(analysis->map.least, factor);
    analysis->map.error = fmax(analysis->map.error, fabs(factor - root * root));
}

fw_status fw_analysis_map(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error)
{
    (void)scenario;
    const fw_scenario_analysis *what = analysis->what;
    const int columns = what->points[0], rows = what->points[1];
    double *c1 = fw_analysis_add(analysis, "c1", "spacings/step", "speed of transverse waves",
                                 columns, 0, error);
    double *c2 =
        fw_analysis_add(analysis, "c2", "spacings/step", "coupling of x and y", rows, 0, error);
    double *factors = fw_analysis_add(analysis, "growth", "1",
                                      "growth per step of the worst plane wave, by c2 and c1", rows,
                                      columns, error);
    double *largest = fw_analysis_add(
        analysis, "singular-value", "1",
        "largest singular value h of H(k), at most 2 where no wave grows, by c2 and c1", rows,
        columns, error);
    if (!c1 || !c2 || !factors || !largest) return FW_SYSTEM_FAILED;
    for (int n = 0; n < columns; ++n) c1[n] = along(what->c1, columns, n);
    for (int n = 0; n < rows; ++n) c2[n] = along(what->c2, rows, n);
    int failures = 0;
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : failures)
    for (int n = 0; n < rows * columns; ++n) {
        const fw_automaton_speeds speeds = {c1[n % columns], c2[n / columns]};
        fw_automaton_growth growth = {0};
        failures += fw_automaton_growth_map(speeds, (int)what->waves, &growth, NULL) != FW_OK;
        factors[n] = growth.factor;
        largest[n] = growth.largest;
    }
    if (failures > 0) return fw_fail_memory(error, "a stability map");
    analysis->map.excess = -INFINITY;
    analysis->map.least = INFINITY;
    for (int n = 0; n < rows * columns; ++n)
        judge_point(analysis, (fw_automaton_speeds){c1[n % columns], c2[n / columns]}, largest[n],
                    factors[n]);
    return FW_OK;
}

/* --- one wave vector --- */

/* The direction of the long axis of the ellipse on which the cells of a colour move. */
static fw_vec2 polarisation_of(const double complex a[2])
{
    const double angle = 0.5 * atan2(2 * creal(conj(a[0]) * a[1]),
                                     creal(conj(a[0]) * a[0]) - creal(conj(a[1]) * a[1]));
    return (fw_vec2){cos(angle), sin(angle)};
}

fw_status fw_analysis_mode(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_analysis *what = analysis->what;
    const fw_scenario_automaton *material = &scenario->materials[what->material].automaton;
    const fw_lattice lattice = {.kind = FW_SQUARE, .spacing = 1};
    for (int m = 0; m < FW_MODES; ++m) {
        fw_automaton_mode mode;
        FW_TRY(fw_build_automaton_mode(material, &lattice, what->wave_vector, m, &mode, error));
        analysis->mode.speed[m] = mode.frequency / hypot(what->wave_vector.x, what->wave_vector.y);
        analysis->mode.polarisation[m] = polarisation_of(mode.white);
    }
    return FW_OK;
}

/* --- dispersion, simulated --- */

/* Two bodies that start with the real and the imaginary part of a wave: together they carry the
 * complex wave, whose amplitude has no part of the opposite wave in it. */
typedef struct carrier {
    fw_solid *part[2];
    const fw_sites *sites;
    double complex *conjugate; /* exp(-i k.s) per site */
} carrier;

static fw_status make_carrier(carrier *c, const fw_elastic_automaton_def *def,
                              const fw_automaton_mode *mode, fw_vec2 wave, fw_vec2 *room,
                              fw_error *error)
{
    fw_elastic_automaton_def own = *def;
    own.displacement = room;
    own.displaced_as_given = true;
    for (int n = 0; n < 2; ++n) {
        fw_automaton_mode_fill(mode->black, mode->white, wave, n == 0 ? 1 : -I, c->sites,
                               def->black_is_odd, room);
        FW_TRY(fw_elastic_automaton_create(&c->part[n], &own, error));
    }
    for (int p = 0; p < c->sites->count; ++p)
        c->conjugate[p] = cexp(-I * (wave.x * c->sites->site[p].i + wave.y * c->sites->site[p].j));
    return FW_OK;
}

/* Amplitude of the wave that the start was, in units of it. */
static double complex amplitude_of(const carrier *c, const fw_automaton_mode *mode)
{
    double complex sum = 0;
    for (int p = 0; p < c->sites->count; ++p) {
        const fw_vec2 re = fw_elastic_automaton_displacement(c->part[0], p);
        const fw_vec2 im = fw_elastic_automaton_displacement(c->part[1], p);
        const double complex *a =
            fw_elastic_automaton_is_black(c->part[0], p) ? mode->black : mode->white;
        sum += c->conjugate[p] * (conj(a[0]) * (re.x + I * im.x) + conj(a[1]) * (re.y + I * im.y));
    }
    return sum;
}

/* Mean turn of the amplitude per step. Waves next to omega = pi turn either way. */
static fw_status run_wave(carrier *c, const fw_elastic_automaton_def *def,
                          const fw_automaton_mode *mode, fw_vec2 wave, int steps, fw_vec2 *room,
                          double *frequency, fw_error *error)
{
    fw_status status = make_carrier(c, def, mode, wave, room, error);
    if (status == FW_OK) {
        double complex before = amplitude_of(c, mode);
        double turns = 0;
        for (int step = 0; step < steps && status == FW_OK; ++step) {
            for (int n = 0; n < 4 && status == FW_OK; ++n)
                status = fw_solid_advance_free(c->part[n / 2], error);
            const double complex now = amplitude_of(c, mode);
            turns += fabs(carg(now * conj(before)));
            before = now;
        }
        *frequency = turns / steps;
    }
    for (int n = 0; n < 2; ++n) {
        fw_solid_destroy(c->part[n]);
        c->part[n] = NULL;
    }
    return status;
}

/* Number n of the way from Gamma over X and M back towards Gamma, in units of 2 pi/size. */
static fw_site way_point(int n, int half)
{
    if (n < half) return (fw_site){n + 1, 0};
    if (n < 2 * half) return (fw_site){half, n - half + 1};
    return (fw_site){3 * half - n - 1, 3 * half - n - 1};
}

static fw_status follow_way(fw_analysis *analysis, const fw_scenario *scenario, carrier *c,
                            const fw_elastic_automaton_def *def, fw_vec2 *room, fw_error *error)
{
    static const char *const names[] = {"closed-slow", "closed-fast", "simulated-slow",
                                        "simulated-fast"};
    const fw_scenario_analysis *what = analysis->what;
    const fw_scenario_automaton *material = &scenario->materials[what->material].automaton;
    const int half = (int)what->size / 2, count = 3 * half - 1;
    double *column[4];
    double *way = fw_analysis_add(analysis, "way", "radians per site",
                                  "length of the way Gamma-X-M-Gamma up to here", count, 0, error);
    for (int n = 0; n < 4; ++n)
        column[n] =
            fw_analysis_add(analysis, names[n], "radians per step", "frequency", count, 0, error);
    if (!way || !column[0] || !column[1] || !column[2] || !column[3]) return FW_SYSTEM_FAILED;
    double length = 0;
    fw_vec2 before = {0, 0};
    for (int n = 0; n < count; ++n) {
        const fw_site at = way_point(n, half);
        const double unit = FW_TWO_PI / (double)what->size;
        const fw_vec2 wave = {unit * at.i, unit * at.j};
        length += hypot(wave.x - before.x, wave.y - before.y);
        before = wave;
        way[n] = length;
        double squared[FW_MODES];
        fw_automaton_closed_form(material->speeds, wave, squared);
        for (int m = 0; m < FW_MODES; ++m) {
            fw_automaton_mode mode;
            FW_TRY(fw_build_automaton_mode(material, &def->lattice, wave, m, &mode, error));
            column[m][n] = 2 * asin(fmin(1, sqrt(fmax(0, squared[m])) / 2));
            FW_TRY(run_wave(c, def, &mode, wave, (int)what->steps, room, &column[2 + m][n], error));
            analysis->frequency_error =
                fmax(analysis->frequency_error, fabs(column[2 + m][n] - column[m][n]));
        }
    }
    return FW_OK;
}

fw_status fw_analysis_dispersion(fw_analysis *analysis, const fw_scenario *scenario,
                                 fw_error *error)
{
    const fw_scenario_analysis *what = analysis->what;
    const fw_scenario_automaton *material = &scenario->materials[what->material].automaton;
    fw_sites sites;
    FW_TRY(fw_sites_rectangle(&sites, (int)what->size, (int)what->size, error));
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = material->speeds;
    def.period_columns = def.period_rows = (int)what->size;
    def.black_is_odd = material->black;
    carrier c = {.sites = &sites};
    c.conjugate = calloc((size_t)sites.count, sizeof *c.conjugate);
    fw_vec2 *room = calloc((size_t)sites.count, sizeof *room);
    const fw_status status = c.conjugate && room
                                 ? follow_way(analysis, scenario, &c, &def, room, error)
                                 : fw_fail_memory(error, "the waves of a dispersion");
    free(c.conjugate);
    free(room);
    fw_sites_clear(&sites);
    return status;
}
