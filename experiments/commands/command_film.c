/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_film.c - the motion of a result as a film. Keeps no state. */
#include "experiments/commands/command.h"
#include "experiments/drawing/encoder.h"
#include "experiments/pictures/film.h"

fw_status fw_command_film(const fw_arguments *arguments, fw_error *error)
{
    const fw_arguments *a = arguments;
    if (!a->output)
        return fw_fail(error, FW_BAD_INPUT,
                       "film needs a file, expected -o and a name that ends in " FW_FILM_ENDINGS);
    fw_film_wish wish = {.file = a->output,
                         .picture = a->picture,
                         .kind = a->kind,
                         .field = a->field,
                         .every = a->every,
                         .rate = a->rate};
    FW_TRY(fw_command_read_range("--range", a->range, wish.range, error));
    return fw_film_make(a->words[0], &wish, stdout, error);
}
