/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile_value.c - what the sums of a profile say, bin by bin. Keeps no state. Start reading at
 * fw_profile_value(). */
#include "profile_parts.h"

#include <math.h>

const fw_profile_column_row fw_profile_columns[FW_PROFILE_COLUMNS] = {
    [FW_PROFILE_RETURN_FORCE] = {"return-force", "force",
                                 "mean length of a particle's net return force (Eqs 24, 25)"},
    [FW_PROFILE_BOND_FORCE] = {"bond-return-force", "force",
                               "mean length of the return force of a single bond"},
    [FW_PROFILE_ORDER] = {"order", "1", "mean of |psi_n| over particles"},
    [FW_PROFILE_DENSITY] = {"density", "1/length^2", "particles per area"},
    [FW_PROFILE_TEMPERATURE] = {"temperature", "energy/k_B",
                                "m v^2/2 relative to the mean of the bin in each sample; of "
                                "what no grip holds"},
    [FW_PROFILE_DRIFT] = {"drift-velocity", "length/time",
                          "root mean square over samples of the bin's mean velocity along the bin"},
    [FW_PROFILE_BOND_BREAKING] = {"bond-breaking-rate", "1/time",
                                  "bonds broken per particle and time: once closer than the bond "
                                  "radius, now 1.2 times further apart"},
    [FW_PROFILE_RELATIVE_DISPLACEMENT] = {"relative-displacement", "length^2",
                                          "mean square change of a bond's vector over one unit of "
                                          "time, r0 (m/epsilon)^(1/2)"},
    [FW_PROFILE_DIFFUSIVITY] = {"diffusivity", "length^2/time",
                                "across the bins: growth of the mean square relative displacement "
                                "of bonded particles between 1 and 4 units of time, over 4"},
};

int fw_profile_bin_count(const fw_profile *profile)
{
    return profile->bin_count;
}

double fw_profile_edge(const fw_profile *profile, int bin)
{
    return profile->plan.middle + (profile->first_bin + bin - .5) * profile->plan.bin;
}

int64_t fw_profile_sample_count(const fw_profile *profile)
{
    return profile->samples;
}

static double over(double sum, double count)
{
    return count > 0 ? sum / count : NAN;
}

static int row_of(const fw_profile *p, int bin)
{
    return bin >= 0 ? bin : p->bin_count + (bin == FW_PROFILE_FAR);
}

/* Time that particles were looked at, one after the other. */
static double looked_at(const fw_profile *p, const double *sums)
{
    return p->history ? sums[SUM_LOOKS] * (double)p->history->look * p->time_step : 0;
}

double fw_profile_least_breaking(const fw_profile *p, int bin)
{
    return over(1, looked_at(p, p->sums[row_of(p, bin)]));
}

/* Two walkers move apart twice as fast as one alone: <(x_i - x_j)^2> grows as 4 D t. */
static double diffusivity(const fw_profile *p, const double *sums)
{
    if (!p->history) return NAN;
    const double early = over(sums[SUM_ACROSS], sums[SUM_CHANGED]);
    const double late = over(sums[SUM_ACROSS_LATE], sums[SUM_CHANGED_LATE]);
    const double lag = (double)p->history->lag * p->time_step;
    return (late - early) / (4 * (FW_HISTORY_LAGS - 1) * lag);
}

double fw_profile_value(const fw_profile *p, int bin, fw_profile_column column)
{
    const int row = row_of(p, bin);
    const double *sums = p->sums[row];
    const double width = bin >= 0                    ? p->plan.bin
                         : bin == FW_PROFILE_CONTACT ? 2 * p->plan.contact
                                                     : 2 * (p->plan.far[1] - p->plan.far[0]);
    const double area = width * (p->window_high - p->window_low);
    switch (column) {
    case FW_PROFILE_RETURN_FORCE:
        return over(sums[SUM_RETURN_FORCE], sums[SUM_PARTICLES]);
    case FW_PROFILE_BOND_FORCE:
        return over(sums[SUM_BOND_FORCE], sums[SUM_BONDED]);
    case FW_PROFILE_ORDER:
        return over(sums[SUM_ORDER], sums[SUM_PARTICLES]);
    case FW_PROFILE_DENSITY:
        return over(sums[SUM_PARTICLES], (double)p->samples * area);
    case FW_PROFILE_TEMPERATURE:
        return over(sums[SUM_HEAT], sums[SUM_FREEDOM]);
    case FW_PROFILE_DRIFT:
        return sqrt(over(sums[SUM_DRIFT], sums[SUM_PARTICLES]));
    case FW_PROFILE_BOND_BREAKING:
        return over(sums[SUM_BROKEN], looked_at(p, sums));
    case FW_PROFILE_RELATIVE_DISPLACEMENT:
        return over(sums[SUM_CHANGE], sums[SUM_CHANGED]);
    case FW_PROFILE_DIFFUSIVITY:
        return diffusivity(p, sums);
    case FW_PROFILE_COLUMNS:
        break;
    }
    return NAN;
}
