/* SPDX-License-Identifier: GPL-3.0-or-later */
/* base64.c - three bytes are four letters. */
#include "experiments/text/base64.h"

#include <string.h>

static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

static void write_three(FILE *out, const unsigned char bytes[3], int count)
{
    const unsigned bits = (unsigned)bytes[0] << 16 | (unsigned)bytes[1] << 8 | bytes[2];
    char letters[4];
    for (int k = 0; k < 4; ++k) letters[k] = k <= count ? alphabet[bits >> (18 - 6 * k) & 63] : '=';
    fwrite(letters, 1, sizeof letters, out);
}

fw_base64 fw_base64_begin(FILE *out)
{
    return (fw_base64){.out = out};
}

void fw_base64_write(fw_base64 *letters, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t n = 0; n < count; ++n) {
        letters->left[letters->count++] = byte[n];
        if (letters->count < 3) continue;
        write_three(letters->out, letters->left, 3);
        letters->count = 0;
    }
}

void fw_base64_end(fw_base64 *letters)
{
    if (letters->count == 0) return;
    memset(letters->left + letters->count, 0, (size_t)(3 - letters->count));
    write_three(letters->out, letters->left, letters->count);
    letters->count = 0;
}
