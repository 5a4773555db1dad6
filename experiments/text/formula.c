/* SPDX-License-Identifier: GPL-3.0-or-later */
/* formula.c - formulas, evaluated by muParser, which is met only here. Keeps no state. Start
 * reading at fw_formula_evaluate(). */
#include "experiments/text/formula.h"

#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include "core/vec2.h"

#include <ctype.h>
#include <math.h>
#include <muParserDLL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LENGTH_MAX = 1000 };

/* muParser's own numbers of what it finds wrong. */
enum { UNKNOWN_NAME = 1, EARLY_END = 2 };

static bool begins_name(char c)
{
    return isalpha((unsigned char)c) || c == '_';
}

static bool goes_on(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* Behind a number that begins there; its exponent is no name. */
static size_t skip_number(const char *text, size_t length, size_t at)
{
    while (at < length && (isdigit((unsigned char)text[at]) || text[at] == '.')) ++at;
    size_t behind = at;
    if (behind < length && (text[behind] == 'e' || text[behind] == 'E')) {
        behind += 1;
        if (behind < length && (text[behind] == '+' || text[behind] == '-')) behind += 1;
        if (behind < length && isdigit((unsigned char)text[behind])) {
            while (behind < length && isdigit((unsigned char)text[behind])) ++behind;
            return behind;
        }
    }
    return at;
}

int fw_formula_find(const char *text, size_t length, size_t from, const fw_variable *variables,
                    int count, size_t *end)
{
    for (size_t at = from; at < length;) {
        if (isdigit((unsigned char)text[at])) {
            at = skip_number(text, length, at);
            continue;
        }
        if (!begins_name(text[at])) {
            at += 1;
            continue;
        }
        const size_t begin = at;
        while (at < length && goes_on(text[at])) ++at;
        *end = at;
        for (int n = 0; n < count; ++n)
            if (strlen(variables[n].name) == at - begin &&
                memcmp(variables[n].name, text + begin, at - begin) == 0)
                return n;
    }
    *end = length;
    return -1;
}

/* --- sentences --- */

static fw_status refuse_name(const char *formula, const char *name, const fw_variable *variables,
                             int count, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int n = 0; n < count; ++n) fw_suggestion_offer(&suggestion, variables[n].name);
    const fw_quote quote = fw_text_quote(name, strlen(name));
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT,
                       "the formula '%s' has the unknown name '%s'; did you mean '%s'?", formula,
                       quote.text, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "the formula '%s' has the unknown name '%s', expected a parameter or a "
                   "function such as sqrt",
                   formula, quote.text);
}

static fw_status refuse(muParserHandle_t parser, const char *text, const fw_variable *variables,
                        int count, fw_error *error)
{
    const fw_quote formula = fw_text_quote(text, strlen(text));
    const int code = mupGetErrorCode(parser), position = mupGetErrorPos(parser);
    /* The text of a token lies in memory that the next call uses again. */
    char token[LENGTH_MAX + 1];
    snprintf(token, sizeof token, "%s", mupGetErrorToken(parser));
    if (code == UNKNOWN_NAME && begins_name(token[0]))
        return refuse_name(formula.text, token, variables, count, error);
    if (code == EARLY_END)
        return fw_fail(error, FW_BAD_INPUT, "the formula '%s' ends where more is expected",
                       formula.text);
    if (position >= 0 && (size_t)position < strlen(text))
        return fw_fail(error, FW_BAD_INPUT,
                       "the formula '%s' cannot be read from its character %d on, '%s'",
                       formula.text, position + 1,
                       fw_text_quote(text + position, strlen(text + position)).text);
    return fw_fail(error, FW_BAD_INPUT, "the formula '%s' cannot be read to its end", formula.text);
}

static fw_status refuse_value(const char *text, double value, const fw_variable *variables,
                              int count, fw_error *error)
{
    char at[200] = "";
    for (int n = 0; n < count; ++n) {
        size_t end;
        if (fw_formula_find(text, strlen(text), 0, &variables[n], 1, &end) != 0) continue;
        fw_text_append(at, sizeof at, "%s%s=%.10g", at[0] ? ", " : "", variables[n].name,
                       variables[n].value);
    }
    return fw_fail(error, FW_BAD_INPUT, "the formula '%s' is %s%s%s, expected a finite number",
                   fw_text_quote(text, strlen(text)).text,
                   isnan(value) ? "not a number" : "infinite", at[0] ? " where " : "", at);
}

/* "x=3" would give x another value; "==", "<=", ">=" and "!=" compare. */
static bool assigns(const char *text)
{
    for (const char *at = strchr(text, '='); at; at = strchr(at + 1, '=')) {
        if (at[1] == '=')
            at += 1;
        else if (at == text || !strchr("<>!", at[-1]))
            return true;
    }
    return false;
}

/* --- values --- */

static muParserHandle_t make_parser(void)
{
    muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
    if (parser) mupDefineConst(parser, "pi", FW_PI);
    return parser;
}

fw_status fw_formula_check_name(const char *name, fw_error *error)
{
    bool fine = isalpha((unsigned char)name[0]);
    for (const char *c = name; *c; ++c) fine = fine && goes_on(*c);
    if (!fine)
        return fw_fail(error, FW_BAD_INPUT,
                       "'%s' cannot stand in a formula, expected a letter and then letters, digits "
                       "or '_'",
                       fw_text_quote(name, strlen(name)).text);
    muParserHandle_t parser = make_parser();
    if (!parser) return fw_fail_memory(error, "a formula");
    /* What may be called, and what has a value without being a variable, has a meaning already. */
    bool taken = false;
    for (int n = 0; n < 2; ++n) {
        char formula[2 * FW_NAME_BYTES];
        snprintf(formula, sizeof formula, n == 0 ? "%.64s" : "%.64s(", name);
        mupSetExpr(parser, formula);
        mupEval(parser);
        taken = taken || !mupError(parser) || mupGetErrorCode(parser) != UNKNOWN_NAME;
    }
    mupRelease(parser);
    if (!taken) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "'%s' is a function or constant of formulas, expected another name", name);
}

fw_status fw_formula_evaluate(const char *text, size_t length, const fw_variable *variables,
                              int count, double *value, fw_error *error)
{
    char formula[LENGTH_MAX + 1];
    if (length > LENGTH_MAX)
        return fw_fail(error, FW_BAD_INPUT, "the formula '%s' has %zu bytes, expected at most %d",
                       fw_text_quote(text, length).text, length, LENGTH_MAX);
    memcpy(formula, text, length);
    formula[length] = '\0';
    if (assigns(formula))
        return fw_fail(error, FW_BAD_INPUT, "the formula '%s' has a single '=', expected none",
                       fw_text_quote(formula, length).text);
    muParserHandle_t parser = make_parser();
    double *values = calloc((size_t)count + 1, sizeof *values);
    if (!parser || !values) {
        if (parser) mupRelease(parser);
        free(values);
        return fw_fail_memory(error, "a formula");
    }
    for (int n = 0; n < count; ++n) {
        values[n] = variables[n].value;
        mupDefineVar(parser, variables[n].name, &values[n]);
    }
    mupSetExpr(parser, formula);
    *value = mupEval(parser);
    fw_status status = FW_OK;
    if (mupError(parser))
        status = refuse(parser, formula, variables, count, error);
    else if (!isfinite(*value))
        status = refuse_value(formula, *value, variables, count, error);
    mupRelease(parser);
    free(values);
    return status;
}
