/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checksum.h - FNV-1a, by which damage to a file is noticed: any change of a single byte changes
 * it, others go unnoticed once in 2^64. It is no protection from somebody who reckons it anew. */
#ifndef FW_CHECKSUM_H
#define FW_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

#define FW_CHECKSUM_OF_NOTHING UINT64_C(14695981039346656037)

static inline uint64_t fw_checksum_add(uint64_t checksum, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < count; ++i) checksum = (checksum ^ byte[i]) * UINT64_C(1099511628211);
    return checksum;
}

/* Exactly `count` bytes from byte `first` of an open file on; 0, or errno. */
int fw_read_bytes(int descriptor, void *bytes, uint64_t first, uint64_t count);
/* Goes on from `*checksum` with `count` bytes from byte `first` of an open file on; 0, or errno. */
int fw_checksum_file(int descriptor, uint64_t first, uint64_t count, uint64_t *checksum);

#endif
