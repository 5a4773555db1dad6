/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_reference.c - the keys of a scenario file: all of them as Markdown, those of a name
 * (`damping`) or path (`run.steps`, `walls.floor.path`) in plain lines, or those that speak of
 * words, a line each. Keeps no state. Start reading at fw_command_reference(). */
#include "experiments/commands/command.h"
#include "experiments/scenario/scenario.h"
#include "experiments/text/json.h"
#include "experiments/text/spelling.h"
#include "lookup.h"

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

static bool is_named(const char *word, const char *path, const fw_key *key)
{
    char named[FW_SCHEMA_PATH + 8];
    if (ends_in(path, word) || same_path(path, word)) return true;
    if (!key->subsection || !(key->forms & (FW_FORM_NAMED | FW_FORM_LIST))) return false;
    snprintf(named, sizeof named, "%s.%s", path, key->forms & FW_FORM_NAMED ? "NAME" : "N");
    return same_path(named, word);
}

typedef struct search {
    const fw_arguments *arguments;
    const char *word; /* the name or path of keys, or NULL: all keys that speak of the words */
    int found, others;
    fw_suggestion suggestion; /* among names of keys */
    fw_json json;
} search;

/* Where a key stands may say some of the words, but not all of them. */
static bool is_wanted(const search *s, const char *path, const fw_key *key, const char *expected)
{
    if (s->word) return is_named(s->word, path, key);
    if (s->arguments->word_count == 0) return true;
    const char *const texts[] = {key->name, key->meaning, expected, path};
    fw_arguments one = *s->arguments;
    bool any = false;
    one.word_count = 1;
    for (int w = 0; w < s->arguments->word_count; ++w) {
        one.words[0] = s->arguments->words[w];
        any |= fw_lookup_fits(&one, texts, 3);
    }
    return any && fw_lookup_fits(s->arguments, texts, 4);
}

static void note_name(void *object, const char *path, const fw_key *key)
{
    search *s = object;
    fw_suggestion_offer(&s->suggestion, key->name);
    s->found += is_named(s->word, path, key);
}

/* --- how they are printed --- */

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
    fw_schema_expected(key, expected, sizeof expected);
    if (!is_wanted(s, path, key, expected)) return;
    s->found += 1;
    if (!s->word) {
        printf("%s: %s\n", path, key->meaning);
        return;
    }
    if (s->found > 1) printf("\n");
    printf("%s: %s\n  %-8s %s\n", path, key->meaning, "value", expected);
    if (key->unit) printf("  %-8s %s\n", "unit", key->unit);
    printf("  %-8s %s\n", "default", default_of(key));
    if (key->needs) printf("  %-8s %s\n", "needs", key->needs);
    if (key->subsection) print_inside(key);
}

/* Keys of other names that speak of the word, a line each, no longer than this. */
enum { OTHER_SIZE = 100 };
static void print_other(void *object, const char *path, const fw_key *key)
{
    search *s = object;
    char expected[EXPECTED_SIZE];
    fw_schema_expected(key, expected, sizeof expected);
    const char *const texts[] = {key->name, key->meaning, expected};
    if (is_named(s->word, path, key) || !fw_lookup_fits(s->arguments, texts, 3)) return;
    if (s->others == 0) printf("\nOthers that speak of it:\n");
    s->others += 1;
    const bool is_long = strlen(key->meaning) > OTHER_SIZE;
    printf("  %s: %.*s%s\n", path, OTHER_SIZE, key->meaning, is_long ? " ..." : "");
}

/* {path, key, value, unit, required, alternative, default, otherwise, needs, meaning} */
static void write_key(void *object, const char *path, const fw_key *key)
{
    search *s = object;
    char expected[EXPECTED_SIZE];
    fw_schema_expected(key, expected, sizeof expected);
    if (!is_wanted(s, path, key, expected)) return;
    s->found += 1;
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
    const fw_quote quote = fw_lookup_quote(s->arguments);
    if (s->suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "no key is called '%s'; did you mean '%s'?", quote.text,
                       s->suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "no key is called '%s', and none speaks of it; expected the name or path of one "
                   "that `fretwork reference` lists",
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
    const char *word = arguments->word_count == 1 ? arguments->words[0] : NULL;
    const char *last = word && strrchr(word, '.') ? strrchr(word, '.') + 1 : word;
    search s = {
        .arguments = arguments, .word = word, .suggestion = fw_suggestion_begin(last ? last : "")};
    if (word) fw_schema_walk(&fw_scenario_section, note_name, &s);
    if (s.found == 0) s.word = NULL;
    s.found = 0;
    if (arguments->json) return write_json(&s, error);
    if (arguments->word_count == 0) return fw_schema_print(&fw_scenario_section, stdout, error);
    fw_schema_walk(&fw_scenario_section, print_key, &s);
    /* A path means one key; a name may be a word of others. */
    if (s.word && !strchr(s.word, '.')) fw_schema_walk(&fw_scenario_section, print_other, &s);
    return s.found > 0 ? FW_OK : refuse(&s, error);
}
