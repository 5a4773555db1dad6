/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_certificate.c - the items of a run's certificate, so far. Keeps no state. */
#include "experiments/measures/quantity.h"

#include <math.h>

static double worst_of(fw_subject subject, fw_certificate_item item)
{
    return subject.observer ? subject.observer->certificate.worst[item] : NAN;
}

#define MEASURES(function, item)                                                                   \
    static void function(const fw_experiment *experiment, fw_subject subject, double *out)         \
    {                                                                                              \
        (void)experiment;                                                                          \
        out[0] = worst_of(subject, item);                                                          \
    }
MEASURES(penetration, FW_CERTIFICATE_PENETRATION)
MEASURES(energy, FW_CERTIFICATE_ENERGY)
MEASURES(momentum, FW_CERTIFICATE_MOMENTUM)
MEASURES(overstep, FW_CERTIFICATE_OVERSTEP)
MEASURES(creep, FW_CERTIFICATE_CREEP)
MEASURES(unconverged, FW_CERTIFICATE_UNCONVERGED)
MEASURES(unresolved, FW_CERTIFICATE_UNRESOLVED)

/* clang-format off */
const fw_quantity fw_certificate_quantities[] = {
    {"certificate-penetration", FW_SCOPE_SCENE, "", "length", "the deepest that any particle lay behind a wall or in another body, of all frames and samples so far", NULL, penetration, "there is nothing to enter", FW_NEEDS_NO_POSITIONS},
    {"certificate-energy", FW_SCOPE_SCENE, "", "1", "the largest energy-error of all frames and samples so far", NULL, energy, NULL, FW_NEEDS_NO_POSITIONS},
    {"certificate-momentum", FW_SCOPE_SCENE, "", "1", "the largest momentum-error so far, over the largest impulse, or (2 M E)^(1/2), M the mass of all bodies and E the largest energy or work", NULL, momentum, NULL, FW_NEEDS_NO_POSITIONS},
    {"certificate-overstep", FW_SCOPE_SCENE, "", "1", "the most by which friction went beyond its cone so far, as a part of the widest one of that step", NULL, overstep, "nothing rubs", FW_NEEDS_NO_POSITIONS},
    {"certificate-creep", FW_SCOPE_SCENE, "", "length", "the furthest that any particle moved along a wall or an edge while it stuck to it", NULL, creep, "nothing rubs", FW_NEEDS_NO_POSITIONS},
    {"certificate-unconverged", FW_SCOPE_SCENE, "", "1", "steps so far in which normals or friction of bodies that touch did not settle: gaps, or the bound of friction, are inexact there", NULL, unconverged, "no bodies keep out of each other", FW_NEEDS_NO_POSITIONS},
    {"certificate-unresolved", FW_SCOPE_SCENE, "", "1", "contacts with walls so far in which no consistent set of them was found", NULL, unresolved, "there is no wall", FW_NEEDS_NO_POSITIONS},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
