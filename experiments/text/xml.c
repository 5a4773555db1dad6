/* SPDX-License-Identifier: GPL-3.0-or-later */
/* xml.c - the five characters that mean something. Keeps no state. */
#include "experiments/text/xml.h"

void fw_xml_write_text(FILE *out, const char *text)
{
    for (; *text; ++text) {
        switch (*text) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc((unsigned char)*text < ' ' || *text == 127 ? ' ' : *text, out);
        }
    }
}
