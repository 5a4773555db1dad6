/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_energy_form.c - is the energy of a body ever negative? Keeps no state.
 * The form is a sparse matrix with a 2x2 block per bond. Numbered by breadth, reversed (Cuthill and
 * McKee 1969), its rows are short, and Cholesky's factorisation fills nothing outside them.
 * Start reading at fw_automaton_form_sign(). */
#include "automaton_stability.h"

#include <math.h>
#include <stdlib.h>

/* Products of the factorisation that are still done: about a second (200 x 200 cells, 260 MB). */
#define WORK_MAX 8e9
/* Rigid shifts have no energy; without a shift rounding would decide about them. What a form above
 * -1e-12 can do is to grow by a factor 1 + 3e-6 in a step. */
#define SHIFT 1e-12
enum { LANES = 8 };

static int neighbour_particle(const fw_automaton *body, int particle, int direction, fw_sym2 *bond)
{
    double weight;
    const int colour = body->white[particle];
    const int partner =
        fw_automaton_cell_neighbour(body, colour, body->cell[particle], direction, &weight);
    if (partner < 0) return -1;
    *bond = fw_sym2_scale(weight, *body->colour[colour].matrix[direction]);
    return body->colour[!colour].particle[partner];
}

/* Numbers the particles that can be reached from `first` by breadth, from `next` on; returns the
 * one past the last number. rank < 0: not yet numbered. */
static int number_from(const fw_automaton *body, int first, int next, int *order, int *rank)
{
    int done = next;
    order[next] = first;
    rank[first] = next++;
    for (; done < next; ++done)
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            fw_sym2 bond;
            const int partner = neighbour_particle(body, order[done], d, &bond);
            if (partner < 0 || rank[partner] >= 0) continue;
            order[next] = partner;
            rank[partner] = next++;
        }
    return next;
}

/* Twice, the second time from the particle that was reached last: an end of the body. */
static void number_particles(const fw_automaton *body, int *order, int *rank)
{
    const int count = body->head.count;
    for (int p = 0; p < count; ++p) rank[p] = -1;
    int next = 0;
    for (int p = 0; p < count; ++p) {
        if (rank[p] >= 0) continue;
        const int end = number_from(body, p, next, order, rank);
        const int far = order[end - 1];
        for (int n = next; n < end; ++n) rank[order[n]] = -1;
        next = number_from(body, far, next, order, rank);
    }
    for (int p = 0; p < count; ++p) rank[p] = count - 1 - rank[p];
}

typedef struct skyline {
    int rows;
    int *first;    /* column of the first entry of each row */
    size_t *start; /* where row r begins; its entry in column c is entry[start[r] + c - first[r]] */
    double *entry;
} skyline;

static void skyline_release(skyline *form)
{
    free(form->first);
    free(form->start);
    free(form->entry);
}

/* Returns the number of products that the factorisation takes. */
static double skyline_shape(skyline *form, const fw_automaton *body, const int *rank)
{
    double work = 0;
    size_t total = 0;
    for (int p = 0; p < body->head.count; ++p) {
        int lowest = rank[p];
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            fw_sym2 bond;
            const int partner = neighbour_particle(body, p, d, &bond);
            if (partner >= 0 && rank[partner] < lowest) lowest = rank[partner];
        }
        for (int axis = 0; axis < 2; ++axis) form->first[2 * rank[p] + axis] = 2 * lowest;
    }
    for (int r = 0; r < form->rows; ++r) {
        const double length = r + 1 - form->first[r];
        form->start[r] = total;
        total += (size_t)length;
        work += length * length / 2;
    }
    form->start[form->rows] = total;
    return work;
}

static void add_entry(skyline *form, int row, int column, double value)
{
    if (column > row) return;
    form->entry[form->start[row] + (size_t)(column - form->first[row])] += value;
}

static void add_block(skyline *form, int row, int column, fw_sym2 block)
{
    add_entry(form, 2 * row, 2 * column, block.xx);
    add_entry(form, 2 * row, 2 * column + 1, block.xy);
    add_entry(form, 2 * row + 1, 2 * column, block.xy);
    add_entry(form, 2 * row + 1, 2 * column + 1, block.yy);
}

/* E = 1/2 (u, Q' u) with 2 m on the diagonal and -B beside it; halved, so that the inside has 1. */
static void skyline_fill(skyline *form, const fw_automaton *body, const int *rank)
{
    for (int p = 0; p < body->head.count; ++p) {
        const fw_sym2 mass = fw_automaton_cell_mass(body, body->white[p], body->cell[p]);
        add_block(form, rank[p], rank[p], fw_sym2_add(mass, fw_sym2_scalar(SHIFT)));
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            fw_sym2 bond;
            const int partner = neighbour_particle(body, p, d, &bond);
            if (partner >= 0) add_block(form, rank[p], rank[partner], fw_sym2_scale(-0.5, bond));
        }
    }
}

/* In lanes of its own order, which the compiler can put side by side. */
static double dot(const double *restrict a, const double *restrict b, int count)
{
    double lane[LANES] = {0};
    int k = 0;
    for (; k + LANES <= count; k += LANES)
        for (int l = 0; l < LANES; ++l) lane[l] += a[k + l] * b[k + l];
    double sum = 0;
    for (; k < count; ++k) sum += a[k] * b[k];
    for (int l = 0; l < LANES; ++l) sum += lane[l];
    return sum;
}

/* L L^T = form, in place, row by row. False as soon as a pivot is not positive. */
static bool factorise(skyline *form)
{
    for (int r = 0; r < form->rows; ++r) {
        double *row = form->entry + form->start[r];
        const int first = form->first[r];
        for (int c = first; c < r; ++c) {
            const double *other = form->entry + form->start[c];
            const int from = first > form->first[c] ? first : form->first[c];
            const double sum = dot(row + (from - first), other + (from - form->first[c]), c - from);
            row[c - first] = (row[c - first] - sum) / other[c - form->first[c]];
        }
        const double pivot = row[r - first] - dot(row, row, r - first);
        if (!(pivot > 0)) return false;
        row[r - first] = sqrt(pivot);
    }
    return true;
}

static fw_status sign_of(skyline *form, const fw_automaton *body, const int *rank,
                         fw_form_sign *sign, fw_error *error)
{
    *sign = FW_FORM_TOO_LARGE;
    if (skyline_shape(form, body, rank) > WORK_MAX) return FW_OK;
    form->entry = fw_array_of_doubles(form->start[form->rows]);
    if (!form->entry) return fw_fail_memory(error, "the energy form of an automaton");
    skyline_fill(form, body, rank);
    *sign = factorise(form) ? FW_FORM_POSITIVE : FW_FORM_NEGATIVE;
    return FW_OK;
}

fw_status fw_automaton_form_sign(const fw_automaton *body, fw_form_sign *sign, fw_error *error)
{
    const size_t count = (size_t)body->head.count;
    int *order = fw_array_allocate(count, sizeof *order);
    int *rank = fw_array_allocate(count, sizeof *rank);
    skyline form = {2 * body->head.count, fw_array_allocate(2 * count, sizeof *form.first),
                    fw_array_allocate(2 * count + 1, sizeof *form.start), NULL};
    fw_status status;
    if (order && rank && form.first && form.start) {
        number_particles(body, order, rank);
        status = sign_of(&form, body, rank, sign, error);
    } else {
        status = fw_fail_memory(error, "the energy form of an automaton");
    }
    free(order);
    free(rank);
    skyline_release(&form);
    return status;
}
