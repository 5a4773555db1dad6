/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_list_result.c - list DIR: what a result holds, what it is certified to have kept to, and
 * where it comes from. Keeps no state. Start reading at fw_command_list_result(). */
#include "command_list_result.h"

#include "experiments/measures/certificate.h"
#include "experiments/results/playback.h"
#include "experiments/study/sweep.h"
#include "experiments/text/json.h"
#include "experiments/text/text.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Facts of a result's provenance, in the order in which they are told. */
static const struct {
    const char *key, *name;
} facts[] = {{"run", "exit_reason"},
             {"start", "start"},
             {"end", "end"},
             {"version", "version"},
             {"revision", "revision"},
             {"compiler", "compiler"},
             {"flags", "flags"},
             {"instructions", "instructions"},
             {"forms", "forms"},
             {"host", "host"},
             {"libraries", "libraries"}};
enum { FACTS = sizeof facts / sizeof *facts };

bool fw_command_is_result(const char *word)
{
    struct stat kind;
    char file[FW_PATH_SIZE];
    fw_error ignored;
    if (stat(word, &kind) != 0) return false;
    if (!S_ISDIR(kind.st_mode)) return strstr(word, ".h5") != NULL;
    return strchr(word, '/') || fw_sweep_is_in(word) ||
           (fw_path_join(file, word, FW_TRAJECTORY_FILE, &ignored) == FW_OK &&
            stat(file, &kind) == 0);
}

static void begin_line(const char *key)
{
    printf("  %-13s", key);
}

/* A text of several lines stands in one, with semicolons. */
static void print_text(const char *key, char *text)
{
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == '\n') text[--length] = '\0';
    if (length == 0) return;
    begin_line(key);
    for (char *line = text; line;) {
        char *end = strchr(line, '\n');
        if (end) *end = '\0';
        fw_text_print_line(stdout, line);
        if (end) fputs("; ", stdout);
        line = end ? end + 1 : NULL;
    }
    printf("\n");
}

static void print_names(const char *key, int count, const char *(*name)(const fw_playback *, int),
                        const fw_playback *playback)
{
    if (count == 0) return;
    begin_line(key);
    for (int n = 0; n < count; ++n) {
        if (n > 0) fputs(", ", stdout);
        fw_text_print_line(stdout, name(playback, n));
    }
    printf("\n");
}

static const char *field_name(const fw_playback *playback, int n)
{
    return playback->fields[n].name;
}

static const char *observable_name(const fw_playback *playback, int n)
{
    return playback->observables[n].name;
}

static void print_bodies(const fw_playback *playback)
{
    begin_line("bodies");
    for (int b = 0; b < playback->body_count; ++b) {
        if (b > 0) fputs(", ", stdout);
        fw_text_print_line(stdout, playback->bodies[b].name);
        printf(" (%d particles)", playback->bodies[b].count);
    }
    printf("\n");
}

static void print(fw_playback *playback, const fw_certificate *certificate)
{
    char line[FW_CERTIFICATE_SIZE];
    fw_text_print_line(stdout, playback->title);
    printf("\n");
    print_bodies(playback);
    begin_line("frames");
    printf("%lld, with position%s%s\n", (long long)playback->frame_count,
           playback->velocity ? ", velocity" : "", playback->force ? ", force" : "");
    print_names("fields", playback->field_count, field_name, playback);
    begin_line("samples");
    printf("%lld\n", (long long)playback->sample_count);
    print_names("observables", playback->observable_count, observable_name, playback);
    begin_line("seed");
    printf("%llu\n", (unsigned long long)playback->seed);
    for (int n = 0; n < FACTS; ++n) {
        char *text = fw_playback_fact(playback, facts[n].name);
        if (text) print_text(facts[n].key, text);
        free(text);
    }
    fw_certificate_print(certificate, line);
    if (line[0]) print_text("certificate", line);
    print_text("warnings", playback->warnings);
}

static void write_names(fw_json *json, const char *key, int count,
                        const char *(*name)(const fw_playback *, int), const fw_playback *playback)
{
    fw_json_begin(json, key, '[');
    for (int n = 0; n < count; ++n) fw_json_text(json, NULL, name(playback, n));
    fw_json_end(json, ']');
}

static void write_json(fw_playback *playback, const fw_certificate *certificate)
{
    fw_json json = {.out = stdout};
    fw_json_begin(&json, NULL, '{');
    fw_json_text(&json, "title", playback->title);
    fw_json_begin(&json, "bodies", '{');
    for (int b = 0; b < playback->body_count; ++b)
        fw_json_integer(&json, playback->bodies[b].name, playback->bodies[b].count);
    fw_json_end(&json, '}');
    fw_json_integer(&json, "frames", playback->frame_count);
    write_names(&json, "fields", playback->field_count, field_name, playback);
    fw_json_integer(&json, "samples", playback->sample_count);
    write_names(&json, "observables", playback->observable_count, observable_name, playback);
    fw_json_integer(&json, "seed", (int64_t)playback->seed);
    for (int n = 0; n < FACTS; ++n) {
        char *text = fw_playback_fact(playback, facts[n].name);
        if (text) fw_json_text(&json, facts[n].key, text);
        free(text);
    }
    fw_report_certificate_as_json(&json, certificate);
    fw_json_text(&json, "warnings", playback->warnings);
    fw_json_end(&json, '}');
}

fw_status fw_command_list_result(const char *directory, bool json, fw_error *error)
{
    fw_playback *playback;
    fw_certificate certificate;
    FW_TRY(fw_sweep_refuse(directory, error));
    FW_TRY(fw_playback_open(&playback, directory, error));
    fw_status status = fw_certificate_read(&certificate, playback, error);
    if (status == FW_OK && json)
        write_json(playback, &certificate);
    else if (status == FW_OK)
        print(playback, &certificate);
    if (status == FW_OK) status = fw_playback_check(playback, error);
    fw_playback_close(playback);
    return status;
}
