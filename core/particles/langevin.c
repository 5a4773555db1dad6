/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin.c - the BAOAB step over blocks of particles; its loops are in langevin_kernels.c.
 * State: positions (head), velocities, controls; forces follow from them. Invariant between steps:
 * force_x/y belong to the present positions, constraint_x/y are zero. Particles are cut into blocks
 * of fixed size, each summed by itself and the blocks in order: the ledger does not depend on how
 * many threads there are. Start reading at fw_langevin_advance(). */
#include "core/particles/langevin.h"

#include "langevin_kernels.h"

#include "core/noise.h"
#include "core/threads.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 512,
    PARALLEL_FROM = 4096 /* particles; below it threads cost more than they bring */
};

static int block_count(const fw_langevin *solid)
{
    return (solid->head.count + BLOCK - 1) / BLOCK;
}

fw_status fw_langevin_create(fw_langevin *solid, const fw_solid_model *model, int count,
                             fw_error *error)
{
    fw_solid_head_begin(&solid->head, model, count);
    const size_t size = (size_t)count;
    double **arrays[] = {
        &solid->velocity_x,   &solid->velocity_y,   &solid->force_x,           &solid->force_y,
        &solid->mass,         &solid->inverse_mass, &solid->root_inverse_mass, &solid->constraint_x,
        &solid->constraint_y, &solid->scratch};
    fw_arena *arena = &solid->head.arena;
    for (size_t a = 0; a < sizeof arrays / sizeof *arrays; ++a)
        fw_arena_add(arena, arrays[a], size, sizeof(double));
    FW_ARENA_ADD(arena, solid->held_at, size);
    FW_ARENA_ADD(arena, solid->sums, (size_t)block_count(solid));
    FW_ARENA_ADD(arena, solid->known, 1);
    fw_status status = fw_solid_allocate(&solid->head, error);
    if (status != FW_OK) fw_langevin_release(solid);
    return status;
}

void fw_langevin_release(fw_langevin *solid)
{
    fw_solid_head_release(&solid->head);
}

fw_status fw_langevin_check(const fw_langevin_controls *controls, fw_error *error)
{
    if (!(controls->time_step > 0 && isfinite(controls->time_step)))
        return fw_fail(error, FW_BAD_INPUT, "the time step is %g, expected a number > 0",
                       controls->time_step);
    if (!(controls->damping >= 0 && isfinite(controls->damping)))
        return fw_fail(error, FW_BAD_INPUT, "the damping is %g, expected a number >= 0",
                       controls->damping);
    if (!(controls->temperature >= 0 && isfinite(controls->temperature)))
        return fw_fail(error, FW_BAD_INPUT, "the temperature is %g, expected a number >= 0",
                       controls->temperature);
    return FW_OK;
}

fw_status fw_langevin_check_heat(const fw_solid *head, const fw_langevin_controls *controls,
                                 fw_error *error)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    assert(fw_solid_is_langevin(head));
    if (!(controls->damping > 0) || !solid->hottest) return FW_OK;
    const double hottest = solid->hottest(solid, controls->time_step);
    if (controls->temperature <= hottest) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "the temperature is %g, expected at most %.4g with a time step of %g: at higher "
                   "ones particles that collide are pressed together further than such a step "
                   "follows",
                   controls->temperature, hottest, controls->time_step);
}

fw_status fw_langevin_start(fw_langevin *solid, fw_error *error)
{
    for (int i = 0; i < solid->head.count; ++i) {
        solid->inverse_mass[i] = 1 / solid->mass[i];
        solid->root_inverse_mass[i] = sqrt(solid->inverse_mass[i]);
    }
    return fw_langevin_refresh(&solid->head, error);
}

void fw_langevin_set_controls(fw_langevin *solid, const fw_langevin_controls *controls)
{
    solid->controls = *controls;
    solid->head.tick = controls->time_step;
}

bool fw_solid_is_langevin(const fw_solid *solid)
{
    return solid->model->advance == fw_langevin_advance;
}

static fw_langevin *langevin_of(fw_solid *head)
{
    assert(fw_solid_is_langevin(head));
    return (fw_langevin *)head;
}

static const fw_langevin *langevin_of_const(const fw_solid *head)
{
    assert(fw_solid_is_langevin(head));
    return (const fw_langevin *)head;
}

fw_vec2 fw_langevin_velocity(const fw_solid *head, int particle)
{
    const fw_langevin *solid = langevin_of_const(head);
    return (fw_vec2){solid->velocity_x[particle], solid->velocity_y[particle]};
}

void fw_langevin_set_velocity(fw_solid *head, int particle, fw_vec2 velocity)
{
    fw_langevin *solid = langevin_of(head);
    fw_langevin_forget(solid);
    solid->velocity_x[particle] = velocity.x;
    solid->velocity_y[particle] = velocity.y;
}

void fw_langevin_add_velocity(fw_solid *head, int first, int count, fw_vec2 velocity)
{
    fw_langevin *solid = langevin_of(head);
    fw_langevin_forget(solid);
    for (int i = first; i < first + count; ++i) {
        solid->velocity_x[i] += velocity.x;
        solid->velocity_y[i] += velocity.y;
    }
}

fw_status fw_langevin_set_bath(fw_solid *head, double damping, double temperature, fw_error *error)
{
    fw_langevin *solid = langevin_of(head);
    fw_langevin_controls controls = solid->controls;
    controls.damping = damping;
    controls.temperature = temperature;
    FW_TRY(fw_langevin_check(&controls, error));
    FW_TRY(fw_langevin_check_heat(head, &controls, error));
    fw_langevin_set_controls(solid, &controls);
    return FW_OK;
}

void fw_langevin_draw_velocities(fw_solid *head, int first, int count, double temperature)
{
    fw_langevin *solid = langevin_of(head);
    double mass = 0;
    fw_vec2 momentum = {0, 0};
    fw_langevin_forget(solid);
    for (int i = first; i < first + count; ++i) {
        const double scale = sqrt(temperature) * solid->root_inverse_mass[i];
        const fw_vec2 drawn =
            fw_vec2_scale(scale, fw_noise_gaussian(solid->seed, (uint32_t)i,
                                                   (uint64_t)solid->head.ticks, FW_NOISE_MAXWELL));
        solid->velocity_x[i] = drawn.x;
        solid->velocity_y[i] = drawn.y;
        mass += solid->mass[i];
        momentum = fw_vec2_add(momentum, fw_vec2_scale(solid->mass[i], drawn));
    }
    for (int i = first; i < first + count; ++i) {
        solid->velocity_x[i] -= momentum.x / mass;
        solid->velocity_y[i] -= momentum.y / mass;
    }
}

void fw_langevin_reverse(fw_solid *head)
{
    fw_langevin *solid = (fw_langevin *)head;
    fw_langevin_forget(solid);
    for (int i = 0; i < solid->head.count; ++i) {
        solid->velocity_x[i] = -solid->velocity_x[i];
        solid->velocity_y[i] = -solid->velocity_y[i];
    }
}

/* --- the step --- */

static fw_baoab baoab_of(const fw_langevin_controls *controls)
{
    const double decay = controls->damping * controls->time_step;
    const double lose = -expm1(-2 * decay);
    return (fw_baoab){.half = controls->time_step / 2,
                      .keep = exp(-decay),
                      .lose = lose,
                      .shake = sqrt(lose * controls->temperature),
                      .thermostat = decay > 0};
}

static inline fw_vec2 kick(fw_vec2 velocity, double push, fw_vec2 force)
{
    return (fw_vec2){velocity.x + push * force.x, velocity.y + push * force.y};
}

static inline fw_vec2 mix(const fw_baoab *baoab, fw_vec2 kicked, double root_inverse_mass,
                          fw_vec2 noise)
{
    const double shake = baoab->shake * root_inverse_mass;
    return (fw_vec2){baoab->keep * kicked.x + shake * noise.x,
                     baoab->keep * kicked.y + shake * noise.y};
}

/* What the step would bring one particle, with that noise. */
static fw_prediction prediction_of(const fw_langevin *solid, const fw_baoab *baoab, int i,
                                   fw_vec2 noise)
{
    const fw_solid *head = &solid->head;
    const double push = baoab->half * solid->inverse_mass[i];
    const double root = solid->root_inverse_mass[i];
    const fw_vec2 velocity = {solid->velocity_x[i], solid->velocity_y[i]};
    fw_vec2 force = {solid->force_x[i], solid->force_y[i]};
    if (head->loaded)
        force = fw_vec2_add(force, (fw_vec2){head->external_x[i], head->external_y[i]});
    const fw_vec2 kicked = kick(velocity, push, force);
    return (fw_prediction){
        .displacement =
            fw_vec2_scale(baoab->half, fw_vec2_add(kicked, mix(baoab, kicked, root, noise))),
        .inertial =
            fw_vec2_scale(baoab->half, fw_vec2_add(velocity, mix(baoab, velocity, root, noise))),
        .mobility = fw_sym2_scalar(baoab->half * push * (1 + baoab->keep))};
}

enum { SOME = 128 }; /* whose noise is drawn together */

static void predict_some(const fw_langevin *solid, const fw_baoab *baoab, const int *particles,
                         int count, fw_prediction *out)
{
    double noise_x[SOME] = {0}, noise_y[SOME] = {0};
    if (baoab->shake > 0)
        fw_noise_gaussians_of_some(solid->seed, particles, (uint64_t)solid->head.ticks,
                                   FW_NOISE_THERMOSTAT, count, noise_x, noise_y);
    for (int k = 0; k < count; ++k)
        out[k] = prediction_of(solid, baoab, particles[k], (fw_vec2){noise_x[k], noise_y[k]});
}

void fw_langevin_predict(const fw_solid *head, const int *particles, int count, fw_prediction *out)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    const fw_baoab baoab = baoab_of(&solid->controls);
    FW_SHARED_LOOP(
        count > PARALLEL_FROM, for (int begin = 0; begin < count; begin += SOME) {
            const int some = count - begin < SOME ? count - begin : SOME;
            predict_some(solid, &baoab, particles + begin, some, out + begin);
        });
}

static void add_to_ledger(fw_langevin *solid, int blocks)
{
    const double dt = solid->controls.time_step;
    for (int b = 0; b < blocks; ++b) {
        const fw_move_sums *sums = &solid->sums[b];
        const fw_solid_ledger part = {.work = sums->work,
                                      .dissipated = sums->dissipated,
                                      .heat = sums->heat,
                                      .impulse = fw_vec2_scale(dt, sums->external),
                                      .drag = sums->drag};
        fw_solid_ledger_add(&solid->head.ledger, &part);
    }
}

static fw_move_task task_of(const fw_langevin *solid, bool held)
{
    const fw_solid *head = &solid->head;
    fw_move_task task = {.baoab = baoab_of(&solid->controls),
                         .seed = solid->seed,
                         .ticks = (uint64_t)head->ticks,
                         .x = head->x,
                         .y = head->y,
                         .velocity_x = solid->velocity_x,
                         .velocity_y = solid->velocity_y,
                         .force_x = solid->force_x,
                         .force_y = solid->force_y,
                         .mass = solid->mass,
                         .inverse_mass = solid->inverse_mass,
                         .root_inverse_mass = solid->root_inverse_mass,
                         .common = solid->common};
    if (head->loaded) task.external_x = head->external_x, task.external_y = head->external_y;
    if (held) task.constraint_x = solid->constraint_x, task.constraint_y = solid->constraint_y;
    return task;
}

/* How much closer two particles may have come in this step: twice what the one that strays most
 * went beside the common path, which is the mean of the step before. */
static double travel_of(fw_langevin *solid, const fw_constraint *constraints, int constraint_count)
{
    double stray = 0;
    fw_vec2 path = {0, 0};
    for (int b = 0; b < block_count(solid); ++b) {
        stray = fmax(stray, solid->sums[b].stray);
        path = fw_vec2_add(path, solid->sums[b].path);
    }
    for (int k = 0; k < constraint_count; ++k) {
        const fw_vec2 off = fw_vec2_subtract(constraints[k].displacement, solid->common);
        stray = fmax(stray, fw_vec2_dot(off, off));
    }
    solid->common = fw_vec2_scale(1. / solid->head.count, path);
    return 2 * sqrt(stray);
}

void fw_langevin_kick(const fw_move_task *kick, int first, int count)
{
    if (!kick) return;
    const fw_langevin_kernels *kernels = FW_KERNELS_CHOSEN(fw_langevin_loops);
    const int end = first + count;
    FW_SHARED_LOOP(count > PARALLEL_FROM,
                   for (int begin = first; begin < end; begin += BLOCK)
                       kernels->kick(kick, begin, begin + BLOCK < end ? begin + BLOCK : end););
}

fw_status fw_langevin_advance(fw_solid *head, const fw_constraint *constraints,
                              int constraint_count, fw_error *error)
{
    fw_langevin *solid = (fw_langevin *)head;
    const int blocks = block_count(solid), count = head->count;
    const fw_move_task task = task_of(solid, constraint_count > 0);
    const fw_langevin_kernels *kernels = FW_KERNELS_CHOSEN(fw_langevin_loops);
    fw_langevin_forget(solid);
    for (int k = 0; k < constraint_count; ++k) {
        const int i = constraints[k].particle;
        solid->constraint_x[i] = constraints[k].force.x;
        solid->constraint_y[i] = constraints[k].force.y;
        solid->held_at[k] = (fw_vec2){head->x[i], head->y[i]};
    }
    FW_SHARED_LOOP(
        count > PARALLEL_FROM, for (int b = 0; b < blocks; ++b) {
            const int begin = b * BLOCK, end = begin + BLOCK < count ? begin + BLOCK : count;
            kernels->move(&task, begin, end, &solid->sums[b]);
        });
    /* The force brings a held particle where it belongs up to rounding; here it is put there. */
    for (int k = 0; k < constraint_count; ++k) {
        const int i = constraints[k].particle;
        head->x[i] = solid->held_at[k].x + constraints[k].displacement.x;
        head->y[i] = solid->held_at[k].y + constraints[k].displacement.y;
    }
    const double travel = travel_of(solid, constraints, constraint_count);
    FW_TRY(solid->find_forces(solid, travel, &task, error));
    for (int k = 0; k < constraint_count; ++k)
        solid->constraint_x[constraints[k].particle] =
            solid->constraint_y[constraints[k].particle] = 0;
    add_to_ledger(solid, blocks);
    head->ticks += 1;
    return FW_OK;
}

void fw_langevin_carry(fw_solid *head, fw_carry *carries, int count)
{
    fw_langevin *solid = (fw_langevin *)head;
    fw_langevin_forget(solid);
    for (int n = 0; n < count; ++n) {
        fw_carry *carry = &carries[n];
        const int i = carry->particle;
        const fw_vec2 before = {solid->velocity_x[i], solid->velocity_y[i]};
        const fw_vec2 after = {carry->x ? carry->velocity.x : before.x,
                               carry->y ? carry->velocity.y : before.y};
        solid->velocity_x[i] = after.x;
        solid->velocity_y[i] = after.y;
        carry->impulse = fw_vec2_scale(solid->mass[i], fw_vec2_subtract(after, before));
        carry->work = 0.5 * fw_vec2_dot(carry->impulse, fw_vec2_add(after, before));
    }
}

/* --- state --- */

void fw_langevin_state(fw_solid *head, fw_state_list *list)
{
    fw_langevin *solid = (fw_langevin *)head;
    const size_t count = (size_t)head->count;
    fw_solid_head_state(head, list);
    fw_state_list_add(list, "velocity-x", FW_F64, count, solid->velocity_x);
    fw_state_list_add(list, "velocity-y", FW_F64, count, solid->velocity_y);
    fw_state_list_add(list, "controls", FW_F64, sizeof solid->controls / sizeof(double),
                      &solid->controls);
}

fw_status fw_langevin_restored(fw_solid *head, fw_error *error)
{
    const fw_langevin *solid = (const fw_langevin *)head;
    FW_TRY(fw_solid_head_restored(head, error));
    FW_TRY(fw_langevin_check(&solid->controls, error));
    for (int i = 0; i < head->count; ++i)
        if (!isfinite(solid->velocity_x[i]) || !isfinite(solid->velocity_y[i]))
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d has the velocity (%g, %g), expected numbers", i,
                           solid->velocity_x[i], solid->velocity_y[i]);
    return fw_langevin_refresh(head, error);
}

fw_status fw_langevin_refresh(fw_solid *head, fw_error *error)
{
    fw_langevin *solid = (fw_langevin *)head;
    fw_langevin_forget(solid);
    head->tick = solid->controls.time_step;
    return solid->find_forces(solid, INFINITY, NULL, error);
}
