/* SPDX-License-Identifier: GPL-3.0-or-later */
/* short_memory.c - what asks for memory in a test named *_short_memory, put before the libraries by
 * the linker (--wrap): counts what is there, and lets one allocation fail. GSL's makers count as
 * one allocation each and call its handler of errors as they do; what libraries ask for on their
 * own does not fail.
 *
 * State: how many allocations were asked for since short_memory_fail() or short_memory_list(),
 * which of them are listed, and how many pieces of memory there are. */
#define _GNU_SOURCE /* dl_iterate_phdr */
#include "tests/support/short_memory.h"

#include "place.h"

#include <errno.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

/* What takes the place of an allocation is in each place as well. */
enum { DEPTH = 6 };

static atomic_long asked, wanted, pieces;
static bool listing;
static long listed[PLACES_MAX], listed_count;

void short_memory_fail(long which)
{
    asked = 0;
    wanted = which;
}

bool short_memory_failed(void)
{
    return wanted > 0 && asked >= wanted;
}

long short_memory_pieces(void)
{
    return pieces;
}

void short_memory_list(void)
{
    begin_places();
    asked = listed_count = 0;
    listing = true;
}

long short_memory_listed(const long **numbers)
{
    listing = false;
    *numbers = listed;
    return listed_count;
}

bool short_memory_fails_here(void)
{
    if (listing) {
        ++asked;
        if (add_place(place_now(0, DEPTH))) listed[listed_count++] = asked;
        return false;
    }
    return wanted > 0 && ++asked == wanted;
}

static void *counted(void *memory)
{
    pieces += memory != NULL;
    return memory;
}

void *__real_malloc(size_t bytes);
void *__real_calloc(size_t count, size_t bytes);
void *__real_realloc(void *memory, size_t bytes);
void *__real_aligned_alloc(size_t alignment, size_t bytes);
char *__real_strdup(const char *text);
char *__real_strndup(const char *text, size_t most);
char *__real_realpath(const char *path, char *found);
FILE *__real_open_memstream(char **text, size_t *size);
FILE *__real_fdopen(int descriptor, const char *mode);
void __real_free(void *memory);
/* C++'s new and delete. */
void *__real__Znwm(size_t bytes);
void __real__ZdlPvm(void *memory, size_t bytes);
void __real__ZdlPv(void *memory);

void *__wrap_malloc(size_t bytes);
void *__wrap_malloc(size_t bytes)
{
    return short_memory_fails_here() ? NULL : counted(__real_malloc(bytes));
}

void *__wrap_calloc(size_t count, size_t bytes);
void *__wrap_calloc(size_t count, size_t bytes)
{
    return short_memory_fails_here() ? NULL : counted(__real_calloc(count, bytes));
}

void *__wrap_realloc(void *memory, size_t bytes);
void *__wrap_realloc(void *memory, size_t bytes)
{
    if (short_memory_fails_here()) return NULL;
    return memory ? __real_realloc(memory, bytes) : counted(__real_realloc(NULL, bytes));
}

void *__wrap_aligned_alloc(size_t alignment, size_t bytes);
void *__wrap_aligned_alloc(size_t alignment, size_t bytes)
{
    return short_memory_fails_here() ? NULL : counted(__real_aligned_alloc(alignment, bytes));
}

char *__wrap_strdup(const char *text);
char *__wrap_strdup(const char *text)
{
    return short_memory_fails_here() ? NULL : counted(__real_strdup(text));
}

char *__wrap_strndup(const char *text, size_t most);
char *__wrap_strndup(const char *text, size_t most)
{
    return short_memory_fails_here() ? NULL : counted(__real_strndup(text, most));
}

/* Of those that ask it for the memory, too. */
char *__wrap_realpath(const char *path, char *found);
char *__wrap_realpath(const char *path, char *found)
{
    return short_memory_fails_here() ? NULL : counted(__real_realpath(path, found));
}

/* Whoever opens it has its text to release. */
FILE *__wrap_open_memstream(char **text, size_t *size);
FILE *__wrap_open_memstream(char **text, size_t *size)
{
    if (short_memory_fails_here()) return NULL;
    FILE *stream = __real_open_memstream(text, size);
    pieces += stream != NULL;
    return stream;
}

/* The stream goes with fclose(), and is not counted. */
FILE *__wrap_fdopen(int descriptor, const char *mode);
FILE *__wrap_fdopen(int descriptor, const char *mode)
{
    if (!short_memory_fails_here()) return __real_fdopen(descriptor, mode);
    errno = ENOMEM;
    return NULL;
}

void __wrap_free(void *memory);
void __wrap_free(void *memory)
{
    pieces -= memory != NULL;
    __real_free(memory);
}

/* More than there is makes it throw what it throws without memory; a sanitizer would end the
 * program for that. */
void *__wrap__Znwm(size_t bytes);
void *__wrap__Znwm(size_t bytes)
{
#ifdef FW_NEW_CANNOT_FAIL
    return counted(__real__Znwm(bytes));
#else
    return short_memory_fails_here() ? __real__Znwm(PTRDIFF_MAX) : counted(__real__Znwm(bytes));
#endif
}

void __wrap__ZdlPvm(void *memory, size_t bytes);
void __wrap__ZdlPvm(void *memory, size_t bytes)
{
    pieces -= memory != NULL;
    __real__ZdlPvm(memory, bytes);
}

/* What clang calls, which tells no size. */
void __wrap__ZdlPv(void *memory);
void __wrap__ZdlPv(void *memory)
{
    pieces -= memory != NULL;
    __real__ZdlPv(memory);
}

/* GSL's makers, which give back what they made by a function of the same kind. */
#define MAKER(type, make, ask, give)                                                               \
    type *__real_##make ask;                                                                       \
    type *__wrap_##make ask;                                                                       \
    type *__wrap_##make ask                                                                        \
    {                                                                                              \
        if (!short_memory_fails_here()) return counted(__real_##make give);                        \
        GSL_ERROR_NULL("no memory", GSL_ENOMEM);                                                   \
    }
#define RELEASE(type, release)                                                                     \
    void __real_##release(type *made);                                                             \
    void __wrap_##release(type *made);                                                             \
    void __wrap_##release(type *made)                                                              \
    {                                                                                              \
        pieces -= made != NULL;                                                                    \
        __real_##release(made);                                                                    \
    }
MAKER(gsl_matrix, gsl_matrix_alloc, (size_t rows, size_t columns), (rows, columns))
MAKER(gsl_matrix, gsl_matrix_calloc, (size_t rows, size_t columns), (rows, columns))
RELEASE(gsl_matrix, gsl_matrix_free)
MAKER(gsl_matrix_complex, gsl_matrix_complex_alloc, (size_t rows, size_t columns), (rows, columns))
RELEASE(gsl_matrix_complex, gsl_matrix_complex_free)
MAKER(gsl_vector, gsl_vector_alloc, (size_t size), (size))
RELEASE(gsl_vector, gsl_vector_free)
MAKER(gsl_vector_complex, gsl_vector_complex_alloc, (size_t size), (size))
RELEASE(gsl_vector_complex, gsl_vector_complex_free)
MAKER(gsl_eigen_gensymm_workspace, gsl_eigen_gensymm_alloc, (size_t size), (size))
RELEASE(gsl_eigen_gensymm_workspace, gsl_eigen_gensymm_free)
MAKER(gsl_eigen_nonsymm_workspace, gsl_eigen_nonsymm_alloc, (size_t size), (size))
RELEASE(gsl_eigen_nonsymm_workspace, gsl_eigen_nonsymm_free)
MAKER(gsl_eigen_herm_workspace, gsl_eigen_herm_alloc, (size_t size), (size))
RELEASE(gsl_eigen_herm_workspace, gsl_eigen_herm_free)
MAKER(gsl_eigen_hermv_workspace, gsl_eigen_hermv_alloc, (size_t size), (size))
RELEASE(gsl_eigen_hermv_workspace, gsl_eigen_hermv_free)
