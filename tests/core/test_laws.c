/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_laws.c - the same laws asked of every solid: momentum, energy, free translation, the ledger,
 * static equilibrium, wave speed, walls, restart, threads, instructions. What a solid keeps only up
 * to the error of its time step says so in its row of tests/support/solids.h. */
#include "tests/support/laws.h"

#include "contact/scene/scene.h"
#include "core/instruction_set.h"
#include "tests/support/solids.h"
#include "tests/support/standing_wave.h"
#include "tests/support/steps.h"

#include <omp.h>
#include <string.h>

/* --- the laws --- */

static void free_bodies_keep_momentum(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 9, 8, 0);
        const fw_vec2 before = fw_solid_momentum(solid);
        const double scale = solid->model->mass(solid).xx * kinds[k].transverse;
        const int ticks = ticks_for(&kinds[k], solid, 300);
        for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
        const fw_vec2 after = fw_solid_momentum(solid);
        if (!(hypot(after.x - before.x, after.y - before.y) < 1e-13 * scale))
            fail_msg("%s: momentum off by %g of %g", kinds[k].name,
                     hypot(after.x - before.x, after.y - before.y), scale);
        fw_solid_destroy(solid);
    }
}

static void free_bodies_keep_energy(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid = shaken(&kinds[k], 9, 8, 0);
        const double before = energy_of(solid);
        start at_rest = rectangle(&kinds[k], 9, 8);
        fw_solid *still = made(&kinds[k], &at_rest);
        const double ringing = before - (kinds[k].binds ? energy_of(still) : 0);
        double worst = 0;
        const int ticks = ticks_for(&kinds[k], solid, 300);
        for (int tick = 0; tick < ticks; ++tick) {
            advance_free(solid);
            if (tick % solid->model->ticks_per_step == solid->model->ticks_per_step - 1)
                worst = fmax(worst, fabs(energy_of(solid) - before) / ringing);
        }
        if (!(worst < kinds[k].energy_error))
            fail_msg("%s: energy off by %g, expected below %g", kinds[k].name, worst,
                     kinds[k].energy_error);
        fw_solid_destroy(solid);
        fw_solid_destroy(still);
    }
}

/* What the particles share of the momentum adds up to it: about another point the angular momentum
 * is another by the distance times the momentum. */
static void angular_momentum_goes_with_the_place(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *solid[2];
        for (int n = 0; n < 2; ++n) {
            start s = rectangle(&kinds[k], 5, 4);
            shake(&s, 0.02, 0.02);
            s.lattice.origin = n == 0 ? (fw_vec2){0, 0} : (fw_vec2){8, -4};
            for (int p = 0; p < s.sites.count; ++p) s.velocity[p].x += 0.05;
            solid[n] = made(&kinds[k], &s);
        }
        for (int tick = 0; tick < 5; ++tick) {
            const double here = fw_solid_angular_momentum(solid[0], 0, solid[0]->count);
            const double there = fw_solid_angular_momentum(solid[1], 0, solid[1]->count);
            const double expected = fw_vec2_cross((fw_vec2){8, -4}, fw_solid_momentum(solid[0]));
            if (!(fabs(there - here - expected) < 1e-12 * fabs(expected)))
                fail_msg("%s, tick %d: angular momentum larger by %g, expected %g", kinds[k].name,
                         tick, there - here, expected);
            for (int n = 0; n < 2; ++n) advance_free(solid[n]);
        }
        for (int n = 0; n < 2; ++n) fw_solid_destroy(solid[n]);
    }
}

static void rigid_motion_does_not_ring(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 7, 6);
        s.lattice.origin = (fw_vec2){3, -2};
        for (int p = 0; p < s.sites.count; ++p) s.velocity[p] = (fw_vec2){0.03, -0.02};
        fw_solid *solid = made(&kinds[k], &s);
        const fw_vec2 begin = solid->model->centre_of_mass(solid);
        const double elastic = fw_solid_energies(solid).elastic;
        const double kinetic = fw_solid_energies(solid).kinetic;
        const int ticks = ticks_for(&kinds[k], solid, 200);
        for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
        const fw_vec2 end = solid->model->centre_of_mass(solid);
        const double way = kinds[k].transverse * ticks * solid->tick;
        assert_close(end.x - begin.x, 0.03 * way, 1e-11);
        assert_close(end.y - begin.y, -0.02 * way, 1e-11);
        assert_below(fabs(fw_solid_energies(solid).elastic - elastic), 1e-11 * kinetic);
        fw_solid_destroy(solid);
    }
}

/* Gives these particles velocities, in one component or both; returns impulse and work. */
static fw_carry carry(fw_solid *solid, int first, int count, bool mixed, fw_vec2 velocity)
{
    fw_carry *carries = calloc((size_t)count, sizeof *carries), sum = {0};
    for (int n = 0; n < count; ++n) {
        const double by = mixed ? 0.01 * n : 0;
        carries[n] = (fw_carry){.particle = first + n,
                                .x = !mixed || n % 3 != 1,
                                .y = !mixed || n % 3 != 2,
                                .velocity = {velocity.x + by, velocity.y - by}};
    }
    solid->model->carry(solid, carries, count);
    for (int n = 0; n < count; ++n) {
        sum.impulse = fw_vec2_add(sum.impulse, carries[n].impulse);
        sum.work += carries[n].work;
    }
    free(carries);
    return sum;
}

static bool can_carry(const solid_kind *kind, const fw_solid *solid)
{
    return solid->model->carry && kind->make != make_displaced;
}

/* What is carried takes as much momentum and energy as is told, whoever is beside it. */
static void what_is_carried_takes_what_is_told(void **state)
{
    (void)state;
    int asked = 0;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 5, 4);
        shake(&s, 0.02, 0.02);
        fw_solid *solid = made(&kinds[k], &s);
        for (int tick = 0; tick < 6 && can_carry(&kinds[k], solid); ++tick) {
            const fw_vec2 momentum = fw_solid_momentum(solid);
            const fw_energies before = fw_solid_energies(solid);
            const fw_carry told = carry(solid, 2 * tick, 6, true, (fw_vec2){0.03, -0.02});
            const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), momentum);
            const fw_energies after = fw_solid_energies(solid);
            const double work = after.kinetic - before.kinetic + after.elastic - before.elastic;
            const double scale = after.kinetic + before.kinetic;
            if (!(fabs(gained.x - told.impulse.x) + fabs(gained.y - told.impulse.y) < 1e-14))
                fail_msg("%s: momentum grew by (%g, %g), told was (%g, %g)", kinds[k].name,
                         gained.x, gained.y, told.impulse.x, told.impulse.y);
            if (!(fabs(work - told.work) < 1e-12 * scale))
                fail_msg("%s: energy grew by %g, told was %g", kinds[k].name, work, told.work);
            advance_free(solid);
            asked += 1;
        }
        fw_solid_destroy(solid);
    }
    assert_true(asked >= 12);
}

/* A body at rest that is carried as a whole goes on evenly, as one that was made moving. */
static void a_body_that_is_carried_moves_evenly(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        start s = rectangle(&kinds[k], 5, 4);
        fw_solid *solid = made(&kinds[k], &s);
        if (can_carry(&kinds[k], solid)) {
            const fw_vec2 velocity = {0.03, -0.02};
            carry(solid, 0, solid->count, false, velocity);
            for (int tick = 0; tick < 6; ++tick) {
                const double x = solid->x[7], y = solid->y[7];
                advance_free(solid);
                if (!(fabs(solid->x[7] - x - velocity.x * solid->tick) < 1e-14 &&
                      fabs(solid->y[7] - y - velocity.y * solid->tick) < 1e-14))
                    fail_msg("%s, tick %d: went (%g, %g), expected (%g, %g)", kinds[k].name, tick,
                             solid->x[7] - x, solid->y[7] - y, velocity.x * solid->tick,
                             velocity.y * solid->tick);
            }
        }
        fw_solid_destroy(solid);
    }
}

static void ledger_balances_under_loads_and_damping(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int damped = 0; damped < 2; ++damped) {
            fw_solid *solid = shaken(&kinds[k], 8, 7, damped ? 0.05 : 0);
            const double before = energy_of(solid);
            const fw_vec2 p0 = fw_solid_momentum(solid);
            const double scale = solid->model->mass(solid).xx * kinds[k].transverse;
            const int ticks = ticks_for(&kinds[k], solid, 150);
            double moved = 0;
            for (int tick = 0; tick < ticks; ++tick) {
                if (tick % solid->model->ticks_per_step == 0)
                    push_at_random(solid, &kinds[k], 0.02);
                advance_free(solid);
                moved = fmax(moved, fabs(solid->ledger.work) + solid->ledger.dissipated);
            }
            const fw_solid_ledger *a = &solid->ledger;
            const double expected = before + a->work - a->dissipated + a->heat;
            const double error = fabs(energy_of(solid) - expected) / moved;
            if (!(error < 10 * kinds[k].energy_error))
                fail_msg("%s: energy off by %g of what passed", kinds[k].name, error);
            const fw_vec2 p = fw_solid_momentum(solid);
            assert_close(p.x, p0.x + a->impulse.x + a->drag.x, 1e-12 * scale);
            assert_close(p.y, p0.y + a->impulse.y + a->drag.y, 1e-12 * scale);
            assert_true(moved > 0 && (a->dissipated > 0) == (damped == 1));
            fw_solid_destroy(solid);
        }
}

/* Opposite forces on the outermost columns; how much longer the body is once it rests. */
static double stretch(const solid_kind *kind, double force, double loss)
{
    enum { COLUMNS = 8, ROWS = 5 };
    start s = rectangle(kind, COLUMNS, ROWS);
    s.loss = loss;
    fw_solid *solid = made(kind, &s);
    const double size = force * kind->transverse * kind->transverse * solid->model->mass(solid).xx;
    solid->loaded = true;
    for (int p = 0; p < solid->count; ++p)
        solid->external_x[p] = p % COLUMNS == 0             ? -size / ROWS
                               : p % COLUMNS == COLUMNS - 1 ? size / ROWS
                                                            : 0;
    const double length = solid->x[COLUMNS - 1] - solid->x[0];
    const int ticks = ticks_for(kind, solid, 40 / loss * 20);
    for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
    fw_vec2 here[COLUMNS * ROWS];
    for (int p = 0; p < solid->count; ++p) here[p] = fw_solid_position(solid, p);
    /* A load that has acted on black but not yet on white shows in the momentum between ticks. */
    fw_vec2 momentum = {0, 0};
    for (int tick = 0; tick < 10; ++tick) {
        momentum = fw_vec2_add(momentum, fw_solid_momentum(solid));
        advance_free(solid);
    }
    assert_below(hypot(momentum.x, momentum.y), 1e-11);
    for (int p = 0; p < solid->count; ++p) {
        assert_below(fabs(solid->x[p] - here[p].x), 1e-11);
        assert_below(fabs(solid->y[p] - here[p].y), 1e-11);
    }
    const double longer = solid->x[COLUMNS - 1] - solid->x[0] - length;
    fw_solid_destroy(solid);
    return longer;
}

static void pulled_bodies_rest_where_damping_has_no_say(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        const double slow = stretch(&kinds[k], 1e-3, 0.3), fast = stretch(&kinds[k], 1e-3, 0.5);
        const double twice = stretch(&kinds[k], 2e-3, 0.5);
        assert_true(slow > 0);
        if (!(fabs(slow / fast - 1) < 1e-8))
            fail_msg("%s: %.12g and %.12g longer", kinds[k].name, slow, fast);
        if (!(fabs(twice / fast / 2 - 1) < kinds[k].nonlinearity))
            fail_msg("%s: twice the force stretches %.10g as far", kinds[k].name, twice / fast);
    }
}

static double wave_speed(const solid_kind *kind, bool longitudinal)
{
    const standing_wave wave = {kind->lattice, longitudinal};
    start s = rectangle(kind, STANDING_COLUMNS, STANDING_ROWS);
    for (int p = 0; p < s.sites.count; ++p)
        s.displacement[p] = standing_wave_at(&wave, s.sites.site[p]);
    return standing_wave_speed(&wave, made(kind, &s));
}

static void long_waves_run_at_the_speed_of_sound(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int longitudinal = 0; longitudinal < 2; ++longitudinal) {
            const double expected = longitudinal ? kinds[k].longitudinal : kinds[k].transverse;
            const double found = wave_speed(&kinds[k], longitudinal == 1);
            print_message("%-22s %-12s %.5f of %.5f\n", kinds[k].name,
                          longitudinal ? "longitudinal" : "transverse", found, expected);
            assert_close(found / expected, 1, STANDING_ERROR);
        }
}

static void walls_hold_without_loss(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k)
        for (int slanted = 0; slanted < 2; ++slanted) {
            start s = rectangle(&kinds[k], 8, 7);
            s.lattice.origin = (fw_vec2){-3.3, 4};
            for (int p = 0; p < s.sites.count; ++p) s.velocity[p] = (fw_vec2){0.01, -0.04};
            fw_solid *solid = made(&kinds[k], &s);
            fw_scene *scene;
            fw_error error;
            int body;
            assert_int_equal(fw_scene_create(&scene, (fw_vec2){0, 0}, INFINITY, NULL), FW_OK);
            assert_int_equal(fw_scene_adopt_body(scene, "body", solid, &body, NULL), FW_OK);
            const fw_vec2 ends[] = {{-200, slanted ? -30 : 0}, {200, slanted ? 30 : 0}};
            fw_wall_def def = fw_wall_def_default();
            def.name = "floor";
            def.shape = FW_CHAIN;
            def.points = ends;
            def.point_count = 2;
            assert_int_equal(fw_scene_add_wall(scene, &def, NULL), FW_OK);
            if (fw_scene_begin(scene, &error) != FW_OK) fail_msg("%s", error.sentence);
            const double kinetic = fw_solid_energies(solid).kinetic, before = energy_of(solid);
            const fw_vec2 p0 = fw_solid_momentum(solid);
            const int steps = ticks_for(&kinds[k], solid, 250) / solid->model->ticks_per_step;
            double deepest = 0, worst = 0;
            for (int step = 0; step < steps; ++step) {
                assert_int_equal(fw_scene_step(scene, &error), FW_OK);
                deepest = fmax(deepest, fw_scene_penetration(scene, -1));
                worst = fmax(worst, fabs(energy_of(solid) - before) / kinetic);
            }
            const fw_vec2 gained = fw_vec2_subtract(fw_solid_momentum(solid), p0);
            const fw_vec2 normal = {slanted ? -0.14834045293024465 : 0,
                                    slanted ? 0.98893635286829761 : 1};
            assert_true(fw_scene_wall_ledger(scene, 0)->held > 0);
            assert_true(fw_vec2_dot(gained, normal) > 0);
            assert_close(fw_vec2_dot(gained, fw_vec2_turn(normal)), 0, 1e-12 * hypot(p0.x, p0.y));
            assert_true(deepest <= (slanted ? 4e-15 : 0));
            /* An impact rings with all frequencies, and Verlet's error is that of the fastest. */
            if (!(worst < fmax(1e-11, 10 * kinds[k].energy_error)))
                fail_msg("%s: energy off by %g", kinds[k].name, worst);
            fw_scene_destroy(scene);
        }
}

static void restored_bodies_go_on_to_the_bit(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        fw_solid *one = shaken(&kinds[k], 9, 8, 0.02), *other = shaken(&kinds[k], 9, 8, 0.02);
        fw_state_list from = {0}, to = {0};
        for (int tick = 0; tick < 101; ++tick) {
            push_at_random(one, &kinds[k], 0.02);
            advance_free(one);
            advance_free(other);
        }
        assert_true(energy_of(one) != energy_of(other)); /* at the same tick */
        one->model->state(one, &from);
        other->model->state(other, &to);
        assert_int_equal(from.count, to.count);
        for (int n = 0; n < from.count; ++n)
            memcpy(to.array[n].data, from.array[n].data,
                   from.array[n].count * fw_element_size(from.array[n].element));
        restore(other);
        assert_true(energy_of(one) == energy_of(other));
        assert_true(fw_solid_momentum(one).x == fw_solid_momentum(other).x);
        for (int tick = 0; tick < 51; ++tick) {
            push_at_random(one, &kinds[k], 0.02);
            push_at_random(other, &kinds[k], 0.02);
            advance_free(one);
            advance_free(other);
        }
        if (fw_state_list_hash(&from) != fw_state_list_hash(&to))
            fail_msg("%s: goes on otherwise", kinds[k].name);
        fw_solid_destroy(one);
        fw_solid_destroy(other);
    }
}

/* Of the state, and of what is measured. */
static uint64_t hash_with(const solid_kind *kind, int threads)
{
    omp_set_num_threads(threads);
    /* More cells of a colour, and chunks of particles, than one thread takes at a time. */
    const bool half = kind->lattice == FW_SQUARE;
    fw_solid *solid = shaken(kind, half ? 186 : 90, half ? 180 : 80, 0.02);
    for (int tick = 0; tick < 12; ++tick) {
        push_at_random(solid, kind, 0.02);
        advance_free(solid);
    }
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    const fw_energies e = fw_solid_energies(solid);
    const fw_vec2 p = fw_solid_momentum(solid), middle = solid->model->centre_of_mass(solid);
    double measured[] = {e.kinetic, e.elastic, p.x, p.y, middle.x, middle.y};
    fw_state_list_add(&list, "measured", FW_F64, 6, measured);
    const uint64_t hash = fw_state_list_hash(&list);
    fw_solid_destroy(solid);
    omp_set_num_threads(1);
    return hash;
}

/* Whatever kernels run. */
static void bytes_do_not_depend_on_instructions(void **state)
{
    (void)state;
    const int before = fw_instruction_set();
    fw_error error;
    for (int k = 0; k < KINDS; ++k) {
        uint64_t hash = 0;
        for (int set = 0; set < FW_INSTRUCTION_SETS; ++set) {
            const char *name = fw_instruction_set_name(set);
            if (!fw_instruction_set_runs(set)) continue;
            assert_int_equal(fw_instruction_set_use(name, &error), FW_OK);
            const uint64_t here = hash_with(&kinds[k], 1);
            if (set > 0 && here != hash) fail_msg("%s: other bytes with %s", kinds[k].name, name);
            hash = here;
        }
    }
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(before), &error), FW_OK);
}

static void bytes_do_not_depend_on_threads(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; ++k) {
        const uint64_t hash = hash_with(&kinds[k], 1);
        for (int threads = 2; threads <= 3; ++threads)
            if (hash_with(&kinds[k], threads) != hash)
                fail_msg("%s: other bytes with %d threads", kinds[k].name, threads);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_bodies_keep_momentum),
        cmocka_unit_test(free_bodies_keep_energy),
        cmocka_unit_test(angular_momentum_goes_with_the_place),
        cmocka_unit_test(rigid_motion_does_not_ring),
        cmocka_unit_test(what_is_carried_takes_what_is_told),
        cmocka_unit_test(a_body_that_is_carried_moves_evenly),
        cmocka_unit_test(ledger_balances_under_loads_and_damping),
        cmocka_unit_test(pulled_bodies_rest_where_damping_has_no_say),
        cmocka_unit_test(long_waves_run_at_the_speed_of_sound),
        cmocka_unit_test(walls_hold_without_loss),
        cmocka_unit_test(restored_bodies_go_on_to_the_bit),
        cmocka_unit_test(bytes_do_not_depend_on_threads),
        cmocka_unit_test(bytes_do_not_depend_on_instructions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
