/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grip.c - rigid blocks of particles.
 * State: the account. Start reading at fw_grip_hold(). */
#include "contact/grip.h"

#include <stdlib.h>
#include <string.h>

#define TWO_PI 6.28318530717958647693

struct fw_grip {
    char *name;
    int count;
    int *particles;
    fw_prediction *predictions; /* of this tick */
    fw_grip_drive drive;
    fw_grip_account account;
};

static bool is_finite(fw_vec2 v)
{
    return isfinite(v.x) && isfinite(v.y);
}

static fw_status check_drive(const char *name, const fw_grip_drive *drive, fw_error *error)
{
    if (!is_finite(drive->force) || !is_finite(drive->amplitude) || !is_finite(drive->tether) ||
        !isfinite(drive->period) || !isfinite(drive->phase) || !is_finite(drive->path.velocity) ||
        !is_finite(drive->path.amplitude) || !isfinite(drive->path.phase) ||
        !isfinite(drive->path.from) || isnan(drive->path.until) || !isfinite(drive->path.period))
        return fw_fail(error, FW_BAD_INPUT, "grip %s: the drive has a number that is not finite",
                       name);
    if (drive->period < 0 || drive->path.period < 0)
        return fw_fail(error, FW_BAD_INPUT, "grip %s: period %g, expected 0 or more", name,
                       fmin(drive->period, drive->path.period));
    if (drive->tether.x < 0 || drive->tether.y < 0)
        return fw_fail(error, FW_BAD_INPUT, "grip %s: tether [%g, %g], expected 0 or more", name,
                       drive->tether.x, drive->tether.y);
    return FW_OK;
}

fw_status fw_grip_create(fw_grip **grip, const fw_grip_def *def, fw_error *error)
{
    *grip = NULL;
    if (def->particle_count < 1)
        return fw_fail(error, FW_BAD_INPUT, "grip %s holds no particles, expected at least one",
                       def->name);
    for (int n = 1; n < def->particle_count; ++n)
        if (def->particles[n] <= def->particles[n - 1])
            return fw_fail(error, FW_BAD_INPUT,
                           "grip %s: particle %d after %d, expected each once and ascending",
                           def->name, def->particles[n], def->particles[n - 1]);
    FW_TRY(check_drive(def->name, &def->drive, error));
    size_t count = (size_t)def->particle_count;
    fw_grip *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "a grip");
    made->name = strdup(def->name);
    made->particles = fw_array_allocate(count, sizeof *made->particles);
    made->predictions = fw_array_allocate(count, sizeof *made->predictions);
    if (!made->name || !made->particles || !made->predictions) {
        fw_grip_destroy(made);
        return fw_fail_memory(error, "the particles of a grip");
    }
    made->count = def->particle_count;
    memcpy(made->particles, def->particles, count * sizeof *def->particles);
    made->drive = def->drive;
    *grip = made;
    return FW_OK;
}

void fw_grip_destroy(fw_grip *grip)
{
    if (!grip) return;
    free(grip->name);
    free(grip->particles);
    free(grip->predictions);
    free(grip);
}

const char *fw_grip_name(const fw_grip *grip)
{
    return grip->name;
}

int fw_grip_particle_count(const fw_grip *grip)
{
    return grip->count;
}

const int *fw_grip_particles(const fw_grip *grip)
{
    return grip->particles;
}

fw_grip_account *fw_grip_account_of(fw_grip *grip)
{
    return &grip->account;
}

const fw_grip_account *fw_grip_observe_account(const fw_grip *grip)
{
    return &grip->account;
}

fw_status fw_grip_set_drive(fw_grip *grip, const fw_grip_drive *drive, fw_error *error)
{
    FW_TRY(check_drive(grip->name, drive, error));
    grip->drive = *drive;
    return FW_OK;
}

/* D of the components that are not prescribed. */
static fw_vec2 drive_force(const fw_grip *grip, double time)
{
    const fw_grip_drive *d = &grip->drive;
    double swing = d->period > 0 ? sin(TWO_PI * time / d->period + d->phase) : 0;
    return (fw_vec2){
        d->force.x + d->amplitude.x * swing - d->tether.x * grip->account.displacement.x,
        d->force.y + d->amplitude.y * swing - d->tether.y * grip->account.displacement.y};
}

/* sum A_i^-1, and sum A_i^-1 w_i. */
typedef struct block {
    fw_sym2 inertia;
    fw_vec2 push;
} block;

static block add_up(const fw_grip *grip)
{
    block sum = {{0, 0, 0}, {0, 0}};
    for (int n = 0; n < grip->count; ++n) {
        fw_sym2 inverse = fw_sym2_invert(grip->predictions[n].mobility);
        sum.inertia = fw_sym2_add(sum.inertia, inverse);
        sum.push = fw_vec2_add(sum.push, fw_sym2_apply(inverse, grip->predictions[n].displacement));
    }
    return sum;
}

/* w, component by component prescribed or driven: inertia w = push + D in the driven ones. */
static fw_vec2 displacement_of(const fw_grip *grip, const block *sum, double time, double tick)
{
    const fw_grip_drive *d = &grip->drive;
    fw_vec2 told = fw_vec2_subtract(fw_path_displacement(&d->path, time + tick),
                                    fw_path_displacement(&d->path, time));
    fw_vec2 right = fw_vec2_add(sum->push, drive_force(grip, time));
    if (d->prescribed_x && d->prescribed_y) return told;
    if (d->prescribed_x)
        return (fw_vec2){told.x, (right.y - sum->inertia.xy * told.x) / sum->inertia.yy};
    if (d->prescribed_y)
        return (fw_vec2){(right.x - sum->inertia.xy * told.y) / sum->inertia.xx, told.y};
    return fw_sym2_apply(fw_sym2_invert(sum->inertia), right);
}

static fw_vec2 centre_of(const fw_grip *grip, const fw_solid *solid)
{
    fw_vec2 sum = {0, 0};
    for (int n = 0; n < grip->count; ++n)
        sum = fw_vec2_add(sum, fw_solid_position(solid, grip->particles[n]));
    return fw_vec2_scale(1.0 / grip->count, sum);
}

void fw_grip_hold(fw_grip *grip, const fw_solid *solid, double time, fw_hold *holds)
{
    fw_solid_predict(solid, grip->particles, grip->count, grip->predictions);
    const block sum = add_up(grip);
    const fw_vec2 w = displacement_of(grip, &sum, time, solid->tick);
    const fw_vec2 centre = centre_of(grip, solid);
    fw_grip_account *account = &grip->account;
    fw_vec2 total = {0, 0};
    account->torque = 0;
    for (int n = 0; n < grip->count; ++n) {
        fw_vec2 force = fw_sym2_apply(fw_sym2_invert(grip->predictions[n].mobility),
                                      fw_vec2_subtract(w, grip->predictions[n].displacement));
        holds[n] = (fw_hold){grip->particles[n], w, force};
        fw_vec2 arm = fw_vec2_subtract(fw_solid_position(solid, grip->particles[n]), centre);
        account->torque += fw_vec2_cross(arm, force);
        total = fw_vec2_add(total, force);
    }
    account->reaction = fw_vec2_scale(0.5, fw_vec2_add(total, account->force));
    account->force = total;
    account->impulse = fw_vec2_add(account->impulse, fw_vec2_scale(solid->tick, total));
    account->work += fw_vec2_dot(total, w);
    account->displacement = fw_vec2_add(account->displacement, w);
    account->way = fw_vec2_add(account->way, (fw_vec2){fabs(w.x), fabs(w.y)});
}
