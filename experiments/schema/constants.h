/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constants.h - named numbers of a scenario, and formulas of them where numbers may be. */
#ifndef FW_CONSTANTS_H
#define FW_CONSTANTS_H

#include "experiments/schema/schema.h"
#include "experiments/text/formula.h"

enum { FW_CONSTANTS_MAX = 256 };

typedef struct fw_constants {
    int count;
    fw_variable *items; /* names and values; of the document, as are the names */
} fw_constants;

/* Those of a mapping of names, each with a number or a formula of others, in any order; NULL:
 * there are none. Values take the place of formulas. FW_BAD_INPUT with the path `key`: a name that
 * cannot be one, a formula that is wrong, constants that need each other. */
fw_status fw_constants_read(fw_constants *constants, fw_document *document, const char *key,
                            fw_node *mapping, fw_error *error);

/* Where a number is expected and a formula is written, its value takes its place: 24*A, or
 * "max(A, B)" in quotes where YAML needs them. A value that was made before is made again. What is
 * no formula is left alone, for others to judge. FW_BAD_INPUT with `path`. */
fw_status fw_constants_resolve(const fw_constants *constants, fw_document *document, fw_node *node,
                               const char *path, fw_error *error);

#endif
