/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_lb.c - how fast an LB body moves: million particle steps per second, next to the rate of
 * plain memory streams of as many bytes in the same run. The ratio carries over between machines,
 * the rates do not. Usage: bench_lb [SIDE [STEPS]] */
#include "core/boltzmann/lb_solid.h"
#include "tests/support/steps.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Bytes that one step of one particle reads and writes: eight slots and two coordinates both ways,
 * the inverse mass once. */
enum { BYTES = 2 * 10 * 8 + 8 };

/* a += b over `count` doubles: 24 bytes per element. */
static double stream_rate(size_t count)
{
    double *a = fw_array_of_doubles(count), *b = fw_array_of_doubles(count);
    double best = 0;
    for (int round = 0; round < 5 && a && b; ++round) {
        double start = clock_now();
        for (size_t n = 0; n < count; ++n) a[n] += b[n];
        double rate = 24.0 * (double)count / (clock_now() - start);
        best = rate > best ? rate : best;
        b[round] = a[round] + 1;
    }
    free(a);
    free(b);
    return best;
}

int main(int count, char **words)
{
    int side = count > 1 ? atoi(words[1]) : 1024, steps = count > 2 ? atoi(words[2]) : 40;
    fw_sites sites;
    fw_error error;
    fw_lb_solid_def def = fw_lb_solid_def_default();
    fw_solid *solid;
    if (fw_sites_rectangle(&sites, side, side, &error) != FW_OK) return 2;
    def.sites = &sites;
    if (fw_lb_solid_create(&solid, &def, &error) != FW_OK) return 2;
    double stream = stream_rate(1 << 24);
    printf("%d x %d particles, %d bytes per particle step, stream %.3g GB/s\n", side, side,
           (int)BYTES, stream * 1e-9);
    for (int threads = 1; threads <= 2; ++threads) {
        omp_set_num_threads(threads);
        advance_free(solid);
        double start = clock_now();
        for (int n = 0; n < steps; ++n) advance_free(solid);
        double rate = (double)steps * side * side / (clock_now() - start);
        printf("%d thread%s: %.4g million particle steps/s, %.2f of the stream\n", threads,
               threads > 1 ? "s" : " ", rate * 1e-6, rate * BYTES / stream);
    }
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
    return 0;
}
