/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_structure.c - pictures of bodies with what follows from where their particles are: the map
 * of the structure factor, the distribution of a field. Each keeps its numbers as a table beside
 * the picture. Keeps no state. Start reading at fw_plot_draw_structure(). */
#include "plot_extent.h"

#include "core/array.h"
#include "core/particles/structure.h"
#include "experiments/storage/csv.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

static_assert((int)FW_PICTURE_PAIRS_MAX <= (int)FW_FIGURE_PAIRS_MAX,
              "a figure has no room for them");

typedef struct pairs {
    int count;
    fw_plot_view loaded[FW_PICTURE_PAIRS_MAX];
    fw_figure_pair pair[FW_PICTURE_PAIRS_MAX];
} pairs;

static fw_status load_pairs(pairs *p, const fw_plot_result *result, const fw_plot_picture *picture,
                            const char *field, fw_error *error)
{
    *p = (pairs){.count = 0};
    if (picture->frame_count > FW_PICTURE_PAIRS_MAX)
        return fw_fail(error, FW_BAD_INPUT, "%s: %d instants in one picture, expected at most %d",
                       result->directory, picture->frame_count, FW_PICTURE_PAIRS_MAX);
    for (int k = 0; k < picture->frame_count; ++k) {
        fw_plot_view *view = &p->loaded[p->count++];
        FW_TRY(fw_plot_view_load(view, result, picture->frames[k], field, error));
        p->pair[k].view = &view->view;
    }
    return FW_OK;
}

static void clear_pairs(pairs *p)
{
    for (int k = 0; k < p->count; ++k) fw_plot_view_clear(&p->loaded[k]);
}

/* --- the structure factor --- */

/* Wave vectors up to 15 per spacing, beyond the second ring of both lattices' reciprocal ones. A
 * peak of a body of diameter L is 4 pi/L wide: the grid is finer by far, as long as it does not
 * take too long. */
#define REACH     15.
#define TERMS_MAX 4e9
enum { POINTS_MIN = 61, POINTS_MAX = 401 };

typedef struct structure_maps {
    const fw_plot_result *result;
    const fw_plot_picture *picture;
    int points, count;
    double first, step, least;
    double *values; /* of each frame one map */
    fw_figure_map_plan plan[FW_PICTURE_PAIRS_MAX];
    char labels[2][32];
} structure_maps;

static void choose_grid(structure_maps *m, const fw_plot_view *view)
{
    const double spacing = fw_view_spacing(&view->view.bodies[0]);
    const long particles = fw_view_count(&view->view);
    fw_view_bounds bounds = fw_view_bounds_empty();
    fw_view_bounds_include_bodies(&bounds, &view->view);
    const double diameter = hypot(bounds.x.high - bounds.x.low, bounds.y.high - bounds.y.low);
    const double wanted = 2 * REACH / spacing * diameter / FW_PI + 1;
    const double most = fmin(POINTS_MAX, sqrt(TERMS_MAX / (double)particles));
    m->points = (int)fmax(POINTS_MIN, fmin(wanted, most)) | 1; /* odd: 0 is among them */
    m->first = -REACH / spacing;
    m->step = -2 * m->first / (m->points - 1);
    m->least = 1. / (double)particles;
}

static fw_status find_maps(structure_maps *m, const pairs *p, fw_error *error)
{
    const fw_units *units = &m->result->scenario->units;
    choose_grid(m, &p->loaded[0]);
    const size_t size = (size_t)m->points * (size_t)m->points;
    const double *asked = m->picture->asked.range;
    m->values = fw_array_of_doubles((size_t)p->count * size);
    if (!m->values) return fw_fail_memory(error, "the maps of a structure factor");
    m->count = p->count;
    for (int k = 0; k < p->count; ++k) {
        double *values = m->values + (size_t)k * size;
        /* The particles of all bodies follow each other in a view's arrays. */
        FW_TRY(fw_structure_map(p->loaded[k].x, p->loaded[k].y,
                                (int)fw_view_count(&p->loaded[k].view), m->first, m->step,
                                m->points, values, error));
        m->plan[k] = (fw_figure_map_plan){
            .columns = m->points,
            .rows = m->points,
            .values = values,
            .p_first = m->first,
            .p_step = m->step,
            .q_first = m->first,
            .q_step = m->step,
            .p_label = fw_plot_label(m->labels[0], sizeof m->labels[0], "q_{x}", "1/length", units),
            .q_label = fw_plot_label(m->labels[1], sizeof m->labels[1], "q_{y}", "1/length", units),
            .equal_aspect = true,
            .colouring = {.label = {"structure factor S(q)", 0},
                          .range = asked[0] < asked[1] ? (fw_range){asked[0], asked[1]}
                                                       : (fw_range){m->least, 1},
                          .logarithmic = !(asked[0] < asked[1]) || asked[0] > 0,
                          .map = m->picture->map ? m->picture->map : FW_PALETTE_SEQUENTIAL}};
    }
    return FW_OK;
}

/* Six digits: full ones would fill megabytes. */
static void write_maps(FILE *out, const void *object)
{
    const structure_maps *m = object;
    fputs("step,qx,qy,S\n", out);
    for (int k = 0; k < m->count; ++k)
        for (int b = 0; b < m->points; ++b)
            for (int a = 0; a < m->points; ++a)
                fprintf(out, "%lld,%.6g,%.6g,%.5g\n",
                        (long long)m->result->steps[m->picture->frames[k]], m->first + a * m->step,
                        m->first + b * m->step,
                        m->values[((size_t)k * (size_t)m->points + (size_t)b) * (size_t)m->points +
                                  (size_t)a]);
}

fw_status fw_plot_draw_structure(const fw_plot_result *result, const fw_plot_picture *picture,
                                 fw_error *error)
{
    pairs p;
    structure_maps maps = {.result = result, .picture = picture};
    fw_status status = load_pairs(&p, result, picture, NULL, error);
    if (status == FW_OK) status = find_maps(&maps, &p, error);
    for (int k = 0; k < p.count; ++k) p.pair[k].map = &maps.plan[k];
    if (status == FW_OK) {
        const fw_figure_pairs_plan plan = {
            .pairs = p.pair, .pair_count = p.count, .look = FW_VIEW_DISCS};
        status = fw_figure_pairs(&picture->page, &plan, error);
    }
    if (status == FW_OK && picture->data)
        status = fw_csv_keep(result->directory, picture->data, write_maps, &maps, error);
    free(maps.values);
    clear_pairs(&p);
    return status;
}

/* --- the distribution of a field --- */

enum { BINS = 60, TIMES_MAX = 400 };

/* Parts of the particles with values in BINS equal bins of a range; those beyond it are in none. */
typedef struct distribution {
    double part[BINS];
    double mean, spread, highest;
} distribution;

static double edge_of(fw_range range, int bin)
{
    return range.low + (range.high - range.low) * bin / BINS;
}

static distribution distribution_of(const double *values, int count, fw_range range)
{
    distribution d = {.highest = -INFINITY};
    int known = 0;
    double sum = 0, square = 0;
    for (int i = 0; i < count; ++i) {
        if (!isfinite(values[i])) continue;
        known += 1;
        sum += values[i];
        d.highest = fmax(d.highest, values[i]);
        const double place = BINS * (values[i] - range.low) / (range.high - range.low);
        const int bin = values[i] == range.high ? BINS - 1 : (int)floor(place);
        if (bin >= 0 && bin < BINS) d.part[bin] += 1;
    }
    d.mean = known > 0 ? sum / known : NAN;
    for (int i = 0; i < count; ++i)
        if (isfinite(values[i])) square += (values[i] - d.mean) * (values[i] - d.mean);
    d.spread = known > 0 ? sqrt(square / known) : NAN;
    for (int bin = 0; bin < BINS && known > 0; ++bin) d.part[bin] /= known;
    return d;
}

typedef struct distributions {
    const fw_plot_result *result;
    fw_range range;
    int count;
    int64_t *frames;
    distribution *of;
} distributions;

static fw_status find_distributions(distributions *d, const fw_plot_picture *picture,
                                    fw_error *error)
{
    fw_playback *playback = d->result->playback;
    fw_colouring colouring;
    double *values = fw_array_of_doubles((size_t)playback->particle_count);
    d->of = calloc((size_t)d->count, sizeof *d->of);
    fw_status status =
        values && d->of ? FW_OK : fw_fail_memory(error, "the distribution of a field");
    if (status == FW_OK) status = fw_plot_colours_find(&colouring, d->result, picture, error);
    if (status == FW_OK) d->range = fw_range_roomy(colouring.range, 0, false);
    for (int k = 0; k < d->count && status == FW_OK; ++k) {
        status = fw_playback_read_field(playback, d->frames[k], picture->asked.field.text, values,
                                        error);
        if (status == FW_OK) d->of[k] = distribution_of(values, playback->particle_count, d->range);
    }
    free(values);
    return status;
}

static void write_distributions(FILE *out, const void *object)
{
    const distributions *d = object;
    fputs("step,time,mean,spread,maximum,from,until,part\n", out);
    for (int k = 0; k < d->count; ++k)
        for (int bin = 0; bin < BINS; ++bin) {
            const distribution *of = &d->of[k];
            const double row[] = {d->result->times[d->frames[k]],
                                  of->mean,
                                  of->spread,
                                  of->highest,
                                  edge_of(d->range, bin),
                                  edge_of(d->range, bin + 1),
                                  of->part[bin]};
            fprintf(out, "%lld", (long long)d->result->steps[d->frames[k]]);
            for (int c = 0; c < 7; ++c) {
                fputc(',', out);
                fw_csv_write_number(out, row[c]);
            }
            fputc('\n', out);
        }
}

static fw_status keep_distributions(const distributions *d, const fw_plot_picture *picture,
                                    fw_error *error)
{
    if (!picture->data) return FW_OK;
    return fw_csv_keep(d->result->directory, picture->data, write_distributions, d, error);
}

/* A histogram as a line over the edges of its bins. */
typedef struct steps {
    double x[2 * BINS], y[2 * BINS];
    fw_curve curve;
    fw_chart chart;
} steps;

static void draw_steps(steps *s, const distributions *d, int number)
{
    for (int bin = 0; bin < BINS; ++bin)
        for (int end = 0; end < 2; ++end) {
            s->x[2 * bin + end] = edge_of(d->range, bin + end);
            s->y[2 * bin + end] = d->of[number].part[bin];
        }
    s->curve = (fw_curve){.count = 2 * BINS, .x = s->x, .y = s->y, .look = FW_CURVE_LINE};
    s->chart =
        (fw_chart){.label = {"part of the particles", 0}, .curves = &s->curve, .curve_count = 1};
}

fw_status fw_plot_draw_stages(const fw_plot_result *result, const fw_plot_picture *picture,
                              fw_error *error)
{
    pairs p;
    distributions d = {.result = result, .count = picture->frame_count, .frames = picture->frames};
    steps *histograms = calloc(FW_PICTURE_PAIRS_MAX, sizeof *histograms);
    fw_figure_pairs_plan plan = {
        .pairs = p.pair, .look = FW_VIEW_CELLS, .spots = true, .x_label = picture->field};
    fw_status status = load_pairs(&p, result, picture, picture->asked.field.text, error);
    if (status == FW_OK && !histograms) status = fw_fail_memory(error, "histograms");
    if (status == FW_OK) status = find_distributions(&d, picture, error);
    if (status == FW_OK) status = fw_plot_colours_find(&plan.colouring, result, picture, error);
    for (int k = 0; k < p.count && status == FW_OK; ++k) {
        draw_steps(&histograms[k], &d, k);
        p.pair[k].chart = &histograms[k].chart;
    }
    plan.pair_count = p.count;
    if (status == FW_OK) status = fw_figure_pairs(&picture->page, &plan, error);
    if (status == FW_OK) status = keep_distributions(&d, picture, error);
    free(histograms);
    free(d.of);
    clear_pairs(&p);
    return status;
}

/* Frames evenly spread over those from one step to another. */
static fw_status choose_times(distributions *d, const fw_plot_picture *picture, fw_error *error)
{
    const int64_t first = fw_plot_nearest_frame(d->result, picture->asked.from);
    const int64_t last = picture->asked.until == INT64_MAX
                             ? d->result->playback->frame_count - 1
                             : fw_plot_nearest_frame(d->result, picture->asked.until);
    const int64_t every = 1 + (last - first) / TIMES_MAX;
    d->count = (int)((last - first) / every) + 1;
    d->frames = fw_array_allocate((size_t)d->count, sizeof *d->frames);
    if (!d->frames) return fw_fail_memory(error, "the times of a histogram");
    for (int k = 0; k < d->count; ++k) d->frames[k] = first + k * every;
    return FW_OK;
}

fw_status fw_plot_draw_histogram(const fw_plot_result *result, const fw_plot_picture *picture,
                                 fw_error *error)
{
    distributions d = {.result = result};
    fw_status status = choose_times(&d, picture, error);
    if (status == FW_OK) status = find_distributions(&d, picture, error);
    const size_t count = (size_t)d.count;
    double *parts = fw_array_of_doubles(count * BINS), *mean = fw_array_of_doubles(2 * count);
    if (status == FW_OK && (!parts || !mean)) status = fw_fail_memory(error, "a histogram");
    if (status == FW_OK) {
        char time[32];
        const fw_units *units = &result->scenario->units;
        double *times = mean + count;
        for (size_t k = 0; k < count; ++k) {
            times[k] = result->times[d.frames[k]];
            mean[k] = d.of[k].mean;
            for (size_t bin = 0; bin < BINS; ++bin) parts[bin * count + k] = d.of[k].part[bin];
        }
        const double bin = (d.range.high - d.range.low) / BINS;
        const fw_curve line = {
            .label = "mean", .count = d.count, .x = times, .y = mean, .look = FW_CURVE_LINE};
        const fw_figure_map_plan plan = {
            .columns = d.count,
            .rows = BINS,
            .values = parts,
            .p_first = times[0],
            .p_step = count > 1 ? (times[count - 1] - times[0]) / (double)(count - 1) : 1,
            .q_first = d.range.low + bin / 2,
            .q_step = bin,
            .p_label = fw_plot_time_label(time, sizeof time, false, units),
            .q_label = picture->field,
            .colouring = {.label = {"part of the particles", 0},
                          .trim = .002,
                          .map = picture->map ? picture->map : FW_PALETTE_SEQUENTIAL},
            .curves = &line,
            .curve_count = 1};
        status = fw_figure_map(&picture->page, &plan, error);
    }
    if (status == FW_OK) status = keep_distributions(&d, picture, error);
    free(parts);
    free(mean);
    free(d.frames);
    free(d.of);
    return status;
}
