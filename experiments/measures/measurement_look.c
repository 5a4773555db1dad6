/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement_look.c - one quantity, measured once. Keeps no state. */
#include "experiments/measures/measurement.h"

#include "measurement_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number of the component that the name asks for behind quantity and subject; -1: all of them. */
static int component_in(const char *name, const fw_probe *probe)
{
    const char *last = strrchr(name, '.');
    if (!last || strcmp(name, probe->label) == 0) return -1;
    return fw_quantity_find_component(probe->quantity, last + 1);
}

static fw_status measure(const fw_observer *observer, const char *name, const fw_measurement *m,
                         double *out, int *count, fw_error *error)
{
    if (m->probe_count == 0)
        return fw_fail(error, FW_BAD_INPUT, "there is nothing to measure %s of", name);
    const fw_probe *probe = &m->probes[0];
    if (m->probe_count > 1)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s is measured of %d things, expected one of them by name, such as %s",
                       name, m->probe_count, probe->label);
    double all[FW_COMPONENTS_MAX];
    probe->quantity->measure(observer->experiment, probe->subject, all);
    const int component = component_in(name, probe);
    *count = component < 0 ? probe->components : 1;
    for (int c = 0; c < *count; ++c) {
        out[c] = all[component < 0 ? c : component];
        if (!isfinite(out[c])) out[c] = NAN;
    }
    return FW_OK;
}

fw_status fw_measurement_look(const fw_observer *observer, const char *name, double *out,
                              int *count, fw_error *error)
{
    fw_measurement m = {0};
    fw_status status =
        fw_measurement_plan_named(&m, observer, (fw_schema_name){.text = name}, error);
    if (status == FW_OK) status = measure(observer, name, &m, out, count, error);
    free(m.probes);
    return status;
}
