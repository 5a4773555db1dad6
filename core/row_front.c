/* SPDX-License-Identifier: GPL-3.0-or-later */
/* row_front.c - fronts of rows, and the wedges between them. Keeps no state. Start reading at
 * fw_row_front_run(). */
#include "core/row_front.h"

#include <assert.h>
#include <stdint.h>

typedef struct front {
    int rows, ticks, strips;
    fw_row_front_move *move;
    void *context;
} front;

/* The first row of a strip, or one past the last row of all. */
static int begin_of(const front *f, int strip)
{
    return (int)((int64_t)f->rows * strip / f->strips);
}

static void move_strip(const front *f, int strip)
{
    const int begin = begin_of(f, strip), end = begin_of(f, strip + 1);
    const int left = strip > 0, right = strip < f->strips - 1;
    for (int head = begin; head < end + f->ticks - 1; ++head)
        for (int tick = 0; tick < f->ticks; ++tick) {
            const int row = head - tick;
            if (row >= begin + left * tick && row < end - right * tick)
                f->move(f->context, tick, row);
        }
}

/* What the strips on both sides of a row have left. */
static void fill_wedge(const front *f, int middle)
{
    for (int tick = 1; tick < f->ticks; ++tick)
        for (int row = middle - tick; row < middle + tick; ++row) f->move(f->context, tick, row);
}

int fw_row_front_strips(int rows, int ticks, int threads)
{
    const int room = rows / (2 * ticks); /* wedges must not meet */
    return threads < room ? threads : room > 1 ? room : 1;
}

void fw_row_front_run(int rows, int ticks, int strips, fw_row_front_move *move, void *context)
{
    const front f = {rows, ticks, strips, move, context};
    assert(ticks > 0 && (strips == 1 || 2 * strips * ticks <= rows));
#pragma omp parallel for schedule(static, 1) num_threads(strips) if (strips > 1)
    for (int strip = 0; strip < strips; ++strip) move_strip(&f, strip);
#pragma omp parallel for schedule(static, 1) num_threads(strips) if (strips > 2)
    for (int strip = 1; strip < strips; ++strip) fill_wedge(&f, begin_of(&f, strip));
}
