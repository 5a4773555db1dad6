/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checksum.c - checksums of files that are open. Keeps no state. */
#include "experiments/storage/checksum.h"

#include <errno.h>
#include <sys/types.h>
#include <unistd.h>

int fw_read_bytes(int descriptor, void *bytes, uint64_t first, uint64_t count)
{
    for (uint64_t done = 0; done < count;) {
        const ssize_t moved =
            pread(descriptor, (char *)bytes + done, count - done, (off_t)(first + done));
        if (moved < 0 && errno == EINTR) continue;
        if (moved <= 0) return moved < 0 ? errno : EIO;
        done += (uint64_t)moved;
    }
    return 0;
}

int fw_checksum_file(int descriptor, uint64_t first, uint64_t count, uint64_t *checksum)
{
    enum { BLOCK = 65536 };
    unsigned char block[BLOCK];
    for (uint64_t done = 0; done < count;) {
        const size_t next = count - done < BLOCK ? (size_t)(count - done) : BLOCK;
        const int reason = fw_read_bytes(descriptor, block, first + done, next);
        if (reason != 0) return reason;
        *checksum = fw_checksum_add(*checksum, block, next);
        done += next;
    }
    return 0;
}
