/* SPDX-License-Identifier: GPL-3.0-or-later */
/* citation.c - the table of citations. Keeps no state. Start reading at fw_citation_print(). */
#include "citation.h"

#include "experiments/results/provenance.h"

#include <string.h>

typedef struct citation {
    const char *key; /* of the BibTeX entry; NULL ends the table */
    const char *entry;
    const char *authors; /* a scenario whose source names them rests on it; NULL: none does */
    /* Does the scenario rest on it, beside by its materials and its source? NULL: no. */
    bool (*needed)(const fw_scenario *scenario);
} citation;

static const fw_material_model *model_of(const fw_scenario *scenario, int material)
{
    return fw_material_model_of(scenario->materials[material].kind);
}

static bool has_material_of(const fw_scenario *scenario, const char *key)
{
    for (int n = 0; n < scenario->material_count; ++n) {
        const char *own = model_of(scenario, n)->citation;
        if (own && strcmp(own, key) == 0) return true;
    }
    return false;
}

static bool names_source(const fw_scenario *scenario, const char *authors)
{
    return authors && scenario->source && strstr(scenario->source, authors);
}

static bool has_reference_solid(const fw_scenario *scenario)
{
    for (int n = 0; n < scenario->analysis_count; ++n)
        if (scenario->analyses[n].kind == FW_ANALYSIS_BOLTZMANN_REFERENCE) return true;
    return false;
}

static bool moves_particles(const fw_scenario *scenario)
{
    for (int n = 0; n < scenario->material_count; ++n)
        if (model_of(scenario, n)->has_dynamics) return true;
    return false;
}

/* Particles are moved by BAOAB in phases with damping, by velocity Verlet in those without. */
static bool has_phase(const fw_scenario *scenario, bool damped)
{
    if (!moves_particles(scenario)) return false;
    if (scenario->phase_count == 0) return (scenario->dynamics.damping > 0) == damped;
    for (int n = 0; n < scenario->phase_count; ++n) {
        const double own = scenario->phases[n].damping;
        if (((own < 0 ? scenario->dynamics.damping : own) > 0) == damped) return true;
    }
    return false;
}

static bool uses_verlet(const fw_scenario *scenario)
{
    return has_phase(scenario, false);
}

static bool uses_baoab(const fw_scenario *scenario)
{
    return has_phase(scenario, true);
}

static bool has_random_pattern(const fw_patterns *patterns)
{
    for (int n = 0; n < patterns->count; ++n)
        if (patterns->item[n].kind == FW_PATTERN_RANDOM) return true;
    return false;
}

static bool has_bath(const fw_scenario *scenario)
{
    bool warm = scenario->dynamics.temperature > 0;
    for (int n = 0; n < scenario->phase_count; ++n) warm |= scenario->phases[n].temperature > 0;
    return warm && uses_baoab(scenario);
}

static bool is_random(const fw_scenario *scenario)
{
    for (int n = 0; n < scenario->force_count; ++n)
        if (scenario->forces[n].kind == FW_FORCE_RANDOM) return true;
    for (int n = 0; n < scenario->body_count; ++n) {
        const fw_scenario_body *body = &scenario->bodies[n];
        if (body->shape.kind == FW_SHAPE_PLACED || body->temperature > 0 ||
            has_random_pattern(&body->displacement) || has_random_pattern(&body->velocities))
            return true;
    }
    return has_bath(scenario);
}

static bool has_walls(const fw_scenario *scenario)
{
    return scenario->wall_count > 0;
}

static bool always(const fw_scenario *scenario)
{
    (void)scenario;
    return true;
}

static const citation citations[] = {
    {"chopard2002",
     "@unpublished{chopard2002,\n"
     "  author = {Chopard, B. and Marconi, S.},\n"
     "  title  = {Mechanical properties of a Lattice Boltzmann solid body},\n"
     "  note   = {January 22, 2002},\n"
     "  year   = {2002}\n"
     "}\n",
     "Chopard & Marconi", has_reference_solid},
    {"popov2007",
     "@article{popov2007,\n"
     "  author  = {Popov, V. L. and Filippov, A. E.},\n"
     "  title   = {Method of movable lattice particles},\n"
     "  journal = {Tribology International},\n"
     "  volume  = {40},\n"
     "  pages   = {930--936},\n"
     "  year    = {2007},\n"
     "  note    = {Copyright 2006 by Elsevier}\n"
     "}\n",
     "Popov & Filippov", NULL},
    {"dong2012",
     "@misc{dong2012,\n"
     "  author        = {Dong, Yinfeng and Zhang, Guangcai and Xu, Aiguo and Gan, Yanbiao},\n"
     "  title         = {Cellular automata model for elastic solid material},\n"
     "  note          = {Accepted by Communications in Theoretical Physics},\n"
     "  archiveprefix = {arXiv},\n"
     "  eprint        = {1211.1732},\n"
     "  year          = {2012}\n"
     "}\n",
     "Dong et al.", NULL},
    {"swope1982",
     "@article{swope1982,\n"
     "  author  = {Swope, William C. and Andersen, Hans C. and Berens, Peter H. and Wilson, Kent "
     "R.},\n"
     "  title   = {A computer simulation method for the calculation of equilibrium constants for "
     "the\n"
     "             formation of physical clusters of molecules: Application to small water "
     "clusters},\n"
     "  journal = {The Journal of Chemical Physics},\n"
     "  volume  = {76},\n"
     "  pages   = {637--649},\n"
     "  year    = {1982},\n"
     "  doi     = {10.1063/1.442716}\n"
     "}\n",
     NULL, uses_verlet},
    {"leimkuhler2013",
     "@article{leimkuhler2013,\n"
     "  author  = {Leimkuhler, Benedict and Matthews, Charles},\n"
     "  title   = {Rational Construction of Stochastic Numerical Methods for Molecular Sampling},\n"
     "  journal = {Applied Mathematics Research eXpress},\n"
     "  volume  = {2013},\n"
     "  pages   = {34--56},\n"
     "  year    = {2013},\n"
     "  doi     = {10.1093/amrx/abs010}\n"
     "}\n",
     NULL, uses_baoab},
    {"salmon2011",
     "@inproceedings{salmon2011,\n"
     "  author    = {Salmon, John K. and Moraes, Mark A. and Dror, Ron O. and Shaw, David E.},\n"
     "  title     = {Parallel random numbers: as easy as 1, 2, 3},\n"
     "  booktitle = {Proceedings of 2011 International Conference for High Performance Computing,\n"
     "               Networking, Storage and Analysis (SC '11)},\n"
     "  year      = {2011},\n"
     "  doi       = {10.1145/2063384.2063405}\n"
     "}\n",
     NULL, is_random},
    {"catto2020",
     "@misc{catto2020,\n"
     "  author = {Catto, Erin},\n"
     "  title  = {{Box2D}, a {2D} physics engine for games, version 2.4.1},\n"
     "  url    = {https://box2d.org},\n"
     "  year   = {2020}\n"
     "}\n",
     NULL, has_walls},
    {"debuyl2014",
     "@article{debuyl2014,\n"
     "  author  = {de Buyl, Pierre and Colberg, Peter H. and H{\\\"o}fling, Felix},\n"
     "  title   = {{H5MD}: A structured, efficient, and portable file format for molecular data},\n"
     "  journal = {Computer Physics Communications},\n"
     "  volume  = {185},\n"
     "  pages   = {1546--1553},\n"
     "  year    = {2014},\n"
     "  doi     = {10.1016/j.cpc.2014.01.018}\n"
     "}\n",
     NULL, always},
    {.key = NULL}};

static bool rests_on(const fw_scenario *scenario, const citation *c)
{
    return has_material_of(scenario, c->key) || names_source(scenario, c->authors) ||
           (c->needed && c->needed(scenario));
}

void fw_citation_print(FILE *out, const fw_scenario *scenario)
{
    const fw_provenance now = fw_provenance_now();
    fprintf(out,
            "@software{fretwork,\n"
            "  author  = {{The Fretwork contributors}},\n"
            "  title   = {Fretwork: contact and friction experiments on lattice solids},\n"
            "  version = {%s},\n"
            "  note    = {Revision %s}\n"
            "}\n",
            now.version, now.revision);
    for (const citation *c = citations; c->key; ++c)
        if (rests_on(scenario, c)) fprintf(out, "\n%s", c->entry);
}
