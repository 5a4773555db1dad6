/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run_page.c - does what a page of the manual says, in the order in which it says it:
 *
 *   run_page PROGRAM PAGE.md
 *
 * A block ```KIND title=FILE is written into FILE. In a block ```console every line that begins
 * with "$ " is a command of the shell, which may go on behind a backslash; the lines that follow
 * are what it prints (stdout and stderr together), and are not compared where there are none. "..."
 * on a line of its own stands for any number of lines, within a line for any text. Every command
 * ends with exit code 0, the last one of a block ```console exit=N with N. All this happens in a
 * scratch folder that knows the program as `fretwork` and as `build/fretwork`.
 *
 * Python that cannot import what it asks for, and films without ffmpeg, are not run; the exit code
 * is then 77, which ctest reports as skipped. Start reading at run_page(). */
#include <ctype.h>
#include <limits.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SKIPPED = 77, LINES_MAX = 4096 };

typedef struct manual_page {
    const char *name;
    char *text;
    char *lines[LINES_MAX]; /* ending in NUL, without line ends or trailing blanks */
    int count;
    int commands, files; /* that were run, and written */
    bool skipped;
} manual_page;

static char folder[64]; /* the scratch folder, "" where there is none */

static void remove_scratch(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (*folder && (chdir("/") != 0 || system(command) != 0)) perror(folder);
}

static void fail(const manual_page *page, int line, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "%s:%d: ", page->name, line + 1);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

static char *read_all(FILE *in)
{
    size_t size = 0, room = 1 << 16;
    char *text = malloc(room);
    while (text) {
        size += fread(text + size, 1, room - 1 - size, in);
        if (size < room - 1) break;
        room *= 2;
        text = realloc(text, room);
    }
    if (!text) abort();
    text[size] = '\0';
    return text;
}

/* Leaves one blank of several: columns may be wider elsewhere. */
static void squeeze(char *line)
{
    char *to = line;
    for (const char *from = line; *from; ++from)
        if (*from != ' ' || to == line || to[-1] != ' ') *to++ = *from;
    *to = '\0';
}

/* Cuts a text into lines, in place. */
static int cut(char *text, char *lines[LINES_MAX])
{
    int count = 0;
    while (*text && count < LINES_MAX) {
        lines[count++] = text;
        char *end = text + strcspn(text, "\n");
        text = *end ? end + 1 : end;
        *end = '\0';
        while (end > lines[count - 1] && isspace((unsigned char)end[-1])) *--end = '\0';
    }
    return count;
}

static bool matches_line(const char *pattern, const char *line)
{
    for (; *pattern; ++pattern, ++line) {
        if (strncmp(pattern, "...", 3) == 0) {
            for (const char *rest = line;; ++rest) {
                if (matches_line(pattern + 3, rest)) return true;
                if (!*rest) return false;
            }
        }
        if (*pattern != *line) return false;
    }
    return !*line;
}

static bool matches(char *const *patterns, int pattern_count, char *const *lines, int line_count)
{
    if (pattern_count == 0) return line_count == 0;
    if (strcmp(patterns[0], "...") == 0) {
        for (int n = 0; n <= line_count; ++n)
            if (matches(patterns + 1, pattern_count - 1, lines + n, line_count - n)) return true;
        return false;
    }
    return line_count > 0 && matches_line(patterns[0], lines[0]) &&
           matches(patterns + 1, pattern_count - 1, lines + 1, line_count - 1);
}

/* The value behind "KEY=" in the line that opens a block; NULL: there is none. */
static const char *value_of(const char *opening, const char *key)
{
    static char value[256];
    const char *at = strstr(opening, key);
    if (!at) return NULL;
    at += strlen(key);
    snprintf(value, sizeof value, "%.*s", (int)strcspn(at, " "), at);
    return value;
}

/* Can the file of Python be run here? */
static bool can_import(const char *file)
{
    char command[512];
    snprintf(command, sizeof command,
             "grep -hE '^(import|from) ' '%s' > .imports && PYTHONWARNINGS=ignore "
             "python3 .imports > /dev/null 2>&1",
             file);
    return system(command) == 0;
}

/* Films want a program that a machine need not have; where it is said to be there, they must be
 * made. */
static bool lacks_encoder(const char *command)
{
    return strstr(command, "fretwork film ") && !getenv("FW_FFMPEG_EXPECTED") &&
           system("command -v ffmpeg > /dev/null 2>&1") != 0;
}

/* Runs one command and holds what it prints against the lines that follow it. */
static void run_command(manual_page *page, int line, const char *command, char *const *expected,
                        int expected_count, int code)
{
    char file[256];
    if (sscanf(command, "python3 %255s", file) == 1 && access(file, R_OK) == 0 &&
        !can_import(file)) {
        printf("%s:%d: not run, python3 cannot import what it needs: %s\n", page->name, line + 1,
               command);
        page->skipped = true;
        return;
    }
    if (lacks_encoder(command)) {
        printf("%s:%d: not run, there is no ffmpeg: %s\n", page->name, line + 1, command);
        page->skipped = true;
        return;
    }
    char *shell;
    size_t size;
    FILE *words = open_memstream(&shell, &size);
    if (!words) abort();
    fprintf(words, "{ %s\n} 2>&1 < /dev/null", command);
    fclose(words);
    fflush(stdout);
    FILE *out = popen(shell, "r");
    if (!out) abort();
    char *text = read_all(out);
    const int status = pclose(out);
    free(shell);
    char *whole = strdup(text), *lines[LINES_MAX];
    const int count = cut(text, lines);
    for (int n = 0; n < count; ++n) squeeze(lines[n]);
    for (int n = 0; n < expected_count; ++n) squeeze(expected[n]);
    page->commands += 1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != code)
        fail(page, line, "exit code %d instead of %d of: %s\nit printed:\n%s",
             WIFEXITED(status) ? WEXITSTATUS(status) : -1, code, command, whole);
    if (expected_count > 0 && !matches(expected, expected_count, lines, count))
        fail(page, line, "prints something else than the page says: %s\nit printed:\n%s", command,
             whole);
    free(whole);
    free(text);
}

/* The commands between two lines of the page. */
static void run_block(manual_page *page, int from, int to, int code)
{
    if (from == to || strncmp(page->lines[from], "$ ", 2) != 0)
        fail(page, from, "a console block begins with a command, '$ ...'");
    for (int n = from; n < to;) {
        char command[4096] = "";
        const int at = n;
        bool more = true;
        while (more && n < to) {
            const char *line = page->lines[n++];
            strncat(command, n == at + 1 ? line + 2 : line, sizeof command - strlen(command) - 2);
            more = command[strlen(command) - 1] == '\\';
            if (more) strcat(command, "\n");
        }
        const int first = n;
        while (n < to && strncmp(page->lines[n], "$ ", 2) != 0) ++n;
        int last = n;
        while (last > first && !*page->lines[last - 1]) --last;
        run_command(page, at, command, page->lines + first, last - first, n == to ? code : 0);
    }
}

static void write_file(manual_page *page, int from, int to, const char *name)
{
    if (strchr(name, '/')) fail(page, from, "a file of the scratch folder, not '%s'", name);
    FILE *out = fopen(name, "w");
    if (!out) fail(page, from, "cannot write '%s'", name);
    for (int n = from; n < to; ++n) fprintf(out, "%s\n", page->lines[n]);
    fclose(out);
    page->files += 1;
}

static void run_page(manual_page *page)
{
    for (int n = 0; n < page->count; ++n) {
        const char *opening = page->lines[n];
        if (strncmp(opening, "```", 3) != 0) continue;
        const int from = n + 1;
        int to = from;
        while (to < page->count && strcmp(page->lines[to], "```") != 0) ++to;
        if (to == page->count) fail(page, n, "a block without an end");
        const char *code = value_of(opening, " exit=");
        if (strncmp(opening, "```console", 10) == 0)
            run_block(page, from, to, code ? atoi(code) : 0);
        const char *title = value_of(opening, " title=");
        if (title) write_file(page, from, to, title);
        n = to;
    }
    if (page->commands == 0 && !page->skipped)
        fail(page, 0, "there is nothing to run on this page");
}

/* A fresh folder with the program in its place; the process moves there. */
static void enter_scratch(const char *program)
{
    char path[2 * PATH_MAX];
    char made[] = "/tmp/fretwork-manual-XXXXXX";
    if (!mkdtemp(made)) {
        perror(made);
        exit(1);
    }
    strcpy(folder, made);
    atexit(remove_scratch);
    if (chdir(folder) != 0 || mkdir("build", 0777) != 0 || mkdir(".bin", 0777) != 0 ||
        symlink(program, "build/fretwork") != 0 || symlink(program, ".bin/fretwork") != 0 ||
        (access("/usr/bin/python3", X_OK) == 0 &&
         symlink("/usr/bin/python3", ".bin/python3") != 0)) {
        perror(folder);
        exit(1);
    }
    snprintf(path, sizeof path, "%s/.bin:%s", folder, getenv("PATH"));
    setenv("PATH", path, 1);
    setenv("NO_COLOR", "1", 1);
}

int main(int count, char **words)
{
    char program[PATH_MAX], file[PATH_MAX];
    if (count != 3 || !realpath(words[1], program) || !realpath(words[2], file)) {
        fputs("expected run_page PROGRAM PAGE.md\n", stderr);
        return 2;
    }
    static manual_page page;
    FILE *in = fopen(file, "r");
    if (!in) {
        perror(file);
        return 2;
    }
    page.name = strrchr(file, '/') + 1;
    page.text = read_all(in);
    fclose(in);
    page.count = cut(page.text, page.lines);
    enter_scratch(program);
    run_page(&page);
    printf("%s: %d commands, %d files\n", page.name, page.commands, page.files);
    free(page.text);
    return page.skipped ? SKIPPED : 0;
}
