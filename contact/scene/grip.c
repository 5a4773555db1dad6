/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grip.c - rigid blocks of particles.
 * State: the ledger. Start reading at fw_grip_constrain(). */
#include "contact/scene/grip.h"

#include <stdlib.h>
#include <string.h>

struct fw_grip {
    char *name;
    int count;
    int *particles;
    fw_prediction *predictions; /* of this tick */
    fw_drive drive;
    fw_grip_ledger ledger;
};

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
    FW_TRY(fw_drive_check(&def->drive, "grip", def->name, error));
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

fw_grip_ledger *fw_grip_ledger_of(fw_grip *grip)
{
    return &grip->ledger;
}

const fw_grip_ledger *fw_grip_observe_ledger(const fw_grip *grip)
{
    return &grip->ledger;
}

fw_status fw_grip_set_drive(fw_grip *grip, const fw_drive *drive, fw_error *error)
{
    FW_TRY(fw_drive_check(drive, "grip", grip->name, error));
    grip->drive = *drive;
    return FW_OK;
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

static fw_vec2 centre_of(const fw_grip *grip, const fw_solid *solid)
{
    fw_vec2 sum = {0, 0};
    for (int n = 0; n < grip->count; ++n)
        sum = fw_vec2_add(sum, fw_solid_position(solid, grip->particles[n]));
    return fw_vec2_scale(1.0 / grip->count, sum);
}

fw_vec2 fw_grip_displacement(fw_grip *grip, const fw_solid *solid, double time)
{
    fw_solid_predict(solid, grip->particles, grip->count, grip->predictions);
    const block sum = add_up(grip);
    return fw_drive_solve(&grip->drive, sum.inertia, sum.push, grip->ledger.displacement, time,
                          solid->tick);
}

fw_sym2 fw_grip_mobility(const fw_grip *grip)
{
    return fw_drive_mobility(&grip->drive, add_up(grip).inertia);
}

fw_vec2 fw_grip_inertial(const fw_grip *grip, fw_vec2 displacement)
{
    const fw_drive *drive = &grip->drive;
    fw_sym2 inertia = {0, 0, 0};
    fw_vec2 push = {0, 0};
    for (int n = 0; n < grip->count; ++n) {
        const fw_sym2 inverse = fw_sym2_invert(grip->predictions[n].mobility);
        inertia = fw_sym2_add(inertia, inverse);
        push = fw_vec2_add(push, fw_sym2_apply(inverse, grip->predictions[n].inertial));
    }
    const fw_vec2 own = fw_sym2_apply(fw_sym2_invert(inertia), push);
    return (fw_vec2){drive->prescribed_x ? displacement.x : own.x,
                     drive->prescribed_y ? displacement.y : own.y};
}

void fw_grip_constrain(fw_grip *grip, const fw_solid *solid, fw_vec2 w, fw_constraint *constraints)
{
    const fw_vec2 centre = centre_of(grip, solid);
    fw_grip_ledger *ledger = &grip->ledger;
    fw_vec2 total = {0, 0};
    ledger->torque = 0;
    for (int n = 0; n < grip->count; ++n) {
        fw_vec2 force = fw_sym2_apply(fw_sym2_invert(grip->predictions[n].mobility),
                                      fw_vec2_subtract(w, grip->predictions[n].displacement));
        constraints[n] = (fw_constraint){grip->particles[n], w, force};
        fw_vec2 arm = fw_vec2_subtract(fw_solid_position(solid, grip->particles[n]), centre);
        ledger->torque += fw_vec2_cross(arm, force);
        total = fw_vec2_add(total, force);
    }
    ledger->reaction = fw_vec2_scale(0.5, fw_vec2_add(total, ledger->force));
    ledger->force = total;
    ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(solid->tick, total));
    ledger->work += fw_vec2_dot(total, w);
    ledger->displacement = fw_vec2_add(ledger->displacement, w);
    ledger->path_length = fw_vec2_add(ledger->path_length, (fw_vec2){fabs(w.x), fabs(w.y)});
}

void fw_grip_book_contact(fw_grip *grip, fw_vec2 force, fw_vec2 displacement, double tick)
{
    fw_grip_ledger *ledger = &grip->ledger;
    ledger->force = fw_vec2_subtract(ledger->force, force);
    ledger->reaction = fw_vec2_subtract(ledger->reaction, fw_vec2_scale(0.5, force));
    ledger->impulse = fw_vec2_subtract(ledger->impulse, fw_vec2_scale(tick, force));
    ledger->work -= fw_vec2_dot(force, displacement);
}

int fw_grip_carry(const fw_grip *grip, int owner, double time, double tick, fw_carry *carries)
{
    const fw_drive *drive = &grip->drive;
    if (!drive->prescribed_x && !drive->prescribed_y) return 0;
    const fw_vec2 velocity = fw_drive_velocity(drive, time, tick);
    for (int n = 0; n < grip->count; ++n)
        carries[n] = (fw_carry){.particle = grip->particles[n],
                                .owner = owner,
                                .x = drive->prescribed_x,
                                .y = drive->prescribed_y,
                                .velocity = velocity};
    return grip->count;
}

void fw_grip_book_carry(fw_grip *grip, const fw_carry *carry, double tick)
{
    fw_grip_ledger *ledger = &grip->ledger;
    const fw_vec2 force = fw_vec2_scale(1 / tick, carry->impulse);
    ledger->force = fw_vec2_add(ledger->force, force);
    ledger->reaction = fw_vec2_add(ledger->reaction, fw_vec2_scale(0.5, force));
    ledger->impulse = fw_vec2_add(ledger->impulse, carry->impulse);
    ledger->work += carry->work;
}
