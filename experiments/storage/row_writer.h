/* SPDX-License-Identifier: GPL-3.0-or-later */
/* row_writer.h - long rows of a file, written in a thread of its own while the program goes on.
 *
 * They go past the system's cache where the file system lets them: nobody reads them soon, and
 * copying them there takes longer than making them. What the system cannot take that way (the ends
 * of a row that share a page with something else, rows that do not begin at a number's place) it
 * takes the usual way: the bytes of the file are the same. */
#ifndef FW_ROW_WRITER_H
#define FW_ROW_WRITER_H

#include <stddef.h>
#include <stdint.h>

/* Shorter rows are sooner written than handed over. */
enum { FW_LONG_ROW_BYTES = 1 << 20 };

typedef struct fw_row_writer fw_row_writer;

/* `bytes` from `memory` on are to be written at `address` of the file. */
typedef struct fw_row_piece {
    const void *memory;
    size_t bytes;
    uint64_t address;
} fw_row_piece;

/* Of the writer's thread, when all pieces are written or one could not be: errno, or 0. */
typedef void (*fw_row_written)(void *owner, int reason);

/* Writes into the file that is open as `descriptor`, which must stay open. NULL: no memory. */
fw_row_writer *fw_row_writer_create(int descriptor, fw_row_written written, void *owner);
/* Waits for what is being written. NULL is legal. */
void fw_row_writer_destroy(fw_row_writer *writer);

/* Memory for a row, all zero; fw_row_place() says where in it a row begins that is to be written
 * at `address`. NULL: there is none. Freed with free(). */
void *fw_row_memory(size_t bytes);
void *fw_row_place(void *memory, uint64_t address);

/* Hands pieces over, after those before are written; they and their memory must stay as they are
 * until fw_row_writer_wait() returns. */
void fw_row_writer_start(fw_row_writer *writer, const fw_row_piece *pieces, int count);
/* Until all is written and `written` has returned. */
void fw_row_writer_wait(fw_row_writer *writer);

#endif
