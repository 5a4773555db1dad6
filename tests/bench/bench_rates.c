/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_rates.c - how fast bodies move, in one trial after the other:
 *     bench_rates [--clock] NAME [TRIALS [SIDE]]
 * prints for each trial our rate and, where the peer is a plain stream of memory or another body of
 * ours, the peer's, both in million particles a second of processor time on one core.
 * tests/bench/run knows the names and puts LAMMPS beside those that have no peer here. */
#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/instruction_set.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

#include "tests/bench/timing.h"
#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include <string.h>

typedef struct fw_case {
    const char *name;
    int side;                         /* columns and rows of a body */
    fw_solid *(*make)(int side);      /* what is measured */
    double bytes;                     /* of the stream that a particle is compared with, or 0 */
    fw_solid *(*make_peer)(int side); /* instead of a stream, or NULL */
    int together;                     /* so many free steps at once; 0: one, positions included */
} fw_case;

/* --- bodies --- */

/* Lennard-Jones has its minimum at 1 here and at 2^(1/6) there. */
#define LONG_CUT  (2.5 / 1.122462048309373)
#define SHORT_CUT 1.5

typedef struct fw_crystals {
    double cut, fading; /* where the potential ends, and over which range it fades before */
    double temperature, amplitude;
    int bodies;
    bool shuffled;
} fw_crystals;

static void shuffle(fw_crowd *crowd)
{
    for (int i = crowd->count - 1; i > 0; --i) {
        const double draw = fw_noise_uniform(7, (uint32_t)i, 0, 3).x * 0.5 + 0.5;
        const int j = (int)(draw * (i + 1));
        const fw_vec2 kept = crowd->at[i];
        crowd->at[i] = crowd->at[j];
        crowd->at[j] = kept;
    }
}

/* side x side particles in one crystal, or in two of half the rows that slide upon each other. */
static fw_solid *crystals_of(int side, fw_crystals what)
{
    fw_crowd crowds[2];
    fw_particle_group_def groups[2];
    fw_vec2 *velocities[2] = {NULL, NULL};
    static const char *const names[] = {"lower", "upper"};
    const int rows = side / what.bodies;
    for (int g = 0; g < what.bodies; ++g) {
        const fw_vec2 origin = {0.3 * g, g * rows * 0.8660254037844386};
        crowds[g] = crowd_rectangle(side, rows, origin, 1, 0, 1);
        if (what.shuffled) shuffle(&crowds[g]);
        groups[g] = fw_particle_group_def_default();
        groups[g].name = names[g];
        groups[g].count = crowds[g].count;
        groups[g].positions = crowds[g].at;
        groups[g].return_force =
            return_force_of(6, what.amplitude, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
        if (what.bodies < 2) continue;
        velocities[g] = malloc((size_t)crowds[g].count * sizeof *velocities[g]);
        for (int i = 0; i < crowds[g].count; ++i)
            velocities[g][i] = (fw_vec2){g == 0 ? -0.1 : 0.1, 0};
        groups[g].velocities = velocities[g];
    }
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = what.bodies;
    def.potential.cut = fw_smooth_cut_over(what.cut - what.fading, what.cut);
    def.controls.time_step = 0.005 / 1.122462048309373;
    if (what.temperature > 0) {
        def.controls.damping = 1;
        def.controls.temperature = what.temperature;
    }
    fw_solid *solid;
    fw_error error;
    if (fw_particles_create(&solid, &def, &error) != FW_OK) {
        puts(error.sentence);
        exit(1);
    }
    if (what.bodies < 2) fw_particles_draw_velocities(solid, -1, 0.1);
    for (int g = 0; g < what.bodies; ++g) {
        free(crowds[g].at);
        free(velocities[g]);
    }
    return solid;
}

#define CRYSTALS(name, ...)                                                                        \
    static fw_solid *name(int side)                                                                \
    {                                                                                              \
        return crystals_of(side, (fw_crystals){__VA_ARGS__});                                      \
    }
/* LAMMPS' potential ends without fading. */
CRYSTALS(long_verlet, LONG_CUT, 0, 0, 0, 1, false)
CRYSTALS(long_langevin, LONG_CUT, 0, 0.1, 0, 1, false)
CRYSTALS(short_verlet, SHORT_CUT, 0, 0, 0, 1, false)
CRYSTALS(short_langevin, SHORT_CUT, 0, 0.1, 0, 1, false)
CRYSTALS(long_return, LONG_CUT, 0, 0.1, 1, 1, false)
CRYSTALS(short_return, SHORT_CUT, 0, 0.1, 1, 1, false)
CRYSTALS(long_rubbing, LONG_CUT, 0, 0.1, 0, 2, false)
CRYSTALS(short_rubbing, SHORT_CUT, 0, 0.1, 0, 2, false)
CRYSTALS(melt, LONG_CUT, 0, 0.1, 0, 1, true)

#define FADING 0.3
CRYSTALS(fading_long_verlet, LONG_CUT, FADING, 0, 0, 1, false)
CRYSTALS(fading_long_langevin, LONG_CUT, FADING, 0.1, 0, 1, false)
CRYSTALS(fading_short_verlet, SHORT_CUT, FADING, 0, 0, 1, false)
CRYSTALS(fading_short_langevin, SHORT_CUT, FADING, 0.1, 0, 1, false)
CRYSTALS(fading_long_return, LONG_CUT, FADING, 0.1, 1, 1, false)
CRYSTALS(fading_short_return, SHORT_CUT, FADING, 0.1, 1, 1, false)
CRYSTALS(fading_long_rubbing, LONG_CUT, FADING, 0.1, 0, 2, false)
CRYSTALS(fading_short_rubbing, SHORT_CUT, FADING, 0.1, 0, 2, false)
CRYSTALS(fading_melt, LONG_CUT, FADING, 0.1, 0, 1, true)

static fw_sites square_of(int side)
{
    fw_sites sites;
    if (fw_sites_rectangle(&sites, side, side, NULL) != FW_OK) exit(1);
    return sites;
}

static fw_sites disc_of(int side)
{
    fw_sites sites;
    if (fw_sites_disc(&sites, FW_SQUARE, 0.5 * side, NULL) != FW_OK) exit(1);
    return sites;
}

/* A body that moves. */
static fw_solid *lb_of(fw_sites sites, fw_lb_form form)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_vec2 *displacement = malloc((size_t)sites.count * sizeof *displacement);
    for (int l = 0; l < sites.count; ++l)
        displacement[l] = (fw_vec2){1e-3 * sin(0.01 * sites.site[l].i), 1e-3 * sites.site[l].j};
    def.sites = &sites;
    def.displacement = displacement;
    def.form = form;
    fw_solid *solid;
    fw_error error;
    if (fw_lb_solid_create(&solid, &def, &error) != FW_OK) {
        puts(error.sentence);
        exit(1);
    }
    free(displacement);
    fw_sites_clear(&sites);
    return solid;
}

static fw_solid *populations(int side)
{
    return lb_of(square_of(side), FW_LB_POPULATIONS);
}

static fw_solid *lb(int side)
{
    return lb_of(square_of(side), FW_LB_DISPLACEMENTS);
}

static fw_solid *lb_disc(int side)
{
    return lb_of(disc_of(side), FW_LB_DISPLACEMENTS);
}

static fw_solid *automaton_of(int side, double break_at)
{
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    fw_sites sites = square_of(side);
    fw_vec2 *displacement = malloc((size_t)sites.count * sizeof *displacement);
    for (int l = 0; l < sites.count; ++l)
        displacement[l] = (fw_vec2){1e-3 * sin(0.01 * sites.site[l].i), 1e-3 * sites.site[l].j};
    def.sites = &sites;
    def.lattice = (fw_lattice){FW_SQUARE, 1, 0, {0, 0}};
    def.displacement = displacement;
    def.break_at = break_at;
    fw_solid *solid;
    fw_error error;
    if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK) {
        puts(error.sentence);
        exit(1);
    }
    free(displacement);
    fw_sites_clear(&sites);
    return solid;
}

static fw_solid *automaton(int side)
{
    return automaton_of(side, INFINITY);
}

static fw_solid *breakable_automaton(int side)
{
    return automaton_of(side, 1e3);
}

static fw_solid *linear(int side)
{
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    fw_sites sites = square_of(side);
    fw_vec2 *velocities = malloc((size_t)sites.count * sizeof *velocities);
    for (int l = 0; l < sites.count; ++l)
        velocities[l] = (fw_vec2){1e-3 * sin(0.01 * sites.site[l].i), 1e-3};
    def.sites = &sites;
    def.velocities = velocities;
    fw_solid *solid;
    fw_error error;
    if (fw_linear_lattice_create(&solid, &def, &error) != FW_OK) {
        puts(error.sentence);
        exit(1);
    }
    free(velocities);
    fw_sites_clear(&sites);
    return solid;
}

static const fw_case cases[] = {
    {"particles-long-verlet", 320, long_verlet, 0, NULL, 0},
    {"particles-long-langevin", 320, long_langevin, 0, NULL, 0},
    {"particles-short-verlet", 320, short_verlet, 0, NULL, 0},
    {"particles-short-langevin", 320, short_langevin, 0, NULL, 0},
    {"returning-long", 320, long_return, 0, NULL, 0},
    {"returning-short", 320, short_return, 0, NULL, 0},
    {"rubbing-long", 320, long_rubbing, 0, NULL, 0},
    {"rubbing-short", 320, short_rubbing, 0, NULL, 0},
    {"melt", 320, melt, 0, NULL, 0},
    {"fading-long-verlet", 320, fading_long_verlet, 0, NULL, 0},
    {"fading-long-langevin", 320, fading_long_langevin, 0, NULL, 0},
    {"fading-short-verlet", 320, fading_short_verlet, 0, NULL, 0},
    {"fading-short-langevin", 320, fading_short_langevin, 0, NULL, 0},
    {"fading-returning-long", 320, fading_long_return, 0, NULL, 0},
    {"fading-returning-short", 320, fading_short_return, 0, NULL, 0},
    {"fading-rubbing-long", 320, fading_long_rubbing, 0, NULL, 0},
    {"fading-rubbing-short", 320, fading_short_rubbing, 0, NULL, 0},
    {"fading-melt", 320, fading_melt, 0, NULL, 0},
    {"linear-lattice", 320, linear, 0, NULL, 0},
    {"lb-populations", 2048, populations, 192, NULL, 0},
    {"lb-stream", 2048, lb, 48, NULL, 1},
    {"lb-sweep", 2048, lb, 48, NULL, 16},
    {"lb-disc", 2048, lb_disc, 0, lb, 1},
    {"lb-disc-sweep", 2048, lb_disc, 0, lb, 16},
    {"automaton-stream", 2048, automaton, 48, NULL, 1},
    {"automaton-sweep", 2048, automaton, 48, NULL, 16},
    {"automaton-breakable", 2048, breakable_automaton, 0, automaton, 16},
};

/* --- trials --- */

/* By the clock, where several threads work; else processor time. */
static bool by_clock;

static double seconds(void)
{
    return by_clock ? clock_seconds() : processor_seconds();
}

/* Million particles a second. */
static double rate_of(fw_solid *solid, int steps, int together)
{
    const double begun = seconds();
    const int ticks = steps * solid->model->ticks_per_step;
    fw_error error;
    if (together == 0)
        for (int tick = 0; tick < ticks; ++tick) advance_free(solid);
    else
        for (int tick = 0; tick < ticks; tick += together)
            assert_moved(fw_solid_move_free(solid, together, &error), &error);
    return 1e-6 * steps * solid->count / (seconds() - begun);
}

/* So many that a trial takes about half a second. */
static int steps_of(fw_solid *solid, int together)
{
    const double rate = rate_of(solid, 16, together);
    const int steps = (int)(0.5e6 * rate / solid->count);
    return steps > 16 ? steps - steps % 16 : 16;
}

static int measure(const fw_case *what, int trials, int side)
{
    fw_solid *ours = what->make(side), *peer = what->make_peer ? what->make_peer(side) : NULL;
    fw_stream stream = {0};
    if (what->bytes > 0) stream = stream_of((size_t)ours->count * 4);
    const int steps = steps_of(ours, what->together),
              peer_steps = peer ? steps_of(peer, what->together) : 0;
    for (int trial = 0; trial < trials; ++trial) {
        const double rate = rate_of(ours, steps, what->together);
        double theirs = NAN;
        if (peer)
            theirs = rate_of(peer, peer_steps, what->together);
        else if (what->bytes > 0)
            theirs = 1e-6 * fmax(stream_rate(&stream), stream_rate(&stream)) / what->bytes;
        printf("%.4g %.4g\n", rate, theirs);
        fflush(stdout);
    }
    if (what->bytes > 0) stream_free(&stream);
    fw_solid_destroy(peer);
    fw_solid_destroy(ours);
    return 0;
}

int main(int count, char **words)
{
    const char *instructions = getenv("FRETWORK_INSTRUCTIONS");
    fw_error error;
    if (instructions && fw_instruction_set_use(instructions, &error) != FW_OK) {
        fprintf(stderr, "%s\n", error.sentence);
        return 2;
    }
    if (count > 1 && strcmp(words[1], "--clock") == 0) {
        by_clock = true;
        ++words;
        --count;
    }
    for (size_t n = 0; count > 1 && n < sizeof cases / sizeof cases[0]; ++n)
        if (strcmp(words[1], cases[n].name) == 0)
            return measure(&cases[n], count > 2 ? atoi(words[2]) : 3,
                           count > 3 ? atoi(words[3]) : cases[n].side);
    printf("# %s\n", fw_instruction_set_name(fw_instruction_set()));
    for (size_t n = 0; n < sizeof cases / sizeof cases[0]; ++n) puts(cases[n].name);
    return count > 1 ? 2 : 0;
}
