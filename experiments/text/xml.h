/* SPDX-License-Identifier: GPL-3.0-or-later */
/* xml.h - text that stays text within XML. */
#ifndef FW_XML_H
#define FW_XML_H

#include <stdio.h>

/* In an element or in an attribute between double quotes. Control characters, which no XML may
 * hold, become blanks. */
void fw_xml_write_text(FILE *out, const char *text);

#endif
