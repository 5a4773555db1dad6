/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin_kernels.c - the BAOAB step of langevin.h, eight particles at a time; compiled once for
 * each instruction set. Keeps no state. Sums are made in eight lanes whatever the width of vectors.
 * Start reading at move_lanes(). */
#include "langevin_kernels.h"

#include "kick_vectors.h"

#include "core/noise.h"
#include "core/noise_vectors.h"

/* Sums in lanes, FW_PARTS registers each. */
typedef struct fw_lane_ledger {
    fw_vector work[FW_PARTS], dissipated[FW_PARTS], heat[FW_PARTS];
    fw_vector external_x[FW_PARTS], external_y[FW_PARTS], drag_x[FW_PARTS], drag_y[FW_PARTS];
    fw_vector path_x[FW_PARTS], path_y[FW_PARTS], stray[FW_PARTS];
} fw_lane_ledger;

FW_INLINE fw_vector square_of(fw_vector_pair v)
{
    return v.x * v.x + v.y * v.y;
}

/* The noise xi of FW_NOISE_RUN particles. */
typedef struct fw_noise_run {
    double x[FW_NOISE_RUN], y[FW_NOISE_RUN];
} fw_noise_run;

/* v2 = c v1 + s xi */
FW_INLINE fw_vector_pair mixed_of(const fw_move_task *task, fw_vector_pair kicked, int at,
                                  fw_vector_pair noise)
{
    const fw_baoab *baoab = &task->baoab;
    const fw_vector_pair kept = {baoab->keep * kicked.x, baoab->keep * kicked.y};
    if (!(baoab->shake > 0)) return kept;
    const fw_vector shake = baoab->shake * fw_load(task->root_inverse_mass + at);
    return (fw_vector_pair){kept.x + shake * noise.x, kept.y + shake * noise.y};
}

FW_INLINE void move_lanes(const fw_move_task *task, bool thermostat, bool loaded, int at, int part,
                          fw_mask held, fw_vector_pair noise, fw_lane_ledger *ledger)
{
    const fw_vector_pair force = fw_load_pair(task->force_x, task->force_y, at);
    const fw_vector_pair kicked = fw_kicked(task, loaded, at, force); /* v1 = v + dt/2m F */
    fw_vector_pair mixed = kicked;
    if (thermostat) {
        mixed = mixed_of(task, kicked, at, noise);
        const fw_vector mass = fw_load(task->mass + at);
        const fw_vector drag = 0.5 * mass * task->baoab.lose * square_of(kicked);
        const fw_vector change = 0.5 * mass * (square_of(mixed) - square_of(kicked));
        ledger->dissipated[part] += fw_keep(held, drag);
        ledger->heat[part] += fw_keep(held, change + drag);
        ledger->drag_x[part] += fw_keep(held, mass * (mixed.x - kicked.x));
        ledger->drag_y[part] += fw_keep(held, mass * (mixed.y - kicked.y));
    }
    const fw_vector_pair path = {task->baoab.half * (kicked.x + mixed.x),
                                 task->baoab.half * (kicked.y + mixed.y)};
    if (loaded) {
        const fw_vector_pair external = fw_load_pair(task->external_x, task->external_y, at);
        ledger->work[part] += fw_keep(held, external.x * path.x + external.y * path.y);
        ledger->external_x[part] += fw_keep(held, external.x);
        ledger->external_y[part] += fw_keep(held, external.y);
    }
    const fw_vector_pair stray = {path.x - task->common.x, path.y - task->common.y};
    ledger->stray[part] = fw_larger(ledger->stray[part], fw_keep(held, square_of(stray)));
    ledger->path_x[part] += fw_keep(held, path.x);
    ledger->path_y[part] += fw_keep(held, path.y);
    fw_store_some(task->x + at, held, fw_load(task->x + at) + path.x);
    fw_store_some(task->y + at, held, fw_load(task->y + at) + path.y);
    fw_store_some(task->velocity_x + at, held, mixed.x);
    fw_store_some(task->velocity_y + at, held, mixed.y);
}

FW_INLINE void move_all(const fw_move_task *task, bool thermostat, bool loaded, int begin, int end,
                        fw_lane_ledger *ledger)
{
    fw_noise_run noise = {{0}, {0}};
    for (int run = begin; run < end; run += FW_NOISE_RUN) {
        if (thermostat && task->baoab.shake > 0)
            fw_noise_gaussians_run(task->seed, (uint64_t)run, task->ticks, FW_NOISE_THERMOSTAT,
                                   noise.x, noise.y);
        const int run_end = run + FW_NOISE_RUN < end ? run + FW_NOISE_RUN : end;
        for (int at = run; at < run_end; at += FW_BLOCK) {
            const uint8_t held = fw_first_lanes(end - at);
            for (int part = 0; part < FW_PARTS; ++part) {
                const int lane = part * FW_WIDTH;
                move_lanes(task, thermostat, loaded, at + lane, part, fw_mask_of(held, part),
                           fw_load_pair(noise.x, noise.y, at - run + lane), ledger);
            }
        }
    }
}

static double largest(const fw_vector *parts)
{
    double most = 0;
    for (int part = 0; part < FW_PARTS; ++part)
        for (int k = 0; k < FW_WIDTH; ++k) most = parts[part][k] > most ? parts[part][k] : most;
    return most;
}

static void move(const fw_move_task *task, int begin, int end, fw_move_sums *sums)
{
    fw_lane_ledger ledger = {0};
    const bool loaded = task->external_x != NULL;
    if (task->baoab.thermostat) {
        if (loaded)
            move_all(task, true, true, begin, end, &ledger);
        else
            move_all(task, true, false, begin, end, &ledger);
    } else {
        if (loaded)
            move_all(task, false, true, begin, end, &ledger);
        else
            move_all(task, false, false, begin, end, &ledger);
    }
    *sums = (fw_move_sums){
        .work = fw_sum_block(ledger.work),
        .dissipated = fw_sum_block(ledger.dissipated),
        .heat = fw_sum_block(ledger.heat),
        .external = {fw_sum_block(ledger.external_x), fw_sum_block(ledger.external_y)},
        .drag = {fw_sum_block(ledger.drag_x), fw_sum_block(ledger.drag_y)},
        .path = {fw_sum_block(ledger.path_x), fw_sum_block(ledger.path_y)},
        .stray = largest(ledger.stray)};
}

FW_INLINE void kick_all(const fw_move_task *task, bool loaded, int begin, int end)
{
    for (int at = begin; at < end; at += FW_WIDTH) {
        const fw_mask held = fw_mask_of(fw_first_lanes(end - at), 0);
        fw_kick(task, loaded, at, held, fw_load_pair(task->force_x, task->force_y, at));
    }
}

static void kick(const fw_move_task *task, int begin, int end)
{
    if (task->external_x)
        kick_all(task, true, begin, end);
    else
        kick_all(task, false, begin, end);
}

const fw_langevin_kernels FW_KERNELS_HERE(fw_langevin_loops) = {.move = move, .kick = kick};
