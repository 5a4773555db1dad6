/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_refusals.c - what is refused of movable particles and linear lattices in scenario
 * files, and the sentences that say so. */
#include "tests/support/laws.h"

#include "experiments/measures/verdict.h"
#include "tests/support/both_commands.h"
#include "tests/support/scenarios.h"

#define PLAIN      "movable-particles: {}"
#define TAIL       "run: {steps: 1}\n"
#define DISC(more) "bodies: {b: {material: m, lattice: hexagonal, shape: {disc: 2}" more "}}\n"

static const bad_scenario refusals[] = {
    {"title: t\nmaterials: {m: {movable-particles: {return-force: {symmetry: 5, amplitude: "
     "1}}}}\n" DISC("") TAIL,
     "t.yaml:2:62: the symmetry is 5, expected an even number (6 for hexagonal bodies, 4 for "
     "square ones): with an odd one the two particles of a bond would not pull equally"},
    {"title: t\nmaterials: {m: {movable-particles: {return-force: {amplitude: 1, reach: [1.2, "
     "1.42]}}}}\n" DISC("") TAIL,
     "t.yaml:2:73: the return force reaches to a proximity radius of 1.42, expected less than "
     "sqrt(2) r0 = 1.41421: beyond it takes in the diagonals of a square"},
    {"title: t\nmaterials: {m: {movable-particles: {return-force: {amplitude: 1, angle: "
     "5}}}}\n" DISC("") TAIL,
     "t.yaml:2:66: the return force has both an 'angle' and corotating axes, which find theirs by "
     "themselves; expected 'axes: lab' or no angle"},
    {"title: t\nmaterials: {m: {movable-particles: {potential: {lennard-jones: {distance: "
     "1.8}}}}}\n" DISC("") TAIL,
     "t.yaml:2:49: the pair potential has its minimum at 1.8, outside its cut from 1.4 to 1.7: "
     "expected the minimum where the potential still has its full strength"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\ndynamics: {time-step: 0.12}\n" DISC("") TAIL,
     "t.yaml:3:23: body b: the time step is 0.12, expected less than 0.09623: beyond it the "
     "stiffest bond's oscillation grows"},
    {"title: t\nmaterials: {m: {linear-lattice: {}}}\ndynamics: {time-step: 0.12}\n" DISC("") TAIL,
     "t.yaml:3:23: body b: the time step is 0.12, expected less than 0.1026: beyond it the "
     "lattice's fastest oscillation grows"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\ndynamics: {temperature: -1}\n" DISC("") TAIL,
     "t.yaml:3:25: dynamics.temperature is '-1', expected a number of at least 0"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\ndynamics: {damping: -1}\n" DISC("") TAIL,
     "t.yaml:3:21: dynamics.damping is '-1', expected a number of at least 0"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nbodies: {b: {material: m, shape: {placed: {count: 3, "
     "box: [0, 0, 9, 9]}}, spacing: 2}}\n" TAIL,
     "t.yaml:3:75: bodies.b has 'spacing', but its particles are placed freely, not on a lattice"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nbodies: {b: {material: m, lattice: square, shape: "
     "{placed: {count: 3, box: [0, 0, 9, 9]}}}}\n" TAIL,
     "t.yaml:3:27: bodies.b has 'lattice', but its particles are placed freely, not on a lattice"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\n" DISC(", spacing: 0.6") TAIL,
     "t.yaml:3:10: body b: particle 0 of body 'b' and particle 1 of body 'b' overlap: at distance "
     "0.6 their energy is 416.5, expected at most 100"},
    {"title: t\nmaterials: {m: {" PLAIN "}, o: {movable-particles: {potential: {lennard-jones: "
     "{depth: 2}}}}}\nbodies:\n  a: {material: m, shape: {disc: 1}}\n  b: {material: o, shape: "
     "{disc: 1}, origin: [9, 0]}\n" TAIL,
     "t.yaml:2:41: material 'o' has another potential than 'm', expected the same: movable "
     "particles of all bodies attract each other"},
    {"title: t\nmaterials: {m: {lattice-boltzmann: {}}}\ndynamics: {damping: 1}\nbodies: {b: "
     "{material: m, shape: {disc: 2}}}\n" TAIL,
     "t.yaml:3:1: 'dynamics' is for movable particles and linear lattices, and no body is one"},
    {"title: t\nmaterials: {m: {lattice-boltzmann: {}}}\nbodies: {b: {material: m, shape: {disc: "
     "2}, spin: 1}}\n" TAIL,
     "t.yaml:3:45: bodies.b has 'spin', which only movable particles and linear lattices have"},
    {"title: t\nmaterials: {m: {linear-lattice: {}}}\nbodies: {b: {material: m, shape: {disc: "
     "2}}}\n" TAIL,
     "t.yaml:3:10: bodies.b.lattice is 'square', expected 'hexagonal': the linear lattice has six "
     "bonds per site"},
    {"title: t\nmaterials: {m: {linear-lattice: {k1: -20}}}\n" DISC("") TAIL,
     "t.yaml:3:10: body b: the linear lattice has k1 = -20 and k2 = 50, expected k1 + k2/4 > 0 and "
     "k1 + 3 k2/4 > 0: otherwise it collapses"},
    {"title: t\nmaterials: {m: {linear-lattice: {}}}\nbodies: {b: {material: m, lattice: "
     "hexagonal, shape: {placed: {count: 5, box: [0, 0, 9, 9]}}}}\n" TAIL,
     "t.yaml:3:55: bodies.b is placed at random, which only movable particles can be: the others "
     "live on a lattice"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nbodies: {b: {material: m, shape: {placed: {count: 5, "
     "box: [0, 9, 9, 0]}}}}\n" TAIL,
     "t.yaml:3:59: bodies.b.shape.placed.box goes from [0, 9] to [9, 0], expected the lower left "
     "corner first and the upper right one next"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nbodies: {b: {material: m, shape: {placed: {count: 99, "
     "box: [0, 0, 5, 5]}}}}\n" TAIL,
     "t.yaml:3:10: body b: 99 particles at least 0.75 from each other are to be placed"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nbodies: {b: {material: m, shape: {placed: {count: 5, "
     "box: [0, 0, 9, 9]}}, velocities: [{gradient: [0, 1, 0, 0]}]}}\n" TAIL,
     "t.yaml:3:89: 'gradient' in body 'b', whose particles are placed freely, expected 'by' or "
     "'random': "
     "it "
     "has no lattice for a pattern to follow"},
    {"title: t\nmaterials: {m: {" PLAIN "}}\nwalls:\n  w: {box: [-9, -9, 30, 9]}\nbodies:\n  a: "
     "{material: m, shape: {disc: 2}}\n  b: {material: m, shape: {disc: 2}, origin: [29, "
     "0]}\n" TAIL,
     "t.yaml:7:3: body b starts in wall w: particle "},
    {"title: t\nmaterials: {m: {" PLAIN "}}\n" DISC("") "run: {steps: 9, reverse-at: 2}\n"
                                                        "dynamics: {damping: 1}\n",
     "t.yaml:5:21: dynamics.damping is 1 in a run that is reversed, expected 0: what damping took "
     "does not come back"},
    {"title: t\nmaterials: {m: {lattice-boltzmann: {}}}\nbodies: {b: {material: m, shape: {disc: "
     "2}}}\nrun: {steps: 1}\nexpect: [{quantity: temperature, below: 1}]\n",
     "t.yaml:5:21: temperature is measured of a movable-particles linear-lattice solid, but no "
     "body is one"},
};

static void mistakes_get_their_sentences(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof refusals / sizeof *refusals; ++n) {
        fw_scenario *s = NULL;
        fw_observer *e = NULL;
        fw_measurement *m = NULL;
        error = (fw_error){0};
        fw_status status = read_text(&s, refusals[n].text);
        if (status == FW_OK) status = fw_observer_create(&e, s, &error);
        if (status == FW_OK) status = fw_measurement_create(&m, e, &error);
        if (status != FW_BAD_INPUT ||
            strncmp(error.sentence, refusals[n].sentence, strlen(refusals[n].sentence)) != 0)
            fail_msg("%s\n  found    %s\n  expected %s", refusals[n].text, error.sentence,
                     refusals[n].sentence);
        fw_observer_destroy(e);
        fw_scenario_destroy(s);
    }
}

static void check_refuses_what_run_refuses(void **state)
{
    (void)state;
    expect_both_refuse(refusals, sizeof refusals / sizeof *refusals);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_get_their_sentences),
        cmocka_unit_test(check_refuses_what_run_refuses),
    };
    return cmocka_run_group_tests_name("particle refusals", tests, NULL, NULL);
}
