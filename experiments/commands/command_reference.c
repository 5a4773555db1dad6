/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_reference.c - the keys of a scenario file: all of them as Markdown, or those of a name
 * (`damping`) or path (`run.steps`, `walls.floor.path`) in plain lines. Keeps no state. Start
 * reading at fw_command_reference(). */
#include "experiments/commands/command.h"
#include "experiments/scenario/scenario.h"
#include "experiments/text/json.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { EXPECTED_SIZE = 800 };

/* --- which keys --- */

/* Length of the part up to the next '.' or the end. */
static size_t part_of(const char *path)
{
    return strcspn(path, ".");
}

/* Do two paths name the same key? Where the schema has NAME or N, any word will do. */
static bool same_path(const char *path, const char *word)
{
    for (;;) {
        const size_t known = part_of(path), given = part_of(word);
        const bool any =
            (known == 4 && strncmp(path, "NAME", 4) == 0) || (known == 1 && path[0] == 'N');
        if (given == 0 || (!any && (known != given || strncasecmp(path, word, known) != 0)))
            return false;
        path += known;
        word += given;
        if (!*path || !*word) return !*path && !*word;
        path += 1;
        word += 1;
    }
}

/* Is the word the end of the path, cut at a '.'? */
static bool ends_in(const char *path, const char *word)
{
    const size_t length = strlen(path), end = strlen(word);
    if (end == 0 || end > length || strcasecmp(path + length - end, word) != 0) return false;
    return end == length || path[length - end - 1] == '.';
}

static bool is_wanted(const char *word, const char *path, const fw_key *key)
{
    char named[FW_SCHEMA_PATH + 8];
    if (!word || ends_in(path, word) || same_path(path, word)) return true;
    if (!key->subsection || !(key->forms & (FW_FORM_NAMED | FW_FORM_LIST))) return false;
    snprintf(named, sizeof named, "%s.%s", path, key->forms & FW_FORM_NAMED ? "NAME" : "N");
    return same_path(named, word);
}

/* --- how they are printed --- */

typedef struct search {
    const char *word; /* NULL: all */
    int found;
    fw_suggestion suggestion; /* among names of keys */
    fw_json json;
} search;

static const char *default_of(const fw_key *key)
{
    if (key->required) return "none, it must be there";
    if (key->alternative) return "none, one of several must be there";
    return key->default_meaning ? key->default_meaning
           : key->default_value ? key->default_value
                                : "none";
}

static void print_inside(const fw_key *key)
{
    const fw_section *section = key->subsection;
    printf("\n  %s\n\n", section->meaning);
    for (const fw_key *inner = fw_section_first(section); inner;
         inner = fw_section_next(section, inner))
        printf("    %-18s %s\n", inner->name, inner->meaning);
}

static void print_key(void *object, const char *path, const fw_key *key)
{
    search *s = object;
    char expected[EXPECTED_SIZE];
    fw_suggestion_offer(&s->suggestion, key->name);
    if (!is_wanted(s->word, path, key)) return;
    if (s->found > 0) printf("\n");
    s->found += 1;
    fw_schema_expected(key, expected, sizeof expected);
    printf("%s: %s\n  %-8s %s\n", path, key->meaning, "value", expected);
    if (key->unit) printf("  %-8s %s\n", "unit", key->unit);
    printf("  %-8s %s\n", "default", default_of(key));
    if (key->needs) printf("  %-8s %s\n", "needs", key->needs);
    if (key->subsection) print_inside(key);
}

/* {path, key, value, unit, required, alternative, default, otherwise, needs, meaning} */
static void write_key(void *object, const char *path, const fw_key *key)
{
    search *s = object;
    char expected[EXPECTED_SIZE];
    fw_suggestion_offer(&s->suggestion, key->name);
    if (!is_wanted(s->word, path, key)) return;
    s->found += 1;
    fw_schema_expected(key, expected, sizeof expected);
    fw_json_begin(&s->json, NULL, '{');
    fw_json_text(&s->json, "path", path);
    fw_json_text(&s->json, "key", key->name);
    fw_json_text(&s->json, "value", expected);
    fw_json_text(&s->json, "unit", key->unit);
    fw_json_flag(&s->json, "required", key->required);
    fw_json_flag(&s->json, "alternative", key->alternative);
    fw_json_text(&s->json, "default", key->default_value);
    fw_json_text(&s->json, "default-meaning", key->default_meaning);
    fw_json_text(&s->json, "needs", key->needs);
    fw_json_text(&s->json, "meaning", key->meaning);
    fw_json_end(&s->json, '}');
}

static fw_status refuse(const search *s, fw_error *error)
{
    const fw_quote quote = fw_text_quote(s->word, strlen(s->word));
    if (s->suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "no key is called '%s'; did you mean '%s'?", quote.text,
                       s->suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "no key is called '%s', expected the name or path of one that `fretwork "
                   "reference` lists",
                   quote.text);
}

static fw_status write_json(search *s, fw_error *error)
{
    char *text = NULL;
    size_t size = 0;
    /* In memory, so that a refusal leaves nothing on stdout. */
    s->json.out = open_memstream(&text, &size);
    if (!s->json.out) return fw_fail_memory(error, "the reference");
    fw_json_begin(&s->json, NULL, '[');
    fw_schema_walk(&fw_scenario_section, write_key, s);
    fw_json_end(&s->json, ']');
    fw_status status = s->found > 0 ? FW_OK : refuse(s, error);
    if (fclose(s->json.out) != 0 && status == FW_OK)
        status = fw_fail_memory(error, "the reference");
    if (status == FW_OK) fwrite(text, 1, size, stdout);
    free(text);
    return status;
}

fw_status fw_command_reference(const fw_arguments *arguments, fw_error *error)
{
    const char *word = arguments->word_count > 0 ? arguments->words[0] : NULL;
    const char *last = word && strrchr(word, '.') ? strrchr(word, '.') + 1 : word;
    search s = {.word = word, .suggestion = fw_suggestion_begin(last ? last : "")};
    if (arguments->json) return write_json(&s, error);
    if (!word) return fw_schema_print(&fw_scenario_section, stdout, error);
    fw_schema_walk(&fw_scenario_section, print_key, &s);
    return s.found > 0 ? FW_OK : refuse(&s, error);
}
