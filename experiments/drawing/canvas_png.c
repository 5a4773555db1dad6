/* SPDX-License-Identifier: GPL-3.0-or-later */
/* canvas_png.c - the size of a dot, which cairo does not write into its PNG files. Keeps no
 * state. */
#include "canvas_parts.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void put_big_endian(unsigned char *to, uint32_t value)
{
    for (int n = 0; n < 4; ++n) to[n] = (unsigned char)(value >> (24 - 8 * n));
}

/* Of a chunk's name and data (PNG specification, annex D). */
static uint32_t chunk_checksum(const unsigned char *bytes, size_t count)
{
    uint32_t sum = 0xffffffff;
    for (size_t n = 0; n < count; ++n) {
        sum ^= bytes[n];
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum;
}

/* The chunk pHYs stands behind the first one, IHDR: dots per metre along x and y. */
bool fw_canvas_add_dots(byte_store *store, double resolution)
{
    enum { HEAD = 8 + 25, DATA = 9, SIZE = 12 + DATA };
    unsigned char chunk[SIZE] = {0, 0, 0, DATA, 'p', 'H', 'Y', 's'};
    const uint32_t dots = (uint32_t)lround(resolution / 25.4 * 1000);
    put_big_endian(chunk + 8, dots);
    put_big_endian(chunk + 12, dots);
    chunk[16] = 1; /* the metre */
    put_big_endian(chunk + 17, chunk_checksum(chunk + 4, 4 + DATA));
    unsigned char *larger = realloc(store->bytes, store->count + SIZE);
    if (!larger) return false;
    memmove(larger + HEAD + SIZE, larger + HEAD, store->count - HEAD);
    memcpy(larger + HEAD, chunk, SIZE);
    *store = (byte_store){larger, store->count + SIZE, store->count + SIZE};
    return true;
}
