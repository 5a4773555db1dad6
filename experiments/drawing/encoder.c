/* SPDX-License-Identifier: GPL-3.0-or-later */
/* encoder.c - ffmpeg reads pictures from a pipe and writes into the temporary file of the film.
 * State: its process, the pipe, and what it complained of. Start reading at
 * fw_encoder_begin(). */
#include "experiments/drawing/encoder.h"

#include "experiments/storage/regular_file.h"
#include "experiments/storage/whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SIZE_AT = 16, SIZE_BYTES = 8, PICTURE_MAX = 1 << 28, NOT_FOUND = 127 };

struct fw_encoder {
    fw_whole_file *file;
    pid_t process;
    int pipe;        /* -1: closed */
    FILE *complaint; /* what ffmpeg says */
    bool begun;
    char size[SIZE_BYTES]; /* width and height of the first picture, as PNG has them */
};

/* H.264 and VP9 want an even number of pixels each way. */
#define EVEN "pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:white"

/* How ffmpeg keeps each kind of film. */
typedef struct kept_as {
    const char *ending;
    const char *words[16];
} kept_as;

static const kept_as films[] = {
    {".mp4",
     {"-vf", EVEN, "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags",
      "+faststart", "-f", "mp4", NULL}},
    {".webm",
     {"-vf", EVEN, "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0", "-f",
      "webm", NULL}},
    {".gif",
     {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none", "-f", "gif",
      NULL}},
};

static const kept_as *find_film(const char *name)
{
    const char *ending = strrchr(name, '.');
    for (size_t n = 0; ending && n < sizeof films / sizeof *films; ++n)
        if (strcmp(films[n].ending, ending) == 0) return &films[n];
    return NULL;
}

/* In the child: pictures come from `pictures`. Does not return. */
static void become_ffmpeg(const kept_as *film, int rate, int pictures, int complaint,
                          const char *temporary)
{
    enum { WORDS_MAX = 40 };
    char rate_word[16];
    const char *words[WORDS_MAX] = {"ffmpeg", "-v",  "error",      "-y",      "-f", "image2pipe",
                                    "-c:v",   "png", "-framerate", rate_word, "-i", "pipe:0"};
    int count = 12;
    snprintf(rate_word, sizeof rate_word, "%d", rate);
    for (int n = 0; film->words[n]; ++n) words[count++] = film->words[n];
    words[count++] = temporary;
    words[count] = NULL;
    signal(SIGINT, SIG_IGN); /* the film ends when the pictures do */
    if (dup2(pictures, STDIN_FILENO) < 0 || dup2(complaint, STDERR_FILENO) < 0) _exit(1);
    execvp("ffmpeg", (char **)words);
    _exit(NOT_FOUND);
}

static fw_status start(fw_encoder *encoder, const kept_as *film, int rate, fw_error *error)
{
    int ends[2];
    encoder->complaint = tmpfile();
    if (!encoder->complaint || pipe(ends) != 0)
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot start ffmpeg: %s", strerror(errno));
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    fflush(NULL);
    encoder->process = fork();
    if (encoder->process == 0)
        become_ffmpeg(film, rate, ends[0], fileno(encoder->complaint),
                      fw_whole_file_place(encoder->file));
    close(ends[0]);
    encoder->pipe = ends[1];
    if (encoder->process > 0) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot start ffmpeg: %s", strerror(errno));
}

fw_status fw_encoder_begin(fw_encoder **encoder, const char *name, int rate, fw_error *error)
{
    *encoder = NULL;
    const kept_as *film = find_film(name);
    if (!film)
        return fw_fail(error, FW_BAD_INPUT,
                       "'%s' as a film, expected a name that ends in " FW_FILM_ENDINGS, name);
    fw_encoder *begun = calloc(1, sizeof *begun);
    if (!begun) return fw_fail_memory(error, "a film");
    begun->pipe = -1;
    fw_status status = fw_whole_file_begin(&begun->file, name, error);
    if (status == FW_OK) status = start(begun, film, rate, error);
    if (status != FW_OK) {
        fw_encoder_abandon(begun);
        return status;
    }
    *encoder = begun;
    return FW_OK;
}

/* Waits for ffmpeg, and says why it ended where it should not have. */
static fw_status await_ffmpeg(fw_encoder *encoder, fw_error *error)
{
    char line[200] = "it ended without a word";
    int how = 0;
    if (encoder->pipe >= 0) close(encoder->pipe);
    encoder->pipe = -1;
    while (waitpid(encoder->process, &how, 0) < 0 && errno == EINTR) continue;
    encoder->process = 0;
    if (WIFEXITED(how) && WEXITSTATUS(how) == 0) return FW_OK;
    if (WIFEXITED(how) && WEXITSTATUS(how) == NOT_FOUND)
        return fw_fail(error, FW_SYSTEM_FAILED,
                       "there is no program ffmpeg, which makes films: install its package");
    rewind(encoder->complaint);
    if (fgets(line, sizeof line, encoder->complaint)) line[strcspn(line, "\n")] = '\0';
    return fw_fail(error, FW_SYSTEM_FAILED, "ffmpeg cannot make the film: %s", line);
}

/* A program that has gone is no reason to end. */
static bool feed(int pipe, const char *bytes, size_t count)
{
    struct sigaction ignored = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGPIPE, &ignored, &before);
    while (count > 0) {
        const ssize_t written = write(pipe, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) break;
        bytes += written;
        count -= (size_t)written;
    }
    sigaction(SIGPIPE, &before, NULL);
    return count == 0;
}

fw_status fw_encoder_add(fw_encoder *encoder, const char *picture, fw_error *error)
{
    char *bytes;
    size_t size;
    FW_TRY(fw_regular_file_read(&bytes, &size, picture, PICTURE_MAX, error));
    fw_status status = FW_OK;
    if (size < SIZE_AT + SIZE_BYTES) {
        status = fw_fail(error, FW_SYSTEM_FAILED, "%s is no picture", picture);
    } else if (encoder->begun && memcmp(encoder->size, bytes + SIZE_AT, SIZE_BYTES) != 0) {
        status = fw_fail(error, FW_SYSTEM_FAILED, "the pictures of a film are not equally large");
    } else {
        memcpy(encoder->size, bytes + SIZE_AT, SIZE_BYTES);
        encoder->begun = true;
        if (!feed(encoder->pipe, bytes, size)) {
            status = await_ffmpeg(encoder, error);
            if (status == FW_OK)
                status = fw_fail(error, FW_SYSTEM_FAILED, "ffmpeg ended before the film did");
        }
    }
    free(bytes);
    return status;
}

static void release(fw_encoder *encoder)
{
    if (encoder->pipe >= 0) close(encoder->pipe);
    if (encoder->process > 0) {
        kill(encoder->process, SIGKILL);
        waitpid(encoder->process, NULL, 0);
    }
    if (encoder->complaint) fclose(encoder->complaint);
    fw_whole_file_abandon(encoder->file);
    free(encoder);
}

fw_status fw_encoder_commit(fw_encoder *encoder, fw_error *error)
{
    fw_status status = await_ffmpeg(encoder, error);
    if (status == FW_OK) {
        status = fw_whole_file_commit(encoder->file, error);
        encoder->file = NULL;
    }
    release(encoder);
    return status;
}

void fw_encoder_abandon(fw_encoder *encoder)
{
    if (encoder) release(encoder);
}
