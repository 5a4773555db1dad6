/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_body.c - what a cell of the automaton feels from its neighbours, whether it stands in a
 * span or at a rim. Keeps no state. Start reading at fw_automaton_cell_pull().
 *
 * Pulls are sums over differences, not -b + sum B w as the paper writes it: a rigid shift of the
 * body, however large, then leaves no rounding behind. */
#include "automaton_rim.h"

#include <stdlib.h>

void *fw_automaton_make_room(void *list, int count, int *room, size_t size)
{
    enum { FEW = 8 };
    if (count < *room) return list;
    const int more = count < FEW ? FEW : 2 * count;
    void *larger = realloc(list, (size_t)more * size);
    if (larger) *room = more;
    return larger;
}

void fw_automaton_release(fw_automaton *body)
{
    for (int c = 0; c < FW_COLOURS; ++c) {
        fw_automaton_colour *colour = &body->colour[c];
        free(colour->span);
        free(colour->rim);
        free(colour->row);
        for (int row = 0; colour->gaps && row < body->row_count; ++row) free(colour->gaps[row].rim);
        free(colour->gaps);
    }
    free(body->run);
    free(body->bonds);
    free(body->built);
    free(body->torn);
    free(body->tear);
    free(body->gone);
    free(body->share);
    fw_arena_release(&body->cells);
    fw_solid_head_release(&body->head);
}

bool fw_automaton_rim_weigh(const fw_automaton *body, int colour, fw_automaton_rim *rim)
{
    rim->mass = (fw_sym2){0, 0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        rim->pull[d] = fw_sym2_scale(rim->weight[d], *body->colour[colour].matrix[d]);
        rim->mass = fw_sym2_add(rim->mass, fw_sym2_scale(0.5, rim->pull[d]));
    }
    rim->inverse_mass = (fw_sym2){0, 0, 0};
    bool bonded = false;
    for (int d = 0; d < FW_DIRECTIONS; ++d) bonded |= rim->neighbour[d] >= 0;
    if (!bonded) return true;
    if (body->boundary == FW_BOUNDARY_MIRROR) {
        for (int d = 0; d < FW_DIRECTIONS; ++d)
            if (rim->neighbour[d] < 0)
                rim->pull[fw_opposite(d)] =
                    fw_sym2_add(rim->pull[fw_opposite(d)], *body->colour[colour].matrix[d]);
        rim->inverse_mass = fw_sym2_scalar(1);
        return true;
    }
    /* Closer to singular than this, the cell's moves would be rounding errors made large. */
    const double trace = rim->mass.xx + rim->mass.yy;
    if (!(trace > 0 && fw_sym2_determinant(rim->mass) > 1e-10 * trace * trace)) return false;
    rim->inverse_mass = fw_sym2_invert(rim->mass);
    return true;
}

fw_vec2 fw_automaton_cell_pull(const fw_automaton *body, int colour, int cell)
{
    const fw_automaton_colour *own = &body->colour[colour], *other = &body->colour[!colour];
    const int place = own->place[cell];
    const fw_vec2 self = fw_automaton_at(own, cell);
    if (place >= 0) return fw_automaton_rim_pull(&own->rim[place], self, other->x, other->y);
    fw_vec2 pull[FW_DIRECTIONS];
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int neighbour = cell + own->span[~place].offset[d];
        pull[d] = fw_sym2_apply(*own->matrix[d],
                                fw_vec2_subtract(fw_automaton_at(other, neighbour), self));
    }
    return fw_vec2_add(fw_vec2_add(pull[FW_EAST], pull[FW_NORTH]),
                       fw_vec2_add(pull[FW_WEST], pull[FW_SOUTH]));
}

fw_sym2 fw_automaton_cell_mass(const fw_automaton *body, int colour, int cell)
{
    const int place = body->colour[colour].place[cell];
    return place >= 0 ? body->colour[colour].rim[place].mass : fw_sym2_scalar(1);
}

fw_sym2 fw_automaton_cell_inverse_mass(const fw_automaton *body, int colour, int cell)
{
    const int place = body->colour[colour].place[cell];
    return place >= 0 ? body->colour[colour].rim[place].inverse_mass : fw_sym2_scalar(1);
}

fw_sym2 fw_automaton_cell_matrix(const fw_automaton *body, int colour, int cell, int direction)
{
    const fw_automaton_colour *own = &body->colour[colour];
    const int place = own->place[cell];
    return place >= 0 ? own->rim[place].pull[direction] : *own->matrix[direction];
}

int fw_automaton_cell_neighbour(const fw_automaton *body, int colour, int cell, int direction,
                                double *weight)
{
    const fw_automaton_colour *own = &body->colour[colour];
    const int place = own->place[cell];
    *weight = place >= 0 ? own->rim[place].weight[direction] : 1;
    return place >= 0 ? own->rim[place].neighbour[direction]
                      : cell + own->span[~place].offset[direction];
}
