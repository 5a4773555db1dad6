/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_observe.c - what a scene reports. Keeps no state; changes nothing but the caller's
 * arrays. */
#include "scene_parts.h"

int64_t fw_scene_steps(const fw_scene *scene)
{
    return scene->clock.step;
}

double fw_scene_time(const fw_scene *scene)
{
    return (double)scene->clock.ticks * scene->tick;
}

int fw_scene_body_count(const fw_scene *scene)
{
    return scene->body_count;
}

fw_solid *fw_scene_body(fw_scene *scene, int body)
{
    return scene->bodies[body].solid;
}

const fw_solid *fw_scene_observe_body(const fw_scene *scene, int body)
{
    return scene->bodies[body].solid;
}

int fw_scene_wall_count(const fw_scene *scene)
{
    return scene->wall_count;
}

const fw_wall *fw_scene_wall(const fw_scene *scene, int wall)
{
    return scene->walls[wall].wall;
}

fw_vec2 fw_scene_wall_displacement(const fw_scene *scene, int wall)
{
    const scene_wall *found = &scene->walls[wall];
    if (found->piston) return fw_piston_observe_ledger(found->piston)->displacement;
    return fw_wall_displacement(found->wall, fw_scene_time(scene));
}

fw_piston *fw_scene_piston(fw_scene *scene, int wall)
{
    return scene->walls[wall].piston;
}

const fw_piston *fw_scene_observe_piston(const fw_scene *scene, int wall)
{
    return scene->walls[wall].piston;
}

int fw_scene_grip_count(const fw_scene *scene)
{
    return scene->grip_count;
}

fw_grip *fw_scene_grip(fw_scene *scene, int grip)
{
    return scene->grips[grip].grip;
}

const fw_grip *fw_scene_observe_grip(const fw_scene *scene, int grip)
{
    return scene->grips[grip].grip;
}

const fw_wall_ledger *fw_scene_wall_ledger(const fw_scene *scene, int wall)
{
    return &scene->ledgers[wall];
}

fw_ledger fw_scene_ledger(const fw_scene *scene)
{
    fw_ledger ledger = {.energy_at_start = scene->energy_at_start,
                        .momentum_at_start = scene->momentum_at_start};
    for (int b = 0; b < scene->body_count; ++b) {
        const fw_solid_ledger *solid = &scene->bodies[b].solid->ledger;
        ledger.external_work += solid->work;
        ledger.dissipated += solid->dissipated;
        ledger.thermostat_heat += solid->heat;
        ledger.external_impulse = fw_vec2_add(ledger.external_impulse, solid->impulse);
        ledger.drag = fw_vec2_add(ledger.drag, solid->drag);
    }
    for (int w = 0; w < scene->wall_count; ++w) {
        ledger.wall_work += scene->ledgers[w].work;
        ledger.wall_stored += scene->ledgers[w].stored;
        ledger.friction_heat += scene->ledgers[w].dissipated;
        ledger.wall_impulse = fw_vec2_add(ledger.wall_impulse, scene->ledgers[w].impulse);
    }
    if (scene->joint) ledger.friction_heat += scene->joint->ledger.heat;
    for (int n = 0; n < scene->grip_count; ++n) {
        const fw_grip_ledger *grip = fw_grip_observe_ledger(scene->grips[n].grip);
        ledger.grip_work += grip->work;
        ledger.grip_impulse = fw_vec2_add(ledger.grip_impulse, grip->impulse);
    }
    return ledger;
}

fw_energies fw_scene_energies(const fw_scene *scene)
{
    fw_energies sum = {0, 0};
    for (int b = 0; b < scene->body_count; ++b) {
        fw_energies energies = fw_solid_energies(scene->bodies[b].solid);
        sum.kinetic += energies.kinetic;
        sum.elastic += energies.elastic;
    }
    return sum;
}

fw_vec2 fw_scene_momentum(const fw_scene *scene)
{
    fw_vec2 sum = {0, 0};
    for (int b = 0; b < scene->body_count; ++b)
        sum = fw_vec2_add(sum, fw_solid_momentum(scene->bodies[b].solid));
    return sum;
}

int64_t fw_scene_unresolved(const fw_scene *scene)
{
    return scene->clock.unresolved;
}

double fw_scene_penetration(const fw_scene *scene, int body)
{
    double deepest = 0;
    for (int w = 0; w < scene->wall_count; ++w) {
        fw_vec2 place = fw_scene_wall_displacement(scene, w);
        for (int b = 0; b < scene->body_count; ++b) {
            const fw_solid *solid = scene->bodies[b].solid;
            if (body >= 0 && b != body) continue;
            for (int n = 0; n < solid->boundary_count; ++n) {
                fw_vec2 at = fw_solid_position(solid, solid->boundary[n]);
                deepest = fmax(deepest, fw_wall_depth(scene->walls[w].wall, at, place));
            }
        }
    }
    return deepest;
}

void fw_scene_mark_held(const fw_scene *scene, int body, uint8_t *held)
{
    const uint8_t *gripped = scene->bodies[body].gripped;
    for (int i = 0; gripped && i < scene->bodies[body].solid->count; ++i)
        held[i] |= gripped[i] != 0;
}

long fw_scene_query_count(const fw_scene *scene)
{
    long count = 0;
    for (int b = 0; b < scene->body_count; ++b)
        if (scene->bodies[b].boundary) count += fw_boundary_query_count(scene->bodies[b].boundary);
    return count;
}

double fw_ledger_energy(const fw_ledger *l)
{
    return l->energy_at_start + l->external_work + l->wall_work + l->grip_work - l->dissipated -
           l->friction_heat + l->thermostat_heat - l->wall_stored;
}

fw_vec2 fw_ledger_momentum(const fw_ledger *l)
{
    fw_vec2 rigid = fw_vec2_add(l->wall_impulse, l->grip_impulse);
    fw_vec2 loads = fw_vec2_add(l->external_impulse, l->drag);
    return fw_vec2_add(l->momentum_at_start, fw_vec2_add(rigid, loads));
}
