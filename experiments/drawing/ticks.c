/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ticks.c - round numbers.
 * Keeps no state. Invariant: ticks ascend and lie inside the range (up to a billionth of a step).
 * Start reading at fw_ticks_find(). */
#include "experiments/drawing/ticks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- printing --- */

static void append(char *text, int size, const char *more)
{
    size_t used = strlen(text);
    snprintf(text + used, (size_t)size - used, "%s", more);
}

/* Copies a number printed by printf with a true minus sign and thin spaces between thousands
 * (from five digits on, as 2000 needs none). */
static void append_plain(char *text, int size, const char *printed)
{
    if (*printed == '-') append(text, size, "\u2212");
    if (*printed == '-') ++printed;
    int whole = (int)strspn(printed, "0123456789");
    for (int k = 0; k < whole; ++k) {
        if (k > 0 && whole >= 5 && (whole - k) % 3 == 0) append(text, size, "\u2009");
        append(text, size, (char[]){printed[k], '\0'});
    }
    append(text, size, printed + whole);
}

static void append_power(char *text, int size, int exponent)
{
    char printed[16];
    snprintf(printed, sizeof printed, "%d", exponent);
    append(text, size, "10^{");
    append_plain(text, size, printed);
    append(text, size, "}");
}

/* "1.500" becomes "1.5", "2.0" becomes "2". */
static void drop_zeros(char *printed)
{
    if (!strchr(printed, '.')) return;
    size_t length = strlen(printed);
    while (printed[length - 1] == '0') printed[--length] = '\0';
    if (printed[length - 1] == '.') printed[length - 1] = '\0';
}

void fw_ticks_print_number(char *text, int size, double value, int digits)
{
    text[0] = '\0';
    if (!isfinite(value)) {
        append(text, size, isnan(value) ? "undefined" : value > 0 ? "\u221e" : "\u2212\u221e");
        return;
    }
    /* printf rounds; the exponent is that of the rounded number. */
    char printed[64], plain[64];
    snprintf(printed, sizeof printed, "%.*e", digits - 1, value);
    char *mark = strchr(printed, 'e');
    int exponent = atoi(mark + 1);
    if (value == 0 || (exponent >= -3 && exponent <= 5)) {
        int decimals = digits - 1 - exponent;
        snprintf(plain, sizeof plain, "%.*f", decimals > 0 ? decimals : 0, value == 0 ? 0 : value);
        drop_zeros(plain);
        append_plain(text, size, plain);
        return;
    }
    *mark = '\0';
    drop_zeros(printed);
    if (strcmp(printed, "1") != 0 && strcmp(printed, "-1") != 0) {
        append_plain(text, size, printed);
        append(text, size, "\u00d7");
    } else if (printed[0] == '-') {
        append(text, size, "\u2212");
    }
    append_power(text, size, exponent);
}

/* --- ticks of a linear axis --- */

/* The roundest number that lies inside the range or close to it: a multiple of the largest power
 * of ten that has one there. */
static double round_number_near(fw_range range)
{
    double middle = range.low + (range.high - range.low) / 2;
    double near = range.high - range.low;
    for (int power = (int)ceil(log10(fabs(middle))); power > -300; --power) {
        double unit = pow(10, power);
        double candidate = nearbyint(middle / unit) * unit;
        if (fabs(candidate - middle) <= near) return candidate;
    }
    return 0;
}

static void write_note(fw_ticks *ticks, int exponent, double offset)
{
    ticks->note[0] = '\0';
    if (exponent != 0) {
        append(ticks->note, sizeof ticks->note, "\u00d7");
        append_power(ticks->note, sizeof ticks->note, exponent);
    }
    if (offset != 0) {
        char number[FW_TICK_LABEL_SIZE];
        fw_ticks_print_number(number, sizeof number, fabs(offset), 15);
        if (exponent != 0) append(ticks->note, sizeof ticks->note, " ");
        append(ticks->note, sizeof ticks->note, offset < 0 ? "\u2212 " : "+ ");
        append(ticks->note, sizeof ticks->note, number);
    }
}

static void find_linear(fw_ticks *ticks, fw_range range, int wanted)
{
    double raw = (range.high - range.low) / fmax(wanted, 1);
    int power = (int)floor(log10(raw));
    double lead = raw / pow(10, power);
    /* The round step that is nearest to the wanted one (on a logarithmic scale). */
    int digit = lead <= 1.41 ? 1 : lead <= 3.16 ? 2 : lead <= 7.07 ? 5 : 10;
    if (digit == 10) {
        digit = 1;
        power += 1;
    }
    double step = digit * pow(10, power);
    double largest = fmax(fabs(range.low), fabs(range.high));
    double offset = largest > 2e5 * step ? round_number_near(range) : 0;
    double first = ceil((range.low - offset) / step - 1e-9);
    double last = floor((range.high - offset) / step + 1e-9);
    double top = fmax(fabs(first), fabs(last)) * digit; /* in units of 10^power */
    int exponent = power + (int)floor(log10(fmax(top, digit)) + 1e-9);
    if (exponent > -4 && exponent < 6) exponent = 0;
    int decimals = exponent > power ? exponent - power : 0;
    double shown = digit * pow(10, power - exponent);
    for (double k = first; k <= last && ticks->count < FW_TICKS_MAX; ++k) {
        char printed[FW_TICK_LABEL_SIZE];
        snprintf(printed, sizeof printed, "%.*f", decimals, k == 0 ? 0 : k * shown);
        ticks->at[ticks->count] = offset + k * step;
        append_plain(ticks->label[ticks->count], FW_TICK_LABEL_SIZE, printed);
        ticks->count += 1;
    }
    write_note(ticks, exponent, offset);
    int parts = digit == 2 ? 4 : 5;
    for (double k = (first - 1) * parts; k <= (last + 1) * parts; ++k) {
        double at = (k / parts) * step;
        bool inside = at >= range.low - offset && at <= range.high - offset;
        if (!inside || fmod(k, parts) == 0 || ticks->minor_count == FW_TICKS_MINOR_MAX) continue;
        ticks->minor[ticks->minor_count++] = offset + at;
    }
}

/* --- ticks of a logarithmic axis --- */

static void add_minor(fw_ticks *ticks, fw_range range, double at)
{
    if (at < range.low || at > range.high || ticks->minor_count == FW_TICKS_MINOR_MAX) return;
    ticks->minor[ticks->minor_count++] = at;
}

static void find_decades(fw_ticks *ticks, fw_range range, int first, int last, int wanted)
{
    int every = 1 + (last - first) / (wanted > 1 ? wanted : 1);
    bool plain = first >= -3 && last <= 4;
    for (int power = first - 1; power <= last + 1; ++power) {
        double decade = pow(10, power);
        bool inside = power >= first && power <= last;
        if (inside && (power - first) % every == 0 && ticks->count < FW_TICKS_MAX) {
            char *label = ticks->label[ticks->count];
            ticks->at[ticks->count++] = decade;
            if (plain) {
                fw_ticks_print_number(label, FW_TICK_LABEL_SIZE, decade, 1);
            } else if (power == 0) {
                append(label, FW_TICK_LABEL_SIZE, "1");
            } else {
                append_power(label, FW_TICK_LABEL_SIZE, power);
            }
        } else {
            add_minor(ticks, range, decade);
        }
        for (int k = 2; k <= 9 && every == 1; ++k) add_minor(ticks, range, k * decade);
    }
}

static void find_logarithmic(fw_ticks *ticks, fw_range range, int wanted)
{
    int first = (int)ceil(log10(range.low) - 1e-9), last = (int)floor(log10(range.high) + 1e-9);
    if (last > first) {
        find_decades(ticks, range, first, last, wanted);
        return;
    }
    for (int power = first - 1; power <= last + 1; ++power) {
        for (int k = 1; k <= 9; ++k) {
            double at = k * pow(10, power);
            bool labelled = k == 1 || k == 2 || k == 5 || range.high < 4 * range.low;
            if (!labelled) {
                add_minor(ticks, range, at);
            } else if (at >= range.low && at <= range.high) {
                fw_ticks_print_number(ticks->label[ticks->count], FW_TICK_LABEL_SIZE, at, 1);
                ticks->at[ticks->count++] = at;
            }
        }
    }
    if (ticks->count < 2) {
        memset(ticks, 0, sizeof *ticks);
        find_linear(ticks, range, wanted);
    }
}

void fw_ticks_find(fw_ticks *ticks, fw_range range, bool logarithmic, int wanted)
{
    memset(ticks, 0, sizeof *ticks);
    if (logarithmic) {
        find_logarithmic(ticks, range, wanted);
    } else {
        find_linear(ticks, range, wanted);
    }
}
