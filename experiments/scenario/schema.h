/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema.h - one table says what every key of a scenario is; checking, filling in, and the printed
 * reference all follow it.
 *
 * A section is a set of keys that may stand together in a mapping; the scenario itself is the
 * section "scenario", and a key whose value is a mapping names the section inside. The table is in
 * schema_keys.c, which is where to start reading. */
#ifndef FW_SCHEMA_H
#define FW_SCHEMA_H

#include "experiments/text/document.h"

/* What the value of a key may be, and what fw_schema_fill stores for it. */
typedef enum fw_form {
    FW_FORM_TEXT = 1 << 0,      /* const char * */
    FW_FORM_WORD = 1 << 1,      /* one of `words`: int, counted from 0 */
    FW_FORM_NAME = 1 << 2,      /* fw_scenario_name */
    FW_FORM_FLAG = 1 << 3,      /* true or false: bool */
    FW_FORM_NUMBER = 1 << 4,    /* double */
    FW_FORM_ANGLE = 1 << 5,     /* degrees: double, in radians */
    FW_FORM_INTEGER = 1 << 6,   /* int64_t */
    FW_FORM_NUMBERS = 1 << 7,   /* so many as `layout` has: double[], or fw_vec2 */
    FW_FORM_INTEGERS = 1 << 8,  /* so many as `layout` has: int[], or fw_site */
    FW_FORM_SYMMETRIC = 1 << 9, /* v, [xx, xy, yy] or [[xx, xy], [xy, yy]]: fw_sym2 */
    FW_FORM_LIST = 1 << 10,     /* of `items`; stored only if they are names: fw_scenario_names */
    FW_FORM_MAPPING = 1 << 11,  /* with the keys of section `subsection`: the section's object */
    FW_FORM_SELECTION = FW_FORM_WORD | FW_FORM_LIST | FW_FORM_MAPPING, /* not stored */
    FW_FORM_NAMED = 1 << 12, /* names of the user's own, each with a mapping: not stored */
    FW_FORM_PATH = 1 << 13   /* names with '.' between them: as FW_FORM_NAME */
} fw_form;

typedef enum fw_bounds {
    FW_UNBOUNDED = 0,
    FW_ABOVE = 1, /* low < value; for a symmetric matrix with low = 0: positive definite */
    FW_FROM = 2,  /* low <= value */
    FW_UP_TO = 4, /* value <= high */
    FW_BELOW = 8  /* value < high */
} fw_bounds;

/* The largest size of a number whatever its bounds: no length, speed or force anybody means is
 * larger, and its square is far from overflow. */
#define FW_NUMBER_MAX 1e15
/* The same for whole numbers, and for those that come in a list, which are sites. */
#define FW_INTEGER_MAX    1e12
#define FW_COORDINATE_MAX 16777216
#define FW_NOT_STORED     SIZE_MAX

typedef struct fw_key {
    const char *section; /* NULL ends the table */
    const char *name;
    unsigned forms; /* several may be allowed */
    unsigned items; /* forms of the items of a list */
    const char
        *subsection;    /* section of the mapping, of the named mappings, or of a list's items */
    const char *words;  /* "left|right" */
    const char *layout; /* "[x, y]": of numbers and integers, and of a list's items */
    unsigned bounds;
    double low, high;
    const char *hint;            /* ends the sentence that refuses a value */
    int least, most;             /* items of a list, and names; most 0: FW_ITEMS_MAX */
    bool required;               /* must be there */
    bool alternative;            /* exactly one of the section's alternatives must be there */
    const char *needs;           /* makes sense only together with this key */
    const char *default_value;   /* the default, as it would be written */
    const char *default_meaning; /* what happens without the key, where that is not one value */
    const char *unit;
    const char *meaning;
    size_t offset; /* offset in the section's object, or FW_NOT_STORED: the reader takes it up
                      itself */
} fw_key;

typedef struct fw_section {
    const char *name;    /* NULL ends the table */
    const char *heading; /* in the reference */
    const char *noun;    /* "a body" */
    const char *meaning;
} fw_section;

enum { FW_ITEMS_MAX = 1 << 20, FW_NAMED_MAX = 1024 };

/* A key that had another name: who writes the old one is told the new one. */
typedef struct fw_renamed_key {
    const char *section; /* NULL ends the table */
    const char *old_name, *name;
} fw_renamed_key;

extern const fw_key fw_schema_keys[];
extern const fw_section fw_schema_sections[];
extern const fw_renamed_key fw_schema_renamed[];

const fw_key *fw_schema_find(const char *section, const char *name);
const fw_section *fw_schema_section(const char *name);

/* Is the whole tree what the table says of that section ("scenario")? FW_BAD_INPUT with place,
 * value and what was expected. */
fw_status fw_schema_check(const fw_document *document, const char *section, fw_error *error);

/* Is `key` one of the section? FW_BAD_INPUT with the key that may have been meant; `path` leads
 * to the mapping ("" for the root). */
fw_status fw_schema_check_key(const fw_document *document, const char *section, const char *path,
                              const char *key, fw_place place, fw_error *error);

/* Stores the values of a checked mapping, and the defaults of keys that are not there, in `object`.
 * Mapping NULL: all defaults. Memory for lists is the document's; FW_SYSTEM_FAILED without. */
fw_status fw_schema_fill(fw_document *document, const char *section, const fw_node *mapping,
                         void *object, fw_error *error);

/* Values of a checked node. */
double fw_node_number(const fw_node *node);
int64_t fw_node_integer(const fw_node *node);
int fw_node_word(const fw_node *node, const char *words);
/* Writes the items of a list of numbers. */
void fw_node_numbers(const fw_node *list, double *values);

/* "one of left, right, top" for the sentences; writes at most `size` bytes. */
void fw_schema_list_words(const char *words, char *out, size_t size);
/* "a number above 0": what a key's value should be. */
void fw_schema_expected(const fw_key *key, char *out, size_t size);

/* The complete reference as Markdown. FW_SYSTEM_FAILED where `out` cannot be written. */
fw_status fw_schema_print(FILE *out, fw_error *error);

#endif
