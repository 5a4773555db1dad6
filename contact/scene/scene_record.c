/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_record.c - what contact has done to each particle, for pictures and files: the forces of
 * the last two moves, and heat and steps of friction since the beginning. No step depends on it.
 * State: both. Start reading at scene_record_forces(), and at scene_record_rub(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fw_scene_keep_forces(fw_scene *scene)
{
    scene->keeps_forces = true;
}

static bool rubs(const scene_body *body)
{
    return body->memory || (body->edge && body->edge->rubs);
}

static fw_status make_felt(scene_body *body, fw_error *error)
{
    const size_t count = (size_t)body->solid->count;
    scene_felt *felt = calloc(1, sizeof *felt);
    body->felt = felt;
    if (felt) {
        felt->now = calloc(count, sizeof *felt->now);
        felt->before = calloc(count, sizeof *felt->before);
        felt->now_list = calloc(count, sizeof *felt->now_list);
        felt->before_list = calloc(count, sizeof *felt->before_list);
    }
    if (!felt || !felt->now || !felt->before || !felt->now_list || !felt->before_list)
        return fw_fail_memory(error, "the forces of contact");
    return FW_OK;
}

fw_status scene_make_records(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        if (scene->keeps_forces) FW_TRY(make_felt(body, error));
        if (!rubs(body)) continue;
        body->rubbed = calloc((size_t)body->solid->count, sizeof *body->rubbed);
        if (!body->rubbed) return fw_fail_memory(error, "the heat of friction");
    }
    return FW_OK;
}

void scene_destroy_records(scene_body *body)
{
    free(body->rubbed);
    if (!body->felt) return;
    free(body->felt->now);
    free(body->felt->before);
    free(body->felt->now_list);
    free(body->felt->before_list);
    free(body->felt);
}

void scene_list_records(scene_body *body, fw_state_list *list)
{
    const size_t count = (size_t)body->solid->count;
    if (body->felt) fw_state_list_add(list, "contact-force", FW_F64, 2 * count, body->felt->now);
    if (body->rubbed)
        fw_state_list_add(list, "rubbed", FW_F64, count * sizeof *body->rubbed / sizeof(double),
                          body->rubbed);
}

void scene_restore_records(scene_body *body)
{
    scene_felt *felt = body->felt;
    if (!felt) return;
    for (int k = 0; k < felt->before_count; ++k)
        felt->before[felt->before_list[k]] = (fw_vec2){0, 0};
    felt->before_count = felt->now_count = 0;
    for (int i = 0; i < body->solid->count; ++i)
        if (felt->now[i].x != 0 || felt->now[i].y != 0) felt->now_list[felt->now_count++] = i;
}

/* --- forces --- */

/* What was felt in the last move becomes what was felt before. */
static void turn_over(scene_felt *felt)
{
    for (int k = 0; k < felt->before_count; ++k)
        felt->before[felt->before_list[k]] = (fw_vec2){0, 0};
    for (int k = 0; k < felt->now_count; ++k) {
        const int i = felt->now_list[k];
        felt->before[i] = felt->now[i];
        felt->now[i] = (fw_vec2){0, 0};
        felt->before_list[k] = i;
    }
    felt->before_count = felt->now_count;
    felt->now_count = 0;
}

/* Of a body whose colours move in turn, each particle moves once in a step of two ticks. */
void scene_record_forces(fw_scene *scene, int number)
{
    scene_body *body = &scene->bodies[number];
    scene_felt *felt = body->felt;
    if (!felt) return;
    if (scene->clock.ticks % body->solid->model->ticks_per_step == 0) turn_over(felt);
    for (int n = 0; n < body->constraint_count; ++n) {
        const fw_constraint *c = &body->constraints[n];
        if (c->force.x == 0 && c->force.y == 0) continue;
        felt->now[c->particle] = c->force;
        felt->now_list[felt->now_count++] = c->particle;
    }
}

void fw_scene_add_contact_forces(const fw_scene *scene, int number, double *x, double *y)
{
    const scene_body *body = &scene->bodies[number];
    const scene_felt *felt = body->felt;
    if (!felt) {
        for (int n = 0; n < body->constraint_count; ++n) {
            x[body->constraints[n].particle] += body->constraints[n].force.x;
            y[body->constraints[n].particle] += body->constraints[n].force.y;
        }
        return;
    }
    for (int k = 0; k < felt->now_count; ++k) {
        x[felt->now_list[k]] += 0.5 * felt->now[felt->now_list[k]].x;
        y[felt->now_list[k]] += 0.5 * felt->now[felt->now_list[k]].y;
    }
    for (int k = 0; k < felt->before_count; ++k) {
        x[felt->before_list[k]] += 0.5 * felt->before[felt->before_list[k]].x;
        y[felt->before_list[k]] += 0.5 * felt->before[felt->before_list[k]].y;
    }
}

/* --- friction --- */

static double this_tick(const fw_scene *scene)
{
    return (double)scene->clock.ticks + 1;
}

/* Sticking ends where it slides, and where it loses touch. */
static void count_sticking(const fw_scene *scene, scene_body *body, int particle, bool slid)
{
    scene_rubbed *rubbed = &body->rubbed[particle];
    const double now = this_tick(scene);
    const bool goes_on = now - rubbed->last <= body->solid->model->ticks_per_step;
    rubbed->stuck = slid ? 0 : goes_on ? rubbed->stuck + (now - rubbed->last) : 1;
    rubbed->last = now;
}

int fw_scene_count_stuck(const fw_scene *scene, int number, int first, int count)
{
    const scene_body *body = &scene->bodies[number];
    const int ticks = body->solid->model->ticks_per_step;
    const double now = (double)scene->clock.ticks;
    int stuck = 0;
    for (int i = first; body->rubbed && i < first + count; ++i)
        stuck += now - body->rubbed[i].last < ticks &&
                 body->rubbed[i].stuck >= FW_SCENE_STUCK_STEPS * scene->ticks_per_step;
    return stuck;
}

static void add_rub(scene_body *body, int particle, double share, double heat, bool slid)
{
    scene_rubbed *rubbed = &body->rubbed[particle];
    rubbed->heat += heat;
    rubbed->steps += share;
    if (slid) rubbed->sliding += share;
}

/* The particles of a row, and how much of what happens on its second side comes to each. */
typedef struct rubbing_row {
    scene_body *body, *other;
    int point, from, to; /* particles */
    double part;         /* of `to`; the rest is that of `from` */
} rubbing_row;

static rubbing_row particles_of(fw_scene *scene, const scene_row *row, const fw_joint_rub *rub)
{
    scene_body *body = &scene->bodies[row->point_body], *other = &scene->bodies[row->body];
    return (rubbing_row){.body = body,
                         .other = other,
                         .point = body->edge->contour.particles[row->point],
                         .from = other->edge->contour.particles[row->from],
                         .to = other->edge->contour.particles[row->to],
                         .part = sqrt(fw_vec2_dot(rub->weight[2], rub->weight[2]))};
}

void scene_record_hold(fw_scene *scene, const scene_row *row, const fw_joint_rub *rub)
{
    const rubbing_row r = particles_of(scene, row, rub);
    if (!rub->stuck) return;
    r.body->rubbed[r.point].held = this_tick(scene);
    if (r.part < 1) r.other->rubbed[r.from].held = this_tick(scene);
    if (r.part > 0) r.other->rubbed[r.to].held = this_tick(scene);
}

/* Points of one face may be at their bound while those of the other hold the place: it slides
 * where all of its rows do. */
static bool slides(const fw_scene *scene, const scene_body *body, int particle)
{
    return body->rubbed[particle].held != this_tick(scene);
}

/* The heat is shared by the two bodies: half of it comes to the point, half to the ends of the
 * segment, by how near they are. */
void scene_record_rub(fw_scene *scene, const scene_row *row, const fw_joint_rub *rub)
{
    const rubbing_row r = particles_of(scene, row, rub);
    const double heat = -rub->traction * rub->slip;
    if (heat == 0 && !(rub->limit > 0)) return;
    add_rub(r.body, r.point, 1, 0.5 * heat, slides(scene, r.body, r.point));
    count_sticking(scene, r.body, r.point, slides(scene, r.body, r.point));
    if (r.part < 1)
        add_rub(r.other, r.from, 1 - r.part, 0.5 * (1 - r.part) * heat,
                slides(scene, r.other, r.from));
    if (r.part > 0)
        add_rub(r.other, r.to, r.part, 0.5 * r.part * heat, slides(scene, r.other, r.to));
}

/* A wall has no particles: all of the heat comes to that of the body. */
void scene_record_rub_on_walls(const fw_scene *scene, scene_body *body,
                               const scene_contact *contact)
{
    double heat = 0, cone = 0;
    if (!body->rubbed) return;
    for (int n = 0; n < contact->solution.wall_contact_count; ++n) {
        heat += contact->solution.wall_contact[n].dissipated;
        cone += contact->solution.wall_contact[n].cone;
    }
    if (!(cone > 0) && heat == 0) return;
    const bool slid = !body->memory[contact->particle].stuck;
    add_rub(body, contact->particle, 1, heat, slid);
    count_sticking(scene, body, contact->particle, slid);
}

/* --- as fields --- */

static void fill_heat(const scene_rubbed *rubbed, int count, double *values)
{
    for (int i = 0; i < count; ++i) values[i] = rubbed[i].heat;
}

static void fill_rubbing(const scene_rubbed *rubbed, int count, double *values)
{
    for (int i = 0; i < count; ++i) values[i] = rubbed[i].steps;
}

static void fill_sliding(const scene_rubbed *rubbed, int count, double *values)
{
    for (int i = 0; i < count; ++i) values[i] = rubbed[i].sliding;
}

/* clang-format off */
const fw_contact_field fw_contact_fields[FW_CONTACT_FIELDS + 1] = {
    {FW_FIELD_HEAT, "energy", "heat of friction at the particle since the start: all of it at a wall, half of it between bodies", fill_heat},
    {FW_FIELD_RUBBING, "1", "steps since the start in which the particle was pressed on what rubs it; of a face, by its share", fill_rubbing},
    {FW_FIELD_SLIDING, "1", "steps of `rubbing` in which it slid, and nothing that touches it stuck to it", fill_sliding},
    {NULL, NULL, NULL, NULL}};
/* clang-format on */

const fw_contact_field *fw_scene_find_field(const fw_scene *scene, int body, const char *name)
{
    if (!scene->bodies[body].rubbed) return NULL;
    for (const fw_contact_field *field = fw_contact_fields; field->name; ++field)
        if (strcmp(field->name, name) == 0) return field;
    return NULL;
}

void fw_scene_fill_field(const fw_scene *scene, int body, const fw_contact_field *field,
                         double *values)
{
    field->fill(scene->bodies[body].rubbed, scene->bodies[body].solid->count, values);
}
