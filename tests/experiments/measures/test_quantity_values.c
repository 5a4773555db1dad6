/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_values.c - energies, pressures, diffusion and waves of automata whose numbers are
 * known in closed form, or are none. */
#include "tests/support/laws.h"

#include "core/particles/langevin.h"
#include "tests/support/measured.h"

/* --- energy --- */

/* Four particles at .3 and six at .4, without deformation: m v^2/2 each. */
static void energy_per_particle_is_that_of_the_body_or_of_all(void **state)
{
    (void)state;
    begin("title: two\nmaterials: {m: {linear-lattice: {mass: 2}}}\n"
          "bodies:\n"
          "  a: {material: m, lattice: hexagonal, shape: {rectangle: [2, 2]}, velocity: [.3, 0]}\n"
          "  b: {material: m, lattice: hexagonal, shape: {rectangle: [3, 2]}, origin: [50, 0],\n"
          "    velocity: [0, -.4]}\n"
          "run: {steps: 1}\n");
    assert_close(value_of("energy-per-particle", 0, NULL), .09, 1e-14);
    assert_close(value_of("energy-per-particle", 1, NULL), .16, 1e-14);
    assert_close(value_of("energy-per-particle", -1, NULL), (4 * .09 + 6 * .16) / 10, 1e-14);
    end();
}

/* One of two particles runs into a soft wall, k = 100: at the deepest point all of its 1/2 is in
 * the wall, and it counts. The other one is at rest. */
static void energy_per_particle_of_the_scene_counts_soft_walls(void **state)
{
    (void)state;
    begin("title: thrown\nmaterials: {m: {movable-particles: {strength: 0}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {sites: [[0, 0]]}, origin: [5, .05], velocity: [0, -1]}\n"
          "  b: {material: m, shape: {sites: [[0, 0]]}, origin: [5, 5]}\n"
          "walls: {box: {box: [0, 0, 9, 9], surface: {penalty: 100}}}\n"
          "dynamics: {time-step: .002, strength-across: 0}\nrun: {steps: 1}\n");
    double least = 1;
    for (int step = 0; step < 220; ++step) {
        run_steps(1);
        least = fmin(least, value_of("energy-per-particle", 0, NULL));
        assert_close(value_of("energy-per-particle", -1, NULL), .25, 1e-3);
    }
    assert_close(least, 0, 1e-3);
    assert_close(value_of("energy-per-particle", 0, NULL), .5, 1e-3);
    end();
}

/* --- pressure: of what does not interact it is sum m v v over the area, v about the mean --- */

static void give_velocities(void)
{
    fw_solid *solid = solid_of_body(0);
    for (int i = 0; i < solid->count; ++i)
        fw_langevin_set_velocity(solid, i, (fw_vec2){i == 0 ? .5 : .8, i == 0 ? .2 : -.4});
}

/* Of three particles of mass 3 about their mean (.7, -.2): (-.2, .4) and twice (.1, -.2). */
static void expect_pressure(double area)
{
    const double sums[] = {.06, -.12, -.12, .24};
    give_velocities();
    for (int c = 0; c < 4; ++c)
        assert_close(value_of("pressure", 0, tensor_names[c]), 3 * sums[c] / area, 1e-13);
}

static void pressure_is_taken_over_the_area_that_a_body_was_given(void **state)
{
    (void)state;
    static const struct {
        const char *body;
        double area;
    } shapes[] = {
        {"shape: {rectangle: [3, 1]}, spacing: 1.25", 3 * 1.25 * 1.25},
        {"lattice: hexagonal, shape: {rectangle: [3, 1]}, spacing: 1.25",
         3 * 1.25 * 1.25 * 0.8660254037844386},
        {"shape: {placed: {count: 3, box: [1, 2, 5, 9]}}", 4 * 7},
        {"shape: {points: [[0, 0], [2, 0], [1, 3]]}", (2 + 1) * (3 + 1)},
    };
    for (size_t n = 0; n < sizeof shapes / sizeof *shapes; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: a gas\nmaterials: {m: {movable-particles: {strength: 0, mass: 3}}}\n"
                 "bodies: {b: {material: m, %s}}\n"
                 "dynamics: {strength-across: 0}\nrun: {steps: 1}\n",
                 shapes[n].body);
        begin(text);
        expect_pressure(shapes[n].area);
        end();
    }
}

/* --- diffusion --- */

#define GAS                                                                                        \
    "title: a gas\nmaterials: {m: {movable-particles: {strength: 0, mass: 4}}}\n"                  \
    "bodies: {b: {material: m, shape: {rectangle: [4, 3]}}}\nrun: {steps: 9}\n"

static void move_all(double x, double y)
{
    fw_solid *solid = solid_of_body(0);
    for (int i = 0; i < solid->count; ++i) {
        solid->x[i] = experiment->start[0][i].x + x;
        solid->y[i] = experiment->start[0][i].y + y;
    }
}

/* 4 T/(m eta) [t - tau (1 - e^{-t/tau})], tau = 1/eta (Eq 17): after half of tau. */
static void diffusion_is_compared_with_brownian_motion(void **state)
{
    (void)state;
    begin(GAS "dynamics: {time-step: .05, damping: 2, temperature: 3, strength-across: 0}\n");
    assert_close(value_of("diffusion-ratio", 0, NULL), 1, 0);
    run_steps(5);
    move_all(.3, .4);
    const double tau = .5, t = .25;
    assert_close(value_of("diffusion-ratio", 0, NULL),
                 .25 / (4 * 3. / (4 * 2.) * (t - tau * (1 - exp(-t / tau)))), 1e-12);
    end();
}

/* Early on it is free flight with 2 T/m: far below tau the ratio must not be rounding. */
static void early_diffusion_is_free_flight(void **state)
{
    (void)state;
    begin(GAS "dynamics: {time-step: .05, damping: 1e-7, temperature: 3, strength-across: 0}\n");
    run_steps(1);
    move_all(.03, .04);
    assert_close(value_of("diffusion-ratio", 0, NULL), .0025 / (2 * 3. / 4 * .05 * .05), 1e-6);
    end();
}

static void nothing_diffuses_without_temperature(void **state)
{
    (void)state;
    begin(GAS "dynamics: {time-step: .05, damping: 1, strength-across: 0}\n");
    run_steps(1);
    assert_true(isnan(value_of("diffusion-ratio", 0, NULL)));
    end();
}

/* --- waves of automata --- */

#define PERIODIC(displacement)                                                                     \
    "title: a wave\nmaterials: {m: {elastic-automaton: {c1: .4, c2: .58, boundary: periodic}}}\n"  \
    "bodies: {b: {material: m, shape: {rectangle: [8, 8]}, spacing: 2,\n"                          \
    "  displaced-as-given: true, displacement:\n"                                                  \
    "  [" displacement "]}}\nrun: {steps: 9}\n"

static double complex_size(double real, double imaginary)
{
    return hypot(real, imaginary);
}

/* With a cos(k . s + 30 degrees) comes b cos(k . s + 120 degrees): of the first it is 1 + i b/a. */
static void the_first_wave_is_what_turns(void **state)
{
    (void)state;
    begin(PERIODIC(
        "{wave: {amplitude: [.1, 0], wave-vector: [0.7853981633974483, 0], phase: 30}}, "
        "{wave: {amplitude: [.05, 0], wave-vector: [0.7853981633974483, 0], phase: 120}}"));
    assert_close(value_of("wave-turn", 0, NULL), atan(.5), 1e-12);
    assert_close(value_of("wave-path", 0, NULL), atan(.5) * 2 / (FW_PI / 4), 1e-12);
    assert_close(value_of("wave-size", 0, NULL), complex_size(1, .5), 1e-12);
    assert_close(value_of("wave-damping", 0, NULL), 1, 0);
    assert_true(isnan(value_of("mode-error", 0, NULL)));
    end();
}

/* Without damping each of them turns with its own frequency (Dong Eq 40), on all cells. */
static void modes_are_where_their_own_frequencies_have_them(void **state)
{
    (void)state;
    begin(PERIODIC("{mode: {wave-vector: [0.7853981633974483, 1.5707963267948966], branch: fast, "
                   "amplitude: .1}}, {mode: {wave-vector: [0.7853981633974483, "
                   "-0.7853981633974483], branch: slow, amplitude: .07, phase: 50}}"));
    for (int step = 0; step < 40; ++step) {
        run_steps(1);
        assert_close(value_of("mode-error", 0, NULL), 0, 1e-13);
    }
    end();
}

/* Both half-steps multiply the wave action by -a, whatever the shape of the wave, so a step takes
 * it times a^2 and the wave times a = 1 - damping: one mode, and two in any directions together. */
static void a_damped_wave_shrinks_by_as_much_each_step(void **state)
{
    (void)state;
#define MODE "{mode: {wave-vector: [0.7853981633974483, 1.5707963267948966], branch: "
    static const char *const modes[] = {MODE "fast, amplitude: .1}}",
                                        MODE "fast, amplitude: .1}}, " MODE
                                             "slow, amplitude: .07, phase: 50}}"};
#undef MODE
    for (int n = 0; n < 2; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: a wave\n"
                 "materials: {m: {elastic-automaton: {c1: .4, c2: .58, boundary: periodic, "
                 "damping: .03}}}\n"
                 "bodies: {b: {material: m, shape: {rectangle: [8, 8]}, displacement:\n"
                 "  [%s]}}\nrun: {steps: 9}\n",
                 modes[n]);
        begin(text);
        for (int step = 0; step < 9; ++step) {
            run_steps(1);
            assert_close(value_of("wave-damping", 0, NULL), .97, 1e-12);
        }
        end();
    }
}

/* Without a wave, and with one that looks on each colour as its opposite does. */
static void what_is_no_wave_does_not_turn(void **state)
{
    (void)state;
    static const char *const texts[] = {
        PERIODIC("{by: [.1, 0]}"), PERIODIC(""),
        PERIODIC("{wave: {amplitude: [.1, 0], "
                 "wave-vector: [3.141592653589793, 3.141592653589793]}}"),
        PERIODIC("{wave: {amplitude: [.1, 0], "
                 "wave-vector: [1.5707963267948966, 1.5707963267948966]}}")};
    static const char *const names[] = {"wave-turn", "wave-path", "wave-size", "wave-damping",
                                        "mode-error"};
    for (size_t t = 0; t < sizeof texts / sizeof *texts; ++t) {
        begin(texts[t]);
        for (size_t n = 0; n < sizeof names / sizeof *names; ++n)
            assert_true(isnan(value_of(names[n], 0, NULL)));
        end();
    }
    /* kx + ky is a multiple of pi, kx - ky is none. */
    begin(PERIODIC("{wave: {amplitude: [.1, 0], "
                   "wave-vector: [2.356194490192345, 0.7853981633974483]}}"));
    assert_close(value_of("wave-size", 0, NULL), 1, 1e-12);
    end();
}

/* --- bodies that share a solid, and one that does not --- */

/* Both clouds of dust are one solid, the sheet is the second one, and the third body. */
static void each_body_is_asked_in_its_own_solid(void **state)
{
    (void)state;
    begin("title: dust and a sheet\n"
          "materials: {dust: {movable-particles: {strength: 0, mass: 2}},\n"
          "  m: {lattice-boltzmann: {rest-mass: 0}}}\n"
          "bodies:\n"
          "  a: {material: dust, shape: {points: [[0, 0], [2, 0]]}, origin: [5, 9], "
          "velocity: [.1, 0]}\n"
          "  b: {material: dust, shape: {points: [[0, 0], [2, 0], [4, 0]]}, origin: [15, 9],\n"
          "    velocity: [0, .2]}\n"
          "  sheet: {material: m, shape: {rectangle: [2, 2]}, origin: [9, 20], "
          "velocity: [.03, .04]}\n"
          "walls: {box: {box: [0, 0, 50, 50]}}\n"
          "dynamics: {time-step: 1, strength-across: 0}\nrun: {steps: 1}\n");
    /* Without a rest mass each end of the sheet's four links has a half. */
    const double kinetic[] = {.02, .12, .5 * 4 * .0025}, x[] = {.1, 0, .03}, y[] = {0, .2, .04};
    for (int b = 0; b < 3; ++b) {
        assert_close(value_of("energy", b, NULL), kinetic[b], 1e-15);
        assert_close(value_of("mean-velocity", b, "x"), x[b], 1e-15);
        assert_close(value_of("mean-velocity", b, "y"), y[b], 1e-15);
        assert_close(value_of("momentum-error", b, "x"), 0, 1e-15);
        assert_close(experiment->energy_at_start[b], kinetic[b], 1e-15);
        assert_close(value_of("energy-error", b, NULL), 0, 1e-13);
        assert_close(value_of("penetration", b, NULL), 0, 0);
    }
    solid_of_body(2)->x[0] = -.25; /* a corner, behind the wall in the west */
    assert_close(value_of("penetration", 0, NULL), 0, 0);
    assert_close(value_of("penetration", 2, NULL), .25, 1e-15);
    assert_close(value_of("penetration", -1, NULL), .25, 1e-15);
    /* The second cloud, at x = 15, 17, 19, is stood upright about its middle. */
    for (int i = 0; i < 3; ++i) {
        solid_of_body(1)->x[2 + i] = 17;
        solid_of_body(1)->y[2 + i] = 9 + 2 * (i - 1);
    }
    for (int b = 0; b < 2; ++b) {
        assert_close(value_of("rotation", b, NULL), b * 90, 1e-12);
        assert_close(value_of("bond-angle", b, NULL), b * 90, 1e-12);
        assert_close(value_of("return-error", b, NULL), b * 2, 1e-14);
        assert_close(value_of("mean-square-displacement", b, NULL), b * 16. / 3, 1e-14);
        assert_close(value_of("elongation", b, "x"), b * -4, 1e-14);
        assert_close(value_of("elongation", b, "y"), b * 4, 1e-14);
        assert_close(value_of("centre-of-mass", b, "x"), b == 0 ? 6 : 17, 1e-14);
    }
    end();
}

/* --- places --- */

static void displacement_is_from_the_lattice_or_from_where_it_was_placed(void **state)
{
    (void)state;
    static const char *const shapes[] = {"{points: [[0, 0], [2, 0]]}", "{rectangle: [2, 1]}"};
    for (int n = 0; n < 2; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: two\nmaterials: {m: {movable-particles: {}}}\n"
                 "bodies: {b: {material: m, shape: %s, origin: [7, 1],\n"
                 "  displacement: [{by: [.1, .2]}]}}\n"
                 "run: {steps: 1}\n",
                 shapes[n]);
        begin(text);
        solid_of_body(0)->x[1] += .25;
        const fw_subject subject = {.body = 0, .particle = 1};
        double out[2];
        fw_quantity_find("displacement")->measure(experiment, subject, out);
        assert_close(out[0], n == 0 ? .25 : .35, 1e-14);
        assert_close(out[1], n == 0 ? 0 : .2, 1e-14);
        assert_close(value_of("elongation", 0, "x"), .25, 1e-14);
        assert_close(value_of("bond-angle", 0, NULL), 0, 1e-14);
        end();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy_per_particle_is_that_of_the_body_or_of_all),
        cmocka_unit_test(energy_per_particle_of_the_scene_counts_soft_walls),
        cmocka_unit_test(pressure_is_taken_over_the_area_that_a_body_was_given),
        cmocka_unit_test(diffusion_is_compared_with_brownian_motion),
        cmocka_unit_test(early_diffusion_is_free_flight),
        cmocka_unit_test(nothing_diffuses_without_temperature),
        cmocka_unit_test(the_first_wave_is_what_turns),
        cmocka_unit_test(modes_are_where_their_own_frequencies_have_them),
        cmocka_unit_test(a_damped_wave_shrinks_by_as_much_each_step),
        cmocka_unit_test(what_is_no_wave_does_not_turn),
        cmocka_unit_test(each_body_is_asked_in_its_own_solid),
        cmocka_unit_test(displacement_is_from_the_lattice_or_from_where_it_was_placed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
