/* SPDX-License-Identifier: GPL-3.0-or-later */
/* structure.c - Fourier sums over points. Keeps no state. */
#include "core/particles/structure.h"

#include "core/particles/return_force.h"

#include <math.h>
#include <stdlib.h>

fw_status fw_structure_map(const double *x, const double *y, int count, double first, double step,
                           int points, double *values, fw_error *error)
{
    const size_t size = (size_t)points;
    /* e^{i q . r} = e^{i qx x} e^{i qy y}: the factors of each point are made once. */
    fw_phase *sum = calloc(size * size, sizeof *sum), *along = calloc(size, sizeof *along);
    if (!sum || !along) {
        free(sum);
        free(along);
        return fw_fail_memory(error, "a map of the structure factor");
    }
    for (int i = 0; i < count; ++i) {
        for (int a = 0; a < points; ++a) {
            const double phase = (first + a * step) * x[i];
            along[a] = (fw_phase){cos(phase), sin(phase)};
        }
        for (int b = 0; b < points; ++b) {
            const double phase = (first + b * step) * y[i];
            const fw_phase across = {cos(phase), sin(phase)};
            fw_phase *row = sum + (size_t)b * size;
            for (int a = 0; a < points; ++a) {
                const fw_phase term = fw_phase_product(along[a], across);
                row[a].cosine += term.cosine;
                row[a].sine += term.sine;
            }
        }
    }
    const double square = (double)count * count;
    for (size_t k = 0; k < size * size; ++k)
        values[k] = (sum[k].cosine * sum[k].cosine + sum[k].sine * sum[k].sine) / square;
    free(sum);
    free(along);
    return FW_OK;
}
