/* SPDX-License-Identifier: GPL-3.0-or-later */
/* verdict_table.c - several verdicts, and their table for people. Keeps no state. Start reading
 * at fw_verdicts_print(). */
#include "experiments/measures/verdict.h"
#include "experiments/text/terminal.h"
#include "experiments/text/text.h"

#include <stdlib.h>
#include <string.h>

fw_status fw_verdicts_create(fw_verdicts *verdicts, const fw_scenario *scenario,
                             const fw_measurement *measurement, fw_error *error)
{
    const int count = scenario->expectation_count;
    verdicts->count = 0;
    verdicts->item = calloc((size_t)count + 1, sizeof *verdicts->item);
    if (!verdicts->item) return fw_fail_memory(error, "the verdicts");
    for (int n = 0; n < count; ++n)
        verdicts->item[verdicts->count++] = fw_verdict_of(scenario, measurement, n);
    return FW_OK;
}

void fw_verdicts_clear(fw_verdicts *verdicts)
{
    free(verdicts->item);
    *verdicts = (fw_verdicts){0};
}

int fw_verdicts_asked(const fw_verdicts *verdicts)
{
    int count = 0;
    for (int n = 0; n < verdicts->count; ++n) count += verdicts->item[n].asked;
    return count;
}

int fw_verdicts_failed(const fw_verdicts *verdicts)
{
    int count = 0;
    for (int n = 0; n < verdicts->count; ++n)
        count += verdicts->item[n].asked && !verdicts->item[n].holds;
    return count;
}

static int longer(int width, const char *text)
{
    int length = (int)strlen(text);
    return length > width ? length : width;
}

/* Widths of the columns; that of the cases is 0 where there are none. */
typedef struct widths {
    int in, quantity, expected, found, word;
} widths;

/* Green and red on a terminal that may have colours. */
static void print_word(FILE *out, const widths *w, const fw_verdict *v)
{
    const bool colours = fw_terminal_colours(out);
    if (colours) fputs(v->holds ? "\033[32m" : "\033[31m", out);
    fprintf(out, "%-*s", w->word, fw_verdict_word(v));
    if (colours) fputs("\033[0m", out);
    fputs("  ", out);
}

static void print_row(FILE *out, const widths *w, const fw_verdict *v)
{
    const char *source = v->expectation->source;
    if (w->in > 0) fprintf(out, "%-*s  ", w->in, v->in ? v->in : "");
    fprintf(out, "%-*s  %-*s  %-*s  ", w->quantity, v->quantity, w->expected, v->expected, w->found,
            v->found);
    print_word(out, w, v);
    if (source) fw_text_print_line(out, source);
    fputc('\n', out);
    if (!v->expectation->note) return;
    fprintf(out, "%-*s  ", w->quantity + (w->in > 0 ? w->in + 2 : 0), "");
    fw_text_print_line(out, v->expectation->note);
    fputc('\n', out);
}

void fw_verdicts_print(FILE *out, const fw_verdicts *verdicts)
{
    widths w = {.quantity = 8, .expected = 8, .found = 16, .word = 7};
    if (fw_verdicts_asked(verdicts) == 0) return;
    for (int n = 0; n < verdicts->count; ++n) {
        const fw_verdict *v = &verdicts->item[n];
        if (!v->asked) continue;
        if (v->in) w.in = longer(w.in > 4 ? w.in : 4, v->in);
        w.quantity = longer(w.quantity, v->quantity);
        w.expected = longer(w.expected, v->expected);
        w.found = longer(w.found, v->found);
        w.word = longer(w.word, fw_verdict_word(v));
    }
    if (w.in > 0) fprintf(out, "%-*s  ", w.in, "case");
    fprintf(out, "%-*s  %-*s  %-*s  %-*s  %s\n", w.quantity, "quantity", w.expected, "expected",
            w.found, "measured", w.word, "verdict", "source");
    for (int n = 0; n < verdicts->count; ++n)
        if (verdicts->item[n].asked) print_row(out, &w, &verdicts->item[n]);
}
