/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rub.h - Coulomb friction of one particle on one wall. */
#ifndef FW_RUB_H
#define FW_RUB_H

#include "rows.h"

/* Friction on the one row that is active, or that was in the step before (lambda = 0 now). Returns
 * the tangential force, and puts lambda and w to what they are with it. */
double constrain_rub(constrain_problem *p, constrain_row *r, const fw_candidate *all,
                     fw_contact_memory *memory);

#endif
