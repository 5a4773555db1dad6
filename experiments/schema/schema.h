/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema.h - the form of the tables that say what the keys of a scenario are; checking, filling in,
 * --set options and the printed reference all follow them.
 *
 * A section is a set of keys that may stand together in a mapping; a key whose value is a mapping
 * points to the section of its keys. The tables themselves are elsewhere: each part of a scenario
 * has its sections beside its reader, scenario_PART.c; the root, from which all others can be
 * reached, is fw_scenario_section in scenario.c. To add a key: a row in the section it belongs to,
 * and the member that it is stored in. */
#ifndef FW_SCHEMA_H
#define FW_SCHEMA_H

#include "experiments/text/document.h"

/* What the value of a key may be, and what fw_schema_fill stores for it. */
typedef enum fw_form {
    FW_FORM_TEXT = 1 << 0,      /* const char * */
    FW_FORM_WORD = 1 << 1,      /* one of `words`: int, its value */
    FW_FORM_NAME = 1 << 2,      /* fw_schema_name */
    FW_FORM_FLAG = 1 << 3,      /* true or false: bool */
    FW_FORM_NUMBER = 1 << 4,    /* double */
    FW_FORM_ANGLE = 1 << 5,     /* degrees: double, in radians */
    FW_FORM_INTEGER = 1 << 6,   /* int64_t */
    FW_FORM_NUMBERS = 1 << 7,   /* so many as `layout` has: double[], or fw_vec2 */
    FW_FORM_INTEGERS = 1 << 8,  /* so many as `layout` has: int[], or fw_site */
    FW_FORM_SYMMETRIC = 1 << 9, /* v, [xx, xy, yy] or [[xx, xy], [xy, yy]]: fw_sym2 */
    FW_FORM_LIST = 1 << 10,     /* of `items`; stored only if they are names: fw_schema_names */
    FW_FORM_MAPPING = 1 << 11,  /* with the keys of section `subsection`: the section's object */
    FW_FORM_SELECTION = FW_FORM_WORD | FW_FORM_LIST | FW_FORM_MAPPING, /* not stored */
    FW_FORM_NAMED = 1 << 12,    /* names of the user's own, each with a mapping: not stored */
    FW_FORM_PATH = 1 << 13,     /* names with '.' between them: as FW_FORM_NAME */
    FW_FORM_POINT = 1 << 14,    /* names of the user's own, each with a number: not stored */
    FW_FORM_CONSTANTS = 1 << 15 /* the same, at the root: formulas may name them */
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

/* A word, and what it is stored as: of some enum, whose order need not be that of the words. */
typedef struct fw_word {
    const char *name; /* NULL ends a list */
    int value;
} fw_word;

typedef struct fw_section fw_section;

typedef struct fw_key {
    const char *name;             /* NULL ends the keys of a section */
    unsigned forms;               /* several may be allowed */
    unsigned items;               /* forms of the items of a list */
    const fw_section *subsection; /* of the mapping, of the named mappings, or of a list's items */
    const fw_word *words;
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
    const char *old_name; /* what it was called before: its refusal names the new one */
    size_t place;         /* in the section's object: 1 + offset, or FW_NOT_STORED; 0: forgotten */
    size_t size;          /* of what is stored there; 0: an object with the keys of `subsection` */
} fw_key;

/* Where a value goes. Each of these sets the form too, and does not compile where the member is of
 * another type than the form is stored as. */
#define FW_NOT_STORED SIZE_MAX
#define FW_FITS(fits) (0 * sizeof(char[(fits) ? 1 : -1]))
#define FW_PLACE(object, member, fits)                                                             \
    .place = 1 + offsetof(object, member) + FW_FITS(fits), .size = sizeof(((object *)0)->member)
#define FW_IS(object, member, type) _Generic(((object *)0)->member, type : 1, default : 0)
#define AT_TEXT(object, member)                                                                    \
    .forms = FW_FORM_TEXT, FW_PLACE(object, member, FW_IS(object, member, const char *))
#define AT_NAME(object, member)                                                                    \
    .forms = FW_FORM_NAME, FW_PLACE(object, member, FW_IS(object, member, fw_schema_name))
#define AT_NAMES(form, object, member)                                                             \
    .forms = FW_FORM_LIST, .items = (form),                                                        \
    FW_PLACE(object, member, FW_IS(object, member, fw_schema_names))
#define AT_FLAG(object, member)                                                                    \
    .forms = FW_FORM_FLAG, FW_PLACE(object, member, FW_IS(object, member, bool))
#define AT_NUMBER(object, member)                                                                  \
    .forms = FW_FORM_NUMBER, FW_PLACE(object, member, FW_IS(object, member, double))
#define AT_ANGLE(object, member)                                                                   \
    .forms = FW_FORM_ANGLE, FW_PLACE(object, member, FW_IS(object, member, double))
#define AT_INTEGER(object, member)                                                                 \
    .forms = FW_FORM_INTEGER, FW_PLACE(object, member, FW_IS(object, member, int64_t))
#define AT_NUMBERS(object, member)                                                                 \
    .forms = FW_FORM_NUMBERS, FW_PLACE(object, member, FW_IS(object, member, double *))
#define AT_VEC2(object, member)                                                                    \
    .forms = FW_FORM_NUMBERS, FW_PLACE(object, member, FW_IS(object, member, fw_vec2))
#define AT_INTEGERS(object, member)                                                                \
    .forms = FW_FORM_INTEGERS, FW_PLACE(object, member, FW_IS(object, member, int *))
#define AT_SITE(object, member)                                                                    \
    .forms = FW_FORM_INTEGERS, FW_PLACE(object, member, FW_IS(object, member, fw_site))
#define AT_SYMMETRIC(object, member)                                                               \
    .forms = FW_FORM_SYMMETRIC, FW_PLACE(object, member, FW_IS(object, member, fw_sym2))
/* An enum, which is an int or unsigned. */
#define AT_WORD(object, member)                                                                    \
    .forms = FW_FORM_WORD,                                                                         \
    FW_PLACE(object, member, _Generic(((object *)0)->member, int : 1, unsigned : 1, default : 0))
/* The object of the subsection. */
#define AT_OBJECT(object, member) .forms = FW_FORM_MAPPING, .place = 1 + offsetof(object, member)
/* The keys of the subsection go into the same object. */
#define AT_SAME    .forms = FW_FORM_MAPPING, .place = 1
#define NOT_STORED .place = FW_NOT_STORED

#define WORDS(...)                                                                                 \
    .words = (const fw_word[])                                                                     \
    {                                                                                              \
        __VA_ARGS__,                                                                               \
        {                                                                                          \
            NULL, 0                                                                                \
        }                                                                                          \
    }
#define REQUIRED                  .required = true
#define ALTERNATIVE               .alternative = true
#define ABOVE_ZERO                .bounds = FW_ABOVE, .low = 0
#define AT_LEAST(least)           .bounds = FW_FROM, .low = (least)
#define FROM_TO(least, most)      .bounds = FW_FROM | FW_UP_TO, .low = (least), .high = (most)
#define FROM_TO_BELOW(least, end) .bounds = FW_FROM | FW_BELOW, .low = (least), .high = (end)

struct fw_section {
    const char *heading; /* in the reference */
    const char *noun;    /* "a body" */
    const char *meaning;
    const fw_key *keys;
    /* Keys that stand in the rows of a table, before the others; see FW_ROWS. */
    const fw_key *rows;
    size_t row_count, row_size;
};

/* The member `key` of each row of a table, which has as many rows as it is declared with. */
#define FW_ROWS(table)                                                                             \
    .rows = &(table)[0].key, .row_count = sizeof(table) / sizeof((table)[0]),                      \
    .row_size = sizeof((table)[0])

enum { FW_ITEMS_MAX = 1 << 20, FW_NAMED_MAX = 1024, FW_SECTIONS_MAX = 128 };

/* A text that is looked up later, and where it stands. */
typedef struct fw_schema_name {
    const char *text; /* NULL: not given */
    fw_place place;
} fw_schema_name;

typedef struct fw_schema_names {
    int count;
    fw_schema_name *item;
} fw_schema_names;

/* The keys of a section in order: `for (key = first(s); key; key = next(s, key))`. */
const fw_key *fw_section_first(const fw_section *section);
const fw_key *fw_section_next(const fw_section *section, const fw_key *key); /* NULL: the last */
const fw_key *fw_section_find(const fw_section *section, const char *name);  /* NULL: none */

/* The root and all sections below it, each once, in the order of the reference; returns how many.
 */
int fw_schema_sections(const fw_section *root, const fw_section *sections[FW_SECTIONS_MAX]);

/* Is the whole tree what the table says of that section? FW_BAD_INPUT with place,
 * value and what was expected. A formula where a number may be gets its value: of the constants
 * that stand there now, whatever it was before. */
fw_status fw_schema_check(fw_document *document, const fw_section *section, fw_error *error);

/* Is `key` one of the section? FW_BAD_INPUT with the key that may have been meant; `path` leads
 * to the mapping ("" for the root). */
fw_status fw_schema_check_key(const fw_document *document, const fw_section *section,
                              const char *path, const char *key, fw_place place, fw_error *error);

/* Stores the values of a checked mapping, and the defaults of keys that are not there, in `object`.
 * Mapping NULL: all defaults. Memory for lists is the document's; FW_SYSTEM_FAILED without. */
fw_status fw_schema_fill(fw_document *document, const fw_section *section, const fw_node *mapping,
                         void *object, fw_error *error);

/* Values of a checked node. */
double fw_node_number(const fw_node *node);
int64_t fw_node_integer(const fw_node *node);
int fw_node_word(const fw_node *node, const fw_word *words); /* its value */
/* Writes the items of a list of numbers. */
void fw_node_numbers(const fw_node *list, double *values);

/* "one of left, right, top" for the sentences; writes at most `size` bytes. */
void fw_schema_list_words(const fw_word *words, char *out, size_t size);
/* "a number above 0": what a key's value should be. */
void fw_schema_expected(const fw_key *key, char *out, size_t size);

/* Visits every key at the root and below, by its whole path: "run.steps", "walls.NAME.path" for
 * names of the user's own, "expect.N.quantity" for items. A section that several keys lead to is
 * visited once for each of them. */
enum { FW_SCHEMA_PATH = 256 };
typedef void (*fw_schema_visit)(void *object, const char *path, const fw_key *key);
void fw_schema_walk(const fw_section *root, fw_schema_visit visit, void *object);

/* The complete reference as Markdown. FW_SYSTEM_FAILED where `out` cannot be written. */
fw_status fw_schema_print(const fw_section *root, FILE *out, fw_error *error);

#endif
