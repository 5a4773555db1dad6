/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_forces.c - forces against all pairs one by one, in plain formulas; and the same
 * bytes for all lists and instruction sets. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include "core/instruction_set.h"
#include "core/particles/neighbour_lists.h"

#include <string.h>

enum { BODIES = 3 };

/* Three bodies that touch: a crystal, one that is shaken beyond recognition and numbered at random,
 * and a turned one. */
static fw_solid *bodies_of(const fw_particle_group_def *kind, fw_pair_potential potential)
{
    fw_crowd crowd[BODIES] = {crowd_rectangle(15, 13, (fw_vec2){0, 0}, 1, 0.08, 31),
                              crowd_rectangle(14, 12, (fw_vec2){15, 0.2}, 1, 0.2, 32),
                              crowd_disc(7, (fw_vec2){36.1, 5}, 0.4, 0.1, 33)};
    const fw_crowd *shaken = &crowd[1];
    for (int i = shaken->count - 1; i > 0; --i) {
        const double drawn = fw_noise_uniform(5, (uint32_t)i, 0, 1).x;
        const int j = (int)((i + 1) * 0.5 * (drawn + 1));
        const fw_vec2 swapped = shaken->at[i];
        shaken->at[i] = shaken->at[j];
        shaken->at[j] = swapped;
    }
    const char *const names[BODIES] = {"crystal", "shaken", "turned"};
    fw_particle_group_def groups[BODIES];
    for (int g = 0; g < BODIES; ++g) {
        groups[g] = kind[g];
        groups[g].name = names[g];
        groups[g].count = crowd[g].count;
        groups[g].positions = crowd[g].at;
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = BODIES;
    def.potential = potential;
    def.strength_across = 0.7;
    def.overlap_energy = INFINITY;
    def.controls = (fw_langevin_controls){1e-3, 0.5, 0.3};
    def.seed = 99;
    fw_solid *solid;
    fw_error error = {0};
    if (fw_particles_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    for (int g = 0; g < BODIES; ++g) free(crowd[g].at);
    return solid;
}

/* What all pairs do to one particle, and how large the terms were. */
typedef struct fw_plain_sums {
    fw_vec2 force, first, second;
    fw_phase sum;
    double size;
} fw_plain_sums;

static fw_plain_sums sums_of(const fw_solid *solid, const fw_pair_potential *potential, int i)
{
    const int own = fw_particles_group_of(solid, i);
    const fw_particle_group *group = fw_particles_group(solid, own);
    fw_plain_sums sums = {.size = 0};
    for (int j = 0; j < solid->count; ++j) {
        if (j == i) continue;
        const double dx = solid->x[i] - solid->x[j], dy = solid->y[i] - solid->y[j];
        const double r2 = dx * dx + dy * dy;
        const bool same = fw_particles_group_of(solid, j) == own;
        const double push = (same ? group->strength : 0.7) * fw_pair_at(potential, r2).push;
        sums.force = fw_vec2_add(sums.force, (fw_vec2){push * dx, push * dy});
        sums.size += fabs(push) * sqrt(r2);
        if (!same) continue;
        const fw_return_pair pair =
            fw_return_pair_at(&group->return_force, group->axes, dx, dy, r2);
        sums.first = fw_vec2_add(sums.first, pair.first);
        sums.second = fw_vec2_add(sums.second, pair.second);
        sums.sum = (fw_phase){sums.sum.cosine + pair.sum.cosine, sums.sum.sine + pair.sum.sine};
        sums.size += hypot(pair.first.x, pair.first.y) + hypot(pair.second.x, pair.second.y);
    }
    return sums;
}

static void assert_plain_forces(const fw_solid *solid, const fw_pair_potential *potential)
{
    const fw_langevin *motion = (const fw_langevin *)solid;
    for (int g = 0; g < BODIES; ++g) {
        const fw_particle_group *group = fw_particles_group(solid, g);
        fw_phase sum = {0, 0};
        for (int i = group->first; i < group->first + group->count; ++i) {
            const fw_phase part = sums_of(solid, potential, i).sum;
            sum = (fw_phase){sum.cosine + part.cosine, sum.sine + part.sine};
        }
        const fw_turn turn = fw_return_turn(group->return_force.axes, sum);
        for (int i = group->first; i < group->first + group->count; ++i) {
            const fw_plain_sums sums = sums_of(solid, potential, i);
            const double x = sums.force.x + turn.first * sums.first.x + turn.second * sums.second.x;
            const double y = sums.force.y + turn.first * sums.first.y + turn.second * sums.second.y;
            assert_below(hypot(motion->force_x[i] - x, motion->force_y[i] - y), 2e-13 * sums.size);
        }
    }
}

static fw_particle_group_def kind_of(fw_return_force force, double strength)
{
    fw_particle_group_def kind = fw_particle_group_def_default();
    kind.return_force = force;
    kind.strength = strength;
    return kind;
}

static fw_return_force turned(fw_return_force force, double angle)
{
    force.angle = angle;
    return force;
}

/* All axes, both variants, folds of each kind, both potentials with long and short cuts. */
static void forces_are_those_of_the_plain_formulas(void **state)
{
    (void)state;
    const fw_return_variant soft = FW_RETURN_CONSERVATIVE, even = FW_RETURN_CONSTANT;
    const fw_particle_group_def kinds[][BODIES] = {
        {kind_of(return_force_of(6, 1, FW_AXES_LAB, soft), 1),
         kind_of(return_force_of(6, 0, FW_AXES_LAB, soft), 1.3),
         kind_of(turned(return_force_of(6, 0.8, FW_AXES_LAB, soft), 0.3), 0.9)},
        {kind_of(return_force_of(6, 1, FW_AXES_COROTATING, soft), 1),
         kind_of(turned(return_force_of(4, 0.7, FW_AXES_SURFACE, soft), 0.2), 1.3),
         kind_of(return_force_of(8, 0.5, FW_AXES_COROTATING, even), 0)},
        {kind_of(return_force_of(4, 1, FW_AXES_LAB, even), 1),
         kind_of(return_force_of(12, 0.3, FW_AXES_LAB, soft), 1),
         kind_of(return_force_of(6, 0.5, FW_AXES_SURFACE, even), 1)},
    };
    fw_pair_potential potentials[4];
    for (int p = 0; p < 4; ++p) {
        potentials[p] = fw_pair_potential_default();
        potentials[p].kind = p % 2 ? FW_MORSE : FW_LENNARD_JONES;
    }
    potentials[2].cut = fw_smooth_cut_over(1.5, 1.5);
    potentials[3].cut = fw_smooth_cut_over(1.2, 2.6);
    potentials[3].distance = 1.1;
    fw_error error;
    const int before = fw_instruction_set();
    for (int set = 0; set < FW_INSTRUCTION_SETS; ++set) {
        if (fw_instruction_set_use(fw_instruction_set_name(set), &error) != FW_OK) continue;
        for (int p = 0; p < 4; ++p)
            for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) {
                fw_solid *solid = bodies_of(kinds[k], potentials[p]);
                assert_plain_forces(solid, &potentials[p]);
                fw_solid_destroy(solid);
            }
    }
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(before), &error), FW_OK);
}

/* A cut that ends without fading has a loop of its own, without return forces. */
typedef struct fw_potential_case {
    fw_pair_kind kind;
    fw_smooth_cut cut;
    double amplitude; /* of the crystal's return force */
} fw_potential_case;

static uint64_t fingerprint_after(int set, double favour, const fw_potential_case *potential)
{
    fw_error error;
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), &error), FW_OK);
    const fw_particle_group_def kinds[BODIES] = {
        kind_of(return_force_of(6, potential->amplitude, FW_AXES_LAB, FW_RETURN_CONSERVATIVE), 1),
        kind_of(return_force_of(4, 0.7, FW_AXES_SURFACE, FW_RETURN_CONSTANT), 1.3),
        kind_of(return_force_of(6, 0.5, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE), 1)};
    fw_pair_potential rule = fw_pair_potential_default();
    rule.kind = potential->kind;
    rule.cut = potential->cut;
    fw_solid *solid = bodies_of(kinds, rule);
    fw_neighbour_lists_favour((fw_neighbour_lists *)fw_particles_neighbours(solid), favour);
    for (int step = 0; step < 60; ++step) advance_free(solid);
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    uint64_t hash = fw_state_list_hash(&list);
    double *energies = malloc((size_t)solid->count * sizeof *energies);
    fw_particles_pair_energies(solid, energies);
    fw_tensor virial = fw_particles_virial(solid, -1);
    fw_state_list read = {0};
    fw_state_list_add(&read, "energies", FW_F64, (size_t)solid->count, energies);
    fw_state_list_add(&read, "virial", FW_F64, 4, &virial);
    hash ^= 3 * fw_state_list_hash(&read);
    free(energies);
    fw_solid_destroy(solid);
    return hash;
}

/* Every width of vectors, offset slots only, gather slots only, and both. */
static void bytes_depend_neither_on_instructions_nor_on_slots(void **state)
{
    (void)state;
    const double favours[] = {2.5, 0, INFINITY};
    const fw_smooth_cut fades = fw_pair_potential_default().cut;
    const fw_potential_case cases[] = {{FW_LENNARD_JONES, fades, 1},
                                       {FW_MORSE, fades, 1},
                                       {FW_LENNARD_JONES, fades, 0},
                                       {FW_LENNARD_JONES, fw_smooth_cut_over(1.5, 1.5), 0}};
    const int before = fw_instruction_set();
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        const uint64_t hash = fingerprint_after(0, 2.5, &cases[n]);
        for (int set = 0; set < FW_INSTRUCTION_SETS; ++set)
            for (int f = 0; f < 3 && fw_instruction_set_runs(set); ++f)
                assert_true(fingerprint_after(set, favours[f], &cases[n]) == hash);
    }
    fw_error error;
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(before), &error), FW_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_those_of_the_plain_formulas),
        cmocka_unit_test(bytes_depend_neither_on_instructions_nor_on_slots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
