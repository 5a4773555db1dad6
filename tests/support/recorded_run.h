/* SPDX-License-Identifier: GPL-3.0-or-later */
/* recorded_run.h - a run without physics for tests of the results file: two bodies of 5 and 3
 * particles, whose every number is a formula of frame, particle and component that trajectory.py
 * knows too. */
#ifndef FW_RECORDED_RUN_H
#define FW_RECORDED_RUN_H

#include "experiments/results/trajectory.h"
#include "tests/support/scratch.h"

enum { RUN_PARTICLES = 8, RUN_FRAMES = 40, RUN_SAMPLES = 300 };

static const int run_counts[] = {5, 3};
static const int run_links[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
static const double run_masses[] = {1, 1, 2, 1, 1, 0.5, 0.5, 0.25};

/* Exact in binary, so that "right" means equal. */
static inline double run_value(int kind, int64_t frame, int particle, int component)
{
    return (double)frame * 64 + (double)particle + 0.25 * component + 4096.0 * kind;
}

static inline fw_trajectory_def run_def(const char *directory)
{
    static const fw_trajectory_body bodies[] = {{"sheet", 5, run_masses, run_links, 3},
                                                {"Körper", 3, run_masses + 5, run_links, 2}};
    static const fw_trajectory_field fields[] = {
        {"strain", "1", "elongation of the links"},
        {"return-force", "force", "force towards its site"}};
    static const fw_observable observables[] = {
        {"energy", "energy", "kinetic and elastic energy", 1},
        {"momentum", "mass length / time", "of all bodies", 2}};
    fw_trajectory_def def = fw_trajectory_def_default();
    def.directory = directory;
    def.author = "A. Person";
    def.title = "a run";
    def.scenario = "title: a run\n";
    def.seed = 77;
    def.threads = 2;
    def.bodies = bodies;
    def.body_count = 2;
    def.velocity = def.force = true;
    def.fields = fields;
    def.field_count = 2;
    def.observables = observables;
    def.observable_count = 2;
    def.frame_count = RUN_FRAMES;
    def.sample_count = RUN_SAMPLES;
    return def;
}

/* Frame k lies at step 10 k, time 5 k; the second body has no return force. */
static inline fw_status run_write_frame(fw_trajectory *trajectory, int64_t frame)
{
    double vectors[3][2][RUN_PARTICLES], strain[RUN_PARTICLES], pull[RUN_PARTICLES];
    for (int i = 0; i < RUN_PARTICLES; ++i) {
        for (int kind = 0; kind < 3; ++kind)
            for (int component = 0; component < 2; ++component)
                vectors[kind][component][i] = run_value(kind, frame, i, component);
        strain[i] = run_value(3, frame, i, 0);
        pull[i] = run_value(4, frame, i, 0);
    }
    fw_frame_body bodies[2];
    const double *fields[2][2] = {{strain, pull}, {strain + 5, NULL}};
    for (int body = 0, first = 0; body < 2; first += run_counts[body++])
        bodies[body] = (fw_frame_body){vectors[0][0] + first,
                                       vectors[0][1] + first,
                                       vectors[1][0] + first,
                                       vectors[1][1] + first,
                                       vectors[2][0] + first,
                                       vectors[2][1] + first,
                                       fields[body],
                                       NULL,
                                       0};
    return fw_trajectory_write_frame(trajectory, 10 * frame, 5.0 * (double)frame, bodies, &error);
}

/* Sample k lies at step k, time k / 2. */
static inline fw_status run_write_sample(fw_trajectory *trajectory, int64_t sample)
{
    const double values[] = {run_value(5, sample, 0, 0), run_value(6, sample, 0, 0),
                             run_value(6, sample, 0, 1)};
    return fw_trajectory_write_sample(trajectory, sample, 0.5 * (double)sample, values, &error);
}

/* Samples from the next one up to `end`, and the frames that come with every seventh. */
static inline fw_status run_write_until(fw_trajectory *trajectory, int64_t end)
{
    for (int64_t step = fw_trajectory_sample_count(trajectory); step < end; ++step) {
        FW_TRY(run_write_sample(trajectory, step));
        if (step % 7 == 0 && step / 7 < RUN_FRAMES) FW_TRY(run_write_frame(trajectory, step / 7));
    }
    return FW_OK;
}

/* Frames that have been written when there are so many samples. */
static inline int64_t run_frames_at(int64_t samples)
{
    int64_t frames = (samples + 6) / 7;
    return frames < RUN_FRAMES ? frames : RUN_FRAMES;
}

#endif
