/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_write.c - what it costs to hand frames to the system and nothing else:
 *     bench_write FILE [TRIALS [BYTES]]
 * writes ten frames of 48 MB into a file that has its room already, and prints for each trial how
 * many frames that makes in a second of processor time. tests/bench/run puts it beside `frames`. */
#include "tests/bench/timing.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { FRAMES = 10 };

static int write_all(int file, const char *from, size_t bytes, off_t place)
{
    while (bytes > 0) {
        const ssize_t done = pwrite(file, from, bytes, place);
        if (done <= 0) return -1;
        from += done;
        place += done;
        bytes -= (size_t)done;
    }
    return 0;
}

static int measure(const char *path, size_t bytes)
{
    char *frame = malloc(bytes);
    const int file = open(path, O_RDWR | O_CREAT | O_TRUNC, 0600);
    if (!frame || file < 0 || posix_fallocate(file, 0, (off_t)(FRAMES * bytes)) != 0) return -1;
    memset(frame, 1, bytes);
    const double begun = processor_seconds();
    for (int n = 0; n < FRAMES; ++n)
        if (write_all(file, frame, bytes, (off_t)((size_t)n * bytes)) != 0) return -1;
    printf("%.4g\n", FRAMES / (processor_seconds() - begun));
    fflush(stdout);
    close(file);
    free(frame);
    return unlink(path);
}

int main(int count, char **words)
{
    const int trials = count > 2 ? atoi(words[2]) : 3;
    const size_t bytes = count > 3 ? (size_t)atof(words[3]) : 48000000;
    if (count < 2) return 2;
    for (int trial = 0; trial < trials; ++trial)
        if (measure(words[1], bytes) != 0) {
            perror(words[1]);
            return 1;
        }
    return 0;
}
