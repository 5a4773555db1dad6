/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_keys.c - the table: every key a scenario may have. Constant.
 * Invariant: sections never contain each other in a circle, so a walk along them ends. A key that
 * nothing reads is not in here. */
#include "experiments/scenario/scenario.h"
#include "experiments/scenario/schema.h"

#define AT(object, member)   .offset = offsetof(object, member)
#define NOT_STORED           .offset = FW_NOT_STORED
#define REQUIRED             .required = true
#define ALTERNATIVE          .alternative = true
#define ABOVE_ZERO           .bounds = FW_ABOVE, .low = 0
#define AT_LEAST(least)      .bounds = FW_FROM, .low = (least)
#define FROM_TO(least, most) .bounds = FW_FROM | FW_UP_TO, .low = (least), .high = (most)
#define FROM_TO_BELOW(least, high_end)                                                             \
    .bounds = FW_FROM | FW_BELOW, .low = (least), .high = (high_end)
#define SELECTION                                                                                  \
    FW_FORM_SELECTION, .items = FW_FORM_INTEGERS, .layout = "[i, j]", .least = 1,                  \
                       .words = "all|left|right|bottom|top", .subsection = "selection"

/* What moves a grip or piston, whole: in itself and in each phase. */
#define DRIVE(section, object)                                                                     \
    {section,                                                                                      \
     "force",                                                                                      \
     FW_FORM_NUMBERS,                                                                              \
     .layout = "[x, y]",                                                                           \
     AT(object, motion.drive.force),                                                               \
     .default_value = "[0, 0]",                                                                    \
     .unit = "force",                                                                              \
     .meaning = "on the whole of it, constant"},                                                   \
        {section,                                                                                  \
         "amplitude",                                                                              \
         FW_FORM_NUMBERS,                                                                          \
         .layout = "[x, y]",                                                                       \
         .needs = "period",                                                                        \
         AT(object, motion.drive.amplitude),                                                       \
         .default_value = "[0, 0]",                                                                \
         .unit = "force",                                                                          \
         .meaning = "on top of it, times sin(360 t / period + phase)"},                            \
        {section,                                                                                  \
         "period",                                                                                 \
         FW_FORM_NUMBER,                                                                           \
         ABOVE_ZERO,                                                                               \
         AT(object, motion.drive.period),                                                          \
         .default_meaning = "no oscillation",                                                      \
         .unit = "time",                                                                           \
         .meaning = "of the oscillation"},                                                         \
        {section,                                                                                  \
         "phase",                                                                                  \
         FW_FORM_ANGLE,                                                                            \
         .needs = "period",                                                                        \
         FROM_TO(-360, 360),                                                                       \
         AT(object, motion.drive.phase),                                                           \
         .default_value = "0",                                                                     \
         .unit = "degrees",                                                                        \
         .meaning = "of the oscillation at time 0 of the run"},                                    \
        {section,                                                                                  \
         "tether",                                                                                 \
         FW_FORM_NUMBERS,                                                                          \
         .layout = "[x, y]",                                                                       \
         AT_LEAST(0),                                                                              \
         AT(object, motion.drive.tether),                                                          \
         .default_value = "[0, 0]",                                                                \
         .unit = "force/length",                                                                   \
         .meaning = "a spring to where it began, per component"},                                  \
        {section,                                                                                  \
         "hold",                                                                                   \
         FW_FORM_WORD,                                                                             \
         .words = "none|x|y|both",                                                                 \
         AT(object, motion.hold),                                                                  \
         .default_value = "none",                                                                  \
         .meaning = "components that follow the path whatever force it takes, or stay at rest "    \
                    "without one"},                                                                \
    {                                                                                              \
        section, "path", FW_FORM_MAPPING, .subsection = "path", AT(object, motion.drive.path),     \
                                          .default_meaning = "at rest",                            \
                                          .meaning = "of the components that `hold` names"         \
    }

const fw_section fw_schema_sections[] = {
    {"scenario", "The scenario", "a scenario", "The keys at the beginning of a line."},
    {"material", "`materials.NAME`", "a material", "What a body is made of: one model of a solid."},
    {"lattice-boltzmann", "`materials.NAME.lattice-boltzmann`", "a lattice Boltzmann material",
     "The solid of Chopard and Marconi (2002). One step takes one unit of time. A particle has the "
     "mass M = (M0^2 + k links)/2, k the link stiffness; each component of the displacement is a "
     "wave of its own (Poisson ratio 0), with speed (k/M)^(1/2)."},
    {"movable-particles", "`materials.NAME.movable-particles`", "a material of movable particles",
     "The solid of Popov and Filippov (2006): particles that attract and repel each other, across "
     "bodies too, and within a body return forces that turn bonds towards the body's axes. It can "
     "flow and melt. All such bodies of a scenario have the same potential."},
    {"potential", "`potential`", "a pair potential",
     "Led smoothly to zero over its cut; its minimum must lie where it has its full strength."},
    {"lennard-jones", "`potential.lennard-jones`", "a Lennard-Jones potential",
     "depth [(distance/r)^12 - 2 (distance/r)^6]."},
    {"morse", "`potential.morse`", "a Morse potential",
     "depth [(1 - e^(-steepness (r - distance)))^2 - 1]."},
    {"return-force", "`return-force`", "a return force",
     "On each bond of direction phi: -amplitude sin(symmetry (phi - axes)) across the bond."},
    {"linear-lattice", "`materials.NAME.linear-lattice`", "a linear lattice",
     "Popov and Filippov's Eqs 1-12: particles on a hexagonal lattice, tied for ever to their "
     "neighbours, F = k1 u + k2 e (e . u) for a bond of direction e whose ends are displaced by u "
     "against each other."},
    {"elastic-automaton", "`materials.NAME.elastic-automaton`", "an elastic automaton",
     "The solid of Dong, Zhang, Xu and Gan: black and white cells move in turn, each reflected "
     "about the place that its neighbours ask for. One step is a black and a white half-step and "
     "takes one unit of time. Waves run at c1 (transverse) and (c1^2 + c2^2)^(1/2) (longitudinal) "
     "spacings per step; c1^2 + c2^2 must not exceed 2. A boundary rule that is unstable for a "
     "body, by the spectral radius of the body's own update, is refused. If one body of a scenario "
     "is an automaton, all must be: it moves in half-steps."},
    {"body", "`bodies.NAME`", "a body",
     "Particles on the sites of a lattice, all of one material."},
    {"shape", "`bodies.NAME.shape`", "a shape",
     "Which sites [i, j] = [column, row] of the lattice the body occupies; rows count upwards."},
    {"placed", "`bodies.NAME.shape.placed`", "a random placement",
     "Particles are dropped one after the other, uniformly in a rectangle; one that falls too near "
     "an earlier one is dropped again. The places follow from the run's seed; particle n is called "
     "site [n, 0]."},
    {"pattern", "Items of `displacement` and `velocities`", "a pattern",
     "A value for the selected sites. The patterns of a list add up."},
    {"gaussian", "`gaussian`", "a Gaussian pattern",
     "amplitude exp(-|s - centre|^2 / (2 width^2)) at site s = [i, j]."},
    {"wave", "`wave`", "a wave pattern",
     "amplitude cos(wave-vector . s + phase) at site s = [i, j]."},
    {"plane-wave", "`plane-wave`", "a plane wave",
     "amplitude cos(wave-vector . r + phase) at distance r = [x, y] from the body's origin."},
    {"mode", "`mode`", "a mode",
     "A running wave of the endless automaton (Dong Eqs 37-40): Re(a exp(i (wave-vector . s + "
     "omega "
     "t + phase))) at site s = [i, j], a being that of the cell's colour. It runs against its wave "
     "vector. White's a has a real positive x (or y, where x is zero); in a periodic body that the "
     "wave fits into it goes on for ever."},
    {"mass-change", "Items of `bodies.NAME.rest-mass`", "a change of rest mass",
     "Another rest mass for the selected sites. The last one given holds."},
    {"stiffness-change", "Items of `bodies.NAME.link-stiffness`", "a change of stiffness",
     "Another stiffness for links of the selected sites. The last one given holds."},
    {"selection", "Selections: `sites`", "a selection",
     "`all`; one of the sides `left`, `right`, `bottom`, `top`; a list of sites `[[i, j], ...]`; "
     "or a mapping with the keys below, which must all hold. Every site, row and column named must "
     "belong to the body."},
    {"wall", "`walls.NAME`", "a wall",
     "A rigid wall, at rest, on a prescribed path, or with a mass that forces move."},
    {"surface", "`walls.NAME.surface`", "a surface",
     "`frictionless`, `stick` (a particle that touches is held), `componentwise` (of an elastic "
     "automaton: what would pass is frozen, the rest of the motion left alone, which does not "
     "conserve energy), or a mapping:"},
    {"path", "`walls.NAME.path`", "a path",
     "The wall is displaced by velocity (t - from) while from <= t <= until, plus amplitude "
     "sin(360 t / period + phase)."},
    {"piston", "`walls.NAME.piston`", "a piston",
     "The wall has a mass and is moved by a drive and by what touches it; it does not turn, and "
     "passes through other walls. Energy and momentum of bodies and pistons together are exact. "
     "Not for automata, which move in half-steps."},
    {"force", "`forces.NAME`", "a force", "An external force on selected particles of one body."},
    {"grip", "`grips.NAME`", "a grip",
     "A rigid block of particles of one body, held together by constraint forces. It does not "
     "turn; "
     "it moves by what drives it and what the rest of the body does to it."},
    {"phase", "`phases.NAME`", "a phase",
     "A part of the run with parameters of its own, from the end of the phase before. The last one "
     "ends with the run. What a phase does not say is as without phases."},
    {"phase-grip", "`phases.NAME.grips.NAME`", "the drive of a grip in a phase",
     "Takes the place of the grip's own drive during the phase, as a whole."},
    {"phase-piston", "`phases.NAME.pistons.NAME`", "the drive of a piston in a phase",
     "Takes the place of the piston's own drive during the phase, as a whole."},
    {"profile", "`profile`", "a profile",
     "Averages across the scene, in bins of one coordinate, over samples of a phase and over the "
     "seeds of the study: what `fretwork profile` prints. Movable particles only."},
    {"study", "`study`", "a study",
     "More runs of the same scenario, side by side: means and standard errors come from all "
     "seeds, and what is expected is held against the mean. `summary.csv` in the results has the "
     "numbers of each seed."},
    {"sweep", "`study.sweep`", "a sweep",
     "One study after the other, each with its results in `DIR/PARAMETER=VALUE`. "
     "`DIR/sweep.csv` has means and standard errors of what is expected, and of the layer's "
     "measures, against the parameter."},
    {"dynamics", "`dynamics`", "a set of dynamics",
     "How movable particles and linear lattices move: m dv/dt = F - m damping v + noise, in steps "
     "of velocity Verlet, or of BAOAB where there is damping. Everything that counts steps (`run`, "
     "forces, expectations) counts these; walls' paths are in time, steps times `time-step`."},
    {"run", "`run`", "a run", "How long, and what happens on the way."},
    {"record", "`record`", "a record",
     "What the results file holds of each particle, beside its position."},
    {"expectation", "Items of `expect`", "an expectation",
     "A number that the run must show, or it ends with exit code 1. Either `value` with `within` "
     "or `within-relative`, or `below`, `above` or both, or the `trend` of a sweep."},
    {"analysis", "`analysis.NAME`", "an analysis",
     "What is computed without running: numbers that `expect` can speak of, and arrays in the "
     "results file under parameters/analysis/NAME."},
    {"stability-map", "`analysis.NAME.stability-map`", "a stability map",
     "Growth of plane waves of the elastic automaton over the plane of c1 and c2."},
    {"dispersion", "`analysis.NAME.dispersion`", "a dispersion",
     "Frequencies along Gamma-X-M-Gamma: waves that run through a periodic body, beside the closed "
     "form."},
    {"plane-mode", "`analysis.NAME.plane-mode`", "a plane wave's modes",
     "Speeds and polarisations of both modes of a wave vector."},
    {"body-stability", "`analysis.NAME.body-stability`", "a body's stability",
     "Growth by the own update of a rectangle with free edges, stable or not; at most 400 cells."},
    {"boltzmann-reference", "`analysis.NAME.boltzmann-reference`", "a lattice Boltzmann reference",
     "Runs the lattice Boltzmann solid that Chopard's automaton is (M0 = 0, two of its steps for "
     "one "
     "of the automaton), from the same start, between the same walls, and compares."},
    {"picture", "`pictures.NAME`", "a picture",
     "What `fretwork plot` draws unless told otherwise."},
    {.name = NULL}};

const fw_key fw_schema_keys[] = {
    /* --- the scenario --- */
    {"scenario", "title", FW_FORM_TEXT, REQUIRED, AT(fw_scenario, title),
     .meaning = "what the experiment shows, in one line"},
    {"scenario", "source", FW_FORM_TEXT, AT(fw_scenario, source), .default_meaning = "none",
     .meaning = "paper and figure that it reproduces"},
    {"scenario", "figure", FW_FORM_TEXT, AT(fw_scenario, figure), .default_meaning = "none",
     .meaning = "short name of that figure, for `fretwork list`"},
    {"scenario", "about", FW_FORM_TEXT, AT(fw_scenario, about), .default_meaning = "none",
     .meaning = "anything else a reader should know"},
    {"scenario", "materials", FW_FORM_NAMED, .subsection = "material", .least = 1,
     .most = FW_NAMED_MAX, REQUIRED, NOT_STORED, .meaning = "materials by name"},
    {"scenario", "bodies", FW_FORM_NAMED, .subsection = "body", .least = 1, .most = FW_NAMED_MAX,
     REQUIRED, NOT_STORED, .meaning = "bodies by name"},
    {"scenario", "walls", FW_FORM_NAMED, .subsection = "wall", .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "walls by name"},
    {"scenario", "forces", FW_FORM_NAMED, .subsection = "force", .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "forces by name; those on the same particle add up"},
    {"scenario", "grips", FW_FORM_NAMED, .subsection = "grip", .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "rigid blocks of particles by name"},
    {"scenario", "phases", FW_FORM_NAMED, .subsection = "phase", .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "one phase, the whole run",
     .meaning = "parts of the run by name, in order"},
    {"scenario", "profile", FW_FORM_MAPPING, .subsection = "profile", NOT_STORED,
     .default_meaning = "none", .meaning = "what is averaged across the scene"},
    {"scenario", "study", FW_FORM_MAPPING, .subsection = "study", NOT_STORED,
     .default_meaning = "one run", .meaning = "replicas over seeds, and a control"},
    {"scenario", "dynamics", FW_FORM_MAPPING, .subsection = "dynamics", AT(fw_scenario, dynamics),
     .default_meaning = "its defaults",
     .meaning = "how movable particles and linear lattices move"},
    {"scenario", "run", FW_FORM_MAPPING, .subsection = "run", REQUIRED, AT(fw_scenario, run),
     .meaning = "how long, and what happens on the way"},
    {"scenario", "record", FW_FORM_MAPPING, .subsection = "record", AT(fw_scenario, record),
     .default_meaning = "positions and velocities",
     .meaning = "what the results file holds of each particle"},
    {"scenario", "measure", FW_FORM_LIST, .items = FW_FORM_NAME, .most = 256,
     AT(fw_scenario, measure), .default_meaning = "a standard set",
     .meaning = "observables to be measured, beside those that `expect` and `pictures` name"},
    {"scenario", "expect", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = "expectation",
     .most = FW_NAMED_MAX, NOT_STORED, .default_meaning = "nothing",
     .meaning = "what must come out"},
    {"scenario", "pictures", FW_FORM_NAMED, .subsection = "picture", .most = 64, NOT_STORED,
     .default_meaning = "the motion", .meaning = "pictures by name"},
    {"scenario", "analysis", FW_FORM_NAMED, .subsection = "analysis", .most = 64, NOT_STORED,
     .default_meaning = "none", .meaning = "what is computed without running, by name"},

    /* --- materials --- */
    {"material", "lattice-boltzmann", FW_FORM_MAPPING, .subsection = "lattice-boltzmann",
     ALTERNATIVE, AT(fw_scenario_material, boltzmann), .meaning = "the lattice Boltzmann solid"},
    {"lattice-boltzmann", "rest-mass", FW_FORM_SYMMETRIC, AT(fw_scenario_boltzmann, rest_mass),
     .default_value = "0", .unit = "mass^(1/2)",
     .meaning = "M0 of Chopard and Marconi: inertia beside that of the links. As a matrix it must "
                "be symmetric: another one would create energy"},
    {"lattice-boltzmann", "damping", FW_FORM_NUMBER, AT(fw_scenario_boltzmann, damping),
     FROM_TO_BELOW(0, 0.5), .hint = "0 is none, and what was mu is 1 - damping",
     .default_value = "0",
     .meaning = "each step takes twice this part of the momentum. 0 is none; the mu of the "
                "paper is 1 - damping"},
    {"lattice-boltzmann", "link-stiffness", FW_FORM_SYMMETRIC,
     AT(fw_scenario_boltzmann, link_stiffness), ABOVE_ZERO, .default_value = "1",
     .unit = "force/length",
     .meaning = "of every link; as a matrix it must be symmetric and positive definite"},
    {"lattice-boltzmann", "break-at", FW_FORM_NUMBER, AT(fw_scenario_boltzmann, break_at),
     ABOVE_ZERO, .default_meaning = "links never break", .unit = "length",
     .meaning = "a link whose ends are displaced from each other by more than this breaks"},

    {"material", "movable-particles", FW_FORM_MAPPING, .subsection = "movable-particles",
     ALTERNATIVE, AT(fw_scenario_material, particles), .meaning = "movable lattice particles"},
    {"movable-particles", "potential", FW_FORM_MAPPING, .subsection = "potential",
     AT(fw_scenario_particles, potential), .default_meaning = "Lennard-Jones with its defaults",
     .meaning = "between any two particles"},
    {"movable-particles", "return-force", FW_FORM_MAPPING, .subsection = "return-force",
     .offset = 0, .default_meaning = "none", .meaning = "on bonds inside a body"},
    {"movable-particles", "mass", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_particles, mass),
     .default_value = "1", .unit = "mass", .meaning = "of each particle"},
    {"movable-particles", "strength", FW_FORM_NUMBER, AT_LEAST(0),
     AT(fw_scenario_particles, strength), .default_value = "1",
     .meaning = "factor on the potential inside a body; at 0 its particles are a gas"},
    {"potential", "lennard-jones", FW_FORM_MAPPING, .subsection = "lennard-jones", ALTERNATIVE,
     .offset = 0, .meaning = "the paper's"},
    {"potential", "morse", FW_FORM_MAPPING, .subsection = "morse", ALTERNATIVE, .offset = 0,
     .meaning = "with a steepness of its own"},
    {"lennard-jones", "depth", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_pair_potential, depth),
     .default_value = "1", .unit = "energy", .meaning = "epsilon, of the minimum"},
    {"lennard-jones", "distance", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_pair_potential, distance),
     .default_value = "1", .unit = "length", .meaning = "r0, of the minimum"},
    {"lennard-jones", "cut", FW_FORM_NUMBERS, .layout = "[from, to]", AT_LEAST(0),
     AT(fw_pair_potential, cut), .default_value = "[1.4, 1.7]", .unit = "length",
     .meaning = "where it is led to zero"},
    {"morse", "depth", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_pair_potential, depth),
     .default_value = "1", .unit = "energy", .meaning = "of the minimum"},
    {"morse", "distance", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_pair_potential, distance),
     .default_value = "1", .unit = "length", .meaning = "r0, of the minimum"},
    {"morse", "steepness", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_pair_potential, steepness),
     .default_value = "6", .unit = "1/length",
     .meaning = "6/r0 has the curvature of Lennard-Jones"},
    {"morse", "cut", FW_FORM_NUMBERS, .layout = "[from, to]", AT_LEAST(0),
     AT(fw_pair_potential, cut), .default_value = "[1.4, 1.7]", .unit = "length",
     .meaning = "where it is led to zero"},
    {"return-force", "symmetry", FW_FORM_INTEGER, FROM_TO(2, 24),
     AT(fw_scenario_particles, symmetry), .default_value = "6",
     .meaning =
         "n: how many axes there are around; even, 6 for hexagonal bodies, 4 for square ones"},
    {"return-force", "amplitude", FW_FORM_NUMBER, REQUIRED, AT_LEAST(0),
     AT(fw_scenario_particles, return_force.amplitude), .unit = "force", .meaning = "f0"},
    {"return-force", "variant", FW_FORM_WORD, .words = "conservative|constant",
     AT(fw_scenario_particles, return_force.variant), .default_value = "conservative",
     .meaning =
         "conservative: with a potential; constant: the paper's, of constant amplitude, which "
         "heats whatever flows"},
    {"return-force", "axes", FW_FORM_WORD, .words = "lab|corotating|surface",
     AT(fw_scenario_particles, return_force.axes), .default_value = "corotating",
     .meaning =
         "lab: fixed, the body is a torsion pendulum, as in the paper; corotating: they turn "
         "with the body, whose angular momentum is kept; surface: fixed, and forces at the "
         "surface take the torque off"},
    {"return-force", "angle", FW_FORM_ANGLE, FROM_TO(-360, 360),
     AT(fw_scenario_particles, return_force.angle), .default_meaning = "that of the body's lattice",
     .unit = "degrees", .meaning = "of the axes, where they are fixed"},
    {"return-force", "reach", FW_FORM_NUMBERS, .layout = "[from, to]", AT_LEAST(0),
     AT(fw_scenario_particles, return_force.cut), .default_value = "[1.2, 1.4]", .unit = "length",
     .meaning = "where it is led to zero; must end before 2^(1/2) r0, where diagonals are"},
    {"material", "linear-lattice", FW_FORM_MAPPING, .subsection = "linear-lattice", ALTERNATIVE,
     AT(fw_scenario_material, linear), .meaning = "the linear lattice"},
    {"linear-lattice", "k1", FW_FORM_NUMBER, AT(fw_scenario_linear, k1), .default_value = "10",
     .unit = "force/length", .meaning = "of a bond against any displacement"},
    {"linear-lattice", "k2", FW_FORM_NUMBER, AT(fw_scenario_linear, k2), .default_value = "50",
     .unit = "force/length", .meaning = "of a bond against displacement along it, beyond k1"},
    {"linear-lattice", "compensated", FW_FORM_FLAG, AT(fw_scenario_linear, compensated),
     .default_value = "true",
     .meaning = "surface forces make up for what k1 does to a body that turns; without them a "
                "specimen with free sides shows another Poisson ratio"},
    {"linear-lattice", "mass", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_linear, mass),
     .default_value = "1", .unit = "mass", .meaning = "of each particle"},
    {"material", "elastic-automaton", FW_FORM_MAPPING, .subsection = "elastic-automaton",
     ALTERNATIVE, AT(fw_scenario_material, automaton), .meaning = "the elastic automaton"},
    {"elastic-automaton", "c1", FW_FORM_NUMBER, ALTERNATIVE, AT_LEAST(0),
     AT(fw_scenario_automaton, speeds.transverse), .unit = "spacings/step",
     .meaning = "speed of transverse waves; c1^2 is the shear modulus"},
    {"elastic-automaton", "c2", FW_FORM_NUMBER, .needs = "c1", AT_LEAST(0),
     AT(fw_scenario_automaton, speeds.coupling), .default_meaning = "must stand beside `c1`",
     .unit = "spacings/step",
     .meaning = "couples x and y; c2^2 is lambda plus the shear modulus, at 0 they know nothing of "
                "each other"},
    {"elastic-automaton", "shear-modulus", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED,
     .unit = "(spacings/step)^2", .meaning = "in place of c1 and c2, with `poisson-ratio`"},
    {"elastic-automaton", "poisson-ratio", FW_FORM_NUMBER, .needs = "shear-modulus",
     FROM_TO(-1, 0.999), NOT_STORED, .default_meaning = "must stand beside `shear-modulus`",
     .meaning = "that of the plane, lambda/(lambda + 2 mu)"},
    {"elastic-automaton", "chopard", FW_FORM_FLAG, ALTERNATIVE, NOT_STORED,
     .meaning = "`true`: Chopard's automaton, c1 = 2^(1/2) and c2 = 0, which is the lattice "
                "Boltzmann solid with M0 = 0"},
    {"elastic-automaton", "boundary", FW_FORM_WORD, .words = "bond|trapezoid|mirror|periodic",
     AT(fw_scenario_automaton, boundary), .default_value = "bond",
     .meaning =
         "what a missing neighbour contributes. bond: nothing; trapezoid: nothing, and bonds "
         "along an edge count half; both conserve energy and momentum. mirror: what the "
         "opposite neighbour does; keeps neither. periodic: the body's frame closes upon "
         "itself, its columns and rows must be even"},
    {"elastic-automaton", "damping", FW_FORM_NUMBER, AT(fw_scenario_automaton, damping),
     FROM_TO_BELOW(0, 1), .hint = "0 is none, and what was a is 1 - damping", .default_value = "0",
     .meaning = "part of a wave that each step takes. 0 is none; the a of the paper is "
                "1 - damping. A lattice Boltzmann solid with half of it is damped alike"},
    {"elastic-automaton", "black", FW_FORM_WORD, .words = "even|odd",
     AT(fw_scenario_automaton, black), .default_value = "even",
     .meaning = "the sites [i, j] that move first: those with i + j even, or odd"},
    {"elastic-automaton", "break-at", FW_FORM_NUMBER, AT(fw_scenario_automaton, break_at),
     ABOVE_ZERO, .default_meaning = "bonds never break", .unit = "length",
     .meaning = "a bond whose ends are displaced from each other by more than this breaks; needs "
                "boundary `bond` and a c2 at which every bond's matrix is positive"},

    /* --- bodies --- */
    {"body", "material", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `materials`"},
    {"body", "shape", FW_FORM_MAPPING, .subsection = "shape", REQUIRED, NOT_STORED,
     .meaning = "the sites it occupies"},
    {"body", "lattice", FW_FORM_WORD, .words = "square|hexagonal",
     AT(fw_scenario_body, lattice.kind), .default_value = "square",
     .meaning = "square: site [i, j] lies at (i, j); hexagonal: rows along x, site [i, j] at (i + "
                "(j odd)/2, j 3^(1/2)/2)"},
    {"body", "spacing", FW_FORM_NUMBER, AT(fw_scenario_body, lattice.spacing), FROM_TO(1e-6, 1e6),
     .default_value = "1", .unit = "length", .meaning = "between neighbouring sites"},
    {"body", "angle", FW_FORM_ANGLE, FROM_TO(-360, 360), AT(fw_scenario_body, lattice.angle),
     .default_value = "0", .unit = "degrees",
     .meaning = "by which the lattice is turned about site [0, 0], counter-clockwise"},
    {"body", "origin", FW_FORM_NUMBERS, .layout = "[x, y]", AT(fw_scenario_body, lattice.origin),
     .default_value = "[0, 0]", .unit = "length", .meaning = "where site [0, 0] lies at the start"},
    {"body", "velocity", FW_FORM_NUMBERS, .layout = "[x, y]", AT(fw_scenario_body, velocity),
     .default_value = "[0, 0]", .unit = "length/time", .meaning = "of the whole body at the start"},
    {"body", "displacement", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = "pattern",
     .most = 4096, NOT_STORED, .default_meaning = "none", .unit = "length",
     .meaning = "of single sites from their places in the lattice at the start"},
    {"body", "velocities", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = "pattern",
     .most = 4096, NOT_STORED, .default_meaning = "none", .unit = "length/time",
     .meaning = "of single sites at the start, added to `velocity`"},
    {"body", "spin", FW_FORM_NUMBER, AT(fw_scenario_body, spin), .default_value = "0",
     .unit = "radians/time",
     .meaning = "angular velocity about its middle at the start, counter-clockwise (movable "
                "particles, linear lattice)"},
    {"body", "temperature", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_body, temperature),
     .default_value = "0", .unit = "energy",
     .meaning =
         "of random velocities at the start, which add up to zero (movable particles, linear "
         "lattice)"},
    {"body", "displaced-as-given", FW_FORM_FLAG, .needs = "displacement",
     AT(fw_scenario_body, displaced_as_given), .default_value = "false",
     .meaning =
         "elastic automaton: black and white are displaced just as `displacement` says, as in "
         "the paper, which in general sets the body moving; without it white lies where its "
         "black neighbours ask for, and the body is at rest"},
    {"body", "rest-mass", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = "mass-change",
     .most = 4096, NOT_STORED, .default_meaning = "the material's",
     .meaning = "of single sites (lattice Boltzmann)"},
    {"body", "link-stiffness", FW_FORM_LIST, .items = FW_FORM_MAPPING,
     .subsection = "stiffness-change", .most = 4096, NOT_STORED,
     .default_meaning = "the material's", .meaning = "of single links (lattice Boltzmann)"},

    {"shape", "rectangle", FW_FORM_INTEGERS, .layout = "[columns, rows]", ALTERNATIVE, AT_LEAST(1),
     NOT_STORED, .unit = "sites", .meaning = "lower left corner at site [0, 0]"},
    {"shape", "disc", FW_FORM_NUMBER, ALTERNATIVE, FROM_TO(0, 8192), NOT_STORED, .unit = "spacings",
     .meaning = "all sites within this distance of site [0, 0]"},
    {"shape", "sites", FW_FORM_LIST, .items = FW_FORM_INTEGERS, .layout = "[i, j]", ALTERNATIVE,
     .least = 1, NOT_STORED, .meaning = "every site, in any order"},
    {"shape", "mask", FW_FORM_TEXT, ALTERNATIVE, NOT_STORED,
     .meaning = "lines of text (after a `|`): `#` is a particle, `.` none; the last line is row 0, "
                "its first character column 0"},

    {"shape", "placed", FW_FORM_MAPPING, .subsection = "placed", ALTERNATIVE, NOT_STORED,
     .meaning = "random sequential placement (movable particles)"},
    {"placed", "count", FW_FORM_INTEGER, REQUIRED, FROM_TO(1, FW_COORDINATE_MAX), NOT_STORED,
     .meaning = "how many particles"},
    {"placed", "box", FW_FORM_NUMBERS, .layout = "[x0, y0, x1, y1]", REQUIRED, NOT_STORED,
     .unit = "length", .meaning = "lower left and upper right corner, seen from the body's origin"},
    {"placed", "min-distance", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_shape, apart),
     .default_value = "0.75", .unit = "length", .meaning = "no two are closer"},

    {"pattern", "sites", SELECTION, .default_value = "all", NOT_STORED, .meaning = "which sites"},
    {"pattern", "by", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .meaning = "the same for all of them"},
    {"pattern", "gaussian", FW_FORM_MAPPING, .subsection = "gaussian", ALTERNATIVE, NOT_STORED,
     .meaning = "a hill around one site"},
    {"pattern", "wave", FW_FORM_MAPPING, .subsection = "wave", ALTERNATIVE, NOT_STORED,
     .meaning = "a plane wave"},
    {"pattern", "plane-wave", FW_FORM_MAPPING, .subsection = "plane-wave", ALTERNATIVE, NOT_STORED,
     .meaning = "a plane wave in space, whatever the lattice"},
    {"pattern", "gradient", FW_FORM_NUMBERS, .layout = "[xx, xy, yx, yy]", ALTERNATIVE, NOT_STORED,
     .unit = "1/length",
     .meaning = "xx x + xy y along x, yx x + yy y along y, at [x, y] from the body's origin"},
    {"pattern", "mode", FW_FORM_MAPPING, .subsection = "mode", ALTERNATIVE, NOT_STORED,
     .meaning = "a running wave of an elastic automaton; its displacements are taken as given"},
    {"pattern", "random", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED,
     .meaning = "each component uniform between minus and plus this, from the run's seed"},
    {"gaussian", "amplitude", FW_FORM_NUMBERS, .layout = "[x, y]", REQUIRED,
     AT(fw_pattern, amplitude), .meaning = "at the centre"},
    {"gaussian", "centre", FW_FORM_NUMBERS, .layout = "[i, j]", REQUIRED, AT(fw_pattern, centre),
     .unit = "sites", .meaning = "need not be a site"},
    {"gaussian", "width", FW_FORM_NUMBER, REQUIRED, ABOVE_ZERO, AT(fw_pattern, width),
     .unit = "sites", .meaning = "standard deviation"},
    {"wave", "amplitude", FW_FORM_NUMBERS, .layout = "[x, y]", REQUIRED, AT(fw_pattern, amplitude),
     .meaning = "at the crest"},
    {"wave", "wave-vector", FW_FORM_NUMBERS, .layout = "[i, j]", REQUIRED,
     AT(fw_pattern, wave_vector), .unit = "radians per site",
     .meaning = "6.2832/n repeats after n sites"},
    {"wave", "phase", FW_FORM_ANGLE, FROM_TO(-360, 360), AT(fw_pattern, phase),
     .default_value = "0", .unit = "degrees", .meaning = "at site [0, 0]"},

    {"plane-wave", "amplitude", FW_FORM_NUMBERS, .layout = "[x, y]", REQUIRED,
     AT(fw_pattern, amplitude), .meaning = "at the crest"},
    {"plane-wave", "wave-vector", FW_FORM_NUMBERS, .layout = "[x, y]", REQUIRED,
     AT(fw_pattern, wave_vector), .unit = "radians per length", .meaning = "6.2832/wavelength"},
    {"plane-wave", "phase", FW_FORM_ANGLE, FROM_TO(-360, 360), AT(fw_pattern, phase),
     .default_value = "0", .unit = "degrees", .meaning = "at the body's origin"},
    {"mode", "wave-vector", FW_FORM_NUMBERS, .layout = "[i, j]", REQUIRED,
     AT(fw_pattern, wave_vector), .unit = "radians per site", .meaning = "not zero"},
    {"mode", "branch", FW_FORM_WORD, .words = "slow|fast", REQUIRED, AT(fw_pattern, branch),
     .meaning = "long waves: slow is transverse, fast longitudinal"},
    {"mode", "amplitude", FW_FORM_NUMBER, REQUIRED, ABOVE_ZERO, AT(fw_pattern, size),
     .unit = "length", .meaning = "of the white cells' displacement"},
    {"mode", "phase", FW_FORM_ANGLE, FROM_TO(-360, 360), AT(fw_pattern, phase),
     .default_value = "0", .unit = "degrees", .meaning = "at site [0, 0]"},

    {"mass-change", "sites", SELECTION, REQUIRED, NOT_STORED, .meaning = "which sites"},
    {"mass-change", "value", FW_FORM_SYMMETRIC, REQUIRED, AT(fw_replacement, value),
     .unit = "mass^(1/2)", .meaning = "as in the material"},
    {"stiffness-change", "sites", SELECTION, REQUIRED, NOT_STORED, .meaning = "which sites"},
    {"stiffness-change", "links", FW_FORM_WORD, .words = "inside|across|touching",
     AT(fw_replacement, links), .default_value = "inside",
     .meaning =
         "inside: links with both ends selected; across: with one end; touching: with one or both"},
    {"stiffness-change", "value", FW_FORM_SYMMETRIC, REQUIRED, ABOVE_ZERO,
     AT(fw_replacement, value), .unit = "force/length", .meaning = "as in the material"},

    {"selection", "side", FW_FORM_WORD, .words = "left|right|bottom|top", NOT_STORED,
     .default_meaning = "any", .meaning = "the outermost columns or rows of the body"},
    {"selection", "layers", FW_FORM_INTEGER, .needs = "side", AT_LEAST(1), NOT_STORED,
     .default_value = "1", .meaning = "how many of them"},
    {"selection", "rows", FW_FORM_INTEGERS, .layout = "[first, last]", NOT_STORED,
     .default_meaning = "all", .meaning = "both included"},
    {"selection", "columns", FW_FORM_INTEGERS, .layout = "[first, last]", NOT_STORED,
     .default_meaning = "all", .meaning = "both included"},

    /* --- walls and forces --- */
    {"wall", "box", FW_FORM_NUMBERS, .layout = "[x0, y0, x1, y1]", ALTERNATIVE, NOT_STORED,
     .unit = "length", .meaning = "two opposite corners"},
    {"wall", "polygon", FW_FORM_LIST, .items = FW_FORM_NUMBERS, .layout = "[x, y]", .least = 3,
     .most = 65536, ALTERNATIVE, NOT_STORED, .unit = "length",
     .meaning = "corners in order; must be convex"},
    {"wall", "circle", FW_FORM_NUMBERS, .layout = "[x, y, radius]", ALTERNATIVE, NOT_STORED,
     .unit = "length", .meaning = "centre and radius"},
    {"wall", "chain", FW_FORM_LIST, .items = FW_FORM_NUMBERS, .layout = "[x, y]", .least = 2,
     .most = 65536, ALTERNATIVE, NOT_STORED, .unit = "length",
     .meaning = "straight pieces from point to point; particles are free to the left of the way "
                "along it, and pass from behind"},
    {"wall", "closed", FW_FORM_FLAG, .needs = "chain", AT(fw_scenario_wall, def.closed),
     .default_value = "false", .meaning = "the chain returns to its first point"},
    {"wall", "side", FW_FORM_WORD, .words = "inside|outside", AT(fw_scenario_wall, def.side),
     .default_value = "inside",
     .meaning = "where particles are free: of boxes, polygons and circles"},
    {"wall", "surface", FW_FORM_WORD | FW_FORM_MAPPING, .words = "frictionless|stick|componentwise",
     .subsection = "surface", NOT_STORED, .default_value = "frictionless",
     .meaning = "what it does along its tangent"},
    {"wall", "path", FW_FORM_MAPPING, .subsection = "path", AT(fw_scenario_wall, def.path),
     .default_meaning = "at rest", .meaning = "how it moves"},
    {"wall", "piston", FW_FORM_MAPPING, .subsection = "piston", AT(fw_scenario_wall, piston),
     .default_meaning = "moved by nothing but its path",
     .meaning = "its mass, and the forces on it"},
    {"piston", "mass", FW_FORM_NUMBER, REQUIRED, ABOVE_ZERO, AT(fw_scenario_piston, mass),
     .unit = "mass", .meaning = "of the whole wall"},
    {"piston", "damping", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_piston, damping),
     .default_value = "0", .unit = "1/time", .meaning = "rate at which its velocity decays"},
    {"piston", "velocity", FW_FORM_NUMBERS, .layout = "[x, y]", AT(fw_scenario_piston, velocity),
     .default_value = "[0, 0]", .unit = "length/time", .meaning = "at the start"},
    DRIVE("piston", fw_scenario_piston),
    {"surface", "coulomb", FW_FORM_NUMBER, ALTERNATIVE, FROM_TO(0, 1000), NOT_STORED,
     .meaning = "friction coefficient: the tangential force is at most this times the reaction"},
    {"surface", "penalty", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED,
     .unit = "force/length",
     .meaning =
         "soft: a particle behind the surface by d is pushed back with this times d; not for "
         "chains"},
    {"path", "velocity", FW_FORM_NUMBERS, .layout = "[x, y]", AT(fw_path, velocity),
     .default_value = "[0, 0]", .unit = "length/time", .meaning = "constant during the window"},
    {"path", "from", FW_FORM_NUMBER, .needs = "velocity", AT(fw_path, from), .default_value = "0",
     .unit = "time", .meaning = "when the velocity begins"},
    {"path", "until", FW_FORM_NUMBER, .needs = "velocity", AT(fw_path, until),
     .default_value = "1e15", .default_meaning = "never", .unit = "time",
     .meaning = "when it ends"},
    {"path", "amplitude", FW_FORM_NUMBERS, .layout = "[x, y]", .needs = "period",
     AT(fw_path, amplitude), .default_value = "[0, 0]", .unit = "length",
     .meaning = "of an oscillation on top"},
    {"path", "period", FW_FORM_NUMBER, .needs = "amplitude", ABOVE_ZERO, AT(fw_path, period),
     .default_meaning = "no oscillation", .unit = "time", .meaning = "of the oscillation"},
    {"path", "phase", FW_FORM_ANGLE, .needs = "period", FROM_TO(-360, 360), AT(fw_path, phase),
     .default_value = "0", .unit = "degrees", .meaning = "of the oscillation at time 0"},

    {"force", "body", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `bodies`"},
    {"force", "sites", SELECTION, .default_value = "all", NOT_STORED,
     .meaning = "which of its particles"},
    {"force", "force", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .unit = "force", .meaning = "on each particle"},
    {"force", "total", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .unit = "force", .meaning = "shared equally among the particles"},
    {"force", "acceleration", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .unit = "length/time^2", .meaning = "times the mass of each particle, as gravity"},
    {"force", "random", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, AT(fw_scenario_force, random),
     .unit = "force",
     .meaning = "on each particle and in each step anew: both components uniform between minus and "
                "plus this"},
    {"force", "balanced", FW_FORM_FLAG, .needs = "random", AT(fw_scenario_force, balanced),
     .default_value = "false", .meaning = "the random forces of a step add up to zero"},
    {"force", "from", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_scenario_force, from),
     .default_value = "0", .unit = "steps", .meaning = "first step in which it acts"},
    {"force", "until", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_force, until),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "first step in which it no longer acts"},
    {"force", "ramp", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_scenario_force, ramp),
     .default_value = "0", .unit = "steps",
     .meaning = "grows to its full size over so many steps after `from`"},
    {"force", "period", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_force, period),
     .default_meaning = "constant", .unit = "steps",
     .meaning = "times sin(360 step / period + phase)"},
    {"force", "phase", FW_FORM_ANGLE, .needs = "period", FROM_TO(-360, 360),
     AT(fw_scenario_force, phase), .default_value = "0", .unit = "degrees", .meaning = "at step 0"},

    /* --- grips, phases, profile, study --- */
    {"grip", "body", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `bodies`"},
    {"grip", "sites", SELECTION, .default_value = "all", NOT_STORED,
     .meaning = "which of its particles; each is in one grip at most"},
    {"grip", "side", FW_FORM_WORD, .words = "left|right|bottom|top", .needs = "layer",
     AT(fw_scenario_grip, side), .default_value = "left",
     .meaning = "outer face that the layer is measured from"},
    {"grip", "layer", FW_FORM_NUMBER, .needs = "side", ABOVE_ZERO, AT(fw_scenario_grip, layer),
     .default_meaning = "all the `sites`", .unit = "length",
     .meaning = "only what is so near to the outermost particles of that side"},
    DRIVE("grip", fw_scenario_grip),
    {"phase", "until", FW_FORM_INTEGER, REQUIRED, AT_LEAST(1), AT(fw_scenario_phase, until),
     .unit = "steps", .meaning = "the step that ends it"},
    {"phase", "damping", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_phase, damping),
     .default_meaning = "that of `dynamics`", .unit = "1/time", .meaning = "of movable particles"},
    {"phase", "temperature", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_phase, temperature),
     .default_meaning = "that of `dynamics`", .unit = "energy", .meaning = "of movable particles"},
    {"phase", "grips", FW_FORM_NAMED, .subsection = "phase-grip", .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "each as driven by itself", .meaning = "other drives, by name of the grip"},
    DRIVE("phase-grip", fw_phase_drive),
    {"phase", "pistons", FW_FORM_NAMED, .subsection = "phase-piston", .most = FW_NAMED_MAX,
     NOT_STORED, .default_meaning = "each as driven by itself",
     .meaning = "other drives, by name of the wall that is a piston"},
    {"phase-piston", "damping", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_phase_piston, damping),
     .default_meaning = "the piston's own", .unit = "1/time",
     .meaning = "rate at which its velocity decays"},
    DRIVE("phase-piston", fw_phase_piston),
    {"profile", "axis", FW_FORM_WORD, .words = "x|y", AT(fw_scenario_profile, axis),
     .default_value = "x", .meaning = "the coordinate that is cut into bins"},
    {"profile", "phase", FW_FORM_NAME, AT(fw_scenario_profile, phase),
     .default_meaning = "the whole run", .meaning = "during which samples are taken"},
    {"profile", "every", FW_FORM_INTEGER, REQUIRED, AT_LEAST(1), AT(fw_scenario_profile, every),
     .unit = "steps", .meaning = "between two samples"},
    {"profile", "bin", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_profile, bin),
     .default_value = "1", .unit = "length",
     .meaning = "width of a bin; one is centred on the middle"},
    {"profile", "middle", FW_FORM_NUMBER, AT(fw_scenario_profile, middle), .default_value = "0",
     .unit = "length", .meaning = "where the contact is"},
    {"profile", "window", FW_FORM_NUMBERS, .layout = "[from, to]", AT(fw_scenario_profile, window),
     .default_value = "[0, 0]", .default_meaning = "all", .unit = "length",
     .meaning = "of the other coordinate: only particles in it count"},
    {"profile", "contact", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_profile, contact),
     .default_value = "1.8", .unit = "length",
     .meaning = "the contact region is what is nearer to the middle than this"},
    {"profile", "far", FW_FORM_NUMBERS, .layout = "[from, to]", AT_LEAST(0),
     AT(fw_scenario_profile, far), .default_value = "[6, 9]", .unit = "length",
     .meaning = "distances from the middle between which a place is far from the contact"},
    {"study", "seeds", FW_FORM_INTEGER, FROM_TO(1, 1024), AT(fw_scenario_study, seeds),
     .default_value = "1", .meaning = "how many runs, with `run.seed` and the numbers after it"},
    {"study", "control", FW_FORM_LIST, .items = FW_FORM_TEXT, .least = 1, .most = 64, NOT_STORED,
     .default_meaning = "none",
     .meaning = "changes, as `--set` has them, that turn the experiment into its control; that is "
                "run with the same seeds"},
    {"study", "sweep", FW_FORM_MAPPING, .subsection = "sweep", NOT_STORED,
     .default_meaning = "none", .meaning = "the whole study once for each of several values"},
    {"sweep", "parameter", FW_FORM_NAME, REQUIRED, AT(fw_scenario_sweep, parameter),
     .meaning = "a name of your own for what is varied"},
    {"sweep", "unit", FW_FORM_TEXT, AT(fw_scenario_sweep, unit), .default_meaning = "none",
     .meaning = "of the parameter, for the axis of pictures"},
    {"sweep", "values", FW_FORM_LIST, .items = FW_FORM_NUMBER, .least = 1, .most = 1024, REQUIRED,
     NOT_STORED, .meaning = "of the parameter, all different, in the order in which they are run"},
    {"sweep", "set", FW_FORM_LIST, .items = FW_FORM_TEXT, .least = 1, .most = 64, NOT_STORED,
     .default_meaning = "required without `case`",
     .meaning = "changes, as `--set` has them; in their values the parameter, or a number times it "
                "as `24*A`, stands for its value"},
    {"sweep", "case", FW_FORM_NUMBER, NOT_STORED, .default_meaning = "all of them",
     .meaning = "the only value to be run, as a study by itself"},

    /* --- running and recording --- */
    {"dynamics", "time-step", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_dynamics, time_step),
     .default_value = "0.005", .unit = "time",
     .meaning = "below the limit that the stiffest bond sets, about 0.1"},
    {"dynamics", "damping", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_dynamics, damping),
     .default_value = "0", .unit = "1/time", .meaning = "eta/m: rate at which velocities decay"},
    {"dynamics", "temperature", FW_FORM_NUMBER, AT_LEAST(0), AT(fw_scenario_dynamics, temperature),
     .default_value = "0", .unit = "energy",
     .meaning = "k_B T of the heat bath, which acts where there is damping"},
    {"dynamics", "strength-across", FW_FORM_NUMBER, AT_LEAST(0),
     AT(fw_scenario_dynamics, strength_across), .default_value = "1",
     .meaning = "factor on the potential between movable particles of different bodies"},
    {"dynamics", "bond-radius", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_dynamics, bond_radius),
     .default_value = "1.25", .unit = "length",
     .meaning = "what counts as a bond where order and coordination are measured"},
    {"dynamics", "overlap-energy", FW_FORM_NUMBER, AT_LEAST(0),
     AT(fw_scenario_dynamics, overlap_energy), .default_value = "100", .unit = "energy",
     .meaning = "a pair of movable particles that starts with more is refused"},
    {"run", "steps", FW_FORM_INTEGER, REQUIRED, AT_LEAST(1), AT(fw_scenario_run, steps),
     .unit = "steps", .meaning = "length of the run"},
    {"run", "record-every", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_run, record_every),
     .default_meaning = "a 200th of `steps`", .unit = "steps",
     .meaning =
         "between two frames in the results file; the start and the end are always recorded"},
    {"run", "measure-every", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_run, measure_every),
     .default_value = "1", .unit = "steps",
     .meaning = "between two values of the observables; the start and the end are always measured"},
    {"run", "checkpoint-every", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_run, checkpoint_every),
     .default_meaning = "about once a minute", .unit = "steps",
     .meaning = "between two checkpoints"},
    {"run", "seed", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_scenario_run, seed), .default_value = "1",
     .meaning = "of everything random; the same seed gives the same run, to the last bit"},
    {"run", "limit", FW_FORM_NUMBER, ABOVE_ZERO, AT(fw_scenario_run, limit), .default_value = "1e6",
     .unit = "length",
     .meaning = "a particle further than this from where site [0, 0] of the first body began stops "
                "the run"},
    {"run", "reverse-at", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_run, reverse_at),
     .default_meaning = "never", .unit = "steps",
     .meaning =
         "after so many steps the arrow of time is turned: every body runs back the way it came"},
    {"record", "velocity", FW_FORM_FLAG, AT(fw_scenario_record, velocity), .default_value = "true",
     .meaning = "velocities"},
    {"record", "force", FW_FORM_FLAG, AT(fw_scenario_record, force), .default_value = "false",
     .meaning = "external and contact forces"},
    {"record", "fields", FW_FORM_LIST, .items = FW_FORM_NAME, .most = 64,
     AT(fw_scenario_record, fields), .default_meaning = "none",
     .meaning = "fields of the solids, by name"},

    /* --- what is expected, and pictures --- */
    {"expectation", "quantity", FW_FORM_NAME, REQUIRED, AT(fw_expectation, quantity),
     .meaning = "an observable"},
    {"expectation", "body", FW_FORM_NAME, AT(fw_expectation, body),
     .default_meaning = "the whole scene, or the only body", .meaning = "of which body"},
    {"expectation", "wall", FW_FORM_NAME, AT(fw_expectation, wall),
     .default_meaning = "the only one", .meaning = "of which wall"},
    {"expectation", "grip", FW_FORM_NAME, AT(fw_expectation, grip),
     .default_meaning = "the only one", .meaning = "of which grip"},
    {"expectation", "phase", FW_FORM_NAME, AT(fw_expectation, phase),
     .default_meaning = "the whole run",
     .meaning = "during which phase, in place of `from` and `until`"},
    {"expectation", "analysis", FW_FORM_NAME, AT(fw_expectation, analysis),
     .default_meaning = "the only one", .meaning = "of which analysis"},
    {"expectation", "site", FW_FORM_INTEGERS, .layout = "[i, j]", .needs = "body",
     AT(fw_expectation, site), .default_meaning = "not of a single site",
     .meaning = "of which of the body's sites"},
    {"expectation", "component", FW_FORM_NAME, AT(fw_expectation, component),
     .default_meaning = "the only one", .meaning = "`x`, `y`, `xx`, ..."},
    {"expectation", "at", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_expectation, at),
     .default_meaning = "see `statistic`", .unit = "steps",
     .meaning = "its value after so many steps, which must be measured there"},
    {"expectation", "statistic", FW_FORM_WORD,
     .words = "last|first|maximum|minimum|largest|mean|spread|change|rate|"
              "time-of-maximum|time-of-minimum",
     AT(fw_expectation, statistic), .default_value = "last",
     .meaning = "what of its values over time; largest: in magnitude; spread: standard deviation; "
                "change: last minus first; rate: least-squares slope against time"},
    {"expectation", "from", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_expectation, from),
     .default_value = "0", .unit = "steps", .meaning = "first step that `statistic` looks at"},
    {"expectation", "until", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_expectation, until),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "last step that `statistic` looks at"},
    {"expectation", "when", FW_FORM_NUMBER, NOT_STORED, .default_meaning = "every case of a sweep",
     .meaning = "the value of a sweep's parameter for which it is expected"},
    {"expectation", "value", FW_FORM_NUMBER, AT(fw_expectation, value),
     .default_meaning = "only bounds", .meaning = "what it should be"},
    {"expectation", "within", FW_FORM_NUMBER, .needs = "value", AT_LEAST(0), NOT_STORED,
     .default_meaning = "see `within-relative`", .meaning = "by how much it may differ"},
    {"expectation", "within-relative", FW_FORM_NUMBER, .needs = "value", AT_LEAST(0), NOT_STORED,
     .default_meaning = "see `within`",
     .meaning = "by how much it may differ, as a part of `value`"},
    {"expectation", "below", FW_FORM_NUMBER, AT(fw_expectation, below),
     .default_meaning = "no bound", .meaning = "it must be smaller"},
    {"expectation", "above", FW_FORM_NUMBER, AT(fw_expectation, above),
     .default_meaning = "no bound", .meaning = "it must be larger"},
    {"expectation", "trend", FW_FORM_WORD, .words = "rises|falls", NOT_STORED,
     .default_meaning = "none",
     .meaning = "over a sweep: from each value to the next larger one its mean rises (falls) by "
                "more than the standard error of the difference, and than 1e-9 of its size"},
    {"expectation", "source", FW_FORM_TEXT, AT(fw_expectation, source), .default_meaning = "none",
     .meaning = "where the expected number comes from"},
    {"expectation", "note", FW_FORM_TEXT, AT(fw_expectation, note), .default_meaning = "none",
     .meaning = "a remark for the table of results"},

    {"picture", "kind", FW_FORM_WORD, .words = FW_PICTURE_WORDS, REQUIRED,
     AT(fw_scenario_picture, kind), .meaning = FW_PICTURE_MEANINGS},
    {"picture", "title", FW_FORM_TEXT, AT(fw_scenario_picture, title),
     .default_meaning = "the scenario's", .meaning = "written above it"},
    {"picture", "instants", FW_FORM_LIST, .items = FW_FORM_INTEGER, .least = 1, .most = 1024,
     AT_LEAST(0), NOT_STORED, .default_meaning = "chosen by the program", .unit = "steps",
     .meaning = "which are drawn, ascending"},
    {"picture", "field", FW_FORM_NAME, AT(fw_scenario_picture, field),
     .default_meaning = "the first that is recorded, else return-force or the solid's first",
     .meaning = "field of the solid that is drawn as colour; it is recorded without being "
                "named in `record`"},
    {"picture", "range", FW_FORM_NUMBERS, .layout = "[low, high]", AT(fw_scenario_picture, range),
     .default_meaning = "from the least to the greatest value of all recorded frames",
     .meaning = "ends of the colour scale"},
    {"picture", "observables", FW_FORM_LIST, .items = FW_FORM_PATH, .most = 64,
     AT(fw_scenario_picture, observables),
     .default_meaning = "the energies; of a sweep, what is expected",
     .meaning =
         "curves of a series: a quantity, as `elongation`, of one body or wall, as "
         "`elongation.chain`, or one component, as `elongation.x`, `elongation.chain.x`; of a "
         "sweep: quantities of `expect`, or measures of the layer"},
    {"picture", "from", FW_FORM_INTEGER, AT_LEAST(0), AT(fw_scenario_picture, from),
     .default_value = "0", .unit = "steps", .meaning = "first step of a series"},
    {"picture", "until", FW_FORM_INTEGER, AT_LEAST(1), AT(fw_scenario_picture, until),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "last step of a series"},
    {"picture", "logarithmic", FW_FORM_FLAG, AT(fw_scenario_picture, logarithmic),
     .default_value = "false", .meaning = "the values of a series on logarithmic axes"},
    {"picture", "analysis", FW_FORM_NAME, AT(fw_scenario_picture, analysis),
     .default_meaning = "the only one", .meaning = "which analysis is drawn"},

    /* --- what is computed without running --- */
    {"analysis", "stability-map", FW_FORM_MAPPING, .subsection = "stability-map", ALTERNATIVE,
     NOT_STORED, .meaning = "which c1 and c2 are stable"},
    {"analysis", "dispersion", FW_FORM_MAPPING, .subsection = "dispersion", ALTERNATIVE, NOT_STORED,
     .meaning = "frequencies, simulated and in closed form"},
    {"analysis", "plane-mode", FW_FORM_MAPPING, .subsection = "plane-mode", ALTERNATIVE, NOT_STORED,
     .meaning = "speeds and polarisations of one wave vector"},
    {"analysis", "body-stability", FW_FORM_MAPPING, .subsection = "body-stability", ALTERNATIVE,
     NOT_STORED, .meaning = "of a boundary rule"},
    {"analysis", "boltzmann-reference", FW_FORM_MAPPING, .subsection = "boltzmann-reference",
     ALTERNATIVE, NOT_STORED, .meaning = "two solids that are one"},
    {"stability-map", "c1", FW_FORM_NUMBERS, .layout = "[from, to]", REQUIRED, FROM_TO(0, 10),
     AT(fw_scenario_analysis, c1), .unit = "spacings/step", .meaning = "both included"},
    {"stability-map", "c2", FW_FORM_NUMBERS, .layout = "[from, to]", REQUIRED, FROM_TO(0, 10),
     AT(fw_scenario_analysis, c2), .unit = "spacings/step", .meaning = "both included"},
    {"stability-map", "points", FW_FORM_INTEGERS, .layout = "[c1, c2]", FROM_TO(1, 1025),
     AT(fw_scenario_analysis, points), .default_value = "[65, 65]",
     .meaning = "of the map, ends included"},
    {"stability-map", "waves", FW_FORM_INTEGER, FROM_TO(4, 1024), AT(fw_scenario_analysis, waves),
     .default_value = "64",
     .meaning = "so many times so many wave vectors, multiples of 2 pi/waves; a multiple of 4 has "
                "the worst one, (pi/2, pi/2)"},
    {"dispersion", "material", FW_FORM_NAME, REQUIRED, NOT_STORED,
     .meaning = "one of `materials`, an elastic automaton"},
    {"dispersion", "size", FW_FORM_INTEGER, FROM_TO(4, 256), AT(fw_scenario_analysis, size),
     .default_value = "32", .unit = "sites",
     .meaning = "columns and rows of the periodic body, even; wave vectors are multiples of 2 "
                "pi/size"},
    {"dispersion", "steps", FW_FORM_INTEGER, FROM_TO(1, 100000), AT(fw_scenario_analysis, steps),
     .default_value = "64", .unit = "steps", .meaning = "that each wave runs"},
    {"plane-mode", "material", FW_FORM_NAME, REQUIRED, NOT_STORED,
     .meaning = "one of `materials`, an elastic automaton"},
    {"plane-mode", "wave-vector", FW_FORM_NUMBERS, .layout = "[i, j]", REQUIRED,
     AT(fw_scenario_analysis, wave_vector), .unit = "radians per site", .meaning = "not zero"},
    {"body-stability", "c1", FW_FORM_NUMBER, REQUIRED, AT_LEAST(0), AT(fw_scenario_analysis, c1),
     .unit = "spacings/step", .meaning = "as in the material"},
    {"body-stability", "c2", FW_FORM_NUMBER, REQUIRED, AT_LEAST(0), AT(fw_scenario_analysis, c2),
     .unit = "spacings/step", .meaning = "as in the material"},
    {"body-stability", "boundary", FW_FORM_WORD, .words = "bond|trapezoid|mirror", REQUIRED,
     AT(fw_scenario_analysis, boundary), .meaning = "as in the material"},
    {"body-stability", "rectangle", FW_FORM_INTEGERS, .layout = "[columns, rows]", REQUIRED,
     AT_LEAST(1), AT(fw_scenario_analysis, rectangle), .unit = "sites",
     .meaning = "at most 400 cells"},
    {"boltzmann-reference", "body", FW_FORM_NAME, REQUIRED, NOT_STORED,
     .meaning = "one of `bodies`, of Chopard's automaton with boundary `bond`, on which no force "
                "acts"},
    {"boltzmann-reference", "half-steps", FW_FORM_INTEGER, FROM_TO(1, 10000000),
     AT(fw_scenario_analysis, ticks), .default_value = "1000", .meaning = "that are compared"},
    {.section = NULL}};
