/* SPDX-License-Identifier: GPL-3.0-or-later */
/* threads.h - loops that are shared among threads where that pays. */
#ifndef FW_THREADS_H
#define FW_THREADS_H

/* The loop, whose rounds do not depend on each other, on all threads if `many`. Not by OpenMP's own
 * `if`: it makes and ends a team of one thread then, which within a study takes a third of a
 * microsecond and two system calls, as much as the forces on 20 particles. */
#define FW_SHARED_LOOP(many, ...)                                                                  \
    do {                                                                                           \
        if (many) {                                                                                \
            _Pragma("omp parallel for schedule(static)") __VA_ARGS__                               \
        } else {                                                                                   \
            __VA_ARGS__                                                                            \
        }                                                                                          \
    } while (0)

#endif
