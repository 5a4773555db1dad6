/* SPDX-License-Identifier: GPL-3.0-or-later */
/* row_writer.c - a thread that writes.
 * State: the pieces at hand, and two ways into the file. Invariant: while `busy`, only the thread
 * touches pieces and file; else it sleeps. Start reading at work(). */
#define _GNU_SOURCE /* O_DIRECT */
#include "experiments/storage/row_writer.h"

#include "core/array.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Memory and places in the file that do without the cache come in multiples of this: no usual disk
 * and no page asks for more. */
enum { STEP = 4096 };

struct fw_row_writer {
    int file, past_cache; /* the second one is -1 where there is none */
    fw_row_written written;
    void *owner;
    const fw_row_piece *pieces;
    int count;
    bool threaded, busy, ending;
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t changed;
};

/* --- memory --- */

void *fw_row_memory(size_t bytes)
{
    return fw_array_allocate(bytes + 2 * (size_t)STEP, 1);
}

/* As far behind a multiple of STEP as the address, or nearly so where it is no place for a number.
 */
void *fw_row_place(void *memory, uint64_t address)
{
    const size_t before = (STEP - (uintptr_t)memory % STEP) % STEP;
    return (char *)memory + before + address % STEP / sizeof(double) * sizeof(double);
}

/* --- writing --- */

/* errno, or 0. */
static int write_all(int file, const char *from, size_t bytes, uint64_t address)
{
    while (bytes > 0) {
        const ssize_t done = pwrite(file, from, bytes, (off_t)address);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return errno;
        if (done == 0) return EIO;
        from += done;
        address += (uint64_t)done;
        bytes -= (size_t)done;
    }
    return 0;
}

static int write_piece(fw_row_writer *writer, const fw_row_piece *piece)
{
    const char *from = piece->memory;
    const uint64_t address = piece->address;
    const size_t head = (STEP - address % STEP) % STEP;
    const bool apart = (uintptr_t)from % STEP == address % STEP && piece->bytes > head + STEP;
    if (writer->past_cache < 0 || !apart)
        return write_all(writer->file, from, piece->bytes, address);
    const size_t middle = (piece->bytes - head) / STEP * STEP, tail = head + middle;
    int reason = write_all(writer->past_cache, from + head, middle, address + head);
    /* File systems may let a file be opened so and then not be written so. */
    if (reason == EINVAL) {
        close(writer->past_cache);
        writer->past_cache = -1;
        reason = write_all(writer->file, from + head, middle, address + head);
    }
    if (reason == 0) reason = write_all(writer->file, from, head, address);
    if (reason == 0)
        reason = write_all(writer->file, from + tail, piece->bytes - tail, address + tail);
    return reason;
}

static void write_pieces(fw_row_writer *writer)
{
    int reason = 0;
    for (int n = 0; n < writer->count && reason == 0; ++n)
        reason = write_piece(writer, &writer->pieces[n]);
    writer->written(writer->owner, reason);
}

/* --- the thread --- */

static void *work(void *argument)
{
    fw_row_writer *writer = argument;
    pthread_mutex_lock(&writer->lock);
    for (;;) {
        while (!writer->busy && !writer->ending) pthread_cond_wait(&writer->changed, &writer->lock);
        if (!writer->busy) break;
        pthread_mutex_unlock(&writer->lock);
        write_pieces(writer);
        pthread_mutex_lock(&writer->lock);
        writer->busy = false;
        pthread_cond_broadcast(&writer->changed);
    }
    pthread_mutex_unlock(&writer->lock);
    return NULL;
}

/* Signals are for the other threads. */
static bool begin_thread(fw_row_writer *writer)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    const bool begun = pthread_create(&writer->thread, NULL, work, writer) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return begun;
}

/* The same file once more, whatever its name is by now. */
static int open_past_cache(int descriptor)
{
#ifdef O_DIRECT
    char path[64];
    snprintf(path, sizeof path, "/proc/self/fd/%d", descriptor);
    return open(path, O_WRONLY | O_DIRECT | O_CLOEXEC);
#else
    (void)descriptor;
    return -1;
#endif
}

fw_row_writer *fw_row_writer_create(int descriptor, fw_row_written written, void *owner)
{
    fw_row_writer *writer = calloc(1, sizeof *writer);
    if (!writer) return NULL;
    writer->file = descriptor;
    writer->past_cache = open_past_cache(descriptor);
    writer->written = written;
    writer->owner = owner;
    pthread_mutex_init(&writer->lock, NULL);
    pthread_cond_init(&writer->changed, NULL);
    writer->threaded = begin_thread(writer);
    return writer;
}

void fw_row_writer_destroy(fw_row_writer *writer)
{
    if (!writer) return;
    if (writer->threaded) {
        pthread_mutex_lock(&writer->lock);
        writer->ending = true;
        pthread_cond_broadcast(&writer->changed);
        pthread_mutex_unlock(&writer->lock);
        pthread_join(writer->thread, NULL);
    }
    if (writer->past_cache >= 0) close(writer->past_cache);
    pthread_cond_destroy(&writer->changed);
    pthread_mutex_destroy(&writer->lock);
    free(writer);
}

void fw_row_writer_start(fw_row_writer *writer, const fw_row_piece *pieces, int count)
{
    fw_row_writer_wait(writer);
    writer->pieces = pieces;
    writer->count = count;
    if (!writer->threaded) {
        write_pieces(writer);
        return;
    }
    pthread_mutex_lock(&writer->lock);
    writer->busy = true;
    pthread_cond_broadcast(&writer->changed);
    pthread_mutex_unlock(&writer->lock);
}

void fw_row_writer_wait(fw_row_writer *writer)
{
    pthread_mutex_lock(&writer->lock);
    while (writer->busy) pthread_cond_wait(&writer->changed, &writer->lock);
    pthread_mutex_unlock(&writer->lock);
}
