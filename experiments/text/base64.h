/* SPDX-License-Identifier: GPL-3.0-or-later */
/* base64.h - bytes as letters (RFC 4648), written piece by piece. */
#ifndef FW_BASE64_H
#define FW_BASE64_H

#include <stddef.h>
#include <stdio.h>

typedef struct fw_base64 {
    FILE *out;
    unsigned char left[3]; /* bytes that wait for a third */
    int count;
} fw_base64;

fw_base64 fw_base64_begin(FILE *out);
void fw_base64_write(fw_base64 *letters, const void *bytes, size_t count);
/* What is left, with its '='. */
void fw_base64_end(fw_base64 *letters);

#endif
