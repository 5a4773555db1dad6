/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_boltzmann.c - what can be measured of LB solids only. Keeps no state. */
#include "experiments/measures/quantity.h"

#include "core/boltzmann/lb_dispersion.h"
#include "core/boltzmann/lb_solid.h"

#include <math.h>

#define LB "lattice-boltzmann"

static const fw_solid *body_of(const fw_experiment *experiment, fw_subject subject)
{
    return fw_experiment_solid(experiment, subject.body);
}

/* Outermost columns and rows. */
static void find_frame(const fw_sites *sites, fw_site *low, fw_site *high)
{
    *low = *high = sites->site[0];
    for (int l = 0; l < sites->count; ++l) {
        const fw_site site = sites->site[l];
        low->i = site.i < low->i ? site.i : low->i;
        high->i = site.i > high->i ? site.i : high->i;
        low->j = site.j < low->j ? site.j : low->j;
        high->j = site.j > high->j ? site.j : high->j;
    }
}

/* Energy-weighted mean distance from the middle of the body, along x. */
static void wave_front(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = body_of(experiment, subject);
    const fw_lattice *lattice = &experiment->scenario->bodies[subject.body].lattice;
    const fw_sites *sites = &experiment->bodies[subject.body].sites;
    fw_site low, high;
    double sum = 0, weight = 0;
    find_frame(sites, &low, &high);
    for (int l = 0; l < solid->count; ++l) {
        double share = fw_lb_solid_energy(solid, l);
        sum += share * fabs(sites->site[l].i - 0.5 * ((double)low.i + high.i)) * lattice->spacing;
        weight += share;
    }
    out[0] = weight > 0 ? sum / weight : 0;
}

static void link_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_lb_solid_link_error(body_of(experiment, subject));
}

static void rest_residual(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_lb_solid_rest_residual(body_of(experiment, subject));
}

static void broken_links(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = fw_lb_solid_broken(body_of(experiment, subject));
}

/* Of the material alone: plane waves on a grid of 33 x 33 wave vectors. NaN without memory. */
static fw_lb_spectrum spectrum_of(const fw_experiment *experiment, fw_subject subject)
{
    const fw_scenario *scenario = experiment->scenario;
    int material = scenario->bodies[subject.body].material;
    const fw_sym2 rest_mass = scenario->materials[material].boltzmann.rest_mass;
    fw_lb_spectrum worst;
    const fw_status status = fw_lb_spectrum_over_grid(rest_mass, 33, &worst, NULL);
    return status == FW_OK ? worst : (fw_lb_spectrum){NAN, NAN};
}

static void dispersion_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = spectrum_of(experiment, subject).frequency_error;
}

static void radius_error(const fw_experiment *experiment, fw_subject subject, double *out)
{
    out[0] = spectrum_of(experiment, subject).radius_error;
}

static void deformation_east(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(
        out, fw_lb_solid_deformation(body_of(experiment, subject), subject.particle, FW_EAST));
}

static void deformation_north(const fw_experiment *experiment, fw_subject subject, double *out)
{
    fw_quantity_put(
        out, fw_lb_solid_deformation(body_of(experiment, subject), subject.particle, FW_NORTH));
}

/* e_{i alpha} of Section 9.2: mean deformation of all links along i; order xx xy yx yy. */
static void strain(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = body_of(experiment, subject);
    for (int d = FW_EAST; d <= FW_NORTH; ++d) {
        fw_vec2 sum = {0, 0};
        int count = 0;
        for (int l = 0; l < solid->count; ++l) {
            if (fw_lb_solid_neighbour(solid, l, d) < 0) continue;
            sum = fw_vec2_add(sum, fw_lb_solid_deformation(solid, l, d));
            count += 1;
        }
        fw_quantity_put(out + 2 * d, fw_vec2_scale(count > 0 ? 1.0 / count : 0, sum));
    }
}

/* S_{i alpha} of Section 9.2 with its signs corrected: the external force on the half of the body
 * that lies further along i, minus that on the other half, over two. */
static void stress(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_solid *solid = body_of(experiment, subject);
    const fw_sites *sites = &experiment->bodies[subject.body].sites;
    fw_site low, high;
    find_frame(sites, &low, &high);
    for (int c = 0; c < 4; ++c) out[c] = 0;
    for (int l = 0; l < sites->count; ++l) {
        int right = 2 * sites->site[l].i - low.i - high.i,
            up = 2 * sites->site[l].j - low.j - high.j;
        double side_x = right > 0 ? 0.5 : right < 0 ? -0.5 : 0;
        double side_y = up > 0 ? 0.5 : up < 0 ? -0.5 : 0;
        out[0] += side_x * solid->external_x[l];
        out[1] += side_x * solid->external_y[l];
        out[2] += side_y * solid->external_x[l];
        out[3] += side_y * solid->external_y[l];
    }
}

static void stress_over_strain(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double e[4];
    strain(experiment, subject, e);
    stress(experiment, subject, out);
    for (int c = 0; c < 4; ++c) out[c] = e[c] != 0 ? out[c] / e[c] : NAN;
}

/* clang-format off */
const fw_quantity fw_boltzmann_quantities[] = {
    {"wave-front", FW_SCOPE_BODY, "", "length", "mean distance of the energy from the middle of the body, along x", LB, wave_front, NULL, FW_NEEDS_NOTHING},
    {"link-error", FW_SCOPE_BODY, "", "length", "largest violation of Eq 30 of Chopard and Marconi", LB, link_error, NULL, FW_NEEDS_NOTHING},
    {"rest-residual", FW_SCOPE_BODY, "", "momentum", "largest of what must vanish at rest (Eqs 22-24): Psi + F/2, f_0, f_i + f_{i+2}", LB, rest_residual, NULL, FW_NEEDS_NOTHING},
    {"broken-links", FW_SCOPE_BODY, "", "1", "links broken since the start", LB, broken_links, NULL, FW_NEEDS_NOTHING},
    {"deformation-east", FW_SCOPE_SITE, "x y", "length", "of the link to the neighbour in the east (Eq 31)", LB, deformation_east, NULL, FW_NEEDS_NOTHING},
    {"deformation-north", FW_SCOPE_SITE, "x y", "length", "of the link to the neighbour in the north (Eq 31)", LB, deformation_north, NULL, FW_NEEDS_NOTHING},
    {"strain", FW_SCOPE_BODY, "xx xy yx yy", "length per link", "e of Section 9.2: mean deformation of the links along the first direction", LB, strain, NULL, FW_NEEDS_NOTHING},
    {"stress", FW_SCOPE_BODY, "xx xy yx yy", "force", "S of Section 9.2: half the difference of the external forces on both halves", LB, stress, NULL, FW_NEEDS_NOTHING},
    {"stress-over-strain", FW_SCOPE_BODY, "xx xy yx yy", "force/length", "S/e of Section 9.2", LB, stress_over_strain, "that strain is zero", FW_NEEDS_NOTHING},
    {"dispersion-error", FW_SCOPE_BODY, "", "1", "of the body's material, over 33 x 33 wave vectors: sin^2(omega/2) of the one-step matrix minus the closed form", LB, dispersion_error, NULL, FW_NEEDS_NOTHING},
    {"spectral-radius-error", FW_SCOPE_BODY, "", "1", "of the body's material, over 33 x 33 wave vectors: largest | |lambda|^2 - 1 |", LB, radius_error, NULL, FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
