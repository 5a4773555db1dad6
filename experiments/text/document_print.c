/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document_print.c - a tree written out as YAML again: short lists and mappings on one line,
 * longer ones indented. Keeps no state. Start reading at fw_document_print(). */
#include "experiments/text/document.h"

#include <errno.h>
#include <limits.h>
#include <string.h>

enum { LINE_WIDTH = 90, INDENT = 2 };

static bool is_letter_or_digit(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/* May it stand without quotes, in any context? Words of letters, digits and _.+- with single
 * blanks between them. */
static bool is_plain(const fw_node *scalar)
{
    if (scalar->quoted || scalar->length == 0) return false;
    bool word = false; /* a letter or digit was seen, so it is neither '-' nor '...' */
    for (size_t n = 0; n < scalar->length; ++n) {
        char c = scalar->text[n];
        if (c == ' ') {
            bool inside = n > 0 && n + 1 < scalar->length;
            if (!inside || !word || scalar->text[n + 1] == ' ') return false;
        } else if (is_letter_or_digit(c)) {
            word = true;
        } else if (!strchr("_.+-", c)) {
            return false;
        }
    }
    return word;
}

/* Lines of text that a '|' can hold as they are. */
static bool is_lines(const fw_node *scalar)
{
    const char *text = scalar->text;
    size_t length = scalar->length;
    if (!memchr(text, '\n', length) || text[0] == '\n' || text[0] == ' ') return false;
    if (memchr(text, '\r', length) || memchr(text, '\t', length)) return false;
    return text[length - 1] != '\n' || text[length - 2] != '\n';
}

/* Length on one line; INT_MAX where it cannot be on one line. */
static int flow_width(const fw_node *node)
{
    if (node->kind == FW_SCALAR) {
        const size_t length = node->formula ? strlen(node->formula) : node->length;
        bool fits = length <= LINE_WIDTH && !is_lines(node);
        return fits ? (int)length + 2 : INT_MAX;
    }
    int width = 2;
    for (const fw_node *child = node->first; child; child = child->next) {
        int inner = flow_width(child);
        if (inner == INT_MAX) return INT_MAX;
        width += inner + 2 + (child->key ? (int)strlen(child->key) + 2 : 0);
        if (width > LINE_WIDTH) return INT_MAX;
    }
    return width;
}

static void print_quoted(const char *text, size_t length, FILE *out)
{
    fputc('"', out);
    for (size_t n = 0; n < length; ++n) {
        switch (text[n]) {
        case '"':
            fputs("\\\"", out);
            break;
        case '\\':
            fputs("\\\\", out);
            break;
        case '\n':
            fputs("\\n", out);
            break;
        case '\r':
            fputs("\\r", out);
            break;
        case '\t':
            fputs("\\t", out);
            break;
        default:
            fputc(text[n], out);
        }
    }
    fputc('"', out);
}

static void print_key(const char *key, FILE *out)
{
    const fw_node name = {.text = key, .length = strlen(key)};
    if (is_plain(&name))
        fputs(key, out);
    else
        print_quoted(key, name.length, out);
    fputc(':', out);
}

static void print_flow(const fw_node *node, FILE *out)
{
    if (node->kind == FW_SCALAR) {
        if (node->formula)
            print_quoted(node->formula, strlen(node->formula), out);
        else if (is_plain(node))
            fwrite(node->text, 1, node->length, out);
        else
            print_quoted(node->text, node->length, out);
        return;
    }
    fputc(node->kind == FW_LIST ? '[' : '{', out);
    for (const fw_node *child = node->first; child; child = child->next) {
        if (child->key) {
            print_key(child->key, out);
            fputc(' ', out);
        }
        print_flow(child, out);
        if (child->next) fputs(", ", out);
    }
    fputc(node->kind == FW_LIST ? ']' : '}', out);
}

static void print_lines(const fw_node *scalar, int indent, FILE *out)
{
    bool ends = scalar->text[scalar->length - 1] == '\n';
    fputs(ends ? " |\n" : " |-\n", out);
    const char *line = scalar->text;
    while (*line) {
        int length = (int)strcspn(line, "\n");
        if (length) fprintf(out, "%*s%.*s", indent, "", length, line);
        line += length;
        if (*line == '\n') {
            line += 1;
            if (*line) fputc('\n', out);
        }
    }
    fputc('\n', out);
}

/* Behind what is on one line: the values of its formulas, in order. */
static bool print_values(const fw_node *node, bool begun, FILE *out)
{
    for (const fw_node *child = node->first; child; child = child->next)
        begun = print_values(child, begun, out);
    if (!node->formula) return begun;
    fprintf(out, "%s%s", begun ? ", " : "  # = ", node->text);
    return true;
}

/* The value after a key or a '-'; ends its line. */
static void print_block(const fw_node *node, int indent, FILE *out)
{
    if (node->kind == FW_SCALAR && is_lines(node)) {
        print_lines(node, indent, out);
        return;
    }
    bool many = node->kind != FW_SCALAR && node->count > 0;
    if (!many || (indent > 0 && flow_width(node) <= LINE_WIDTH)) {
        if (indent > 0) fputc(' ', out);
        print_flow(node, out);
        print_values(node, false, out);
        fputc('\n', out);
        return;
    }
    if (indent > 0) fputc('\n', out);
    for (const fw_node *child = node->first; child; child = child->next) {
        fprintf(out, "%*s", indent, "");
        if (child->key)
            print_key(child->key, out);
        else
            fputc('-', out);
        print_block(child, indent + INDENT, out);
    }
}

fw_status fw_document_print(const fw_document *document, FILE *out, fw_error *error)
{
    print_block(fw_document_root(document), 0, out);
    if (!ferror(out)) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "%s cannot be written out: %s",
                   fw_document_file(document), strerror(errno));
}
