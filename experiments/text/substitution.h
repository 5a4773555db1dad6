/* SPDX-License-Identifier: GPL-3.0-or-later */
/* substitution.h - a change of a scenario with a parameter in it, and a number in its place. */
#ifndef FW_SUBSTITUTION_H
#define FW_SUBSTITUTION_H

#include <stddef.h>

/* Room that fw_substitution_write may need for a setting of so many bytes. */
size_t fw_substitution_room(size_t length);

/* Writes KEY=VALUE with `value` for every word of VALUE that is the parameter, as A or -A or with a
 * number before it, as 24*A; a word ends at blanks, commas, brackets, braces and quotes, and is
 * left alone where it is a key. Returns how many words that were: 0 leaves the setting as it is. */
int fw_substitution_write(const char *setting, const char *parameter, double value, char *out);

#endif
